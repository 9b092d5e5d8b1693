"""Robots that differ in one way from what their certificate assumes, each with a log."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from planted.controllers import SECONDS, SEED
from upright.certification.certificate import certify
from upright.certification.checks import TAIL, kernel_controller
from upright.certification.pushes import standard_pushes
from upright.certification.verdict import MOST_CYCLE, MOST_SATURATED, MOST_TRAVEL
from upright.control import LinearController, as_linear, make_controller
from upright.errors import UprightError
from upright.experiment import Drive, Impulse, Slope
from upright.fleets.ensemble import tables
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.likelihood.assumptions import batteries
from upright.robots import Kit, Robot, find_kit
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log


def tried(
    controller: LinearController, robot: Robot, truth: Robot, kit: Kit, rng: np.random.Generator, *,
    assumed: Kit, slope: Sequence[Any] = (), known: bool = False,
) -> tuple[bool, str]:  # fmt: skip
    """Whether the true robot falls in any of the standard pushes of the robot of the file and the kit it assumes,
    whatever its certificate made of the log, and which limit of an amber light it passes, "" for none. Each is a run of
    `SECONDS` at three batteries, or at the true kit's where that is `known`; on a `slope`."""
    low, full = batteries(robot, assumed) or (None, None)
    runs: list[tuple[float | None, float | None]] = [(low, low), (full, full)]  # of the push, and of the run
    if low is not None and full is not None:
        runs = [(low, kit.battery.voltage)] if known else [*runs, (low, float(rng.uniform(low, full)))]
    parameters, fell, most = parameters_of([truth]), False, np.zeros(3)
    for sized, volts in runs:
        for one in standard_pushes(robot, assumed, sized).values():
            programme = tables([one.push, *slope], (), parameters)
            batch = FleetBatch(
                parameters=parameters, controller=kernel_controller(controller, robot, kit).law, kit=kit,
                seed=int(rng.integers(2**31)), kit_changes={} if volts is None else {"battery.voltage": [volts]},
                pushes=programme.pushes, slope=programme.slope,
            )  # fmt: skip
            result = simulate(batch, SECONDS, record=1, channels=("truth/pitch",), threads=1)
            fell |= bool(result.fell.any())
            ending = result.trace[0, -round(TAIL / controller.period) :, 0]
            travel = float(result.peak[0, 1]) * truth.wheel_radius
            most = np.maximum(most, [float(result.saturated[0]), travel, float(np.ptp(ending)) / 2])
    named = ("at its limit for {:.0%} of the time", "rolls {:.2f} m away", "sways by {:.2f} rad at rest")
    passed = most > (MOST_SATURATED, MOST_TRAVEL, MOST_CYCLE)
    texts = [text.format(value) for text, value, past in zip(named, most.tolist(), passed, strict=True) if past]
    return fell, "" if fell else ", ".join(texts)


LOGGED = 12.0  # [s]
OUTSIDE = ("none", "battery", "slope", "mass", "delay", "dead zone", "asymmetry", "gyro scale", "gyro noise")
HOLDING = ("hinf", "lqg", "lqr")
WEIGHED = 0.005  # one deviation: 3 g of 0.6 kg
REFUSED, NOT_ASKED = "refused", "not asked"
ROBOTS = ("nxtway-gs", "nxtway-gs-measured")
VOLTS = 8.0  # [V] of a full NXT battery: a dead zone of a motor without one is in the same proportion to its limit


@dataclass(frozen=True)
class Stranger:
    """A robot that differs from what its certificate assumes by `size` in one way, and what came of it; one that holds
    `passes` a limit of an amber light, or none ("")."""

    number: int
    robot: str
    design: str
    way: str
    size: float
    light: str
    reason: str
    fell: bool
    logged: bool
    passes: str = ""


