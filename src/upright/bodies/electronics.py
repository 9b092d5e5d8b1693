"""A kit's electronics round any body: what reaches the motors, and what the sensors say."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace

from upright.bodies.body import REST, Body, BodySpec, Sample, checked, sample
from upright.compiled.counter import FOR_BIAS, FOR_JITTER, FOR_NOISE, FOR_WALK, KINDS, Normals, walk_steps, whole
from upright.compiled.electronics import SENSOR_NUMBERS, formulas, gyro_numbers
from upright.errors import SpecMismatch
from upright.physics.dynamics import CALM, Disturbance
from upright.physics.sensing import FUSED_OF
from upright.robots import Kit, Sensor
from upright.signals.signal import FUSED, KNOWN, TRUTH

BATTERY = "sensor/battery"
ANGLE = FUSED[0].name

_DRIVE = [formulas(volts=volts)["drive"].function() for volts in (False, True)]
_TURN, _SLACKEN, _SETTLE, _SWING, _FUSE, _MEASURE = (
    formulas()[name].function() for name in ("turn", "slacken", "settle", "swing", "fuse", "measure")
)


class Electronics:
    """`body` behind the electronics of `kit`: quantisation, noise, bias, delay, dead zone, drop, backlash, battery.

    Truth channels of the body are passed on, so that a log shows both; a controller for a real robot must
    not read them. Times are rounded to the body's period. Everything random is drawn from the seed of `reset`, as
    `compiled.counter` says: the kernel draws the same.
    """

    def __init__(self, body: Body, kit: Kit) -> None:
        inner = body.spec
        if inner.real:
            raise SpecMismatch(
                f"a {inner.kind} has electronics of its own", expected="a model or the twin", hint="upright fly"
            )
        have = {signal.name: i for i, signal in enumerate(inner.channels)}
        sources = {name: _sources(name, sensor) for name, sensor in kit.sensors.items()}
        missing = sorted({source for several in sources.values() for source in several} - have.keys())
        if missing:
            raise SpecMismatch(
                f"kit '{kit.name}' needs {', '.join(missing)}, which a {inner.kind} does not offer",
                expected="a body with these sensors",
                hint="a kit without them, such as 'ideal'",
            )
        kit.check_drive(inner.robot.drive)
        names = [*(s.name for s in TRUTH if s.name in have), *kit.sensors]
        self.body = body
        self.kit = kit
        self._truth = [have[s.name] for s in TRUTH if s.name in have]
        channels = tuple(KNOWN[name] for name in names)
        limit = kit.most(inner.command_unit)
        self.spec = replace(inner, kind=f"{inner.kind} with {kit.name} electronics", channels=channels, limit=limit)
        self._own = list[_Gyro | _FusedAngle]()
        senses = have.copy()  # places of what sensors sense: behind what the body reads those that have states
        # the angle comes last, which is made of the gyro's reading
        for name in sorted(sources, key=lambda name: name == ANGLE):
            places = [senses[source] for source in sources[name]]
            if len(places) > 1:
                own = _FusedAngle(kit, places, inner) if name == ANGLE else _Gyro(kit.sensors[name], places, inner)
                senses[name] = len(have) + len(self._own)
                self._own.append(own)
            elif places:
                senses[name] = places[0]
        self._sensors = [
            (senses.get(name), _Channel(sensor, name, inner.period, kit)) for name, sensor in kit.sensors.items()
        ]
        self._lasting = [(index, channel) for index, channel in self._sensors if channel.lasts]
        self._line = _CommandLine(kit, inner.period)
        self._alike = kit.motor.left == kit.motor.right == 1.0

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        first = self.body.reset(start, seed)
        self._now = 0
        self._line.reset(seed)
        self._voltage = self.kit.battery.voltage
        self._driven = None
        for one in self._own:
            first = first._replace(numbers=(*first.numbers, one.reset(first.numbers, seed)))
        for index, channel in self._sensors:
            channel.reset(seed, self._voltage if index is None else first.numbers[index])
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
                channel.skip(self._now, self._voltage if index is None else inner.numbers[index])
        return self._sample(self._moved(numbers, disturbance(t)))

    def _moved(self, command: tuple[float, ...], disturbance: Disturbance) -> Sample:
        """The sample of the body itself."""
        arrived = self._line.step(self._now, command)
        self._now += 1
        if arrived is not self._driven:  # one command lasts many steps
            self._driven = arrived
            self._applied, self._voltage = drive(arrived, self.kit, self.spec.command_unit)
        if self._alike:
            moved = self.body.step(self._applied, disturbance)
        else:
            moved = self.body.step(self._turned(self._applied), disturbance)._replace(applied=self._applied)
        for one in self._own:
            moved = moved._replace(numbers=(*moved.numbers, one.step(self._now, moved.numbers)))
        return moved

    def _turned(self, applied: tuple[float, float]) -> tuple[float, ...]:
        """What each motor makes of what is applied to it."""
        return _TURN(*applied, self.kit.motor.left, self.kit.motor.right)

    def close(self) -> None:
        self.body.close()

    def _sample(self, inner: Sample) -> Sample:
        raw = inner.numbers
        truth = [raw[i] for i in self._truth]
        now = self._now
        readings = [channel.read(now, self._voltage if i is None else raw[i]) for i, channel in self._sensors]
        return sample(inner.t, (*truth, *readings), inner.applied, inner.fallen, inner.slipped)


def without_missing(kit: Kit, body: Body) -> Kit:
    """The kit with those sensors alone that can be made of what the `body` offers."""
    have = {signal.name for signal in body.spec.channels}
    offered = {name: sensor for name, sensor in kit.sensors.items() if have.issuperset(_sources(name, sensor))}
    return replace(kit, sensors=offered)


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
        self._delay = round(kit.delay / period)
        self._jitter = round(kit.jitter / period)

    def reset(self, seed: int) -> None:
        self._seed = seed
        self._latest = self._current = (0.0, 0.0)
        self._waiting: deque[tuple[int, tuple[float, ...]]] = deque()

    def step(self, now: int, command: tuple[float, ...]) -> tuple[float, ...]:
        """What arrives in the body's step `now`, in which this is commanded."""
        if command != self._latest:
            jitter = whole(now, FOR_JITTER, self._jitter + 1, self._seed) if self._jitter else 0
            self._waiting.append((now + self._delay + jitter, command))
            self._latest = command
        while self._waiting and self._waiting[0][0] <= now:
            self._current = self._waiting.popleft()[1]
        return self._current


