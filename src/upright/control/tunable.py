"""The weights of a design that may be tuned: their names, their defaults for a robot, and the controller under others.

The wheels' heading is left alone: by symmetry it is a loop of its own, which no fall depends on. Of Bryson's sizes only
ratios matter, so that the command's is fixed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from upright.control.controller import Controller
from upright.control.delay import sampled
from upright.control.design import design_of
from upright.control.hinf import Expected, hinf
from upright.control.kalman import RECOVERED, Disturbed, offset_free
from upright.control.lqg import lqg
from upright.control.lqi import LARGEST_INTEGRAL, lqi
from upright.control.lqr import lqr
from upright.control.mpc import HORIZON, mpc
from upright.control.pid import Pid, pid
from upright.control.pid_angle_design import pid_angle
from upright.control.riccati import LARGEST_COMMAND, LARGEST_STATE, bryson
from upright.control.sliding import LAYER, REACH, TIME, sliding
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES

Weights = Mapping[str, float]

PLANE = STATE_NAMES[:4]
"""The states of the pitch plane, whose largest accepted deviations (Bryson's rule) are weights."""

UNITS = dict(zip(PLANE, ("rad", "rad/s", "rad", "rad/s"), strict=True)) | {
    "integral": "rad s", "motor_noise": "1", "push_walk": "N/√s", "time": "s", "reach": "1", "layer": "1",
    "horizon": "1", "disturbance": "1", "encoder_error": "rad", "gyro_error": "rad/s", "p": "command/rad",
    "i": "command/(rad s)", "d": "command s/rad", "filter_time": "s", "wheel_gain": "1", "wheel_rate_gain": "s",
    "kp": "pwm/deg", "ki": "pwm/(deg s)", "kd": "pwm s/deg",
}  # fmt: skip
"""Name of a weight → its unit."""

WIDTH = 30.0
"""A tuned weight is at most so many times its default, or its default so many times it."""
NARROWER = {"horizon": 6.0}
"""The same of some: a horizon is at most 200 periods."""


@dataclass(frozen=True)
class Tunable:
    """`defaults(robot, kit, dt)` are positive weights by name; `make(robot, kit, dt, weights)` is the controller under
    such weights, and under the defaults the controller of the method itself."""

    defaults: Callable[[Robot, Kit, float], dict[str, float]]
    make: Callable[[Robot, Kit, float, Weights], Controller]


def _regulator(robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
    """Bryson's sizes of what is shown of the pitch plane, and the filter's noise where the command enters
    (`Disturbed.motor`)."""
    hidden = sampled(robot, kit, dt).hidden
    sizes = {name: size for name, size in zip(PLANE, LARGEST_STATE, strict=False) if name not in hidden}
    return sizes | {"motor_noise": RECOVERED.motor}


def largest_of(weights: Weights) -> tuple[float, ...]:
    """Bryson's sizes (6,) with those of the pitch plane from `weights`, where they hold them."""
    default = zip(PLANE, LARGEST_STATE, strict=False)
    return (*(weights.get(name, size) for name, size in default), *LARGEST_STATE[4:])


def sized(make: Callable[..., Controller]) -> Tunable:
    """Of a weighted method of a package, `make(robot, kit, dt, largest, command)`: the sizes of the pitch plane."""

    def defaults(_robot: Robot, _kit: Kit, _dt: float) -> dict[str, float]:
        return dict(zip(PLANE, LARGEST_STATE, strict=False))

    def under(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
        return make(robot, kit, dt, largest=largest_of(weights), command=LARGEST_COMMAND[robot.command_unit])

    return Tunable(defaults, under)


def by_sizes(
    method: Callable[..., Controller],
    robot: Robot,
    kit: Kit,
    dt: float,
    *,
    largest: Sequence[float],
    command: float,
    integral: float | None = None,
    **own: Any,
) -> Controller:
    """The controller by a `method` of Q and R, from Bryson's sizes: `largest` (6,), that of the `integral` where it has
    one, and the `command`'s; `own` are further keywords of the method."""
    sizes = [*largest] if integral is None else [*largest, integral]
    return method(robot, kit, dt, Q=bryson(sizes), R=bryson([command] * 2), **own)


def _on_filter(
    method: Callable[..., Controller], robot: Robot, kit: Kit, dt: float, weights: Weights, **own: Any
) -> Controller:
    """A method of Q and R behind a filter, which has `weights` of its own beside those of the plane."""
    own.setdefault("disturbed", replace(RECOVERED, motor=weights["motor_noise"]))
    command = LARGEST_COMMAND[robot.command_unit]
    return by_sizes(method, robot, kit, dt, largest=largest_of(weights), command=command, **own)


def _lqi_defaults(robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
    return _regulator(robot, kit, dt) | {"integral": LARGEST_INTEGRAL}


def _lqi(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
    return _on_filter(lqi, robot, kit, dt, weights, integral=weights["integral"])


def _sliding_defaults(robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
    return _regulator(robot, kit, dt) | {"time": TIME, "reach": REACH, "layer": LAYER}


def _sliding(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
    own = {name: weights[name] for name in ("time", "reach", "layer")}
    return _on_filter(sliding, robot, kit, dt, weights, **own)


def _mpc_defaults(robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
    noise = offset_free(sampled(robot, kit, dt))
    own = {"motor_noise": noise.motor, "push_walk": noise.push_walk, "horizon": float(HORIZON)}
    return _regulator(robot, kit, dt) | own


def _mpc(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
    noise = Disturbed(motor=weights["motor_noise"], push_walk=weights["push_walk"])
    return _on_filter(mpc, robot, kit, dt, weights, disturbed=noise, horizon=round(weights["horizon"]))


def _hinf_defaults(_robot: Robot, _kit: Kit, _dt: float) -> dict[str, float]:
    expected = Expected()
    own = {"encoder_error": expected.errors[0], "gyro_error": expected.errors[1], "disturbance": expected.disturbance}
    return dict(zip(PLANE, expected.state, strict=False)) | own


def _hinf(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
    errors = (weights["encoder_error"], weights["gyro_error"])
    expected = Expected(state=largest_of(weights), disturbance=weights["disturbance"], errors=errors)
    return hinf(robot, kit, dt, expected=expected)


PID_GAINS = {
    "p": "p", "i": "i", "d": "d", "filter_time": "filter_time", "wheel_gain": "wheel", "wheel_rate_gain": "wheel_rate",
}  # fmt: skip
"""Name of a weight → field of `PidGains`."""


def _pid_defaults(robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
    record = design_of(pid(robot, kit, dt))
    assert isinstance(record, Pid)
    return {name: float(getattr(record.gains, field)) for name, field in PID_GAINS.items()}


def _pid(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
    return pid(robot, kit, dt, gains={field: weights[name] for name, field in PID_GAINS.items()})


def _angle_defaults(robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
    plain = pid_angle(robot, kit, dt)
    return {name: gain for name, gain in (("kp", plain.kp), ("ki", plain.ki), ("kd", plain.kd)) if gain}


def _angle(robot: Robot, kit: Kit, dt: float, weights: Weights) -> Controller:
    return pid_angle(robot, kit, dt, **weights)


TUNABLE: dict[str, Tunable] = {
    "lqr": Tunable(_regulator, partial(_on_filter, lqr)),
    "lqi": Tunable(_lqi_defaults, _lqi),
    "lqg": Tunable(_regulator, partial(_on_filter, lqg)),
    "pid": Tunable(_pid_defaults, _pid),
    "pid-angle": Tunable(_angle_defaults, _angle),
    "hinf": Tunable(_hinf_defaults, _hinf),
    "mpc": Tunable(_mpc_defaults, _mpc),
    "sliding": Tunable(_sliding_defaults, _sliding),
}
"""Of our methods."""
