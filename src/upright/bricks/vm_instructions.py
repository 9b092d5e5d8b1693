"""What each instruction of the brick does: a maker for each number, called once where the instruction stands.

Source: LEGO, "MINDSTORMS NXT Executable File Specification" 2.0, and the listings of nbc for what firmware 1.28 adds.
"""

from __future__ import annotations

import math
import operator
import struct
from collections.abc import Callable, Sequence
from typing import Any

from upright.bricks.processor import Processor, copied, holder
from upright.bricks.rxe import SCALARS, Code, InvalidProgram, Type

Step = Callable[[], int | None]
"""Does one instruction; where it returns a word's number, the program goes on there."""
Maker = Callable[[Processor, Code], Step]

END = -1
COMPARE = (operator.lt, operator.gt, operator.le, operator.ge, operator.eq, operator.ne)


def signed(word: int) -> int:
    return word - 0x10000 if word & 0x8000 else word


def _binary(operation: Callable[[Any, Any], Any]) -> Maker:
    def make(m: Processor, code: Code) -> Step:
        target, a, b = code.args
        cells = m.cells
        store = m.store(target)
        return lambda: store(operation(cells[a], cells[b]))

    return make


def _unary(operation: Callable[[Any], Any]) -> Maker:
    def make(m: Processor, code: Code) -> Step:
        cells = m.cells
        store = m.store(code.args[0])
        source = code.args[1]
        return lambda: store(operation(cells[source]))

    return make


def _compare(m: Processor, code: Code) -> Step:
    return _binary(COMPARE[code.condition])(m, code)


def _test(m: Processor, code: Code) -> Step:
    compare = COMPARE[code.condition]
    return _unary(lambda a: compare(a, 0))(m, code)


def _branch_compare(m: Processor, code: Code) -> Step:
    cells = m.cells
    compare = COMPARE[code.condition]
    there = code.at + signed(code.args[0])
    a, b = code.args[1:]
    return lambda: there if compare(cells[a], cells[b]) else None


def _branch_test(m: Processor, code: Code) -> Step:
    cells = m.cells
    compare = COMPARE[code.condition]
    there = code.at + signed(code.args[0])
    return lambda: there if compare(cells[code.args[1]], 0) else None


def _jump(_: Processor, code: Code) -> Step:
    there = code.at + signed(code.args[0])
    return lambda: there


def _subcall(m: Processor, code: Code) -> Step:
    clump, back = code.args
    there = m.program.clumps[clump]
    after = code.at + code.length
    returns = m.returns

    def step() -> int:
        returns[back] = after
        return there

    return step


def _subreturn(m: Processor, code: Code) -> Step:
    return lambda: m.returns[code.args[0]]


def _end(_m: Processor, _code: Code) -> Step:
    return lambda: END


def _nothing(_m: Processor, _code: Code) -> Step:
    return lambda: None


def _move(m: Processor, code: Code) -> Step:
    target, source = code.args
    cells = m.cells
    kind = m.program.entries[target].type
    if kind is Type.ARRAY:
        return lambda: cells.__setitem__(target, copied(cells[source]))
    if kind is Type.CLUSTER:
        pairs = zip(m.program.members(target), m.program.members(source), strict=True)
        return _all([_move(m, Code(code.number, pair)) for pair in pairs])
    return _unary(_same)(m, code)


def _set(m: Processor, code: Code) -> Step:
    store = m.store(code.args[0])
    value = signed(code.args[1])
    return lambda: store(value)


def _index(m: Processor, code: Code) -> Step:
    target, source, place = code.args
    cells = m.cells
    store = m.store(target)
    where = m.number(place)

    def step() -> None:
        values: Any = cells[source]
        store(values[_inside(values, where())])

    return step


def _replace(m: Processor, code: Code) -> Step:
    target, source, place, value = code.args
    cells = m.cells
    where = m.number(place)
    hold = holder(m.program.element(target))

    def step() -> None:
        if target != source:
            cells[target] = copied(cells[source])
        values: Any = cells[target]
        values[_inside(values, where())] = hold(cells[value])

    return step


