"""The log with a fault taken out of it: what the filter then gives is exact, where the bank is linear."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from contextvars import ContextVar
from dataclasses import dataclass, field, replace

import numpy as np

from upright.arrays import Array, Mask
from upright.diagnose.changes import DRAGGED, HELD, MOTORS, channels_of, dead_motors, lost_command
from upright.diagnose.fall import limit, without
from upright.diagnose.fault_fits import FaultFit, dearer, freed_of, remaining, with_pushes
from upright.diagnose.innovations import IN_TIME, NEVER_STIFF, FilterRun, follow
from upright.diagnose.signatures import YOUNGEST, Bank, bank, beside, channels, finer, pushing, unknown_parameters
from upright.diagnose.sizes import natural, possible
from upright.errors import InvalidLog
from upright.signals import Log

GYRO = "sensor/gyro"

UNTIL: ContextVar[float] = ContextVar("UNTIL", default=math.inf)  # [s] of processor time, when all searches end
READING_FAULTS = ("bias", "scale")
COMMAND_FAULTS = ("weak", "delay", "motor", "friction")
"""Faults of the commands, which are not small where the robot falls: the filter itself searches for them."""
FREED = READING_FAULTS + COMMAND_FAULTS  # faults that a log can be freed of
CHARGES = (0.05, 0.15, 0.3, 0.5, 0.7)  # fractions of the battery's voltage that are tried first
DELAYS = (1.0, 2.0, 3.5, 5.0, 7.0, 10.0)  # periods that are tried first
LONGEST = 20.0  # periods: a loop whose commands arrive later does not run, which lost rows show
FADE, FADE_PRICE = 0.4, 1  # [s] in which a battery breaks down that are tried first, and its free number
WEAKEST, STRONGEST = 0.03, 0.97  # of a battery's voltage
NO_TIME = 1e-9  # [s]
ONSET_STEP = 0.4  # [s] between onsets that are tried first
WARM_UP = 2.0  # [s] that the filter has to find the robot before the part of the log that is judged
SCALE_STEP = 0.2  # of a reading, or of the motion that it stands for where that is more
HALVINGS = 4  # of the steps in size and onset, round the best
MOST_MOVES = 8  # by steps of one length
BIAS_ROUNDS = 2  # most times that a gyro's offset is estimated again on the log freed of it
BEHIND = 150.0  # nats behind the likeliest, from which a gyro's offset is not examined again
RARE = 50.0
"""Nats that another scale of a sensor has to explain beyond another fault, and twice as many where it leaves more than
noise: it follows the motion, so it takes up a part of whatever else is wrong."""

MOST_BIASES, MOST_SCALES, MOST_MOTORS, PUSHED = 4, 2, 2, 2  # that are examined again, the last beside their pushes
SETTLED = 0.3  # [s] of a log, by whose readings the filter begins
SHORT = 0.1  # [s] before the window's end: a filter that stops earlier has lost the robot


def timed_out() -> bool:
    """Whether the time to search is over."""
    return time.thread_time() > UNTIL.get()


def remedied(run: FilterRun, *fits: FaultFit) -> FilterRun | None:
    """The run of the log without these faults; None where a log cannot be freed of one, or no log or time is left."""
    if timed_out() or any(fit.fault not in FREED for fit in fits):
        return None
    channels, changed, delayed = dict(run.log.channels), [fit for fit in fits if fit.fault in READING_FAULTS], IN_TIME
    for fit in changed:
        if fit.fault == "bias":
            elapsed = run.log.t - fit.onset
            channels[GYRO] = channels[GYRO] - fit.size * np.where(elapsed >= 0, elapsed if fit.way == "ramp" else 1, 0)
        else:
            names = channels_of(run, fit.way)
            channels |= {name: _rescaled(run.log.t, name, channels[name], fit) for name in names}
    log = Log(run.log.t, channels, run.log.units, run.log.origin) if changed else None
    if log and min(fit.onset for fit in changed) < run.log.t[0] + SETTLED:  # what the filter begins with
        try:
            run, log = follow(log, run.robot, run.kit, run.kept), None
        except InvalidLog:  # of a sensor beyond its range in all rows nothing is left
            return None
    sent, stiff = None, NEVER_STIFF
    for fit in fits:
        if fit.fault == "friction":
            left, right = DRAGGED[fit.way]
            stiff = fit.onset, fit.size * left, fit.size * right
        elif fit.fault in COMMAND_FAULTS:
            sent, delayed = _sent(run if log is None else replace(run, log=log), fit, sent), _in_time(run, fits)
    unchanged = log is None and sent is None and stiff == NEVER_STIFF
    return run if unchanged else run.again(sent, log, delayed, stiff)


def followed(run: FilterRun, end: float, *fits: FaultFit) -> FilterRun | None:
    """The run of the log without these faults; None also where its filter loses the robot before `end` [s]."""
    freed = remedied(run, *fits)
    return freed if freed is not None and freed.reaches(end - SHORT) else None


def _in_time(run: FilterRun, fits: Sequence[FaultFit]) -> tuple[float, float, float]:
    """Since when [s] commands, or readings, are late by how much [s] of a delay: of commands, what is left of a
    period."""
    delay = next((fit for fit in fits if fit.fault == "delay"), FaultFit(fault="none"))
    if delay.way == "readings":
        return delay.onset, 0.0, delay.size * run.log.period
    return delay.onset, (delay.size - math.floor(delay.size)) * run.log.period, 0.0


def _rescaled(t: Array, name: str, values: Array, fit: FaultFit) -> Array:
    """A sensor's readings without the fraction `fit.size` of them since the onset; of an angle, of what it grew by, and
    of a gyro of what lies beyond the reading at rest that the fit names."""
    on, first = t >= fit.onset, 0.0
    if name == GYRO:
        first = fit.more[0] if fit.more else 0.0
    elif "rate" not in name:
        first = _angle_at(fit.onset, t, values, max(1 - fit.size, 0.0))
    return np.where(on, first + (1 - fit.size) * (values - first), values)


def _angle_at(onset: float, t: Array, values: Array, rest: float) -> float:
    """An angle's true reading at a time between two rows [s], from which on `rest` of its change counts."""
    i = max(0, int(np.argmax(t >= onset)) - 1)
    part = min(max((onset - t[i]) / (t[i + 1] - t[i]), 0.0), 1.0) if i + 1 < len(t) else 0.0
    whole = 1 - part + part * rest
    return float(((1 - part) * values[i] + part * rest * values[i + 1]) / whole if whole > 0 else values[i])


