"""The twin: the robot in MuJoCo, physics that nobody here wrote.

A twin stands in for hardware; it is not hardware, and its spec says so. The floor is the plane z = 0 with x forward
at zero yaw; a slope tilts gravity instead, so that pitch is measured from the floor's normal as in the model.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib import import_module
from typing import Any

from upright.bodies.body import FALLEN, REST, BodySpec, Sample, checked, checked_period
from upright.bodies.mjcf import mjcf
from upright.errors import InvalidScenario, UprightError
from upright.physics.dynamics import CALM, Disturbance, drives_speed, mass_matrix, motor_gain, rolling_friction
from upright.physics.sensing import wheel_angles
from upright.robots import Robot
from upright.signals.signal import SENSORS, TRUTH

mujoco: Any = import_module("mujoco")  # compiled and untyped: `Any` says so to the type checker


def _not_written(_warning: str) -> None:
    """MuJoCo would write its warnings into a file of the current folder; `Twin` raises what matters."""


mujoco.set_mju_user_warning(_not_written)

_WILD = 1e9  # [rad/s²] a tenth of the acceleration at which MuJoCo gives up, and writes a file about it


class Twin:
    """`robot` simulated by MuJoCo; `period` [s] is what one `step` takes.

    `timestep` [s] is MuJoCo's own step and must divide the period; contacts settle within `contact_time` [s], at
    least twice the time step. `grip` is the coefficient of friction of the wheels. Why these defaults: docs/model.md.

    Raises `InvalidScenario` for times that do not fit, and `InvalidRobot` for a robot that no rigid body is.
    """

    def __init__(
        self,
        robot: Robot,
        period: float = 0.001,
        *,
        timestep: float = 0.00025,
        contact_time: float = 0.0005,
        grip: float = 10.0,
    ) -> None:
        self._count = _steps_per_period(period, timestep)
        self._more = [mujoco.mj_step] * (self._count - 1)
        _check_contact(timestep, contact_time, grip)
        text = mjcf(robot, timestep=period / self._count, contact_time=contact_time, grip=grip)
        channels = (*TRUTH, *SENSORS[:-1])
        self.spec = BodySpec(
            kind="twin", robot=robot, channels=channels, period=period, command_unit=robot.command_unit
        )
        self._holds(text)
        self._dragged = bool(robot.wheel_friction or robot.rolling_friction)
        servos = 2 if drives_speed(robot) else 0
        self._servos = [_SpeedServo(robot, period / self._count) for _ in range(servos)]
        lightest = robot.wheel_inertia + robot.gear_ratio**2 * robot.rotor_inertia
        self._wildest = _WILD * lightest / motor_gain(robot)
        self.reset()

    def _holds(self, text: str) -> None:
        """MuJoCo's model of this description, and its arrays, asked for once."""
        self._model = mujoco.MjModel.from_xml_string(text)
        self._data = data = mujoco.MjData(self._model)
        self._q = data.qpos
        self._v = data.qvel
        self._sensed = data.sensordata
        self._wrong = data.warning.number
        self._control, self._forces = data.ctrl, data.qfrc_applied

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:  # noqa: ARG002 (nothing here is random)
        x = checked(start, 6, "start")
        robot = self.spec.robot
        data = self._data
        pitch, pitch_rate, _, wheel_rate, yaw, yaw_rate = x
        mujoco.mj_resetData(self._model, data)
        self._slope = math.nan
        self._slope_is(0.0)
        angles = wheel_angles(x, robot)
        rates = wheel_angles((0.0, 0.0, wheel_rate, 0.0, yaw_rate, 0.0), robot)
        data.qpos[3:7] = _quaternion(pitch, yaw)
        data.qpos[7:9] = [angle - pitch for angle in angles]
        speed = robot.wheel_radius * wheel_rate
        data.qvel[:2] = speed * math.cos(yaw), speed * math.sin(yaw)
        data.qvel[3:6] = -yaw_rate * math.sin(pitch), pitch_rate, yaw_rate * math.cos(pitch)
        data.qvel[6:8] = [rate - pitch_rate for rate in rates]
        for servo, angle, rate in zip(self._servos, data.qpos[7:9].tolist(), data.qvel[6:8].tolist(), strict=False):
            servo.reset(angle, rate)
        self._settle()
        self._steps = 0
        self._yaw = yaw
        self._ready = False
        return self._sample((0.0, 0.0))

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        u = checked(command, 2, "command")
        force, height, slope = CALM if disturbance is CALM else checked(disturbance, 3, "disturbance")
        if max(abs(u[0]), abs(u[1])) > self._wildest:
            raise _unstable(self._steps * self.spec.period, u)
        self._control[:] = u
        self._slope_is(slope)
        first = mujoco.mj_step2 if self._ready else mujoco.mj_step  # positions and velocities are computed already
        if force or self._dragged or self._servos:
            for advance in (first, *self._more):
                self._load(force, height)
                for side, servo in enumerate(self._servos):
                    self._control[side] = servo.command(u[side], float(self._q[7 + side]), float(self._v[6 + side]))
                advance(self._model, self._data)
        else:
            self._forces[:] = 0.0
            first(self._model, self._data)
            mujoco.mj_step(self._model, self._data, self._count - 1)
        mujoco.mj_forward(self._model, self._data)  # sensors belong to the end of the step, not to its start
        self._steps += 1
        self._ready = True
        return self._sample(u)

    def close(self) -> None:
        """MuJoCo's memory goes with the object."""

    def _slope_is(self, slope: float) -> None:
        if slope != self._slope:
            self._slope = slope
            self._ready = False
            g = self.spec.robot.gravity
            self._model.opt.gravity[:] = -g * math.sin(slope), 0.0, -g * math.cos(slope)

    def _settle(self) -> None:
        """Sinks the wheels into the floor until the contacts carry the weight and the axle does not accelerate."""
        model = self._model
        data = self._data
        radius = self.spec.robot.wheel_radius
        depth, deeper = 1e-9 * radius, 1e-6 * radius

        def lift(depth: float) -> float:
            data.qpos[2] = radius - depth
            mujoco.mj_forward(model, data)
            return float(data.qacc[2])

        first, second = lift(depth), lift(deeper)
        lift(depth - first * (deeper - depth) / (second - first))

    def _load(self, force: float, height: float) -> None:
        """The push and the floor's drag on the wheels, as generalised forces of this instant.

        The free joint takes forces in the world's axes and torques in the body's. Drag is a torque on the wheel from
        outside, so it works on the wheel's own angle, which is the hinge's plus the pitch.
        """
        pitch, yaw = _attitude(self._q.tolist())
        rates = self._v.tolist()
        left, right = (self._drag(rate + rates[4]) for rate in rates[6:8])
        moment = force * height * math.cos(pitch) + left + right
        self._forces[:] = force * math.cos(yaw), force * math.sin(yaw), 0.0, 0.0, moment, 0.0, left, right

    def _drag(self, rate: float) -> float:
        """Torque of the floor on a wheel [N m] that turns at `rate` [rad/s]."""
        robot = self.spec.robot
        return -robot.wheel_friction * rate - rolling_friction(rate, robot)

    def _sample(self, u: tuple[float, ...]) -> Sample:
        if any(self._wrong.tolist()):  # not a number, or beyond 10¹⁰, somewhere inside
            raise _unstable(self._steps * self.spec.period, u)
        q, v = self._q.tolist(), self._v.tolist()
        pitch, yaw = _attitude(q)
        self._yaw += math.remainder(yaw - self._yaw, math.tau)
        pitch_rate, left, right = v[4], q[7], q[8]
        yaw_rate = v[5] * math.cos(pitch) - v[3] * math.sin(pitch)
        wheel = (left + right) / 2 + pitch
        wheel_rate = (v[6] + v[7]) / 2 + pitch_rate
        _, gyro, _, forward, _, up = self._sensed.tolist()
        truth = (pitch, pitch_rate, wheel, wheel_rate, self._yaw, yaw_rate)
        values = (*truth, left, right, gyro, self._yaw, forward, up)
        slipped = any(servo.slipped for servo in self._servos)
        return Sample(self._steps * self.spec.period, values, (u[0], u[1]), abs(pitch) > FALLEN, slipped)


