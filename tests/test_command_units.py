"""Gains in torque, volts and duty: commands in any of them close the same loop."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from upright.errors import InvalidRobot, UnknownName
from upright.physics.linear import linearise
from upright.robots import Battery, Kit, Motor, Robot
from upright.robots.motor import COMMAND_UNITS, converted_gain

Matrix = NDArray[np.float64]
VOLTS = 7.4
KIT = Kit(name="k", battery=Battery(voltage=VOLTS))
RANDOM = np.random.default_rng(3).normal(size=(2, 6))


def plant(p: Robot, brake: float, push: float) -> tuple[Matrix, Matrix]:
    """ẋ = Ax + Bu upright, in closed form, where each motor turns its wheel by `push` u − `brake` ω (and friction)."""
    rotors = p.gear_ratio**2 * p.rotor_inertia
    h = p.track / (2 * p.wheel_radius)
    a11 = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia + 2 * rotors
    a12 = p.body_mass * p.com_height * p.wheel_radius - 2 * rotors
    a22 = p.body_mass * p.com_height**2 + p.pitch_inertia + 2 * rotors
    a33 = p.yaw_inertia + p.track**2 / 2 * p.wheel_mass + 2 * h**2 * (p.wheel_inertia + rotors)
    weight = p.gravity * p.body_mass * p.com_height
    b = brake + p.motor_friction
    floor = 2 * p.wheel_friction
    # rows: torque on the wheels, on the body, about the vertical; columns: the state, then both commands
    forces = np.array([
        [0, 2 * b, 0, -2 * b - floor, 0, 0, push, push],
        [weight, -2 * b, 0, 2 * b, 0, 0, -push, -push],
        [0, 0, 0, 0, 0, -(2 * b + floor) * h**2, -h * push, h * push],
    ])  # fmt: skip
    wheel, pitch = np.linalg.solve(np.array([[a11, a12], [a12, a22]]), forces[:2])
    A = np.zeros((6, 8))
    A[0, 1] = A[2, 3] = A[4, 5] = 1.0
    A[1], A[3], A[5] = pitch, wheel, forces[2] / a33
    return A[:, :6], A[:, 6:]


@pytest.mark.parametrize("name", ["nxtway-gs", "balrob"])
def test_a_gain_in_torque_volts_or_duty_closes_the_same_loop(name: str) -> None:
    """With and without a gear, and with a back-EMF twice what the torque constant tells."""
    p = Robot.preset(name)
    alpha = p.gear_ratio * p.torque_constant / p.motor_resistance
    by_torque, by_volts = plant(p, 0.0, 1.0), plant(p, alpha * p.back_emf, alpha)
    of_package = linearise(p)
    assert np.allclose(by_volts[0], of_package.A, rtol=1e-9, atol=1e-9)
    assert np.allclose(by_volts[1], of_package.B, rtol=1e-9, atol=1e-9)
    wanted = by_torque[0] - by_torque[1] @ RANDOM
    size = np.abs(wanted).max()
    for unit, volts in {"V": 1.0, "duty": VOLTS, "%": VOLTS / 100, "PWM": VOLTS / 255}.items():
        gain = converted_gain(RANDOM, p, KIT, "N m", unit).gain
        closed = by_volts[0] - by_volts[1] @ (volts * gain)
        assert np.abs(closed - wanted).max() < 1e-12 * size  # rounding
        assert np.allclose(converted_gain(gain, p, KIT, unit, "N m").gain, RANDOM)


@pytest.mark.parametrize("was", COMMAND_UNITS)
@pytest.mark.parametrize("unit", COMMAND_UNITS)
def test_there_and_back_is_the_same_gain(was: str, unit: str) -> None:
    p = Robot.preset("nxtway-gs")
    there = converted_gain(RANDOM, p, KIT, was, unit, 1023)
    assert np.allclose(converted_gain(there.gain, p, KIT, unit, was, 1023).gain, RANDOM)
    assert bool(there.changes) == (was != unit)


def test_the_same_torque_needs_more_volts_of_a_weaker_motor() -> None:
    """The motor of a script has 3.45 times the torque constant of the motor that was measured, with nearly the same
    back-EMF: gains in torque that suit both become other gains in volts, and so do those of duty in torque."""
    told, true = (
        Robot.preset("nxtway-gs").replace(torque_constant=k_t, back_emf=k_b, motor_resistance=5.6)
        for k_t, k_b in ((0.86156, 0.2585), (0.2494, 0.2494))
    )
    row = [9.773, 1.3203, 1.0, 0.3969, 0, 0]
    duty = {p.torque_constant: converted_gain(row, p, KIT, "duty", "N m").gain[0, 0] for p in (told, true)}
    assert duty[0.86156] / duty[0.2494] == pytest.approx(0.86156 / 0.2494)
    assert duty[0.2494] == pytest.approx(9.773 * VOLTS * 0.2494 / 5.6)  # pitch has no part in the back-EMF


def test_what_changes_is_told_and_what_cannot_be_is_refused() -> None:
    p: Any = Robot.preset("nxtway-gs")
    kit = dataclasses.replace(KIT, motor=Motor(drop=1.8))
    said = " ".join(converted_gain(RANDOM[0], p, kit, "N m", "PWM").changes)
    for part in ("21.1 V/(N m)", "0.468 V s/rad", "34.46 PWM", "7.4 V", "keeps 1.8 V"):  # 6.69/0.317, 255/7.4
        assert part in said
    with pytest.raises(UnknownName, match="volt"):
        converted_gain(RANDOM, p, KIT, "volt", "V")
    with pytest.raises(InvalidRobot, match="states no battery"):
        converted_gain(RANDOM, p, Kit.preset("ideal"), "V", "duty")
    with pytest.raises(InvalidRobot, match="torque drive"):
        converted_gain(RANDOM, Robot.preset("twipr"), KIT, "N m", "V")
    with pytest.raises(InvalidRobot, match="shape"):
        converted_gain(RANDOM[:, :4], p, KIT, "N m", "V")
