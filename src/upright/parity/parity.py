"""Whether a program does what was designed: it is run itself on the twin, with the design beside it step by step."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies import Electronics, make_body
from upright.bodies.electronics import drive
from upright.compiled.fixed import fractions, memory
from upright.compiled.program import Kind, Program
from upright.control.controller import Controller, ControllerSpec
from upright.experiment import Hold, run
from upright.experiment.references import Reference
from upright.firmware.setup import CALIBRATION_TIME, SIDES, STATUS
from upright.firmware.targets import BATTERY, COMPASS, GYRO, OFFSET
from upright.firmware.tools import ExecutionFailed
from upright.parity.executor import Executor, Values
from upright.robots import Battery, Kit, Robot
from upright.signals import STATE_NAMES, Log

Array = NDArray[np.float64]

PUSHES = {"front": (0.1, 0.0), "back": (-0.12, 10.0)}
"""Pitch [rad] at which each push holds the robot (Herrera et al. 2015, section 3.2), and when it begins [s]."""

TOLERANCE = {"double": 1e-6, "float": 1e-4}
"""The largest difference of a command [V or N m] from the design's, by arithmetic; fixed point states its own."""

HELD, SECONDS = 5.0, 20.0  # [s] how long each push lasts, and the run
LOST = 0.5  # [rad] from which a robot whose program has stopped will not come back
ROUNDED = {"double": 1e-14, "float": 1e-6}
"""What rounding does to a command [V or N m] in one period, by arithmetic."""
SLACK = {"double": 1e-9, "float": 1e-4, "fixed": 1e-3}
"""What rounding may do to a command [V or N m] before it becomes a duty, by arithmetic."""


@dataclass(frozen=True)
class Stood:
    """One push in closed loop: whether the executed program stood, its largest |pitch| [rad], and how it ended."""

    push: str
    stood: bool
    peak: float
    said: str


@dataclass(frozen=True)
class Parity:
    """The program run on `where` in `numbers` for `periods`: in the first `steps` of them, which can be compared, its
    commands came within `worst` of the design's in `unit`, where `tolerance` is allowed; `duties` counts the periods
    whose duty was not the one that follows from the command."""

    target: str
    where: str
    numbers: str
    robot: str
    hash: str
    unit: str
    steps: int
    periods: int
    worst: float
    tolerance: float
    duties: int
    pushes: tuple[Stood, ...]

    @property
    def passed(self) -> bool:
        """Equal within the tolerance, every duty right, and upright after both pushes."""
        return self.worst <= self.tolerance and not self.duties and all(p.stood for p in self.pushes)

    def to_json(self) -> dict[str, Any]:
        return {**asdict(self), "passed": self.passed}

    def __str__(self) -> str:
        lines = [
            f"{'EQUAL' if self.passed else 'NOT EQUAL'}: {self.target} program for {self.robot} on {self.where}",
            f"  {self.steps} steps in {self.numbers}: at most {self.worst:.3g} {self.unit} from the design, "
            f"{self.tolerance:.3g} allowed",
        ]
        if self.steps < self.periods:
            lines.append(
                f"  in the {self.periods - self.steps} steps after them rounding grows, as its memory does by itself"
            )
        lines += [f"  {self.duties} duties do not follow from their commands"] if self.duties else []
        return "\n".join(lines + [f"  {p.push} push: {p.said}, largest pitch {p.peak:.3f} rad" for p in self.pushes])


