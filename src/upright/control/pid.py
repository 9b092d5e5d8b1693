"""PID: a cascade of pitch and position loops and a heading loop, tuned by margins on the reduced model.

Feedback of the wheel rate with c = β/α compensates back-EMF and friction. This leaves the reduced model: a robot driven
by torques, whose pitch plane (equal commands) and heading (opposite commands) are separate. The position loop gives
ψ_ref = −(p_θ (θ − θ_r) + d_θ (θ̇ − θ̇_r)). The pitch loop is

    u = u_r + c (θ̇ − ψ̇) + p e + i ∫e + d r_f,    e = ψ − ψ_ref,
    r_f = a w + (1 − a) ψ̇,    w⁺ = r_f,    a = T_f/(T_f + dt)

with the derivative on the measured pitch alone, filtered over T_f, and back-calculation against windup (Åström and
Hägglund 2006, sections 3.4 and 3.5).
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array, Complex
from upright.control.delay import SampledRobot, sampled
from upright.control.design import Design
from upright.control.kalman import DISTURBED, Disturbed, Filter, kalman_filter
from upright.control.linear_controller import LinearController
from upright.control.lqi import unwound
from upright.control.observer import Extra, output_feedback
from upright.errors import DesignFailed
from upright.physics.dynamics import drives_speed, motor_damping, motor_gain
from upright.robots import Kit, Robot, find_kit, find_robot

STIFFNESSES = np.geomspace(1.4, 24, 10)  # pitch gains tried, against the gravity they must overcome
TIMES = np.geomspace(0.03, 0.3, 7)  # [s] derivative times tried
LAGS = (0.02, 0.1)  # integral gains tried, as a fraction of p times the rate at which the robot falls
BANDWIDTHS = np.geomspace(0.3, 3, 8)  # [rad/s] of the position loop: well below the rate at which a robot falls
DAMPINGS = (0.7, 1.0, 1.5)
FILTERED = 100.0  # the derivative time is so many times that of its filter, since the gyro has been filtered before
HEADING = 3.0, math.radians(60)  # [rad/s] crossover and phase margin of the heading loop
MARGIN = 0.6  # min |1 + L| at the motors: a largest sensitivity of 1.7 (Åström and Hägglund 2006, section 4.6)
NEARLY_BEST = 0.8  # of the best margin, where MARGIN is out of reach
LEAST = 0.1  # a sensitivity of 10: with less, the smallest error of the model topples the robot


@dataclass(frozen=True, kw_only=True)
class PidGains:
    """Motor compensation, pitch loop with its filter time [s], position and heading loop, in command units and SI."""

    motor: float
    p: float
    i: float
    d: float
    filter_time: float
    wheel: float = 0.0
    wheel_rate: float = 0.0
    yaw: float = 0.0
    yaw_rate: float = 0.0


@dataclass(frozen=True, eq=False)
class Pid(Design):
    """The tuned `gains`, the `filter` that gives them the state, and the `margin` min |1 + L| at the motors."""

    filter: Filter
    gains: PidGains
    margin: float

    def check(self) -> float:
        """The filter's residual, or how much less than `margin` the loop as built keeps, or its instability."""
        plane = _Plane(self.filter.sampled)
        if not all(plane.stable([self.gains])):
            return math.inf
        return max(self.filter.check(), self.margin - plane.margin(self.gains), 0.0)


