"""The controllers of a batch as compiled functions on the rows of a block."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from upright.arrays import Array
from upright.compiled.generated import LEFT
from upright.compiled.print_lanes import LanesPrinter, RowOf, constants
from upright.compiled.program import Block, Kind, Program, Step, Sum
from upright.control.law import program
from upright.control.linear_controller import Law
from upright.kernel.rows import COMMAND, REFERENCE
from upright.kernel.store import functions_of
from upright.signals import STATE_NAMES

NUMBERS = {"float64": "double", "float32": "float"}

FIXED = {f"reference_{name}": RowOf(REFERENCE + i) for i, name in enumerate(STATE_NAMES)} | {
    "command_left": RowOf(COMMAND), "command_right": RowOf(COMMAND + 1),
}  # fmt: skip
"""Variables of a law that every block has."""


@dataclass(frozen=True, eq=False)
class CompiledLaw:
    """Addresses of both functions (`update` is 0 where nothing is remembered), the number of their own `rows`, which
    begin with the readings, and their `constants`: one row for all robots, or one for each. `residual` is the row of
    a predictive controller's, among its own; 0 for any other."""

    command: int
    update: int
    rows: int
    constants: Array
    residual: int


@lru_cache(maxsize=64)
def compiled(laws: tuple[Law, ...], referred: int, dtype: str, applied: int = LEFT) -> CompiledLaw:
    """The laws of a batch, in float64 or float32; for the first `referred` states there is a reference, and what is
    applied stands in the two rows from `applied` on."""
    text, table = merged([program(law, referred) for law in laws])
    outputs = [v.name for v in text.of(Kind.OUTPUT) if v.name not in FIXED]
    own = [*text.channels, *(v.name for v in text.of(Kind.STATE)), *text.carried(), *outputs]
    places = (
        FIXED
        | {"applied_left": RowOf(applied), "applied_right": RowOf(applied + 1)}
        | {name: RowOf(i, relative=True) for i, name in enumerate(own)}
    )
    module = LanesPrinter((text.command, text.update), NUMBERS[dtype], places, table=True, own=len(laws) > 1).text()
    command, update = functions_of(module, "command", "update")
    residual = own.index("residual") if "residual" in own else 0
    return CompiledLaw(command, update if text.update.statements else 0, len(own), table, residual)


def merged(programs: Sequence[Program]) -> tuple[Program, Array]:
    """One program with the terms that any of several like ones has, and the constants (n, k) of each: zero for a term
    that it does not have, which changes none of its bits."""
    first, *others = programs
    if not others:
        return first, np.array([constants(first)])
    place = {name: i for i, name in enumerate(first.variables)}

    def whole(blocks: Sequence[Block], terms: Sequence[Sequence[str]]) -> list[Block]:
        statements = [[_filled(s, names) for s, names in zip(b.steps, terms, strict=True)] for b in blocks]
        return [replace(b, statements=tuple(s)) for b, s in zip(blocks, statements, strict=True)]

    filled: list[list[Block]] = []
    for blocks in ([p.command for p in programs], [p.update for p in programs]):
        rows = zip(*(b.steps for b in blocks), strict=True)
        filled.append(whole(blocks, [sorted(set().union(*map(_names, row)), key=place.__getitem__) for row in rows]))
    each = [replace(p, command=c, update=u) for p, c, u in zip(programs, *filled, strict=True)]
    return each[0], np.array([constants(p) for p in each])


def _names(statement: Step) -> set[str]:
    return {name for _, name in statement.terms} if isinstance(statement, Sum) else set()


def _filled(statement: Step, names: Sequence[str]) -> Step:
    """A sum with a coefficient for each of `names`."""
    if not isinstance(statement, Sum):
        return statement
    terms = {name: coefficient for coefficient, name in statement.terms}
    return replace(statement, terms=tuple((terms.get(name, 0.0), name) for name in names))