def _array(m: Processor, target: int, make: Callable[[], Sequence[Any]]) -> Step:
    cells = m.cells
    kind = m.program.element(target)
    hold = holder(kind)

    def step() -> None:
        values = [hold(x) for x in make()]
        cells[target] = bytearray(values) if kind is Type.UBYTE else values

    return step


def _array_init(m: Processor, code: Code) -> Step:
    cells = m.cells
    count = m.number(code.args[2])
    return _array(m, code.args[0], lambda: [cells[code.args[1]]] * int(count()))


def _array_build(m: Processor, code: Code) -> Step:
    cells = m.cells
    return _array(m, code.args[0], lambda: [x for a in code.args[1:] for x in _several(cells[a])])


def _string_join(m: Processor, code: Code) -> Step:
    cells = m.cells
    return lambda: cells.__setitem__(code.args[0], bytearray(b"".join(_text(cells[a]) for a in code.args[1:]) + b"\0"))


def _subset(m: Processor, code: Code) -> Step:
    cells = m.cells
    first = m.number(code.args[2])
    count = m.number(code.args[3], 0xFFFF)
    return _array(m, code.args[0], lambda: cells[code.args[1]][first() : first() + count()])  # type: ignore[index]


def _size(m: Processor, code: Code) -> Step:
    cells = m.cells
    store = m.store(code.args[0])
    return lambda: store(len(cells[code.args[1]]))  # type: ignore[arg-type]


def _flatten(m: Processor, code: Code) -> Step:
    cells = m.cells
    target = code.args[0]
    leaves = m.leaves(code.args[1])
    kinds = [m.program.entries[leaf].type for leaf in leaves]
    if not SCALARS.issuperset(kinds):
        raise InvalidProgram("an array is written as bytes", expected="numbers")
    layout = struct.Struct("<" + "".join(kind.format for kind in kinds))
    return lambda: cells.__setitem__(target, bytearray(layout.pack(*(cells[i] for i in leaves)) + b"\0"))


def _unflatten(m: Processor, code: Code) -> Step:
    target, failed, source, _ = code.args
    layout = struct.Struct("<" + m.program.entries[target].type.format)
    cells = m.cells
    store = m.store(target)
    fail = m.store(failed)

    def step() -> None:
        data = bytes(cells[source])  # type: ignore[arg-type]
        fail(len(data) < layout.size)
        if len(data) >= layout.size:
            store(layout.unpack_from(data)[0])

    return step


def _converted(conversion: Callable[[Any], bytes]) -> Maker:
    """Stores bytes made from one variable."""

    def make(m: Processor, code: Code) -> Step:
        cells, (target, source) = m.cells, code.args
        return lambda: cells.__setitem__(target, bytearray(conversion(cells[source])))

    return make


def _get_input(m: Processor, code: Code) -> Step:
    store, port = m.store(code.args[0]), m.number(code.args[1])
    return lambda: store(m.now().get_input(port(), code.args[2]))


def _set_input(m: Processor, code: Code) -> Step:
    value, port = m.number(code.args[0]), m.number(code.args[1])
    return lambda: m.now().set_input(port(), code.args[2], value())


def _get_output(m: Processor, code: Code) -> Step:
    store, port = m.store(code.args[0]), m.number(code.args[1])
    return lambda: store(m.now().get_output(port(), code.args[2]))


def _set_output(m: Processor, code: Code) -> Step:
    cells = m.cells
    settings = [(item, m.number(value)) for item, value in zip(code.args[1::2], code.args[2::2], strict=True)]
    return lambda: m.now().set_output(_several(cells[code.args[0]]), [(item, read()) for item, read in settings])


