"""The grammar of pages: what is said is a literal sentence with a translation, and every rendering says the same."""

from __future__ import annotations

import ast
import json
import math
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import budget
import upright
from messages import still_english
from upright.checkup.doctor import doctor
from upright.classwork.graded import Grade, differs
from upright.classwork.grading import Grades
from upright.cli.output import continued
from upright.cli.typed import GIVEN
from upright.comparison.bench import Bench, BenchRow
from upright.control import make_controller
from upright.diagnose.causes import LOW, PUSH, Blow, Cause
from upright.diagnose.post_mortem import PostMortem
from upright.diagnose.series import Series
from upright.errors import UnknownName
from upright.execution.parity import Parity, PushOutcome
from upright.fleets.basin import Axis, basin
from upright.fleets.binomial import clopper_pearson
from upright.fleets.cases import Cases
from upright.fleets.fleet import ensemble_of
from upright.fleets.push_map import PushGrid
from upright.fleets.tally import CaseSummary
from upright.lab.handin import RunResult
from upright.languages import LANGUAGES, catalogue, speaking
from upright.loops.analysis import analyse
from upright.messages import in_language
from upright.pages import (
    Column,
    Fold,
    KeyNumber,
    Message,
    Next,
    Page,
    Quantity,
    Result,
    Say,
    Table,
    Verdict,
    data_of,
    html,
    terminal,
)  # fmt: skip
from upright.pages.terms import term
from upright.pages.words import _FORMS
from upright.robots import PARAMETERS, Kit, Robot
from upright.signals import Log
from upright.signals.signal import SIDES, TRUE_STATE

SOURCE = Path(upright.__file__).parent
OTHERS = [language for language in LANGUAGES if language != "en"]


def calls(*names: str) -> Iterator[tuple[Path, ast.Call]]:
    """The calls of functions by these names."""
    for path in sorted(SOURCE.rglob("*.py")):
        if path.name == "terms.py" and path.parent.name == "pages":
            continue  # names of parameters, which a test below asks
        for node in budget.nodes()[path]:
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in names:
                yield path, node


def literals() -> set[str]:
    """Every template of the package, in Python and in the templates of pages."""
    said = {
        node.args[0].value
        for _, node in calls("Say", "translated")
        if isinstance(node.args[0], ast.Constant) and isinstance(node.args[0].value, str)
    }
    for path in (SOURCE / "pages" / "templates").glob("*.html"):
        said |= set(re.findall(r'say\("([^"]+)"\)', path.read_text("utf-8")))
    return said


def leaves(texts: Any) -> Iterator[str]:
    """Every text of the lab's page."""
    if isinstance(texts, str):
        yield texts
    else:
        for inside in texts.values() if isinstance(texts, dict) else texts:
            yield from leaves(inside)


def test_what_is_said_is_one_literal_sentence() -> None:
    """A sentence put together from pieces cannot be translated: other languages order their words otherwise."""
    made = [
        f"{path.relative_to(SOURCE)}:{node.lineno}"
        for path, node in calls("Say")
        if not (isinstance(node.args[0], ast.Constant) and isinstance(node.args[0].value, str))
    ]
    assert made == []


def test_a_sentence_that_is_one_fact_is_a_name() -> None:
    """An error or a remark under another name would pass for one, and stay English: it is a `Message`, or a `Say`."""
    whole = (ast.Call, ast.List, ast.ListComp)  # which is said by itself
    hidden = [
        f"{path.relative_to(SOURCE)}:{node.lineno}"
        for path, node in calls("Say")
        for fact in node.keywords
        if isinstance(node.args[0], ast.Constant) and node.args[0].value == f"{{{fact.arg}}}"
        if fact.arg != "name" and not isinstance(fact.value, whole)
    ]
    assert hidden == []


def test_the_text_of_an_error_is_no_fact() -> None:
    """`str(error)` is English for ever; `Message(error)` is found in the catalogue where it is shown."""
    hidden: list[str] = []
    for path, node in calls("Say"):
        errors = {one.name for one in budget.nodes()[path] if isinstance(one, ast.ExceptHandler)}
        for fact in node.keywords:
            match fact.value:
                case ast.Call(func=ast.Name("str" | "one_line"), args=[ast.Name(name), *_]) if name in errors:
                    hidden.append(f"{path.relative_to(SOURCE)}:{node.lineno}")
    assert hidden == []


