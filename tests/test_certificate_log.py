"""What a certificate says beside a log: of which controller, and of which numbers."""

from __future__ import annotations

import dataclasses
import math
from functools import cache
from importlib import import_module
from pathlib import Path

import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.certification.certificate import certify
from upright.control import controller_hash, make_controller, write_controller
from upright.errors import InvalidLog
from upright.experiment import Drive, run
from upright.likelihood.calibrated import Learnt
from upright.logs.raw import raw_log
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty
from upright.signals import Log

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
FLOWN = make_controller("lqg", ROBOT, KIT, KIT.period)
SHARED = Path(__file__).resolve().parents[2] / "shared"


@cache
def a_log() -> Log:
    log = run(Electronics(NonlinearBody(ROBOT), KIT), FLOWN, [], reference=[Drive(speed=0.1, start=1.0)], seconds=4.0)
    return Log(log.t, {n: log[n] for n in log.channels if n.startswith(("sensor/", "command/"))})


@pytest.mark.parametrize("by_name", [True, False])
def test_a_name_beside_a_log_is_no_new_controller_in_the_name_of_the_old(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, *, by_name: bool
) -> None:
    """The log shows slower sensors and a taller body: LQG would be another controller for them, which never flew."""
    slow = {n: dataclasses.replace(s, delay=s.delay + 0.01) for n, s in KIT.sensors.items()}
    tall, late = ROBOT.replace(com_height=1.1 * ROBOT.com_height), dataclasses.replace(KIT, sensors=slow)
    own = Learnt(tall, late, Uncertainty.of(tall).scaled(0.1))
    monkeypatch.setattr(import_module("upright.likelihood.calibrated"), "calibrated", lambda *_: (own, ()))
    asked = "lqg" if by_name else str(write_controller(FLOWN, tmp_path / "flown.json"))
    given = certify(asked, "nxtway-gs", samples=100, sweeps=False, log=a_log())
    assert given.hash == controller_hash(FLOWN)
    assert controller_hash(make_controller("lqg", tall, late, KIT.period)) != given.hash  # so that it could be told
    assert ("Certified is `upright design lqg`: if another controller flew" in " ".join(str(given).split())) is by_name


@pytest.mark.evidence
@pytest.mark.needs("shared/cases/late-loop")
def test_a_robot_that_falls_with_what_flew_is_red_by_its_name_too() -> None:
    """Commands that act 22 ms late: 12 of 12 simulations fall, and so did its file. Five seconds of it tell."""
    log = Log.load(SHARED / "cases" / "late-loop" / "run.csv").between(0.0, 5.0)
    given = certify("hinf", "ev3way", samples=100, sweeps=False, log=log)
    assert given.light == "red"
    assert given.reasons[0].kind == "loop"


@pytest.mark.evidence
@pytest.mark.needs("shared/data/twipr/run2_all.csv")
def test_a_robot_that_lies_and_then_balances_is_followed_where_it_balances() -> None:
    """The doctor finds it balancing from 12.1 s on; `calibrate` a level floor (-.03°, -.14 to .07)."""
    log = raw_log(SHARED / "data" / "twipr" / "run2_all.csv").between(9.0, 18.0)
    given = certify("lqg", "twipr", samples=100, sweeps=False, log=log)
    (floor,) = (s for s in given.support if s.name == "slope")
    assert abs(math.degrees(floor.value)) < 0.2
    assert not any("slope" in t.push for t in given.trials)
    assert "slope" not in " ".join(map(str, given.reasons))


@pytest.mark.needs("shared/data/twipr/new_dive_1_all.csv")
def test_too_little_on_its_wheels_is_told_as_that() -> None:
    """It balances and falls from 4.36 to 6.95 s of 9.6 s; what lies before was once read as a slope of -4°."""
    with pytest.raises(InvalidLog, match=r"lasts 2\.6 s.*on its wheels"):
        certify("lqg", "twipr", samples=100, sweeps=False, log=SHARED / "data" / "twipr" / "new_dive_1_all.csv")
