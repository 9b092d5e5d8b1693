"""The page of an `Analysis`: margins in words and numbers, Bode and Nyquist of the broken loop, poles."""

from __future__ import annotations

import math

import numpy as np

from upright.certify.analysis import INPUTS, Analysis, broken
from upright.certify.design import Designed
from upright.certify.margins import Margins
from upright.errors import InvalidController
from upright.physics.linear import Complex
from upright.report.figure import Figure, Panel, PointFigure, PointSet, Trace
from upright.report.page import Cell, Item, Page, Section, Table, Verdict

NEAR = 3.0
"""The Nyquist curve is drawn up to this distance from the origin, around the critical point."""


def page_of(result: Analysis | Designed) -> Page:
    """The page of an analysis, or of a design's; raises `InvalidController` for a design without one."""
    if isinstance(result, Designed):
        if not result.analysis:
            raise InvalidController(f"no report: {result.remark}", expected="a controller that is linear near rest")
        return page_of(result.analysis)
    analysis = result
    verdict = Verdict("stable", "good") if analysis.stable else Verdict("unstable", "warn")
    sections = [Section("Summary", analysis.words(), verdict), Section("Margins", _margins(analysis))]
    if analysis.stable:
        sections += [Section("Broken at both motors", _loop(analysis))]
    sections.append(Section("Closed-loop poles", [_poles(analysis)]))
    facts = {"controller": analysis.hash[:12], "period": f"{analysis.period * 1e3:g} ms"}
    return Page(
        f"{analysis.controller} on {analysis.robot}", sections, "The stability margins of this loop.", facts, False
    )


def _margins(analysis: Analysis) -> list[Item]:
    rows: list[list[Cell]] = [_row(m) for m in (*analysis.inputs, *analysis.outputs)]
    header = ["broken at", "gain from", "gain to", "phase [°]", "delay [ms]", "disk α", "Ms", "Mt"]
    numbers: list[list[Cell]] = [
        ["disk α of both motors at once", analysis.disk],
        ["delay margin [ms]", analysis.delay * 1e3],
        ["b(P, C), normalised coprime stability margin", analysis.coprime],
        ["largest ν-gap of the drawn robots", analysis.gap],
        ["largest |pole|", float(np.abs(analysis.poles).max())],
        ["largest |pole| of the drawn robots", float(analysis.radii.max()) if len(analysis.radii) else math.nan],
    ]
    if analysis.mu:
        numbers.append(["μ over the parameters, at least", analysis.mu.lower])
        numbers.append(["μ over the parameters, at most", analysis.mu.upper])
    return [
        Table(header, rows, "One loop broken, all others closed", 3),
        Table(["", "value"], numbers, "The whole loop", 3),
    ]


def _row(m: Margins) -> list[Cell]:
    return [m.channel, m.gain_low, m.gain_high, math.degrees(m.phase), m.delay * 1e3, m.disk, m.Ms, m.Mt]


def _loop(analysis: Analysis) -> list[Item]:
    omega, response = broken(analysis.loop, INPUTS["both motors"])
    decades, name = np.log10(omega), "loop gain"
    size, phase = 20 * np.log10(np.abs(response)), np.degrees(np.unwrap(np.angle(response)))
    panels = [Panel("size", "dB", [Trace(name, decades, size)]), Panel("phase", "°", [Trace(name, decades, phase)])]
    title = "Bode: the loop crosses 0 dB last at " + f"{analysis.both().crossover:.3g} rad/s"
    return [Figure(title, panels, "frequency, power of ten", "rad/s"), _nyquist(analysis, response)]


def _nyquist(analysis: Analysis, response: Complex) -> PointFigure:
    near = response[np.abs(response) < NEAR]
    sets = [PointSet("loop gain", [complex(v) for v in (*near, *near.conj())]), PointSet("−1", [-1.0])]
    title = f"Nyquist: the loop stays {1 / analysis.both().Ms:.2f} away from −1"
    return PointFigure(title, sets, note=f"Points beyond {NEAR:g} from the origin are omitted.")


def _poles(analysis: Analysis) -> PointFigure:
    drawn = [complex(p) for p in analysis.drawn.ravel()]
    sets = [PointSet("robots drawn from the spreads", drawn)] if drawn else []
    sets.append(PointSet("nominal robot", [complex(p) for p in analysis.poles]))
    fell = int((analysis.radii >= 1).sum())
    inside = "All poles lie inside the circle" if analysis.stable else "A pole lies outside the circle"
    return PointFigure(f"{inside}; {fell} of {len(analysis.radii)} drawn robots are unstable", sets)
