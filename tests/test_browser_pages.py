"""Pages as a browser shows them: nothing wider than the screen, figures that say numbers, few printed pages."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from upright.certification.design import design
from upright.comparison import compare
from upright.comparison.bench import Bench, BenchRow
from upright.experiment import Impulse
from upright.fleets.basin import Axis, basin
from upright.fleets.fleet import ensemble_of, fleet
from upright.reports import report
from upright.signals import STATE_NAMES, Log

pytestmark = [pytest.mark.needs("chromium", "module:playwright")]

KINDS = ("comparison", "design", "fleet", "basin", "bench")
DEAR = pytest.param("design", marks=pytest.mark.evidence)
"""Half of the time that all pages take."""
SCREENS = ((1280, 900), (390, 844))  # [px] a laptop's window, a phone


def run(decay: float) -> Log:
    t = np.arange(0, 6, 0.01)
    pitch = 0.1 * np.exp(-np.maximum(t - 1, 0) / decay)
    columns = {f"truth/{name}": pitch for name in STATE_NAMES} | {"push/force": np.where(t < 1, 1.0, 0.0)}
    columns |= {f"{p}/{s}": 10 * pitch for p in ("command", "applied") for s in ("left", "right")}
    return Log(t, columns)


def bench() -> Bench:
    rows = tuple(
        BenchRow(controller=name, push=push, outcome="yes", peak=0.12345, settling=1.234, travel=12.345, effort=123.4,
                 saturated=0.0, impulse=size, spread=0.01)
        for name, size in (("lqr-complementary", 0.2), ("lqg", 0.3)) for push in ("front, +0.10 rad", "back, −0.12 rad")
    )  # fmt: skip
    logs = {(row.controller, row.push): run(0.5) for row in rows}
    return Bench(robot="nxtway-gs", kit="nxt", body="twin", seed=1, rows=rows, logs=logs)


RESULTS: dict[str, Callable[[], Any]] = {
    "comparison": lambda: compare({"twin": run(0.5), "nonlinear model": run(0.4), "linear": run(0.3)}),
    "design": lambda: design("lqg", "nxtway-gs"),
    "fleet": lambda: fleet("nxtway-gs", 20, vary={"com_height": "±10%"}, pushes=(Impulse(impulse=0.1),), seconds=2.0),
    "basin": lambda: basin(ensemble_of("nxtway-gs", seconds=1.0), Axis("pitch", -1.0, 1.0, 5), Axis("wheel", -1, 1, 3)),
    "bench": bench,
}


class Pages(dict[str, Path]):
    """One page of each kind whose result takes no more than seconds, made when it is asked for."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __missing__(self, name: str) -> Path:
        self[name] = report(RESULTS[name](), self.folder / f"{name}.html")
        return self[name]


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Pages:
    return Pages(tmp_path_factory.mktemp("pages"))


AXE = [(("bench",), "dark"), *(pytest.param(KINDS, way, marks=pytest.mark.evidence) for way in ("light", "dark"))]
"""One page with numbers, figure and table, where contrast is hardest; the others have the same template and style."""


@pytest.mark.needs("npm")
@pytest.mark.parametrize(("kinds", "scheme"), AXE)
def test_axe_core_finds_nothing_serious(
    pages: dict[str, Path], browser: Any, lend: Any, axe: Path, kinds: tuple[str, ...], scheme: str
) -> None:
    """Neither on a light screen nor on a dark one, where it also measures the contrast of all letters."""
    page = lend(browser, scheme=scheme)
    found: list[str] = []
    for name in kinds:
        page.goto(pages[name].as_uri())
        page.evaluate("document.querySelectorAll('details').forEach((item) => { item.open = true })")
        page.add_script_tag(path=str(axe))
        for wrong in page.evaluate("axe.run().then((result) => result.violations)"):
            if wrong["impact"] in ("serious", "critical"):
                found += [f"{name}: {wrong['id']}: {node['html'][:200]}" for node in wrong["nodes"]]
    assert not found


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_lines_and_letters_of_a_drawing_differ_from_the_paper(
    pages: dict[str, Path], browser: Any, lend: Any, scheme: str
) -> None:
    """Letters by 4.5:1 and lines by 3:1, as WCAG 2.2 asks (1.4.3, 1.4.11), by its formula of contrast."""
    page = lend(browser, scheme=scheme)
    page.goto(pages["comparison"].as_uri())

    def luminance(variable: str) -> float:
        text = page.evaluate(f"getComputedStyle(document.documentElement).getPropertyValue('--{variable}').trim()")
        parts = [int(text[k : k + 2], 16) / 255 for k in (1, 3, 5)]
        linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
        return float(np.dot(linear, (0.2126, 0.7152, 0.0722)))

    def contrast(one: str, other: str) -> float:
        low, high = sorted((luminance(one), luminance(other)))
        return (high + 0.05) / (low + 0.05)

    least = {"soft": 4.5, "ink": 4.5, **dict.fromkeys(("axis", "c0", "c1", "c2", "c3", "c4", "c5"), 3.0)}
    weak = {name: contrast(name, "paper") for name, bar in least.items() if contrast(name, "paper") < bar}
    assert not weak


