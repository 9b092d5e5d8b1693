"""Many robots at once, from names: the outcomes of a fleet and their summary."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array
from upright.control import Controller
from upright.errors import UnknownName, check_within
from upright.fleets.ensemble import Ensemble
from upright.fleets.results import OUTCOMES, Summary, labelled, origin_of, summarise
from upright.fleets.sweep import electronics, find_controller
from upright.fleets.unfinished import as_far, marked, stoppable
from upright.fleets.vary import Vary, varied
from upright.pages import Result
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_robot
from upright.robots.uncertainty import Family, Uncertainty, at_medians

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from upright.pages import Page

MOST_ROBOTS = 10_000_000
"""In one fleet, whose results take a gigabyte; more go into a campaign."""

CHUNK = 8192  # robots between two reports of progress; the memory of a run grows with it, and what Ctrl-C loses


@dataclass(frozen=True, eq=False, repr=False)
class Fleet(Result):
    """The outcomes of each robot, `data`, and their `summary`."""

    data: Dataset
    summary: Summary

    def plot(self, outcome: str = "peak_pitch") -> Figure:
        """How an `outcome` is distributed over the robots that stood; `UnknownName` lists the outcomes."""
        if outcome not in OUTCOMES:
            raise UnknownName("outcome", outcome, OUTCOMES)
        from upright.fleets.fleet_page import distribution

        return distribution(self.data, outcome)

    def to_json(self) -> dict[str, Any]:
        """The summary, and where it comes from."""
        return {"schema": "upright/fleet/1", **self.summary.to_json(), "origin": origin_of(self.data)}

    def page(self) -> Page:
        """The fleet for people."""
        from upright.fleets.fleet_page import fleet_page

        return as_far(fleet_page(self.data, self.summary), origin_of(self.data))


def ensemble_of(
    robot: Robot | str,
    controller: Controller | str = "lqg",
    kit: Kit | str | None = None,
    *,
    vary: Vary = (),
    posterior: Uncertainty | str | PathLike[str] | None = None,
    **scenario: Any,
) -> Ensemble:
    """Robots like `robot` with `kit` (None: its own), all under one linear `controller`; each may be a name or a file.

    `vary` are the numbers that differ from robot to robot: {"com_height": "±10%"}, or "spread". A `posterior` is drawn
    beside them, and its medians replace the robot's numbers. `scenario` is that of an `Ensemble`.
    """
    nominal, unknown = at_medians(find_robot(robot), posterior)
    parts = kit if isinstance(kit, Kit) else electronics(kit or nominal.kit)
    family = Family(nominal, parts, varied(vary, nominal, parts, unknown))
    design = find_controller(controller, nominal, parts) if isinstance(controller, str) else controller
    return Ensemble(family=family, controller=design, **scenario)


def fleet(
    robot: Robot | str | Ensemble,
    n: int = 10000,
    *,
    threads: int | None = None,
    progress: Progress | None = None,
    **choices: Any,
) -> Fleet:
    """Simulate `n` robots of an ensemble, or of the one that `ensemble_of` makes of a robot and `choices`.

    `choices` are its controller, kit, vary, posterior, pushes, references, start, seconds and seed. `progress` is
    called with the fraction done. Ctrl-C raises `interrupts.Stopped`, whose `result` is the fleet of the robots until
    then. Raises `InvalidScenario`.
    """
    check_within("robots in a fleet", n, 1, MOST_ROBOTS)
    ensemble = robot if isinstance(robot, Ensemble) else ensemble_of(robot, **choices)
    parts: list[Mapping[str, Array]] = []
    show = progress or unwatched
    show(0.0)
    chunk = ensemble.at_once(CHUNK)
    with stoppable(lambda: _together(parts, ensemble, n) if parts else None):
        for first in range(0, n, chunk):
            parts.append(ensemble.run(range(first, min(n, first + chunk)), threads))
            show(min(1.0, (first + chunk) / n))
    return _together(parts, ensemble, n)


def _together(parts: Sequence[Mapping[str, Array]], ensemble: Ensemble, n: int) -> Fleet:
    """The first robots of `n`, as many as the `parts` have."""
    columns = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
    done = len(columns["fell"])
    data = marked(labelled(columns, range(done), ensemble), "robots", done, n)
    return Fleet(data, summarise(data))
