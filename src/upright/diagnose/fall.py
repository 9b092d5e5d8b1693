"""Whether and when a robot fell, and the seconds before: lean, the motors' authority, lost rows, repeated readings."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from upright.arrays import Array, Mask
from upright.checkup.finding import FALLING, Segment
from upright.checkup.poses import NEAR_FLOOR, segments
from upright.checkup.wheels import record_of
from upright.control.reach import largest_command
from upright.diagnose.innovations import FULL_RANGE, FilterRun
from upright.logs.raw import RATES
from upright.logs.recording import commanded
from upright.pages import Say
from upright.physics.linear import linearise_rolling
from upright.robots import Kit, Robot, Sensor
from upright.robots.kit import STOP
from upright.signals import Log

LEANING = 0.7  # [rad] up to which the seconds before a fall are examined: short of the stop of every program
LOST_END = 0.2  # [s] before the log's end at which the filter has stopped where the robot toppled
PLAUSIBLE = 0.4  # [rad] of the filter's pitch where a fall begins: beyond, the filter has lost the robot
STUCK = 0.2  # [s] up to the fall, of one and the same reading: a moving robot repeats itself a few times at most
STUCK_STEPS, STUCK_MOVES = 20, 0.4  # steps, and [rad or rad/s], by which another sensor moves meanwhile
DRIVING = 0.08  # [m/s] from which a robot can drive into something
RUN_UP, CONTACT, HELD = 0.2, 0.03, 0.1  # [s] before a contact, of its beginning, and after it, that are looked at
GIVES, THROWN = 0.6, 0.6  # of the way that the robot would have gone on: how far it may go, and be thrown back
USUALLY_HELD = 3.0  # times the longest that a command was held before: a loop may do so near rest
ANSWERED = 0.1  # of the largest command, by which what stops the fall changes: any law that balances answers that
LAST_SWINGS, CLEARLY = 12.0, 0.05  # e-folds before the fall whose swings count, and of the largest command, one
SAME_DUTY = 1e-9  # [1] between two duties that are the same
QUICK = 4.75  # [1/s] of falling, from which the times of this package in seconds hold; a slower robot has more
CLIPPED_GRAINS = 5  # steps of a reading from zero, below which rows repeat each other by chance
CLIPPED_ROWS = 3  # one after the other, in which a reading was at the end of its range before
RATE_OVER = 0.05  # [s] of a wheel's rate: a step of one degree is then 0.35 rad/s
STILL_GRAINS = 2  # encoder steps that wheels must turn before a repeated reading cannot be true


def fall_time(run: FilterRun, level: float = LEANING) -> float | None:
    """When the lean passed `level` [rad] for the last time [s] before the log ends or the robot lies; None without a
    fall.

    Either the integrated motion falls (`doctor.poses`), whatever its shape, or the filter's pitch ends beyond `STOP`.
    """
    fallen = falling_lean(run)
    if fallen is not None:
        t, lean = fallen
        out = np.abs(lean) > min(level, NEAR_FLOOR * float(np.abs(lean).max()))  # of a gyro whose scale is wrong
        return float(t[np.argmax(out)])
    pitch = run.after[:, 0]
    lost = run.t[-1] < run.log.t[-1] - LOST_END
    if abs(pitch[-1]) < STOP and not lost:
        return None
    upright = np.flatnonzero(np.abs(pitch) < level)
    return float(run.t[upright[-1]])


def falling_lean(run: FilterRun) -> tuple[Array, Array] | None:
    """Times [s] from where the last fall begins, and the lean [rad] that the gyro integrates to from there; None where
    the integrated motion shows no fall."""
    fall = last_fall(run.log)
    if fall is None:
        return None
    first = int(np.searchsorted(run.log.t, fall.start))
    t = run.log.t[first:]
    rate = gyro(run.log)[first:]
    angle = np.concatenate([[0.0], np.cumsum(rate[:-1] * np.diff(t))])
    return t, angle + _lean_at(run, fall.start)


def last_fall(log: Log) -> Segment | None:
    """The last fall of a log by its integrated motion, with the swing in which it begins: the filter still holds."""
    falls = [segment for segment in segments(record_of(log), swung=True) if segment.kind == FALLING]
    return falls[-1] if falls else None


def against(log: Log, fall: Segment) -> Say | None:
    """What worked against its purpose in a fall: wheels that turn against their commands, or commands that
    drive away from the fall."""
    record, prefix = record_of(log), commanded(log)
    rows = (log.t >= fall.start) & (log.t < fall.stop)
    if not prefix:
        return None
    every = (log[f"{prefix}/left"] + log[f"{prefix}/right"]) / 2
    rows &= log.t <= worked_until(log.t, every)
    command = every[rows]
    rate = log["sensor/gyro"][rows]
    wheel = sum(record[f"sensor/encoder_{side}"][rows] for side in ("left", "right")) / 2 + np.cumsum(rate) * log.period
    if len(command) < 3:
        return None
    turned = float((command - command[0]) @ (wheel - wheel[0]))
    caught = float(command @ np.cumsum(rate))  # driving forward catches a forward fall
    if turned < 0:
        return Say("The wheels turn against their commands: a motor or both encoders count backwards.")
    if caught < 0:
        return Say("The commands drive away from the fall: the gyro or the controller has the wrong sign.")
    return None


def worked_until(t: Array, commands: Array) -> float:
    """When [s] commands (rows,) last were any: a program stops its motors where its robot has fallen."""
    return float(t[commands != 0].max(initial=-math.inf))


def gyro(log: Log) -> Array:
    """The gyro without its usual offset [rad/s], missing readings filled in."""
    rate = log["sensor/gyro"]
    there = np.isfinite(rate)
    return np.interp(log.t, log.t[there], rate[there]) - float(np.median(rate[there]))


def _lean_at(run: FilterRun, t: float) -> float:
    """The filter's pitch at t, where it is plausible."""
    i = min(int(np.searchsorted(run.t, t)), len(run.t) - 1)
    return float(np.clip(run.after[i, 0], -PLAUSIBLE, PLAUSIBLE))


