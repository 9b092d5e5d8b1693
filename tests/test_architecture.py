"""The house keeps its order: imports point down, heavy packages load late, and nothing grows too large."""

from __future__ import annotations

import ast
import re
import statistics
import subprocess
import sys
import tomllib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from importlib import metadata
from pathlib import Path

import pytest

import budget
from conftest import PATIENCE

CHECKOUT = Path(__file__).resolve().parents[1]
SOURCE = CHECKOUT / "src" / "upright"

WINGS = {
    "base": ("arrays", "errors", "interrupts", "streams", "atomic", "reading", "languages", "messages", "progress",
             "decimate", "ticks", "plotting", "pages", "plugins"),
    "description": ("signals", "robots"),
    "model": ("physics", "compiled", "bodies", "control", "loops"),
    "simulation": ("experiment", "kernel", "fleets", "gym"),
    "inference": (
        "logs", "checkup", "calibration", "excitation", "identification", "validation", "likelihood", "diagnose",
    ),
    "decision": ("certification", "tuning"),
    "hardware": ("links", "firmware", "bricks", "execution", "flight"),
    "presentation": ("comparison", "reports", "paper", "lab", "classwork", "cli", "__main__"),
}  # fmt: skip
ROOMS = tuple(name for wing in WINGS.values() for name in wing)
"""From the ground up."""

STRANGERS = {("control", "bodies")}
"""Rooms that do not know each other although the order would allow it: a controller must not see inside a body."""

HEAVY = {
    "cma", "control", "cvxpy", "dask", "distributed", "fastapi", "gymnasium", "jinja2", "matplotlib", "mcap", "mujoco",
    "numba", "pandas", "pyarrow", "rich", "scipy.signal", "slycot", "sympy", "uvicorn", "xarray", "zarr",
}  # fmt: skip
AT_ONCE = {
    ("bodies/twin.py", "mujoco"), ("paper/derivation.py", "sympy"), ("paper/errata.py", "sympy"),
    ("compiled/generate.py", "sympy"), ("compiled/trace.py", "sympy"),
    ("compiled/trace_constants.py", "sympy"), ("compiled/trace_print.py", "sympy"),
    ("compiled/trace_motion.py", "sympy"),
    ("gym/balance.py", "gymnasium"), ("gym/task.py", "gymnasium"), ("gym/vector.py", "gymnasium"),
    ("calibration/motion.py", "numba"), ("lab/app.py", "fastapi"), ("plotting.py", "matplotlib"),
    ("ticks.py", "matplotlib"), ("pages/drawing.py", "matplotlib"),
    ("robots/drawing.py", "matplotlib"), ("reports/film.py", "matplotlib"),
}  # fmt: skip
"""Heavy packages that a module may import when it is loaded, because it is loaded only to use them."""

SYMPY = {
    "paper/derivation.py", "paper/errata.py", "compiled/generate.py", "compiled/trace.py",
    "compiled/trace_constants.py",
    "compiled/trace_print.py",
    "compiled/trace_motion.py",
}  # fmt: skip
"""Nothing else imports SymPy at all: it proves and traces, and is never needed at run time."""

UNIX = {"fcntl", "grp", "pty", "pwd", "resource", "syslog", "termios", "tty"}
"""Modules of Python that Windows lacks."""

UNIX_NAMES = {"fork", "getpgid", "getuid", "killpg", "mkfifo", "nice", "setsid", "setitimer", "SIGALRM", "SIGHUP",
              "SIGKILL", "SIGPIPE", "SIGVTALRM"}  # fmt: skip
"""And names in modules that it has."""

MOST_LINES_OF_A_MODULE = 400
MOST_LINES_OF_A_FUNCTION = 60
MOST_POSITIONAL = 7
"""Parameters that a caller may give by position: beyond it nobody remembers the order."""

ENTRY = ("kernel/run.py", "entry")
"""The one function that takes many arguments by position: addresses of tables, from outside compiled code."""

RETIRED = {
    "foretell", "foretold", "foretells", "foretelling", "brain", "felt", "told", "wanted", "mend", "mended", "mends",
    "heard", "farther", "farthest", "said", "found", "seen", "share", "shares", "late", "later", "much",
}  # fmt: skip
"""Words that name nothing: prediction, controller, disturbance, reference, hint, message, result, measured, fraction,
delay are what is meant (docs/conventions.md has the glossary)."""


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
def nodes() -> dict[str, list[ast.AST]]:
    """Every node of each file: making and walking the trees takes longer than what is asked of them."""
    return {path.relative_to(SOURCE).as_posix(): inside for path, inside in budget.nodes().items()}


