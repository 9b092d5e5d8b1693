"""How long `upright grade` takes for a class: 500 hand-ins of ten seconds each.

python benchmarks/grade.py [COUNT] [--step 0.002]      # 0.01: as a class makes them
"""

from __future__ import annotations

import os
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import harness

from upright.classwork.grading import grade
from upright.lab.handin import HandIn, RunResult, write_hand_in
from upright.lab.messages import Setup, Strike
from upright.lab.rerun import rerun

CONTROLLERS = ("lqg", "lqr", "lqi", "pid")
BAR = 60.0  # [s] for 500 on two cores


def hand_ins(folder: Path, count: int, step: float) -> None:
    """Knocks of different sizes on robots of different seeds; every tenth claims more than it did."""
    nothing = RunResult(fell=False, seconds=0.0, peak=0.0, travel=0.0, best=0.0)
    for k in range(count):
        setup = Setup(bodies=("nonlinear",), seed=k % 40, controller=CONTROLLERS[k % 4])
        knock = ((1.0, Strike("impulse", 0.05 + 0.002 * (k % 100))),)
        done = HandIn(
            student=f"student {k}", setup=setup, step=step, lean=0.0, seconds=10.0, actions=knock, claimed=nothing
        )
        claimed = rerun(done) if k < 40 else replace(nothing, seconds=9.99)
        write_hand_in(replace(done, claimed=claimed), folder / f"{k:04d}.json")


def main() -> int:
    """Print the time, and 1 where it is beyond the bar."""
    options = harness.options(__doc__, ("count", 500), step=0.002)
    with tempfile.TemporaryDirectory() as folder:
        hand_ins(Path(folder), options.count, options.step)
        clock = harness.Clock()
        grades = grade(folder)
        wall, computed = clock.wall, clock.cpu
    print(f"{options.count} hand-ins of 10 s in steps of {options.step:g} s on {os.cpu_count()} processors")
    print(f"{wall:.1f} s, of which {computed:.1f} s of computing by all processes")
    print(grades.summary)
    return int(wall > BAR * options.count / 500)


if __name__ == "__main__":
    sys.exit(main())
