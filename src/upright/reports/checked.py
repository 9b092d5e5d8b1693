"""Pages of what a check found: a `Parity` of a program, the `LinearModel` of a robot."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.execution.parity import Parity
from upright.physics.linear import Complex, LinearModel
from upright.plotting import AXIS, COLOURS, PANEL, bars, legend, number, numbered, panels, plane, points
from upright.reports.figure import Figure
from upright.reports.made import again
from upright.reports.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.robots import Robot, find_kit


def page_of(result: Parity | LinearModel) -> Page:
    """The page, not yet written."""
    return _parity(result) if isinstance(result, Parity) else _linear(result)


def _parity(result: Parity) -> Page:
    rows: list[list[Cell]] = [[p.push, p.outcome, p.peak] for p in result.pushes]
    figure = bars(["difference", "tolerance"], [result.worst, result.tolerance], f"command [{result.unit}]", "largest")
    difference = f"{cell_text(result.worst, 3)} {result.unit}"
    within = "within" if result.worst <= result.tolerance else "beyond"
    return Page(
        f"{result.target} program of {result.robot}: {'equal to' if result.passed else 'not equal to'} its design",
        [Section("Pushes", [Table(["push", "outcome", "largest pitch [rad]"], rows)])],
        "" if result.as_generated else "The file differs from what `upright firmware` generates here.",
        {"controller": result.hash[:12], "numbers": result.numbers, "where": result.where}, True,
        verdict=Verdict("equal", "good") if result.passed else Verdict("not equal", "bad"),
        picture=Figure(f"Commands differ by {difference}, {within} the tolerance", figure),
        numbers=[
            (f"{result.steps} of {result.periods}", "periods compared"),
            (str(result.duties), "duties that do not follow from their commands"),
        ],
    )  # fmt: skip


SYMBOLS = {"pitch": "ψ", "pitch_rate": "ψ̇", "wheel": "θ", "wheel_rate": "θ̇", "yaw": "φ", "yaw_rate": "φ̇"}
_SYMBOLS = (
    "ψ pitch, positive forward; θ wheel angle against the floor; φ yaw, anticlockwise [rad]. With a dot: their rates "
    "[rad/s]. Commands are in {unit}."
)


def linear_page(model: LinearModel, robot: Robot) -> Page:
    """The page of the linear model of a `robot`, which is named on it."""
    page = _linear(model, robot.command_unit)
    period = find_kit(robot.kit).period
    rate = _fastest(model)
    words = f"times its controller acts, every {1e3 * period:g} ms, before a lean doubles"
    numbers = [
        (number(math.log(2) / rate / period, 2), words) if text == _DOUBLES else (value, text)
        for value, text in page.numbers
    ]
    lead = page.lead.replace("ROBOT", robot.name)
    facts = {"robot": robot.name}
    return replace(page, title=linear_title(model, robot.name), lead=lead, numbers=numbers, provenance=facts)


_DOUBLES = "in which a small lean doubles"


def linear_title(model: LinearModel, robot: str = "the robot") -> str:
    """Whether a robot falls without a controller, and how fast."""
    fastest = _fastest(model)
    if fastest <= 0:
        return "No pole is unstable"
    return f"Without a controller {robot} falls: a lean doubles every {_doubling(fastest)}"


def _unstable(model: LinearModel) -> list[complex]:
    return [p for p in model.poles().tolist() if (p.real > 1e-9 if model.continuous else abs(p) > 1 + 1e-9)]


def _fastest(model: LinearModel) -> float:
    """The largest rate of growth [1/s], 0 where nothing grows."""
    return max((p.real if model.continuous else math.log(abs(p)) / model.dt for p in _unstable(model)), default=0.0)


def _doubling(rate: float) -> str:
    seconds = math.log(2) / rate
    return f"{cell_text(1e3 * seconds, 2)} ms" if seconds < 1 else f"{cell_text(seconds, 2)} s"


def _linear(model: LinearModel, unit_of_command: str = "V, or in N m for a robot with a torque drive") -> Page:
    poles = model.poles()
    unit = "1/s" if model.continuous else "1"
    unstable = _unstable(model)
    motions = _motions(model, poles)
    several: Sequence[complex] = poles.tolist()
    real = not poles.imag.any()
    rows: list[list[Cell]] = [[p.real, *([] if real else [p.imag]), of] for p, of in zip(several, motions, strict=True)]
    parts = [f"pole, all real [{unit}]"] if real else [f"real part [{unit}]", f"imaginary part [{unit}]"]
    named = [SYMBOLS.get(state, state) for state in model.states]
    rates = [f"d{name}/dt" if model.continuous else f"next {name}" for name in named]
    matrices = [
        Table(["", *names], [[state, *row] for state, row in zip(rates, matrix.tolist(), strict=True)], caption, 3)
        for caption, names, matrix in (
            ("A: from each state (column) to the rates of change (rows)", named, model.A) if model.continuous else
            ("A: from each state (column) to the next state (rows)", named, model.A),
            ("B: from each command (column)", [f"{name} command" for name in model.inputs], model.B),
        )
    ]  # fmt: skip
    legend_of = [_SYMBOLS.format(unit=unit_of_command)] if set(model.states) <= set(SYMBOLS) else []
    count = f"{len(unstable)} of {len(poles)} poles {'is' if len(unstable) == 1 else 'are'} unstable"
    fastest = _fastest(model)
    doubles = _doubling(fastest) if unstable else ""
    equation = (
        "ẋ\u00a0=\u00a0A\u00a0x\u00a0+\u00a0B\u00a0u" if model.continuous else f"x⁺ = A x + B u, every {model.dt:g} s"
    )
    numbers = [
        *(
            (f"{cell_text(p.real, 3)}{' 1/s' if model.continuous else ''}", _pole(p, model.continuous))
            for p in unstable[:1]
        ),
        *([(doubles, _DOUBLES)] if unstable else []),
        *_others(poles.tolist(), model.continuous),
    ]
    return Page(
        linear_title(model),
        [
            Section("Matrices", [*legend_of, *matrices, f"All digits: `{again('upright linearise')} --json`."]),
            Section("Poles", [Table([*parts, "motion"], rows)]),
        ],
        f"The linear model of the robot's file, standing upright with motors at zero command: {equation}. "
        "Next: `upright design lqg --robot ROBOT -o lqg.json` designs a controller that holds it.", {}, False,
        verdict=Verdict("unstable without control" if unstable else "stable", "info"),
        picture=_pole_figure(poles, model.continuous, count, motions), numbers=numbers,
    )  # fmt: skip


def _others(poles: Sequence[complex], continuous: bool) -> list[tuple[str, str]]:
    """How many poles keep what they have: nothing brings the robot back there."""
    still = sum(abs(p) < 1e-9 if continuous else abs(p - 1) < 1e-9 for p in poles)
    at = "at zero" if continuous else "at one"
    return [(f"{still} of {len(poles)}", f"poles {at}: where it has rolled or turned, it stays")] if still else []


def _pole(pole: complex, continuous: bool) -> str:
    """What an unstable pole means; of a real one how long a lean takes to double."""
    if not continuous:
        return "by which a lean grows every period: the unstable pole"
    doubles = f": it doubles in 0.69 / {cell_text(pole.real, 3)} = {_doubling(pole.real)}" if not pole.imag else ""
    return f"rate at which a lean grows, the unstable pole{doubles}"


TURNING = ("yaw", "yaw_rate")


def _motions(model: LinearModel, poles: Complex) -> list[str]:
    """What moves with each pole, where the model keeps turning and balancing apart; '' where it does not."""
    turning = np.array([state in TURNING for state in model.states])
    if not turning.any() or turning.all() or model.A[np.ix_(turning, ~turning)].any() or (
        model.A[np.ix_(~turning, turning)].any()
    ):  # fmt: skip
        return [""] * len(poles)
    left = list(np.linalg.eigvals(model.A[np.ix_(turning, turning)]))
    motions: list[str] = []
    for pole in poles.tolist():
        near = min(range(len(left)), key=lambda k, p=pole: abs(left[k] - p), default=-1)
        turns = near >= 0 and abs(left[near] - pole) < 1e-6 * (1 + abs(pole))
        rolls = abs(pole) < 1e-9
        motions.append("yaw" if turns else "rolling" if rolls else "pitch and wheels")
        if turns:
            del left[near]
    return motions


def _pole_figure(poles: Complex, continuous: bool, count: str, motions: Sequence[str]) -> Figure:
    """The poles; of a continuous model over a real axis that is logarithmic away from zero, so that fast poles do not
    hide the slow ones, with a line at zero."""
    if not continuous:
        figure, ax = plane("real part [1]", "imaginary part [1]", circle=True)
        points(ax, "poles", poles.tolist())
        return Figure(f"{count}: outside the circle" if not count.startswith("0 ") else count, figure)
    figure, (ax,) = panels(
        ["imaginary part [1/s]"],
        "real part [1/s], in powers of ten on both sides of zero",
        height=0.9 if not poles.imag.any() else PANEL,
    )
    high = 1.5 * (float(np.abs(poles.imag).max()) or 1.0)
    reach = max(10.0, 3 * float(np.abs(poles.real).max()))
    ax.set(xscale="symlog", xlim=(-1.5 * reach, reach), ylim=(-high, high))
    numbered(ax.xaxis)
    ax.axvline(0, color=AXIS, linewidth=1)
    if not poles.imag.any():
        ax.set_yticks([0], ["0"])
    kinds = {"stable": (-math.inf, -1e-9, 0), "neither (at zero)": (-1e-9, 1e-9, 4), "unstable": (1e-9, math.inf, 1)}
    for name, (low, top, colour) in kinds.items():
        kept = poles[(poles.real > low) & (poles.real <= top)]
        if len(kept):
            (marks,) = ax.plot(kept.real, kept.imag, "x", label=name, markersize=9, color=COLOURS[colour], zorder=3)
            marks.set_markeredgewidth(2.2)
    several = Counter(complex(round(p.real, 6), round(p.imag, 6)) for p in poles.tolist())
    for place, pole in enumerate(sorted(several, key=lambda p: p.real)):
        same = {of for p, of in zip(poles.tolist(), motions, strict=True) if abs(p - pole) < 1e-5}
        words = [", ".join(sorted(same - {""})) or f"{several[pole]} poles"] if several[pole] > 1 else []
        words = words or (["yaw"] if same == {"yaw"} else [])
        text = number(pole.real, 3) + "".join(f" ({word})" for word in words)
        beside = 6 if pole.real == 0 else -9 if words else 0  # neither on the line at zero nor over the left edge
        above = (beside, -22) if place % 2 else (beside, 9)  # neighbours do not overlap
        ax.annotate(text, (pole.real, pole.imag), above, textcoords="offset points", ha="left" if beside else "center")
    return Figure(f"{count}: right of the line" if not count.startswith("0 ") else count, legend(figure))
