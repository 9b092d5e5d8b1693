"""`upright fly`: a program onto a brick or a hub, into balance, and its log home."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli import options
from upright.cli.output import check_folder, print_json, progress
from upright.errors import InvalidController, UprightError

if TYPE_CHECKING:
    from upright.compiled.program import Program
    from upright.control import Controller
    from upright.flight.fly import Flight
    from upright.robots import Robot

VIRTUAL, AIR = "virtual", "ble"
LOST = 3
"""Exit code of a flight whose line was lost: the program goes on without it."""
PORTS = {"nxc": "usb, a device such as /dev/rfcomm0, or virtual", "pybricks": "ble, ble:NAME or virtual"}
BRICKS = {"nxc": "nxt", "prime": "spike", "technic": "technic", "ev3": "ev3", "nxt": "nxt"}
"""Target or hub of a program → the name of its brick."""
TWINS = {"nxc": "a virtual NXT brick with the twin round it", "pybricks": "a virtual hub with the twin round it"}


def fly(
    program: Annotated[Path, typer.Argument(help="What upright firmware wrote for nxc (.nxc) or pybricks (.py).")],
    controller: Annotated[str, typer.Argument(help="The controller.json it was made from.")],
    *,
    robot: Annotated[
        str | None,
        typer.Option(
            "--robot", "-r", help="What it must be made for: a robot by name or TOML file, or nxt, spike or ev3."
        ),
    ] = None,
    port: Annotated[
        str,
        typer.Option(
            help="An NXT at usb or at a device such as /dev/rfcomm0; a hub at ble or ble:NAME; virtual, a twin."
        ),
    ] = VIRTUAL,
    certificate: Annotated[
        Path | None, typer.Option(help="What upright certify wrote; a red or foreign one is refused.")
    ] = None,
    anyway: Annotated[bool, typer.Option("--anyway", help="Fly in spite of the certificate.")] = False,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="Do not ask.")] = False,
    seconds: Annotated[float, typer.Option("--seconds", "-s", help="How long, the still start included [s].")] = 20.0,
    push: Annotated[
        list[str] | None, typer.Option("--push", "-p", metavar="KIND:NUMBER,...", help="Virtual: " + options.PUSH_HELP)
    ] = None,
    seed: Annotated[int, typer.Option(help="Virtual: seed of all noise.")] = 0,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the log: .parquet, .csv or .mcap.")
    ] = None,
    fetch: Annotated[
        bool,
        typer.Option("--fetch", help="Start nothing; stop what runs, and bring home the log that is there."),
    ] = False,
    as_json: options.JsonOption = False,
) -> None:
    """Upload a program to an NXT brick or a Pybricks hub, start it, and fetch its log.

    Shows robot, controller, certificate and hash, and asks. The motors are off when this ends, Ctrl-C included. Exit
    code 3 where the robot was lost on the way.
    """
    from upright.firmware import head, longest_run

    if output:
        check_folder(output)
    facts = head(text := options.program_text(program))
    _check(facts["target"], port, seconds, push, fetch)
    _in_time(program, seconds, longest_run(text))
    chosen = _meant(robot, program, facts)
    brain, made = _made(program, controller, chosen, facts)
    permit = "" if fetch else _permit(certificate, brain, anyway)
    _ask(made, port, permit, yes or fetch or as_json)
    flight = _flown(program, made, chosen, port, seconds, [options.push(p) for p in push or []], seed, fetch)
    _say(flight, made, port, flight.log.log.save(output) if flight.log and output else None, as_json)
    if flight.lost:
        raise typer.Exit(LOST)


def _check(target: str, port: str, seconds: float, push: list[str] | None, fetch: bool) -> None:
    if target not in PORTS:
        raise UprightError(f"a program for {target} is not flown from here", expected=" or ".join(PORTS))
    if port != VIRTUAL and (port.partition(":")[0] == AIR) != (target == "pybricks"):
        raise UprightError(f"--port {port} for a {target} program", expected=PORTS[target])
    if not (math.isfinite(seconds) and 0 < seconds <= 600):
        raise UprightError(f"--seconds {seconds:g}", expected="more than 0 and at most 600")
    if push and port != VIRTUAL:
        raise UprightError("a real robot is pushed by hand", expected=f"--push with --port {VIRTUAL} only")
    if fetch and port == VIRTUAL:
        raise UprightError("a virtual brick keeps nothing", expected="--fetch with a real port")


def _in_time(program: Path, seconds: float, longest: int) -> None:
    if longest and seconds > longest:
        raise UprightError(
            f"--seconds {seconds:g}: {program} stops by itself after {longest} s", expected=f"at most {longest}",
            hint=f"upright firmware --seconds {math.ceil(seconds)} makes one that drives longer",
        )  # fmt: skip


def _meant(name: str | None, program: Path, facts: dict[str, str]) -> Robot:
    """The robot of that name, where the program was made for it; for a brick's name or none the program's own."""
    from upright.robots import find_robot

    brick = BRICKS[facts.get("hub", facts["target"])]
    if name is None or name in BRICKS.values():
        found, meant = find_robot(facts["robot"]), name in (None, brick)
    else:
        found = find_robot(name)
        meant = found.name == facts["robot"]
    if not meant:
        raise UprightError(
            f"{program} was made for {facts['robot']} on the brick {brick}", expected=f"a program for {name}",
            hint="upright firmware makes one",
        )  # fmt: skip
    return found


def _made(source: Path, controller: str, robot: Robot, facts: dict[str, str]) -> tuple[Controller, Program]:
    """The controller, and the program that is made of it, which `source` has to hold."""
    from upright.control import find_controller
    from upright.firmware import generate
    from upright.robots import find_kit

    kit = find_kit(facts["kit"])
    brain = find_controller(controller, robot, kit, kit.period)
    made = generate(brain, robot, kit, facts["target"]).program
    if made.hash != facts["hash"]:
        raise InvalidController(
            f"{source} holds another controller ({facts['hash'][:12]})", expected=f"{made.hash[:12]}",
            hint=f"upright firmware CONTROLLER --target {made.target}, or name the controller it was made from",
        )  # fmt: skip
    return brain, made


def _permit(path: Path | None, brain: Any, anyway: bool) -> str:
    from upright.certify import read_certificate
    from upright.control.permit import permitted

    return permitted(brain, read_certificate(path) if path else None, anyway)


def _ask(program: Program, port: str, permit: str, sure: bool) -> None:
    if sure:
        return
    where = TWINS[program.target] if port == VIRTUAL else f"at {port}"
    typer.echo(f"robot       {program.robot} on {program.kit}, {where}", err=True)
    typer.echo(f"controller  {program.kind} {program.hash[:12]}, every {program.period * 1e3:g} ms", err=True)
    typer.echo(f"certificate {permit}", err=True)
    typer.confirm("Hold it upright and still. Start?", abort=True, err=True)


def _flown(
    source: Path, made: Program, robot: Robot, port: str, seconds: float, pushes: list[Any], seed: int, fetch: bool
) -> Flight:
    from upright.flight.fly import fetch as fetch_nxt
    from upright.flight.fly import fly as fly_nxt
    from upright.flight.fly_hub import fetch_hub, fly_hub

    hub = made.target == "pybricks"
    if fetch:
        return fetch_hub(made, port) if hub else fetch_nxt(made, port)
    with progress("flying") as share:
        if port == VIRTUAL:
            return _twin(source, made, robot, seconds, pushes, seed, share)
        return (fly_hub if hub else fly_nxt)(source, made, port, seconds, share)


def _twin(
    source: Path, made: Program, robot: Robot, seconds: float, pushes: list[Any], seed: int, share: Any
) -> Flight:
    """The flight of a virtual brick or hub, whose time runs as fast as it can and not beyond the end."""
    from upright.bricks.virtual_robot import virtual_flight, virtual_hub
    from upright.flight.fly import fly as fly_nxt
    from upright.flight.fly_hub import fly_hub
    from upright.robots import find_kit

    kit, where = find_kit(made.kit), TWINS[made.target]
    if made.target == "pybricks":
        with virtual_hub(robot, kit, pushes, seed=seed) as hub:
            hub.until = seconds
            return fly_hub(source, made, hub, seconds, share, lambda: hub.seconds, where=where)
    with virtual_flight(robot, kit, pushes, seed=seed) as virtual:
        virtual.line.until = seconds
        return fly_nxt(source, made, virtual.path, seconds, share, virtual.clock, where)


def _say(flight: Flight, made: Program, port: str, path: Path | None, as_json: bool) -> None:
    log = flight.log
    facts = {"rows": len(log.log) if log else 0, "seconds": float(log.log.t[-1]) if log else 0.0}
    facts |= {"largest_pitch": float(abs(log.log["estimate/pitch"]).max()) if log else None}
    facts |= {"hash": made.hash, "port": port, "notes": flight.notes, "log": str(path) if path else None}
    if as_json:
        print_json(facts)
        return
    where = TWINS[made.target] if port == VIRTUAL else port
    if log:
        typer.echo(
            f"{made.robot} ({where}) balanced for {facts['seconds']:.1f} s; by its own opinion at most "
            f"{facts['largest_pitch']:.3f} rad off upright"
        )
    for line in (*flight.notes, *([f"wrote {path}"] if path else [])):
        typer.echo(line)
