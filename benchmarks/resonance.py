"""Is a gyro that swings, or is filtered, found; and do the intervals of its robot then hold the truth?

    python benchmarks/resonance.py                  # ten robots of each of four gyros
    python benchmarks/resonance.py --seeds 20 40    # others

A robot is drawn from what its preset says of its own numbers, and driven as in `calibrate.py`, as the nonlinear model
behind its kit. What its gyro would read is then computed by `scipy.signal.lsim` along the pitch rate of every
millisecond, and gets the noise and the steps of the kit. So its controller reads a gyro that does not swing.
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Sequence

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command `upright` does

import numpy as np
from scipy.signal import lsim

from planted.twins import DITHER, drawn
from upright.bodies import Electronics
from upright.bodies.body import REST, Sample
from upright.bodies.models import NonlinearBody
from upright.calibrate.calibrate import calibrate
from upright.calibrate.estimate import VISIBLE
from upright.calibrate.resonance import DAMPING, FREQUENCY
from upright.calibrate.summary import COMBINATIONS
from upright.control import Estimated, kalman, lqr, make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.experiment import run
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Robot, find_kit
from upright.signals import STATE_NAMES, Log

SECONDS = 20.0
GYROS: tuple[tuple[str, float, float], ...] = (
    ("ev3way", 11.0, 0.05), ("nxtway-gs", 18.0, 0.1), ("nxtway-gs", 25.0, 0.7), ("ev3way", 0.0, 0.0),
    ("nxtway-gs", 0.0, 0.0),
)  # fmt: skip
"""Presets, frequency [Hz] and damping: two that swing, a filter, and two that do neither."""


class Watched:
    """A body whose pitch rate is noted at every step."""

    def __init__(self, body: NonlinearBody) -> None:
        self._body, self.spec = body, body.spec
        self._row = [signal.name for signal in body.spec.channels].index(f"truth/{STATE_NAMES[1]}")

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        first = self._body.reset(start, seed)
        self.rates = [first.numbers[self._row]]
        return first

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        after = self._body.step(command, disturbance)
        self.rates.append(after.numbers[self._row])
        return after

    def close(self) -> None:
        self._body.close()


def swung(rates: Sequence[float], period: float, frequency: float, damping: float) -> np.ndarray:
    """The pitch rate (n,) of every `period` [s] through ω²/(s² + 2ζωs + ω²), by SciPy."""
    omega = 2 * np.pi * frequency
    system = ([omega**2], [1.0, 2 * damping * omega, omega**2])
    return lsim(system, rates, period * np.arange(len(rates)))[1]


def log_of(name: str, true: Robot, seed: int, frequency: float, damping: float) -> Log:
    """A run of that robot, whose gyro has the resonance; none where the frequency is zero."""
    robot = Robot.preset(name)
    kit = find_kit(robot.kit)
    if name == "nxtway-gs":
        controller = Estimated(lqr(robot, kit.period), kalman(robot, kit, kit.period))
    else:
        controller = make_controller("lqg", robot, kit, kit.period)
    amplitude, hold = DITHER[name]
    dither = random_binary(round(SECONDS / kit.period), amplitude, seed, hold)
    body = Watched(NonlinearBody.dividing(true, kit.period))
    log = run(Electronics(body, kit), Excited(controller, dither), seconds=SECONDS, seed=seed)
    if not frequency:
        return log
    gyro, rng = kit.sensors["sensor/gyro"], np.random.default_rng(7000 + seed)
    read = swung(body.rates, body.spec.period, frequency, damping)
    read = np.interp(log.t - gyro.delay, body.spec.period * np.arange(len(read)), read)
    read = read + gyro.bias * rng.standard_normal() + gyro.noise * rng.standard_normal(len(read))
    read = gyro.quantum * np.round(read / gyro.quantum) if gyro.quantum else read
    return Log(log.t, {**log.channels, "sensor/gyro": read}, log.units, log.origin)


def truth(true: Robot, frequency: float, damping: float) -> dict[str, float]:
    """What a calibration of that run ought to find, but for the dead times."""
    combined = {combination: float(formula(true)) for combination, (_, formula) in COMBINATIONS.items()}
    return {**true.numbers(), **combined, "asymmetry": 0.0, FREQUENCY: frequency, DAMPING: damping}


def judged(name: str, frequency: float, damping: float, seeds: Sequence[int]) -> None:
    """How often a resonance is found, and how often intervals of what is visible hold the truth."""
    robot, inside, missed, found, logs, spent = Robot.preset(name), 0, list[str](), 0, 0, 0.0
    for seed in seeds:
        true = drawn(robot, seed)
        log = log_of(name, true, seed, frequency, damping)
        if log.origin["outcome"]["fell"]:
            continue
        began = time.process_time()
        try:
            result = calibrate(log, robot)
        except UprightError as error:
            print(f"    seed {seed}: {error}")
            continue
        spent, logs, right = spent + time.process_time() - began, logs + 1, truth(true, frequency, damping)
        found += any(e.name == FREQUENCY for e in result.electronics)
        for e in (*result.parameters, *result.combinations, *result.electronics):
            if e.verdict == VISIBLE and e.name in right:
                holds = e.low <= right[e.name] <= e.high
                inside += holds
                if not holds:
                    off = (e.value - right[e.name]) / e.spread
                    missed.append(f"seed {seed}: {e.name} {e.value:.4g}, truth {right[e.name]:.4g}, {off:+.1f}")
    which = f"{frequency:g} Hz, damping {damping:g}" if frequency else "no resonance"
    every = inside + len(missed)
    print(f"{name}, {which}: a resonance in {found} of {logs} logs, truth inside {inside} of {every} intervals "
          f"({inside / max(every, 1):.1%}), {spent / max(logs, 1):.1f} s of processors a log")  # fmt: skip
    print("".join(f"    {text} deviations\n" for text in missed), end="", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, nargs=2, default=(0, 10), metavar=("FIRST", "END"))
    parser.add_argument("--only", type=int, nargs="*", default=range(len(GYROS)), help="which of the gyros, from 0")
    asked = parser.parse_args()
    for which in asked.only:
        name, frequency, damping = GYROS[which]
        judged(name, frequency, damping, range(*asked.seeds))


if __name__ == "__main__":
    main()
