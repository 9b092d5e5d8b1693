"""Hand-ins to try `upright grade` on: what a class of three might have saved."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from upright.atomic import make_folder
from upright.classwork.tasks import TASKS
from upright.errors import UprightError
from upright.lab.handin import HandIn, RunResult, write_hand_in
from upright.lab.messages import Strike
from upright.lab.plant import COARSE
from upright.lab.rerun import rerun

SECONDS = 6.0
KNOCKS = {"Ana": 0.25, "Luis": 0.1, "Eva": 0.28}
"""[N s] The first task asks for 0.2 at least."""

BOASTED = 0.4
"""[N s] What Eva claims."""


def hand_ins(folder: Path) -> Path:
    """Write three hand-ins of the first task: one reaches its goal, one does not, and one claims more than it did.

    Raises `UprightError` where the folder already holds something.
    """
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise UprightError(f"{folder} is there already", expected="an empty folder, or none", hint="-o another-folder")
    make_folder(folder)
    for student, size in KNOCKS.items():
        done = _done(student, size)
        claimed = replace(done.claimed, best=BOASTED) if student == "Eva" else done.claimed
        write_hand_in(replace(done, claimed=claimed), folder / f"{student}.json")
    return folder


def _done(student: str, size: float) -> HandIn:
    nothing = RunResult(fell=False, seconds=0.0, peak=0.0, travel=0.0, best=0.0)
    done = HandIn(
        student=student, setup=TASKS[0].setup, step=COARSE, lean=0.0, seconds=SECONDS,
        actions=((1.0, Strike("impulse", size)),), claimed=nothing,
    )  # fmt: skip
    return replace(done, claimed=rerun(done))
