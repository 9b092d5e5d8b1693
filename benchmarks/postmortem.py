"""Whether the post-mortem is right: robots that fell for a planted reason, and robots that did not fall.

    python benchmarks/postmortem.py                       # 30 runs of each cause, 60 without a fall
    python benchmarks/postmortem.py --first-seed 9100 --runs 10 --results told.jsonl   # a part; again for the next one

The truth is the twin behind its kit, drawn from a share of the spreads of the robot's sources, under a controller that
was designed for the nominal one. From a random moment on one thing changes. A run counts where it falls after that, and
where the same run without the change does not. The post-mortem sees commands and raw sensors, the nominal robot, and
the controller's file or not; it sees neither the truth nor what the motors really did.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import harness
import numpy as np

from planted.falls import CAUSES, NO_FALL, ROBOTS, SEED, NoFall, planted
from upright.diagnose import PostMortem
from upright.diagnose.evidence import gather
from upright.diagnose.verdict import ranked
from upright.errors import UprightError
from upright.robots import Kit, Robot


@dataclass(frozen=True)
class Told:
    """What was planted and what was said of it, the `first` cause and its likelihood; `trouble` says why there is no
    run, or no verdict."""

    planted: str
    seed: int
    robot: str = ""
    how: str = ""
    verdict: str = ""
    right: bool = False
    why: str = ""
    seconds: float = 0.0
    trouble: str = ""
    with_file: str = ""
    first: str = ""
    likelihood: float = 0.0

    def __str__(self) -> str:
        if self.trouble:
            return f"{self.seed} {self.robot} {self.planted}: {self.trouble}"
        said = f"{'right' if self.right else 'WRONG'}: {self.why or self.verdict} ({self.seconds:.0f} s)"
        return f"{self.seed} {self.robot} {self.planted} {self.how}: {said}"


def answered(told: Told, found: PostMortem, clock: harness.Clock) -> Told:
    """With what a post-mortem says."""
    odds = ", ".join(f"{c.name} {c.likelihood:.2f}" for c in found.causes[:3]) or found.verdict
    first = found.causes[0] if found.causes else None
    told = replace(told, verdict=found.verdict, why=f"{odds}; {first.evidence if first else ''}", seconds=clock.cpu)
    return replace(told, first=first.name, likelihood=first.likelihood) if first else told


def judged(key: tuple[str, int]) -> Told:
    """One case, made and examined without and with the controller's file."""
    cause, seed = key
    try:
        case = planted(cause, seed)
    except NoFall as error:
        return Told(cause, seed, trouble=str(error))
    fault, nominal, clock = case.fault, Robot.preset(case.robot), harness.Clock()
    how = f"{case.design} {fault.way} {fault.size:.3g} from {fault.onset:.2f} to {case.fell_at:.2f} s"
    told = Told(cause, seed, case.robot, how)
    try:
        _, evidence = gather(case.log, nominal, Kit.preset(nominal.kit), case.controller, lambda _: None)
        plain = with_file = NO_FALL
        if evidence is not None:
            plain, with_file = (ranked(e)[0].name for e in (replace(evidence, match=None, stable=None), evidence))
    except UprightError as error:
        return replace(told, trouble=f"{type(error).__name__}: {error}")
    why = f"{plain}; with the file {with_file}"
    return replace(told, verdict=plain, right=plain == cause, why=why, seconds=clock.cpu, with_file=with_file)


def confusion(rows: Sequence[tuple[str, str]]) -> None:
    """The table of what was planted (rows) against what was said (columns)."""
    order = [*CAUSES, NO_FALL]
    said = sorted({s for _, s in rows}, key=lambda s: order.index(s) if s in order else len(order))
    counts, table = Counter(rows), harness.Table("planted <18", *(f"{s} >17" for s in said))
    for cause in dict.fromkeys(c for c, _ in rows):
        table.row(cause, *(counts[cause, s] or "·" for s in said))


def report(told: Sequence[Told]) -> None:
    """Shares and confusion of all cases; those without a verdict count as wrong, those without a run do not count."""
    order = [*CAUSES, NO_FALL]
    runs = sorted((t for t in told if t.robot), key=lambda t: (order.index(t.planted), t.seed))
    fell = [t for t in runs if t.planted != NO_FALL]
    for which, name in (("verdict", "from the data alone"), ("with_file", "with the controller's file")):
        for some in ("", *ROBOTS):
            these = [t for t in fell if some in ("", t.robot)]
            right = sum(t.planted == getattr(t, which) for t in these)
            print(f"{name}: " if not some else f"  {some:<12} ", harness.share(right, len(these)))
        confusion([(t.planted, getattr(t, which) or "no verdict") for t in runs])
    seconds = [t.seconds for t in runs] or [0.0]
    print(f"post-mortem: median {np.median(seconds):.1f} s of processor time, {max(seconds):.1f} s at most")


def main() -> None:
    asked = harness.options(__doc__, runs=30, first_seed=SEED, workers=2, results=Path, causes=(*CAUSES, NO_FALL))
    keys = [(c, asked.first_seed + i) for c in asked.causes for i in range(asked.runs * (1 + (c == NO_FALL)))]
    report(harness.cases(judged, keys, Told, asked.workers, asked.results))


if __name__ == "__main__":
    main()
