"""Every long command, interrupted by SIGINT and SIGTERM at random moments: its exit code, its time, what it leaves.

SIGINT goes to all processes of the command, as a terminal's Ctrl-C does, SIGTERM to the first one alone.
"""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import psutil

MOMENTS = 5
BAR = 1.0  # [s]
WRITING = 4.0  # [s] of what writes the part that is done: the batch that runs, then data, page and picture
FIRST = 0.5  # [s] before it, Python's own start answers a signal, where the system does not say who does

CAMPAIGN = """
n = 200000
chunk = 4096
vary = ["spread"]
[grid]
"motor.dead_zone" = [0.0, 0.3]
"""

COMMANDS = {
    "certify lqg": "certify lqg -n 20000 -o c.json --report r.html",
    "certify mpc": "certify mpc -n 10000 -o c.json --report r.html",
    "certify sliding": "certify sliding -n 20000 -o c.json --report r.html",
    "calibrate": "calibrate {log} -o r.toml --save s.json --report r.html",
    "identify": "identify {log} -o m.json --report r.html",
    "fleet": "fleet -n 500000 -o f.parquet --report r.html",
    "push-map": "push-map --points 24 -o m.parquet --report r.html",
    "basin": "basin --points 501 -o b.zarr --report r.html",
    "sweep": "sweep {spec} -o campaign --workers 2",
    "sweep, alone": "sweep {spec} -o campaign --workers 0",
    "excite": "excite -o plan.json --report r.html",
    "post-mortem": "post-mortem {fall} --save p.json --report r.html",
    "reproduce": "reproduce -o paper",
    "bench-controllers": "bench-controllers --save b.json",
    "design hinf": "design hinf -o h.json --report r.html",
    "doctor": "doctor {log} --fix fixed.csv --save d.json",
    "parity": "parity {program} {controller} --body nonlinear",
}
"""What is run; a name in braces is a file that is made first."""

KEEP = ("fleet", "push-map", "basin")
"""What writes the part that is done: all its files, or none."""

LENGTH = {"identify": 6.0, "post-mortem": 6.0, "design hinf": 4.0, "doctor": 4.0, "parity": 5.0, "calibrate": 10.0}
LONGEST = 12.0
"""From then on to the last moment [s]; most commands run longer."""


class End(NamedTuple):
    """How an interrupted command ended: its exit `code`, after `seconds`; `left`: files and processes that remain;
    `early`: that it was done before the signal came; and what it printed as `error`."""

    code: int
    seconds: float
    left: list[str]
    early: bool
    error: str


def measure(seed: int, minutes: float | None) -> Iterator[tuple[str, str, str, bool]]:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background has it ignored, children too
    draw = random.Random(seed)
    until = time.monotonic() + (60 * minutes if minutes else 1e9)
    with tempfile.TemporaryDirectory() as folder:
        given = inputs(Path(folder))
        for name, call in COMMANDS.items():
            for number in (signal.SIGINT, signal.SIGTERM):
                ends: list[End] = []
                while len(ends) < MOMENTS and time.monotonic() < until:
                    moment = draw.uniform(0.0, LENGTH.get(name, LONGEST))
                    ends.append(interrupted(call.format(**given).split(), number, moment))
                yield from _rows(name, number, [end for end in ends if not end.early])


def _rows(name: str, number: signal.Signals, ends: list[End]) -> Iterator[tuple[str, str, str, bool]]:
    if not ends:
        return
    codes, left = sorted({end.code for end in ends}), sorted({path for end in ends for path in end.left})
    slowest, traces = max(end.seconds for end in ends), sum("Traceback" in end.error for end in ends)
    bad = [end for end in ends if not held(end, number)]
    value = f"{len(ends)}×, {', '.join(map(str, codes))}, {slowest:.2f} s"
    bar = WRITING if name in KEEP else BAR
    yield f"{name}, {number.name}", value, f"{128 + number}, {bar:g} s", not bad and slowest < bar
    if left or traces:
        yield f"{name}, {number.name}: leaves {left}, {traces} tracebacks", str(len(left)), "0", False


