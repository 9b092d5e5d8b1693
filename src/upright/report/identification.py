"""The page of a comparison of identified models: poles with intervals, what they foretell, what the loop says."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from upright.identify.identified import Identified
from upright.identify.identify import Comparison
from upright.identify.methods import TITLES
from upright.report.figure import Figure, Panel, PointFigure, PointSet, Trace
from upright.report.page import Cell, Item, Page, Section, Table, Verdict, cell_text


def identification_page(compared: Comparison, path: str | Path) -> Path:
    """Write the comparison as one self-contained HTML page and return its path."""
    return page_of(compared).write(path)


def page_of(compared: Comparison) -> Page:
    """The comparison's page, not yet written."""
    holding = [name for name, trial in compared.trials.items() if trial.holds]
    verdict = Verdict(f"{len(holding)} of {len(compared.trials)} hold it", "good" if holding else "warn")
    data = compared.samples
    sections = [
        Section("In the loop", [_lead_of_loop(compared), trial_table(compared)], verdict),
        Section("The unstable pole", [_POLES, pole_table(compared), _eigenvalues(compared)]),
        Section("How far they foretell", [_FORETOLD, *_foretold(compared)]),
        Section("How many states", _orders(compared)),
        Section("What else is to be said", [*compared.notes, *_failures(compared), *_late(compared)]),
    ]
    facts = {
        "samples": f"{data.fitted} fitted of {len(data.log)}",
        "period": f"{data.dt * 1e3:.4g} ms",
        "read from": data.source,
        "robot": data.robot.name,
        "kit": data.kit.name,
    }
    return Page(f"Linear models of {data.robot.name}", sections, _lead(compared), facts, compared.judge.made_the_log)


_POLES = (
    "The rate at which the robot falls, with its 95 % interval. The bias is what the method says of repeated logs, on "
    "average, less the pole that was put into them: the loop of the subspace model and the law that the log shows, "
    "with innovations drawn anew. An interval holds the scatter, not the bias."
)
_FORETOLD = (
    "Fit in per cent, 100 (1 − rms error / rms of the motion), on the part of the log that was held out, from one and "
    "the same filter for all models. Angles count by how far they moved in the time foretold."
)


def _lead(compared: Comparison) -> str:
    holding = [name for name, trial in compared.trials.items() if trial.holds]
    said = (
        f"A regulator designed on the model of {', '.join(holding)} holds the robot"
        if holding
        else "No model's regulator holds the robot"
    )
    true = "" if math.isnan(compared.true_pole) else f", which falls at {compared.true_pole:.3g} 1/s"
    return f"{said}{true}. All methods saw the same samples."


def _lead_of_loop(compared: Comparison) -> str:
    return (
        f"The same weights, the same filter noise and the same kit for all; only the model differs. Tried on "
        f"{compared.judge.who}: held at 0.05 rad for a second, let go, and watched for seven."
    )


def trial_table(compared: Comparison) -> Table:
    """What came of each regulator."""
    rows: list[list[Cell]] = [
        [name, TITLES.get(name, ""), str(t).replace(" ", "\u00a0") if not t.why else t.why, t.largest, t.restless]
        for name, t in compared.trials.items()
    ]
    return Table(
        ["method", "what it is", "in the loop", "peak [rad]", "rest [rad]"],
        rows,
        "Largest pitch after the release, and its rms in the last two seconds",
        digits=3,
    )


def pole_table(compared: Comparison) -> Table:
    """Unstable poles by method, with interval and bias."""
    rows: list[list[Cell]] = [_pole_row(name, m) for name, m in compared.models.items()]
    if not math.isnan(compared.true_pole):
        rows.append(["the robot itself", compared.true_pole, "", None, None, None])
    header = ["method", "pole [1/s]", "95 % interval", "bias [1/s]", "± of the bias", "less its bias"]
    how = dict.fromkeys(m.pole.how for m in compared.models.values() if math.isfinite(m.pole.low))
    return Table(header, rows, "Unstable pole; intervals from the " + ", or the ".join(how), digits=3)


def _pole_row(name: str, model: Identified) -> list[Cell]:
    p = model.pole
    known = f"{cell_text(p.low, 3)} to {cell_text(p.high, 3)}" if math.isfinite(p.low) else "none"
    return [name, p.value, known, p.bias, 2 * p.bias_error, p.corrected]


def _eigenvalues(compared: Comparison) -> PointFigure:
    sets = [
        PointSet(name, [complex(v) for v in np.linalg.eigvals(m.parts[0].A) if abs(v) < 2])
        for name, m in compared.models.items()
    ]
    spread = [m.pole.value for m in compared.models.values()]
    between = f"{cell_text(min(spread), 2)} to {cell_text(max(spread), 2)}" if spread else "none"
    title = f"Eigenvalues of pitch and wheels over one period; unstable poles from {between} 1/s"
    return PointFigure(title, sets)


def _foretold(compared: Comparison) -> list[Item]:
    horizons = list(next(iter(compared.models.values())).fits) if compared.models else []
    outputs = compared.samples.parts[0].outputs
    header = ["method", *(f"{output}, {h} ahead" for output in outputs for h in horizons)]
    rows: list[list[Cell]] = [
        [name, *(m.fits[h].get(output) for output in outputs for h in horizons)] for name, m in compared.models.items()
    ]
    panels = [
        Panel(f"fit of {output}", "%", [_trace(name, m, output) for name, m in compared.models.items()], (0.0, 100.0))
        for output in outputs
    ]
    title = "What each model foretells of the part held out"
    figure = Figure(title, panels, "samples ahead, power of ten", "")
    return [Table(header, rows, "Fit [%]; – where the model runs away", digits=3), figure]


def _trace(name: str, model: Identified, output: str) -> Trace:
    ahead = [math.log10(float(h)) for h in model.fits]
    values = [fit.get(output, math.nan) for fit in model.fits.values()]
    return Trace(name, ahead, [max(value, -100.0) if math.isfinite(value) else -100.0 for value in values])


def _orders(compared: Comparison) -> list[Item]:
    items: list[Item] = []
    for name, order in compared.orders.items():
        rows: list[list[Cell]] = [
            [float(n), value - min(order.criterion.values()) if math.isfinite(value) else None, n == order.chosen]
            for n, value in order.criterion.items()
        ]
        caption = f"Order of {name}: criterion of Schwarz above its least value, from a past of {order.past} rows"
        items.append(Table(["states", "criterion", "chosen"], rows, caption, digits=3))
        values = np.log10(np.maximum(order.singular, 1e-300))
        trace = Trace("singular value", np.arange(1, len(values) + 1), values)
        title = f"What the past foretells of {name}: {order.chosen} states are kept"
        items.append(Figure(title, [Panel("size, power of ten", "", [trace])], "direction", ""))
    return items


def _failures(compared: Comparison) -> list[Item]:
    return [f"{name}: {why}" for name, why in compared.failed.items()]


def _late(compared: Comparison) -> list[Item]:
    rows: list[list[Cell]] = [
        [output, float(count), count * part.dt * 1e3]
        for part in compared.samples.parts
        for output, count in zip(part.outputs, part.late, strict=True)
    ]
    caption = "Whole periods from a command to the answer, taken out before any fit"
    return [Table(["output", "periods", "ms"], rows, caption)]
