"""Writes the generated files again: `python -m upright.compiled.generate`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import sympy as sp
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter

from upright.atomic import write_text
from upright.compiled.electronics import formulas
from upright.compiled.print_javascript import NEAREST, function
from upright.compiled.trace import ROWS
from upright.compiled.trace_constants import NAMED
from upright.compiled.trace_motion import motions, work_rows
from upright.compiled.trace_print import function as python_function
from upright.robots.robot import PARAMETERS


def _constants_class() -> str:
    """The named constants, each with its formula."""
    width = max(map(len, NAMED))
    lines = [f"{name + ': Any':<{width + 5}}  # {meaning}" for name, (_, meaning) in NAMED.items()]
    document = (
        '"""The products of a robot\'s parameters in its equations of motion; a11 and a33 of the upright robot."""'
    )
    return "\n".join(
        ["class Constants(NamedTuple):", f"    {document}", "", *(f"    {line}" for line in lines), "", ""]
    )


def _constants_function() -> str:
    """A robot's constants from its parameters, in the order of `PARAMETERS`."""
    shared, results = sp.cse([sp.factor_terms(formula) for formula, _ in NAMED.values()], sp.numbered_symbols("t"))
    lines = [f"{', '.join(PARAMETERS)} = p", *(f"{name} = {_code(formula)}" for name, formula in shared)]
    return python_function(
        "constants(p, complete)", [*lines, f"return Constants({', '.join(map(_code, results))})"], None
    )


class _Products(PythonCodePrinter):
    """Python text with squares as products, which a number and an array of numbers round alike."""

    def _print_Pow(self, expr: Any, rational: bool = False) -> str:  # noqa: N802 (the name SymPy looks for)
        if expr.exp == 2:
            base = self.parenthesize(expr.base, PRECEDENCE["Mul"])
            return f"({base} * {base})"
        return super()._print_Pow(expr, rational)


def _code(formula: Any) -> str:
    return str(_Products({"fully_qualified_modules": False}).doprint(formula))


def _page() -> str:
    """The electronics for a page."""
    known = formulas()
    named = {"driveVolts": known.pop("drive"), "driveTorque": formulas(volts=False)["drive"], **known}
    head = (
        "// Generated from physics/electronics.py: do not edit. Written again by: python -m upright.compiled.generate"
    )
    return "\n".join([head, "", NEAREST, *(function(name, formula) for name, formula in named.items())])


def sources() -> dict[str, str]:
    """The text of each generated file, by its path from here."""
    rows = [*ROWS, *NAMED]
    layout = [
        f"LANES, ROW, SIZE = {LANES}, {ROW}, {len(rows) + work_rows()} * {ROW}",
        *(f"{name.upper()} = {row}" for row, name in enumerate(rows)),
        f"WORK, WORK_ROWS = {len(rows)}, {work_rows()}",
        "",
    ]
    parts = [HEADER, IMPORTS, "\n".join(layout), _constants_class(), _constants_function()]
    return {
        "generated.py": "\n\n".join(parts).rstrip() + "\n",
        "generated_motion.py": "\n\n".join([HEADER, *motions()]).rstrip() + "\n",
        "../lab/web/src/electronics.js": _page(),
    }


IMPORTS = "from typing import Any, NamedTuple"

HEADER = """# Generated from physics.dynamics: do not edit. Written again by: python -m upright.compiled.generate
# ruff: noqa
# fmt: off
# pyright: basic"""

LANES, ROW = 64, 80
"""Robots in a block, and numbers from one row to the next: rows 64 apart would meet in the same cache lines."""


def main() -> None:
    """Writes the generated files."""
    for name, text in sources().items():
        write_text(Path(__file__).parent / name, text)


if __name__ == "__main__":
    main()
