"""What a design is, for its page: readings, weights, gains and filter; and a run in which the robot is let go."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.arrays import Array
from upright.certification.design import UPRIGHT, Designed, Release
from upright.control import Controller, Design, design_of
from upright.control.hinf import Hinf
from upright.control.kalman import Filter
from upright.control.law import near_rest
from upright.control.lqg import Lqg
from upright.control.lqr import Lqr
from upright.control.mpc import PredictiveController
from upright.control.observed import Observed
from upright.control.pid import Pid, PidGains
from upright.control.sliding import Sliding, SlidingMode
from upright.reports.figure import Figure
from upright.reports.page import Cell, Formula, Item, Section, Table, cell_text, distance_text
from upright.signals.signal import KNOWN, STATE
from upright.tables import joined, short

UNITS = {signal.name: signal.unit for signal in STATE} | {"gyro_bias": "rad/s", "push": "N", "integral": "rad s"}
"""Units of the states of a regulator or of a filter."""


def let_go(run: Release) -> Section:
    """Pitch and travel of the run."""
    heading = f"Let go at {math.degrees(run.lean):.2g}°"
    note = (
        "The nonlinear model with the electronics of the kit: noise, delay, dead zone and the motors' limit. "
        "At first the controller takes it to stand upright, so the lean grows until the sensors show it."
    )
    title = f"{heading}, it is upright again after {_after(run)} and rolls up to {_travel(run)}"
    if run.fell is not None:
        title = f"{heading}, it falls after {cell_text(run.fell, 2)} s"
    elif not math.isfinite(run.upright):
        title = f"{heading}, it does not fall, but keeps swinging beyond ±{math.degrees(UPRIGHT):g}°"
    return Section(heading, [Figure(title, run.plot(), note)])


def tile(run: Release) -> tuple[str, str]:
    """The run as a number, and what it is."""
    from_lean = f"let go at {math.degrees(run.lean):.2g}°"
    if run.fell is not None:
        return "falls", f"{from_lean}, after {cell_text(run.fell, 2)} s"
    if not math.isfinite(run.upright):
        return "swings", f"{from_lean} it does not fall, but swings beyond ±{math.degrees(UPRIGHT):g}°"
    return _after(run), f"after which it is upright again (±{math.degrees(UPRIGHT):g}°), {from_lean}"


def _after(run: Release) -> str:
    return f"{cell_text(run.upright, 2)} s"


def _travel(run: Release) -> str:
    return distance_text(run.travel)


def controller_section(designed: Designed) -> Section:
    """What the controller reads and commands, and the numbers that it was found by."""
    controller = designed.controller
    spec = controller.spec
    linear = near_rest(controller)
    reads = joined([short(name) for name in spec.reads])
    first = f"It reads {reads} every {1e3 * spec.period:g} ms, and commands each motor in {spec.command_unit}."
    order = f"Near rest it is a linear system of {len(linear.A)} states." if len(linear.A) else ""
    return Section("The controller", [f"{first} {order}".strip(), *_parts(controller)], folded=True)


def _parts(controller: Controller) -> list[Item]:
    """Weights, gains and filter, as far as the method has some."""
    unit = controller.spec.command_unit
    record = design_of(controller) or getattr(controller, "controller", controller)
    match record:
        case Lqr():
            items = _regulator(record.model.states, record, unit)
        case Observed(feedback=Lqr() as feedback):
            items = [*_regulator(feedback.model.states, feedback, unit), _ARRIVES]
        case Lqg():
            items = _regulator(record.plant.states, record, unit)
            if isinstance(controller, PredictiveController):
                items.append(f"It plans ahead, so that commands stay within ±{controller.splitting.limit:.3g} {unit}.")
        case Sliding() if isinstance(controller, SlidingMode):
            items = _surface(record, controller, unit)
        case Pid():
            items = _cascade(record.gains, unit)
        case Hinf():
            items = _shaped(record, unit)
        case _:
            items = [*record.words()] if isinstance(record, Design) else []
    estimator = record.base.filter if isinstance(record, Sliding) else getattr(record, "filter", None)
    return [*items, *(_filter(estimator) if isinstance(estimator, Filter) else [])]


_ARRIVES = "Here x̂ is the estimate for the moment when the command reaches the motors."


def _regulator(states: Sequence[str], design: Lqr | Lqg, unit: str) -> list[Item]:
    K = design.gain
    assert K is not None
    weights = design.Q.diagonal()
    table = _by_state(states, weights, {"K left": K[0], "K right": K[1]}, unit)
    return [_cost(design.R, unit), table]


def _cost(R: Array, unit: str) -> str:
    price = float(R[0, 0])
    return (
        "The command is u = −K x̂. K makes the sum of xᵀQx + uᵀRu smallest. "
        f"R is {cell_text(price, 3)} 1/{_squared(unit)} for each motor: {cell_text(price**-0.5, 3)} {unit} cost 1."
    )


def _squared(unit: str) -> str:
    return f"{unit}²" if unit.isalpha() else f"({unit})²"


def _by_state(states: Sequence[str], weights: Array, gains: dict[str, Array], unit: str) -> Table:
    header = ["state x [unit]", "Q [1/unit²]", "costs 1 at [unit]", *(f"{name} [{unit}/unit]" for name in gains)]
    rows: list[list[Cell]] = []
    for k, name in enumerate(states):
        weight = float(weights[k])
        own: list[Cell] = [weight, weight**-0.5] if weight > 0 else [0.0, None]
        rows.append([_named(name, unit), *own, *(float(gain[k]) for gain in gains.values())])
    return Table(header, rows, "Weights and gains of each state", 3, narrow=True)


def _named(name: str, unit: str) -> str:
    """A state with its unit: one of the robot or of the filter, or a command on its way, such as sent_2/left."""
    if name.startswith("sent_"):
        ago, side = name.removeprefix("sent_").split("/")
        return f"{side} command {ago} period{'' if ago == '1' else 's'} ago [{unit}]"
    return f"{name.replace('_', ' ')} [{UNITS.get(name, unit)}]"


def _filter(estimator: Filter) -> list[Item]:
    model = estimator.sampled
    header = ["estimate x̂ [unit]", *(f"{short(name)} [unit/{_whole(KNOWN[name].unit)}]" for name in model.reads)]
    rows: list[list[Cell]] = [
        [_named(name, ""), *(0.0 if abs(x) < ROUNDING * np.abs(estimator.L).max() else float(x) for x in row)]
        for name, row in zip(model.linear.states, estimator.L, strict=True)
        if "@" not in name
    ]
    return [
        "A Kalman filter corrects its estimate at each reading y: x̂ = x̂⁻ + L (y − C x̂⁻).",
        Table(header, rows, "Kalman gain L", 3, narrow=True),
    ]


ROUNDING = 1e-12
"""Of the largest entry: a gain that is smaller is zero but for rounding."""


def _whole(unit: str) -> str:
    return f"({unit})" if "/" in unit else unit


def _surface(design: Sliding, controller: SlidingMode, unit: str) -> list[Item]:
    table = _by_state(
        design.base.plant.states, design.base.Q.diagonal(),
        {"S left": design.S[0], "S right": design.S[1]}, unit,
    )  # fmt: skip
    words = (
        f"It drives s = S x̂ to zero. Of s {cell_text(100 * design.keep, 3)} % are left after a period, and "
        f"{cell_text(controller.reach, 2)} {unit} less outside of ±{cell_text(controller.layer, 2)} {unit}. "
        "S is that of the regulator with these weights."
    )
    return [words, table]


def _cascade(gains: PidGains, unit: str) -> list[Item]:
    rows: list[list[Cell]] = [
        [f"p, on pitch [{unit}/rad]", gains.p],
        [f"i, on its integral [{unit}/(rad s)]", gains.i],
        [f"d, on pitch rate [{unit} s/rad]", gains.d],
        ["filter time of d [s]", gains.filter_time],
        [f"c, against the motors' friction and back-EMF [{unit} s/rad]", gains.motor],
        ["pθ, on the wheels' angle [1]", gains.wheel],
        ["dθ, on the wheels' rate [s]", gains.wheel_rate],
        [f"pφ, on yaw [{unit}/rad]", gains.yaw],
        [f"dφ, on yaw rate [{unit} s/rad]", gains.yaw_rate],
    ]
    law = (
        "u = c (θ̇ − ψ̇) + p e + i ∫e + d ψ̇ ∓ (pφ φ + dφ φ̇)\n"
        "e = ψ + pθ θ + dθ θ̇\n"
        "− in front of the bracket: right motor; +: left motor"
    )
    return [Formula(law), Table(["gain", "value"], rows, "Gains", 3)]


def _shaped(design: Hinf, unit: str) -> list[Item]:
    orders = [len(channel.controller.A) for channel in (design.forward, design.turning)]
    wants = design.expected
    rows: list[list[Cell]] = [
        *([f"{s.name.replace('_', ' ')} [{s.unit}]", size] for s, size in zip(STATE, wants.state, strict=True)),
        [f"command of a motor [{unit}]", design.command],
        [f"disturbance at the command [{unit}]", design.command * wants.disturbance],
        ["error of an encoder [rad]", wants.errors[0]],
        ["error of the gyro [rad/s]", wants.errors[1]],
    ]
    words = (
        f"It has no gain K on a state. A controller of order {orders[0]} moves both motors alike, one of order "
        f"{orders[1]} steers. The weights are sizes. From disturbance and errors to states and command, each over its "
        f"size, the largest gain is γ = {cell_text(design.gamma, 3)}."
    )
    return [words, Table(["quantity", "size"], rows, "Weights", 3)]
