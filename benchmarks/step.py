"""One control step called from Python: medians and the 99.9th percentile, for every registered controller.

Run: python benchmarks/step.py [--robot NAME] [--repeats N]. A step is `step` and `applied`, as `run` calls them, on
readings of a gentle motion recorded beforehand. The clock's own cost is taken off the median.
"""

from __future__ import annotations

import argparse
import os
import platform
import time
from importlib.metadata import version

import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.control import CONTROLLERS, Controller, make_controller
from upright.experiment import Hold, run
from upright.robots import Kit, Robot

TARGETS = {"lqr": 1.0, "lqr-state": 1.0, "lqg": 1.5, "mpc": 20.0}  # [µs] medians


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--robot", default="nxtway-gs")
    parser.add_argument("--repeats", type=int, default=20_000)
    options = parser.parse_args()
    robot = Robot.preset(options.robot)
    kit = Kit.preset(robot.kit)
    body = Electronics(NonlinearBody(robot), kit)
    log = run(body, make_controller("lqg", robot, kit, kit.period), Hold(pitch=0.05, until=1.0), seconds=2.0)
    print(_machine(), f"{options.repeats} steps of {robot.name}", sep="\n")
    print(f"{'controller':<20}{'median':>10}{'step alone':>12}{'99.9 %':>10}{'target':>10}   [µs]")
    for name in CONTROLLERS:
        controller = make_controller(name, robot, kit, kit.period)
        readings = np.ascontiguousarray([log[channel] for channel in controller.spec.reads]).T.copy()
        applied = np.column_stack([log["applied/left"], log["applied/right"]]).tolist()
        both, alone, worst = measured(controller, list(readings), applied, options.repeats)
        target = f"{TARGETS[name]:.1f}" if name in TARGETS else ""
        print(f"{name:<20}{both:>10.2f}{alone:>12.2f}{worst:>10.2f}{target:>10}")


def measured(
    controller: Controller, readings: list[np.ndarray], commands: list[list[float]], repeats: int
) -> tuple[float, float, float]:
    """Median of step and applied, median of the step alone, and the 99.9th percentile of both together [µs].

    The recorded commands are handed back, so that the filters stay on the recorded motion.
    """
    reference = np.zeros(6)
    clock, step, applied = time.perf_counter_ns, controller.step, controller.applied
    both, alone, idle = np.zeros(repeats), np.zeros(repeats), np.zeros(repeats)
    controller.reset()
    for k in range(repeats):
        y, command = readings[k % len(readings)], commands[k % len(readings)]
        start = clock()
        step(y, reference)
        middle = clock()
        applied(command)
        end = clock()
        both[k], alone[k], idle[k] = end - start, middle - start, clock() - end
    off = float(np.median(idle))
    return (np.median(both) - 2 * off) / 1e3, (np.median(alone) - off) / 1e3, np.percentile(both, 99.9) / 1e3


def _machine() -> str:
    packages = f"numpy {version('numpy')}"
    chip = platform.processor() or platform.machine()
    return f"{chip}, {os.cpu_count()} cores, Python {platform.python_version()}, {packages}"


if __name__ == "__main__":
    main()