class Readings:
    """Raw readings of a program from channels in SI units, as its target's sensors would give them, in words of the
    arithmetic that it `numbers` in."""

    def __init__(self, program: Program, kit: Kit, numbers: str = "double") -> None:
        self._program, self._kit = program, kit
        bits = fractions(program) if numbers == "fixed" else {}
        self._steps = {name: 2.0 ** -bits[name] for name in program.channels if name in bits}
        self.channels = dict(program.channels)
        gyro = next(name for name, channel in self.channels.items() if channel == GYRO)
        offset = OFFSET / program.scales[gyro]
        self.gyro, self.offset = gyro, round(offset) if program.variables[gyro].whole else offset

    def raw(self, channels: Mapping[str, float], offset: float = 0.0) -> dict[str, float]:
        """`channels` by name [SI] as raw readings by input; `offset` [raw] is added to the gyro's."""
        idle = {v.name: 0.0 for v in self._program.of(Kind.INPUT)}  # the reference, where it is an input
        return idle | {name: self._one(name, channel, channels, offset) for name, channel in self.channels.items()}

    def still(self, count: int, seed: int = 0) -> Iterator[dict[str, float]]:
        """Readings of a robot held still, with the gyro's own noise round its offset."""
        rng = np.random.Generator(np.random.Philox(seed))
        sensor = self._kit.sensors[GYRO]
        resting = {channel: 0.0 for channel in self.channels.values() if channel != BATTERY}
        for _ in range(count):
            yield self.raw(resting | {GYRO: sensor.noise * float(rng.standard_normal())}, self.offset)

    def si(self, channel: str, channels: Mapping[str, float], raw: Values, offset: float) -> float:
        """What the program takes a channel for [SI], given the gyro's `offset` [raw] that it found."""
        name = next(n for n, c in self.channels.items() if c == channel)
        scale = self._program.scales[name]
        if channel == COMPASS:  # the program follows it over its wrap
            return round(channels[channel] / scale) * scale
        value = (raw[name] - (offset if channel == GYRO else 0.0)) * scale
        bound = self._program.variables[channel.removeprefix("sensor/")]
        return min(max(value, bound.low), bound.high)

    def _one(self, name: str, channel: str, channels: Mapping[str, float], offset: float) -> float:
        variable, scale = self._program.variables[name], self._program.scales[name]
        resting = self._kit.battery.voltage if channel == BATTERY else 0.0
        value = channels.get(channel, resting) / scale + (offset if channel == GYRO else 0.0)
        if channel == COMPASS:
            return float(-round(value) % 360)
        step = 1.0 if variable.whole else self._steps.get(name)
        return round(value / step) * step if step else value


def calibrated(executor: Executor, readings: Readings, period: float) -> float:
    """The gyro's offset [raw] that the program must have found, once its start is over."""
    count = round(CALIBRATION_TIME / period)
    executor.start()
    seen: list[float] = []
    for raw in readings.still(count):
        if executor.step(raw):
            raise ExecutionFailed("the program balances before its gyro is calibrated")
        seen.append(raw[readings.gyro])
    return float(np.mean(seen))


class Executed:
    """An executed program as a controller of the twin, with the design beside it, step by step.

    Its duty becomes volts at the battery's voltage under that load. The design gets what the program's readings say in
    SI units and is told what the program applied, so that every step is compared by itself: a controller of an unstable
    robot may be unstable without it, and then two runs part for good at the first duty that rounds the other way.
    """

    def __init__(self, executor: Executor, program: Program, kit: Kit, design: Controller) -> None:
        self._executor, self._program, self._kit, self._design = executor, program, kit, design
        self._readings = Readings(program, kit, executor.numbers)
        self._slack, self._longest = SLACK[executor.numbers], comparable(program, executor.numbers)
        reads = tuple(c for c in program.channels.values() if c in kit.sensors)
        self.spec = ControllerSpec(f"{program.kind} on {executor.where}", reads, program.period, program.command_unit)

    def reset(self) -> None:
        self._offset = calibrated(self._executor, self._readings, self._program.period)
        self._design.reset()
        self._sent = deque([(0.0, 0.0)] * self._program.lag)
        self.status, self.steps, self.worst, self.wrong = 0, 0, 0.0, 0

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        if self.status:
            return 0.0, 0.0
        channels = dict(zip(self.spec.reads, measurement.tolist(), strict=True))
        raw = self._readings.raw(channels, self._readings.offset)
        states = {f"reference_{n}": float(v) for n, v in zip(STATE_NAMES, reference, strict=True)}
        out = self._executor.step(raw | {n: v for n, v in states.items() if n in self._program.variables})
        if not out:
            raise ExecutionFailed("the program still calibrates after a second of stillness")
        self._compare(channels, raw, out, reference)
        self.status = int(out["status"])
        return self._volts(out)

    def estimate(self) -> Sequence[float]:
        return ()

    def applied(self, command: Sequence[float]) -> None:
        """The program reckons for itself what it applied."""

    def to_json(self) -> dict[str, Any]:
        return {"kind": self.spec.kind, "program": self._program.hash}

    def _compare(self, channels: Mapping[str, float], raw: Values, out: Values, reference: Array) -> None:
        reads = self._design.spec.reads
        y = np.array([self._readings.si(c, channels, raw, self._offset) for c in reads])
        typed = self._program.variables["command_left"].high
        expected = np.clip(self._design.step(y, reference), -typed, typed)
        self._sent.append((out["applied_left"], out["applied_right"]))
        self._design.applied(self._sent.popleft())
        self.wrong += not follows(self._program, self._kit, raw, out, self._slack)
        if self.steps < self._longest:
            self.worst = max(self.worst, float(np.abs(expected - (out["command_left"], out["command_right"])).max()))
            self.steps += 1

    def _volts(self, out: Values) -> tuple[float, float]:
        if not self._program.full:
            return out["applied_left"], out["applied_right"]
        return self._kit.battery.volts([out[f"duty_{side}"] / self._program.full for side in SIDES])


