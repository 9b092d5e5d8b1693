"""Post-mortems of robots that others made: two simulators that share nothing with upright (`tests/planted/foreign`).

    python benchmarks/postmortem_foreign.py --first-seed 18
    python benchmarks/postmortem_foreign.py --first-seed 3 --seeds 4 --robots H --causes friction gyro-scale

F has 1.2 kg and 50 Hz, G 16 kg, 1.1 m and 100 Hz, H 0.6 kg and 200 Hz. They differ by 15 % from fall to fall, and each
file has numbers that are 1 to 4 % off. A fall counts where the robot stands without the fault. Half of the programs
stop at the fall. With `--robots small arduino middle` the falls are of the simulator in a plane.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import harness
from postmortem import Told, answered

from planted import foreign
from upright.diagnose import post_mortem
from upright.errors import InvalidLog
from upright.logs.mapping import apply, propose
from upright.logs.readers import RawTable

UNKNOWN = ("none of these", "cannot tell", "it did not fall")


def judged(key: tuple[str, str, int]) -> Told:
    """One fall, made and examined."""
    name, cause, seed = key
    case = foreign.fall(name, cause, seed)
    if case is None:
        return Told(cause, seed, trouble=f"{name}: no fall")
    how = f"{case.size:.3g} side {case.side} from {case.onset:.2f} to {case.fell_at:.2f} s"
    clock, log = harness.Clock(), case.log
    try:
        found = post_mortem(apply(propose(log), log) if isinstance(log, RawTable) else log, case.file)
    except InvalidLog as error:
        return Told(cause, seed, name, how, trouble=f"refused, {error}")
    told = Told(cause, seed, name, how, right=found.verdict == foreign.RIGHT[cause])
    return answered(told, found, clock)


def main() -> None:
    asked = harness.options(__doc__, first_seed=3, seeds=1, robots=("F", "G", "H"), causes=(), workers=1, results=Path)
    seeds = range(asked.first_seed, asked.first_seed + asked.seeds)
    keys = [
        (name, cause, seed)
        for seed in seeds for name in asked.robots for cause in foreign.faults(name)
        if not asked.causes or cause in asked.causes
    ]  # fmt: skip
    told = harness.cases(judged, keys, Told, asked.workers, asked.results)
    runs = [t for t in told if t.verdict]
    wrong = [t for t in runs if not t.right and t.verdict not in UNKNOWN]
    words = ["named" if t.right else "wrong" if t in wrong else "none" for t in runs]
    calls = Counter(words)
    print(f"{dict(calls)}, refused: {sum(bool(t.robot) for t in told) - len(runs)}")
    sure = sum(t.likelihood >= 0.8 for t in wrong)
    print(f"named: {harness.share(calls['named'], len(runs))}; wrong at 0.8 or more: {sure}")


if __name__ == "__main__":
    main()
