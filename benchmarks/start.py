"""How long `upright` takes to answer, beside a bare interpreter in the same run: `python benchmarks/start.py`."""

from __future__ import annotations

import subprocess
import sys
import time

COMMANDS = {
    "python -c pass": ["-c", "pass"],
    "import upright": ["-c", "import upright"],
    "upright --help": ["-m", "upright", "--help"],
    "upright robots": ["-m", "upright", "robots"],
    "upright linearise": ["-m", "upright", "linearise"],
}
REPEATS = 9


def best(arguments: list[str]) -> float:
    """Shortest of several runs [s]: what the command costs without the machine's other work."""
    times: list[float] = []
    for _ in range(REPEATS):
        before = time.perf_counter()
        subprocess.run([sys.executable, *arguments], capture_output=True, check=True, timeout=60)
        times.append(time.perf_counter() - before)
    return min(times)


def main() -> None:
    took = {name: best(arguments) for name, arguments in COMMANDS.items()}
    bare = took["python -c pass"]
    print(f"{'command':<20}{'best of 9 [s]':>15}{'bare interpreters':>20}")
    for name, seconds in took.items():
        print(f"{name:<20}{seconds:>15.3f}{seconds / bare:>20.1f}")


if __name__ == "__main__":
    main()
