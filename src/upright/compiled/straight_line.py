"""The nonlinear model's step as straight-line code: one function, without a call of another inside.

What depends on parameters alone stays a float and folds in the order in which the dynamics compute it, so that the
numbers are those of the dynamics bit for bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

from upright.compiled.print_python import PythonStatements
from upright.compiled.program import Block
from upright.compiled.tracer import FormulaTracer, Number
from upright.physics.dynamics import Disturbance, derivative
from upright.physics.integrate import rk4_step
from upright.physics.sensing import readings_under
from upright.robots import Robot

Step = Callable[[Sequence[float], Sequence[float], Sequence[float]], tuple[float, ...]]


@lru_cache(maxsize=64)
def written(robot: Robot, model: str, period: float, substeps: int) -> Step:
    """(x, u, w) → the state after `period` [s], six numbers, and what every ideal sensor then reads."""
    printer, (step, sensed) = PythonStatements(), blocks(robot, model, period / substeps)
    once = printer.lines(step)
    loop = once if substeps == 1 else [f"for _ in range({substeps}):", *(f" {line}" for line in once)]
    result = ", ".join([*(f"x{i}" for i in range(6)), *(value for _, value in sensed.commit)])
    lines = ["x0, x1, x2, x3, x4, x5 = x", "u0, u1 = u", "w0, w1, w2 = w", *loop]
    lines += [line for statement in sensed.statements for line in printer.statement(statement)]
    words: dict[str, Any] = {name: getattr(math, name) for name in ("sin", "cos", "sqrt", "inf", "nan")}
    code = [*lines, f"return {result}"]
    exec("def step(x, u, w):\n " + "\n ".join(code), words)  # our own dynamics; a test compares the numbers
    return words["step"]


def blocks(robot: Robot, model: str, h: float) -> tuple[Block, Block]:
    """A step of `h` [s] of the state x0 … x5 under u0, u1 and the disturbance w0 … w2, and of the state it ends in what
    every ideal sensor reads, y0 … y5."""
    step, after = FormulaTracer("t"), FormulaTracer("s")

    def inputs(tracer: FormulaTracer) -> tuple[list[Number], list[Number], Disturbance]:
        numbers = tracer.numbers
        return numbers("x0 x1 x2 x3 x4 x5"), numbers("u0 u1"), Disturbance(*numbers("w0 w1 w2"))

    x, u, w = inputs(step)
    moved = rk4_step(lambda state: derivative(state, u, robot, w, step, model), x, h)
    x, u, w = inputs(after)
    sensed = readings_under(u, x, robot, w, after, model)
    return step.block("step", _named("x", moved)), after.block("read", _named("y", sensed))


def _named(letter: str, values: Sequence[Any]) -> dict[str, Any]:
    return {f"{letter}{i}": value for i, value in enumerate(values)}
