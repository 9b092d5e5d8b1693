"""Logs of twins that might be a preset: each of its numbers is off by its own spread."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from upright.bodies import Body, Electronics
from upright.bodies.twin import Twin
from upright.calibration.effects import FRACTIONS
from upright.control import Estimated, kalman, lqr_state, make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.experiment import run
from upright.experiment.pushes import Hold, Slope
from upright.logs.recording import SENSOR
from upright.robots import PARAMETERS, Kit, Robot
from upright.signals import Log

DITHER = {"nxtway-gs": (1.5, 4), "ev3way": (2.5, 4), "twipr": (0.03, 6)}
"""Amplitude [command unit] and how many periods it is held: loud enough to be told from the sensors' steps."""

HELD, RELEASED = 0.1, 1.0  # [rad], [s]
RUNS = 3
"""Of each family."""
FLOOR = 0.003
"""[N m] Rolling friction of a family whose robot's file asks for it: its log says so (docs/calibrate.md)."""


def drawn(robot: Robot, seed: int) -> Robot:
    """A robot that might be this preset: each measured number off by its own spread."""
    rng = np.random.default_rng(1000 + seed)
    known = {
        n: p.spread for n, p in robot.provenance.items() if p.spread and n in PARAMETERS and not n.startswith("body_d")
    }
    while True:
        values = {n: getattr(robot, n) for n in known}
        try:
            moved = {n: v * math.exp(min(known[n] / v, 0.5) * rng.standard_normal()) for n, v in values.items()}
            true = robot.replace(**moved)
            Twin(true)
        except UprightError:
            continue
        return true


def twin_log(
    name: str, true: Robot, seed: int, seconds: float = 20.0, slope: float = 0.0, *, quiet: bool = False,
    kit: Kit | None = None, body: Callable[[Robot], Body] = Twin,
) -> Log:  # fmt: skip
    """The twin of `true`, or another `body`, in the preset's kit or another, under the preset's controller, excited by
    a random binary dither, on a floor of that slope [rad]; or `quiet`: held at a tenth of a radian, let go after a
    second, and then left alone. The log then begins at the release, as a person's does who lets a robot go."""
    robot = Robot.preset(name)
    kit = kit or Kit.preset(robot.kit)
    if name == "nxtway-gs":
        controller = Estimated(lqr_state(robot, kit.period), kalman(robot, kit, kit.period))
    else:
        controller = make_controller("lqg", robot, kit, kit.period)
    plant = Electronics(body(true), kit)
    if quiet:
        whole = run(plant, controller, Hold(pitch=HELD, until=RELEASED), seconds=RELEASED + seconds, seed=seed)
        return whole.between(RELEASED, math.inf)
    amplitude, hold = DITHER[name]
    dither = random_binary(round(seconds / kit.period), amplitude, seed, hold)
    floor = Slope(angle=slope)
    return run(plant, Excited(controller, dither), floor, seconds=seconds, seed=seed)


def runs_of(name: str, true: Robot, seed: int) -> list[Log]:
    """Three runs of 8 s of that robot: warmer and colder, on other floors. Each run's friction and winding are off by
    the spreads that `effects` states, its floor by half a degree."""
    rng = np.random.default_rng(5000 + seed)
    logs: list[Log] = []
    for number in range(RUNS):
        values = {n: getattr(true, n) * math.exp(size * rng.standard_normal()) for n, size in FRACTIONS.items()
                  if true.drive == "voltage" or n != "motor_resistance"}  # fmt: skip
        slope = math.radians(0.5) * rng.standard_normal()
        logs.append(twin_log(name, true.replace(**values), RUNS * seed + number, 8.0, slope))
    return logs


def truth(name: str, true: Robot) -> dict[str, float]:
    """What a calibration of that twin ought to find: its numbers, its kit's dead times, and two equal motors.

    A log says what was really applied, period by period: of the kit's dead time the whole periods are in it already.
    The twin rounds its jitter to whole milliseconds. MuJoCo moves positions by the rates of the end of its time step,
    so that they are half a step (0.125 ms) ahead of these.
    """
    kit = Kit.preset(Robot.preset(name).kit)
    late = kit.delay % kit.period + round(kit.jitter / 0.001) * 0.001 / 2
    ahead = {"encoder": 0.000125, "compass": 0.000125, "gyro": 0.0}
    delays = {
        f"delay/{SENSOR[channel]}": late + s.delay - ahead[SENSOR[channel]]
        for channel, s in kit.sensors.items()
        if channel in SENSOR
    }
    return {**true.numbers(), **delays, "delay/gyro−encoder": delays["delay/gyro"] - delays["delay/encoder"]} | {
        "asymmetry": 0.0, "constant_command": 0.0
    }  # fmt: skip
