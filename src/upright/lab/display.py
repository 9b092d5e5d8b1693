"""The last minute as a page draws it: one row for each period, from which snapshots and the history are taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array
from upright.lab.lane import Lane
from upright.lab.messages import History, Snapshot
from upright.lab.ring import Ring
from upright.physics.dynamics import Disturbance

KEPT = 60.0  # [s] that can be scrubbed back through
SHOWN = 0.04  # [s] between two rows of the history that a page gets when it comes
_STATE = (4, 3, 3, 3, 4, 3)  # decimals of the six states that a page can draw
_LANE = (*_STATE, 2, 2, 0)
_DISTURBANCE = (3, 4, 4, 3)


class Display:
    """Rows of t, then of each lane six states, two applied commands and whether it fell, then the first lane's
    estimate (6), the disturbance (3) with the pull at a wheel, the reference wheel and yaw angle, and which motors are
    at their limit."""

    def __init__(self) -> None:
        self._lanes: Sequence[Lane] = ()
        self._rows = Ring(1, 1)
        self._period = 1.0

    def show(self, lanes: Sequence[Lane], period: float) -> None:
        """Show these lanes, of `period` [s], from now on; the rows so far stay where the same bodies go on."""
        if [lane.name for lane in lanes] != [lane.name for lane in self._lanes]:
            self._rows = Ring(round(KEPT / period), 1 + 9 * len(lanes) + 13)
        self._lanes, self._period = lanes, period

    def record(self, t: float, disturbance: Disturbance, pull: float, target: Array) -> None:
        """Add the moment `t` [s]."""
        main = self._lanes[0]
        row = [t]
        for lane in self._lanes:
            row += [*lane.state(), *lane.applied, float(lane.fallen)]
        estimate = main.estimate() or [0.0] * 6
        reference = (target[2] + main.offset[2], target[4] + main.offset[4])
        self._rows.append([*row, *estimate, *disturbance, pull, *reference, main.saturated()])

    def snapshot(self, n: int, back: float, paused: bool) -> Snapshot:
        """The moment `back` [s] ago."""
        return self.view().snapshot(self._rows.back(round(back / self._period)).tolist(), n, back, paused)

    def rows(self, every: float) -> Array:
        """All that is kept, oldest first, a row each `every` seconds; `view` makes pictures of them."""
        return self._rows.rows(max(1, round(every / self._period)))

    def view(self) -> View:
        """How the rows are read."""
        return View(len(self._lanes), self._lanes[0].controller.spec.estimates)

    def history(self, since: float = 0.0) -> History:
        """What was recorded from `since` [s] on, thinned out: for a page that came later, or was too slow."""
        rows = self.rows(SHOWN)
        lanes = len(self._lanes)
        rows = rows[rows[:, 0] >= since]
        end = 1 + 9 * lanes
        states = [(1 + 9 * i + k, digits) for i in range(lanes) for k, digits in enumerate(_STATE)]
        rest = [(end, _STATE[0]), (7, 2), (8, 2), (end + 12, 0)]
        columns = np.column_stack([np.round(rows[:, c], digits) for c, digits in (*states, *rest)])
        return History(tuple(np.round(rows[:, 0], 3).tolist()), tuple(map(tuple, columns.tolist())))


@dataclass(frozen=True)
class View:
    """How a row is read: of so many `lanes`, with the first one's estimate or without."""

    lanes: int
    estimates: bool

    def snapshot(self, row: list[float], n: int, back: float, paused: bool) -> Snapshot:
        """The row's moment as a page draws it."""
        end = 1 + 9 * self.lanes
        return Snapshot(
            n=n,
            t=round(row[0], 3),
            x=tuple(_round(row[1 + 9 * i : 10 + 9 * i], _LANE) for i in range(self.lanes)),
            e=_round(row[end : end + 6], _STATE) if self.estimates else (),
            f=_round(row[end + 6 : end + 10], _DISTURBANCE),
            r=_round(row[end + 10 : end + 12], (3, 3)),
            s=int(row[end + 12]),
            paused=paused,
            back=round(back, 2),
        )


def _round(values: Sequence[float], digits: Sequence[int]) -> tuple[float, ...]:
    return tuple(round(v, d) for v, d in zip(values, digits, strict=True))