def trees() -> dict[str, ast.Module]:
    return {file: inside[0] for file, inside in nodes().items()}  # type: ignore[misc]


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
        elif not isinstance(child, ast.expr):  # which holds no import
            function = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef)
            yield from walk(file, child, at_once and not function)


ENTRANCES = ("__init__.py", "__main__.py")
"""Files beside the rooms, which may import all of them."""


def room(path: str) -> str:
    return path.partition("/")[0].removesuffix(".py")


def between_rooms() -> list[Import]:
    return [
        i for i in imports() if i.of("upright") and i.file not in ENTRANCES and i.target.split(".")[1] != room(i.file)
    ]


def test_every_folder_is_a_known_room() -> None:
    there = {room(file) for file in trees() if file not in ENTRANCES}
    assert there <= set(ROOMS)


def test_the_page_of_the_house_shows_every_room_in_order() -> None:
    shown: dict[str, tuple[str, ...]] = {}
    text = (CHECKOUT / "docs" / "architecture.md").read_text("utf-8")
    for wing, rooms in re.findall(r"^\| (?:\*\*(.*?)\*\*|(`.*?)) \|", text, re.MULTILINE):
        if wing:
            shown[wing] = ()
        else:
            shown[[*shown][-1]] += tuple(name.rstrip("/") for name in re.findall(r"`(.*?)`", rooms))
    assert list(shown.items()) == list(WINGS.items())


def test_the_page_of_the_house_gives_every_command_a_room() -> None:

    from upright.cli.main import group

    rows = [
        line for line in (CHECKOUT / "docs" / "architecture.md").read_text("utf-8").splitlines() if line[:3] == "| `"
    ]
    table = [row.split("|")[3] for row in rows]
    shown = [name for cell in table for name in re.findall(r"`([^`]*)`", cell) if not name.startswith("--")]
    assert sorted(shown) == sorted(group().commands)  # type: ignore[attr-defined]


def test_imports_point_down() -> None:
    wrong = [i for i in between_rooms() if ROOMS.index(i.target.split(".")[1]) > ROOMS.index(room(i.file))]
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


def test_what_only_unix_has_is_no_import_of_a_module() -> None:
    """So that everything loads on Windows; what needs such a module says so in one line where it is used."""
    wrong = [i for i in imports() if i.at_once and any(i.of(name) for name in UNIX)]
    assert not wrong, "\n".join(map(str, wrong))
    named = [
        f"{file}: {ast.unparse(node)}"
        for file, tree in trees().items()
        for top in tree.body
        if not isinstance(top, ast.FunctionDef | ast.ClassDef)
        for node in ast.walk(top)
        if isinstance(node, ast.Attribute) and node.attr in UNIX_NAMES
    ]
    assert named == []


def packages_of(distribution: str) -> set[str]:
    """What a distribution can be imported as: its name, where it is not installed here."""
    try:
        files = metadata.files(distribution) or []
    except metadata.PackageNotFoundError:
        return {distribution}
    return {file.parts[0].partition(".")[0] for file in files}


def test_every_imported_package_is_a_declared_dependency() -> None:
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]
    extras = [line for lines in project["optional-dependencies"].values() for line in lines]
    declared = {re.split(r"[<>=!~;\[ ]", line)[0].lower() for line in [*project["dependencies"], *extras]}
    brought = {package for name in declared for package in packages_of(name)}
    outside = {i.target.split(".")[0]: i for i in imports()}
    outside = {
        name: i for name, i in outside.items() if name not in sys.stdlib_module_names | {"upright", "__future__"}
    }
    wrong = [i for name, i in outside.items() if name not in brought]
    assert not wrong, "\n".join(map(str, wrong))


@pytest.mark.parametrize("module", ["upright", "upright.errors", "upright.cli.main"])
def test_start_loads_no_numerics(module: str) -> None:
    heavy = sorted({"numpy", "scipy", *HEAVY})
    code = f"import sys, {module}; print([name for name in {heavy} if name in sys.modules])"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=PATIENCE)
    assert said.stdout.strip() == "[]"


def test_a_log_is_read_without_pandas(tmp_path: Path) -> None:
    """It takes longer to import than all else that a log needs; Arrow imports it for its own arrays."""
    (tmp_path / "log.csv").write_text("time,gyro\n0,1\n0.01,\n0.02,3\n")
    code = "import sys; from upright.logs.readers import read_table as read; read(sys.argv[1])"
    code += "; print('pandas' in sys.modules)"
    command = [sys.executable, "-c", code, str(tmp_path / "log.csv")]
    said = subprocess.run(command, capture_output=True, text=True, check=True, timeout=PATIENCE)
    assert said.stdout.strip() == "False"


