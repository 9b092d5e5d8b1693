"""How long `upright` takes to answer, beside a bare interpreter in the same run: `python benchmarks/start.py`."""

from __future__ import annotations

import subprocess
import sys

import harness

COMMANDS = {
    "python -c pass": ["-c", "pass"],
    "import upright": ["-c", "import upright"],
    "upright --help": ["-m", "upright", "--help"],
    "upright robots": ["-m", "upright", "robots"],
    "upright linearise": ["-m", "upright", "linearise"],
}


def answered(arguments: list[str]) -> None:
    subprocess.run([sys.executable, *arguments], capture_output=True, check=True, timeout=60)


def main() -> None:
    repeats = harness.options(__doc__, repeats=9).repeats
    took = harness.best({name: lambda a=a: answered(a) for name, a in COMMANDS.items()}, repeats)
    table = harness.Table("command <20", f"best of {repeats} [s] >15.3f", "bare interpreters >20.1f")
    for name, seconds in took.items():
        table.row(name, seconds, seconds / took["python -c pass"])


if __name__ == "__main__":
    main()
