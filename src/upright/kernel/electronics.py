"""The electronics as compiled functions on the rows of a block."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from upright.compiled.electronics import SENSOR_NUMBERS, formulas
from upright.compiled.generated import LEFT, RIGHT
from upright.compiled.print_lanes import LanesPrinter, RowOf
from upright.kernel import rows as b
from upright.kernel.law import NUMBERS
from upright.kernel.store import functions_of

_DRIVE = {
    "command_left": b.COMMAND, "command_right": b.COMMAND + 1, "limit": b.LIMIT, "dead_zone": b.DEAD_ZONE,
    "quantum": b.QUANTUM, "drop": b.DROP, "voltage": b.VOLTAGE, "sag": b.SAG, "applied_left": b.DRIVEN,
    "applied_right": b.DRIVEN + 1, "beyond": b.BEYOND,
}  # fmt: skip
_TURN = {
    "applied_left": b.APPLIED, "applied_right": b.APPLIED + 1, "left": b.STRENGTH,
    "right": b.STRENGTH + 1, "motor_left": LEFT, "motor_right": RIGHT,
}  # fmt: skip
_SENSOR = {name: row for row, name in enumerate(SENSOR_NUMBERS)} | {
    "play": b.S_PLAY, "offset": b.S_OFFSET, "reading": b.S_VALUE, "touch": b.S_TOUCH, "wheel": b.S_WHEEL,
    "ideal": b.S_IDEAL, "normal": b.S_NORMAL, "step": b.S_STEP,
}  # fmt: skip
ROWS = {"drive": _DRIVE, "turn": _TURN, "slacken": _SENSOR, "measure": _SENSOR}
"""Of each formula's variables; those of a sensor count from its own first row."""


class Functions(NamedTuple):
    """Addresses of the functions, by the formulas' names."""

    drive: int
    turn: int
    slacken: int
    measure: int


@cache
def functions(dtype: str) -> Functions:
    """In float64 or float32."""
    known = formulas()
    texts = list[str]()
    for name in Functions._fields:
        places = {variable: RowOf(row, ROWS[name] is _SENSOR) for variable, row in ROWS[name].items()}
        texts.append(LanesPrinter((known[name].block,), NUMBERS[dtype], places, table=False).text())
    return Functions(*(functions_of(text, name)[0] for text, name in zip(texts, Functions._fields, strict=True)))
