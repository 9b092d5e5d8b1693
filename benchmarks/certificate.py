"""Whether the certificate is right: planted controllers on robots that it has never seen.

    python benchmarks/certificate.py                      # 40 controllers on each side, nine presets: most of an hour
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

from collections import Counter
from collections.abc import Sequence
from typing import Any

import harness

from planted.controllers import DESIGNS, FAULTS, FEW, MANY, SEED, Case, plant, right
from upright.certification.certificate import certify
from upright.certification.checks import (
    TrialSetup,
    kernel_controller,
    trials,
)  # fmt: skip
from upright.control import CONTROLLERS, make_controller
from upright.errors import UprightError
from upright.robots import Kit, Robot, find_kit
from upright.robots.robot import preset_names
from upright.robots.uncertainty import draw

REFUSED = ("red", "unknown")  # lights with which no robot is driven


def inside(robots: Sequence[str], first: int, sides: int, samples: int, *, each: bool) -> None:
    """Cases of each robot until there are `sides` on each side, or twelve times as many in all."""
    table = harness.Table(
        "robot <22", "≥ 10 % >8", "refused >8", "not >5", "≤ 1 % >9", "green >7", "amber >7", "refused >8", "between >9"
    )
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
        table.row(*counts(name, own))
        rows += own
    table.row(*counts("all", rows))
    for case in rows:
        refused = case.light in REFUSED
        if (case.falls >= MANY and not refused) or (case.falls <= FEW and refused):
            print(f"    {case}")


def counts(name: str, cases: Sequence[Case]) -> tuple[Any, ...]:
    """A row of the table of `inside`."""
    many = Counter(c.light for c in cases if c.falls >= MANY)
    few = Counter(c.light for c in cases if c.falls <= FEW)
    between = len(cases) - many.total() - few.total()
    refused = sum(many[light] for light in REFUSED)
    lights = few["green"], few["amber"], sum(few[light] for light in REFUSED)
    return name, many.total(), refused, many.total() - refused, few.total(), *lights, between


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
    table = harness.Table("robot <22", "method <10", "default >9", "its own >9", "of >6")
    for name in robots:
        robot = Robot.preset(name)
        kit, drawn = find_kit(robot.kit), draw(robot, count, SEED)
        for method in DESIGNS:
            default = kernel_controller(make_controller(method, robot, kit, kit.period), robot, kit)
            fell = int(trials(TrialSetup(robot, drawn, kit, SEED, controller=default, threads=1)).fell.sum())
            own = sum(_falls_under_its_own(method, robot, one, kit) for one in drawn)
            table.row(name, method, fell, own, count)


def _falls_under_its_own(method: str, nominal: Robot, robot: Robot, kit: Kit) -> bool:
    """Also where nothing can be designed for it."""
    try:
        own = kernel_controller(make_controller(method, robot, kit, kit.period), robot, kit)
    except UprightError:
        return True
    return bool(trials(TrialSetup(nominal, [robot], kit, SEED, controller=own, threads=1)).fell.any())


def main() -> None:
    asked = harness.options(
        __doc__, robots=tuple(preset_names()), first=0, sides=40, samples=1000, each=False, defaults=False,
        methods=(), exactly=0,
    )  # fmt: skip
    clock = harness.Clock()
    if asked.defaults:
        defaults(asked.robots, asked.samples, asked.methods)
    elif asked.exactly:
        exactly(asked.robots, asked.exactly)
    else:
        inside(asked.robots, asked.first, asked.sides, asked.samples, each=asked.each)
    print(clock)


if __name__ == "__main__":
    main()
