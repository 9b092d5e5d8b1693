"""The page of a `Calibration`: what was learnt, what could not be, and how it was checked."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from upright.calibrate.calibration import VERDICTS, Calibration, Estimate
from upright.report.figure import Figure, Panel, Trace
from upright.report.page import Cell, Page, Section, Table, Verdict

STRONG = 0.9
"""Correlations from this size up are listed: such pairs are told apart by the prior alone."""


def calibration_page(calibration: Calibration, path: str | Path) -> Path:
    """Write the calibration as one self-contained HTML page and return its path."""
    return page_of(calibration).write(path)


def page_of(calibration: Calibration) -> Page:
    """The calibration's page, not yet written."""
    wrong = calibration.check()
    verdict = Verdict("passes its checks", "good") if not wrong else Verdict(f"{len(wrong)} reservations", "warn")
    sections = [
        Section("What was learnt", [*calibration.notes, _estimates(calibration.parameters), _meanings()], verdict),
        Section("Dead times and motors", [_LATE, _estimates((*calibration.delays, *calibration.electronics))]),
        Section("What enters the motion", [_COMBINED, _estimates(calibration.combinations)]),
        Section(
            "What this log cannot tell", [*(calibration.unseen or ["Every direction is seen."]), _pairs(calibration)]
        ),
        Section("How far it foretells", [_FORETOLD, *_foretold(calibration)]),
        Section("What is left over", [_LEFT, _whiteness(calibration), *wrong]),
    ]
    kept = {
        "prior": calibration.prior.name,
        "samples": str(calibration.samples),
        "logs": ", ".join(calibration.sources),
    }
    return Page(f"{calibration.robot.name}, calibrated", sections, _lead(calibration), kept, twin_note=False)


_LATE = (
    "From a command to what each sensor says of it; then what commands go through. `asymmetry` is by how much the "
    "right motor is the stronger, of their mean, `battery` what reaches the motors of what the log says."
)
_COMBINED = (
    "The coefficients of the equations of motion and the pole with which the robot falls. A log often fixes these far "
    "better than the parameters they are made of."
)
_FORETOLD = (
    "Fit in per cent, 100 (1 − rms error / deviation), of a simulation that starts from the filter's state and is told "
    "the commands alone, on the part of the log that was kept back; and R² of half seconds of which only the start was "
    "fitted."
)
_LEFT = (
    "Innovations are what the filter did not foresee. They should neither foretell one another (Ljung and Box) nor "
    "follow from earlier commands; both statistics then stay below the threshold in 99 of 100 logs."
)


def _lead(c: Calibration) -> str:
    seen = [e.name.replace("_", " ") for e in c.parameters if e.verdict == "visible"]
    pole = c["unstable_pole"]
    return (
        f"{c.samples} samples fix {', '.join(seen) or 'no parameter'}. The robot falls at {pole.value:.3g} 1/s "
        f"({pole.low:.3g} to {pole.high:.3g})."
    )


def _estimates(estimates: Sequence[Estimate]) -> Table:
    rows: list[list[Cell]] = [
        [e.name, e.unit, e.value, f"{e.low:.4g} to {e.high:.4g}", e.prior, e.prior_spread, e.shift, e.verdict]
        for e in estimates
    ]
    header = ["", "unit", "value", "95 % interval", "prior", "its deviation", "moved by deviations", "verdict"]
    return Table(header, rows)


def _meanings() -> Table:
    return Table(["verdict", "means"], [[name, text] for name, text in VERDICTS.items()])


def _pairs(c: Calibration) -> Table:
    R = c.correlation
    rows: list[list[Cell]] = [
        [c.names[i], c.names[j], float(R[i, j])] for i in range(len(R)) for j in range(i) if abs(R[i, j]) >= STRONG
    ]
    return Table(["", "with", "correlation"], rows, f"Pairs correlated by {STRONG:g} or more", digits=3)


def _foretold(c: Calibration) -> list[Table | Figure]:
    free: list[list[Cell]] = [[name.removeprefix("sensor/"), value] for name, value in c.segments.items()]
    tables: list[Table | Figure] = [Table(["half a second, simulated freely", "R²"], free)]
    if not c.fits:
        return tables
    names = list(next(iter(c.fits.values())))
    rows: list[list[Cell]] = [[f"{h} samples", *fits.values()] for h, fits in c.fits.items()]
    tables.append(Table(["ahead", *(n.removeprefix("sensor/") for n in names)], rows, "Fit [%]", digits=3))
    ahead = np.array([float(h) for h in c.fits])
    traces = [Trace(n.removeprefix("sensor/"), ahead, [_shown(f[n]) for f in c.fits.values()]) for n in names]
    panel = Panel("Fit on the part kept back", "%", traces, (0.0, 100.0))
    tables.append(Figure("Fit falls with the time foretold", [panel], x_label="samples ahead", x_unit=""))
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
