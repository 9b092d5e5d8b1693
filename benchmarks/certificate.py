"""Whether the certificate is right: planted controllers on robots that it has never seen.

    python benchmarks/certificate.py                      # 40 controllers on each side, six presets: half an hour
    python benchmarks/certificate.py --robots twipr --sides 10
    python benchmarks/certificate.py --defaults           # the light of every method on every preset with its kit
    python benchmarks/certificate.py --defaults --methods hinf robust
    python benchmarks/certificate.py --exactly 100        # drawn robots, each under controllers designed for itself

A controller is designed for a robot and spoilt in one way, or not at all. Its certificate knows the robot by the
spreads of its sources, all of them or a part as after a calibration. The truth is the fraction of falls among robots
drawn from the same spreads with other seeds, up to `DRAWN` of them: fewer where the fraction is clear. Fractions from 1
to 10 % are not scored.

With `--exactly` every drawn robot is known exactly: what still falls, falls for want of motors, sensors or time, and
what falls besides under the default falls since the robots of the spreads differ. Robots outside the spreads are those
of `certificate_outside.py`.
"""

from __future__ import annotations

import argparse
import dataclasses
import os
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads

import numpy as np

from upright.certify.certificate import certify
from upright.certify.checks import (
    TrialSetup,
    kernel_controller,
    trials,
)  # fmt: skip
from upright.control import CONTROLLERS, LinearController, as_linear, lqg, make_controller
from upright.errors import DesignFailed, InvalidRobot, UprightError
from upright.robots import Kit, Robot, find_kit
from upright.robots.robot import preset_names
from upright.robots.uncertainty import Uncertainty, draw

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
        setup = TrialSetup(kernel_controller(controller, robot, kit), robot, robots, kit, seed + count, threads=1)
        fell, count = fell + int(trials(setup).fell.sum()), count + part
        if fell > 2 * MANY * count or (count >= 3 * FIRST and fell < FEW * count / 3):
            break
    return fell / count, count


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


def defaults(robots: Sequence[str], samples: int, methods: Sequence[str]) -> None:
    """The light of these methods (none: every one) on every robot with its kit, over the spreads in its file."""
    for name in robots:
        for method, entry in CONTROLLERS.items():
            if entry.reads_truth or not entry.benched or (methods and method not in methods):
                continue
            robot = Robot.preset(name)
            try:
                c = certify(method, robot, samples=samples, sweeps=False, threads=1)
            except UprightError as error:
                print(f"{name:<22}{method:<20}{error}")
                continue
            fell = f"{c.fell / c.samples:>7.1%} fell, {c.beyond / c.samples:.1%} beyond any controller"
            print(f"{name:<22}{method:<20}{c.light:<7}{fell}; {c.reasons[0]}", flush=True)


def exactly(robots: Sequence[str], count: int) -> None:
    """Falls of drawn robots under the pushes for the nominal one: the default's, and those of own controllers."""
    print(f"{'':<22}{'':<10}{'default':>9}{'its own':>9}{'of':>6}")
    for name in robots:
        robot = Robot.preset(name)
        kit, drawn = find_kit(robot.kit), draw(robot, count, SEED)
        for method in DESIGNS:
            default = kernel_controller(make_controller(method, robot, kit, kit.period), robot, kit)
            fell = int(trials(TrialSetup(default, robot, drawn, kit, SEED, threads=1)).fell.sum())
            own = sum(_falls_under_its_own(method, robot, one, kit) for one in drawn)
            print(f"{name:<22}{method:<10}{fell:>9}{own:>9}{count:>6}", flush=True)


def _falls_under_its_own(method: str, nominal: Robot, robot: Robot, kit: Kit) -> bool:
    """Also where nothing can be designed for it."""
    try:
        own = kernel_controller(make_controller(method, robot, kit, kit.period), robot, kit)
    except UprightError:
        return True
    return bool(trials(TrialSetup(own, nominal, [robot], kit, SEED, threads=1)).fell.any())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--robots", nargs="+", default=list(preset_names()))
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--sides", type=int, default=40, help="controllers on each side, of each robot")
    parser.add_argument("--samples", type=int, default=1000)
    parser.add_argument("--each", action="store_true", help="print every case")
    parser.add_argument("--defaults", action="store_true", help="instead: the light of every method on every preset")
    parser.add_argument("--methods", nargs="+", default=[], help="with --defaults: these alone")
    parser.add_argument("--exactly", type=int, default=0, metavar="COUNT", help="instead: robots known exactly")
    asked = parser.parse_args()
    started = time.perf_counter()
    if asked.defaults:
        defaults(asked.robots, asked.samples, asked.methods)
    elif asked.exactly:
        exactly(asked.robots, asked.exactly)
    else:
        inside(asked.robots, asked.first, asked.sides, asked.samples, each=asked.each)
    print(f"{time.perf_counter() - started:.0f} s")


if __name__ == "__main__":
    main()
