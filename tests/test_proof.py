"""Results are data: a certificate, a calibration and a post-mortem on a terminal, as a page, in a notebook, in the lab,
in Spanish and as JSON have equal numbers, which are read out of each text here, with their units."""

from __future__ import annotations

import html
import json
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

import upright
from upright.diagnose.causes import LOW, PUSH, Blow, Cause
from upright.diagnose.post_mortem import PostMortem
from upright.diagnose.series import Series
from upright.languages import speaking
from upright.pages import Result, Say
from upright.pages.result import write_page

SI = {
    "°": ("rad", math.pi / 180), "%": ("fraction", 0.01), "ms": ("s", 1e-3), "s": ("s", 1.0), "cm": ("m", 0.01),
    "m": ("m", 1.0), "N s": ("N s", 1.0), "N": ("N", 1.0), "": ("1", 1.0),
}  # fmt: skip
"""Unit of people → unit of data, and what one of it is."""

UNITS = "|".join(sorted(filter(None, SI), key=len, reverse=True))
NUMBER = re.compile(rf"(?<![\w.,])(−?\d+(?:[.,]\d+)?)(?: ± [\d.,]+| \([^()]* [^()]*\d\))? ?({UNITS})?(?![\w°%])")
"""A number with its unit, between which an error or an interval may stand."""


@dataclass(frozen=True)
class Shown:
    """A number as it is printed, in SI; so large is one in its last digit."""

    value: float
    step: float
    unit: str


def numbers_of(text: str, decimal: str) -> list[Shown]:
    """Every number of a text."""
    plain = " ".join(text.replace("\u00a0", " ").split())
    found: list[Shown] = []
    for digits, unit in NUMBER.findall(plain):
        name, factor = SI[unit]
        number = digits.replace("−", "-").replace(decimal, ".")
        if number.count(".") <= 1 and "," not in number:
            step = 10.0 ** -len(number.partition(".")[2])
            found.append(Shown(float(number) * factor, step * factor, name))
    return found


def shows(text: str, value: float, unit: str, decimal: str = ".") -> bool:
    """Whether a text has this number; a bound is never rounded to the safe side, but by less than one in its last
    digit."""
    return any(n.unit == unit and abs(n.value - value) < 1.001 * n.step for n in numbers_of(text, decimal))


Facts = list[tuple[float, str]]


def of_certificate(data: Mapping[str, Any]) -> Facts:
    """Numbers of a certificate's JSON that stand on its first screen, or in the answers below it."""
    pushes = {one["kind"]: one for one in data["endured"]}
    return [(data["bound"], "fraction"), (data["linear"]["delay"], "s"), (pushes["knock"]["size"], "N s")]


def answers_of_certificate(data: Mapping[str, Any]) -> Facts:
    pushes = {one["kind"]: one for one in data["endured"]}
    return [
        (pushes["knock"]["best"], "N s"), (pushes["hold"]["size"], "N"), (pushes["hold"]["best"], "N"),
        (pushes["slope"]["size"], "rad"), (data["standing"]["longest"], "s"), (data["standing"]["runs"], "1"),
    ]  # fmt: skip


def of_calibration(data: Mapping[str, Any]) -> Facts:
    """A lean grows as exp(pole t): it doubles in log 2 / pole. R² is that of the gyro or encoder predicted worst."""
    pole = next(one for one in data["combinations"] if one["name"] == "unstable_pole")
    scores = [min(data["segments"][n], data["unfitted"][n]) for n in ("sensor/gyro", "sensor/encoder_left")]
    return [(math.log(2) / pole["value"], "s"), (min(scores), "1")]


def of_post_mortem(data: Mapping[str, Any]) -> Facts:
    push = data["causes"][0]["push"]
    return [
        (data["causes"][0]["likelihood"], "fraction"), (data["causes"][1]["likelihood"], "fraction"),
        (push["impulse"], "N s"), (push["most"], "N s"), (push["height"], "m"), (data["fell_at"], "s"),
    ]  # fmt: skip


def nothing_more(data: Mapping[str, Any]) -> Facts:
    return []


def a_certificate() -> Result:
    return upright.certify("lqg", "nxtway-gs", samples=100)


def a_calibration() -> Result:
    return upright.calibrate(upright.example("standing"), "nxtway-gs")


def a_post_mortem() -> Result:
    push = Blow(impulse=0.38, start=5.0, duration=0.01, height=0.07, counts=0.65, largest=0.63, most=0.29, explained=1)
    causes = Cause(PUSH, 0.67, 5.0, Say("a push"), push), Cause(LOW, 0.33, 4.5, Say("the motors had torque left"))
    return PostMortem(
        verdict=PUSH, causes=causes, robot="a", kit="b", controller="", hash="", fell_at=5.43, onset=5.0, rows=600,
        missing=(), notes=(), series=Series.none(),
    )  # fmt: skip


@pytest.mark.parametrize(
    ("make", "first", "below"),
    [
        pytest.param(a_certificate, of_certificate, answers_of_certificate, id="certificate"),
        pytest.param(a_calibration, of_calibration, nothing_more, id="calibration", marks=pytest.mark.evidence),
        pytest.param(a_post_mortem, of_post_mortem, nothing_more, id="post-mortem"),
    ],
)
def test_six_renderings_have_the_numbers_of_the_json(
    make: Callable[[], Result], first: Callable[[Any], Facts], below: Callable[[Any], Facts], tmp_path: Path
) -> None:
    result = make()
    data = json.loads(json.dumps(result.to_json()))
    texts = {"terminal": (str(result), "."), "notebook": (read(result._repr_html_()), ".")}
    texts["page"] = (read(write_page(result.page(), tmp_path / "page.html").read_text("utf-8")), ".")
    with speaking("es"):
        texts["Spanish terminal"] = (str(result), ",")
        texts["Spanish page"] = (read(write_page(result.page(), tmp_path / "es.html").read_text("utf-8")), ",")
    heads = {f"lab in {name}": spoken for name, spoken in in_lab(result).items()}
    facts = first(data)
    for name, (text, decimal) in (texts | heads).items():
        for value, unit in facts + ([] if name in heads else below(data)):
            assert shows(text, value, unit, decimal), (name, value, unit)
    # and no text has every number: of these, changed by a tenth, at least half are nowhere
    others = [(1.1 * value, unit) for value, unit in facts]
    for name, (text, decimal) in (texts | heads).items():
        assert sum(shows(text, value, unit, decimal) for value, unit in others) <= len(others) / 2, name


def in_lab(result: Result) -> dict[str, tuple[str, str]]:
    """What the lab sends of a page, by language, as text, and its decimal sign."""
    from upright.lab.spoken import heads_of

    spoken: dict[str, tuple[str, str]] = {}
    for language, head in heads_of(result.page()).items():
        words = [head.title, head.verdict, *head.lead, *(part for number in head.numbers for part in number)]
        spoken[language] = ("\n".join(words), "," if language == "es" else ".")
    return spoken


def read(page: str) -> str:
    """A page as its reader has it: without drawings, scripts and style."""
    plain = re.sub(r"<(script|style|svg)\b.*?</\1>", " ", page, flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]+>", " ", plain))