@dataclass(frozen=True)
class Falling:
    """The robot's falling mode ξ = wᵀx with ξ̇ = λ ξ + b (u_l + u_r)/2: `pole` λ [1/s], `w` (6,), and `b`."""

    pole: float
    w: Array
    b: float


def falling(robot: Robot) -> Falling:
    """The falling mode, in which pitch counts one."""
    model = linearise_rolling(robot)
    values, vectors = np.linalg.eig(model.A.T)
    index = int(np.argmax(np.real(values)))
    w = np.real(vectors)[:, index]
    w = w / w[model.states.index("pitch")]
    return Falling(float(np.real(values)[index]), w, float((w @ model.B).sum()))


def pace(robot: Robot) -> float:
    """How many times more slowly than a quick robot this one falls; 1 for all quick ones."""
    return max(1.0, QUICK / falling(robot).pole)


@dataclass(frozen=True, eq=False)
class Authority:
    """The motors' authority by sample: time [s], mean command over its limit, the command that stops the fall over it
    (`needed`; beyond 1 is lost), how they `help` (1: all they can, −1: the wrong way), and the states."""

    t: Array
    command: Array
    needed: Array
    help: Array
    states: Array

    @property
    def reserve(self) -> Array:
        """The size of what is needed."""
        return np.abs(self.needed)


def authority(run: FilterRun) -> Authority:
    """What the robot did, and what its motors could still do."""
    commands = run.row < 0
    states = run.after[commands][:, :6]
    sample = run.sample[commands]
    mode = falling(run.robot)
    most = _most(run)[sample]
    command = run.asked[sample].mean(axis=1) / most
    xi = states @ mode.w
    needed = -xi * mode.pole / (mode.b * most)
    help_ = -np.sign(xi) * np.sign(mode.b) * np.clip(command, -1, 1)
    return Authority(run.t[commands], command, needed, help_, states)


def _most(run: FilterRun) -> Array:
    """The largest command (samples,): `limit`, and no more than the battery shows."""
    most = np.full(len(run.asked), limit(run.robot, run.kit, run.asked))
    volts = run.log["sensor/battery"] if "sensor/battery" in run.log and run.robot.command_unit == "V" else most
    return np.where(volts > 0, np.fmin(volts, most), most) if len(volts) == len(most) else most


def limit(robot: Robot, kit: Kit, asked: Array) -> float:
    """The largest command: the kit's, or the largest that was asked where the kit has no limit."""
    most = largest_command(robot, kit)
    return most if math.isfinite(most) else float(np.abs(asked).max())


def wheel_rates(log: Log, t: Array) -> Array:
    """The mean rate of both wheels against the body [rad/s] over `RATE_OVER` up to times t [s], as the encoders show
    it: the filter's follows every single step of them."""
    record = record_of(log)
    several: list[Array] = []
    for name in (n for n in RATES if n in record):
        there = np.isfinite(record[name])
        now, before = (np.interp(t - past, log.t[there], record[name][there]) for past in (0.0, RATE_OVER))
        several.append((now - before) / RATE_OVER)
    return np.mean(several, axis=0) if several else np.zeros(len(t))


