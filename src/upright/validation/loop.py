"""The closed loop simulated freely: from a log's first state the robot, and the law that drove it, and no reading."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array, Whole
from upright.calibration.fitting import Problem
from upright.calibration.stretch import Stretch
from upright.control.delay import RAW
from upright.logs.outliers import left_out
from upright.logs.recording import SENSOR, Recording, commanded, one_encoder
from upright.robots import Kit
from upright.signals import Log
from upright.validation.law import ESTIMATES, CommandLaw

PITCH = "estimate/pitch"
SOURCE = {n: "gyro" if n.startswith(PITCH) else "encoder" for n in ESTIMATES}
"""The sensor from which a program computes each estimate. It is as late as its readings are, where no body of ours made
the log: what a program without a model knows of the robot is older than the robot by their dead time."""
LEFT, RIGHT = RAW[:2]
LYING = math.pi / 2
"""[rad] from which a simulated robot has fallen for good. Less would end it too early: a published run comes back from
1.33 rad, and a simulation that leans 0.1 rad further is not lost by that."""
FIRST = 0.5  # [s] of readings to which the first state is fitted


@dataclass(frozen=True, eq=False)
class FreeLoop:
    """Readings of the sensor rows `names`, `measured` and `simulated` (rows, names), NaN after a simulated fall, at the
    log's times `t` (rows,) [s]; the last is the pitch, where the log estimates it. It fell at `fell_at` [s], or None;
    `pushes` are from when to when [s] the log says that it was pushed, which the simulation does not get."""

    names: tuple[str, ...]
    t: Array
    measured: Array
    simulated: Array
    fell_at: float | None = None
    pushes: tuple[tuple[float, float], ...] = ()


class _Plant:
    """The robot of a problem at z, moved from event to event by the calibration's own equations."""

    def __init__(self, problem: Problem, recording: Recording, z: Array, first: Array) -> None:
        from upright.calibration.motion import block_of

        lanes = problem.lanes(recording, z[:, None])
        self._w = block_of(lanes.robots)
        self._longest = problem.longest
        self._reads = lanes.reads[:, :, 0]
        self._offsets = first[6:, None].copy()
        self._now = np.full(1, np.nan)
        self._swing = lanes.swing
        self.command = np.zeros(2)
        self._put(first)

    def _put(self, first: Array) -> None:
        from upright.compiled.generated import PITCH, ROW

        self._rows = [(PITCH + j) * ROW for j in range(6)]
        for row, value in zip(self._rows, first, strict=False):
            self._w[row] = value

    @property
    def state(self) -> Array:
        """The six states."""
        return self._w[self._rows]

    def move(self, to: float) -> None:
        """The robot at the time `to` [s]."""
        from upright.calibration.ringing import moved

        if math.isnan(self._now[0]):
            self._now[0] = to
        moved(self._w, self.command, self._now, np.full(1, to), self._longest, self._swing, self._offsets)

    def reading(self, row: int) -> float:
        """What the sensor of this row reads."""
        return float(self._reads[row] @ np.concatenate([self.state, self._offsets[:, 0]]))


