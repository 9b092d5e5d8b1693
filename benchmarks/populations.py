"""Stored populations: falls and logs with their truth, made by one commit, on which any version can be judged.

    python benchmarks/populations.py FOLDER                # ten of each kind, in an environment of its own
    python benchmarks/populations.py FOLDER --borrow       # the same with the packages of this Python: no download
    python benchmarks/populations.py FOLDER --count 2 --kinds known twins

The program and the scripts that plant are those of commit `COMMIT`: its wheel is built and installed, so that what is
made does not change with this repository. A case is a log or several as CSV, a JSON with the truth and the command that
is asked, and the robot's file where it is no preset. What is there is not made again. `judge.py` judges them.
`populations.sha256` lists files that were made on x86-64; another processor may round the last digits otherwise, and
`--list` writes the list anew.
"""

from __future__ import annotations

import hashlib
import json
import os
import subprocess
import sys
from collections.abc import Callable, Mapping
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import harness

COMMIT = "781a77f5fbe9c0ef59189ca1fd4bfea55f372026"
HERE = Path(__file__).resolve()
SHA256 = HERE.with_suffix(".sha256")
UNKNOWN = "none of these"
SEED, ELSE, TRIES = 46_000, 1000, 20
"""The first seed, and how far off the next one is where a seed gives nothing, so many times."""


def written(path: Path, columns: Mapping[str, Any], units: Mapping[str, str] | None) -> str:
    """A log as CSV to nine digits, `units` for the header of a log of ours; the file's name."""
    import numpy as np

    head = f"# upright-log: {json.dumps({'units': dict(units), 'origin': {}})}\n" if units is not None else ""
    rows = zip(*(np.asarray(column).tolist() for column in columns.values()), strict=True)
    lines = (",".join(f"{x:.9g}" for x in row) for row in rows)
    path.write_text(head + "\n".join([",".join(columns), *lines]) + "\n", "utf-8")
    return path.name


def of_log(path: Path, log: Any) -> str:
    """A log of ours, without truth and origin."""
    kept = {n: x for n, x in log.channels.items() if n.split("/")[0] in ("sensor", "command", "applied", "reference")}
    return written(path, {"t": log.t, **kept}, {n: u for n, u in log.units.items() if n in kept})


Maker = Callable[[Path, int, int], dict[str, Any] | None]
"""Writes the logs of a case beside a path, for its number and its seed; its truth, or None where it gives no case."""


def known(path: Path, number: int, seed: int) -> dict[str, Any] | None:
    import postmortem as bench

    try:
        case = bench.planted(bench.CAUSES[number % len(bench.CAUSES)], seed)
    except bench.NoFall:
        return None
    return fall([of_log(path, case.log)], case.robot, [case.cause], verdicts=[case.cause])


def pairs(path: Path, number: int, seed: int) -> dict[str, Any] | None:
    import postmortem_open as bench

    causes = bench.PAIRS[number % len(bench.PAIRS)]
    return broken(path, causes, seed, every=list(causes))


def unlisted(path: Path, number: int, seed: int) -> dict[str, Any] | None:
    import postmortem_open as bench

    cause = list(bench.UNLISTED)[number % len(bench.UNLISTED)]
    return broken(path, (cause,), seed, verdicts=[UNKNOWN, *bench.SAME_AS[cause]])


def broken(path: Path, causes: tuple[str, ...], seed: int, **right: list[str]) -> dict[str, Any] | None:
    import postmortem_open as bench

    try:
        case = bench.broken(causes, seed)
    except bench.NoFall:
        return None
    return fall([of_log(path, case.log)], case.robot, list(causes), **right)


def foreign_falls(path: Path, number: int, seed: int) -> dict[str, Any] | None:
    import postmortem_foreign as bench

    names, causes = list(bench.MACHINES), list(bench.FAULTS)
    cause = causes[number % len(causes)]
    case = bench.fall(names[number % len(names)], cause, seed)
    if case is None:
        return None
    robot = case.file.save(path.with_suffix(".toml")).name
    return fall([of_log(path, case.log)], robot, [cause], verdicts=[bench.RIGHT[cause]])


def fall(logs: list[str], robot: str, causes: list[str], **right: list[str]) -> dict[str, Any]:
    return {"command": "post-mortem", "logs": logs, "robot": robot, "planted": causes, "right": right}


def twins(path: Path, number: int, seed: int) -> dict[str, Any] | None:
    return of_twin(path, number, seed, lambda bench, name, true: [bench.twin_log(name, true, seed)])


def families(path: Path, number: int, seed: int) -> dict[str, Any] | None:
    return of_twin(path, number, seed, lambda bench, name, true: bench.runs_of(name, true, seed))


def of_twin(path: Path, number: int, seed: int, fly: Callable[[Any, str, Any], list[Any]]) -> dict[str, Any] | None:
    import calibrate as bench

    from upright.robots import Robot

    name = list(bench.DITHER)[number % len(bench.DITHER)]
    logs = fly(bench, name, true := bench.drawn(Robot.preset(name), seed))
    if any(log.origin["outcome"]["fell"] for log in logs):
        return None
    names = [of_log(path.with_stem(f"{path.stem}-{run}"), log) for run, log in enumerate(logs, 1)]
    truth = bench.truth(name, true)
    if len(logs) > 1:
        del truth["constant_command"]  # the floors of a family differ
    return {"command": "calibrate", "logs": names, "robot": name, "right": {"numbers": truth}}


