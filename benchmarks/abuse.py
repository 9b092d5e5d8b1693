"""What the package bears: hostile clients, malformed calls, mutated files, faults in flight, interrupts.

Run: python benchmarks/abuse.py lab|calls|mutants|flights|interrupts [--seed N] [--minutes M]

Each part is a module of `tests/planted/abuse` with `measure(seed, minutes)`, which yields rows: what was
measured, its value, its bar, and whether it held; `minutes` is None for the part's usual length. Exit code 1: some did
not hold.
"""

from __future__ import annotations

import sys
from importlib import import_module

import harness

PARTS = ("calls", "flights", "interrupts", "lab", "mutants")


def main() -> int:
    options = harness.options(__doc__, ("part", str), seed=1, minutes=float)
    if options.part not in PARTS:
        raise SystemExit(f"part {options.part!r}; expected one of {', '.join(PARTS)}")
    harness.machine()
    clock, broken = harness.Clock(), 0
    for what, value, bar, held in import_module(f"planted.abuse.{options.part}").measure(options.seed, options.minutes):
        broken += not held
        print(f"{'  ' if held else '! '}{what:<64}{value:>18}   (bar {bar})", flush=True)
    print(f"{broken} not held, {clock}")
    return min(broken, 1)


if __name__ == "__main__":
    sys.exit(main())
