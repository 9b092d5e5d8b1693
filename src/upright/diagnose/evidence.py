"""All that is measured of a fall before anything is decided: fault fits, commands, lost rows, pushes, demands."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from upright.arrays import Array, Mask
from upright.checkup.finding import FEWEST
from upright.checkup.wheels import on_its_wheels
from upright.control import Controller
from upright.diagnose.beyond import Leftover, goes_beyond, jam_or_stuck, leftover
from upright.diagnose.causes import foreign, noisy
from upright.diagnose.clock import on_even_clock, thinned
from upright.diagnose.fall import (
    Authority,
    StuckSensor,
    authority,
    blind,
    fall_time,
    falling,
    far_from_zero,
    frozen_rows,
    half_swing,
    held_command,
    last_fall,
    limit,
    lost_lately,
    pace,
    stale_rows,
    stuck_sensor,
    wheel_rates,
    worked_until,
)
from upright.diagnose.fault_fits import CORRELATED, FaultFit, fits, gainable, spared, with_commands
from upright.diagnose.forces import forced, refined
from upright.diagnose.hidden import hidden_fall, mis_scaled, mis_scaled_angles, sooner, unseen
from upright.diagnose.innovations import FilterRun, follow, followed_on
from upright.diagnose.joint import each_alone, pairs_settled, settled
from upright.diagnose.law import CommandMatch, matched, references
from upright.diagnose.measured import Demand, MotorUse, Toppling
from upright.diagnose.pairs import CONTRIBUTES, Pair, contributing, paired
from upright.diagnose.pushed import LEAVES, with_sudden_pushes
from upright.diagnose.remedy import Window, dropped, searched, sharpened, timed_out
from upright.diagnose.signatures import Bank
from upright.diagnose.sizes import possible
from upright.diagnose.slip import slid_at
from upright.diagnose.supply import as_shown, with_supply
from upright.diagnose.thrown import Throw, thrown
from upright.diagnose.usual import FOREIGN, calm_of, quiet_of, window_of
from upright.errors import SpecMismatch, UprightError
from upright.pages import Message, Say
from upright.physics.dynamics import motor_damping, motor_gain
from upright.physics.linear import linearise
from upright.progress import Progress
from upright.robots import Kit, Robot
from upright.robots.kit import STOP
from upright.signals import Log

EXCURSION = 1.2  # [s] of a quick robot before the fall, in which a push or a demand must lie to be its cause
EXPLAINED = 1.1  # NIS over the calm one, up to which nothing is left to explain
LOST, LOST_SECONDS = 20.0, 0.4  # times the ordinary NIS, and for how long [s], of a filter that has lost the robot
UNEXPLAINED, BETTER = 20.0, 5.0  # nats that pushes leave to other faults to explain, or by which these are better
SEARCHED_AGAIN = 100.0  # nats that the likeliest leaves to a search beside sudden pushes
REPEATING = 1.5  # [s] before the fall in which two repeated readings make dropped samples a hypothesis
LAST_SECONDS = (0.2, 0.3, 0.5)  # [s] before the fall over which commands are compared with the file's
SAME = 0.9999  # fraction of the commands' difference that a gain explains where it was wrong from the start
UPRIGHT = 0.35  # [rad] up to which a lean is one that motors bring back
LIMIT, AT_LIMIT = 0.95, 0.98  # of the largest command: at the limit for a second's count, and where it is to be sure
SMALL_EXCURSION = 0.1  # of the last excursion's peak, below which its rows do not count
LEAST_NOISE = 0.3  # NIS: less is that of a robot at rest, whose readings stand still at one step
KNOWN_TO = 0.03  # of its size, to which what a robot does is known: numbers in owners' files are 1 to 4 % off
ALIKE = 0.1  # [s] in which such errors are alike
FEWEST_FREE = 4  # rows with motors below their limit, for a median of how they helped


@dataclass(frozen=True, eq=False, kw_only=True)
class Evidence:
    """What was measured of a fall up to the time `fell_at` [s]; programs stop their motors at `stopped_at` [s].

    `fits` are the hypotheses, the likeliest first, `pairs` two faults at once, and `left` is what the likeliest leaves,
    where it leaves something. `ordinary` is the scale of the innovations before the fall, `calm` that of its calmer
    seconds, `nis` in the window, whose readings are at the times `then` [s].
    A `stuck` sensor has the scores of a jammed wheel and of a dumb encoder, and the NIS that the better one leaves, in
    `jam`. All was sound until the commands made the wheels slide at `slid` [s] (NaN: not so): nothing later is judged.
    `match` compares the recorded commands with the file's, whose loop is `stable`. `lost` is the fraction of periods
    without a row since a time [s] in the last second, before it, and that time; `battery` the voltage [V] before and
    at the fall. A blow that shows in the readings alone is a `throw`. `demand` is None where no references were logged.
    """

    run: FilterRun
    fell_at: float
    ordinary: float
    calm: float
    nis: float
    then: Array
    fits: tuple[FaultFit, ...]
    pairs: tuple[Pair, ...]
    left: Leftover | None
    stuck: StuckSensor | None
    jam: tuple[float, float, float] | None
    toppling: Toppling
    motors: MotorUse
    match: CommandMatch | None
    stable: bool | None
    lost: tuple[float, float, float]
    demand: Demand | None
    battery: tuple[float, float]
    throw: Throw | None
    notes: tuple[Say, ...]
    slid: float = math.nan
    stopped_at: float = math.nan

    @cached_property
    def weights(self) -> Array:
        """What each reading counts: the robot is known to `KNOWN_TO`, so that each `ALIKE` seconds may be wrong by that
        part of what it did in them, by one error that all their readings share."""
        if not len(self.then):  # nothing to be read in the window of a log of a few rows
            return np.ones(0)
        run = self.run.only(self.run.readings & (self.run.clock >= self.then[0]) & (self.run.clock <= self.then[-1]))
        blocks = np.floor((run.clock - self.then[0]) / ALIKE).astype(int)
        did = np.bincount(blocks, run.whitened**2)
        weights = np.ones(len(self.pushes_only.rest))
        weights[: len(blocks)] = self.calm / (self.calm + KNOWN_TO**2 * did[blocks])
        return weights

    def misfit(self, one: FaultFit | Leftover) -> float:
        """The NIS that a hypothesis leaves, by the readings' weights; the plain one of a log of other readings."""
        if len(one.rest) != len(self.weights) or not len(one.rest):
            return one.nis
        return float(np.average(one.rest**2, weights=self.weights))

    @cached_property
    def noise(self) -> float:
        """The NIS that nothing explains: the least that any hypothesis leaves."""
        every = (*self.fits, *(pair.second for pair in self.pairs))
        return max(LEAST_NOISE, min(self.misfit(one) for one in every))

    def nats(self, one: FaultFit | Leftover) -> float:
        """The score of a hypothesis by the noise of this log [nats, up to a constant of it]."""
        plain = len(self.weights) / CORRELATED / 2 * math.log(one.nis + self.ordinary)
        return one.score + plain - self.weights.sum() / CORRELATED * math.log(self.misfit(one) + self.noise)

    @property
    def excursion(self) -> float:
        """How long [s] before the fall a push or a demand may be its cause."""
        return EXCURSION * pace(self.run.robot)

    @cached_property
    def pushes_only(self) -> FaultFit:
        """The hypothesis of pushes without any fault."""
        return _pushes_only(self.fits)


