"""The one representation of a balancing program: typed straight-line statements that every target is printed from.

A `Program` has three blocks, called once a period: `calibrate` while the robot is held still, then `command` (readings
to duty) and `update` (memory, fall detection), which comes second so that the motors wait for `command` alone. Every
variable is a number with a unit and a proven range; a state keeps its value from one period to the next, and `commit`
gives it its next value at the end of a block. There are no branches or calls: `Choose` picks one of two values. The one
loop is `Repeat`, a fixed number of times.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum

INFINITY = float("inf")


class Kind(StrEnum):
    """The role of a variable."""

    INPUT = "input"
    STATE = "state"
    OUTPUT = "output"
    TEMPORARY = "temporary"


@dataclass(frozen=True)
class Variable:
    """A number in `unit`, always within [`low`, `high`]; `whole` ones are integers. A state begins at `start`."""

    name: str
    unit: str
    kind: Kind
    low: float
    high: float
    whole: bool = False
    start: float = 0.0

    @property
    def most(self) -> float:
        """The largest magnitude."""
        return max(abs(self.low), abs(self.high))


Operand = str | float
"""A variable's name or a constant."""


@dataclass(frozen=True)
class Sum:
    """target = Σ coefficient · variable + constant, kept within [`low`, `high`] where they are finite."""

    target: str
    terms: tuple[tuple[float, str], ...]
    constant: float = 0.0
    low: float = -INFINITY
    high: float = INFINITY


@dataclass(frozen=True)
class Product:
    """target = first · second."""

    target: str
    first: str
    second: str


@dataclass(frozen=True)
class Quotient:
    """target = number / below, where `below` never comes near zero."""

    target: str
    number: Operand
    below: str


@dataclass(frozen=True)
class Limit:
    """target = value kept within [low, high]."""

    target: str
    value: str
    low: float
    high: float


@dataclass(frozen=True)
class Absolute:
    """target = |value|."""

    target: str
    value: str


@dataclass(frozen=True)
class Whole:
    """target = value without its fraction, towards zero."""

    target: str
    value: str


@dataclass(frozen=True)
class Choose:
    """target = then where left < right, else other."""

    target: str
    left: str
    right: Operand
    then: Operand
    other: Operand


@dataclass(frozen=True)
class Function:
    """target = name(value): one of `sin`, `cos`, `sqrt`, `square`, and `nearest`, the whole number, halves to the even.

    Formulas have them; no controller does, and no brick is asked for one.
    """

    target: str
    name: str
    value: str


@dataclass(frozen=True)
class Fused:
    """target = Σ sign · term + Σ sign · first · second; each product is added with one rounding, in order."""

    target: str
    terms: tuple[tuple[float, Operand], ...]
    products: tuple[tuple[float, Operand, Operand], ...] = ()


Step = Sum | Product | Quotient | Limit | Absolute | Whole | Choose | Function | Fused


@dataclass(frozen=True)
class Repeat:
    """`steps`, `count` times; each time every (variable, value) of `carry` follows, in order."""

    count: int
    steps: tuple[Step, ...]
    carry: tuple[tuple[str, str], ...]


Statement = Step | Repeat


def operands(statement: Step) -> tuple[str, ...]:
    """The variables a statement reads, in order."""
    if isinstance(statement, Sum):
        return tuple(name for _, name in statement.terms)
    if isinstance(statement, Fused):
        parts = [part for entry in (*statement.terms, *statement.products) for part in entry[1:]]
        return tuple(part for part in parts if isinstance(part, str))
    fields = {k: v for k, v in vars(statement).items() if k not in ("target", "name")}
    return tuple(value for value in fields.values() if isinstance(value, str))


@dataclass(frozen=True)
class Block:
    """`statements` in order, each target written once; then every (state, variable) of `commit` at the same time."""

    name: str
    statements: tuple[Statement, ...]
    commit: tuple[tuple[str, str], ...] = ()

    @property
    def steps(self) -> tuple[Step, ...]:
        """The statements, those of a loop once."""
        return tuple(step for s in self.statements for step in (s.steps if isinstance(s, Repeat) else (s,)))

    def reads(self) -> set[str]:
        """Every variable that a statement or a commit reads."""
        return {name for s in self.steps for name in operands(s)} | {name for _, name in self.commit}

    def writes(self) -> set[str]:
        return {s.target for s in self.steps}


