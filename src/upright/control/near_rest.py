"""What a controller is while nothing about it is at a limit: the linear system that decides about stability at rest."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.control.controller import Controller
from upright.control.linear_controller import LinearController, as_linear
from upright.control.mpc import PredictiveController
from upright.control.recursion import Recursion
from upright.control.sliding import SlidingMode

Array = NDArray[np.float64]


def near_rest(controller: Controller) -> LinearController:
    """The controller itself where it is linear; a predictive one without active limits, a sliding one in its layer.

    Raises `InvalidController` for any other.
    """
    if isinstance(controller, PredictiveController):
        return _closed(controller, controller.memory, np.eye(2, len(controller.memory.C), len(controller.memory.C) - 2))
    if isinstance(controller, SlidingMode):
        slope = controller.reach / controller.layer
        return _closed(controller, controller.memory, np.hstack([-slope * np.eye(2), np.eye(2)]))
    return as_linear(controller)


def _closed(controller: Controller, memory: Recursion, pick: Array) -> LinearController:
    """u = pick · outputs, put back into the recursion as the command that was decided."""
    spec, C, Dy, Dr = controller.spec, pick @ memory.C, pick @ memory.Dy, pick @ memory.Dr
    A, By, Br = memory.A + memory.Bu @ C, memory.By + memory.Bu @ Dy, memory.Bu @ Dr
    return LinearController(
        A, By, Br, memory.Ba, C, Dy, Dr, reads=spec.reads, period=spec.period, S=memory.S, Sy=memory.Sy,
        command_unit=spec.command_unit, kind=spec.kind,
    )  # fmt: skip
