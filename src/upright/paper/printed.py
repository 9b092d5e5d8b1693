"""The numbers that Herrera et al. (2015) print, exactly as printed, each with its equation.

State [ψ, ψ̇, θ, θ̇, φ, φ̇] (17), input [left, right] in volts (18). The small entries that couple pitch and yaw are
the noise of the authors' fit. In (35) the left motor turns the robot to +φ, against (16) and (24): whoever uses
these matrices beside the equations must flip the sign of φ once.
"""

from __future__ import annotations

import numpy as np

from upright.arrays import read_only

A = read_only(
    [
        [1.0037, 0.0092, 0, 0.0008, 0, 0],
        [0.6347, 0.9004, 0, 0.1034, -0.0001, 0.002],
        [-0.01, 0.0071, 1, 0.0029, 0, 0],
        [-1.09, 0.8795, 0, 0.1103, 0, -0.0002],
        [0.0002, 0, 0, 0, 1, 0.0031],
        [0.0104, -0.0009, -0.0003, 0.0009, -0.0007, 0.0493],
    ]
)
"""State matrix (6, 6) of the fitted discrete model, eq. (34)."""

B = read_only(
    [
        [-0.0008, -0.0008],
        [-0.1005, -0.1005],
        [0.0069, 0.0069],
        [0.8647, 0.8647],
        [0.0019, -0.0019],
        [0.2637, -0.2637],
    ]
)
"""Input matrix (6, 2) of the fitted discrete model [per V], eq. (35)."""

B_TURNED = read_only(B * np.array([[1], [1], [1], [1], [-1], [-1]]))
"""The same with the yaw of (16) and (24), which the right wheel turns to +φ."""

Q = read_only(np.diag([800.0, 1, 1, 80, 1, 1]))
"""State weights (6, 6) of the regulator, eq. (38)."""

R = read_only(np.diag([10000.0, 10000]))
"""Input weights (2, 2) of the regulator, eq. (38)."""

KU1 = read_only([-85.2, -11.5, -1.2, -1.3, -1.7, -0.005])
"""Gain (6,) of the left motor in u = −K x [V per rad or rad/s], printed below eq. (38)."""

KU2 = read_only([-85.18, -11.5, -1.2, -1.3, 1.7, 0.005])
"""Gain (6,) of the right motor, printed below eq. (38)."""

K = read_only([KU1, KU2])
"""Both gains as the matrix (2, 6) of u = −K x."""

PERIOD = 0.01
"""Sampling time [s], section 2.1.4, above eq. (34)."""

SAMPLES = 2000
"""Samples of the least-squares fit, section 2.1.4, above eq. (34)."""

FRONT_PUSH = 0.1
"""Pitch [rad] kept by the force on the front, section 3.2 (figures 4 to 10)."""

BACK_PUSH = -0.12
"""Pitch [rad] kept by the force on the back, section 3.2 (figures 11 to 13)."""
