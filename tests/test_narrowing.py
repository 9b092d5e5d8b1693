"""Which spread makes a certificate red: planted falls that hang on one number alone."""

from __future__ import annotations

import pytest

from upright.certification.narrowing import ranking
from upright.kernel.batch import NAMES, parameters_of
from upright.robots import Robot
from upright.robots.uncertainty import Uncertainty, draw


@pytest.mark.parametrize(("low", "high"), [(-3.0, -1.5), (1.0, 3.0), (-0.8, -0.35)])
def test_the_number_on_which_falls_hang_comes_first(low: float, high: float) -> None:
    """The last range lies near the nominal robot: known twice as well as many would fall, known five times none."""
    robot = Robot.preset("ev3way")
    unknown = Uncertainty.of(robot)
    numbers = parameters_of(draw(robot, 500, 1, unknown))
    spread = next(s for s in unknown.spreads if s.name == "pitch_inertia")
    z = (numbers[:, NAMES.index(spread.name)] - spread.low) / spread.high
    assert ranking(unknown, numbers, (low < z) & (z < high))[0].name == "pitch_inertia"
