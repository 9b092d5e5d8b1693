"""Which battery a fall is judged with: that of the log where it shows one, else the kit's."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from planted.foreign import Bot, Course, known, logged, metric
from upright.checkup.finding import BATTERY
from upright.diagnose.evidence import gather
from upright.diagnose.fault_fits import FaultFit, with_pushes
from upright.diagnose.forces import refined
from upright.diagnose.innovations import follow
from upright.diagnose.pushed import LEAVES
from upright.diagnose.remedy import followed
from upright.diagnose.supply import as_shown, of_supply, with_supply
from upright.diagnose.usual import window_of
from upright.robots import Kit, Robot
from upright.signals import Log

NXT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")  # of 8 V, which both commands together pull down by 2 %
HEAVY = Bot(body=0.9, com=0.075, radius=0.03, inertia=2.5e-3)


def volts(full: float, sag: float, *, shown: bool = True, most: float | None = None, **origin: object) -> Log:
    """Commands that go to the battery's limit and back, 10 s of them."""
    asked = 1.2 * full * np.sin(np.arange(1000) / 7)
    asked = np.clip(asked, -most, most) if most else asked
    load = np.concatenate([[0.0], 2 * np.minimum(np.abs(asked), full)[:-1]])
    channels = {"command/left": asked, "command/right": asked, "sensor/gyro": 0.1 * asked}
    channels |= {"sensor/battery": full - sag * load} if shown else {}
    return Log(0.01 * np.arange(1000), channels, {}, dict(origin))


def test_a_battery_that_shows_more_than_the_kit_s_is_the_log_s() -> None:
    kit = with_supply(KIT, volts(11.7, 0.0), NXT)
    assert (kit.battery.voltage, kit.battery.sag) == pytest.approx((11.7, 0.0))
    kit = with_supply(KIT, volts(11.7, 0.01), NXT)  # a reading under load, whose load a least-squares line takes off
    assert (kit.battery.voltage, kit.battery.sag) == pytest.approx((11.7, 0.01), rel=1e-6)
    facts = of_supply(KIT, kit)[0].facts
    assert (facts["volts"].value, facts["usual"].value) == pytest.approx((11.7, 8.0))
    assert with_supply(KIT, volts(8.0, 0.02), NXT) is KIT
    assert with_supply(KIT, volts(11.7, 0.0), Robot.preset("twipr")) is KIT  # torques know no battery


def test_a_battery_that_shows_less_is_in_the_words_but_may_be_the_fault() -> None:
    log = volts(6.0, 0.02)
    assert with_supply(KIT, log, NXT) is KIT
    assert as_shown(KIT, log, NXT).battery.voltage == pytest.approx(6.0, rel=1e-6)


def test_commands_of_a_foreign_program_that_end_at_one_value_show_its_battery() -> None:
    def found(**log: object) -> float:
        return with_supply(KIT, volts(11.7, 0.0, shown=False, **log), NXT).battery.voltage  # type: ignore[arg-type]

    assert found(most=11.7) == pytest.approx(11.7)
    assert found() == 8.0  # commands as a law asks for them, before any limit
    assert found(most=6.0) == 8.0  # a program may have reasons for less
    assert found(most=11.7, body={"kind": "model"}) == 8.0  # ours logs what a controller asks of its kit


def of_bot(bot: Bot, course: Course, seed: int, floor: float) -> Log:
    """A log up to where its robot leans by `floor` [rad], as a mapping gives it."""
    columns = logged(bot, course, seed=seed)
    lean = np.abs(np.cumsum(columns["gyro"] - bot.offset) * bot.period)
    values = list(metric(columns, bot).columns.values())
    names = ("sensor/gyro", "sensor/encoder_left", "sensor/encoder_right", "command/left", "command/right", BATTERY)
    ends = int(np.argmax(lean > floor)) if lean.max() > floor else len(lean)
    return Log(values[0][:ends], {name: one[:ends] for name, one in zip(names, values[1:], strict=True)})


def test_a_push_on_a_robot_with_another_battery_needs_no_fault() -> None:
    """Commands of 11.7 V, cut to the kit's 8 V, left what encoders of 1.5 times the motion would: the post-mortem
    said so at 0.87. A push alone has to leave no more than noise, which counts up to `LEAVES`."""
    log, robot = of_bot(HEAVY, Course(free=2.5, pushes=((1.5, 1.6, 12.6),), falls=True), 77, 0.7), known(HEAVY)
    before, fall = gather(log.between(0.0, 1.4), robot, KIT, None, lambda _: None)
    assert fall is None
    assert before.kit.battery.voltage == pytest.approx(HEAVY.battery, rel=1e-3)
    nis: list[float] = []
    for kit in (before.kit, KIT):
        run = follow(log, robot, kit)
        window = window_of(run, float(log.t[-1]))
        bank = window.bank(run)
        nis.append(refined(run, with_pushes(bank), window, bank).nis)
    assert nis[0] < LEAVES < 5 * LEAVES < nis[1]


def test_friction_holds_a_resting_wheel() -> None:
    """Both motors grow stiff by 0.3 of what they give at most. With its true numbers the filter leaves noise, which
    counts up to `LEAVES`; friction that is smooth about rest let wheels creep, and left a NIS of 4.0."""
    bot = replace(HEAVY, battery=8.0, late=0.0)  # as the kit has them
    since, torque = 1.5, 0.3 * bot.gain * bot.battery
    log = of_bot(bot, Course(free=5.0, falls=True, stiff=(since, torque)), 3, 0.7)
    run, end = follow(log, known(bot), KIT), float(log.t[-1])
    freed = followed(run, end, FaultFit(fault="friction", way="both", onset=since, size=torque / bot.gain))
    assert freed is not None
    left, before = (float(np.mean(one.between(since, end).whitened ** 2)) for one in (freed, run))
    assert left < LEAVES < 50 * LEAVES < before
