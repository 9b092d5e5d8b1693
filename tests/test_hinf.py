"""H∞ designs: the measured norm against γ, SLICOT's own norm, and every preset on raw sensors."""

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.control.delay import sampled
from upright.control.hinf import Expected, Hinf, hinf, hinf_norm
from upright.control.linear_controller import LinearController
from upright.errors import DesignFailed, SpecMismatch
from upright.experiment import Drive, Hold, run
from upright.loops.loop import robot_loop
from upright.loops.margins import margins
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot, preset_names

pytestmark = pytest.mark.needs("module:slycot")


@pytest.fixture(scope="module")
def designs():
    robots = [Robot.preset(name) for name in preset_names()]
    return {robot.name: (robot, Kit.preset(robot.kit), hinf(robot, Kit.preset(robot.kit))) for robot in robots}


def test_the_norm_is_that_of_a_dense_grid_and_of_closed_forms():
    rng = np.random.default_rng(5)
    A = rng.normal(size=(5, 5))
    A *= 0.95 / np.abs(np.linalg.eigvals(A)).max()  # stable, with a resonance
    system = LinearModel(A, rng.normal(size=(5, 2)), rng.normal(size=(3, 5)), rng.normal(size=(3, 2)), 0.01)
    gains = np.linalg.norm(system.matrices(np.linspace(0, np.pi / 0.01, 200_001)), 2, axis=(1, 2))
    # a peak of width 1 − |pole| = 0.05 between points 1.6e-5 apart is missed by less than their ratio squared, 1e-7
    assert hinf_norm(system) == pytest.approx(gains.max(), rel=1e-6)
    # 1/(z − a) peaks at z = 1, and 1/(s² + 2ζs + 1) at 1/(2ζ√(1 − ζ²)) (Zhou and Doyle 1998, section 4.5)
    assert hinf_norm(LinearModel([[0.9]], [[1.0]], [[1.0]], dt=0.01)) == pytest.approx(10.0, rel=1e-9)
    zeta = 0.1
    resonant = LinearModel([[0, 1], [-1, -2 * zeta]], [[0.0], [1.0]], [[1.0, 0.0]])
    assert hinf_norm(resonant) == pytest.approx(1 / (2 * zeta * np.sqrt(1 - zeta**2)), rel=1e-9)
    assert hinf_norm(LinearModel([[1.1]], [[1.0]], dt=0.01)) == np.inf


@pytest.mark.parametrize("name", preset_names())
def test_measured_norm_does_not_exceed_gamma(designs, name):
    design = designs[name][2].design
    assert isinstance(design, Hinf)
    for channel in (design.forward, design.turning):
        assert channel.norm() <= channel.gamma * (1 + 1e-9)
        assert channel.norm() > channel.gamma / 1.1 * 0.98  # γ is 1.1 times the least, found to 2⁻¹⁶ by bisection
    assert design.check() == 0.0


@pytest.mark.parametrize("name", preset_names())
def test_the_design_steers_the_robot_it_was_made_for(designs, name):
    # the two channels put together and split again are the loop: same largest pole, by another route
    robot, kit, controller = designs[name]
    loop = robot_loop(controller, robot, kit)
    channels = controller.design.forward, controller.design.turning
    assert loop.stable
    slowest = max(float(np.abs(channel.closed.poles()[0])) for channel in channels)
    assert abs(loop.closed.poles()[0]) == pytest.approx(slowest, abs=1e-6)


@pytest.mark.parametrize("pitch", [0.1, -0.12])
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name in ("nxtway-gs", "twipr") else pytest.mark.evidence)
        for name in preset_names()
    ],
)
def test_every_preset_stands_through_the_papers_pushes_on_raw_sensors(designs, name, pitch):
    robot, kit, controller = designs[name]
    body = Electronics(NonlinearBody(robot), kit)
    log = run(body, controller, Hold(pitch=pitch, until=3.0), seconds=6, seed=1)
    assert not log.origin["outcome"]["fell"]
    assert not controller.spec.reads_truth


def test_a_reference_is_followed_and_held(designs):
    robot, kit, controller = designs["nxtway-gs"]
    log = run(NonlinearBody(robot), controller, reference=Drive(speed=0.1, until=4.0), seconds=9)
    assert abs(log["truth/wheel"][-1] - log["reference/wheel"][-1]) < 0.05  # [rad] after 5 s, no noise: e⁻⁵ of 10 rad
    assert kit.name == "nxt"


def test_saturation_correction_changes_nothing_while_nothing_saturates(designs):
    # with a = u the anti-windup term vanishes: the linear loop has the poles of the design, whatever H is
    robot, kit, controller = designs["twipr"]
    assert isinstance(controller, LinearController)
    assert sampled(robot, kit).delay == 5  # 53 ms at 10 ms: five whole periods, so a late report is tested
    assert robot_loop(controller, robot, kit).stable


def test_the_margin_is_wider_than_lqgs_on_nxtway(designs):
    from upright.control.lqg import lqg

    robot, kit, controller = designs["nxtway-gs"]
    ours, theirs = (margins(robot_loop(c, robot, kit).at_input, (1, 1)) for c in (controller, lqg(robot, kit)))
    assert ours.Ms < theirs.Ms  # what the method is for: LQG has no guaranteed margins (Doyle 1978)


@pytest.mark.parametrize(
    "wants", [{"state": (1.0,) * 5}, {"errors": (0.1, -1.0)}, {"disturbance": 0.0}, {"command": 0.0}]
)
def test_bad_weights_are_refused(wants):
    with pytest.raises(DesignFailed, match="weights"):
        hinf(Robot.preset("nxtway-gs"), Kit.preset("nxt"), expected=Expected(**wants))


def test_slack_of_one_and_a_blind_kit_are_refused():
    with pytest.raises(DesignFailed, match="slack"):
        hinf(Robot.preset("nxtway-gs"), Kit.preset("nxt"), slack=1.0)
    with pytest.raises(SpecMismatch, match="encoder"):
        hinf(Robot.preset("nxtway-gs"), Kit(name="blind"))
