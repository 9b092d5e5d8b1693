"""The accelerations and the step of Runge and Kutta, as source text for the kernel and the calibration's predictor.

The step is `physics.integrate.rk4_step`, run over symbols. It is written twice, with the same arithmetic. `rk4_…` moves
one robot and keeps everything in registers. `advance_…` moves a block by one loop for each stage, with the
accelerations between them in rows of the block: a loop over a whole step is so long that a processor cannot look ahead
to the next robots while it waits for its results.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from types import SimpleNamespace
from typing import Any

import sympy as sp

from upright.compiled.program import Function, Fused, Product, Quotient, Step, operands
from upright.compiled.trace import CONSTANTS, ROWS, STAGE, Maths, trace
from upright.compiled.trace_print import (
    COS,
    COS_SLOPE,
    COS_YAW,
    FORCE,
    HELD,
    LEFT,
    MOMENT,
    PITCH,
    PITCH_RATE,
    RIGHT,
    ROLL,
    SIN,
    SIN_SLOPE,
    SIN_YAW,
    SLIP,
    STATE,
    WHEEL_RATE,
    YAW,
    YAW_RATE,
    AlgebraTracer,
    LaneSource,
    P,
    SourceLine,
    called,
    factored,
    function,
)
from upright.compiled.tracer import FormulaTracer
from upright.physics.dynamics import Unpowered, held_at_speed
from upright.physics.integrate import rk4_step
from upright.physics.sensing import accelerometer

_SMOOTH, _EASY = dict.fromkeys(SLIP, 0), dict.fromkeys(ROLL, 0)
_LEVEL, _CALM = {SIN_SLOPE: 0, COS_SLOPE: 1}, {FORCE: 0, MOMENT: 0}
VARIANTS = {
    "smooth": {**_SMOOTH, **_EASY, **_LEVEL}, "coulomb": {**_EASY, **_LEVEL}, "rolling": _LEVEL,
    "slope": {**_SMOOTH, **_EASY}, "coulomb_slope": _EASY, "rolling_slope": {},
    "free": {**_SMOOTH, **_LEVEL, **_CALM},
    "speed": {**_SMOOTH, **_LEVEL}, "speed_slope": _SMOOTH,
}  # fmt: skip
"""Name → what it leaves out: dry friction of motors and on the floor, a floor that slopes, and, for the predictor
alone, pushes. The predictor holds the signs of rolling friction over a step, as it does the commands. A speed drive's
motors have no friction of their own."""
FOR_BLOCKS = tuple(name for name in VARIANTS if name != "free")

IMPORTS = """from upright.compiled.generated import WORK
from upright.compiled.jit import absolute, align_stack, fma, get, inlined, put, sqrt
from upright.compiled.lane_math import sincos, sincos_any"""

_ANGLES = ("pitch", "wheel", "yaw")
_ACCELERATIONS = tuple(f"{angle}_acc" for angle in _ANGLES)
_STATES = ROWS[:6]
_NEW = tuple(f"new_{name}" for name in _STATES)
_H = sp.Symbol("h")
_STEP = {sp.Integer(1): "h", sp.Rational(1, 2): "half"}


def motions() -> list[str]:
    """The parts of `generated_motion.py`."""
    return [IMPORTS, _ended(), *(text for name in VARIANTS for text in _Work(name).functions())]


def work_rows() -> int:
    """Rows of a block that `advance_…` needs between its loops."""
    return max(len(_Work(name).rows) for name in FOR_BLOCKS)


@cache
def _stages() -> list[list[Any]]:
    """What each stage of `rk4_step` is evaluated at, over symbols. Where it ends is printed by `_ended`."""
    stages = list[list[Any]]()

    def slopes(x: Sequence[Any]) -> list[Any]:
        stages.append(list(x))
        k = str(len(stages))
        rates = [sp.Symbol(f"{n}_rate{k if k != '1' else ''}") for n in _ANGLES]
        accelerations = sp.symbols([f"{n}_acc{k}" for n in _ANGLES])
        return [value for pair in zip(rates, accelerations, strict=True) for value in pair]

    rk4_step(slopes, sp.symbols(_STATES), _H)  # type: ignore[arg-type]
    return stages


def _increment(name: str, expression: Any) -> Fused:
    """x + h s or x + h s/2 in one rounding."""
    number, slope = expression.coeff(_H).as_coeff_Mul()
    return Fused(name, ((1.0, str(expression.coeff(_H, 0))),), ((1.0, _STEP[number], str(slope)),))


class _Work:
    """The source texts of one variant, whose `held` values are the same in all stages of a step."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.slope = SIN_SLOPE not in VARIANTS[name]
        self._moving = [n for n in STAGE if n != "yaw" or self.slope]
        held = (*HELD, *ROLL) if name == "free" else HELD
        source, (held_steps, steps) = LaneSource(), _parted(_acceleration_steps(name, held), held)
        self._held_lines, self._lines = source.lines(held_steps), source.lines(steps)
        self._constants, self._held_constants = _used(self._lines, CONSTANTS), _used(self._held_lines, CONSTANTS)
        self._inputs = _used(self._held_lines, map(str, held))
        self.held = _used(self._lines, [step.target for step in held_steps])
        self._all = _used([*self._held_lines, *self._lines], CONSTANTS)
        accelerations = [f"{angle}_acc{k}" for k in (1, 2, 3) for angle in _ANGLES]
        rates = [f"{n}_rate{k}" for k in (2, 3) for n in _ANGLES if n in self._moving]
        self._stages = [*accelerations, *rates]
        self.rows = {name: f"WORK + {row}" for row, name in enumerate([*self._stages, *self.held])}

    def functions(self) -> list[str]:
        """All texts of the variant."""
        texts = [*self.accelerations(), self.constants(), self.rk4()]
        return [*texts, self.step(), self.advance(), self.specific_force()] if self.name in FOR_BLOCKS else texts

    def accelerations(self) -> list[str]:
        """What is held over a step, the accelerations from it, and both in one."""
        one = ", ".join([*self._inputs, *self._held_constants])
        two = ", ".join([*self._moving, *self.held, *self._constants])
        both = ", ".join([*self._moving, *self._inputs, *self._all])
        return [
            function(f"held_{self.name}({one})", [*self._held_lines, f"return {', '.join(self.held)}"]),
            function(f"moved_{self.name}({two})", [*self._lines, f"return {', '.join(_ACCELERATIONS)}"]),
            function(f"accelerations_{self.name}({both})", [self._hold(), f"return moved_{self.name}({two})"]),
        ]

    def constants(self) -> str:
        """The constants of robot `i` of a block that the variant needs, in the order that `rk4_…` takes them."""
        return function(f"constants_{self.name}(w, i)", [f"return {self._get(self._all)}"])

    def rk4(self) -> str:
        """The state one step on."""
        lines = [self._hold(), *(line for k in (1, 2, 3, 4) for line in self._stage(k, recall=False)), *_sums()]
        arguments = ", ".join([*_STATES, "h", *self._inputs, *self._all])
        return function(f"rk4_{self.name}({arguments})", [*lines, f"return {', '.join(_NEW)}"])

    def step(self) -> str:
        """The one robot of a block by one step."""
        names = (*_STATES, "h", *self._inputs)
        arguments = ", ".join(names)
        text = f"{', '.join(_NEW)} = rk4_{self.name}({arguments}, *constants_{self.name}(w, i))"
        call = SourceLine(text, _NEW, names)
        return function(
            f"step_{self.name}(w, count, fallen, now)", ["i = 0", *self._load([call, *_STORE]), call, *_STORE], None
        )

    def advance(self) -> str:
        """All robots of a block by one step; one whose pitch leaves ±fallen gets a step of zero from then on."""
        lines = ["align_stack()"]
        for k in (1, 2, 3, 4):
            stage = [*([self._hold()] if k == 1 else []), *self._stage(k, recall=True), *(_sums() if k == 4 else [])]
            kept = [*(n for n in self._stages if n.endswith(str(k))), *(self.held if k == 1 else [])]
            stage += _STORE if k == 4 else [_put(self.rows[name], name) for name in kept]
            lines += ["for i in range(count):", *(f"    {line.text}" for line in [*self._load(stage), *stage])]
        return function(f"advance_{self.name}(w, count, fallen, now)", lines, None)

    def specific_force(self) -> str:
        """Rows `out` and `out` + 1: what an accelerometer at the axle reads, in motion under what is held."""
        tilt = sp.Symbol("slope", real=True)
        x = (PITCH, PITCH_RATE, sp.Symbol("wheel"), WHEEL_RATE, YAW, YAW_RATE)
        forces = accelerometer(x, sp.Symbol("wheel_acc", real=True), P, tilt, Maths(tilt))
        forward, up = (sp.expand(f).subs(VARIANTS[self.name]) for f in forces)
        tracer = AlgebraTracer()
        _directions(tracer, slope=self.slope)
        results = [tracer.named(name, factored(force)) for name, force in (("forward", forward), ("up", up))]
        arguments = [*self._moving, *self.held, *self._constants]
        body = [
            self._hold(),
            called(("_", "wheel_acc", "_"), f"moved_{self.name}", arguments),
            *LaneSource().lines(tracer.steps),
            *(_put(f"out + {k}", result) for k, result in enumerate(results)),
        ]
        lines = ["for i in range(count):", *(f"    {line.text}" for line in [*self._load(body), *body])]
        return function(f"specific_force_{self.name}(w, count, out)", lines, None)

    def _hold(self) -> SourceLine:
        return called(self.held, f"held_{self.name}", [*self._inputs, *self._held_constants])

    def _stage(self, k: int, *, recall: bool) -> list[SourceLine]:
        """The accelerations of stage `k` from those before it. With `recall` no line of another stage is at hand."""
        half = [SourceLine("half = 0.5 * h", ("half",), ("h",))] if k == 2 or (recall and k == 3) else []
        at = [f"{n}{k}" if k > 1 and n in self._moving else n for n in self._moving]
        states = zip(_STATES, _stages()[k - 1], strict=True) if k > 1 else ()
        steps = [_increment(f"{name}{k}", value) for name, value in states if name in self._moving]
        arguments = [*at, *self.held, *self._constants]
        return [
            *half,
            *LaneSource().lines(steps),
            called((f"{a}{k}" for a in _ACCELERATIONS), f"moved_{self.name}", arguments),
        ]

    def _load(self, lines: Sequence[SourceLine]) -> list[SourceLine]:
        """Loads of the rows that `lines` need and do not make themselves."""
        made = {name for line in lines for name in line.makes}
        names = [name for name in _used(lines, [*ROWS, *CONSTANTS, *self.rows]) if name not in made]
        return [SourceLine(f"{', '.join(names)} = {self._get(names)}", tuple(names), ())]

    def _get(self, names: Iterable[str]) -> str:
        places = {name: str(row) for row, name in enumerate([*ROWS, *CONSTANTS])} | self.rows
        return ", ".join(f"get(w, {places[name]}, i)" for name in names)


