"""`upright excite`: the next experiment to run, so that its log tells most of the robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json, print_table, progress

if TYPE_CHECKING:
    from upright.excite.plan import ExcitationPlan, Predicted


def excite(
    *,
    robot: RobotOption = "nxtway-gs",
    kit: Annotated[
        str | None, typer.Option(help="Electronics by name or TOML file (default: the robot's own).")
    ] = None,
    controller: Annotated[
        str, typer.Option("--controller", "-c", help="What keeps it upright meanwhile: by name or JSON file, linear.")
    ] = "lqg",
    seconds: Annotated[float, typer.Option("--seconds", "-s", help="How long the run is to be [s].")] = 20.0,
    focus: Annotated[
        str | None,
        typer.Option(metavar="NAME,…", help="The parameters in question, such as com_height (default: all)."),
    ] = None,
    known: Annotated[
        list[str] | None, typer.Option(help="A parameter taken for exact, such as body_mass; repeatable.")
    ] = None,
    posterior: Annotated[
        Path | None,
        typer.Option(help="Which robots to expect, by `upright calibrate --save` (default: the spreads of its file)."),
    ] = None,
    falls: Annotated[float, typer.Option(help="Largest chance of a fall, with 95 % confidence.")] = 0.01,
    saturated: Annotated[float, typer.Option(help="Largest share of periods with a motor at its limit.")] = 0.05,
    travel: Annotated[float, typer.Option(help="Farthest it may roll from its start [m].")] = 0.5,
    enough: Annotated[
        float, typer.Option(help="How many times as wide intervals may be for less energy; 1 uses all limits allow.")
    ] = 1.1,
    samples: Annotated[int, typer.Option("--samples", "-n", help="How many robots the limits are tried on.")] = 600,
    seed: Annotated[int, typer.Option(help="Seed of all draws and all noise.")] = 0,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the plan as JSON.")] = None,
    page: Annotated[Path | None, typer.Option("--report", help="Write a page with figures: .html.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Design the next experiment: what to add to the commands, so that the log tells most.

    Then run it, `upright simulate --controller … --excite plan.json -o run.csv` or on the robot, and calibrate from the
    log.
    """
    from upright.excite import excite as design
    from upright.excite.plan import Limits

    for target in filter(None, (output, page)):
        check_folder(target)
    found = _found(robot, kit, controller, posterior)
    names = [name.strip() for name in focus.split(",")] if focus else []
    with progress("designing") as show:
        plan = design(
            **found, seconds=seconds, focus=names, limits=Limits(falls, saturated, travel), enough=enough,
            known=known or (), samples=samples, seed=seed, progress=show,
        )  # fmt: skip
    _keep(plan, output, page)
    if as_json:
        print_json(plan.to_json())
        return
    _say(plan)
    typer.echo("".join(f"wrote {path}\n" for path in (output, page) if path), nl=False)


def _found(robot: str, kit: str | None, controller: str, posterior: Path | None) -> dict[str, Any]:
    """Robot, kit and controller, and which robots to expect."""
    from upright.control import find_controller
    from upright.fleet.vary import read_posterior
    from upright.robots import find_kit, find_robot

    nominal, drawn = find_robot(robot), read_posterior(posterior) if posterior else None
    if drawn:
        middle = dict(zip(drawn.names, drawn.mean.tolist(), strict=True))
        nominal = nominal.replace(**middle, provenance=nominal.provenance)
    parts = find_kit(kit or nominal.kit)
    brain = find_controller(controller, nominal, parts, parts.period)
    return {"robot": nominal, "kit": parts, "controller": brain, "posterior": drawn}


def _keep(plan: ExcitationPlan, output: Path | None, page: Path | None) -> None:
    from upright.atomic import write_json

    if output:
        write_json(output, plan.to_json())
    if page:
        from upright.report.excitation import excitation_page

        excitation_page(plan, page)


def _say(plan: ExcitationPlan) -> None:
    checked = plan.checked
    typer.echo(f"{plan.way} for {plan.robot} with kit {plan.kit} under {plan.controller}: {plan.seconds:g} s\n")
    print_table(("of its energy", "goes into"), [(f"{share:.0%}", name) for name, share in plan.shares.items()])
    typer.echo(
        f"\nTried {plan.margin:g} times as large on {checked.samples} robots: {checked.fell} fell, so the chance is "
        f"below {checked.bound:.2%}.\n95 % of them: saturated for at most {checked.saturated:.1%} of the time, at most "
        f"{checked.travel:.2f} m from the start, pitch at most {checked.peak:.2f} rad.\n"
    )
    kinds = ("before", "after", "by a dither", "by one held 40 ms", "by 100 runs")
    header = ("parameter", "unit", "value", *(f"± {kind}" for kind in kinds))
    rows = [_row(p) for p in plan.predicted]
    print_table(header, rows, numbers=header[2:])
    typer.echo(
        "\n± is half of the 95 % interval. Both dithers are random binary ones of the same energy.\n"
        "What is left after 100 runs comes from the spreads of other numbers: measure those, and name them --known."
    )
    for note in plan.notes:
        typer.echo(f"- {note}")


def _row(p: Predicted) -> tuple[str, ...]:
    halves = (f"{width / 2:.3g}" for width in (p.before, p.after, p.dither, p.held, p.least))
    return p.name, p.unit, f"{p.value:.4g}", *halves
