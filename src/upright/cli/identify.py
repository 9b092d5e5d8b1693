"""`upright identify`: linear models from a log, one by one or all beside one another."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json, print_table, progress
from upright.errors import UprightError

if TYPE_CHECKING:
    from upright.identify.identified import Identified
    from upright.identify.identify import Comparison
    from upright.identify.study import Study
    from upright.signals import Log

ALL = "all"
ROUNDING = 1e-13
"""Entries up to this are what arithmetic leaves of a zero."""


KitOption = Annotated[str | None, typer.Option(help="Its electronics by name or TOML file (default: the robot's).")]
MappingOption = Annotated[
    str | None, typer.Option(help="A mapping by name (twipr, ev3way, …) or TOML file (default: what seems to fit).")
]


def identify(
    log: Annotated[Path, typer.Argument(help="A log of any program: .csv, .txt, .json, .mat, .parquet, .mcap.")],
    method: Annotated[
        str, typer.Option(help="least-squares, total-least-squares, instrumental, subspace, calibrate, or all.")
    ] = "subspace",
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    mapping: MappingOption = None,
    start: Annotated[float | None, typer.Option(help="Leave out what comes before this time [s].")] = None,
    until: Annotated[float | None, typer.Option(help="Leave out what comes after this time [s].")] = None,
    states: Annotated[bool, typer.Option("--states", help="From the true states of a twin's log.")] = False,
    delay: Annotated[
        float | None, typer.Option(help="Dead time from command to sensors [s] (default: from the answers).")
    ] = None,
    order: Annotated[int | None, typer.Option(help="States of pitch and wheels (default: chosen; 4 or more).")] = None,
    held_out: Annotated[float, typer.Option(help="Last share of the log that is only foretold.")] = 0.25,
    repeats: Annotated[int, typer.Option(help="Repeated logs behind intervals and biases.")] = 40,
    seed: Annotated[int, typer.Option(help="Seed of the repeated logs.")] = 0,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the model as JSON.")] = None,
    controller: Annotated[
        Path | None, typer.Option(help="Write the model's regulator as JSON, to simulate it.")
    ] = None,
    report: Annotated[Path | None, typer.Option(help="Write a page that compares the methods: .html.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Identify a linear model from a log, with intervals and the method's bias.

    --method all compares all methods, and tries a regulator designed on each model.
    """
    from upright.identify.identify import identify as fit
    from upright.identify.identify import identify_all, study_of
    from upright.identify.methods import find_identifier
    from upright.robots import find_kit, find_robot

    _ = method == ALL or find_identifier(method)
    targets = {"output": output, "controller": controller, "report": report}
    for name, target in targets.items():
        _check_target(target, method, log, name)
    data = _read(log, mapping, start, until)
    source, parts = "states" if states else "sensors", find_kit(kit) if kit else None
    choices: dict[str, Any] = {"delay": delay, "order": order, "held_out": held_out, "runs": repeats, "seed": seed}
    study = study_of(data, find_robot(robot), parts, source=source, **choices)
    with progress("identifying") as show:
        compared = identify_all(study, progress=show) if method == ALL or report else None
        found = fit(study, method) if method != ALL else None
    _write(study, found, compared, **targets)
    if as_json:
        print_json(found.to_json() if found else compared.to_json() if compared else None)
        return
    _say_what(found, compared)
    _say_written(targets)


def _say_written(targets: dict[str, Path | None]) -> None:
    for path in filter(None, targets.values()):
        typer.echo(f"wrote {path}")


def _say_what(found: Identified | None, compared: Comparison | None) -> None:
    if found:
        _say(found)
    elif compared:
        _say_all(compared)


def _read(log: Path, mapping: str | None, start: float | None, until: float | None) -> Log:
    from upright.logs.mapping import find_mapping
    from upright.logs.raw import raw_log

    data = raw_log(log, find_mapping(mapping) if mapping else None)
    return data.between(-math.inf if start is None else start, math.inf if until is None else until)