def lost_rows(log: Log, period: float, start: float, stop: float) -> float:
    """The fraction of periods between two times [s] that have no row: the loop did not run."""
    t = log.t[(log.t >= start) & (log.t <= stop)]
    if len(t) < 3:
        return 0.0
    missing = np.maximum(np.round(np.diff(t) / period) - 1, 0.0)
    return float(missing.sum() / (missing.sum() + len(t) - 1))


def lost_lately(log: Log, period: float, end: float) -> tuple[float, float, float]:
    """The fraction of periods without a row from the first of them in the last second before `end` [s] on, but over
    half a second at least, the fraction before, and that time [s]."""
    t = log.t[(log.t >= end - 1.0) & (log.t <= end)]
    gaps = np.flatnonzero(np.diff(t) > 1.5 * period)
    since = min(float(t[gaps[0]]), end - 0.5) if len(gaps) else end - 1.0
    return lost_rows(log, period, since, end), lost_rows(log, period, log.t[0], since), since


def stale_rows(log: Log) -> Mask:
    """Rows in which every sensor repeats its last reading exactly."""
    names = [n for n in log.channels if n.startswith("sensor/") and "battery" not in n]
    readings = np.column_stack([log[n] for n in names])
    return np.concatenate([[False], (np.diff(readings, axis=0) == 0).all(axis=1)])


def frozen_rows(run: FilterRun) -> Mask:
    """Stale rows in which the wheels turned by more than `STILL_GRAINS` encoder steps."""
    log = run.log
    stale = stale_rows(run.log)
    commands = run.row < 0
    turned = np.zeros(len(log))
    turned[run.sample[commands]] = np.abs(run.after[commands, 3] - run.after[commands, 1]) * log.period
    grain = max((s.quantum for n, s in run.kit.sensors.items() if "encoder" in n), default=0.0)
    return stale & (turned > STILL_GRAINS * grain)


@dataclass(frozen=True)
class StuckSensor:
    """A sensor, by its channel, that gave one and the same `reading` from `start` [s] on to the fall, while others
    moved; `clipped` where it stood there before and never went beyond, `beyond` where the body turns faster the same
    way: both are the end of its range."""

    channel: str
    reading: float
    start: float
    clipped: bool = False
    beyond: bool = False


def blind(stuck: StuckSensor | None) -> bool:
    """Whether the gyro is what stands still."""
    return stuck is not None and "gyro" in stuck.channel


def far_from_zero(stuck: StuckSensor, kit: Kit) -> bool:
    """Whether a sensor stands still at many of its steps from zero."""
    sensor = kit.sensors.get(stuck.channel)
    return abs(stuck.reading) > (CLIPPED_GRAINS * sensor.quantum if sensor else 0.0)


def stuck_sensor(log: Log, kit: Kit, end: float) -> StuckSensor | None:
    """The sensor that stood still up to `end` [s] while an encoder, or for an encoder the other one, moved by far more
    than a step; None where there is none. A reading at the end of its kit's range says nothing, and is not stuck."""
    encoders = [n for pair in RATES.items() for n in pair if n in log]
    upto = log.t <= end
    for name in [n for n in ("sensor/gyro", *encoders) if n in log]:
        sensor = kit.sensors.get(name)
        readings = log[name][upto]
        changes = np.flatnonzero(np.diff(readings) != 0)
        first = int(changes[-1]) + 1 if len(changes) else 0
        start = float(log.t[first])
        clipped = sensor is not None and abs(float(readings[-1])) >= FULL_RANGE * sensor.range
        others = [n for n in encoders if n != name and ("rate" in n) == ("rate" in encoders[0])]
        if end - start < STUCK or clipped or not np.isfinite(readings[-1]):
            continue
        moves = [float(np.ptp(np.nan_to_num(log[n][upto][first:]))) for n in others]
        grains = [STUCK_STEPS * kit.sensors[n].quantum if n in kit.sensors else 0.0 for n in others]
        if any(m > max(g, STUCK_MOVES) for m, g in zip(moves, grains, strict=True)):
            ends = "encoder" not in name or "rate" in name  # an angle counts on
            return StuckSensor(name, float(readings[-1]), start, ends and _at_its_end(readings, first, sensor))
    return None


def _at_its_end(readings: Array, first: int, sensor: Sensor | None) -> bool:
    """Whether readings that stand still from row `first` on, many steps from zero, stood at the same size for some rows
    before and never went beyond since then: a range may be smaller than the kit says."""
    size = abs(float(readings[-1]))
    if sensor is not None and size < CLIPPED_GRAINS * sensor.quantum:
        return False
    before = np.abs(readings[:first])
    beyond = np.flatnonzero(before > size * (1 + 1e-9))
    since = before[int(beyond[-1]) + 1 :] if len(beyond) else before
    at_end = (since >= size * (1 - 1e-9)).astype(int)
    stood = np.convolve(np.append(at_end, 0), np.ones(CLIPPED_ROWS, dtype=int))
    return size > 0 and int(stood.max()) == CLIPPED_ROWS


