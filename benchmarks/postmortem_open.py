"""Whether the post-mortem knows its limits: faults outside the nine of `postmortem.py`, and two faults at once.

    python benchmarks/postmortem_open.py                                       # 6 falls of each fault, 24 pairs
    python benchmarks/postmortem_open.py --first-seed 7300 --runs 10 --results told.jsonl    # again resumes

`LISTED` are causes that the post-mortem knows, planted in the twin by MuJoCo's own means: actuators without gain,
locked joints, a box in the way, tilted gravity, another mass. `UNLISTED` are in no list of the code: right is "none of
these", or a cause that says the same. Of a pair neither fault fells the robot alone. As in `postmortem.py`, a run
counts where it falls after the onset and does not fall without the fault, and nothing of the truth is shown.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import harness
import numpy as np
from postmortem import Told, answered

from planted.falls import NoFall
from planted.open_falls import LISTED, PAIRS, SEED, UNLISTED, broken, right
from upright.diagnose import post_mortem
from upright.robots import Robot


def judged(key: tuple[Sequence[str], int]) -> Told:
    """One fall, made and examined."""
    causes, seed = key
    name = "+".join(causes)
    try:
        case = broken(tuple(causes), seed)
    except NoFall as error:
        return Told(name, seed, trouble=str(error))
    clock = harness.Clock()
    found = post_mortem(case.log, Robot.preset(case.robot))
    ways, sizes = ("+".join(x) for x in ([f.way for f in case.faults], [f"{f.size:.3g}" for f in case.faults]))
    how = f"{case.design} {ways} {sizes} from {case.faults[0].onset:.2f} to {case.fell_at:.2f} s"
    return answered(Told(name, seed, case.robot, how, right=right(causes, found.verdict)), found, clock)


def main() -> None:
    asked = harness.options(__doc__, runs=6, first_seed=SEED, workers=2, results=Path, causes=())
    every = [(c,) for c in (*LISTED, *UNLISTED)] + list(PAIRS)
    chosen = [tuple(c.split("+")) for c in asked.causes] or every
    keys = [
        (causes, asked.first_seed + i)
        for i in range(asked.runs) for causes in chosen
        if len(causes) == 1 or i < (asked.runs + 1) // 2
    ]  # fmt: skip
    report(harness.cases(judged, keys, Told, asked.workers, asked.results))


def one_alone(told: Told) -> bool:
    """Whether one cause stands at 0.9 or more where two were planted."""
    return not told.right and told.likelihood >= 0.9 and " and " not in told.first and told.first != "none of these"


def one_below(told: Told) -> bool:
    """Whether one of two causes is named, below 0.9: the rest is left to what the log does not show."""
    return told.verdict in told.planted.split("+") and not one_alone(told)


def report(told: Sequence[Told]) -> None:
    """Figures against the bars."""
    runs = [t for t in told if t.robot]
    for name, some in (("listed", LISTED), ("unlisted", UNLISTED)):
        these = [t for t in runs if t.planted in some]
        print(f"\n{name}: {harness.share(sum(t.right for t in these), len(these))}")
        for cause in dict.fromkeys(t.planted for t in these):
            mine = [t for t in these if t.planted == cause]
            print(
                f"  {cause:<18}{sum(t.right for t in mine):>3} of {len(mine)}", dict(Counter(t.verdict for t in mine))
            )
    pairs = [t for t in runs if "+" in t.planted]
    alone = sum(one_alone(t) for t in pairs)
    print(f"\npairs: both named in {sum(t.right for t in pairs)} of {len(pairs)}; one alone at 0.9 or more in {alone}")
    print(f"  besides, one of both named below 0.9 in {sum(one_below(t) for t in pairs)}")
    if runs:
        print(f"post-mortem: median {np.median([t.seconds for t in runs]):.1f} s of processor time")


if __name__ == "__main__":
    main()
