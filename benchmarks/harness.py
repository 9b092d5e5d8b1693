"""What the benchmarks share: options, the machine in a line, timing, cases that resume, shares with intervals, tables.

Import it before NumPy: it keeps the linear algebra to one thread, and finds what is planted in `tests/planted`.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import re
import sys
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # many small products gain nothing by threads
TESTS = Path(__file__).resolve().parents[1] / "tests"
sys.path.insert(0, str(TESTS))
DATA = TESTS.parents[1] / "shared" / "data"  # logs that others made, which are not part of the project


def options(doc: str | None, *positional: tuple[str, Any], **defaults: Any) -> argparse.Namespace:
    """The options of a script, each of the kind of its default: a tuple takes several values, False is a switch, and a
    type stands for an option that may be left out. A positional argument with a type must be given."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name, default in (*positional, *defaults.items()):
        flag = name if (name, default) in positional else f"--{name.replace('_', '-')}"
        if default is False:
            parser.add_argument(flag, action="store_true")
        elif isinstance(default, tuple):
            parser.add_argument(flag, nargs="*", type=type(default[0]) if default else str, default=default)
        elif isinstance(default, type):
            parser.add_argument(flag, type=default)
        else:
            optional = {"nargs": "?"} if flag == name else {}
            parser.add_argument(flag, type=type(default), default=default, **optional)
    return parser.parse_args()


def machine(*packages: str) -> None:
    """Print what a figure depends on: processor, cores, load, and the versions of Python and of `packages`."""
    chip = platform.processor() or platform.machine()
    versions = "".join(f", {name} {version(name)}" for name in packages)
    print(
        f"{chip}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}; Python {platform.python_version()}{versions}"
    )


class Clock:
    """What has passed since it was made [s]: on the wall, and of processors with the children that have ended."""

    def __init__(self) -> None:
        self._wall, self._spent = time.perf_counter(), self._now()

    @staticmethod
    def _now() -> float:
        children = os.times()
        return time.process_time() + children.children_user + children.children_system

    @property
    def wall(self) -> float:
        return time.perf_counter() - self._wall

    @property
    def cpu(self) -> float:
        return self._now() - self._spent

    def __str__(self) -> str:
        return f"{self.wall:.1f} s, {self.cpu:.1f} s of processors"


def best(
    jobs: dict[str, Callable[[], object]], repeats: int, clock: Callable[[], float] = time.perf_counter
) -> dict[str, float]:
    """The shortest time [s] of each job, taken in turns after one that does not count, so that a ratio compares like
    with like on a busy machine; `time.thread_time` leaves out what other programs took."""
    found = dict.fromkeys(jobs, float("inf"))
    for job in jobs.values():
        job()
    for _ in range(repeats):
        for name, job in jobs.items():
            began = clock()
            job()
            found[name] = min(found[name], clock() - began)
    return found


def cases(
    judge: Callable[[Any], Any], keys: Sequence[Any], kind: type, workers: int = 1, results: Path | None = None
) -> list[Any]:
    """What `judge` says of every key, each a dataclass of that `kind`, printed as it comes. `results` is a file of
    lines to which answers are added: none is made twice, so that a run that was interrupted goes on."""
    lines = results.read_text("utf-8").splitlines() if results and results.exists() else []
    found = {json.dumps(line["key"]): kind(**line["told"]) for line in map(json.loads, lines)}
    new = [key for key in keys if json.dumps(key) not in found]
    with ProcessPoolExecutor(max(1, workers)) as pool:
        told = pool.map(judge, new) if workers > 1 else map(judge, new)
        for done, (key, one) in enumerate(zip(new, told, strict=True), 1):
            found[json.dumps(key)] = one
            if results:
                with results.open("a", encoding="utf-8") as file:
                    file.write(json.dumps({"key": key, "told": asdict(one)}) + "\n")
            print(f"{done}/{len(new)} {one}", flush=True)
    return list(found.values())


def share(right: int, count: int) -> str:
    """So many of so many, with Wilson's interval at 95 %."""
    if not count:
        return "0 of 0"
    from scipy.stats import binomtest

    low, high = binomtest(right, count).proportion_ci(method="wilson")
    return f"{right} of {count} ({right / count:.1%}, {low:.0%} to {high:.0%})"


class Held:
    """How often the intervals of each number hold its truth."""

    def __init__(self) -> None:
        self.by_name: dict[str, list[bool]] = {}

    def add(self, name: str, held: bool) -> bool:
        self.by_name.setdefault(name, []).append(bool(held))
        return held

    def __str__(self) -> str:
        every = [one for several in self.by_name.values() for one in several]
        missed = {name: f"{len(v) - sum(v)} of {len(v)}" for name, v in self.by_name.items() if not all(v)}
        words = ", ".join(f"{name} {count}" for name, count in missed.items()) or "none"
        return f"truth inside {share(sum(every), len(every))} intervals; missed: {words}"


class Table:
    """Prints a head, and then rows under it: a column is a name, a space and a format with its width, as
    "median >9.2f". A text in a column of numbers is only aligned."""

    def __init__(self, *columns: str) -> None:
        names, self._formats = zip(*(column.rsplit(" ", 1) for column in columns), strict=True)
        self.row(*names)

    def row(self, *cells: Any) -> None:
        pairs = zip(cells, self._formats, strict=False)
        print("".join(format(c, _aligned(f) if isinstance(c, str) else f) for c, f in pairs).rstrip(), flush=True)


def _aligned(form: str) -> str:
    return "".join(re.findall(r"^[<>]?\d+", form))
