"""Maximum likelihood of raw readings: Gauss–Newton on whitened innovations.

The filter's gains are held while the parameters move: at the truth the innovations are white, so that they are
uncorrelated with their own derivative at fixed gains, and the estimate stays consistent (Ljung 1999, section 9.2).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from upright.identify.electronics import driven
from upright.identify.parameters import Parameter, columns, rows_of
from upright.identify.recording import SENSOR, Recording, reading_matrix
from upright.physics.linear import linearise
from upright.robots import PARAMETERS, Robot

Array = NDArray[np.float64]

PROCESS = ("motor", "push", "gyro_bias")
STIFF = 0.7  # largest |pole| h of a Runge–Kutta step: an error of 0.1 % of the fastest, dying mode
ROLLING = 0.004  # [s] longest step: within one a wheel's rate is taken for straight where dry friction stops it
SLIDING = 0.001  # [s] the same for a robot known to have dry friction: its error is 0.03 % of the friction then
NUDGE = 1e-3  # of the prior's deviation: central differences at 1e-7 of the parameter, rounding 1e-10
OUTLIER = 4.0  # deviations beyond which an innovation counts linearly (Huber 1964)


@dataclass(frozen=True, eq=False)
class Path:
    """The filter along one recording: innovations, their variances, the gains, and the state after each event."""

    e: Array
    s: Array
    gains: Array
    states: Array


@lru_cache(maxsize=16)
def _linear(robot: Robot) -> tuple[float, tuple[Array, Array]]:
    """The size of the fastest pole without dry friction [1/s], and how noise of motors and pushes enters the states."""
    model = linearise(robot)
    poles = linearise(robot.replace(coulomb_friction=0.0)).poles()
    push = model.E[:, 0] + robot.com_height * model.E[:, 1]
    return float(np.abs(poles).max()), (model.B @ model.B.T, np.outer(push, push))


@dataclass(frozen=True, eq=False)
class Problem:
    """Recordings, the robot they are thought to be of, what to estimate, and log-variances of process and sensors.

    `held` names parameters that stay at their prior. `temper` weighs the readings against the prior: below one where
    innovations are not white, so that they hold less information than their number says (Lyddon et al. 2019).
    """

    recordings: tuple[Recording, ...]
    robot: Robot
    parameters: tuple[Parameter, ...]
    delays: Mapping[str, float]
    noise: Mapping[str, float]
    held: frozenset[str] = frozenset()
    temper: float = 1.0
    longest: float = field(init=False)
    _shapes: tuple[Array, Array] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        fastest, shapes = _linear(self.robot)
        most = SLIDING if self.robot.coulomb_friction else ROLLING
        object.__setattr__(self, "longest", min(most, STIFF / max(1.0, fastest)))
        object.__setattr__(self, "_shapes", shapes)

    @property
    def active(self) -> NDArray[np.bool_]:
        """Which parameters move; the others are held at their prior."""
        return np.array([p.name not in self.held for p in self.parameters])

    def late(self, z: Array) -> dict[str, Array]:
        """Dead time [s] of each sensor, over the lanes of z (parameters, lanes)."""
        late = {name: np.full(z.shape[1], value) for name, value in self.delays.items()}
        for i, p in enumerate(self.parameters):
            if p.name.startswith("delay/"):
                late[p.name.removeprefix("delay/")] = p.value(z[i])
        return late

    def lanes(self, recording: Recording, z: Array) -> tuple[Array, Array, Array]:
        """Reading matrix, delays of the rows, and the kernel's constants with what drives it, for the lanes of z."""
        from upright.fleet.generated import constants

        numbers = columns(self.robot, self.parameters, z)
        late = self.late(z)
        delays = np.array([late[SENSOR[row]] for row in recording.rows])
        turn = numbers.track / (2 * numbers.wheel_radius)
        reads = reading_matrix(recording.rows, len(recording.first), turn)
        c = constants([getattr(numbers, name) for name in PARAMETERS], 1.0)
        return reads, delays, np.concatenate([np.array(np.broadcast_arrays(*c)), driven(self.parameters, z)])

    def own_delays(self, recording: Recording, z: Array) -> Array:
        """Dead time [s] of each event (events,): zero for commands."""
        late = self.late(z[:, None])
        rows = np.array([float(late[SENSOR[row]][0]) for row in recording.rows] + [0.0])
        return rows[recording.kind]

    def order(self, recording: Recording, z: Array) -> NDArray[np.int64]:
        """The events in the command's time at z (parameters,)."""
        return recording.order({name: float(d[0]) for name, d in self.late(z[:, None]).items()})

    def filtered(self, recording: Recording, z: Array, *, keep: bool = False, until: float = np.inf) -> Path:
        """The filter at z (parameters,) along a recording, up to the time `until` [s]."""
        from upright.identify.predictor import WIDE, kalman_path

        reads, delays, constants = self.lanes(recording, z[:, None])
        size = len(recording.first)
        order = self.order(recording, z)
        order = order[recording.when[order] <= until]
        gains = np.zeros((len(recording.kind), size))
        states = np.zeros((len(recording.kind) if keep else 0, size))
        R = np.exp([self.noise[SENSOR[row]] for row in recording.rows])
        e, s = kalman_path(
            order, recording.kind, recording.when, recording.value, recording.commands,
            np.ascontiguousarray(reads[:, :, 0]), np.ascontiguousarray(delays[:, 0]),
            np.repeat(constants, WIDE, axis=1), recording.first, recording.P0, self.process(size), R,
            self.longest, gains, states,
        )  # fmt: skip
        return Path(e, s, gains, states)

    def process(self, size: int) -> Array:
        """Covariance of the process noise a second."""
        Q = np.zeros((size, size))
        for name, shape in zip(PROCESS, self._shapes, strict=False):
            Q[:6, :6] += np.exp(self.noise[name]) * shape
        Q[6, 6] = np.exp(self.noise["gyro_bias"])
        if size > 7:
            Q[7, 7] = 1e-10
        return Q

    def slopes(self, recording: Recording, z: Array, gains: Array) -> Array:
        """∂e/∂z (events, parameters) at fixed gains, by lanes a nudge either side, or two above a bound."""
        from upright.identify.predictor import LANES, innovations

        order, half = self.order(recording, z), LANES // 2
        low = np.maximum(z - NUDGE, [p.least for p in self.parameters])
        found: list[Array] = []
        for start in range(0, len(z), half):
            part = np.arange(start, min(start + half, len(z)))
            lanes = np.repeat(z[:, None], 2 * len(part), axis=1)
            lanes[part, np.arange(len(part))] = low[part] + 2 * NUDGE
            lanes[part, len(part) + np.arange(len(part))] = low[part]
            first = np.repeat(recording.first[:, None], lanes.shape[1], axis=1)
            reads, delays, constants = self.lanes(recording, lanes)
            e = innovations(
                order, recording.kind, recording.when, recording.value, recording.commands, reads, delays, constants,
                first, gains, self.longest,
            )  # fmt: skip
            found.append((e[:, : len(part)] - e[:, len(part) :]) / (2 * NUDGE))
        return np.concatenate(found, axis=1)

    def coefficient_slopes(self, recording: Recording, z: Array, gains: Array) -> Array:
        """∂e/∂log c (events, coefficients) of the coefficients of the equations of motion, at fixed gains."""
        from upright.fleet.generated import CONSTANTS
        from upright.identify.predictor import innovations

        reads, delays, constants = self.lanes(recording, np.repeat(z[:, None], 2 * CONSTANTS, axis=1))
        k = np.arange(CONSTANTS)
        constants[k, k] *= 1 + NUDGE
        constants[k, CONSTANTS + k] *= 1 - NUDGE
        e = innovations(
            self.order(recording, z), recording.kind, recording.when, recording.value, recording.commands, reads,
            delays, constants, np.repeat(recording.first[:, None], 2 * CONSTANTS, axis=1), gains, self.longest,
        )  # fmt: skip
        return (e[:, :CONSTANTS] - e[:, CONSTANTS:]) / (2 * NUDGE)


