"""The robot sampled once a period, as the controller has it: dead time and sensor delays become states.

Between two samples the motors get the older command and, after the fraction of a period in the dead time, a newer one
(Åström and Wittenmark 1997, section 2.3). A delayed sensor reads an earlier state, between samples too. What no reading
shows, such as the wheels' position without encoders, is left out.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, lru_cache

import numpy as np

from upright.arrays import Array, Mask
from upright.errors import DesignFailed, SpecMismatch
from upright.physics.linear import LinearModel, delay_line, linearise_rolling
from upright.physics.sensing import FORWARD, FUSED_OF, GYRO, PITCH, sensed
from upright.robots import Kit, Robot, Sensor
from upright.signals import SIDES, STATE_NAMES, TRUE_STATE

RAW = ("sensor/encoder_left", "sensor/encoder_right", GYRO)

_FREE = STATE_NAMES[2:]  # of these a robot may know nothing and stand
_SAME = 1e-9  # of a period: equal times may differ by rounding
ROUNDING = 1e-12  # [1] of a row's largest entry, to rounding
_FINEST = 1e-10  # [unit²] variance of a sensor said to be perfect, so that the filter stays defined
LONGEST = 50  # periods of delay: beyond, the states of a filter would be many and the loop hopeless
MOST_PERIODS = 1000  # of delay, for the poles of a loop: a filter of so many states is never asked for


@dataclass(frozen=True, eq=False, kw_only=True)
class SampledRobot:
    """`robot` once a period, between `delay` whole periods (and a fraction) of dead time and delayed sensors.

    `linear` is the model of the estimator: p⁺ = A p + B [a, a⁻] + E F, y = C p. Here a is the command that was really
    applied at the end of the period, a⁻ that of the period before, and F [N] a push of one period. The states p are
    those of the robot's six that are not `hidden`, those that sensors have of their own, a gyro's bias [rad/s] where
    one is read, a push at the centre of mass [N] where the readings tell it from a lean, and readings still on their
    way. `noise` (p, p) is the covariance of the readings.

    `plant` is the model of the regulator: x⁺ = A x + B u, of the six states and the commands sent before, newest first.
    `ahead` (6, n) gives from these the six states at the moment when a command sent now reaches the motors. Both are
    computed where they are asked for; a margin of delay, which tries many, does not.

    It is not a linear model itself: it pairs both with the robot, the kit and the delay.
    """

    robot: Robot
    kit: Kit
    delay: int
    linear: LinearModel
    noise: Array
    between: _Between

    @cached_property
    def plant(self) -> LinearModel:
        return _plant(self.between)

    @cached_property
    def ahead(self) -> Array:
        return _ahead(self.between, self.plant)

    @property
    def dt(self) -> float:
        """The period [s]."""
        return self.linear.dt

    @property
    def reads(self) -> tuple[str, ...]:
        """The channels of the readings."""
        return self.linear.outputs

    @property
    def shown(self) -> list[int]:
        """Which of the six states the readings show."""
        return [i for i, name in enumerate(STATE_NAMES) if name in self.linear.states]

    @property
    def hidden(self) -> tuple[str, ...]:
        """The states of which they tell nothing, and which do not move what they show."""
        return tuple(name for name in STATE_NAMES if name not in self.linear.states)

    def check_position(self, method: str) -> None:
        """Raise `DesignFailed` for a `method` that holds the wheels where nothing shows where they are."""
        if "wheel" in self.hidden:
            raise DesignFailed(
                f"{method} holds the wheels where they are, which {' and '.join(self.reads)} do not show",
                expected="both encoders",
                hint="lqr, lqg, mpc or sliding, which do without",
            )

    @property
    def now(self) -> Array:
        """What the command applied at the end of a period adds to p (n, 2)."""
        return self.linear.B[:, :2]

    @property
    def before(self) -> Array:
        """What the command of the period before adds (n, 2): zero where the dead time is whole periods."""
        return self.linear.B[:, 2:]

    @property
    def history(self) -> int:
        """How many earlier commands the plant remembers."""
        return (len(self.plant.states) - 6) // 2


def readable(kit: Kit) -> tuple[str, ...]:
    """The channels that a controller reads by default: both encoders and the gyro. Without all of these it reads the
    fused angle, or else the accelerometer, and what there is of them, so that something shows a lean."""
    if all(name in kit.sensors for name in RAW) or not {PITCH, GYRO} & kit.sensors.keys():
        return RAW
    encoders = RAW[:2] if all(name in kit.sensors for name in RAW[:2]) else ()
    lean = PITCH if PITCH in kit.sensors else FORWARD
    return (*encoders, *(name for name in (lean, GYRO) if name in kit.sensors))


def sampled(
    robot: Robot, kit: Kit, dt: float | None = None, reads: Sequence[str] | None = None, *, longest: int = LONGEST
) -> SampledRobot:
    """`robot` under `kit` every `dt` [s] (None: the kit's period), measured by the channels `reads` (None: `readable`).

    Raises `SpecMismatch` for a channel that the kit does not have. Raises `DesignFailed` for a period outside (0, 1] s
    or a delay of more than `longest` periods.
    """
    period = kit.period if dt is None else dt
    if not (math.isfinite(period) and 0 < period <= 1):
        raise DesignFailed(f"a period of {period} s", expected="between 0 and 1 s", likely="milliseconds")
    reads = readable(kit) if reads is None else tuple(reads)
    sensors = [sensor_of(kit, name) for name in reads]
    delay = max([kit.delay + kit.jitter / 2, *(sensor.delay for sensor in sensors)])
    if delay > longest * period:
        raise DesignFailed(
            f"a delay of {delay:g} s at a period of {period:g} s", expected=f"at most {longest} periods",
            hint="lengthen the period",
        )  # fmt: skip
    between = _Between(_senses(robot, reads, _prompt(kit, reads)), period, kit.delay + kit.jitter / 2)
    return _assembled(robot, kit, between, sensors)


@dataclass(frozen=True, eq=False)
class _Senses:
    """The robot in continuous time on its sensors, `model`; what 1 N at the centre of mass, at that `height` [m], adds
    to the readings at once, `by_push` (p,). They tell which states are `shown`, and whether a push lasts where
    `tells_push`.
    """

    model: LinearModel
    height: float
    by_push: Array
    shown: list[bool]
    tells_push: bool


@lru_cache(maxsize=1024)
def _senses(robot: Robot, reads: tuple[str, ...], sensors: tuple[tuple[str, Sensor], ...]) -> _Senses:
    model, F = sensed(linearise_rolling(robot), reads, robot, dict(sensors))
    push, by_push = (matrix[:, 0] + robot.com_height * matrix[:, 1] for matrix in (model.E, F))
    shown = _shown(model)
    return _Senses(model, robot.com_height, by_push, shown, _tells_push(model, shown, push, by_push))


def _shown(model: LinearModel) -> list[bool]:
    """Which states the readings tell, themselves or by others that they move."""
    known: Mask = np.any(model.C != 0, axis=0)
    moves = np.abs(model.A) > ROUNDING * np.abs(model.A).max(axis=1, keepdims=True)
    for _ in model.states:
        known |= moves[known].any(axis=0)
    standing = known[STATE_NAMES.index("pitch")]  # without its lean all is hopeless, and nothing is left out
    return [bool(known[i]) or name not in _FREE or not standing for i, name in enumerate(model.states)]


def _tells_push(model: LinearModel, shown: list[bool], push: Array, by_push: Array) -> bool:
    """Whether no lean, rate and bias of a gyro together look like a push that lasts (Hautus, at frequency zero)."""
    bias = np.array([name == GYRO for name in model.outputs], dtype=np.float64)
    moved = np.column_stack([model.A[shown][:, shown], push[shown], 0 * push[shown]])
    read = np.column_stack([model.C[:, shown], by_push, bias])
    steady = np.vstack([moved, read])
    size = np.linalg.norm(steady, axis=0)
    return bool(np.linalg.matrix_rank(steady / np.maximum(size, ROUNDING), tol=_SAME) == (size > 0).sum())


def _prompt(kit: Kit, reads: Sequence[str]) -> tuple[tuple[str, Sensor], ...]:
    """The sensors by name, and those of which an angle is fused, without their delays, so that one model serves all
    delays that a margin tries."""
    fused = FUSED_OF if PITCH in reads and kit.sensors[PITCH].time_constant else ()
    names = dict.fromkeys((*reads, *(name for name in fused if name in kit.sensors)))
    return tuple((name, replace(sensor_of(kit, name), delay=0.0)) for name in names)


class _Between:
    """x(t + h) for 0 ≤ h ≤ dt: Φ(h) x + Γ⁻(h) a⁻ + Γ(h) a + ε(h) F."""

    def __init__(self, senses: _Senses, dt: float, dead: float) -> None:
        self.senses = senses
        self.dt = dt
        self.delay = math.floor(dead / dt + _SAME)
        rest = dead - self.delay * dt
        self.rest = rest if rest > _SAME * dt else 0.0

    @cache  # noqa: B019 (it lives as long as one design)
    def __call__(self, h: float) -> tuple[Array, Array, Array, Array]:
        first = min(h, self.rest)
        second = max(h - self.rest, 0.0)
        phi, old, push = _held(self.senses, first)
        phi2, new, push2 = _held(self.senses, second)
        return phi2 @ phi, phi2 @ old, new, phi2 @ push + push2


@lru_cache(maxsize=1024)  # delays at which a margin is tried, and robots a log is compared with, have parts in common
def _held(senses: _Senses, h: float) -> tuple[Array, Array, Array]:
    """Φ, Γ and ε of one command over `h` [s]."""
    model = senses.model
    n = len(model.states)
    if h <= 0:
        return np.eye(n), np.zeros((n, 2)), np.zeros(n)
    held = model.c2d(h)
    return held.A, held.B, held.E[:, 0] + senses.height * held.E[:, 1]


def _assembled(robot: Robot, kit: Kit, between: _Between, sensors: Sequence[Sensor]) -> SampledRobot:
    senses = between.senses
    model = senses.model
    reads = model.outputs
    extra = ["gyro_bias"] * (GYRO in reads) + ["push"]
    lines = [_line(sensor.delay, between.dt, at_once=d.any()) for sensor, d in zip(sensors, model.D, strict=True)]
    waiting = [f"{name}@{i + 1}" for name, (count, _) in zip(reads, lines, strict=True) for i in range(count)]
    names = (*model.states, *extra, *waiting)
    n = len(names)
    m = len(model.states)
    push = m + len(extra) - 1
    A = np.zeros((n, n))
    B = np.zeros((n, 4))
    E = np.zeros((n, 1))
    C = np.zeros((len(reads), n))

    phi, old, new, force = between(between.dt)
    A[:m, :m], A[:m, push], B[:m], E[:m, 0] = phi, force, np.hstack([new, old]), force
    A[range(m, push + 1), range(m, push + 1)] = 1.0
    place = push + 1
    for i, (count, h) in enumerate(lines):
        c = model.C[i]
        d = model.D[i]
        if count:
            phi, old, new, force = between(h)
            pushed = c @ force + senses.by_push[i]
            commands = np.concatenate([c @ new, c @ old])
            commands[:2] += d * (h > between.rest)  # what the motors get at that moment shows at once
            commands[2:] += d * (h <= between.rest)
            A[place, :m] = c @ phi
            A[place, push] = pushed
            B[place] = commands
            E[place] = pushed
            A[place + 1 : place + count, place : place + count] = delay_line(1, count, between.dt).A[1:]
            C[i, place + count - 1] = 1.0
        else:
            C[i, :m] = c
        place += count
    if GYRO in reads:
        C[reads.index(GYRO), m] = 1.0
    keep = [name != "push" or senses.tells_push for name in names]
    keep[:m] = senses.shown
    noise = np.diag([max(s.noise**2 + s.quantum**2 / 12, _FINEST) for s in sensors])
    linear = LinearModel(
        A[keep][:, keep], B[keep], C[:, keep], dt=between.dt, states=tuple(itertools.compress(names, keep)),
        inputs=(*SIDES, *(f"{side}_before" for side in SIDES)), outputs=reads, E=E[keep], disturbances=("push",),
    )  # fmt: skip
    return SampledRobot(robot=robot, kit=kit, delay=between.delay, linear=linear, noise=noise, between=between)


def _line(delay: float, dt: float, *, at_once: bool) -> tuple[int, float]:
    """How many states a reading waits in, and how long into the period the state is that enters the first. One that
    shows a command `at_once` is taken at the end of a period, before the next command."""
    whole = math.floor(delay / dt + _SAME)
    rest = delay - whole * dt
    if rest > _SAME * dt:
        return whole + 1, dt - rest
    return (whole + 1, dt) if at_once else (whole, 0.0)


def _plant(between: _Between) -> LinearModel:
    phi, old, new, push = (part[:6] for part in between(between.dt))
    h = between.delay + (between.rest > 0)
    A, B = behind_dead_time(phi[:, :6], new, old, between.delay, h)
    E = np.zeros((len(A), 1))
    E[:6, 0] = push
    states = (*STATE_NAMES, *sent(h))
    return LinearModel(A, B, dt=between.dt, states=states, inputs=SIDES, E=E, disturbances=("push",))


def sent(count: int) -> list[str]:
    """Names of `count` commands of both motors on their way, newest first."""
    return [f"sent_{i + 1}/{side}" for i in range(count) for side in SIDES]


def behind_dead_time(A: Array, new: Array, old: Array, delay: int, line: int) -> tuple[Array, Array]:
    """A and B of x⁺ = A x + `new` u + `old` u⁻ where u arrives `delay` periods after it was sent, and u⁻ is the command
    before it: the last `line` commands are further states, newest first."""
    n = len(A)
    waiting = delay_line(2, line, 1.0)
    whole = np.zeros((n + 2 * line, n + 2 * line))
    whole[:n, :n], whole[n:, n:] = A, waiting.A
    B = np.vstack([np.zeros((n, 2)), waiting.B])
    arrives = [B, *(whole[:, n + 2 * i : n + 2 * i + 2] for i in range(line))]
    arrives[delay][:n] = new
    if line > delay:
        arrives[delay + 1][:n] = old
    return whole, B


def _ahead(between: _Between, plant: LinearModel) -> Array:
    """The plant run over its dead time: whole periods, then the rest of one under the command sent last."""
    whole: Array = np.linalg.matrix_power(plant.A, between.delay)[:6]
    if not between.rest:
        return whole
    phi, held, _ = _held(between.senses, between.rest)
    arrived = phi[:6, :6] @ whole
    arrived[:, 6:8] += held[:6]
    return arrived


def sensor_of(kit: Kit, name: str) -> Sensor:
    """That of a channel, a perfect one of a true state; raises `SpecMismatch` where the kit has none."""
    if name in TRUE_STATE:
        return Sensor()
    if name not in kit.sensors:
        has = ", ".join(kit.sensors) or "nothing but the true state"
        raise SpecMismatch(f"kit '{kit.name}' has no {name}", expected=f"a controller that reads what it has: {has}")
    return kit.sensors[name]
