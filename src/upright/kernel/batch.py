"""Many robots as arrays: what is simulated, and what comes of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import reduce
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.control import Controller
from upright.control.linear_controller import as_linear
from upright.errors import InvalidModel, InvalidRobot, InvalidScenario, SpecMismatch
from upright.physics.dynamics import MODELS
from upright.robots import Kit, Robot
from upright.robots.robot import PARAMETERS

Array = NDArray[np.float64]

Rows = slice | NDArray[np.int64]
"""Which robots of a batch."""

NAMES = tuple(PARAMETERS)


class Gains(NamedTuple):
    """A linear controller for all robots (leading axis 1) or one for each (n): z⁺ = A z + By y + Br r + Ba a,
    u = C z + Dy y + Dr r, with the channels it reads and its period [s]."""

    A: Array
    By: Array
    Br: Array
    Ba: Array
    C: Array
    Dy: Array
    Dr: Array
    reads: tuple[str, ...]
    period: float
    command_unit: str

    @classmethod
    def of(cls, controller: Controller | Sequence[Controller] | Gains) -> Gains:
        """From one controller, or one for each robot; `InvalidController` for one that is not linear,
        `SpecMismatch` where they do not read the same at the same rate."""
        if isinstance(controller, Gains):
            return controller
        several = [controller] if isinstance(controller, Controller) else list(controller)
        linear = [as_linear(one) for one in several]
        forms = {(one.reads, one.period, one.command_unit, len(one.A)) for one in linear}
        if len(forms) != 1:
            raise SpecMismatch(
                f"{len(forms)} forms of controllers", expected="one period, size and set of channels for all"
            )
        stacked = [
            np.stack([getattr(one, name) for one in linear]) for name in ("A", "By", "Br", "Ba", "C", "Dy", "Dr")
        ]
        A, By, Br, Ba, C, Dy, Dr = stacked
        return cls(A, By, Br, Ba, C, Dy, Dr, linear[0].reads, linear[0].period, linear[0].command_unit)

    @classmethod
    def silent(cls, controller: Controller) -> Gains:
        """Gains that command nothing and read what `controller` reads, which is called in their place."""
        spec, m = controller.spec, len(controller.spec.reads)
        sizes = ((1, 0, 0), (1, 0, m), (1, 0, 6), (1, 0, 2), (1, 2, 0), (1, 2, m), (1, 2, 6))
        A, By, Br, Ba, C, Dy, Dr = (np.zeros(size) for size in sizes)
        return cls(A, By, Br, Ba, C, Dy, Dr, spec.reads, spec.period, spec.command_unit)


@dataclass(frozen=True, eq=False, kw_only=True)
class FleetBatch:
    """n robots under linear control. Every array has n rows, or one row that all robots share.

    `parameters` (·, 21) in the order and units of `robots.robot.PARAMETERS` (see `parameters_of`); `controller` is
    one for all, a sequence of n, or `Gains`; `start` (·, 6) the state at t = 0; `pushes` (·, p, 4) force [N], height
    above the axle [m] (NaN: at the centre of mass), start [s], duration [s]; `slope` (·, 2) angle [rad] and start [s];
    `reference` (·, q, 4) speed [m/s], turn [rad/s], start and end [s], which add up. `kit` is the electronics,
    None the bare body; `kit_changes` replaces its numbers for each robot, by dotted name: "delay", "motor.limit",
    "sensors.gyro.noise" (channel without "sensor/"), (·,). `model` is "complete" or "published", or one for each.
    `index` (n,) numbers the robots for their random numbers, so that a part of a fleet behaves as in the whole.
    `period` [s] is the body's step, cut into `substeps` (None: as many as the fastest robot here needs; give it where a
    result must not depend on the company a robot keeps).

    Raises `SpecMismatch`, `InvalidModel` or `InvalidScenario` for what does not fit.
    """

    parameters: Array
    controller: Controller | Sequence[Controller] | Gains
    start: Array = field(default_factory=lambda: np.zeros((1, 6)))
    pushes: Array = field(default_factory=lambda: np.zeros((1, 0, 4)))
    slope: Array = field(default_factory=lambda: np.zeros((1, 2)))
    reference: Array = field(default_factory=lambda: np.zeros((1, 0, 4)))
    kit: Kit | None = None
    kit_changes: Mapping[str, ArrayLike] = field(default_factory=dict)
    model: str | Sequence[str] = "complete"
    seed: int = 0
    index: NDArray[np.uint64] | None = None
    period: float = 0.001
    substeps: int | None = None
    n: int = field(init=False)

    def __post_init__(self) -> None:
        for name, tail in (
            ("parameters", (len(NAMES),)),
            ("start", (6,)),
            ("pushes", (-1, 4)),
            ("slope", (2,)),
            ("reference", (-1, 4)),
        ):
            object.__setattr__(self, name, _table(name, getattr(self, name), tail))
        object.__setattr__(self, "controller", Gains.of(self.controller))
        changes = {name: _table(name, np.reshape(values, (-1,)), ()) for name, values in self.kit_changes.items()}
        object.__setattr__(self, "kit_changes", changes)
        models = (self.model,) if isinstance(self.model, str) else tuple(self.model)
        if unknown := set(models) - set(MODELS):
            raise InvalidModel(f"no model is called '{unknown.pop()}'", expected=" or ".join(MODELS))
        sizes = {name: len(getattr(self, name)) for name in ("parameters", "start", "pushes", "slope", "reference")}
        sizes |= {name: len(values) for name, values in changes.items()}
        sizes |= {"model": len(models), "controller": len(self.gains.C)}
        sizes |= {} if self.index is None else {"index": len(self.index)}
        object.__setattr__(self, "n", _common(sizes))

    @property
    def gains(self) -> Gains:
        """The controller as matrices."""
        assert isinstance(self.controller, Gains)
        return self.controller

    def part(self, rows: Rows, **changes: Array) -> FleetBatch:
        """The robots number `rows` (n,) under the numbers they have in the whole, with whole arrays (`start`, `pushes`)
        replaced by `changes`."""

        def some(values: Any) -> Any:
            return values[rows] if len(values) > 1 else values

        names = ("parameters", "start", "pushes", "slope", "reference")
        arrays = {name: changes[name] if name in changes else some(getattr(self, name)) for name in names}
        kit_changes = {name: some(np.asarray(values)) for name, values in self.kit_changes.items()}
        gains = self.gains
        if len(gains.C) > 1:
            gains = gains._replace(**{name: getattr(gains, name)[rows] for name in gains._fields[:7]})
        models = self.model if isinstance(self.model, str) else tuple(np.asarray(self.model)[rows].tolist())
        index = np.arange(self.n, dtype=np.uint64) if self.index is None else self.index
        return FleetBatch(
            **arrays, controller=gains, kit=self.kit, kit_changes=kit_changes,
            model=models, seed=self.seed, index=index[rows], period=self.period, substeps=self.substeps,
        )  # fmt: skip


def parameters_of(robots: Robot | Iterable[Robot], changes: Mapping[str, ArrayLike] | None = None) -> Array:
    """Parameters (n, 21) of one robot or several, with some columns replaced: {"com_height": (n,), …}.

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
        said = ", ".join(f"{name} has {size}" for name, size in wrong.items())
        raise InvalidScenario(f"{said} rows in a batch of {n}", expected=f"{n} rows, or one that all share")
    return n


