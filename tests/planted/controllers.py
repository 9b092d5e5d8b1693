"""Controllers that are right or spoilt in one way, and the fraction of unseen robots that fall under them."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from upright.certification.certificate import certify
from upright.certification.checks import (
    TrialSetup,
    kernel_controller,
    trials,
)  # fmt: skip
from upright.control import LinearController, as_linear, lqg, make_controller
from upright.errors import DesignFailed, InvalidRobot
from upright.robots import Kit, Robot, find_kit
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
        name, controller.kind, f"{fault.__name__}, {part:g}", certificate.light, str(certificate.reasons[0]),
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
        driving = kernel_controller(controller, robot, kit)
        setup = TrialSetup(robot, robots, kit, seed + count, controller=driving, threads=1)
        fell, count = fell + int(trials(setup).fell.sum()), count + part
        if fell > 2 * MANY * count or (count >= 3 * FIRST and fell < FEW * count / 3):
            break
    return fell / count, count
