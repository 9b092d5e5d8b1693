"""What the brick's instructions work on: variables, time, and the devices around them.

Arithmetic is the brick's: integers wrap at the width of what they are stored in, an operation on a float is done in
single precision.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

from upright.bricks.brick import Hardware
from upright.bricks.rxe import NOTHING, Executable, InvalidProgram, Type, Value

_SINGLE = struct.Struct("<f")
_WIDTH = {Type.UBYTE: 8, Type.SBYTE: 8, Type.UWORD: 16, Type.SWORD: 16, Type.ULONG: 32, Type.SLONG: 32, Type.MUTEX: 32}
_SIGNED = frozenset({Type.SBYTE, Type.SWORD, Type.SLONG})


class Processor:
    """The variables of `program`, its `devices`, `time` [µs], and `naps`, the number of waits.

    Abstract: a `Machine` runs the instructions.
    """

    def __init__(self, program: Executable, devices: Hardware) -> None:
        self.program, self.devices = program, devices
        self.cells: list[Value] = [copied(v) for v in program.values]
        self.time = self.naps = 0
        self.returns: dict[int, int] = {}  # the variable of a subroutine's caller → where it goes on

    def now(self) -> Hardware:
        """The world, brought to this moment."""
        self.devices.reach(self.time)
        return self.devices

    def sleep(self, duration: int) -> None:
        """Do nothing for that long [ms]."""
        self.time += 1000 * duration
        self.naps += 1

    def store(self, index: int) -> Callable[[Any], None]:
        """What puts a number into the variable `index`, as its type holds it."""
        cells = self.cells
        hold = holder(self.program.entries[index].type)
        return lambda x: cells.__setitem__(index, hold(x))

    def number(self, index: int, nothing: int = 0) -> Callable[[], Any]:
        """What reads a number from the variable `index`; `nothing` where the argument stands for no variable."""
        cells = self.cells
        return (lambda: nothing) if index == NOTHING else lambda: cells[index]

    def leaves(self, index: int) -> list[int]:
        """The variables that a cluster is made of, those of clusters in it among them."""
        if self.program.entries[index].type is not Type.CLUSTER:
            return [index]
        return [leaf for member in self.program.members(index) for leaf in self.leaves(member)]


def holder(kind: Type) -> Callable[[Any], Any]:
    """What a number becomes when it is stored as that type."""
    if kind is Type.FLOAT:
        return lambda x: _SINGLE.unpack(_SINGLE.pack(x))[0]
    if kind not in _WIDTH:
        raise InvalidProgram(f"a number is stored in a {kind.name.lower()}")
    width = 1 << _WIDTH[kind]
    low = -(1 << _WIDTH[kind] - 1) if kind in _SIGNED else 0

    def wrap(x: Any) -> int:
        if x != int(x):
            raise InvalidProgram(f"{x} is stored as an integer", expected="a whole number", hint="trunc it first")
        return (int(x) - low) % width + low

    return wrap


def copied(value: Any) -> Any:
    return value.copy() if isinstance(value, bytearray | list) else 0 if value is None else value
