"""The page of a `Comparison`: its tables and one figure for each signal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.comparison import Comparison
from upright.comparison.comparison import DIVERGED, METRICS, NEGLIGIBLE
from upright.plotting import AXIS
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as MplFigure

BESIDE = 1.0  # [s] shown before a push and after it has settled
STEADY, WIDE = 1.6, 0.5
"""A wobble that grows no more than this between the last quarter and the last half is steady; beyond this part of the
peak it is no rest."""
CLOSE, FAIR = 80.0, 50.0  # [%] of fit: from where two runs agree well, and at all
SMALL = 0.6  # [1] of a run: less is shown alone
DWARFED = 5.0
"""A trace that leaves the reference's range by more than this many times its width is cut at the frame."""


def page_of(comparison: Comparison) -> Page:
    """The comparison's page, not yet written."""
    first = "pitch" if "pitch" in comparison.signals else comparison.signals[0]
    still = [name for name in comparison.signals if _is_still(comparison, name)]
    figures = [state_figure(comparison, name) for name in comparison.signals if name not in (first, *still)]
    quiet = [sentence(f"no motion of {' or '.join(name.replace('_', ' ') for name in still)}")] if still else []
    sections = [
        Section("Numbers", [metrics_table(comparison), *fit_tables(comparison), _how(comparison)]),
        Section("Other states", [*figures, *quiet]),
    ]
    commands = comparison.plot_commands()
    sections += [Section("Commands", [Figure(_efforts(comparison), commands)])] if commands else []
    sections.append(Section("Origin of the runs", [_origin_table(comparison)], folded=True))
    return Page(
        _title(comparison, first), sections, _lead(comparison), _provenance(comparison),
        verdict=_verdict(comparison), picture=state_figure(comparison, first), numbers=_numbers(comparison),
    )  # fmt: skip


def _title(comparison: Comparison, first: str) -> str:
    """Who fell, or how well the runs agree; of one run what it did."""
    labels = list(comparison.logs)
    fell = [label for label, m in comparison.metrics.items() if m.fell]
    if len(labels) == 1:
        (m,) = comparison.metrics.values()
        robot = comparison.logs[labels[0]].origin.get("robot", {}).get("name", "") or "The robot"
        return f"{robot} {'fell' if m.fell else 'stands'}; pitch reaches {_degrees(m.pitch_peak)}"
    if fell and len(fell) < len(labels):
        return f"{', '.join(fell)} fell; {', '.join(label for label in labels if label not in fell)} did not"
    fits = _fits(comparison, first)
    if not fits:
        return f"{', '.join(labels)} compared"
    worst = min(fits, key=lambda label: fits[label])
    follows = "follows" if fits[worst] >= FAIR else "does not follow"
    if len(fits) == 1:
        return f"{sentence(worst, '')} {follows} {comparison.reference}: fit {_percent(fits[worst])}"
    return f"{len(fits)} runs beside {comparison.reference}; the worst, {worst}, fits {_percent(fits[worst])}"


def _fits(comparison: Comparison, first: str) -> dict[str, float]:
    return {label: f[first] for label, f in comparison.fits.items() if math.isfinite(f.get(first, math.nan))}


def _lead(comparison: Comparison) -> str:
    """What was run: robot, controller, push; and what to run next."""
    log = comparison.logs[comparison.reference]
    robot, kind = log.origin.get("robot", {}).get("name", ""), log.origin.get("controller", {}).get("kind", "")
    who = f"{robot} under {kind}" if robot and kind else robot or "One experiment"
    pushes = [f"from {start:.3g} to {stop:.3g} s" for start, stop in comparison.pushed]
    force = np.abs(log["push/force"]).max() if "push/force" in log else 0.0
    size = f" with {cell_text(float(force), 2)} N" if force else ""
    pushed = f", pushed{size} {' and '.join(pushes[:2])}" if pushes else ", without a push"
    several = f"; runs: {', '.join(comparison.logs)}" if comparison.fits else ""
    twin = any(kind.startswith("twin") for kind in comparison.kinds.values())
    stands = " A twin, a physics engine, stands in for the real robot." if twin else ""
    after = (
        "`upright compare` it with another body" if len(comparison.logs) == 1 else "`upright certify` the controller"
    )
    return f"{who}{pushed}{several}.{stands} Next: {after}."


