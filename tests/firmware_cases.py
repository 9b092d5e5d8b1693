"""What the tests of generated programs share: one frozen design, and programs of it in a folder."""

from __future__ import annotations

import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from upright.control import LinearController, make_controller, read_controller
from upright.control.controller import Controller
from upright.execution import Parity
from upright.execution.execute import PythonExecutor
from upright.firmware import Firmware, generate
from upright.robots import Kit, Robot

GOLDEN = Path(__file__).parent / "golden" / "firmware"

ROBOT, NXT, SPIKE, EV3 = Robot.preset("nxtway-gs"), Kit.preset("nxt"), Kit.preset("spike"), Kit.preset("ev3")


def frozen() -> LinearController:
    """The LQG of `controller.json`, which no change of a design method changes."""
    controller = read_controller(GOLDEN / "controller.json")
    assert isinstance(controller, LinearController)
    return controller


def steering(gain: float = 2.0) -> LinearController:
    """The frozen design that also steers against what the compass reads, by `gain` [V/rad] on either side."""
    plain, heading = (
        frozen(),
        np.array([[gain], [-gain]]),
    )  # anticlockwise is positive: then the right wheel is too fast
    return replace(
        plain, By=np.pad(plain.By, ((0, 0), (0, 1))), Dy=np.hstack([plain.Dy, heading]), S=np.zeros((0, 0)),
        Sy=np.zeros((0, 0)), reads=(*plain.reads, "sensor/compass"), kind="lqg with compass",
    )  # fmt: skip


@cache
def designed(name: str) -> Controller:
    """A registered controller of NXTway-GS on the NXT."""
    return make_controller(name, ROBOT, NXT, 0.01)


def written(
    folder: Path, target: str, kit: Kit = NXT, controller: Controller | None = None, **options: object
) -> tuple[Path, Firmware]:
    """A program on disk, and what it was made from."""
    made = generate(controller or frozen(), ROBOT, kit, target, **options)  # type: ignore[arg-type]
    suffix = next(iter(made.files))
    return made.write(folder / f"balance{suffix}")[0], made


def finish(executor: PythonExecutor) -> list[str]:
    """Press the button and return the program's output, its log last."""
    while executor.script.exchange([0.0, 0.0, 0.0, 8000.0], pressed=True):
        pass
    return executor.script.lines


STILL = 10
"""Periods after which a program of `brief` knows its gyro's offset."""


def brief(
    folder: Path, target: str, kit: Kit = NXT, controller: Controller | None = None, **options: object
) -> tuple[Path, Firmware]:
    """A program whose start averages its gyro over `STILL` periods instead of a second, to be executed in a tenth of
    the time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("upright.firmware.readings.CALIBRATION_TIME", 0.01 * STILL)
        return written(folder, target, kit, controller, **options)


SHORT = 5.0
"""[s] of a parity in tests: each of its two pushes holds the robot for 1.5 s, and it has 1 s to recover."""


def shorten(monkeypatch: pytest.MonkeyPatch, seconds: float = SHORT) -> None:
    """Make a parity that short, with the same pushes."""
    parity = sys.modules[Parity.__module__]  # whose name is also that of a function
    monkeypatch.setattr(parity, "SECONDS", seconds)
    monkeypatch.setattr(parity, "HELD", 0.3 * seconds)
    monkeypatch.setattr(parity, "PUSHES", {"front": (0.1, 0.0), "back": (-0.12, seconds / 2)})
