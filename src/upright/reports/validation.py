"""The page of a `Validation`: measured against predicted, and what would have to move."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from pathlib import Path

import numpy as np

from upright.calibration.calibration import GOOD, PREDICTED
from upright.plotting import number
from upright.reports.figure import Figure
from upright.reports.made import command, parsed, quoted
from upright.reports.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.signals import STATE_NAMES
from upright.tables import HALF_UP, joined, sentence, short, spoken
from upright.tables import least as least_of
from upright.validation.loop import FreeLoop
from upright.validation.validation import (
    DOES_NOT,
    JUDGED,
    PREDICTS,
    SMOOTH,
    ChannelFit,
    LogJudged,
    Validation,
    half_second_figure,
    least,
    loop_figure,
)

_HALF = (
    "Each half second starts from a state that is fitted to it, and gets only the logged commands. R² counts what the "
    "prediction misses against what the reading varies. Fit is 100 (1 − rms error / standard deviation). First missed: "
    "the first half second whose rms error is above the standard deviation of the whole reading."
)
_OWN = (
    "Friction, winding, supply, floor and dead times differ from run to run of one robot. Here they are fitted to this "
    "log, about what is known, with the spreads that runs usually have. The robot's other numbers stay."
)
_LOOP = (
    "The closed loop is simulated from the first state of the log. The law computes its commands anew, and what the "
    "experiment added to them is added again. It gets no reading of the log. "
    "Small errors of that state and the missing noise add up, so that it drifts before a push too. It gets no push: it "
    "leaves the log at the first one. Neither alone speaks against the robot."
)
_LOST = (
    "Lost: over {:g} s the rms error is above the standard deviation of the whole reading, pushes included. "
    "That is {}. A smaller drift is not counted, although it shows in the figure."
)
_FELL = (
    "The simulated robot falls at t = {:.3g} s. If the logged one stood, that is not expected: the law as known here, "
    "or the fitted first state, is not right."
)
_STILL = "The robot hardly turns in this log, less than the compass can tell: its R² says nothing."
_ONE = "The right encoder is not judged: the log has none, or its channel equals that of the left one."
_SHIFTS = (
    "Each parameter is moved alone to where it fits the log best (one Gauss–Newton step). Listed are those that shrink "
    "the squared error of half seconds by a tenth or more. σ: the standard deviation of what is known."
)


_NONE = "None: changing any one alone removes less than a tenth of the squared error. Changing several may help more."


def page_of(result: Validation) -> Page:
    """The validation's page, not yet written."""
    worst = result.worst
    level = {PREDICTS: "good", DOES_NOT: "bad"}.get(result.verdict, "warn")
    words = result.verdict if result.verdict == JUDGED else result.says("the log")
    used = any(log.no_test for log in result.logs)
    verdict = Verdict(f"{words}; no test" if used else words, "warn" if used and level == "good" else level)
    sections = [section for log in result.logs for section in _sections(log, len(result.logs) > 1)]
    half = f"Measured and predicted, half a second at a time: R² of {_each(worst)}"
    half = "Predictions of half a second lie on the readings" if worst.worst.r2 >= GOOD else half
    starts = " ".join([_starts(worst), *(note.replace(" -", " −") for note in worst.notes if note.startswith("Only "))])
    logs = ", ".join(Path(log.source).name for log in result.logs)
    return Page(
        _title(result), sections, _lead(result), {"kit": result.kit, "logs": logs}, False, verdict=verdict,
        picture=Figure(half, half_second_figure(worst), starts), numbers=_numbers(result),
    )  # fmt: skip


def _starts(log: LogJudged) -> str:
    """From what each half second starts, and whether that flatters R²: m numbers fitted to n readings take m/n of the
    error at most where that is noise."""
    halves = len(np.unique(log.segments.segment))
    readings = len(log.segments.when) / max(halves, 1)
    text = f"Each half second gets the logged commands and a first state: {STATES} numbers, fitted to about "
    few = FEW * readings > STATES
    text += f"{number(readings, 2)} readings of it."
    return f"{text} {'That hardly raises R².' if few else 'So few readings make R² too high.'}"


# of the readings, up to which numbers fitted to them hardly show
STATES = len(STATE_NAMES)
FEW = 0.1


