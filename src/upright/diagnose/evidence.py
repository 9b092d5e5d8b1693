"""All that is measured of a fall before anything is decided: hypotheses, the law, lost rows, pushes, demands."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.atomic import finite
from upright.control import Controller
from upright.diagnose.fall import (
    Fall,
    Motion,
    before,
    fall,
    falling,
    frozen_rows,
    limit,
    lost_rows,
    motion,
    stale_rows,
)  # fmt: skip
from upright.diagnose.faults import Bank, bank
from upright.diagnose.fits import Fit, Pushed, fits
from upright.diagnose.law import Law, by_file, references
from upright.diagnose.mend import Window, dropped, mended, searched, sharpened
from upright.diagnose.path import Track, tangent, track
from upright.errors import SpecMismatch
from upright.physics.dynamics import motor_damping, motor_gain
from upright.physics.linear import linearise
from upright.robots import Kit, Robot
from upright.signals import Log

Array = NDArray[np.float64]

SECONDS = 4.0  # [s] before the fall that are judged: a fault that shows itself earlier has not made it fall
EXCURSION = 1.2  # [s] before the fall in which a push or a demand must lie to be its cause
LOST = 20.0  # times their usual scale at which innovations say that the filter has lost the robot
FOREIGN = 20.0
"""Scale of the innovations before the fall from which the robot is not the one that was given."""

TIPPING = 0.35  # [rad] lean at the log's end that is a fall where the filter has lost the robot as well

LATEST = (0.2, 0.3, 0.5)  # [s] before the fall over which commands are compared with the law's


@dataclass(frozen=True, eq=False)
class Series:
    """The last seconds by sample: time [s], pitch [rad], pitch rate [rad/s], command over the largest, how much of the
    motors' reach is used up, and the mean of e²/s over the readings of a tenth of a second, which lies between `low`
    and `high` in 95 of 100 cases where the robot follows its model."""

    t: Array
    pitch: Array
    pitch_rate: Array
    command: Array
    reserve: Array
    nis: Array
    low: float = math.nan
    high: float = math.nan

    @classmethod
    def none(cls) -> Series:
        """Nothing to draw."""
        empty = np.zeros(0)
        return cls(empty, empty, empty, empty, empty, empty)

    def to_json(self) -> dict[str, Any]:
        """As lists, to six digits."""
        data = {f.name: getattr(self, f.name) for f in fields(self)}
        return {k: _rounded(v) if isinstance(v, np.ndarray) else finite(v) for k, v in data.items()}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Series:
        """The inverse of `to_json`."""
        arrays: dict[str, Any] = {
            k: np.array([math.nan if x is None else x for x in v]) for k, v in data.items() if isinstance(v, list)
        }
        band: dict[str, Any] = {k: math.nan if data[k] is None else float(data[k]) for k in ("low", "high")}
        return cls(**arrays, **band)


def _rounded(values: Array) -> list[float | None]:
    return [float(f"{v:.6g}") if math.isfinite(v) else None for v in values.tolist()]


@dataclass(frozen=True, eq=False)
class Evidence:
    """What was found. `fits` are the hypotheses, the likeliest first, `none` the one of pushes alone. A push is worth
    `tilt` [rad] of lean for each N s, and for each N s and m of height; `lean_limit` is the lean that no motor brings
    back. `law` is the recorded commands against the file's. `lost` is the share of periods without a row in the last
    second, and before it. `saturated` is the share of the last excursion with motors at their limit, `pegged` that of
    the last second; `stuck` says that no command changed in the last seconds.
    """

    found: Track
    fall: Fall | None
    usual: float
    misfit: float
    fits: tuple[Fit, ...]
    none: Fit | None
    tilt: tuple[float, float]
    lean_limit: float
    law: Law | None
    stable: bool | None
    lost: tuple[float, float]
    demand: float
    demanded_at: float
    top_speed: float
    driven: bool
    saturated: float
    pegged: float
    stuck: bool
    swings: float
    help: float
    battery: tuple[float, float]
    notes: tuple[str, ...]

    def worth(self, push: Pushed) -> float:
        """The lean [rad] that a push gives the robot."""
        return (self.tilt[0] + push.height * self.tilt[1]) * push.impulse


def gathered(
    log: Log, robot: Robot, kit: Kit, controller: Controller | None, show: Callable[[float], None]
) -> Evidence:
    """All evidence of one log; where it did not fall nothing but the track is looked at."""
    found = track(log, robot, kit)
    fallen = fall(found)
    window = _window(found, fallen.at if fallen else float(found.then[-1]))
    show(0.1)
    if fallen is None and not _lost(found, window):
        return _nothing(found, window.usual)
    first = _bank(found, window)
    show(0.4)
    all_fits = fits(first)
    if _unexplained(all_fits, first):
        all_fits += searched(found, window)
    if fallen is None:
        fallen = _seen_at_last(found, all_fits)
        if fallen is None:
            return _nothing(found, window.usual)
    all_fits = sharpened(found, all_fits, window, first)
    frozen = frozen_rows(found)
    recent = (log.t > fallen.at - 1.5) & (log.t <= fallen.at)
    if frozen[recent].sum() >= 2:
        stale = stale_rows(log) & (log.t >= log.t[np.flatnonzero(frozen)[0]] - 0.1)
        all_fits = sorted([*all_fits, dropped(found, stale, window, first)], key=lambda f: -f.score)
    show(0.9)
    return _evidence(found, fallen, window, first, all_fits, controller)


def _window(found: Track, end: float) -> Window:
    readings = (found.row >= 0) & np.isfinite(found.s)
    early = readings & (found.then < end - 1.0)
    part = early if early.sum() > 100 else readings
    usual = float(np.median(found.e[part] ** 2 / found.s[part])) / 0.455  # the median of χ² with one degree
    return Window(end, SECONDS, max(1.0, usual))


def _bank(found: Track, window: Window) -> Bank:
    part = before(found, window.end, window.seconds)
    return bank(part, tangent(part), (part.row >= 0) & np.isfinite(part.s), window.usual)


def _lost(found: Track, window: Window) -> bool:
    """Whether innovations at the log's end say that the filter is far from the robot."""
    last = (found.row >= 0) & np.isfinite(found.s) & (found.then > window.end - 0.4)
    return bool(last.any()) and float(np.mean(found.e[last] ** 2 / found.s[last])) > LOST * window.usual