def _pushes_only(several: Sequence[FaultFit]) -> FaultFit:
    return next(fit for fit in several if fit.fault == "none")


def gather(
    log: Log, robot: Robot, kit: Kit, controller: Controller | None, show: Progress
) -> tuple[FilterRun, Evidence | None]:
    """The filter along a log, and all evidence of its fall, one of the integrated motion; None where it did not fall.
    Where that motion shows no fall, a filter that is lost may, if it is of this robot."""
    kit = with_supply(kit, log, robot)
    throw, fallen = thrown(log, robot, kit, float(log.t[-1])), last_fall(log) is not None
    gone = throw is not None and throw.lost
    unseeing = blind(stuck_sensor(log, kit, float(log.t[-1])))  # nothing balances while its gyro stands still
    falls = fallen or gone or unseeing
    whole = on_even_clock(follow(log, robot, kit) if falls else followed_on(on_its_wheels(log)[0], robot, kit))
    log, fell_at, run = whole.log if falls else log, fall_time(whole), thinned(whole)
    stopped_at = fall_time(whole, STOP)  # None of a fall that shows otherwise: then programs stop where it ends
    if throw is not None and gone and (fell_at is None or fell_at < throw.start):
        fell_at, stopped_at, fallen = float(log.t[-1]), None, True
    if fell_at is None and unseeing:
        fell_at, fallen = float(run.t[-1]), True
    window = window_of(run, float(run.t[-1]) if fell_at is None else fell_at)
    show(0.1)
    if not fallen and fell_at is None and window.usual <= FOREIGN and not _lost(run, window):
        fell_at = unseen(run, window)
        window = window if fell_at is None else window_of(run, fell_at)
    if not fallen and (window.usual > FOREIGN or (fell_at is None and not _lost(run, window))):
        return whole, None
    still = stuck_sensor(log, kit, window.end)
    foreign = blind(still) or (window.usual > FOREIGN and still is None)  # no cause will rest on the fits
    bank, several = _beside_pushes(run, window, foreign)
    scaled = mis_scaled(run, window) if not foreign and _unexplained(several, bank, quiet_of(run, window)) else []
    if not foreign and (true := sooner(run, [*several, *scaled], window)) is not None:
        fell_at, stopped_at, window = true, None, window_of(run, true)
        bank, several = _beside_pushes(run, window, foreign)
    show(0.4)
    if not foreign and _unexplained(several, bank, quiet_of(run, window)):
        several += [*searched(run, window), *with_commands(bank, several), *scaled, *mis_scaled_angles(run, window)]
    if fell_at is None:
        fell_at = hidden_fall(run, several)
        if fell_at is None:
            return whole, None
    several = sharpened(run, several, window, bank)
    if not foreign and _unexplained(several, bank, quiet_of(run, window)):
        several = forced(run, several, window, bank)
        again = gainable(bank, several[0].nis, quiet_of(run, window)) > SEARCHED_AGAIN
        if again or several[0].nis > LEAVES * calm_of(run, window):
            several += with_sudden_pushes(run, window, bank, several[0].score)
            several.sort(key=lambda fit: -fit.score)
        several = settled(run, several, window, bank)
    frozen, t = frozen_rows(whole), whole.log.t  # of the part of the log that was filtered
    if not foreign and frozen[(t > fell_at - REPEATING) & (t <= fell_at)].sum() >= 2:
        stale = stale_rows(whole.log) & (t >= t[np.flatnonzero(frozen)[0]] - 0.1)
        several = sorted([*several, dropped(run, stale, window, bank)], key=lambda f: -f.score)
    slid = None if foreign or timed_out() else _sound_until(run, window, several)
    window, bank, several = slid or (window, bank, several)
    show(0.9)
    evidence = _evidence(whole, run, fell_at, window, bank, several, controller)
    stopped_at = fell_at if stopped_at is None else stopped_at
    return whole, replace(evidence, stopped_at=stopped_at, slid=window.end if slid else math.nan)


