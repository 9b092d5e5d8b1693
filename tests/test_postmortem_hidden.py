"""Falls that a gyro of another scale hides, and what a wheel that rests, a load beside a push and a wall are called."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from planted.foreign import Bot, Course, known, logged, metric
from upright.diagnose import blows, hidden
from upright.diagnose import evidence as gathering
from upright.diagnose.causes import WALL
from upright.diagnose.chances import holds
from upright.diagnose.clock import thinned
from upright.diagnose.facts import IDLE
from upright.diagnose.fall import Blocked, fall_time
from upright.diagnose.fault_fits import FaultFit, PushEstimate
from upright.diagnose.hidden import mis_scaled
from upright.diagnose.innovations import Signature, follow
from upright.diagnose.joint import _as_another
from upright.diagnose.pairs import _explained
from upright.diagnose.remedy import remedied
from upright.diagnose.resting import RESTS, held_wheel, weighed
from upright.diagnose.sizes import possible
from upright.diagnose.usual import window_of
from upright.logs.mapping import apply, propose
from upright.pages import Say
from upright.robots import Kit, Robot
from upright.signals import Log

NXT = Robot.preset("nxtway-gs")
SHOWS = 0.3


def test_a_fall_that_the_gyro_shows_a_third_of_is_found_by_the_gyro_s_scale(monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither the integrated gyro nor the filter that believes it leans by more than 0.4 rad: it did not fall, said the
    log. The scale is found to a third, as far as half a second of a robot known to a tenth shows it."""
    bot, several = Bot(), list[FaultFit]()
    columns = logged(bot, Course(free=5.5, pushes=((4.3, 4.4, 1.0),), scale=(4.0, SHOWS)), seed=1)
    rate = (columns["gyro"] - bot.offset) / np.where(columns["t"] >= 4.0, SHOWS, 1.0)
    lean = np.abs(np.cumsum(rate) * bot.period)
    run = thinned(follow(apply(propose(table := metric(columns, bot)), table), known(bot), Kit.preset("ideal")))
    assert fall_time(run) is None

    def recorded(*given: Any) -> list[FaultFit]:
        several.extend(mis_scaled(*given))
        return several

    monkeypatch.setattr(hidden, "mis_scaled", recorded)
    fell_at = hidden.unseen(run, window_of(run, float(run.t[-1])))
    assert fell_at is not None
    assert columns["t"][np.argmax(lean > 0.6)] < fell_at < columns["t"][np.argmax(lean > 1.25)]  # it leans, it lies
    (found,) = several
    assert 1 / (1 - found.size) == pytest.approx(SHOWS, rel=0.33)


def test_a_gyro_of_another_scale_may_keep_its_offset() -> None:
    """A gyro that shows a quarter of the motion and 0.02 rad/s at rest: times four, that is 0.08 rad/s of a robot at
    rest, unless what it shows at rest is taken for its offset."""
    t = np.arange(200) * 0.01
    motion, offset = np.sin(5 * t), 0.02
    gyro = np.where(t >= 1.0, 0.25, 1.0) * motion + offset
    fit = FaultFit(fault="scale", way="gyro", onset=1.0, size=1 - 4.0, more=(offset,))
    log = Log(t, {"sensor/gyro": gyro})
    run: Any = SimpleNamespace(log=log, rows=("sensor/gyro",), again=lambda sent, log, *_: log)
    freed: Any = remedied(run, fit)
    assert freed["sensor/gyro"] == pytest.approx(motion + offset)


def judged(*, noise: float, calm: float = 1.0) -> Any:
    """Pushes that leave a NIS of 0.88, in a log of such noise."""
    pushes = FaultFit(fault="none", score=149.0, nis=0.88)
    return SimpleNamespace(
        calm=calm, noise=noise, pushes_only=pushes, misfit=lambda fit: fit.nis, nats=lambda fit: fit.score
    )


def test_a_load_beside_a_push_is_judged_by_the_log_s_own_noise() -> None:
    """7674's pair: pushes leave less than the noise that the kit states, and half again as much as this log has."""
    load = FaultFit(fault="payload", size=-0.47, score=176.0, nis=0.58)
    assert holds(judged(noise=0.57), load) > 0.75
    assert holds(judged(noise=0.88), load) < 0.1  # pushes leave nothing either
    weaker = FaultFit(fault="payload", size=-0.47, score=150.0, nis=0.58)
    assert holds(judged(noise=0.57), weaker) < 0.1  # no more nats than pushes


