"""Whether the certificate is right: planted controllers on robots that it has never seen.

    python benchmarks/certificate.py            # 240 controllers, some ten minutes on two cores
    python benchmarks/certificate.py --count 40 # fewer

A controller is designed for a robot and spoilt in one way, or not at all. Its certificate knows the robot by the
spreads of its sources, cut to a share as by a calibration. The truth is one robot drawn from the same spreads, with
noise and seed of its own, under each of the standard pushes for `SECONDS`, with the battery low, full, and somewhere in
between; where it falls in none of these it holds.
"""

from __future__ import annotations

import argparse
import dataclasses
import os
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads

import numpy as np

from upright.certify.certificate import certify
from upright.certify.checks import BATTERIES, kernel_controller, standard_pushes
from upright.control import LinearController, as_linear, lqg, make_controller
from upright.errors import DesignFailed, InvalidRobot
from upright.fleet.ensemble import tables
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot, find_kit
from upright.robots.uncertainty import Uncertainty, draw

ROBOTS = ("nxtway-gs", "nxtway-gs-measured", "ev3way", "herrera2015")
DESIGNS = ("lqr", "lqg", "lqi", "pid", "hinf")
KNOWN = (0.1, 0.2, 0.4)  # shares of the spreads that calibrations of different quality leave
SECONDS = 20.0  # [s] more than twice as long as the certificate looks, so that what falls slowly is seen to
SEED = 20_000


@dataclass(frozen=True)
class Case:
    """A planted controller: on which robot, how well known, spoilt how, and what came of it."""

    robot: str
    design: str
    fault: str
    light: str
    reason: str
    chance: float
    fell: bool


def scaled(controller: LinearController, factor: float) -> LinearController:
    """The same with all commands `factor` times as large."""
    C, Dy, Dr = (factor * m for m in (controller.C, controller.Dy, controller.Dr))
    return dataclasses.replace(controller, C=C, Dy=Dy, Dr=Dr)


def right(robot: Robot, kit: Kit, design: str, _: np.random.Generator) -> tuple[LinearController, Kit]:
    """Nothing is wrong."""
    return as_linear(make_controller(design, robot, kit, kit.period)), kit


def gains(robot: Robot, kit: Kit, design: str, rng: np.random.Generator) -> tuple[LinearController, Kit]:
    """All commands too large or too small."""
    factor = float(np.exp(rng.uniform(np.log(0.25), np.log(4.0))))
    return scaled(right(robot, kit, design, rng)[0], factor), kit


def delay(robot: Robot, kit: Kit, design: str, rng: np.random.Generator) -> tuple[LinearController, Kit]:
    """The command comes later than the design was told."""
    later = dataclasses.replace(kit, delay=kit.delay + float(rng.integers(2, 31)) * 1e-3)
    return right(robot, kit, design, rng)[0], later


def sensor(robot: Robot, kit: Kit, design: str, rng: np.random.Generator) -> tuple[LinearController, Kit]:
    """One sensor read in another unit or with the other sign."""
    controller, _ = right(robot, kit, design, rng)
    By, Dy = controller.By.copy(), controller.Dy.copy()
    column = [i for i, name in enumerate(controller.reads) if name != "sensor/compass"][int(rng.integers(3))]
    factor = float(rng.choice([-1.0, 0.0, 0.5, 2.0]))
    By[:, column] *= factor
    Dy[:, column] *= factor
    return dataclasses.replace(controller, By=By, Dy=Dy), kit


def wrong_robot(robot: Robot, kit: Kit, design: str, rng: np.random.Generator) -> tuple[LinearController, Kit]:
    """Designed for a robot whose centre of mass, wheels or motors are others."""
    name = str(rng.choice(["com_height", "wheel_radius", "torque_constant", "back_emf"]))
    other = robot.replace(**{name: getattr(robot, name) * float(np.exp(rng.uniform(-0.5, 0.5)))})
    return right(other, kit, design, rng)[0], kit


def filtered(robot: Robot, kit: Kit, _: str, rng: np.random.Generator) -> tuple[LinearController, Kit]:
    """A filter that trusts its sensors far too much or too little."""
    factor = float(10 ** rng.uniform(-3, 3))
    sensors = {n: dataclasses.replace(s, noise=max(s.noise, 1e-3) * factor) for n, s in kit.sensors.items()}
    return lqg(robot, dataclasses.replace(kit, sensors=sensors), kit.period), kit