@dataclass(frozen=True, eq=False)
class FleetResult:
    """What came of each of n robots; arrays are read-only.

    `final` (n, 6) is the last state (that at the fall for one that fell), `fell` (n,) whether and `lived` (n,) [s]
    until when it stood. Counted at the start of each period while it stood: `peak` (n, 3) largest |pitch|, |wheel| and
    |yaw| [rad],
    `settled` (n,) [s] the time from which it stayed inside `bands` (NaN: still outside or fallen),
    `rms_pitch` (n,) [rad].
    `effort` (n,) is ∫ u_l² + u_r² dt of the applied command, `saturated` (n,) the share of periods [1] in which a
    motor could not give what was asked. `trace` (n, k, m) holds `channels` at times `t` (k,) [s], NaN after a fall.
    """

    final: NDArray[Any]
    fell: NDArray[np.bool_]
    lived: NDArray[Any]
    peak: NDArray[Any]
    settled: NDArray[Any]
    rms_pitch: NDArray[Any]
    effort: NDArray[Any]
    saturated: NDArray[Any]
    t: Array
    channels: tuple[str, ...]
    trace: NDArray[Any]
    substeps: int

    def __post_init__(self) -> None:
        for value in vars(self).values():
            if isinstance(value, np.ndarray):
                value.setflags(write=False)