def _seen_at_last(found: Track, all_fits: Sequence[Fit]) -> Fall | None:
    """The fall that shows itself where the likeliest fault is taken out of the log."""
    for fit in (f for f in all_fits if f.fault in ("bias", "late")):
        freed = mended(found, fit)
        seen = fall(freed) if freed is not None else None
        if seen is not None:
            return seen
    last = float(found.after[-1, 0])  # a log of late readings ends before they show the floor
    return Fall(float(found.then[-1]), 1 if last > 0 else -1) if abs(last) > TIPPING else None


def _unexplained(all_fits: Sequence[Fit], first: Bank) -> bool:
    """Whether anything is left to explain that pushes do not."""
    none = next(f for f in all_fits if f.fault == "none")
    return none.left > 1.5 * first.scale or max(f.score for f in all_fits) > none.score + 5


def _nothing(found: Track, usual: float) -> Evidence:
    nan = math.nan
    return Evidence(
        found, None, usual, nan, (), None, (nan, nan), nan, None, None, (nan, nan), nan, nan, nan, False, nan, nan,
        False, nan, nan, (nan, nan), (),
    )  # fmt: skip


def _evidence(
    found: Track, fallen: Fall, window: Window, first: Bank, all_fits: Sequence[Fit], controller: Controller | None
) -> Evidence:
    log, robot, end = found.log, found.robot, fallen.at
    moved, most = motion(found), limit(found.robot, found.kit, found.asked)
    mode, model = falling(robot), linearise(robot)
    none = next(f for f in all_fits if f.fault == "none")
    tilt = float(mode.w @ model.E[:, 0]), float(mode.w @ model.E[:, 1])
    law, stable, notes = _law(found, controller, end)
    demand, at = _demand(log, robot, end)
    share, swings, helped = _excursion(moved, mode.w, end)
    late = (moved.t > end - 1.0) & (moved.t <= end)
    pegged = float((np.abs(moved.command[late]) > 0.95).mean())
    stuck = not np.ptp(found.asked[(log.t > end - EXCURSION) & (log.t <= end)], axis=0).any()
    if window.usual > FOREIGN:
        notes = (*notes, _foreign(window.usual))
    top = motor_gain(robot) * most / motor_damping(robot) * robot.wheel_radius if motor_damping(robot) else math.inf
    return Evidence(
        found, fallen, window.usual, float(np.mean(first.y**2)), tuple(all_fits), none, tilt,
        abs(mode.b) * most / mode.pole, law, stable,
        (lost_rows(log, found.kit.period, end - 1, end), lost_rows(log, found.kit.period, log.t[0], end - 1)),
        demand, at, top, bool(np.ptp(references(log)) > 0), share, pegged, stuck, swings, helped, _battery(log, end),
        notes,
    )  # fmt: skip


def _foreign(usual: float) -> str:
    return (
        "the robot that was given does not follow this log even before the fall: innovations are "
        f"{math.sqrt(usual):.0f} times what they should be; calibrate it first (`upright calibrate`), or name the "
        "right one"
    )


