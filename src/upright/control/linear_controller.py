"""One discrete state-space system: the form of every linear controller with a memory."""

from __future__ import annotations

from array import array
from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass, field, fields, replace
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.compiled.tracer import Form, Tracer
from upright.control.controller import ControllerSpec, Lawful
from upright.control.design import Design, OfDesign
from upright.errors import InvalidController

MOST_STATES = 1000
"""Of a controller in a file."""

MATRICES = ("A", "By", "Br", "Ba", "C", "Dy", "Dr", "S", "Sy", "Bu")


@dataclass(eq=False, repr=False)
class LinearController(OfDesign, Lawful):
    """z⁺ = A z + By y + Br r + Ba a, u = C z + Dy y + Dr r, x̂ = S z + Sy y, every `period` [s].

    y are the channels `reads`, r the reference state (6,) and u the command (2,). a is the command that was really
    applied, so that nothing winds up in saturation. x̂ (6,) is the controller's estimate of the state; S and Sy stay
    empty where it has none.

    For a method that is not linear it is the memory: it has any number of outputs C z + Dy y + Dr r, read by `outputs`.
    The method computes u from them and passes it to `decided`; Bu u is then added to z⁺. Bu stays empty in all others.

    Raises `InvalidController` for matrices that do not fit each other or are not finite.
    """

    form: ClassVar[str] = "linear"
    A: Array
    By: Array
    Br: Array
    Ba: Array
    C: Array
    Dy: Array
    Dr: Array
    _: KW_ONLY
    reads: tuple[str, ...]
    period: float
    S: Array = field(default_factory=lambda: np.zeros((0, 0)))
    Sy: Array = field(default_factory=lambda: np.zeros((0, 0)))
    Bu: Array = field(default_factory=lambda: np.zeros((0, 0)))
    command_unit: str = "V"
    kind: str = "linear controller"
    design: Design | None = field(default=None, repr=False)
    spec: ControllerSpec = field(init=False)

    def __post_init__(self) -> None:
        n = len(self.A)
        m = len(self.reads)
        estimates = np.shape(self.S)[0] > 0
        memory = np.size(self.Bu) > 0
        o = len(self.C) if memory else 2
        shapes = {"A": (n, n), "By": (n, m), "Br": (n, 6), "Ba": (n, 2), "C": (o, n), "Dy": (o, m), "Dr": (o, 6)}
        shapes |= {"S": (6, n), "Sy": (6, m)} if estimates else {"S": (0, 0), "Sy": (0, 0)}
        shapes |= {"Bu": (n, 2) if memory else (0, 0)}
        for name, shape in shapes.items():
            setattr(self, name, finite_matrix(getattr(self, name), name, shape))
        if not (np.isfinite(self.period) and self.period > 0):
            raise InvalidController(f"the period is {self.period} s", expected="a positive number")
        self.reads = tuple(self.reads)
        self.spec = ControllerSpec(self.kind, self.reads, self.period, self.command_unit, estimates=estimates)
        self._stack()
        self.reset()

    def _stack(self) -> None:
        """One matrix from [p, a, x̂, y, r] to [p, u, x̂], with p = z − Ba a: the product needs no command but the last.

        It writes where the next step reads, u in the place of a, so that a command nobody corrects counts as applied.
        A memory has [p, outputs, x̂, a, u, y, r], with p = z − Ba a − Bu u. A few numbers are copied through a
        memoryview in half the time that NumPy takes.
        """
        n, m, o, opinions = len(self.A), len(self.reads), len(self.C), len(self.S)
        states = np.vstack([self.A, self.C, self.S.reshape(opinions, n)])
        readings = np.vstack([self.By, self.Dy, self.Sy.reshape(opinions, m)])
        references = np.vstack([self.Br, self.Dr, np.zeros((opinions, 6))])
        top = len(states)
        idle = np.zeros((len(states), o + opinions))
        if self.Bu.size:
            commands = [idle, states @ self.Ba, states @ self.Bu]
            own = slice(top, top + 4)
        else:
            commands = [states @ self.Ba, idle[:, o:]]
            own = slice(n, n + 2)
        stacked = np.hstack([states, *commands, readings, references])
        self._dot = np.ascontiguousarray(stacked).dot
        self._memory = np.zeros((2, stacked.shape[1]))
        given, (first, second) = max(top, own.stop), self._memory
        view: Any = memoryview
        self._turns = [
            (w, view(w[given : given + m]), view(w[given + m :]), other[:top], view(other[n : n + 2]), view(w[own]),
             w[n + o : top], other[n : n + o])
            for w, other in ((first, second), (second, first))
        ]  # fmt: skip

    def reset(self) -> None:
        self._memory[:] = 0.0
        self._now, self._next = self._turns

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        w, y, r, result, u, _, _, _ = self._now
        try:
            y[:] = measurement
            r[:] = reference
        except (TypeError, ValueError):  # lists, whole numbers, and arrays whose byte order is spelled out
            y[:] = array("d", measurement)
            r[:] = array("d", reference)
        self._dot(w, result)
        self._now, self._next = self._next, self._now
        return u[0], u[1]

    def outputs(self, measurement: Array, reference: Array) -> Array:
        """A step of a memory: all outputs, in an array that is written again two steps later."""
        result = self._now[7]
        self.step(measurement, reference)
        return result

    def decided(self, left: float, right: float) -> None:
        """The command that was computed from the outputs; it counts as applied until `applied` corrects it."""
        commands = self._now[5]
        commands[0] = commands[2] = left
        commands[1] = commands[3] = right

    def estimate(self) -> Sequence[float]:
        return self._now[6].tolist()

    def applied(self, command: Sequence[float]) -> None:
        a = self._now[5]
        a[0], a[1] = command

    def law(self) -> Law:
        return Law(self)

    def law_with(self, part: Nonlinearity, linear: Array, rows: slice) -> Law:
        """Of a memory: the law whose s are those `rows` of its outputs, and whose linear command is `linear`
        (2, outputs) times them."""
        command = {"C": linear @ self.C, "Dy": linear @ self.Dy, "Dr": linear @ self.Dr}
        alone = replace(self, **command, Bu=np.zeros((0, 0)))
        return Law(alone, Nonlinear(self.C[rows], self.Dy[rows], self.Dr[rows], self.Bu, part))

    def facts(self) -> dict[str, Any]:
        """Kind, channels, period and unit, for JSON."""
        return {"kind": self.kind, "reads": list(self.reads), "period": self.period, "command_unit": self.command_unit}

    def matrices(self) -> dict[str, Any]:
        """Every matrix that has entries, by name, for JSON; a memory without Br, which is zero."""
        names = [name for name in MATRICES if getattr(self, name).size and not (name == "Br" and self.Bu.size)]
        return {name: getattr(self, name).tolist() for name in names}

    def to_json(self) -> dict[str, Any]:
        return self.facts() | {"states": len(self.A)} | self.matrices()

    @classmethod
    def like(cls, spec: ControllerSpec, *matrices: Array, **opinion: Array) -> LinearController:
        """Of the kind, channels, period and unit in `spec`: A to Dr, and S and Sy by name."""
        facts: dict[str, Any] = {"reads": spec.reads, "period": spec.period, "command_unit": spec.command_unit}
        return cls(*matrices, **facts, **opinion, kind=spec.kind)

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> LinearController:
        """The inverse of `to_json`; the design's record stays behind."""
        n, reads = int(data["states"]), tuple(data["reads"])
        if not 0 <= n <= MOST_STATES:
            raise InvalidController(f"{n:.3g} states", expected=f"0 to {MOST_STATES}")
        empty = {"A": (n, n), "By": (n, len(reads)), "Br": (n, 6), "Ba": (n, 2), "C": (2, n)}
        given: dict[str, Any] = {name: data.get(name, np.zeros(empty.get(name, (0, 0)))) for name in MATRICES}
        return cls(**given, reads=reads, period=data["period"], command_unit=data["command_unit"], kind=data["kind"])

    @classmethod
    def memory_from_json(cls, data: dict[str, Any]) -> LinearController:
        """The memory of a method that is not linear: its `facts` in `data`, its `matrices` under "memory"."""
        return cls.from_json(data | data["memory"] | {"states": len(data["memory"]["A"])})

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies are made anew: what a step writes to and reads from is one memory."""
        values = {f.name: getattr(self, f.name) for f in fields(self) if f.init}
        return _remade, (values,)


def _remade(values: dict[str, Any]) -> LinearController:
    return LinearController(**values)


def finite_matrix(given: ArrayLike, name: str, shape: tuple[int, int]) -> Array:
    """A read-only copy of that shape; `InvalidController` says what is wrong with it."""
    value = np.array(given, dtype=np.float64)
    if value.size == 0 and 0 in shape:
        value = np.zeros(shape)
    if value.shape != shape:
        raise InvalidController(f"{name} has shape {value.shape}", expected=f"{shape}", likely="a transpose")
    if not np.isfinite(value).all():
        raise InvalidController(f"{name} holds NaN or infinity", expected="finite numbers")
    value.setflags(write=False)
    return value


class Remembering(OfDesign, Lawful):
    """A method that is not linear, behind a linear `memory`, which knows its readings, commands and estimate."""

    memory: LinearController

    @property
    def spec(self) -> ControllerSpec:
        return self.memory.spec

    def reset(self) -> None:
        self.memory.reset()

    def estimate(self) -> Sequence[float]:
        return self.memory.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.memory.applied(command)


class Nonlinearity(Protocol):
    """What of a law is not linear: from the linear command and s to the commands, and to what else the memory gets.

    `slope` (2 + further, s) is what it adds per s near rest, and `most` (further,) the largest that each of what it
    gives besides the commands can be.
    """

    @property
    def slope(self) -> Array: ...

    @property
    def most(self) -> tuple[float, ...]:
        """Empty where it gives nothing but the commands."""
        return ()

    def forms(self, t: Tracer, linear: Sequence[Form], s: Sequence[Form], /) -> tuple[list[Form], list[Form]]: ...


@dataclass(frozen=True, eq=False)
class Nonlinear:
    """s = C z + Dy y + Dr r, and what is made of it: the `part` of a law that is not linear.

    The memory is driven by Bu v as well, v being the command before the motors' limits and what else the part gives.
    """

    C: Array
    Dy: Array
    Dr: Array
    Bu: Array
    part: Nonlinearity


@dataclass(frozen=True, eq=False)
class Law:
    """A controller as fixed sums of products; `nonlinear` is None for a linear one."""

    linear: LinearController
    nonlinear: Nonlinear | None = None

    @property
    def period(self) -> float:
        return self.linear.period

    def law(self) -> Law:
        """It is its own."""
        return self

    def linearised(self) -> LinearController:
        """The linear system that decides about stability at rest, where no limit counts."""
        one, two = self.linear, self.nonlinear
        if two is None:
            return one
        slope = two.part.slope

        def near_rest(linear: Array, s: Array) -> Array:
            return np.pad(linear, ((0, len(slope) - 2), (0, 0))) + slope @ s

        C, Dy, Dr = near_rest(one.C, two.C), near_rest(one.Dy, two.Dy), near_rest(one.Dr, two.Dr)
        memory = {"A": one.A + two.Bu @ C, "By": one.By + two.Bu @ Dy, "Br": one.Br + two.Bu @ Dr}
        return replace(one, **memory, C=C[:2], Dy=Dy[:2], Dr=Dr[:2])

    def with_period(self, period: float) -> Law:
        """The same numbers every `period` [s]."""
        return replace(self, linear=replace(self.linear, period=period))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self._numbers() == other._numbers()

    def __hash__(self) -> int:
        return hash(self._numbers())

    def _numbers(self) -> tuple[Any, ...]:
        """All that decides the statements."""
        one, two = self.linear, self.nonlinear
        names = ("reads", "period", "command_unit", "kind", "A", "By", "Br", "Ba", "C", "Dy", "Dr")
        facts = [getattr(one, name) for name in names]
        facts += [two.C, two.Dy, two.Dr, two.Bu, *vars(two.part).values()] if two else []
        return tuple(fact.tobytes() if isinstance(fact, np.ndarray) else fact for fact in facts)
