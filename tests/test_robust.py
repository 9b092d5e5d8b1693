"""One controller for many robots: its inequalities, its costs by other routes, and what it says of itself."""

from functools import cache

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.control.delay import sampled, sent
from upright.control.family import family, halves, plane
from upright.control.guaranteed import excess, guaranteed
from upright.control.kalman import RECOVERED, kalman_filter
from upright.control.lqr import lqr_state
from upright.control.observed import observed
from upright.control.riccati import LARGEST_STATE, bryson
from upright.control.robust import WORTH, Costs, Robust, robust
from upright.errors import DesignFailed
from upright.experiment import Drive, Hold, Turn, run
from upright.loops.loop import robot_loop
from upright.physics.linear import linearise_rolling
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import STATE_NAMES

pytestmark = pytest.mark.needs("module:cvxpy")

NXT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
W, PRICE = bryson(LARGEST_STATE)[:4, :4], 2 / 4.0**2


@cache
def drawn():
    return draw(NXT, 20, seed=4)


@cache
def design():
    return robust(NXT, KIT, robots=drawn())


@pytest.mark.parametrize("preset", ["nxtway-gs", "ev3way", "twipr"])
def test_the_plane_has_the_poles_of_the_whole_loop(preset):
    # the same loop assembled in full from the finished controller's matrices, for robots it was not designed for: the
    # plane's largest pole is the loop's, since heading decays faster; late sensors and 53 ms of dead time among them
    robot = Robot.preset(preset)
    kit = Kit.preset(robot.kit)
    others = draw(robot, 3, seed=1)
    controller = observed(lqr_state(robot, kit.period), robot, kit)
    seen, estimator = sampled(robot, kit), controller.design.filter
    loops = family([plane(sampled(each, kit)) for each in others], estimator)
    out, _ = halves([*STATE_NAMES, *sent(seen.history)])
    k = (controller.design.feedback.gain @ seen.ahead @ out)[0]
    whole = [float(np.abs(robot_loop(controller, each, kit).closed.poles()[0])) for each in others]
    assert loops.radii(k) == pytest.approx(whole, abs=1e-7)


def test_the_cost_is_that_of_a_noisy_run():
    # E[xᵀWx + price u²] against the mean over 5e4 periods of the plane driven by its own noise: its slow modes
    # remember some hundred of them, so that the mean of so many squares is known to √(2·100/5e4) = 6 %
    seen = sampled(NXT, KIT)
    loops = family([plane(seen)], kalman_filter(seen, RECOVERED))
    k = (
        np.concatenate([lqr_state(NXT, 0.01).gain[0, :4], [0, 0]])
        @ seen.ahead
        @ halves([*STATE_NAMES, *sent(seen.history)])[0]
    )
    rng = np.random.default_rng(0)
    row, closed = k @ loops.F, loops.M[0] - np.outer(loops.b[0], k @ loops.F)
    count = 50_000
    push, noise = rng.normal(size=(count, 2)), rng.normal(size=(count, 2)) * np.sqrt(loops.noise)
    enters = push @ loops.G[0].T + noise @ (loops.N - np.outer(loops.b[0], k @ loops.Fy)).T
    x, total = np.zeros(len(closed)), 0.0
    for w, v in zip(enters, noise, strict=True):
        u = -row @ x - k @ loops.Fy @ v
        total += x[:4] @ W @ x[:4] + PRICE * u * u
        x = closed @ x + w
    assert loops.costs(k, W, PRICE)[0] == pytest.approx(total / count, rel=0.06)


def test_doubling_equals_the_lyapunov_equation_and_an_unstable_loop_costs_infinity():
    seen = sampled(NXT, KIT)
    loops = family([plane(seen)], kalman_filter(seen, RECOVERED))
    k = design().design.k
    assert loops.costs(k, W, PRICE)[0] == pytest.approx(loops.direct(k, W, PRICE), rel=1e-9)
    assert loops.costs(-k, W, PRICE)[0] == np.inf


def models(robots, dt=0.01):
    found = [linearise_rolling(each).c2d(dt) for each in robots]
    return [(m.A[:4, :4], m.B[:4].sum(axis=1)[:, None]) for m in found]


def test_one_lyapunov_function_proves_every_robot_of_the_family():
    family_ = models([NXT, *drawn()])
    found = guaranteed(family_, W, PRICE, 1 / np.sqrt(np.diag(W)))
    assert found.check() < 1e-6
    assert np.linalg.eigvalsh(found.P)[0] > 0
    for A, b in family_:
        assert excess((A, b), found.k, found.P, W, PRICE) < 1e-5
        assert np.abs(np.linalg.eigvals(A - b * found.k)).max() < 1


