"""Files that nobody wrote on purpose, or somebody did: every reader refuses them in one line and little memory.

`benchmarks/abuse.py mutants` tries thousands; here is a seeded part, and by name those that once took a machine down.
"""

from __future__ import annotations

import contextlib
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from planted.abuse import mutants
from upright.certification import read_certificate
from upright.control import make_controller, read_controller, write_controller
from upright.control.controller import controller_hash
from upright.errors import UprightError
from upright.excitation.plan import read_plan
from upright.fleets.results import load
from upright.fleets.sweep import read_campaign
from upright.logs.mapping import Mapping
from upright.logs.readers import read_table
from upright.robots import Kit, Robot
from upright.robots.uncertainty import read_posterior
from upright.signals import Log

DIGITS = "9" * 400

TOML = {
    "deep array": "a = " + "[" * 100_000,
    "deep keys": ".".join("a" * 100_000) + " = 1",
    "deep table": "[" + ".".join("a" * 100_000) + "]",
    "400 digits": f"period = {{value = {DIGITS}, unit = 's'}}\nname = 'x'",
    "beyond every number": "period = {value = 1e999, unit = 's'}\nname = 'x'",
    "not UTF-8": b"name = '\xff'",
    "a zero": "name = 'a\0b'",
    "[time] of numbers": "[time]\ncolumn = 1\n[channels]\na = 3",
    "unit of numbers": "[time]\ncolumn = 't'\nunit = 1.5\n[channels]\n",
    "unit of lists": "[time]\ncolumn = 't'\nunit = [1]\n[channels]\n",
    "constants of text": "[time]\ncolumn = 't'\n[channels]\n[constants]\na = 'x'\n",
    "sizes of text": "n = 'x'\nchunk = []",
    "negative sizes": "n = -5\nchunk = 0",
    "a number of robots": "n = inf",
}
JSON = {
    "deep lists": "[" * 100_000,
    "deep tables": '{"a":' * 100_000,
    "400 digits": f'{{"mean": [{DIGITS}], "parameters": ["body_mass"], "covariance": [[1]], "t": [{DIGITS}, 1]}}',
    "beyond every number": '{"t": [1e999, 1]}',
    "half a character": '{"file": "\\ud800", "\\udfff": [1]}',
    "null": "null",
    "a number": "7",
    "a list": "[]",
    "not UTF-8": b'{"a": "\xff"}',
    "lists in lists": '{"t": [[1], [2, [3]]], "a": [{}, null]}',
    "empty": "",
    "a certificate of nothing": '{"file": "upright certificate", "version": 1}',
    "a controller of nothing": '{"file": "upright controller", "version": 1, "form": "linear", "controller": []}',
    "a list of forms": '{"file": "upright controller", "version": 1, "form": ["linear"], "controller": 3}',
    "many states": '{"file": "upright controller", "version": 1, "form": "linear", "hash": "", "controller": '
    '{"states": 1e9, "reads": [], "period": 0.01, "command_unit": "V", "kind": "x"}}',
}
READ_TOML: dict[str, Callable[[Path], Any]] = {
    "robot": Robot.load, "kit": Kit.load, "mapping": Mapping.load, "campaign": read_campaign,
}  # fmt: skip
READ_JSON: dict[str, Callable[[Path], Any]] = {
    "posterior": read_posterior, "controller": read_controller, "certificate": read_certificate, "plan": read_plan,
    "table": read_table,
}  # fmt: skip


def refused(read: Callable[[Path], Any], path: Path, content: str | bytes) -> None:
    path.write_bytes(content if isinstance(content, bytes) else content.encode("utf-8", "surrogatepass"))
    with pytest.raises(UprightError) as refusal:
        read(path)
    assert len(str(refusal.value)) < 1000
    assert len(str(refusal.value).splitlines()) == 1


@pytest.mark.parametrize("content", TOML)
@pytest.mark.parametrize("reader", READ_TOML)
def test_a_table_that_is_none_is_refused_in_one_line(reader: str, content: str, tmp_path: Path) -> None:
    refused(READ_TOML[reader], tmp_path / "file.toml", TOML[content])