def _sums() -> list[SourceLine]:
    """The state one step on."""
    given = [[n, f"{n}_rate", *(f"{n}_acc{k}" for k in (1, 2, 3, 4))] for n in _ANGLES]
    ends = [
        called((f"new_{n}", f"new_{n}_rate"), "ended", ("h", "sixth", *g)) for n, g in zip(_ANGLES, given, strict=True)
    ]
    return [SourceLine("sixth = 1 / 6 * h", ("sixth",), ("h",)), *ends]


def _ended() -> str:
    """One angle and its rate a step on, in the accelerations of the four stages (Nyström's form of the classical
    method), with the sums that both share."""
    steps = [
        Fused("middle", ((1.0, "two"), (1.0, "three"))),
        Fused("all_four", ((1.0, "one"), (1.0, "middle"))),
        Fused("mean", ((1.0, "rate"),), ((1.0, "sixth", "all_four"),)),
        Fused("new", ((1.0, "angle"),), ((1.0, "h", "mean"),)),
        Fused("weighted", ((1.0, "all_four"), (1.0, "middle"), (1.0, "four"))),
        Fused("new_rate", ((1.0, "rate"),), ((1.0, "sixth", "weighted"),)),
    ]
    head = "ended(h, sixth, angle, rate, one, two, three, four)"
    return function(head, [*LaneSource().lines(steps), "return new, new_rate"])


