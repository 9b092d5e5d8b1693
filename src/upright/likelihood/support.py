"""What a log says of the numbers that a certificate takes as given: battery, floor, motors, delays, gyro, load, clock.

The nominal robot's steady Kalman filter follows the log (`followed`). A number that differs from the assumed
one adds a signature to its innovations; what robots within their spreads add is taken out as well as it may (ridge
regression). The rest gives each number's value by least squares, with a 95 % interval that counts the innovations'
correlation in time. The gyro's scale is the likeliest.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import KW_ONLY, dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import SURPRISE, Estimate
from upright.calibration.knocks import at_motors, moved_by
from upright.control.delay import MOST_PERIODS, sampled
from upright.likelihood.assumptions import Assumptions, batteries, steepness
from upright.likelihood.followed import FollowedLog, body_load, filtered_log, gyro_scale, taken
from upright.logs.recording import commanded
from upright.pages import Quantity, Say
from upright.pages.terms import term
from upright.robots import Kit, Robot
from upright.signals import Log

MASS = "body's mass"
NAMED = {
    MASS: Say("the body's mass"), "battery": Say("the battery"), "battery's sag": Say("the battery's sag"),
    "jitter": Say("the jitter of the clock"), "motors' strength": Say("the motors' strength"),
    "difference of the motors": Say("the difference of the motors"), "gyro's scale": Say("the gyro's scale"),
    "gyro's further delay": Say("the gyro's further delay"), "gyro's noise": Say("the gyro's noise"),
    "further delay": Say("the further delay"), "dead zone": Say("the motors' dead zone"),
    "drop": Say("the driver's voltage drop"), "slope": Say("the floor's slope"),
    "share of readings that count": Say("the share of readings that count"),
}  # fmt: skip
"""What a log shows besides the parameters of a robot."""
FURTHER = ("further delay", "gyro's further delay")  # than the kit's
NORMAL = 1.96  # standard deviations either side that hold 95 % of a normal distribution
DRAWN = 24  # robots whose differences stand for the spreads
CORRELATED = 0.5  # [s] over which the correlation of innovations is summed

UNEQUAL = 0.1  # [1] difference of two motors: two standard deviations of two of one make
STRENGTH = 0.1  # [1] of the motors beyond the robot's spreads: an empty battery or a warm winding takes as much
GYRO_SCALE = 0.2  # [1]
SCALE_KNOWN = 0.1  # of it: within their spreads robots move the likeliest scale by as much
GYRO_NOISE = 2.0  # times the kit's: a guess counts as right within a factor of two
WHITE = -0.71  # correlation of neighbours in third differences: of white noise -3/4, of what falls as 1/f² -2/3
LOAD = 0.3  # [1] of the body's mass beyond its spread, with which the errors of its inertia and height go
LOAD_KNOWN = 0.2  # of it: as far as the likeliest mass of robots within their spreads lies from theirs
LEVEL = math.radians(1.0)  # [rad] of a floor that counts as level
LEAD = -2.0  # [periods] of less delay, which harms no loop
LAG = 0.5  # [periods] of further delay that count as none
CLOCK = 1e-3  # [s] resolution of a log's clock
SAG = 2.0  # times the kit's: a guess counts as right within a factor of two
FEWEST_VOLTS = 20  # readings of a battery from which its sag is fitted
LEAST_LOAD = 0.05  # of the battery's voltage, by which commands must vary to show a sag
DELAYS = tuple(0.5 * k for k in range(-2, 17))  # [periods] that are tried
BETWEEN = 4  # parts of a step of these grids, in which the best value is looked for at last
ZONES = 65  # dead zones that are tried, with as many commands between one and the next
ZONE_KNOWN = 0.1  # of it
LEAST_ZONE = 0.01  # of the largest command, where the kit has none


@dataclass(frozen=True)
class Support:
    """One number of a log: its `value` with the 95 % interval from `low` to `high` in `unit`, beside what the
    certificate covers, from `least` to `most`. Of a number that a calibration finds these are `SURPRISE` deviations of
    what the robot's file states: `stated`, value and one deviation (None: no such number). One that is `left_open` may
    be any of its interval, as far as the log tells."""

    name: str
    unit: str
    value: float
    low: float
    high: float
    least: float
    most: float
    _: KW_ONLY
    stated: tuple[float, float] | None = None
    left_open: bool = False

    @property
    def outside(self) -> bool:
        """Whether the whole interval lies outside what was assumed; of a stated number, its value; of one that is left
        open, a part of it."""
        low, high = (self.value, self.value) if self.stated else (self.low, self.high)
        return self.left_open or high < self.least or low > self.most

    @property
    def excess(self) -> float:
        """How far the value lies outside what was assumed, in widths of that; negative inside."""
        return max(self.least - self.value, self.value - self.most) / max(self.most - self.least, 1e-12)

    @classmethod
    def of_estimate(cls, e: Estimate) -> Support:
        """What a calibration finds of a number that the robot's file states."""
        least, most = (float(e.asked.value(side * SURPRISE)) for side in (-1, 1))
        name = e.name.replace("_", " ")
        stated = (e.prior, e.prior_spread)
        return cls(name, e.unit, e.value, e.low, e.high, least, most, stated=stated)

    @property
    def named(self) -> Say:
        """What the number is."""
        return NAMED.get(self.name) or term(self.name.replace(" ", "_"))

    @property
    def assumed(self) -> Quantity:
        """What the certificate covers."""
        return Quantity(None, self.unit, low=self.least, high=self.most)

    @property
    def message(self) -> Say:
        """The number beside what was assumed, or what the file states."""
        value = Quantity(self.value, self.unit)
        if self.stated is None:
            if self.name in FURTHER and self.value > self.most:
                facts = {"name": self.named, "value": value, "most": Quantity(self.most, "s")}
                return Say("{name} is {value}; the kit's was trusted to {most}", **facts)
            return Say("{name} is {value}, assumed {range}", name=self.named, value=value, range=self.assumed)
        stated, deviation = (Quantity(number, self.unit) for number in self.stated)
        return Say("{name} is {value}, in the file {stated} ± {deviation}", name=self.named, value=value,
                   stated=stated, deviation=deviation)  # fmt: skip