def test_an_error_in_a_page_is_shown_as_on_the_command_line() -> None:
    error = UnknownName("robot", "a", ["b"])
    sentence = Say("Left out: {why}", why=Message(error))
    with speaking("es"):
        assert str(sentence).endswith(in_language(str(error)))
        assert "no hay robot" in str(sentence)
    assert str(sentence).endswith(str(error))
    assert data_of(Message(error)) == str(error)


@pytest.mark.parametrize("language", OTHERS)
def test_every_sentence_is_translated_and_no_translation_is_left_over(language: str) -> None:
    names = {term(name).template for name in PARAMETERS}
    needed = literals() | names | set(_FORMS.values()) - {"–", "{value}"}
    known = set(catalogue(language))
    # a template of places alone needs no words
    wordless = {text for text in needed if not re.search(r"[A-Za-z]", re.sub(r"\{\w+\}", "", text))}
    assert sorted(needed - known - wordless) == []
    lab = json.loads((SOURCE / "lab" / "web" / "src" / "texts" / "en.json").read_text("utf-8"))
    other_terms = known - needed - set(leaves(lab))  # what the lab lacks, test_lab_build.py says
    assert sorted(text for text in other_terms if "{" in text) == []


@pytest.mark.parametrize("language", OTHERS)
def test_a_translation_keeps_its_places(language: str) -> None:
    def places(text: str) -> list[str]:
        return sorted(re.findall(r"\{\w+\}", text))

    assert [text for text, other in catalogue(language).items() if places(text) != places(other)] == []


@pytest.mark.parametrize(
    ("quantity", "text"),
    [
        (Quantity(math.pi / 6, "rad"), "30°"),
        (Quantity(0.0999, "fraction", digits=2), "10 %"),
        (Quantity(0.1897, "N s", digits=2), "0.19 N s"),
        (Quantity(None, "N s", low=0.1897, digits=2), "at least 0.18 N s"),  # a bound is never rounded to the safe side
        (Quantity(None, "N s", high=0.1811, digits=2), "at most 0.19 N s"),
        (Quantity(None, "1", low=0.3, digits=2), "at least 0.3"),  # 0.3 is not below itself
        (Quantity(0.0455, "N m/A", low=0.043, high=0.0471), "0.0455 (0.043 to 0.0471) N m/A"),
        (Quantity(1.5e-6, "kg m²", digits=2), "1.5 · 10⁻⁶ kg m²"),
        (Quantity(-0.02, "m"), "−2 cm"),
        (Quantity(0.02, "s"), "20 ms"),
        (Quantity(math.nan, "s"), "–"),
        (Quantity(math.inf, "s"), "∞ s"),
    ],
)
def test_a_quantity_is_said_in_the_units_of_people(quantity: Quantity, text: str) -> None:
    assert str(quantity).replace("\u00a0", " ") == text


def test_spanish_has_a_decimal_comma() -> None:
    with speaking("es"):
        assert str(Quantity(1.25, "V")) == "1,25\u00a0V"
    assert str(Quantity(1.25, "V")) == "1.25\u00a0V"


def test_a_float_is_no_fact() -> None:
    with pytest.raises(TypeError, match="has a unit"):
        Say("it weighs {mass}", mass=0.6)


def example() -> Page:
    columns = [Column(Say("number")), Column(Say("middle"), "rad"), Column(Say("varies"))]
    rows = [[term("wheel_radius"), 0.5, "x" * 30], [term("body_mass"), 0.25, None]]
    table = Table(
        [*columns, Column(Say("middle")), Column(Say("varies"))], [[*row, "y" * 20, "z" * 30] for row in rows]
    )
    return Page(
        Say("{fell} of {n} robots fell", fell=3, n=100),
        verdict=Verdict(Say("few fall: {most}", most=Quantity(None, "fraction", high=0.05)), "good"),
        numbers=[KeyNumber(Quantity(0.04, "m"), Say("distance rolled"))],
        next=[Next("push_map", robot="my robot.toml")],
        blocks=[table, Fold(Say("What varies"), [table])],
    )


