"""The record of how a controller was found: its residual, its gain, and what else a page or a command shows of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.control.controller import Controller
from upright.pages import Say


class Design:
    """What every record of a design offers; a method says more by overriding."""

    def check(self) -> float:
        """A residual computed anew from the record's own fields: zero is perfect."""
        raise NotImplementedError

    @property
    def gain(self) -> Array | None:
        """K (2, 6 or more) of u = −K x on the robot's six states first; None where there is no such matrix."""
        return None

    def words(self) -> Sequence[Say | str]:
        """Sentences on the result, and lines of a matrix; none by default."""
        return []

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; by default the gain alone."""
        return {} if self.gain is None else {"gain": self.gain.tolist()}


class OfDesign:
    """A controller with the record of its `design`, None where that is not known."""

    design: Any  # a `Design`, None where it is not known: a field of the controller

    @property
    def gain(self) -> Array | None:
        """That of the design."""
        return None if self.design is None else self.design.gain

    def check(self) -> float:
        """The residual of the design, zero where there is none to check."""
        return 0.0 if self.design is None else self.design.check()


def design_of(controller: Controller) -> Design | None:
    """The record of the controller's design, through an estimator in front of it; None where nothing is recorded."""
    record = getattr(getattr(controller, "controller", controller), "design", None)
    return record if isinstance(record, Design) else None


def gain_of(controller: Controller) -> Array | None:
    """K (2, 6) of u = −K x on the robot's six states, None of a controller that has no such gain."""
    gain = getattr(controller, "gain", None)
    return None if gain is None else np.asarray(gain, dtype=np.float64)[:, :6]


def residual_of(controller: Controller) -> float | None:
    """What the controller's own `check()` gives, None of one that has nothing to check."""
    check: Callable[[], float] | None = getattr(controller, "check", None)
    return float(check()) if check else None