def held(end: End, number: int) -> bool:
    """Whether it ended as it should, whatever its time on a busy machine."""
    said = ("Traceback", "unexpected", "leaked")
    return end.code == 128 + number and not end.left and not any(word in end.error for word in said)


def inputs(folder: Path) -> dict[str, str]:
    """The files that commands read."""
    given = {name: str(folder / name) for name in ("log", "fall", "controller", "program", "spec")}
    given |= {"log": given["log"] + ".parquet", "fall": given["fall"] + ".parquet", "program": given["program"] + ".c"}
    given |= {"controller": given["controller"] + ".json", "spec": given["spec"] + ".toml"}
    Path(given["spec"]).write_text(CAMPAIGN, encoding="utf-8")
    for call in (
        "simulate -s 20 -p hold:0.05,until=1 -o {log}",
        "simulate -s 5 -p impulse:2,start=2 -o {fall}",
        "design lqg -o {controller}",
        "firmware {controller} -t c -o {program}",
    ):
        subprocess.run(
            [sys.executable, "-m", "upright", *call.format(**given).split()], check=True, capture_output=True
        )
    return given


def interrupted(call: list[str], number: int, moment: float) -> End:
    """One run, sent the signal at that moment [s] after it has begun to answer signals itself."""
    with tempfile.TemporaryDirectory() as place, tempfile.TemporaryDirectory() as temporary:
        process = subprocess.Popen(
            [sys.executable, "-m", "upright", *call], cwd=place, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            start_new_session=True, env=os.environ | {"TMPDIR": temporary}, text=True,
        )  # fmt: skip
        while process.poll() is None and not _answers(process.pid):
            time.sleep(0.005)
        try:
            process.communicate(timeout=moment)
        except subprocess.TimeoutExpired:
            pass
        else:
            return End(process.returncode, 0.0, [], True, "")
        family = psutil.Process(process.pid).children(recursive=True)
        began, clock = time.monotonic(), time.time()
        if number == signal.SIGINT:
            os.killpg(process.pid, number)
        else:
            process.send_signal(number)
        error = process.communicate(timeout=60)[1]
        seconds = time.monotonic() - began
        _, alive = psutil.wait_procs(family, timeout=5)
        left = [f"process {p.pid}" for p in alive]
        files = {folder: [p for p in Path(folder).rglob("*") if not _campaigns(p)] for folder in (place, temporary)}
        if process.returncode == 0 and files[place] and all(p.stat().st_ctime < clock for p in files[place]):
            return End(0, seconds, [], True, error)  # the result stood before the signal came: Python was shutting down
        outputs = {word for before, word in pairwise(call) if before in ("-o", "--report")}
        if call[0] in KEEP and outputs <= set(os.listdir(place)):
            files[place] = [p for p in files[place] if p.relative_to(place).parts[0] not in outputs]
        left += [str(p.relative_to(folder)) for folder, paths in files.items() for p in paths]
        for p in alive:
            p.kill()
        code = process.returncode if process.returncode >= 0 else 128 - process.returncode  # as a shell says it
        return End(code, seconds, left, False, error)


def _answers(pid: int) -> bool:
    """Whether the process handles SIGTERM itself, as Python alone does not, however long it takes to start."""
    try:
        caught = Path(f"/proc/{pid}/status").read_text("utf-8").partition("SigCgt:")[2].split()[0]
    except (OSError, IndexError):
        time.sleep(FIRST)
        return True
    return bool(int(caught, 16) & 1 << (signal.SIGTERM - 1))


def _campaigns(path: Path) -> bool:
    """Whether this is what a campaign leaves to go on from."""
    return path.name in ("campaign", "plan.json", "chunks") or (
        path.parent.name == "chunks" and path.suffix == ".parquet" and path.stem.isdigit()
    )