def test_a_terminal_has_eighty_columns_and_says_what_it_left_out() -> None:
    text = terminal.text(example())
    assert max(map(len, text.splitlines())) <= 80
    assert "Columns left out" in text
    assert "`upright push-map --robot 'my robot.toml'`" in text
    assert "Columns left out" not in terminal.text(example(), wide=True)


def test_a_table_is_aligned_and_wraps_its_last_column() -> None:
    columns = [Column(Say("number")), Column(Say("value")), Column(Say("why"))]
    table = Table(columns, [["θ̇", 1, "one two three four five six"], ["pitch", 20, "x"]])
    lines = terminal.table_text(table, 40).splitlines()
    assert lines[1:] == ["θ̇           1  one two three four five", "               six", "pitch      20  x"]


def test_a_page_fetches_nothing_and_is_well_formed() -> None:
    text = html.document(example(), "upright fleet")
    assert "http" not in re.sub(r"http://www\.w3\.org/\S+", "", text)
    body = text[text.index("<body>") : text.index("<script>")]
    ElementTree.fromstring(f"{body}</body>".replace("&nbsp;", " "))
    assert "28.6" in text  # 0.5 and 0.25 rad, in degrees with equal decimals
    assert "14.3" in text


def test_a_page_that_says_too_much_is_refused() -> None:
    one = KeyNumber(1, Say("number"))
    with pytest.raises(ValueError, match="4 numbers; at most 3"):
        Page(Say("number"), numbers=[one] * 4)


def a_fleet() -> Result:
    return upright.fleet("nxtway-gs", 40, seconds=2.0, pushes=(upright.Impulse(impulse=0.1),))


def a_push_map() -> Result:
    grid = PushGrid(heights=np.array([0.05, 0.1]), durations=np.array([0.02, 0.1]))
    return upright.push_map("nxtway-gs", grid, samples=3, nodes=(1, 1), watch=1.0)


def a_basin() -> Result:
    return basin(ensemble_of("nxtway-gs", seconds=1.0), Axis("pitch", -0.3, 0.3, 5), Axis("pitch_rate", -2, 2, 5))


def a_campaign() -> Result:
    counts = {"lqr": 30, "lqg": 0}
    return Cases(CaseSummary({"controller": k}, 100, n, clopper_pearson(n, 100), {}) for k, n in counts.items())


def an_analysis() -> Result:
    kit = Kit.preset("nxt")
    return analyse(make_controller("lqr", Robot.preset("nxtway-gs"), kit, kit.period), Robot.preset("nxtway-gs"), kit)


def a_bench() -> Result:
    t = np.arange(0.0, 5.0, 0.01)
    sides = [f"{kind}/{side}" for kind in ("command", "applied") for side in SIDES]
    log = Log(t, dict.fromkeys([*TRUE_STATE, *sides], 0.1 * np.exp(-t)))
    row = BenchRow(controller="lqg", push="front, +0.10 rad", outcome="yes", impulse=0.2, spread=0.0, effort=2.0)
    return Bench(robot="r", kit="nxt", body="twin", seed=1, rows=(row,), logs={("lqg", row.push): log}, period=0.01)


def a_parity() -> Result:
    pushes = (PushOutcome("front", True, 0.1, "stood"),)
    return Parity(
        target="c", where=Say("CPython"), numbers="float", robot="r", hash="0", unit="V", steps=9, periods=9,
        worst=1e-5, tolerance=1e-4, duties=0, pushes=pushes,
    )  # fmt: skip


def a_diagnosis() -> Result:
    return doctor(upright.example("fall"))


