"""What a post-mortem may say: sizes that sensors have, facts that are facts, and numbers that its falls bear out."""

from __future__ import annotations

import math
from typing import Any

import pytest

from conftest import SHARED
from planted.foreign import turning as bench
from upright.cli.main import main
from upright.diagnose import post_mortem
from upright.diagnose.causes import CANNOT_TELL, DEAD, LOW, NONE, OFF, PUSH, SCALED, Cause
from upright.diagnose.fault_fits import FaultFit
from upright.diagnose.remedy import Window
from upright.diagnose.sizes import natural, possible
from upright.diagnose.verdict import BORNE_OUT, PAIR, UNFINISHED, stated

CASES = SHARED / "cases"


@pytest.mark.needs("shared/cases/weak-gain")
def test_a_robot_that_is_let_go_with_too_little_gain_falls_by_its_loop() -> None:
    """It fell for 0.7 s, so that its gyro's mean is what it turned: an offset of −2 rad/s was 87 % likely. The log's
    own offset is −0.002 rad/s, and the loop's pole, computed apart from this project, +6.08 1/s."""
    found = post_mortem(CASES / "weak-gain" / "log.csv", CASES / "weak-gain" / "robot.toml")
    assert found.verdict == LOW, str(found)
    told = found.causes[0].evidence.facts["doubles"].value
    assert told == pytest.approx(math.log(2) / 6.08, rel=0.1)  # a gain by least squares
    assert not any("gyro" in cause.name for cause in found.causes)
    assert found.onset >= 0.0, "before the log begins"


@pytest.mark.evidence
def test_what_the_floor_does_is_not_usual() -> None:
    """A log of 0.8 s and 1.3 s on the floor was "of another robot", since most of its rows lie there."""
    case = bench.fall("F", "let-go", 41)
    assert case is not None
    assert case.fell_at < 1.0  # no second before the fall, in which anything is usual
    found = post_mortem(case.log, case.file)
    assert found.verdict == LOW, str(found)


HALF = [CASES / "half-gyro" / f"known_1_5_gyro_scale.{end}" for end in ("csv", "toml")]


@pytest.mark.evidence
@pytest.mark.needs("shared/cases/half-gyro")
def test_a_gyro_at_half_of_its_scale_is_no_load() -> None:
    """It was "a load of about 3 kg that was added", 87 %: a scale that is no power of two is rare, and this is one."""
    found = post_mortem(*HALF)
    assert found.verdict == SCALED, str(found)
    assert found.causes[0].evidence.facts["fault"].facts["size"].value == pytest.approx(0.5, rel=0.05)


@pytest.mark.needs("shared/cases/half-gyro")
def test_a_search_that_has_no_time_says_what_is_known_and_that_it_is_not_finished() -> None:
    soon = post_mortem(*HALF, seconds=0.0)
    assert soon.causes[0].likelihood <= UNFINISHED
    assert "--seconds" in str(soon.notes[0])
    assert not soon.check()


@pytest.mark.needs("shared/data/ev3way")
def test_a_controller_that_puts_out_about_nothing_was_not_switched_off() -> None:
    """Its commands are 0 for rows on end while it balances, and "motors off" was 98 % likely."""
    found = post_mortem(SHARED / "data" / "ev3way" / "nn_v16_002.csv", "ev3way")
    assert found.verdict != OFF, str(found)


def test_an_offset_that_no_gyro_has_is_no_fault() -> None:
    """75 degrees per second are the most of a common gyro's data sheet (L3GD20), at once or in the end."""
    for way, size, met in (("step", 1.2, True), ("step", -2.0, False), ("ramp", 1.2, True), ("ramp", 2.0, False)):
        assert possible(FaultFit(fault="bias", way=way, onset=2.0, size=size), 3.0) == met


def test_a_range_or_a_decoding_that_is_set_wrongly_is_natural() -> None:
    """250 for 500 degrees per second, one count for two or four, and both the other way round."""
    for shows, is_one in (
        (0.5, True),
        (2.0, True),
        (0.25, True),
        (4.0, True),
        (1.0, False),
        (0.3, False),
        (1.5, False),
    ):
        assert natural(FaultFit(fault="scale", way="gyro", size=1 - shows)) == is_one
    assert not natural(FaultFit(fault="payload", size=0.5))
    assert not natural(FaultFit(fault="scale", way="gyro", size=2.0))  # of the other sign


def said(*odds: tuple[str, float]) -> tuple[Cause, ...]:
    return tuple(Cause(name, likelihood, 1.0, "") for name, likelihood in odds)


def test_no_verdict_is_said_above_what_its_kind_bears_out() -> None:
    for name, most in ((PUSH, BORNE_OUT[PUSH]), (NONE, BORNE_OUT[NONE]), (f"{DEAD} and {PUSH}", PAIR)):
        causes = stated(said((name, 0.88), (LOW, 0.08), (CANNOT_TELL, 0.04)), unfinished=False)
        assert [cause.name for cause in causes] == [name, LOW, CANNOT_TELL]
        assert causes[0].likelihood == most
        assert sum(cause.likelihood for cause in causes) == pytest.approx(1.0)
        assert causes[1].likelihood / causes[2].likelihood == pytest.approx(2.0)  # what is left is shared as before
    named = said((DEAD, 0.88), (CANNOT_TELL, 0.12))
    assert stated(named, unfinished=False) == named
    assert stated(named, unfinished=True)[0].likelihood == UNFINISHED
    fact = said((OFF, 0.98), (CANNOT_TELL, 0.02))  # no search is needed for it
    assert stated(fact, unfinished=True) == fact


def test_a_bank_is_kept_by_its_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """By the number of a run that was gone another run had its bank."""
    window, made = Window(3.0, 1.0, 1.0), list[Any]()
    monkeypatch.setattr(Window, "bank", lambda _self, run, **_: made.append(run) or object())
    usual: Any = object()
    first, second = (FaultFit(fault="bias", run=run) for run in (object(), object()))  # type: ignore[arg-type]
    assert window.beside(first, usual) is window.beside(first, usual)
    assert window.beside(first, usual) is not window.beside(second, usual)
    assert list(window.banks) == [first.run, second.run] == made


def test_a_time_that_is_none_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["post-mortem", "log.csv", "--time-limit", "-1"]) == 2
    assert "--time-limit" in capsys.readouterr().err
