"""The nonlinear model's step as straight-line Python: one function, without a call of another inside.

The dynamics are generic over their numbers: called with names instead, they write down what they would compute. What
depends on parameters alone stays a float and folds in the order in which the dynamics compute it, so that the numbers
are those of the dynamics bit for bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from upright.physics.dynamics import Disturbance, accelerations, derivative
from upright.physics.integrate import rk4_step
from upright.physics.sensing import readings
from upright.robots import Robot

Step = Callable[[Sequence[float], Sequence[float], Sequence[float]], tuple[float, ...]]


class Statements(NamedTuple):
    """One step of x0 … x5 under u0, u1, w0 … w2 as assignments `name = expression` in order, and the expressions of its
    results: `moving` gives the six of `moved`; of the state it ends in, `reading` gives those of every ideal sensor.

    Each expression is one operation on names and numbers, written alike in many languages but for the power `a ** 2`.
    """

    moving: list[str]
    moved: list[str]
    reading: list[str]
    readings: list[str]


@lru_cache(maxsize=64)
def written(robot: Robot, model: str, period: float, substeps: int) -> Step:
    """(x, u, w) → the state after `period` [s], six numbers, and what every ideal sensor then reads."""
    step = statements(robot, model, period / substeps)
    once = [*step.moving, f"x0, x1, x2, x3, x4, x5 = {', '.join(step.moved)}"]
    loop = once if substeps == 1 else [f"for _ in range({substeps}):", *(f" {line}" for line in once)]
    result = ", ".join(["x0, x1, x2, x3, x4, x5", *step.readings])
    lines = ["x0, x1, x2, x3, x4, x5 = x", "u0, u1 = u", "w0, w1, w2 = w", *loop, *step.reading, f"return {result}"]
    words: dict[str, Any] = {"sin": math.sin, "cos": math.cos, "sqrt": math.sqrt}
    exec("def step(x, u, w):\n " + "\n ".join(lines), words)  # our own dynamics; a test compares the numbers
    return words["step"]


def statements(robot: Robot, model: str, h: float) -> Statements:
    """A step of `h` [s]."""
    step, after = _Book("t"), _Book("s")

    def inputs(book: _Book) -> tuple[list[_Name], list[_Name], Disturbance]:
        return ([_Name(f"x{i}", book) for i in range(6)], [_Name(f"u{i}", book) for i in range(2)],
                Disturbance(*(_Name(f"w{i}", book) for i in range(3))))  # fmt: skip

    x, u, w = inputs(step)
    moved = rk4_step(lambda state: derivative(state, u, robot, w, step, model), x, h)
    x, u, w = inputs(after)
    wheel_acc = accelerations(x, u, robot, w, after, model)[1]
    sensed = readings(x, wheel_acc, robot, w.slope, after)
    return Statements(step.lines(), [*map(_text, moved)], after.lines(), [*map(_text, sensed)])


class _Book:
    """Statements in order, each expression once; as `xp` it is the dynamics' namespace of mathematics."""

    def __init__(self, letter: str) -> None:
        self._letter, self._names = letter, dict[str, str]()

    def let(self, expression: str) -> _Name:
        return _Name(self._names.setdefault(expression, f"{self._letter}{len(self._names)}"), self)

    def lines(self) -> list[str]:
        return [f"{name} = {expression}" for expression, name in self._names.items()]

    def sin(self, angle: Any) -> _Name:
        return self.let(f"sin({_text(angle)})")

    def cos(self, angle: Any) -> _Name:
        return self.let(f"cos({_text(angle)})")

    def sqrt(self, square: Any) -> _Name:
        return self.let(f"sqrt({_text(square)})")


class _Name:
    """What stands for a number: arithmetic with it becomes a statement."""

    def __init__(self, text: str, book: _Book) -> None:
        self.text, self._book = text, book

    def __add__(self, other: Any) -> _Name:
        return self._book.let(f"{self.text} + {_text(other)}")

    def __radd__(self, other: Any) -> _Name:
        return self._book.let(f"{_text(other)} + {self.text}")

    def __sub__(self, other: Any) -> _Name:
        return self._book.let(f"{self.text} - {_text(other)}")

    def __rsub__(self, other: Any) -> _Name:
        return self._book.let(f"{_text(other)} - {self.text}")

    def __mul__(self, other: Any) -> _Name:
        return self._book.let(f"{self.text} * {_text(other)}")

    def __rmul__(self, other: Any) -> _Name:
        return self._book.let(f"{_text(other)} * {self.text}")

    def __truediv__(self, other: Any) -> _Name:
        return self._book.let(f"{self.text} / {_text(other)}")

    def __pow__(self, power: int) -> _Name:
        return self._book.let(f"{self.text} ** {power}")

    def __neg__(self) -> _Name:
        return self._book.let(f"-{self.text}")


def _text(value: Any) -> str:
    return value.text if isinstance(value, _Name) else repr(float(value))
