"""What `push_map` and `basin` return: data that is shown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from upright.fleets import limits
from upright.fleets.results import origin_of
from upright.fleets.unfinished import as_far
from upright.pages import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from upright.pages import Page


@dataclass(frozen=True, eq=False, repr=False)
class PushMap(Result):
    """The largest impulses that are survived, `data`; `PushMap(load(path))` is a map that was saved."""

    data: Dataset

    def plot(self) -> Figure:
        """The map of the direction in which the robot is weakest."""
        from upright.fleets.push_map_page import draw_map

        first, *_ = limits.weakest(self.data)
        return draw_map(self.data.sel(direction=first))

    def to_json(self) -> dict[str, Any]:
        """The weakest place by direction, a knock at the centre of mass, the longest pushes, and the origin."""
        numbers = {
            "weakest": limits.weakest(self.data), "at_centre": limits.at_centre(self.data),
            "longest": limits.longest(self.data),
        }  # fmt: skip
        return {"schema": "upright/push-map/1", **numbers, "origin": origin_of(self.data)}

    def page(self) -> Page:
        """The map for people."""
        from upright.fleets.push_map_page import push_map_page

        return as_far(push_map_page(self.data), origin_of(self.data))


@dataclass(frozen=True, eq=False, repr=False)
class Basin(Result):
    """The fraction that recovers over two states, `data`; `Basin(load(path))` is a basin that was saved."""

    data: Dataset

    def plot(self) -> Figure:
        """The states from which the robot recovers; of several robots the fraction."""
        from upright.fleets.basin_page import draw_basin

        return draw_basin(self.data)

    def to_json(self) -> dict[str, Any]:
        """The fraction of the states from which robots recover, the ranges round rest, and where they come from."""
        recovered = self.data["recovered"].values
        numbers = {
            "fraction": float(recovered.mean()), "points": int(recovered.size), "samples": limits.samples(self.data),
            "islands": float(self.data["island"].values.mean()), "ranges": limits.ranges(self.data),
            "saved_by_any": limits.saved_by_any(self.data), "sees_lean": limits.sees_lean(self.data),
        }  # fmt: skip
        return {"schema": "upright/basin/1", **numbers, "origin": origin_of(self.data)}

    def page(self) -> Page:
        """The basin for people."""
        from upright.fleets.basin_page import basin_page

        return as_far(basin_page(self.data), origin_of(self.data))