@dataclass(frozen=True, eq=False)
class Normal:
    """What Gauss–Newton needs at z: objective −log posterior (up to a constant), gradient and Hessian, and by event the
    whitened innovations and their slopes (of the fitted events that are readings)."""

    objective: float
    gradient: Array
    hessian: Array
    whitened: Array
    slopes: Array


def fitted_readings(recording: Recording, path: Path) -> NDArray[np.bool_]:
    return recording.fitted & np.isfinite(path.s)


def objective(problem: Problem, z: Array) -> tuple[float, list[Path]]:
    """−log posterior of z (innovations beyond `OUTLIER` count linearly); inf where the filter lost the robot."""
    total, paths = 0.5 * float(z @ z), []
    for recording in problem.recordings:
        path = problem.filtered(recording, z)
        paths.append(path)
        use = recording.fitted & (recording.kind >= 0)
        r2 = path.e[use] ** 2 / path.s[use]
        if not (np.isfinite(r2).all() and (path.s[use] > 0).all()):
            return np.inf, paths
        far = r2 > OUTLIER**2
        loss = np.where(far, 2 * OUTLIER * np.sqrt(r2) - OUTLIER**2, r2)
        total += 0.5 * problem.temper * float(loss.sum() + np.log(path.s[use]).sum())
    return total, paths


