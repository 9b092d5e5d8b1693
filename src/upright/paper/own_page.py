"""`upright reproduce --log`: a robot of one's own in the paper's figures, into a folder with one page to open."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from upright.atomic import make_folder, write_json
from upright.comparison.runs import DIVERGED, NEGLIGIBLE
from upright.control import Controller
from upright.experiment.pushes import PushProgramme
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import LogSource
from upright.paper.own_log import OwnRobot, compare_own
from upright.paper.pushes import FIGURES, NAMED
from upright.progress import Progress, unwatched
from upright.reports import Details, Figure, Page, Section, Table
from upright.reports.page import Cell, Item, cell_text
from upright.reports.states import fit_table, metrics_table, state_figure
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES
from upright.tables import Shown, sentence

_HOW = (
    "The models start from the first state of the log and get its push and its law, and no reading. Nonlinear and "
    "linear model have the numbers of the robot's file, ideal sensors and no dead time, like the paper's simulations. "
    "The last run has the calibrated numbers, where there are any, and the robot's electronics."
)
UNSETTLED = "The robot swings at the end as much as after any push: no settling time is given."
STILL = "The robot turns by less than 1°: yaw and its rate are not drawn."
_ADJUSTED = (
    "Each line is put right on top of those above it: what brings the nonlinear model nearest to the settling time of "
    "the robot, or to its pitch round the push where the robot never settles. Settled is 5 % of the largest deviation "
    "from where pitch comes to rest, or what the resting robot swings, if that is more."
)


@dataclass(frozen=True, eq=False, repr=False)
class OwnReproduction(Shown):
    """What came of it, and the output folder."""

    result: OwnRobot
    folder: Path

    def __str__(self) -> str:
        r = self.result
        settled = _settled(r) if r.settles else UNSETTLED
        lines = [f"law: {r.law}", r.push, "", str(r.comparison), "", settled, r.answer, *r.notes]
        return "\n".join([*lines, "", f"wrote {self.folder / 'report.html'}, results.json and the logs beside it"])

    def page(self) -> Page:
        """The page as written to report.html."""
        return page_of(self.result)

    def to_json(self) -> dict[str, Any]:
        """All numbers, as written to results.json."""
        return self.result.to_json()


def reproduce_log(
    folder: str | Path,
    log: LogSource,
    robot: Robot | str | Path,
    kit: Kit | str | None = None,
    *,
    controller: Controller | str | Path | None = None,
    push: Sequence[PushProgramme] = (),
    learnt: Robot | str | Path | None = None,
    mapping: Columns | str | None = None,
    progress: Progress = unwatched,
) -> OwnReproduction:
    """`compare_own` with its page report.html, results.json and the logs, written into `folder`, which is created if
    missing. Raises `UprightError` where that cannot be written."""
    target = make_folder(Path(folder) / "logs").parent
    result = compare_own(
        log, robot, kit, controller=controller, push=push, learnt=learnt, mapping=mapping, progress=progress
    )
    for label, one in result.comparison.logs.items():
        one.save(target / "logs" / f"{label.replace(' ', '-')}.parquet")
    done = OwnReproduction(result, target)
    done.page().write(target / "report.html")
    write_json(target / "results.json", done.to_json())
    return done


def _settled(result: OwnRobot) -> str:
    times = ", ".join(f"{n} {'never' if math.isnan(t) else f'{t:.2f} s'}" for n, t in result.settling.items())
    return f"Pitch settles to {100 * result.band:.0f} % in: {times}"


def _is_still(result: OwnRobot, state: str) -> bool:
    """Whether the robot turns by no more than a compass shows."""
    reference = result.comparison.reference
    values = result.comparison.logs[reference][f"{result.comparison.sources[reference]}/{state}"]
    return float(np.ptp(values)) <= NEGLIGIBLE.get(state, -1.0)


def page_of(result: OwnRobot) -> Page:
    """The page, not yet written."""
    comparison = result.comparison
    numbered = FIGURES[result.side]
    moving = [name for name in STATE_NAMES if not _is_still(result, name)]
    figures: list[Figure] = []
    for state in moving:
        drawn = state_figure(comparison, state)
        drawn = replace(drawn, title=_settled(result)) if state == "pitch" and result.settles else drawn
        title = f"Figure {numbered[state]} again. {drawn.title}" if state in numbered else drawn.title
        figures.append(replace(drawn, title=title))
    still: list[Item] = [] if len(moving) == len(STATE_NAMES) else [STILL]
    within = f"{100 * result.band:.0f} %"
    settling = [
        ("diverges" if fit < DIVERGED else f"{cell_text(fit, 3)} %", f"{label}: fit of pitch to the robot's")
        for label, fit in result.fits.items() if label != comparison.reference
    ] if not result.settles else [
        ("never" if math.isnan(time) else f"{cell_text(time, 3)} s", f"{label}: settles to {within}")
        for label, time in result.settling.items()
    ]  # fmt: skip
    rows: list[list[Cell]] = [[a.name, a.change, a.settling, a.fit] for a in result.adjusted]
    table: list[Item] = [Table(["", "change", "settles in [s]", "fit of pitch [%]"], rows, digits=3)] if rows else []
    sections = [
        Section(
            "What must be adjusted",
            [
                result.answer,
                *([] if result.settles else [UNSETTLED]),
                *([_ADJUSTED] if rows else []),
                *table,
                *result.notes,
            ],
        ),
        Section(f"{NAMED[result.side].capitalize()}, of this robot", [*figures[1:], *still]),
        Section("Numbers", [metrics_table(comparison), fit_table(comparison)]),
        Section("How this was done", [_HOW, Details("Law and push", [f"Law: {result.law}.", sentence(result.push)])]),
    ]
    title = f"{result.robot.name} in the experiment of Herrera et al. (2015)"
    return Page(
        title, sections, result.answer, {}, "twin" in comparison.reference, picture=figures[0], numbers=settling
    )
