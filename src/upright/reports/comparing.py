"""The page of a `Comparison`: its tables and one figure for each signal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.comparison import Comparison
from upright.comparison.comparison import NEGLIGIBLE
from upright.experiment import motionless
from upright.plotting import line, number
from upright.reports.beside import (
    AVERAGED,
    CLOSE,
    FAIR,
    answered_fits,
    answered_only,
    averaged_over,
    both_runs,
    certify_command,
    fit_number,
    grazes,
    mark_largest,
    with_difference,
    worse,
    worst_state,
)
from upright.reports.figure import Figure
from upright.reports.made import again, command, typed
from upright.reports.metrics import around, degrees, fit_tables, how, left_out, listed_metrics, percent, words
from upright.reports.page import Cell, Details, Page, Section, Table, Verdict, cell_text
from upright.reports.single import (
    alone,
    band,
    leans_into,
    resting_figure,
    settles,
    travel,
    untouched,
    untouched_lead,
    untouched_title,
    way,
)
from upright.tables import joined, sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as MplFigure

    from upright.signals import Log


MOST = 3  # numbers on the first screen
NAMED = 4  # runs that a sentence names
DWARFED = 5.0
"""A trace that leaves the reference's range by more than this many times its width is cut at the frame."""


def page_of(comparison: Comparison) -> Page:
    """The comparison's page, not yet written."""
    labels, first = list(comparison.logs), "pitch" if "pitch" in comparison.signals else comparison.signals[0]
    still = [name for name in comparison.signals if _is_still(comparison, name)]
    figures = [state_figure(comparison, name) for name in comparison.signals if name not in (first, *still)]
    quiet = [sentence(f"no motion of {' or '.join(name.replace('_', ' ') for name in still)}")] if still else []
    defined = Details("How these numbers are defined", how(comparison))
    calm = untouched(comparison)
    still_run = calm and bool(motionless(comparison.logs[labels[0]]))
    numbers = [listed_metrics(comparison), *fit_tables(comparison, answered_fits(comparison)), defined]
    sections = [
        Section("Numbers", numbers, folded=still_run),
        Section("Other states", [*figures, *quiet], folded=True),
    ]
    commands = comparison.plot_commands()
    sections += [Section("Commands", [Figure(_efforts(comparison), commands)], folded=True)] if commands else []
    sections.append(
        Section(f"Origin of the run{'s' if len(comparison.logs) > 1 else ''}", [_origin_table(comparison)], folded=True)
    )
    return Page(
        _title(comparison, first), sections, _lead(comparison), _provenance(comparison),
        verdict=_verdict(comparison), numbers=_numbers(comparison),
        picture=(calm and resting_figure(comparison.logs[labels[0]])) or state_figure(comparison, first),
    )  # fmt: skip


def _title(comparison: Comparison, first: str) -> str:
    """Who fell, or how well the runs agree; of one run what it did."""
    labels = list(comparison.logs)
    if len(labels) == 1:
        return _title_of_one(comparison)
    fell = [label for label, m in comparison.metrics.items() if m.fell]
    if fell and len(fell) < len(labels):
        stood = [label for label in labels if label not in fell]
        if len(labels) > NAMED:
            fallen = f": {', '.join(fell)}" if len(fell) <= NAMED else ""
            return f"{len(fell)} of {len(labels)} runs fell{fallen}"
        return f"{', '.join(fell)} fell; {', '.join(stood)} did not"
    fits = _fits(comparison, first)
    if not fits:
        return f"{', '.join(labels)} compared"
    if first == "pitch" and answered_only(comparison):
        names = sentence(joined(list(fits)) if len(fits) < NAMED else f"{len(fits)} runs", "")
        return f"{names}: no further from {comparison.reference} than by their sway at rest"
    return _worst(comparison, fits, first)


def _worst(comparison: Comparison, fits: dict[str, float], first: str) -> str:
    """Of the worst run how well it fits."""
    worst = min(fits, key=lambda label: fits[label])
    follows = "follows" if fits[worst] >= FAIR else "does not follow"
    if len(fits) == 1:
        return f"{sentence(worst, '')} {follows} {comparison.reference}: {words(first)} fits {percent(fits[worst])}"
    return f"{len(fits)} runs beside {comparison.reference}; the worst, {worst}, fits {percent(fits[worst])}"


