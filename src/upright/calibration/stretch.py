"""A stretch of a log simulated freely, from the first state that its readings show.

A log begins anywhere: tilted, rolling, or falling. No reading is the pitch, and a filter that has just started does not
know it either; so first states of several pitches are tried, and the best of them are fitted.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array, Whole
from upright.calibration.fitting import Problem
from upright.logs.recording import Recording, first_line, first_wheel_rates
from upright.physics.dynamics import turn_ratio

if TYPE_CHECKING:
    from upright.calibration.predictor import Events, RobotLanes


FAN = np.array([-0.6, -0.3, -0.15, -0.07, -0.03, 0.0, 0.03, 0.07, 0.15, 0.3, 0.6])
"""[rad] first pitches to try, closer where a balancing robot is."""
TRIED, MOST_TRIED = 2, 6
"""How many of the first states are fitted, those that follow the readings best as they are; and how many where the fit
is still `POOR`: near a fall the errors have several minima."""
POOR = 1000.0
"""Squared error of a reading, over its scale: a tenth of the variance. Of 266 stretches of two EV3 runs none that left
less was followed better from a third start; the others are near a fall, or of a robot that is not the log's."""
GROWING = (0.25, 0.5, 0.75, 1.0)
"""Fractions of a stretch to which a first state is fitted in turn. Over a short time the motion is nearly linear in it
and the error has one minimum; over the whole of a fall it has one for each way to fall."""


@dataclass(frozen=True, eq=False)
class Stretch:
    """The events of a recording in `order`, with the command `before` them, under the robot at `z`; errors are counted
    over the `scale` of each row (rows,)."""

    problem: Problem
    recording: Recording
    z: Array
    order: Whole
    before: Whole
    scale: Array
    events: Whole = field(init=False)
    _robot: RobotLanes = field(init=False, repr=False)
    _given: Events = field(init=False, repr=False)
    _read: tuple[Whole, Array] = field(init=False, repr=False)
    _lanes: dict[int, RobotLanes] = field(init=False, repr=False, default_factory=dict)

    def __post_init__(self) -> None:
        kind = self.recording.kind[self.order]
        object.__setattr__(self, "_robot", self.problem.lanes(self.recording, self.z[:, None]))
        object.__setattr__(self, "_given", _events(self.recording, self.order, self.before))
        object.__setattr__(self, "events", self.order[kind >= 0])
        object.__setattr__(self, "_read", (np.flatnonzero(kind >= 0), self.scale[kind[kind >= 0]]))

    def predicted(self, filtered: Array) -> Array:
        """The readings (events,) as simulated from the best first state, near the one of the filter (states,) or any
        other that fits the first readings; NaN beyond a fall."""
        e = self._errors(self.first(filtered)[:, None])[:, 0] * self.scale[self.recording.kind[self.events]]
        return self.recording.value[self.events] - e

    def first(self, filtered: Array) -> Array:
        """The first state (states,) from which the readings are followed best."""
        best = np.full_like(filtered, np.inf)
        least = np.inf
        starts = self._starts(filtered)
        for tried, first in enumerate(self._likeliest(starts)):
            if tried >= TRIED and least < POOR * len(self.events):
                break
            state, cost = self._descended(first, best)
            best, least = (state, cost) if cost < least else (best, least)
        state, cost = self._grown(starts) if least >= POOR * len(self.events) else (best, least)
        return state if cost < least else best

    def _grown(self, starts: Array) -> tuple[Array, float]:
        """The first state, and its cost, that is fitted to the beginning alone and then to more and more: from that of
        the `starts` (states, lanes) which follows the beginning best."""
        until = [round(fraction * len(self.events)) for fraction in GROWING]
        state = starts[:, np.argmin(self._costs(starts, until[0]))]
        cost = np.inf
        for events in until:
            state, cost = self._descended(state, np.full_like(state, np.inf), events)
        return state, cost

    def _errors(self, firsts: Array) -> Array:
        """Errors (events, lanes) over their scale, from the first states (states, lanes)."""
        (rows, scale), robots = self._read, self._robots(firsts.shape[1])
        return _simulated(self._given, robots, firsts, self.problem.longest)[rows] / scale[:, None]

    def _costs(self, firsts: Array, until: int | None = None) -> Array:
        """What the errors of the first `until` readings cost (lanes,), or all."""
        from upright.calibration.descent import costs

        return costs(self._errors(firsts)[:until])

    def _starts(self, filtered: Array) -> Array:
        """First states (states, lanes) to try: the filter's, and those of several pitches with the rates that the first
        readings show."""
        fan = np.repeat(filtered[:, None], 1 + len(FAN), axis=1)
        lines = {name: self._line(row) for row, name in enumerate(self.recording.rows)}
        shown = lines.get("sensor/gyro")
        wheels = first_wheel_rates(lines)
        rate = filtered[1] if shown is None else shown[0] - filtered[6]
        fan[0, 1:], fan[1, 1:] = FAN, rate
        if self.recording.swings:
            fan[-2, 1:] = rate
        fan[2, 1:] += FAN - filtered[0]
        if wheels:
            fan[3, 1:] = rate + sum(wheels) / 2
            fan[5, 1:] = (wheels[1] - wheels[0]) / (2 * turn_ratio(self.problem.robot))
        return fan

    def _line(self, row: int) -> tuple[float, float] | None:
        at = self.events[self.recording.kind[self.events] == row]
        return first_line(self.recording.when[at], self.recording.value[at])

    def _likeliest(self, firsts: Array) -> list[Array]:
        """The best of the first states (states, lanes), best first."""
        return [firsts[:, lane] for lane in np.argsort(self._costs(firsts), kind="stable")[:MOST_TRIED]]

    def _descended(self, first: Array, known: Array, until: int | None = None) -> tuple[Array, float]:
        """The first state of least error near `first`, and its cost; as far as to one that is `known` already. Of the
        first `until` readings, where given."""
        from upright.calibration.descent import descended

        free = np.arange(6)
        if self.recording.swings:
            free = np.append(free, [len(first) - 2, len(first) - 1])
        rows, scale = (of_all[:until] for of_all in self._read)
        given = self._given._replace(order=self._given.order[: rows[-1] + 1])
        start = np.ascontiguousarray(first)
        robot = self._robots(1 + len(free))
        return descended(given, robot, (rows, scale), start, np.ascontiguousarray(known), free, self.problem.longest)

    def _robots(self, count: int) -> RobotLanes:
        """The robot in so many lanes."""
        if count not in self._lanes:
            self._lanes[count] = _alike(self._robot, count)
        return self._lanes[count]