def _beside_pushes(run: FilterRun, window: Window, foreign: bool) -> tuple[Bank, list[FaultFit]]:
    """A window's bank and fits: pushes alone by the equations of motion, since linear ones leave more."""
    several = fits(bank := window.bank(run, pushes_only=foreign))
    others = [one for one in several if one.fault != "none"]
    return bank, several if foreign else [*others, refined(run, _pushes_only(several), window, bank)]


def _sound_until(
    run: FilterRun, window: Window, several: Sequence[FaultFit]
) -> tuple[Window, Bank, list[FaultFit]] | None:
    """The part of the log before the commands made the wheels slide, its bank and fits, where pushes alone explain it,
    while a blow came then, or what nothing explains; None where it is not so."""
    at, throw = slid_at(run, window.end - window.seconds, window.end), thrown(run.log, run.robot, run.kit, window.end)
    best = next(fit for fit in several if possible(fit, window.end))
    explained = best.nis < LEAVES * calm_of(run, window)
    if at is None or (explained and (throw is None or throw.start < at)) or (run.log.t < at).sum() < FEWEST:
        return None
    part = window_of(run, at)
    sound = fits(before := part.bank(run, pushes_only=False))
    return (part, before, sound) if not _unexplained(sound, before, part.usual) else None


def _lost(run: FilterRun, window: Window) -> bool:
    """Whether innovations at the log's end show that the filter is far from the robot."""
    last = run.only(run.t > window.end - LOST_SECONDS).whitened
    return bool(len(last)) and float(np.mean(last**2)) > LOST * window.usual


