"""The limits that a push map or a basin shows, as numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array, Mask
from upright.fleets.results import origin_of

if TYPE_CHECKING:
    from xarray import Dataset

KNOCK = 0.02  # [s] of a knock, as a certificate's
TENNIS_BALL = 0.058  # [kg] in the middle of what the rules of tennis allow


def weakest(data: Dataset) -> Mapping[str, Mapping[str, float]]:
    """For each direction of a push map, the weakest first, where the least impulse fells the nominal robot: `impulse`
    [N s], `height` [m], `duration` [s], its mean `force` [N], the speed [m/s] of a tennis `ball` that gives as much
    when it is caught, the band `low` to `high` [N s] where similar robots were tried, and the fraction of `islands`."""
    places = {str(way): _weakest(data.sel(direction=way)) for way in data["direction"].values}
    return dict(sorted(places.items(), key=lambda item: item[1]["impulse"]))


def _weakest(part: Dataset) -> dict[str, float]:
    impulse = part["impulse"].values
    row, column = np.unravel_index(int(np.argmin(impulse)), impulse.shape)
    place = {"impulse": impulse[row, column], "height": part["height"][row], "duration": part["duration"][column]}
    place |= {"force": place["impulse"] / place["duration"], "ball": place["impulse"] / TENNIS_BALL}
    place |= {name: part[name].values[row, column] for name in ("low", "high") if name in part}
    return {name: float(value) for name, value in place.items()} | {"islands": float(part["island"].values.mean())}


def at_centre(data: Dataset) -> float | None:
    """The impulse [N s] of a `KNOCK` at the centre of mass that is survived, between the points of a push map; None
    where it has none there."""
    height = float(origin_of(data)["robot"].get("com_height") or math.nan)
    heights, durations = data["height"].values, data["duration"].values
    if not (durations[0] <= KNOCK <= durations[-1] and heights[0] <= height <= heights[-1]):
        return None
    least = data["impulse"].min("direction").transpose("height", "duration").values
    return float(np.interp(height, heights, [np.interp(KNOCK, durations, row) for row in least]))


def longest(data: Dataset) -> float:
    """The impulse [N s] that is survived at every height in the longest pushes of a push map."""
    return float(data["impulse"].isel(duration=-1).min())


def states(data: Dataset) -> tuple[str, str]:
    """The names of the two states of a basin, that across first."""
    across, up = map(str, data["recovered"].dims)
    return across, up


def samples(data: Dataset) -> int:
    """How many robots were let go at each point of a basin; 1 is the nominal robot."""
    return int((origin_of(data).get("basin") or {}).get("samples", 1))


def saved_by_any(data: Dataset) -> float | None:
    """The largest pitch [rad] at rest from which any controller could save the linear robot (`control.reach`); None
    where the motors lift it off the floor, no kit limits the command, or the basin is not over pitch."""
    return (origin_of(data).get("basin") or {}).get("saved_by_any")


def sees_lean(data: Dataset) -> bool:
    """Whether the controller of a basin reads pitch itself or an accelerometer; without them a lean at rest shows only
    as it grows."""
    reads = (origin_of(data).get("controller") or {}).get("reads") or ("truth/pitch",)
    return any(name == "truth/pitch" or "accel" in name for name in reads)


def ranges(data: Dataset) -> dict[str, tuple[float, float] | None]:
    """For each state of a basin from where to where, round zero, most robots recover while the other is zero; None
    where they do not recover from rest."""
    across, up = states(data)
    recovers = data["recovered"].values > 0.5
    first, second = data[across].values, data[up].values
    column, row = int(np.abs(first).argmin()), int(np.abs(second).argmin())
    inside = first[0] <= 0 <= first[-1] and second[0] <= 0 <= second[-1] and recovers[column, row]
    return {
        across: _round(first, recovers[:, row], column) if inside else None,
        up: _round(second, recovers[column], row) if inside else None,
    }


def _round(values: Array, recovers: Mask, middle: int) -> tuple[float, float]:
    """From where to where all round number `middle` recover."""
    lost = np.flatnonzero(~recovers)
    low = lost[lost < middle].max(initial=-1) + 1
    high = lost[lost > middle].min(initial=len(values)) - 1
    return float(values[low]), float(values[high])
