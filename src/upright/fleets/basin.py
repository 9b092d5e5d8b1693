"""From which states a robot recovers: its basin of attraction, cut along any two of the six states."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array, Mask, Whole
from upright.control.reach import largest_pitch
from upright.errors import InvalidScenario, UnknownName, check_within
from upright.fleets.ensemble import Ensemble
from upright.fleets.maps import Basin
from upright.fleets.unfinished import coarse_first, marked, stoppable
from upright.progress import Progress, unwatched
from upright.signals import STATE_NAMES
from upright.signals.signal import STATE

if TYPE_CHECKING:
    from xarray import Dataset


MOST_ROBOTS = 10_000_000
_AT_ONCE = 8192  # robots in one batch, which bounds the memory; Ctrl-C leaves the last grid that is whole


@dataclass(frozen=True)
class Axis:
    """`points` values of the state `name` from `low` to `high`, in its own unit."""

    name: str
    low: float
    high: float
    points: int = 101

    def __post_init__(self) -> None:
        if self.name not in STATE_NAMES:
            raise UnknownName("state", self.name, STATE_NAMES)
        if not (np.isfinite([self.low, self.high]).all() and self.low < self.high and self.points >= 2):
            raise InvalidScenario(
                f"{self.name} from {self.low:g} to {self.high:g} in {self.points} points",
                expected="a low end below the high one, and two points or more",
            )

    @property
    def values(self) -> Array:
        """The values (points,)."""
        return np.linspace(self.low, self.high, self.points)


def basin(
    ensemble: Ensemble,
    across: Axis,
    up: Axis,
    *,
    samples: int = 1,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Basin:
    """The fraction of `samples` robots that stand `ensemble.seconds` after a start at each point of the two axes.

    The other states start as the ensemble's `start`. One sample is the nominal robot, so that the fraction is 0 or 1;
    more are robots 0 to `samples` − 1 of the family, each with its own noise. `settling` [s] is the median time after
    which pitch stays in the ensemble's band, NaN where half of them or more did not. Ctrl-C raises
    `interrupts.Stopped`, whose `result` is the finest grid of which every point was tried.
    """
    from upright.kernel.simulate import simulate

    check_within("runs in a basin", samples * across.points * up.points, 1, MOST_ROBOTS)
    if samples < 1 or across.name == up.name:
        raise InvalidScenario(f"{samples} samples over {across.name} and {up.name}", expected="one or more, two states")
    starts = _starts(ensemble, across, up)
    robots = (ensemble.nominal() if samples == 1 else ensemble).batch(np.arange(samples))
    stood, settled = np.empty((2, across.points, up.points, samples))
    at_once = max(1, ensemble.at_once(_AT_ONCE) // samples)
    tried = 0
    whole: tuple[Whole, ...] = ()

    def so_far() -> Basin:
        data = _labelled(ensemble, (across, up), whole, stood[np.ix_(*whole)], settled[np.ix_(*whole)])
        return Basin(marked(data, "points", data["recovered"].size, len(starts)))

    show = progress or unwatched
    show(0.0)
    with stoppable(lambda: so_far() if whole else None):
        for rows, points in coarse_first(across.points, up.points):
            for part in np.split(points, range(at_once, len(points), at_once)):
                every = robots.part(
                    np.tile(np.arange(samples), len(part)), start=np.repeat(starts[part], samples, axis=0)
                )
                result = simulate(every, ensemble.seconds, bands=(ensemble.band, np.inf, np.inf), threads=threads)
                stood.reshape(-1, samples)[part] = ~result.fell.reshape(-1, samples)
                settled.reshape(-1, samples)[part] = result.settled.reshape(-1, samples)
                tried += len(part)
                show(tried / len(starts))
            whole = rows
    return so_far()


def _starts(ensemble: Ensemble, across: Axis, up: Axis) -> Array:
    """States (points, 6), the second axis running faster."""
    starts = np.tile(np.array(ensemble.start), (across.points * up.points, 1))
    grid = np.meshgrid(across.values, up.values, indexing="ij")
    for axis, values in zip((across, up), grid, strict=True):
        starts[:, STATE_NAMES.index(axis.name)] = values.reshape(-1)
    return starts


def islands(recovered: Mask, across: Array, up: Array) -> Mask:
    """Which of `recovered` (across, up) are not joined, side by side, to the region nearest to rest."""
    from scipy.ndimage import label

    regions: Whole = np.asarray(label(recovered)[0], dtype=np.int64)  # type: ignore[index]
    if not recovered.any():
        return recovered
    far = np.hypot(*np.meshgrid(across / np.ptp(across), up / np.ptp(up), indexing="ij"))
    main = regions.flat[int(np.where(recovered, far, np.inf).argmin())]
    return recovered & (regions != main)


def _labelled(
    ensemble: Ensemble, axes: tuple[Axis, Axis], rows: Sequence[Whole], stood: Array, settled: Array
) -> Dataset:
    """The outcomes (across, up, samples) of these `rows` of the axes."""
    import xarray as xr

    across, up = axes
    dims = (across.name, up.name)
    inner = np.where(np.isnan(settled), np.inf, settled)
    median = np.sort(inner, axis=-1)[..., settled.shape[-1] // 2]
    units = {signal.name.removeprefix("truth/"): signal.unit for signal in STATE}
    coords = {
        axis.name: (axis.name, axis.values[some], {"unit": units[axis.name]})
        for axis, some in zip(axes, rows, strict=True)
    }
    recovered = stood.mean(axis=-1)
    apart = islands(recovered >= 0.5, coords[across.name][1], coords[up.name][1])
    variables: dict[str, Any] = {
        "island": (dims, apart, {"unit": "1", "long_name": "recovers apart from the region round rest"}),
        "recovered": (dims, recovered, {"unit": "1", "long_name": "fraction that recovered"}),
        "settling": (dims, np.where(np.isinf(median), np.nan, median), {"unit": "s", "long_name": "settling time"}),
    }
    kit = ensemble.family.kit
    able = largest_pitch(ensemble.family.robot, kit) if kit and across.name == "pitch" else math.inf
    settings = {"samples": stood.shape[-1], "saved_by_any": able if able < math.pi / 2 else None}
    origin = ensemble.origin() | {"basin": settings}
    return xr.Dataset(variables, coords, {"origin": json.dumps(origin, ensure_ascii=False)})
