"""How often the intervals of identified linear models hold the truth, and whether the estimated bias is the real one.

    python benchmarks/identify.py --seeds 40                  # three kits, all linear methods
    python benchmarks/identify.py --seeds 40 --facts          # the sensors of the project's facts: ½°, 1 °/s, 10 ms

A log is 20 s of a simulated robot under its own regulator, excited; 15 s of it are fitted. The truth is the pole of the
robot linearised, dry friction taken for the damping that brakes alike. With `--facts` the robot is the nonlinear model,
else the MuJoCo twin on its kit.
"""

from __future__ import annotations

import argparse
import math
import os
import platform
import time
from dataclasses import replace
from importlib.metadata import version

import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.control import Estimated, kalman, lqr, make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.experiment import run
from upright.identify.identify import identify_one, study_of
from upright.identify.judge import judge_of, loop_trial
from upright.physics.linear import rolling, unstable_pole
from upright.robots import Kit, Robot, Sensor
from upright.signals import Log

DITHER = {"nxtway-gs": (1.5, 4), "ev3way": (2.5, 4), "twipr": (0.03, 6)}
"""Amplitude [command unit] and how many periods it is held."""
METHODS = ("least-squares", "total-least-squares", "instrumental", "subspace")
SECONDS = 20.0


def facts_kit() -> Kit:
    """Encoders of ½°, a gyro with noise of 1 °/s, and nothing else."""
    nxt = Kit.preset("nxt")
    encoder, gyro = Sensor(quantum=math.radians(0.5)), Sensor(noise=math.radians(1.0))
    sensors = {"sensor/encoder_left": encoder, "sensor/encoder_right": encoder, "sensor/gyro": gyro}
    return replace(nxt, name="facts", sensors=sensors, delay=0.0, jitter=0.0)


def log_of(name: str, kit: Kit, seed: int, facts: bool) -> Log:
    """One excited run."""
    robot = Robot.preset(name)
    if name == "nxtway-gs":
        controller = Estimated(lqr(robot, kit.period), kalman(robot, kit, kit.period))
    else:
        controller = make_controller("lqg", robot, kit, kit.period)
    amplitude, hold = DITHER[name]
    body = Electronics(NonlinearBody(robot) if facts else Twin(robot), kit)
    dither = random_binary(round(SECONDS / kit.period), amplitude, seed, hold)
    return run(body, Excited(controller, dither), seconds=SECONDS, seed=seed)


def coverage(name: str, seeds: int, facts: bool) -> None:
    robot = Robot.preset(name)
    kit = facts_kit() if facts else Kit.preset(robot.kit)
    true = unstable_pole(rolling(robot))
    poles: dict[str, list[float]] = {m: [] for m in METHODS}
    inside: dict[str, list[bool]] = {m: [] for m in METHODS}
    biases: dict[str, list[float]] = {m: [] for m in METHODS}
    holds: dict[str, list[bool]] = {m: [] for m in METHODS}
    failed, busy = 0, time.process_time()
    for seed in range(seeds):
        study = study_of(log_of(name, kit, seed, facts), robot, kit)
        judge = judge_of(study.samples)
        for method in METHODS:
            try:
                found = identify_one(study, method)
            except UprightError:
                failed += 1
                continue
            poles[method].append(found.pole.value)
            inside[method].append(found.pole.low <= true <= found.pole.high)
            biases[method].append(found.pole.bias)
            holds[method].append(loop_trial(study.samples, found.halves, judge).holds)
    spent = (time.process_time() - busy) / seeds
    print(
        f"\n{name} on kit {kit.name}, {seeds} logs; unstable pole {true:.3f} 1/s; {failed} failed; {spent:.1f} s a log"
    )
    header = ("mean", 7), ("scatter", 8), ("bias", 7), ("its estimate", 16), ("truth inside", 13), ("holds", 6)
    print(f"  {'method':<20} " + " ".join(f"{title:>{width}}" for title, width in header))
    for method in METHODS:
        values = np.array(poles[method])
        estimate = f"{np.mean(biases[method]):.2f} ± {np.std(biases[method]):.2f}"
        print(
            f"  {method:<20} {values.mean():>7.2f} {values.std():>8.2f} {values.mean() - true:>7.2f} {estimate:>16} "
            f"{np.mean(inside[method]):>13.0%} {np.mean(holds[method]):>6.0%}"
        )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=10, help="logs of each robot")
    parser.add_argument("--robots", nargs="*", default=list(DITHER), help="presets")
    parser.add_argument("--facts", action="store_true", help="nxtway-gs with encoders of ½° and a gyro of 1 °/s")
    asked = parser.parse_args()
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy"))
    print(f"{platform.machine()}, {os.cpu_count()} cores; Python {platform.python_version()}, {packages}")
    for name in ["nxtway-gs"] if asked.facts else asked.robots:
        coverage(name, asked.seeds, asked.facts)


if __name__ == "__main__":
    main()
