"""From formulas in Python to statements: numbers that record the operations on them, and the ranges of the results.

A formula of `physics` is called with what stands for its numbers, and with the tracer as its namespace of mathematics.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self

from upright.compiled.program import (
    INFINITY,
    Absolute,
    Block,
    Choose,
    Function,
    Kind,
    Limit,
    Operand,
    Product,
    Quotient,
    Repeat,
    Statement,
    Step,
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

    def _made(self, terms: Mapping[str, float], constant: float) -> Form:
        return Form(terms, constant)

    def _plus(self, sign: float, other: Form | float, other_sign: float) -> Form:
        terms = {name: sign * coefficient for name, coefficient in self.terms.items()}
        if not isinstance(other, Form):
            return self._made(terms, sign * self.constant + other_sign * other)
        for name, coefficient in other.terms.items():
            terms[name] = terms.get(name, 0.0) + other_sign * coefficient
        return self._made(terms, sign * self.constant + other_sign * other.constant)

    def __add__(self, other: Form | float) -> Form:
        return self._plus(1.0, other, 1.0)

    __radd__ = __add__

    def __sub__(self, other: Form | float) -> Form:
        return self._plus(1.0, other, -1.0)

    def __rsub__(self, other: float) -> Form:
        return self._plus(-1.0, other, 1.0)

    def __mul__(self, factor: float) -> Form:
        factor = float(factor)
        return self._made({n: factor * c for n, c in self.terms.items()} if factor else {}, factor * self.constant)

    __rmul__ = __mul__

    def __truediv__(self, below: float) -> Form:
        return self * (1.0 / below)

    def __neg__(self) -> Form:
        return self * -1.0

    @property
    def name(self) -> str:
        """Of a form that is one variable and nothing else."""
        (name,) = self.terms
        return name


class Tracer:
    """Records statements block by block, each with the unit of its result and the range that interval arithmetic proves
    for it. What depends on constants alone is computed at once."""

    def __init__(self) -> None:
        self.variables: dict[str, Variable] = {}
        self._statements: list[Statement] = []
        self._commit: list[tuple[str, str]] = []
        self._names: list[str] = []

    def called(self, *names: str) -> Self:
        """The tracer, as the namespace of a formula whose statements take these names, in order."""
        assert not self._names, f"no statement took {self._names}"
        self._names = list(names)
        return self

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
        whole = float(form.constant).is_integer() and all(c.is_integer() and self._known(n).whole for c, n in terms)
        step = Sum(name, terms, form.constant, -limit, limit)
        return self.record(step, unit, (max(low, -limit), min(high, limit)), whole=whole, output=output)

    def claim(self, name: str, value: Form, unit: str, most: float) -> Form:
        """A named sum that stays within ±most for a reason beyond interval arithmetic."""
        return self.record(Sum(name, self._kept(value), value.constant), unit, (-most, most))

    def product(self, name: str, first: Form, second: Form, unit: str, *, output: bool = False) -> Form:
        a, b = (self._known(f.name) for f in (first, second))
        corners = [x * y for x in (a.low, a.high) for y in (b.low, b.high)]
        return self.record(Product(name, first.name, second.name), unit, (min(corners), max(corners)), output=output)

    def quotient(self, name: str, number: float, below: Form, unit: str) -> Form:
        """number / below; raises `InvalidController` where the divisor may be zero."""
        under = self._known(below.name)
        if under.low <= 0 <= under.high:
            raise InvalidController(f"{name} divides by {under.name}, which may be zero", expected="a positive one")
        ends = sorted((number / under.low, number / under.high))
        return self.record(Quotient(name, number, under.name), unit, (ends[0], ends[1]))

    def limit(self, value: Form, low: float, high: float, name: str = "") -> Form:
        """`value` within [low, high]."""
        inner = self._known(value.name)
        bounds = max(low, inner.low), min(high, inner.high)
        return self.record(Limit(name, value.name, low, high), inner.unit, bounds, whole=inner.whole)

    def absolute(self, value: Form, name: str = "") -> Form:
        inner = self._known(value.name)
        least = 0.0 if inner.low <= 0 <= inner.high else min(abs(inner.low), abs(inner.high))
        return self.record(Absolute(name, value.name), inner.unit, (least, inner.most), whole=inner.whole)

    def whole(self, value: Form, name: str = "") -> Form:
        """`value` without its fraction: an output."""
        inner = self._known(value.name)
        low, high = (float(math.trunc(end)) if math.isfinite(end) else end for end in (inner.low, inner.high))
        return self.record(Whole(name, value.name), inner.unit, (low, high), whole=True, output=True)

    def choose(
        self, left: Form | float, right: Form | float, then: Form | float, other: Form | float, name: str = "",
        *, output: bool = False, whole: bool = False,
    ) -> Any:  # fmt: skip
        """`then` where left < right, else `other`."""
        if not isinstance(left, Form):
            if not isinstance(right, Form):
                return then if left < right else other
            # a statement compares a variable with what follows: left < right is not right < the number after left
            return self.choose(right, math.nextafter(left, INFINITY), other, then, name, output=output, whole=whole)
        ranges = [self._range(f.name, 1.0) if isinstance(f, Form) else (f, f) for f in (then, other)]
        bounds = min(r[0] for r in ranges), max(r[1] for r in ranges)
        units = [self._known(f.name).unit for f in (then, other) if isinstance(f, Form)]
        step = Choose(name, left.name, _operand(right), _operand(then), _operand(other))
        return self.record(step, units[0] if units else "1", bounds, whole=whole, output=output)

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
        reach = {n: abs(c) * self._known(n).most for n, c in form.terms.items()}
        least = NEGLIGIBLE * (sum(reach.values()) + abs(form.constant))
        return tuple((float(c), n) for n, c in form.terms.items() if c and not reach[n] <= least < INFINITY)

    def _range(self, name: str, coefficient: float) -> Interval:
        variable = self._known(name)
        ends = coefficient * variable.low, coefficient * variable.high
        return min(ends), max(ends)

    def _known(self, name: str) -> Variable:
        return self.variables[name]

    def record(self, step: Step, unit: str, bounds: Interval, *, whole: bool = False, output: bool = False) -> Form:
        """The result of a statement; one without a name takes the next that the formula is `called` by."""
        named = step if step.target else replace(step, target=self._names.pop(0))
        self._statements.append(named)
        return self._new(named.target, unit, bounds, Kind.OUTPUT if output else Kind.TEMPORARY, whole)

    def _new(self, name: str, unit: str, bounds: Interval, kind: Kind, whole: bool = False, start: float = 0.0) -> Form:
        assert name not in self.variables, f"{name} is recorded twice"
        self.variables[name] = Variable(name, unit, kind, bounds[0], bounds[1], whole, start)
        return Form({name: 1.0})


class Number(Form):
    """A form whose every operation is a statement at once, so that a printed text rounds as the formula does."""

    tracer: FormulaTracer

    def __init__(self, name: str, tracer: FormulaTracer) -> None:
        super().__init__({name: 1.0})
        object.__setattr__(self, "tracer", tracer)  # a form is frozen

    def _made(self, terms: Mapping[str, float], constant: float) -> Form:
        return self.tracer.let("", Form(terms, constant), "1")

    def __mul__(self, factor: Any) -> Form:
        if isinstance(factor, Number):
            return self.tracer.record(Product("", self.name, factor.name))
        return super().__mul__(factor)

    __rmul__ = __mul__

    def __truediv__(self, below: Any) -> Form:
        return self.tracer.record(Quotient("", self.name, below.name))

    def __rtruediv__(self, number: float) -> Form:
        return self.tracer.record(Quotient("", float(number), self.name))

    def __pow__(self, power: int) -> Form:
        assert power == 2, "no other power is written"
        return self.tracer.record(Function("", "square", self.name))


UNKNOWN = Variable("", "1", Kind.TEMPORARY, -INFINITY, INFINITY)


class FormulaTracer(Tracer):
    """Records a formula alone: each statement once, in order, with nothing known of ranges."""

    def __init__(self, letter: str = "t") -> None:
        super().__init__()
        self._letter = letter
        self._numbers = dict[Step, Number]()

    def number(self, name: str) -> Number:
        """What stands for the variable of that name."""
        return Number(name, self)

    def numbers(self, names: str) -> list[Number]:
        """Those of these names, between spaces."""
        return [self.number(name) for name in names.split()]

    def record(self, step: Step, *_facts: Any, **_kinds: Any) -> Number:
        return self._numbers.setdefault(step, Number(f"{self._letter}{len(self._numbers)}", self))

    def block(self, name: str, results: Mapping[str, Any] | None = None) -> Block:
        """All statements, after which each variable of `results` takes its value."""
        statements = tuple(replace(step, target=number.name) for step, number in self._numbers.items())
        return Block(name, statements, tuple((target, value.name) for target, value in (results or {}).items()))

    def _function(self, name: str, value: Form) -> Form:
        return self.record(Function("", name, value.name))

    def sin(self, angle: Form) -> Form:
        return self._function("sin", angle)

    def cos(self, angle: Form) -> Form:
        return self._function("cos", angle)

    def nearest(self, value: Form) -> Form:
        return self._function("nearest", value)

    def sqrt(self, square: Form) -> Form:
        """The root; of a square, its size, to the last bit and quicker."""
        whole = next((step for step, number in self._numbers.items() if number is square), None)
        if isinstance(whole, Function) and whole.name == "square":
            return self.record(Absolute("", whole.value))
        return self._function("sqrt", square)

    def limit(self, value: Form, low: Any, high: Any, name: str = "") -> Form:  # ends that vary, too
        return self.choose(value, low, low, self.choose(high, value, high, value), name)

    def _known(self, name: str) -> Variable:  # noqa: ARG002 (it knows as much of each)
        return UNKNOWN


def _operand(value: Form | float) -> Operand:
    return value.name if isinstance(value, Form) else float(value)