_SERVO = 0.1  # [1] rad of the servo's natural frequency in a time step; from 0.15 on it shakes the contacts


class _SpeedServo:
    """The drive of one wheel by speed: it takes up the command within the robot's lag and limit of acceleration, and
    holds the angle that this comes to, as a stepper does, by a loop whose three poles are one frequency. Where this
    takes more than the slip torque, it gives that, and forgets the angle."""

    def __init__(self, robot: Robot, timestep: float) -> None:
        a11, a12, a22, _ = mass_matrix(1.0, 0.0, robot)
        self._inertia = (a11 * a22 - a12**2) / (2 * (a11 + 2 * a12 + a22))  # of one wheel, both turning alike
        self._frequency = _SERVO / timestep
        self._most = robot.slip_torque
        self._gain = motor_gain(robot)
        self._timestep = timestep
        self._taken = -math.expm1(-timestep / robot.speed_lag)  # [1] of what is left of the way, in a step
        self._fastest = robot.acceleration_limit * timestep

    def reset(self, angle: float, rate: float) -> None:
        """A wheel that is at this angle and rate against the body, and meant to be."""
        self.slipped = False
        self._angle = angle
        self._rate = rate
        self._sum = 0.0

    def command(self, speed: float, angle: float, rate: float) -> float:
        """The motor's command over the next time step, from a wheel at this angle and rate."""
        rise = min(max(self._taken * (speed - self._rate), -self._fastest), self._fastest)
        w = self._frequency
        away = self._angle - angle
        asked = rise / self._timestep + 3 * w * (self._rate - rate) + 3 * w**2 * away + w**3 * self._sum
        torque = self._inertia * asked
        self._rate += rise
        if abs(torque) > self._most:
            self.slipped = True
            torque = math.copysign(self._most, torque)
            self._angle = angle
        else:
            self._sum += self._timestep * away
        self._angle += self._timestep * (self._rate - rise / 2)
        return torque / self._gain


