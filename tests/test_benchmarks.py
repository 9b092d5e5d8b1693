"""Benchmarks run rarely, so that what they need is checked here: their imports, their place in the readme, and what
they share."""

from __future__ import annotations

import ast
import sys
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest

FOLDER = Path(__file__).resolve().parents[1] / "benchmarks"
SCRIPTS = sorted(path.name for path in FOLDER.glob("*.py"))


@pytest.fixture
def harness(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(FOLDER))
    return import_module("harness")


@pytest.mark.parametrize("script", SCRIPTS)
def test_every_name_that_a_benchmark_imports_is_there(script: str) -> None:
    tree = ast.parse((FOLDER / script).read_text("utf-8"))
    froms = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
    ours = [node for node in froms if node.module and node.module.split(".")[0] in ("upright", "planted")]
    for node in ours:
        module = import_module(node.module)
        for name in (alias.name for alias in node.names):
            assert hasattr(module, name) or import_module(f"{node.module}.{name}"), f"{script}: {node.module}.{name}"


def test_the_readme_names_every_script_once() -> None:
    rows = [line for line in (FOLDER / "README.md").read_text("utf-8").splitlines() if line.startswith("| `")]
    assert sorted(row.split("`")[1] for row in rows) == [name for name in SCRIPTS if name != "harness.py"]


def test_a_share_has_wilsons_interval(harness: ModuleType) -> None:
    # 1 of 1: from 1/(1 + z²) to 1, with z = 1.96 (Wilson 1927)
    assert harness.share(1, 1) == "1 of 1 (100.0%, 21% to 100%)"
    assert harness.share(0, 0) == "0 of 0"


@dataclass(frozen=True)
class Square:
    value: int


def test_a_run_that_was_interrupted_asks_nothing_twice(harness: ModuleType, tmp_path: Path) -> None:
    asked: list[tuple[str, int]] = []

    def judge(key: tuple[str, int]) -> Square:
        asked.append(key)
        if key[1] == 2 and len(asked) == 3:
            raise KeyboardInterrupt
        return Square(key[1] ** 2)

    keys, kept = [("a", n) for n in range(4)], tmp_path / "told.jsonl"
    with pytest.raises(KeyboardInterrupt):
        harness.cases(judge, keys, Square, 1, kept)
    told = harness.cases(judge, keys, Square, 1, kept)
    assert [one.value for one in told] == [0, 1, 4, 9]
    assert asked == [*keys[:3], *keys[2:]]


def test_options_are_of_the_kind_of_their_default(harness: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["x", "7", "--robots", "a", "b", "--quick", "--wall", "0.5"])
    asked = harness.options("", ("count", 40), robots=("z",), quick=False, wall=float, seed=3, each=False)
    assert (asked.count, list(asked.robots), asked.quick, asked.wall) == (7, ["a", "b"], True, 0.5)
    assert (asked.seed, asked.each) == (3, False)


def test_a_text_in_a_column_of_numbers_is_aligned(harness: ModuleType, capsys: pytest.CaptureFixture[str]) -> None:
    table = harness.Table("name <6", "largest size >14.2f")
    table.row("a", 2 / 3)
    table.row("b", "none")
    assert capsys.readouterr().out.splitlines() == [
        "name    largest size",
        "a               0.67",
        "b               none",
    ]