@cache
def by_hand(path: Path) -> bool:
    """Nobody reads or edits a generated file; what writes it is held to the limits instead."""
    return not path.read_text("utf-8").startswith("# Generated")


def test_no_module_is_too_long() -> None:
    lengths = {path: len(path.read_text("utf-8").splitlines()) for path in SOURCE.rglob("*.py") if by_hand(path)}
    assert {str(p): n for p, n in lengths.items() if n > MOST_LINES_OF_A_MODULE} == {}


def test_no_function_is_too_long() -> None:
    functions = [
        (f"{file}:{node.lineno} {node.name}", (node.end_lineno or 0) - node.lineno + 1)
        for file, inside in nodes().items()
        if by_hand(SOURCE / file)
        for node in inside
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]
    assert {name: n for name, n in functions if n > MOST_LINES_OF_A_FUNCTION} == {}


def imported_files() -> dict[str, set[str]]:
    """File → files it imports, lazily or not; a package's own list of names (`__init__`) is no link."""
    links: dict[str, set[str]] = {file: set() for file in trees()}
    for i in imports():
        parts = i.target.split(".")[1:] if i.of("upright") else []
        candidates = ("/".join(parts[:n]) + ".py" for n in range(len(parts), 0, -1))
        target = next((file for file in candidates if file in links), None)
        if target and target != i.file:
            links[i.file].add(target)
    return links


def circles(links: dict[str, set[str]]) -> set[frozenset[str]]:
    """Strongly connected components of two or more (Tarjan 1972)."""
    index: dict[str, int] = {}
    low: dict[str, int] = {}
    stack: list[str] = []
    components: set[frozenset[str]] = set()

    def visit(file: str) -> None:
        index[file] = low[file] = len(index)
        stack.append(file)
        for target in links[file]:
            if target not in index:
                visit(target)
            if target in stack:
                low[file] = min(low[file], low[target])
        if low[file] == index[file]:
            component = stack[stack.index(file) :]
            del stack[stack.index(file) :]
            components.update({frozenset(component)} if len(component) > 1 else ())

    for file in links:
        if file not in index:
            visit(file)
    return components


def test_the_search_for_circles_finds_them() -> None:
    links = {"a": {"b"}, "b": {"c"}, "c": {"a", "d"}, "d": {"e"}, "e": set[str](), "f": {"g"}, "g": {"f", "a"}}
    assert circles(links) == {frozenset("abc"), frozenset("fg")}


def test_no_files_import_in_a_circle() -> None:
    assert circles(imported_files()) == set()


def test_a_class_name_means_one_thing() -> None:
    homes: dict[str, set[str]] = {}
    for file, inside in nodes().items():
        for node in inside:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                homes.setdefault(node.name, set()).add(file)
    assert {n: files for n, files in homes.items() if len(files) > 1} == {}


def positional(node: ast.AST) -> int:
    """Parameters that a function, or a data class's constructor, takes by position, `self` apart."""
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        return sum(a.arg not in ("self", "cls") for a in (*node.args.posonlyargs, *node.args.args))
    if not isinstance(node, ast.ClassDef):
        return 0
    how = " ".join(ast.unparse(d) for d in node.decorator_list)
    fields = [ast.unparse(s) for s in node.body if isinstance(s, ast.AnnAssign)]
    fields = fields[: fields.index("_: KW_ONLY")] if "_: KW_ONLY" in fields else fields
    plain = [s for s in fields if "init=False" not in s and "ClassVar" not in s]
    return len(plain) if "dataclass" in how and "kw_only" not in how else 0


def test_nothing_takes_many_arguments_by_position() -> None:
    wide: dict[str, list[str]] = {}
    for file, inside in nodes().items():
        if by_hand(SOURCE / file):
            for node in inside:
                if positional(node) > MOST_POSITIONAL and (file, getattr(node, "name", "")) != ENTRY:
                    name = f"{file}:{node.lineno} {node.name} ({positional(node)})"  # type: ignore[attr-defined]
                    wide.setdefault(room(file), []).append(name)
    assert {name: where for name, where in wide.items() if where} == {}


def bound(inside: Iterable[ast.AST]) -> Iterator[str]:
    """Every name that the nodes of a file give to something."""
    for node in inside:
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            yield node.id if isinstance(node, ast.Name) else node.attr
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            yield node.name
        elif isinstance(node, ast.alias) and node.asname:
            yield node.asname