@pytest.mark.parametrize("name", [DEAR if name == "design" else name for name in KINDS])
def test_a_page_fits_a_laptop_and_a_phone(pages: dict[str, Path], browser: Any, lend: Any, name: str) -> None:
    """Nothing is wider than the screen, on the first screen are picture, numbers and what to run next, and no axis is
    a logarithm."""
    page = lend(browser, 1280, 900)
    page.goto(pages[name].as_uri())
    top = page.evaluate("document.querySelector('header figure svg').getBoundingClientRect().top")
    assert top < 450  # half a laptop's screen
    letters = page.evaluate("[...document.querySelectorAll('figure svg text')].map((t) => t.textContent)")
    assert not [text for text in letters if re.search(r"log|power of ten", text)]
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        for part in page.query_selector_all("header .numbers, header .next"):
            box = part.bounding_box()
            assert box["y"] + box["height"] <= height
    page.evaluate("document.querySelectorAll('details').forEach((item) => { item.open = true })")
    for width, height in SCREENS:
        page.set_viewport_size({"width": width, "height": height})
        assert page.evaluate("document.documentElement.scrollWidth") == width
        wide = "[...document.querySelectorAll('.table')].filter((t) => t.scrollWidth > t.clientWidth + 1).length"
        assert width < 1280 or page.evaluate(wide) == 0  # a phone scrolls a table by itself


def test_a_pointer_over_a_figure_reads_its_lines(pages: dict[str, Path], browser: Any, lend: Any) -> None:
    page = lend(browser, 1280, 900)
    page.goto(pages["comparison"].as_uri())
    box = page.evaluate("(({x, y, width, height}) => [x, y, width, height])"
                        "(document.querySelector('svg.lines').getBoundingClientRect())")  # fmt: skip
    data = page.evaluate("JSON.parse(document.querySelector('svg.lines').dataset.curves)[0]")
    wide = page.evaluate("document.querySelector('svg.lines').viewBox.baseVal.width")
    (low, high), left, right = data["x"], data["left"], data["right"]
    at = left + (0.5 - low) / (high - low) * (right - left)  # half a second, while pitch is held at 0.1
    page.mouse.move(box[0] + at / wide * box[2], box[1] + box[3] / 2)
    text = page.evaluate("document.querySelector('output').textContent")
    time, *values = re.findall(r"-?\d+\.?\d*", text)
    assert float(time) == pytest.approx(0.5, abs=0.02)
    # angles in degrees of three runs; how far two of them are from the first follows
    assert [float(value) for value in values[:3]] == pytest.approx([math.degrees(0.1)] * 3, abs=0.1)


@pytest.mark.parametrize("left_out", ["design", pytest.param("", marks=pytest.mark.evidence)])
def test_captions_are_short_sentences(pages: dict[str, Path], left_out: str) -> None:
    """Half of them of at most 14 words, none of more than 25."""
    lengths: list[int] = []
    for name in set(KINDS) - {left_out}:
        page = pages[name].read_text()
        for text in re.findall(r"<(?:p|figcaption)\b[^>]*>(.*?)</(?:p|figcaption)>", page, re.DOTALL):
            plain = re.sub(r"<[^>]+>", "", text)
            lengths += [len(re.findall(r"\S*\w\S*", part)) for part in re.split(r"(?<=[.;:!?])\s+", plain)]
    assert np.median(lengths) <= 14
    assert max(lengths) <= 25
