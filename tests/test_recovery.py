"""What any controller could survive, against searches over other commands, the closed form and statics."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest
from numpy.typing import NDArray

from upright.certification.pushes import HELD, KNOCKED, MOST_HOLD, MOST_KNOCK, RELEASE, standard_pushes
from upright.certification.recovery import KNOCK_DURATION, largest_hold, largest_knock, means, recoverable
from upright.control import LinearController
from upright.control.reach import largest_pitch
from upright.experiment import Hold, Impulse
from upright.fleets.ensemble import tables
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.physics.dynamics import Disturbance, accelerations
from upright.physics.integrate import rk4_step
from upright.physics.linear import linearise_rolling
from upright.robots import Kit, Robot, find_kit
from upright.robots.kit import STOP
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

STEP = 0.002  # [s] of the search: a tenth of the shortest time constant of these robots
LONGEST = 1.6  # [s]: ten or more time constants of falling for all but twipr (3.6 1/s), which falls by its torque
COMMANDS = 160


def survivors(robot: Robot, kit: Kit, push: Hold | Impulse, rng: np.random.Generator) -> float:
    """The fraction of `COMMANDS` other bang-bang commands, with up to six switches each, under which it stands.

    Half of the first commands point towards the fall, a third are zero or away from it: among them are short steps
    backwards first, and early and late turns. Integrated here in NumPy, without the kernel.
    """
    able = means(robot, kit)
    levels = able.most * rng.choice([-1.0, 0.0, 1.0, 1.0], size=(COMMANDS, 7))
    levels[:40] = np.abs(levels[:40])
    ends = able.wait + np.cumsum(rng.exponential(0.12, size=(COMMANDS, 6)), axis=1)
    ends[:60, 0] = able.wait + np.linspace(0.02, 0.6, 60)  # the first switch at every time
    levels[:60, 0] = able.most
    held = isinstance(push, Hold)
    force = 0.0 if held else push.impulse / push.duration
    lean = push.pitch if held else 0.0
    rest = -push.force(robot) * robot.wheel_radius / 2 if held else 0.0  # torque of each motor, by statics
    before = rest * robot.motor_resistance / (robot.gear_ratio * robot.torque_constant)
    x: tuple[Array, ...] = (np.full(COMMANDS, lean), np.zeros(COMMANDS), np.zeros(COMMANDS))
    stands = np.ones(COMMANDS, dtype=np.bool_)
    for k in range(round(LONGEST / STEP)):
        t = k * STEP
        index = (t >= ends - 1e-9).sum(axis=1)
        u = np.full(COMMANDS, before) if t < able.wait - 1e-9 else levels[np.arange(COMMANDS), index]
        w = Disturbance(force if t < KNOCK_DURATION - 1e-9 else 0.0, robot.com_height)

        def motion(s: tuple[Array, ...], u: Array = u, w: Disturbance = w) -> tuple[Array, ...]:
            pitch, wheels, _ = accelerations((s[0], s[1], 0.0, s[2], 0.0, 0.0), (u, u), robot, w, np)
            return s[1], pitch, wheels

        x = rk4_step(motion, x, STEP)
        stands &= np.abs(x[0]) < STOP
        x = tuple(np.where(stands, v, 0.0) for v in x)
    return float(stands.mean())


USUAL = ("nxtway-gs", "twipr")  # motors that take volts, and motors that take torques


@pytest.mark.parametrize("preset", USUAL)
def test_beyond_the_bound_no_command_that_was_searched_holds(preset: str) -> None:
    robot, rng = Robot.preset(preset), np.random.default_rng(7)
    kit = find_kit(robot.kit)
    hold, knock = largest_hold(robot, kit), largest_knock(robot, kit)
    # 4 %: a step of 2 ms here, 1 ms there, and a knock that ends inside the dead time
    beyond = [Impulse(impulse=1.04 * knock, duration=KNOCK_DURATION)]
    beyond += [Hold(pitch=1.04 * hold, until=1.0)] if 1.04 * hold < STOP else []
    for push in beyond:
        assert survivors(robot, kit, push, rng) == 0.0


@pytest.mark.parametrize("preset", ["nxtway-gs", "herrera2015", "ev3way"])
def test_feedback_of_the_falling_mode_comes_near_the_largest_knock(preset: str) -> None:
    # u = −g λ wᵀx / wᵀB, with the true state and the kit's dead time; 5 %: the linear mode of a nonlinear robot
    robot = Robot.preset(preset)
    kit = dataclasses.replace(find_kit(robot.kit), jitter=0.0)
    model = linearise_rolling(robot)
    values, vectors = np.linalg.eig(model.A.T)
    index = int(np.argmax(values.real))
    w = vectors[:, index].real
    gain = -3 * float(values[index].real) / float((w @ model.B).sum()) * np.tile(w, (2, 1))
    none, reads = np.zeros((0, 0)), tuple(f"truth/{name}" for name in STATE_NAMES)
    feedback = LinearController(
        none, np.zeros((0, 6)), np.zeros((0, 6)), np.zeros((0, 2)), np.zeros((2, 0)), gain, np.zeros((2, 6)),
        reads=reads, period=kit.period,
    )  # fmt: skip
    bound, parameters = largest_knock(robot, kit), parameters_of(robot)
    pushes = [Impulse(impulse=f * bound, duration=KNOCK_DURATION) for f in (0.5, 0.95, 1.01)]
    rows = np.concatenate([tables([push], (), parameters).pushes for push in pushes])
    batch = FleetBatch(
        parameters=parameters, controller=feedback, kit=kit, kit_changes={"motor.dead_zone": [0.0]}, pushes=rows
    )
    assert simulate(batch, 3.0, threads=1).fell.tolist() == [False, False, True]


@pytest.mark.parametrize("preset", ["nxtway-gs", "ev3way", "herrera2015"])
def test_the_largest_hold_is_the_closed_form_of_the_linear_robot(preset: str) -> None:
    # 8 %: sin ψ < ψ and the friction's secant; the standing command of a hold changes what happens in the dead time
    robot = Robot.preset(preset)
    kit = find_kit(robot.kit)
    able = means(robot, kit)
    linear = largest_pitch(robot, dataclasses.replace(kit, delay=able.wait), able.most)
    assert largest_hold(robot, kit) == pytest.approx(linear, rel=0.08)


def test_both_sides_are_alike_on_level_ground_and_not_on_a_slope() -> None:
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    assert largest_hold(robot, kit) == pytest.approx(largest_hold(robot, kit, -1), rel=1e-6)
    assert largest_knock(robot, kit, 1, slope=0.1) < largest_knock(robot, kit, -1, slope=0.1)  # uphill is harder


def test_who_cannot_stand_on_a_slope_survives_nothing_there() -> None:
    # statics: the body's weight balances (M + 2m) g R sin(slope) at sin ψ' = (M + 2m) R sin(slope) / (M L), here 1.08
    robot = Robot.preset("twipr")
    kit = find_kit(robot.kit)
    slope = math.asin(1.08 * robot.body_mass * robot.com_height / (1.584 * robot.wheel_radius))
    assert largest_hold(robot, kit, slope=slope) == largest_knock(robot, kit, slope=slope) == 0.0
    assert {p.size for p in standard_pushes(robot, kit, slope=slope).values()} == {0.0}


def test_without_a_limit_everything_can_be_survived() -> None:
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("ideal")
    assert largest_hold(robot, kit) == largest_knock(robot, kit) == math.inf
    sizes = [push.size for push in standard_pushes(robot, kit).values()]
    assert sizes == [MOST_HOLD, MOST_HOLD, MOST_KNOCK * robot.body_mass]


def test_standard_pushes_are_fractions_of_what_is_possible() -> None:
    # to three digits; a weak battery makes them smaller, so that no robot is asked for what its motors cannot do
    robot = Robot.preset("ev3way")
    kit = find_kit(robot.kit)
    low, full = (standard_pushes(robot, kit, volts) for volts in (6.4, 8.4))
    for pushes in (low, full):
        front, back, knock = pushes.values()
        assert front.push == Hold(pitch=front.size, until=RELEASE)
        assert (front.size, knock.size) == pytest.approx((HELD * front.bound, KNOCKED * knock.bound), rel=5e-3)
        assert back.push.pitch == pytest.approx(-front.size, rel=5e-3)
    assert all(a.size < b.size for a, b in zip(low.values(), full.values(), strict=True))


def test_of_two_robots_only_the_stronger_is_recoverable() -> None:
    robot, kit = Robot.preset("ev3way"), Kit.preset("ev3")
    push = Impulse(impulse=1.05 * largest_knock(robot, kit), duration=KNOCK_DURATION)
    strong = robot.replace(torque_constant=1.3 * robot.torque_constant)
    assert recoverable(parameters_of([robot, strong]), means(robot, kit), push).tolist() == [False, True]
