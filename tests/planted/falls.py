"""Robots that fell for a planted reason, and robots that did not fall."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from upright.bodies import Electronics
from upright.bodies.body import REST, Sample
from upright.bodies.twin import Twin
from upright.control import Controller, make_controller
from upright.control.reach import largest_command
from upright.errors import InvalidRobot
from upright.experiment import Drive, Impulse, Push, run
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty, deviations, draw
from upright.signals import Log

CAUSES = (
    "saturation", "gyro bias", "dropped samples", "wheel slip", "weak battery", "push too large", "delay grown",
    "gain too low", "gain too high",
)  # fmt: skip
NO_FALL = "it did not fall"
ROBOTS = ("nxtway-gs", "ev3way", "twipr")
DESIGNS = ("lqg", "lqi", "pid", "hinf")
KNOWN = 0.2
"""Share of the spreads by which the robot differs from the one that the post-mortem is told, as after a calibration."""

LEAST_KNOWN = 0.05
"""No parameter is farther off than by this share of itself (one standard deviation)."""

AFTER = 5.0  # [s] within which the planted change must have made it fall
TRIES = 200
SEED = 1000


class NoFall(Exception):
    """No run of a seed falls for its cause."""


@dataclass(frozen=True)
class Fault:
    """What changes at `onset` [s]: of which `cause`, in which `way`, how badly."""

    cause: str
    way: str
    onset: float
    size: float
    sign: float = 1.0


@dataclass(frozen=True, eq=False)
class Planted:
    """One run: what was planted, on which robot, under which controller, and what a real robot would have logged."""

    cause: str
    fault: Fault
    robot: str
    design: str
    fell_at: float
    log: Log
    controller: Controller


class FaultyBody:
    """A body in its kit, whose command line, sensors or floor change at the fault's onset."""

    def __init__(self, twin: Twin, kit: Kit, fault: Fault, seed: int) -> None:
        self.inner = Electronics(twin, kit)
        self.twin, self.kit, self.fault, self.seed = twin, kit, fault, seed
        self.spec = self.inner.spec
        self.names = [signal.name for signal in self.spec.channels]
        self.stride = round(kit.period / self.spec.period)
        self.grip = float(twin._model.geom_friction[:, 0].max())
        self.most = largest_command(twin.spec.robot, kit)

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        self.rng, self.count = np.random.default_rng(self.seed), 0
        self._friction(self.grip)
        late = 1 + round(self.fault.size * self.kit.period / self.spec.period) if self._is("delay grown") else 1
        self.commands: deque[Any] = deque([(0.0, 0.0)] * late, maxlen=late)
        first = self.inner.reset(start, seed)
        self.readings: deque[Any] = deque([first.values] * late, maxlen=late)
        self.held, self.dropping = first.values, False
        return first

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        t = self.count * self.spec.period
        on = t >= self.fault.onset - 1e-9
        if on and self._is("wheel slip"):
            self._friction(self.fault.size)
        self.commands.append(tuple(command))
        sent = self.commands[0] if on and self._is("delay grown", "command") else tuple(command)
        if on and self._is("weak battery"):
            left = self._left(t)
            gain = 1.0 if self.fault.way == "limit" else left
            sent = tuple(min(max(gain * u, -left * self.most), left * self.most) for u in sent)
        got = self.inner.step(sent, disturbance)
        self.count += 1
        return got._replace(numbers=tuple(self._seen(got.values, on, t).tolist()))

    def close(self) -> None:
        self.inner.close()

    def _is(self, cause: str, way: str = "") -> bool:
        return self.fault.cause == cause and way in ("", self.fault.way)

    def _left(self, t: float) -> float:
        """The share of the battery that is left: it breaks down within half a second."""
        return 1 - (1 - self.fault.size) * min(1.0, (t - self.fault.onset) / 0.5)

    def _friction(self, grip: float) -> None:
        self.twin._model.geom_friction[1:, 0] = grip

    def _seen(self, values: Any, on: bool, t: float) -> Any:
        self.readings.append(values)
        if on and self._is("delay grown", "sensors"):
            values = self.readings[0]
        if on and self._is("gyro bias"):
            values = self._biased(values, t)
        if self._is("sensor stuck"):
            values, place = values.copy(), self.names.index(self.fault.way)
            self.stuck_at = values[place] if not on else self.stuck_at
            values[place] = self.stuck_at
        if on and self._is("weak battery") and "sensor/battery" in self.names:
            values = values.copy()
            values[self.names.index("sensor/battery")] *= self._left(t)
        if self.count % self.stride == 0:
            self.dropping = on and self._is("dropped samples") and self.rng.random() < self.fault.size
        if self.dropping:
            return self.held
        self.held = values
        return values

    def _biased(self, values: Any, t: float) -> Any:
        grown = self.fault.size if self.fault.way == "step" else self.fault.size * (t - self.fault.onset)
        quantum = self.kit.sensors["sensor/gyro"].quantum
        bias = self.fault.sign * (round(grown / quantum) * quantum if quantum else grown)
        values = values.copy()
        values[self.names.index("sensor/gyro")] += bias
        return values


