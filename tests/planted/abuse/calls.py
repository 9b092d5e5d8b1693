"""Malformed calls of every command: no traceback, nothing unexpected, no hang, no file changed that was not named.

The calls come from the commands themselves: each option with hostile values of its type, each argument with hostile
files, one at a time in a call that is right otherwise.
"""

from __future__ import annotations

import json
import os
import random
import shlex
import shutil
import tempfile
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from planted.abuse.forked import SECONDS, Ended, forked

COUNT = 2400
"""Calls of a whole run; there are more, of which a seed takes these."""

LOADED = ("scipy.linalg", "pyarrow.parquet", "upright.cli.main", "upright.control", "upright.experiment",
          "upright.checkup.doctor", "upright.comparison", "upright.reports", "upright.firmware")  # fmt: skip

CODES = (0, 2, 3, 130)

NUMBERS = (
    "nan", "inf", "-inf", "-1", "0", "1e308", "-1e308", "5e-324", "1e9", "1e-9", "", "x", "9" * 400, "٣", "1,5", "0x10",
    "--", "1e",
)  # fmt: skip
WHOLE = ("-1", "0", "1000000000", "9" * 400, str(2**63), str(-(2**63) - 1), "", "x", "1.5", "nan", "1e3", "1_000")
TEXTS = (
    "", " ", "-", ".", "..", "/", "~nosuchuser", "~nosuchuser/x.toml", "a\nb", "x" * 5000, "\udcff", "*", "nan", "=",
    ",", "0..", "..", "1..0", "nan..inf", "x=1", "pitch=nan", "pitch=1e308", "lqr:", "missing.toml", "missing.json",
    "missing.py:X", "folder.toml", "deep.toml", "deep.json", "bytes.toml", "bytes.json", "empty.json", "list.json",
    "big.json", "big.toml", "broken.py:X", "exits.py:X", "force:1", "hold:",
    "impulse:nan,start=0", "force:1e308,start=0,duration=1",
    "'; rm -rf x", "{{7*7}}", "%s%n", "lgq", "LQR", "nxtway-gs ", "com_height=±1e9%", "com_height=nan..nan",
    "0,0,0,0,0,0", "1e308,1e308,1e308,1e308,1e308,1e308", "0.1,start=-1", "1e9", "-1e308",
)  # fmt: skip
# Never a path outside of the folder: where a command takes it, it is written, with whatever rights there are.
OUTPUTS = (
    "", ".", "nowhere/x", "folder", "folder/", "~nosuchuser/x", "x", "x.", ".x", "x" * 300 + ".json", "a\nb.json",
    "run.csv", "run.csv/x", "\udcff.json", "loop.json", "missing-target.json", "x.JSON", "x.exe",
)  # fmt: skip
FILES = (
    "", ".", "folder", "missing", "~nosuchuser/x", "empty.csv", "bytes.csv", "bytes.parquet", "bytes.mat", "bytes.mcap",
    "deep.json", "deep.toml", "big.json", "list.json", "loop.json", "run.csv/x", "x" * 300, "cut.parquet", "cut.mcap",
    "twice.parquet", "zeros.csv", "huge.csv", "jump.csv", "nan.csv", "words.csv", "one.csv", "quotes.csv", "bytes.toml",
    "controller.json", "posterior.json", "robot.toml", "kit.toml", "program.py", "run.csv", "\udcff.csv", "x.docx", "-",
)  # fmt: skip

BASES = {
    "simulate": "-s 0.3", "compare": "run.csv", "linearise": "", "design": "lqr", "certify": "lqr -n 100",
    "post-mortem": "run.csv -r nxtway-gs", "doctor": "run.csv",
    "identify": "run.csv --method least-squares --repeats 2",
    "fleet": "-n 20 -s 0.3", "push-map": "--points 2 -n 0 --watch 0.3 --tolerance 0.5",
    "basin": "--points 3 --watch 0.3",
    "firmware": "lqr -t c", "monitor": "lines.txt", "robots": "", "sweep": "campaign.toml --workers 0",
    "bench-controllers": "", "calibrate": "run.csv", "excite": "-n 100 -s 2", "parity": "program.py controller.json",
    "fly": "program.py controller.json -y -s 5", "reproduce": "", "lab": "--no-browser",
    "validate": "nxtway-gs run.csv", "example": "standing", "film": "run.csv -r nxtway-gs -o f.gif --width 160",
    "grade": "folder --workers 1", "tune": "lqr --budget 8 -n 20 --time-limit 1", "start": "study -n 100",
}  # fmt: skip
"""What is right in a call of each command, and quick."""

SLOW = {"bench-controllers", "calibrate", "excite", "parity", "fly", "reproduce", "lab", "tune", "start"}
"""Commands that take long by themselves: they get only values that can be nowhere right."""

WRONG = (
    "nan",
    "-inf",
    "",
    "x",
    "9" * 400,
    "~nosuchuser/x.toml",
    "deep.toml",
    "deep.json",
    "a\nb",
    "nowhere/x",
    "folder",
    "run.csv/x",
)

