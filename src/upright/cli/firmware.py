"""`upright firmware`: a controller as a program for a brick."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.atomic import place_of
from upright.cli.options import (
    AnywayOption,
    CertificateOption,
    ControllerArgument,
    JsonOption,
    KitOption,
    RobotOption,
    completed,
    registered,
)
from upright.cli.output import print_json

TargetOption = Annotated[
    str,
    typer.Option(
        "--target",
        "-t",
        help="Language: pybricks, nxc, c, arduino or ev3dev.",
        autocompletion=completed(registered("upright.firmware.targets", "TARGETS")),
    ),
]


def firmware(
    controller: ControllerArgument,
    *,
    target: TargetOption,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the program (.py, .nxc, .c with its .h, .ino).")
    ] = None,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    number: Annotated[
        str, typer.Option("--number", help="Arithmetic of c (float, double, fixed) and arduino (float, fixed).")
    ] = "",
    hub: Annotated[
        str,
        typer.Option(
            help="Hub of pybricks: prime, technic, ev3 or nxt.",
            autocompletion=completed(registered("upright.firmware.generate", "GYROS")),
        ),
    ] = "prime",
    reference: Annotated[bool, typer.Option("--reference", help="For c: the reference state as inputs.")] = False,
    seconds: Annotated[
        int | None,
        typer.Option("--seconds", "-s", help="Time after which the program stops [s]; 0: no limit (default: 60)."),
    ] = None,
    certificate: CertificateOption = None,
    anyway: AnywayOption = False,
    listing: Annotated[bool, typer.Option("--listing", help="Print the statements, in no language.")] = False,
    as_json: JsonOption = False,
) -> None:
    """Turn a controller into a program for a brick.

    The controller must be linear or sliding-mode. Without -o the program is printed. Check it with `upright parity`.
    """
    from upright.certification import read_certificate
    from upright.control import find_controller
    from upright.experiment.permit import permitted
    from upright.firmware import generate
    from upright.robots import find_kit, find_robot
    from upright.robots.motor import refuse_energy

    if output:
        place_of(output)  # which refuses where no file can be written
    chosen = refuse_energy(find_robot(robot))
    parts = find_kit(kit or chosen.kit)
    design = find_controller(controller, chosen, parts, parts.period)
    made = generate(design, chosen, parts, target, number=number, hub=hub, reference=reference, seconds=seconds)
    permit = permitted(design, read_certificate(certificate), chosen, parts, anyway=anyway) if certificate else ""
    warning = permit if permit != "certified" else ""
    written = made.write(output) if output else []
    if as_json:
        print_json(made.to_json() | {"warning": warning, "files": [str(path) for path in written]})
        return
    if not output:
        typer.echo(str(made.program) if listing else made.text)
        return
    notes = [warning, str(made.program) * listing, made.wiring, *(f"wrote {path}" for path in written), str(made)]
    typer.echo("\n".join(filter(None, notes)))