class FaultyController:
    """A controller that gives `factor` of its command from `onset` on, or does not run while readings are dropped."""

    def __init__(self, inner: Controller, fault: Fault, body: FaultyBody) -> None:
        self.inner, self.fault, self.body, self.spec = inner, fault, body, inner.spec
        self.reset()

    def reset(self) -> None:
        self.inner.reset()
        self.now, self.last = 0, (0.0, 0.0)
        self.skipped: list[int] = []

    def step(self, measurement: Any, reference: Any) -> tuple[float, float]:
        t = self.now * self.spec.period
        if self.fault.way == "lost" and self.body.dropping:
            self.skipped.append(self.now)
            self.now += 1
            return self.last
        left, right = self.inner.step(measurement, reference)
        gains = self.fault.cause in ("gain too low", "gain too high") and t >= self.fault.onset - 1e-9
        factor = self.fault.size if gains else 1.0
        self.now, self.last = self.now + 1, (factor * left, factor * right)
        return self.last

    def estimate(self) -> Sequence[float]:
        return self.inner.estimate()

    def applied(self, command: Sequence[float]) -> None:
        if not (self.fault.way == "lost" and self.body.dropping):
            self.inner.applied(command)

    def to_json(self) -> dict[str, Any]:
        return self.inner.to_json()


@cache
def _controller(robot: str, design: str) -> Controller:
    nominal = Robot.preset(robot)
    kit = Kit.preset(nominal.kit)
    return make_controller(design, nominal, kit, kit.period)


def _fault(cause: str, rng: np.random.Generator, tried: float) -> Fault:
    """A fault of random way and size; `tried` from 0 to 1 moves the size towards the worse, until the robot falls."""
    onset, sign = float(rng.uniform(2.5, 4.5)), float(rng.choice([-1.0, 1.0]))
    level = min(1.0, float(rng.uniform(0.0, 0.5)) + tried)

    def between(mild: float, bad: float) -> float:
        return mild * (bad / mild) ** level

    ways: dict[str, tuple[tuple[str, ...], float, float]] = {
        "saturation": (("drive",), 0.8, 4.0),
        "gyro bias": (("step", "ramp"), 0.05, 2.0),
        "dropped samples": (("held", "lost"), 0.4, 0.97),
        "wheel slip": (("floor",), 0.15, 0.004),
        "weak battery": (("pwm", "limit"), 0.6, 0.03),
        "push too large": (("push",), 0.3, 5.0),
        "delay grown": (("command", "sensors"), 1.0, 12.0),
        "gain too low": (("law",), 0.7, 0.05),
        "gain too high": (("law",), 1.3, 16.0),
        NO_FALL: (("none",), 1.0, 1.0),
    }
    names, mild, bad = ways[cause]
    return Fault(cause, str(rng.choice(names)), onset, between(mild, bad), sign)


def _programme(fault: Fault, robot: Robot, kit: Kit, rng: np.random.Generator) -> tuple[list[Any], list[Any]]:
    """Pushes and references: harmless ones before the onset, those that show slip or a weak battery after it."""
    mass = robot.body_mass + 2 * robot.wheel_mass
    knock = 0.12 * mass
    pushes: list[Any] = [
        Impulse(impulse=float(rng.uniform(-1, 1)) * knock, start=float(rng.uniform(0.6, fault.onset - 0.8)),
                duration=0.02)
        for _ in range(int(rng.integers(0, 3)))
    ]  # fmt: skip
    references: list[Any] = []
    speed = float(rng.uniform(-0.15, 0.15))
    begin = float(rng.uniform(0.5, fault.onset))
    if rng.random() < 0.4:
        references.append(Drive(speed=speed, start=begin))
    provoked = fault.cause == "wheel slip" or fault.way == "limit"
    after = [float(rng.uniform(0.3, 2.5)) for _ in range(2)] if provoked else []
    pushes += [
        Impulse(impulse=fault.sign * float(rng.uniform(0.5, 1.0)) * knock, start=fault.onset + t, duration=0.02)
        for t in after
    ]
    if fault.cause == "push too large":
        duration, height = float(rng.uniform(0.02, 0.25)), float(rng.uniform(0.0, 2.0)) * robot.com_height
        force = fault.sign * fault.size * mass / duration
        pushes.append(Push(force=force, start=fault.onset, duration=duration, height=height))
    if fault.cause == "saturation" and fault.way == "drive":
        fastest = largest_command(robot, kit) / max(robot.back_emf, 1e-9) if robot.drive == "voltage" else 40.0
        references.append(Drive(speed=fault.sign * fault.size * fastest * robot.wheel_radius, start=fault.onset))
    return pushes, references