def _title(result: Validation) -> str:
    """Which sensors are predicted, and which are not, with the R² of the worst."""
    least_r2 = result.worst.worst.r2
    logs = Path(result.logs[0].source).name or "the log" if len(result.logs) == 1 else f"{len(result.logs)} logs"
    fits = [c for log in result.logs for c in log.half_seconds if c.name in PREDICTED]
    poor = {c.name for c in fits if c.r2 < GOOD}
    good = {c.name for c in fits} - poor
    if not poor:
        return f"{result.robot} {result.says(logs)}: {_named(good)} with R²\u00a0≥\u00a0{least_of(least_r2, 3)}"
    lowest = f"R² {least_of(least_r2, 3)}" if least_r2 >= 0 else "R² below 0"
    lowest = f"{lowest}, needs {GOOD:g}" if len(poor) == 1 else f"least {lowest}, needs {GOOD:g}"
    if good:
        return f"{result.robot} predicts the {_named(good)} of {logs}, not the {_named(poor)} ({lowest})"
    return f"{result.robot} does not predict the {_named(poor)} of {logs} well ({lowest})"


def _each(log: LogJudged) -> str:
    """R² of each sensor that is judged, of both encoders the smaller."""
    judged = sorted((c for c in log.half_seconds if c.name in PREDICTED), key=lambda c: c.r2)
    names = {c.name for c in judged}
    least_r2 = dict[str, float]()
    for c in judged:
        least_r2.setdefault(_called(c.name, names), c.r2)
    return ", ".join(f"{name} {f'≥ {least_of(r2, 3)}' if r2 >= 0 else 'below 0'}" for name, r2 in least_r2.items())


def _r2(r2: float) -> str:
    """R² to three digits, rounded, but never up to the pass mark or to 1."""
    if r2 < 0:
        return "below 0"
    rounded = round(r2 * HALF_UP, 3)
    return least_of(r2, 3) if r2 < GOOD <= rounded or r2 < 1 <= rounded else f"{rounded:.3f}"


def _named(names: Collection[str]) -> str:
    """Sensors in words."""
    return joined(sorted({_called(name, names) for name in names}, reverse=True))


def _called(name: str, names: Collection[str]) -> str:
    """A sensor in words; both sides have one name where both are there."""
    kind, _, side = name.rpartition("_")
    other = {"left": "right", "right": "left"}.get(side)
    return f"{short(kind)}s" if other and f"{kind}_{other}" in names else short(name)


def _lead(result: Validation) -> str:
    """Whether this is a test, how the worst sensor misses, what is not judged, and what to run next."""
    again = "`upright calibrate` with this log, which moves all parameters together"
    made = parsed(command())
    robot = quoted(made.arguments[:1]) if made.verb == "validate" and made.arguments else result.robot
    then = (
        f"`upright design lqg --robot {robot} -o lqg.json` designs a controller for it"
        if result.worst.worst.r2 >= GOOD
        else again
    )
    then = f"`upright validate {robot} LOG` with a LOG of another run" if any(o.no_test for o in result.logs) else then
    dead = sorted({short(name) for log in result.logs for name in log.dead})
    never = f" Not judged, since constant: {joined(dead)}." if dead else ""
    return f"{_tested(result)}{_size(result.worst)}{never} Next: {then}."


def _size(log: LogJudged) -> str:
    """How large the swings are that are predicted for the worst sensor, where it does not pass, as a sentence with a
    space before it."""
    if log.worst.r2 >= GOOD:
        return ""
    _, measured, predicted = log.segments.series(log.worst.name)
    there = np.isfinite(measured) & np.isfinite(predicted)
    if not there.any() or not measured[there].std():
        return ""
    part = cell_text(float(predicted[there].std() / measured[there].std()), 2)
    return f" The predicted {short(log.worst.name)} swings {part} times as much as the measured one (rms)."


def _tested(result: Validation) -> str:
    """Whether these logs test the robot: only what it was not fitted to does."""
    seconds = f"{sum(log.seconds for log in result.logs):.3g} s"
    if any(log.fitted is None for log in result.logs):
        return (
            f"{seconds} of log. It is a test only if {result.robot} was not fitted to it, which its file does not say. "
            "A log of a new run is a test for sure."
        )
    used = [log.no_test for log in result.logs if log.no_test]
    if not used:
        return f"A test on {seconds} of log: {result.robot} was fitted to none of these rows."
    few = "" if len(used) == len(result.logs) else " The other logs do."
    return f"{sentence('; '.join(used))} That part tests nothing.{few}"