def _system_call(m: Processor, code: Code) -> Step:
    cells = m.cells
    number = code.args[0]
    leaves = m.leaves(code.args[1])
    holds = [None if m.program.entries[i].type is Type.ARRAY else holder(m.program.entries[i].type) for i in leaves]

    def step() -> None:
        values = [cells[i] for i in leaves]
        m.now().call(number, values)
        for i, hold, value in zip(leaves, holds, values, strict=True):
            cells[i] = value if hold is None else hold(value)

    return step


def _tick(m: Processor, code: Code) -> Step:
    store = m.store(code.args[0])
    return lambda: store(m.time // 1000)


def _wait(m: Processor, code: Code) -> Step:
    value = m.number(code.args[0])
    return lambda: m.sleep(value())


def _wait_short(m: Processor, code: Code) -> Step:
    return lambda: m.sleep(code.args[0])


def _divide(a: Any, b: Any) -> Any:
    if b == 0:
        raise InvalidProgram(f"the program divides {a} by zero")
    if isinstance(a, float) or isinstance(b, float):
        return a / b
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)


def _remainder(a: Any, b: Any) -> Any:
    if b == 0:
        raise InvalidProgram(f"the program divides {a} by zero")
    return math.fmod(a, b) if isinstance(a, float) or isinstance(b, float) else a - b * _divide(a, b)


def _inside(values: Any, index: Any) -> int:
    if not 0 <= index < len(values):
        raise InvalidProgram(f"the program reaches for element {index} of {len(values)}")
    return int(index)


def _several(value: Any) -> Sequence[Any]:
    return value if isinstance(value, bytearray | list) else [value]


def _text(value: Any) -> bytes:
    return bytes(value).removesuffix(b"\0")


def _same(value: Any) -> Any:
    return value


def _all(steps: Sequence[Step]) -> Step:
    def step() -> None:
        for one in steps:
            one()

    return step


INSTRUCTIONS: dict[int, Maker] = {
    0x00: _binary(operator.add), 0x01: _binary(operator.sub), 0x02: _unary(operator.neg), 0x03: _binary(operator.mul),
    0x04: _binary(_divide), 0x05: _binary(_remainder), 0x06: _binary(operator.and_), 0x07: _binary(operator.or_),
    0x08: _binary(operator.xor), 0x09: _unary(operator.not_), 0x0A: _unary(operator.invert),
    0x0B: _binary(operator.lshift), 0x0C: _binary(lambda a, b: (a & 0xFFFFFFFF) >> b), 0x0D: _binary(operator.lshift),
    0x0E: _binary(operator.rshift), 0x11: _compare, 0x12: _test, 0x15: _index, 0x16: _replace, 0x17: _size,
    0x18: _array_build, 0x19: _subset, 0x1A: _array_init, 0x1B: _move, 0x1C: _set, 0x1D: _flatten, 0x1E: _unflatten,
    0x1F: _converted(lambda x: f"{x:g}".encode() + b"\0"), 0x21: _string_join, 0x23: _converted(_text),
    0x24: _converted(lambda x: bytes(x) + b"\0"), 0x25: _jump, 0x26: _branch_compare,
    0x27: _branch_test, 0x28: _system_call, 0x29: _end, 0x2A: _end, 0x2B: _end, 0x2C: _nothing, 0x2D: _nothing,
    0x2E: _subcall, 0x2F: _subreturn, 0x30: _set_input, 0x31: _set_output, 0x32: _get_input, 0x33: _get_output,
    0x34: _wait, 0x35: _tick, 0x36: _unary(math.sqrt), 0x37: _unary(abs), 0x64: _wait_short, 0x65: _wait,
    0x66: _unary(lambda a: (a > 0) - (a < 0)), 0x6F: _unary(math.ceil), 0x71: _unary(math.floor),
    0x7A: _unary(math.trunc), 0x7B: _unary(lambda a: math.modf(a)[0]),
}  # fmt: skip
"""Number → what makes the step; the enhanced firmware's own begin at 0x36."""