def period(robot: Robot, kit: Kit, design: str, rng: np.random.Generator) -> tuple[LinearController, Kit]:
    """Run at another period than the one it was designed for."""
    own = max(0.002, round(kit.period * float(rng.choice([0.6, 0.8, 1.2, 1.5])), 3))
    return dataclasses.replace(right(robot, kit, design, rng)[0], period=own), kit


FAULTS: tuple[Callable[..., tuple[LinearController, Kit]], ...] = (
    right, right, gains, gains, delay, sensor, wrong_robot, filtered, period,
)  # fmt: skip


def plant(number: int, samples: int = 1000) -> Case | None:
    """Case `number`; None where nothing can be designed for the robot it was planted for."""
    rng = np.random.Generator(np.random.Philox(SEED + number))
    robot = Robot.preset(str(rng.choice(ROBOTS)))
    kit, design, fault = find_kit(robot.kit), str(rng.choice(DESIGNS)), FAULTS[number % len(FAULTS)]
    try:
        controller, met = fault(robot, kit, design, rng)
    except (DesignFailed, InvalidRobot):
        return None
    share = float(rng.choice(KNOWN))
    unknown = Uncertainty.of(robot).scaled(share)
    certificate = certify(controller, robot, met, samples=samples, seed=number, posterior=unknown, sweeps=False)
    truth = draw(robot, 1, SEED + number, unknown)[0]
    return Case(
        robot.name, controller.kind, f"{fault.__name__}, {share:g}", certificate.light, certificate.reasons[0],
        certificate.fell / certificate.samples, falls(controller, robot, truth, met, rng),
    )  # fmt: skip


def falls(controller: LinearController, robot: Robot, truth: Robot, kit: Kit, rng: np.random.Generator) -> bool:
    """Whether the true robot falls in any of the pushes, each a run of `SECONDS` at each of three batteries."""
    low, full = (share * kit.battery.voltage for share in BATTERIES.values())
    voltages = [low, full, float(rng.uniform(low, full))]
    parameters = parameters_of([truth] * len(voltages))
    fell = False
    for push in standard_pushes(robot).values():
        batch = FleetBatch(
            parameters=parameters, controller=kernel_controller(controller, robot, kit).law, kit=kit,
            seed=int(rng.integers(2**31)), kit_changes={"battery.voltage": voltages},
            pushes=tables([push], (), parameters).pushes,
        )  # fmt: skip
        fell |= bool(simulate(batch, SECONDS, threads=1).fell.any())
    return fell


def table(cases: list[Case], labels: list[str]) -> str:
    """Counts by label and light of those that fell and of those that held."""
    lines = [f"{'':<28}{'fell':>6}{'red':>6}{'held':>8}{'green':>7}{'amber':>7}{'red':>6}"]
    for name in sorted(set(labels)):
        own = [c for c, label in zip(cases, labels, strict=True) if label == name]
        fell, held = (Counter(c.light for c in own if c.fell is happened) for happened in (True, False))
        numbers = f"{held.total():>8}{held['green']:>7}{held['amber']:>7}{held['red']:>6}"
        lines.append(f"{name:<28}{fell.total():>6}{fell['red']:>6}{numbers}")
    return "\n".join(lines)


def shares(cases: list[Case]) -> tuple[float, float]:
    """Of those that fell the share that is red, of those that held the share that is green."""
    fell, held = ([c.light for c in cases if c.fell is happened] for happened in (True, False))
    return fell.count("red") / max(1, len(fell)), held.count("green") / max(1, len(held))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=240)
    parser.add_argument("--first", type=int, default=0, help="number of the first case; other numbers, other cases")
    parser.add_argument("--each", action="store_true", help="print every case")
    options = parser.parse_args()
    start = time.perf_counter()
    cases: list[Case] = []
    for number in range(options.first, options.first + options.count):
        if case := plant(number):
            cases.append(case)
            if options.each:
                print(case, flush=True)
    for labels in ([c.fault.split(",")[0] for c in cases], [c.robot for c in cases], ["all"] * len(cases)):
        print(table(cases, labels), end="\n\n")
    red, green = shares(cases)
    print(f"{len(cases)} controllers in {time.perf_counter() - start:.0f} s")
    print(f"of those that fell {red:.1%} are red (bar: 99 %); of those that held {green:.1%} are green (bar: 90 %)")


if __name__ == "__main__":
    main()
