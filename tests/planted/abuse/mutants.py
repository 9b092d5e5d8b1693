"""Mutants of every file that a command reads: 0 crashes, nothing but one-line errors of ours, at most 1 GB."""

from __future__ import annotations

import json
import random
import re
import tempfile
import tomllib
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

from planted.abuse.forked import forked

BATCH = 25
"""Mutants read by one child; a batch that does not end well is read again one by one."""

COUNT = 3200
MOST = 1024.0
"""[MB] that a reader may take."""

Reader = Callable[[Path], Any]
Row = tuple[str, str, str, bool]

HOSTILE = (
    None, True, -1, 0, 1e308, -1e308, 5e-324, 10**400, "", "x", "NaN", "*/", [], [[]], {}, {"a": 1}, [None], ["a"],
    float("nan"), float("inf"), 2**63, "\ud800", "a" * 5000, [1] * 7, [[1, 2], [3]],
)  # fmt: skip
"""What takes the place of a number, a text or a list."""


def measure(seed: int, minutes: float | None) -> Iterator[Row]:
    count = COUNT if minutes is None else max(40, int(COUNT * minutes / 4))
    with tempfile.TemporaryDirectory(prefix="upright-mutants-") as folder:
        yield from rows(Path(folder), seed, count)


def rows(folder: Path, seed: int, count: int) -> Iterator[Row]:
    """One row for each format, and one for all."""
    samples = made(folder)
    of_each = -(-count // len(samples))
    total, bad, most = 0, Counter[str](), 0.0
    for name, (path, read) in samples.items():
        faults, peak = tried(path, read, of_each, f"{seed} {name}", folder)
        total, most = total + of_each, max(most, peak)
        bad += faults
        worst = "; ".join(f"{n} × {fault}" for fault, n in faults.most_common(4))
        yield (
            f"{name}: {of_each} mutants {worst}"[:200],
            f"{peak:.0f} MB",
            f"0 faults, {MOST:.0f} MB",
            (not faults and peak <= MOST),
        )
    yield f"{total} mutants of {len(samples)} formats", f"{bad.total()} faults", "0", not bad


def tried(path: Path, read: Reader, count: int, seed: str, folder: Path) -> tuple[Counter[str], float]:
    """The faults of `count` mutants of one file by what happened, and the largest peak of memory [MB]."""
    rng = random.Random(seed)
    scratch = folder / "scratch"
    scratch.mkdir(exist_ok=True)
    mutants = [mutant(path, rng) for _ in range(count)]
    faults, peak = Counter[str](), 0.0
    at_once = 4 if path.suffix == ".mat" else BATCH  # a process for each is slow to start
    for first in range(0, count, at_once):
        batch = mutants[first : first + at_once]
        ended = forked(lambda b=batch: [_read(read, path, data, scratch) for data in b], scratch)
        peak = max(peak, ended.peak)
        if not ended.how and not any(ended.value) and ended.peak <= MOST:
            continue
        for data in batch:
            alone = forked(lambda d=data: [_read(read, path, d, scratch)], scratch)
            fault = alone.how or alone.value[0] or (f"takes {alone.peak:.0f} MB" if alone.peak > MOST else "")
            if fault:
                faults[fault] += 1
    return faults, peak


def _read(read: Reader, path: Path, data: bytes, scratch: Path) -> str:
    """Nothing where the file is read, or refused in one line; else what came instead."""
    from upright.errors import UprightError

    target = scratch / path.name
    target.write_bytes(data)
    try:
        read(target)
    except UprightError as error:
        return "" if len(str(error).splitlines()) == 1 else f"error of several lines: {str(error)[:60]!r}"
    except Exception as error:
        import traceback

        last = traceback.extract_tb(error.__traceback__)[-1]
        return f"{type(error).__name__} at {Path(last.filename).name}:{last.lineno} {str(error)[:60]!r}"
    return ""


def mutant(path: Path, rng: random.Random) -> bytes:
    """The bytes of `path` with one to four changes, in the structure where it has one, or anywhere."""
    data = path.read_bytes()
    if path.suffix in (".json", ".toml") and rng.random() < 0.6:
        return _structured(path, data, rng)
    for _ in range(rng.choice((1, 1, 2, 4))):
        data = _damaged(data, rng)
    return data


def _damaged(data: bytes, rng: random.Random) -> bytes:  # noqa: PLR0911 (one return for each kind of damage)
    at, kind = rng.randrange(len(data) + 1), rng.randrange(8)
    length = rng.choice((1, 2, 8, 64, 1000))
    if kind == 0:
        return data[:at]
    if kind == 1:
        return data[:at] + data[at + length :]
    if kind == 2:
        return data[:at] + rng.randbytes(length) + data[at + length :]
    if kind == 3:
        return data[:at] + data[at : at + length] * 3 + data[at + length :]
    if kind == 4:
        words = (b"nan", b"inf", b"-1e308", b"9" * 400, b"\0", b"\xff\xfe", b"[" * 3000, b'"', b"\r", b",,,,", b"1e999")
        return data[:at] + rng.choice(words) + data[at:]
    if kind == 5 and data:
        at = min(at, len(data) - 1)
        return data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1 :]
    if kind == 6:
        numbers = [m.span() for m in re.finditer(rb"-?\d+(?:\.\d+)?(?:e-?\d+)?", data[:200_000])]
        if numbers:
            first, last = rng.choice(numbers)
            new = rng.choice((b"nan", b"1e308", b"-1e308", b"1e9", b"9" * 400, b"0", b"-1", b"x", b""))
            return data[:first] + new + data[last:]
    other = rng.randrange(len(data) + 1)
    first, last = sorted((at, other))
    return data[:first] + data[last : last + length] + data[first:]


