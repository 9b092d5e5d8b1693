"""A calibration: the robot learnt from logs, with its page."""

from __future__ import annotations

from upright.calibration.calibrated_robot import CalibratedRobot
from upright.calibration.calibration_page import calibration_page
from upright.pages import Page


class Calibration(CalibratedRobot):
    """A robot learnt from logs, and how surely; see `CalibratedRobot` for what it holds."""

    def page(self) -> Page:
        """The calibration for people."""
        return calibration_page(self)
