"""Hand-ins of a folder, run again on this machine: what was claimed, what comes of it, and which are not genuine."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.atomic import write_text
from upright.classwork.tasks import task_of
from upright.errors import InvalidLog, UprightError, one_line
from upright.fleets.workers import end_with_parent, new_pool
from upright.interrupts import without_ctrl_c
from upright.lab.handin import HandIn, RunResult, read_hand_in
from upright.lab.rerun import rerun
from upright.lab.seat import TookTooLong, within
from upright.progress import Progress, unwatched
from upright.reading import limit_memory
from upright.tables import Listing, Shown

if TYPE_CHECKING:
    from upright.reports import Page

OK, MISSED, DIFFERS, EDITED, COPIED, CHANGED, BROKEN = (
    "ok", "not reached", "differs", "edited", "copied", "other set-up", "broken",
)  # fmt: skip
FORGED = (DIFFERS, EDITED, COPIED)

LONGEST = 30.0
"""[s] of computing for one hand-in: the usual takes a quarter of a second, and the slowest design ten."""

MEMORY = 3 << 30
"""[bytes] of addresses for the process that runs a hand-in."""

MOST_FILES = 5000

TOLERANCE = {"seconds": (0.25, 0.0), "peak": (0.01, 0.05), "travel": (0.02, 0.05), "best": (0.003, 0.02)}
"""Largest difference between two machines: absolute [s, rad, m, N s], and as a fraction. They differ in the last bit of
a reading, and a reading in one step of an encoder (0.017 rad of a wheel); a fall is passed through within 0.25 s."""


@dataclass(frozen=True, kw_only=True)
class Grade:
    """One hand-in: its `verdict`, and in `why` the sentence to it."""

    file: str
    student: str = ""
    task: str = ""
    claimed: RunResult | None = None
    replayed: RunResult | None = None
    verdict: str = BROKEN
    why: str = ""
    run: str = ""


@dataclass(frozen=True, eq=False, repr=False)
class Grades(Shown):
    """Every hand-in of a folder, by student and task."""

    folder: str
    rows: tuple[Grade, ...]

    def listing(self) -> Listing:
        """Student, task, outcome claimed and replayed, verdict and why."""
        cells = [(g.student or g.file, g.task, _shown(g.claimed), _replayed(g), g.verdict, g.why) for g in self.rows]
        return Listing(("student", "task", "claimed", "replayed", "verdict", "why"), cells)

    def count(self, *verdicts: str) -> int:
        """How many have one of these verdicts."""
        return sum(g.verdict in verdicts for g in self.rows)

    @property
    def summary(self) -> str:
        """One sentence."""
        parts = [
            f"{self.count(OK)} of {len(self.rows)} hand-ins reach their goal", f"{self.count(MISSED, CHANGED)} do not",
            f"{self.count(*FORGED)} are not genuine", f"{self.count(BROKEN)} cannot be read",
        ]  # fmt: skip
        return ", ".join(parts)

    def __str__(self) -> str:
        return f"{self.listing()}\n\n{self.summary}"

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        return {"folder": self.folder, "summary": self.summary, "grades": [asdict(g) for g in self.rows]}

    def save(self, path: Path) -> Path:
        """Write CSV (RFC 4180); what a spreadsheet would take for a formula gets an apostrophe."""
        out = io.StringIO()
        writer = csv.writer(out)
        numbers = ("fell", "seconds", "peak", "travel", "best")
        writer.writerow(["file", "student", "task", "verdict", "why",
                         *(f"{which}_{name}" for which in ("claimed", "replayed") for name in numbers)])  # fmt: skip
        for g in self.rows:
            results = [getattr(r, name) if r else "" for r in (g.claimed, g.replayed) for name in numbers]
            writer.writerow([*map(_harmless, (g.file, g.student, g.task, g.verdict, g.why)), *results])
        return write_text(path, out.getvalue())

    def page(self) -> Page:
        """The table as a page, not yet written."""
        from upright.reports import Page, Section, Table, Verdict

        table = self.listing()
        forged = self.count(*FORGED)
        broken = self.count(BROKEN)
        rows = dict(zip(self.rows, table.rows, strict=True))
        wrong = [g for g in self.rows if g.verdict in (*FORGED, BROKEN)]
        parts = {"To look at": wrong, "As claimed": [g for g in self.rows if g not in wrong]}
        return Page(
            f"Hand-ins: {self.summary}",
            [Section(head, [Table(table.header, [rows[g] for g in some])]) for head, some in parts.items() if some],
            f"{wrong[0].student or wrong[0].file}: {wrong[0].why}." if wrong else "", {"folder": self.folder}, False,
            verdict=Verdict("to look at", "warn") if wrong else Verdict("all genuine", "good"),
            numbers=[(str(len(self.rows)), "hand-ins"), (str(forged), "not genuine"), (str(broken), "cannot be read")],
        )  # fmt: skip


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
    return Grades(str(folder), tuple(sorted(rows, key=lambda g: (g.student.casefold() or "\uffff", g.task, g.file))))


def grade_file(path: Path) -> Grade:
    """One hand-in, run again here; whatever is in the file, nothing is raised."""
    try:
        done = read_hand_in(path)
    except (UprightError, OSError, RecursionError, MemoryError) as error:
        return Grade(file=path.name, why=one_line(error))
    task = task_of(done)
    first = Grade(
        file=path.name, student=done.student, task=task.name if task else "", claimed=done.claimed, run=done.run
    )
    if not done.sealed:
        return replace(first, verdict=EDITED, why="the file was changed after the lab saved it")
    try:
        with within(LONGEST):
            replayed = rerun(done)
    except TookTooLong:
        return replace(first, why=f"it took longer than {LONGEST:g} s to run")
    except Exception as error:  # whatever a set-up does, the others are graded
        return replace(first, why=f"it cannot be run: {one_line(error)}")
    return _judged(replace(first, replayed=replayed), done, replayed)


def _judged(first: Grade, done: HandIn, replayed: RunResult) -> Grade:
    task = task_of(done)
    if why := differs(done.claimed, replayed):
        return replace(first, verdict=DIFFERS, why=why)
    if task and (why := task.differs(done.setup)):
        return replace(first, verdict=CHANGED, why=why)
    why = task.goal(done, replayed) if task else ""
    return replace(first, verdict=MISSED if why else OK, why=why)


def differs(claimed: RunResult, replayed: RunResult) -> str:
    """How a claim differs from the replay by more than two machines do, in words; '' where it does not."""
    if claimed.fell != replayed.fell:
        words = {True: f"fell at {replayed.seconds:.2f} s", False: "did not fall"}
        return f"claimed that it {'fell' if claimed.fell else 'stood'}; replayed, it {words[replayed.fell]}"
    numbers = ("seconds",) if claimed.fell else TOLERANCE  # a fall magnifies what differs, but for its time
    for name in numbers:
        absolute, relative = TOLERANCE[name]
        before, now = getattr(claimed, name), getattr(replayed, name)
        if abs(before - now) > absolute + relative * abs(now):
            return f"claimed {name} {before:.3g}; replayed, it is {now:.3g}"
    return ""


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
                yield path, Grade(file=path.name, why="the process that ran it died")


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
        replace(g, verdict=COPIED, why=f"the same run as {', '.join(sorted(owners[g.run] - {g.student}))}")
        if g in genuine and len(owners[g.run]) > 1
        else g
        for g in grades
    ]


def _harmless(text: str) -> str:
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text


def _shown(result: RunResult | None) -> str:
    return str(result) if result else ""


def _replayed(g: Grade) -> str:
    return "as claimed" if g.replayed and g.verdict != DIFFERS else _shown(g.replayed)
