"""The texts of the course: one for both languages, with answers that no student gets. `test_site.py` executes them."""

from __future__ import annotations

import ast
import importlib.util
import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.needs("module:nbclient")

FOLDER = Path(__file__).parents[1] / "notebooks"
TEXTS = sorted(FOLDER.glob("[0-9]_*.py"))


@pytest.fixture(scope="module")
def course():
    spec = importlib.util.spec_from_file_location("course", FOLDER / "build.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def is_answer(cell) -> bool:
    return "answer" in cell.metadata["tags"]


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.stem)
def test_both_languages_say_the_same(course, text: Path) -> None:
    """As far as a program sees it: as many cells, headings, formulas, rows of tables and exercises."""
    cells = [cell for cell in course.cells_of(text) if cell.cell_type == "markdown"]
    prose = {lang: [cell for cell in cells if cell.metadata["lang"] == lang] for lang in ("en", "es")}
    assert len(prose["en"]) == len(prose["es"])
    for one, other in zip(prose["en"], prose["es"], strict=True):
        assert is_answer(one) == is_answer(other)
        for mark in (r"^#+ ", r"^\$\$$", r"^\|", r"^\*\*\d\.\*\*", r"^- "):
            counts = [len(re.findall(mark, cell.source, re.MULTILINE)) for cell in (one, other)]
            assert counts[0] == counts[1], (mark, one.source[:80])


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.stem)
def test_answers_are_the_teachers_only(course, text: Path) -> None:
    cells = course.cells_of(text)
    answers = [cell.source for cell in cells if is_answer(cell) and cell.metadata["lang"] in ("", "en")]
    assert len(answers) >= 3
    teacher, student = (course.notebook_of(cells, "en", teacher=who) for who in (True, False))
    assert [cell.source for cell in teacher.cells if "answer" in cell.metadata.get("tags", ())] == answers
    assert not {cell.source for cell in student.cells} & set(answers)
    empty = [cell for cell in student.cells if cell.source == course.EMPTY["en"]]
    assert len(empty) == len([cell for cell in cells if is_answer(cell) and cell.cell_type == "code"])


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.stem)
def test_exercises_stand_by_what_students_have(course, text: Path) -> None:
    """No cell outside an answer uses a name that only an answer defines."""
    given: set[str] = set()
    answered: set[str] = set()
    for cell in course.cells_of(text):
        if cell.cell_type == "code":
            names = [node for node in ast.walk(ast.parse(cell.source)) if isinstance(node, ast.Name)]
            used = {node.id for node in names if isinstance(node.ctx, ast.Load)}
            made = {node.id for node in names if isinstance(node.ctx, ast.Store)}
            assert is_answer(cell) or not used & (answered - given - made)
            (answered if is_answer(cell) else given).update(made)


def test_a_figure_is_drawn_again_in_another_language_and_the_rest_is_shown_again(course) -> None:
    """Letters of a figure are in the language in which it was drawn; a result is text in that of its reader."""
    assert course.shown_again('runs = {}\nup.compare(runs).plot("pitch")', 3) == 'up.compare(runs).plot("pitch")'
    assert course.shown_again("found = up.calibrate(log)\nfound", 4) == "Out.get(4)"
    assert course.shown_again("figure = many.plot()", 5) == "Out.get(5)"


def test_a_text_with_a_mistake_is_refused(course, tmp_path: Path) -> None:
    for head in ('# %% [markdown] lang="fr"', '# %% tags=["hidden"]', "# %% [markdown]"):
        text = tmp_path / "1_wrong.py"
        text.write_text(f"{head}\n# words\n", "utf-8")
        with pytest.raises(ValueError, match="1_wrong"):
            course.cells_of(text)