def _sent(run: FilterRun, fit: FaultFit, before: Array | None = None) -> Array:
    """The commands at the motors (samples, 2) with a fault of them from its onset on, after another one that made them
    those `before`."""
    usual = run.driven() if before is None else before
    if fit.fault == "motor":
        return _without_motor(run, fit, usual)
    if fit.fault == "delay":
        whole = 0 if fit.way == "readings" else math.floor(fit.size)
        before = np.vstack([np.repeat(usual[:1], whole, axis=0), usual[: len(usual) - whole]])
        return np.where((run.log.t >= fit.onset)[:, None], before, usual)
    grown = np.clip((run.log.t - fit.onset) / max(fit.rise, NO_TIME), 0.0, 1.0)
    faulty = run.driven(1 - (1 - fit.size) * grown, pwm=fit.way == "pwm")
    return np.where((grown > 0)[:, None], faulty, usual)


def acts_from(run: FilterRun, fit: FaultFit) -> float:
    """When a fault begins to act [s]: a largest command that is smaller, where one would have been larger."""
    if fit.fault != "weak" or fit.way != "limit":
        return fit.onset
    changed = np.flatnonzero((_sent(run, fit) != run.driven()).any(axis=1))
    return float(run.log.t[changed[0]]) if len(changed) else math.inf


def _without_motor(run: FilterRun, fit: FaultFit, usual: Array) -> Array:
    """The commands that dead motors act as: none where they are braked, else the voltage that they turn at."""
    faulty = np.where(MOTORS[fit.way][:2], _by_sample(run, run.command + lost_command(run, fit.way)), usual)
    return np.where((run.log.t >= fit.onset)[:, None], faulty, usual)


def _by_sample(run: FilterRun, values: Array) -> Array:
    """What is known at each event (events, 2) at each sample of the log (samples, 2)."""
    rows = run.row < 0
    return np.column_stack([np.interp(run.log.t, run.t[rows], one) for one in values[rows].T])