def _write(
    study: Study, found: Identified | None, compared: Comparison | None, output: Path | None, controller: Path | None,
    report: Path | None,
) -> None:  # fmt: skip
    """Everything that was asked for; the regulator is designed first, so that its failure leaves no file."""
    if found and controller:
        from upright.control import write_controller
        from upright.identify.judge import regulator

        write_controller(regulator(study.samples, found.parts), controller)
    if found and output:
        found.save(output)
    if compared and report:
        from upright.report.identification import identification_page

        identification_page(compared, report)


def _check_target(target: Path | None, method: str, log: Path, name: str) -> None:
    if target is None:
        return
    check_folder(target)
    if method == ALL and name != "report":
        raise UprightError(f"{target.name} holds one model", expected="one method", hint="name it, --method subspace")
    if target.exists() and log.exists() and target.samefile(log):
        raise UprightError(f"{target} is the log itself", expected="another file", hint="a log is never written over")


def _say(found: Identified) -> None:
    from upright.identify.identified import interval

    model, pole = found.model, found.pole
    late = ", ".join(f"{name} {count}" for name, count in found.late.items())
    typer.echo(
        f"{found.method}, {found.samples} samples of {found.source}; periods from a command to the answer: {late}"
    )
    typer.echo(f"unstable pole {pole.value:.4g} 1/s {interval(pole)}: {pole.how}")
    if not math.isnan(pole.bias):
        typer.echo(f"bias of this method on such logs {pole.bias:+.2g} 1/s (± {2 * pole.bias_error:.1g})")
    for name, chosen in found.orders.items():
        typer.echo(f"order of {name} {chosen.chosen}, from a past of {chosen.past} rows")
    typer.echo("\nx⁺ = A x + B u, one deviation after ±")
    header = ("", *model.states, *model.inputs)
    values = [[*a, *b] for a, b in zip(model.A.tolist(), model.B.tolist(), strict=True)]
    spreads = [[*a, *b] for a, b in zip(found.a_deviation.tolist(), found.b_deviation.tolist(), strict=True)]
    rows = [
        [state, *(_entry(v, d) for v, d in zip(row, spread, strict=True))]
        for state, row, spread in zip(model.states, values, spreads, strict=True)
    ]
    print_table(header, rows, header[1:])
    for horizon, fits in found.fits.items():
        said = ", ".join(f"{name} {_percent(value)}" for name, value in fits.items())
        typer.echo(f"fit {horizon} ahead, on what was held out: {said}")
    for note in found.notes:
        typer.echo(f"- {note}")


def _say_all(compared: Comparison) -> None:
    from upright.identify.identified import interval

    header = ("method", "pole [1/s]", "95 % interval", "bias", "gyro, 10 ahead", "wheels, 10 ahead", "in the loop")
    rows = [
        [name, f"{m.pole.value:.4g}", interval(m.pole), _bias(m), *_ahead(m), str(compared.trials[name])]
        for name, m in compared.models.items()
    ]
    print_table(header, rows, header[1:6])
    typer.echo(f"\nRegulators were tried on {compared.judge.who}.")
    if not math.isnan(compared.true_pole):
        typer.echo(f"Its unstable pole is {compared.true_pole:.4g} 1/s.")
    for name, why in compared.failed.items():
        typer.echo(f"- {name}: {why}")
    for note in compared.notes:
        typer.echo(f"- {note}")


def _bias(model: Identified) -> str:
    return "–" if math.isnan(model.pole.bias) else f"{model.pole.bias:+.2g}"


def _ahead(model: Identified) -> list[str]:
    return [_percent(model.fits["10"].get(name, math.nan)) for name in ("gyro", "wheel")]


def _entry(value: float, spread: float) -> str:
    shown = value if abs(value) > ROUNDING else 0.0
    return f"{shown:.4g} ±{spread:.1g}" if spread > ROUNDING else f"{shown:.4g}"


def _percent(value: float) -> str:
    return "–" if math.isnan(value) else f"{value:.0f} %"