@cache
def words(name: str) -> set[str]:
    split = name if name.isupper() else re.sub(r"([A-Z])", r"_\1", name)
    return set(re.findall(r"[a-z]+", split.lower()))


def test_names_are_the_words_of_the_textbook() -> None:
    retired: dict[str, list[str]] = {}
    for file, inside in nodes().items():
        names = [name for name in bound(inside) if words(name) & RETIRED] if by_hand(SOURCE / file) else []
        retired.setdefault(room(file), []).extend(f"{file}: {name}" for name in names)
    assert {where: names for where, names in retired.items() if names} == {}


def sentences(text: str) -> list[list[str]]:
    """The words of each sentence."""
    parts = re.split(r"(?<=[.;:!?])\s+", text)
    return [words for part in parts if (words := [word for word in part.split() if re.search(r"\w", word)])]


def test_help_is_in_short_sentences() -> None:
    """Half of them of at most 14 words, none of more than 25."""
    from upright.cli.main import group

    commands = group().commands.values()  # type: ignore[attr-defined]
    texts = [text for command in commands for text in (command.help, *(option.help for option in command.params))]
    lengths = [len(words) for text in texts for words in sentences(text or "")]
    assert statistics.median(lengths) <= 14
    assert max(lengths) <= 25


def test_errors_are_short_sentences() -> None:
    """What stands in every `raise` of the sources."""
    lengths: list[int] = []
    for inside in nodes().values():
        for node in inside:
            if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
                values = [*node.exc.args, *(keyword.value for keyword in node.exc.keywords)]
                lengths += [len(words) for value in values for words in sentences(literal(value))]
    assert statistics.median(lengths) <= 14
    assert max(lengths) <= 25


def literal(node: ast.expr) -> str:
    """The text of a string, with X for what is put in."""
    if isinstance(node, ast.JoinedStr):
        return "".join(str(part.value) if isinstance(part, ast.Constant) else "X" for part in node.values)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def test_names_are_read_word_by_word() -> None:
    source = "class FoundIt:\n    def f(self, was_told): self.late_by, relate = 1, 2\nimport a as share\nNOT_SEEN = 0"
    names = ("FoundIt", "was_told", "late_by", "share", "NOT_SEEN")
    assert {name for name in bound(ast.walk(ast.parse(source))) if words(name) & RETIRED} == set(names)


@pytest.mark.parametrize(
    ("source", "count"),
    [
        ("def f(self, a, b, *, c): ...", 2),
        ("@dataclass(frozen=True)\nclass A:\n    a: int\n    b: int = field(init=False)\n    c: ClassVar[int] = 1", 1),
        ("@dataclass(kw_only=True)\nclass A:\n    a: int", 0),
        ("class A(NamedTuple):\n    a: int", 0),
    ],
)
def test_positional_parameters_are_counted(source: str, count: int) -> None:
    assert positional(ast.parse(source).body[0]) == count


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


def test_a_home_that_does_not_exist_raises_nothing_of_its_own() -> None:
    """`Path.expanduser` raises a RuntimeError for `~nosuchuser`; `os.path.expanduser` leaves it as it is."""
    files = {path for path in SOURCE.rglob("*.py") if ".expanduser()" in path.read_text("utf-8")}
    allowed = {SOURCE / "reading.py"}  # catches it
    assert files == allowed


def test_only_one_module_opens_files_for_writing() -> None:
    def writes(node: ast.AST) -> bool:
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute | ast.Name)):
            return False
        name = node.func.attr if isinstance(node.func, ast.Attribute) else node.func.id
        if name in ("NamedTemporaryFile", "TemporaryDirectory", "mkdtemp", "mkstemp"):
            return True
        if name == "replace" and ast.unparse(node.func).startswith("os."):
            return True
        if name in ("write_text", "write_bytes") and isinstance(node.func, ast.Attribute):
            return not ast.unparse(node.func).startswith("super()")  # of help, which is text
        modes = [a.value for a in (*node.args, *(k.value for k in node.keywords)) if isinstance(a, ast.Constant)]
        return name == "open" and any(isinstance(m, str) and set(m) <= set("wxab+") for m in modes)

    bare = {
        f"{file}:{node.lineno}"
        for file, inside in nodes().items() for node in inside
        if file != "atomic.py" and isinstance(node, ast.Call) and writes(node)
    }  # fmt: skip
    assert not bare, "through upright.atomic, so that a file is written whole: " + ", ".join(sorted(bare))