@dataclass(frozen=True)
class Window:
    """The part of a log that is judged: it `end`s then [s], is at most so many `seconds` long, and `usual` is the scale
    of its innovations before."""

    end: float
    seconds: float
    usual: float
    banks: dict[FilterRun, Bank] = field(default_factory=dict, repr=False)

    def of(self, run: FilterRun) -> FilterRun:
        """This part of a run."""
        return run.between(self.end - self.seconds, self.end)

    def bank(self, run: FilterRun, *, pushes_only: bool = True, beside_it: str = "") -> Bank:
        """The bank of hypotheses on this part of a run."""
        part = self.of(run)
        coarse = bank(part, self.usual, pushes_only=pushes_only, beside_it=beside_it)
        return finer(part, coarse, [(push.start, push.stop) for push in with_pushes(coarse).pushes])

    def beside(self, fit: FaultFit, usual: Bank) -> Bank:
        """The bank of all hypotheses on the run without the fault of `fit`; the `usual` one where there is none."""
        if fit.run is None:
            return usual
        if fit.run not in self.banks:
            self.banks[fit.run] = self.bank(fit.run, pushes_only=False)
        return self.banks[fit.run]

    def channels(self, fit: FaultFit, usual: Bank) -> Bank:
        """The same of disturbances of any shape alone."""
        if fit.run is None:
            return usual
        return self.banks.get(fit.run) or channels(self.of(fit.run), self.usual)


BATTERY_OR_DELAY = (
    (FaultFit(fault="weak", way="pwm", rise=FADE), CHARGES),
    (FaultFit(fault="weak", way="limit", rise=FADE), CHARGES),
    (FaultFit(fault="delay"), DELAYS),
)
"""A weak battery of either kind and a longer delay, and the sizes that are tried first."""


def lately(run: FilterRun, window: Window) -> FilterRun:
    """The filter along the window and the seconds in which it warms up."""
    return follow(run.log.between(window.end - window.seconds - WARM_UP, math.inf), run.robot, run.kit, run.kept)


def searched(run: FilterRun, window: Window) -> list[FaultFit]:
    """A weak battery of either kind, a longer delay, dead motors and wheels held by dry friction, each of the size and
    onset with the smallest innovations; their scores are not yet exact."""
    most, ways = limit(run.robot, run.kit, run.asked), dead_motors(run)
    held = tuple(part * most for part in HELD)
    faults = (*BATTERY_OR_DELAY, *((FaultFit(fault="motor", way=way), (1.0,)) for way in ways))
    faults += tuple((FaultFit(fault="friction", way=way), held) for way in DRAGGED if way in ways)
    recent = lately(run, window)
    return [_searched(recent, window, *fault) for fault in faults]


def _searched(recent: FilterRun, window: Window, fault: FaultFit, sizes: tuple[float, ...]) -> FaultFit:
    """The fault of the smallest innovations."""

    def squares(tried: FaultFit) -> float:
        freed = followed(recent, float(recent.t[-1]), tried)
        return math.inf if freed is None else float((window.of(freed).whitened ** 2).sum())

    least, best = anywhere(squares, fault, sizes, window)
    return replace(best, nis=least / int(window.of(recent).readings.sum()))


def anywhere(
    cost: Callable[[FaultFit], float], fault: FaultFit, sizes: Sequence[float], window: Window
) -> tuple[float, FaultFit]:
    """The least cost of a fault of any size and onset in a window, and that fault: by a grid that has these sizes,
    then by steps that are halved."""
    onsets = np.arange(window.end - window.seconds, window.end - YOUNGEST, ONSET_STEP).tolist()
    least, best = least_of(cost, [replace(fault, onset=t, size=x) for t in onsets for x in sizes])
    for halving in range(HALVINGS):
        for _ in range(MOST_MOVES):
            tried = least_of(cost, _near(best, 0.5**halving, window.end - YOUNGEST))
            if tried[0] >= least:
                break
            least, best = tried
    return least, best


def least_of(squares: Callable[[FaultFit], float], several: Sequence[FaultFit]) -> tuple[float, FaultFit]:
    """What leaves the smallest squares, and these."""
    return min(((squares(one), one) for one in several), key=lambda one: one[0])


