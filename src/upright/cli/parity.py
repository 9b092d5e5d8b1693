"""`upright parity`: whether a program does what was designed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption, program_text
from upright.cli.output import print_json, progress
from upright.errors import InvalidController

NOT_EQUAL = 3
"""Exit code of a program that does not do what was designed."""


def parity(
    program: Annotated[Path, typer.Argument(help="What upright firmware wrote: .py, .c, .ino or .nxc.")],
    controller: Annotated[str, typer.Argument(help="The controller.json it was made from.")],
    *,
    robot: Annotated[
        str | None, typer.Option("--robot", "-r", help="By name or TOML file (default: the head's).")
    ] = None,
    kit: Annotated[str | None, typer.Option(help="By name or TOML file (default: the head's).")] = None,
    chip: Annotated[
        str, typer.Option(help="c: host, arm7 or avr; pybricks: micropython or mpy (default: the first).")
    ] = "",
    body: Annotated[str, typer.Option("--body", "-b", help="What it drives: twin (MuJoCo) or nonlinear.")] = "twin",
    as_json: JsonOption = False,
) -> None:
    """Run a program itself, step by step, against the design.

    It drives the twin through both pushes of Herrera et al. (2015) for 20 s; every command is compared with the
    design's. Exit code 3 where they differ or the robot falls.
    """
    from upright.control import controller_hash, find_controller
    from upright.firmware import generate, head, longest_run
    from upright.parity import parity as compare
    from upright.parity.execute import execute
    from upright.parity.parity import SECONDS
    from upright.robots import find_kit, find_robot

    text = program_text(program)
    facts = head(text)
    chosen, parts = find_robot(robot or facts["robot"]), find_kit(kit or facts["kit"])
    brain = find_controller(controller, chosen, parts, parts.period)
    if controller_hash(brain) != facts["hash"]:
        raise InvalidController(
            f"{program} holds another controller ({facts['hash'][:12]})", expected=f"{controller_hash(brain)[:12]}",
            hint="generate the program anew, or name the controller it was made from",
        )  # fmt: skip
    longest = longest_run(text)
    if 0 < longest <= SECONDS:
        raise InvalidController(
            f"{program} stops by itself after {longest} s", expected=f"more than the {SECONDS:g} s of this test",
            hint="test the same controller with upright firmware --seconds 60",
        )  # fmt: skip
    made = generate(
        brain, chosen, parts, facts["target"], number=facts["number"], hub=facts.get("hub", "prime"),
        reference="reference" in facts, seconds=longest,
    )  # fmt: skip
    executor = execute(program, made.program, made.number, chip)
    try:
        with progress("running") as share:
            found = compare(
                executor, brain, made.program, chosen, parts, quantum=made.quantum, body=body, progress=share
            )
    finally:
        executor.close()
    current = text in {t.replace("@HEADER@", f"{program.stem}.h") for t in made.files.values()}
    if as_json:
        print_json(found.to_json() | {"as_generated": current})
    else:
        typer.echo(str(found) + ("" if current else "\n  the file is not what upright generates now: edited, or older"))
    if not found.passed:
        raise typer.Exit(NOT_EQUAL)
