"""The page of a `Calibration`: estimates, what the log does not determine, and the checks."""

from __future__ import annotations

import math
from collections.abc import Sequence

from upright.calibrate.calibration import VERDICTS, VISIBLE, Calibration, Estimate
from upright.plotting import legend, line, panels
from upright.report.figure import Figure
from upright.report.page import Cell, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence

ROUGH = 0.5  # of a value: a wider interval on either side is called rough
STRONG = 0.9
"""Correlations from this size up are listed: only the prior separates such pairs."""


def page_of(calibration: Calibration) -> Page:
    """The calibration's page, not yet written."""
    wrong = calibration.check()
    verdict = Verdict("predicts the log", "good") if not wrong else Verdict(f"{len(wrong)} reservations", "warn")
    others = (*calibration.delays, *calibration.electronics)
    sections = [
        *([Section("Reservations", [_sentence(text) for text in wrong])] if wrong else []),
        Section("Estimates", [*calibration.notes, *_by_name(calibration), _estimates(calibration.parameters)]),
        Section("Prediction", [_PREDICTED, *_predicted(calibration)]),
        *([Section("Delays and motors", [_DELAYS, _estimates(others)], folded=True)] if others else []),
        Section("Coefficients of the motion", [_COMBINED, _estimates(calibration.combinations)], folded=True),
        Section("What the log does not determine", _undetermined(calibration), folded=True),
        Section("Innovations", [_INNOVATIONS, _whiteness(calibration)], folded=True),
        Section("Meaning of the verdicts", [_meanings()], folded=True),
    ]
    kept = {
        "prior": calibration.prior.name,
        "samples": str(calibration.samples),
        "logs": ", ".join(calibration.sources),
    }
    return Page(
        _title(calibration), sections, _lead(calibration), kept, False, verdict=verdict,
        picture=_measured(calibration), numbers=_numbers(calibration),
    )  # fmt: skip


def _title(c: Calibration) -> str:
    if c.refused:
        return f"The log does not describe {c.robot.name}"
    visible = sum(e.verdict == VISIBLE for e in c.parameters)
    known = f"{visible} of {len(c.parameters)} parameters are known from it"
    does = "follows its log only in part" if c.check() else "predicts its log"
    return f"{c.robot.name} {does}; {known}"


def _sentence(text: str) -> str:
    return sentence(text.replace("sensor/", "").replace("_", " "))


def _numbers(c: Calibration) -> list[tuple[str, str]]:
    pole = c["unstable_pole"]
    worst = [(n, v) for n, v in c.segments.items() if n.startswith("sensor/")]
    name, value = min(worst, key=lambda pair: pair[1]) if worst else ("", math.nan)
    return [
        (
            f"{pole.value:.3g} 1/s",
            f"unstable pole ({pole.low:.3g} to {pole.high:.3g}): a lean doubles in {math.log(2) / pole.value:.2g} s",
        ),
        (
            cell_text(value, 3),
            f"R² of half seconds, smallest of all sensors ({name.removeprefix('sensor/').replace('_', ' ')})",
        ),
    ]


def _measured(c: Calibration) -> Figure | None:
    if not c.free:
        return None
    lowest = min((v for n, v in c.segments.items() if n.startswith("sensor/")), default=math.nan)
    title = f"Measured and predicted for half a second at a time: R² is {cell_text(lowest, 3)} or more"
    return Figure(title, c.plot_prediction(), "Each half second starts from a fitted state and gets only the commands.")


def _by_name(c: Calibration) -> list[Item]:
    if not any(0 < e.prior_spread < math.inf for e in c.parameters):
        return []
    return [Figure("Estimates with their 95 % intervals, relative to the prior", c.plot())]


def _undetermined(c: Calibration) -> list[Item]:
    pairs = _pairs(c)
    return [*(c.unseen or ["The log determines every direction."]), *([pairs] if pairs.rows else [])]