@dataclass(frozen=True, kw_only=True)
class Program:
    """Three blocks over `variables`, and which robot, kit, controller (`kind`, `hash`) and target they were made for.

    `period` [s]; `channels` says which measured channel each raw input is, and `scales` its SI unit for one raw unit.
    `full` is the largest duty, 0 where the program commands in `command_unit` itself. `proven` is whether the ranges of
    the memory follow from those of the readings; if not, the memory grows without the robot and is only limited.
    The applied command enters the memory `lag` periods later, when the motors begin to act on it.
    """

    robot: str
    kit: str
    kind: str
    hash: str
    target: str
    period: float
    version: str
    command_unit: str
    full: int
    proven: bool
    lag: int
    channels: Mapping[str, str]
    scales: Mapping[str, float]
    variables: Mapping[str, Variable]
    calibrate: Block
    command: Block
    update: Block

    @property
    def blocks(self) -> tuple[Block, Block, Block]:
        return self.calibrate, self.command, self.update

    def of(self, kind: Kind) -> list[Variable]:
        """The variables of that kind, in the order of their making."""
        return [v for v in self.variables.values() if v.kind is kind]

    def carried(self) -> list[str]:
        """Temporaries of `command` that `update` reads: they live from one to the other, but not over a period."""
        both = self.update.reads() & self.command.writes()
        return [s.target for s in self.command.steps if s.target in both and not self.is_output(s.target)]

    def results(self) -> list[str]:
        """The outputs of a period in balance, in order."""
        written = (s.target for block in (self.command, self.update) for s in block.steps)
        return [name for name in written if self.is_output(name)]

    def is_output(self, name: str) -> bool:
        return self.variables[name].kind is Kind.OUTPUT

    def head(self) -> list[str]:
        """The first lines of every generated text; `firmware.head` reads them back."""
        facts = {"target": self.target, "robot": self.robot, "kit": self.kit, "controller": self.kind}
        facts |= {"hash": self.hash, "period": f"{self.period!r} s", "version": f"upright {self.version}"}
        return [f"{name}: {value}" for name, value in facts.items()]

    def operations(self) -> int:
        """Number of multiplications and divisions in one period."""
        return sum(map(_products, (*self.command.statements, *self.update.statements)))

    def __str__(self) -> str:
        lines = [f"# {line}" for line in self.head()]
        for variable in (*self.of(Kind.INPUT), *self.of(Kind.STATE)):
            lines.append(f"{variable.kind} {variable.name} [{variable.unit}] in {_range(variable)}")
        for block in self.blocks:
            lines += ["", f"{block.name}:", *(f"    {line}" for line in self._listing(block))]
        return "\n".join(lines)

    def _listing(self, block: Block) -> Iterator[str]:
        for statement in block.statements:
            if isinstance(statement, Repeat):
                yield f"{statement.count} times:"
                yield from (f"    {line}" for line in map(self._line, statement.steps))
                yield from (f"    {name} <- {value}" for name, value in statement.carry)
            else:
                yield self._line(statement)
        yield from (f"{state} <- {value}" for state, value in block.commit)

    def _line(self, step: Step) -> str:
        variable = self.variables[step.target]
        return f"{step.target} = {expression(step)}  # [{variable.unit}] in {_range(variable)}"


def expression(statement: Step) -> str:  # noqa: PLR0911 (one for each kind of statement)
    """The right side of a statement as a formula."""
    match statement:
        case Sum(_, terms, constant, low, high):
            text = " + ".join([*(f"{c!r} {name}" for c, name in terms), *([repr(constant)] if constant else [])]) or "0"
            return text if low == -INFINITY else f"limit({text}, {low!r}, {high!r})"
        case Product(_, first, second):
            return f"{first} {second}"
        case Quotient(_, number, below):
            return f"{number} / {below}"
        case Limit(_, value, low, high):
            return f"limit({value}, {low!r}, {high!r})"
        case Absolute(_, value):
            return f"|{value}|"
        case Whole(_, value):
            return f"whole({value})"
        case Choose(_, left, right, then, other):
            return f"{then} where {left} < {right} else {other}"
        case Function(_, name, value):
            return f"{name}({value})"
        case Fused(_, terms, products):
            return " + ".join(" ".join(map(str, entry)) for entry in (*terms, *products))


def _products(statement: Statement) -> int:
    if isinstance(statement, Repeat):
        return statement.count * sum(map(_products, statement.steps))
    if isinstance(statement, Sum):
        return sum(abs(c) != 1 for c, _ in statement.terms)
    return int(isinstance(statement, Product | Quotient))


def _range(variable: Variable) -> str:
    return f"[{variable.low:.6g}, {variable.high:.6g}]"
