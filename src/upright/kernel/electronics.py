"""The electronics as compiled functions on the rows of a block."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from upright.compiled.electronics import FUSED_NUMBERS, GYRO_NUMBERS, SENSOR_NUMBERS, formulas
from upright.compiled.generated import GRAVITY, LEFT, PITCH_RATE, RIGHT, YAW_RATE
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
_MOTION = {
    "rate": PITCH_RATE, "yaw_rate": YAW_RATE, "forward": b.SPECIFIC_FORCE, "up": b.SPECIFIC_FORCE + 1,
    "gravity": GRAVITY,
}  # fmt: skip
_OWN = (*SENSOR_NUMBERS, *GYRO_NUMBERS)
_SENSOR = {name: row for row, name in enumerate(_OWN)} | {
    "play": b.S_OWN, **{name: b.S_OWN + row for row, name in enumerate(FUSED_NUMBERS)}, "drift": b.S_DRIFT,
    "reading": b.S_VALUE, "touch": b.S_SENSED, "sensed": b.S_SENSED, "angle": b.S_SENSED, "wheel": b.S_MEMORY,
    "first": b.S_MEMORY, "second": b.S_MEMORY + 1, "cosine": b.S_MEMORY, "sine": b.S_MEMORY + 1, "ideal": b.S_IDEAL,
    "normal": b.S_NORMAL, "step": b.S_STEP,
}  # fmt: skip
PLACES = {
    "drive": {name: RowOf(row) for name, row in _DRIVE.items()},
    "turn": {name: RowOf(row) for name, row in _TURN.items()},
}
"""Of each formula's variables; those of a sensor count from its own first row."""
for _name in ("slacken", "settle", "swing", "fuse", "measure"):
    PLACES[_name] = {n: RowOf(row) for n, row in _MOTION.items()} | {n: RowOf(row, True) for n, row in _SENSOR.items()}


class Functions(NamedTuple):
    """Addresses of the functions, by the formulas' names."""

    drive: int
    turn: int
    slacken: int
    settle: int
    swing: int
    fuse: int
    measure: int


@cache
def functions(dtype: str) -> Functions:
    """In float64 or float32."""
    known = formulas()
    texts = list[str]()
    for name in Functions._fields:
        texts.append(LanesPrinter((known[name].block,), NUMBERS[dtype], PLACES[name], table=False).text())
    return Functions(*(functions_of(text, name)[0] for text, name in zip(texts, Functions._fields, strict=True)))
