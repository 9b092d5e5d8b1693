"""What is shown in Spanish: every word of the figures, decimal commas, and the terms of the glossary."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import upright as up
from upright.identification.methods import IDENTIFIERS
from upright.languages import catalogue, language, speaking, translated
from upright.pages.terms import term
from upright.plotting import bars, intervals
from upright.robots.drawing import labelled
from upright.robots.robot import PARAMETERS
from upright.signals.log import called
from upright.signals.signal import KNOWN

GLOSSARY = Path(__file__).parents[1] / "docs" / "conventions.md"
NXT, KIT = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
SAME = {"robots [%]", *IDENTIFIERS, "calibrate"}
"""What is the same in both languages, and names that one types."""


@pytest.fixture
def in_spanish() -> Iterator[None]:
    """As `language` would set it, whose choice would outlast the test and count more than UPRIGHT_LANG."""
    with speaking("es"):
        yield


def texts(figure: Figure) -> list[str]:
    """Every text that is drawn, ticks too."""
    figure.draw_without_rendering()
    return [text.get_text() for text in figure.findobj(Text) if text.get_text()]


def alike(draw: Callable[[], Figure | None]) -> set[str]:
    """Texts with words that are drawn alike in both languages."""
    figure = draw()
    english = set(texts(figure)) if figure else set()
    with speaking("es"):
        spanish = draw()
        both = english & set(texts(spanish)) if spanish else set()
    return {text for text in both if re.search(r"[a-z]{3}", text)} - SAME


def test_the_terms_are_those_of_the_glossary() -> None:
    """A row of several names has them in one phrase, and is left out; so is `estimate`, which is a state there."""
    rows = [[cell.strip() for cell in row.split("|")] for row in GLOSSARY.read_text("utf-8").splitlines() if "|" in row]
    terms = {row[2][1:-1]: row[5] for row in rows if len(row) == 7 and re.fullmatch(r"`[a-z_]+`", row[2])}
    spanish = catalogue("es")
    known = {name: spanish[word] for name in terms.keys() - {"estimate"} if (word := term(name).template) in spanish}
    assert len(known) > 15
    for name, said in known.items():
        assert set(said.split()) - {"de", "del", "la", "las"} <= set(re.findall(r"\w+", terms[name])), name


@pytest.mark.usefixtures("in_spanish")
def test_every_parameter_has_a_name_that_fits_beside_its_row() -> None:
    names = [str(term(name)) for name in PARAMETERS]
    figure = intervals(names, [0.0] * len(names), [(0.0, 1.0)] * len(names), "x [1]", "y")
    figure.draw_without_rendering()
    assert min(label.get_window_extent().x0 for label in figure.axes[0].get_yticklabels()) >= 0


@pytest.mark.usefixtures("in_spanish")
def test_every_channel_that_is_written_has_a_name() -> None:
    plain = {name: called(name) for name in KNOWN if not name.startswith(("reference/", "push/"))}
    with speaking("en"):
        assert {name for name, said in plain.items() if called(name) == said} == set()
    assert plain["truth/pitch"] == "inclinación (verdad)"
    assert called("of/mine {x}") == "of/mine {x}"


@pytest.mark.usefixtures("in_spanish")
def test_numbers_have_a_comma() -> None:
    shown = texts(bars(["a"], [0.25], "recorrido [m]", "empujón"))
    assert "0,25" in shown
    assert not [text for text in shown if re.search(r"\d\.\d", text)]


@pytest.mark.usefixtures("in_spanish")
def test_names_of_ones_own_and_another_language() -> None:
    language("es", {"stays": "se queda"})
    log = up.Log([0.0, 0.1], {"truth/pitch": [0.0, 0.1]})
    assert translated("stays") == "se queda"
    assert translated("from the equator to the poles") == "from the equator to the poles"
    assert "inclinación (verdad) [rad]" in texts(log.plot())
    with pytest.raises(up.UprightError, match="no language is called 'fr'; expected one of en, es"):
        language("fr")
    language()
    assert translated("stays") == "stays"
    with speaking("en"):
        assert "pitch (truth) [rad]" in texts(log.plot())


def test_a_log_and_a_robot_are_tables_in_both_languages() -> None:
    log = up.Log([0.0, 0.5], {"truth/pitch": [0.0, 0.25]})
    assert '<th scope="col" class="number">largest</th>' in log._repr_html_()
    with speaking("es"):
        spanish = log._repr_html_()
        robot = NXT._repr_html_()
    assert "Registro de 2 muestras" in spanish
    assert "0,25" in spanish
    assert "radio de la rueda" in robot
    assert "wheel_radius" in robot  # as one types it


@pytest.mark.evidence
def test_no_figure_of_the_course_keeps_an_english_word() -> None:
    """Drawn in both languages: a text that stands in both is a name, or was left in English."""
    log, law = up.example("excited").between(0.0, 6.0), up.lqg(NXT, KIT)
    push = up.Impulse(impulse=0.05, start=0.5)
    runs = {"linear": up.LinearBody(up.linearise(NXT), NXT), "nonlinear": up.NonlinearBody(NXT), "twin": up.Twin(NXT)}
    compared = up.compare(
        {name: up.run(body, up.lqr_state(NXT, 0.01), push, seconds=1.0) for name, body in runs.items()}
    )
    analysis = up.design("lqg", NXT, KIT).analysis
    assert analysis
    calibration = up.calibrate(log.between(0.0, 3.0), NXT)
    validation = up.validate(up.example("pushed"), NXT)
    identified = up.identify(log, NXT, method="all", runs=4)
    certificate = up.certify(law, NXT, samples=100, sweeps=False)
    fleet = up.fleet(NXT, n=40, controller=law, vary="spread", pushes=(push,), seconds=1.0)
    draws = [
        compared.plot, compared.plot_commands, analysis.plot, analysis.plot_nyquist, analysis.plot_poles,
        calibration.plot, calibration.plot_prediction, validation.plot, identified.plot, certificate.plot, fleet.plot,
        lambda: fleet.plot("travel"), lambda: log.plot("sensor/gyro", "command/left"), lambda: labelled(NXT),
        up.doctor(up.example("fall")).plot, up.linearise(NXT).plot,
    ]  # fmt: skip
    assert [alike(draw) for draw in draws] == [set()] * len(draws)
