"""Two runs beside each other: a figure with their difference, and the command that certifies their controller."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.comparison import Comparison
from upright.comparison.metrics import nrmse_fit
from upright.experiment.outcome import last_part
from upright.plotting import AXIS, BELOW, legend, line, panels, span
from upright.reports.metrics import percent, words
from upright.reports.page import cell_text
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


CLOSE, FAIR = 80.0, 50.0  # [%] of fit: from where two runs agree well, and at all
AVERAGED = 0.3  # [s] over which quick swings (noise, rounded readings) average out, the answer to a push does not


SHORT = 24  # letters of two names that stand at an axis


def with_difference(comparison: Comparison, t: Array, one: Array, other: Array) -> Figure:
    """Pitch of two runs [rad], and below it by how much the second exceeds the reference, at the times `t` [s]."""
    less = " − ".join(reversed([*comparison.logs]))
    less = less if len(less) <= SHORT else "difference"
    figure, axes = panels(["pitch [rad]", f"{less} [rad]"])
    for style, (label, log) in enumerate(comparison.logs.items()):
        line(axes[0], label, log.t, log[f"{comparison.sources[label]}/pitch"], style=style, solid=True)
    axes[0].lines[0].set(**BELOW)
    line(axes[1], less, t, other - one, style=4, solid=True)
    for start, stop in comparison.pushed:
        span(axes, start, min(stop, float(t[-1])), "push acts")
    return legend(figure)


def mark_largest(ax: Axes) -> None:
    """A dot where the curve of an axis in degrees is furthest from zero, with its size."""
    x, y = (np.asarray(values, dtype=np.float64) for values in ax.lines[0].get_data())
    if not np.isfinite(y).any():
        return
    at = int(np.nanargmax(np.abs(y)))
    ax.plot([x[at]], [y[at]], "o", markersize=6, color=AXIS, label="_largest difference")
    text = f"{cell_text(float(y[at]), 2)}°"
    beside, side = (-6, "right") if x[at] > x[0] + 0.8 * (x[-1] - x[0]) else (6, "left")
    ax.annotate(text, (x[at], y[at]), (beside, 0), textcoords="offset points", va="center", ha=side)
    ax.margins(y=0.15)


def worse(comparison: Comparison) -> str:
    """What fits badly although pitch fits, and whether quick swings alone explain it: then averages over a while
    fit."""
    worst = worst_state(comparison)
    if not worst:
        return ""
    name, label, averaged = worst
    plain = percent(comparison.fits[label][name])
    if averaged < FAIR:
        return f" {sentence(words(name), '')} fits {plain} only."
    agrees = "agrees too" if averaged >= CLOSE else "agrees less"
    return (
        f" {sentence(words(name), '')} {agrees}: {averaged:.0f} % averaged over {AVERAGED:g} s; sample by sample "
        f"{plain}, since noise differs in each run."
    )


def worst_state(comparison: Comparison) -> tuple[str, str, float] | None:
    """Of two runs whose pitch fits the state that fits badly, the run, and the fit [%] of the means over `AVERAGED`."""
    if len(comparison.fits) != 1 or "pitch" not in comparison.signals:
        return None
    ((label, fits),) = comparison.fits.items()
    name = min(fits, key=lambda name: fits[name] if math.isfinite(fits[name]) else math.inf)
    if not fits[name] < FAIR <= fits["pitch"]:
        return None
    t, one, other = both_runs(comparison, name, label)
    return name, label, nrmse_fit(averaged_over(t, one)[1], averaged_over(t, other)[1])


def averaged_over(t: Array, y: Array) -> tuple[Array, Array]:
    """Means over `AVERAGED` and the times of their middles."""
    window = np.full(max(1, round(AVERAGED / float(np.median(np.diff(t))))), 1.0)
    window /= len(window)
    return np.convolve(t, window, "valid"), np.convolve(y, window, "valid")


def grazes(comparison: Comparison, within: float) -> bool:
    """Whether two runs settle at different times since the later one passes `within` [rad] by no more than it swings at
    rest, in the last quarter of the run."""
    rest = {label: comparison.at_rest(label)[0] for label in comparison.logs}
    slower = max(rest, key=lambda label: rest[label])
    run = comparison.released(slower)
    since = run.t - run.t[0]
    between = run.size[(since > min(rest.values())) & (since <= rest[slower])]
    noise = float(run.size[last_part(len(run.size)) :].max())
    return bool(len(between)) and 0 < float(between.max()) - within < noise


def both_runs(comparison: Comparison, name: str, label: str) -> tuple[Array, Array, Array]:
    """Times [s], the reference's state and that of a run at these times, while both last."""
    reference = comparison.logs[comparison.reference]
    log = comparison.logs[label]
    both = (reference.t >= log.t[0]) & (reference.t <= log.t[-1])
    t = reference.t[both]
    one = reference[f"{comparison.sources[comparison.reference]}/{name}"][both]
    return t, one, np.interp(t, log.t, log[f"{comparison.sources[label]}/{name}"])


def sways_only(comparison: Comparison) -> bool:
    """Whether no run differs from the reference in pitch by more than both sway at rest, while a push is answered."""
    answers = [comparison.answer(label) for label, fit in comparison.fits.items() if math.isfinite(fit["pitch"])]
    return bool(answers) and all(answer is not None and answer.sway_only for answer in answers)


def answered_only(comparison: Comparison) -> bool:
    """Whether a page shows the fits while a push is answered: those of whole runs are low as each sways by itself."""
    fits = [fit.get("pitch", math.nan) for fit in comparison.fits.values()]
    return any(fit < FAIR for fit in fits) and sways_only(comparison)


def answered_fits(comparison: Comparison, *names: str) -> dict[str, dict[str, float]]:
    """The fits [%] of these signals, or of all, while a push is answered, where a page shows these; none where it does
    not."""
    if not answered_only(comparison):
        return {}
    asked = names or comparison.signals
    answers = {label: {n: comparison.answer(label, n) for n in asked} for label in comparison.fits}
    return {label: {n: a.fit if a else math.nan for n, a in each.items()} for label, each in answers.items()}


def fit_number(comparison: Comparison, label: str, fit: float) -> tuple[str, str]:
    """How well a run's pitch fits: while a push is answered, where the runs differ by their sway only."""
    of = f"fit of {label} to {comparison.reference} in pitch"
    if answered_only(comparison) and (answer := comparison.answer(label)):
        return percent(answer.fit), f"{of}, from the push until both are calm; later each sways by itself"
    return percent(fit), f"{of}; good from {CLOSE:g} %"


def certify_command(robot: str, kind: str) -> str:
    """The command that certifies a controller of a robot, as far as both are known."""
    from upright.control.methods import OURS

    law = kind if kind in {method.name for method in OURS} else "CONTROLLER"
    return f"`upright certify {law}{f' --robot {robot}' if robot else ''}`"
