"""A kit's electronics round any body: what reaches the motors, and what the sensors say."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from upright.bodies.body import REST, Body, Sample, checked, sample
from upright.compiled.electronics import SENSOR_NUMBERS, formulas
from upright.errors import SpecMismatch
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Kit, Sensor
from upright.signals.signal import KNOWN, TRUTH

BATTERY = "sensor/battery"

_DRIVE = [formulas(volts=volts)["drive"].function() for volts in (False, True)]
_TURN, _SLACKEN, _MEASURE = (formulas()[name].function() for name in ("turn", "slacken", "measure"))


class Electronics:
    """`body` behind the electronics of `kit`: quantisation, noise, bias, delay, dead zone, drop, backlash, battery.

    Truth channels of the body are passed on, so that a log shows both; a controller for a real robot must
    not read them. Times are rounded to the body's period. Everything random is drawn from the seed of `reset`.
    """

    def __init__(self, body: Body, kit: Kit) -> None:
        inner = body.spec
        if inner.real:
            raise SpecMismatch(
                f"a {inner.kind} has electronics of its own", expected="a model or the twin", hint="upright fly"
            )
        have = {signal.name: i for i, signal in enumerate(inner.channels)}
        missing = sorted(set(kit.sensors) - have.keys() - {BATTERY})
        if missing:
            raise SpecMismatch(
                f"kit '{kit.name}' needs {', '.join(missing)}, which a {inner.kind} does not offer",
                expected="a body with these sensors",
                hint="a kit without them, such as 'ideal'",
            )
        kit.check_drive(inner.robot.drive)
        names = [*(s.name for s in TRUTH if s.name in have), *kit.sensors]
        self.body, self.kit = body, kit
        self._truth = [have[s.name] for s in TRUTH if s.name in have]
        channels = tuple(KNOWN[name] for name in names)
        limit = kit.most(inner.command_unit)
        self.spec = replace(inner, kind=f"{inner.kind} with {kit.name} electronics", channels=channels, limit=limit)
        self._sensors = [
            (have.get(name), _Channel(sensor, name, inner.period, kit)) for name, sensor in kit.sensors.items()
        ]
        self._lasting = [(index, channel) for index, channel in self._sensors if channel.lasts]
        self._line = _CommandLine(kit, inner.period)
        self._alike = kit.motor.left == kit.motor.right == 1.0

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        rng = np.random.Generator(np.random.Philox(seed))
        first = self.body.reset(start, seed)
        self._line.reset(rng)
        self._voltage = self.kit.battery.voltage
        self._driven = None
        for index, channel in self._sensors:
            channel.reset(rng, self._voltage if index is None else first.numbers[index])
        return self._sample(first)

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        return self._sample(self._moved(checked(command, 2, "command"), disturbance))

    def advance(
        self, t: float, command: Sequence[float], disturbance: Callable[[float], Disturbance], count: int
    ) -> Sample:
        """See `advanced`."""
        numbers = checked(command, 2, "command")
        for _ in range(count - 1):
            inner = self._moved(numbers, disturbance(t))
            t = inner.t
            for index, channel in self._lasting:
                channel.skip(self._voltage if index is None else inner.numbers[index])
        return self._sample(self._moved(numbers, disturbance(t)))

    def _moved(self, command: tuple[float, ...], disturbance: Disturbance) -> Sample:
        """The sample of the body itself."""
        arrived = self._line.step(command)
        if arrived is not self._driven:  # one command lasts many steps
            self._driven = arrived
            self._applied, self._voltage = drive(arrived, self.kit, self.spec.command_unit)
        if self._alike:
            return self.body.step(self._applied, disturbance)
        return self.body.step(self._turned(self._applied), disturbance)._replace(applied=self._applied)

    def _turned(self, applied: tuple[float, float]) -> tuple[float, ...]:
        """What each motor makes of what is applied to it."""
        return _TURN(*applied, self.kit.motor.left, self.kit.motor.right)

    def close(self) -> None:
        self.body.close()

    def _sample(self, inner: Sample) -> Sample:
        raw = inner.numbers
        truth = [raw[i] for i in self._truth]
        readings = [channel.read(self._voltage if i is None else raw[i]) for i, channel in self._sensors]
        return sample(inner.t, (*truth, *readings), inner.applied, inner.fallen)


def advanced(
    body: Body, t: float, command: Sequence[float], disturbance: Callable[[float], Disturbance], count: int
) -> Sample:
    """The sample of `body` after `count` steps from time `t` [s] under one command, each under `disturbance` at its
    start. Electronics form no readings between."""
    if isinstance(body, Electronics):
        return body.advance(t, command, disturbance, count)
    for _ in range(count - 1):
        t = body.step(command, disturbance(t)).t
    return body.step(command, disturbance(t))


def drive(command: Sequence[float], kit: Kit, unit: str = "V") -> tuple[tuple[float, float], float]:
    """What reaches both motors, and the battery's voltage [V] while it does."""
    left, right = command
    motor, battery = kit.motor, kit.battery
    left, right, voltage, _ = _DRIVE[unit == "V"](
        left, right, motor.limit, motor.dead_zone, motor.quantum, motor.drop, battery.voltage, battery.sag
    )
    return (left, right), voltage


