"""Many robots as arrays: the input of a simulation, and its results."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.arrays import Array, Mask, Whole
from upright.control import Controller
from upright.control.controller import ControllerSpec
from upright.control.excited import Excited
from upright.control.law import as_law
from upright.control.linear_controller import Law, LinearController
from upright.errors import InvalidController, InvalidModel, InvalidRobot, InvalidScenario, check_within
from upright.physics.dynamics import MODELS
from upright.robots import Kit, Robot
from upright.robots.robot import PARAMETERS

Selection = slice | Whole
"""Numbers of some robots of a batch."""

NAMES = tuple(PARAMETERS)
_TAILS = {
    "parameters": (len(NAMES),),
    "start": (6,),
    "pushes": (-1, 4),
    "slope": (2,),
    "reference": (-1, 4),
    "excitation": (-1, 2),
}
"""Shapes of the arrays of a batch after the first axis; −1: any length."""


@dataclass(frozen=True, eq=False, kw_only=True)
class FleetBatch:
    """n robots under any controller. Every array has n rows, or one that all robots share.

    `parameters` (·, 25) in the order and units of `robots.robot.PARAMETERS` (see `parameters_of`); `law` is what the
    `controller` of all computes. One that no law describes is `called` in Python, for one robot after another and a
    hundred times as slowly, as is one that is given as `called` in the law's place.
    `start` (·, 6) is the state at t = 0;
    `pushes` (·, p, 4) force [N], height above the axle [m] (NaN: at the centre of mass), start [s], duration [s];
    `slope` (·, 2) angle [rad] and start [s];
    `reference` (·, q, 4) speed [m/s], turn [rad/s], start and end [s], which add up;
    `excitation` (·, e, 2) is added to the controller's commands [unit], each row for `excitation_hold` periods, as
    `Excited` adds it; that of an `Excited` controller, where none is given here. `kit` is the electronics,
    None the bare body; `kit_changes` replaces its numbers for each robot, by dotted name: "delay", "motor.limit",
    "sensors.gyro.noise" (channel without "sensor/"), (·,). `model` is "complete" or "published".
    `index` (n,) numbers the robots for their random numbers, so that a part of a fleet behaves as in the whole fleet.
    `period` [s] is the body's step, cut into `substeps` (None: for each robot as many as its fastest pole needs).

    Raises `InvalidModel` or `InvalidScenario`.
    """

    parameters: Array
    controller: Controller | Law
    start: Array = field(default_factory=lambda: np.zeros((1, 6)))
    pushes: Array = field(default_factory=lambda: np.zeros((1, 0, 4)))
    slope: Array = field(default_factory=lambda: np.zeros((1, 2)))
    reference: Array = field(default_factory=lambda: np.zeros((1, 0, 4)))
    excitation: Array = field(default_factory=lambda: np.zeros((1, 0, 2)))
    excitation_hold: int = 1
    kit: Kit | None = None
    kit_changes: Mapping[str, ArrayLike] = field(default_factory=dict)
    model: str = "complete"
    seed: int = 0
    index: NDArray[np.uint64] | None = None
    period: float = 0.001
    substeps: int | None = None
    called: Controller | None = None
    law: Law = field(init=False)
    n: int = field(init=False)

    def __post_init__(self) -> None:
        if isinstance(self.controller, Excited) and not self.excitation.size:
            object.__setattr__(self, "excitation", self.controller.excitation)
            object.__setattr__(self, "controller", self.controller.controller)
        check_within("periods for a row of an excitation", self.excitation_hold, 1, math.inf)
        for name, tail in _TAILS.items():
            object.__setattr__(self, name, _table(name, getattr(self, name), tail))
        given = self.controller
        law, called = (given, None) if isinstance(given, Law) else law_of(given)
        object.__setattr__(self, "law", law)
        object.__setattr__(self, "called", self.called or called)
        changes = {name: _table(name, np.reshape(values, (-1,)), ()) for name, values in self.kit_changes.items()}
        object.__setattr__(self, "kit_changes", changes)
        if self.model not in MODELS:
            raise InvalidModel(f"no model is called '{self.model}'", expected=" or ".join(MODELS))
        sizes = {name: len(getattr(self, name)) for name in _TAILS}
        sizes |= {name: len(values) for name, values in changes.items()}
        if self.index is not None:
            sizes["index"] = len(self.index)
        object.__setattr__(self, "n", _common(sizes))

    @property
    def form(self) -> LinearController:
        """The controller's size, channels, period and unit."""
        return self.law.linear

    def part(self, rows: Selection, **changes: Array) -> FleetBatch:
        """The robots number `rows` (n,) under the numbers they have in the whole, with whole arrays (`start`, `pushes`)
        replaced by `changes`."""

        def some(values: Any) -> Any:
            return values[rows] if len(values) > 1 else values

        arrays = {name: some(getattr(self, name)) for name in _TAILS} | changes
        kit_changes = {name: some(np.asarray(values)) for name, values in self.kit_changes.items()}
        index = np.arange(self.n, dtype=np.uint64) if self.index is None else self.index
        return replace(self, **arrays, controller=self.law, kit_changes=kit_changes, index=index[rows])


