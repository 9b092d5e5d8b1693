"""The robot sampled once a period, as the controller has it: dead time and sensor delays become states.

Between two samples the motors get the older command and, after the fraction of a period in the dead time, a newer one
(Åström and Wittenmark 1997, section 2.3). A delayed sensor reads an earlier state, between samples too.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

import numpy as np

from upright.arrays import Array
from upright.errors import DesignFailed, SpecMismatch
from upright.physics.dynamics import turn_ratio
from upright.physics.linear import LinearModel, delay_line, linearise_rolling
from upright.physics.sensing import sensor_matrix
from upright.robots import Kit, Robot, Sensor
from upright.signals import SIDES, STATE_NAMES, TRUE_STATE

RAW = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro")
GYRO = RAW[2]

_SAME = 1e-9  # of a period: equal times may differ by rounding
_FINEST = 1e-10  # [unit²] variance of a sensor said to be perfect, so that the filter stays defined
LONGEST = 50  # periods of delay: beyond, the states of a filter would be many and the loop hopeless
MOST_PERIODS = 1000  # of delay, for the poles of a loop: a filter of so many states is never asked for


@dataclass(frozen=True, eq=False, kw_only=True)
class SampledRobot:
    """`robot` once a period, between `delay` whole periods (and a fraction) of dead time and delayed sensors.

    `linear` is the model of the estimator: p⁺ = A p + B [a, a⁻] + E F, y = C p. Here a is the command that was really
    applied at the end of the period, a⁻ that of the period before, and F [N] a push of one period. The states p are the
    robot's six, a gyro's bias [rad/s] where one is read, a push at the centre of mass [N], and readings still on their
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


def sampled(
    robot: Robot, kit: Kit, dt: float | None = None, reads: Sequence[str] = RAW, *, longest: int = LONGEST
) -> SampledRobot:
    """`robot` under `kit` every `dt` [s] (None: the kit's period), measured by the channels `reads`.

    Raises `SpecMismatch` for a channel that the kit does not have. Raises `DesignFailed` for a period outside (0, 1] s
    or a delay of more than `longest` periods.
    """
    period = kit.period if dt is None else dt
    if not (math.isfinite(period) and 0 < period <= 1):
        raise DesignFailed(f"a period of {period} s", expected="between 0 and 1 s", likely="milliseconds")
    C = sensor_matrix(reads, turn_ratio(robot), kit.sensors)
    rows = list(zip([_sensor(kit, name) for name in reads], C, strict=True))
    delay = max([kit.delay + kit.jitter / 2, *(sensor.delay for sensor, _ in rows)])
    if delay > longest * period:
        raise DesignFailed(
            f"a delay of {delay:g} s at a period of {period:g} s", expected=f"at most {longest} periods",
            hint="lengthen the period",
        )  # fmt: skip
    between = _Between(robot, period, kit.delay + kit.jitter / 2)
    return _assembled(robot, kit, tuple(reads), between, rows)


class _Between:
    """x(t + h) for 0 ≤ h ≤ dt: Φ(h) x + Γ⁻(h) a⁻ + Γ(h) a + ε(h) F."""

    def __init__(self, robot: Robot, dt: float, dead: float) -> None:
        self.robot, self.dt = robot, dt
        self.delay = math.floor(dead / dt + _SAME)
        rest = dead - self.delay * dt
        self.rest = rest if rest > _SAME * dt else 0.0

    @cache  # noqa: B019 (it lives as long as one design)
    def __call__(self, h: float) -> tuple[Array, Array, Array, Array]:
        first = min(h, self.rest)
        second = max(h - self.rest, 0.0)
        phi, old, push = _held(self.robot, first)
        phi2, new, push2 = _held(self.robot, second)
        return phi2 @ phi, phi2 @ old, new, phi2 @ push + push2


@lru_cache(maxsize=1024)  # delays at which a margin is tried, and robots a log is compared with, have parts in common
def _held(robot: Robot, h: float) -> tuple[Array, Array, Array]:
    """Φ, Γ and ε of one command over `h` [s]."""
    if h <= 0:
        return np.eye(6), np.zeros((6, 2)), np.zeros(6)
    held = linearise_rolling(robot).c2d(h)
    return held.A, held.B, held.E[:, 0] + robot.com_height * held.E[:, 1]


