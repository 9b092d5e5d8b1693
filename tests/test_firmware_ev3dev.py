"""The program for ev3dev on the library that a brick has, python-ev3dev2, with files in place of the kernel's."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from conftest import PATIENCE
from firmware_cases import NXT, written
from upright.flight.program_logs import read_lines

DRIVER = """
import fcntl, runpy, sys, types
sys.modules["evdev"] = types.ModuleType("evdev")  # of the brick's own Linux: only for waiting on a button
import ev3dev2
ev3dev2.get_current_platform = lambda: "ev3"
ev3dev2.Device.DEVICE_ROOT_PATH = sys.argv[2]
from ev3dev2._platform import ev3
ev3.BUTTONS_FILENAME = sys.argv[2] + "/buttons"
fcntl.ioctl = lambda *_: 0  # no button is pressed
runpy.run_path(sys.argv[1], run_name="__main__")
"""
"""The library as it is, told only where its files lie."""

MOTOR = {"driver_name": "lego-ev3-l-motor", "position": "0", "duty_cycle_sp": "0", "command": ""}
MOTOR |= {"max_speed": "1050", "count_per_rot": "360"}
LEFT, RIGHT, GYRO = "tacho-motor/motor1", "tacho-motor/motor0", "lego-sensor/sensor0"


def sysfs(root: Path) -> Path:
    """What the kernel of ev3dev shows of two motors, a gyro, the battery and the lights."""
    lights = {f"leds/led{i}:{c}:brick-status": {"brightness": "0", "max_brightness": "255", "trigger": "none"}
              for i in range(2) for c in ("red", "green")}  # fmt: skip
    devices = lights | {
        LEFT: MOTOR | {"address": "ev3-ports:outD"},
        RIGHT: MOTOR | {"address": "ev3-ports:outA"},
        GYRO: {
            "driver_name": "lego-ev3-gyro",
            "address": "ev3-ports:in1",
            "mode": "GYRO-ANG",
            "value0": "0",
            "num_values": "1",
        },
        "power_supply/lego-ev3-battery": {"voltage_now": "7800000"},
    }
    for device, attributes in devices.items():
        (root / device).mkdir(parents=True)
        for name, value in attributes.items():
            (root / device / name).write_text(value)
            (root / device / name).chmod(0o664)
    (root / "buttons").touch()
    return root


def wait(until: Callable[[], bool], process: subprocess.Popen[str]) -> None:
    end = time.monotonic() + PATIENCE
    while not until():
        assert process.poll() is None, process.communicate()
        assert time.monotonic() < end
        time.sleep(0.005)


@pytest.mark.needs("module:ev3dev2")
def test_the_program_drives_the_library_of_the_brick(tmp_path: Path) -> None:
    """It sets the gyro's mode, stands still until its lights are green, runs both motors directly, answers a gyro that
    turns with duties of both, stops both motors, and its log comes home."""
    source, made = written(tmp_path, "ev3dev")
    root = sysfs(tmp_path / "sys")
    process = subprocess.Popen(
        [sys.executable, "-c", DRIVER, str(source), str(root)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )

    def now(device: str, name: str) -> str:
        return (root / device / name).read_text()

    wait(lambda: all(now(motor, "command").startswith("run-direct") for motor in (LEFT, RIGHT)), process)
    assert now(GYRO, "mode") == "GYRO-RATE"
    assert now("leds/led0:green:brick-status", "brightness").startswith("255")
    with (root / GYRO / "value0").open("r+") as value:  # over what stands there: an empty file is no number
        value.write("40")  # [deg/s]: without wheels that answer, it lies after a second or two
    printed, complaints = process.communicate(timeout=PATIENCE)
    assert complaints == ""
    assert [now(motor, "command")[:4] for motor in (LEFT, RIGHT)] == ["stop"] * 2
    log = read_lines(printed.splitlines())
    volts = [log.log[f"applied/{side}"] for side in ("left", "right")]
    assert min(np.abs(u).max() for u in volts) > 0.1 * NXT.battery.voltage
    assert log.head["hash"] == made.program.hash
    assert NXT.name in printed