def _put(row: object, value: str, *reads: str) -> SourceLine:
    return SourceLine(f"put(w, {row}, i, {value})", (), reads or (value,))


_STORE = [
    *(_put(row, name) for row, name in enumerate(_NEW)),
    _put(ROWS.index("lived"), "now if h > 0.0 else lived", "h", "lived"),
    _put(ROWS.index("h"), "h if absolute(new_pitch) <= fallen else 0.0", "h", "new_pitch"),
]


def _used(lines: Iterable[SourceLine], names: Iterable[str]) -> list[str]:
    read = {name for line in lines for name in line.reads}
    return [name for name in names if name in read]


def _parted(steps: Sequence[Step], fixed: Sequence[Any]) -> tuple[list[Step], list[Step]]:
    """Steps that need nothing but what is `fixed` over a step of time and constants, and the others."""
    known = {*map(str, fixed), *CONSTANTS}
    held = list[Step]()
    rest = list[Step]()
    for step in steps:
        reads = set(operands(step))
        alone = reads <= known and not reads <= set(CONSTANTS)
        (held if alone else rest).append(step)
        known |= {step.target} if alone else set()
    return held, rest


def _split(expression: Any, fixed: Sequence[Any]) -> Any:
    """Factored, with what is `fixed` over a step apart, so that it is computed once for all stages."""
    terms = sp.Add.make_args(sp.expand(expression))
    held = [term for term in terms if not term.free_symbols & (set(STATE) - set(fixed))]
    return factored(sp.Add(*held)), factored(sp.Add(*[term for term in terms if term not in held]))