def _verdict(comparison: Comparison) -> Verdict | None:
    """Of one run whether the robot stood; of several how well they agree, or that only some fell."""
    fell = [m.fell for m in comparison.metrics.values()]
    if any(fell):
        return Verdict("fell" if len(fell) == 1 else f"{fell.count(True)} of {len(fell)} fell", "bad")
    first = "pitch" if "pitch" in comparison.signals else comparison.signals[0]
    fits = _fits(comparison, first)
    if fits:
        worst = min(fits.values())
        text = f"good fit: {CLOSE:g} % or more" if worst >= CLOSE else f"fair fit: less than {CLOSE:g} %"
        if worst < FAIR:
            return Verdict(f"poor fit: less than {FAIR:g} %", "bad")
        return Verdict(text, "good" if worst >= CLOSE else "warn")
    return None if any(f is None for f in fell) else Verdict("stood", "good")


def _is_still(comparison: Comparison, name: str) -> bool:
    """Whether no run moves in this state by more than what counts as noise."""
    states = [log[f"{comparison.sources[label]}/{name}"] for label, log in comparison.logs.items()]
    return name in NEGLIGIBLE and all(np.nanmax(y) - np.nanmin(y) <= NEGLIGIBLE[name] for y in states)


def _numbers(comparison: Comparison) -> list[tuple[str, str]]:
    """Of one run pitch, calm and travel; of several the fit, the largest difference and pitch; a fall says so."""
    if len(comparison.logs) == 1:
        ((label, m),) = comparison.metrics.items()
        calm, limit = _calm(comparison, label)
        return [
            (_degrees(m.pitch_peak), f"largest pitch ({abs(m.pitch_peak):.2g} rad)"),
            (_settles(calm), f"after the release, until pitch stays within ±{_degrees(limit)}, as at rest"),
            (_degrees(m.wheel_travel), f"largest turn of the wheels ({m.wheel_travel:.3g} rad)"),
        ]
    fits = [
        (_percent(fit["pitch"]), f"fit of {label} to {comparison.reference}: pitch; good from {CLOSE:g} %")
        for label, fit in list(comparison.fits.items())[:1]
        if math.isfinite(fit.get("pitch", math.nan))
    ]
    apart = _apart(comparison, "pitch") if "pitch" in comparison.signals else {}
    fits += [(_degrees(size), f"largest difference of pitch: {label}") for label, size in list(apart.items())[:1]]
    return fits + [
        (_degrees(m.pitch_peak), f"{label}: largest pitch") if not m.fell else ("fell", label)
        for label, m in list(comparison.metrics.items())[: 4 - len(fits)]
    ]  # fmt: skip


def _degrees(angle: float) -> str:
    size = math.degrees(abs(angle))
    return f"{size:.0f}°" if size >= 10 else f"{cell_text(size, 2)}°"


def _apart(comparison: Comparison, name: str) -> dict[str, float]:
    """The largest difference [unit of the state] of each run from the reference, while both last."""
    reference = comparison.logs[comparison.reference]
    one = reference[f"{comparison.sources[comparison.reference]}/{name}"]
    apart: dict[str, float] = {}
    for label, log in comparison.logs.items():
        if label != comparison.reference:
            both = (reference.t >= log.t[0]) & (reference.t <= log.t[-1])
            other = np.interp(reference.t[both], log.t, log[f"{comparison.sources[label]}/{name}"])
            apart[label] = float(np.nanmax(np.abs(one[both] - other), initial=0.0))
    return apart


