"""The page of a `PostMortem`: the causes with their evidence, and the last seconds with the onset marked."""

from __future__ import annotations

import math

import numpy as np

from upright.diagnose import PostMortem
from upright.diagnose.causes import NO_FALL
from upright.diagnose.fall import LEANING
from upright.plotting import line, numbered, panels, span
from upright.report.figure import Figure
from upright.report.page import Cell, Item, Page, Section, Table, Verdict
from upright.tables import sentence

CUT = 1.2  # of the largest command: a law may ask for much more
SHOWN = 0.02
"""Less likely causes are only in the JSON."""


def page_of(result: PostMortem) -> Page:
    """The post-mortem's page, not yet written."""
    level = "good" if result.verdict == NO_FALL else "warn" if result.fell else "info"
    evidence = [*_words(result), *([_causes(result)] if result.causes else [])]
    sections = [Section("Cause", evidence)] if evidence else []
    drawn = len(result.series.t) > 1
    if drawn:
        sections.append(Section("Reading the figure", [_READ]))
    facts = {"robot": result.robot, "kit": result.kit, "samples": str(result.rows)}
    facts |= {"controller": f"{result.controller}, {result.hash[:12]}"} if result.controller else {}
    title = f"Why {result.robot} fell: {result.verdict}" if result.fell else f"{result.robot}: {result.verdict}"
    return Page(
        title, sections, _lead(result), facts, False, verdict=Verdict(result.verdict, level),
        picture=_figure(result) if drawn else None,
        numbers=[
            (f"{100 * c.likelihood:.0f} %", f"probability of: {c.name}")
            for c in result.causes[:3]
            if c.likelihood >= SHOWN
        ],
    )  # fmt: skip


_READ = (
    "Shaded: from the onset to the fall. Dashed in the first panel: 0.7 rad, which counts as the fall. The second "
    "panel divides the lean by the largest one that the motors can recover from; dashed: the point of no return. NIS "
    "is the mean normalised innovation squared over a tenth of a second. Without faults it stays between the dashed "
    "lines in 95 of 100 cases."
)


def _lead(result: PostMortem) -> str:
    if not result.fell:
        return "The robot did not fall in this log."
    text = f"It fell at t = {result.fell_at:.2f} s of the log: the lean passed 0.7 rad (40°)."
    best = result.causes[0].evidence if result.causes else ""
    return f"{text} {sentence(best.split('; ')[0].split('. ')[0])}" if best else text


def _words(result: PostMortem) -> list[Item]:
    missing = [f"Missing channels: {', '.join(result.missing)}."] if result.missing else []
    return [*missing, *map(sentence, result.notes)]


def _causes(result: PostMortem) -> Table:
    rows: list[list[Cell]] = [
        [c.name, f"{100 * c.likelihood:.0f} %", f"{c.evidence}.", c.repair]
        for c in result.causes
        if c.likelihood >= SHOWN
    ]
    return Table(["cause", "likelihood", "evidence", "repair"], rows)


def _figure(result: PostMortem) -> Figure:
    s = result.series
    labels = [
        "pitch [rad]", "lean / largest lean to recover from [1]", f"command / largest command, cut at {CUT:g} [1]",
        "NIS = squared innovation / expected [1]",
    ]  # fmt: skip
    figure, axes = panels(labels, height=1.35)
    pitch, reach, command, nis = axes
    line(pitch, "pitch", s.t, s.pitch, style=0, solid=True)
    for level in (-LEANING, LEANING):
        if np.nanmin(s.pitch) < level < np.nanmax(s.pitch):
            line(pitch, "_fall", s.t[[0, -1]], [level] * 2, style=5)
    line(command, "command", s.t, np.clip(s.command, -CUT, CUT), step=True, style=1, solid=True)
    line(reach, "lean", s.t, s.reserve, style=2, solid=True)
    line(reach, "_no return", s.t[[0, -1]], [1.0] * 2, style=5)
    nis.set_yscale("log")
    numbered(nis.yaxis)
    line(nis, "NIS", s.t, np.maximum(s.nis, 1e-3), style=4, solid=True)
    for level in (s.low, s.high):
        if math.isfinite(level) and level > 0:
            line(nis, "_usual", s.t[[0, -1]], [level] * 2, style=5)
    command.set_ylim(-1.5, 1.5)
    reach.set_ylim(0, 1.5)
    if result.fell and math.isfinite(result.onset):
        span(axes, max(result.onset, float(s.t[0])), result.fell_at, "_trouble")
    known = result.fell and math.isfinite(result.onset)
    title = (
        f"The trouble begins at {result.onset:.2f} s, and the lean passes 0.7 rad at {result.fell_at:.2f} s (shaded)"
        if known
        else "The last seconds"
    )
    return Figure(title, figure)
