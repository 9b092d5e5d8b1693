"""A robot of one's own in the paper's experiment: the model that made a log reproduces it, and what was planted is what
must be adjusted."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path

import pytest

import upright as up
from heads import shown_alike
from upright.cli.main import main
from upright.comparison.comparison_page import fit_verdict
from upright.comparison.drawing import state_words
from upright.control import Estimated, kalman, lqr_state
from upright.pages import Say, Verdict
from upright.paper.own_log import CALIBRATED, compare_own
from upright.paper.own_trial import LINEAR, NONLINEAR
from upright.robots import Kit, Robot

FILE, KIT = Robot.preset("nxtway-gs"), Kit.preset("ideal")
TRUE = FILE.replace(com_height=1.2 * FILE.com_height)
"""The robot that was built is a fifth higher than its file says."""


@cache
def log_of(robot: Robot) -> up.Log:
    """Pushed at 0.5 s by 3 N for 50 ms, under the regulator of the file, which reads the true state."""
    push = up.Push(force=3.0, start=0.5, duration=0.05)
    return up.run(up.NonlinearBody(robot), lqr_state(FILE, 0.01), push, seconds=4.0)


def test_the_model_that_made_a_log_reproduces_it() -> None:
    result = compare_own(log_of(FILE), FILE, learnt=FILE)
    # the same equations in steps of 10 ms instead of 1 ms
    assert all(result.comparison.fits[NONLINEAR][name] > 99.5 for name in ("pitch", "pitch_rate", "wheel"))
    assert result.settling[NONLINEAR] == pytest.approx(result.settling["robot"], abs=0.005)
    assert result.side == "back"  # a push from behind is positive
    assert "3 N from 0.5 s" in str(result.push).replace("\u00a0", " ")
    assert "lqr" in str(result.law)
    assert result.page().verdict == fit_verdict(state_words("pitch"), 95.0)
    assert result.comparison.fits[LINEAR]["pitch"] > 95  # 0.1 rad: its sine is 0.2 % less


def test_what_was_planted_is_what_must_be_adjusted() -> None:
    result = compare_own(log_of(TRUE), FILE, learnt=TRUE)
    measured = result.settling["robot"]
    assert abs(result.settling[NONLINEAR] - measured) > 0.02  # two rows
    assert result.adjusted[0].name == "com_height"
    assert result.adjusted[-1].settling == pytest.approx(measured, abs=0.01)
    assert result.comparison.fits[CALIBRATED]["pitch"] > 90  # with the file's kit: 2 ms and steps that this log had not
    assert "centre of mass height" in str(result.page().lead[-1])
    assert result.page().next[0].verb == "calibrate"


def test_a_log_that_teaches_nothing_is_followed_by_a_plan_for_one_that_does() -> None:
    result = compare_own(log_of(FILE), FILE, learnt=FILE)
    assert result.page().next[0].verb == "excite"


def test_a_log_of_another_program_says_neither_law_nor_push() -> None:
    """They are given: the push as of the command line, and the law is read from its readings."""
    log = log_of(FILE)
    channels = {n.replace("truth/", "estimate/"): x for n, x in log.channels.items() if not n.startswith("push/")}
    foreign = up.Log(log.t, channels, {n.replace("truth/", "estimate/"): u for n, u in log.units.items()})
    result = compare_own(foreign, FILE, push=[up.Push(force=3.0, start=0.5, duration=0.05)], learnt=FILE)
    assert "read from the log" in str(result.law)
    assert result.comparison.fits[NONLINEAR]["pitch"] > 99
    alone = compare_own(foreign, FILE, learnt=FILE)
    assert "no push" in str(alone.push)
    assert alone.comparison.fits[NONLINEAR]["pitch"] < 50  # a robot at rest that nobody pushes
    assert alone.page().verdict == Verdict(Say("push unknown"), "unknown")  # so a poor fit is no fault of the model
    assert alone.page().next[0].options["push"]


def test_the_command_writes_page_numbers_and_logs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, folder = log_of(TRUE).save(tmp_path / "run.parquet"), tmp_path / "out"
    mine = TRUE.save(tmp_path / "mine.toml")
    command = ["reproduce", "--log", str(path), "--robot", "nxtway-gs", "--calibrated", str(mine), "-o", str(folder)]
    assert main(command) == 0
    page, numbers = (folder / "report.html").read_text(), json.loads((folder / "results.json").read_text())
    assert "Figures 12 and 13 again" in page  # of the push on the back
    assert numbers["adjusted"][0]["name"] == "com_height"
    shown_alike(compare_own(log_of(TRUE), FILE, learnt=TRUE))
    assert math.isfinite(numbers["settling"]["robot"])
    assert len(list((folder / "logs").iterdir())) == 4
    capsys.readouterr()
    assert main(["reproduce", "--robot", "nxtway-gs"]) == 2
    assert main(["reproduce", "--log", str(path)]) == 2
    assert "--robot" in capsys.readouterr().err


def test_a_log_whose_law_nobody_knows_is_refused() -> None:
    kit = Kit.preset("nxt")
    controller = Estimated(lqr_state(FILE, 0.01), kalman(FILE, kit))
    log = up.run(up.Electronics(up.NonlinearBody(FILE), kit), controller, seconds=2.0, start=(0.05, 0, 0, 0, 0, 0))
    sensors = {n: x for n, x in log.channels.items() if n.startswith(("sensor/", "command/", "applied/"))}
    with pytest.raises(up.errors.InvalidLog, match="--controller"):
        compare_own(up.Log(log.t, sensors, log.units), FILE, learnt=FILE)
