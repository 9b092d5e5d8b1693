"""Notebooks from their texts: executed once, in two languages, for students and for teachers.

    python notebooks/build.py [--out FOLDER] [NAME…]

A text is a Python file of cells, as jupytext and most editors read it. Beside the code, which serves both languages, a
cell of prose is marked `lang="en"` or `lang="es"`. A cell with `tags=["answer"]` is in the teacher's notebook only; in
the student's there is an empty cell in place of code. Answers are executed with everything else. Code marked
`lang="es"` changes nothing but how results are shown (`up.language`). So it is executed after the rest, and all
results are shown again: what draws a figure is executed once more, since letters are drawn in one language.
"""

from __future__ import annotations

import argparse
import ast
import re
import shutil
import tempfile
from collections.abc import Sequence
from copy import deepcopy
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat import NotebookNode

HERE = Path(__file__).parent
LANGUAGES = ("en", "es")
LIMIT = 600  # [s] of one cell: a guard against hanging, also on a machine that is busy with other work
EMPTY = {"en": "# your answer", "es": "# su respuesta"}
HEAD = re.compile(r'( \[markdown\] lang="(?:en|es)"| lang="es")?( tags=\["answer"\])?\n')


def texts() -> list[Path]:
    """The texts of all notebooks, in the order of the course."""
    return sorted(HERE.glob("[0-9]_*.py"))


def cells_of(text: Path) -> list[NotebookNode]:
    """The cells of a text; their metadata hold `lang`, empty where a cell serves both languages, and `tags`.

    Raises `ValueError` for a head that means nothing.
    """
    cells: list[NotebookNode] = []
    for part in re.split(r"^# %%", text.read_text("utf-8"), flags=re.MULTILINE)[1:]:
        head = HEAD.match(part)
        if head is None:
            raise ValueError(f"{text.name}: '# %%{part.splitlines()[0]}' is no head of a cell")
        source = part[head.end() :].strip("\n")
        kind = head[1] or ""
        if "markdown" in kind:
            cell = nbformat.v4.new_markdown_cell(re.sub(r"^# ?", "", source, flags=re.MULTILINE))
        else:
            cell = nbformat.v4.new_code_cell(source)
        cell["id"] = f"cell-{len(cells)}"  # else they are random, and no two builds are alike
        cell.metadata = {"lang": kind[-3:-1], "tags": ["answer"] if head[2] else []}
        cells.append(cell)
    return cells


def executed(text: Path, folder: Path) -> dict[str, list[NotebookNode]]:
    """Every cell of a text, executed, by language; files are written into `folder`. Raises what a cell raises."""
    cells = cells_of(text)
    shared = [cell for cell in cells if cell.cell_type == "code" and not cell.metadata["lang"]]
    spanish = [cell for cell in cells if cell.cell_type == "code" and cell.metadata["lang"]]
    again = [nbformat.v4.new_code_cell(shown_again(cell.source, k)) for k, cell in enumerate(shared, 1)]
    notebook = nbformat.v4.new_notebook(cells=[*shared, *spanish, *again])
    where = {"metadata": {"path": folder}}
    NotebookClient(notebook, timeout=LIMIT, kernel_name="python3", resources=where, coalesce_streams=True).execute()
    results = {cell["id"]: shown.outputs for cell, shown in zip(shared, again, strict=True)}
    ran = {"en": cells, "es": deepcopy(cells)}
    for cell in ran["es"]:
        if cell["id"] in results:
            printed = [out for out in cell.outputs if out.output_type != "execute_result"]
            cell["outputs"] = [*printed, *results[cell["id"]]]
    return ran


def shown_again(source: str, number: int) -> str:
    """The code that shows the result of a cell, executed as the `number`-th one, in another language."""
    last = ast.parse(source).body[-1]
    words = ast.get_source_segment(source, last) or ""
    draws = isinstance(last, ast.Expr) and re.search(r"\.plot(_\w+)?\(", words)
    return words if draws else f"Out.get({number})"


def notebook_of(cells: Sequence[NotebookNode], lang: str, *, teacher: bool) -> NotebookNode:
    """The notebook of one language, with its outputs; without `teacher` the answers are taken out."""
    chosen: list[NotebookNode] = []
    for cell in cells:
        if cell.metadata["lang"] not in ("", lang):
            continue
        answer = "answer" in cell.metadata["tags"]
        if teacher or not answer:
            chosen.append(NotebookNode(cell | {"metadata": {"tags": ["answer"]} if answer else {}}))
        elif cell.cell_type == "code":
            chosen.append(nbformat.v4.new_code_cell(EMPTY[lang], id=cell["id"]))
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    return nbformat.v4.new_notebook(cells=chosen, metadata=kernel | {"language_info": {"name": "python"}})


def build(folder: Path, names: Sequence[str] = ()) -> None:
    """Write every notebook below `folder`: student/en, student/es, teacher/en and teacher/es."""
    for text in texts():
        if names and text.stem not in names:
            continue
        with tempfile.TemporaryDirectory() as scratch:
            ran = executed(text, Path(scratch))
            for lang in LANGUAGES:
                for reader in ("student", "teacher"):
                    path = folder / reader / lang / f"{text.stem}.ipynb"
                    path.parent.mkdir(parents=True, exist_ok=True)
                    nbformat.write(notebook_of(ran[lang], lang, teacher=reader == "teacher"), path)
                    labs_beside(path.parent, Path(scratch))
                    print(path)


def labs_beside(folder: Path, scratch: Path) -> None:
    """The labs that notebooks have written into `scratch` and show in a frame, beside the notebooks in `folder`."""
    for lab in scratch.glob("lab-*"):
        shutil.copytree(lab, folder / lab.name, dirs_exist_ok=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("names", nargs="*", choices=[*(text.stem for text in texts()), []], metavar="NAME")
    parser.add_argument("--out", type=Path, default=Path("course"))
    given = parser.parse_args()
    build(given.out, given.names)
