"""The page of an `ExcitationPlan`: the excitation, the predicted intervals, and the limits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.excite.plan import VISIBLE, ExcitationPlan, Predicted
from upright.report.figure import Figure, Panel, Trace
from upright.report.page import Cell, Page, Section, Table, Verdict

Array = NDArray[np.float64]


def page_of(plan: ExcitationPlan) -> Page:
    """The plan's page, not yet written."""
    wrong = plan.check()
    verdict = Verdict("keeps its limits", "good") if not wrong else Verdict(f"{len(wrong)} reservations", "warn")
    sections = [
        Section("Excitation", [_WHAT, _over_time(plan), _spectrum(plan), _energies(plan)]),
        Section("Predicted intervals", [_PREDICTED, _widths(plan), _table(plan)]),
        Section("Limits", [_checked_words(plan), _limits(plan), *wrong, *plan.notes], verdict),
        Section("Alternatives", [_TRIED, _tried(plan)]),
    ]
    facts = {"controller": plan.hash[:12], "seed": str(plan.seed), "kit": plan.kit}
    return Page(f"The next run of {plan.robot}", sections, _lead(plan), facts, twin_note=False)


_WHAT = (
    "Added to the commands of the controller, which keeps the robot upright. The mean of both motors drives; half of "
    "their difference turns."
)
_PREDICTED = (
    "Predicted from the Fisher information of the calibration's predictor, along a run of the nonlinear model with the "
    "kit. Both dithers are random binary signals of the same energy: one changes every period, one is held for 40 ms. "
    "The intervals after a hundred runs come from the spreads of other parameters: measure those."
)
_TRIED = (
    "Each excitation is as large as the limits allow. Intervals shrink to this fraction: the geometric mean over the "
    "parameters in focus."
)


def _lead(plan: ExcitationPlan) -> str:
    halved = [p.name.replace("_", " ") for p in plan.predicted if p.after < VISIBLE * p.before and "/" not in p.name]
    return (
        f"{plan.seconds:g} s of {plan.way} under {plan.controller} halve at least the intervals of "
        f"{', '.join(halved) or 'no parameter'}. The probability of a fall is below {100 * plan.checked.bound:.2g} %."
    )


def _over_time(plan: ExcitationPlan) -> Figure:
    t = np.arange(len(plan.excitation)) * plan.hold * plan.period
    drive, turn = plan.excitation.mean(axis=1), (plan.excitation[:, 1] - plan.excitation[:, 0]) / 2
    panels = [
        Panel("both motors", plan.unit, [Trace("driving", t, drive, step=True)]),
        Panel("right less left, halved", plan.unit, [Trace("turning", t, turn, step=True)]),
    ]
    return Figure("The excitation over time", panels)


def _spectrum(plan: ExcitationPlan) -> Figure:
    step = plan.hold * plan.period
    frequency: Array = np.fft.rfftfreq(len(plan.excitation), step)[1:].astype(np.float64)
    drive, turn = plan.excitation.mean(axis=1), (plan.excitation[:, 1] - plan.excitation[:, 0]) / 2
    traces = [Trace(n, np.log10(frequency), _level(x, frequency)) for n, x in (("driving", drive), ("turning", turn))]
    note = "Amplitude of each sine of the run, in decibels over 1 unit of command."
    return Figure(
        "Its spectrum",
        [Panel("amplitude", f"dB over 1 {plan.unit}", traces)],
        "log₁₀ of frequency in Hz",
        "",
        note=note,
    )


QUIETEST = 60.0  # [dB] below the loudest sine: less is not drawn


def _level(wave: Array, frequency: Array) -> Array:
    """Amplitudes in decibels."""
    amplitude = 2 * np.abs(np.fft.rfft(wave))[1 : len(frequency) + 1] / len(wave)
    level = 20 * np.log10(np.maximum(amplitude, 1e-12))
    return np.maximum(level, level.max() - QUIETEST)


def _energies(plan: ExcitationPlan) -> Table:
    rows: list[list[Cell]] = [[name, 100 * fraction] for name, fraction in plan.division.items()]
    return Table(["part", "fraction of the energy [%]"], rows, _energy(plan), 3)


def _energy_unit(plan: ExcitationPlan) -> str:
    return f"({plan.unit})² s" if " " in plan.unit else f"{plan.unit}² s"


def _energy(plan: ExcitationPlan) -> str:
    unit = _energy_unit(plan)
    return f"Energy: {plan.energy:.3g} {unit} at the motors in closed loop, {plan.added:.3g} of the excitation"


DRAWN = 0.95  # of the width before: parameters whose intervals shrink less are not drawn


def _widths(plan: ExcitationPlan) -> Figure:
    """Widths over those before, a step for each parameter, the least certain first."""
    shown = sorted((p for p in plan.predicted if p.after < DRAWN * p.before), key=lambda p: -p.after / p.before)
    place = np.arange(0.5, len(shown) + 1)
    kinds = {"plan": "after", "dither": "dither", "dither held 40 ms": "held"}
    traces = [
        Trace(name, place, [np.log10(getattr(p, kind) / p.before) for p in (*shown, *shown[-1:])], step=True)
        for name, kind in kinds.items()
    ]
    names = ", ".join(f"{i} {p.name}" for i, p in enumerate(shown, 1))
    panel = Panel("log₁₀ of width after over before", "", traces)
    return Figure("Intervals after over before, by parameter", [panel], "parameter, by number", "", note=names)


def _table(plan: ExcitationPlan) -> Table:
    header = ["parameter", "before", "after", "dither", "held 40 ms", "100 runs", "after / dither"]
    return Table(header, [_row(p) for p in plan.predicted], "Half widths of 95 % intervals", 3)


def _row(p: Predicted) -> list[Cell]:
    widths = (p.before, p.after, p.dither, p.held, p.least)
    return [f"{p.name} [{p.unit}]", *(width / 2 for width in widths), p.after / p.dither]


def _checked_words(plan: ExcitationPlan) -> str:
    c = plan.checked
    return (
        f"{c.samples} robots drawn from the uncertainty of {plan.robot}, in the nonlinear model with kit {plan.kit} "
        f"and {plan.margin:g} times this excitation: {c.fell} fell. With 95 % confidence the probability of a fall is "
        f"below {100 * c.bound:.2g} %. The other values are 95 % quantiles of the robots."
    )


def _limits(plan: ExcitationPlan) -> Table:
    c, limits = plan.checked, plan.limits
    rows: list[list[Cell]] = [
        ["probability of a fall [%]", 100 * c.bound, 100 * limits.falls],
        ["periods with a saturated motor [%]", 100 * c.saturated, 100 * limits.saturated],
        ["travel [m]", c.travel, limits.travel],
        ["largest pitch [rad]", c.peak, None],
    ]
    return Table(["", "measured", "limit"], rows, "Limits", 3)


def _tried(plan: ExcitationPlan) -> Table:
    rows: list[list[Cell]] = [[t.name, t.energy, t.shrinks] for t in plan.tried]
    return Table(
        ["excitation", f"energy [{_energy_unit(plan)}]", "intervals shrink to"], rows, "Excitations, the best first", 3
    )