def contradictions(support: Sequence[Support]) -> list[Support]:
    """The numbers that lie outside, the farthest first."""
    beyond = [s for s in support if s.outside]
    return sorted(
        beyond, key=lambda s: -max(s.least - s.high, s.low - s.most) / max(s.most - s.least, s.high - s.low, 1e-12)
    )


def supported(log: Log, setup: Assumptions) -> tuple[Support, ...]:
    """What `log`, of the robot of `setup`, shows of the numbers that its certificate takes as given.

    Raises like `agreement`. Numbers that the log does not show at all are left out.
    """
    return (*_battery(log, setup), *_jitter(log, setup.actual_kit), *_dynamics(log, setup))


def _battery(log: Log, setup: Assumptions) -> list[Support]:
    """The battery's open-circuit voltage and its sag, from its own readings."""
    kit = setup.actual_kit
    prefix = commanded(log)
    nominal = kit.battery.voltage
    expected = batteries(setup.robot, setup.kit)
    if "sensor/battery" not in log or expected is None:
        return []
    tried = [*expected, *(setup.logged.batteries if setup.logged else ())]
    volts = log["sensor/battery"]
    there = np.isfinite(volts)
    if there.sum() < FEWEST_VOLTS:
        return []
    load = np.zeros(len(log))
    if prefix:
        sides = np.abs(np.column_stack([log[f"{prefix}/{side}"] for side in ("left", "right")]))
        load = np.minimum(np.nan_to_num(sides), nominal).sum(axis=1)
    lag = max(0, round(kit.delay / log.period)) if prefix == "command" else 0
    load = np.concatenate([np.zeros(lag + 1), load])[: len(log)]  # a row's reading precedes its command
    least, most = min(tried), max(tried)
    if load[there].std() < LEAST_LOAD * nominal:
        middle = float(np.median(volts[there]))
        spread = float(volts[there].std())
        full = middle + kit.battery.sag * float(np.median(load[there]))
        return [Support("battery", "V", full, full - spread, full + spread, least, most)]
    A = np.column_stack([np.ones(int(there.sum())), -load[there]])
    values, errors = _fitted(A, volts[there], log.period)
    full, sag = (float(v) for v in values)
    wide = NORMAL * errors
    numbers = [Support("battery", "V", full, full - wide[0], full + wide[0], least, most)]
    limit = max(SAG * kit.battery.sag, 0.01)
    return [*numbers, Support("battery's sag", "V/V", sag, sag - wide[1], sag + wide[1], min(0.0, limit), limit)]


