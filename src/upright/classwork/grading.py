"""Hand-ins of a folder, run again on this machine: what was claimed, what comes of it, and which are not genuine."""

from __future__ import annotations

import csv
import io
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.atomic import write_text
from upright.classwork.graded import CHANGED, COPIED, DIFFERS, EDITED, MEASURED, MISSED, OK, Grade, differs
from upright.classwork.tasks import task_of
from upright.errors import InvalidLog, UprightError, one_line
from upright.fleets.workers import end_with_parent, new_pool
from upright.interrupts import without_ctrl_c
from upright.lab.handin import HandIn, RunResult, read_hand_in
from upright.lab.rerun import rerun
from upright.lab.seat import TookTooLong, within
from upright.pages import Message, Quantity, Result, Say, english
from upright.progress import Progress, unwatched
from upright.reading import limit_memory

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page

LONGEST = 30.0
"""[s] of computing for one hand-in: the usual takes a quarter of a second, and the slowest design ten."""

MEMORY = 3 << 30
"""[bytes] of addresses for the process that runs a hand-in."""

MOST_FILES = 5000


class Grades(Result):
    """Every hand-in of a `folder`, by student and task."""

    def __init__(self, folder: str, rows: Sequence[Grade]) -> None:
        self.folder = folder
        self.rows = tuple(rows)

    def plot(self) -> Figure:
        """What came of the hand-ins of each task."""
        from upright.classwork.grade_page import draw_tasks

        return draw_tasks(self.rows)

    def page(self) -> Page:
        """The hand-ins for people."""
        from upright.classwork.grade_page import grade_page

        return grade_page(self.folder, self.rows)

    def to_json(self) -> dict[str, Any]:
        """Plain values: how many have each verdict, and every hand-in."""
        counts = Counter(one.verdict for one in self.rows)
        grades = [one.to_json() for one in self.rows]
        return {"schema": "upright/grade/1", "folder": self.folder, "counts": dict(counts), "grades": grades}

    def save(self, path: Path) -> Path:
        """Write CSV (RFC 4180); what a spreadsheet would take for a formula gets an apostrophe."""
        out = io.StringIO()
        writer = csv.writer(out)
        numbers = ("fell", *MEASURED)
        writer.writerow(["file", "student", "task", "verdict", "why",
                         *(f"{which}_{name}" for which in ("claimed", "replayed") for name in numbers)])  # fmt: skip
        for one in self.rows:
            results = [getattr(run, name) if run else "" for run in one.runs.values() for name in numbers]
            texts = (one.file, one.student, one.task, one.verdict, english(one.why) if one.why else "")
            writer.writerow([*map(_harmless, texts), *results])
        return write_text(path, out.getvalue())


def grade(folder: str | Path, *, workers: int = 0, progress: Progress = unwatched) -> Grades:
    """Run every hand-in (.json) of a folder again, in `workers` processes (0: one for each processor).

    A hand-in is ok where its run comes out as claimed, by outcome and `TOLERANCE`, and reaches its task's goal. Nothing
    in a file stops the others. Raises `InvalidLog` for a folder that cannot be read or has none.
    """
    files = _files(Path(folder))
    grades: dict[Path, Grade] = {}
    for path, one in _graded(files, workers or os.cpu_count() or 1):
        grades[path] = one
        progress(len(grades) / len(files))
    rows = _without_copies([grades[path] for path in files])
    return Grades(str(folder), sorted(rows, key=lambda g: (g.student.casefold() or "\uffff", g.task, g.file)))


def grade_file(path: Path) -> Grade:
    """One hand-in, run again here; whatever is in the file, nothing is raised."""
    try:
        done = read_hand_in(path)
    except (UprightError, OSError, RecursionError, MemoryError) as error:
        return Grade(file=path.name, why=Message(one_line(error)))
    task = task_of(done)
    first = Grade(
        file=path.name, student=done.student, task=task.name if task else "", claimed=done.claimed, run=done.run
    )
    if not done.sealed:
        return replace(first, verdict=EDITED, why=Say("the file was changed after the lab saved it"))
    try:
        with within(LONGEST):
            replayed = rerun(done)
    except TookTooLong:
        return replace(first, why=Say("it took longer than {limit} to run", limit=Quantity(LONGEST, "s")))
    except Exception as error:  # whatever a set-up does, the others are graded
        return replace(first, why=Say("it cannot be run: {error}", error=Message(one_line(error))))
    return _judged(replace(first, replayed=replayed), done, replayed)


def _judged(first: Grade, done: HandIn, replayed: RunResult) -> Grade:
    task = task_of(done)
    if why := differs(done.claimed, replayed):
        return replace(first, verdict=DIFFERS, why=why)
    if task and (why := task.differs(done.setup)):
        return replace(first, verdict=CHANGED, why=why)
    why = task.goal(done, replayed) if task else None
    return replace(first, verdict=MISSED if why else OK, why=why)


def _files(folder: Path) -> list[Path]:
    """The regular files .json of a folder; no link, pipe or folder is opened."""
    try:
        with os.scandir(folder) as entries:
            names = sorted(e.name for e in entries if e.name.endswith(".json") and e.is_file(follow_symlinks=False))
    except OSError as error:
        raise InvalidLog(f"cannot read the folder {folder}: {error.strerror}", expected="a folder") from None
    if not 0 < len(names) <= MOST_FILES:
        raise InvalidLog(f"{folder} holds {len(names)} files .json", expected=f"1 to {MOST_FILES} hand-ins")
    return [folder / name for name in names]


def _graded(files: Sequence[Path], workers: int) -> Iterator[tuple[Path, Grade]]:
    """Grades as they come. Where a process dies, those that it leaves are run one by one."""
    left = list(files)
    with new_pool(min(workers, len(files)), _modest) as pool:
        waiting: dict[Future[Grade], Path] = {_begun(pool, path): path for path in files}
        while waiting:
            ended, _ = wait(waiting, return_when=FIRST_COMPLETED)
            for future in ended:
                path = waiting.pop(future)
                if isinstance(future.exception(), BrokenProcessPool):
                    continue
                left.remove(path)
                yield path, future.result()
    for path in left:
        with new_pool(1, _modest) as alone:
            try:
                yield path, _begun(alone, path).result()
            except BrokenProcessPool:
                yield path, Grade(file=path.name, why=Say("the process that ran it died"))


def _begun(pool: ProcessPoolExecutor, path: Path) -> Future[Grade]:
    with without_ctrl_c():
        return pool.submit(grade_file, path)


def _modest() -> None:
    """What a file from anywhere may take of this machine, and no warning of its numbers."""
    import warnings

    end_with_parent()
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    warnings.simplefilter("ignore")
    limit_memory(MEMORY)


def _without_copies(grades: Sequence[Grade]) -> list[Grade]:
    """The same run under another name is a copy: nobody knows which was first, so that all are reported."""
    genuine = [g for g in grades if g.verdict in (OK, MISSED, CHANGED)]
    owners: dict[str, set[str]] = {}
    for g in genuine:
        owners.setdefault(g.run, set()).add(g.student)
    return [
        replace(g, verdict=COPIED, why=Say("the same run as {others}", others=sorted(owners[g.run] - {g.student})))
        if g in genuine and len(owners[g.run]) > 1
        else g
        for g in grades
    ]


def _harmless(text: str) -> str:
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text