def test_a_family_of_one_has_the_gain_of_lqr():
    # for one system the inequalities are tight at the Riccati solution; Clarabel stops at 1e-7 of the cost, and the
    # gain moves by the root of that
    found = guaranteed(models([NXT]), W, PRICE, 1 / np.sqrt(np.diag(W)))
    assert found.k == pytest.approx(lqr_state(NXT, 0.01).gain[0, :4], rel=1e-2)


def test_it_is_better_than_plain_lqr_where_it_says_so_and_checks_itself():
    found = design().design
    assert isinstance(found, Robust)
    # the nominal cost by SciPy, the filter's Riccati equation, and the inequalities to Clarabel's tolerance
    assert found.check() < 1e-6
    assert found.verdict().template.startswith("Better")


def test_what_is_called_better_is_better_on_robots_that_nobody_has_drawn_yet():
    # fresh robots, their costs by SciPy's Lyapunov solver instead of doubling, and the whole loop's poles by
    # `robot_loop`: neither the design nor its verdict has used any of these
    controller, fresh = design(), draw(NXT, 12, seed=99)
    found, nominal = controller.design, sampled(NXT, KIT)
    spread = halves([*STATE_NAMES, *sent(nominal.history)])[0]
    plain = np.concatenate([lqr_state(NXT, 0.01).gain[0, :4], [0, 0]]) @ nominal.ahead @ spread
    worst = [
        max(family([plane(sampled(each, KIT))], filter_).direct(k, found.W, found.price) for each in fresh)
        for filter_, k in ((found.filter, found.k), (kalman_filter(nominal, RECOVERED), plain))
    ]
    assert worst[0] < (1 - WORTH) * worst[1]
    assert all(robot_loop(controller, each, KIT).stable for each in fresh)


def test_the_design_tells_what_became_of_the_inequalities():
    found = design().design
    assert any("inequalities" in said.template for said in found.words())


def test_the_verdict_says_plainly_when_it_is_no_better():
    found, same = design().design, Costs(1.0, 2.0, 0, 20)

    def verdict(own, plain=same):
        fields = {
            name: getattr(found, name) for name in ("filter", "k", "W", "price", "method", "proof", "inequalities")
        }
        return str(Robust(**fields, own=own, plain=plain).verdict()).replace("\u00a0", " ")

    assert verdict(same).startswith("No better than plain LQR")
    assert verdict(Costs(1.1, 1.0, 0, 20)).startswith("Better: the worst cost is 50 % lower")
    assert verdict(Costs(1.0, np.inf, 3, 20)).startswith("No better: 3 of 20")
    assert verdict(same, Costs(1.0, np.inf, 3, 20)).startswith("Better: 0 of 20")


def test_it_stabilises_robots_that_it_has_not_seen():
    others = draw(NXT, 20, seed=9)
    assert all(robot_loop(design(), each, KIT).stable for each in others)


@pytest.mark.parametrize("pitch", [0.1, -0.12])
def test_it_holds_the_papers_pushes_on_raw_sensors(pitch):
    log = run(Electronics(NonlinearBody(NXT, period=0.002), KIT), design(), Hold(pitch=pitch, until=3), seconds=6)
    assert not log.origin["outcome"]["fell"]


def test_it_drives_turns_and_stops():
    goal = [Drive(speed=0.15, start=0.5, until=3), Turn(rate=0.8, start=1, until=2.5)]
    log = run(Electronics(NonlinearBody(NXT, period=0.002), KIT), design(), reference=goal, seconds=8)
    assert not log.origin["outcome"]["fell"]
    last = {name: log[f"truth/{name}"][-1] - log[f"reference/{name}"][-1] for name in ("wheel", "yaw")}
    # [rad] 5 cm: it has no integral, and rests where the gyro's bias leans it; three times what that does over seeds
    assert abs(last["wheel"]) < 1.2
    assert abs(last["yaw"]) < 0.05


@pytest.mark.evidence
def test_dead_time_is_part_of_the_design():
    # 53 ms: a gain designed without them falls at once; of draws within a fifth of the spreads none is unstable
    robot = Robot.preset("twipr")
    kit = Kit.preset("twipr")
    found = robust(robot, kit, uncertainty=Uncertainty.of(robot).scaled(0.2), tried=5).design
    assert found.own.fell == 0


def test_what_cannot_be_is_refused():
    slow = models(drawn(), 0.5)  # e-folded 40 times between two commands
    with pytest.raises(DesignFailed, match="no one gain"):
        guaranteed(slow, W, PRICE, 1 / np.sqrt(np.diag(W)))