def _numbers(result: Validation) -> list[tuple[str, str]]:
    worst = result.worst.worst
    numbers = [
        (
            _r2(worst.r2),
            f"R² of the {short(worst.name)} over half seconds, the worst of gyro and encoders; passes from {GOOD:g}",
        )
    ]
    if own := result.worst.own_run:
        numbers.append((_r2(least(own).r2), "the same with friction, battery and delays fitted to this run"))
    judged = [log for log in result.logs if log.loop and not log.caution]
    loops = [c for log in judged for c in log.loop]
    if loops:
        lowest = min(loops, key=lambda c: c.r2)
        if lowest.r2 < 0 and (first := _first(loops)):
            pushed = next((p for p in map(_pushed, judged) if p is not None), None)
            numbers.append(
                (f"{first.breaks:.2g} s", f"the whole run, simulated, follows the log; {_lost(loops, pushed)}")
            )
        else:
            long = f"{cell_text(max(log.seconds for log in judged), 2)} s"
            whole = f"R² of {short(lowest.name)} when the whole {long} are simulated from the first state"
            whole += ": not judged, since small errors grow"
            numbers.append((_r2(lowest.r2), whole))
    shifts = [s for log in result.logs for s in log.shifts]
    if shifts:
        first = max(shifts, key=lambda s: s.explains)
        left = (
            f" of the {cell_text(100 * (1 - worst.r2), 2)} % of error left" if GOOD <= worst.r2 < 1 else " of the error"
        )
        removes = f"moved alone it removes {cell_text(100 * first.explains, 2)} %{left}"
        small = worst.r2 >= GOOD and all(abs(s.deviations) < 1 for s in shifts)  # as below
        doubt = f"{removes}; no need to change it" if small else f"the parameter to doubt first: {removes}"
        numbers.append((spoken(first.name), doubt))
    elif len(numbers) < MOST:
        numbers.append(("none", "of the parameters, changed alone, would make the prediction much better"))
    seconds = (f"{sum(log.seconds for log in result.logs):.3g} s", "of log predicted, half a second at a time")
    return [*numbers, *_passing(result), *([seconds] if len(numbers) < 2 else [])][:MOST]


def _passing(result: Validation) -> list[tuple[str, str]]:
    """The least R² of the sensors that pass, where others do not."""
    fits = [c for log in result.logs for c in log.half_seconds if c.name in PREDICTED]
    poor = {c.name for c in fits if c.r2 < GOOD}
    good = [c for c in fits if c.name not in poor]
    if not poor or not good:
        return []
    return [(_r2(min(c.r2 for c in good)), f"R² of the {_named({c.name for c in good})}: passes")]


MOST = 3  # numbers on the first screen


def _first(loop: Sequence[ChannelFit]) -> ChannelFit | None:
    """The reading that leaves the log first; a compass does so by itself."""
    broken = [c for c in loop if c.breaks is not None and not c.name.endswith("compass")]
    return min(broken, key=lambda c: c.breaks or 0.0, default=None)


def _pushed(log: LogJudged) -> float | None:
    """The start [s] of the push that ends the whole run, where the log tells of one."""
    first = _first(log.loop)
    starts = [start for start, _ in log.simulated.pushes] if log.simulated else []
    return next((s for s in starts if first and first.breaks is not None and s <= first.breaks <= s + AFTER), None)


AFTER = 0.5  # [s] within which a push shows in some reading


def _lost(loop: Sequence[ChannelFit], pushed: float | None) -> str:
    """What ended the whole run: drift shows in the wheels first, a push in the gyro; a pitch that leaves before the
    gyro swings by itself."""
    first = _first(loop)
    assert first
    if pushed is not None:
        return f"a push at {cell_text(pushed, 3)} s is not simulated"
    if "encoder" in first.name:
        return "then the wheels drift off"
    if "gyro" in first.name:
        return "then the gyro jumps, as after a push"
    return f"then the simulated {short(first.name)} swings away"