_DELAYS = (
    "The delay from a command to each sensor, then the motors. Asymmetry: right motor less left, over their mean. "
    "Battery: the fraction of the logged command that reaches the motors."
)
_COMBINED = (
    "The coefficients of the equations of motion, and the unstable pole. A log often determines these much better than "
    "the single parameters."
)
_PREDICTED = (
    "Fit, 100 (1 − rms error / standard deviation) [%], on the part of the log held out. Each simulation starts from "
    "the filter's state and gets only the commands. R² is that of free simulations of half a second, each from a "
    "fitted start."
)
_INNOVATIONS = (
    "Innovations are the filter's prediction errors. They should not correlate with each other (Ljung and Box) or with "
    "earlier commands. Both statistics then stay below the threshold in 99 of 100 logs."
)


def _lead(c: Calibration) -> str:
    visible = [e for e in c.parameters if e.verdict == VISIBLE]
    away = {e.name.replace("_", " "): (e.high - e.low) / abs(e.low + e.high) for e in visible if e.low * e.high > 0}
    ranked = sorted(away.items(), key=lambda x: x[1])
    known = [f"{name} to ±{cell_text(100 * part, 2)} %" for name, part in ranked if part <= ROUGH]
    rough = [name for name, part in ranked if part > ROUGH]
    zero = [e.name.replace("_", " ") for e in visible if e.low * e.high <= 0]
    parts = {"Known": known, "Known roughly": rough, "Zero or little": zero}
    sentences = [f"{how}: {', '.join(names)}." for how, names in parts.items() if names]
    return " ".join(sentences) or f"{c.samples} samples say less of every parameter than the robot's file."


def _estimates(estimates: Sequence[Estimate]) -> Table:
    rows: list[list[Cell]] = [
        [e.name.replace("_", " "), e.unit, e.value, _interval(e), e.prior,
         e.prior_spread, e.verdict]
        for e in estimates
    ]  # fmt: skip
    return Table(["", "unit", "value", "95 % interval", "prior", "±", "verdict"], rows, digits=3)


def _interval(e: Estimate) -> str:
    return f"{cell_text(e.low, 3)} … {cell_text(e.high, 3)}".replace(" ", "\u00a0")


def _meanings() -> Table:
    return Table(["verdict", "meaning"], [[name, text] for name, text in VERDICTS.items()])


def _pairs(c: Calibration) -> Table:
    R = c.correlation
    rows: list[list[Cell]] = [
        [c.names[i], c.names[j], float(R[i, j])] for i in range(len(R)) for j in range(i) if abs(R[i, j]) >= STRONG
    ]
    return Table(["", "with", "correlation"], rows, f"Pairs correlated by {STRONG:g} or more", digits=3)


def _predicted(c: Calibration) -> list[Item]:
    free: list[list[Cell]] = [[name.removeprefix("sensor/"), value] for name, value in c.segments.items()]
    tables: list[Item] = [Table(["free simulation of half a second", "R²"], free)]
    if not c.fits:
        return tables
    names = list(next(iter(c.fits.values())))
    rows: list[list[Cell]] = [
        [f"{h} samples", *("worse than the mean" if fit < 0 else fit for fit in fits.values())]
        for h, fits in c.fits.items()
    ]
    tables.append(Table(["ahead", *(n.removeprefix("sensor/") for n in names)], rows, "Fit [%]", digits=3))
    figure, (ax,) = panels(["fit on the part held out [%]"], "samples ahead", "log")
    for name in names:
        line(ax, name.removeprefix("sensor/"), [float(h) for h in c.fits], [fits[name] for fits in c.fits.values()])
    ax.set_ylim(0, 100)
    tables.append(Figure("Fit over the prediction horizon", legend(figure)))
    return tables


def _whiteness(c: Calibration) -> Table:
    rows: list[list[Cell]] = [
        [w.sensor.removeprefix("sensor/"), w.rms, w.worst, w.ljung_box, w.input_test, w.threshold, w.white]
        for w in c.whiteness
    ]
    header = ["sensor", "rms / expected", "correlation", "Ljung–Box", "commands", "threshold", "white"]
    return Table(header, rows)
