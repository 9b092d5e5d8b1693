"""One gain for many robots: its inequalities, its costs by simulation, and what it says of itself."""

import numpy as np
import pytest

from upright.control.delay import rolling
from upright.control.lqr import lqr
from upright.control.robust import FARTHEST, Robust, draw, robust, spreads
from upright.errors import DesignFailed, UnknownName
from upright.physics.linear import linearise
from upright.robots import Robot

pytest.importorskip("cvxpy")

NXT = Robot.preset("nxtway-gs")


@pytest.fixture(scope="module")
def family():
    return draw(NXT, 20, seed=4)


@pytest.fixture(scope="module")
def design(family):
    return robust(NXT, robots=family)


def test_one_lyapunov_function_proves_every_robot_of_the_family(design, family):
    assert isinstance(design, Robust)
    assert design.check() < 1e-6
    K, P = design.gain, design.P
    assert np.linalg.eigvalsh(P)[0] > 0
    for robot in [NXT, *family]:
        model = linearise(rolling(robot)).c2d(0.01)
        closed = model.A - model.B @ K
        fall = closed.T @ P @ closed - P + design.W + K.T @ design.R @ K
        assert np.linalg.eigvalsh(fall)[-1] < 1e-5 * np.linalg.eigvalsh(P)[-1]
        assert np.abs(np.linalg.eigvals(closed)).max() < 1


def test_the_cost_is_that_of_a_simulation(design):
    # tr(P X₀) of the nominal robot against the sum of the costs of six runs of 40 s, whose tails have died
    model = linearise(NXT).c2d(0.01)
    closed = model.A - model.B @ design.gain
    price = design.W + design.gain.T @ design.R @ design.gain
    x, total = np.diag(1 / np.sqrt(np.diag(design.W))), 0.0
    for _ in range(4000):
        total += float(np.trace(x.T @ price @ x))
        x = closed @ x
    assert design.own.nominal == pytest.approx(total, rel=1e-6)


def test_a_family_of_one_has_the_gain_of_lqr():
    alone = robust(NXT, robots=[NXT])
    assert alone.own.nominal == pytest.approx(lqr(NXT, 0.01).cost.diagonal() @ (1 / np.diag(alone.W)), rel=1e-4)


def test_plain_lqr_is_optimal_for_the_nominal_robot_and_the_verdict_says_how_both_compare(design):
    assert design.own.nominal >= design.plain.nominal * (1 - 1e-6)
    said = design.verdict()
    better = design.plain.fell > design.own.fell or design.own.worst < 0.99 * design.plain.worst
    assert said.startswith("Better" if better else "No better than plain LQR")


def test_draws_are_robots_within_their_spreads_and_repeat_with_the_seed():
    sizes = spreads(NXT)
    for robot in draw(NXT, 50, seed=7):
        for name, size in sizes.items():
            assert abs(getattr(robot, name) - getattr(NXT, name)) <= FARTHEST * size * (1 + 1e-12)
    assert draw(NXT, 3, seed=7) == draw(NXT, 3, seed=7)
    assert draw(NXT, 3, seed=7) != draw(NXT, 3, seed=8)


def test_a_covariance_correlates_the_draws():
    # both parameters move together exactly: 2000 draws have the correlation to rounding
    sizes = {"body_mass": 0.02, "com_height": 0.004}
    covariance = np.outer(list(sizes.values()), list(sizes.values()))
    robots = draw(NXT, 200, sizes=sizes, covariance=covariance)
    pairs = np.array([[r.body_mass, r.com_height] for r in robots])
    assert np.corrcoef(pairs.T)[0, 1] == pytest.approx(1.0, abs=1e-9)


def test_what_cannot_be_is_refused():
    with pytest.raises(UnknownName, match="did you mean 'body_mass'"):
        draw(NXT, 2, sizes={"bodymass": 0.1})
    with pytest.raises(DesignFailed, match="covariance"):
        draw(NXT, 2, sizes={"body_mass": 0.1}, covariance=np.array([[-1.0]]))
    with pytest.raises(DesignFailed, match="no one gain"):
        robust(NXT, 0.5, robots=draw(NXT, 12, seed=4))  # at half a second, 40 times e-folded between two commands