OUTPUT = {"--output", "--report", "--fix", "--write-mapping", "--save", "--export", "--regulator"}
"""Options of what is written."""

Row = tuple[str, str, str, bool]


@dataclass(frozen=True)
class Call:
    command: str
    arguments: tuple[str, ...]
    outputs: tuple[str, ...]


def measure(seed: int, minutes: float | None) -> Iterator[Row]:
    count = COUNT if minutes is None else max(50, int(COUNT * minutes / 15))
    with tempfile.TemporaryDirectory(prefix="upright-calls-") as folder:
        yield from rows(Path(folder), seed, count)


def rows(folder: Path, seed: int, count: int, names: tuple[str, ...] = tuple(BASES)) -> Iterator[Row]:
    """One row for each command, with its worst calls, and one for all."""
    place, scratch = folder / "work", folder / "scratch"
    place.mkdir()
    scratch.mkdir()
    os.environ.update(
        HOME=str(scratch), COLUMNS="200", UPRIGHT_CACHE=os.environ.get("UPRIGHT_CACHE", str(scratch / "k"))
    )
    for name in LOADED:  # once, not in every child
        import_module(name)
    began = forked(partial(make, place), scratch)
    if began.how:
        raise SystemExit(f"the inputs were not made: {began.how}\n{began.text}")
    everything = [call for call in calls() if call.command in names]
    chosen = random.Random(seed).sample(everything, min(count, len(everything)))
    total = Counter[str]()
    for name in names:
        faults = Counter[str]()
        mine = [call for call in chosen if call.command == name]
        for call in mine:
            for fault in tried(call, place, scratch):
                faults[fault.split(":")[0]] += 1
                print(f"      upright {shlex.join(call.arguments)[:160]!r}: {fault[:300]}", flush=True)
        total += faults
        shown = ", ".join(f"{n} × {what}" for what, n in faults.items())
        yield f"{name}: {len(mine)} calls {shown}", str(faults.total()), "0", not faults
    yield f"{len(chosen)} calls of {len(everything)}", f"{total.total()} faults", "0", not total


def tried(call: Call, place: Path, scratch: Path) -> list[str]:
    """What is wrong with how the call ends; the folder is as it was afterwards."""
    before = contents(place)
    ended = forked(partial(run, call, place), scratch)
    faults = judged(ended)
    after = contents(place)
    for path in sorted(before.keys() | after.keys()):
        if before.get(path) != after.get(path) and not named(path, call):
            faults.append(f"a file that was not named: {path}")
    if before != after:
        restore(place, before, after, scratch)
    return faults


def judged(ended: Ended) -> list[str]:
    if ended.how:
        return [ended.how if ended.how != "hangs" else f"hangs: over {SECONDS:g} s"]
    faults: list[str] = []
    if "Traceback" in ended.text:
        faults.append(f"traceback: {ended.text[-300:]}")
    elif ended.value not in CODES:
        faults.append(f"exit {ended.value}: {ended.text[-300:]}")
    elif ended.value == 2 and ended.text.count("upright: ") != 1:
        faults.append(f"not one line: {ended.text[-300:]}")
    if ended.peak > 1024:
        faults.append(f"memory: {ended.peak:.0f} MB")
    return faults


def run(call: Call, place: Path) -> int:
    from upright.cli.main import main

    os.chdir(place)
    return main(call.arguments)


def named(path: str, call: Call) -> bool:
    """Whether the call may have written that file: an output, beside one with its stem, or inside a named folder."""
    stems = {Path(o).stem for o in call.outputs} | {Path(o).name for o in call.outputs}
    folder = path.split("/", maxsplit=1)[0]
    return (
        Path(path).stem in stems
        or Path(path).name in stems
        or folder in stems
        or call.command in ("sweep", "reproduce", "start")
    )


def contents(place: Path) -> dict[str, tuple[int, int]]:
    found: dict[str, tuple[int, int]] = {}
    for folder, _, files in os.walk(place):
        for name in files:
            path = os.path.join(folder, name)
            status = os.lstat(path)
            found[os.path.relpath(path, place)] = (status.st_size, status.st_mtime_ns)
    return found


def restore(place: Path, before: dict[str, Any], after: dict[str, Any], scratch: Path) -> None:
    """New files and folders are removed; if an input was changed, all are made again."""
    for path in after.keys() - before.keys():
        (place / path).unlink(missing_ok=True)
        top = place / path.split("/")[0]
        if top.is_dir() and top.name != "folder":
            shutil.rmtree(top, ignore_errors=True)
    if any(before[path] != after.get(path) for path in before):
        shutil.rmtree(place)
        place.mkdir()
        forked(partial(make, place), scratch)


