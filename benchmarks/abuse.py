"""What the package bears: hostile clients, malformed calls, mutated files, faults in flight, interrupts.

Run: python benchmarks/abuse.py lab|calls|mutants|flights|interrupts [--seed N] [--minutes M]

Each part is a module of `tests/planted/abuse` with `measure(seed, minutes)`, which yields rows: what was
measured, its value, its bar, and whether it held; `minutes` is None for the part's usual length. Exit code 1: some did
not hold.
"""

from __future__ import annotations

import argparse
import os
import platform
import sys
import time
from importlib import import_module
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

PARTS = ("calls", "flights", "interrupts", "lab", "mutants")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("part", choices=PARTS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float)
    options = parser.parse_args()
    print(f"{options.part}, seed {options.seed}; {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}, "
          f"Python {platform.python_version()}")  # fmt: skip
    began, broken = time.monotonic(), 0
    for what, value, bar, held in import_module(f"planted.abuse.{options.part}").measure(options.seed, options.minutes):
        broken += not held
        print(f"{'  ' if held else '! '}{what:<64}{value:>18}   (bar {bar})", flush=True)
    print(f"{broken} not held, {time.monotonic() - began:.0f} s")
    return min(broken, 1)


if __name__ == "__main__":
    sys.exit(main())