class _CommandLine:
    """Delays a command by the kit's dead time, and each new one by a jitter on top."""

    def __init__(self, kit: Kit, period: float) -> None:
        self._delay, self._jitter = round(kit.delay / period), round(kit.jitter / period)

    def reset(self, rng: np.random.Generator) -> None:
        self._rng = rng
        self._now = 0
        self._latest = self._current = (0.0, 0.0)
        self._waiting: deque[tuple[int, tuple[float, ...]]] = deque()

    def step(self, command: tuple[float, ...]) -> tuple[float, ...]:
        if command != self._latest:
            jitter = int(self._rng.integers(0, self._jitter + 1)) if self._jitter else 0
            self._waiting.append((self._now + self._delay + jitter, command))
            self._latest = command
        while self._waiting and self._waiting[0][0] <= self._now:
            self._current = self._waiting.popleft()[1]
        self._now += 1
        return self._current


class _Channel:
    """One sensor: play, delay, bias, noise, quantum, range, sample and hold, in this order."""

    def __init__(self, sensor: Sensor, name: str, period: float, kit: Kit) -> None:
        self._sensor = sensor
        self._numbers = [getattr(sensor, name) for name in SENSOR_NUMBERS]
        self._play = kit.motor.backlash / 2 if "encoder" in name else 0.0
        self._delay = round(sensor.delay / period)
        self._every = max(1, round(sensor.period / period))
        self._root = math.sqrt(period * self._every)
        self._walks, self._noisy = bool(sensor.bias_walk), bool(sensor.noise)
        self._alone = self._every == 1 and not self._walks  # no reading depends on an earlier one
        self.lasts = bool(not self._alone or self._play or self._delay or self._noisy)

    def reset(self, rng: np.random.Generator, first: float) -> None:
        self._random = rng.standard_normal
        self._wait = 0
        self._line = deque([first] * (self._delay + 1), maxlen=self._delay + 1)
        self._touch = first
        self._bias = self._sensor.bias * float(self._random()) if self._sensor.bias else 0.0

    def skip(self, value: float) -> None:
        """What `read` leaves behind for the next reading."""
        if not self._alone:
            self.read(value)
            return
        if self._play or self._delay:
            self._arrived(value)
        if self._noisy:
            self._random()

    def _arrived(self, value: float) -> float:
        """The value after play and delay."""
        if self._play:
            (value,) = _SLACKEN(self._touch, value, self._play)
            self._touch = value
        if self._delay:
            self._line.append(value)
            value = self._line[0]
        return value

    def read(self, value: float) -> float:
        if self._play or self._delay:
            value = self._arrived(value)
        if self._wait:
            self._wait -= 1
            return self._held
        self._wait = self._every - 1
        step = self._root * self._random() if self._walks else 0.0
        normal = self._random() if self._noisy else 0.0
        self._held, self._bias = _MEASURE(value, self._bias, normal, step, *self._numbers)
        return self._held
