"""Pages and figures: well formed, self-contained, the same bytes each time, and true to the data."""

from __future__ import annotations

import math
import re
from html.parser import HTMLParser
from importlib import import_module
from itertools import pairwise
from typing import get_args, get_type_hints
from xml.etree import ElementTree

import numpy as np
import pytest
from xarray import Dataset

from upright.comparison import compare
from upright.errors import InvalidLog, UnknownName, UprightError
from upright.report import (
    PAGES,
    Figure,
    Formula,
    Page,
    Panel,
    PointFigure,
    PointSet,
    Section,
    Table,
    Trace,
    Verdict,
    page_of,
    report,
)
from upright.report.page import cell_text
from upright.report.svg import decimate, nice_ticks, tick_texts
from upright.signals import STATE_NAMES, Log

SVG = "{http://www.w3.org/2000/svg}"
VOID = {"meta", "link", "br", "hr", "img", "input"}


class Balanced(HTMLParser):
    """Fails on a tag that is closed out of turn; at the end `open` must be empty."""

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.links = [], [], []

    def handle_starttag(self, tag, attrs):
        self.open += [] if tag in VOID else [tag]
        self.ids += [value for name, value in attrs if name == "id"]
        self.links += [value for name, value in attrs if name in ("href", "src", "xlink:href")]

    def handle_startendtag(self, _, attrs):
        self.ids += [value for name, value in attrs if name == "id"]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def figure(**changes):
    t = np.linspace(0, 5, 100)
    panels = [Panel("pitch ψ", "rad", [Trace("twin", t, np.sin(t)), Trace("model <1>", t, np.cos(t))])]
    return Figure(**{"title": "Twin & model agree", "panels": panels, "spans": [(1.0, 2.0)], **changes})


def run(kind="nonlinear model", tau=0.5):
    t = np.arange(0, 6, 0.01)
    pitch = 0.1 * np.exp(-np.maximum(t - 1, 0) / tau)
    columns = {f"truth/{name}": pitch for name in STATE_NAMES} | {"push/force": np.where(t < 1, 1.0, 0.0)}
    columns |= {f"{p}/{s}": 10 * pitch for p in ("command", "applied") for s in ("left", "right")}
    return Log(t, columns, origin={"body": {"kind": kind}, "seed": 7, "versions": {"numpy": "2"}})


def page():
    poles = PointFigure("All poles lie inside the circle", [PointSet("closed loop", [0.9 + 0.1j, 0.9 - 0.1j])])
    maths = Formula('<math xmlns="http://www.w3.org/1998/Math/MathML"><mi>x</mi></math>')
    sections = [
        Section("First <em>", ["A & B <script>", figure(), poles], Verdict("reproduced", "good")),
        Section("First", [Table(["", "s"], [["x", 1.5], ["y", math.nan]], "Times"), Formula("u = −K x"), maths]),
    ]
    return Page("A page", sections, "Lead.", {"seed": "7"})


def drawings(html):
    return [ElementTree.fromstring(text) for text in re.findall(r"<svg.*?</svg>", html, re.DOTALL)]


def coordinates(root):
    lines = root.iter(f"{SVG}polyline")
    return [[tuple(map(float, pair.split(","))) for pair in line.attrib["points"].split()] for line in lines]


@pytest.fixture(scope="module")
def comparison():
    return compare({"robot": run("twin"), "linear": run(tau=0.3), "nonlinear": run(tau=0.45)})


def test_pages_are_well_formed_and_their_links_lead_to_ids_that_exist_once(comparison):
    for html in (page().html(), page_of(comparison).html()):
        parser = Balanced()
        parser.feed(html)
        assert parser.open == []
        assert len(set(parser.ids)) == len(parser.ids)
        assert {link.removeprefix("#") for link in parser.links} <= set(parser.ids)


def test_pages_fetch_nothing(comparison):
    for html in (page().html(), page_of(comparison).html()):
        assert not re.search(r"https?://|//[a-z]+\.[a-z]", re.sub(r'xmlns="[^"]*"', "", html))
        assert not re.search(r"@import|url\((?!#)", html)  # url(#…) points into the drawing itself