def law_of(controller: Controller) -> tuple[Law, Controller | None]:
    """Its law; where none describes it an idle one, and the controller itself, which is called in its place."""
    try:
        return as_law(controller), None
    except InvalidController:
        return Law(idle(controller.spec)), controller


def idle(spec: ControllerSpec) -> LinearController:
    """A linear controller that commands nothing, with the readings, period and unit of `spec`."""
    none = np.zeros((0, 0))
    m = len(spec.reads)
    return LinearController(
        none, none, none, none, none, np.zeros((2, m)), np.zeros((2, 6)),
        reads=spec.reads, period=spec.period, command_unit=spec.command_unit,
    )  # fmt: skip


def parameters_of(robots: Robot | Iterable[Robot], changes: Mapping[str, ArrayLike] | None = None) -> Array:
    """Parameters (n, 25) of one robot or several, with some columns replaced: {"com_height": (n,), …}.

    Only the robots are checked to be possible, not the changes. Raises `InvalidRobot` for an unknown name.
    """
    rows = [robots] if isinstance(robots, Robot) else list(robots)
    table = np.array([list(robot.numbers().values()) for robot in rows])
    for name, values in (changes or {}).items():
        if name not in NAMES:
            raise InvalidRobot(f"no parameter is called '{name}'", expected="one of " + ", ".join(NAMES))
        column = np.atleast_1d(np.asarray(values, dtype=np.float64))
        table = np.repeat(table, len(column), axis=0) if len(table) == 1 else table
        table[:, NAMES.index(name)] = column
    return table


def _table(name: str, given: ArrayLike, tail: tuple[int, ...]) -> Array:
    table = np.array(given, dtype=np.float64, order="C")
    if table.ndim == len(tail):
        table = table[None]
    fits = table.ndim == len(tail) + 1 and all(b in (-1, a) for a, b in zip(table.shape[1:], tail, strict=True))
    if not fits:
        shape = ", ".join("any" if size < 0 else str(size) for size in tail)
        raise InvalidScenario(
            f"{name} has shape {np.shape(given)}", expected=f"(n, {shape}), or n = 1 for all robots alike"
        )
    table.setflags(write=False)
    return table


def _common(sizes: Mapping[str, int]) -> int:
    n = reduce(max, sizes.values())
    wrong = {name: size for name, size in sizes.items() if size not in (1, n)}
    if wrong:
        sizes_given = ", ".join(f"{name} has {size}" for name, size in wrong.items())
        raise InvalidScenario(f"{sizes_given} rows in a batch of {n}", expected=f"{n} rows, or one that all share")
    return n


@dataclass(frozen=True, eq=False, kw_only=True)
class FleetResult:
    """The results of n robots; arrays are read-only.

    `final` (n, 6) is the last state (that at the fall for one that fell), `fell` (n,) whether and `lived` (n,) [s]
    until when it stood. Counted at the start of each period while it stood: `peak` (n, 3) largest |pitch|, |wheel| and
    |yaw| [rad],
    `settled` (n,) [s] the time from which it stayed inside `bands` (NaN: still outside or fallen),
    `rms_pitch` (n,) [rad].
    Nothing here tells of a speed drive whose motors slipped: `run` alone counts that.
    `effort` (n,) is ∫ u_l² + u_r² dt of the applied command, `saturated` (n,) the fraction of periods [1] in which a
    command exceeded the limit. `trace` (n, k, m) holds `channels` at times `t` (k,) [s], NaN after a fall.
    """

    final: NDArray[Any]
    fell: Mask
    lived: NDArray[Any]
    peak: NDArray[Any]
    settled: NDArray[Any]
    rms_pitch: NDArray[Any]
    effort: NDArray[Any]
    saturated: NDArray[Any]
    t: Array
    channels: tuple[str, ...]
    trace: NDArray[Any]

    def __post_init__(self) -> None:
        for value in vars(self).values():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)

    def part(self, rows: Selection) -> FleetResult:
        """The robots number `rows`."""
        return replace(self, **{name: getattr(self, name)[rows] for name in _OF_EACH})


_OF_EACH = ("final", "fell", "lived", "peak", "settled", "rms_pitch", "effort", "saturated", "trace")


def joined(results: Sequence[FleetResult]) -> FleetResult:
    """The robots of all `results` of one length, one after another."""
    if len(results) == 1:
        return results[0]
    return replace(results[0], **{n: np.concatenate([getattr(one, n) for one in results]) for n in _OF_EACH})
