"""Linear state feedback u = −K (x − r), the form in which most methods hand over their result."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from upright.arrays import Array, read_only
from upright.control.controller import ControllerSpec, Lawful
from upright.control.linear_controller import Law, LinearController
from upright.errors import InvalidController
from upright.signals import STATE_NAMES, TRUE_STATE


@dataclass(frozen=True, eq=False, repr=False)
class StateFeedback(Lawful):
    """u = −K (x − r): `gain` K (2, 6) from the state to [left, right], every `period` [s]; r is the reference state.

    Raises `InvalidController` for a gain of the wrong size or with NaN.
    """

    form: ClassVar[str] = "state feedback"
    gain: Array
    period: float
    command_unit: str = "V"
    kind: str = "state feedback"
    spec: ControllerSpec = field(init=False)
    _times: Callable[[Array], Array] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        gain = read_only(self.gain)
        if gain.shape != (2, 6):
            raise InvalidController(
                f"the gain has shape {gain.shape}",
                expected=f"(2, 6): left and right motor, each from {', '.join(STATE_NAMES)}",
                likely="one motor's row alone" if gain.size == 6 else "",
                hint="use StateFeedback.symmetric(pitch_row, yaw_row)" if gain.size == 6 else "",
            )
        if not np.isfinite(gain).all():
            raise InvalidController("the gain holds NaN or infinity", expected="finite numbers")
        if not (np.isfinite(self.period) and self.period > 0):
            raise InvalidController(f"the period is {self.period} s", expected="a positive number")
        object.__setattr__(self, "gain", gain)
        object.__setattr__(self, "_times", gain.dot)
        object.__setattr__(self, "spec", ControllerSpec(self.kind, TRUE_STATE, self.period, self.command_unit))

    @classmethod
    def symmetric(cls, left: Sequence[float], period: float, **options: Any) -> StateFeedback:
        """From the left motor's six gains: the right motor's are the same with the two yaw gains negated."""
        row = np.array(left, dtype=np.float64)
        if row.shape != (6,):
            raise InvalidController(f"{row.size} gains", expected=f"six, from {', '.join(STATE_NAMES)}")
        return cls(np.array([row, row * [1, 1, 1, 1, -1, -1]]), period, **options)

    def reset(self) -> None:
        """Nothing is remembered."""

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        left, right = self._times(reference - measurement).tolist()
        return left, right

    def estimate(self) -> Sequence[float]:
        """Empty: it estimates no state."""
        return ()

    def applied(self, command: Sequence[float]) -> None:
        """What the motors did does not matter to a static gain."""

    def check(self) -> float:
        """A gain that was given has no equation to fail."""
        return 0.0

    def words(self) -> list[str]:
        """K as a table."""
        units = ", ".join(("rad", "rad/s") * 3)
        return table_lines(f"K of u = −K (x − r) [{self.command_unit} per {units}]", self.gain, ("left", "right"))

    def law(self) -> Law:
        none = np.zeros((0, 0))
        return Law(LinearController.like(self.spec, none, none, none, none, none, -self.gain, self.gain))

    def to_json(self) -> dict[str, Any]:
        return {"kind": self.kind, "gain": self.gain.tolist(), "period": self.period, "command_unit": self.command_unit}


def table_lines(title: str, matrix: Array, rows: Sequence[str]) -> list[str]:
    """A matrix on the six states as lines of text: the title, the states' names, and its rows."""
    lines = [title, f"{'':<11}" + "".join(f"{name:>12}" for name in STATE_NAMES)]
    for name, row in zip(rows, matrix.tolist(), strict=True):
        lines.append(f"{name:<11}" + "".join(f"{value:>12.4g}" for value in row))
    return lines