def _without(fault: Fault, pushes: list[Any], references: list[Any]) -> tuple[Fault, list[Any], list[Any]]:
    """The same run without what was planted."""
    planted = fault.cause in ("push too large", "saturation")
    at_onset = lambda p: planted and getattr(p, "start", None) == fault.onset  # noqa: E731
    kept = [p for p in pushes if not at_onset(p)], [r for r in references if not at_onset(r)]
    return Fault(NO_FALL, "none", fault.onset, 1.0), *kept


def planted(cause: str, seed: int) -> Planted:
    """A run that fell for that cause, or for `NO_FALL` one that did not; raises where none is found."""
    kind = [*CAUSES, NO_FALL].index(cause)
    for tried in range(TRIES):
        robot = str(np.random.default_rng([seed, kind, tried // 10]).choice(ROBOTS))
        rng = np.random.default_rng([seed, kind, tried])
        design = str(rng.choice(DESIGNS))
        nominal = Robot.preset(robot)
        kit = Kit.preset(nominal.kit)
        true = draw(nominal, 1, int(rng.integers(2**31)), Uncertainty.normal(nominal, _sizes(nominal)))[0]
        fault = _fault(cause, rng, 0.1 * (tried % 10))
        pushes, references = _programme(fault, nominal, kit, rng)
        seconds = fault.onset + AFTER
        try:
            log, end, skipped = _run(true, kit, robot, design, fault, pushes, references, seconds, seed)
        except (ValueError, InvalidRobot):  # MuJoCo: a drawn robot that no rigid body is
            continue
        if cause == NO_FALL:
            if not end["fell"]:
                real = _as_real(log, skipped, rng)
                return Planted(cause, fault, robot, design, math.inf, real, _controller(robot, design))
            continue
        if not end["fell"] or end["seconds"] < fault.onset + 0.15:
            continue
        plain = _without(fault, pushes, references)
        if not _run(true, kit, robot, design, *plain, end["seconds"] + 1.0, seed)[1]["fell"]:
            real = _as_real(log, skipped, rng)
            return Planted(cause, fault, robot, design, end["seconds"], real, _controller(robot, design))
    raise NoFall(f"none of {TRIES} runs falls by {cause} alone")


def _sizes(nominal: Robot) -> dict[str, float]:
    """One standard deviation of what the post-mortem does not know of the robot."""
    values = nominal.numbers()
    return {n: min(KNOWN * s, LEAST_KNOWN * abs(values[n])) for n, s in deviations(nominal).items() if values[n]}


def _run(
    true: Robot, kit: Kit, robot: str, design: str, fault: Fault, pushes: list[Any], references: list[Any],
    seconds: float, seed: int,
) -> tuple[Log, dict[str, Any], list[int]]:  # fmt: skip
    body = FaultyBody(Twin(true), kit, fault, seed)
    controller = FaultyController(_controller(robot, design), fault, body)
    log = run(body, controller, pushes, reference=references, seconds=seconds, seed=seed)
    return log, log.origin["outcome"], controller.skipped


def _as_real(log: Log, skipped: list[int], rng: np.random.Generator) -> Log:
    """What a real robot would have logged: rows in which its loop ran, sensors, commands, references; the battery in
    half of the logs."""
    battery = rng.random() < 0.5
    wanted = [n for n in log.channels if n.startswith(("sensor/", "command/", "reference/"))]
    names = [n for n in wanted if battery or n != "sensor/battery"]
    keep = np.setdiff1d(np.arange(len(log)), skipped)
    return Log(log.t[keep], {n: log[n][keep] for n in names}, {n: log.units[n] for n in names})
