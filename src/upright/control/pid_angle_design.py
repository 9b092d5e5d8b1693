"""PID on the angle for a robot: the program's own numbers, or numbers found by the margins of its linear loop.

The pitch answers a voltage by s n(s)/d(s), as a motor at a constant voltage only makes the wheels run at a constant
speed. With ki/s the closed loop d(s) − (kp s + ki + kd s²) n(s) has the constant term d(0) − ki n(0), so that no kp or
kd removes its growing mode, and ki must exceed d(0)/n(0). A fused angle, which leans while the robot accelerates, asks
for more.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.control.delay import SampledRobot, sampled
from upright.control.design import Design
from upright.control.linear_controller import LinearController
from upright.control.pid_angle import FULL, PER_RADIAN, AnglePid
from upright.control.state_space import controller_of, plant_of
from upright.errors import DesignFailed, InvalidController, SpecMismatch, UnknownName
from upright.pages import Quantity, Say
from upright.physics.interconnect import feedback
from upright.physics.linear import linearise_rolling
from upright.physics.sensing import GYRO, PITCH, sensor_matrix
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.kit import STOP

STIFFNESSES = np.geomspace(1.4, 24, 12)  # kp tried, against the gravity that it must overcome
TIMES = np.geomspace(0.01, 0.3, 10)  # [s] kd tried, over kp
RATIOS = (1.5, 2.0, 3.0, 5.0, 8.0)  # ki tried, over the least that removes the growing mode
SLOW = (0.0, 0.3, 1.0)  # [1/s] ki tried, over kp, where none is needed
LEAST = 0.1  # min |1 + L|: a sensitivity of 10, with which the smallest error of the model topples the robot
NEAR = 1e-5  # from z = 1: nearer than any mode, and far above rounding
ON_CIRCLE = 1e-6  # of |z|: position and heading, which nothing holds, stay at 1 to rounding
WATCHED = 20.0  # [s] in which an error of the set point is followed
FACTORS = tuple(2.0 ** (sign * k / 2) for k in range(1, 21) for sign in (-1, 1))  # up to 1000, the nearest to 1 first
_GAINS = ("kp", "ki", "kd")
OWN = tuple(f.name for f in fields(AnglePid) if f.init and f.name not in ("period", "command_unit", "supply"))
"""Numbers and words of a program, as `pid_angle` takes them."""


@dataclass(frozen=True, eq=False)
class AngleDesign(Design):
    """What a `controller` on the angle does on `robot` under `kit`; `searched`: its gains were searched."""

    robot: Robot
    kit: Kit
    controller: AnglePid
    searched: bool

    @property
    def gain(self) -> Array:
        """That of the part without memory."""
        return self.controller.gain

    @property
    def growth(self) -> float:
        """[1/s] of the fastest growing mode of the linear loop; 0 where none grows."""
        return _growth(self._model, self.controller.linearised())

    @property
    def _model(self) -> SampledRobot:
        return _model(self.robot, self.kit, self.controller)

    @property
    def least_ki(self) -> float:
        """ki, in the program's unit, that removes the growing mode of a voltage drive; 0 where none is needed."""
        own = self.controller
        a, b = least_integral(self._model)
        return max(a - b * own.kp * own.per_radian, 0.0) / abs(own.per_radian) * own.ki_time

    def check(self) -> float:
        """Nothing is solved: the gains are given, or tried."""
        return 0.0

    def words(self) -> list[Say]:
        """The numbers, what they do, and what they cannot."""
        pid = self.controller
        each = f"{pid.output}/{pid.unit}"
        rate = f"{pid.output} s/{pid.unit}"
        units = (each, f"{pid.output}/({pid.unit} s)", rate)
        if pid.per == "step":
            units = (each, f"{each} a step", rate if pid.rate == "gyro" else each)
        gains = {name: Quantity(getattr(pid, name), unit) for name, unit in zip(_GAINS, units, strict=True)}
        radian = Quantity(abs(pid.per_radian) * pid.kp, pid.command_unit)
        head = Say("kp = {kp}, ki = {ki}, kd = {kd}: a radian of lean gives {radian}.", **gains, radian=radian)
        return [head, *self._limits(), *(self._falls() or self._stands())]

    def _limits(self) -> list[Say]:
        """From which lean on there is no more output, and a limit that is none."""
        pid = self.controller
        shape = pid.shape
        highest = Quantity(pid.highest, pid.output)
        lines = list[Say]()
        if pid.kp and math.isfinite(shape.limit):
            lean = Quantity((shape.limit - shape.dead_band) / abs(pid.per_radian * pid.kp), "rad")
            lines.append(Say("At {lean} of lean its output is at its limit of {highest}.", lean=lean, highest=highest))
        if math.isfinite(pid.limit) and pid.limit > pid.highest:
            limit = Quantity(pid.limit, "1")
            lines.append(Say("A limit of {limit} is more than there is: {highest}.", limit=limit, highest=highest))
        return lines

    def _stands(self) -> list[Say]:
        """What nothing holds, and what a wrong set point does: its own, where it is not upright, and one degree."""
        pid = self.controller
        lines = [] if pid.cascade else [_NOTHING_HOLDS]
        lean = pid.sign * pid.set_point / PER_RADIAN[pid.unit] - self.kit.sensors[PITCH].offset
        sizes = [round(abs(math.degrees(lean)), 1), 1.0]  # no angle is mounted or set more exactly
        return [*lines, *(self._off(math.radians(size)) for size in dict.fromkeys(sizes) if size)]

    def _falls(self) -> list[Say]:
        """That the linear loop grows and, where that is it, why; nothing where it does not."""
        growth = self.growth
        if not growth:
            return []
        pole = _worst_pole(self._model, self.controller.linearised())
        turns = abs(np.angle(pole)) / (2 * math.pi * self.controller.period)
        doubled = Quantity(math.log(2) / growth, "s", digits=2)
        lines = [Say("It falls: a deviation doubles every {time}.", time=doubled)]
        if turns:
            often = Quantity(turns, "1", digits=2)
            lines = [Say("It falls: a swing doubles every {time}, at {often} swings a second.", time=doubled,
                         often=often)]  # fmt: skip
        lines += self._without_friction(growth)
        lines += self._wrong_gains()
        own = self.controller
        sensor = self.kit.sensors[PITCH]
        true = replace(self.kit, sensors=self.kit.sensors | {PITCH: replace(sensor, time_constant=0.0)})
        on_true = replace(self, kit=true)
        least = self.least_ki
        if least and own.kp * own.sign >= 0 and own.ki < least:
            facts = {"least": Quantity(least, "1"), "ki": Quantity(own.ki, "1")}
            lines.append(Say("P and D on the angle alone always leave a growing mode."))
            if sensor.time_constant:
                lines.append(Say("ki must be above {least} on this fused angle, above {true} on the true one; it is "
                                 "{ki}.", true=Quantity(on_true.least_ki, "1"), **facts))  # fmt: skip
            else:
                lines.append(Say("ki must be above {least}; it is {ki}.", **facts))
        lines += self._times()
        if sensor.time_constant and not on_true.growth:
            lines.append(
                Say("On the true angle it would stand; one fused in {time} errs while the robot accelerates.",
                    time=Quantity(sensor.time_constant, "s"))
            )  # fmt: skip
        return lines

    def _without_friction(self, growth: float) -> list[Say]:
        """What the dry friction has to do with it, of which a linear loop counts the drag at a slow roll."""
        free = replace(self, robot=self.robot.without_dry_friction()).growth
        if not free:
            return [Say("The linear loop counts dry friction as drag; without it the loop would stand.")]
        doubled = [Quantity(math.log(2) / rate, "s", digits=2) for rate in (growth, free)]
        if str(doubled[0]) == str(doubled[1]):
            return []
        return [Say("The linear loop counts dry friction as drag; without it a deviation doubles every {time}.",
                    time=doubled[1])]  # fmt: skip

    def _wrong_gains(self) -> list[Say]:
        """A kp or kd of the wrong sign, and a kp that does not even balance the body's weight."""
        pid = self.controller
        kp, kd = pid.kp * pid.sign, pid.kd * pid.sign
        hold = _gravity(self.robot) / abs(pid.per_radian)
        if kp < 0 and pid.sign < 0:
            return [Say("kp drives it the way it does not fall: sign = 1.")]
        if kp < 0:
            return [Say("kp drives it the way it does not fall: sign = -1 where your angle is positive backwards.")]
        lines = list[Say]()
        if kp < hold:
            lines.append(
                Say("kp is too small: gravity alone asks for {hold}, and a loop that stands for a multiple.",
                    hold=Quantity(hold, "1"))
            )  # fmt: skip
        if kd * kp < 0:
            lines.append(Say("kd has the other sign than kp: it helps the fall."))
        return lines

    def _times(self) -> list[Say]:
        """The factor of all gains next to one with which it would stand."""
        own = self.controller
        for factor in FACTORS:
            scaled = replace(own, **{name: factor * getattr(own, name) for name in _GAINS})
            if not _growth(self._model, scaled.linearised()):
                times = Quantity(factor, "1", digits=2)
                return [Say("With kp, ki and kd {times} times as large the linear loop would stand.", times=times)]
        return []

    def _off(self, error: float) -> Say:
        """What an error [rad] of the set point does."""
        time, speed, travel, fell = drift(self.robot, self.controller, error)
        facts = {
            "off": Quantity(abs(error), "rad", digits=2), "speed": Quantity(abs(speed), "m/s", digits=2),
            "time": Quantity(time, "s", digits=2), "travel": Quantity(abs(travel), "m", digits=2),
        }  # fmt: skip
        if fell:
            return Say("With the set point {off} off upright it rolls at {speed} after {time}, {travel} away, and "
                       "falls.", **facts)  # fmt: skip
        return Say("With the set point {off} off upright it rolls at {speed} after {time}, {travel} away, and still "
                   "stands.", **facts)  # fmt: skip

    def to_json(self) -> dict[str, Any]:
        """The gain of the state, the growth [1/s] and the least ki."""
        return super().to_json() | {"growth": self.growth, "least_ki": self.least_ki, "searched": self.searched}


