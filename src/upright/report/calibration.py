"""The page of a `Calibration`: estimates, what the log does not determine, and the checks."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.calibrate.calibration import VERDICTS, Calibration, Estimate
from upright.report.figure import Figure, Panel, Trace
from upright.report.page import Cell, Page, Section, Table, Verdict

STRONG = 0.9
"""Correlations from this size up are listed: only the prior separates such pairs."""


def page_of(calibration: Calibration) -> Page:
    """The calibration's page, not yet written."""
    wrong = calibration.check()
    verdict = Verdict("passes its checks", "good") if not wrong else Verdict(f"{len(wrong)} reservations", "warn")
    sections = [
        Section("Estimates", [*calibration.notes, _estimates(calibration.parameters), _meanings()], verdict),
        Section("Delays and motors", [_DELAYS, _estimates((*calibration.delays, *calibration.electronics))]),
        Section("Coefficients of the motion", [_COMBINED, _estimates(calibration.combinations)]),
        Section(
            "What the log does not determine",
            [*(calibration.unseen or ["The log determines every direction."]), _pairs(calibration)],
        ),
        Section("Prediction", [_PREDICTED, *_predicted(calibration)]),
        Section("Innovations", [_INNOVATIONS, _whiteness(calibration), *wrong]),
    ]
    kept = {
        "prior": calibration.prior.name,
        "samples": str(calibration.samples),
        "logs": ", ".join(calibration.sources),
    }
    return Page(f"{calibration.robot.name}, calibrated", sections, _lead(calibration), kept, twin_note=False)


_DELAYS = (
    "The delay from a command to each sensor, then the motors. `asymmetry` is right motor less left over their mean; "
    "`battery` is the fraction of the logged command that reaches the motors."
)
_COMBINED = (
    "The coefficients of the equations of motion, and the unstable pole. A log often determines these much better than "
    "the single parameters."
)
_PREDICTED = (
    "Fit, 100 (1 − rms error / standard deviation) [%], on the part of the log held out. Each simulation starts from "
    "the filter's state and gets only the commands. R² is that of half seconds, simulated freely from a fitted start."
)
_INNOVATIONS = (
    "Innovations are the filter's prediction errors. They should not correlate with each other (Ljung and Box) or with "
    "earlier commands. Both statistics then stay below the threshold in 99 of 100 logs."
)


def _lead(c: Calibration) -> str:
    visible = [e.name.replace("_", " ") for e in c.parameters if e.verdict == "visible"]
    pole = c["unstable_pole"]
    return (
        f"{c.samples} samples determine {', '.join(visible) or 'no parameter'}. Unstable pole: {pole.value:.3g} 1/s "
        f"({pole.low:.3g} to {pole.high:.3g})."
    )


def _estimates(estimates: Sequence[Estimate]) -> Table:
    rows: list[list[Cell]] = [
        [e.name, e.unit, e.value, f"{e.low:.4g} to {e.high:.4g}", e.prior, e.prior_spread, e.shift, e.verdict]
        for e in estimates
    ]
    header = ["", "unit", "value", "95 % interval", "prior", "prior spread", "shift [spreads]", "verdict"]
    return Table(header, rows)


def _meanings() -> Table:
    return Table(["verdict", "meaning"], [[name, text] for name, text in VERDICTS.items()])


def _pairs(c: Calibration) -> Table:
    R = c.correlation
    rows: list[list[Cell]] = [
        [c.names[i], c.names[j], float(R[i, j])] for i in range(len(R)) for j in range(i) if abs(R[i, j]) >= STRONG
    ]
    return Table(["", "with", "correlation"], rows, f"Pairs correlated by {STRONG:g} or more", digits=3)


def _predicted(c: Calibration) -> list[Table | Figure]:
    free: list[list[Cell]] = [[name.removeprefix("sensor/"), value] for name, value in c.segments.items()]
    tables: list[Table | Figure] = [Table(["free simulation of half a second", "R²"], free)]
    if not c.fits:
        return tables
    names = list(next(iter(c.fits.values())))
    rows: list[list[Cell]] = [[f"{h} samples", *fits.values()] for h, fits in c.fits.items()]
    tables.append(Table(["ahead", *(n.removeprefix("sensor/") for n in names)], rows, "Fit [%]", digits=3))
    ahead = np.array([float(h) for h in c.fits])
    traces = [Trace(n.removeprefix("sensor/"), ahead, [_shown(f[n]) for f in c.fits.values()]) for n in names]
    panel = Panel("Fit on the part held out", "%", traces, (0.0, 100.0))
    tables.append(Figure("Fit over the prediction horizon", [panel], x_label="samples ahead", x_unit=""))
    return tables


def _shown(value: float) -> float:
    return value if math.isfinite(value) else 0.0


def _whiteness(c: Calibration) -> Table:
    rows: list[list[Cell]] = [
        [w.sensor.removeprefix("sensor/"), w.rms, w.worst, w.ljung_box, w.input_test, w.threshold, w.white]
        for w in c.whiteness
    ]
    header = ["sensor", "rms over expected", "largest correlation", "Ljung–Box", "commands", "threshold", "white"]
    return Table(header, rows)