def comparable(program: Program, numbers: str) -> float:
    """In how many periods the rounding of one grows to a tenth of the tolerance: never where the memory fades."""
    if program.proven:
        return math.inf
    growth = float(np.abs(np.linalg.eigvals(memory(program)[2])).max())
    room = 0.1 * TOLERANCE[numbers] / ROUNDED[numbers]
    return max(1, math.floor(math.log(room) / math.log(growth))) if growth > 1 else math.inf


def follows(program: Program, kit: Kit, raw: Values, out: Values, slack: float) -> bool:
    """Whether what was applied is what the kit's own electronics make of the command, nudged by `slack` at most."""
    source, step = kit, slack
    if program.full:
        battery = program.variables["battery"]
        volts = min(max(raw["raw_battery"] * program.scales["raw_battery"], battery.low), battery.high)
        step = volts / program.full
        quantum = step * (1 - 1e-9)  # so that full voltage is all of the steps, and not one less by rounding
        source = replace(kit, motor=replace(kit.motor, quantum=quantum), battery=Battery(voltage=volts))
    command, applied = (np.array([out[f"{what}_{s}"] for s in SIDES]) for what in ("command", "applied"))
    nudged = [drive((command + n).tolist(), source, program.command_unit)[0] for n in (0.0, -slack, slack)]
    return all(min(abs(n[i] - applied[i]) for n in nudged) <= step * 0.01 + slack for i in range(2))


def parity(
    executor: Executor,
    controller: Controller,
    program: Program,
    robot: Robot,
    kit: Kit,
    *,
    quantum: float | None = None,
    body: str = "twin",
    reference: Reference | Sequence[Reference] = (),
    progress: Callable[[float], None] | None = None,
) -> Parity:
    """The executed program drives the twin in the kit's electronics for `SECONDS` through both `PUSHES`.

    `quantum` is the tolerance of a fixed-point program. Raises `ExecutionFailed` for a program that does not answer.
    """
    steps = replace(kit, motor=replace(kit.motor, quantum=0.0)) if program.full else kit  # its duty is whole already
    plant, executed = Electronics(make_body(body, robot), steps), Executed(executor, program, kit, controller)
    pushes = [Hold(pitch=p, start=start, until=start + HELD) for p, start in PUSHES.values()]
    log = run(plant, executed, pushes, reference=reference, seconds=SECONDS, seed=1, progress=progress)
    plant.close()
    stood = tuple(_stood(push, log, STATUS[executed.status] if executed.status else "") for push in PUSHES)
    tolerance = TOLERANCE[executor.numbers] if quantum is None else quantum
    return Parity(
        program.target, executor.where, executor.numbers, robot.name, program.hash, program.command_unit,
        executed.steps, len(log), executed.worst, tolerance, executed.wrong, stood,
    )  # fmt: skip


def _stood(push: str, log: Log, stopped: str) -> Stood:
    """How the robot fared from a push's start until the next one's."""
    start, half = PUSHES[push][1], SECONDS / len(PUSHES)
    if log.t[-1] <= start:
        return Stood(push, False, 0.0, "fell before it")
    window = log.between(start, min(start + half, float(log.t[-1])))
    peak, ended = float(np.abs(window["truth/pitch"]).max()), float(log.t[-1])
    if ended < start + half - 2 * float(log.t[1]) or (stopped and peak > LOST):
        return Stood(push, False, peak, f"fell ({stopped or 'lost its balance'})")
    return Stood(push, True, peak, "stood")
