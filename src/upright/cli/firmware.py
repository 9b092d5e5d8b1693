"""`upright firmware`: a controller as a program for a brick."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.atomic import place_of
from upright.cli.output import print_json, tell


def firmware(
    controller: str,
    *,
    target: str,
    output: Annotated[Path | None, "Write the program (.py, .nxc, .c with its .h, .ino)."] = None,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    number: str = "",
    hub: str = "prime",
    reference_inputs: bool = False,
    seconds: Annotated[
        int | None, "Length of the run [s], after which the program stops; 0: no limit (default: 60)."
    ] = None,
    certificate: Path | None = None,
    anyway: bool = False,
    listing: bool = False,
    json: bool = False,
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
    made = generate(design, chosen, parts, target, number=number, hub=hub, reference=reference_inputs, seconds=seconds)
    permit = permitted(design, read_certificate(certificate), chosen, parts, anyway=anyway) if certificate else ""
    warning = permit if permit != "certified" else ""
    written = made.write(output) if output else []
    if json:
        print_json(made.to_json() | {"warning": warning, "files": [str(path) for path in written]})
        return
    if not output:
        typer.echo(str(made.program) if listing else made.text)
        return
    notes = [warning, str(made.program) * listing, made.wiring, *(f"wrote {path}" for path in written), str(made)]
    tell("\n".join(filter(None, notes)))