def pid(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    *,
    heading: float = HEADING[0],
    unwinding: float = 2.0,
    gains: Mapping[str, float] | None = None,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed = DISTURBED,
) -> LinearController:
    """The cascade for `robot` on the sensors of `kit`, with a heading loop that crosses over at `heading` [rad/s].

    Of all cascades tried, in multiples of what gravity asks for, it is the stiffest against a held push that keeps the
    modulus margin min |1 + L| at the motors above `MARGIN`. With `gains`, fields of `PidGains` for pitch and position,
    nothing is tried. What saturation takes flows out of the integral within `unwinding` [s]. Raises `DesignFailed`
    where no cascade, or not this one, stabilises the robot.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    if not (heading > 0 and unwinding > 0):
        raise DesignFailed(f"heading {heading}, unwinding {unwinding}", expected="positive numbers")
    if drives_speed(robot):
        why = f"pid asks a torque for a lean, and '{robot.name}' is driven by wheel speed"
        hint = "lqg, hinf or mpc, or a cascade of your own to an acceleration"
        raise DesignFailed(why, expected="another drive", hint=hint)
    model = sampled(robot, kit, dt, reads)
    model.check_position("pid")
    estimator = kalman_filter(model, disturbed)
    plane = _Plane(model)
    still = robot.rolling()
    motor = motor_damping(still) / motor_gain(still)
    turning = _heading(model, heading)
    chosen = _tuned(plane, motor, turning) if gains is None else _given(plane, motor, turning, gains)
    K, extra = _law(model, chosen, unwinding)
    return output_feedback(estimator, K, "pid", Pid(estimator, chosen, plane.margin(chosen)), extra)


class _Plane:
    """The pitch plane, x⁺ = A x + b v for one command v of both motors, on a grid of frequencies up to Nyquist's."""

    def __init__(self, model: SampledRobot) -> None:
        self.sampled = model
        self.dt = model.dt
        self.A, self.b = _halved(model, range(4), +1)
        self.omega = np.geomspace(0.05, math.pi / model.dt, 300)
        self.z = np.exp(1j * self.omega * model.dt)
        self.response = self.respond(self.z)
        self.falling = math.log(np.abs(np.linalg.eigvals(self.A)).max()) / model.dt

    def respond(self, z: Complex) -> Complex:
        """ψ, ψ̇, θ, θ̇ per command at each z, shape (len(z), 4)."""
        n = len(self.A)
        states: Complex = np.asarray(np.linalg.solve(z[:, None, None] * np.eye(n) - self.A, self.b[:, None]), complex)
        return states[:, :4, 0]

    def margins(self, pitch: PidGains, positions: Sequence[PidGains]) -> Array:
        """min |1 + L| with the loop cut at the motors, for position loops (n,) round one of pitch."""
        x = self.response.T
        z = self.z
        wheel, wheel_rate = np.array([(gains.wheel, gains.wheel_rate) for gains in positions]).T[:, :, None]
        error = x[0] + wheel * x[2] + wheel_rate * x[3]
        keep = _keep(pitch, self.dt)
        rate = (1 - keep) * z / (z - keep) * x[1]
        command = (pitch.p + pitch.i * self.dt / (z - 1)) * error + pitch.d * rate + pitch.motor * (x[3] - x[1])
        return np.abs(1 - command).min(axis=1)

    def margin(self, gains: PidGains) -> float:
        """The same of one cascade."""
        return float(self.margins(gains, [gains])[0])

    def closed(self, gains: PidGains) -> Array:
        """A of the closed plane, with the integral and the derivative's filter as its last states."""
        k, k_w, X, W = _pitch_law(gains, self.dt)
        plane = np.eye(4, len(self.A))
        return np.block([[self.A - np.outer(self.b, k @ plane), -np.outer(self.b, k_w)], [X @ plane, W]])

    def stable(self, cascades: Sequence[PidGains]) -> list[bool]:
        """Whether each closed plane is."""
        matrices = np.array([self.closed(gains) for gains in cascades])
        return (np.abs(np.linalg.eigvals(matrices)).max(axis=1) < 1).tolist()


def _keep(gains: PidGains, dt: float) -> float:
    return gains.filter_time / (gains.filter_time + dt)


def _halved(model: SampledRobot, states: range, sign: int) -> tuple[Array, Array]:
    """The plant of `states` when the right motor gets `sign` times the left one's command."""
    plant = model.plant
    left = [*states, *range(6, len(plant.states), 2)]
    right = [*states, *range(7, len(plant.states), 2)]
    A = plant.A[np.ix_(left, left)]
    k = len(states)
    A[:k, k:] += sign * plant.A[np.ix_(list(states), right[k:])]
    b = plant.B[left, 0].copy()
    b[:k] += sign * plant.B[list(states), 1]
    return A, b


def _tuned(plane: _Plane, motor: float, heading: tuple[float, float]) -> PidGains:
    """The stiffest position loop of all that keep `MARGIN`, or `NEARLY_BEST` of the best where none does."""
    cascades: list[tuple[float, PidGains]] = []
    for pitch in _pitches(plane, motor):
        tried = list(_positions(plane, replace(pitch, yaw=heading[0], yaw_rate=heading[1])))
        cascades += zip(plane.margins(pitch, tried).tolist(), tried, strict=True)
    cascades = [(margin, gains) for margin, gains in cascades if margin >= LEAST]
    stable = plane.stable([gains for _, gains in cascades]) if cascades else []
    cascades = list(itertools.compress(cascades, stable))
    if not cascades:
        raise _no_cascade(plane)
    enough = min(MARGIN, NEARLY_BEST * max(margin for margin, _ in cascades))
    return max((gains.wheel, margin, i, gains) for i, (margin, gains) in enumerate(cascades) if margin >= enough)[3]


