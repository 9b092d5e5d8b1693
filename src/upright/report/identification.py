"""The page of a comparison of identified models: trials in the loop, poles with intervals, predictions, orders."""

from __future__ import annotations

import math

import numpy as np

from upright.identify.identified import Identified
from upright.identify.identify import MethodComparison
from upright.identify.methods import TITLES
from upright.report.figure import Figure, Panel, PointFigure, PointSet, Trace
from upright.report.page import Cell, Item, Page, Section, Table, Verdict, cell_text


def page_of(compared: MethodComparison) -> Page:
    """The comparison's page, not yet written."""
    holding = [name for name, trial in compared.trials.items() if trial.holds]
    verdict = Verdict(f"{len(holding)} of {len(compared.trials)} hold it", "good" if holding else "warn")
    data = compared.samples
    sections = [
        Section("In the loop", [_lead_of_loop(compared), trial_table(compared)], verdict),
        Section("The unstable pole", [_POLES, pole_table(compared), _eigenvalues(compared)]),
        Section("Predictions", [_PREDICTIONS, *_predictions(compared)]),
        Section("Model order", _orders(compared)),
        Section("Notes", [*compared.notes, *_failures(compared), *_delays(compared)]),
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
    "The rate at which the robot falls, with its 95 % interval. The bias is the method's mean estimate from repeated "
    "logs, less their true pole. These logs are simulated with the subspace model, the log's feedback law and new "
    "innovations. An interval covers the scatter, not the bias."
)
_PREDICTIONS = (
    "Fit in per cent, 100 (1 − rms error / rms of the motion), on the held-out part of the log, with the same filter "
    "for all models. For angles the motion is their change over the prediction horizon."
)


def _lead(compared: MethodComparison) -> str:
    holding = [name for name, trial in compared.trials.items() if trial.holds]
    result = (
        f"A regulator designed on the model of {', '.join(holding)} holds the robot"
        if holding
        else "No model's regulator holds the robot"
    )
    true = "" if math.isnan(compared.true_pole) else f", which falls at {compared.true_pole:.3g} 1/s"
    return f"{result}{true}. All methods used the same samples."


def _lead_of_loop(compared: MethodComparison) -> str:
    return (
        "Weights, filter noise and kit are the same for all; only the model differs. Tested on "
        f"{compared.judge.who}: held at 0.05 rad for a second, then released for seven seconds."
    )


def trial_table(compared: MethodComparison) -> Table:
    """The trial of each regulator."""
    rows: list[list[Cell]] = [
        [name, TITLES.get(name, ""), str(t).replace(" ", "\u00a0") if not t.why else t.why, t.largest, t.restless]
        for name, t in compared.trials.items()
    ]
    return Table(
        ["method", "description", "in the loop", "peak [rad]", "rms at rest [rad]"],
        rows,
        "Largest pitch after the release, and its rms in the last two seconds",
        digits=3,
    )


def pole_table(compared: MethodComparison) -> Table:
    """Unstable poles by method, with interval and bias."""
    rows: list[list[Cell]] = [_pole_row(name, m) for name, m in compared.models.items()]
    if not math.isnan(compared.true_pole):
        rows.append(["the robot itself", compared.true_pole, "", None, None, None])
    header = ["method", "pole [1/s]", "95 % interval", "bias [1/s]", "± of the bias", "pole less bias"]
    how = dict.fromkeys(m.pole.how for m in compared.models.values() if math.isfinite(m.pole.low))
    return Table(header, rows, "Unstable pole; intervals from the " + ", or the ".join(how), digits=3)


def _pole_row(name: str, model: Identified) -> list[Cell]:
    p = model.pole
    known = f"{cell_text(p.low, 3)} to {cell_text(p.high, 3)}" if math.isfinite(p.low) else "none"
    return [name, p.value, known, p.bias, 2 * p.bias_error, p.corrected]


def _eigenvalues(compared: MethodComparison) -> PointFigure:
    sets = [
        PointSet(name, [complex(v) for v in np.linalg.eigvals(m.halves["pitch"].A) if abs(v) < 2])
        for name, m in compared.models.items()
    ]
    spread = [m.pole.value for m in compared.models.values()]
    between = f"{cell_text(min(spread), 2)} to {cell_text(max(spread), 2)}" if spread else "none"
    title = f"Eigenvalues of pitch and wheels over one period; unstable poles from {between} 1/s"
    return PointFigure(title, sets)


def _predictions(compared: MethodComparison) -> list[Item]:
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
    title = "Predictions of the held-out part"
    figure = Figure(title, panels, "samples ahead, power of ten", "")
    return [Table(header, rows, "Fit [%]; – where the prediction diverges", digits=3), figure]


def _trace(name: str, model: Identified, output: str) -> Trace:
    ahead = [math.log10(float(h)) for h in model.fits]
    values = [fit.get(output, math.nan) for fit in model.fits.values()]
    return Trace(name, ahead, [max(value, -100.0) if math.isfinite(value) else -100.0 for value in values])


def _orders(compared: MethodComparison) -> list[Item]:
    items: list[Item] = []
    for name, order in compared.orders.items():
        rows: list[list[Cell]] = [
            [float(n), value - min(order.bic.values()) if math.isfinite(value) else None, n == order.chosen]
            for n, value in order.bic.items()
        ]
        caption = f"Order of {name}: BIC above its least value, from {order.past} past rows"
        items.append(Table(["states", "BIC", "chosen"], rows, caption, digits=3))
        values = np.log10(np.maximum(order.singular, 1e-300))
        trace = Trace("singular value", np.arange(1, len(values) + 1), values)
        title = f"Singular values of the prediction of {name}: {order.chosen} states are kept"
        items.append(Figure(title, [Panel("size, power of ten", "", [trace])], "direction", ""))
    return items


def _failures(compared: MethodComparison) -> list[Item]:
    return [f"{name}: {why}" for name, why in compared.failed.items()]


def _delays(compared: MethodComparison) -> list[Item]:
    rows: list[list[Cell]] = [
        [output, float(count), count * part.dt * 1e3]
        for part in compared.samples.parts
        for output, count in zip(part.outputs, part.delays, strict=True)
    ]
    caption = "Delays from a command to the response in whole periods, taken out before any fit"
    return [Table(["output", "periods", "ms"], rows, caption)]
