"""Logs of robots that others made: stamps that scatter, rows that are close, a gyro that shows the fall too late."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from planted import falls as bench
from upright.bodies import Electronics
from upright.bodies.twin import Twin
from upright.control import make_controller
from upright.diagnose.clock import evened, on_even_clock, thinned
from upright.diagnose.fall import LEANING, fall_time, falling, stuck_sensor
from upright.diagnose.fault_fits import FaultFit
from upright.diagnose.hidden import sooner
from upright.diagnose.innovations import follow
from upright.diagnose.remedy import remedied
from upright.diagnose.signatures import biases
from upright.diagnose.usual import window_of
from upright.experiment import Drive, run
from upright.robots import Kit, Robot
from upright.signals import Log

NXT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
PERIOD = 0.01
SPREAD = 3e-4  # [s] of stamps, uniform: ±0.3 ms on a microcontroller that writes its log between two loops
WHEEL_RATE = 10.0  # [rad/s], at which such a stamp is 3 mrad off


def fine() -> Kit:
    """The kit with encoders of 1.7 mrad instead of 17 mrad: their steps hide no stamp."""
    sensors = {
        n: dataclasses.replace(s, quantum=s.quantum / 10) if "encoder" in n else s for n, s in KIT.sensors.items()
    }
    return dataclasses.replace(KIT, sensors=sensors)


def driven(kit: Kit = KIT) -> Log:
    """A sound robot that drives, with even stamps."""
    law = make_controller("lqg", NXT, KIT, KIT.period)
    log = run(Electronics(Twin(NXT), kit), law, reference=Drive(speed=0.3, start=1.0), seconds=5.0, seed=3)
    return Log(log.t, {n: log[n] for n in log.channels if n.startswith(("sensor/", "command/"))})


def scattered(log: Log) -> Log:
    off = np.random.default_rng(1).uniform(-SPREAD, SPREAD, len(log))
    return Log(log.t + off, dict(log.channels))


def test_an_even_clock_ticks_in_whole_periods_about_the_stamps() -> None:
    ticks = np.delete(np.arange(500), [200, 201, 300])  # three lost rows
    t = PERIOD * ticks
    channels = {"sensor/gyro": np.sin(t)}
    even = evened(scattered(Log(t, channels)))
    assert even is not None
    # a running mean of 100 stamps of ±0.3 ms is known to 0.3 ms / √3 / √100 = 0.017 ms
    np.testing.assert_allclose(even.t - even.t[0], t - t[0], atol=4 * SPREAD / np.sqrt(3) / 10)
    assert evened(Log(t, channels)) is None  # even already
    wild = t + np.random.default_rng(1).uniform(-0.49, 0.49, len(t)) * PERIOD
    assert evened(Log(np.sort(wild), channels)) is None  # no clock at all


def test_stamps_that_scatter_are_no_trouble_of_the_robot() -> None:
    kit = fine()
    log = driven(kit)
    sound, late = follow(log, NXT, kit), follow(scattered(log), NXT, kit)
    even = on_even_clock(late)
    nis = [float(np.mean(one.whitened**2)) for one in (sound, late, even)]
    assert on_even_clock(sound) is sound
    # 0.3 ms / √3 at the 7.5 rad/s of 0.3 m/s are 1.3 mrad, more than the noise of a step of 1.7 mrad, 0.5 mrad
    assert nis[1] > 1.5 * nis[0]  # of the encoders' readings alone; 1.8 to 3.1 times over seeds
    assert nis[2] < 1.1 * nis[0]


def test_uneven_loops_keep_their_true_stamps() -> None:
    # the rows were taken when their stamps say: on an even clock the readings would be wrong
    log = driven(fine())
    off = np.random.default_rng(1).uniform(-SPREAD, SPREAD, len(log))
    moved = {n: np.interp(log.t + off, log.t, log[n]) if "encoder" in n else log[n] for n in log.channels}
    true = follow(Log(log.t + off, moved), NXT, fine())
    assert on_even_clock(true) is true


def test_close_rows_are_read_less_often_and_all_commands_stay() -> None:
    log = driven()
    usual = follow(log, NXT, KIT)
    assert thinned(usual) is usual  # 10 ms are 0.07 of the time in which it falls e-fold
    t = np.arange(0, log.t[-1], PERIOD / 4)
    held = np.searchsorted(log.t, t + 1e-9) - 1
    fast = {n: log[n][held] if "command" in n else np.interp(t, log.t, log[n]) for n in log.channels}
    run_of = follow(Log(t, fast), NXT, KIT)
    thin = thinned(run_of)
    many = int(0.09 / (falling(NXT).pole * PERIOD / 4))  # the fraction of `clock.CLOSE`
    assert thin.readings.sum() == pytest.approx(run_of.readings.sum() / many, rel=0.02)
    assert (thin.row < 0).sum() == (run_of.row < 0).sum()
    assert np.isfinite(thin.whitened).all()


def test_a_gyros_offset_begins_with_the_same_row_in_a_signature_and_in_the_log() -> None:
    # a gyro that is a whole period late: by the filter's own time its reading belongs to the row before
    gyro = dataclasses.replace(KIT.sensors["sensor/gyro"], delay=PERIOD)
    kit = dataclasses.replace(KIT, sensors={**KIT.sensors, "sensor/gyro": gyro})
    path = follow(driven(), NXT, kit)
    onset = float(path.log.t[300])
    signature = next(one for one in biases(path, np.array([onset])) if one.way == "step")
    freed = remedied(path, FaultFit(fault="bias", way="step", onset=onset, size=0.01))
    assert freed is not None
    change = freed.whitened - path.whitened
    # a fault adds −0.01 of the signature, and a log is freed of it by the same
    np.testing.assert_allclose(change, 0.01 * signature.values, atol=0.02 * np.abs(change).max())


def test_an_angle_and_a_small_reading_are_not_at_the_end_of_a_range() -> None:
    t = np.arange(300) * PERIOD
    turning = np.round(3 * t, 2)
    swings = np.round(0.3 * np.sin(9 * t), 2)
    rests = np.where(t < 2.0, np.round(0.2 * np.sin(5 * t), 1), 0.2)  # stands at its largest angle for some rows
    log = Log(t, {"sensor/gyro": swings, "sensor/encoder_left": rests, "sensor/encoder_right": turning})
    found = stuck_sensor(log, KIT, 2.9)
    assert found is not None
    assert found.channel == "sensor/encoder_left"
    assert not found.clipped


def test_a_gyro_with_an_offset_shows_the_fall_too_late(monkeypatch: pytest.MonkeyPatch) -> None:
    # planted: 1 rad/s more from 2 s on. The controller falls the other way, so that the gyro's integral is behind: by
    # some rows where the program never stops its motors, and by one where it stops them at 0.8 rad
    monkeypatch.setattr("upright.experiment.loop.STOP", np.inf)
    body = bench.FaultyBody(Twin(NXT), KIT, bench.Fault("gyro bias", "step", 2.0, 1.0), 1)
    log = run(body, make_controller("lqg", NXT, KIT, KIT.period), seconds=6.0, seed=2)
    true = float(log.t[np.flatnonzero(np.abs(log["truth/pitch"]) > LEANING)[0]])
    path = follow(Log(log.t, {n: log[n] for n in log.channels if n.startswith(("sensor/", "command/"))}), NXT, KIT)
    shown = fall_time(path) or float(path.t[-1])
    bias = FaultFit(
        fault="bias", way="step", onset=float(path.log.t[200]), size=0.8
    )  # as a signature has it, too small
    found = sooner(path, [bias], window_of(path, shown))
    assert shown > true + 0.03
    assert found == pytest.approx(true, abs=0.05)
