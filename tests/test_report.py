"""Pages as files, and figures: the same bytes each time, and true to the data."""

from __future__ import annotations

import json
import math
import re
from itertools import pairwise
from xml.etree import ElementTree

import numpy as np
import pytest

from upright.certification.design import Designed
from upright.comparison.bench import Bench, BenchRow
from upright.control import design_of, make_controller
from upright.decimate import decimate
from upright.errors import InvalidLog, UprightError
from upright.fleets.binomial import clopper_pearson
from upright.fleets.cases import Cases
from upright.fleets.tally import CaseSummary
from upright.pages import Column, Picture, Say, Table
from upright.pages.drawing import svg
from upright.pages.terms import term
from upright.plotting import (
    COLOURS,
    line,
    number,
    numbered,
    panels,
    plane,
    points,
)
from upright.reports import report
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES, Log

SVG = "{http://www.w3.org/2000/svg}"


def drawn(*curves, label="y [m]", step=False):
    """A figure with one panel for each curve (x, y)."""
    drawing, axes = panels([label] * len(curves))
    for ax, (x, y) in zip(axes, curves, strict=True):
        line(ax, "a", x, y, step=step)
    return drawing


def svg_of(drawing):
    """The drawing as a page has it, without the place below it for what a pointer reads."""
    return svg(Picture(Say("number"), lambda: drawing)).removesuffix("<output></output>")


def a_campaign():
    return Cases((CaseSummary({"robot": "a"}, 100, 0, clopper_pearson(0, 100), {}),))


def circle(*sets):
    drawing, ax = plane(circle=True)
    for name, values in zip("pqr", sets, strict=False):
        points(ax, name, values)
    return drawing


def run(kind="nonlinear model", tau=0.5):
    t = np.arange(0, 6, 0.01)
    pitch = 0.1 * np.exp(-np.maximum(t - 1, 0) / tau)
    columns = {f"truth/{name}": pitch for name in STATE_NAMES} | {"push/force": np.where(t < 1, 1.0, 0.0)}
    columns |= {f"{p}/{s}": 10 * pitch for p in ("command", "applied") for s in ("left", "right")}
    return Log(t, columns, origin={"body": {"kind": kind}, "seed": 7, "versions": {"numpy": "2"}})


def coordinates(root):
    """The lines that a pointer reads: the corners of each run between gaps."""
    lines = [g for g in root.iter(f"{SVG}g") if (g.get("id") or "").startswith("line-")]
    paths = [path.attrib["d"] for g in lines for path in g.iter(f"{SVG}path")]
    runs = [run for d in paths for run in re.split(r"(?=M)", d) if run]
    return [[(float(x), float(y)) for x, y in re.findall(r"[ML] ?(-?[\d.]+) (-?[\d.]+)", run)] for run in runs]


def test_the_same_page_is_the_same_bytes(tmp_path):
    first, second = (report(a_campaign(), tmp_path / name) for name in ("a.html", "b.html"))  # each is drawn anew
    assert first.read_bytes() == second.read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.html", "b.html"]  # no temporary file stays


def test_a_title_replaces_the_pages_own_and_a_result_without_a_page_says_so(tmp_path):
    path = report(a_campaign(), tmp_path / "a.html", title="Two & one")
    assert "<title>Two &amp; one</title>" in path.read_text("utf-8")
    with pytest.raises(UprightError, match="float has no page; expected what a verb of upright returns") as error:
        report(1.0, tmp_path / "b.html")
    assert "\n" not in str(error.value)


def test_a_failed_write_leaves_the_old_page(tmp_path, monkeypatch):
    target = tmp_path / "a.html"
    target.write_text("old")
    monkeypatch.setattr("os.replace", lambda *_: (_ for _ in ()).throw(OSError(28, "disk full")))
    with pytest.raises(UprightError, match="disk full"):
        report(a_campaign(), target)
    assert [path.name for path in tmp_path.iterdir()] == ["a.html"]
    assert target.read_text() == "old"


def test_a_line_goes_through_its_data():
    drawing = drawn(([0, 1, 2], [0, 1, 0]))
    root = ElementTree.fromstring(svg_of(drawing))
    (corners,) = coordinates(root)
    (left, low), (middle, high), (right, end) = corners
    assert middle == pytest.approx((left + right) / 2, abs=0.02)  # rounded to 2 decimals
    assert low == end > high  # a drawing's y runs downwards
    box, (bottom, top) = drawing.axes[0].get_position(), drawing.axes[0].get_ylim()
    height = 72 * drawing.get_figheight() * box.height  # 72 units for an inch
    assert low - high == pytest.approx(height / (top - bottom), abs=0.02)


