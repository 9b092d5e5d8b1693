"""When a run has settled after the release of its push: from when on pitch stays near zero, and what near means."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from upright.arrays import Array

STEADY, WIDE = 1.6, 0.5
"""A wobble that grows no more than this between the last quarter and the last half is steady; beyond this part of the
peak it is no rest."""


class Released(NamedTuple):
    """Times [s] and |pitch| [rad] of a run after the release; empty where it falls or is pushed to its end."""

    t: Array
    size: Array


def at_rest(runs: Mapping[str, Released], label: str) -> tuple[float, float]:
    """From how long after the release on a run's pitch stays near zero [s], and what near means for all runs [rad];
    NaN where this run, or every one, never rests.

    That is `SETTLED`, as in a fleet, where pitch went clearly beyond it and sways less at rest. Else it is 5 % of its
    largest value, or its wobble at rest where that is more: then the noise of the sensors decides.
    """
    from upright.fleets.ensemble import SETTLED

    own = {name: near(run) for name, run in runs.items()}
    limit = max((x for x in own.values() if math.isfinite(x)), default=math.nan)
    run = runs[label]
    if math.isnan(own[label]):
        return math.nan, limit
    limit = SETTLED if limit <= SETTLED <= WIDE * float(run.size.max()) else limit
    beyond = np.flatnonzero(run.size > limit)
    return (float(run.t[beyond[-1]] - run.t[0]) if len(beyond) else 0.0), limit


def near(run: Released) -> float:
    """What near zero means for one run [rad]; NaN where it never rests."""
    if len(run.size) < 8:
        return math.nan
    half, quarter = (float(run.size[-len(run.size) // part :].max()) for part in (2, 4))
    limit = max(0.05 * float(run.size.max()), half if half <= STEADY * quarter else quarter)
    return limit if limit <= WIDE * float(run.size.max()) else math.nan
