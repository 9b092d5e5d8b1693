"""The JSON of every result keeps the schema that is published, by an independent validator; the three scripts of the
how-to run as they stand there."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from schemas import FOLDER, LONG, QUICK, kinds, ran, schema_of
from upright.cli.main import main

ROOT = Path(__file__).parents[1]
FILES = sorted(FOLDER.glob("*.json"), key=lambda path: path.stem)


@cache
def published(named: str) -> dict[str, Any]:
    """The schema of a name such as upright/fleet/1."""
    return json.loads((FOLDER / f"{named.split('/')[1]}.json").read_text("utf-8"))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where all runs leave the files that others read."""
    return tmp_path_factory.mktemp("runs")


@pytest.mark.parametrize("command", [*QUICK, *(pytest.param(c, marks=pytest.mark.evidence) for c in LONG)])
def test_the_json_of_a_command_keeps_its_schema(command: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    data, result = ran(command)
    schema = published(data["schema"])
    assert schema["$id"] == data["schema"]
    Draft202012Validator(schema).validate(data)
    # what the library gives, without the words that a page begins with
    Draft202012Validator(schema).validate(json.loads(json.dumps(result.to_json())))
    # nor has a type changed of which these values show nothing: what is made anew adds nothing to what is published
    assert unknown(schema_of(data, result), schema) == []


def unknown(new: dict[str, Any], old: dict[str, Any], at: str = "") -> list[str]:
    """Where a new schema allows what the old one does not."""
    more = set(kinds(new)) - set(kinds(old))
    if more == {"integer"} and "number" in kinds(old):
        more = set[str]()
    wrong = [at] if more or new.get("const") != old.get("const") else []
    for name, inner in new.get("properties", {}).items():
        known = old.get("properties", {}).get(name)
        wrong += unknown(inner, known, f"{at}/{name}") if known else [f"{at}/{name}"]
    for name in ("items", "additionalProperties"):
        if isinstance(new.get(name), dict) and isinstance(old.get(name), dict):
            wrong += unknown(new[name], old[name], f"{at}/*")
    return wrong


def leaves(value: Any, at: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The way to every key of records and to every number or text, the first of each list alone."""
    if at:
        yield at
    inner = value.items() if isinstance(value, dict) else enumerate(value[:1]) if isinstance(value, list) else ()
    for key, one in inner:
        if key not in ("origin", "head", "facts"):  # which hold anything
            yield from leaves(one, (*at, key))


def changed(data: Any, way: tuple[Any, ...], change: Any) -> Any:
    """The data with `change` made to what holds the last key of a way."""
    copy = json.loads(json.dumps(data))
    inside = copy
    for key in way[:-1]:
        inside = inside[key]
    change(inside, way[-1])
    return copy


def of_another_type(inside: Any, key: Any) -> None:
    inside[key] = 1 if isinstance(inside[key], dict | list) else ["x"]


@pytest.mark.parametrize(
    "command", ["certify lqg --samples 100", "simulate --push impulse:0.1 --seconds 2", "doctor run.csv"]
)
def test_a_key_that_is_added_lost_or_of_another_type_breaks_the_schema(
    command: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    data, result = ran(command)
    valid = Draft202012Validator(published(data["schema"])).is_valid
    assert valid(data)
    assert not valid(changed(data, ("more",), lambda inside, key: inside.update({key: 1})))
    names = result.to_json()
    assert len(names) > 5
    for name in names:
        assert not valid(changed(data, (name,), lambda inside, key: inside.pop(key))), name
    for way in leaves(data):
        assert not valid(changed(data, way, of_another_type)), way


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_published_schema_is_one(path: Path) -> None:
    schema = json.loads(path.read_text("utf-8"))
    Draft202012Validator.check_schema(schema)
    assert re.fullmatch(rf"upright/{path.stem}/\d+", schema["$id"])
    assert schema["properties"]["schema"] == {"const": schema["$id"]}
    assert schema["additionalProperties"] is False


def test_the_page_of_schemas_lists_all_of_them() -> None:
    page = (ROOT / "docs" / "schemas.md").read_text("utf-8")
    assert re.findall(r"schemas/([\w-]+)\.json\)", page) == [path.stem for path in FILES]
    for path in FILES:
        row = next(line for line in page.splitlines() if f"/{path.name})" in line)
        keys = re.findall(r"`([\w.[\]]+)`", row.split("|")[3])
        assert keys
        for key in keys:
            name = key.split(".")[0].removesuffix("[]")
            assert name in json.loads(path.read_text("utf-8"))["properties"], key
    every = {command.split()[0] for command in (*QUICK, *LONG)}
    assert {path.stem.removesuffix("-all").removesuffix("-log") for path in FILES} == every


HOW_TO = (ROOT / "docs" / "how-to.md").read_text("utf-8")
SCRIPTS = dict(
    zip(
        ("shell", "python", "job"),
        re.findall(r"```(?:sh|python)\n(.*?)```", HOW_TO.partition("## Use it in scripts")[2], re.DOTALL),
        strict=False,
    )
)


def run(script: list[str], folder: Path) -> subprocess.CompletedProcess[str]:
    """A script in this folder, with `upright` as this Python has it."""
    program = folder / "bin" / "upright"
    program.parent.mkdir(exist_ok=True)
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m upright "$@"\n', "utf-8")
    program.chmod(0o755)
    path = f"{program.parent}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(
        script, cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True, check=False
    )


@pytest.mark.evidence
@pytest.mark.needs("jq", "bash")
def test_the_script_of_the_shell_runs(tmp_path: Path) -> None:
    ended = run(["bash", "-c", SCRIPTS["shell"]], tmp_path)
    first, *rows = ended.stdout.splitlines()
    assert first == '"green"', ended.stderr
    assert [row.split("\t")[:2] for row in rows[:2]] == [["lqr", "green"], ["lqg", "green"]]
    assert rows[2].startswith("pid")
    assert all(0 < float(row.split("\t")[2]) < 1 for row in rows)
    # one run says in text and as JSON what the library says of it
    assert main(["certify", "lqg", "--samples", "200", "-o", str(tmp_path / "lqg.json")]) == 0
    assert float(rows[1].split("\t")[2]) == json.loads((tmp_path / "lqg.json").read_text("utf-8"))["bound"]


@pytest.mark.evidence
def test_the_script_in_python_runs(tmp_path: Path) -> None:
    ended = run([sys.executable, "-c", SCRIPTS["python"]], tmp_path)
    assert re.fullmatch(r"lq[rg] is green: at most [1-5]\.\d% fall\n", ended.stdout), ended.stderr


@pytest.mark.evidence
@pytest.mark.needs("jq", "bash")
@pytest.mark.parametrize(("robot", "code"), [("nxtway-gs", 0), ("balrob", 3)])
def test_the_job_ends_with_its_exit_code(robot: str, code: int, tmp_path: Path) -> None:
    """Of balrob too much is guessed for a verdict, as docs/certificate.md says."""
    assert main(["robots", "show", robot, "-o", str(tmp_path / "mine.toml")]) == 0
    ended = run(["bash", "-c", SCRIPTS["job"]], tmp_path)
    assert ended.returncode == code, ended.stderr
    assert (tmp_path / "balance.c").exists() == (code == 0)
    assert (tmp_path / "certificate.html").exists()
