"""The controllers of a batch, and the electronics, as compiled functions on the rows of a block."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache, lru_cache
from typing import NamedTuple

import numpy as np

from upright.arrays import Array
from upright.compiled.electronics import FUSED_NUMBERS, GYRO_NUMBERS, SENSOR_NUMBERS, formulas
from upright.compiled.generated import GRAVITY, LEFT, PITCH_RATE, RIGHT, YAW_RATE
from upright.compiled.print_lanes import LanesPrinter, RowOf
from upright.compiled.program import Kind
from upright.control.law import program
from upright.control.linear_controller import Law
from upright.kernel import rows as b
from upright.kernel.store import functions_of
from upright.signals import STATE_NAMES

FIXED = {f"reference_{name}": RowOf(b.REFERENCE + i) for i, name in enumerate(STATE_NAMES)} | {
    "command_left": RowOf(b.COMMAND), "command_right": RowOf(b.COMMAND + 1),
}  # fmt: skip
"""Variables of a law that every block has."""


@dataclass(frozen=True, eq=False)
class CompiledLaw:
    """Addresses of both functions (`update` is 0 where nothing is remembered), the number of their own `rows`, which
    begin with the readings, and their `constants` (k,). `residual` is the row of a predictive controller's, among its
    own; 0 for any other."""

    command: int
    update: int
    rows: int
    constants: Array
    residual: int


@lru_cache(maxsize=64)
def compiled(law: Law, referred: int, applied: int = LEFT) -> CompiledLaw:
    """The law of a batch; for the first `referred` states there is a reference, and what is applied stands in the two
    rows from `applied` on."""
    text = program(law, referred)
    outputs = [v.name for v in text.of(Kind.OUTPUT) if v.name not in FIXED]
    own = [*text.channels, *(v.name for v in text.of(Kind.STATE)), *text.carried(), *outputs]
    places = (
        FIXED
        | {"applied_left": RowOf(applied), "applied_right": RowOf(applied + 1)}
        | {name: RowOf(i, relative=True) for i, name in enumerate(own)}
    )
    printer = LanesPrinter((text.command, text.update), places, table=True)
    command, update = functions_of(printer.text(), "command", "update")
    residual = own.index("residual") if "residual" in own else 0
    return CompiledLaw(
        command, update if text.update.statements else 0, len(own), np.array(printer.constants), residual
    )


_DRIVE = {
    "command_left": b.COMMAND, "command_right": b.COMMAND + 1, "limit": b.LIMIT, "dead_zone": b.DEAD_ZONE,
    "quantum": b.QUANTUM, "drop": b.DROP, "voltage": b.VOLTAGE, "sag": b.SAG, "applied_left": b.DRIVEN,
    "applied_right": b.DRIVEN + 1, "beyond": b.BEYOND,
}  # fmt: skip
_TURN = {
    "applied_left": b.APPLIED, "applied_right": b.APPLIED + 1, "left": b.STRENGTH,
    "right": b.STRENGTH + 1, "motor_left": LEFT, "motor_right": RIGHT,
}  # fmt: skip
_MOTION = {"rate": PITCH_RATE, "yaw_rate": YAW_RATE, "gravity": GRAVITY}
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
PLACES["fuse"] |= {name: RowOf(b.S_FUSED + i, True) for i, name in enumerate(("rate", "forward", "up"))}


class CompiledElectronics(NamedTuple):
    """Addresses of the electronics' functions, by the formulas' names."""

    drive: int
    turn: int
    slacken: int
    settle: int
    swing: int
    fuse: int
    measure: int


@cache
def electronics() -> CompiledElectronics:
    """The functions, compiled once."""
    known = formulas()
    addresses = list[int]()
    for name in CompiledElectronics._fields:
        text = LanesPrinter((known[name].block,), PLACES[name], table=False).text()
        addresses += functions_of(text, name)
    return CompiledElectronics(*addresses)