def _sections(log: LogJudged, several: bool) -> list[Section]:
    """What the page says of one log."""
    name = f" of {Path(log.source).name}" if several else ""
    named = log.law.startswith("law")
    law = sentence(log.law if named else f"the closed loop {log.law}".replace("; --controller", "; `--controller`"))
    loop: list[Item] = [log.caution] if log.caution else []
    if log.simulated is not None:
        estimated = any(name.startswith("estimate/") for name in log.simulated.names)
        loop += [
            Figure("Measured, and the whole run simulated from its first row", loop_figure(log.simulated)),
            *([_FELL.format(log.simulated.fell)] if log.simulated.fell is not None else []),
            _table(log.loop, "lost after [s]"),
            Details(_COMPUTED, [law, _LOOP, _beyond(log.simulated), *([_ESTIMATED] if estimated else [])]),
        ]
    else:
        loop += [law]
    rows: list[list[Cell]] = [
        [f"{spoken(s.name)} [{s.unit}]", s.value, s.proposed, s.deviations, 100 * s.explains] for s in log.shifts
    ]
    steps = Table(["parameter", "value", "proposed", "step [σ]", "error removed alone [%]"], rows, digits=3)
    small = all(abs(s.deviations) < 1 for s in log.shifts)
    moves: list[Item] = [*([_SMALL] if small else []), steps, Details(_COMPUTED, [_SHIFTS])]
    names = {c.name for c in log.half_seconds}
    one = "sensor/encoder_left" in names and "sensor/encoder_right" not in names
    noted = [note for note in log.notes if several or not note.startswith("Only ")]  # that stands below the picture
    half: list[Item] = [*noted, _table(log.half_seconds), *([_ONE] if one else [])]
    half += [f"{_COMPASS}{_would(log)}"] if COMPASS in names else []
    half += [_STILL] if _still(log) else []
    if log.own_run:
        effects: list[list[Cell]] = [[e.name.replace("_", " "), e.unit, e.known, e.here] for e in log.effects]
        half += [_OWN, _table(log.own_run), Table(["parameter", "unit", "known", "this run"], effects, digits=3)]
    return [
        Section(f"Half a second at a time{name}", [*half, Details(_COMPUTED, [_HALF])]),
        Section(f"The whole run{name}", loop, _whole(log), folded=log.simulated is not None),
        Section(f"Parameters to doubt{name}", moves if rows else [_NONE]),
    ]


def _would(log: LogJudged) -> str:
    """Whether the compass would pass, where it shows a turn."""
    r2 = next(c.r2 for c in log.half_seconds if c.name == COMPASS)
    return "" if _still(log) else f" Here it would {'' if r2 >= GOOD else 'not '}pass."


def _whole(log: LogJudged) -> Verdict | None:
    """How well the whole run is followed, beside its heading, since it is folded."""
    if log.simulated is None or not log.loop:
        return None
    ends = [_r2(end(c.r2 for c in log.loop)) for end in (min, max)]
    words = f"R² {' to '.join(dict.fromkeys(ends))}"
    return Verdict(f"{words}: not judged", "info")


_SMALL = "Each step is less than one standard deviation of what is known: no number has to be changed."
_COMPUTED = "How this is computed"
_COMPASS = "The compass is not judged: iron and motors nearby disturb any compass."
_ESTIMATED = "The measured pitch is the estimate that the log holds, not a reading: it is shown, not judged."


def _beyond(loop: FreeLoop) -> str:
    """What counts as lost, for each reading."""
    sizes = [
        f"{cell_text(float(np.nanstd(y)), 2)} {PREDICTED.get(name, 'rad')} for the {short(name)}"
        for name, y in zip(loop.names, loop.measured.T, strict=True)
        if not name.endswith("compass")
    ]
    return _LOST.format(SMOOTH, joined(sizes))


def _still(log: LogJudged) -> bool:
    """Whether the compass shows no turn beyond its noise: steps, or what differs from one reading to the next."""
    if COMPASS not in log.segments.rows:
        return False
    _, measured, _ = log.segments.series(COMPASS)
    y = measured[np.isfinite(measured)]
    steps = np.diff(np.unique(np.round(y, 6)))
    noise = float(np.std(np.diff(y))) / math.sqrt(2) if len(y) > 2 else 0.0
    return not len(steps) or float(np.ptp(y)) <= max(RANGE * noise, 2 * float(steps.min()))


COMPASS = "sensor/compass"
RANGE = 7.0  # deviations of normal noise from the least to the largest of some thousand readings: 6.5


def _table(channels: Sequence[ChannelFit], when: str = "first missed at [s]") -> Table:
    rows: list[list[Cell]] = [
        [short(c.name) + (" (not judged)" if c.name.endswith("compass") else ""),
         float(least_of(c.r2, 4)) if c.r2 > 0 else "below 0", c.fit if c.r2 > 0 else None, c.breaks]
        for c in channels
    ]  # fmt: skip
    kept = 4 if any(c.breaks is not None for c in channels) else 3  # a column of dashes says nothing
    cells = [[*row[:2], _rounded(row[2]), row[3]][:kept] for row in rows]
    return Table(["sensor", "R²", "fit [%]", when][:kept], cells)


def _rounded(fit: Cell) -> Cell:
    """A fit to a tenth of a per cent: more digits mean nothing."""
    return round(fit, 1) if isinstance(fit, float) else fit
