"""Chapter 4: the regulator. The printed gains are not the ones that the printed Q and R give."""

from __future__ import annotations

import itertools
import math

import numpy as np

from upright.arrays import Array
from upright.control import Lqr, StateFeedback, dlqr
from upright.paper import printed
from upright.paper.claim import Claim, judged
from upright.physics.linear import LinearModel, linearise
from upright.plotting import legend, plane, points
from upright.reports import Figure, Table
from upright.reports.page import cell_text
from upright.robots import Robot
from upright.signals import STATE_NAMES
from upright.tables import joined

PRICES: list[float] = np.logspace(0, 4, 41).tolist()


def printed_feedback() -> StateFeedback:
    """u = −Kx with the printed gains, for the equations' yaw (anticlockwise)."""
    return StateFeedback(printed.K, printed.PERIOD, kind="printed gains")


def without_noise(A: Array, B: Array) -> LinearModel:
    """The printed model with its small coupling of pitch and yaw removed, which is noise."""
    pitch = np.arange(4)
    yaw = np.arange(4, 6)
    clean = A.copy()
    clean[pitch[:, None], yaw] = clean[yaw[:, None], pitch] = 0
    clean[5, 4] = 0  # heading does not turn the robot
    return LinearModel(clean, B, dt=printed.PERIOD)


def chapter(light: Robot) -> Claim:
    """The regulator of the printed A, B, Q, R beside the printed gains, and the proof that the two differ.

    `light` is the robot of reference [4], on which the printed gains are tried too.
    """
    as_printed = dlqr(LinearModel(printed.A, printed.B, dt=printed.PERIOD), printed.Q, printed.R)
    clean = dlqr(without_noise(printed.A, printed.B), printed.Q, printed.R)
    nearest, permutation, price = nearest_gain()
    feedback = printed_feedback()
    loops = {
        "printed A, B as printed": _radius(LinearModel(printed.A, printed.B, dt=printed.PERIOD), feedback),
        "printed A, B, yaw inputs turned": _radius(_turned(), feedback),
        light.name: _radius(linearise(light).c2d(printed.PERIOD), feedback),
    }
    summary = (
        f"The regulator (LQR) of the printed A, B, Q, R has a pitch gain of {cell_text(clean.gain[0, 0], 3)} (printed: "
        f"{cell_text(printed.KU1[0], 3)}) and a wheel gain of {cell_text(clean.gain[0, 2], 2)} (printed: "
        f"{cell_text(printed.KU1[2], 2)}); {_balanced(loops, light.name)}. "
        "A search covers the 30 orders of the diagonal of Q, and R = r·I with r from "
        f"1 to 10⁴. Its smallest distance from the printed gains is {100 * nearest:.0f} % (RMS over the six gains). "
        "The printed gains stabilise the printed model (largest |eigenvalue| "
        f"{loops['printed A, B, yaw inputs turned']:.4f} with the yaw sign corrected, "
        f"{loops['printed A, B as printed']:.4f} without) but not {light.name} ({loops[light.name]:.1f})."
    )
    numbers = {
        "dlqr_as_printed": as_printed.gain.tolist(), "dlqr_without_noise": clean.gain.tolist(),
        "printed": printed.K.tolist(), "riccati_residual": clean.check(),
        "nearest_relative_distance": nearest, "nearest_Q": permutation, "nearest_r": price, "largest_eigenvalue": loops,
    }  # fmt: skip
    items = [_gains(clean.gain, as_printed.gain), _stability(loops), _poles(feedback, clean)]
    same = np.abs(np.abs(clean.gain[0] / printed.KU1) - 1) < SAME
    return Claim("4", "The regulator and its gains, eqs. (36)–(38)", judged(same.tolist()), summary, numbers, items)


def _balanced(loops: dict[str, float], light: str) -> str:
    """Which robots balance with the printed gains."""
    names = {"printed A, B, yaw inputs turned": "the printed model", light: light}
    stable = [words for name, words in names.items() if loops[name] < 1]
    others = [words for words in names.values() if words not in stable]
    return f"the printed gains balance {joined(stable) or 'neither'}{f', but not {joined(others)}' if others else ''}"


SAME = 0.05  # [1] of a printed gain: closer is the same to two digits, as it was printed


def nearest_gain() -> tuple[float, list[float], float]:
    """The smallest relative distance (RMS) of the left motor's gains from the printed ones, over every order of Q's
    diagonal and prices r, with the order and the price. Yaw gains count by size, since their sign is in doubt."""
    model = without_noise(printed.A, printed.B)
    target = np.abs(printed.KU1)
    best: tuple[float, list[float], float] = (math.inf, [0.0], 0.0)
    orders = sorted(set(itertools.permutations(np.diag(printed.Q).tolist())))
    for diagonal in orders:
        for price in PRICES:
            gain = dlqr(model, np.array(diagonal), np.array([price, price])).gain[0]
            distance = float(np.linalg.norm(np.abs(gain) / target - 1) / math.sqrt(6))
            best = min(best, (distance, list(diagonal), price))
    return best


def _turned() -> LinearModel:
    signs = np.array([[1], [1], [1], [1], [-1], [-1]])
    return LinearModel(printed.A, printed.B * signs, dt=printed.PERIOD)


def _radius(model: LinearModel, feedback: StateFeedback) -> float:
    return float(np.abs(np.linalg.eigvals(model.A - model.B @ feedback.gain)).max())


def _gains(clean: Array, noisy: Array) -> Table:
    header = ["gain, left motor", *(name.replace("_", " ") for name in STATE_NAMES)]
    rows = [
        ["printed Ku₁", *printed.KU1.tolist()],
        ["dlqr of the printed matrices, noise removed", *clean[0].tolist()],
        ["dlqr of the printed matrices, left", *noisy[0].tolist()],
        ["dlqr of the printed matrices, right", *noisy[1].tolist()],
    ]
    return Table(header, rows, "The regulator of (38) beside the printed gains", digits=3)


def _stability(loops: dict[str, float]) -> Table:
    rows = [[name, value, value < 1] for name, value in loops.items()]
    return Table(
        ["robot under the printed gains", "largest |eigenvalue|", "stable"],
        rows,
        "Where the printed gains hold",
        digits=5,
    )


def _poles(feedback: StateFeedback, clean: Lqr) -> Figure:
    """Each under its own sign of yaw: the printed gains suit the equations', dlqr the printed matrices'."""
    model = _turned()
    poles = {
        "printed gains": np.linalg.eigvals(model.A - model.B @ feedback.gain),
        "dlqr of the printed Q and R": clean.poles(),
    }
    figure, ax = plane("real part [1]", "imaginary part [1]", circle=True)
    for name, values in poles.items():
        points(ax, name, values.tolist())
    largest = ", ".join(f"{cell_text(float(np.abs(values).max()), 6)} ({name})" for name, values in poles.items())
    return Figure(f"Largest pole of the printed robot under both regulators: {largest}", legend(figure))