def _title_of_one(comparison: Comparison) -> str:
    """What one robot did, under which push."""
    if untouched(comparison):
        return untouched_title(comparison)
    ((label, log),) = comparison.logs.items()
    robot, pushes = log.origin.get("robot", {}).get("name", "") or "The robot", comparison.pushed
    lasting = f" for {min(pushes[0][1], log.t[-1]) - pushes[0][0]:.3g} s" if len(pushes) == 1 else ""
    under = (
        f", pushed {way(log)}{f'{len(pushes)} times ' if not lasting else ''}with {_force(log)}{lasting}"
        if pushes
        else ""
    )
    return f"{'Simulated, ' if comparison.kinds[label] else ''}{robot} {comparison.ended(label)}{under}"


def _fits(comparison: Comparison, first: str) -> dict[str, float]:
    return {label: f[first] for label, f in comparison.fits.items() if math.isfinite(f.get(first, math.nan))}


def _lead(comparison: Comparison) -> str:
    """What was run: robot, controller, push; and what to run next."""
    if untouched(comparison):
        return untouched_lead(comparison)
    log = comparison.logs[comparison.reference]
    robot, kind = (log.origin.get(part, {}).get(name, "") for part, name in (("robot", "name"), ("controller", "kind")))
    who = f"{robot} under {kind}" if robot and kind else robot or "One experiment"
    pushes = [f"from {start:.3g} to {stop:.3g} s" for start, stop in comparison.pushed]
    size = f" with {force}" if (force := _force(log)) else ""
    pushed = f", pushed {way(log)}".rstrip() + f"{size} {' and '.join(pushes[:2])}" if pushes else ", without a push"
    several = f"; runs: {', '.join(comparison.logs)}" if 1 < len(comparison.fits) < NAMED else ""
    several += "; other runs are pushed in another way" if _pushed_differently(comparison) else ""
    twin = any(kind.startswith("twin") for kind in comparison.kinds.values())
    stands = " The twin is a simulation, no real robot." if twin else ""
    models = [(name, what) for name, what in comparison.kinds.items() if what[:4] not in ("", "twin", "real")]
    stands += "".join(f" {sentence(name, '')} is the {what}." for name, what in models[:1])
    if len(comparison.logs) == 1:
        what = comparison.kinds[comparison.reference]
        body = f"One run of {f'the {what}' if what else 'a robot'}"
        return f"{body}{f', under {kind}' if kind else ''}.{leans_into(comparison)} Next: {_next_body(comparison)}"
    after = f"{certify_command(robot, kind)} pushes many similar robots under this controller, and counts how many fall"
    return f"{who}{pushed}{several}.{stands}{worse(comparison)} Next: {after}."


def _next_body(comparison: Comparison) -> str:
    """The same run in another body, and the comparison of both."""
    this = "twin" if comparison.kinds[comparison.reference].startswith("twin") else "model"
    other, body = ("model", "nonlinear") if this == "twin" else ("twin", "twin")
    file, options = typed("--output"), ("--output", "--body")
    if not command().startswith("upright simulate") or not file:
        return "`upright simulate … -o run.parquet` keeps a run, and `upright compare` shows it beside another."
    return (
        f"`{again('', *options)} --body {body} -o {other}.parquet`, then "
        f"`upright compare {this}={file} {other}={other}.parquet` shows how another model of it answers."
    )


def _force(log: Log) -> str:
    """The largest push, with its unit; nothing where there is none."""
    force = float(np.nanmax(np.abs(log["push/force"]), initial=0.0)) if "push/force" in log else 0.0
    return f"{number(force, 2)} N" if force else ""


def _pushed_differently(comparison: Comparison) -> bool:
    """Whether the largest pushes of the runs differ."""
    logs = [log for log in comparison.logs.values() if "push/force" in log]
    sizes = [float(np.nanmax(np.abs(log["push/force"]), initial=0.0)) for log in logs]
    return bool(sizes) and max(sizes) - min(sizes) > DIFFERS * max(sizes)


DIFFERS = 0.2  # of the largest push


def _grade(fit: float) -> str:
    """How good a fit [%] is, in one word."""
    return "good" if fit >= CLOSE else "fair" if fit >= FAIR else "poor"


_RANGES = {"good": f"{CLOSE:g} % or more", "fair": f"{FAIR:g} to {CLOSE:g} %", "poor": f"less than {FAIR:g} %"}