def _unexplained(several: Sequence[FaultFit], bank: Bank, quiet: float) -> bool:
    """Whether there is time to explain what pushes leave, beyond the NIS of a quiet second."""
    none = _pushes_only(several)
    return not timed_out() and (
        gainable(bank, none.nis, quiet) > UNEXPLAINED or max(f.score for f in several) > none.score + BETTER
    )


def _evidence(
    whole: FilterRun,
    run: FilterRun,
    end: float,
    window: Window,
    bank: Bank,
    several: Sequence[FaultFit],
    controller: Controller | None,
) -> Evidence:
    log, robot = whole.log, run.robot
    most, mode, model = limit(robot, as_shown(run.kit, log, robot), run.asked), falling(robot), linearise(robot)
    match, stable, notes = _match(whole, controller, end)
    stuck = stuck_sensor(log, run.kit, end)
    if stuck and "gyro" in stuck.channel and not stuck.clipped:
        stuck = replace(stuck, beyond=far_from_zero(stuck, run.kit) and goes_beyond(run, stuck, end))
    jam = jam_or_stuck(run, stuck, window, bank) if stuck and "encoder" in stuck.channel else None
    met = [fit for fit in several if possible(fit, end)]
    calm, quiet = calm_of(run, window), quiet_of(run, window)
    known, best = not stuck and window.usual <= FOREIGN, met[0]
    more = best.nis > EXPLAINED * calm or (best.fault != "none" and best.pushes)  # that a fault leaves
    gain = gainable(bank, best.nis, quiet) + spared(bank, best.spent)
    pairs: list[Pair] = []
    if known and gain > CONTRIBUTES and not timed_out():  # else no pair explains more
        pairs = pairs_settled(run, paired(run, met, window, bank), best.score, window, bank)
        several = sorted([*several, *each_alone(run, pairs, best.score, window, bank)], key=lambda fit: -fit.score)
        met = [fit for fit in several if possible(fit, end)]
        pairs = contributing(run, pairs, met[0].score, window, bank)
    if window.usual > FOREIGN:
        notes = (*notes, foreign(window.usual, robot))
    elif robot.noise:
        notes = (*notes, noisy(robot.noise))
    left = leftover(met, window, bank) if known and (more or pairs) else None
    per_impulse, per_height, *_ = (mode.w @ model.E).tolist()
    return Evidence(
        run=run, fell_at=end, ordinary=window.usual, calm=calm,
        nis=float(np.mean(bank.y**2)), then=bank.then, fits=tuple(several),
        stuck=stuck, jam=jam, pairs=tuple(pairs), left=left,
        toppling=Toppling(per_impulse, per_height, abs(mode.b) * most / mode.pole, mode.pole),
        motors=_motor_use(whole, mode.w, end), match=match, stable=stable,
        lost=lost_lately(log, run.kit.period, end),
        demand=_demand(log, robot, most, end), battery=_battery(log, end), throw=thrown(log, robot, run.kit, end),
        notes=notes,
    )  # fmt: skip


def _match(
    run: FilterRun, controller: Controller | None, end: float
) -> tuple[CommandMatch | None, bool | None, tuple[Say, ...]]:
    """The comparison over the time before the fall that shows it best, and whether the file's loop is stable."""
    if controller is None:
        return None, None, ()
    end = min(end, worked_until(run.log.t, run.asked.sum(axis=1)))
    try:
        several = [matched(run, controller, end - seconds, end) for seconds in LAST_SECONDS]
    except SpecMismatch as error:
        return None, None, (Say("The controller was not replayed: {error}", error=Message(error)),)
    best = max(several, key=lambda match: match.explained)
    stable = _stable(controller, run.robot, run.kit)
    if best.known or best.explained > SAME:
        return best, stable, ()
    return best, stable, (Say("The controller's file does not give the commands of this log, even before the fault."),)


def _stable(controller: Controller, robot: Robot, kit: Kit) -> bool | None:
    from upright.loops.analysis import ROUNDED
    from upright.loops.loop import robot_loop

    try:
        radius = abs(robot_loop(controller, robot, kit).poles()[0])
    except UprightError:
        return None
    return bool(radius < 1 - ROUNDED)