def test_a_fault_that_pushes_explain_as_well_by_the_kit_s_noise_is_none_by_the_log_s_own() -> None:
    """A push of a foreign robot of 0.6 kg left a NIS of 0.7, since its file was 2 % off: a delay beside it left 0.4,
    and was named at 0.86, with a nat less than the push by the kit's noise."""
    evidence, delay = judged(noise=0.57), FaultFit(fault="delay", size=2.4, score=148.0, nis=0.58)
    evidence.nats = lambda fit: 40.0 if fit is delay else 0.0
    assert holds(evidence, delay) < 0.01


@pytest.mark.parametrize(("more", "share"), [(-20.0, 0.03), (-1.0, 0.45), (30.0, blows.MOST_SHARED)])
def test_a_push_shares_its_probability_with_a_load_that_explains_as_much(
    more: float, share: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of the loads that went beside a push (7673 and 7675) the planted numbers have 10 nats and 1 nat less than the
    push alone, which stood at 0.87. One cause stays likelier than two."""
    for name in ("blow", "of_push", "of_fault"):
        monkeypatch.setattr(blows, name, lambda *_: Say("none of these"))
    push = PushEstimate(4.0, 4.1, 0.5, 0.1, 90.0)
    load = FaultFit(fault="payload", onset=3.9, size=-0.2, score=100.0 + more, pushes=(push,))
    evidence: Any = SimpleNamespace(
        fits=(load,), pushes_only=FaultFit(fault="none", score=100.0), nats=lambda fit: fit.score, fell_at=4.8
    )
    alone, both = blows._with_load(evidence, 0.87, push, 0.3)
    assert (alone.name, both.name) == ("push too large", "load changed and push too large")
    assert (alone.probability, both.probability) == pytest.approx((0.87 * (1 - share), 0.87 * share), abs=0.01)
    assert ("explains about as much" in str(alone.evidence)) == (share > 0.1)


def test_what_takes_torque_is_searched_from_where_the_other_causes_of_that_were_found() -> None:
    """Dry friction of both wheels of a robot of 0.6 kg, 40 ms after a knock, was a weak battery: its search had begun
    at the wrong onset beside the wrong push, and left a NIS of 2.1. From those of the battery it leaves 0.5."""
    push = PushEstimate(4.67, 4.77, 0.09, 0.06, 50.0)
    run: Any = object()
    friction = FaultFit(fault="friction", way="both", onset=4.67, size=5.4, score=443.0, run=run)
    battery = FaultFit(fault="weak", way="pwm", onset=4.70, size=0.3, score=457.0, pushes=(push,), run=run)
    offset = FaultFit(fault="bias", way="step", onset=4.5, score=900.0, run=run)
    (start,) = _as_another(friction, [offset, battery, friction])
    assert (start.fault, start.size, start.onset, start.pushes) == ("friction", 5.4, 4.70, (push,))
    assert not _as_another(offset, [offset, battery, friction])


def test_no_scale_of_a_gyro_is_searched_where_pushes_leave_nothing_to_explain(monkeypatch: pytest.MonkeyPatch) -> None:
    """That search took 2 to 3 s of every log."""
    bot, searches = Bot(), list[float]()

    class Examined(Exception):
        pass

    def stop(*_: Any) -> None:
        raise Examined

    def search(_run: Any, window: Any) -> list[FaultFit]:
        searches.append(window.end)
        return []

    monkeypatch.setattr(gathering, "mis_scaled", search)
    monkeypatch.setattr(gathering, "sharpened", stop)
    for name in ("searched", "with_commands", "mis_scaled_angles"):
        monkeypatch.setattr(gathering, name, lambda *_: [])
    columns = logged(bot, Course(free=2.6, pushes=((2.0, 2.1, 9.0),), falls=True), seed=1)
    log = apply(propose(table := metric(columns, bot)), table)
    for searched in (0, 1):
        monkeypatch.setattr(gathering, "_unexplained", lambda *_, more=bool(searched): more)
        with pytest.raises(Examined):
            gathering.gather(log, replace(known(bot), kit="ideal"), Kit.preset("ideal"), None, lambda _: None)
        assert len(searches) == searched


def resting(turns: float) -> tuple[Any, dict[str, FaultFit]]:
    """Evidence of a left wheel that turns by so many radians from 1 s on, a dead motor 12 nats ahead of a jam."""
    t = np.arange(300) * 0.01
    log = Log(t, {"sensor/encoder_left": np.where(t < 1, 3 * t, 3 + turns * (t - 1) / 2)})
    evidence = SimpleNamespace(run=SimpleNamespace(log=log), fell_at=3.0, nats=lambda fit: fit.score)
    dead = FaultFit(fault="motor", way="left braked", onset=1.0, score=600.0)
    return evidence, {"motor": dead, "friction": FaultFit(fault="friction", way="left", onset=1.01, score=588.0)}


def test_of_a_wheel_that_rests_a_jam_and_a_dead_motor_are_both_said() -> None:
    """Two jammed wheels of another simulator crept by 0.05 and 0.07 rad, and were dead motors by 7 and 11 nats."""
    evidence, best = resting(0.07)
    assert held_wheel(evidence, best) == "left"
    weights = weighed(evidence, best, held=True)
    assert weights == pytest.approx({"motor": IDLE, "friction": 1 - IDLE})
    evidence, best = resting(3 * RESTS)  # let go before the robot lies, as by a motor without torque
    assert held_wheel(evidence, best) == ""
    assert weighed(evidence, best, held=False)["motor"] == pytest.approx(1 / (1 + np.exp(-12 / 6)))


def test_what_a_fault_explains_much_better_than_pushes_is_no_wall(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tyres that were lost (7691) held the wheels of a robot that drove at 0.09 m/s: 55 nats more than any pushes, and
    yet a wall at 0.95, since they left too much to be the cause."""
    push = PushEstimate(4.1, 4.28, -0.13, 0.01, 53.0)
    pushes = FaultFit(fault="none", score=158.0, nis=2.0, pushes=(push,))
    run = SimpleNamespace(log=None, robot=NXT)
    monkeypatch.setattr(blows, "blocked", lambda *_: Blocked(4.1, 0.086, 0.004))

    def wall(tyres: float) -> float:
        fit = FaultFit(fault="radius", onset=3.8, size=0.35, score=tyres, nis=1.5)
        evidence: Any = SimpleNamespace(
            run=run,
            fits=(fit, pushes),
            pushes_only=pushes,
            fell_at=4.8,
            calm=1.0,
            noise=1.4,
            misfit=lambda one: one.nis,
        )
        return sum(answer.probability for answer in blows.driven_into(evidence) if answer.name == WALL)

    assert wall(212.0) < 0.01
    assert wall(140.0) > 0.9


def test_a_load_as_heavy_as_the_body_does_not_go() -> None:
    """A search by the equations of motion ends at 0.95 of the body's mass: something else is needed there. A signature
    is linear, and may say a tenth more than all."""
    lost = FaultFit(fault="payload", onset=4.0, size=-0.95)
    assert possible(lost, 5.0)
    assert not possible(FaultFit(fault="payload", onset=4.0, size=-0.95, more=(0.3, 0.0)), 5.0)


def test_a_scale_that_is_nearly_right_fells_no_robot() -> None:
    """A gyro that showed 0.96 times the motion stood beside a push at 0.89, where a load had gone (7681)."""
    for shows, fells in ((0.96, False), (1.05, False), (0.7, True), (1.3, True)):
        assert possible(FaultFit(fault="scale", way="gyro", onset=4.0, size=1 - 1 / shows), 5.0) == fells


def test_an_offset_and_a_drift_are_second_causes_of_their_own() -> None:
    """A drift explained more at first beside a battery at 4 % than the offset that was there, which the search by the
    filter then never saw (7677)."""
    rng = np.random.default_rng(1)
    values = rng.normal(size=(3, 60))
    ways = (("bias", "step"), ("bias", "ramp"), ("motor", "both"))
    several = [Signature(fault=f, way=w, onset=1.0, values=v) for (f, w), v in zip(ways, values, strict=True)]
    bank: Any = SimpleNamespace(faults=several)
    y = -1.0 * values[1] - 0.8 * values[0]
    chosen = _explained(bank, y, values, range(3), np.ones((60, 1)))
    assert [several[i].way for i, *_ in chosen] == ["step", "ramp", "both"]


def test_an_encoder_of_another_scale_is_found_beside_a_push_that_a_fit_of_squares_follows() -> None:
    """Encoders that show 1.8 times the motion and a push (7679): the search of squares never came near. Here the push
    is one of 2 N for a tenth of a second; the scale shows to a tenth, to which the file knows the robot."""
    bot = Bot()
    columns = logged(bot, Course(free=5.0, pushes=((3.6, 3.7, 2.0),), excitation=1.2), seed=1)
    for side in ("left", "right"):
        first = columns[side][np.argmax(columns["t"] >= 3.0)]
        columns[side] = np.where(columns["t"] >= 3.0, first + np.rint(1.8 * (columns[side] - first)), columns[side])
    run = thinned(follow(apply(propose(table := metric(columns, bot)), table), known(bot), Kit.preset("ideal")))
    several = hidden.mis_scaled_angles(run, window_of(run, float(run.t[-1])))
    (found,) = (fit for fit in several if fit.way == "encoders")
    assert 1 / (1 - found.size) == pytest.approx(1.8, rel=0.1)
    assert found.onset == pytest.approx(3.0, abs=0.2)  # two of three steps of the search
