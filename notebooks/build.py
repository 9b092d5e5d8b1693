"""Notebooks from their texts: executed once, in two languages, for students and for teachers.

    python notebooks/build.py [--out FOLDER] [NAME…]

A text is a Python file of cells, as jupytext and most editors read it. Beside the code, which serves both languages, a
cell of prose is marked `lang="en"` or `lang="es"`. A cell with `tags=["answer"]` is in the teacher's notebook only; in
the student's there is an empty cell in place of code. Answers are executed with everything else. Code with a `lang` is
in that notebook only, and changes nothing but how results are shown (`up.language`). So it is executed after the rest,
and all results are shown again.
"""

from __future__ import annotations

import argparse
import ast
import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat import NotebookNode

HERE = Path(__file__).parent
LANGUAGES = ("en", "es")
LIMIT = 120  # [s] of one cell: a guard against hanging, not the time that a notebook should take
BAR = 30.0  # [s] of computing that a notebook should take; printed, not tested: machines differ
EMPTY = {"en": "# your answer", "es": "# su respuesta"}
HEAD = re.compile(r"^# %%(?P<prose> \[markdown\])?(?P<options>.*)$", re.MULTILINE)
OPTION = re.compile(r"""(\w+)=("[^"]*"|\[[^\]]*\])""")


@dataclass(frozen=True)
class Cell:
    """A cell of prose, in the language `lang`, or of code, empty where it serves both; and whether it is an answer."""

    text: str
    prose: bool
    lang: str
    answer: bool

    @property
    def heading(self) -> str:
        """The heading that the prose begins with, or nothing."""
        first = self.text.partition("\n")[0]
        return first.lstrip("# ") if self.prose and first.startswith("#") else ""


def texts() -> list[Path]:
    """The texts of all notebooks, in the order of the course."""
    return sorted(HERE.glob("[0-9]_*.py"))


def cells_of(text: Path) -> list[Cell]:
    """The cells of a text. Raises `ValueError` for an option or a language that does not exist."""
    _, *parts = re.split(r"(?=^# %%)", text.read_text("utf-8"), flags=re.MULTILINE)
    return [_cell(text.name, part) for part in parts]


def _cell(where: str, part: str) -> Cell:
    first, _, body = part.partition("\n")
    head = HEAD.match(first)
    if head is None:
        raise ValueError(f"{where}: '{first}' is no head of a cell")
    options = {name: ast.literal_eval(value) for name, value in OPTION.findall(head["options"])}
    prose, lang, tags = bool(head["prose"]), options.pop("lang", ""), options.pop("tags", [])
    if options or lang not in (LANGUAGES if prose else ("", *LANGUAGES)) or not set(tags) <= {"answer"}:
        raise ValueError(f"{where}: '{first}'; expected the lang of prose, {' or '.join(LANGUAGES)}, no tag but answer")
    lines = [re.sub(r"^# ?", "", line) if prose else line for line in body.strip("\n").split("\n")]
    return Cell("\n".join(lines), prose, lang, "answer" in tags)


Ran = Sequence[tuple[Cell, NotebookNode]]
"""Every cell with its executed node."""


def executed(text: Path, folder: Path) -> dict[str, Ran]:
    """Every cell of a text with its executed node, by language; files are written into `folder`.

    Raises what a cell raises.
    """
    cells = cells_of(text)
    nodes = [node_of(cell) for cell in cells]
    shared = [node for cell, node in zip(cells, nodes, strict=True) if not (cell.lang and not cell.prose)]
    again: dict[str, list[NotebookNode]] = {}
    count = sum(node.cell_type == "code" for node in shared)
    for lang in LANGUAGES:
        own = [node for cell, node in zip(cells, nodes, strict=True) if cell.lang == lang and not cell.prose]
        shown = [nbformat.v4.new_code_cell(f"Out.get({k + 1})") for k in range(count)]
        again[lang] = [*own, *shown] if own else []
    notebook = nbformat.v4.new_notebook(cells=[*shared, *again["en"], *again["es"]])
    for number, node in enumerate(notebook.cells):
        node["id"] = f"cell-{number}"  # else they are random, and no two builds are alike
    where = {"metadata": {"path": folder}}
    NotebookClient(notebook, timeout=LIMIT, kernel_name="python3", resources=where, coalesce_streams=True).execute()
    for node in notebook.cells:
        node.metadata = {}  # when each cell ran
    return {lang: _shown(cells, nodes, again[lang][-count:]) for lang in LANGUAGES}


