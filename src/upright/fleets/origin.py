"""Where a fleet's results come from: robot, controller, what varied."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from upright.experiment.described import facts_of
from upright.fleets.results import origin_of
from upright.pages import Column, Quantity, Say, Table
from upright.pages.terms import term

if TYPE_CHECKING:
    from xarray import Dataset


def spreads_of(data: Dataset) -> Sequence[Mapping[str, Any]]:
    """What varied from robot to robot: name, kind of distribution, and its two numbers."""
    return (origin_of(data).get("vary") or {}).get("spreads", ())


def names_varied(data: Dataset) -> list[str]:
    """The numbers in which the robots differ."""
    return [str(spread["name"]) for spread in spreads_of(data)]


def spreads_table(spreads: Sequence[Mapping[str, Any]], units: Mapping[str, str]) -> Table:
    """Each number that varies, with its middle and how widely."""
    rows: list[list[Any]] = []
    for spread in spreads:
        name, low, high = str(spread["name"]), float(spread["low"]), float(spread["high"])
        unit = units.get(name) or "1"
        if spread["kind"] == "uniform":
            rows.append([term(name), Quantity((low + high) / 2, unit), Quantity(None, unit, low=low, high=high)])
        elif spread["kind"] == "lognormal":
            factor = Quantity(math.exp(high), "1", digits=2)
            rows.append([term(name), Quantity(low, unit), Say("by a factor of {factor}", factor=factor)])
        else:
            rows.append([term(name), Quantity(low, unit), Say("± {size}", size=Quantity(high, unit, digits=2))])
    caption = Say("Factors and ± are one standard deviation")
    return Table([Column(Say("number")), Column(Say("middle")), Column(Say("varies"))], rows, caption)


def pushes_of(origin: Mapping[str, Any]) -> Sequence[Mapping[str, Any]]:
    """The pushes of a scenario, each with its numbers."""
    return origin.get("scenario", {}).get("push") or ()


def made_of(data: Dataset) -> dict[str, str]:
    """Robot, kit, controller, seed and versions, for a page's foot."""
    return {"kit": "ideal"} | facts_of(origin_of(data))
