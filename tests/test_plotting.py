"""Figures of results: every axis is named with its unit, and what is drawn are the result's own numbers."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure

from upright.calibration.calibration import Calibration
from upright.calibration.estimate import VISIBLE, Estimate
from upright.comparison import compare
from upright.control import lqr_state
from upright.loops.analysis import Analysis, analyse
from upright.plotting import bars, intervals, panels
from upright.robots import Kit, Robot
from upright.robots.drawing import filmstrip, labelled
from upright.signals import STATE_NAMES, Log

NXT = Robot.preset("nxtway-gs")


def run(size: float) -> Log:
    t = np.linspace(0.0, 2.0, 21)
    return Log(t, {f"truth/{name}": size * np.exp(-t) for name in STATE_NAMES})


def estimate(name: str, prior_spread: float) -> Estimate:
    return Estimate(name=name, unit="kg", value=3.0, low=2.0, high=4.5, prior=2.0, prior_spread=prior_spread,
                    verdict=VISIBLE, shift=2.0, shrink=0.5)  # fmt: skip


def calibration() -> Calibration:
    return Calibration(
        robot=NXT, prior=NXT, parameters=(estimate("body_mass", 0.5), estimate("exact", 0.0)), combinations=(),
        delays=(), names=("body_mass",), covariance=np.eye(1), noise={}, whiteness=(), fits={}, segments={}, temper=1.0,
        samples=10, seconds=1.0,
    )  # fmt: skip


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyse(lqr_state(NXT, 0.01), NXT, Kit.preset("ideal"))


def named(figure: Figure) -> bool:
    """Whether every y has a name, and the shared x a name and a unit."""
    assert isinstance(figure, Figure)
    return all(ax.get_ylabel() for ax in figure.axes) and bool(re.search(r"\[.+\]$", figure.axes[-1].get_xlabel()))


def test_a_comparison_draws_each_state_of_each_log() -> None:
    figure = compare({"a": run(0.1), "b": run(0.2)}).plot()
    assert named(figure)
    assert {"pitch [°]", "wheel angle [°]", "pitch rate [°/s]"} <= {ax.get_ylabel() for ax in figure.axes}
    assert [line.get_label() for line in figure.axes[0].lines] == ["a", "b"]
    assert max(figure.axes[1].lines[1].get_ydata()) == pytest.approx(math.degrees(0.2))


def test_a_calibration_draws_estimates_against_the_prior() -> None:
    figure = calibration().plot()
    assert named(figure)
    (ax,) = figure.axes
    assert [tick.get_text() for tick in ax.get_yticklabels()] == ["body mass"]  # a prior without spread has no scale
    assert ax.lines[0].get_xdata().tolist() == [2.0]  # (3 − 2) kg over 0.5 kg
    assert ax.collections[0].get_segments()[0][:, 0].tolist() == [0.0, 5.0]  # (2 − 2) / 0.5 and (4.5 − 2) / 0.5


def test_what_must_be_positive_is_drawn_by_its_logarithm() -> None:
    mass = replace(estimate("body_mass", 0.5), scale="logarithm")  # half a kilogram of two: σ is a quarter of e
    (ax,) = replace(calibration(), parameters=(mass,)).plot().axes
    assert ax.lines[0].get_xdata()[0] == pytest.approx(4 * np.log(3 / 2))
    assert ax.collections[0].get_segments()[0][:, 0] == pytest.approx([0.0, 4 * np.log(4.5 / 2)])


def test_an_analysis_draws_bode_on_logarithmic_axes(analysis: Analysis) -> None:
    figure = analysis.plot()
    assert named(figure)
    size, phase = figure.axes
    assert (size.get_xscale(), size.get_yscale(), phase.get_yscale()) == ("log", "log", "linear")
    omega, gain = size.lines[0].get_data()
    crossings = omega[:-1][np.diff(np.sign(np.log(gain))) != 0]
    # the grid has 400 points over four decades at most: neighbours differ by less than 3 %
    assert crossings[-1] == pytest.approx(analysis.both().crossover, rel=0.03)


def test_intervals_without_ends_are_not_drawn() -> None:
    figure = intervals(["a", "b"], [1.0, 2.0], [(0.5, 1.5), (np.nan, np.nan)], "unstable pole [1/s]", "method")
    assert named(figure)
    figure.draw_without_rendering()  # raises where an axis cannot be laid out


def test_panels_share_one_x() -> None:
    figure, axes = panels(["a [m]", "b [V]"], "frequency [Hz]", "log")
    assert named(figure)
    assert [ax.get_xscale() for ax in axes] == ["log", "log"]


def test_a_notebook_shows_tables() -> None:
    assert "<td>&lt;b&gt;</td>" in compare({"a": run(0.1), "<b>": run(0.2)})._repr_html_()


def test_nyquist_stays_out_of_the_circle_that_it_touches(analysis: Analysis) -> None:
    (ax,) = analysis.plot_nyquist().axes
    curve = np.asarray(ax.lines[0].get_xdata()) + 1j * np.asarray(ax.lines[0].get_ydata())
    (circle,) = ax.patches[:1]
    # Ms is found on a finer grid than the curve's 400 points over four decades
    assert np.nanmin(np.abs(curve + 1)) == pytest.approx(circle.get_width() / 2, rel=0.02)


def test_bars_are_as_long_as_their_numbers_and_what_is_not_known_has_none() -> None:
    figure = bars(["a", "b"], [2.0, np.nan], "falls [%]", "push")
    (ax,) = figure.axes
    assert [patch.get_width() for patch in ax.patches] == [2.0, 0.0]
    assert [text.get_text() for text in ax.texts] == ["2", "–"]


def test_a_filmstrip_puts_the_axle_where_the_wheels_have_rolled_and_the_body_at_its_pitch() -> None:
    t = np.array([0.0, 1.0])
    log = Log(t, {"truth/pitch": np.array([0.0, 0.3]), "truth/wheel": np.array([0.0, 2.0])})
    _, ax = filmstrip(NXT, log, [0.0, 1.0]).axes
    body, wheel = ax.patches[:2]
    rolled = 2.0 * NXT.wheel_radius
    assert wheel.get_center() == pytest.approx((rolled, NXT.wheel_radius))
    (left, right, *_), upper = body.get_xy()[:2], body.get_xy()[2:4].mean(axis=0)
    axle = (left + right) / 2
    assert axle == pytest.approx((rolled, NXT.wheel_radius))
    assert np.arctan2(*(upper - axle)) == pytest.approx(0.3)  # from the vertical, forwards


def test_the_labelled_robot_names_its_angles_and_lengths() -> None:
    side, top = labelled(NXT).axes
    words = " ".join(text.get_text() for text in (*side.texts, *top.texts))
    assert all(symbol in words for symbol in ("ψ", "θ", "φ", "L", "R", "W"))


def test_a_notebook_shows_a_figure_by_itself() -> None:
    """As a PNG with twice the dots of the size that it asks for, by the header of the file (ISO 15948, IHDR)."""
    figure = run(0.1).plot("truth/pitch")
    data, size = figure._repr_png_()  # type: ignore[attr-defined]
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    assert [int.from_bytes(data[k : k + 4], "big") for k in (16, 20)] == [2 * size["width"], 2 * size["height"]]
