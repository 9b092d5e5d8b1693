"""Standing up from lying: a planned command lifts the body, then another controller takes over.

The floor holds a lying robot until its motors act. So its state is known: at rest, at the pitch at which it lies. The
lift is planned on the nonlinear model as a command of `PARTS` steps that ends upright and at rest, by least squares in
the commands (single shooting). It is the shortest that the motors permit, since the model's error grows with time.
Under a body that leans forward the wheels accelerate forward: the reaction lifts the body, and stops it as they brake.
The controller that takes over corrects the rest.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import ceil
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.bodies.body import Body
from upright.bodies.models import NonlinearBody
from upright.control.controller import Controller
from upright.control.reach import largest_command, largest_pitch, static_pitch
from upright.errors import DesignFailed
from upright.physics.dynamics import motor_damping, motor_gain
from upright.robots import Kit, Robot

PARTS = 6
LONGEST = 0.6  # [s] in a longer lift the model's error grows more than e⁴-fold on any robot here
KEPT = 0.1  # fraction of the largest command that the plan leaves to the kit's sag and noise
UPRIGHT = (
    0.02,
    0.1,
    1.0,
)  # [rad, rad/s, rad/s] pitch, its rate and the wheels' at the end: a tenth of what a push does
_EASE = 0.03  # weight of the commands beside the end


@dataclass(frozen=True, eq=False)
class Lift:
    """`commands` (n,) for both motors, every `period` [s], from `pitch` [rad]."""

    robot: Robot
    pitch: float
    period: float
    commands: Array

    def check(self) -> float:
        """The largest of where it ends over what counts as upright: below one is well."""
        body = NonlinearBody(self.robot, period=self.period)
        return float((np.abs(_end(body, self.pitch, self.commands)) / UPRIGHT).max())


def lift(robot: Robot, kit: Kit, pitch: float, dt: float | None = None) -> Lift:
    """The shortest lift from rest at `pitch` [rad]; `DesignFailed` says in numbers why there is none."""
    period = kit.period if dt is None else dt
    full = largest_command(robot, kit)
    most = (1 - KEPT) * full
    reach = largest_pitch(robot, kit)
    if not 0 < abs(pitch) < np.pi:
        raise DesignFailed(f"a lift from {pitch:g} rad", expected="a pitch between 0 and π, of either sign")
    if abs(pitch) > 1.1 * reach:  # exact for linear robots, and 1 to 5 % too large for the presets
        raise DesignFailed(_why(robot, kit, pitch, full, reach), hint="stronger motors, or a prop that holds it higher")
    lengths = range(2, int(LONGEST / (PARTS * period)) + 1)
    for n in lengths:
        plan = _planned(robot, pitch, period, n, most)
        if plan.check() < 1:
            return plan
    raise DesignFailed(
        f"no command up to {most:.3g} {robot.command_unit} lifts {robot.name} from {pitch:g} rad within {LONGEST:g} s",
        hint="stronger motors, or a prop that holds it higher",
    )


def _why(robot: Robot, kit: Kit, pitch: float, most: float, reach: float) -> str:
    message = (
        f"{robot.name} cannot stand up from {pitch:g} rad: {most:.3g} {robot.command_unit} bring it back from at most "
        f"{reach:.2f} rad"
    )
    if damping := motor_damping(robot):
        top = motor_gain(robot) * most / damping * robot.wheel_radius
        message += (
            f"; standing still they hold it up to {static_pitch(robot, kit):.2f} rad, but the wheels run away, and at "
            f"{top:.2f} m/s nothing is left against gravity"
        )
    return message


def _planned(robot: Robot, pitch: float, period: float, each: int, most: float) -> Lift:
    """The lift of `PARTS` commands that hold for `each` periods."""
    from scipy.optimize import least_squares

    body = NonlinearBody(robot, period=period)

    def errors(fractions: Array) -> Array:
        commands = np.repeat(most * fractions, each)
        return np.hstack([_end(body, pitch, commands) / UPRIGHT, _EASE * fractions])

    first = np.sign(pitch) * np.array([0.8, 0.5, -0.2, -0.6, -0.2, 0.2])
    result = least_squares(errors, first, bounds=(-1, 1), max_nfev=40)
    return Lift(robot, pitch, period, np.repeat(most * result.x, each))


def _end(body: Body, pitch: float, commands: Array) -> Array:
    """Pitch, its rate and the wheels' rate (3,) after `commands` (n,), one for each step of the body, from rest."""
    now = body.reset((pitch, 0.0, 0.0, 0.0, 0.0, 0.0))
    for u in commands.tolist():
        now = body.step((u, u))
    return now.values[[0, 1, 3]]


def standing_up(controller: Controller, robot: Robot, kit: Kit, pitch: float) -> StandUpController:
    """The `controller` behind the `lift` of its robot from rest at `pitch` [rad]."""
    return StandUpController(lift(robot, kit, pitch, controller.spec.period), controller, kit)


class StandUpController:
    """`lift`, then `controller` from where the robot stands then: its encoders count from there.

    Between them nothing is commanded for the kit's dead time, so that no command is on its way when it takes over.
    """

    def __init__(self, plan: Lift, controller: Controller, kit: Kit) -> None:
        self.plan = plan
        self.controller = controller
        self.spec = replace(controller.spec, stands_up=True)
        if self.spec.period != plan.period or self.spec.command_unit != plan.robot.command_unit:
            raise DesignFailed(
                f"a lift every {plan.period:g} s in {plan.robot.command_unit} before a controller every "
                f"{self.spec.period:g} s in {self.spec.command_unit}", expected="the same of both",
            )  # fmt: skip
        self._moves = np.array([("encoder" in n and "rate" not in n) or n == "truth/wheel" for n in self.spec.reads])
        self._commands = [*plan.commands.tolist(), *[0.0] * ceil(kit.delay / plan.period - 1e-9)]
        self.reset()

    def reset(self) -> None:
        self.controller.reset()
        self._k, self._from = 0, np.zeros(len(self.spec.reads))

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        self._k += 1
        if self._k <= len(self._commands):
            return self._commands[self._k - 1], self._commands[self._k - 1]
        if self._k == len(self._commands) + 1:
            self._from = np.where(self._moves, measurement, 0.0)
        return self.controller.step(measurement - self._from, reference)

    def estimate(self) -> Sequence[float]:
        return self.controller.estimate() if self._k > len(self._commands) else [0.0] * 6 * self.spec.estimates

    def applied(self, command: Sequence[float]) -> None:
        if self._k > len(self._commands):
            self.controller.applied(command)

    def to_json(self) -> dict[str, Any]:
        return {"kind": "stand up", "commands": self._commands, "controller": self.controller.to_json()}
