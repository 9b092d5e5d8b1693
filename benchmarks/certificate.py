"""Whether the certificate is right: planted controllers on robots that it has never seen.

    python benchmarks/certificate.py                      # 40 controllers on each side, six presets: half an hour
    python benchmarks/certificate.py --robots twipr --sides 10
    python benchmarks/certificate.py --defaults           # the light of every method on every preset with its kit
    python benchmarks/certificate.py --outside 40         # robots outside the spreads, each with a log

A controller is designed for a robot and spoilt in one way, or not at all. Its certificate knows the robot by the
spreads of its sources, all of them or a part as after a calibration. The truth is the fraction of falls among robots
drawn from the same spreads with other seeds, up to `DRAWN` of them: fewer where the fraction is clear. Fractions from 1
to 10 % are not scored.

With `--outside` a robot differs in one way that its certificate does not know of: battery, slope, mass, delay, dead
zone, motors, gyro's scale or noise, or in none. Its log is of `LOGGED` seconds under the same controller, driven and
knocked, in the nonlinear model; the certificate has this log and the spreads of an older calibration. It falls where it
does under any of the standard pushes, in runs of `SECONDS`.
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
from upright.certify.checks import Course, batteries, kernel_controller, standard_pushes, trials
from upright.control import CONTROLLERS, LinearController, as_linear, lqg, make_controller
from upright.errors import DesignFailed, InvalidRobot, UprightError
from upright.experiment import Drive, Impulse, Slope
from upright.fleet.ensemble import tables
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot, find_kit
from upright.robots.robot import preset_names
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log

DESIGNS = ("lqr", "lqg", "hinf", "pid")
KNOWN = (0.1, 0.2, 0.4, 1.0)  # parts of the spreads: as calibrations of different quality leave them, and none
SECONDS = 20.0  # [s] more than twice as long as the certificate looks, so that what falls slowly is seen to
SEED = 20_000
DRAWN, FIRST = 10_000, 1000
FEW, MANY = 0.01, 0.1
"""Fractions of falls up to which a controller should be green, and from which on it should be red."""


@dataclass(frozen=True)
class Case:
    """A planted controller: on which robot, how well known, spoilt how; its light, and the true fraction that falls."""

    robot: str
    design: str
    fault: str
    light: str
    reason: str
    counted: float
    falls: float
    draws: int


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


def plant(name: str, number: int, samples: int = 1000, most: int = DRAWN) -> Case | None:
    """Case `number` of the preset `name`; None where nothing can be designed for the robot it was planted for."""
    rng = np.random.Generator(np.random.Philox(SEED + number))
    robot = Robot.preset(name)
    kit, design, fault = find_kit(robot.kit), str(rng.choice(DESIGNS)), FAULTS[number % len(FAULTS)]
    try:
        controller, met = fault(robot, kit, design, rng)
    except (DesignFailed, InvalidRobot):
        return None
    part = float(rng.choice(KNOWN))
    unknown = Uncertainty.of(robot).scaled(part)
    certificate = certify(
        controller, robot, met, samples=samples, seed=number, posterior=unknown, sweeps=False, threads=1
    )
    falls, draws = fraction(controller, robot, met, unknown, SEED + number, most)
    return Case(
        name, controller.kind, f"{fault.__name__}, {part:g}", certificate.light, certificate.reasons[0],
        certificate.fell / certificate.samples, falls, draws,
    )  # fmt: skip


def fraction(
    controller: LinearController, robot: Robot, kit: Kit, unknown: Uncertainty, seed: int, most: int
) -> tuple[float, int]:
    """The fraction of robots that fall in the standard pushes, and of how many draws.

    It ends early beyond doubt: over 2 MANY, or under FEW / 3, of FIRST draws or more (binomial: one error in 10⁹, or in
    10³ of FIRST, 10⁷ of 3 FIRST).
    """
    fell = count = 0
    while count < most:
        part = FIRST if count < 3 * FIRST else min(most - count, 3500)
        robots = draw(robot, part, seed + 7919 * count, unknown)
        course = Course(kernel_controller(controller, robot, kit), robot, robots, kit, seed + count, threads=1)
        fell, count = fell + int(trials(course).fell.sum()), count + part
        if fell > 2 * MANY * count or (count >= 3 * FIRST and fell < FEW * count / 3):
            break
    return fell / count, count


def falls(
    controller: LinearController, robot: Robot, truth: Robot, kit: Kit, rng: np.random.Generator, *,
    assumed: Kit, slope: Sequence[Any] = (), known: bool = False,
) -> bool:  # fmt: skip
    """Whether the true robot falls in any of the pushes that its certificate tries with the kit it assumes, each a run
    of `SECONDS` at three batteries, or at the true kit's where that is `known`; on a `slope`."""
    low, full = batteries(robot, assumed) or (None, None)
    tried: list[tuple[float | None, float | None]] = [(low, low), (full, full)]  # of the push, and of the run
    if low is not None and full is not None:
        tried = [(low, kit.battery.voltage)] if known else [*tried, (low, float(rng.uniform(low, full)))]
    parameters, fell = parameters_of([truth]), False
    for sized, volts in tried:
        for standard in standard_pushes(robot, assumed, sized).values():
            programme = tables([standard.push, *slope], (), parameters)
            batch = FleetBatch(
                parameters=parameters, controller=kernel_controller(controller, robot, kit).law, kit=kit,
                seed=int(rng.integers(2**31)), kit_changes={} if volts is None else {"battery.voltage": [volts]},
                pushes=programme.pushes, slope=programme.slope,
            )  # fmt: skip
            fell |= bool(simulate(batch, SECONDS, threads=1).fell.any())
    return fell


