"""The loop: what it refuses, what it records, and that it is deterministic."""

import math
from dataclasses import replace

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.control import Estimated, StateFeedback, kalman, lqr_state
from upright.errors import InvalidScenario, SpecMismatch
from upright.experiment import Drive, Hold, Impulse, Push, Slope, Turn, run
from upright.experiment.notation import push as push_of
from upright.experiment.pushes import combined
from upright.physics.dynamics import derivative, motor_gain
from upright.robots import Kit, Robot

NXT = Robot.preset("nxtway-gs")
DESIGN = lqr_state(NXT, 0.01)


def test_a_hold_is_statics():
    # docs/conventions.md: α(v_l + v_r) = −F R and M g L sin ψ = −F (h cos ψ + R) make every acceleration vanish
    for pitch in (0.1, -0.12):
        push = Hold(pitch=pitch, until=1.0)
        force = push.force(NXT)
        voltage = -force * NXT.wheel_radius / motor_gain(NXT) / 2
        slopes = derivative((pitch, 0, 3.0, 0, 0, 0), (voltage, voltage), NXT, push.at(0.5, NXT))
        # terms that cancel are of the size of MgL/a22 ~ 100 1/s², so rounding leaves about 1e-13
        assert np.abs(slopes).max() < 1e-11
        assert math.copysign(1, force) == -math.copysign(1, pitch)


def test_the_loop_holds_and_releases():
    log = run(NonlinearBody(NXT), DESIGN, Hold(pitch=0.1, until=8.0), seconds=16)
    pitch, t = log["truth/pitch"], log.t
    # the slowest closed-loop pole decides how near to rest 8 s bring it: e^(−8·|p|), with margin
    slowest = -math.log(np.abs(DESIGN.poles()).max()) / 0.01
    assert abs(pitch[(t > 7.9) & (t < 8)].mean() - 0.1) < 0.1 * math.exp(-8 * slowest) * 20 + 1e-3
    assert abs(pitch[-1]) < 0.1 * math.exp(-8 * slowest) * 20 + 1e-3
    assert (log["push/force"] != 0).sum() == 800  # 8 s of 10 ms


def test_same_arguments_give_the_same_log():
    kit = Kit.preset("nxt")
    controller = Estimated(DESIGN, kalman(NXT, kit))

    def once(seed):
        return run(Electronics(NonlinearBody(NXT), kit), controller, seconds=1, seed=seed)

    assert once(4) == once(4)
    assert once(4) != once(5)


def test_a_fall_ends_the_log_and_is_reported():
    log = run(NonlinearBody(NXT), StateFeedback(np.zeros((2, 6)), 0.01), seconds=10, start=(0.1, 0, 0, 0, 0, 0))
    assert log.origin["outcome"]["fell"]
    assert log.t[-1] < 1.0  # 0.1 rad·cosh(7.4 t) passes 1.4 rad after ln(28)/7.4 = 0.45 s


def test_drive_and_turn_are_followed():
    rate = 0.2 / NXT.wheel_radius
    log = run(
        NonlinearBody(NXT), DESIGN, reference=[Drive(speed=0.2, until=6.0), Turn(rate=0.5, until=6.0)], seconds=16
    )
    end = log.state()[-1]
    assert end[2] == pytest.approx(6 * rate, abs=0.02)  # where the reference stopped, after 10 s of settling
    assert end[4] == pytest.approx(3.0, abs=0.02)


def test_pushes_add_up_with_their_moments():
    both = combined([Push(force=1.0, start=0, height=0.1), Push(force=2.0, start=0, height=0.04)], 0.05, NXT)
    assert both.force == 3.0
    assert both.force * both.height == pytest.approx(1.0 * 0.1 + 2.0 * 0.04)


def test_an_impulse_is_its_time_integral():
    log = run(NonlinearBody(NXT, period=0.001), lqr_state(NXT, 0.001), Impulse(impulse=0.02, start=0.1), seconds=0.3)
    assert log["push/force"].sum() * 0.001 == pytest.approx(0.02, rel=1e-12)


def test_the_command_line_s_impulse_starts_like_a_force():
    assert push_of("impulse:0.02,start=0.1") == Impulse(impulse=0.02, start=0.1)


def test_a_slope_is_held_by_leaning_uphill():
    log = run(NonlinearBody(NXT), DESIGN, Slope(angle=0.05), seconds=15)
    assert log["truth/pitch"][-1] > 0.05  # measured from the floor's normal: more than the slope itself


@pytest.mark.parametrize(
    ("make", "word"),
    [
        (lambda: Hold(pitch=6.0, until=1.0), "degrees"),
        (lambda: Hold(pitch=0.1, until=0.0), "end after its start"),
        (lambda: Push(force=math.nan), "finite"),
        (lambda: Push(force=1.0, duration=0.0), "more than zero"),
        (lambda: Slope(angle=2.0), "degrees"),
        (lambda: Drive(speed=math.inf), "finite"),
        (lambda: run(NonlinearBody(NXT), DESIGN, seconds=-1), "more than zero"),
    ],
)
def test_scenarios_that_make_no_sense_are_refused(make, word):
    with pytest.raises(InvalidScenario, match=word):
        make()


def test_body_and_controller_must_fit():
    blind = Electronics(NonlinearBody(NXT), Kit.preset("nxt"))
    blind.spec = replace(blind.spec, channels=blind.spec.channels[6:])
    with pytest.raises(SpecMismatch, match="Estimated"):
        run(blind, DESIGN)
    with pytest.raises(SpecMismatch, match="multiple"):
        run(NonlinearBody(NXT, period=0.003), DESIGN)
    with pytest.raises(SpecMismatch, match="N m"):
        run(NonlinearBody(NXT), StateFeedback(DESIGN.gain, 0.01, command_unit="N m"))


def test_the_log_says_where_it_came_from():
    log = run(NonlinearBody(NXT), DESIGN, Push(force=0.5), seconds=0.5, seed=9)
    origin = log.origin
    assert origin["robot"]["name"] == "nxtway-gs"
    assert origin["body"]["kind"] == "complete nonlinear model"
    assert origin["scenario"]["seed"] == 9
    assert len(origin["controller"]["hash"]) == 64
    assert log.unit("applied/left") == "V"