def foreign_logs(path: Path, number: int, seed: int) -> dict[str, Any]:
    import calibrate_foreign as bench
    import foreign_robots

    bot, free, excitation = list(bench.ROBOTS.values())[number % len(bench.ROBOTS)]
    course = foreign_robots.Course(free=free, held=0.5, excitation=excitation)
    table = foreign_robots.metric(foreign_robots.logged(bot, course, seed), bot)
    robot = foreign_robots.known(bot).save(path.with_suffix(".toml")).name
    right = {"numbers": foreign_robots.truth_of(bot)}
    return {"command": "calibrate", "logs": [written(path, table.columns, None)], "robot": robot, "right": right}


def faults(path: Path, number: int, seed: int) -> dict[str, Any]:
    import doctor as bench

    case = bench.CASES[number * 7 % len(bench.CASES)]  # of all kinds, in a few
    log = bench.planted(case, seed)
    columns = log.columns if hasattr(log, "columns") else {"t": log.t, **log.channels}
    right = {"code": case.code, "channel": case.channel}
    return {"command": "doctor", "logs": [written(path, columns, log.units)], "planted": [case.name], "right": right}


def clean(path: Path, number: int, seed: int) -> dict[str, Any]:
    import doctor as bench

    _, log = bench.standing(seed + number)
    return {"command": "doctor", "logs": [of_log(path, log)], "right": {"code": "", "channel": ""}}


KINDS: dict[str, Maker] = {
    "known": known, "pairs": pairs, "unlisted": unlisted, "foreign-falls": foreign_falls, "twins": twins,
    "families": families, "foreign-logs": foreign_logs, "faults": faults, "clean": clean,
}  # fmt: skip


def made(work: tuple[str, str, int]) -> str:
    """Case `number` of a kind in its folder; its JSON comes last, and says that it is whole."""
    folder, kind, number = work
    path = Path(folder) / kind / f"{number:03d}.csv"
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.with_suffix(".json").exists():
        return f"{kind} {number}: there"
    for seed in range(SEED + number, SEED + number + ELSE * TRIES, ELSE):
        if truth := KINDS[kind](path, number, seed):
            text = json.dumps({"kind": kind, "seed": seed, **truth}, indent=1, ensure_ascii=False)
            path.with_suffix(".json").write_text(text + "\n", "utf-8")
            return f"{kind} {number}: made"
    return f"{kind} {number}: no seed gives one"


def environment(folder: Path, *, borrow: bool) -> Path:
    """The interpreter of an environment with the wheel of `COMMIT`, whose scripts lie beside it; made once."""
    source, home = folder / "source", folder / "env"
    python = home / "bin" / "python"
    if (folder / "whole").exists():
        return python
    source.mkdir(parents=True, exist_ok=True)
    archive = subprocess.run(["git", "-C", HERE.parents[1], "archive", COMMIT], capture_output=True, check=True).stdout
    subprocess.run(["tar", "-x", "-C", source], input=archive, check=True)
    subprocess.run([sys.executable, "-m", "venv", home], check=True)
    pip = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, *(["--no-deps"] if borrow else []), source], check=True)
    if borrow:
        import sysconfig

        (site,) = home.glob("lib/python*/site-packages")
        (site / "borrowed.pth").write_text(sysconfig.get_path("purelib") + "\n")
    (folder / "whole").touch()
    return python


def checked(folder: Path, *, anew: bool) -> str:
    """Compare the files with the list, or write the list."""
    files = sorted(p for kind in KINDS for p in (folder / kind).glob("*") if p.is_file())
    found = {p.relative_to(folder).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}
    if anew:
        SHA256.write_text("".join(f"{digest}  {name}\n" for name, digest in found.items()))
    lines = SHA256.read_text().splitlines() if SHA256.exists() else []
    listed = {name: digest for digest, name in (line.split("  ", 1) for line in lines)}
    differ = [name for name, digest in found.items() if listed.get(name, digest) != digest]
    new = sum(name not in listed for name in found)
    return f"{len(found)} files, {new} not in the list, {len(differ)} differ from it: {', '.join(differ) or 'none'}"


def main() -> None:
    asked = harness.options(
        __doc__, ("folder", Path), count=10, kinds=tuple(KINDS), workers=1, borrow=False, list=False, inside=False
    )
    folder = asked.folder.resolve()
    if asked.inside:
        work = [(str(folder), kind, number) for kind in asked.kinds for number in range(asked.count)]
        with ProcessPoolExecutor(asked.workers) as pool:
            for said in pool.map(made, work):
                print(said, flush=True)
        return
    python, source = environment(folder / "maker", borrow=asked.borrow), folder / "maker" / "source"
    numbers = ["--count", str(asked.count), "--workers", str(asked.workers), "--kinds", *asked.kinds]
    paths = {"PYTHONPATH": os.pathsep.join(map(str, (source / "benchmarks", source / "tests", HERE.parent)))}
    subprocess.run([python, "-P", HERE, folder, "--inside", *numbers], env={**os.environ, **paths}, check=True)
    print(checked(folder, anew=asked.list))


if __name__ == "__main__":
    main()
