"""How often visible intervals hold the truth of robots that others made: logs of the simulator of the tests.

    python benchmarks/calibrate_foreign.py --robot arduino --first-seed 40 --logs 4
    python benchmarks/calibrate_foreign.py --dead-zone 0.6      # motors that nothing below 0.6 V moves

Each log is held for half a second and then balances, excited. The file is what its owner would have measured, on the
kit of a LEGO NXT. Prints a row for each log: visible intervals that hold, the numbers whose interval misses, and time.
"""

from __future__ import annotations

import argparse
import platform
import sys
import time
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.foreign import SMALL, Bot, Course, known, logged, metric, missed
from upright.calibrate.calibrate import calibrate
from upright.logs.mapping import apply, propose

MIDDLE = Bot(
    body=0.62, wheels=0.06, radius=0.034, com=0.07, inertia=1.6e-3, wheel_inertia=4e-5, rotor=9e-5, gain=0.045,
    damping=0.012, dry=0.01, rolling=1.2e-3, ticks=1440.0, late=0.003, battery=8.0, gains=(0.6, 26.0, 0.6, 2.0),
    period=0.008,
)  # fmt: skip
ROBOTS = {  # and seconds of balance, amplitude of the excitation [V]
    "small": (SMALL, 9.0, 1.0),
    "arduino": (Bot(), 12.0, 1.2),
    "middle": (MIDDLE, 12.0, 1.2),
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--robot", choices=[*ROBOTS], action="append", help="all, unless named")
    parser.add_argument("--first-seed", type=int, default=40)
    parser.add_argument("--logs", type=int, default=3)
    parser.add_argument("--dead-zone", type=float, default=0.0, metavar="VOLTS")
    given = parser.parse_args()
    print(f"{platform.processor() or platform.machine()}, Python {platform.python_version()}, NumPy {version('numpy')}")
    all_visible = all_held = 0
    for name in given.robot or ROBOTS:
        bot, free, excitation = ROBOTS[name]
        bot = replace(bot, dead_zone=given.dead_zone)
        for seed in range(given.first_seed, given.first_seed + given.logs):
            table = metric(logged(bot, Course(free=free, held=0.5, excitation=excitation), seed=seed), bot)
            started, used = time.perf_counter(), time.process_time()
            found = calibrate(apply(propose(table), table), known(bot))
            took, used = time.perf_counter() - started, time.process_time() - used
            visible, out = missed(found, bot)
            all_visible, all_held = all_visible + visible, all_held + visible - len(out)
            print(
                f"{name:8} {seed:3}  {visible - len(out):2} of {visible:2} hold  {took:5.1f} s, {used:5.1f} s of "
                f"processors{'  refused' if found.refused else ''}  {', '.join(out)}",
                flush=True,
            )
    print(f"all: {all_held} of {all_visible} hold ({all_held / max(all_visible, 1):.0%})")


if __name__ == "__main__":
    main()
