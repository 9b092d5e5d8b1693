"""The page of a class's hand-ins: how many reach their goal, and which of them to look at."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.classwork.graded import MEASURED, SHOWN, Grade
from upright.classwork.tasks import TASKS
from upright.languages import chosen
from upright.pages import Column, Fold, KeyNumber, Next, Page, Picture, Say, Table, Verdict

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GROUPS = {("good",): Say("ok"), ("warn",): Say("not reached"), ("bad", "unknown"): Say("to look at")}
"""Levels of verdicts that a picture draws alike."""

_STUDENT, _TASK = Column(Say("student")), Column(Say("task"))


def grade_page(folder: str, grades: Sequence[Grade]) -> Page:
    """The page of the hand-ins of a folder."""
    wrong = [one for one in grades if one.level in ("bad", "unknown")]
    genuine = [one for one in grades if one not in wrong]
    return Page(
        Say("{ok} of {n} hand-ins reach their goal", ok=_count(grades, "good"), n=len(grades)),
        verdict=Verdict(Say("{n} to look at", n=len(wrong)), "warn") if wrong else Verdict(Say("all genuine"), "good"),
        lead=[Say("Every hand-in was run again on this computer.")],
        numbers=[
            KeyNumber(_count(grades, "warn"), Say("as claimed, but not at the goal")),
            KeyNumber(_count(grades, "bad"), Say("not genuine")),
            KeyNumber(_count(grades, "unknown"), Say("cannot be run")),
        ],
        picture=Picture(Say("What came of the hand-ins of each task"), lambda: draw_tasks(grades)),
        next=[Next("grade", folder, output="grades.csv", why=Say("A table for a spreadsheet."))],
        blocks=[
            _verdicts([*wrong, *genuine]),
            Fold(Say("What was claimed, and what came of it"), [_results(grades)]),
        ],
        origin={"folder": folder},
    )  # fmt: skip


def _count(grades: Sequence[Grade], *levels: str) -> int:
    return sum(one.level in levels for one in grades)


def _verdicts(grades: Sequence[Grade]) -> Table:
    rows = [[one.student or one.file, _title(one.task), SHOWN[one.verdict], one.why or ""] for one in grades]
    return Table([_STUDENT, _TASK, Column(Say("verdict")), Column(Say("why"))], rows)


def _results(grades: Sequence[Grade]) -> Table:
    rows = [
        [one.student or one.file, _title(one.task), source, run.fell, *(getattr(run, name) for name in MEASURED)]
        for one in grades
        for source, run in ((Say("claimed"), one.claimed), (Say("run again"), one.replayed))
        if run
    ]
    numbers = [Column(what, unit) for what, unit in MEASURED.values()]
    return Table([_STUDENT, _TASK, Column(Say("of")), Column(Say("fell")), *numbers], rows)


def _title(name: str) -> str | None:
    """A task's title on the worksheet; None for a run of one's own."""
    return next((task.texts[chosen()][0] for task in TASKS if task.name == name), None)


def draw_tasks(grades: Sequence[Grade]) -> Figure:
    """For each task the number of its hand-ins that reach the goal, that do not, and that are to be looked at."""
    from matplotlib.ticker import MaxNLocator

    from upright.plotting import COLOURS, legend, rows_of

    tasks = list(dict.fromkeys(one.task for one in grades))
    names = [_title(task) or str(Say("no task")) for task in tasks]
    figure, ax = rows_of(names, str(Say("hand-ins")), str(Say("task")))
    begin = np.zeros(len(tasks))
    looks: list[dict[str, Any]] = [{"color": COLOURS[0]}, {"color": COLOURS[0], "alpha": 0.35}, {"color": COLOURS[1]}]
    for (levels, name), look in zip(GROUPS.items(), looks, strict=True):
        counts = [_count([one for one in grades if one.task == task], *levels) for task in tasks]
        ax.barh(range(len(tasks)), counts, left=begin, height=0.6, label=str(name), **look)
        begin += counts
    ax.xaxis.set_major_locator(MaxNLocator(integer=True))
    return legend(figure)