def free(robot: RobotLanes, recording: Recording, order: Whole, before: Whole, firsts: Array, longest: float) -> Array:
    """Errors (events of `order`, lanes) of a free simulation of one `robot` over these events from the first states
    (states, lanes), after the command `before` them, in steps of at most `longest` [s]; NaN for commands and beyond a
    fall."""
    return _simulated(_events(recording, order, before), _alike(robot, firsts.shape[1]), firsts, longest)


def _simulated(events: Events, lanes: RobotLanes, firsts: Array, longest: float) -> Array:
    from upright.calibration.predictor import innovations

    return innovations(events, lanes, firsts, np.zeros((len(events.order), len(firsts))), longest)


def _alike(robot: RobotLanes, count: int) -> RobotLanes:
    """One robot in each of so many lanes."""
    from upright.calibration.predictor import RobotLanes

    return RobotLanes(*(np.repeat(of_one, count, axis=-1) for of_one in robot[:4]), stiff=robot.stiff)


def _events(recording: Recording, order: Whole, before: Whole) -> Events:
    """The events of `order` alone, after the command `before` them."""
    from upright.calibration.predictor import Events

    kind = recording.kind[order]
    value = recording.value[order].copy()
    skipped = int(recording.value[before[0]]) if len(before) else 0
    value[kind < 0] -= skipped
    commands = np.ascontiguousarray(recording.commands[skipped:])
    return Events(np.arange(len(order)), kind, recording.when[order], value, commands)