def calls() -> Iterator[Call]:
    """Every call: each option and argument of each command with each hostile value of its type."""

    from upright.cli.main import group

    group: Any = group()
    for name, base in BASES.items():
        right = shlex.split(base)
        always = tuple(right[right.index("-o") + 1 :][:1]) if "-o" in right else ()
        positions = [word for word in right if not word.startswith("-")][:2] if name != "lab" else []
        command = group.commands[name]
        for parameter in command.params:
            kind = str(parameter.type_descriptor.annotation)
            if parameter.is_flag if hasattr(parameter, "is_flag") else False:
                continue
            option = next((o for o in parameter.opts if o.startswith("--")), "")
            output = option in OUTPUT
            for value in values(kind, output=output, file=not option or "Path" in kind, slow=name in SLOW):
                outputs = (*always, value) if output else always
                if option:
                    yield Call(name, (name, *right, f"{option}={value}"), outputs)
                elif positions:
                    index = min(
                        [p.name for p in command.params if not any(o.startswith("-") for o in p.opts)].index(
                            parameter.name
                        ),
                        1,
                    )
                    words = [value if word == positions[index] else word for word in right]
                    yield Call(name, (name, *words), always)
    for words in (
        "nosuch",
        "--nosuch",
        "simulate --nosuch",
        "",
        "simulate simulate",
        "robots show",
        "robots show x",
        "--version x",
    ):
        yield Call(words.split(" ")[0] if words.split(" ")[0] in BASES else "robots", tuple(shlex.split(words)), ())
    for value in TEXTS:
        yield Call("robots", ("robots", "show", value), ())


def values(kind: str, *, output: bool, file: bool, slow: bool) -> tuple[str, ...]:
    if output:
        return tuple(
            v for v in OUTPUTS if not slow or v in ("", ".", "nowhere/x", "folder", "run.csv/x", "~nosuchuser/x")
        )
    if slow:
        return WRONG
    if "float" in kind:
        return NUMBERS
    if "int" in kind:
        return WHOLE
    return (*TEXTS, *FILES) if file else TEXTS


def make(place: Path) -> None:
    """The inputs, right and wrong."""
    import pyarrow as pa
    import pyarrow.parquet as pq

    from upright.bodies import Electronics, NonlinearBody
    from upright.control import make_controller, write_controller
    from upright.experiment import run as experiment
    from upright.firmware import generate
    from upright.robots import Kit, Robot
    from upright.signals import Log

    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    design = make_controller("lqg", robot, kit, 0.01)
    log = experiment(Electronics(NonlinearBody(robot), kit), design, seconds=1.5, seed=1)
    log.save(place / "run.csv")
    write_controller(design, place / "controller.json")
    robot.save(place / "robot.toml")
    generate(design, robot, kit, "pybricks").write(place / "program.py")
    (place / "kit.toml").write_text('name = "mine"\n[sensors.gyro.noise]\nvalue = 0.01\nunit = "rad/s"\n')
    (place / "campaign.toml").write_text("n = 4\nchunk = 2\nseconds = 0.2\n")
    posterior = {"parameters": ["body_mass"], "mean": [0.6], "covariance": [[1e-6]]}
    (place / "posterior.json").write_text(json.dumps(posterior))
    (place / "lines.txt").write_text("hello\nT 1 2 3*0000\n")
    (place / "folder").mkdir()
    (place / "folder.toml").mkdir()
    (place / "folder" / "keep").write_text("keep")
    (place / "loop.json").symlink_to("loop.json")
    (place / "missing-target.json").symlink_to("nowhere/x.json")
    for suffix in ("csv", "json", "toml", "parquet", "mat", "mcap"):
        (place / f"empty.{suffix}").write_bytes(b"")
        (place / f"bytes.{suffix}").write_bytes(bytes(range(256)) * 8)
    (place / "deep.json").write_text("[" * 100_000)
    (place / "deep.toml").write_text(".".join("a" * 100_000) + " = 1")
    (place / "big.json").write_text(f'{{"mean": [{"9" * 400}], "gain": [{"9" * 400}], "t": [{"9" * 400}]}}')
    (place / "big.toml").write_text(f"period = {{value = {'9' * 400}, unit = 's'}}\nname = 'x'")
    (place / "list.json").write_text("[]")
    (place / "broken.py").write_text("1/0\n")
    (place / "exits.py").write_text("raise SystemExit(7)\n")
    (place / "x.docx").write_bytes(b"PK\3\4")
    for suffix in (".parquet", ".mcap"):
        whole = log.save(place / f"cut{suffix}").read_bytes()
        (place / f"cut{suffix}").write_bytes(whole[: len(whole) // 2])
    column = pa.array([0.0, 0.1])
    pq.write_table(pa.Table.from_arrays([column] * 3, names=["t", "a", "a"]), place / "twice.parquet")
    t = log.t.copy()
    t[70:] += 1e9
    Log(t, log.channels, log.units, log.origin).save(place / "jump.csv")
    for name, factor in (("zeros", 0.0), ("huge", 1e308), ("nan", np.nan)):
        channels = {channel: values * factor for channel, values in log.channels.items()}
        Log(log.t, channels, log.units, log.origin).save(place / f"{name}.csv")
    (place / "words.csv").write_text("t,sensor/gyro\n0,up\n1,down\n")
    (place / "one.csv").write_text("t,sensor/gyro\n0,1\n")
    (place / "quotes.csv").write_text('t,"sensor/gyro\n0,1\n')