def normal_equations(problem: Problem, z: Array, paths: Sequence[Path], value: float) -> Normal:
    """Gradient and Gauss–Newton Hessian of the objective at fixed gains."""
    gradient, hessian = z.copy(), np.eye(len(z))
    whites: list[Array] = []
    slopes: list[Array] = []
    for recording, path in zip(problem.recordings, paths, strict=True):
        use = fitted_readings(recording, path)
        raw = problem.slopes(recording, z, path.gains)[use] / np.sqrt(path.s[use])[:, None]
        r = path.e[use] / np.sqrt(path.s[use])
        J = np.where(np.isfinite(raw), raw, 0.0)
        weight = np.minimum(1.0, OUTLIER / np.maximum(np.abs(r), 1e-12))
        gradient += problem.temper * (J.T @ (weight * r))
        hessian += problem.temper * (J.T @ (weight[:, None] * J))
        whites.append(r)
        slopes.append(J)
    return Normal(value, gradient, hessian, np.concatenate(whites), np.concatenate(slopes))


def gauss_newton(
    problem: Problem, z: Array, *, iterations: int, tolerance: float = 0.02, progress: Callable[[], None] | None = None
) -> tuple[Array, Normal, list[Path]]:
    """z that makes the objective least, with damping after Marquardt (1963) and bounds by projection; stops when a
    step is less than `tolerance` of every parameter's posterior deviation."""
    least = np.array([p.least for p in problem.parameters])
    value, paths = objective(problem, z)
    normal = normal_equations(problem, z, paths, value)
    damping = 1e-3
    for _ in range(iterations):
        if progress:
            progress()
        for _ in range(8):
            new, spread = _step(z, normal, damping, least, problem.active)
            now, candidate = objective(problem, new)
            if now < value + 1e-2 or (not np.isfinite(value) and np.isfinite(now)):
                break
            damping *= 10
        else:
            break
        small = np.abs((new - z) / spread).max() < tolerance
        z, value, paths, damping = new, now, candidate, damping / 5
        normal = normal_equations(problem, z, paths, value)
        if small:
            break
    return z, normal, paths


def _step(z: Array, normal: Normal, damping: float, least: Array, active: NDArray[np.bool_]) -> tuple[Array, Array]:
    """The damped step of the active parameters, those that press against their bound left out, and the deviations."""
    free = active & ~((z <= least + 1e-9) & (normal.gradient > 0))
    H = normal.hessian + damping * np.diag(np.diag(normal.hessian))
    step = np.zeros_like(z)
    step[free] = -np.linalg.solve(H[np.ix_(rows_of(free), rows_of(free))], normal.gradient[free])
    step *= min(1.0, 3.0 / max(np.abs(step).max(), 1e-12))  # at most three prior deviations at once
    return np.maximum(z + step, least), np.sqrt(np.diag(np.linalg.inv(normal.hessian)))
