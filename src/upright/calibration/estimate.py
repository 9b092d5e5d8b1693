"""One number of a calibration: its interval, its prior, and what a log says of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from upright.calibration.parameters import Parameter
from upright.pages import Quantity, Say
from upright.pages.terms import term
from upright.robots import PARAMETERS

VISIBLE, PRIOR, BOUND, HELD, REFUSED = "visible", "prior dominates", "at its bound", "not fitted", "refused"
QUIET = "too quiet"
"""Verdicts. Of a visible number the log halves the prior's uncertainty, or better. One at its bound it takes down to
zero, one that is not fitted keeps its prior's value. Of a log too quiet a value is partly an image of the sensors'
steps."""
MEASURED, BOUNDED, NOT_VISIBLE, MOVED = "measured", "bounded", "not visible", "moved"
"""Two kinds of visible; and where the log adds little to the prior, one that the fit moves all the same."""
CALLED = {
    MEASURED: Say("measured"),
    BOUNDED: Say("bounded"),
    NOT_VISIBLE: Say("not visible"),
    MOVED: Say("not visible, yet moved"),
    BOUND: Say("at its bound of zero"),
    HELD: Say("not fitted"),
    QUIET: Say("log too quiet"),
    REFUSED: Say("refused"),
}

CLOSE = 0.25  # of a value: the half width of an interval up to which it counts as measured
ONE_SIDED = 0.1  # of the upper end of an interval: a lower end below it says no more than zero would
NORMAL = 1.96  # standard deviations either side that hold 95 % of a normal distribution
SURPRISE = 3.0
"""Prior deviations beyond which the log contradicts a stated value."""
WIDER = 1.05
"""Of a prior's deviation: from here up, by more than rounding, a fit leaves a number less certain than its file."""
FOREIGN = 6.0
"""Prior deviations of a stated value beyond which the log is of another robot."""


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A number with its 95 % interval, the prior it had (value and one standard deviation), and the verdict on it.

    `shift` is how far it moved, and `shrink` how uncertain it still is, in deviations of its prior: those of the
    number, or of its logarithm, by its `scale`.
    """

    name: str
    unit: str
    value: float
    low: float
    high: float
    prior: float
    prior_spread: float
    verdict: str
    shift: float
    shrink: float
    guess: bool = False
    scale: Literal["linear", "logarithm"] = "linear"

    @property
    def asked(self) -> Parameter:
        """The number with its prior, as it was asked."""
        return Parameter(self.name, self.unit, self.prior, self.prior_spread, self.scale)

    @property
    def spread(self) -> float:
        """One standard deviation, as a quarter of the interval's width over 0.98."""
        return (self.high - self.low) / (2 * NORMAL)

    @property
    def wider(self) -> bool:
        """Whether the log knows less of the number than the robot's file states."""
        return not self.guess and self.shrink > WIDER

    @property
    def outside(self) -> bool:
        """Whether the fit puts the number outside the 95 % interval that was known before."""
        return abs(self.shift) > NORMAL and self.verdict not in (HELD, QUIET)

    @property
    def surprising(self) -> bool:
        """Whether the log contradicts a prior that was not a guess."""
        return not self.guess and abs(self.shift) > SURPRISE

    @property
    def off(self) -> bool:
        """Whether the fit puts the number outside of what was known before, or contradicts a stated value."""
        return self.outside or self.surprising

    @property
    def width(self) -> float:
        """Half of the interval over the value [1]."""
        return (self.high - self.low) / max(abs(self.high + self.low), 1e-300)

    @property
    def one_sided(self) -> bool:
        """Whether the log only says how large the number is at most."""
        least, most = sorted((abs(self.low), abs(self.high)))
        return self.low * self.high <= 0 or least < ONE_SIDED * most

    @property
    def measured(self) -> bool:
        """Whether the log shows the number closely."""
        return self.verdict == VISIBLE and not self.one_sided and self.width <= CLOSE

    @property
    def kind(self) -> str:
        """The verdict, by name: measured or bounded where it is visible; not visible, or moved, where the prior
        dominates."""
        if self.verdict == VISIBLE:
            return MEASURED if self.measured else BOUNDED
        if self.verdict == PRIOR:
            return MOVED if self.off else NOT_VISIBLE
        return self.verdict

    @property
    def called(self) -> Say:
        """The verdict in words."""
        return CALLED[self.kind]

    @property
    def quantity(self) -> Quantity:
        """The number with its interval, for people."""
        return Quantity(self.value, self.unit, low=self.low, high=self.high)

    @property
    def before(self) -> tuple[float, float]:
        """The ends of 95 % of the prior, what was known before; no number of a robot is below zero."""
        low, high = (float(self.asked.value(side * NORMAL)) for side in (-1, 1))
        return max(low, 0.0) if self.name in PARAMETERS else low, high


def known_to(value: float, low: float, high: float) -> Say:
    """An interval as people read it: ± of the value, but its upper end where the lower says no more than zero would,
    and both where the number may be negative."""
    if low < 0:
        return Say("{interval}", interval=Quantity(None, "1", low=low, high=high, digits=2))
    if low < ONE_SIDED * high:
        return Say("≤\u00a0{end}", end=Quantity(high, "1"))
    return Say("±\u00a0{size}", size=Quantity((high - low) / (2 * value), "fraction", digits=2))


def headed(name: str, unit: str) -> Say:
    """A number in words, with the unit of its value."""
    return term(name) if unit == "1" else Say("{name} [{unit}]", name=term(name), unit=unit)
