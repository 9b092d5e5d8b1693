"""Does the suite notice a wrong sign? Forty mutations, planted one at a time, and the tests that execute their line.

    pip install pytest-cov
    python tests/planted/mutations.py list                      # the forty, each as one line
    python tests/planted/mutations.py map --tests tests         # one run with coverage: which test executes what
    python tests/planted/mutations.py run --tests tests         # about an hour; goes on where it was stopped

`--tests` may be the tests of another commit, to compare two suites on the same forty; `--folder` keeps what was found.
Half of the mutations change a number or a sign, half a condition; which forty is decided by `--seed`. A line that
coverage cannot see (numba compiles it) is tried by the test files that name its room.
"""

from __future__ import annotations

import argparse
import ast
import copy
import json
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
ROOMS = ("physics", "control", "robots", "signals", "compiled", "calibrate", "certify", "firmware", "cli")
SIGNS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}
ORDER = {ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq}
LONGEST = 1200  # s for the tests of one mutation: what hangs is noticed, too


class Mutation(NamedTuple):
    """One change of one expression: its file below `src/upright`, its place in it, and its text before and after."""

    file: str
    line: int
    start: int
    end: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.before} -> {self.after}"


def changed(node: ast.expr) -> tuple[str, ast.expr] | None:
    """What an expression becomes, after the kind of its mutation (`number`, `condition`); None where it has none."""
    new = copy.deepcopy(node)
    kind = "condition"
    match new:
        case ast.BinOp(op=op) if type(op) in SIGNS and not isinstance(new.left, ast.Constant | ast.JoinedStr):
            new.op = SIGNS[type(op)]()
            kind = "number"
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            new = operand
            kind = "number"
        case ast.Constant(value=float(value)) if value:
            new.value = 1.1 * value
            kind = "number"
        case ast.Compare(ops=[op]) if type(op) in ORDER:
            new.ops = [ORDER[type(op)]()]
        case ast.BoolOp(op=op):
            new.op = ast.Or() if isinstance(op, ast.And) else ast.And()
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            new = operand
        case _:
            return None
    return kind, new


def executed(tree: ast.Module) -> Iterator[ast.expr]:
    """The expressions inside functions, without annotations and the parts of f-strings."""
    for function in ast.walk(tree):
        if isinstance(function, ast.FunctionDef):
            todo: list[ast.AST] = list(function.body)
            while todo:
                node = todo.pop()
                if isinstance(node, ast.FunctionDef | ast.JoinedStr | ast.AnnAssign):
                    continue
                if isinstance(node, ast.expr) and node.lineno == node.end_lineno:
                    yield node
                todo += ast.iter_child_nodes(node)