def _sources(name: str, sensor: Sensor) -> tuple[str, ...]:
    """The channels of a body that a sensor is made of."""
    if name == BATTERY:
        return ()
    if name == ANGLE:
        return "truth/pitch", *(FUSED_OF if sensor.time_constant else ())
    tilted = sensor.misalignment or sensor.resonance
    return (name, "truth/yaw_rate") if tilted else (name,)


class _Gyro:
    """What a gyro senses that swings against the frame, or is tilted; `places` are those of pitch rate and yaw rate."""

    def __init__(self, sensor: Sensor, places: Sequence[int], body: BodySpec) -> None:
        self._rate, self._yaw_rate = places
        self._numbers = gyro_numbers(sensor, body.period)

    def reset(self, numbers: Sequence[float], seed: int) -> float:  # noqa: ARG002 (nothing of it is random)
        sensed, *self._memory = _SETTLE(numbers[self._rate], numbers[self._yaw_rate], *self._numbers)
        return sensed

    def step(self, now: int, numbers: Sequence[float]) -> float:  # noqa: ARG002 (it swings at every step)
        sensed, *self._memory = _SWING(numbers[self._rate], numbers[self._yaw_rate], *self._memory, *self._numbers)
        return sensed


class _FusedAngle:
    """The angle of a filter that begins at the true one; `places` are those of the pitch and of what the gyro and the
    accelerometer sense. It takes their readings with all their faults, those of a sensor that the kit lacks as ideal,
    in channels of its own: what they draw depends on the time alone, so that both copies read the same.
    """

    def __init__(self, kit: Kit, places: Sequence[int], body: BodySpec) -> None:
        sensor = kit.sensors[ANGLE]
        self._pitch, *self._places = places
        self._channels = [_Channel(kit.sensors.get(name, Sensor()), name, body.period, kit) for name in FUSED_OF]
        self._every = max(1, round(sensor.period / body.period))
        self._numbers = (body.robot.gravity, sensor.time_constant, self._every * body.period)

    def reset(self, numbers: Sequence[float], seed: int) -> float:
        self._angle = numbers[self._pitch]
        for channel, place in zip(self._channels, self._places, strict=True):
            channel.reset(seed, numbers[place])
            channel.read(0, numbers[place])
        return self._angle

    def step(self, now: int, numbers: Sequence[float]) -> float:
        if now % self._every:
            for channel, place in zip(self._channels, self._places, strict=True):
                channel.skip(now, numbers[place])
        else:
            motion = [
                channel.read(now, numbers[place]) for channel, place in zip(self._channels, self._places, strict=True)
            ]
            direction = math.cos(self._angle), math.sin(self._angle)
            (self._angle,) = _FUSE(self._angle, *direction, *motion, *self._numbers)
        return self._angle