def _demand(log: Log, robot: Robot, most: float, end: float) -> Demand | None:
    """The largest sudden change of the reference speed before the fall."""
    if not any(name.startswith("reference/") for name in log.channels):
        return None
    speeds, excursion = references(log)[:, 3] * robot.wheel_radius, EXCURSION * pace(robot)
    top = _top_rate(robot, most) * robot.wheel_radius
    fastest = float(np.abs(speeds[(log.t > end - 2 * excursion) & (log.t <= end)]).max(initial=0.0))
    rows = np.flatnonzero((log.t > end - 1.3 * excursion) & (log.t <= end))
    if len(rows) < 2:
        return Demand(0.0, math.nan, top, fastest)
    jumps = np.abs(np.diff(speeds[rows]))
    i = int(np.argmax(jumps))
    return Demand(float(jumps[i]), float(log.t[rows[i + 1]]), top, fastest)


def _motor_use(run: FilterRun, w: Array, end: float) -> MotorUse:
    """Of the last excursion, which begins where the falling mode `w` last changed its sign."""
    motors, log = authority(run), run.log
    inside = motors.t <= end
    xi = motors.states[inside] @ w
    start = len(xi) - 1
    while start > 0 and np.sign(xi[start - 1]) == np.sign(xi[-1]):
        start -= 1
    rows = np.arange(start, len(xi))
    rows = rows[np.abs(xi[rows]) > SMALL_EXCURSION * np.abs(xi[rows]).max()]
    full = np.abs(motors.command[rows]) > AT_LIMIT
    free, excursion = rows[~full], EXCURSION * pace(run.robot)
    helped = motors.help[free] / np.maximum(motors.reserve[free], 1e-6)
    recent = motors.command[inside & (motors.t > end - excursion)]
    second = motors.command[inside & (motors.t > end - 1.0)]
    last = run.asked[(log.t > end - excursion) & (log.t <= end)]  # motors that are off wait on the floor
    held = held_command(run, motors, end, excursion)
    if held is not None:  # a law whose command is at its limit holds it, and how it steers at a limit of its own
        at = np.abs(run.asked[int(np.searchsorted(log.t, held[0]))])
        held = None if (at > LIMIT * limit(run.robot, run.kit, run.asked)).any() else held
    return MotorUse(
        held=held,
        saturated=float(full.mean()) if len(rows) else math.nan,
        pegged=float((np.abs(second) > LIMIT).mean()) if len(second) else 0.0,
        stuck=not np.ptp(last, axis=0).any() and bool(last.any()),
        swings=float((np.diff(np.sign(recent)) != 0).sum()) / excursion,
        help=float(np.median(helped)) if len(free) >= FEWEST_FREE else math.nan,
        speed=_speed(run, motors, inside & (motors.t > end - 2 * excursion)),
        half_swing=half_swing(motors, falling(run.robot).pole, end),
    )


def _speed(run: FilterRun, motors: Authority, rows: Mask) -> float:
    """The largest rate in these rows of wheels that run after a lean, while the robot was upright, over that without
    torque: wheels that run the other way have all the torque that stops the fall."""
    rates = wheel_rates(run.log, motors.t)
    after = rows & (np.abs(motors.states[:, 0]) < UPRIGHT) & (rates * motors.needed > 0)
    top = _top_rate(run.robot, limit(run.robot, run.kit, run.asked))
    return float(np.abs(rates[after]).max(initial=0.0)) / top if top > 0 else 0.0  # of motors that were off: nothing


def _top_rate(robot: Robot, most: float) -> float:
    """The rate of a wheel [rad/s] at which commands of `most` give no torque; infinite where nothing damps it."""
    damping = motor_damping(robot)
    return motor_gain(robot) * most / damping if damping else math.inf


def _battery(log: Log, end: float) -> tuple[float, float]:
    """The battery's voltage before and in the last half second [V], NaN where it was not logged."""

    def median(rows: Mask) -> float:
        volts = log["sensor/battery"][rows] if "sensor/battery" in log else np.zeros(0)
        return float(np.nanmedian(volts)) if np.isfinite(volts).any() else math.nan

    return median(log.t < end - 2.0), median((log.t > end - 0.5) & (log.t <= end))
