"""Whether the certificate is right: planted controllers on robots that it has never seen.

    python benchmarks/certificate.py            # 240 controllers, some ten minutes on two cores
    python benchmarks/certificate.py --count 40 # fewer
    python benchmarks/certificate.py --outside 40   # robots outside the spreads, each with a log

A controller is designed for a robot and spoilt in one way, or not at all. Its certificate knows the robot by the
spreads of its sources, cut to a share as by a calibration. The truth is one robot drawn from the same spreads, with
noise and seed of its own, under each of the standard pushes for `SECONDS`, with the battery low, full, and somewhere in
between; where it falls in none of these it holds.

With `--outside` a robot differs in one way that its certificate does not know of: battery, slope, mass, delay, dead
zone, motors, gyro's scale or noise, or in none. Its log is of `LOGGED` seconds under the same controller, driven and
knocked, in the nonlinear model; the certificate has this log and the spreads of a calibration.
"""

from __future__ import annotations

import argparse
import dataclasses
import os
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads

import numpy as np

from upright.certify.certificate import certify
from upright.certify.checks import BATTERIES, kernel_controller, standard_pushes
from upright.control import LinearController, as_linear, lqg, make_controller
from upright.errors import DesignFailed, InvalidRobot, UprightError
from upright.experiment import Drive, Impulse, Slope
from upright.fleet.ensemble import tables
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot, find_kit
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log

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


def falls(
    controller: LinearController, robot: Robot, truth: Robot, kit: Kit, rng: np.random.Generator, *,
    slope: Sequence[Any] = (), known: bool = False,
) -> bool:  # fmt: skip
    """Whether the true robot falls in any of the pushes, each a run of `SECONDS` at each of three batteries, or at the
    kit's where that is `known`; on a `slope`."""
    low, full = (share * kit.battery.voltage for share in BATTERIES.values())
    voltages = [kit.battery.voltage] if known else [low, full, float(rng.uniform(low, full))]
    parameters = parameters_of([truth] * len(voltages))
    fell = False
    for push in standard_pushes(robot).values():
        batch = FleetBatch(
            parameters=parameters, controller=kernel_controller(controller, robot, kit).law, kit=kit,
            seed=int(rng.integers(2**31)), kit_changes={"battery.voltage": voltages},
            pushes=tables([push, *slope], (), parameters).pushes, slope=tables([push, *slope], (), parameters).slope,
        )  # fmt: skip
        fell |= bool(simulate(batch, SECONDS, threads=1).fell.any())
    return fell


LOGGED = 12.0  # [s]
OUTSIDE = ("none", "battery", "slope", "mass", "delay", "dead zone", "asymmetry", "gyro scale", "gyro noise")
HOLDING = ("pid", "lqg", "lqr")


@dataclass(frozen=True)
class Stranger:
    """A robot that differs from what its certificate assumes by `size` in one way, and what came of it."""

    robot: str
    design: str
    way: str
    size: float
    light: str
    reason: str
    fell: bool
    logged: bool


def stranger(number: int, samples: int) -> Stranger:
    """Case `number` of `--outside`."""
    rng = np.random.Generator(np.random.Philox(3 * SEED + number))
    name, way = str(rng.choice(["nxtway-gs", "nxtway-gs-measured"])), OUTSIDE[number % len(OUTSIDE)]
    robot, design = Robot.preset(name), str(rng.choice(HOLDING))
    kit = find_kit(robot.kit)
    controller = as_linear(make_controller(design, robot, kit, kit.period))
    unknown = Uncertainty.of(robot).scaled(0.2)
    truth = draw(robot, 1, SEED + number, unknown)[0]
    true_kit, size, pushes = kit, 0.0, list[Any]()
    gain, unequal, kits = 1.0, 0.0, dataclasses.replace
    if way == "battery":
        size = float(rng.uniform(1.8, 5.5))
        true_kit = kits(kit, battery=kits(kit.battery, voltage=size))
    elif way == "slope":
        size = float(np.radians(rng.uniform(2.5, 14.0)) * rng.choice([-1, 1]))
        pushes = [Slope(angle=size)]
    elif way == "mass":
        size = float(rng.choice([rng.uniform(0.2, 0.6), rng.uniform(1.5, 5.0)]))
        loaded = ("body_mass", "pitch_inertia", "roll_inertia", "yaw_inertia")
        truth = truth.replace(**{n: size * getattr(truth, n) for n in loaded})
    elif way == "delay":
        size = float(rng.integers(8, 60)) * 1e-3
        true_kit = kits(kit, delay=kit.delay + size)
    elif way == "dead zone":
        size = float(rng.uniform(0.7, 4.0))
        true_kit = kits(kit, motor=kits(kit.motor, dead_zone=size))
    elif way == "asymmetry":
        size = unequal = float(rng.uniform(0.3, 1.6) * rng.choice([-1, 1]))
    elif way == "gyro scale":
        size = gain = float(rng.choice([rng.uniform(0.25, 0.7), rng.uniform(1.4, 5.0)]))
    elif way == "gyro noise":
        size = float(rng.uniform(0.1, 3.0))
        gyro = kits(kit.sensors["sensor/gyro"], noise=size / gain)
        true_kit = kits(kit, sensors={**kit.sensors, "sensor/gyro": gyro})
    met = _as_met(controller, gain, unequal)
    log = _recorded(met, truth, true_kit, robot, pushes, (gain, unequal, number))
    fell = falls(met, robot, truth, true_kit, rng, slope=pushes, known=way == "battery")
    if log is None:
        return Stranger(name, design, way, size, "", "no log under a holding controller", fell, False)
    given = certify(controller, robot, kit, samples=samples, seed=number, posterior=unknown, sweeps=False, log=log)
    return Stranger(name, design, way, size, given.light, given.reasons[0], fell, True)


