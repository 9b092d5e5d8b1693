"""Whether the post-mortem is right: robots that fell for a planted reason, and robots that did not fall.

    python benchmarks/postmortem.py                       # 30 runs of each cause, 60 without a fall
    python benchmarks/postmortem.py --first-seed 9100 --runs 10 --results told.jsonl   # a part; again for the next one

The truth is the twin behind its kit, drawn from a share of the spreads of the robot's sources, under a controller that
was designed for the nominal one. From a random moment on one thing changes. A run counts where it falls after that, and
where the same run without the change does not. The post-mortem sees commands and raw sensors, the nominal robot, and
the controller's file or not; it sees neither the truth nor what the motors really did.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import time
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.falls import CAUSES, NO_FALL, ROBOTS, SEED, NoFall, Planted, made
from upright.errors import UprightError
from upright.robots import Kit, Robot


@dataclass(frozen=True)
class Told:
    """What was planted and what was said, without and with the controller's file; `trouble` says why there is no
    verdict."""

    cause: str
    seed: int
    robot: str = ""
    design: str = ""
    way: str = ""
    size: float = 0.0
    onset: float = 0.0
    fell_at: float = 0.0
    without: str = ""
    with_file: str = ""
    seconds: float = 0.0
    trouble: str = ""

    def __str__(self) -> str:
        if self.trouble:
            return f"{self.seed} {self.cause}: {self.trouble}"
        return (
            f"{self.seed} {self.robot} {self.design} {self.cause}/{self.way} {self.size:.3g} from {self.onset:.2f} "
            f"to {self.fell_at:.2f} s: {self.without}; with the file {self.with_file}"
        )


def judged(work: tuple[str, int, str]) -> Told:
    """One case, made and examined twice."""
    cause, seed, folder = work
    try:
        case = made(cause, seed, Path(folder) if folder else None)
    except NoFall as error:
        return Told(cause, seed, trouble=str(error))
    told = Told(
        cause, seed, case.robot, case.design, case.fault.way, case.fault.size, case.fault.onset,
        case.fell_at if math.isfinite(case.fell_at) else 0.0,
    )  # fmt: skip
    try:
        return _examined(case, told)
    except UprightError as error:
        return replace(told, trouble=f"{type(error).__name__}: {error}")


def _examined(case: Planted, told: Told) -> Told:
    from upright.diagnose.evidence import gather
    from upright.diagnose.verdict import ranked

    nominal = Robot.preset(case.robot)
    kit = Kit.preset(nominal.kit)
    began = time.process_time()
    _, evidence = gather(case.log, nominal, kit, case.controller, lambda _: None)
    seconds = time.process_time() - began
    plain = with_file = NO_FALL
    if evidence is not None:
        plain, with_file = (ranked(e)[0].name for e in (replace(evidence, match=None, stable=None), evidence))
    return replace(told, without=plain, with_file=with_file, seconds=seconds)


def known(path: Path | None) -> dict[tuple[str, int], Told]:
    """The cases that an earlier call has written."""
    lines = path.read_text().splitlines() if path and path.exists() else []
    told = [Told(**json.loads(line)) for line in lines]
    return {(t.cause, t.seed): t for t in told}


def confusion(rows: Sequence[tuple[str, str]]) -> str:
    """The table of what was planted (rows) against what was said (columns)."""
    said = sorted({s for _, s in rows}, key=lambda s: [*CAUSES, NO_FALL].index(s) if s in (*CAUSES, NO_FALL) else 99)
    counts = Counter(rows)
    lines = [f"{'planted':<18}" + "".join(f"{s:>17}" for s in said)]
    for cause in dict.fromkeys(c for c, _ in rows):
        lines.append(f"{cause:<18}" + "".join(f"{counts[cause, s] or '·':>17}" for s in said))
    return "\n".join(lines)


def share(told: Sequence[Told], which: str) -> str:
    """How many causes were named rightly."""
    right = sum(t.cause == getattr(t, which) for t in told)
    return f"{right} of {len(told)} ({100 * right / max(len(told), 1):.1f} %)"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=30, help="runs of each cause; twice as many without a fall")
    parser.add_argument("--first-seed", type=int, default=SEED, help="the final figures' are 9100 and more")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--results", type=Path, help="a file of lines to which verdicts are added; none is made twice")
    parser.add_argument("--keep", default="", help="a folder in which the planted runs are kept")
    parser.add_argument("--causes", nargs="*", default=[*CAUSES, NO_FALL])
    options = parser.parse_args()
    work = [
        (cause, options.first_seed + i, options.keep)
        for i in range(2 * options.runs)
        for cause in options.causes
        if i < options.runs or cause == NO_FALL
    ]
    found = known(options.results)
    new = [one for one in work if one[:2] not in found]
    with ProcessPoolExecutor(options.workers) as pool:
        for done, told in enumerate(pool.map(judged, new), 1):
            found[told.cause, told.seed] = told
            if options.results:
                with options.results.open("a") as file:
                    file.write(json.dumps(asdict(told)) + "\n")
            word = "right" if told.without == told.cause else "WRONG"
            print(f"{done}/{len(new)} {word} {told}", flush=True)
    report(list(found.values()))


def report(told: Sequence[Told]) -> None:
    """Shares and confusion of all cases; those without a verdict count as wrong, those without a run do not count."""
    runs = sorted((t for t in told if t.robot), key=lambda t: ([*CAUSES, NO_FALL].index(t.cause), t.seed))
    fell = [t for t in runs if t.cause != NO_FALL]
    for which, name in (("without", "from the data alone"), ("with_file", "with the controller's file")):
        print(f"\n{name}: {share(fell, which)} of those that fell")
        print(confusion([(t.cause, getattr(t, which) or "no verdict") for t in runs]))
        for robot in ROBOTS:
            print(f"  {robot:<12} {share([t for t in fell if t.robot == robot], which)}")
    print("\nwrong:", *(t for t in runs if t.cause not in (t.without, t.with_file)), sep="\n  ")
    print("without a run:", *(t for t in told if not t.robot), sep="\n  ")
    print(f"post-mortem: median {np.median([t.seconds for t in runs]):.1f} s of processor time, "
          f"{max(t.seconds for t in runs):.1f} s at most")  # fmt: skip


if __name__ == "__main__":
    main()
