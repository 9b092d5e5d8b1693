"""Pages of what a check found: a `Diagnosis` of a log, a `Parity` of a program, the `LinearModel` of a robot."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from upright.doctor.doctor import Diagnosis
from upright.parity.parity import Parity
from upright.physics.linear import Complex, LinearModel
from upright.plotting import AXIS, bars, numbered, plane, points
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def page_of(result: Diagnosis | Parity | LinearModel) -> Page:
    """The page, not yet written."""
    if isinstance(result, Diagnosis):
        return _diagnosis(result)
    return _parity(result) if isinstance(result, Parity) else _linear(result)


def _diagnosis(result: Diagnosis) -> Page:
    faults = sum(f.severity != "note" for f in result.findings)
    rows: list[list[Cell]] = [
        [f.severity, f.channel.replace("_", " "), sentence(f.evidence), f.repair] for f in result.findings
    ]
    columns: list[list[Cell]] = [[name, source.column] for name, source in result.mapping.channels.items()]
    first, drawn = next(iter(result.findings), None), result.plot()
    poses = ", ".join(dict.fromkeys(segment.kind for segment in result.segments))
    verdict = "no fault found" if not faults else "1 fault" if faults == 1 else f"{faults} faults"
    return Page(
        f"{result.source or 'Log'}: {verdict}",
        [
            Section("Findings", [Table(["severity", "channel", "evidence", "repair"], rows)]),
            Section("Columns of the log", [Table(["channel", "column"], columns)], folded=True),
        ],
        f"{first.channel}: {first.evidence}." if first and not result.healthy else "",
        {"mapping": result.mapping.name, "rows": str(result.rows)}, False,
        verdict=Verdict("healthy", "good") if result.healthy else Verdict("to repair", "warn"),
        picture=Figure(": ".join(filter(None, ("The log as it was read", poses))), drawn) if drawn else None,
        numbers=[
            (f"{result.seconds:.4g} s", "length of the log"), (f"{result.period * 1e3:.4g} ms", "median period"),
            (str(result.rows), "rows"),
        ],
    )  # fmt: skip


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
        verdict=Verdict("equal", "good") if result.passed else Verdict("not equal", "warn"),
        picture=Figure(f"Commands differ by {difference}, {within} the tolerance", figure),
        numbers=[
            (f"{result.steps} of {result.periods}", "periods compared"),
            (str(result.duties), "duties that do not follow from their commands"),
        ],
    )  # fmt: skip


def _spread_out(ax: Axes, poles: Complex) -> None:
    """A real axis that is logarithmic away from zero, so that fast poles do not hide the slow ones; a line at zero."""
    reach, high = max(10.0, 3 * float(np.abs(poles.real).max())), float(np.abs(poles.imag).max())
    ax.set_aspect("auto")
    ax.set(xscale="symlog", xlim=(-reach, reach), ylim=(-1.5 * (high or 1.0), 1.5 * (high or 1.0)))
    numbered(ax.xaxis)
    ax.axvline(0, color=AXIS, linewidth=1)


def _linear(model: LinearModel) -> Page:
    poles = model.poles()
    unit = "1/s" if model.continuous else "1"
    figure, ax = plane(f"real part [{unit}]", f"imaginary part [{unit}]", circle=not model.continuous)
    if model.continuous:
        _spread_out(ax, poles)
    points(ax, "poles", poles.tolist())
    unstable = [p for p in poles if (p.real > 1e-9 if model.continuous else abs(p) > 1 + 1e-9)]
    rows: list[list[Cell]] = [[p.real, p.imag] for p in poles.tolist()]
    matrices = [
        Table(["", *names], [[state, *row] for state, row in zip(model.states, matrix.tolist(), strict=True)], letter)
        for letter, names, matrix in (("A", model.states, model.A), ("B", model.inputs, model.B))
    ]
    title = f"{len(unstable)} of {len(poles)} poles {'is' if len(unstable) == 1 else 'are'} unstable"
    fastest = max((float(p.real) for p in unstable), default=0.0)
    falls = model.continuous and unstable
    heading = f"{title}: a fall grows with {cell_text(fastest, 3)} {unit}" if falls else title
    figure_title = f"{title}: right of the line" if falls else title
    return Page(
        heading,
        [Section("Matrices", matrices), Section("Poles", [Table(["real part", "imaginary part"], rows)])],
        "ẋ = A x + B u" if model.continuous else f"x⁺ = A x + B u, every {model.dt:g} s", {}, False,
        verdict=Verdict("unstable" if unstable else "stable", "info"), picture=Figure(figure_title, figure),
        numbers=[(f"{cell_text(float(p.real), 3)} {unit}", "unstable pole, real part") for p in unstable[:1]],
    )  # fmt: skip
