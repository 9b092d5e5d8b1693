"""`upright reproduce`: the paper from end to end, into a folder with one page to open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from upright.atomic import write_json
from upright.control import lqr
from upright.errors import UprightError
from upright.paper import controllers, equations, linear_model, printed, pushes, regulator, sensors, turning
from upright.paper.finding import Finding, Progress, silent
from upright.paper.pushes import Trial
from upright.report import Page
from upright.robots import Kit, Robot

LIGHT, HEAVY = "nxtway-gs", "herrera2015"

TITLE = "The balancing robot of Herrera et al. (2015), reproduced"
LEAD = (
    "Herrera, Chamorro, Gómez and Camacho (2015) model the LEGO NXT balancing robot twice, put robot and models under "
    "one regulator, push them and compare. Here is all of it again, from their text: what follows from it, what does "
    "not, and what lies beyond. No curve of the authors’ robot survives, so a twin stands in for it."
)


@dataclass(frozen=True, eq=False)
class Reproduction:
    """Every finding, in the paper's order, and the folder it was written to."""

    findings: Sequence[Finding]
    folder: Path

    def __str__(self) -> str:
        width = max(len(f.title) for f in self.findings)
        rows = [f"{f.part:<3} {f.title:<{width}}  {f.verdict}\n{f.why(100)}" for f in self.findings]
        return "\n".join([*rows, "", f"wrote {self.folder / 'report.html'}, results.json and the logs beside it"])

    def to_json(self) -> dict[str, Any]:
        """All numbers, as written to results.json."""
        return {"versions": _versions(), "findings": [finding.to_json() for finding in self.findings]}


def reproduce(folder: str | Path = "herrera2015", progress: Progress = silent) -> Reproduction:
    """Run every chapter and write report.html, results.json and the logs into `folder`, which is made if need be.

    `progress` is called with the share done. Raises `UprightError` where the folder cannot be written.
    """
    target = _folder(folder)
    findings = chapters(progress)
    for finding in findings:
        for name, log in finding.logs.items():
            log.save(target / "logs" / f"{name}.parquet")
    done = Reproduction(findings, target)
    page = Page(TITLE, [f.section() for f in findings], LEAD, _versions())
    page.write(target / "report.html")
    write_json(target / "results.json", done.to_json())
    progress(1.0)
    return done


def chapters(progress: Progress = silent) -> list[Finding]:
    """The findings of every chapter, in the paper's order."""
    light, heavy, kit = Robot.preset(LIGHT), Robot.preset(HEAVY), Kit.preset("nxt")
    gains = regulator.printed_feedback()
    own = lqr(light, printed.PERIOD)
    why = "The printed gains do not hold this lighter robot; it has an LQR of its own."
    findings = equations.chapter(lambda share: progress(0.2 * share))
    findings += turning.chapter(lambda share: progress(0.2 + 0.1 * share))
    findings += linear_model.chapter(heavy, gains, kit)
    sensed = findings[-1].logs["identification-sensors"]
    findings.append(sensors.chapter(heavy, kit, sensed, lambda share: progress(0.3 + 0.1 * share)))
    progress(0.4)
    findings.append(regulator.chapter(light))
    progress(0.5)
    trials = [
        Trial(light, own, linear_model.identify(light, own)[1].model, why),
        Trial(heavy, gains, linear_model.identify(heavy, gains)[1].model, "The gains are the printed ones."),
    ]  # fmt: skip
    findings += pushes.chapter(trials, kit, lambda share: progress(0.5 + 0.25 * share))
    findings.append(controllers.chapter(light, kit, lambda share: progress(0.75 + 0.25 * share)))
    return findings


def _folder(folder: str | Path) -> Path:
    target = Path(folder).expanduser()
    try:
        (target / "logs").mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UprightError(f"cannot make {target}: {error.strerror}", hint="choose another folder with -o") from None
    return target


def _versions() -> dict[str, str]:
    return {name: version(name) for name in ("upright", "numpy", "scipy", "mujoco", "sympy")}