def _fitted(A: Array, y: Array, period: float) -> tuple[Array, Array]:
    """Least squares (k,) and standard deviations (k,) that count the correlation of what is left."""
    values = np.linalg.lstsq(A, y, rcond=None)[0]
    rest = y - A @ values
    variance = float(rest @ rest) / max(len(y) - A.shape[1], 1) * _inflation(rest[:, None], period)
    errors: Array = np.sqrt(np.maximum(np.diag(np.linalg.pinv(A.T @ A)), 0) * variance).astype(np.float64)
    return values.astype(np.float64), errors


def _inflation(rest: Array, period: float) -> float:
    """1 + 2 Σ ρ over positive autocorrelations: readings (n, sensors) for each independent one."""
    most = max(1, min(round(CORRELATED / period), len(rest) // 4))
    centred = rest - rest.mean(axis=0)
    zero = float((centred**2).sum())
    rho = [float((centred[k:] * centred[:-k]).sum()) / max(zero, 1e-300) for k in range(1, most + 1)]
    cut = next((k for k, r in enumerate(rho) if r <= 0), len(rho))
    return max(1.0, 1 + 2 * sum(rho[:cut]))


def _jitter(log: Log, kit: Kit) -> list[Support]:
    """The width of the steps between rows; lost rows are not counted."""
    steps = np.diff(log.t)
    steps = steps[steps < 1.5 * log.period]
    if len(steps) < FEWEST_VOLTS:
        return []
    low, high = np.quantile(steps, (0.025, 0.975))
    width = float(high - low)
    return [Support("jitter", "s", width, width, width, 0.0, max(2 * kit.jitter, 2 * CLOCK))]


def _dynamics(log: Log, setup: Assumptions) -> list[Support]:
    """What the filter's innovations say."""
    robot, kit = setup.actual_robot, setup.actual_kit
    path, sent, motors = filtered_log(log, setup)
    raw = commanded(log) == "command"
    weighs = not (setup.is_weighed or setup.dry_friction)
    names, columns = _signatures(path, motors)
    spreads = _spreads(path, setup, motors)
    fit = _Fit(path, np.column_stack([*columns, spreads]), len(columns), log.period)
    values, errors = fit.solved(path.errors)
    fitted = {name: (float(v), NORMAL * float(e)) for name, v, e in zip(names, values, errors, strict=True)}
    lag = tuple(log.period * x for x in fitted["gyro delay"])
    scale = gyro_scale(log, setup)
    within = {"least": 1 - GYRO_SCALE, "most": 1 + GYRO_SCALE}
    numbers = [
        *([] if setup.dry_friction else [_of("motors' strength", "1", 1.0, fitted["strength"], STRENGTH)]),
        _of("difference of the motors", "1", 0.0, fitted["asymmetry"], UNEQUAL),
        replace(_of("gyro's scale", "1", scale, (0.0, SCALE_KNOWN * scale), 0.0), **within),
        replace(_of("gyro's further delay", "s", 0.0, lag, LAG * log.period), least=LEAD * log.period),
        *([body_mass(setup, robot.body_mass * body_load(log, setup), LOAD_KNOWN)] if weighs else []),
        *([_slope(setup.floor, setup)] if setup.floor else []),
        *_noise(log, setup, path),
        _delay(fit, path, motors, log.period),
    ]  # fmt: skip
    known = ("dead_zone", *(("drop",) if kit.motor.drop else ()))
    return [*numbers, *(_taken(name, path, setup, sent, motors) for name in known if raw)]


def body_mass(setup: Assumptions, value: float, known: float) -> Support:
    """The mass [kg] of the body, `known` to this part of it, beside what the certificate covers."""
    mass = setup.actual_robot.body_mass
    spread = float(np.std([r.body_mass for r in setup.robots]))
    most = max(LOAD * mass, 2 * spread)
    return Support(MASS, "kg", value, value * (1 - known), value * (1 + known), mass - most, mass + most)


def _of(name: str, unit: str, middle: float, numbers: Sequence[float], around: float) -> Support:
    value = middle + numbers[0]
    wide = numbers[1]
    return Support(name, unit, value, value - wide, value + wide, middle - around, middle + around)


def _signatures(path: FollowedLog, motors: Array) -> tuple[list[str], list[Array]]:
    """What each number that differs by one unit adds to the innovations."""
    model = path.estimator.sampled
    half = np.array([-0.5, 0.5])
    commands = path.unknown([motors, motors * half])
    gyro = path.predicted[:, 2]  # not the reading, whose noise is in its innovation too
    shifted = np.zeros((len(gyro), 3, 2))
    shifted[:, 2, 0], shifted[:, 2, 1] = gyro, -np.gradient(gyro)
    sensors = path.answer(shifted, np.zeros((len(gyro), len(model.linear.A), 2)))
    heavier = model.robot.replace(body_mass=1.05 * model.robot.body_mass)
    load = _others(path, [heavier], motors)[:, 0] / 0.05
    names = ["strength", "asymmetry", "gyro scale", "gyro delay", "load"]
    return names, [*commands.T, *sensors.T, load]


def _others(path: FollowedLog, robots: Sequence[Robot], motors: Array) -> Array:
    """What robots that differ add to the innovations (rows·sensors, robots), linear in the difference."""
    model = path.estimator.sampled
    known = moved_by(model, motors)
    moved = list[Array]()
    for robot in robots:
        other = sampled(robot, model.kit, model.dt, longest=MOST_PERIODS)
        moved.append(path.states @ (other.linear.A - model.linear.A).T + moved_by(other, motors) - known)
    return -path.answer(np.zeros((len(known), 3, len(moved))), np.stack(moved, axis=2))


def _spreads(path: FollowedLog, setup: Assumptions, motors: Array) -> Array:
    """What robots within their spreads add (rows·sensors, k), so that their sum with normal weights has their
    covariance."""
    some = setup.robots[:DRAWN]
    return _others(path, [setup.actual(robot) for robot in some], motors) / math.sqrt(len(some))


class _Fit:
    """Least squares of innovations by the first `free` columns, beside others that have normal weights of one."""

    def __init__(self, path: FollowedLog, columns: Array, free: int, period: float) -> None:
        self.columns, self.free, self.period = columns, free, period
        self.prior = np.diag([1e-6] * free + [1.0] * (columns.shape[1] - free))
        self.scale = 1.0
        for _ in range(2):  # the prior weighs against the noise, which is known from what is left
            rest = path.errors - columns @ self._weights(path.errors)
            correlated = _inflation(rest.reshape(-1, 3), period)
            self.scale = float(rest @ rest) / len(rest) * correlated

    def _matrix(self) -> Array:
        return self.columns.T @ self.columns / self.scale + self.prior

    def _weights(self, y: Array) -> Array:
        return np.linalg.solve(self._matrix(), self.columns.T @ y / self.scale).astype(np.float64)

    def solved(self, y: Array) -> tuple[Array, Array]:
        """Values and standard deviations (free,)."""
        return self._weights(y)[: self.free], np.sqrt(np.diag(np.linalg.inv(self._matrix()))[: self.free])

    def cost(self, y: Array) -> float:
        """−2 log likelihood, but for a constant, of innovations y with the best weights."""
        w = self._weights(y)
        rest = y - self.columns @ w
        return float(rest @ rest) / self.scale + float(w @ self.prior @ w)


def _profile(
    fit: _Fit, path: FollowedLog, tried: Sequence[float], others: Callable[[float], Array], known: Array
) -> Array:
    """Value with the least cost among those `tried` and between its neighbours, and the ends of where it is within 95 %
    of it."""
    values, costs = list[float](), list[float]()
    near = list(tried)
    for _ in range(2):
        changes = path.unknown([others(x) - known for x in near])
        values = [*values, *near]
        costs = [*costs, *(fit.cost(path.errors - change) for change in changes.T)]
        best = values[int(np.argmin(costs))]
        below = max((x for x in tried if x < best), default=best)
        above = min((x for x in tried if x > best), default=best)
        near = [x for x in np.linspace(below, above, 2 * BETWEEN + 1).tolist() if x not in values]
    likely = np.array(values)[np.array(costs) <= min(costs) + NORMAL**2]
    return np.array([values[int(np.argmin(costs))], likely.min(), likely.max()])


def _delay(fit: _Fit, path: FollowedLog, motors: Array, period: float) -> Support:
    rows = np.arange(len(motors))

    def shifted(periods: float) -> Array:
        return np.column_stack([np.interp(rows - periods, rows, side) for side in motors.T])

    # neighbours of the best cannot be distinguished from it by half a step of the grid
    value, low, high = period * _profile(fit, path, DELAYS, shifted, motors)
    half = period * (DELAYS[1] - DELAYS[0]) / (2 * BETWEEN)
    return Support("further delay", "s", value, low - half, high + half, LEAD * period, LAG * period)


def _taken(name: str, path: FollowedLog, setup: Assumptions, sent: Array, motors: Array) -> Support:
    """What the driver takes from commands: the motor's `dead_zone`, or its `drop`."""
    kit = setup.actual_kit
    unit = setup.robot.command_unit
    sizes = np.abs(sent)
    unit_zone = max(getattr(kit.motor, name), LEAST_ZONE * float(np.abs(motors).max()))
    most = 0.9 * float(sizes.max())  # one beyond all commands is a strength of zero
    zones = np.unique([0.0, unit_zone, *np.quantile(sizes, np.linspace(0.0, 1.0, ZONES))])

    def made(zone: float) -> Array:
        return at_motors(sent, replace(kit, motor=replace(kit.motor, **{name: zone})), unit)

    value = taken(path, motors, made, [z for z in zones.tolist() if z <= unit_zone or z < most])
    wide = max(ZONE_KNOWN * value, LEAST_ZONE * float(np.abs(sent).max()))
    return Support(name.replace("_", " "), unit, value, value - wide, value + wide, 0.0, 2 * unit_zone)


def slope(calibration: Calibration) -> tuple[float, float, float]:
    """The floor's slope with its interval [rad]: to a calibration it is a constant command, to first order."""
    e = calibration["constant_command"]
    each = -2 * steepness(calibration.robot)
    return each * e.value, each * e.high, each * e.low


def _slope(angles: tuple[float, float, float], setup: Assumptions) -> Support:
    """The slope beside the floors that are tried."""
    tried = [*setup.robot.conditions.slopes, *(setup.logged.slopes if setup.logged else ())]
    return Support("slope", "rad", *angles, min(tried) - LEVEL, max(tried) + LEVEL)


def _noise(log: Log, setup: Assumptions, path: FollowedLog) -> list[Support]:
    """The gyro's noise from third differences, in which the motion nearly vanishes, of its readings or of its
    innovations, in which a fast motion is predicted: the smaller one. Where these are not white a motion is left, such
    as the frame's swing, and the log leaves the noise open below."""
    gyro = log["sensor/gyro"]
    several = [np.diff(x[np.isfinite(x)], n=3) for x in (gyro, path.raw[:, 2])]
    if len(several[0]) < FEWEST_VOLTS:
        return []
    size, least = min((float(np.median(np.abs(x))) * 1.4826 / math.sqrt(20), k) for k, x in enumerate(several))
    known = np.corrcoef(several[least][1:], several[least][:-1])[0, 1] < WHITE
    sensor = (setup.actual_kit if known else setup.kit).sensors["sensor/gyro"]
    value = math.sqrt(max(size**2 - sensor.quantum**2 / 12, 0.0))
    wide = value * 2 / math.sqrt(len(several[0]))
    most = GYRO_NOISE * math.hypot(sensor.noise, sensor.quantum)
    low, left_open = (value - wide, False) if known else (0.0, value + wide > most)
    return [Support("gyro's noise", "rad/s", value, low, value + wide, 0.0, most, left_open=left_open)]
