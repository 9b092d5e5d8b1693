"""What a validation is shown with."""

from __future__ import annotations

from typing import TYPE_CHECKING

from upright.pages import Result
from upright.validation.drawn import half_second_figure
from upright.validation.fits import RobotJudged
from upright.validation.validation_page import validation_page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page


class Validation(RobotJudged, Result):
    """What is known of a robot with its kit, judged on logs."""

    def page(self) -> Page:
        """The validation for people."""
        return validation_page(self)

    def plot(self) -> Figure:
        """Readings of the worst log, measured and predicted for half a second at a time."""
        return half_second_figure(self.worst)