def closed_loop(problem: Problem, recording: Recording, z: Array, log: Log, kit: Kit, law: CommandLaw) -> FreeLoop:
    """The loop of `law` and the robot at `z` (parameters,), simulated from the log's first state to its end."""
    order, when, start, first = first_state(problem, recording, z)
    plant = _Plant(problem, recording, z, first)
    line = _Line(log, kit)
    names = recording.rows
    estimated = [n for n in ESTIMATES if n in log and "body" not in log.origin]
    shown = (*names, *((PITCH,) if PITCH in log else ()))
    computed = np.column_stack([np.zeros((len(log), 0)), *(log[n] for n in estimated)])
    measured = np.column_stack([log[name] for name in shown])
    simulated = np.full_like(measured, np.nan)
    known = measured[:, : len(names)].copy()
    sample = np.searchsorted(log.t, recording.when - 1e-9)
    odd = np.column_stack([left_out(log, name) for name in names])  # the law gets the simulated ones
    last = order[:start][recording.kind[order[:start]] < 0]
    one = LEFT in names and RIGHT in log and one_encoder(log)  # then the law must not read the log's other one

    def readings(row: int) -> dict[str, float]:
        given = dict(zip((*names, *estimated), [*known[row].tolist(), *computed[row].tolist()], strict=True))
        return {**given, RIGHT: given[LEFT]} if one else given

    fell = None
    law.reset()
    for event in last:  # what the law remembers of the readings before
        row = int(recording.value[event])
        law.step(row, readings(row), np.zeros(6))
        law.applied(recording.commands[row].tolist())
    plant.command[:] = recording.commands[int(recording.value[last[-1]]) if len(last) else 0]
    line.begin(plant.command)
    for event in order[start:]:
        plant.move(float(when[event]))
        if not abs(plant.state[0]) < LYING:
            fell = float(when[event])
            break
        kind = int(recording.kind[event])
        row = int(sample[event])
        if kind >= 0:
            simulated[row, kind] = known[row, kind] = plant.reading(kind)
            of_sensor = [i for i, n in enumerate(estimated) if SOURCE[n] == SENSOR[names[kind]]]
            computed[row, of_sensor] = [plant.state[ESTIMATES.index(estimated[i])] for i in of_sensor]
        else:
            for sensor in np.flatnonzero(odd[row]).tolist():
                known[row, sensor] = plant.reading(sensor)
            asked = law.step(row, readings(row), plant.state)
            plant.command[:] = line.step(asked)
            law.applied(plant.command.tolist())
            simulated[row, len(names) :] = (
                computed[row, estimated.index(PITCH)] if PITCH in estimated else plant.state[0]
            )
    return FreeLoop(shown, log.t, measured, simulated, fell, pushes_of(log))


def pushes_of(log: Log) -> tuple[tuple[float, float], ...]:
    """From when to when [s] the scenario of a log of ours pushed the robot."""
    scenario = log.origin.get("scenario")
    given = scenario.get("push") if isinstance(scenario, Mapping) else None
    known = [p for p in given or () if isinstance(p, Mapping) and isinstance(p.get("start"), int | float)]
    spans = [(float(p["start"]), float(p.get("until", p["start"] + p.get("duration", 0.0)))) for p in known]
    return tuple((start, stop) for start, stop in spans if log.t[0] <= start <= log.t[-1])


def first_state(problem: Problem, recording: Recording, z: Array) -> tuple[Whole, Array, int, Array]:
    """Events in order, a command after the readings of its instant, with their times [s]; the place of the first
    reading; and the state there, fitted to what follows."""
    when = recording.when - np.maximum(problem.own_delays(recording, z), 0.0)
    order = np.lexsort((recording.kind < 0, when)).astype(np.int64)
    start = int((recording.kind[order] >= 0).argmax())
    part = order[start:][when[order[start:]] < when[order[start]] + FIRST]
    states = problem.filtered(recording, z, keep=True).states
    before = order[:start][recording.kind[order[:start]] < 0][-1:]
    stretch = Stretch(problem, recording, z, part, before, _spans(recording))
    return order, when, start, stretch.first(states[part[0]])


def _spans(recording: Recording) -> Array:
    """A hundredth of how much each row varies (rows,)."""
    return np.array([max(0.01 * float(recording.value[recording.kind == i].std()), 1e-9)
                     for i in range(len(recording.rows))])  # fmt: skip


class _Line:
    """From a law's command to the one that the log calls its own: what was really applied is a dead time of whole
    periods behind, and nothing is larger than the kit and the log allow."""

    def __init__(self, log: Log, kit: Kit) -> None:
        prefix = commanded(log)
        both = prefix == "applied" and "command/left" in log
        self._periods = math.floor(kit.delay / log.period + 1e-9) if both else 0
        largest = max(float(np.abs(log[f"{prefix}/{side}"]).max()) for side in ("left", "right"))
        self._limit = largest if math.isinf(kit.motor.limit) else max(largest, kit.motor.limit)

    def begin(self, command: Array) -> None:
        """Start with this command on its way."""
        self._waiting = deque([(float(command[0]), float(command[1]))] * self._periods)

    def step(self, command: Sequence[float]) -> tuple[float, float]:
        """What is applied while this command is given."""
        left, right = (min(max(u, -self._limit), self._limit) for u in command)
        self._waiting.append((left, right))
        return self._waiting.popleft()