def _shown(cells: Sequence[Cell], nodes: Sequence[NotebookNode], again: Sequence[NotebookNode]) -> Ran:
    """The nodes with the results of `again`, one for each cell of code for both languages, where there are any."""
    ran: list[tuple[Cell, NotebookNode]] = []
    results = iter(again)
    for cell, node in zip(cells, nodes, strict=True):
        if cell.lang or not again:
            ran.append((cell, node))
            continue
        printed = [out for out in node.outputs if out.output_type != "execute_result"]
        shown = [NotebookNode(out | {"execution_count": node.execution_count}) for out in next(results).outputs]
        ran.append((cell, NotebookNode(node | {"outputs": [*printed, *shown]})))
    return ran


def node_of(cell: Cell) -> NotebookNode:
    """A cell of a notebook that was not executed."""
    make = nbformat.v4.new_markdown_cell if cell.prose else nbformat.v4.new_code_cell
    return make(cell.text)


def notebook_of(ran: Ran, lang: str, *, teacher: bool) -> NotebookNode:
    """The notebook of one language, with its outputs; without `teacher` the answers are taken out."""
    nodes = list(_chosen(ran, lang, teacher))
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    return nbformat.v4.new_notebook(cells=nodes, metadata=kernel | {"language_info": {"name": "python"}})


def _chosen(ran: Ran, lang: str, teacher: bool) -> Iterator[NotebookNode]:
    for cell, node in ran:
        if cell.lang not in ("", lang):
            continue
        if teacher or not cell.answer:
            yield NotebookNode(node | {"metadata": {"tags": ["answer"]}}) if cell.answer else node
        elif not cell.prose:
            empty = nbformat.v4.new_code_cell(EMPTY[lang])
            empty["id"] = node["id"]
            yield empty


def build(folder: Path, names: Sequence[str] = ()) -> list[Path]:
    """Write every notebook below `folder`: student/en, student/es, teacher/en and teacher/es."""
    written: list[Path] = []
    for text in texts():
        if names and text.stem not in names:
            continue
        with tempfile.TemporaryDirectory() as scratch:
            before = _computed()
            ran = executed(text, Path(scratch))
            print(f"{text.stem}: executed in {_computed() - before:.0f} s of computing (bar {BAR:g})")
            for reader in ("student", "teacher"):
                for lang in LANGUAGES:
                    path = folder / reader / lang / f"{text.stem}.ipynb"
                    path.parent.mkdir(parents=True, exist_ok=True)
                    nbformat.write(notebook_of(ran[lang], lang, teacher=reader == "teacher"), path)
                    labs_beside(path.parent, Path(scratch))
                    written.append(path)
    return written


def _computed() -> float:
    """Seconds of processors that ended children took; nothing on Windows, which does not count them."""
    spent = os.times()
    return spent.children_user + spent.children_system


def labs_beside(folder: Path, scratch: Path) -> None:
    """The labs that notebooks have written into `scratch` and show in a frame, beside the notebooks in `folder`."""
    for lab in scratch.glob("lab-*"):
        shutil.copytree(lab, folder / lab.name, dirs_exist_ok=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("names", nargs="*", choices=[*(text.stem for text in texts()), []], metavar="NAME")
    parser.add_argument("--out", type=Path, default=Path("course"))
    given = parser.parse_args()
    for path in build(given.out, given.names):
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