def stranger(
    number: int, samples: int, *, plain: bool, robots: Sequence[str] = ROBOTS, scale: bool = False, fallen: bool = False
) -> Stranger:
    """Robot `number`, one of `robots`, which stood on a `scale`; with `fallen` it is certified only if it fell."""
    rng = np.random.Generator(np.random.Philox(3 * SEED + number))
    name, way = str(rng.choice(list(robots))), OUTSIDE[number % len(OUTSIDE)]
    robot, design = Robot.preset(name), str(rng.choice(HOLDING))
    kit = find_kit(robot.kit)
    controller = as_linear(make_controller(design, robot, kit, kit.period))
    unknown = Uncertainty.of(robot).scaled(0.2)
    truth = draw(robot, 1, SEED + number, unknown)[0]
    true_kit, size, pushes = kit, 0.0, list[Any]()
    gain, kits = 1.0, dataclasses.replace
    if way == "battery" and batteries(robot, kit) is None:
        way = "none"
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
        later = {n: kits(s, delay=s.delay + size) for n, s in kit.sensors.items()}
        true_kit = kits(kit, sensors=later)  # of commands it would be told, as no program is
    elif way == "dead zone":
        size = float(rng.uniform(0.7, 4.0)) * (kit.motor.limit / VOLTS if kit.drive == "torque" else 1.0)
        true_kit = kits(kit, motor=kits(kit.motor, dead_zone=size))
    elif way == "asymmetry":
        size = float(rng.uniform(0.3, 1.6) * rng.choice([-1, 1]))
        true_kit = kits(kit, motor=kits(kit.motor, left=1 - size / 2, right=1 + size / 2))
    elif way == "gyro scale":
        size = gain = float(rng.choice([rng.uniform(0.25, 0.7), rng.uniform(1.4, 5.0)]))
    elif way == "gyro noise":
        size = float(rng.uniform(0.1, 3.0))
        gyro = kits(kit.sensors["sensor/gyro"], noise=size / gain)
        true_kit = kits(kit, sensors={**kit.sensors, "sensor/gyro": gyro})
    met = _as_met(controller, gain)
    log = _recorded(met, truth, true_kit, robot, pushes, gain, number)
    fell, passes = tried(met, robot, truth, true_kit, rng, assumed=kit, slope=pushes, known=way == "battery")
    if log is None:
        return Stranger(number, name, design, way, size, "", "no log under a holding controller", fell, False, passes)
    if fallen and not fell:
        return Stranger(number, name, design, way, size, NOT_ASKED, "", fell, True, passes)
    try:
        given = certify(
            controller, robot, kit, samples=samples, seed=number, posterior=None if plain else unknown, sweeps=False,
            log=log, threads=1, weighed=_weight(truth, number) if scale else None,
        )  # fmt: skip
    except UprightError as error:
        return Stranger(number, name, design, way, size, REFUSED, str(error), fell, True, passes)
    return Stranger(number, name, design, way, size, given.light, " ".join(map(str, given.reasons)), fell, True, passes)


def _weight(robot: Robot, number: int) -> float:
    """What a scale that is right to `WEIGHED` says [kg]."""
    error = np.random.Generator(np.random.Philox([number, 1])).normal()
    return (robot.body_mass + 2 * robot.wheel_mass) * float(1 + WEIGHED * error)


def _as_met(controller: LinearController, gain: float) -> LinearController:
    """The controller together with a gyro that counts `gain` times."""
    read = np.array([gain if name == "sensor/gyro" else 1.0 for name in controller.reads])
    return dataclasses.replace(controller, By=controller.By * read, Dy=controller.Dy * read)


def _recorded(
    met: LinearController, truth: Robot, kit: Kit, robot: Robot, pushes: list[Any], gain: float, number: int
) -> Log | None:
    """The log of a robot that is driven and knocked; None where it falls."""
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
    if np.isfinite(full):
        late = np.concatenate([[0.0], load[:-1]])
        columns["sensor/battery"] = full - kit.battery.sag * late  # the kernel records none
    columns["sensor/gyro"] = gain * columns["sensor/gyro"]
    units = {name: robot.command_unit for name in names if name.startswith("command/")}
    return Log(np.arange(len(result.trace[0])) * met.period, columns, units)
