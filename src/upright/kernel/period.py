"""The loop of `run.entry` one period at a time, under commands from outside: a block's memory lasts between calls."""

from __future__ import annotations

from typing import Any

from upright.compiled.generated import LANES
from upright.compiled.jit import RobotBlock, item, row_of, store
from upright.kernel.rows import ALL_ROWS, NEVER, STRIDE
from upright.kernel.run import Ahead, move, read, send, sense_all, sense_first

K, SENSED = range(2)
"""Places in a clock: the period that comes next, and the step at which a sensor is to sample next."""


def begin(w: Any, count: int, clock: Any, plan: Any, times: Any, sensors: Any, index: Any) -> None:
    """The first readings of one block of robots that have been at rest."""
    block = RobotBlock(w, count, index, 0)
    sense_first(block, plan, sensors)
    sensed = sense_all(block, plan, times, sensors, 0)
    if item(clock, K) == 0:
        store(clock, SENSED, sensed)
    read(block, plan, times, sensors, 0)


def advance(w: Any, robots: int, clock: Any, plan: Any, times: Any, sensors: Any, index: Any) -> None:
    """The clock's period of every block: the commands in its rows act, and the readings are those at its end."""
    k = item(clock, K)
    stride = item(plan, STRIDE)
    end = (k + 1) * stride
    sensed = item(clock, SENSED)
    for first in range(0, robots, LANES):
        count = min(LANES, robots - first)
        block = RobotBlock(row_of(w, item(plan, ALL_ROWS) * (first // LANES)), count, index, first)
        last = send(block, plan, k)
        ahead = move(block, plan, times, sensors, k * stride, last, Ahead(item(clock, SENSED), NEVER, NEVER))
        sensed = ahead.sensed
        if end >= sensed:
            sensed = sense_all(block, plan, times, sensors, end)
        read(block, plan, times, sensors, k + 1)
    store(clock, K, k + 1)
    store(clock, SENSED, sensed)
