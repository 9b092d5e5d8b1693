"""What a controller is while nothing about it is at a limit: the linear system that decides about stability at rest."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.control.controller import Controller
from upright.control.linear_controller import LinearController, as_linear
from upright.control.mpc import PredictiveController
from upright.control.sliding import SlidingMode


def near_rest(controller: Controller) -> LinearController:
    """The controller itself where it is linear; a predictive one without active limits, a sliding one in its layer.

    Raises `InvalidController` for any other.
    """
    if isinstance(controller, PredictiveController):
        return _closed(controller.memory, controller.splitting.limit * np.eye(2, len(controller.memory.C)))
    if isinstance(controller, SlidingMode):
        slope = controller.reach / controller.layer
        return _closed(controller.memory, np.hstack([-slope * np.eye(2), np.eye(2)]))
    return as_linear(controller)


def _closed(memory: LinearController, pick: Array) -> LinearController:
    """u = pick · outputs, fed back into the memory as the command that was decided."""
    C, Dy, Dr = pick @ memory.C, pick @ memory.Dy, pick @ memory.Dr
    A = memory.A + memory.Bu @ C
    By = memory.By + memory.Bu @ Dy
    Br = memory.Bu @ Dr
    return replace(memory, A=A, By=By, Br=Br, C=C, Dy=Dy, Dr=Dr, Bu=np.zeros((0, 0)))
