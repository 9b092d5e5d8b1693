"""The third part of the trace: the accelerations and the step of Runge and Kutta, as source text for the kernel.

A step is written twice, with the same arithmetic. `step_…` moves one robot and keeps everything in registers.
`advance_…` moves a block by one loop for each stage, with the accelerations between them in rows of the block: a loop
over a whole step is so long that a processor cannot look ahead to the next robots while it waits for its results.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp

from upright.compiled.trace import ROWS, STAGE, Maths, trace
from upright.compiled.trace_print import (
    COS_SLOPE,
    HELD,
    PITCH,
    PITCH_RATE,
    SIN_SLOPE,
    SLIP_LEFT,
    SLIP_RIGHT,
    STATE,
    WHEEL_RATE,
    YAW,
    YAW_RATE,
    P,
    Printer,
    factored,
    function,
)
from upright.physics.sensing import accelerometer

VARIANTS = {"smooth": (False, False), "coulomb": (True, False), "slope": (False, True), "coulomb_slope": (True, True)}
"""Name → whether with Coulomb friction and whether on a floor that may slope."""

IMPORTS = """from upright.compiled.generated import WORK
from upright.compiled.jit import absolute, align_stack, fma, get, inlined, mul, positive, put, reciprocal, sqrt
from upright.compiled.lane_math import sincos, sincos_any"""

_ANGLES = ("pitch", "wheel", "yaw")


def motions() -> list[str]:
    """The parts of `generated_motion.py`."""
    return [IMPORTS, *(text for name, variant in VARIANTS.items() for text in _functions(name, *variant))]


def work_rows() -> int:
    """Rows of a block that `advance_…` needs between its loops."""
    return max(len(_Work(name, *variant).rows) for name, variant in VARIANTS.items())


def _functions(name: str, coulomb: bool, slope: bool) -> list[str]:
    work = _Work(name, coulomb, slope)
    return [*work.accelerations(), work.step(), work.advance(), work.specific_force()]


class _Work:
    """The source texts of one variant, whose `held` values are the same in all stages of a step."""

    def __init__(self, name: str, coulomb: bool, slope: bool) -> None:
        self.name, self.slope = name, slope
        self._moving = ("pitch", "yaw") if slope else ("pitch",)
        self._held_lines, self._lines, self._result = _parted(_acceleration_lines(coulomb=coulomb, slope=slope))
        self._constants = _used([*self._lines, self._result], trace().constants)
        self._held_constants = _used(self._held_lines, trace().constants)
        self.held = _used([*self._lines, self._result], [line.split(" = ")[0] for line in self._held_lines])
        accelerations = [f"{angle}_acc{k}" for k in (1, 2, 3) for angle in _ANGLES]
        rates = [f"{angle}_rate{k}" for k in (2, 3) for angle in self._moving]
        self._stages = [*accelerations, *rates]
        self.rows = {name: f"WORK + {row}" for row, name in enumerate([*self._stages, *self.held])}

    def accelerations(self) -> list[str]:
        """What is held over a step, the accelerations from it, and both in one."""
        held, constants = f"{', '.join(self.held)}", list(trace().constants)
        one = [*map(str, HELD), *self._held_constants]
        two = [*STAGE, *self.held, *self._constants]
        both = [f"{held} = held_{self.name}({', '.join(one)})", f"return moved_{self.name}({', '.join(two)})"]
        all_ = [*STAGE, *map(str, HELD), *constants]
        return [
            function(f"held_{self.name}({', '.join(one)})", [*self._held_lines, f"return {held}"]),
            function(f"moved_{self.name}({', '.join(two)})", [*self._lines, self._result]),
            function(f"accelerations_{self.name}({', '.join(all_)})", both),
        ]

    def step(self) -> str:
        """The one robot of a block by one step."""
        lines = [self._hold(), *(line for k in (1, 2, 3, 4) for line in self._stage(k, recall=False)), *_sums()]
        lines = [*self._load([*lines, *_STORE]), *lines, *_STORE]
        body = ["i = 0", *lines]
        return function(f"step_{self.name}(w, count, fallen, now)", body, None)

    def advance(self) -> str:
        """All robots of a block by one step; one whose pitch leaves ±fallen gets a step of zero from then on."""
        lines = ["align_stack()"]
        for k in (1, 2, 3, 4):
            stage = [*([self._hold()] if k == 1 else []), *self._stage(k, recall=True), *(_sums() if k == 4 else [])]
            kept = [*(n for n in self._stages if n.endswith(str(k))), *(self.held if k == 1 else [])]
            stage += _STORE if k == 4 else [f"put(w, {self.rows[name]}, i, {name})" for name in kept]
            lines += ["for i in range(count):", *(f"    {line}" for line in [*self._load(stage), *stage])]
        return function(f"advance_{self.name}(w, count, fallen, now)", lines, None)

    def specific_force(self) -> str:
        """Rows `out` and `out` + 1: what an accelerometer at the axle reads, in motion under what is held."""
        tilt = sp.Symbol("slope", real=True)
        x = (PITCH, PITCH_RATE, sp.Symbol("wheel"), WHEEL_RATE, YAW, YAW_RATE)
        forces = accelerometer(x, sp.Symbol("wheel_acc", real=True), P, tilt, Maths(tilt))
        known = {P.wheel_radius: sp.Symbol("c1"), P.gravity: sp.Symbol("c2")}
        forward, up = (_shorter(sp.expand(f.xreplace(known)), coulomb=False, slope=self.slope) for f in forces)
        printer = Printer()
        results = [printer.value(factored(forward)), printer.value(factored(up))]
        arguments = ", ".join([*STAGE, *self.held, *self._constants])
        body = [
            self._hold(),
            f"_, wheel_acc, _ = moved_{self.name}({arguments})",
            "s, c = sincos(pitch)",
            *(["sin_yaw, cos_yaw = sincos_any(yaw)"] if self.slope else []),
            *printer.lines,
            *(f"put(w, out + {k}, i, {result})" for k, result in enumerate(results)),
        ]
        lines = ["for i in range(count):"]
        lines += [f"    {line}" for line in [*self._load(body), *body]]
        return function(f"specific_force_{self.name}(w, count, out)", lines, None)

    def _hold(self) -> str:
        return f"{', '.join(self.held)} = held_{self.name}({', '.join([*map(str, HELD), *self._held_constants])})"

    def _stage(self, k: int, *, recall: bool) -> list[str]:
        """The accelerations of stage `k` from those before it. With `recall` no line of another stage is at hand."""
        if k == 1:
            return [self._moved(1, {})]
        step = "h" if k == 4 else "half"
        lines = ["half = mul(h, 0.5)"] if k == 2 or (recall and k == 3) else []
        for n in _ANGLES:
            if n in self._moving:
                lines.append(f"{n}{k} = fma({step}, {n}_rate{k - 1 if k > 2 else ''}, {n})")
            lines.append(f"{n}_rate{k} = fma({step}, {n}_acc{k - 1}, {n}_rate)")
        return [*lines, self._moved(k, {n: f"{n}{k}" for n in (*self._moving, *(f"{n}_rate" for n in _ANGLES))})]

    def _moved(self, k: int, at: dict[str, str]) -> str:
        found = ", ".join(f"{angle}_acc{k}" for angle in _ANGLES)
        arguments = [*(at.get(name, name) for name in STAGE), *self.held, *self._constants]
        return f"{found} = moved_{self.name}({', '.join(arguments)})"

    def _load(self, lines: Sequence[str]) -> list[str]:
        """Loads of the rows that `lines` need and do not make themselves."""
        places = {name: str(row) for row, name in enumerate([*ROWS, *trace().constants])}
        places |= self.rows
        made = {name for line in lines for name in line.split(" = ")[0].split(", ")}
        return [f"{name} = get(w, {places[name]}, i)" for name in _used(lines, places) if name not in made]


def _sums() -> list[str]:
    """From the four stages to the state one step on (Nyström's form of the classical method)."""
    lines = ["sixth = mul(h, 1 / 6)"]
    for n in _ANGLES:
        lines.append(f"{n}_middle = {n}_acc2 + {n}_acc3")
        lines.append(f"{n}_sum = {n}_acc1 + {n}_middle")
        lines.append(f"new_{n} = fma(h, fma(sixth, {n}_sum, {n}_rate), {n})")
        lines.append(f"new_{n}_rate = fma(sixth, ({n}_sum + {n}_middle) + {n}_acc4, {n}_rate)")
    return lines


_STORE = [
    *(f"put(w, {row}, i, new_{name})" for row, name in enumerate(ROWS[:6])),
    f"put(w, {ROWS.index('lived')}, i, now if positive(h) else lived)",
    f"put(w, {ROWS.index('h')}, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))",
]


def _words(lines: Iterable[str]) -> set[str]:
    return {word for line in lines for word in re.findall(r"[A-Za-z_]\w*", line)}


def _used(lines: Iterable[str], names: Iterable[str]) -> list[str]:
    words = _words(lines)
    return [name for name in names if name in words]


def _parted(lines: Sequence[str]) -> tuple[list[str], list[str], str]:
    """Lines that need nothing but what is held and constants, the other lines, and the one that returns."""
    known = {*map(str, HELD), *trace().constants, "fma"}
    held, rest = list[str](), list[str]()
    for line in lines[:-1]:
        name, _, text = line.partition(" = ")
        words = _words([text])
        alone = words <= known and not words <= set(trace().constants)
        (held if alone else rest).append(line)
        known |= {name} if alone else set()
    return held, rest, lines[-1]


def _split(expression: Any) -> Any:
    """Factored, with what is held over a step apart, so that it is computed once for all stages."""
    terms = sp.Add.make_args(sp.expand(expression))
    held = [term for term in terms if not term.free_symbols & set(STATE)]
    return factored(sp.Add(*held)), factored(sp.Add(*[term for term in terms if term not in held]))


def _shorter(expression: Any, *, coulomb: bool, slope: bool) -> Any:
    """Without what a level floor or a robot without Coulomb friction does not need."""
    level = {SIN_SLOPE: 0, COS_SLOPE: 1}
    smooth = {SLIP_LEFT: 0, SLIP_RIGHT: 0}
    return expression.subs({**({} if slope else level), **({} if coulomb else smooth)})


def _acceleration_lines(*, coulomb: bool, slope: bool) -> list[str]:
    """The body of a function that gives ψ̈, θ̈, φ̈, with one reciprocal for all its divisions."""
    traced, out = trace(), Printer()
    out.put("s, c", "sincos(pitch)")
    if slope:
        out.put("sin_yaw, cos_yaw", "sincos_any(yaw)")
    _, a22, a33 = (
        sp.Symbol(out.put(n, out.value(e))) for n, e in zip(("a12", "a22", "a33"), traced.inertias, strict=True)
    )
    below = [out.put("determinant", f"fma(-a12, a12, {a22})"), str(a33)]
    if coulomb:
        for side, rate in zip(("left", "right"), traced.rates, strict=True):
            out.put(f"rate_{side}", out.value(rate))
            square = list(trace().constants)[-1]
            below.append(out.put(f"root_{side}", f"sqrt(fma(rate_{side}, rate_{side}, {square}))"))
    over = _reciprocals(out, below)
    if coulomb:
        out.put("slip_left", f"rate_left * {over[2]}")
        out.put("slip_right", f"rate_right * {over[3]}")
    force = [_split(_shorter(f, coulomb=coulomb, slope=slope)) for f in traced.forces]
    for name, (held, _) in zip(("held_pitch", "held_wheel", "held_yaw"), force, strict=True):
        out.put(name, out.value(held))
    pitch, wheel, yaw = (
        out.value(sp.Symbol(name) + free)
        for name, (_, free) in zip(("held_pitch", "held_wheel", "held_yaw"), force, strict=True)
    )
    out.put("pitch_acc", f"fma(-a12, {wheel}, {pitch}) * {over[0]}")
    return [*out.lines, f"return pitch_acc, fma(-a12, pitch_acc, {wheel}), {yaw} * {over[1]}"]


def _reciprocals(out: Printer, names: Sequence[str]) -> list[str]:
    """1/a, 1/b, … by one division of their product (Montgomery 1987)."""
    before = [names[0]]
    for i, name in enumerate(names[1:]):
        before.append(out.put(f"before_{i}", f"{before[-1]} * {name}"))
    rest, found = out.put("over", f"reciprocal({before[-1]})"), []
    for i in range(len(names) - 1, 0, -1):
        found.append(out.put(f"over_{i}", f"{rest} * {before[i - 1]}"))
        rest = out.put(f"rest_{i}", f"{rest} * {names[i]}")
    return [rest, *reversed(found)]