def test_nan_breaks_a_line():
    root = ElementTree.fromstring(svg_of(drawn((range(5), [0, 1, math.nan, 1, 0]), ([0, 1], [math.nan] * 2))))
    assert [len(corners) for corners in coordinates(root)] == [2, 2]
    assert not any("nan" in (text.text or "") for text in root.iter(f"{SVG}text"))


def test_a_step_line_holds_each_value_up_to_the_next():
    (corners,) = coordinates(ElementTree.fromstring(svg_of(drawn(([0, 1, 2], [0, 1, 0]), step=True))))
    assert all(a[0] == b[0] or a[1] == b[1] for a, b in pairwise(corners))
    assert len(corners) == 5  # three values and two corners between them


def test_what_a_pointer_reads_are_the_values_drawn():
    drawing, (ax,) = panels(["gain [1]"], "frequency [rad/s]", "log")
    line(ax, "loop", [0.1, 1, 10], [3, 2, 1])
    root = ElementTree.fromstring(svg_of(drawing))
    (panel,) = json.loads(root.get("data-curves"))
    (corners,) = coordinates(root)
    low, high = panel["x"]
    parts = [(x - panel["left"]) / (panel["right"] - panel["left"]) for x, _ in corners]
    assert [low * (high / low) ** part for part in parts] == pytest.approx([0.1, 1, 10], rel=1e-3)  # 2 decimals of 468
    assert panel["logx"]
    assert root.findall(f".//{SVG}g[@id='line-0-0-{root.find(f'{SVG}title').get('id')[1:]}']")


def test_colours_are_the_pages_own_and_letters_stay_text():
    picture = svg_of(drawn(([0, 1], [0, 1]), ([0, 1], [1, 0]), label="pitch ψ [rad]"))
    assert "var(--c0)" in picture
    assert "var(--axis)" in picture
    assert not any(colour in picture for colour in COLOURS)
    assert "pitch ψ [rad]" in [text.text for text in ElementTree.fromstring(picture).iter(f"{SVG}text")]


def test_a_number_on_a_page_is_the_number_of_the_drawing():
    drawing, (ax,) = panels(["y [m]"])
    ax.set(ylim=(0, 0.0155), ylabel="0.12345 m")
    drawing.draw_without_rendering()
    named = {text.get_text() for text in ax.get_yticklabels() if 0 <= text.get_position()[1] <= 0.0155}
    letters = {text.text for text in ElementTree.fromstring(svg_of(drawing)).iter(f"{SVG}text")}
    assert {"0.12345 m", *named} <= letters
    assert "0.005" in letters


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


RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"


def value_of(text):
    """The number that a tick says."""
    plain = text.replace("−", "-").replace("\u00a0", " ")
    power = re.fullmatch(rf"(-?)(?:([\d.]+) · )?10([{RAISED}]+)", plain)
    if not power:
        return float(plain)
    sign, mantissa, exponent = power.groups()
    return float(f"{sign}{mantissa or 1}e{exponent.translate(str.maketrans(RAISED, '0123456789-'))}")


RANGES = [(0, 1), (-0.013, 0.11), (3e5, 9e5), (-2e-7, 1e-7), (99.9, 100.1), (0, 0.0155)]


@pytest.mark.parametrize(("low", "high"), RANGES)
def test_ticks_are_named_as_numbers_that_differ(low, high):
    _, (ax,) = panels(["y [m]"])
    ax.set_ylim(low, high)
    texts = [text.get_text() for text in ax.get_yticklabels()]
    assert len(set(texts)) == len(texts) >= 2
    values = [value_of(text) for text in texts]
    assert values == pytest.approx(ax.get_yticks()[: len(values)].tolist(), abs=1e-3 * (high - low))


def test_a_logarithmic_axis_names_numbers_and_no_logarithms():
    _, (ax,) = panels(["y [1]"], x_scale="log")
    ax.set_xlim(0.05, 200)
    assert {"0.1", "1", "10", "100"} <= {text.get_text() for text in ax.get_xticklabels()}
    assert number(2e-7) == "2\u00a0·\u00a010⁻⁷"
    assert number(-1e6) == "−10⁶"
    assert [number(value, 4) for value in (1e4, 25_000, -99_990, 1e5)] == ["10000", "25000", "−99990", "10⁵"]
    assert number(1250, 3) == "1250"
    ax.set_yscale("log")
    numbered(ax.yaxis)
    ax.set_ylim(0.5, 4)  # less than a power of ten: the ticks between are named too
    assert {"1", "2"} <= {t.get_text() for t in (*ax.get_yticklabels(), *ax.get_yticklabels(minor=True))}


