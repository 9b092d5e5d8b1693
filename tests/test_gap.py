"""The ν-gap and the coprime stability margin against published values and closed forms."""

import math

import numpy as np
import pytest

from upright.errors import DesignFailed, InvalidModel
from upright.loops.gap import graph, nu_gap, stability_margin
from upright.loops.loop import Loop
from upright.physics.linear import LinearModel

control = pytest.importorskip("control")


def system(num, den):
    return LinearModel.from_control(control.tf(num, den))


@pytest.mark.parametrize(
    ("one", "other", "published"),
    [
        (([1], [1, -0.001]), ([1], [1, 0.001]), 0.0020),  # Matlab, documentation of gapmetric
        (([100], [2, 1]), ([100], [2, -1]), 0.0200),  # Zhou and Doyle (1998), section 17.2, after Vinnicombe
        (([100], [2, 1]), ([100], [1, 2, 1]), 0.8988),
        (([100], [2, -1]), ([100], [1, 2, 1]), 0.8941),
        (([1, -1], [1, 1]), ([2, -1], [1, 1]), 1 / math.sqrt(10)),  # κ² = ω²/(2(5ω² + 2)) grows to 1/10
    ],
)
def test_published_gaps(one, other, published):
    found = nu_gap(system(*one), system(*other))
    assert found == pytest.approx(published, abs=6e-5)  # four decimals are printed
    assert nu_gap(system(*other), system(*one)) == pytest.approx(found, rel=1e-6)  # it is a metric


@pytest.mark.parametrize(("gain", "published"), [(1.0, 0.7069), (10.0, 0.0995)])
def test_published_coprime_margins(gain, published):
    # Matlab, documentation of ncfmargin: 4/(s − 0.001) under gains of 1 and 10
    loop = Loop(system([4], [1, -0.001]), LinearModel.gain([[-gain]]))
    assert stability_margin(loop) == pytest.approx(published, abs=6e-5)


def test_equal_frequency_distance_with_an_unstable_pole_is_a_gap_of_one():
    # |P| is 0.1/√(ω² + 1) for both, so the chordal distance from zero peaks at 0.1/√1.01; a pole without a partner is
    # one
    nothing = LinearModel.gain([[0.0]])
    assert nu_gap(nothing, system([0.1], [1, 1])) == pytest.approx(0.1 / math.sqrt(1.01), rel=1e-9)
    assert nu_gap(nothing, system([0.1], [1, -1])) == 1.0


def test_graph_symbols_are_normalised_and_give_the_system():
    rng = np.random.default_rng(3)
    P = LinearModel(rng.normal(size=(4, 4)), rng.normal(size=(4, 2)), rng.normal(size=(3, 4)), rng.normal(size=(3, 2)))
    omega = np.array([0.0, 0.3, 2.0, 50.0])
    found = graph(P)
    right, left = found.right.matrices(omega), found.left.matrices(omega)
    assert np.allclose(right.conj().swapaxes(1, 2) @ right, np.eye(2), atol=1e-9)
    assert np.allclose(left @ left.conj().swapaxes(1, 2), np.eye(3), atol=1e-9)
    assert np.allclose(right[:, :3] @ np.linalg.inv(right[:, 3:]), P.matrices(omega), atol=1e-8)
    assert np.allclose(left @ right, 0, atol=1e-9)  # one annihilates the other


def test_no_controller_beats_the_best_margin_and_the_gap_bounds_what_is_lost():
    # Vinnicombe: arcsin b(P₂, C) ≥ arcsin b(P₁, C) − arcsin δ(P₁, P₂)
    one, other = system([1], [1, -1]), system([1.2], [1, -0.8])
    K = LinearModel.gain([[-2.4]])
    first, second = stability_margin(Loop(one, K)), stability_margin(Loop(other, K))
    assert first <= graph(one).best_margin + 1e-9
    assert math.asin(second) >= math.asin(first) - math.asin(nu_gap(one, other)) - 1e-9


def test_best_margin_of_an_integrator_is_reached_by_unit_feedback():
    # P = 1/s: b_opt = 1/√2, by C = −1 (Zhou and Doyle 1998, section 16.1)
    P = system([1], [1, 0])
    assert graph(P).best_margin == pytest.approx(1 / math.sqrt(2), rel=1e-9)
    assert stability_margin(Loop(P, LinearModel.gain([[-1.0]]))) == pytest.approx(1 / math.sqrt(2), rel=1e-6)


def test_sampling_leaves_both_numbers_where_the_map_is_exact():
    # z = (1 + s)/(1 − s) keeps them by construction: Tustin at T = 2 is that very map
    one, other = control.tf([100], [2, 1]), control.tf([100], [1, 2, 1])
    pair = [LinearModel.from_control(control.c2d(control.ss(s), 2.0, "tustin")) for s in (one, other)]
    assert nu_gap(*pair) == pytest.approx(0.8988, abs=6e-5)


def test_unstable_loops_and_systems_that_do_not_compare():
    assert stability_margin(Loop(system([1], [1, -1]), LinearModel.gain([[-0.5]]))) == 0.0
    with pytest.raises(InvalidModel, match="same period"):
        nu_gap(system([1], [1, 1]), LinearModel.gain([[1.0, 0.0]]))
    hidden = LinearModel(np.diag([1.0, -1.0]), [[0.0], [1.0]], [[0.0, 1.0]], [[0.0]])
    with pytest.raises(DesignFailed, match="unstable modes"):
        graph(hidden)