def _structured(path: Path, data: bytes, rng: random.Random) -> bytes:
    """A leaf or a branch replaced by a hostile value; a controller's hash is made to fit again."""
    table = json.loads(data) if path.suffix == ".json" else tomllib.loads(data.decode())
    places = list(_places(table))
    for _ in range(rng.choice((1, 1, 2))):
        holder, key = rng.choice(places)
        value = rng.choice(HOSTILE)
        if rng.random() < 0.1 and isinstance(holder, dict):
            holder.pop(key, None)
        elif isinstance(holder, list) and key >= len(holder):
            continue
        else:
            holder[key] = value
    if path.suffix == ".toml":
        return "".join(_toml(table)).encode("utf-8", "surrogatepass")
    text = json.dumps(table)
    return text.encode("utf-8", "surrogatepass")


def _places(value: Any) -> Iterator[tuple[Any, Any]]:
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in list(items)[:60]:
        yield value, key
        yield from _places(inner)


def _toml(table: Any, prefix: str = "") -> Iterator[str]:
    """Any table as TOML, whether it makes sense or not."""
    if not isinstance(table, dict):
        return
    tables = {k: v for k, v in table.items() if isinstance(v, dict)}
    for key, value in table.items():
        if key not in tables:
            yield f"{json.dumps(key)} = {_value(value)}\n"
    for key, value in tables.items():
        path = f"{prefix}{json.dumps(key)}"
        yield f"\n[{path}]\n"
        yield from _toml(value, f"{path}.")


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return {"nan": "nan", "inf": "inf", "-inf": "-inf"}.get(repr(value), repr(value))
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(k)} = {_value(v)}" for k, v in value.items()) + "}"
    return '"?"' if value is None else json.dumps(value)


