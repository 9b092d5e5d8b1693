"""The process that talks to an NXT brick: a line of JSON in, a line of JSON out. Run as a script, never imported.

nxt-python is under the GPL 3, so that it is loaded here and nowhere else. Requests: {"do": NAME, "number": N, …};
answers: {"number": N, "ok": …} or {"number": N, "error": "one line"}.
"""

from __future__ import annotations

import base64
import json
import sys
from collections.abc import Callable
from typing import Any


def connect(port: str) -> Any:
    """The brick at that port: usb, or the path of a device such as /dev/rfcomm0."""
    import nxt.locator  # pyright: ignore[reportMissingImports]

    where: dict[str, Any] = {"backends": ["usb"]} if port == "usb" else {"backends": ["devfile"], "filename": port}
    return nxt.locator.find(config=None, **where)


def upload(brick: Any, name: str, data: str) -> int:
    """Put a file on the brick in place of one of that name."""
    content = base64.b64decode(data)
    try:
        brick.file_delete(name)
    except Exception as error:
        if "not found" not in str(error).lower():
            raise
    with brick.open_file(name, "wb", len(content)) as file:
        file.write(content)
    return len(content)


def fetch(brick: Any, name: str) -> str:
    """A file of the brick, as base64."""
    with brick.open_file(name, "rb") as file:
        return base64.b64encode(file.read()).decode("ascii")


def running(brick: Any) -> str:
    """The program that runs, or nothing."""
    try:
        return str(brick.get_current_program_name())
    except Exception as error:
        if "no active program" in str(error).lower():
            return ""
        raise


def stop(brick: Any) -> bool:
    """End the program, if one runs; whether one did. It is one telegram, which no other one's failure prevents."""
    try:
        brick.stop_program()
    except Exception as error:
        if "no active program" in str(error).lower():
            return False
        raise
    return True


def sensor(brick: Any, port: int, kind: int) -> int:
    """What the converter of an input reads with a sensor of that kind set."""
    import nxt.sensor  # pyright: ignore[reportMissingImports]

    where = nxt.sensor.Port(port)
    brick.set_input_mode(where, nxt.sensor.Type(kind), nxt.sensor.Mode.RAW)
    brick.get_input_values(where)  # the first reading may still be that of the sensor set before
    return int(brick.get_input_values(where)[5])


def drive(brick: Any, ports: list[int], powers: list[int], limits: list[int], fresh: list[bool]) -> list[int]:
    """Give motors their duty [%], which they keep until they have turned by their limit [deg] (0: for ever).

    A brick adds a limit to where the last one ended; a `fresh` motor first runs without one, which makes it begin where
    the motor is. Returns how far each fresh motor had turned there [deg], and 0 of the others.
    """
    from nxt.motor import Mode, Port, RegulationMode, RunState  # pyright: ignore[reportMissingImports]

    def order(i: int, limit: int) -> None:
        how = Mode.ON | Mode.BRAKE, RegulationMode.IDLE, 0, RunState.RUNNING
        brick.set_output_state(Port(ports[i]), powers[i], *how, limit)

    for i, new in enumerate(fresh):
        order(i, 0 if new else limits[i])
    turned = [int(brick.get_output_state(Port(port))[-1]) if new else 0 for port, new in zip(ports, fresh, strict=True)]
    for i, new in enumerate(fresh):
        if new:  # the answer above says that the order without a limit has been taken
            order(i, limits[i])
    return turned


def release(brick: Any, ports: list[int]) -> None:
    """Switch motors off, and count their turning from here."""
    from nxt.motor import Mode, Port, RegulationMode, RunState  # pyright: ignore[reportMissingImports]

    for port in ports:
        brick.set_output_state(Port(port), 0, Mode(0), RegulationMode.IDLE, 0, RunState.IDLE, 0)
        brick.reset_motor_position(Port(port), False)


def look(brick: Any, motors: list[int], gyro: int) -> list[int]:
    """The turning of motors [deg] since `release`, what the converter of an input reads, and the battery [mV]."""
    from nxt.motor import Port  # pyright: ignore[reportMissingImports]
    from nxt.sensor import Port as Input  # pyright: ignore[reportMissingImports]

    turned = [int(brick.get_output_state(Port(port))[-1]) for port in motors]
    return [*turned, int(brick.get_input_values(Input(gyro))[5]), int(brick.get_battery_level())]


def battery(brick: Any) -> int:
    """The battery [mV]."""
    return int(brick.get_battery_level())


def firmware(brick: Any) -> list[int]:
    """Major and minor version of the brick's firmware."""
    return [int(part) for part in brick.get_firmware_version()[1]]


def free(brick: Any) -> int:
    """The largest file [B] that the brick still has room for."""
    return int(brick.get_device_info()[-1])


def files(brick: Any) -> list[list[Any]]:
    """Name and size of every file, the size that it was opened for."""
    return [list(file) for file in brick.find_files("*.*")]


def start(brick: Any, name: str) -> None:
    """Begin a program."""
    brick.start_program(name)


REQUESTS: dict[str, Callable[..., Any]] = {
    f.__name__: f
    for f in (upload, fetch, running, start, stop, sensor, drive, release, look, battery, firmware, free, files)
}
"""Name of a request → its function."""


def answer(brick: Any, request: dict[str, Any]) -> dict[str, Any]:
    """The result of one request, with its number."""
    number = request.pop("number")
    try:
        return {"number": number, "ok": REQUESTS[request.pop("do")](brick, **request)}
    except Exception as error:  # any error of the library or the connection, as one line
        return {"number": number, "error": f"{type(error).__name__}: {error}".replace("\n", " ")}


def main(port: str) -> None:
    """Serve requests until the input ends, which only a flight that was killed lets happen: then end its program."""
    try:
        brick = connect(port)
    except Exception as error:
        print(json.dumps({"number": 0, "error": f"{type(error).__name__}: {error}".replace("\n", " ")}), flush=True)
        return
    print(json.dumps({"number": 0, "ok": "connected"}), flush=True)
    begun = False
    try:
        for line in sys.stdin:
            request = json.loads(line)
            begun = begun or request["do"] == "start"
            print(json.dumps(answer(brick, request)), flush=True)
    finally:
        if begun:
            stop(brick)


if __name__ == "__main__":
    main(sys.argv[1])