def _quaternion(pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Yaw about z after pitch about y, as (w, x, y, z)."""
    cp, sp, cy, sy = math.cos(pitch / 2), math.sin(pitch / 2), math.cos(yaw / 2), math.sin(yaw / 2)
    return cy * cp, -sy * sp, cy * sp, sy * cp


def _attitude(q: Sequence[float]) -> tuple[float, float]:
    """Pitch atan2(−R₃₁, R₃₃) and yaw atan2(−R₁₂, R₂₂) [rad] from MuJoCo's positions.

    Yaw is read from the axle (second column), which stays level; the first column turns round as pitch passes π/2.
    """
    w, x, y, z = q[3:7]
    pitch = math.atan2(2 * (w * y - x * z), 1 - 2 * (x * x + y * y))
    return pitch, math.atan2(2 * (w * z - x * y), 1 - 2 * (x * x + z * z))


def _steps_per_period(period: float, timestep: float) -> int:
    count = round(checked_period(period) / timestep) if math.isfinite(timestep) and timestep > 0 else 0
    if count < 1 or abs(count * timestep - period) > 1e-9 * period:
        raise InvalidScenario(
            f"the twin's period is {period} s with a timestep of {timestep} s",
            expected="a whole number of time steps in a period",
            hint=f"take timestep={period / max(count, 1):g}",
        )
    return count


def _check_contact(timestep: float, contact_time: float, grip: float) -> None:
    if not 2 * timestep * (1 - 1e-9) <= contact_time < math.inf:
        raise InvalidScenario(
            f"contact_time is {contact_time} s with a timestep of {timestep} s",
            expected="at least two time steps, or MuJoCo would change it silently",
        )
    if not 0 < grip < math.inf:
        raise InvalidScenario(f"grip is {grip}", expected="a positive number")


def _unstable(t: float, u: Sequence[float]) -> UprightError:
    return UprightError(
        f"the twin became unstable at t = {t:g} s under the command {list(u)}",
        likely="a command beyond any motor",
        hint="limit the command, or take a shorter timestep",
    )