def made(folder: Path) -> dict[str, tuple[Path, Reader]]:  # noqa: PLR0915 (a list of formats)
    """A valid file of every format, with what reads it and uses what it read."""
    from upright.bodies import Electronics, NonlinearBody
    from upright.bricks.rxe import read_rxe
    from upright.certification import certify, read_certificate
    from upright.control import make_controller, read_controller, write_controller
    from upright.experiment import run
    from upright.firmware import generate
    from upright.firmware.generate import head, longest_run
    from upright.firmware.program_file import read_text
    from upright.fleets.results import load
    from upright.fleets.sweep import read_campaign
    from upright.flight.program_logs import read_lines
    from upright.logs.mapping import Mapping
    from upright.logs.raw import raw_log
    from upright.logs.readers import read_table
    from upright.physics.linear import linearise
    from upright.robots import Kit, Robot
    from upright.robots.uncertainty import read_posterior
    from upright.signals import Log

    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    log = run(Electronics(NonlinearBody(robot), kit), make_controller("lqg", robot, kit, 0.01), seconds=1.5, seed=1)
    samples: dict[str, tuple[Path, Reader]] = {}

    def add(name: str, path: Path, *reads: Reader) -> None:
        samples[name] = path, lambda p: [read(p) for read in reads]

    for suffix in (".csv", ".parquet", ".mcap"):
        add(f"log {suffix}", log.save(folder / f"log{suffix}"), lambda p: str(Log.load(p)))
        add(f"raw {suffix}", log.save(folder / f"raw{suffix}"), lambda p: len(raw_log(p)))
    named = {"enc_left": "sensor/encoder_left", "enc_right": "sensor/encoder_right", "gyro": "sensor/gyro"}
    named |= {"pwm_left": "applied/left", "pwm_right": "applied/right"}
    foreign = {"t": log.t, **{name: log[channel] for name, channel in named.items()}}
    (folder / "columns.json").write_text(json.dumps({k: v.tolist() for k, v in foreign.items()}))
    add("columns .json", folder / "columns.json", read_table, raw_log)
    text = "\n".join(";".join(f"{x:.6f}".replace(".", ",") for x in row) for row in zip(*foreign.values(), strict=True))
    (folder / "foreign.txt").write_text(";".join(foreign) + "\n" + text + "\n")
    add("foreign .txt", folder / "foreign.txt", read_table, raw_log)
    from scipy.io import savemat

    for compressed in (False, True):
        path = folder / f"columns{int(compressed)}.mat"
        savemat(path, {"run": dict(foreign), "t": foreign["t"]}, do_compression=compressed)
        add(f"mat {'compressed' if compressed else 'plain'}", path, read_table)
    add("robot .toml", robot.save(folder / "robot.toml"), lambda p: linearise(Robot.load(p)).poles())
    from importlib import resources

    for name in ("nxt", "ideal"):
        path = folder / f"kit-{name}.toml"
        path.write_text(resources.files("upright.robots").joinpath("kits", f"{name}.toml").read_text("utf-8"))
        add(f"kit {name} .toml", path, Kit.load)
    mapping = resources.files("upright.logs").joinpath("mappings")
    first = sorted(entry.name for entry in mapping.iterdir() if entry.name.endswith(".toml"))[0]
    (folder / "mapping.toml").write_text(mapping.joinpath(first).read_text("utf-8"))
    add("mapping .toml", folder / "mapping.toml", Mapping.load)
    (folder / "campaign.toml").write_text(
        'robots = ["nxtway-gs"]\ncontrollers = ["lqr"]\nkit = "nxt"\nn = 10\nchunk = 5\nseed = 1\nseconds = 1.0\n'
        'vary = ["com_height=±10%"]\nkeep = ["peak_pitch"]\n[[scenario]]\nname = "push"\n'
        'push = ["impulse:0.1,start=0.2"]\n[grid]\nbody_mass = [0.5, 0.6]\n'
    )
    add("campaign .toml", folder / "campaign.toml", read_campaign)
    sizes = np.diag([1e-6, 1e-4]).tolist()
    posterior = {"parameters": ["com_height", "body_mass"], "mean": [0.07, 0.6], "covariance": sizes}
    (folder / "posterior.json").write_text(json.dumps(posterior))
    add("posterior .json", folder / "posterior.json", read_posterior)
    for name in ("lqg", "sliding", "mpc", "lqr-complementary", "lqr-state"):
        design = make_controller(name, robot, kit, 0.01)
        path = write_controller(design, folder / f"{name}.json")
        add(f"controller {name} .json", path, lambda p: _driven(read_controller(p)))
        add(f"controller {name} .json, its hash made anew", path, _rehashed)
    certificate = certify("lqr", robot, kit, samples=100)
    from upright.atomic import write_json

    path = write_json(folder / "certificate.json", certificate.to_json())
    add("certificate .json", path, lambda p: str(read_certificate(p)))
    design = make_controller("lqg", robot, kit, 0.01)
    for target in ("pybricks", "nxc", "c"):
        made_of = generate(design, robot, kit, target)
        path = made_of.write(folder / f"program{next(iter(made_of.files))}")[0]
        add(f"program {path.suffix}", path, lambda p: head(read_text(p)), lambda p: longest_run(read_text(p)))
    recorded = Path(__file__).resolve().parents[2] / "golden"
    for path in sorted(recorded.rglob("*.rxe"))[:1]:
        add("program .rxe", path, read_rxe)
    lines = folder / "lines.txt"
    lines.write_text("\n".join(_program_lines()))
    add("lines of a program", lines, lambda p: read_lines(p.read_text("utf-8", "replace").splitlines()))
    from upright.fleets.fleet import ensemble_of, fleet
    from upright.fleets.results import save

    save(fleet(ensemble_of("nxtway-gs", "lqr", seconds=0.3), 20).data, folder / "fleet.parquet")
    add("fleet .parquet", folder / "fleet.parquet", load)
    return samples


def _driven(controller: Any) -> None:
    """What a run does with a controller."""
    controller.reset()
    controller.step(np.zeros(len(controller.spec.reads)), np.zeros(6))


def _rehashed(path: Path) -> None:
    """The same file with a hash that fits, as somebody makes it who edits it and knows how."""
    from unittest.mock import patch

    from upright.control import controller_hash, read_controller

    try:
        own = json.loads(path.read_text("utf-8")).get("hash")
    except (ValueError, AttributeError, RecursionError):
        own = None  # no JSON table, so no hash to fit: the reader itself must say so
    with patch("upright.control.files.controller_hash", lambda _: own):
        controller = read_controller(path)
    controller_hash(controller)
    _driven(controller)


def _program_lines() -> list[str]:
    import binascii

    texts = ["H robot=nxtway-gs;kit=nxt;hash=0123456789abcdef;period=0.01;rows=4"]
    texts += ["H first=0;late=0;status=0;offset=0.5"]
    texts += [f"D {k} " + "00" * 14 for k in range(4)] + ["E 4"]
    return [f"{text}*{binascii.crc_hqx(text.encode(), 0xFFFF):04X}" for text in texts]
