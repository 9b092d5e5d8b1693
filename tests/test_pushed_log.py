"""A log that does not hold what moved its robot tells neither inertias nor the pole, and no file is written of it."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from conftest import SHARED
from planted.foreign import Bot, Course, known, logged, metric
from test_calibrate import short_calibration
from upright.calibration.calibrate import _unknown
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import PRIOR, VISIBLE
from upright.calibration.knocks import Knocks, without_knocks
from upright.calibration.summary import untold
from upright.cli.main import main
from upright.logs.mapping import apply, propose
from upright.pages import Say, html
from upright.robots import find_kit
from upright.signals import Log

BOT = Bot()
SHOVE = 1.5 * BOT.body  # [N] for 50 ms: 0.075 m/s, a soft tap with a finger
BLOWS = [(2.0, 2.05, SHOVE), (4.0, 4.05, -SHOVE), (6.0, 6.05, SHOVE)]


def of_another_simulator(seed: int, *, pushed: bool) -> Log:
    course = Course(held=0.5, excitation=0.0 if pushed else 1.2, pushes=BLOWS if pushed else ())
    table = metric(logged(BOT, course, seed=seed), BOT)
    return apply(propose(table), table)


def test_soft_pushes_are_found_and_a_dither_is_none() -> None:
    seed = 811
    robot = known(BOT)
    kit = find_kit(robot.kit)
    _, (note,) = without_knocks([of_another_simulator(seed, pushed=True)], robot, kit, cut=False)
    assert note.used is None
    assert note.times == pytest.approx([0.5 + start for start, *_ in BLOWS], abs=0.05)  # which is how long each lasts
    assert without_knocks([of_another_simulator(seed, pushed=False)], robot, kit, cut=False)[1] == []


@pytest.mark.evidence
@pytest.mark.needs("shared/cases/hand-pushed")
def test_a_log_with_pushes_by_hand_writes_no_robot(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """True pole 7.19 1/s: 5.96 (5.66 to 6.26) was measured, and written."""
    case, output = SHARED / "cases" / "hand-pushed", tmp_path / "robot.toml"
    named = [f"--{n}={case / f}.toml" for n, f in (("robot", "mine2"), ("kit", "nano"), ("mapping", "m"))]
    assert main(["calibrate", str(case / "p2.csv"), *named, "-o", str(output), "--json"]) == 3
    said = json.loads(capsys.readouterr().out)
    assert not output.exists()
    assert said["decision"]["verdict"] == said["head"]["verdict"]["level"] == "unknown"
    assert "upright excite" in said["head"]["next"][0]
    every = [e["verdict"] for group in ("parameters", "combinations", "delays") for e in said[group]]
    assert VISIBLE not in every


def fitted() -> Calibration:
    return short_calibration()[0]


@pytest.mark.parametrize(("delay", "told"), [(-4e-3, False), (-1e-4, True), (4e-3, True)])
def test_a_dead_time_is_not_negative(delay: float, told: bool) -> None:
    """Of 0.5 ms of standard deviation −4 ms is eight below zero, and −0.1 ms none."""
    late = next(e for e in fitted().delays if e.name == "delay/encoder")
    delays = (replace(late, value=delay, low=delay - 1e-3, high=delay + 1e-3),)
    why = _unknown(replace(fitted(), delays=delays), [], [], cut=False)
    assert (why is None) == told
    assert told or "below zero" in str(why[0])


def test_what_cannot_be_told_accuses_no_robot() -> None:
    """Not even where a fit beside softer pushes came out as of another robot."""
    refused = replace(fitted(), refused=(Say("The log is of another robot."),))
    knocked = [Knocks((3.0,), length=10.0, used=9.0, enough=True)]
    assert _unknown(fitted(), [], knocked, cut=True) is None
    why = _unknown(refused, [], knocked, cut=True)
    assert why
    found = untold(refused, why)
    page = found.page()
    assert "another robot" not in f"{html.document(page)}{found}{found.to_json()}"
    assert found.decision.withheld
    assert page.verdict.level == "unknown"


@pytest.mark.needs("shared/data/regbot/balance_rest.txt")
def test_a_faster_controller_is_not_told_from_its_slow_log() -> None:
    from upright.logs.raw import raw_log

    why = _unknown(fitted(), [raw_log(SHARED / "data" / "regbot" / "balance_rest.txt")], [], cut=False)
    assert why
    assert "lacks commands" in str(why[0])


@pytest.mark.parametrize(("verdict", "withheld"), [(PRIOR, True), (VISIBLE, False)])
def test_a_number_that_the_fit_moves_and_the_log_does_not_see_is_not_written(verdict: str, withheld: bool) -> None:
    """Four deviations of its file's guess off: seen, it is measured, and doubtful; unseen, it makes up for another."""
    mass, *rest = fitted().parameters
    bent = replace(fitted(), parameters=(replace(mass, verdict=verdict, shift=4.0, shrink=0.7, guess=True), *rest))
    assert bent.decision.against
    assert bent.decision.withheld == withheld
    assert "mass" in str(bent.decision.why)


@pytest.mark.evidence
@pytest.mark.needs("shared/data/ev3way")
def test_wheels_of_a_kilogram_each_are_not_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The whole robot of this log weighs 0.777 kg (its file's source)."""
    log, written = SHARED / "data" / "ev3way" / "nn_v6_001.csv", tmp_path / "mine.toml"
    assert main(["calibrate", str(log), "--robot", "ev3way-large-wheels", "-o", str(written)]) == 3
    assert not written.exists()
    assert "wheel mass" in capsys.readouterr().err
