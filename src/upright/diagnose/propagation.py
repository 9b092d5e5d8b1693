"""Small errors through the filter of a log, in compiled code."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from upright.calibrate.kept import njit


@njit
def propagate(phi: Any, pushed: Any, shifted: Any, reads: Any, gains: Any, deviation: Any) -> Any:
    """What faults add to the whitened innovations (events, faults) of a filter that corrects what they do to its state.

    Each event's flow is `phi` (events, 6, 6), its gain `gains` (events, states), its reading `reads` (events, states),
    whose innovation has this standard `deviation` (events,), NaN where none is used. Faults enter the state,
    `pushed` (events, 6, faults), and readings, `shifted` (events, faults); either may have one row for all.
    """
    n, size, faults = len(phi), gains.shape[1], pushed.shape[2]
    error, before = np.zeros((size, faults)), np.zeros((6, faults))
    innovation, response = np.zeros(faults), np.zeros((n, faults))
    for i in range(n):
        before[:] = error[:6]
        for row in range(6):
            into = error[row]
            into[:] = pushed[i % len(pushed), row]
            for column in range(6):
                slope = phi[i, row, column]
                if slope != 0:
                    of = before[column]
                    for fault in range(faults):
                        into[fault] += slope * of[fault]
        if math.isnan(deviation[i]):
            continue
        innovation[:] = -shifted[i % len(shifted)]
        for state in range(size):
            if reads[i, state] != 0:
                for fault in range(faults):
                    innovation[fault] -= reads[i, state] * error[state, fault]
        for state in range(size):
            for fault in range(faults):
                error[state, fault] += gains[i, state] * innovation[fault]
        for fault in range(faults):
            response[i, fault] = innovation[fault] / deviation[i]
    return response