def _as_met(controller: LinearController, gain: float, unequal: float) -> LinearController:
    """The controller together with a gyro that counts `gain` times and motors that differ by `unequal`."""
    read = np.array([gain if name == "sensor/gyro" else 1.0 for name in controller.reads])
    sides = np.array([[1 - unequal / 2], [1 + unequal / 2]])
    C, Dy, Dr = (sides * m for m in (controller.C, controller.Dy * read, controller.Dr))
    return dataclasses.replace(controller, By=controller.By * read, C=C, Dy=Dy, Dr=Dr)


def _recorded(
    met: LinearController, truth: Robot, kit: Kit, robot: Robot, pushes: list[Any], wrong: tuple[float, float, int]
) -> Log | None:
    """The log of a robot that is driven and knocked; None where it falls."""
    gain, unequal, number = wrong
    names = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "command/left", "command/right")
    parameters = parameters_of([truth])
    knocks = [Impulse(impulse=0.06 * robot.body_mass, start=t, duration=0.02) for t in (2.0, 6.5)]
    drives = [Drive(speed=0.08, start=3.0), Drive(speed=-0.16, start=5.0), Drive(speed=0.08, start=9.0)]
    programme = tables([*knocks, *pushes], drives, parameters)
    batch = FleetBatch(
        parameters=parameters, controller=kernel_controller(met, robot, kit).law, kit=kit, seed=number,
        pushes=programme.pushes, slope=programme.slope, reference=programme.reference,
    )  # fmt: skip
    result = simulate(batch, LOGGED, record=1, channels=names, threads=1)
    if result.fell.any():
        return None
    columns = dict(zip(names, result.trace[0].T, strict=True))
    full = kit.battery.voltage
    load = np.minimum(np.abs(columns["command/left"]), full) + np.minimum(np.abs(columns["command/right"]), full)
    columns["sensor/battery"] = full - kit.battery.sag * np.concatenate([[0.0], load[:-1]])  # the kernel records none
    columns["sensor/gyro"] = gain * columns["sensor/gyro"]
    columns["command/left"], columns["command/right"] = (
        columns["command/left"] / (1 - unequal / 2), columns["command/right"] / (1 + unequal / 2),
    )  # fmt: skip
    return Log(np.arange(len(result.trace[0])) * met.period, columns)


def strangers(first: int, count: int, samples: int, *, each: bool) -> None:
    """Run and print `--outside`."""
    cases: list[Stranger] = []
    for number in range(first, first + count):
        try:
            cases.append(stranger(number, samples))
        except UprightError as error:
            print(f"{number}: {error}", flush=True)
            continue
        if each:
            print(cases[-1], flush=True)
    print(f"{'':<12}{'no log':>8}{'fell':>6}{'not green':>11}{'held':>6}{'green':>7}{'outside':>9}")
    for way in (*OUTSIDE, "all"):
        own = [c for c in cases if way in (c.way, "all")]
        with_log = [c for c in own if c.logged]
        fell, held = ([c for c in with_log if c.fell is happened] for happened in (True, False))
        numbers = (len(own) - len(with_log), len(fell), sum(c.light != "green" for c in fell), len(held))
        numbers += (sum(c.light == "green" for c in held), sum("outside" in c.reason for c in with_log))
        print(f"{way:<12}" + "".join(f"{n:>{w}}" for n, w in zip(numbers, (8, 6, 11, 6, 7, 9), strict=True)))


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
    parser.add_argument("--outside", type=int, default=0, help="robots outside the spreads, each with a log; no others")
    parser.add_argument("--samples", type=int, default=200, help="robots drawn for each certificate of --outside")
    options = parser.parse_args()
    if options.outside:
        return strangers(options.first, options.outside, options.samples, each=options.each)
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
    return None


if __name__ == "__main__":
    main()
