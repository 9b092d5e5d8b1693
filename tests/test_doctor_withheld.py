"""What the doctor does not say: poses of motors that are off, delays of a robot that was pushed, signs and scales that
nothing decides, physics of a column that is another."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from planted.foreign import SMALL, Bot, Course, known, logged, metric, replace
from upright.checkup.doctor import Diagnosis, doctor
from upright.checkup.finding import GYRO, LEFT, PITCH
from upright.logs.readers import RawTable

TALL = replace(Bot(), body=1.6, com=0.09, inertia=4e-3)
"""A bot of 1.6 kg whose weight is half as high again."""

PUSHES = ((2.0, 2.05, 3.0), (3.5, 3.55, -4.0), (5.1, 5.15, 3.0), (6.3, 6.35, -2.0))
"""When a hand pushes (from, until [s]), in newtons for each kilogram of the body: knocks of 0.1 to 0.2 m/s."""


def kinds(diagnosis: Diagnosis) -> list[str]:
    return [segment.kind for segment in diagnosis.segments]


@pytest.mark.needs("shared/cases/motors-off/freefall.csv")
@pytest.mark.parametrize("name", ["freefall.csv", "wrap.csv"])
def test_a_robot_without_motors_does_not_balance(shared: Path, name: str) -> None:
    """Both duties are 0 in every row of these logs."""
    found = kinds(doctor(shared / "cases" / "motors-off" / name))
    assert found[0] == "motors off"
    assert "balancing" not in found


def test_motors_that_are_off_balance_nothing_whatever_the_pose() -> None:
    bot = SMALL
    columns = logged(bot, Course(free=5.0, excitation=0.5), seed=21)
    columns["duty"] = np.zeros(len(columns["t"]))
    assert "balancing" not in kinds(doctor(metric(columns, bot)))


@pytest.mark.parametrize(("bot", "seed"), [(SMALL, 12)])
def test_what_was_balancing_stays_so_when_later_rows_are_cut(bot: Bot, seed: int) -> None:
    """A robot that lies for 2 s, is raised in 1 s and let go at 3 s; a second later no throw is still upright."""
    columns = logged(bot, Course(free=6.0, lying=2.0, excitation=0.5), seed=seed)
    for end in (4.2, 4.9, 5.5):
        diagnosis = doctor(metric({n: x[columns["t"] < end] for n, x in columns.items()}, bot))
        assert kinds(diagnosis)[-1] == "balancing"
        assert diagnosis.segments[-1].start == pytest.approx(2.9, abs=0.1)  # it is up before it is let go
        assert "moved" not in kinds(diagnosis)


@pytest.mark.needs("shared/cases/hand-pushed/p2.csv")
def test_delays_of_a_log_with_pushes_by_hand_are_not_judged(shared: Path) -> None:
    """Its simulator reads the gyro at once, and its commands act from their row on."""
    case = shared / "cases" / "hand-pushed"
    for robot in (None, case / "mine2.toml"):
        diagnosis = doctor(case / "p2.csv", robot=robot, mapping=case / "m.toml")
        assert not {"delay/sensor", "delay/command", "samples/controller"} & set(diagnosis.codes())
        assert "excite" in [step.verb for step in diagnosis.page().next]


@pytest.mark.parametrize(("bot", "seed"), [(Bot(), 3)])
def test_pushes_tell_no_delay(bot: Bot, seed: int) -> None:
    """The gyro of these is 4 or 5 ms late; without a dither pushes shift the best lag to 20 ms."""
    pushes = [(start, stop, force * bot.body) for start, stop, force in PUSHES]
    codes = doctor(metric(logged(bot, Course(free=9.0, pushes=pushes), seed), bot)).codes()
    assert not {"delay/sensor", "delay/command"} & set(codes)
    assert "delay/untold" in codes


def test_a_dither_tells_a_delay() -> None:
    """Four periods of 5 ms late."""
    bot = replace(Bot(), late=0.02)
    diagnosis = doctor(metric(logged(bot, Course(free=6.0, excitation=1.0), seed=6), bot))
    late = next(f for f in diagnosis.findings if f.code == "delay/sensor")
    assert late.fixes[0].numbers[0] == pytest.approx(0.02, abs=0.003)


def table(columns: dict[str, np.ndarray]) -> RawTable:
    return RawTable(columns, source="run.csv")


@pytest.mark.parametrize(("bot", "factor", "digits"), [(SMALL, -3.3, 2)])
def test_a_wheels_speed_that_is_the_gyro_times_a_number_is_no_wheel(bot: Bot, factor: float, digits: int) -> None:
    """The pendulum equation then holds exactly, with q the number: no sign is wrong."""
    columns = dict(metric(logged(bot, Course(free=6.0, excitation=0.6), seed=31), bot).columns)
    for side in ("l", "r"):
        del columns[f"enc_{side}_rad"]
        columns[f"v_{side}_radps"] = np.round(factor * columns["gyro_radps"], digits)
    diagnosis = doctor(table(columns))
    assert diagnosis.findings[0].code == "columns/copied"
    assert not any(f.fixes for f in diagnosis.findings)
    assert not any(f.code.startswith(("motion/", "delay/", "units/")) for f in diagnosis.findings)


@pytest.mark.parametrize(("bot", "seed"), [(SMALL, 32)])
def test_readings_of_their_own_are_no_copies(bot: Bot, seed: int) -> None:
    columns = logged(bot, Course(free=6.0, excitation=0.6), seed)
    values = {**metric(columns, bot).columns, "pitch_rad": columns["tilt"]}
    assert "columns/copied" not in doctor(table(values)).codes()


def test_a_sign_is_repaired_only_where_a_third_witness_decides() -> None:
    """A gyro in raw sign: commands or a tilt that agree with the wheels tell that it is the gyro."""
    columns = logged(TALL, Course(free=6.0, excitation=0.6), seed=34)
    turned = dict(metric(columns, TALL).columns)
    turned["gyro_radps"] = -turned["gyro_radps"]
    silent = {name: x for name, x in turned.items() if not name.startswith("u_")}
    for values in (turned, {**silent, "pitch_rad": columns["tilt"]}):
        fixed = {f.channel for f in doctor(table(values)).findings if f.fixes}
        assert fixed == {GYRO}  # its sign, and then its offset
    alone = doctor(table(silent))
    assert {f.channel for f in alone.findings if f.code == "motion/contradicted"} == {GYRO, LEFT}
    assert not any(fix.kind == "scale" for f in alone.findings for fix in f.fixes)  # an offset has any sign


@pytest.mark.parametrize(("bot", "seed", "factor"), [(SMALL, 42, 2.0), (TALL, 43, 0.5)])
def test_a_scale_of_two_against_the_robots_file_is_asked(bot: Bot, seed: int, factor: float) -> None:
    """q of these robots is known from their masses to 0.1; 2 is far outside."""
    columns = dict(metric(logged(bot, Course(free=6.0, excitation=1.0), seed), bot).columns)
    right = doctor(table(columns), robot=known(bot))
    assert "units/scale" not in right.codes()
    assert "motion/untold" in right.codes()  # the clock
    for start, channel in (("gyro", GYRO), ("enc", LEFT)):
        changed = {name: x * (factor if name.startswith(start) else 1.0) for name, x in columns.items()}
        told = doctor(table(changed), robot=known(bot))
        assert "calibrate" not in [step.verb for step in told.page().next]  # a fit would bend its numbers to the scale
        found = [f for f in told.findings if f.code == "units/scale"]
        assert channel in [f.channel for f in found] or (channel == LEFT and "encoders count" in str(found[0].evidence))
        assert not any(f.fixes for f in found)


def test_a_tilt_that_the_gyro_contradicts_by_two_or_by_the_clock_is_not_divided() -> None:
    """Which of both has another scale is not told: the gyro's range, or the clock, is as likely as the tilt's unit."""
    columns = logged(TALL, Course(free=6.0, excitation=1.0), seed=44)
    values = {**metric(columns, TALL).columns, "pitch_rad": columns["tilt"]}
    for wrong in ({"gyro_radps": 2 * values["gyro_radps"]}, {"time_s": values["time_s"] / 1.3}):
        found = [f for f in doctor(table({**values, **wrong})).findings if f.channel == PITCH]
        assert [f.code for f in found] == ["units/scale"]
        assert not found[0].fixes
