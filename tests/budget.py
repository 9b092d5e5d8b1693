"""How heavy the code is: `python tests/budget.py` prints it beside `budget.toml`, `--lower` lowers what got lighter.

Tokens are those of `tokenize` without comments, docstrings, indents and newlines; files named `generated*` are left
out. What is not Python (the lab's TypeScript, its page, templates and styles) is counted in words and signs.
"""

from __future__ import annotations

import ast
import gc
import io
import re
import sys
import tokenize
import tomllib
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "src" / "upright"
FILE = ROOT / "budget.toml"

LAYOUT = {
    tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENCODING,
    tokenize.ENDMARKER,
}  # fmt: skip
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
BY_HAND = {".ts", ".js", ".css", ".html", ".svg", ".c"}
"""What is written by hand beside Python; built files (`lab/static/assets`) are not."""

HEAD = """\
# How heavy the code may be. `python tests/budget.py` counts; `--lower` lowers a line when what it counts shrinks.
# A line is raised only by a commit that says why.
"""


def sources() -> Iterator[Path]:
    """Every Python file of the package that a person wrote."""
    return (path for path in sorted(PACKAGE.rglob("*.py")) if not path.name.startswith("generated"))


@cache
def nodes() -> dict[Path, list[ast.AST]]:
    """Every node of each Python file of the package, the file itself first: they are made once for all that asks."""
    gc.disable()  # it would look again and again at what stays
    made = {path: list(ast.walk(ast.parse(path.read_text("utf-8")))) for path in sorted(PACKAGE.rglob("*.py"))}
    gc.freeze()
    gc.enable()
    return made


def tokens_of(text: str) -> int:
    """Tokens of a Python file without its comments, docstrings and layout."""
    number = 0
    statement_begins = True
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in LAYOUT:
            statement_begins = statement_begins or token.type not in (tokenize.COMMENT, tokenize.NL)
        elif not (token.type == tokenize.STRING and statement_begins):
            number += 1
            statement_begins = False
        else:
            statement_begins = False
    return number


def rooms() -> dict[str, int]:
    """Python tokens of each room; a module beside the rooms is one of its own."""
    number: Counter[str] = Counter()
    for path in sources():
        number[path.relative_to(PACKAGE).parts[0].removesuffix(".py")] += tokens_of(path.read_text("utf-8"))
    return dict(sorted(number.items()))


def beside() -> dict[str, int]:
    """Words and signs of what is written by hand and is not Python, by suffix."""
    number: Counter[str] = Counter()
    for path in PACKAGE.rglob("*"):
        if path.suffix in BY_HAND and "assets" not in path.parts and "node_modules" not in path.parts:
            number[path.suffix.removeprefix(".")] += len(re.findall(r"\w+|[^\w\s]", path.read_text("utf-8")))
    return dict(sorted(number.items()))


def is_pair(node: ast.AST) -> bool:
    """Whether a statement is `a, b = x, y`, which gives several names their values at once."""
    return (
        isinstance(node, ast.Assign)
        and isinstance(node.targets[0], ast.Tuple)
        and isinstance(node.value, ast.Tuple)
        and len(node.targets[0].elts) == len(node.value.elts)
    )


def named_numbers(node: ast.AST) -> int:
    """How many numbers a statement of a module gives names in capitals."""
    if not isinstance(node, ast.Assign):
        return 0
    several = is_pair(node)
    names = node.targets[0].elts if several else node.targets[:1]
    values = node.value.elts if several else [node.value]
    return sum(
        isinstance(name, ast.Name)
        and name.id.isupper()
        and isinstance(value, ast.Constant)
        and isinstance(value.value, int | float)
        for name, value in zip(names, values, strict=True)
    )


def density() -> dict[str, int]:
    """How often the package writes what is dense: several things in one line, or a number that needs a name."""
    number: Counter[str] = Counter()
    for path in sources():
        tree, *_ = found = nodes()[path]
        number["fmt_skip"] += path.read_text("utf-8").count("# fmt: skip")
        number["named_numbers"] += sum(map(named_numbers, tree.body))
        for node in found:
            number["pairs"] += is_pair(node)
            number["walrus"] += isinstance(node, ast.NamedExpr)
            if isinstance(node, COMPREHENSIONS):
                number["nested_comprehensions"] += any(
                    isinstance(inner, COMPREHENSIONS) for inner in ast.walk(node) if inner is not node
                )
    return dict(sorted(number.items()))


def measured() -> dict[str, dict[str, int]]:
    """What `budget.toml` bounds, as it is."""
    return {"rooms": rooms(), "beside": beside(), "dense": density()}


def allowed() -> dict[str, dict[str, int]]:
    """What `budget.toml` says."""
    return tomllib.loads(FILE.read_text("utf-8"))


def lower() -> None:
    """Write the budget anew: each line falls to what is counted, none rises; a room that is new enters as it is."""
    before = allowed() if FILE.exists() else {}
    lines = [HEAD]
    for table, counts in measured().items():
        lines.append(f"\n[{table}]\n")
        lines += [f"{name} = {min(count, before.get(table, {}).get(name, count))}\n" for name, count in counts.items()]
    FILE.write_text("".join(lines), "utf-8")


def main() -> None:
    """Print every count beside what is allowed."""
    if "--lower" in sys.argv[1:]:
        lower()
    bounds = allowed()
    for table, counts in measured().items():
        print(f"[{table}]")
        for name, count in counts.items():
            print(f"  {name:<22} {count:>7}  of {bounds[table].get(name, 0):>7}")
        print(f"  {'together':<22} {sum(counts.values()):>7}  of {sum(bounds[table].values()):>7}")


if __name__ == "__main__":
    main()
