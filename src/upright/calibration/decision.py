"""What may be done with a calibrated robot, and why."""

from __future__ import annotations

from typing import NamedTuple

from upright.calibration.estimate import REFUSED, Estimate
from upright.pages import Next, Quantity, Say
from upright.pages.terms import term

UNKNOWN, DOUBTFUL, USABLE = "unknown", "doubtful", "usable"
"""Verdicts on a calibration, beside `REFUSED`."""
EXCITE = Next("excite", output="plan.json", why=Say("Run that dither, push nothing, log every row, calibrate again."))
"""What to run where a log cannot tell its robot."""


class Decision(NamedTuple):
    """What may be done with a calibrated robot (`verdict`, one of those above), why, and what to run next; the last two
    are None where nothing speaks against it."""

    verdict: str
    why: Say | None = None
    next: Next | None = None

    @property
    def hint(self) -> str:
        """The line to type."""
        return self.next.command if self.next else ""

    @property
    def against(self) -> bool:
        """Whether no controller is to be designed with this robot, or nobody knows."""
        return self.verdict in (REFUSED, UNKNOWN, DOUBTFUL)

    @property
    def withheld(self) -> bool:
        """Whether no file of the robot is to be written."""
        return self.verdict in (REFUSED, UNKNOWN)


def came_out(e: Estimate) -> Say:
    """That a number is far from the robot's file."""
    value = Quantity(e.value, e.unit)
    low, high = e.before
    before = Quantity(e.prior, e.unit, low=low, high=high)
    return Say(
        "The {name} comes out at {value}; the file says {before}.", name=term(e.name), value=value, before=before
    )
