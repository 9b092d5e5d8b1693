"""The house keeps its order: imports point down, heavy packages load late, and nothing grows too large."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.metadata import packages_distributions
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
SOURCE = CHECKOUT / "src" / "upright"

ROOMS = (
    "errors", "atomic", "signals", "robots", "physics", "compiled", "links", "bodies", "control", "logs", "doctor",
    "experiment", "kernel", "calibrate", "fleet", "firmware", "bricks", "parity", "excite", "identify", "certify",
    "diagnose", "flight", "comparison", "report", "paper", "lab", "cli",
)  # fmt: skip
"""From the ground up."""

STRANGERS = {("control", "bodies")}
"""Rooms that do not know each other although the order would allow it: a controller must not see inside a body."""

UPWARD = {("comparison/comparison.py", "report"): "a comparison writes its own page, with the page's code loaded then"}
"""The stated exceptions, lazy imports all of them."""

HEAVY = {
    "control", "cvxpy", "dask", "distributed", "fastapi", "jinja2", "matplotlib", "mcap", "mujoco", "numba", "pandas",
    "pyarrow", "rich", "scipy.signal", "slycot", "sympy", "uvicorn", "xarray", "zarr",
}  # fmt: skip
AT_ONCE = {
    ("bodies/twin.py", "mujoco"), ("paper/derivation.py", "sympy"), ("paper/errata.py", "sympy"),
    ("compiled/trace.py", "sympy"), ("compiled/trace_print.py", "sympy"), ("compiled/trace_tangent.py", "sympy"),
    ("compiled/trace_motion.py", "sympy"),
    ("kernel/cuda_loop.py", "numba"), ("calibrate/predictor.py", "numba"), ("lab/app.py", "fastapi"),
}  # fmt: skip
"""Heavy packages that a module may import when it is loaded, because it is loaded only to use them."""

SYMPY = {
    "paper/derivation.py", "paper/errata.py", "compiled/trace.py", "compiled/trace_print.py",
    "compiled/trace_tangent.py", "compiled/trace_motion.py",
}  # fmt: skip
"""Nothing else imports SymPy at all: it proves and traces, and is never needed at run time."""

MOST_LINES_OF_A_MODULE = 400
MOST_LINES_OF_A_FUNCTION = 60


@dataclass(frozen=True)
class Import:
    """One imported dotted name, in which file, on which line, and whether it runs when the file is loaded."""

    file: str
    line: int
    target: str
    at_once: bool

    def of(self, package: str) -> bool:
        return self.target == package or self.target.startswith(package + ".")

    def __str__(self) -> str:
        return f"{self.file}:{self.line} imports {self.target}"


@cache
def trees() -> dict[str, ast.Module]:
    return {p.relative_to(SOURCE).as_posix(): ast.parse(p.read_text("utf-8")) for p in sorted(SOURCE.rglob("*.py"))}


@cache
def imports() -> tuple[Import, ...]:
    return tuple(found for file, tree in trees().items() for found in walk(file, tree, at_once=True))


def walk(file: str, node: ast.AST, at_once: bool) -> Iterator[Import]:
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.Import):
            yield from (Import(file, child.lineno, name.name, at_once) for name in child.names)
        elif isinstance(child, ast.ImportFrom):
            assert child.level == 0, f"{file}:{child.lineno}: imports are written in full, from upright.…"
            yield from (Import(file, child.lineno, f"{child.module}.{name.name}", at_once) for name in child.names)
        elif isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
            yield from walk(file, child, at_once=False)
        else:
            function = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
            yield from walk(file, child, at_once and not function)


def room(path: str) -> str:
    return path.partition("/")[0].removesuffix(".py")


def between_rooms() -> list[Import]:
    return [
        i for i in imports() if i.of("upright") and i.file != "__init__.py" and i.target.split(".")[1] != room(i.file)
    ]


def test_every_folder_is_a_known_room() -> None:
    there = {room(file) for file in trees()} - {"__init__"}
    assert there <= set(ROOMS)


def test_imports_point_down() -> None:
    up = [i for i in between_rooms() if ROOMS.index(i.target.split(".")[1]) > ROOMS.index(room(i.file))]
    wrong = [i for i in up if i.at_once or (i.file, i.target.split(".")[1]) not in UPWARD]
    assert not wrong, "\n".join(map(str, wrong))


def test_strangers_stay_strangers() -> None:
    wrong = [i for i in between_rooms() if (room(i.file), i.target.split(".")[1]) in STRANGERS]
    assert not wrong, "\n".join(map(str, wrong))


def test_heavy_packages_are_imported_inside_functions() -> None:
    loaded = [(i, package) for i in imports() for package in HEAVY if i.at_once and i.of(package)]
    wrong = [i for i, package in loaded if (i.file, package) not in AT_ONCE]
    assert not wrong, "\n".join(map(str, wrong))


def test_sympy_stays_where_proofs_and_traces_are() -> None:
    wrong = [i for i in imports() if i.of("sympy") and i.file not in SYMPY]
    assert not wrong, "\n".join(map(str, wrong))


def test_every_imported_package_is_a_declared_dependency() -> None:
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]
    extras = [line for lines in project["optional-dependencies"].values() for line in lines]
    declared = {re.split(r"[<>=!~;\[ ]", line)[0].lower() for line in [*project["dependencies"], *extras]}
    homes = packages_distributions()
    outside = {i.target.split(".")[0]: i for i in imports()}
    outside = {
        name: i for name, i in outside.items() if name not in sys.stdlib_module_names | {"upright", "__future__"}
    }
    wrong = [i for name, i in outside.items() if not declared & {home.lower() for home in homes.get(name, [name])}]
    assert not wrong, "\n".join(map(str, wrong))


@pytest.mark.parametrize("module", ["upright", "upright.errors", "upright.cli.main"])
def test_start_loads_no_numerics(module: str) -> None:
    heavy = sorted({"numpy", "scipy", *HEAVY})
    code = f"import sys, {module}; print([name for name in {heavy} if name in sys.modules])"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    assert said.stdout.strip() == "[]"


def by_hand(path: Path) -> bool:
    """Nobody reads or edits a generated file; what writes it is held to the limits instead."""
    return not path.read_text("utf-8").startswith("# Generated")


def test_no_module_is_too_long() -> None:
    lengths = {path: len(path.read_text("utf-8").splitlines()) for path in SOURCE.rglob("*.py") if by_hand(path)}
    assert {str(p): n for p, n in lengths.items() if n > MOST_LINES_OF_A_MODULE} == {}


def test_no_function_is_too_long() -> None:
    functions = [
        (f"{file}:{node.lineno} {node.name}", (node.end_lineno or 0) - node.lineno + 1)
        for file, tree in trees().items()
        for node in ast.walk(tree)
        if by_hand(SOURCE / file) and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]
    assert {name: n for name, n in functions if n > MOST_LINES_OF_A_FUNCTION} == {}


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("import numpy", [("numpy", True)]),
        ("def f():\n    from scipy.signal import lti", [("scipy.signal.lti", False)]),
        (
            "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import sympy",
            [("typing.TYPE_CHECKING", True), ("sympy", False)],
        ),
        ("class A:\n    import mujoco", [("mujoco", True)]),
    ],
)
def test_the_reader_of_imports_tells_early_from_late(source: str, expected: list[tuple[str, bool]]) -> None:
    assert [(i.target, i.at_once) for i in walk("x.py", ast.parse(source), at_once=True)] == expected
