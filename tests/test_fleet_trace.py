"""The trace: generated text is current, and says what the one definition of the dynamics says."""

import math
from pathlib import Path
from types import SimpleNamespace

import numba
import numpy as np
import pytest

from upright.compiled import generated, generated_motion
from upright.compiled.generate import sources
from upright.physics.dynamics import Disturbance, accelerations
from upright.robots import Robot

ROUGH = Robot.preset("nxtway-gs").replace(coulomb_friction=0.004, wheel_friction=0.001)  # no parameter without effect
X, U = np.array([0.3, 1.2, 0.5, 4.0, 0.7, 2.0]), np.array([1.0, -2.0])  # leaning, driving and turning
FORCE, MOMENT, SLOPE = 0.5, 0.03, 0.1
ROUNDING = 1e-13  # a few hundred operations on doubles


def test_the_generated_files_are_current():
    for name, text in sources().items():
        assert Path(generated.__file__).with_name(name).read_text("utf-8") == text, (
            f"run python -m upright.compiled.generate: {name}"
        )


VARIANTS = {
    "smooth": (0.0, 0.0), "coulomb": (ROUGH.coulomb_friction, 0.0), "slope": (0.0, SLOPE),
    "coulomb_slope": (ROUGH.coulomb_friction, SLOPE),
}  # fmt: skip
"""The generated accelerations, and the dry friction [N m] and the slope [rad] that each may have."""


@pytest.mark.parametrize("model", ["complete", "published"])
@pytest.mark.parametrize("variant", VARIANTS)
def test_the_generated_accelerations_equal_the_definition(variant, model):
    """With the friction and slope that a variant has."""
    friction, slope = VARIANTS[variant]
    p = {**ROUGH.numbers(), "coulomb_friction": friction}
    true = accelerations(X, U, SimpleNamespace(**p), Disturbance(FORCE, MOMENT / FORCE, slope), math, model)
    c = generated.constants(list(p.values()), float(model == "complete"))
    compiled = getattr(generated_motion, f"accelerations_{variant}")
    traced = numba.njit(lambda arguments: compiled(*arguments), error_model="numpy")
    moving = (X[0], X[1], X[3], X[4], X[5])
    found = traced((*map(float, (*moving, *U, FORCE, MOMENT, math.sin(slope), math.cos(slope), *c)),))
    assert np.abs(np.subtract(found, true)).max() <= ROUNDING * np.abs(true).max()
