"""From formulas in Python to statements: numbers that record the operations on them, and the ranges of the results."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from upright.compiled.program import (
    INFINITY,
    Absolute,
    Block,
    Choose,
    Kind,
    Limit,
    Operand,
    Product,
    Quotient,
    Repeat,
    Statement,
    Sum,
    Variable,
    Whole,
)
from upright.errors import InvalidController

NEGLIGIBLE = 2.0**-44
"""A term is left out where it cannot reach this fraction of its sum: designs leave rounding of about 1e-14 there."""

Interval = tuple[float, float]


@dataclass(frozen=True)
class Form:
    """Σ coefficient · variable + constant: sums and multiples of traced numbers, until they get a name."""

    terms: Mapping[str, float] = field(default_factory=dict)
    constant: float = 0.0

    def __add__(self, other: Form | float) -> Form:
        if not isinstance(other, Form):
            return Form(self.terms, self.constant + other)
        terms = dict(self.terms)
        for name, coefficient in other.terms.items():
            terms[name] = terms.get(name, 0.0) + coefficient
        return Form(terms, self.constant + other.constant)

    __radd__ = __add__

    def __mul__(self, factor: float) -> Form:
        factor = float(factor)
        return Form({n: factor * c for n, c in self.terms.items()} if factor else {}, factor * self.constant)

    __rmul__ = __mul__

    def __neg__(self) -> Form:
        return self * -1.0

    def __sub__(self, other: Form | float) -> Form:
        return self + -other

    def __rsub__(self, other: float) -> Form:
        return -self + other

    @property
    def name(self) -> str:
        """Of a form that is one variable and nothing else."""
        (name,) = self.terms
        return name


class Tracer:
    """Records statements block by block, each with the range that interval arithmetic proves for its result."""

    def __init__(self) -> None:
        self.variables: dict[str, Variable] = {}
        self._statements: list[Statement] = []
        self._commit: list[tuple[str, str]] = []

    def input(self, name: str, unit: str, most: float, whole: bool = False, low: float | None = None) -> Form:
        """A raw reading in [`low` or −most, most]: the range is what the program relies on until it is limited."""
        return self._new(name, unit, (-most if low is None else low, most), Kind.INPUT, whole)

    def state(self, name: str, unit: str, most: float, whole: bool = False, start: float = 0.0) -> Form:
        """A memory within ±most."""
        return self._new(name, unit, (-most, most), Kind.STATE, whole, start)

    def let(self, name: str, value: Form | float, unit: str, most: float = INFINITY, *, output: bool = False) -> Form:
        """A named sum, limited to ±most."""
        form = value if isinstance(value, Form) else Form({}, float(value))
        terms = self._kept(form)
        bounds = [self._range(n, c) for c, n in terms]
        low, high = form.constant + sum(b[0] for b in bounds), form.constant + sum(b[1] for b in bounds)
        limit = most if max(-low, high) > most else INFINITY
        self._statements.append(Sum(name, terms, form.constant, -limit, limit))
        whole = float(form.constant).is_integer() and all(c.is_integer() and self.variables[n].whole for c, n in terms)
        return self._new(name, unit, (max(low, -limit), min(high, limit)), _kind(output), whole)

    def claim(self, name: str, value: Form, unit: str, most: float) -> Form:
        """A named sum that stays within ±most for a reason beyond interval arithmetic."""
        self._statements.append(Sum(name, self._kept(value), value.constant))
        return self._new(name, unit, (-most, most), Kind.TEMPORARY)

    def product(self, name: str, first: Form, second: Form, unit: str, *, output: bool = False) -> Form:
        a, b = (self.variables[f.name] for f in (first, second))
        corners = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
        self._statements.append(Product(name, a.name, b.name))
        return self._new(name, unit, (min(corners), max(corners)), _kind(output))

    def quotient(self, name: str, number: float, below: Form, unit: str) -> Form:
        """number / below; raises `InvalidController` where the divisor may be zero."""
        under = self.variables[below.name]
        if under.low <= 0 <= under.high:
            raise InvalidController(f"{name} divides by {under.name}, which may be zero", expected="a positive one")
        ends = sorted((number / under.low, number / under.high))
        self._statements.append(Quotient(name, number, under.name))
        return self._new(name, unit, (ends[0], ends[1]), Kind.TEMPORARY)

    def limit(self, name: str, value: Form, low: float, high: float, unit: str) -> Form:
        inner = self.variables[value.name]
        self._statements.append(Limit(name, inner.name, low, high))
        return self._new(name, unit, (max(low, inner.low), min(high, inner.high)), Kind.TEMPORARY, inner.whole)

    def absolute(self, name: str, value: Form, unit: str) -> Form:
        inner = self.variables[value.name]
        self._statements.append(Absolute(name, inner.name))
        least = 0.0 if inner.low <= 0 <= inner.high else min(abs(inner.low), abs(inner.high))
        return self._new(name, unit, (least, inner.most), Kind.TEMPORARY, inner.whole)

    def whole(self, name: str, value: Form, unit: str) -> Form:
        inner = self.variables[value.name]
        self._statements.append(Whole(name, inner.name))
        ends = math.trunc(inner.low), math.trunc(inner.high)
        return self._new(name, unit, (float(ends[0]), float(ends[1])), Kind.OUTPUT, True)

    def choose(
        self, name: str, left: Form, right: Form | float, then: Form | float, other: Form | float, unit: str,
        *, output: bool = False, whole: bool = False,
    ) -> Form:  # fmt: skip
        """`then` where left < right, else `other`."""
        ranges = [self._range(f.name, 1.0) if isinstance(f, Form) else (f, f) for f in (then, other)]
        bounds = min(r[0] for r in ranges), max(r[1] for r in ranges)
        self._statements.append(Choose(name, left.name, _operand(right), _operand(then), _operand(other)))
        return self._new(name, unit, bounds, _kind(output), whole)

    def repeat(self, count: int, carried: Sequence[Form], body: Callable[[], Sequence[Form]]) -> None:
        """`count` times what `body` records; then each of `carried` takes, in order, the value that it returns.

        Nothing is proven of the range of what is carried.
        """
        for form in carried:
            variable = self.variables[form.name]
            self.variables[form.name] = replace(variable, low=-INFINITY, high=INFINITY, whole=False)
        before = self._statements
        self._statements = []
        carry = tuple((form.name, value.name) for form, value in zip(carried, body(), strict=True))
        steps = tuple(s for s in self._statements if not isinstance(s, Repeat))
        assert len(steps) == len(self._statements), "a loop in a loop"
        self._statements = [*before, Repeat(count, steps, carry)]

    def commit(self, state: Form, value: Form) -> None:
        """The state's next value, checked against the state's range."""
        inner, outer = self.variables[value.name], self.variables[state.name]
        assert inner.kind is not Kind.STATE, f"{outer.name} would take {inner.name} before or after its own change"
        if inner.low < outer.low or inner.high > outer.high:
            raise InvalidController(
                f"{inner.name} reaches {inner.most:g} {inner.unit}", expected=f"at most {outer.most:g} in {outer.name}"
            )
        self._commit.append((outer.name, inner.name))

    def block(self, name: str) -> Block:
        """The statements since the last block."""
        block = Block(name, tuple(self._statements), tuple(self._commit))
        self._statements, self._commit = [], []
        return block

    def _kept(self, form: Form) -> tuple[tuple[float, str], ...]:
        reach = {n: abs(c) * self.variables[n].most for n, c in form.terms.items()}
        least = NEGLIGIBLE * (sum(reach.values()) + abs(form.constant))
        return tuple((float(c), n) for n, c in form.terms.items() if c and not reach[n] <= least < INFINITY)

    def _range(self, name: str, coefficient: float) -> Interval:
        variable = self.variables[name]
        ends = coefficient * variable.low, coefficient * variable.high
        return min(ends), max(ends)

    def _new(self, name: str, unit: str, bounds: Interval, kind: Kind, whole: bool = False, start: float = 0.0) -> Form:
        assert name not in self.variables, f"{name} is recorded twice"
        self.variables[name] = Variable(name, unit, kind, bounds[0], bounds[1], whole, start)
        return Form({name: 1.0})


def _kind(output: bool) -> Kind:
    return Kind.OUTPUT if output else Kind.TEMPORARY


def _operand(value: Form | float) -> Operand:
    return value.name if isinstance(value, Form) else float(value)
