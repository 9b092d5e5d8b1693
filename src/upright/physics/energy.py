"""Kinetic and potential energy [J] of the model, generic over the maths namespace."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from upright.physics.dynamics import mass_matrix


def kinetic(x: Sequence[Any], p: Any, xp: Any = math, model: str = "complete") -> Any:
    """T = ½ (a11 θ̇² + 2 a12 θ̇ψ̇ + a22 ψ̇² + a33 φ̇²); the forces that keep the wheels rolling do no work."""
    pitch, pitch_rate, _, wheel_rate, _, yaw_rate = x
    a11, a12, a22, a33 = mass_matrix(xp.cos(pitch), xp.sin(pitch), p, model)
    return (a11 * wheel_rate**2 + 2 * a12 * wheel_rate * pitch_rate + a22 * pitch_rate**2 + a33 * yaw_rate**2) / 2


def potential(x: Sequence[Any], p: Any, xp: Any = math) -> Any:
    """V = M g L cos ψ on a level floor, zero where the centre of mass is at the axle's height."""
    return p.body_mass * p.gravity * p.com_height * xp.cos(x[0])


def total(x: Sequence[Any], p: Any, xp: Any = math, model: str = "complete") -> Any:
    """T + V, constant without voltage, friction, back-EMF and pushes."""
    return kinetic(x, p, xp, model) + potential(x, p, xp)
