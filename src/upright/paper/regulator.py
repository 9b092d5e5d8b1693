"""Chapter 4: the regulator. The printed gains are not the ones that the printed Q and R give."""

from __future__ import annotations

import itertools
import math

import numpy as np

from upright.arrays import Array
from upright.comparison.drawing import state_words
from upright.control import StateFeedback, dlqr
from upright.pages import Column, Quantity, Say, Table
from upright.paper import printed
from upright.paper.claim import Claim, judged
from upright.physics.linear import LinearModel, linearise
from upright.robots import Robot
from upright.signals import STATE_NAMES

AS_PRINTED = "printed A, B as printed"
TURNED = "printed A, B, yaw inputs turned"
LOOPS = {AS_PRINTED: Say("the printed model"), TURNED: Say("the printed model, yaw inputs turned")}

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
    model = LinearModel(printed.A, printed.B, dt=printed.PERIOD)
    as_printed = dlqr(model, printed.Q, printed.R)
    clean = dlqr(without_noise(printed.A, printed.B), printed.Q, printed.R)
    nearest, permutation, price = nearest_gain()
    feedback = printed_feedback()
    loops = {
        AS_PRINTED: _radius(model, feedback),
        TURNED: _radius(LinearModel(printed.A, printed.B_TURNED, dt=printed.PERIOD), feedback),
        light.name: _radius(linearise(light).c2d(printed.PERIOD), feedback),
    }
    gains = {"gain": Quantity(clean.gain[0, 0]), "printed": Quantity(printed.KU1[0])}
    summary = Say("The printed weights give a pitch gain of {gain}; printed is {printed}.", **gains)
    numbers = {
        "dlqr_as_printed": as_printed.gain.tolist(),
        "dlqr_without_noise": clean.gain.tolist(),
        "printed": printed.K.tolist(),
        "riccati_residual": clean.check(),
        "nearest_relative_distance": nearest,
        "nearest_Q": permutation,
        "nearest_r": price,
        "largest_eigenvalue": loops,
    }
    search = Say(
        "No order of the weights in Q, with any R from 1 to 10⁴, comes nearer than {distance} (RMS).",
        distance=Quantity(nearest, "fraction", digits=2),
    )
    blocks = [_gains(clean.gain), search, _stability(loops)]
    same = np.abs(np.abs(clean.gain[0] / printed.KU1) - 1) < SAME
    result = Say("{gain}, not {printed}", **gains)
    return Claim("4", Say("Regulator gains"), judged(same.tolist()), summary, numbers, blocks, result=result)


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


def _radius(model: LinearModel, feedback: StateFeedback) -> float:
    return float(np.abs(np.linalg.eigvals(model.A - model.B @ feedback.gain)).max())


def _gains(clean: Array) -> Table:
    columns = [Column(Say("gain of")), Column(Say("printed")), Column(Say("from Q and R, noise removed"))]
    each = zip(STATE_NAMES, printed.KU1.tolist(), clean[0].tolist(), strict=True)
    rows = [[state_words(name), *gains] for name, *gains in each]
    return Table(columns, rows, Say("Gains of the left motor, printed below (38)"))


def _stability(loops: dict[str, float]) -> Table:
    rows = [[LOOPS.get(name, name), value, value < 1] for name, value in loops.items()]
    columns = [
        Column(Say("under the printed gains")),
        Column(Say("largest eigenvalue"), digits=5),
        Column(Say("stable")),
    ]
    return Table(columns, rows)
