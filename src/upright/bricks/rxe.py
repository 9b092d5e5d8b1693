"""The program files of the NXT brick, read: variables, first values and code words of an .rxe.

Source: LEGO, "MINDSTORMS NXT Executable File Specification" 2.0: a header of 38 bytes; the table of contents of the
data space, four bytes an entry; first values; a record for each clump (a task or subroutine); the code, 16 bits a word.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum
from pathlib import Path

from upright.errors import UprightError

MAGIC = b"MindstormsNXT\0"
HEADER = struct.Struct("<16s9H2H")
ZERO = 1  # flag of an entry: it begins at zero, and no first value is stored for it
NOTHING = 0xFFFF  # an argument without a variable
SHORT, LONG = 0x0800, 14  # a bit of the first word; a size that says that the next word holds it
SHORT_CODES = (0x1B, 0x2C, 0x2D, 0x2E)  # move, acquire, release, subcall

Value = int | float | bytearray | list[int | float]


class InvalidProgram(UprightError):
    """A file that is not a program of the brick, or an unknown instruction."""


class Type(IntEnum):
    """What an entry of the data space is."""

    VOID, UBYTE, SBYTE, UWORD, SWORD, ULONG, SLONG, ARRAY, CLUSTER, MUTEX, FLOAT = range(11)

    @property
    def format(self) -> str:
        """The letter by which `struct` knows it."""
        return "xBbHhIi__If"[self]


SCALARS = frozenset({Type.UBYTE, Type.SBYTE, Type.UWORD, Type.SWORD, Type.ULONG, Type.SLONG, Type.FLOAT, Type.MUTEX})


@dataclass(frozen=True)
class TypeEntry:
    """A variable: its `type`; `data` is an address, or for a cluster the number of its members."""

    type: Type
    zero: bool
    data: int


@dataclass(frozen=True)
class Code:
    """An instruction: its `number`, `args`, the `condition` it compares by, the word it stands `at`, its `length`."""

    number: int
    args: tuple[int, ...]
    condition: int = 0
    at: int = 0
    length: int = 0


@dataclass(frozen=True)
class Executable:
    """The variables with their first `values`, where each clump starts, and the `code` words."""

    entries: tuple[TypeEntry, ...]
    values: tuple[Value | None, ...]
    clumps: tuple[int, ...]
    code: tuple[int, ...]

    def decode(self, at: int) -> Code:
        """The instruction at that word; a short one is given as the long one that it stands for."""
        word = self.code[at]
        size = self.code[at] >> 12
        length = (self.code[at + 1] if size == LONG else size) // 2
        args = self.code[at + (2 if size == LONG else 1) : at + length]
        condition = word >> 8 & 7
        if not word & SHORT:
            return Code(word & 0xFF, args, condition, at, length)
        offset = (word & 0xFF ^ 0x80) - 0x80  # the first argument, counted from the second
        return Code(SHORT_CODES[condition], (args[0] + offset, *args) if args else (offset,), 0, at, length)

    def members(self, index: int) -> list[int]:
        """The members of the cluster `index`, in order; those of clusters inside it are theirs."""
        members = list[int]()
        at = index + 1
        for _ in range(self.entries[index].data):
            members.append(at)
            at = self._after(at)
        return members

    def element(self, array: int) -> Type:
        """The type of an array's elements."""
        return self.entries[array + 1].type

    def _after(self, index: int) -> int:
        entry = self.entries[index]
        after = index + 1
        for _ in range({Type.CLUSTER: entry.data, Type.ARRAY: 1}.get(entry.type, 0)):
            after = self._after(after)
        return after


def read_rxe(source: str | Path | bytes) -> Executable:
    """The program in a file, or in its bytes; raises `InvalidProgram` for anything else."""
    data, name = (source, "the program") if isinstance(source, bytes) else (Path(source).read_bytes(), str(source))
    if not data.startswith(MAGIC):
        raise InvalidProgram(f"{name} is not a program of an NXT brick", expected="an .rxe file by nbc")
    try:
        return _read(data)
    except (struct.error, IndexError, ValueError):
        raise InvalidProgram(f"{name} is cut short or damaged", hint="compile it again") from None


def _read(data: bytes) -> Executable:
    _, count, _, static, size, dynamic, _, _, _, vectors, clumps, words = HEADER.unpack_from(data)
    at = HEADER.size
    rows = list(struct.iter_unpack("<BBH", data[at : at + 4 * count]))
    entries = tuple(TypeEntry(Type(kind), bool(flags & ZERO), address) for kind, flags, address in rows)
    at += 4 * count
    first = data[at : at + size]
    at = at + size + (at + size) % 2
    records = [struct.unpack_from("<BBH", data, at + 4 * i) for i in range(clumps)]
    at += 4 * clumps + sum(dependents for _, dependents, _ in records)
    at += at % 2
    values = tuple(_values(entries, first[:dynamic], first[dynamic:], static, vectors))
    return Executable(
        entries, values, tuple(start for *_, start in records), struct.unpack_from(f"<{words}H", data, at)
    )


def _values(
    entries: tuple[TypeEntry, ...], stored: bytes, heap: bytes, static: int, vectors: int
) -> Iterator[Value | None]:
    """First values in the order of the entries; the heap begins at address `static`, the vectors of arrays in it."""
    at, element = 0, 0
    for i, entry in enumerate(entries):
        if i < element:  # what an array is made of has no value of its own
            yield None
        elif entry.type in SCALARS:
            value, at = (0, at) if entry.zero else _scalar(stored, at, entry.type)
            yield float(value) if entry.type is Type.FLOAT else value
        elif entry.type is Type.ARRAY:
            (vector, at), element = _scalar(stored, at, Type.UWORD), i + 2
            yield _array(heap, static, vectors + 10 * int(vector), entries[i + 1].type)
        else:
            yield None


def _scalar(stored: bytes, at: int, kind: Type) -> tuple[int | float, int]:
    layout = struct.Struct("<" + kind.format)
    return layout.unpack_from(stored, at)[0], at + layout.size


def _array(heap: bytes, static: int, vector: int, kind: Type) -> Value:
    address, size, count = struct.unpack_from("<3H", heap, vector - static)
    if kind not in SCALARS:
        raise InvalidProgram("the program has arrays of arrays or of clusters", expected="arrays of numbers")
    if not count:
        return bytearray() if kind is Type.UBYTE else []
    start = address - static
    values = struct.unpack(f"<{count}{kind.format}", heap[start : start + size * count])
    return bytearray(values) if kind is Type.UBYTE else list(values)