def _verdict(comparison: Comparison) -> Verdict | None:
    """Of one run whether the robot stood; of several how well they agree, or that only some fell."""
    fell = [m.fell for m in comparison.metrics.values()]
    if any(fell):
        return Verdict("fell" if len(fell) == 1 else f"{fell.count(True)} of {len(fell)} fell", "bad")
    first = "pitch" if "pitch" in comparison.signals else comparison.signals[0]
    fits = _fits(comparison, first)
    if fits:
        worst = min(fits.values())
        if first == "pitch" and answered_only(comparison):
            return Verdict("pitch: differs by sway only", "good")
        levels = {"good": "good", "fair": "warn", "poor": "bad"}
        return Verdict(f"{words(first)}: {_grade(worst)} fit, {_RANGES[_grade(worst)]}", levels[_grade(worst)])
    if untouched(comparison):
        return Verdict("nothing disturbed it", "info")
    return None if any(f is None for f in fell) else Verdict("stood", "good")


def _is_still(comparison: Comparison, name: str) -> bool:
    """Whether no run moves in this state by more than what counts as noise."""
    states = [log[f"{comparison.sources[label]}/{name}"] for label, log in comparison.logs.items()]
    return name in NEGLIGIBLE and all(np.nanmax(y) - np.nanmin(y) <= NEGLIGIBLE[name] for y in states)


def _numbers(comparison: Comparison) -> list[tuple[str, str]]:
    """Of one run pitch, calm and travel; of several the fit, the largest difference and pitch; a fall says so."""
    if len(comparison.logs) == 1:
        ((label, m),) = comparison.metrics.items()
        rest, limit = comparison.at_rest(label)
        calm = (settles(rest, 2), f"after the release, until pitch has settled: it stays within ±{degrees(limit)}")
        kept = [calm] if comparison.pushed and not m.fell else []
        return [(degrees(m.pitch_peak), "largest pitch"), *kept, travel(comparison, label)]
    fits = [
        fit_number(comparison, label, fit["pitch"])
        for label, fit in list(comparison.fits.items())[:1]
        if math.isfinite(fit.get("pitch", math.nan))
    ]
    apart = _apart(comparison, "pitch") if "pitch" in comparison.signals else {}
    fits += [
        (
            f"{cell_text(math.degrees(size), 2)}°",
            f"largest difference in pitch between {comparison.reference} and {label}",
        )
        for label, size in sorted(apart.items(), key=lambda item: -item[1])[:1]
    ]
    peaks = {label: degrees(m.pitch_peak) for label, m in comparison.metrics.items() if not m.fell}
    rest = [comparison.at_rest(label) for label in comparison.logs] if comparison.pushed else []
    if len(rest) == 2 and all(math.isfinite(seconds) for seconds, _ in rest):
        times, both = " and ".join(cell_text(seconds, 3) for seconds, _ in rest), " and ".join(comparison.logs)
        within = max(size for _, size in rest)
        band = f"±{degrees(within)} ({within:.2g} rad)"
        text = f"{both} settle after the release, to {band}"
        if grazes(comparison, within):
            middle = f"about {cell_text(float(np.mean([seconds for seconds, _ in rest])), 2)} s"
            each = " and ".join(f"{cell_text(s, 3)} s ({n})" for n, (s, _) in zip(comparison.logs, rest, strict=True))
            fits.append((middle, f"until {both} settle, to {band}; noise makes it {each}"))
        else:
            fits.append((f"{times} s", text))
    if len(peaks) == len(comparison.logs) == 2 and len(fits) < MOST:
        return [*fits, (" and ".join(peaks.values()), f"largest pitch of {' and '.join(peaks)}")]
    return fits + [
        (degrees(m.pitch_peak), f"{label}: largest pitch") if not m.fell else ("fell", label)
        for label, m in list(comparison.metrics.items())[: MOST - len(fits)]
    ]  # fmt: skip


def _apart(comparison: Comparison, name: str) -> dict[str, float]:
    """The largest difference [unit of the state] of each run from the reference, while both last."""
    apart: dict[str, float] = {}
    for label in comparison.fits:
        _, one, other = both_runs(comparison, name, label)
        apart[label] = float(np.nanmax(np.abs(one - other), initial=0.0))
    return apart


