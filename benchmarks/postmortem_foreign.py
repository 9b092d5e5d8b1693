"""Post-mortems of robots that others made: a simulator of its own equations, which shares nothing with upright.

    python benchmarks/postmortem_foreign.py --first-seed 18
    python benchmarks/postmortem_foreign.py --first-seed 3 --seeds 4 --robots H --causes friction gyro-scale

Two wheels and a body in the plane, which turn about the vertical as well, by Runge and Kutta's method in steps of
50 µs; dry friction in both gears and under both wheels; a state feedback of a complementary filter. F has 1.2 kg and
50 Hz, G 16 kg, 1.1 m and 100 Hz, H 0.6 kg and 200 Hz. They differ by 15 % from fall to fall, and each file has numbers
that are 1 to 4 % off. A fall counts where the robot stands without the fault. Half of the programs stop at the fall.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.foreign.turning import FAULTS, MACHINES, RIGHT, fall
from upright.diagnose import PostMortem, post_mortem
from upright.errors import InvalidLog


def called(found: PostMortem, cause: str) -> str:
    """Whether a verdict names the cause, says that it does not know, or is wrong."""
    if found.verdict == RIGHT[cause]:
        return "named"
    return "none" if found.verdict in ("none of these", "cannot tell", "it did not fall") else "wrong"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--first-seed", type=int, default=3)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--robots", nargs="*", default=[*MACHINES])
    parser.add_argument("--causes", nargs="*", default=[*FAULTS])
    given = parser.parse_args()
    calls, sure = Counter[str](), 0
    for seed in range(given.first_seed, given.first_seed + given.seeds):
        for name in given.robots:
            for cause in given.causes:
                case = fall(name, cause, seed)
                if case is None:
                    print(f"{seed} {name} {cause}: no fall", flush=True)
                    continue
                began = time.process_time()
                try:
                    found = post_mortem(case.log, case.file)
                except InvalidLog as error:
                    calls["refused"] += 1
                    print(f"{seed} {name} {cause}: refused, {error}", flush=True)
                    continue
                took, told = time.process_time() - began, called(found, cause)
                calls[told] += 1
                sure += told == "wrong" and found.causes[0].likelihood >= 0.8
                odds = ", ".join(f"{one.name} {one.likelihood:.2f}" for one in found.causes[:3]) or found.verdict
                f = case.fault
                print(
                    f"{seed} {name} {cause} {f.size:.3g} side {f.side} from {f.onset:.2f} to {case.fell_at:.2f} s: "
                    f"{told}: {odds} ({took:.0f} s); {found.causes[0].evidence if found.causes else ''}",
                    flush=True,
                )
    print(f"{dict(calls)}, wrong at 0.8 or more: {sure}")


if __name__ == "__main__":
    main()