def mutations(seed: int, number: int = 40) -> list[Mutation]:
    """Mutations drawn by a seed: half of numbers and signs, half of conditions, the rooms in turn."""
    found: dict[tuple[str, str], list[Mutation]] = {}
    for room in ROOMS:
        for path in sorted((ROOT / "src" / "upright" / room).rglob("*.py")):
            text = path.read_text("utf-8")
            if path.name.startswith("generated"):
                continue
            for node in executed(ast.parse(text)):
                if made := changed(node):
                    kind, new = made
                    before = str(ast.get_source_segment(text, node))
                    file = str(path.relative_to(ROOT / "src" / "upright"))
                    place = (file, node.lineno, node.col_offset, node.end_col_offset or 0)
                    found.setdefault((room, kind), []).append(Mutation(*place, before, f"({ast.unparse(new)})"))
    draw = random.Random(seed)
    result: list[Mutation] = []
    while len(result) < number:
        kind = "number" if len(result) % 2 else "condition"
        room = ROOMS[len(result) // 2 % len(ROOMS)]
        choice = draw.choice(found[room, kind])
        if choice not in result:
            result.append(choice)
    return result


def plant(mutation: Mutation, folder: Path) -> None:
    """Write the mutation into a copy of the sources."""
    path = folder / "src" / "upright" / mutation.file
    lines = path.read_bytes().split(b"\n")
    line = lines[mutation.line - 1]  # bytes, as the columns of `ast` count
    lines[mutation.line - 1] = line[: mutation.start] + mutation.after.encode() + line[mutation.end :]
    path.write_bytes(b"\n".join(lines))


def copy_of(tests: Path, folder: Path) -> Path:
    """A checkout of its own: the sources and documents of this one, and the tests that are asked for."""
    for name in ("src", "docs", "examples", "notebooks", "benchmarks"):
        shutil.copytree(ROOT / name, folder / name)
    shutil.copytree(tests, folder / "tests")
    for path in ROOT.glob("*.*"):
        if path.is_file():
            shutil.copy(path, folder)
    if (ROOT.parent / "shared").exists() and not (folder.parent / "shared").exists():
        (folder.parent / "shared").symlink_to((ROOT.parent / "shared").resolve())
    return folder


def pytest(folder: Path, *arguments: str, limit: float | None = None) -> int:
    """Run pytest in a checkout on two processes; its exit code, or 1 where it was stopped by the limit."""
    environment = {**os.environ, "PYTHONPATH": str(folder / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-m", "pytest", "-q", "-n", "2", "-p", "no:cacheprovider", *arguments]
    try:
        done = subprocess.run(command, cwd=folder, env=environment, timeout=limit, capture_output=True, check=False)
    except subprocess.TimeoutExpired:
        return 1
    return done.returncode


def make_map(tests: Path, kept: Path) -> None:
    """Which tests execute which line: `{file: {line: [test, …]}}`, by one run of the suite with coverage."""
    from coverage import CoverageData

    with tempfile.TemporaryDirectory() as scratch:
        folder = copy_of(tests, Path(scratch) / "main")
        pytest(folder, "--cov=upright", "--cov-context=test", "--cov-report=")
        data = CoverageData(str(folder / ".coverage"))
        data.read()
        lines: dict[str, dict[int, list[str]]] = {}
        for measured in data.measured_files():
            name = measured.partition("src/upright/")[2]
            by_line = data.contexts_by_lineno(measured)
            lines[name] = {line: sorted({test.partition("|")[0] for test in by_line[line] if test}) for line in by_line}
        kept.write_text(json.dumps(lines), "utf-8")


def tests_of(mutation: Mutation, lines: dict[str, dict[str, list[str]]], tests: Path) -> list[str]:
    """The tests that execute a mutation's line, or, where coverage sees none, the files that name its room."""
    if seen := lines.get(mutation.file, {}).get(str(mutation.line)):
        return seen
    room = re.compile(rf"upright[. ](import )?{mutation.file.split('/')[0]}\b")
    return [f"tests/{path.name}" for path in sorted(tests.glob("test_*.py")) if room.search(path.read_text("utf-8"))]


def main() -> None:
    """List, map or run, as the command line asks."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("task", choices=("list", "map", "run"))
    parser.add_argument("--tests", type=Path, default=ROOT / "tests")
    parser.add_argument("--folder", type=Path, default=Path("mutations"))
    parser.add_argument("--seed", type=int, default=46)
    asked = parser.parse_args()
    forty = mutations(asked.seed)
    asked.folder.mkdir(exist_ok=True)
    lines, done = asked.folder / "map.json", asked.folder / "killed.json"
    if asked.task == "map":
        make_map(asked.tests, lines)
    if asked.task != "run":
        print(*forty, sep="\n")
        return
    covering = json.loads(lines.read_text("utf-8"))
    killed: dict[str, bool] = json.loads(done.read_text("utf-8")) if done.exists() else {}
    for mutation in forty:
        if str(mutation) not in killed:
            with tempfile.TemporaryDirectory() as scratch:
                folder = copy_of(asked.tests, Path(scratch) / "main")
                plant(mutation, folder)
                chosen = tests_of(mutation, covering, asked.tests)
                killed[str(mutation)] = bool(chosen) and pytest(folder, "-x", *chosen, limit=LONGEST) == 1
            done.write_text(json.dumps(killed, indent=1), "utf-8")
        print(f"{'killed ' if killed[str(mutation)] else 'SURVIVES'} {mutation}", flush=True)
    print(f"{sum(killed[str(m)] for m in forty)} of {len(forty)} killed")


if __name__ == "__main__":
    main()