def _directions(out: AlgebraTracer, *, slope: bool) -> None:
    out.sine_and_cosine(SIN, COS, PITCH)
    if slope:
        out.sine_and_cosine(SIN_YAW, COS_YAW, YAW)


def _acceleration_steps(variant: str, fixed: Sequence[Any]) -> list[Step]:
    """What gives ψ̈, θ̈, φ̈ in a variant, with one reciprocal for all divisions."""
    if "speed" in variant:
        speeds = [Fused(f"speed_{side}", ((1.0, side),)) for side in ("left", "right")]
        free = _torque_steps({**VARIANTS[variant], LEFT: 0, RIGHT: 0}, fixed, "free_")
        return [*speeds, *free, *_speed_steps()]
    return _torque_steps(VARIANTS[variant], fixed)


def _speed_steps() -> list[Step]:
    """`held_at_speed` after the accelerations without motors, with all inertias and torques over a11."""
    out = FormulaTracer("drive_")
    numbers = out.numbers
    half_track, yaw_rate, wheel_rate, pitch_rate = numbers("half_track yaw_rate wheel_rate pitch_rate")
    a12, a22, a33, yaw_inertia = numbers("a12 a22 a33 yaw_inertia")
    lag, most, slip = numbers("speed_lag acceleration_limit slip_torque")
    turning = half_track * yaw_rate
    idle = Unpowered(
        rates=(wheel_rate - turning - pitch_rate, wheel_rate + turning - pitch_rate),
        free=numbers(" ".join(f"free_{name}" for name in _ACCELERATIONS)),
        inertias=(1.0, a12, a22, a33 * yaw_inertia),
        half_track=half_track,
    )
    motor = SimpleNamespace(speed_lag=lag, acceleration_limit=most, slip_torque=slip)
    moved = held_at_speed(numbers("speed_left speed_right"), idle, motor, out)
    results = [Fused(name, ((1.0, value.name),)) for name, value in zip(_ACCELERATIONS, moved, strict=True)]
    return [*out.block("drive").steps, *results]


def _torque_steps(absent: dict[Any, int], fixed: Sequence[Any], prefix: str = "") -> list[Step]:
    """The accelerations, called by their names after `prefix`, without what is `absent`."""
    traced, out = trace(), AlgebraTracer()
    signs = {str(sign): rate for sign, rate in zip((*SLIP, *ROLL), traced.rates, strict=True)
             if sign not in absent and sign not in fixed}  # fmt: skip
    _directions(out, slope=SIN_SLOPE not in absent)
    a12, a22, a33 = (out.named(n, e) for n, e in zip(("a12", "a22", "a33"), traced.inertias, strict=True))
    below = [out.put("determinant", Fused("", ((1.0, a22),), ((-1.0, a12, a12),))), a33]
    for sign, rate in signs.items():
        turn = out.named(f"rate_{sign}", rate)
        square = out.put(f"square_{sign}", Fused("", ((1.0, "stiction_rate_squared"),), ((1.0, turn, turn),)))
        below.append(out.put(f"root_{sign}", Function("", "sqrt", square)))
    over = _reciprocals(out, below)
    for sign, inverse in zip(signs, over[2:], strict=True):
        out.put(sign, Product("", f"rate_{sign}", inverse))
    force = [_split(f.subs(absent), fixed) for f in traced.forces]
    held = [out.named(f"held_{n}", part) for n, (part, _) in zip(_ANGLES, force, strict=True)]
    pitch, wheel, yaw = (out.value(sp.Symbol(n) + free) for n, (_, free) in zip(held, force, strict=True))
    assert yaw[0] == 1
    alone = out.put("pitch_alone", Fused("", (pitch,), ((-wheel[0], a12, wheel[1]),)))
    pitch_acc, wheel_acc, yaw_acc = (prefix + name for name in _ACCELERATIONS)
    out.put(pitch_acc, Product("", alone, over[0]))
    out.put(wheel_acc, Fused("", (wheel,), ((-1.0, a12, pitch_acc),)))
    out.put(yaw_acc, Product("", str(yaw[1]), over[1]))
    return out.steps


def _reciprocals(out: AlgebraTracer, names: Sequence[str]) -> list[str]:
    """1/a, 1/b, … by one division of their product (Montgomery 1987)."""
    before = [names[0]]
    for i, name in enumerate(names[1:]):
        before.append(out.put(f"before_{i}", Product("", before[-1], name)))
    rest = out.put("over", Quotient("", 1.0, before[-1]))
    inverses = list[str]()
    for i in range(len(names) - 1, 0, -1):
        inverses.append(out.put(f"over_{i}", Product("", rest, before[i - 1])))
        rest = out.put(f"rest_{i}", Product("", rest, names[i]))
    return [rest, *reversed(inverses)]
