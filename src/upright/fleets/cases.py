"""What a campaign returns: the summaries of its cases, which are shown."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from upright.fleets.tally import Tally
from upright.fleets.unfinished import as_far
from upright.pages import Result

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page


class Cases(Result, Tally):
    """The summaries of a campaign, in the order of its plan."""

    def plot(self) -> Figure:
        """The fraction that fell in each case [%], the worst first, with bounds of 95 % confidence."""
        from upright.fleets.cases_page import draw_cases

        return draw_cases(self)

    def to_json(self) -> dict[str, Any]:
        """Each case, what each label does to the falls, and the drawn numbers that decide them."""
        return {"schema": "upright/sweep/1"} | self.numbers()

    def page(self) -> Page:
        """The campaign for people."""
        from upright.fleets.cases_page import cases_page

        return as_far(cases_page(self), {"unfinished": self.unfinished})
