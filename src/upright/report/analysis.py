"""The page of an `Analysis`: margins in words and numbers, Bode and Nyquist of the broken loop, poles."""

from __future__ import annotations

import math

import numpy as np

from upright.certify.analysis import Analysis
from upright.certify.design import Designed
from upright.certify.margins import Margins
from upright.errors import InvalidController
from upright.report.figure import Figure
from upright.report.page import Cell, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence


def page_of(result: Analysis | Designed) -> Page:
    """The page of an analysis, or of a design's; raises `InvalidController` for a design without one."""
    if isinstance(result, Designed):
        if not result.analysis:
            raise InvalidController(f"no report: {result.remark}", expected="a controller that is linear near rest")
        return page_of(result.analysis)
    analysis = result
    first, *rest = analysis.words()
    sections = [Section("Margins", [*rest, *_margins(analysis)])]
    if analysis.stable:
        last = f"Bode diagram: last gain crossover at {analysis.both().crossover:.3g} rad/s"
        sections = [Section("Frequency response", [Figure(last, analysis.plot())]), *sections]
        sections += [Section("Closed-loop poles", [_poles(analysis)])]
    facts = {"controller": analysis.hash[:12], "period": f"{analysis.period * 1e3:g} ms"}
    return Page(
        _title(analysis), sections, _lead(analysis, first), facts, False, verdict=_verdict(analysis),
        picture=_nyquist(analysis) if analysis.stable else _poles(analysis), numbers=_numbers(analysis),
    )  # fmt: skip


CLOSE = 0.5
"""Distance of the Nyquist curve from −1 below which margins are small: the usual rule, Ms at most 2."""


def _title(analysis: Analysis) -> str:
    who = f"{analysis.controller} on {analysis.robot}"
    if not analysis.stable:
        return f"{who}: unstable"
    return f"{who}: stable, with up to {_delay(analysis)} more delay at the {_weakest(analysis)}"


def _verdict(analysis: Analysis) -> Verdict:
    if not analysis.stable:
        return Verdict("unstable", "warn")
    near = 1 / analysis.both().Ms < CLOSE
    return Verdict("stable, small margins", "warn") if near else Verdict("stable", "good")


def _weakest(analysis: Analysis) -> str:
    """The loop that a delay makes unstable first; all loops at once are those of the motors."""
    return analysis.weakest.channel if analysis.weakest.delay <= analysis.delay else "motors"


def _delay(analysis: Analysis) -> str:
    return f"{cell_text(min(analysis.delay, analysis.weakest.delay) * 1e3, 3)} ms"


def _lead(analysis: Analysis, first: str) -> str:
    """The first sentence, and the loop that a delay makes unstable first."""
    if not analysis.stable:
        return sentence(first, "")
    return f"{analysis.words()[1]} {sentence(first, '')}"


def _numbers(analysis: Analysis) -> list[tuple[str, str]]:
    if not analysis.stable:
        return []
    both = analysis.both()
    return [
        (
            f"{cell_text(both.gain_low, 2)} to {cell_text(both.gain_high, 2)}",
            "gain of both motors, as a factor, that stays stable",
        ),
        (f"{cell_text(math.degrees(both.phase), 2)}°", "phase margin"),
        (_delay(analysis), f"more delay at the {_weakest(analysis)} alone stays stable"),
    ]


def _margins(analysis: Analysis) -> list[Item]:
    rows: list[list[Cell]] = [_row(m) for m in (*analysis.inputs, *analysis.outputs)]
    header = ["broken at", "gain from", "gain to", "phase [°]", "delay [ms]", "disk α", "Ms", "Mt"]
    numbers: list[list[Cell]] = [
        ["disk α of both motors at once", analysis.disk],
        ["delay margin [ms]", analysis.delay * 1e3],
        ["b(P, C), stability margin of the normalised coprime factors", analysis.coprime],
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


def _nyquist(analysis: Analysis) -> Figure:
    title = f"Nyquist diagram, both motors: least distance from −1 is {1 / analysis.both().Ms:.2f}"
    return Figure(
        title,
        analysis.plot_nyquist(),
        "The loop is broken at both motors at once. The curve goes on outwards at lower frequencies.",
    )


def _poles(analysis: Analysis) -> Figure:
    unstable = int((analysis.radii >= 1).sum())
    inside = "All poles lie inside the circle" if analysis.stable else "A pole lies outside the circle"
    return Figure(f"{inside}; {unstable} of {len(analysis.radii)} drawn robots are unstable", analysis.plot_poles())
