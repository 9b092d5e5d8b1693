"""What the lesson says that one will see: its numbers, from the equations and from runs."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.control import CONTROLLERS, gain_of, lqg
from upright.experiment import Impulse, outcome_of
from upright.experiment import run as simulate
from upright.lab.handin import HandIn, RunResult
from upright.lab.messages import Setup, Strike
from upright.lab.rerun import rerun
from upright.physics.linear import unstable_pole
from upright.robots import Kit, Robot

DOCS = Path(__file__).resolve().parents[1] / "docs"
ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
NOTHING = RunResult(fell=False, seconds=0.0, peak=0.0, travel=0.0, best=0.0)
USUAL = Setup(bodies=("nonlinear",))


def run(setup: Setup = USUAL, *actions: Any, lean: float = 0.0, seconds: float = 8.0) -> RunResult:
    done = HandIn(student="a", setup=setup, step=0.01, lean=lean, seconds=seconds, actions=actions, claimed=NOTHING)
    return rerun(done)


def knock(size: float) -> tuple[float, Strike]:
    return 1.0, Strike("impulse", size)


def test_a_lean_twice_as_large_falls_a_doubling_time_earlier():
    """From the equations: ln 2 over the unstable pole; a run's time is counted in periods of 0.01 s."""
    doubling = math.log(2) / unstable_pole(ROBOT)
    assert doubling == pytest.approx(0.093, abs=0.0005)
    assert unstable_pole(ROBOT) == pytest.approx(7.44, abs=0.005)
    times = [run(replace(USUAL, controller="off"), lean=lean).seconds for lean in (0.01, 0.02, 0.04)]
    assert [a - b for a, b in pairwise(times)] == pytest.approx([doubling] * 2, abs=0.011)
    assert math.exp(0.2 * unstable_pole(ROBOT)) > 4  # a person's reaction


def test_each_gain_of_zero_does_what_the_table_says():
    gains = gain_of(CONTROLLERS["lqr-state"](ROBOT, KIT, KIT.period))[0]

    def without(state: int) -> RunResult:
        left = tuple(0.0 if i == state else float(k) for i, k in enumerate(gains))
        return run(replace(USUAL, controller="gains", gains=left), knock(0.05), seconds=12.0)

    pitch, pitch_rate, wheel, wheel_rate = map(without, range(4))
    assert pitch.fell
    assert pitch.seconds < 3.0  # less than two seconds after the knock
    assert not pitch_rate.fell
    assert pitch_rate.best == 0.0  # it never comes to rest
    assert wheel_rate.fell
    assert 1.8 < wheel_rate.seconds < 2.4  # a second after the knock
    assert not wheel.fell
    assert wheel.best > 0  # it recovers
    assert wheel.travel > 0.1  # [m], and is not where it was


def test_the_largest_knock_is_between_those_that_are_named():
    assert not run(USUAL, knock(0.32)).fell
    assert run(USUAL, knock(0.34)).fell


@pytest.mark.parametrize(("delay", "falls"), [(0.002, False), (0.05, True)])
def test_a_delay_that_the_controller_does_not_know_takes_a_knock_from_it(delay, falls):
    """As in the exported page, which keeps the controller that was designed for the kit."""
    body = Electronics(NonlinearBody(ROBOT, period=0.002), replace(KIT, delay=delay))
    push = Impulse(impulse=0.25, start=1.0, duration=0.02)
    assert outcome_of(simulate(body, lqg(ROBOT, KIT, KIT.period), push, seconds=4.0)).fell is falls


def test_on_a_slope_it_leans_as_statics_says():
    """M L sin(ψ − γ) = (M + 2m) R sin γ (docs/conventions.md)."""
    slope = 0.1
    ratio = (ROBOT.body_mass + 2 * ROBOT.wheel_mass) * ROBOT.wheel_radius / (ROBOT.body_mass * ROBOT.com_height)
    assert slope + math.asin(ratio * math.sin(slope)) == pytest.approx(0.16, abs=0.005)
    assert run(replace(USUAL, slope=slope), seconds=12.0).travel == pytest.approx(0.36, abs=0.06)  # and swings beyond


def test_both_languages_have_the_same_hour():
    spanish, english = ((DOCS / f"lesson.{key}.md").read_text("utf-8") for key in ("es", "en"))
    for pattern in (r"#\S*", r"\d+[.,]\d+", r"^## \d+ \w+ \d+", r"^\|", r"^\*\*"):
        found = [len(re.findall(pattern, text, re.MULTILINE)) for text in (spanish, english)]
        assert found[0] == found[1], pattern
    numbers = [sorted(re.findall(r"\d+[.,]\d+", text.replace(",", "."))) for text in (spanish, english)]
    assert numbers[0] == numbers[1]