def state_figure(comparison: Comparison, name: str) -> Figure:
    """One state of all runs over time, under a title that says how they differ."""
    two = name == "pitch" and len(comparison.fits) == 1
    figure = (
        with_difference(comparison, *both_runs(comparison, name, *comparison.fits)) if two else comparison.plot(name)
    )
    _in_degrees(figure)
    if name == "pitch" and comparison.pushed and len(comparison.logs) == 1:
        band(comparison, figure.axes[0])
    if two:
        mark_largest(figure.axes[1])
    limits, note = _limits(comparison, name)
    worst = worst_state(comparison)
    if worst and worst[0] == name and worst[2] >= FAIR:
        _means(comparison, name, figure.axes[0])
        note = f"Lines: means over {AVERAGED:g} s. Pale: every sample. {note}".strip()
    if limits:
        scale = 180 / math.pi if "[°" in figure.axes[0].get_ylabel() else 1.0
        figure.axes[0].set_ylim(*(scale * limit for limit in limits))
    if name == "pitch" and len(comparison.logs) > 1:
        note = f"{note}{leans_into(comparison)}".strip()
    if part := around(comparison):
        figure.axes[0].set_xlim(*part)
        note = f"{note} {left_out(comparison, *part)}".strip()
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


def _means(comparison: Comparison, name: str, ax: Axes) -> None:
    """Means over a while on top of the samples, which are pale then."""
    factor = 180 / math.pi if "[°" in ax.get_ylabel() else 1.0
    for drawn in ax.lines:
        if str(drawn.get_label()) in comparison.logs:
            drawn.set(alpha=0.3, linewidth=0.8, linestyle="-", label="_samples")
    for style, (label, log) in enumerate(comparison.logs.items()):
        t, mean = averaged_over(log.t, log[f"{comparison.sources[label]}/{name}"])
        line(ax, label, t, factor * mean, style=style)


def _claim(comparison: Comparison, name: str) -> str:
    if not comparison.fits:
        return alone(comparison, name)
    if name == "pitch":
        apart = _apart(comparison, name)
        if len(apart) == 1:
            ((label, size),) = apart.items()
            most = f"{cell_text(math.degrees(size), 2)}°"
            return f"Pitch of {comparison.reference} and {label} differs by at most {most}"
        if len(apart) >= NAMED:
            far = max(apart, key=lambda label: apart[label])
            most = f"{far} differs most, by {degrees(apart[far])}"
            return f"Pitch of {len(apart)} runs beside {comparison.reference}: {most}"
        several = ", ".join(f"{label} {degrees(size)}" for label, size in apart.items())
        return f"Pitch beside that of {comparison.reference}, largest difference: {several}"
    worst = worst_state(comparison)
    if worst and worst[0] == name and worst[2] >= FAIR:
        over = f"{sentence(words(name), '')} averaged over {AVERAGED:g} s"
        return f"{over}: {worst[1]} fits {comparison.reference} {percent(worst[2])}"
    shown = answered_fits(comparison, name) or comparison.fits
    fits = (f"{label} {percent(fits[name])}" for label, fits in shown.items())
    return f"{sentence(words(name), '')}, fit to {comparison.reference}: {', '.join(fits)}"


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
    if len(comparison.logs) == 1:
        (m,) = comparison.metrics.values()
        at = f", {cell_text(100 * m.saturated, 2)} % of the time at the limit" if m.saturated > 0 else ""
        return f"Commands of the motors: effort {cell_text(m.effort, 3)} {comparison.unit('effort')}{at}"
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
    several: dict[str, dict[str, str]] = {}
    for label, log in comparison.logs.items():
        seed = log.origin.get("scenario", {}).get("seed")
        mark = log.origin.get("controller", {}).get("hash")
        versions = log.origin.get("versions", {})
        known = {
            "robot": str(log.origin.get("robot", {}).get("name", "")),
            "seed": "" if seed is None else str(seed),
            "controller": f"{log.origin.get('controller', {}).get('kind', '')} (fingerprint {str(mark)[:12]})".lstrip()
            if mark
            else "",
            "versions": ", ".join(f"{name} {number}" for name, number in sorted(versions.items())),
        }
        for key, text in known.items():
            several.setdefault(key, {})[label] = text
    for key, texts in several.items():  # what all have in common is said once
        alike = len(set(texts.values())) == 1
        named = {key: next(iter(texts.values()))} if alike else {f"{label}: {key}": t for label, t in texts.items()}
        facts |= {name: text for name, text in named.items() if text}
    return facts
