"""The next experiment to run, and how it is shown."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from upright.errors import InvalidScenario
from upright.excitation.plan_page import plan_page, uncertainty_left
from upright.excitation.planned import PlannedRun
from upright.pages import Result
from upright.reading import named, read_json

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page


class ExcitationPlan(PlannedRun, Result):
    """An excitation, what it is expected to tell, and what it was checked to keep."""

    def page(self) -> Page:
        """The plan for people."""
        return plan_page(self)

    def plot(self) -> Figure:
        """How much of each parameter's uncertainty the run should leave."""
        return uncertainty_left(self)


def read_plan(path: str | Path) -> ExcitationPlan:
    """The plan in a JSON file; raises `InvalidScenario` for one that cannot be read or is none."""
    data = read_json(path, InvalidScenario, "a plan by upright excite")
    with named(path, InvalidScenario):
        return ExcitationPlan.from_json(data)
