"""One control step called from Python: medians and the 99.9th percentile, for every registered controller.

Run: python benchmarks/step.py [--robot NAME] [--repeats N]. A step is `step` and `applied`, as `run` calls them, on
readings of a gentle motion recorded beforehand. The clock's own cost is taken off the median.
"""

from __future__ import annotations

import time

import harness
import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.control import CONTROLLERS, Controller, make_controller
from upright.experiment import Hold, run
from upright.robots import Kit, Robot

TARGETS = {"lqr": 1.0, "lqr-state": 1.0, "lqg": 1.5, "mpc": 20.0}  # [µs] medians


def main() -> None:
    options = harness.options(__doc__, robot="nxtway-gs", repeats=20_000)
    robot = Robot.preset(options.robot)
    kit = Kit.preset(robot.kit)
    body = Electronics(NonlinearBody(robot), kit)
    log = run(body, make_controller("lqg", robot, kit, kit.period), Hold(pitch=0.05, until=1.0), seconds=2.0)
    harness.machine("numpy")
    print(f"{options.repeats} steps of {robot.name} [µs]")
    table = harness.Table("controller <20", "median >10.2f", "step alone >12.2f", "99.9 % >10.2f", "target >10.1f")
    for name in CONTROLLERS:
        controller = make_controller(name, robot, kit, kit.period)
        readings = np.ascontiguousarray([log[channel] for channel in controller.spec.reads]).T.copy()
        applied = np.column_stack([log["applied/left"], log["applied/right"]]).tolist()
        table.row(name, *measured(controller, list(readings), applied, options.repeats), TARGETS.get(name, ""))


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


if __name__ == "__main__":
    main()
