"""Writes the generated files again: `python -m upright.compiled.generate`."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import sympy as sp

from upright.compiled.trace import ROWS, trace
from upright.compiled.trace_motion import motions, work_rows
from upright.compiled.trace_print import function
from upright.robots.robot import PARAMETERS


def _constants_function() -> str:
    """A robot's constants from its parameters, in the order of `PARAMETERS`."""
    lines = [f"{name} = p[{i}]" for i, name in enumerate(PARAMETERS)]
    shared, formulas = sp.cse(list(trace().constants.values()), sp.numbered_symbols("t"))
    lines += [f"{name} = {_code(formula)}" for name, formula in shared]
    lines.append(f"return ({', '.join(map(_code, formulas))})")
    return function("constants(p, complete)", lines, None)


def _code(formula: Any) -> str:
    """Python text, with squares as products, which a number and an array of numbers round alike."""
    return re.sub(r"(\w+)\*\*2", r"(\1 * \1)", str(sp.pycode(formula)))


def sources() -> dict[str, str]:
    """The text of each generated file, by name."""
    work = len(ROWS) + len(trace().constants)
    size = f"LANES, ROW, SIZE = {LANES}, {ROW}, {work + work_rows()} * {ROW}"
    rows = [
        size,
        f"CONSTANTS = {len(trace().constants)}",
        *(f"{n.upper()} = {i}" for i, n in enumerate([*ROWS, "c0"])),
        f"WORK, WORK_ROWS = {work}, {work_rows()}",
        "",
    ]
    return {
        "generated.py": "\n\n".join([HEADER, "\n".join(rows), _constants_function()]).rstrip() + "\n",
        "generated_motion.py": "\n\n".join([HEADER, *motions()]).rstrip() + "\n",
    }


HEADER = """# Generated from physics.dynamics: do not edit. Written again by: python -m upright.compiled.generate
# ruff: noqa
# fmt: off
# pyright: basic"""

LANES, ROW = 64, 80
"""Robots in a block, and numbers from one row to the next: rows 64 apart would meet in the same cache lines."""


def main() -> None:
    """Writes the generated files beside this one."""
    for name, text in sources().items():
        Path(__file__).with_name(name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
