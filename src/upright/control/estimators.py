"""From raw sensors to the state: the steady Kalman filter and the complementary filter."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from upright.arrays import Array
from upright.control.controller import Controller, ControllerSpec, Lawful
from upright.control.delay import RAW, sampled, sensor_of
from upright.control.design import gain_of
from upright.control.kalman import DISTURBED, Disturbed, corrected, kalman_filter, one_step
from upright.control.law import as_law
from upright.control.linear_controller import Law, LinearController
from upright.errors import InvalidController
from upright.physics.dynamics import turn_ratio
from upright.robots import Kit, Robot, find_kit, find_robot

ACCELEROMETER = ("sensor/accel_forward", "sensor/accel_up")


class Estimator(Protocol):
    """`update(measurement)` gives the state (6,) now; `predict(command)` moves on one period under the command
    that was really applied. `reads` names the channels of the measurement."""

    @property
    def reads(self) -> tuple[str, ...]: ...

    def reset(self) -> None: ...

    def update(self, measurement: Array) -> Array: ...

    def predict(self, command: Sequence[float]) -> None: ...

    def to_json(self) -> dict[str, Any]: ...


class Estimated(Lawful):
    """A controller of the state behind an estimator: what a real robot can run."""

    def __init__(self, controller: Controller, estimator: Estimator) -> None:
        inner = controller.spec
        self.controller, self.estimator = controller, estimator
        kind = f"{inner.kind} behind a {estimator.to_json()['kind']}"
        self.spec = ControllerSpec(kind, estimator.reads, inner.period, inner.command_unit, estimates=True)
        self.reset()

    def reset(self) -> None:
        self.controller.reset()
        self.estimator.reset()
        self._state = np.zeros(6)

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        self._state = self.estimator.update(measurement)
        return self.controller.step(self._state, reference)

    def estimate(self) -> Sequence[float]:
        return self._state.tolist()

    def applied(self, command: Sequence[float]) -> None:
        self.estimator.predict(command)
        self.controller.applied(command)

    @property
    def form(self) -> str:
        """Of its file."""
        return f"estimated {getattr(self.controller, 'form', self.controller.spec.kind)}"

    @property
    def gain(self) -> Array | None:
        """That of the controller."""
        return gain_of(self.controller)

    def words(self) -> Sequence[Any]:
        """Those of the controller."""
        return getattr(self.controller, "words", list)()

    def law(self) -> Law:
        estimator: Any = self.estimator
        law = as_law(self.controller)
        if law.nonlinear or len(law.linear.A) or not hasattr(estimator, "before"):
            raise InvalidController(f"a {self.spec.kind} has no known linear form", expected="a fixed gain behind one")
        return Law(estimator.before(law.linear, self.spec))

    def to_json(self) -> dict[str, Any]:
        parts = {"controller": self.controller.to_json(), "estimator": self.estimator.to_json()}
        return {"kind": self.spec.kind, "period": self.spec.period, "command_unit": self.spec.command_unit, **parts}


@dataclass(eq=False)
class Kalman:
    """The steady-state filter x̂ = x̂⁻ + L (y − C x̂⁻), x̂⁻ = A x̂ + B u (Anderson and Moore 1979, ch. 4).

    The states are the robot's six, the gyro's bias [rad/s] and a push at the centre of mass [N], both random walks.
    Without the push as a state, a steady force would look like a lean. y holds both encoders and the gyro.
    Build it with `kalman`.
    """

    A: Array
    B: Array
    C: Array
    L: Array
    reads: tuple[str, ...] = RAW
    _x: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        self._x = np.zeros(len(self.A))

    def update(self, measurement: Array) -> Array:
        self._x = corrected(self._x, measurement, self.C, self.L)
        return self._x[:6]

    def predict(self, command: Sequence[float]) -> None:
        self._x = self.A @ self._x + self.B @ np.asarray(command)

    def before(self, feedback: LinearController, spec: ControllerSpec) -> LinearController:
        """u = Dy x̂ + Dr r of a static `feedback`, where z is the filter's state before the reading."""
        A, By, after = one_step(self.A, self.C, self.L)
        S, Sy = after[:6], self.L[:6]
        C, Dy = feedback.Dy @ S, feedback.Dy @ Sy
        return LinearController.like(spec, A, By, np.zeros((len(A), 6)), self.B, C, Dy, feedback.Dr, S=S, Sy=Sy)

    def to_json(self) -> dict[str, Any]:
        matrices = {name: getattr(self, name).tolist() for name in "ABCL"}
        return {"kind": "Kalman filter", "reads": list(self.reads), **matrices}