def moved(
    run: FilterRun,
    starts: Sequence[Sequence[FaultFit]],
    window: Window,
    basis: Array | None = None,
    others: Sequence[Array] = (),
) -> list[FaultFit]:
    """Faults that a log can be freed of, with the onsets and sizes that leave the smallest innovations near the best of
    the `starts`, beside what the best of `others` (readings, signatures) and unknown parameters by their `basis`
    explain."""
    recent = lately(run, window)
    bases = [np.linalg.qr(one)[0] for one in others]

    def squares(tried: Sequence[FaultFit]) -> float:
        freed = followed(recent, float(recent.t[-1]), *tried)
        if freed is None:
            return math.inf
        y = window.of(freed).whitened
        if basis is not None:
            if len(y) + basis.shape[1] != len(basis):  # the filter lost a reading
                return math.inf
            y = beside(basis, y)
        return float(y @ y) - max((float(((y @ one) ** 2).sum()) for one in bases), default=0.0)

    least, best = min(((squares(fits), list(fits)) for fits in starts), key=lambda one: one[0])
    return descended(squares, least, best, window.end - YOUNGEST)[1]


def descended(
    squares: Callable[[Sequence[FaultFit]], float], least: float, best: list[FaultFit], latest: float, rounds: int = 1
) -> tuple[float, list[FaultFit]]:
    """From the `best` faults, which leave `least`, by steps that are halved; with each length at most so many `rounds`,
    as long as they lead on."""
    for halving in range(HALVINGS):
        for _ in range(rounds):
            before = least
            for i in range(len(best)):
                for other in _near(best[i], 0.5**halving, latest):
                    tried = [*best[:i], other, *best[i + 1 :]]
                    left = squares(tried)
                    if left < least:
                        best, least = tried, left
            if least == before:
                break
    return least, best


def faded(fit: FaultFit) -> list[FaultFit]:
    """The fault as it is, and of a battery that breaks down at once one that fades about the same time."""
    if fit.fault != "weak" or fit.rise > 0:
        return [fit]
    return [fit, replace(fit, rise=FADE, onset=fit.onset - FADE / 2)]


def _near(fit: FaultFit, step: float, latest: float) -> list[FaultFit]:
    """The same fault a little earlier or later, and of a smaller or larger size."""
    times = [fit.onset - step * ONSET_STEP / 2, min(fit.onset + step * ONSET_STEP / 2, latest)]
    near = [replace(fit, onset=t) for t in times]
    if fit.fault == "motor":
        return near
    if fit.fault == "scale":
        part = SCALE_STEP * max(1.0, abs(1 - fit.size))  # of what one reading counts
        return near + [replace(fit, size=fit.size + change * step) for change in (-part, part)]
    sizes = [fit.size * 1.6**change for change in (-step, step)]
    if fit.fault == "delay":
        sizes = [min(size, LONGEST) for size in sizes]
    if fit.fault != "weak":
        return near + [replace(fit, size=size) for size in sizes]
    least = WEAKEST if fit.rise > 0 else 0.0  # of one that fades beyond the fall, what is left in the end does not show
    near += [replace(fit, size=min(max(size, least), STRONGEST)) for size in sizes]
    rises = [max(0.0, fit.rise - step * FADE), fit.rise + step * FADE]  # about the same middle
    near += [replace(fit, rise=rise, onset=fit.onset - (rise - fit.rise) / 2) for rise in rises]
    longer = [1 - step / 2, 1 + step / 2]  # as steep: the robot may fall while its battery fades
    sizes = [min(max(1 - (1 - fit.size) * k, WEAKEST), STRONGEST) for k in longer]
    return near + [replace(fit, rise=k * fit.rise, size=size) for k, size in zip(longer, sizes, strict=True)]


def exact(run: FilterRun, fit: FaultFit, window: Window, against: Bank) -> FaultFit:
    """The fit's score where its fault is taken out of the log; the size of a gyro's offset is estimated again."""
    best = fit
    for _ in range(BIAS_ROUNDS if fit.fault in READING_FAULTS else 1):
        freed = followed(run, window.end, fit)
        if freed is None:
            return best
        now = replace(freed_of(with_pushes(window.bank(freed), against=against), fit), run=freed)
        if fit.rise > 0:
            now = dearer(now, FADE_PRICE, against)
        if now.score <= best.score and best is not fit:
            return best
        best = now if now.score > best.score else best
        if fit.fault in READING_FAULTS:
            more = remaining(window.of(freed), fit)
            fit = replace(fit, size=fit.size + (more if fit.fault == "bias" else more * (1 - fit.size)))
    return best


