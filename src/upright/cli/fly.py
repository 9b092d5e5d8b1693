"""`upright fly`: a program onto a brick, into balance, and its log home."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli import options
from upright.cli.output import check_folder, print_json, progress
from upright.errors import InvalidController, UprightError

if TYPE_CHECKING:
    from upright.firmware.fly import Flight
    from upright.firmware.program import Program

VIRTUAL = "virtual"


def fly(
    program: Annotated[Path, typer.Argument(help="What upright firmware wrote for the NXT: .nxc.")],
    controller: Annotated[str, typer.Argument(help="The controller.json it was made from.")],
    *,
    port: Annotated[
        str, typer.Option(help="usb, a device such as /dev/rfcomm0, or virtual: a brick with the twin round it.")
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
    fetch: Annotated[bool, typer.Option("--fetch", help="Drive nothing; bring home the log that is there.")] = False,
    as_json: options.JsonOption = False,
) -> None:
    """Upload a program to an NXT brick, start it, and fetch its log.

    Shows robot, controller, certificate and hash, and asks. The motors are off when this ends, Ctrl-C included.
    """
    from upright.control import find_controller
    from upright.firmware import generate, head
    from upright.robots.files import find_kit, find_robot

    _check(port, seconds, push)
    if output:
        check_folder(output)
    facts = head(options.program_text(program))
    robot, kit = find_robot(facts["robot"]), find_kit(facts["kit"])
    brain = find_controller(controller, robot, kit, kit.period)
    made = generate(brain, robot, kit, facts["target"]).program
    if facts["target"] != "nxc" or made.hash != facts["hash"]:
        raise InvalidController(
            f"{program} is a {facts['target']} program of {facts['hash'][:12]}", expected=f"nxc of {made.hash[:12]}",
            mend="upright firmware CONTROLLER --target nxc",
        )  # fmt: skip
    permit = "" if fetch else _permit(certificate, brain, anyway)
    _ask(made, port, permit, yes or fetch or as_json)
    pushes = [options.push(text) for text in push or []]
    flight = _home(made, port) if fetch else _flown(program, made, port, seconds, pushes, seed)
    _say(flight, made, port, flight.log.log.save(output) if flight.log and output else None, as_json)


def _check(port: str, seconds: float, push: list[str] | None) -> None:
    if not (math.isfinite(seconds) and 0 < seconds <= 600):
        raise UprightError(f"--seconds {seconds:g}", expected="more than 0 and at most 600")
    if push and port != VIRTUAL:
        raise UprightError("a real robot is pushed by hand", expected=f"--push with --port {VIRTUAL} only")


def _permit(path: Path | None, brain: Any, anyway: bool) -> str:
    from upright.certify import read_certificate
    from upright.control.permit import permitted

    return permitted(brain, read_certificate(path) if path else None, anyway)


def _ask(program: Program, port: str, permit: str, sure: bool) -> None:
    if sure:
        return
    typer.echo(
        f"robot       {program.robot} on {program.kit}, {'a twin' if port == VIRTUAL else 'at ' + port}", err=True
    )
    typer.echo(f"controller  {program.kind} {program.hash[:12]}, every {program.period * 1e3:g} ms", err=True)
    typer.echo(f"certificate {permit}", err=True)
    typer.confirm("Hold it upright and still. Start?", abort=True, err=True)


def _flown(source: Path, made: Program, port: str, seconds: float, pushes: list[Any], seed: int) -> Flight:
    from upright.firmware.fly import fly as start
    from upright.firmware.virtual_robot import virtual_flight
    from upright.robots.files import find_kit, find_robot

    with progress("flying") as share:
        if port != VIRTUAL:
            return start(source, made, port, seconds, share)
        with virtual_flight(made, find_robot(made.robot), find_kit(made.kit), pushes, seed=seed) as virtual:
            virtual.line.until = seconds
            return start(source, made, virtual.path, seconds, share, virtual.clock)


def _home(made: Program, port: str) -> Flight:
    from upright.firmware.connection import Connection
    from upright.firmware.fly import Flight, bring_home

    if port == VIRTUAL:
        raise UprightError("a virtual brick keeps nothing", expected="--fetch with a real port")
    flight = Flight()
    with Connection(port) as brick:
        bring_home(brick, made, flight)
    return flight


def _say(flight: Flight, made: Program, port: str, path: Path | None, as_json: bool) -> None:
    log = flight.log
    facts = {"rows": len(log.log) if log else 0, "seconds": float(log.log.t[-1]) if log else 0.0}
    facts |= {"largest_pitch": float(abs(log.log["estimate/pitch"]).max()) if log else None}
    facts |= {"hash": made.hash, "port": port, "notes": flight.notes, "log": str(path) if path else None}
    if as_json:
        print_json(facts)
        return
    where = "the twin in a virtual brick" if port == VIRTUAL else port
    if log:
        typer.echo(
            f"{made.robot} ({where}) balanced for {facts['seconds']:.1f} s; by its own opinion at most "
            f"{facts['largest_pitch']:.3f} rad off upright"
        )
    for line in (*flight.notes, *([f"wrote {path}"] if path else [])):
        typer.echo(line)