def held_command(run: FilterRun, motors: Authority, end: float, seconds: float) -> tuple[float, float] | None:
    """From when to when [s] both commands stood still for longest in the last `seconds` before `end`, while the motors
    could still save the robot; None where that took no longer than a lean needs to grow e-fold, or is usual since the
    motors were first switched on, or where no law had to answer anything meanwhile, as of a robot at rest."""
    log = run.log
    rows = log.t <= end
    moved = np.flatnonzero(~_repeated(run)[rows][1:]) + 1
    edges = np.concatenate([[0], moved, [int(rows.sum()) - 1]])
    starts = log.t[edges[:-1]]
    stops = log.t[edges[1:]]
    lengths = stops - starts
    recent = stops > end - seconds
    if not recent.any():
        return None
    i = int(np.argmax(np.where(recent, lengths, 0.0)))
    needed = np.interp(log.t, motors.t, motors.needed)
    changes = np.array([np.ptp(needed[first : last + 1]) for first, last in pairwise(edges.tolist())])
    earlier = (stops <= starts[i]) & (stops > log.t[int(np.argmax(run.asked.any(axis=1)))])
    if not earlier.any():
        return None
    least = max(1 / falling(run.robot).pole, USUALLY_HELD * float(lengths[earlier].max()))
    answered = max(ANSWERED, USUALLY_HELD * float(np.median(changes[earlier])))
    stood = lengths[i] > least and changes[i] > answered and abs(needed[edges[i]]) < 1
    return (float(starts[i]), float(stops[i])) if stood else None


def half_swing(motors: Authority, pole: float, end: float) -> float:
    """How long the commands went one way at a time in the last swings before `end` [s], over the time in which the
    robot falls e-fold, 1/`pole` (median); NaN where they did not swing."""
    rows = (motors.t <= end) & (np.abs(motors.command) > CLEARLY)
    t = motors.t[rows]
    way = np.sign(motors.command[rows])
    turns = t[1:][np.diff(way) != 0]
    turns = turns[turns > end - LAST_SWINGS / pole]
    return float(np.median(np.diff(turns))) * pole if len(turns) > 1 else math.nan


def _repeated(run: FilterRun) -> Mask:
    """Rows whose commands are those before; of volts by a measured battery, whose duties are."""
    same = (np.diff(run.asked, axis=0) == 0).all(axis=1)
    if "sensor/battery" in run.log and run.robot.command_unit == "V":
        with np.errstate(divide="ignore", invalid="ignore"):
            duties = run.asked / run.log["sensor/battery"][:, None]
        same |= (np.abs(np.diff(duties, axis=0)) < SAME_DUTY).all(axis=1)
    return np.concatenate([[False], same])


@dataclass(frozen=True)
class Blocked:
    """A robot that drove at `speed` [m/s] and was held from `start` [s] on: it went no further than `further` [m]."""

    start: float
    speed: float
    further: float


def blocked(log: Log, robot: Robot, start: float, force: float) -> Blocked | None:
    """Whether what pushed with a `force` from `start` [s] on was something that the robot drove into: it opposes the
    motion, and the wheels neither go on nor are thrown back."""
    record = record_of(log)
    names = [name for name in RATES if name in record.channels]
    if not names:
        return None
    pitch = np.concatenate([[0.0], np.cumsum(gyro(log)[:-1] * np.diff(log.t))])
    wheel = np.mean([record[name] for name in names], axis=0) + pitch
    x = robot.wheel_radius * wheel
    first = start - CONTACT
    held = start + HELD
    if first - RUN_UP < log.t[0] or held > log.t[-1]:
        return None
    at = np.interp([first - RUN_UP, first, start], log.t, x)
    speed = float(at[1] - at[0]) / RUN_UP
    after = np.sign(speed) * (x[(log.t >= start) & (log.t <= held)] - at[2])
    if abs(speed) < DRIVING or force * speed > 0 or not len(after):
        return None
    stands = after[-1] < GIVES * abs(speed) * HELD and after[-1] > -THROWN * abs(speed) * HELD
    return Blocked(start, speed, float(after.max())) if stands else None


def without(log: Log, rows: Mask, *sensors: str) -> Log:
    """The log without the readings of some rows, of these channels or of all sensors; its commands stay."""
    names = sensors or [name for name in log.channels if name.startswith("sensor/")]
    channels = {**log.channels, **{name: np.where(rows, np.nan, log[name]) for name in names}}
    return Log(log.t, channels, log.units, log.origin)
