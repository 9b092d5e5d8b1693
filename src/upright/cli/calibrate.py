"""`upright calibrate`: the robot from its own raw log."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json, print_table, progress
from upright.errors import UprightError

if TYPE_CHECKING:
    from upright.calibrate.calibration import Calibration, Estimate


def calibrate(
    logs: Annotated[list[Path], typer.Argument(help="Logs of one robot: .csv, .txt, .json, .mat, .parquet, .mcap.")],
    robot: RobotOption = "nxtway-gs",
    kit: Annotated[
        str | None, typer.Option(help="Its electronics by name or TOML file (default: the robot's).")
    ] = None,
    mapping: Annotated[
        str | None, typer.Option(help="A mapping by name (twipr, ev3way, …) or TOML file (default: what seems to fit).")
    ] = None,
    start: Annotated[float | None, typer.Option(help="Leave out what comes before this time [s].")] = None,
    until: Annotated[
        float | None, typer.Option(help="Leave out what comes after this time [s], such as a fall.")
    ] = None,
    known: Annotated[
        list[str] | None, typer.Option(help="A parameter taken for exact, such as body_mass; repeatable.")
    ] = None,
    held_out: Annotated[float, typer.Option(help="Last share of each log that is only foretold.")] = 0.25,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the robot as TOML.")] = None,
    page: Annotated[Path | None, typer.Option("--report", help="Write a page with figures: .html.")] = None,
    save: Annotated[Path | None, typer.Option(help="Write all numbers, with the covariance, as JSON.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Learn a robot's parameters, dead times and noise from its raw logs.

    Prints each number with its 95 % interval, its prior, and whether the log can tell it at all.
    """
    import math

    from upright.atomic import write_json
    from upright.calibrate.calibrate import calibrate as learn
    from upright.logs.mapping import find_mapping
    from upright.logs.raw import raw_log
    from upright.robots import find_kit, find_robot

    for target in (output, page, save):
        if target:
            check_folder(target)
            _check_new(target, logs)
    chosen = find_mapping(mapping) if mapping else None
    data = [raw_log(path, chosen).between(start or -math.inf, math.inf if until is None else until) for path in logs]
    with progress("calibrating") as show:
        found = learn(
            data, find_robot(robot), find_kit(kit) if kit else None, known=known or (), held_out=held_out, progress=show
        )
    if output:
        found.known_robot().save(output)
    if save:
        write_json(save, found.to_json())
    if page:
        from upright.report.calibration import calibration_page

        calibration_page(found, page)
    if as_json:
        print_json(found.to_json())
        return
    _say(found)
    for path in filter(None, (output, page, save)):
        typer.echo(f"wrote {path}")


def _say(found: Calibration) -> None:
    typer.echo(f"{found.robot.name}: {found.samples} samples fitted in {found.seconds:.1f} s\n")
    header = ("parameter", "unit", "value", "95 % interval", "prior", "verdict")
    rows = [_row(e) for e in (*found.parameters, *found.delays, *found.electronics)]
    print_table(header, rows, numbers=("value", "prior"))
    typer.echo("\nWhat enters the motion:")
    print_table(header, [_row(e) for e in found.combinations], numbers=("value", "prior"))
    for horizon, fits in found.fits.items():
        said = ", ".join(f"{name.removeprefix('sensor/')} {value:.1f} %" for name, value in fits.items())
        typer.echo(f"\nFit {horizon} samples ahead, on the part kept back: {said}", nl=False)
    typer.echo("\n\nR² of half seconds simulated freely: " + ", ".join(
        f"{name.removeprefix('sensor/')} {value:.4f}" for name, value in found.segments.items()
    ))  # fmt: skip
    for note in (*found.notes, *found.unseen):
        typer.echo(f"- {note}")


def _row(e: Estimate) -> tuple[str, ...]:
    prior = f"{e.prior:.4g}" + ("" if e.guess else f" ± {e.prior_spread:.2g}")
    verdict = e.verdict + (f"; contradicts its prior by {abs(e.shift):.1f} deviations" if e.surprising else "")
    return e.name, e.unit, f"{e.value:.5g}", f"{e.low:.4g} to {e.high:.4g}", prior, verdict


def _check_new(target: Path, logs: list[Path]) -> None:
    if any(target.exists() and log.exists() and target.samefile(log) for log in logs):
        raise UprightError(f"{target} is a log itself", expected="another file", hint="a log is never written over")
