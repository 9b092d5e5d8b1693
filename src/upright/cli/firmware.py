"""`upright firmware`: a controller as a program for a brick."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json

if TYPE_CHECKING:
    from upright.control import Controller
    from upright.firmware import Firmware


def firmware(
    controller: Annotated[str, typer.Argument(help="A controller.json, or a controller by name.")],
    *,
    target: Annotated[str, typer.Option("--target", "-t", help="pybricks, nxc, c, arduino or ev3dev.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the program (.py, .nxc, .c with its .h, .ino).")
    ] = None,
    robot: RobotOption = "nxtway-gs",
    kit: Annotated[
        str | None, typer.Option(help="Electronics by name or TOML file (default: the robot's own).")
    ] = None,
    number: Annotated[
        str, typer.Option("--number", help="Arithmetic of c (float, double, fixed) and arduino (float, fixed).")
    ] = "",
    hub: Annotated[str, typer.Option(help="What pybricks runs on: prime, technic, ev3 or nxt.")] = "prime",
    reference: Annotated[bool, typer.Option("--reference", help="c: the wanted state as further inputs.")] = False,
    seconds: Annotated[
        int | None,
        typer.Option("--seconds", "-s", help="When it stops by itself, whatever happens [s]; 0: never (default: 60)."),
    ] = None,
    certificate: Annotated[
        Path | None, typer.Option(help="What upright certify wrote; a red or foreign one is refused.")
    ] = None,
    anyway: Annotated[bool, typer.Option("--anyway", help="Write the program in spite of the certificate.")] = False,
    listing: Annotated[
        bool, typer.Option("--listing", help="Print the program before it is put into a language.")
    ] = False,
    as_json: JsonOption = False,
) -> None:
    """Turn a controller into a program for a brick.

    Linear and sliding controllers can be turned; without -o the program is printed. Check it with upright parity.
    """
    from upright.control import find_controller
    from upright.firmware import generate
    from upright.robots import find_kit, find_robot

    if output:
        check_folder(output)
    chosen = find_robot(robot)
    parts = find_kit(kit or chosen.kit)
    brain = find_controller(controller, chosen, parts, parts.period)
    made = generate(brain, chosen, parts, target, number=number, hub=hub, reference=reference, seconds=seconds)
    warning = _refused(certificate, brain, anyway)
    written = made.write(output) if output else []
    if as_json:
        print_json(_facts(made) | {"warning": warning, "files": [str(path) for path in written]})
        return
    if not output:
        typer.echo(str(made.program) if listing else made.text)
        return
    notes = [warning, str(made.program) if listing else "", *(f"wrote {path}" for path in written), _said(made)]
    typer.echo("\n".join(line for line in notes if line))


def _refused(path: Path | None, controller: Controller, anyway: bool) -> str:
    """What is to be said in spite of the certificate; raises `NotPermitted` where it refuses and nobody insists."""
    from upright.certify import read_certificate
    from upright.control.permit import permitted

    said = permitted(controller, read_certificate(path), anyway) if path else ""
    return said if said != "certified" else ""


def _facts(made: Firmware) -> dict[str, Any]:
    program = made.program
    facts = {"target": program.target, "number": made.number, "robot": program.robot, "kit": program.kit}
    facts |= {"controller": program.kind, "hash": program.hash, "period": program.period}
    return facts | {"operations": program.operations(), "quantum": made.quantum}


def _said(made: Firmware) -> str:
    program = made.program
    fixed = "" if made.quantum is None else f", within {made.quantum:.3g} {program.command_unit} of it by proof"
    return (
        f"{program.kind} {program.hash[:12]} for {program.robot} on {program.kit}, every {program.period * 1e3:g} ms: "
        f"{program.operations()} products a period in {made.number}{fixed}"
    )