_NOTHING_HOLDS = Say("Nothing holds its position: without encoders it stands and rolls away.")


def pid_angle(robot: Robot | str, kit: Kit | str, dt: float | None = None, **own: Any) -> AnglePid:
    """The program on the fused angle of `kit`: with the `own` numbers and words of one (fields of `AnglePid`), or
    without kp with the gains whose linear loop keeps the largest distance min |1 + L| at the motors.

    Raises `SpecMismatch` for a kit without `sensor/pitch`, `DesignFailed` where no gains hold the robot.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    if PITCH not in kit.sensors:
        hint = "[sensors.pitch.time_constant] in the kit's file"
        raise SpecMismatch(f"kit '{kit.name}' has no {PITCH}", expected="a fused angle", hint=hint)
    for name in own:
        if name not in OWN:
            raise UnknownName("number of a pid-angle", name, OWN)
    alone = [name for name in _GAINS if name in own and "kp" not in own]
    if alone:
        raise InvalidController(f"{' and '.join(alone)} without kp", expected="kp as well, or none of the three")
    usual: dict[str, Any] = {"rate": "gyro" if GYRO in kit.sensors else "difference"}
    if robot.command_unit != "V":
        usual["output"] = robot.command_unit
    if "k_position" in own or "k_speed" in own:
        usual["wheel_radius"] = robot.wheel_radius
    facts: dict[str, Any] = {"period": kit.period if dt is None else dt, "command_unit": robot.command_unit}
    output = own.get("output", usual.get("output", "pwm"))
    facts["supply"] = kit.battery.voltage if output in FULL else kit.most(robot.command_unit)

    def made(**gains: Any) -> AnglePid:
        return AnglePid(**(usual | own | facts | gains))

    controller = made() if "kp" in own else _searched(robot, kit, made)
    controller.design = AngleDesign(robot, kit, controller, "kp" not in own)
    return controller


def least_integral(model: SampledRobot) -> tuple[float, float]:
    """(a, b): with kp [command/rad] the loop has no growing mode near frequency zero where ki > a − b kp
    [command/(rad s)].

    There 1 = (kp + ki dt/(z − 1)) P(z) with P = P(1) + P'(1) (z − 1) from both commands to the angle, whose root is
    beyond z = 1 until ki dt P'(1) > 1 − kp P(1). What rolls without friction has P(1) = 0 with a voltage drive.
    """
    plant = plant_of(model)
    angle = plant.C[model.reads.index(PITCH)]
    moved = plant.B.sum(axis=1)

    def response(z: float) -> float:
        return float(angle @ np.linalg.solve(z * np.eye(len(plant.A)) - plant.A, moved))

    above = response(1 + NEAR)
    below = response(1 - NEAR)
    slope = model.dt * (above - below) / (2 * NEAR)
    return 1 / slope, (above + below) / 2 / slope


def _gravity(robot: Robot) -> float:
    """Command of both motors for a radian of lean at which the pitch does not accelerate, the wheels being free."""
    model = linearise_rolling(robot)
    return -float(model.A[1, 0] / model.B[1].sum())


def _model(robot: Robot, kit: Kit, controller: AnglePid) -> SampledRobot:
    return sampled(robot, kit, controller.period, controller.spec.reads)


def _worst_pole(model: SampledRobot, linear: LinearController) -> complex:
    closed = feedback(plant_of(model), controller_of(linear, model.delay), sign=1.0)
    return complex(closed.poles()[0])


def _growth(model: SampledRobot, linear: LinearController) -> float:
    radius = abs(_worst_pole(model, linear))
    return math.log(radius) / model.dt if radius > 1 + ON_CIRCLE else 0.0


def _searched(robot: Robot, kit: Kit, made: Callable[..., AnglePid]) -> AnglePid:
    """Of all gains tried the stable ones with the largest distance: the loop is linear in kp, ki and kd."""
    ones = [made(**dict(zip(_GAINS, row, strict=True))) for row in np.eye(3).tolist()]
    model = _model(robot, kit, ones[0])
    grid = np.geomspace(0.05, math.pi / model.dt, 300)
    answers = plant_of(model).response(grid).sum(axis=1)  # readings, for one of both motors
    parts = [_returned(one.linearised(), model, grid, answers) for one in ones]
    per_radian = ones[0].per_radian
    gravity = _gravity(robot) / per_radian
    steps = ones[0].ki_time
    a, b = least_integral(model)
    rates = steps if ones[0].rate == "difference" else 1.0
    tried = list[tuple[float, tuple[float, float, float]]]()
    for stiffness in STIFFNESSES.tolist():
        kp = stiffness * gravity
        least = (a / per_radian - b * kp) * (a > b * kp * per_radian)
        integrals = [ratio * least for ratio in RATIOS] if least else [slow * kp for slow in SLOW]
        for time, ki in itertools.product(TIMES.tolist(), integrals):
            gains = (kp, ki * steps, time * kp / rates)
            L = sum(gain * part for gain, part in zip(gains, parts, strict=True))
            tried.append((float(np.abs(1 - L).min()), gains))
    for margin, gains in sorted(tried, reverse=True):
        if margin < LEAST:
            break
        controller = made(**{name: float(f"{g:.3g}") for name, g in zip(_GAINS, gains, strict=True)})
        if not _growth(model, controller.linearised()):
            return controller
    why = ", and ki against the zero of a voltage drive" if a > 0 else ""
    raise DesignFailed(
        f"no PID on the angle of the {len(tried)} tried holds '{robot.name}' at {model.dt:g} s with its delays{why}",
        expected=f"a margin min |1 + L| of {LEAST:g} at least",
        hint="a shorter period, or state feedback: lqg",
    )


def _returned(linear: LinearController, model: SampledRobot, grid: Array, answers: Any) -> Any:
    """The command that comes back for one of both motors, at each frequency."""
    K = controller_of(linear, model.delay).response(grid)
    return (K[0] * answers).sum(axis=0)


def drift(robot: Robot, controller: AnglePid, error: float) -> tuple[float, float, float, bool]:
    """When [s] the robot falls whose set point is wrong by `error` [rad], or `WATCHED`; its speed [m/s] and travel [m]
    then, and whether it did: the linear robot under the program with its limits, on the true angle and without delay.
    """
    dt = controller.period
    plant = linearise_rolling(robot).c2d(dt)
    program = replace(controller, set_point=0.0)
    read = sensor_matrix(program.spec.reads, 0.0)  # it goes straight
    x = np.zeros(6)
    reference = np.eye(6)[0] * error
    steps = round(WATCHED / dt)
    k = 0
    while k < steps and abs(x[0]) < STOP:
        x = plant.A @ x + plant.B @ program.step(read @ x, reference)
        k += 1
    return k * dt, float(x[3]) * robot.wheel_radius, float(x[2]) * robot.wheel_radius, k < steps
