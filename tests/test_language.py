"""What a notebook shows in Spanish: every word of its figures, decimal commas, and the terms of the glossary."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import upright as up
from upright.checkup.finding import BALANCING, FALLEN, FALLING, LYING, MOVED, OVER, RISING, STANDING
from upright.identification.methods import IDENTIFIERS
from upright.languages import SPANISH, figure_translated, language, translated
from upright.pages.drawing import strokes
from upright.pages.words import catalogue
from upright.plotting import bars, intervals
from upright.robots.robot import PARAMETERS
from upright.tables import Listing, spoken

GLOSSARY = Path(__file__).parents[1] / "docs" / "conventions.md"
NXT, KIT = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
SAME = {"robots", "LQR", *IDENTIFIERS, "calibrate"}
"""Words that are the same in both languages, and names that one types."""


@pytest.fixture(autouse=True)
def in_spanish() -> Iterator[None]:
    language("es")
    yield
    language()


def texts(figure: Figure) -> list[str]:
    """Every text that is drawn, ticks too."""
    figure.draw_without_rendering()
    return [text.get_text() for text in figure.findobj(Text) if text.get_text()]


def left_in_english(figure: Figure) -> set[str]:
    """Words that stay as they are: not in a bracket, with two letters at least, and no name of a channel or method."""
    with figure_translated(figure):
        shown = set(texts(figure))
    words = {re.sub(r" ?\[.*\]", "", text) for text in shown & set(texts(figure))}
    english = {w for w in words if re.search(r"[a-z]{2}", w) and not re.search(r"[a-z]/[a-z]|-", w)} - SAME
    # what was drawn as a `Say` is in the chosen language already
    return {w for w in english if not any(re.fullmatch(form, w) for form in _catalogued())}


@functools.cache
def _catalogued() -> list[str]:
    """Translated templates as patterns, a unit in brackets left out."""
    bare = (re.sub(r" ?\[.*\]", "", text) for text in catalogue("es").values())
    return [re.sub(r"\\\{\w+\\\}", ".+", re.escape(text)) for text in bare if re.search(r"[a-z]{2}", text)]


def test_the_terms_are_those_of_the_glossary() -> None:
    """A row of several names has them in one phrase, and is left out; so is `estimate`, which is a state there."""
    rows = [[cell.strip() for cell in row.split("|")] for row in GLOSSARY.read_text("utf-8").splitlines() if "|" in row]
    terms = {row[2][1:-1]: row[5] for row in rows if len(row) == 7 and re.fullmatch(r"`[a-z_]+`", row[2])}
    known = {name: SPANISH[spoken(name)] for name in terms.keys() - {"estimate"} if spoken(name) in SPANISH}
    assert len(known) > 15
    for name, words in known.items():
        assert set(words.split()) - {"de", "del", "la", "las"} <= set(re.findall(r"\w+", terms[name])), name


def test_every_parameter_has_a_name_that_fits_beside_its_row() -> None:
    names = [*PARAMETERS]
    figure = intervals(names, np.zeros(len(names)), np.ones((len(names), 2)), "time [s]", "parameter")
    assert not left_in_english(figure)
    with figure_translated(figure):
        figure.draw_without_rendering()
        assert min(label.get_window_extent().x0 for label in figure.axes[0].get_yticklabels()) >= 0


def test_numbers_have_a_comma_and_the_figure_stays_english() -> None:
    figure = bars(["hold at +6.9°, low battery", "knock of 0.155 N s, full battery"], [0.25, 1.5], "travel [m]", "push")
    before = texts(figure)
    with figure_translated(figure):
        shown = texts(figure)
    assert {"sostener a +6,9°, batería baja", "golpe de 0,155 N s, batería plena", "recorrido [m]"} <= set(shown)
    assert not [text for text in shown if re.search(r"\d\.\d", text)]
    assert texts(figure) == before


def test_a_picture_is_spanish_and_a_report_is_not() -> None:
    figure = bars(["a"], [0.5], "travel [m]", "push")
    spanish = figure._repr_png_()[0]  # type: ignore[attr-defined]
    page = strokes(figure, "t")
    language()
    assert figure._repr_png_()[0] != spanish  # type: ignore[attr-defined]
    assert strokes(figure, "t") == page


def test_names_of_ones_own_and_another_language() -> None:
    language("es", {"stays": "se queda"})
    assert translated("stays (twin)") == "se queda (gemelo)"
    assert translated("from the equator to the poles") == "from the equator to the poles"  # a sentence is left alone
    with pytest.raises(up.UprightError, match="no language is called 'fr'; expected one of en, es"):
        language("fr")
    language()
    assert translated("stays (twin)") == "stays (twin)"


def test_every_pose_has_a_name_and_a_list_of_them_too() -> None:
    for pose in (BALANCING, STANDING, LYING, OVER, RISING, FALLING, FALLEN, MOVED):
        assert translated(pose) != pose
    assert translated(f"{RISING}, {FALLING}") == "levantándose, cayendo"


def test_a_table_keeps_the_names_of_its_rows() -> None:
    html = Listing(("parameter", "value"), [("track", "0.14")]).html()
    assert "<th>parámetro</th><th>valor</th>" in html
    assert "<td>track</td><td>0,14</td>" in html


def test_the_margins_of_a_loop_are_shown_in_spanish() -> None:
    """Every word but names: what both languages write alike stands in `same`."""
    loop = up.design("lqg", NXT, KIT).analysis
    assert loop
    both = loop.both()
    edges = [replace(both, **{name: v}) for name, v in (("gain_low", 0.0), ("gain_high", 1e4), ("delay", np.inf))]
    sentences = [*(m.words() for m in edges), replace(both, delay=0.0).words()]
    pairs = [(words, translated(words)) for words in sentences]
    same = {"lqg", "nxtway", "motor", "robots"}
    for english, spanish in pairs:
        kept = set(re.findall(r"[a-z]{3,}", english)) & set(re.findall(r"[a-z]{3,}", spanish)) - same
        assert not kept, spanish
        assert not re.search(r"\d\.\d", spanish)


@pytest.mark.evidence
def test_no_figure_of_the_course_keeps_an_english_word() -> None:
    log, law = up.example("excited").between(0.0, 6.0), up.lqg(NXT, KIT)
    push = up.Impulse(impulse=0.05, start=0.5)
    runs = {"linear": up.LinearBody(up.linearise(NXT), NXT), "nonlinear": up.NonlinearBody(NXT), "twin": up.Twin(NXT)}
    compared = up.compare(
        {name: up.run(body, up.lqr_state(NXT, 0.01), push, seconds=1.0) for name, body in runs.items()}
    )
    analysis = up.design("lqg", NXT, KIT).analysis
    assert analysis
    calibration = up.calibrate(log, NXT)
    figures = {
        "comparison": compared.plot(), "commands": compared.plot_commands(), "bode": analysis.plot(),
        "nyquist": analysis.plot_nyquist(), "poles": analysis.plot_poles(), "calibration": calibration.plot(),
        "prediction": calibration.plot_prediction(),
        "validation": up.validate(up.example("pushed"), NXT).plot(), "log": log.plot("sensor/gyro", "command/left"),
        "identification": up.identify(log, NXT, method="all", runs=4).plot(),
        "certificate": up.certify(law, NXT, samples=100, sweeps=False).plot(),
        "fleet": up.fleet(NXT, n=40, controller=law, vary="spread", pushes=(push,), seconds=1.0).plot(),
    }  # fmt: skip
    assert {name: words for name, figure in figures.items() if figure and (words := left_in_english(figure))} == {}
