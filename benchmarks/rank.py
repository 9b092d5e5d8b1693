"""Do twin, model and kernel rank ten controllers alike? Kendall's τ of their orders by three scores.

Each controller is a linear quadratic regulator behind a Kalman filter on the kit of the robot; they differ in what a
volt costs and in what a lean costs. Each is knocked forward. The kernel runs a thousand noises; model and twin, which
are loops in Python, run a few. Run: python benchmarks/rank.py [NOISES]
"""

from __future__ import annotations

import itertools
import os
import platform
import sys
import time
from collections.abc import Callable
from importlib.metadata import version

import numpy as np
from scipy.stats import kendalltau

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.control import Controller, Estimated, bryson, kalman, lqr
from upright.control.lqr import LARGEST_COMMAND, LARGEST_STATE
from upright.experiment import Impulse, run
from upright.fleet.ensemble import Ensemble
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Family

PUSH = Impulse(impulse=0.2, start=0.5)  # more than half of what the default regulator survives
SECONDS = 4.0
SCORES = ("peak_pitch", "rms_pitch", "travel")
VOLTS, LEANS = (0.3, 0.6, 1.0, 1.7, 3.0), (0.6, 1.8)  # factors on the largest accepted command and pitch
KERNEL_NOISES = 1000


def controllers(robot: Robot, kit: Kit) -> dict[str, Controller]:
    found: dict[str, Controller] = {}
    for volts, lean in itertools.product(VOLTS, LEANS):
        state = np.array(LARGEST_STATE) * [lean, 1, 1, 1, 1, 1]
        price = bryson([volts * LARGEST_COMMAND[robot.command_unit]] * 2)
        regulator = lqr(robot, kit.period, bryson(state), price)
        found[f"volts × {volts:g}, lean × {lean:g}"] = Estimated(regulator, kalman(robot, kit, kit.period))
    return found


def by_kernel(robot: Robot, kit: Kit, controller: Controller, _: int) -> list[float]:
    ensemble = Ensemble(family=Family(robot, kit), controller=controller, pushes=(PUSH,), seconds=SECONDS)
    found = ensemble.run(range(KERNEL_NOISES))
    return [float(found[name].mean()) for name in SCORES]


def by_loop(body: type[NonlinearBody] | type[Twin]) -> Callable[[Robot, Kit, Controller, int], list[float]]:
    def scores(robot: Robot, kit: Kit, controller: Controller, noises: int) -> list[float]:
        rows: list[list[float]] = []
        for seed in range(noises):
            plant = Electronics(body(robot), kit)
            log = run(plant, controller, PUSH, seconds=SECONDS, seed=seed)
            plant.close()
            pitch, wheel = np.abs(log["truth/pitch"]), np.abs(log["truth/wheel"])
            rows.append([pitch.max(), np.sqrt(np.mean(pitch**2)), wheel.max() * robot.wheel_radius])
        return np.mean(rows, axis=0).tolist()

    return scores


def main(noises: int) -> None:
    robot = Robot.preset("nxtway-gs")
    kit = Kit.preset(robot.kit)
    ten = controllers(robot, kit)
    routes = {"kernel": by_kernel, "model": by_loop(NonlinearBody), "twin": by_loop(Twin)}
    machine = f"{platform.processor() or platform.machine()}, {os.cpu_count()} processors"
    versions = ", ".join(f"{name} {version(name)}" for name in ("numpy", "numba", "mujoco"))
    print(f"{machine}, Python {platform.python_version()}, {versions}")
    print(f"{robot.name} on kit {kit.name}, knocked by {PUSH.impulse} N s")
    print(f"{KERNEL_NOISES} noises in the kernel, {noises} elsewhere")
    tables: dict[str, np.ndarray] = {}
    for name, route in routes.items():
        begin = time.perf_counter()
        tables[name] = np.array([route(robot, kit, controller, noises) for controller in ten.values()])
        print(f"  {name}: {time.perf_counter() - begin:.1f} s")
    for k, score in enumerate(SCORES):
        ranges = (f"{label} {t[:, k].min():.4g} … {t[:, k].max():.4g}" for label, t in tables.items())
        print(f"\n{score}: " + ", ".join(ranges))
        for a, b in itertools.combinations(tables, 2):
            print(f"  Kendall τ of {a} and {b}: {kendalltau(tables[a][:, k], tables[b][:, k]).statistic:.3f}")
    print("\nbest to worst by RMS pitch:")
    for name, table in tables.items():
        order = np.argsort(table[:, SCORES.index("rms_pitch")])
        print(f"  {name}: " + " < ".join(list(ten)[i] for i in order[:3]) + " < …")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 3)
