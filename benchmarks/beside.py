"""Are two programs' numbers equal on logs of others: every number of the JSON of several commands, to 1e-6.

    python benchmarks/beside.py "env PYTHONPATH=/old/src python -m upright" "python -m upright"
    python benchmarks/beside.py OLD NEW --commands doctor calibrate --only twipr --results found.jsonl   # again resumes

A number that only one of them has, and words, are counted apart. Times are of the processor, theirs included.
"""

from __future__ import annotations

import json
import os
import resource
import shlex
import subprocess
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import harness

EQUAL = 1e-6  # of the larger of the two
ZERO = 1e-12  # what differs by less is rounding
IGNORED = {"seconds", "version", "versions", "took", "created", "upright"}  # of a run, not of its robot
NAMES = ("name", "code", "channel", "cause")  # by which one of a list is found again, and not by its place
LONGEST = 360  # [s] of processor for one call
OPTIONS = {"identify": ("--repeats", "0")}
"""No simulated logs, whose noise is drawn."""

KEPT, WORDS = 6, 160  # differences that are printed, and letters of each

EV3 = "ev3way-large-wheels"
LOGS = {
    **dict.fromkeys((f"data/ev3way/{n}.csv" for n in ("nn_v16_002", "nn_v7_000", "nn_v6_001", "nn_v17_005")), EV3),
    "data/ev3way/tilt_000.csv": EV3,
    "data/ev3-balanc3r/datalog.json.txt": "ev3way",
    **dict.fromkeys((f"data/twipr/{n}.csv" for n in ("run1", "new_dive_1_all", "direct_1_all", "run2_all")), "twipr"),
    **dict.fromkeys(
        (f"data/regbot/{n}.txt" for n in ("position_step_2m", "balance_rest", "square_08", "wheel_speed_upside_down")),
        "data/regbot/regbot.toml",
    ),
    "data/balboa/standing.txt": "nxtway-gs",
    "cases/half-gyro/known_1_5_gyro_scale.csv": "cases/half-gyro/known_1_5_gyro_scale.toml",
    "cases/hand-pushed/p2.csv": "cases/hand-pushed/mine2.toml",
    "cases/late-loop/run.csv": "ev3way",
    "cases/motors-off/freefall.csv": "nxtway-gs",
    "cases/motors-off/wrap.csv": "nxtway-gs",
    "cases/pwm-and-battery/mylog_vbat.csv": "cases/pwm-and-battery/mine2.toml",
    "cases/weak-gain/log.csv": "cases/weak-gain/robot.toml",
}
"""Below the folder of what is shared: logs, and whose numbers they are judged with."""


@dataclass(frozen=True)
class Compared:
    """How the two answers to one call differ."""

    command: str
    log: str
    said: str  # how both ended, or each
    numbers: int = 0
    equal: int = 0
    largest: float = 0.0
    alone: int = 0
    words: int = 0
    seconds: tuple[float, float] = (0.0, 0.0)
    where: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        took = "{:.1f} {:.1f} s".format(*self.seconds)
        count = f"{self.equal} of {self.numbers} equal, largest {self.largest:.1e}, {self.alone} of one alone"
        return f"{self.command} {self.log}: {self.said}; {count}, {self.words} words differ; {took} {self.where}"


def leaves(tree: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Every number and word of a JSON with its path; what has a name is found by it."""
    if isinstance(tree, dict):
        for key, value in tree.items():
            if key not in IGNORED:
                yield from leaves(value, f"{path}/{key}")
    elif isinstance(tree, list):
        met = Counter[str]()
        for place, value in enumerate(tree):
            names = [str(value[key]) for key in NAMES if key in value] if isinstance(value, dict) else []
            name = ":".join(names) or str(place)
            met[name] += 1
            yield from leaves(value, f"{path}/{name}" + (f"#{met[name]}" if met[name] > 1 else ""))
    else:
        yield path, tree


def limited() -> None:
    """In the child, before it starts: no more processor than `LONGEST`."""
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 5))


def told(executable: str, call: list[str], folder: Path) -> tuple[Any, str, float]:
    """The JSON of a call or None, how it ended in words, and its processor time [s]."""
    clock = harness.Clock()
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    ended = subprocess.run(
        [*shlex.split(executable), *call],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        preexec_fn=limited,
        check=False,
    )
    try:
        return json.loads(ended.stdout), f"exit {ended.returncode}", clock.cpu
    except ValueError:
        first = (ended.stderr.strip().splitlines() or ["nothing"])[0]
        return None, f"exit {ended.returncode}: {first}", clock.cpu


def is_number(leaf: Any) -> bool:
    return isinstance(leaf, (int, float)) and not isinstance(leaf, bool)


def compared(executables: tuple[str, str], folder: str, key: list[str]) -> Compared:
    """One call of both executables, on a log below `folder`; `key` is the command and the log."""
    command, log = key
    asked = [LOGS[log], log] if command == "validate" else [log, "--robot", LOGS[log]]
    call = [command, *asked, *OPTIONS.get(command, ()), "--json"]
    (old, ended, before), (new, now, after) = (told(e, call, Path(folder)) for e in executables)
    said = ended if ended == now else f"{ended} | {now}"
    if old is None or new is None:
        return Compared(command, log, said, seconds=(before, after))
    return differences(command, log, said, (before, after), dict(leaves(old)), dict(leaves(new)))


def differences(
    command: str, log: str, said: str, seconds: tuple[float, float], old: dict[str, Any], new: dict[str, Any]
) -> Compared:
    """What differs between the leaves of two answers; the largest differences and some words are kept."""
    both = [path for path in old if path in new]
    numbers = [path for path in both if is_number(old[path]) and is_number(new[path])]
    words = [path for path in both if path not in numbers and old[path] != new[path]]
    apart: dict[str, float] = {}
    for path in numbers:
        difference = abs(old[path] - new[path])
        size = max(abs(old[path]), abs(new[path]))
        if difference > max(EQUAL * size, ZERO):
            apart[path] = difference / size
    alone = sum(is_number((old | new)[path]) for path in old.keys() ^ new.keys())
    where = sorted(apart, key=lambda path: -apart[path])[:KEPT]
    where += [f"{path}: {old[path]!r} | {new[path]!r}"[:WORDS] for path in words[:KEPT]]
    equal = len(numbers) - len(apart)
    largest = max(apart.values(), default=0.0)
    return Compared(command, log, said, len(numbers), equal, largest, alone, len(words), seconds, where)


def main() -> None:
    asked = harness.options(
        __doc__,
        ("old", str),
        ("new", str),
        data=harness.DATA.parent,
        commands=("doctor", "validate", "identify", "calibrate", "post-mortem"),
        only="",
        results=Path,
    )
    keys = [[c, log] for c in asked.commands for log in LOGS if asked.only in log and (asked.data / log).exists()]
    judge = partial(compared, (asked.old, asked.new), str(asked.data.resolve()))
    harness.cases(judge, keys, Compared, 1, asked.results)


if __name__ == "__main__":
    main()