@pytest.mark.parametrize("content", JSON)
@pytest.mark.parametrize("reader", READ_JSON)
def test_json_that_is_none_is_refused_in_one_line(reader: str, content: str, tmp_path: Path) -> None:
    refused(READ_JSON[reader], tmp_path / "file.json", JSON[content])


@pytest.mark.parametrize("reader", [*READ_TOML.values(), *READ_JSON.values(), Log.load, load])
@pytest.mark.parametrize("name", ["~nosuchuser/file", "a\0b", "", ".", "x" * 300])
def test_a_path_that_is_none_is_refused_in_one_line(reader: Callable[[Path], Any], name: str) -> None:
    with pytest.raises(UprightError):
        reader(Path(name + ".parquet" if reader in (Log.load, load) else name))


@pytest.mark.parametrize("form", ["lqg", "sliding", "mpc", "lqr-complementary", "lqr-state"])
@pytest.mark.parametrize("value", [None, True, "x", [], {}, -1, 0, 1e308, [["a"]], [[]], "NaN"], ids=repr)
def test_a_controller_of_wrong_types_is_refused_also_with_a_hash_that_fits(
    form: str, value: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Somebody who can edit the file can make its hash anew: types, sizes and signs are checked by themselves."""
    path = write_controller(
        make_controller(form, Robot.preset("nxtway-gs"), Kit.preset("nxt"), 0.01), tmp_path / "c.json"
    )
    data = json.loads(path.read_text("utf-8"))
    monkeypatch.setattr("upright.control.files.controller_hash", lambda _: data["hash"])
    holders = [data["controller"], *(v for v in data["controller"].values() if isinstance(v, dict))]
    for holder in holders:
        for key in list(holder):
            before, holder[key] = holder[key], value
            path.write_text(json.dumps(data), "utf-8")
            with contextlib.suppress(UprightError):
                controller = read_controller(path)
                controller_hash(controller)
                controller.reset()
                controller.step(np.zeros(len(controller.spec.reads)), np.zeros(6))
            holder[key] = before


def test_a_column_that_stands_twice_is_refused(tmp_path: Path) -> None:
    column = pa.array([0.0, 0.1])
    table = pa.Table.from_arrays([column, column, column], names=["t", "sensor/gyro", "sensor/gyro"])
    pq.write_table(table, tmp_path / "twice.parquet")
    for read in (Log.load, read_table):
        with pytest.raises(UprightError, match="'sensor/gyro' appears"):
            read(tmp_path / "twice.parquet")


@pytest.mark.parametrize("reader", [Log.load, read_table])
@pytest.mark.parametrize("suffix", ["parquet", "csv"])
def test_a_log_that_would_fill_the_memory_is_refused_before_it_does(
    reader: Callable[[Path], Any], suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("upright.signals.header.MOST_NUMBERS", 1000)
    t = np.arange(400.0)
    log = Log(t, {"sensor/gyro": 0 * t, "command/left": 0 * t})
    path = log.save(tmp_path / f"large.{suffix}")
    with pytest.raises(UprightError, match=r"120\d numbers.*at most 1000"):
        reader(path)


def test_a_damaged_mat_file_cannot_take_the_program_with_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the parser does to its process, here by a signal, the caller gets one line."""
    from scipy.io import savemat

    path = tmp_path / "run.mat"
    savemat(path, {"t": np.arange(5.0), "gyro": np.ones(5)})
    assert read_table(path).columns["gyro"].tolist() == [1.0] * 5
    crash = "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)"
    monkeypatch.setattr("upright.logs.readers.MAT_READER", [sys.executable, "-c", crash])
    with pytest.raises(UprightError, match="MAT file cannot be read"):
        read_table(path)


@pytest.mark.evidence
def test_a_seeded_part_of_the_mutants(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = list(mutants.rows(tmp_path, seed=7, count=200))
    assert len(rows) > 20
    assert [what for what, _, _, held in rows if not held] == []
