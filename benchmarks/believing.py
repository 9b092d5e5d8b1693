"""Whether a certificate's loop and the program that flies say alike who falls, where robot and belief differ.

    python benchmarks/believing.py                    # 1000 runs: a quarter of an hour
    python benchmarks/believing.py --runs 100 --first 5000

Each run has a robot that differs from what its program believes: a further delay of commands up to 30 ms, a dead zone,
another battery, motors that differ, parameters within their spreads. The program is the one for ev3dev, executed in
CPython: it counts its own commands as applied, `lag` periods ago. The certificate's loop is the kernel, told as
`certify --log` tells it: further delay stands in the readings. Pushes are drawn up to what throws the robot.
"""

from __future__ import annotations

import argparse
import dataclasses
import os
import tempfile
import time
from collections import Counter
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads

import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.certify.logged import delaying
from upright.control import make_controller
from upright.experiment import Push, run
from upright.firmware.generate import Firmware, generate
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.parity.execute_python import PythonExecutor
from upright.parity.executed import Executed, calibrated
from upright.robots import Kit, Robot, find_kit
from upright.robots.uncertainty import draw

PAIRS = (("ev3way", "lqg"), ("ev3way", "hinf"), ("ev3way-large-wheels", "lqr"), ("nxtway-gs", "lqg"))
SECONDS, STARTS, LASTS = 4.0, 0.5, 0.1
THROWN = 0.5  # [m/s] of the robot by the hardest push, which throws it
WAYS = ("delay", "dead zone", "battery", "asymmetry")


class Flown(Executed):
    """The executed program alone, without the design beside it."""

    def reset(self) -> None:
        self._offset = calibrated(self._executor, self._readings, self._program.period)
        self.status = 0

    def _compare(self, *_: object) -> None:
        pass


def met(kit: Kit, way: str, rng: np.random.Generator) -> tuple[Kit, float]:
    """The kit as it is, and the delay [s] of commands beyond that."""
    motor = kit.motor
    if way == "dead zone":
        return dataclasses.replace(kit, motor=dataclasses.replace(motor, dead_zone=float(rng.uniform(0, 1.2)))), 0.0
    if way == "battery":
        volts = kit.battery.voltage * float(rng.uniform(0.85, 1.1))
        return dataclasses.replace(kit, battery=dataclasses.replace(kit.battery, voltage=volts)), 0.0
    if way == "asymmetry":
        half = float(rng.uniform(-0.2, 0.2))
        return dataclasses.replace(kit, motor=dataclasses.replace(motor, left=1 - half, right=1 + half)), 0.0
    return kit, float(rng.integers(0, 31)) * 1e-3 if way == "delay" else 0.0


def still(kit: Kit) -> Kit:
    """Without what is random: both machines draw their own noise."""
    none = {"noise": 0.0, "bias": 0.0, "bias_walk": 0.0}
    sensors = {name: dataclasses.replace(s, **none) for name, s in kit.sensors.items()}
    return dataclasses.replace(kit, sensors=sensors, jitter=0.0)


def judged(
    number: int, made: dict[tuple[str, str], tuple[Firmware, PythonExecutor]], folder: Path
) -> tuple[str, bool, bool]:
    """In which way robot `number` differs, whether it falls by the kernel, and under the executed program."""
    rng = np.random.Generator(np.random.Philox(number))
    name, method = PAIRS[number % len(PAIRS)]
    robot, way = Robot.preset(name), WAYS[int(rng.integers(len(WAYS)))]
    kit = still(find_kit(robot.kit))
    design = make_controller(method, robot, kit, kit.period)
    if (name, method) not in made:
        firmware = generate(design, robot, kit, "ev3dev")
        source = folder / f"{name}-{method}.py"
        source.write_text(firmware.text, "utf-8")
        made[name, method] = firmware, PythonExecutor(source, firmware.program)
    firmware, executor = made[name, method]
    truth, (own, later) = draw(robot, 1, number)[0], met(kit, way, rng)
    speed = float(rng.uniform(0.0, THROWN) * rng.choice([-1, 1]))
    force = (robot.body_mass + 2 * robot.wheel_mass) * speed / LASTS
    rows = np.array([[[force, np.nan, STARTS, LASTS]]])
    batch = FleetBatch(parameters=parameters_of([truth]), controller=design, kit=delaying(own, later), pushes=rows)
    fell = bool(simulate(batch, SECONDS, threads=1).fell.any())
    fine = dataclasses.replace(own, motor=dataclasses.replace(own.motor, quantum=0.0), delay=own.delay + later)
    flown = Flown(executor, firmware.program, own, design)
    log = run(Electronics(NonlinearBody(truth), fine), flown, Push(force=force, start=STARTS, duration=LASTS),
              seconds=SECONDS)  # fmt: skip
    return way, fell, bool(log.origin["outcome"]["fell"])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0)
    asked, started = parser.parse_args(), time.perf_counter()
    alike, fell, count = Counter[str](), Counter[str](), Counter[str]()
    made = dict[tuple[str, str], tuple[Firmware, PythonExecutor]]()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(asked.first, asked.first + asked.runs):
            way, told, believing = judged(number, made, Path(folder))
            count[way] += 1
            alike[way] += told == believing
            fell[way] += believing
            if told != believing:
                print(number, PAIRS[number % len(PAIRS)], way, "kernel fell" if told else "program fell", flush=True)
        for _, executor in made.values():
            executor.close()
    for way in WAYS:
        print(f"{way:<12}{alike[way]:>5} of {count[way]} alike, {fell[way]} fell")
    print(f"all{'':<9}{alike.total():>5} of {count.total()}, {time.perf_counter() - started:.0f} s")


if __name__ == "__main__":
    main()