def _assembled(
    robot: Robot, kit: Kit, reads: tuple[str, ...], between: _Between, rows: list[tuple[Sensor, Array]]
) -> SampledRobot:
    extra = ["gyro_bias"] * (GYRO in reads) + ["push"]
    lines = [_line(sensor.delay, between.dt) for sensor, _ in rows]
    waiting = [f"{name}@{i + 1}" for name, (count, _) in zip(reads, lines, strict=True) for i in range(count)]
    names = (*STATE_NAMES, *extra, *waiting)
    n = len(names)
    push = len(STATE_NAMES) + len(extra) - 1
    A = np.zeros((n, n))
    B = np.zeros((n, 4))
    E = np.zeros((n, 1))
    C = np.zeros((len(rows), n))

    def moves(row: int, c: Array, h: float) -> None:
        phi, old, new, force = between(h)
        A[row, :6], A[row, push], B[row], E[row] = c @ phi, c @ force, np.concatenate([c @ new, c @ old]), c @ force

    phi, old, new, force = between(between.dt)
    A[:6, :6], A[:6, push], B[:6], E[:6, 0] = phi, force, np.hstack([new, old]), force
    A[range(6, push + 1), range(6, push + 1)] = 1.0
    place = push + 1
    for i, ((_, c), (count, h)) in enumerate(zip(rows, lines, strict=True)):
        if count:
            moves(place, c, h)
            A[place + 1 : place + count, place : place + count] = delay_line(1, count, between.dt).A[1:]
            C[i, place + count - 1] = 1.0
        else:
            C[i, :6] = c
        place += count
    if GYRO in reads:
        C[reads.index(GYRO), 6] = 1.0
    noise = np.diag([max(s.noise**2 + s.quantum**2 / 12, _FINEST) for s, _ in rows])
    linear = LinearModel(
        A, B, C, dt=between.dt, states=names, inputs=(*SIDES, *(f"{side}_before" for side in SIDES)), outputs=reads,
        E=E, disturbances=("push",),
    )  # fmt: skip
    return SampledRobot(robot=robot, kit=kit, delay=between.delay, linear=linear, noise=noise, between=between)


def _line(delay: float, dt: float) -> tuple[int, float]:
    """How many states a reading waits in, and how long into the period the state is that enters the first."""
    whole = math.floor(delay / dt + _SAME)
    rest = delay - whole * dt
    return (whole, 0.0) if rest <= _SAME * dt else (whole + 1, dt - rest)


def _plant(between: _Between) -> LinearModel:
    d = between.delay
    h = between.delay + (between.rest > 0)
    phi, old, new, push = between(between.dt)
    n = 6 + 2 * h
    A = np.zeros((n, n))
    B = np.zeros((n, 2))
    E = np.zeros((n, 1))
    A[:6, :6], E[:6, 0] = phi, push
    if between.rest > 0:
        A[:6, 6 + 2 * d : 8 + 2 * d] = old
    if d:
        A[:6, 4 + 2 * d : 6 + 2 * d] = new
    else:
        B[:6] = new
    line = delay_line(2, h, between.dt)
    A[6:, 6:], B[6:] = line.A, B[6:] + line.B
    sent = tuple(f"sent_{i + 1}/{side}" for i in range(h) for side in SIDES)
    states = (*STATE_NAMES, *sent)
    return LinearModel(A, B, dt=between.dt, states=states, inputs=SIDES, E=E, disturbances=("push",))


def _ahead(between: _Between, plant: LinearModel) -> Array:
    """The plant run over its dead time: whole periods, then the rest of one under the command sent last."""
    whole: Array = np.linalg.matrix_power(plant.A, between.delay)[:6]
    if not between.rest:
        return whole
    phi, held, _ = _held(between.robot, between.rest)
    arrived = phi @ whole
    arrived[:, 6:8] += held
    return arrived


def _sensor(kit: Kit, name: str) -> Sensor:
    if name in TRUE_STATE:
        return Sensor()
    if name not in kit.sensors:
        raise SpecMismatch(
            f"kit '{kit.name}' has no {name}", expected="the sensors the controller reads: both encoders and a gyro"
        )
    return kit.sensors[name]