def a_post_mortem() -> Result:
    push = Blow(impulse=0.38, start=5.0, duration=0.01, height=0.07, counts=0.65, largest=0.63, most=0.37, explained=1)
    causes = Cause(PUSH, 0.67, 5.0, Say("push"), push), Cause(LOW, 0.33, 4.5, Say("gain too low"))
    return PostMortem(
        verdict=PUSH, causes=causes, robot="a", kit="b", controller="", hash="", fell_at=5.4, onset=5.0, rows=600,
        missing=(), notes=(), series=Series.none(),
    )  # fmt: skip


def grades() -> Result:
    runs = [RunResult(fell=False, seconds=6.0, peak=0.2, travel=0.1, best=best) for best in (0.28, 0.4)]
    wrong = Grade(student="Eva", file="b", task="push", claimed=runs[1], replayed=runs[0], verdict="differs",
                  why=differs(runs[1], runs[0]))  # fmt: skip
    return Grades("class", [Grade(student="Ana", file="a", task="push", replayed=runs[0], verdict="ok"), wrong])


@pytest.mark.parametrize(
    "make",
    [
        grades, a_fleet, a_push_map, a_basin, a_campaign, a_diagnosis, a_post_mortem, an_analysis, a_bench, a_parity,
        lambda: upright.linearise("nxtway-gs"),
    ],
)  # fmt: skip
def test_every_rendering_has_the_same_numbers(make: Callable[[], Result]) -> None:
    """A head as JSON, terminal, page and notebook; in Spanish with its comma."""
    result = make()
    page = result.page()
    values = [value.replace("\u00a0", " ") for value, _ in page.head()["numbers"]]
    assert values
    data = json.dumps(result.to_json(), allow_nan=False)
    head = json.dumps(page.head(), ensure_ascii=False)
    for rendered in (str(result), html.document(page), result._repr_html_(), head):
        assert all(value in rendered.replace("\u00a0", " ") for value in values)
    assert max(map(len, str(result).splitlines())) <= 80
    with speaking("es"):
        spanish = terminal.text(result.page())
        assert json.dumps(result.to_json()) == data  # data are in one language
    assert re.findall(r"\d+", spanish.partition("upright")[0]) == re.findall(
        r"\d+", str(result).partition("upright")[0]
    )
    assert spanish.splitlines()[0] != str(result).splitlines()[0]
    assert not still_english(spanish)


@pytest.mark.parametrize(
    ("step", "typed", "command"),
    [
        (Next("certify", "lqg", robot="ev3way"), {"robot": "b.toml", "method": "lqg", "output": "lqg.json"},
         "certify lqg.json --robot b.toml"),
        (Next("design", "hinf", robot="ev3way"), {"kit": "ev3"}, "design hinf --robot ev3way --kit ev3"),
        (Next("push_map", robot="ev3way", controller="lqg"), {"controller": "c.json"},
         "push-map --robot ev3way --controller c.json"),
        (Next("certify", "mpc", robot="ev3way"), {"controller": ["mpc", "lqr"]}, "certify mpc --robot ev3way"),
        (Next("certify", "lqg", robot="ev3way"), {}, "certify lqg --robot ev3way"),
        (Next("certify", "lqg"), {"method": "lqg", "output": "my lqg.json"}, "certify 'my lqg.json'"),
        (Next("doctor", "a.csv"), {"robot": "my robot.toml"}, "doctor a.csv --robot 'my robot.toml'"),
    ],
)  # fmt: skip
def test_what_to_run_next_keeps_the_robot_kit_and_controller_that_were_typed(
    step: Next, typed: dict[str, Any], command: str
) -> None:
    token = GIVEN.set(typed)
    (following,) = continued(Page(Say("number"), next=[step])).next
    GIVEN.reset(token)
    assert following.command == f"upright {command}"


@pytest.mark.parametrize(("suffix", "begins"), [(".svg", b"<?xml"), (".pdf", b"%PDF"), (".png", b"\x89PNG")])
def test_a_report_may_be_the_picture_alone(suffix: str, begins: bytes, tmp_path: Path) -> None:
    """A page under the name of a picture opened nowhere."""
    path = upright.report(upright.linearise("nxtway-gs"), tmp_path / f"poles{suffix}")
    assert path.read_bytes().startswith(begins)