def test_every_drawing_is_xml_with_a_title_a_description_and_units_on_both_axes(comparison):
    for html in (page().html(), page_of(comparison).html()):
        pictures = [root for root in drawings(html) if root.get("role") == "img"]
        assert pictures
        for root in pictures:
            assert root.findtext(f"{SVG}title")
            assert root.findtext(f"{SVG}desc")
            labels = [text.text for text in root.iter(f"{SVG}text") if text.get("class") == "axis"]
            assert len(labels) >= 2
            assert all(re.search(r"\[.+\]$", label) for label in labels)


def test_the_comparison_page_draws_each_state_and_the_commands_and_says_twin(comparison):
    html = page_of(comparison).html()
    assert sum(root.get("role") == "img" for root in drawings(html)) == len(STATE_NAMES) + 1
    assert "Pitch settles to 2 %: twin in" in html
    assert ">robot<" not in html
    assert "not results of a real robot" in html  # the note on twins


def test_the_same_page_is_the_same_bytes(comparison, tmp_path):
    first, second = (report(comparison, tmp_path / name) for name in ("a.html", "b.html"))
    assert first.read_bytes() == second.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.html", "b.html"]  # no temporary file stays


def test_a_title_replaces_the_pages_own_and_a_result_without_a_page_says_so(comparison, tmp_path):
    assert "<title>Runs compared</title>" in page_of(comparison).html()
    assert "<title>Two &amp; one</title>" in report(comparison, tmp_path / "a.html", title="Two & one").read_text()
    with pytest.raises(UprightError, match="float has no page; expected a result: Comparison, Calibration") as error:
        report(1.0, tmp_path / "b.html")
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("name", PAGES)
def test_every_class_of_the_list_exists_and_its_file_takes_it(name):
    takes = get_type_hints(import_module(f"upright.report.{PAGES[name]}").page_of, localns={"Dataset": Dataset})
    given = takes[next(iter(takes))]
    assert name in {kind.__name__ for kind in (get_args(given) or (given,))}


def test_text_is_escaped_wherever_it_stands():
    html = page().html()
    assert "<script>\n//" in html  # our own
    assert "A &amp; B &lt;script&gt;" in html
    assert "First &lt;em&gt;" in html
    assert "model &lt;1&gt;" in html
    assert "<1>" not in html


def test_a_page_that_cannot_be_written_is_an_error_of_ours(tmp_path):
    with pytest.raises(UprightError, match="no folder"):
        page().write(tmp_path / "nowhere" / "a.html")


def test_a_failed_write_leaves_the_old_page(tmp_path, monkeypatch):
    target = tmp_path / "a.html"
    target.write_text("old")
    monkeypatch.setattr("os.replace", lambda *_: (_ for _ in ()).throw(OSError(28, "disk full")))
    with pytest.raises(UprightError, match="disk full"):
        page().write(target)
    assert [path.name for path in tmp_path.iterdir()] == ["a.html"]
    assert target.read_text() == "old"


def test_a_line_goes_through_its_data():
    root = ElementTree.fromstring(figure(panels=[Panel("y", "m", [Trace("a", [0, 1, 2], [0, 1, 0])])]).svg())
    (line,) = coordinates(root)
    (left, low), (middle, high), (right, end) = line
    assert middle == pytest.approx((left + right) / 2, abs=0.01)  # rounded to 2 decimals
    assert low == end > high  # a drawing's y runs downwards
    panel = next(g for g in root.iter(f"{SVG}g") if g.get("class") == "panel")
    assert low - high == pytest.approx(190 / 1.12, abs=0.02)  # a panel of 190 with 6 % of room on either side
    assert float(panel.attrib["data-low"]) == pytest.approx(-0.06)


def test_nan_breaks_a_line_and_a_panel_of_nan_says_so():
    gap = Panel("y", "m", [Trace("a", range(5), [0, 1, math.nan, 1, 0])])
    nothing = Panel("z", "m", [Trace("a", range(2), [math.nan, math.nan])])
    root = ElementTree.fromstring(figure(panels=[gap, nothing]).svg())
    assert [len(line) for line in coordinates(root)] == [2, 2]
    texts = [text.text for text in root.iter(f"{SVG}text")]
    assert "no finite values" in texts
    assert not any("nan" in (text or "") for text in texts)


def test_a_step_line_holds_each_value_up_to_the_next():
    (line,) = coordinates(
        ElementTree.fromstring(figure(panels=[Panel("u", "V", [Trace("a", [0, 1, 2], [0, 1, 0], step=True)])]).svg())
    )
    assert all(a[0] == b[0] or a[1] == b[1] for a, b in pairwise(line))
    assert len(line) == 5  # three values and two corners between them


