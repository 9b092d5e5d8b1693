"""The page of a `LinearModel`: whether it falls without a controller, how fast, and its matrices."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array, Complex
from upright.languages import number
from upright.pages import Column, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.blocks import Cell
from upright.pages.terms import channel
from upright.signals.signal import STATE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LinearModel = Any  # that of `linear.py`, which imports this file

SYMBOLS = {signal.name: signal.symbol for signal in STATE}
PERIOD = 0.01  # [s] of the controllers of most kits, where the model has none
TURNING = ("yaw", "yaw_rate")
STILL = 1e-9  # [1/s, or 1 from z = 1] a pole nearer is at rest but for rounding


DRIFT = 1e-9  # [rad/s, rad/s²] of a state by itself: less is rounding, since what matters is of order 1 to 1000
BALANCING = Say("pitch and wheels")
STEADY = ("wheel", "yaw")
"""What may move by itself in a steady motion: nothing on a level floor depends on it."""


def linear_page(model: LinearModel) -> Page:
    """The page of a linear model."""
    rates = growth(model)
    rate = float(np.max(rates, initial=0.0))
    unstable = int((rates > STILL).sum())
    upright = set(model.states) <= set(SYMBOLS)
    facts = [_pole(model, rate)] if unstable else []
    if unstable:
        period = PERIOD if model.continuous else model.dt
        meaning = Say("control periods of {period} until a lean doubles", period=Quantity(period, "s"))
        facts.append(KeyNumber(Quantity(math.log(2) / rate / period, "1", digits=2), meaning))
    if still := int((np.abs(rates) <= STILL).sum()):
        value = Say("{n} of {all}", n=still, all=len(rates))
        facts.append(KeyNumber(value, Say("poles at zero: where it has rolled or turned, it stays")))
    why = Say("An lqg controller holds the robot; this writes its file.")
    return Page(
        _title(model, rate, unstable, upright),
        verdict=Verdict(Say("unstable without control") if unstable else Say("no pole is unstable")),
        lead=[_equation(model, upright), *_drift(model)], numbers=facts, picture=poles_picture(model),
        next=[Next("design", "lqg", output="lqg.json", why=why)] if upright and unstable else [],
        blocks=[_poles(model), *_matrices(model, upright)],
    )  # fmt: skip


def _equation(model: LinearModel, upright: bool) -> Say:
    """The equation, and what x and u are."""
    if not model.continuous:
        period = Quantity(model.dt, "s")
        return Say("Near its operating point the state changes every {period} to x⁺ = A x + B u.", period=period)
    if upright:
        return Say("For small motions ẋ = A x + B u: x are angles and their rates, u both motors' commands.")
    return Say("For small motions the state follows ẋ = A x + B u.")


def _drift(model: LinearModel) -> list[Say]:
    """That the operating point is no equilibrium, and which state leaves it fastest."""
    rates = model.f0 if model.continuous else model.f0 / model.dt
    moves = zip(model.states, rates.tolist(), strict=True)
    own = {name: rate for name, rate in moves if name not in STEADY and abs(rate) > DRIFT}
    if not own:
        return []
    state = max(own, key=lambda name: abs(own[name]))
    rate = Quantity(own[state], "rad/s²" if state.endswith("_rate") else "rad/s")
    return [
        Say("Not an equilibrium: {state} changes by itself, by {rate}.", state=SYMBOLS.get(state, state), rate=rate)
    ]


def growth(model: LinearModel) -> Array:
    """The rate [1/s] at which the motion of each pole grows."""
    poles: Complex = model.poles()
    if model.continuous:
        return poles.real
    return np.log(np.maximum(np.abs(poles), np.finfo(float).tiny)) / model.dt


def motions(model: LinearModel) -> list[Say | None]:
    """What moves with each pole, where the model keeps turning and balancing apart."""
    poles = model.poles().tolist()
    turning = np.array([state in TURNING for state in model.states])
    coupled = model.A[np.ix_(turning, ~turning)].any() or model.A[np.ix_(~turning, turning)].any()
    if not turning.any() or turning.all() or coupled:
        return [None] * len(poles)
    left: list[complex] = np.linalg.eigvals(model.A[np.ix_(turning, turning)]).tolist()
    names: list[Say | None] = []
    for pole in poles:
        same = [other for other in left if abs(other - pole) < 1e-6 * (1 + abs(pole))]
        if same:
            left.remove(same[0])
            names.append(Say("yaw"))
        else:
            rest = 0.0 if model.continuous else 1.0
            names.append(Say("rolling") if abs(pole - rest) < STILL else BALANCING)
    return names


def _title(model: LinearModel, rate: float, unstable: int, upright: bool) -> Say:
    if not unstable:
        return Say("No pole is unstable: without a controller nothing grows")
    time = _doubled(rate)
    if upright and model.subject:
        return Say("Without a controller {robot} falls: a lean doubles every {time}", robot=model.subject, time=time)
    if upright:
        return Say("Without a controller the robot falls: a lean doubles every {time}", time=time)
    return Say("Unstable: a small deviation doubles every {time}", time=time)


def _doubled(rate: float) -> Quantity:
    """The time until a deviation that grows at a rate is twice as large."""
    return Quantity(math.log(2) / rate, "s", digits=2)


def _pole(model: LinearModel, rate: float) -> KeyNumber:
    pole = float(model.poles()[0].real)
    if model.continuous:
        facts = {"pole": Quantity(pole, "1"), "time": _doubled(rate)}
        meaning = Say("unstable pole, the rate at which a lean grows: it doubles in 0.69 / {pole} = {time}", **facts)
        return KeyNumber(Quantity(pole, "1/s"), meaning)
    return KeyNumber(Quantity(pole, "1", digits=4), Say("unstable pole: what a lean grows by each period"))


def _matrices(model: LinearModel, upright: bool) -> list[Table]:
    """A and B: a row for each rate of change, or next state."""
    states = [SYMBOLS.get(name) or name for name in model.states]
    caption = Say("A")
    commands = Say("B")
    if upright:
        caption = Say("A; ψ: pitch, θ: wheel angle, φ: yaw [rad]; with a dot: their rates [rad/s]")
        commands = Say("B, for the commands of both motors")
    if upright and model.input_unit:
        commands = Say("B, for the commands of both motors [{unit}]", unit=model.input_unit)
    change = Say("d{state}/dt") if model.continuous else Say("{state}⁺")
    rows = [change.about(state=state) for state in states]
    return [_matrix(model.A, rows, states, caption), _matrix(model.B, rows, model.inputs, commands)]


def _matrix(values: Array, rows: Sequence[Say], names: Sequence[str], caption: Say) -> Table:
    rounded = np.where(np.abs(values) < 1e-14 * np.abs(values).max(initial=0.0), 0.0, values)
    cells: list[list[Cell]] = []
    for name, row in zip(rows, rounded.tolist(), strict=True):
        cells.append([name, *(Quantity(value or 0.0, "1") for value in row)])  # no −0
    return Table([Column(Say("change")), *(Column(channel(name)) for name in names)], cells, caption)


def _poles(model: LinearModel) -> Table:
    poles: list[complex] = model.poles().tolist()
    unit = "1/s" if model.continuous else "1"
    real = [Quantity(p.real, "1", digits=4) for p in poles]
    named = motions(model)
    if not any(p.imag for p in poles):
        columns = [Column(Say("pole"), unit), Column(Say("motion"))]
        return Table(columns, list(zip(real, named, strict=True)))
    columns = [Column(Say("pole, real part"), unit), Column(Say("imaginary part"), unit), Column(Say("motion"))]
    imaginary = [Quantity(p.imag, "1", digits=4) for p in poles]
    return Table(columns, list(zip(real, imaginary, named, strict=True)))


def poles_picture(model: LinearModel) -> Picture:
    """The poles in the plane, and how many of them are unstable."""
    counts = {"n": int((growth(model) > STILL).sum()), "of": len(model.A)}
    if not model.continuous:
        claim = Say("Unstable poles lie outside of the circle: {n} of {of}", **counts)
        return Picture(claim, functools.partial(_draw_discrete, model))
    claim = Say("Unstable poles lie right of the line: {n} of {of}", **counts)
    if counts["n"] == 1:
        claim = Say("One of {of} poles lies right of the line: this motion grows", of=counts["of"])
    note = Say("The real axis has powers of ten on both sides of zero.")
    return Picture(claim, functools.partial(_draw_continuous, model), note)


def _draw_discrete(model: LinearModel) -> Figure:
    from upright.plotting import plane, points

    figure, ax = plane(circle=True)
    points(ax, str(Say("poles")), model.poles().tolist())
    return figure


def _draw_continuous(model: LinearModel) -> Figure:
    """Over a real axis that is logarithmic away from zero, so that fast poles do not hide the slow ones."""
    from upright.plotting import AXIS, COLOURS, PANEL, numbered, panels

    poles: Complex = model.poles()
    real = not poles.imag.any()
    figure, (ax,) = panels(
        [str(Say("imaginary part [1/s]"))], str(Say("real part [1/s]")),
        height=1.1 if real else PANEL,
    )  # fmt: skip
    high = 1.5 * (float(np.abs(poles.imag).max(initial=0.0)) or 1.0)
    reach = max(10.0, 3 * float(np.abs(poles.real).max(initial=0.0)))
    ax.set(xscale="symlog", xlim=(-1.5 * reach, reach), ylim=(-high, high))
    numbered(ax.xaxis)
    ax.axvline(0, color=AXIS, linewidth=1)
    if real:
        ax.set_yticks([0], ["0"])
    still = np.abs(poles.real) <= STILL
    fading = ~still & (poles.real < 0)
    for those, colour in ((fading, 0), (still, 4), (~still & ~fading, 1)):
        ax.scatter(poles.real[those], poles.imag[those], 80, COLOURS[colour], marker="x", linewidths=2.2, zorder=3)
    sides = ((Say("fades"), COLOURS[0], -6, "right"), (Say("grows"), COLOURS[1], 6, "left"))
    for words, colour, shift, side in sides:
        ax.annotate(str(words), (0, 1), (shift, -3), xycoords=("data", "axes fraction"), textcoords="offset points",
                    ha=side, va="top", color=colour)  # fmt: skip
    _name_poles(ax, poles, motions(model))
    return figure


def _name_poles(ax: Axes, poles: Complex, named: Sequence[Say | None]) -> None:
    """The real part beside each pole, once where several are equal; above and below by turns, so that none overlap.
    What moves stands behind it, but for pitch and wheels, which move with most."""
    apart: dict[complex, list[str]] = {}
    for pole, motion in zip(np.round(poles, 6).tolist(), named, strict=True):
        words = apart.setdefault(pole, [])
        if motion and motion != BALANCING:
            words.append(str(motion))
    for place, pole in enumerate(sorted(apart, key=lambda p: p.real)):
        beside = 6 if abs(pole.real) <= STILL else 0  # not over the line
        behind = f" ({', '.join(dict.fromkeys(apart[pole]))})" if apart[pole] else ""
        ax.annotate(number(pole.real) + behind, (pole.real, pole.imag), (beside, -20 if place % 2 else 9),
                    textcoords="offset points", ha="left" if beside else "center")  # fmt: skip