def beside_pushes(run: FilterRun, fit: FaultFit, window: Window, against: Bank) -> FaultFit:
    """The fit again, with the onset and size that explain most together with the pushes beside it."""
    edges = [(push.start, push.stop, push.height) for push in fit.pushes]
    freed = fit.run or remedied(run, fit)
    if freed is None:
        return fit
    part = window.of(freed)
    basis = unknown_parameters(part, fit.nis)
    again = moved(run, [[one] for one in faded(fit)], window, basis, [beside(basis, pushing(part, edges))])[0]
    again = priced(exact(run, replace(again, score=-math.inf), window, against), against)
    return max(fit, again, key=lambda one: one.score)


def priced(fit: FaultFit, against: Bank) -> FaultFit:
    """The fit with the price of a scale that is no power of two."""
    rare = fit.fault == "scale" and len(fit.rest) and not natural(fit)
    price = RARE * min(max(fit.nis / against.scale, 1.0), 2.0) if rare else 0.0
    return replace(fit, score=fit.score - price)


def dropped(run: FilterRun, frozen: Mask, window: Window, against: Bank) -> FaultFit:
    """The fit of a robot whose sensors gave no reading in the `frozen` rows."""
    freed = follow(without(run.log, frozen), run.robot, run.kit, run.kept)
    again = with_pushes(window.bank(freed), against=against)
    first = int(np.argmax(frozen & (run.log.t > window.end - window.seconds)))
    return replace(
        again,
        fault="dropped",
        way="frozen",
        onset=float(run.log.t[first]),
        size=float(frozen[first:].mean()),
        run=freed,
    )


def sharpened(run: FilterRun, fits: Sequence[FaultFit], window: Window, against: Bank) -> list[FaultFit]:
    """All fits, the likeliest of each fault that a log can be freed of by their exact score, the likeliest first."""
    plain = max((fit.score for fit in fits if fit.fault not in ("scale", "motor", "payload", "ramp")), default=0.0)
    offsets = [fit for fit in fits if fit.fault == "bias" and fit.score > plain - BEHIND][:MOST_BIASES]
    exact_ones = [*offsets, *(moved(run, [[fit]], window)[0] for fit in offsets if fit.way == "step")]
    exact_ones += [fit for fit in fits if fit.fault == "scale" and fit.score > fits[0].score - BEHIND][:MOST_SCALES]
    exact_ones += [fit for fit in fits if fit.fault == "scale" and not len(fit.rest)]
    exact_ones += [fit for fit in fits if fit.fault in ("weak", "delay")]
    exact_ones += [fit for fit in fits if fit.fault == "friction" and not len(fit.rest)]
    alone = sorted((fit for fit in fits if fit.fault == "motor" and not len(fit.rest)), key=lambda fit: fit.nis)
    exact_ones += alone[:MOST_MOTORS] + [fit for fit in fits if fit.fault == "motor" and len(fit.rest)][:1]
    stiff = [fit for fit in fits if fit.fault == "friction" and fit.size > 0 and len(fit.rest)][:1]
    rest = [fit for fit in fits if not any(fit is one for one in (*exact_ones, *stiff))]
    exact_ones += [moved(run, [[fit]], window)[0] for fit in stiff]
    exactly = [exact(run, fit, window, against) for fit in exact_ones]
    every = [priced(fit, against) for fit in (*exactly, *rest) if len(fit.rest)]
    every.sort(key=lambda fit: -fit.score)
    pushed: dict[tuple[str, str], FaultFit] = {}
    for fit in every:
        if fit.pushes and fit.fault in FREED and possible(fit, window.end):
            pushed.setdefault((fit.fault, fit.way), fit)
    likely = list(pushed.values())[:PUSHED]
    every = [beside_pushes(run, fit, window, against) if any(fit is one for one in likely) else fit for fit in every]
    return sorted(every, key=lambda fit: -fit.score)
