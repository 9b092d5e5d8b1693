"""Closings, series and blocks are those of python-control."""

import control
import numpy as np
import pytest

from upright.errors import InvalidModel
from upright.physics.interconnect import append, feedback, lft
from upright.physics.linear import LinearModel, delay_line

OMEGA = np.geomspace(0.01, 30, 25)


def drawn(n: int, m: int, p: int, *, seed: int, dt: float = 0.1) -> LinearModel:
    """A system whose inputs show at once."""
    rng = np.random.default_rng(seed)
    A, B, C, D = (rng.normal(size=shape) for shape in ((n, n), (n, m), (p, n), (p, m)))
    return LinearModel(0.3 * A, B, C, 0.3 * D, dt)


def same(ours: LinearModel, theirs: control.StateSpace) -> None:
    at = np.exp(1j * OMEGA * ours.dt) if ours.dt else 1j * OMEGA
    # one solution of linear equations each
    np.testing.assert_allclose(ours.response(OMEGA), theirs(at, squeeze=False), rtol=1e-9, atol=1e-12)


@pytest.mark.parametrize("dt", [0.0, 0.1])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_feedback(dt, sign):
    forward, back = drawn(4, 2, 3, seed=1, dt=dt), drawn(2, 3, 2, seed=2, dt=dt)
    same(feedback(forward, back, sign), control.feedback(forward.to_control(), back.to_control(), sign))


def test_lft():
    plant, controller = drawn(5, 4, 5, seed=3), drawn(3, 3, 2, seed=4)
    same(lft(plant, controller), plant.to_control().lft(controller.to_control()))


def test_lft_of_nothing_but_gains():
    # y = w + u and u = y / 2 give y = 2 w
    doubled = lft(LinearModel.gain([[1.0, 1.0], [1.0, 1.0]], 0.1), LinearModel.gain([[0.5]], 0.1))
    assert float(doubled.D[0, 0]) == pytest.approx(2.0)
    assert lft(drawn(2, 3, 3, seed=5), delay_line(2, 0, 0.1)).A.shape == (2, 2)


def test_series_and_append():
    one, other = drawn(3, 2, 2, seed=6), drawn(2, 2, 1, seed=7)
    same(other * one, other.to_control() * one.to_control())
    same(append(one, other), control.append(one.to_control(), other.to_control()))


def test_two_periods_do_not_meet():
    with pytest.raises(InvalidModel, match="equal periods"):
        append(drawn(1, 1, 1, seed=8), drawn(1, 1, 1, seed=9, dt=0.0))
