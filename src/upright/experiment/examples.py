"""Example logs of the twin, as a robot would write them: each with a fixed seed, some with a planted fault.

None holds what a robot does not know: no true state, no push.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import closing
from dataclasses import dataclass
from functools import cache

import numpy as np

from upright.arrays import Array
from upright.errors import UnknownName
from upright.experiment.pushes import Impulse, PushProgramme
from upright.experiment.run import run
from upright.pages import Say
from upright.signals import Log

ROBOT = "nxtway-gs"
SECONDS = 12.0
SEED = 11
AMPLITUDE, HELD = 1.2, 8  # [V], rows: a random binary excitation that moves the robot by a few degrees
BLOW, FATAL = 0.06, 0.4  # [N s] pushes that it survives, and not
GYRO, LEFT, RIGHT = "sensor/gyro", "sensor/encoder_left", "sensor/encoder_right"
BEHIND, LOST = 3, 0.03  # rows by which a gyro is behind; fraction of the rows that are lost

Planted = Callable[[Log], Log]


@dataclass(frozen=True)
class Example:
    """What a log shows (`about`), with which pushes, excited or not, and the fault `planted` in it."""

    about: Say
    pushes: tuple[PushProgramme, ...] = ()
    excited: bool = False
    planted: Planted | None = None


def _with(log: Log, others: dict[str, Array]) -> Log:
    return Log(log.t, {**log.channels, **others}, log.units, log.origin)


def _scaled(name: str, factor: float) -> Planted:
    return lambda log: _with(log, {name: factor * log[name]})


def _swapped(log: Log) -> Log:
    return _with(log, {LEFT: log[RIGHT], RIGHT: log[LEFT]})


def _behind(log: Log) -> Log:
    return _with(log, {GYRO: np.concatenate([np.full(BEHIND, log[GYRO][0]), log[GYRO][:-BEHIND]])})


def _lossy(log: Log) -> Log:
    keep = np.random.Generator(np.random.Philox(SEED)).random(len(log)) >= LOST
    keep[0] = True
    return Log(log.t[keep], {name: values[keep] for name, values in log.channels.items()}, log.units, log.origin)


EXAMPLES: Mapping[str, Example] = {
    "standing": Example(Say("stands still: too quiet for an inertia")),
    "excited": Example(Say("excited by a random binary voltage, as `calibrate` needs it"), excited=True),
    "pushed": Example(
        Say("pushed at 3 and 7 s"), (Impulse(impulse=BLOW, start=3.0), Impulse(impulse=-BLOW, start=7.0))
    ),
    "fall": Example(Say("pushed over at 5 s"), (Impulse(impulse=FATAL, start=5.0),)),
    "gyro-degrees": Example(Say("excited; its gyro counts degrees"), excited=True, planted=_scaled(GYRO, 180 / np.pi)),
    "gyro-flipped": Example(Say("excited; its gyro has the other sign"), excited=True, planted=_scaled(GYRO, -1.0)),
    "gyro-behind": Example(Say("excited; its gyro is 3 rows behind"), excited=True, planted=_behind),
    "sides-swapped": Example(Say("excited; left and right encoder are swapped"), excited=True, planted=_swapped),
    "rows-lost": Example(Say("excited; 3 rows in 100 are lost"), excited=True, planted=_lossy),
}  # fmt: skip
"""Name → example, in the order of a lesson."""


def example(name: str) -> Log:
    """The example of that name, always the same. Raises `UnknownName`."""
    if name not in EXAMPLES:
        raise UnknownName("example", name, EXAMPLES)
    chosen = EXAMPLES[name]
    log = _simulated(chosen.pushes, chosen.excited)
    if chosen.planted:
        log = chosen.planted(log)
    known = {n: x for n, x in log.channels.items() if not n.startswith(("truth/", "push/"))}
    return Log(log.t, known, log.units, {**log.origin, "example": name})


@cache
def _simulated(pushes: tuple[PushProgramme, ...], excited: bool) -> Log:
    from upright.bodies import equipped
    from upright.control import find_controller
    from upright.control.excited import Excited, random_binary
    from upright.robots import find_kit, find_robot

    robot = find_robot(ROBOT)
    kit = find_kit(robot.kit)
    controller = find_controller("lqg", robot, kit, kit.period)
    added = random_binary(round(SECONDS / kit.period), AMPLITUDE, seed=SEED, hold=HELD)
    if excited:
        controller = Excited(controller, added)
    with closing(equipped("twin", robot, kit)) as body:
        log = run(body, controller, pushes, seconds=SECONDS, seed=SEED)
    known = {f"excitation/{side}": added[: len(log), i] for i, side in enumerate(("left", "right"))} if excited else {}
    return Log(log.t, {**log.channels, **known}, {**log.units, **dict.fromkeys(known, "V")}, log.origin)
