"""Numba's compiler as the kernel uses it: what every compiled function shares.

Products that are added are written `fma(a, b, c)`, rounded once, and no flag lets the compiler change an order of
arithmetic: a lane of a vector of any width, a robot alone and another machine give the same bits.
"""
# ruff: noqa: ARG001 (Numba calls an intrinsic with more than it may need)

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import Any, NamedTuple

from upright.compiled.generated import ROW

numba: Any = import_module("numba")  # compiled and untyped, like what follows: `Any` says so to the type checker
ir: Any = import_module("llvmlite.ir")
types: Any = numba.types
intrinsic: Any = numba.extending.intrinsic
overload: Any = numba.extending.overload

njit: Any = partial(
    numba.njit, nogil=True, error_model="numpy", boundscheck=False, no_cpython_wrapper=True, no_cfunc_wrapper=True
)
"""A function for other compiled functions alone, which divides as IEEE says."""

inlined: Any = partial(njit, forceinline=True)
"""The same, put into its callers, where it is vectorised across robots."""

taken: Any = numba.extending.register_jitable(**inlined.keywords)
"""The same of a function that plain Python calls too."""


class RobotBlock(NamedTuple):
    """The rows `w` of so many `robots`, the first of which is number `first` of the batch's `index`."""

    w: Any
    robots: int
    index: Any
    first: int


def _same(a: Any, *others: Any) -> Any:
    return a(a, *[a] * len(others)) if isinstance(a, types.Float) else None


def _code(emit: Callable[[Any, Any], Any]) -> Callable[[Any, Any, Any, Any], Any]:
    """What Numba wants of an intrinsic, from a function of the LLVM builder and the arguments alone."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        result = emit(builder, args)
        return context.get_dummy_value() if signature.return_type == types.void else result

    return codegen


def _call(name: str) -> Callable[[Any, Any, Any, Any], Any]:
    def emit(builder: Any, args: Any) -> Any:
        kind = args[0].type
        function = builder.module.declare_intrinsic(name, [kind], ir.FunctionType(kind, [kind] * len(args)))
        return builder.call(function, args)

    return _code(emit)


def _address(context: Any, builder: Any, kind: Any, array: Any) -> Any:
    return array if isinstance(kind, types.CPointer) else context.make_array(kind)(context, builder, array).data


@intrinsic
def fma(typingctx: Any, a: Any, b: Any, c: Any) -> Any:
    """a·b + c, rounded once."""
    return _same(a, b, c), _call("llvm.fma")


@intrinsic
def sqrt(typingctx: Any, a: Any) -> Any:
    """√a."""
    return _same(a), _call("llvm.sqrt")


@intrinsic
def rint(typingctx: Any, a: Any) -> Any:
    """The nearest whole number, halves to the even one as Python's `round`."""
    return _same(a), _call("llvm.rint")


@intrinsic
def absolute(typingctx: Any, a: Any) -> Any:
    """|a|."""
    return _same(a), _call("llvm.fabs")


@intrinsic
def bits(typingctx: Any, a: Any) -> Any:
    """The 64 bits of a double as a whole number."""

    def emit(builder: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.IntType(64))

    return types.int64(types.float64), _code(emit)


@intrinsic
def from_bits(typingctx: Any, a: Any) -> Any:
    """The double of these 64 bits."""

    def emit(builder: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.DoubleType())

    return types.float64(types.int64), _code(emit)


@intrinsic
def align_stack(typingctx: Any) -> Any:
    """Has the caller's stack start at a cache line, so that no vector register is kept across two lines."""

    def emit(builder: Any, args: Any) -> Any:
        with builder.goto_entry_block():
            place = builder.alloca(ir.IntType(8))
        place.align = 64
        kind = ir.FunctionType(ir.VoidType(), [place.type])
        builder.asm(kind, "", "r", [place], side_effect=True)  # no instruction, but the place must exist

    return types.void(), _code(emit)


@intrinsic
def item(typingctx: Any, array: Any, place: Any) -> Any:
    """array[place] of an array or an address, for a place that is not negative, which spares the test that keeps loops
    from being vectorised."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.load(builder.gep(_address(context, builder, array, args[0]), [args[1]], inbounds=True))

    return array.dtype(array, types.int64), codegen


@intrinsic
def store(typingctx: Any, array: Any, place: Any, value: Any) -> Any:
    """array[place] = value, likewise."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        builder.store(args[2], builder.gep(_address(context, builder, array, args[0]), [args[1]], inbounds=True))
        return context.get_dummy_value()

    return types.void(array, types.int64, array.dtype), codegen


def _lane(builder: Any, block: Any, row: Any, lane: Any) -> Any:
    place = builder.add(builder.mul(row, ir.Constant(row.type, ROW)), lane)
    return builder.gep(block, [place], inbounds=True)


@intrinsic
def get(typingctx: Any, block: Any, row: Any, lane: Any) -> Any:
    """The number of robot `lane` in a row of a block."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.load(_lane(builder, _address(context, builder, block, args[0]), *args[1:]))

    return block.dtype(block, types.int64, types.int64), codegen


@intrinsic
def put(typingctx: Any, block: Any, row: Any, lane: Any, value: Any) -> Any:
    """Writes it."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        builder.store(args[3], _lane(builder, _address(context, builder, block, args[0]), *args[1:3]))
        return context.get_dummy_value()

    return types.void(block, types.int64, types.int64, block.dtype), codegen


def _far_call(array: Any) -> Callable[[Any, Any, Any, Any], Any]:
    """Calls the function whose address comes first with the array's address and what follows it."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        given = [_address(context, builder, array, args[1]), *args[2:]]
        kind = ir.FunctionType(ir.VoidType(), [value.type for value in given])
        builder.call(builder.inttoptr(args[0], kind.as_pointer()), given)
        return context.get_dummy_value()

    return codegen


@intrinsic
def call_to_move(typingctx: Any, address: Any, w: Any, count: Any, fallen: Any, now: Any) -> Any:
    """Calls the compiled `advance_…` at `address`."""
    return types.void(types.int64, w, types.int64, w.dtype, w.dtype), _far_call(w)


@intrinsic
def call_on_block(typingctx: Any, address: Any, w: Any, count: Any, out: Any) -> Any:
    """Calls the compiled `specific_force_…` at `address`."""
    return types.void(types.int64, w, types.int64, types.int64), _far_call(w)


@intrinsic
def call_program(typingctx: Any, address: Any, w: Any, count: Any, first: Any, constants: Any) -> Any:
    """Calls a controller's compiled block, whose own rows begin at `first`."""
    return types.void(types.int64, w, types.int64, types.int64, constants), _far_call(w)


@intrinsic
def row_of(typingctx: Any, block: Any, row: Any) -> Any:
    """The address of a row of a block."""

    def codegen(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return _lane(builder, args[0], args[1], ir.Constant(args[1].type, 0))

    return block(block, types.int64), codegen