def _law(found: Track, controller: Controller | None, end: float) -> tuple[Law | None, bool | None, tuple[str, ...]]:
    """The law over the shortest stretch before the fall that shows it best, and whether its loop is stable."""
    if controller is None:
        return None, None, ()
    try:
        laws = [by_file(found, controller, end - seconds, end) for seconds in LATEST]
    except SpecMismatch as error:
        return None, None, (f"the controller was not replayed: {error}",)
    best = max(laws, key=lambda law: law.share)
    stable = _stable(controller, found.robot, found.kit)
    if best.known or best.share > 0.9999:  # a gain that was wrong from earlier on
        return best, stable, ()
    note = "the controller's file does not give the commands of this log, not even before the trouble"
    return best, stable, (note,)


def _stable(controller: Controller, robot: Robot, kit: Kit) -> bool | None:
    from upright.certify.certificate import linear_margins
    from upright.errors import UprightError

    try:
        margins: Any = linear_margins(controller, robot, kit)
    except UprightError:
        return None
    return None if margins is None else bool(margins.stable)


def _demand(log: Log, robot: Robot, end: float) -> tuple[float, float]:
    """The largest sudden change of the wanted speed [m/s] before the fall, and when it came."""
    speed = references(log)[:, 3] * robot.wheel_radius
    late = np.flatnonzero((log.t > end - 1.3 * EXCURSION) & (log.t <= end))
    if len(late) < 2:
        return 0.0, math.nan
    jumps = np.abs(np.diff(speed[late]))
    i = int(np.argmax(jumps))
    return float(jumps[i]), float(log.t[late[i + 1]])


def _excursion(moved: Motion, w: Array, end: float) -> tuple[float, float, float]:
    """Of the last excursion: share of saturated samples, changes of the command's sign a second before, and the
    median of what the motors gave over what it would have taken to stop the fall, where they had more to give."""
    inside = moved.t <= end
    xi = moved.states[inside] @ w
    start = len(xi) - 1
    while start > 0 and np.sign(xi[start - 1]) == np.sign(xi[-1]):
        start -= 1
    rows = np.arange(start, len(xi))
    rows = rows[np.abs(xi[rows]) > 0.1 * np.abs(xi[rows]).max()]
    late = inside & (moved.t > end - EXCURSION)
    swings = float((np.diff(np.sign(moved.command[late])) != 0).sum()) / EXCURSION
    if not len(rows):
        return math.nan, swings, math.nan
    full = np.abs(moved.command[rows]) > 0.98
    free = rows[~full]
    helped = float(np.median(moved.help[free] / np.maximum(moved.reserve[free], 1e-6))) if len(free) >= 4 else math.nan
    return float(full.mean()), swings, helped


def _battery(log: Log, end: float) -> tuple[float, float]:
    """The battery's voltage before and in the last half second [V], NaN where it was not logged."""
    if "sensor/battery" not in log:
        return math.nan, math.nan
    volts = log["sensor/battery"]
    early, late = volts[log.t < end - 2.0], volts[(log.t > end - 0.5) & (log.t <= end)]
    return tuple(float(np.nanmedian(v)) if len(v) and np.isfinite(v).any() else math.nan for v in (early, late))  # type: ignore[return-value]


def series_of(seen: Evidence) -> Series:
    """The last seconds, or the whole log's last ones where it did not fall."""
    found = seen.found
    end = seen.fall.at if seen.fall else float(found.then[-1])
    moved = motion(found)
    keep = (moved.t > end - SECONDS) & (moved.t <= end + 0.2)
    readings = (found.row >= 0) & np.isfinite(found.s)
    t, ratio = found.then[readings], found.e[readings] ** 2 / found.s[readings]
    sums, edges = np.concatenate([[0.0], np.cumsum(ratio)]), np.searchsorted(t, moved.t[keep])
    back = np.searchsorted(t, moved.t[keep] - 0.1)
    nis = (sums[edges] - sums[back]) / np.maximum(edges - back, 1)
    low, high = _band(float(np.median(edges - back)) if keep.any() else 1.0)
    pitch, rate = moved.states[keep, 0], moved.states[keep, 1]
    return Series(moved.t[keep], pitch, rate, moved.command[keep], moved.reserve[keep], nis, low, high)


def _band(count: float) -> tuple[float, float]:
    """Between which the mean of so many squares of standard normal numbers lies in 95 of 100 cases."""
    from scipy.special import chdtri

    n = max(count, 1.0)
    return float(chdtri(n, 0.975)) / n, float(chdtri(n, 0.025)) / n
