"""The page of a `Certificate`: its light and reasons, every push, and what more delay and other periods do."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from upright.certify.certificate import GREEN, RED, Certificate, LinearMargins
from upright.certify.checks import Swept
from upright.report.figure import Figure, Panel, Trace
from upright.report.page import Cell, Item, Page, Section, Table, Verdict

LEVEL = {GREEN: "good", RED: "warn"}


def certificate_page(certificate: Certificate, path: str | Path) -> Path:
    """Write the certificate as one self-contained HTML page and return its path."""
    return page_of(certificate).write(path)


def page_of(certificate: Certificate) -> Page:
    """The certificate's page, not yet written."""
    verdict = Verdict(certificate.light, LEVEL.get(certificate.light, "info"))
    sections = [
        Section("In words", [f"{reason[0].upper()}{reason[1:]}." for reason in certificate.reasons], verdict),
        Section("Pushes", [_intro(certificate), _trials(certificate)]),
        Section("Nominal loop", [_linear(certificate.linear)] if certificate.linear else []),
    ]
    if certificate.later or certificate.slower:
        sections.append(Section("If the loop ran otherwise", _sweeps(certificate)))
    facts = {"controller": certificate.hash[:12], "seed": str(certificate.seed), "kit": certificate.kit}
    lead = "What is to be expected of this controller, computed before it drives."
    return Page(f"{certificate.controller} on {certificate.robot}", sections, lead, facts, False)


def _intro(c: Certificate) -> str:
    return (
        f"{c.samples} robots drawn from what is not known of {c.robot}, in the nonlinear model with the faults of kit "
        f"{c.kit}. {c.fell} of them fell in one of these trials or more; with 95 % confidence the chance of that is "
        f"below {100 * c.bound:.2g} %. The last four columns are what 95 % of the standing robots stay below."
    )


def _trials(c: Certificate) -> Table:
    rows: list[list[Cell]] = [
        [t.push, t.battery, t.runs, t.fell, 100 * t.saturated, t.travel, t.peak, t.cycle] for t in c.trials
    ]
    header = ["push", "battery", "robots", "fell", "saturated [%]", "travel [m]", "peak pitch [rad]", "sway [rad]"]
    return Table(header, rows, "Every standard push at every battery", 3)


def _linear(found: LinearMargins) -> Table:
    rows: list[list[Cell]] = [
        ["largest |pole|", found.radius],
        ["both motors as weak as", found.gain_low],
        ["both motors as strong as", found.gain_high],
        ["more dead time survived [ms]", found.delay * 1e3],
    ]
    return Table(["", "value"], rows, "Linear margins, broken at both motors", 4)


def _sweeps(c: Certificate) -> list[Item]:
    sweeps = {"further dead time": c.later, "period": c.slower}
    return [_figure(name, swept) for name, swept in sweeps.items() if len(swept) > 1]


def _figure(name: str, swept: Sequence[Swept]) -> Figure:
    milliseconds = [1e3 * s.value for s in swept]
    trace = Trace("fell", milliseconds, [100 * s.fell / s.runs for s in swept])
    title = f"Falls of {swept[0].runs} runs by {name}, which the controller does not know"
    return Figure(title, [Panel("fell", "%", [trace], limits=(-2.0, 102.0))], name, "ms")