LOGGED = 12.0  # [s]
OUTSIDE = ("none", "battery", "slope", "mass", "delay", "dead zone", "asymmetry", "gyro scale", "gyro noise")
HOLDING = ("hinf", "lqg", "lqr")


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
    fell = falls(met, robot, truth, true_kit, rng, assumed=kit, slope=pushes, known=way == "battery")
    if log is None:
        return Stranger(name, design, way, size, "", "no log under a holding controller", fell, False)
    given = certify(controller, robot, kit, samples=samples, seed=number, posterior=unknown, sweeps=False, log=log)
    return Stranger(name, design, way, size, given.light, "; ".join(given.reasons), fell, True)


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
    print(f"{'':<12}{'no log':>8}{'fell':>6}{'not green':>11}{'held':>6}{'green':>7}{'taken':>9}")
    for way in (*OUTSIDE, "all"):
        own = [c for c in cases if way in (c.way, "all")]
        with_log = [c for c in own if c.logged]
        fell, held = ([c for c in with_log if c.fell is happened] for happened in (True, False))
        numbers = (len(own) - len(with_log), len(fell), sum(c.light != "green" for c in fell), len(held))
        numbers += (sum(c.light == "green" for c in held), sum("as the log shows" in c.reason for c in with_log))
        print(f"{way:<12}" + "".join(f"{n:>{w}}" for n, w in zip(numbers, (8, 6, 11, 6, 7, 9), strict=True)))


def inside(robots: Sequence[str], first: int, sides: int, samples: int, *, each: bool) -> None:
    """Cases of each robot until there are `sides` on each side, or twelve times as many in all."""
    print(f"{'':<22}{'≥ 10 %':>8}{'red':>6}{'not':>5}{'≤ 1 %':>9}{'green':>7}{'amber':>7}{'red':>5}{'between':>9}")
    rows: list[Case] = []
    for name in robots:
        own: list[Case] = []
        for number in range(first, first + 12 * sides):
            many, few = sum(c.falls >= MANY for c in own), sum(c.falls <= FEW for c in own)
            if min(many, few) >= sides:
                break
            # of a side that is full no further one is needed: those that nothing is wrong with are every ninth or two
            if few >= sides > many and FAULTS[number % len(FAULTS)] is right:
                continue
            if (case := plant(name, number, samples)) is None:
                continue
            own.append(case)
            if each:
                print(case, flush=True)
        print(counts(name, own), flush=True)
        rows += own
    print(counts("all", rows))
    for case in rows:
        if (case.falls >= MANY and case.light != "red") or (case.falls <= FEW and case.light == "red"):
            print(f"    {case}")


def counts(name: str, cases: Sequence[Case]) -> str:
    """A row of the table of `inside`."""
    many = Counter(c.light for c in cases if c.falls >= MANY)
    few = Counter(c.light for c in cases if c.falls <= FEW)
    between = len(cases) - many.total() - few.total()
    return (f"{name:<22}{many.total():>8}{many['red']:>6}{many.total() - many['red']:>5}{few.total():>9}"
            f"{few['green']:>7}{few['amber']:>7}{few['red']:>5}{between:>9}")  # fmt: skip


def defaults(robots: Sequence[str], samples: int) -> None:
    """The light of every method on every robot with its kit, over the spreads in its file."""
    for name in robots:
        for method, entry in CONTROLLERS.items():
            if entry.reads_truth or not entry.benched:
                continue
            robot = Robot.preset(name)
            try:
                c = certify(method, robot, samples=samples, sweeps=False, threads=1)
            except UprightError as error:
                print(f"{name:<22}{method:<20}{error}")
                continue
            fell = f"{c.fell / c.samples:>7.1%} fell, {c.beyond / c.samples:.1%} beyond any controller"
            print(f"{name:<22}{method:<20}{c.light:<7}{fell}; {c.reasons[0]}", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--robots", nargs="+", default=list(preset_names()))
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--sides", type=int, default=40, help="controllers on each side, of each robot")
    parser.add_argument("--samples", type=int, default=1000)
    parser.add_argument("--each", action="store_true", help="print every case")
    parser.add_argument("--defaults", action="store_true", help="instead: the light of every method on every preset")
    parser.add_argument("--outside", type=int, default=0, metavar="COUNT", help="instead: robots outside the spreads")
    asked = parser.parse_args()
    started = time.perf_counter()
    if asked.defaults:
        defaults(asked.robots, asked.samples)
    elif asked.outside:
        strangers(asked.first, asked.outside, asked.samples, each=asked.each)
    else:
        inside(asked.robots, asked.first, asked.sides, asked.samples, each=asked.each)
    print(f"{time.perf_counter() - started:.0f} s")


if __name__ == "__main__":
    main()
