"""The likelihood of raw readings: whitened innovations, and how they follow the parameters.

The filter's gains are held while the parameters move: at the truth the innovations are white, so that they are
uncorrelated with their own derivative at fixed gains, and the estimate stays consistent (Ljung 1999, section 9.2).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from upright.arrays import Array, Mask, Whole
from upright.calibration.coefficients import (
    AHEAD,
    AT,
    DELAYS,
    DRIVEN,
    EQUATION,
    LEVEL,
    NUDGE,
    ROLLING_DRY,
    TURN_READ,
    ZONE,
    ZONE_AHEAD,
    Bowls,
    Curves,
    priors_of,
)
from upright.calibration.effects import RUN, maps_of
from upright.calibration.parameters import Parameter
from upright.calibration.resonance import SWING
from upright.calibration.threads import CORES, in_threads
from upright.compiled.generated import LANES
from upright.logs.recording import SENSOR, Recording
from upright.physics.integrate import PREDICTED
from upright.physics.linear import linearise
from upright.robots import Robot

if TYPE_CHECKING:
    from upright.calibration.predictor import Events, RobotLanes


PROCESS = ("motor", "push", "gyro_bias")
STICKING = "sticking"
"""Of the motors, while a wheel sticks or turns back: which way dry friction then acts, and when it lets go, is decided
by less than a filter can know."""
JITTER = "jitter"
"""Of the moments at which commands arrive, uniformly late by up to the kit's jitter: a variance [s²] that is not
learnt."""
ROLLING = 0.004  # [s] longest step: within one a wheel's rate is taken for straight where dry friction stops it
SLIDING = 0.001  # [s] the same for a robot known to have dry friction: its error is 0.03 % of the friction then
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
    poles = linearise(robot.without_dry_friction()).poles()
    push = model.E[:, 0] + robot.com_height * model.E[:, 1]
    return float(np.abs(poles).max()), (model.B @ model.B.T, np.outer(push, push))


@dataclass(frozen=True, eq=False, kw_only=True)
class Problem:
    """Recordings, the robot they are thought to be of, what to estimate, and log-variances of process and sensors.

    Of the parameters come first those `asked`, then `EQUATIONS`, then where there are several recordings the deviations
    of each run from the robot. `held` names some that stay at their prior.
    `temper` weighs the readings against the prior: below one where innovations are not white, so that they hold less
    information than their number says (Lyddon et al. 2019). After every `restart` [s] the filter forgets the state.
    A `resonance` of the gyro that was found, its `misalignment`, or a `drop` of the driver, makes the logs likelier by
    so many nats. Logs that are `foreign` are not of a body of ours. Of the electronics some numbers are `exact`, by
    name.
    """

    recordings: tuple[Recording, ...]
    robot: Robot
    parameters: tuple[Parameter, ...]
    delays: Mapping[str, float]
    noise: Mapping[str, float]
    held: frozenset[str] = frozenset()
    temper: float = 1.0
    fine: bool = False
    restart: float = math.inf
    resonance: float = 0.0
    drop: float = 0.0
    misalignment: float = 0.0
    foreign: bool = False
    exact: Mapping[str, float] = field(default_factory=dict[str, float])
    longest: float = field(init=False)
    asked: tuple[Parameter, ...] = field(init=False)
    curves: Curves = field(init=False, repr=False)
    _shapes: tuple[Array, Array] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        fastest, shapes = _linear(self.robot)
        most = SLIDING if self.fine and self.robot.coulomb_friction else ROLLING
        object.__setattr__(self, "longest", min(most, PREDICTED / max(1.0, fastest)))
        object.__setattr__(self, "_shapes", shapes)
        shared = [p for p in self.parameters if not p.name.startswith(RUN)]
        object.__setattr__(self, "asked", tuple(p for p in shared if not p.name.startswith(EQUATION)))
        maps = maps_of(self.parameters, len(self.recordings))
        least = np.array([p.least - 2 * NUDGE for p in shared])
        priors = priors_of(self.robot, self.asked, self.delays, self.exact)
        object.__setattr__(self, "curves", Curves(maps, least, priors))

    @property
    def active(self) -> Mask:
        """Which parameters move; the others are held at their prior."""
        return np.array([p.name not in self.held for p in self.parameters])

    def run_of(self, recording: Recording) -> int:
        """Which run a recording is, among those of the problem."""
        return next((i for i, other in enumerate(self.recordings) if other is recording), 0)

    def with_noise(self, noise: Mapping[str, float]) -> Problem:
        """The same problem with these log-variances beside its others; nothing else follows from them."""
        other = copy(self)
        object.__setattr__(other, "noise", {**self.noise, **noise})
        return other

    def of_run(self, z: Array, run: int) -> Array:
        """The numbers of one run (shared, lanes) at z (parameters, lanes): the robot's, and what this run adds."""
        from upright.calibration.curves import of_run

        return of_run(np.array(z, order="C"), run, self.curves)

    def coefficients(self, recording: Recording, z: Array) -> Array:
        """The coefficients of a recording (coefficients, lanes) at z (parameters, lanes)."""
        from upright.calibration.curves import coefficients_of

        return coefficients_of(np.array(z, order="C"), self.run_of(recording), self.curves)

    def values(self, z: Array) -> dict[str, Array]:
        """What is asked (lanes,), by name, at a run's numbers z (shared, lanes)."""
        from upright.calibration.curves import numbers_at

        numbers = numbers_at(np.array(z, order="C"), self.curves.priors)
        return {p.name: numbers[place] for p, place in zip(self.asked, self.curves.priors.place, strict=True)}

    def _own(self, q: Array) -> dict[str, float]:
        """Dead time [s] of each sensor, of the coefficients q (coefficients,)."""
        return dict(zip(self.delays, q[DELAYS:].tolist(), strict=False))

    def by_parameter(self, z: Array) -> list[tuple[Array, Array]]:
        """For each run the coefficients (coefficients,) at z (parameters,), and their slopes (coefficients,
        parameters)."""
        from upright.calibration.curves import by_parameter

        return [by_parameter(np.array(z), run, self.curves) for run in range(len(self.recordings))]

    def lanes_of(self, recording: Recording, q: Array) -> RobotLanes:
        """What the predictor takes of the coefficients q (coefficients, lanes)."""
        from upright.calibration.predictor import RobotLanes

        delay = dict(zip(self.delays, q[DELAYS:], strict=False))
        delays = np.array([delay[SENSOR[row]] for row in recording.rows])
        robots, swing = (np.ascontiguousarray(part) for part in (q[:TURN_READ], q[DELAYS + len(self.delays) :]))
        return RobotLanes(recording.reads(q[AT.half_track], q[TURN_READ]), delays, robots, swing)

    def lanes(self, recording: Recording, z: Array) -> RobotLanes:
        """The same for z (parameters, lanes)."""
        return self.lanes_of(recording, self.coefficients(recording, z))

    def own_delays(self, recording: Recording, z: Array) -> Array:
        """Dead time [s] of each event (events,): zero for commands."""
        delays = self._own(self.coefficients(recording, z[:, None])[:, 0])
        return np.array([delays[SENSOR[row]] for row in recording.rows] + [0.0])[recording.kind]

    def order(self, recording: Recording, z: Array) -> Whole:
        """The events in the command's time at z (parameters,)."""
        return recording.order(self._own(self.coefficients(recording, z[:, None])[:, 0]))

    def filtered(
        self, recording: Recording, z: Array, *, keep: bool = False, until: float = np.inf, fitted: bool = False
    ) -> Path:
        """The filter at z (parameters,) along a recording, up to the time `until` [s], and where that is asked, to the
        last event that is `fitted`."""
        from upright.calibration.predictor import WIDE, Noise, kalman_path

        q = self.coefficients(recording, z[:, None])
        order = recording.order(self._own(q[:, 0]))
        readings = np.exp([self.noise[SENSOR[row]] for row in recording.rows])
        process = self.process(recording)
        jitter = np.exp(self.noise.get(JITTER, -np.inf))
        noise = Noise(recording.P0, process, jitter, readings, self.restart)
        order = order[recording.when[order] <= until]
        events = events_of(recording, _through_fitted(recording, order) if fitted else order)
        lanes = self.lanes_of(recording, np.repeat(q, WIDE, axis=1))
        return Path(*kalman_path(events, lanes, recording.first, noise, self.longest, keep))

    def process(self, recording: Recording) -> Array:
        """Covariance (2, s, s) of the process noise a second: while both wheels move, and while one sticks."""
        Q = np.zeros((2, len(recording.first), len(recording.first)))
        for name, shape in zip(PROCESS, self._shapes, strict=False):
            Q[:, :6, :6] += math.exp(self.noise[name]) * shape
        Q[1, :6, :6] += np.exp(self.noise.get(STICKING, -np.inf)) * self._shapes[0]
        Q[:, 6, 6] = np.exp(self.noise["gyro_bias"])
        if "compass" in recording.sensors:
            Q[:, 7, 7] = 1e-10
        if recording.swings:
            Q[:, -1, -1] = np.exp(self.noise.get(SWING, -np.inf))
        return Q

    def coefficient_slopes(
        self, recording: Recording, q: Array, unit: Array, gains: Array, rows: Sequence[int], *, fitted: bool = False
    ) -> Array:  # fmt: skip
        """∂e/∂q (events, rows) of those `rows` of the coefficients q, each in its `unit`, at fixed gains: by lanes
        `ahead` of q, beside one of q. NaN after the last event that is `fitted`, where that is asked."""
        from upright.calibration.predictor import innovations

        order = recording.order(self._own(q))
        events = events_of(recording, _through_fitted(recording, order) if fitted else order)
        ahead = AHEAD * unit
        ahead[ZONE] = ZONE_AHEAD * max(unit[ZONE], 0.5 * q[ZONE])

        def of(part: Whole) -> Array:
            count = len(part)
            lanes = np.repeat(q[:, None], count + 1, axis=1)
            lanes[part, np.arange(count)] += ahead[part]
            first = np.repeat(recording.first[:, None], count + 1, axis=1)
            e = innovations(events, self.lanes_of(recording, lanes), first, gains, self.longest)
            return (e[:, :count] - e[:, count:]) * (unit[part] / ahead[part])

        parts = min(len(rows), max(CORES, -(-(len(rows) + CORES) // LANES)))
        return np.concatenate(in_threads(of, np.array_split(np.array(rows), parts)), axis=1)

    def slopes(self, recording: Recording, z: Array, gains: Array) -> Array:
        """∂e/∂z (events, parameters) at fixed gains."""
        q, C = self.by_parameter(z)[self.run_of(recording)]
        unit, rows = units(C)
        return self.coefficient_slopes(recording, q, unit, gains, rows) @ (C[rows] / unit[rows, None])


def events_of(recording: Recording, order: Whole) -> Events:
    """The events of a recording for the predictor, those in `order`."""
    from upright.calibration.predictor import Events

    return Events(order, recording.kind, recording.when, recording.value, recording.commands)


def units(C: Array) -> tuple[Array, list[int]]:
    """How far the prior lets each coefficient be off (coefficients,), from its slopes C (coefficients, parameters), and
    the rows of those that move and that a level floor shows."""
    unit = np.sqrt((C**2).sum(axis=1))
    return unit, [i for i in (*LEVEL, *ROLLING_DRY, *range(DRIVEN, len(C))) if unit[i] > 0]


@dataclass(frozen=True, eq=False, kw_only=True)
class Normal:
    """What Gauss–Newton needs at z: objective −log posterior (up to a constant), gradient and Hessian, and by event the
    whitened innovations and their slopes (of the fitted events that are readings).

    The slopes are those by the coefficients, in which the objective is made of `bowls`, times the coefficients' own:
    what the equations cannot tell apart, the Hessian cannot either.
    """

    objective: float
    gradient: Array
    hessian: Array
    whitened: Array
    slopes: Array
    bowls: Bowls

    @property
    def weight(self) -> Array:
        """How much each innovation counts."""
        return huber_weight(self.whitened)


class Fitted(NamedTuple):
    """A problem, its parameters of greatest posterior z (parameters,), and the derivatives and filters there; and where
    it is one of several optima that predict half seconds equally well, the z of the `others` (n, parameters)."""

    problem: Problem
    z: Array
    normal: Normal
    paths: Sequence[Path]
    others: Sequence[Array] = ()


def huber_weight(whitened: Array) -> Array:
    """One, and less beyond `OUTLIER`."""
    return np.minimum(1.0, OUTLIER / np.maximum(np.abs(whitened), 1e-12))


def fitted_readings(recording: Recording, path: Path) -> Mask:
    return recording.fitted & np.isfinite(path.s)


def _through_fitted(recording: Recording, order: Whole) -> Whole:
    """Of the events in `order` those up to the last fitted one, on which no later one has an effect."""
    return order[: int(np.flatnonzero(recording.fitted[order]).max(initial=-1)) + 1]


def objective(problem: Problem, z: Array) -> tuple[float, list[Path]]:
    """−log posterior of z (innovations beyond `OUTLIER` count linearly); inf where the filter lost the robot in one of
    the recordings, and the path of each through what is fitted."""
    total = 0.5 * float(z @ z)
    paths = [problem.filtered(r, z, fitted=True) for r in problem.recordings]
    for recording, path in zip(problem.recordings, paths, strict=True):
        e, s = path.e[recording.judged], path.s[recording.judged]
        r2 = e**2 / s
        if not (np.isfinite(r2).all() and (s > 0).all()):
            return np.inf, paths
        far = r2 > OUTLIER**2
        loss = np.where(far, 2 * OUTLIER * np.sqrt(r2) - OUTLIER**2, r2)
        total += 0.5 * problem.temper * float(loss.sum() + np.log(s).sum())
    return total, paths


def normal_equations(problem: Problem, z: Array, paths: Sequence[Path], value: float) -> Normal:
    """Gradient and Gauss–Newton Hessian of the objective at fixed gains."""
    at = problem.by_parameter(z)
    shape = len(at), len(at[0][0])
    bowls = Bowls(np.array([q for q, _ in at]), np.zeros(shape), np.zeros((*shape, shape[1])))
    whitened: list[Array] = []
    slopes: list[Array] = []
    hessian = np.eye(len(z))
    for run, (recording, path, (q, C)) in enumerate(zip(problem.recordings, paths, at, strict=True)):
        unit, rows = units(C)
        use = fitted_readings(recording, path)
        deviation = np.sqrt(path.s[use])
        e = problem.coefficient_slopes(recording, q, unit, path.gains, rows, fitted=True)[use]
        e /= deviation[:, None] * unit[rows]
        by_coefficient = np.where(np.isfinite(e), e, 0.0)
        whitened.append(path.e[use] / deviation)
        weighed = problem.temper * huber_weight(whitened[-1])[:, None] * by_coefficient
        bowls.gradient[run, rows] = weighed.T @ whitened[-1]
        bowls.hessian[run][np.ix_(rows, rows)] = by_coefficient.T @ weighed
        hessian += C.T @ bowls.hessian[run] @ C
        slopes.append(by_coefficient @ C[rows])
    r, J = np.concatenate(whitened), np.concatenate(slopes)
    gradient = z + problem.temper * (J.T @ (huber_weight(r) * r))
    return Normal(objective=value, gradient=gradient, hessian=hessian, whitened=r, slopes=J, bowls=bowls)