def _given(plane: _Plane, motor: float, heading: tuple[float, float], gains: Mapping[str, float]) -> PidGains:
    """The `gains` of pitch and position, which have to stabilise the robot."""
    result = PidGains(motor=motor, yaw=heading[0], yaw_rate=heading[1], **gains)
    if not all(plane.stable([result])):
        raise DesignFailed(f"these gains do not stabilise '{plane.sampled.robot.name}'", expected=str(PidGains.__doc__))
    return result


def _pitches(plane: _Plane, motor: float) -> Iterator[PidGains]:
    """Pitch loops of several stiffnesses, against gravity's M g L shared by both motors, and derivative times."""
    robot = plane.sampled.robot
    gravity = robot.body_mass * robot.gravity * robot.com_height / (2 * motor_gain(robot))
    for stiffness, time, lag in itertools.product(STIFFNESSES.tolist(), TIMES.tolist(), LAGS):
        p = stiffness * gravity
        yield PidGains(motor=motor, p=p, i=lag * plane.falling * p, d=time * p, filter_time=time / FILTERED)


def _positions(plane: _Plane, pitch: PidGains) -> Iterator[PidGains]:
    """Position loops round a pitch loop, by bandwidth and damping: a robot that leans accelerates, R θ̈ = g ψ."""
    scale = plane.sampled.robot.wheel_radius / plane.sampled.robot.gravity
    for omega, damping in itertools.product(BANDWIDTHS.tolist(), DAMPINGS):
        yield replace(pitch, wheel=scale * omega**2, wheel_rate=scale * 2 * damping * omega)


def _heading(model: SampledRobot, omega: float) -> tuple[float, float]:
    """Gains on yaw and its rate for that crossover [rad/s] and the phase margin of `HEADING`."""
    A, b = _halved(model, range(4, 6), -1)
    response = -np.linalg.solve(np.exp(1j * omega * model.dt) * np.eye(len(A)) - A, b)[:2]
    target = np.exp(1j * (HEADING[1] - math.pi))  # of the right motor's part, whose response is minus the left one's
    yaw, rate = np.linalg.solve([response.real, response.imag], [target.real, target.imag]).tolist()
    return yaw, rate


def _pitch_law(gains: PidGains, dt: float) -> tuple[Array, Array, Array, Array]:
    """k (4,), k_w (2,), X (2, 4) and W (2, 2) of u = −k x − k_w w, w⁺ = X x + W w, for x = [ψ, ψ̇, θ, θ̇] and
    w = [∫e, the derivative's filter]."""
    keep = _keep(gains, dt)
    error = np.array([1.0, 0.0, gains.wheel, gains.wheel_rate])
    rate = np.eye(4)[1]
    k = -gains.p * error - (1 - keep) * gains.d * rate - gains.motor * (np.eye(4)[3] - rate)
    X = np.vstack([dt * error, (1 - keep) * rate])
    return k, np.array([-gains.i, -keep * gains.d]), X, np.diag([1.0, keep])


def _law(model: SampledRobot, gains: PidGains, unwinding: float) -> tuple[Array, Extra]:
    """K on the state and the two further states of the pitch loop."""
    k, k_w, X, W = _pitch_law(gains, model.dt)
    plane = np.eye(4, len(model.plant.states))
    turn = np.zeros(len(model.plant.states))
    turn[[4, 5]] = gains.yaw, gains.yaw_rate
    K_w = np.tile(k_w, (2, 1))
    back = np.vstack([unwound(K_w[:, 0], model.dt / unwinding), np.zeros((1, 2))])
    return np.vstack([k @ plane - turn, k @ plane + turn]), Extra(W, X @ plane, K_w, back)


def _no_cascade(plane: _Plane) -> DesignFailed:
    return DesignFailed(
        f"no cascade of the kind tried stabilises '{plane.sampled.robot.name}' at {plane.dt:g} s with its delays",
        expected="a period and a dead time well below the time in which the robot falls", hint="shorten them",
    )  # fmt: skip
