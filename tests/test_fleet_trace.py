"""The trace: generated text is current, and says what the one definition of the dynamics says."""

import inspect
import math
from pathlib import Path
from types import SimpleNamespace

import numba
import numpy as np
import pytest

from upright.compiled import generated, generated_motion
from upright.compiled.generate import sources
from upright.compiled.trace_constants import ConstantNames
from upright.compiled.trace_print import P
from upright.errors import InvalidModel
from upright.physics.dynamics import CALM, Disturbance, accelerations
from upright.robots import Robot

# no parameter without effect
ROUGH = Robot.preset("nxtway-gs").replace(coulomb_friction=0.004, rolling_friction=0.003, wheel_friction=0.001)
X, U = np.array([0.3, 1.2, 0.5, 4.0, 0.7, 2.0]), np.array([1.0, -2.0])  # leaning, driving and turning
FORCE, MOMENT, SLOPE = 0.5, 0.03, 0.1
DRY = ("coulomb_friction", "rolling_friction")
ROUNDING = 1e-13  # a few hundred operations on doubles


def test_the_generated_files_are_current():
    for name, text in sources().items():
        assert (Path(generated.__file__).parent / name).read_text("utf-8") == text, (
            f"run python -m upright.compiled.generate: {name}"
        )


VARIANTS = {
    "smooth": ((), 0.0), "coulomb": (("coulomb_friction",), 0.0), "rolling": (DRY, 0.0), "slope": ((), SLOPE),
    "coulomb_slope": (("coulomb_friction",), SLOPE), "rolling_slope": (DRY, SLOPE),
    "free": (("rolling_friction",), 0.0),
}  # fmt: skip
"""The generated accelerations, and the dry frictions and the slope [rad] that each may have."""


def signs_over_the_floor():
    """The smoothed signs of both wheels' rates at `X`, which the predictor gives its accelerations."""
    rates = np.array([X[3] - ROUGH.track / (2 * ROUGH.wheel_radius) * X[5] * side for side in (1, -1)])
    return rates / np.hypot(rates, ROUGH.stiction_rate)


@pytest.mark.parametrize("model", ["complete", "published"])
@pytest.mark.parametrize("variant", VARIANTS)
def test_the_generated_accelerations_equal_the_definition(variant, model):
    """With the friction, slope and push that a variant has."""
    dry, slope = VARIANTS[variant]
    p = {**ROUGH.numbers(), **dict.fromkeys(set(DRY) - set(dry), 0.0)}
    push = CALM if variant == "free" else Disturbance(FORCE, MOMENT / FORCE, slope)
    true = accelerations(X, U, SimpleNamespace(**p), push, math, model)
    c = generated.constants(list(p.values()), float(model == "complete"))
    values = {
        **dict(zip(("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate"), X, strict=True)),
        **dict(zip(("left", "right"), U, strict=True)), "force": FORCE, "moment": MOMENT,
        **dict(zip(("roll_left", "roll_right"), signs_over_the_floor(), strict=True)),
        "sin_slope": math.sin(slope), "cos_slope": math.cos(slope), **c._asdict(),
    }  # fmt: skip
    compiled = getattr(generated_motion, f"accelerations_{variant}")
    traced = numba.njit(lambda arguments: compiled(*arguments), error_model="numpy")
    found = traced(tuple(float(values[name]) for name in inspect.signature(compiled.py_func).parameters))
    assert np.abs(np.subtract(found, true)).max() <= ROUNDING * np.abs(true).max()


def test_constants_are_the_textbook_s():
    """Each by the formula of docs/model.md, in numbers; the generator refuses products without a name itself."""
    p = ROUGH
    c = generated.constants(list(p.numbers().values()), 1.0)
    rotors = p.gear_ratio**2 * p.rotor_inertia
    a11 = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia + 2 * rotors
    a22 = p.body_mass * p.com_height**2 + p.pitch_inertia + 2 * rotors
    volt = p.gear_ratio * p.torque_constant / p.motor_resistance
    assert c.motor_torque == pytest.approx(volt / a11, rel=ROUNDING)
    assert c.motor_damping == pytest.approx(2 * (volt * p.back_emf + p.motor_friction) / a11, rel=ROUNDING)
    assert c.coulomb_torque == pytest.approx(p.coulomb_friction / a11, rel=ROUNDING)
    assert c.rotor_coupling == pytest.approx(2 * rotors / a11, rel=ROUNDING)
    assert c.pitch_inertia == pytest.approx(a22 / a11, rel=ROUNDING)
    assert c.half_track == pytest.approx(p.track / (2 * p.wheel_radius), rel=ROUNDING)


def test_a_product_without_a_name_stops_the_generator():
    known = ConstantNames()
    assert str(known.of(P.wheel_radius)) == "wheel_radius"
    assert str(known.of(-P.gravity)) == "-gravity"
    with pytest.raises(InvalidModel, match="need body_mass"):
        known.of(P.body_mass)
    with pytest.raises(InvalidModel, match="do not need"):
        known.check()