def test_decimation_keeps_extremes_and_ends_and_bounds_the_count():
    rng = np.random.default_rng(3)
    t, y = np.linspace(0, 1, 100_000), rng.normal(size=100_000)
    y[54_321], y[12_345] = 99, -99  # two lone spikes, which a plain stride of 100 would lose
    kept_t, kept = decimate(t, y, 500)
    assert len(kept) <= 4 * 500  # first, smallest, largest, last of each column
    assert (kept.min(), kept.max()) == (-99, 99)
    assert (kept_t[0], kept_t[-1]) == (0, 1)
    assert (np.diff(kept_t) > 0).all()


def test_few_samples_and_loops_are_drawn_whole():
    angle = np.linspace(0, 6, 5000)
    assert len(decimate(np.cos(angle), np.sin(angle), 10)[0]) == 5000
    assert len(decimate(angle[:40], angle[:40], 10)[0]) == 40


@pytest.mark.parametrize(("low", "high"), [(0, 1), (-0.013, 0.11), (3e5, 9e5), (-2e-7, 1e-7), (99.9, 100.1)])
def test_ticks_are_round_inside_the_range_and_different_from_each_other(low, high):
    ticks = nice_ticks(low, high, 5)
    assert 2 <= len(ticks) <= 6
    assert low - 1e-9 * abs(low) <= ticks[0] < ticks[-1] <= high + 1e-9 * abs(high)
    mantissa = (ticks[1] - ticks[0]) / 10 ** math.floor(math.log10(ticks[1] - ticks[0]) + 1e-6)
    assert min(abs(mantissa - round_one) for round_one in (1, 2, 5)) < 1e-6
    assert len(set(tick_texts(ticks))) == len(ticks)


def test_traces_differ_by_dashes_too_and_keep_their_style_in_every_panel():
    both = [Panel(side, "V", [Trace(n, [0, 1], [0, 1]) for n in names]) for side, names in (("l", "ab"), ("r", "b"))]
    root = ElementTree.fromstring(figure(panels=both).svg())
    lines = [(g.get("data-name"), g.get("class")) for g in root.iter(f"{SVG}g") if g.get("data-name")]
    assert lines == [("a", "line c0 d0"), ("b", "line c1 d1"), ("b", "line c1 d1")]


def test_the_unit_circle_is_round_and_poles_stand_where_they_are():
    root = ElementTree.fromstring(PointFigure("Pole at one", [PointSet("p", [1.0]), PointSet("q", [1j])]).svg())
    circle = next(c for c in root.iter(f"{SVG}circle") if c.get("class") == "unit")
    other = next(c for c in root.iter(f"{SVG}circle") if c.get("class") != "unit")  # the second marker's shape
    assert float(other.attrib["cx"]) == pytest.approx(float(circle.attrib["cx"]), abs=0.02)  # both rounded
    assert float(other.attrib["cy"]) == pytest.approx(
        float(circle.attrib["cy"]) - float(circle.attrib["r"]), abs=0.02
    )  # j is at the top


def test_a_run_that_dwarfs_the_reference_is_cut_and_named():
    base = run()
    wild = Log(base.t, {**base.channels, "truth/yaw": np.exp(base.t)}, origin=base.origin)
    html = page_of(compare({"a": base, "wild": wild})).html()
    assert "Cut at the frame: wild." in html
    clips = set(re.findall(r'<clipPath id="(\w+)"', html))
    assert clips == set(re.findall(r'clip-path="url\(#(\w+)\)"', html)) != set()


def test_cells_show_a_true_minus_and_a_dash_for_what_is_not_known():
    assert [cell_text(cell) for cell in (-1.5, math.nan, None, True, 1.06e7, "x")] == [
        "−1.5",
        "–",
        "–",
        "yes",
        "1.06 · 10⁷",
        "x",
    ]


def test_mistakes_in_a_page_are_told():
    with pytest.raises(UprightError, match="a row of table 'T' has 1 cells; expected 2"):
        Table(["a", "b"], [["x"]], "T")
    with pytest.raises(UnknownName, match="one of good, info, warn"):
        Verdict("fine", "great")
    with pytest.raises(UprightError, match="MathML does not parse"):
        Formula("<math><mi>x</math>")
    with pytest.raises(InvalidLog, match="trace 'a' has 2 x and 1 y"):
        Trace("a", [0, 1], [0])