def test_lines_differ_by_dashes_too_and_keep_their_style_in_every_panel():
    _, (left, right) = panels(["l [V]", "r [V]"])
    for name in "ab":
        line(left, name, [0, 1], [0, 1])
    line(right, "b", [0, 1], [0, 1])
    a, b, again = (*left.lines, *right.lines)
    assert a.get_color() != b.get_color() == again.get_color()
    assert a.get_linestyle() != b.get_linestyle() == again.get_linestyle()


def test_the_unit_circle_is_round_and_poles_stand_where_they_are():
    drawing = circle([1.0], [1j])
    drawing.draw_without_rendering()
    (ax,) = drawing.axes
    centre, east, north = (ax.transData.transform(p) for p in ((0, 0), (1, 0), (0, 1)))
    assert east[0] - centre[0] == pytest.approx(north[1] - centre[1], rel=1e-6)
    assert [(line.get_xdata()[0], line.get_ydata()[0]) for line in ax.lines] == [(1, 0), (0, 1)]


def test_numbers_are_rounded_as_readers_round():
    """Python takes a half to the even neighbour."""
    assert [number(x, 2) for x in (58.5, 57.5, -58.5, 0.125)] == ["59", "58", "−59", "0.13"]


def test_a_bench_takes_of_tied_controllers_the_one_with_the_least_effort():
    """a and b are within the 3 % of a place, c is not; the worse side counts: 0.29 N s of a, 0.295 N s of b."""
    rows = [
        BenchRow(controller=name, push=push, outcome="yes", peak=0.1, effort=effort, impulse=size, spread=falls)
        for name, effort, size, falls in (("a", 5.0, 0.29, 0.01), ("b", 9.0, 0.295, 0.0), ("c", 1.0, 0.2, 0.0))
        for push in ("front, 0.1 rad", "back, -0.12 rad")
    ]
    logs = {(row.controller, row.push): run() for row in rows}
    bench = Bench(robot="r", kit="k", body="twin", seed=0, rows=tuple(rows), logs=logs)
    page = bench.page()
    assert bench.take == bench.to_json()["take"] == "a"
    assert (str(page.verdict.text), page.verdict.level) == ("take a", "good")
    # of 2 falls in 200, 95 % one-sided (Clopper and Pearson): 3.1 %; a bound is rounded up
    numbers = [str(number.value).replace("\u00a0", " ") for number in page.numbers]
    assert numbers == ["0.29 N s", "at most 3.2 %", "5 V² s"]


def test_mistakes_are_reported():
    with pytest.raises(ValueError, match="a row of 1 cells under 2 columns"):
        Table([Column(Say("number")), Column(Say("middle"))], [["x"]])
    with pytest.raises(InvalidLog, match="line 'a' has 2 x and 1 y"):
        drawn(([0, 1], [0]))


def test_ratios_of_coefficients_keep_their_slash():
    assert [term(name).template for name in ("weight_moment/a22", "a22/a11", "delay/gyro", "fleet.com_height")] == [
        "weight moment/a22", "a22/a11", "gyro delay", "centre of mass height",
    ]  # fmt: skip


def test_a_design_tells_its_weights_and_gains():
    """Bryson's rule: a pitch of 0.15 rad costs 1 (`LARGEST_STATE`)."""
    result = designed("lqg")
    K = design_of(result.controller).gain
    first = result.weights[0]
    assert (first.name, first.unit, first.size) == ("pitch", "rad", pytest.approx(0.15))
    assert [list(weight.gain) for weight in result.weights] == [list(column) for column in K.T]
    assert result.weights[6].name == "sent_1/left"  # the dead time of nxt is within one period


def designed(method, period=None):
    """A design without its analysis, which takes longer."""
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    return Designed(method, robot, kit, make_controller(method, robot, kit, period or kit.period), None)


@pytest.mark.parametrize("period", [0.0085, 0.004])
def test_a_design_of_any_period_is_let_go(period):
    """8.5 ms is no multiple of a body's usual millisecond."""
    run_ = designed("lqg", period).let_go()
    assert np.diff(run_.log.t) == pytest.approx(period)
    assert run_.upright < 3.0  # as every 10 ms, 1.3 s, but for noise
    assert run_.fell_at is None


@pytest.mark.parametrize("method", ["lqr", "lqi", "pid", "hinf", "sliding", "mpc"])
def test_every_method_shows_what_it_was_found_by(method):
    weights = designed(method).to_json()["weights"]
    assert weights
    numbers = [number for weight in weights for number in (weight["size"], *weight["gain"])]
    assert all(number is None or math.isfinite(number) for number in numbers)
    assert all(weight["unit"] for weight in weights)
