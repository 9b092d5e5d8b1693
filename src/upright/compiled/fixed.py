"""Fixed point: where the binary point of each variable stands, and how far rounding can carry a command.

A word has 32 bits and a sum 64. Inputs and outputs are Q16.16 wherever their range allows it and integers where they
are whole; inside, each variable keeps as many bits of fraction as its proven range leaves, and each coefficient as many
as its sum leaves. No sum and no product can overflow: that follows from the ranges alone, by interval arithmetic.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array
from upright.compiled.program import (
    Absolute,
    Choose,
    Kind,
    Limit,
    Program,
    Step,
    Sum,
    Variable,
    operands,
)
from upright.errors import InvalidController
from upright.physics.linear import impulse_norm

WORD, WIDE = 31, 62  # bits of magnitude in a word, and in a sum with its rounding
INTERFACE = 16  # bits of fraction of inputs and outputs
FINEST = 30


@dataclass(frozen=True)
class Scaled:
    """A sum in integers: Σ factor · word + constant, then `shift` bits to the right."""

    terms: tuple[tuple[int, str], ...]
    constant: int
    shift: int


def fractions(program: Program) -> dict[str, int]:
    """Bits of fraction of every variable; raises `InvalidController` for one that no word holds."""
    if not program.proven:
        raise InvalidController(
            f"nothing is proven of the numbers inside this {program.kind}", expected="a proven range",
            hint="use --number float",
        )  # fmt: skip
    bits = {v.name: _own(v) for v in program.variables.values()}
    for block in program.blocks:
        for statement in block.steps:
            variable = program.variables[statement.target]
            if variable.kind is Kind.TEMPORARY and not variable.whole:
                bits[variable.name] = min(bits[variable.name], _inherited(statement, bits))
    return bits


def _own(variable: Variable) -> int:
    """From the range: the rest of the word, or `INTERFACE` for inputs and outputs."""
    if not variable.most < 2.0**WORD - 1:
        raise InvalidController(
            f"{variable.name} reaches {variable.most:.3g} {variable.unit}", expected="less than 2³¹ for fixed point",
            hint="use --number float",
        )  # fmt: skip
    if variable.whole:
        return 0
    left = WORD - 1 - max(0, math.ceil(math.log2(max(variable.most, 2.0**-20) * (1 + 1e-9))))
    return min(left, INTERFACE if variable.kind in (Kind.INPUT, Kind.OUTPUT) else FINEST)


def _inherited(statement: Step, bits: Mapping[str, int]) -> int:
    """A statement that only selects or mirrors a word keeps its format."""
    if isinstance(statement, Limit | Absolute):
        return bits[statement.value]
    if isinstance(statement, Choose):
        return min((bits[o] for o in (statement.then, statement.other) if isinstance(o, str)), default=FINEST)
    return FINEST


def scaled(statement: Sum, program: Program, bits: Mapping[str, int]) -> Scaled:
    """The finest integer form of a sum whose every partial sum stays within 62 bits."""
    words = {n: math.ceil(program.variables[n].most * 2.0 ** bits[n]) + 1 for _, n in statement.terms}
    target = bits[statement.target]
    for fraction in range(WIDE, target - 1, -1):
        factors = [round(c * 2.0 ** (fraction - bits[n])) for c, n in statement.terms]
        constant = round(statement.constant * 2.0**fraction)
        total = sum(abs(f) * words[n] for f, (_, n) in zip(factors, statement.terms, strict=True)) + abs(constant)
        fine = all(fraction >= bits[n] for _, n in statement.terms)
        if fine and total < 2**WIDE and all(abs(f) < 2**WORD for f in factors):
            pairs = tuple((f, n) for f, (_, n) in zip(factors, statement.terms, strict=True) if f)
            return _reduced(pairs, constant, fraction - target)
    raise InvalidController(
        f"the sum {statement.target} does not fit 64 bits", expected="smaller ranges", hint="use --number float"
    )


def _reduced(terms: tuple[tuple[int, str], ...], constant: int, shift: int) -> Scaled:
    """Without the powers of two that all factors share, so that integers stay small."""
    common = math.gcd(constant, *(f for f, _ in terms))
    spare = min(shift, (common & -common).bit_length() - 1) if common else shift
    return Scaled(tuple((f >> spare, n) for f, n in terms), constant >> spare, shift - spare)


def quantum(program: Program) -> float:
    """What fixed point may add to a command at worst, in the command's unit, with the design given the same words:
    rounding of every sum and coefficient, carried through the memory by the l1 norm of its impulse response."""
    places = fractions(program)
    names, inner, A = memory(program)
    errors = _reading_errors(program, places)
    rows = {s.target: s for s in program.update.steps if isinstance(s, Sum)}
    made = np.array([_row_error(rows[f"next_{w}"], program, places, errors) for w in names])
    for name, grown in zip(inner, (impulse_norm(A, np.eye(len(A))) @ made).tolist(), strict=True):
        errors[name] += grown
    outputs = [s for s in program.command.steps if isinstance(s, Sum)]
    after = {s.target: _row_error(s, program, places, errors) for s in outputs if s.target not in inner}
    return max(error for name, error in after.items() if name.startswith("command_"))


def memory(program: Program) -> tuple[list[str], list[str], Array]:
    """The controller's states, the variables that its rows read for them, and their matrix (n, n) over one period."""
    names = [v.name for v in program.of(Kind.STATE) if v.name[0] == "w" and v.name[1:].isdigit()]
    rows = {s.target: s for s in program.update.steps if isinstance(s, Sum)}
    inner = [f"z{name[1:]}" if f"z{name[1:]}" in program.variables else name for name in names]
    A = np.array([[_coefficient(rows[f"next_{w}"], z) for z in inner] for w in names])
    return names, inner, A.reshape(len(names), len(names))


def _coefficient(row: Sum, name: str) -> float:
    return next((c for c, n in row.terms if n == name), 0.0)


def _reading_errors(program: Program, bits: Mapping[str, int]) -> dict[str, float]:
    """The rounding error of each variable in one period that begins with an exact memory."""
    errors = {v.name: 0.0 for v in (*program.of(Kind.INPUT), *program.of(Kind.STATE))}
    errors["gyro_offset"] = 2.0 ** -bits["gyro_offset"]
    for statement in program.command.steps:
        target = statement.target
        if isinstance(statement, Sum):
            errors[target] = _row_error(statement, program, bits, errors)
        elif isinstance(statement, Limit | Absolute | Choose):
            carried = max((errors[name] for name in operands(statement)), default=0.0)
            kept = isinstance(statement, Limit) and bits[statement.value] == bits[target]
            errors[target] = carried + (0.0 if kept else 2.0 ** -bits[target])
        else:
            errors[target] = 0.0  # from here on the design gets the program's own numbers
    return errors


def _row_error(row: Sum, program: Program, bits: Mapping[str, int], errors: Mapping[str, float]) -> float:
    """The error of one sum: its rounding, that of its coefficients over the whole ranges, and its operands' errors."""
    form = scaled(row, program, bits)
    fraction = form.shift + bits[row.target]
    factors = {n: f for f, n in form.terms}
    total = 2.0 ** -(bits[row.target] + 1) if form.shift else 0.0
    for coefficient, name in row.terms:
        off = abs(factors.get(name, 0) * 2.0 ** (bits[name] - fraction) - coefficient)
        total += off * program.variables[name].most + abs(coefficient) * errors[name]
    return total