class _Channel:
    """One sensor: play, delay, bias, noise, quantum, range, sample and hold, in this order. Times are the body's steps,
    one after another."""

    def __init__(self, sensor: Sensor, name: str, period: float, kit: Kit) -> None:
        self._sensor = sensor
        self._kind = KINDS.index(name)
        self._numbers = [getattr(sensor, name) for name in SENSOR_NUMBERS]
        self._play = kit.motor.backlash / 2 if "encoder" in name else 0.0
        self._delay = round(sensor.delay / period)
        self._every = max(1, round(sensor.period / period))
        self._walks = walk_steps(self._every, kit.period / period)
        self._root = math.sqrt(period * self._walks)
        self._delayed = bool(self._play or self._delay)
        self.lasts = self._delayed or self._every > 1

    def reset(self, seed: int, first: float) -> None:
        sensor = self._sensor
        self._line = deque([first] * (self._delay + 1), maxlen=self._delay + 1)
        self._touch = first
        self._noise = Normals(FOR_NOISE, self._kind, seed) if sensor.noise else None
        self._walk = Normals(FOR_WALK, self._kind, seed) if sensor.bias_walk else None
        self._walked = -1
        self._bias = sensor.bias * Normals(FOR_BIAS, self._kind, seed).at(0) if sensor.bias else 0.0

    def skip(self, now: int, value: float) -> None:
        """What `read` leaves behind for the next reading."""
        if self._every > 1:
            self.read(now, value)
        elif self._delayed:
            self._arrived(value)

    def _arrived(self, value: float) -> float:
        """The value after play and delay."""
        if self._play:
            (value,) = _SLACKEN(self._touch, value, self._play)
            self._touch = value
        if self._delay:
            self._line.append(value)
            value = self._line[0]
        return value

    def read(self, now: int, value: float) -> float:
        if self._delayed:
            value = self._arrived(value)
        if now % self._every:
            return self._held
        step = self._stepped(now) if self._walk else 0.0
        normal = self._noise.at(now) if self._noise else 0.0
        self._held, self._bias = _MEASURE(value, self._bias, normal, step, *self._numbers)
        return self._held

    def _stepped(self, now: int) -> float:
        """The walk, over its size in a second, since the last reading."""
        assert self._walk
        before, self._walked = self._walked, now // self._walks
        return self._root * sum(self._walk.at(k * self._walks) for k in range(before + 1, self._walked + 1))