def kalman(robot: Robot | str, kit: Kit | str, dt: float | None = None, disturbed: Disturbed = DISTURBED) -> Kalman:
    """The filter for `robot` under `kit`, every `dt` [s] (None: the kit's period): `kalman.kalman_filter` of the kit
    without its delays.

    Raises `SpecMismatch` for a kit without both encoders and a gyro, `DesignFailed` when it has no solution.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    sensors = {name: replace(sensor_of(kit, name), delay=0.0) for name in RAW}
    prompt = Kit(name=kit.name, sensors=sensors, period=kit.period)
    steady = kalman_filter(sampled(robot, prompt, dt), disturbed)
    return Kalman(steady.sampled.linear.A, steady.sampled.now, steady.sampled.linear.C, steady.L)


@dataclass(eq=False)
class Complementary:
    """Pitch from the gyro at high and gravity at low frequency, the rest from encoders (Mahony et al. 2008, sec. II).

    ψ̂⁺ = a (ψ̂ + dt·gyro) + (1 − a) ψ_slow with a = τ/(τ + dt). ψ_slow is the accelerometer's pitch where the kit has
    one, else zero: a robot that balances is upright in the mean. Rates of wheel and yaw are differences, low-passed
    with `rate_time` [s]. `turn` is W/(2R).
    """

    turn: float
    dt: float
    time: float = 2.0
    rate_time: float = 0.03
    accelerometer: bool = False
    _state: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if not (self.turn > 0 and self.dt > 0 and self.time >= 0 and self.rate_time >= 0):
            raise InvalidController("a complementary filter has times and W/(2R) that are positive")
        self.reset()

    @property
    def reads(self) -> tuple[str, ...]:
        return (*RAW, *(ACCELEROMETER if self.accelerometer else ()))

    def reset(self) -> None:
        self._state = np.zeros(6)
        self._first = True

    def update(self, measurement: Array) -> Array:
        left, right, gyro = measurement[:3].tolist()
        slow = math.atan2(-measurement[3], measurement[4]) if self.accelerometer else 0.0
        pitch, _, wheel, wheel_rate, yaw, yaw_rate = self._state.tolist()
        keep = self.time / (self.time + self.dt)
        pitch = slow if self._first else keep * (pitch + self.dt * gyro) + (1 - keep) * slow
        new_wheel = (left + right) / 2 + pitch
        new_yaw = (right - left) / (2 * self.turn)
        if self._first:
            wheel = new_wheel
            yaw = new_yaw
            self._first = False
        smooth = self.rate_time / (self.rate_time + self.dt)
        wheel_rate = smooth * wheel_rate + (1 - smooth) * (new_wheel - wheel) / self.dt
        yaw_rate = smooth * yaw_rate + (1 - smooth) * (new_yaw - yaw) / self.dt
        self._state = np.array([pitch, gyro, new_wheel, wheel_rate, new_yaw, yaw_rate])
        return self._state

    def predict(self, command: Sequence[float]) -> None:
        """This filter knows no model, so the command tells it nothing."""

    def to_json(self) -> dict[str, Any]:
        numbers = {name: getattr(self, name) for name in ("turn", "dt", "time", "rate_time", "accelerometer")}
        return {"kind": "complementary filter", "reads": list(self.reads), **numbers}


def complementary(robot: Robot | str, kit: Kit | str, dt: float | None = None, **options: float) -> Complementary:
    """The complementary filter for `robot` under `kit`, every `dt` [s] (None: the kit's period), with the kit's
    accelerometer where there is one."""
    robot, kit = find_robot(robot), find_kit(kit)
    for name in RAW:
        sensor_of(kit, name)
    accelerometer = all(name in kit.sensors for name in ACCELEROMETER)
    period = kit.period if dt is None else dt
    return Complementary(turn_ratio(robot), period, accelerometer=accelerometer, **options)
