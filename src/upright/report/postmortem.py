"""The page of a `PostMortem`: the causes with their evidence, and the last seconds with the onset marked."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from upright.diagnose import PostMortem
from upright.diagnose.verdict import NO_FALL
from upright.report.figure import Figure, Panel, Trace
from upright.report.page import Cell, Item, Page, Section, Table, Verdict

SHOWN = 0.02
"""Causes less likely than this are left to the JSON."""


def postmortem_page(found: PostMortem, path: str | Path) -> Path:
    """Write the post-mortem as one self-contained HTML page and return its path."""
    return page_of(found).write(path)


def page_of(found: PostMortem) -> Page:
    """The post-mortem's page, not yet written."""
    level = "good" if found.verdict == NO_FALL else "warn" if found.fell else "info"
    sections = [Section("Why", [*_words(found), _causes(found)] if found.causes else _words(found),
                        Verdict(found.verdict, level))]  # fmt: skip
    if len(found.series.t) > 1:
        sections.append(Section("The last seconds", [_figure(found), _READ]))
    facts = {"robot": found.robot, "kit": found.kit, "samples": str(found.rows)}
    facts |= {"controller": f"{found.controller}, {found.hash[:12]}"} if found.controller else {}
    title = f"Why {found.robot} fell" if found.fell else f"{found.robot}: {found.verdict}"
    return Page(title, sections, _lead(found), facts, twin_note=False)


_READ = (
    "Reach used is the lean in the direction of the fall over what the motors can still bring back, of which 1 is the "
    "point of no return. NIS is the mean square of the filter's innovations over a tenth of a second, over what the "
    "filter expects; between the dashed lines it stays in 95 of 100 cases where robot and sensors are as they should."
)


def _lead(found: PostMortem) -> str:
    if not found.fell:
        return "What the log says of the robot's balance."
    return f"Its lean passed 0.7 rad for good at t = {found.fell_at:.2f} s. Times are those of the log."


def _words(found: PostMortem) -> list[Item]:
    missing = [f"Missing for more: {', '.join(found.missing)}."] if found.missing else []
    return [*missing, *(f"{note[0].upper()}{note[1:]}." for note in found.notes)]


def _causes(found: PostMortem) -> Table:
    rows: list[list[Cell]] = [
        [c.name, f"{100 * c.likelihood:.0f} %", f"{c.evidence}.", c.repair]
        for c in found.causes
        if c.likelihood >= SHOWN
    ]
    return Table(["cause", "likelihood", "evidence", "repair"], rows)


def _figure(found: PostMortem) -> Figure:
    s = found.series
    band = [Trace(f"{side} of 95 %", s.t[[0, -1]], [level] * 2, style=3) for side, level in _levels(found)]
    nis = np.maximum(s.nis, 1e-3)
    panels = [
        Panel("Pitch", "rad", [Trace("pitch", s.t, s.pitch, style=0)]),
        Panel("Command over the largest", "1", [Trace("command", s.t, s.command, step=True, style=1)], (-1.5, 1.5)),
        Panel("Reach used", "1", [Trace("reach used", s.t, s.reserve, style=2)], (0.0, 1.5)),
        Panel("log₁₀ NIS", "1", [Trace("NIS", s.t, np.log10(nis), style=4), *band]),
    ]
    spans = [(found.onset, found.fell_at)] if found.fell and math.isfinite(found.onset) else []
    spans = [(max(a, float(s.t[0])), b) for a, b in spans]
    return Figure("From the onset to the fall", panels, spans=spans, span_name="from onset to fall")


def _levels(found: PostMortem) -> list[tuple[str, float]]:
    levels = {"lower edge": found.series.low, "upper edge": found.series.high}
    return [(name, math.log10(level)) for name, level in levels.items() if math.isfinite(level) and level > 0]
