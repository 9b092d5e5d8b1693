"""Judges any installed `upright` on stored populations, through its command line and its JSON alone.

    python benchmarks/judge.py FOLDER upright
    python benchmarks/judge.py FOLDER /old/bin/upright /new/bin/upright --results told   # two columns; again resumes

FOLDER is made by `populations.py`. An executable may have arguments ("python -m upright"). Each case is asked once with
its logs and its robot's file: `post-mortem`, `calibrate` or `doctor`, each with `--json`. A fall is right where the
verdict is the planted cause, both of two, or says that none is known. Of a calibration the visible intervals count that
hold their truth. A fault is right where its code is found on its channel without another error, and a clean log where
no error is found.
"""

from __future__ import annotations

import json
import os
import shlex
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import harness

UNKNOWN = "none of these"
LONGEST = 1800  # [s] for one call; a calibration takes seconds to two minutes


@dataclass(frozen=True)
class Told:
    """What one case came to: how many answers were right, of how many; `said` in a few words; `trouble` where there is
    no answer."""

    case: str
    right: int
    of: int
    said: str
    seconds: float
    trouble: bool = False

    def __str__(self) -> str:
        return f"{self.case}: {self.right} of {self.of}, {self.said} ({self.seconds:.0f} s)"


def asked_of(executable: str, folder: str, case: str) -> Told:
    """One case, asked of one executable."""
    path = Path(folder) / f"{case}.json"
    truth, clock = json.loads(path.read_text("utf-8")), harness.Clock()
    robot = ["--robot", truth["robot"]] if "robot" in truth else []
    call = [*shlex.split(executable), truth["command"], *truth["logs"], *robot, "--json"]
    try:
        own = {n: v for n, v in os.environ.items() if n != "PYTHONPATH"}  # of an installed program, not of this one
        ended = subprocess.run(call, cwd=path.parent, env=own, capture_output=True, text=True, timeout=LONGEST)  # noqa: PLW1510
        answer = json.loads(ended.stdout)
    except subprocess.TimeoutExpired:
        return Told(case, 0, 1, f"no answer in {LONGEST} s", clock.wall, trouble=True)
    except ValueError:
        words = (ended.stderr.strip().splitlines() or ["nothing"])[-1]
        return Told(case, 0, 1, f"exit {ended.returncode}: {words}", clock.wall, trouble=True)
    return Told(case, *JUDGES[truth["command"]](answer, truth["right"]), clock.wall)


def of_fall(answer: dict[str, Any], right: dict[str, list[str]]) -> tuple[int, int, str]:
    verdict = str(answer["verdict"])
    if "every" in right:
        good = all(cause in verdict for cause in right["every"])
    else:
        good = verdict in right["verdicts"] or (UNKNOWN in right["verdicts"] and verdict.startswith(UNKNOWN))
    return int(good), 1, verdict


def of_calibration(answer: dict[str, Any], right: dict[str, Any]) -> tuple[int, int, str]:
    lists = ("parameters", "combinations", "delays", "electronics")
    seen = {e["name"]: e for name in lists for e in answer[name] if e["verdict"] == "visible"}
    truth = {name: value for name, value in right["numbers"].items() if name in seen}
    missed = [name for name, value in truth.items() if not seen[name]["low"] <= value <= seen[name]["high"]]
    refused = "refused, " if answer["refused"] else ""
    return len(truth) - len(missed), len(truth), f"{refused}missed: {', '.join(missed) or 'none'}"


def of_doctor(answer: dict[str, Any], right: dict[str, str]) -> tuple[int, int, str]:
    found, code = answer["findings"], right["code"]
    hits = [f for f in found if code and f["code"] == code and right["channel"] in ("", f["channel"])]
    others = [f for f in found if f["severity"] == "error" and f not in hits]
    good = not others if not code else bool(hits) and (code.startswith("time/") or not others)
    return int(good), 1, ", ".join(f["code"] for f in found if f["severity"] != "note") or "nothing"


JUDGES = {"post-mortem": of_fall, "calibrate": of_calibration, "doctor": of_doctor}


def table(kinds: Sequence[str], columns: dict[str, list[Told]]) -> None:
    """Shares of each kind in a column for each executable, and in how many cases there was no answer."""
    rows = harness.Table("kind <16", *(f"{name[-44:]} >48" for name in columns))
    for kind in kinds:
        cells: list[str] = []
        for every in columns.values():
            told = [t for t in every if t.case.startswith(f"{kind}/")]
            none = sum(t.trouble for t in told)
            share = harness.share(sum(t.right for t in told), sum(t.of for t in told))
            cells.append(share + (f", {none} without" if none else ""))
        rows.row(kind, *cells)
    seconds = [sum(t.seconds for t in every) / max(len(every), 1) for every in columns.values()]
    rows.row("a case takes", *(f"{s:.1f} s" for s in seconds))


def main() -> None:
    asked = harness.options(
        __doc__, ("folder", Path), ("executable", str), ("another", ""), kinds=(), count=1000, workers=1, results=Path
    )
    folder = asked.folder.resolve()
    kinds = asked.kinds or sorted({p.parent.name for p in folder.glob("*/*.json")})
    cases = [f"{kind}/{p.stem}" for kind in kinds for p in sorted((folder / kind).glob("*.json"))[: asked.count]]
    columns: dict[str, list[Told]] = {}
    for number, executable in enumerate(filter(None, (asked.executable, asked.another)), 1):
        print(f"\n{executable}")
        judge = partial(asked_of, executable, str(folder))
        kept = asked.results.with_suffix(f".{number}.jsonl") if asked.results else None
        columns[executable] = harness.cases(judge, cases, Told, asked.workers, kept)
    print()
    table(kinds, columns)


if __name__ == "__main__":
    main()