def _calm(comparison: Comparison, label: str) -> tuple[float, float]:
    """From how long after the release on pitch stays near zero [s], and what near means [rad].

    That is 5 % of its largest value, or its wobble at rest where that is more: then the noise of the sensors decides.
    """
    m = comparison.metrics[label]
    log, release = comparison.logs[label], comparison.releases[label]
    if not release <= log.t[-1]:  # it is pushed to its end
        return math.nan, 0.05 * abs(m.pitch_peak)
    released = log.between(release, math.inf)
    pitch = np.abs(released[f"{comparison.sources[label]}/pitch"])
    if m.fell or len(pitch) < 8:
        return math.nan, 0.05 * abs(m.pitch_peak)
    half, quarter = (float(pitch[-len(pitch) // part :].max()) for part in (2, 4))
    limit = max(0.05 * float(pitch.max()), half if half <= STEADY * quarter else quarter)
    if limit > WIDE * float(pitch.max()):
        return math.nan, limit
    beyond = np.flatnonzero(pitch > limit)
    return (float(released.t[beyond[-1]] - released.t[0]) if len(beyond) else 0.0), limit


def _settles(seconds: float) -> str:
    return "never" if math.isnan(seconds) else f"{seconds:.2g} s"


def _how(comparison: Comparison) -> str:
    times = {label: f"{time:.4g} s" if math.isfinite(time) else "never" for label, time in comparison.releases.items()}
    same = len(set(times.values())) == 1
    release = next(iter(times.values())) if same else ", ".join(f"{label} {text}" for label, text in times.items())
    return (
        f"Settling and overshoot are those of pitch about zero after the release of the push at {release}. "
        "Settling: the time until pitch stays within 2 % (5 %) of its largest deviation. Overshoot: the largest "
        "deviation on the far side over the largest on the side of the start. Effort: the integral of both squared "
        "commands. Saturated: the fraction of samples with a command above the largest applied one. Fell: the recorded "
        "outcome of the run."
    )


def metrics_table(comparison: Comparison) -> Table:
    """The metrics, one column a run."""
    rows: list[list[Cell]] = [
        [text, comparison.unit(name), *(getattr(numbers, name) for numbers in comparison.metrics.values())]
        for name, (_, text) in METRICS.items()
    ]
    if comparison.pushed:
        calm: list[Cell] = [_calm(comparison, label)[0] for label in comparison.logs]
        rows.insert(0, ["calm after the release, as at rest", "s", *calm])
    return Table(["", "unit", *comparison.logs], rows, "Metrics of each run")


def fit_tables(comparison: Comparison) -> list[Table]:
    """The fit of each run to the reference, one row a run; none where there is one run."""
    if not comparison.fits:
        return []
    rows: list[list[Cell]] = [
        [label, *("diverges" if fit < DIVERGED else fit for fit in fits.values())]
        for label, fits in comparison.fits.items()
    ]
    caption = f"NRMSE fit to {comparison.reference} [%]: 100 is perfect; 0 is that of a constant, its mean"
    return [Table(["", *(name.replace("_", " ") for name in comparison.signals)], rows, caption, digits=3)]


def state_figure(comparison: Comparison, name: str) -> Figure:
    """One state of all runs over time, under a title that says how they differ."""
    figure = comparison.plot(name)
    _in_degrees(figure)
    if name == "pitch" and comparison.pushed and len(comparison.logs) == 1:
        _band(comparison, figure.axes[0])
    limits, note = _limits(comparison, name)
    if limits:
        scale = 180 / math.pi if "[°" in figure.axes[0].get_ylabel() else 1.0
        figure.axes[0].set_ylim(*(scale * limit for limit in limits))
    around = _around(comparison)
    if around:
        figure.axes[0].set_xlim(*around)
        note = f"{note} Shown round the push; before and after the robot is near rest.".strip()
    return Figure(_claim(comparison, name), figure, note)


def _in_degrees(figure: MplFigure) -> None:
    """Angles and their rates in degrees."""
    for ax in figure.axes:
        if not ax.get_ylabel().endswith(("[rad]", "[rad/s]")):
            continue
        for drawn in ax.lines:
            drawn.set_ydata(np.degrees(np.asarray(drawn.get_ydata(), dtype=np.float64)))
        ax.yaxis.label.set_text(ax.get_ylabel().replace("[rad", "[°"))
        ax.relim()
        ax.autoscale_view()


def _band(comparison: Comparison, ax: Axes) -> None:
    """Dotted: what counts as calm after the release."""
    ((label, log),) = comparison.logs.items()
    calm, limit = _calm(comparison, label)
    if math.isfinite(calm):
        for side in (-1, 1):
            level, start = side * math.degrees(limit), comparison.releases[label]
            ax.hlines(level, start, log.t[-1], linestyle=":", linewidth=1.2, color=AXIS)


def _around(comparison: Comparison) -> tuple[float, float] | None:
    """The time [s] round the pushes until every run is calm, where that is a small part of the runs."""
    calm = {label: _calm(comparison, label)[0] for label in comparison.logs} if comparison.pushed else {}
    if not calm or "pitch" not in comparison.signals or not all(map(math.isfinite, calm.values())):
        return None
    settled = max(comparison.releases[label] + seconds for label, seconds in calm.items())
    log = comparison.logs[comparison.reference]
    start, end = float(log.t[0]), float(log.t[-1])
    low, high = max(start, comparison.pushed[0][0] - BESIDE), min(end, settled + BESIDE)
    return (low, high) if high - low < SMALL * (end - start) else None


def _claim(comparison: Comparison, name: str) -> str:
    if name == "pitch":
        if len(comparison.logs) == 1:
            label = comparison.reference
            calm, limit = _calm(comparison, label)
            if not comparison.pushed or comparison.metrics[label].fell:
                return "Pitch of the run"
            if math.isnan(calm):
                return "Pitch does not come to rest within the run"
            return f"Pitch is calm, within the dotted ±{_degrees(limit)}, {_settles(calm)} after the release"
        apart = (f"{label} {_degrees(size)}" for label, size in _apart(comparison, name).items())
        return f"Pitch beside that of {comparison.reference}, largest difference: {', '.join(apart)}"
    words = name.replace("_", " ").capitalize()
    fits = (f"{label} {_percent(fits[name])}" for label, fits in comparison.fits.items())
    return f"{words}, fit to {comparison.reference}: " + ", ".join(fits) if comparison.fits else f"{words} of the run"


def _percent(fit: float) -> str:
    if math.isnan(fit):
        return "none (no motion)"
    return f"{cell_text(fit, 3)} %" if fit > 0 else "below 0 %"


def _limits(comparison: Comparison, name: str) -> tuple[tuple[float, float] | None, str]:
    """The range to draw where a run dwarfs the reference, and which runs are cut."""
    states = {label: log[f"{comparison.sources[label]}/{name}"] for label, log in comparison.logs.items()}
    reference = states[comparison.reference]
    finite = reference[np.isfinite(reference)]
    low, high = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)
    room = DWARFED * (high - low)
    with np.errstate(invalid="ignore"):
        cut = [label for label, y in states.items() if ((y > high + room) | (y < low - room)).any()]
    if not cut or high == low:
        return None, ""
    return (low - (high - low), high + (high - low)), f"Cut at the frame: {', '.join(cut)}."


def _efforts(comparison: Comparison) -> str:
    unit = comparison.unit("effort")
    return "Effort: " + ", ".join(f"{label} {cell_text(m.effort, 3)} {unit}" for label, m in comparison.metrics.items())


def _origin_table(comparison: Comparison) -> Table:
    rows: list[list[Cell]] = [
        [label, comparison.kinds[label] or "–", comparison.sources[label], len(log), float(log.t[-1] - log.t[0])]
        for label, log in comparison.logs.items()
    ]
    return Table(["run", "body", "states from", "samples", "length [s]"], rows, "Runs")


def _provenance(comparison: Comparison) -> dict[str, str]:
    facts: dict[str, str] = {}
    for label, log in comparison.logs.items():
        seed = log.origin.get("scenario", {}).get("seed")
        mark = log.origin.get("controller", {}).get("hash")
        versions = log.origin.get("versions", {})
        known = {
            "seed": "" if seed is None else str(seed),
            "controller": str(mark)[:12] if mark else "",
            "versions": ", ".join(f"{name} {number}" for name, number in sorted(versions.items())),
        }
        facts |= {f"{label}: {key}": text for key, text in known.items() if text}
    return facts
