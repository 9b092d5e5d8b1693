"""Planted faults are named, clean logs raise no alarm, and what is said of measured logs is true."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from planted import faults as bench
from upright import calibrate, checkup, identify, post_mortem
from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.checkup.doctor import Diagnosis, contradictions, doctor
from upright.checkup.finding import during
from upright.checkup.physics import _r_squared, _solved, trimmed
from upright.checkup.titles import TITLES
from upright.control import lqg, make_controller
from upright.diagnose import causes
from upright.diagnose.causes import CANNOT_TELL, CAUSES, NONE
from upright.errors import InvalidLog
from upright.experiment import Drive, Hold, Impulse, run
from upright.experiment.examples import example
from upright.logs.mapping import Mapping, Source
from upright.logs.outliers import single
from upright.logs.readers import RawTable, read_table
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log


def test_what_lasts_no_time_in_words_is_at_a_time() -> None:
    """A knock of 20 ms begins and ends at the same three digits."""
    assert during(10.41, 10.43) == "at 10.4 s"
    assert during(1.41, 1.43) == "from 1.41 to 1.43 s"


_LEFT_OUT = {
    "controller at 2 ms": "not told from friction; the benchmark counts it as missed",
    "gyro in degrees, torque drive": "as the voltage drive",
    "per cent, battery not logged": "as with the battery",
    "rows in disorder": "as a jump back",
    "gyro clipped": "as commands clipped",
    "both encoders turned": "among the repairs",
    "rows twice": "among the repairs",
    "left counter of 8 bits": "as one turn, and among the repairs",
    "1 % of left readings are 20 rad": "as the gyro's",
}
"""Cases that only benchmarks/doctor.py runs, to keep this file under a minute."""

QUICK = [case for case in bench.CASES if case.name not in _LEFT_OUT]

_LOGS: dict[object, object] = {}


def made(setting: str, **options: object) -> Log:
    """One run for all faults that are planted in it."""
    key = setting, *options.items()
    if key not in _LOGS:
        _LOGS[key] = bench.record(setting, 0, **options)
    log = _LOGS[key]
    assert isinstance(log, Log)
    return log


@cache
def mended(setting: str) -> Log:
    """The repaired log without a fault: what the kit really does (a late gyro) is repaired too."""
    return doctor(made(setting)).repaired()


@pytest.mark.parametrize("case", QUICK, ids=[case.name for case in QUICK])
def test_a_planted_fault_is_named(case: object) -> None:
    assert isinstance(case, bench.Case)
    rng = np.random.Generator(np.random.Philox(0))
    special = {"ice", "fall"} & dict(case.options).keys()
    log = bench.planted(case, 0) if special else case.plant(made(case.setting, **dict(case.options)), rng)
    diagnosis = doctor(log)
    assert bench.named(case, diagnosis), str(diagnosis)
    assert [f.evidence for f in diagnosis.findings if _SYMBOL.search(str(f.evidence))] == []


_SYMBOL = re.compile("[δψφ]|\\b[pq] = ")
"""A letter of an equation: evidence is read by who owns the robot, in a verdict of the calibration as well."""


# All five settings, with and without excitation, pushes and drives, model and twin; the benchmark runs 50.
@pytest.mark.parametrize("seed", [30, pytest.param(33, marks=pytest.mark.evidence)])
def test_a_clean_log_raises_no_alarm(seed: int) -> None:
    name, log = bench.standing(seed)
    diagnosis = doctor(log)
    assert bench.false_alarms(name, log, diagnosis) == []
    without = RawTable({"t": log.t, **{n: x for n, x in log.channels.items() if n != bench.GYRO}}, dict(log.units))
    assert not [f for f in doctor(without).findings if f.severity == "error"]  # the estimate takes the gyro's place


@pytest.mark.parametrize(
    "name",
    [
        "both encoders turned",
        "encoders swapped",
        "rows twice",
        "gyro integrated",
        "encoders count one turn",
        "left counter of 8 bits",
        "1 % of gyro readings are 9 rad/s",
        "clock of tenths of a second",
    ],
)
def test_the_repair_undoes_the_fault(name: str) -> None:
    case = next(case for case in bench.CASES if case.name == name)
    clean, wanted = made(case.setting), mended(case.setting)
    repaired = doctor(case.plant(clean, np.random.Generator(np.random.Philox(0)))).repaired()
    assert not [finding for finding in doctor(repaired).findings if finding.severity == "error"]
    for channel in (bench.LEFT, bench.GYRO, "applied/left"):
        same = np.interp(wanted.t, repaired.t, repaired[channel])
        # A gyro that was summed and differenced is smoothed over two rows: hence a correlation, not equality.
        assert np.corrcoef(same, wanted[channel])[0, 1] > 0.95
        assert same.std() == pytest.approx(wanted[channel].std(), rel=0.15)


def test_a_command_that_never_changes_has_no_effect() -> None:
    none = np.zeros((2, 2)), np.zeros(2)  # its normal equations; they ended a certificate from a log with a traceback
    assert [_solved(*none, positive=positive).tolist() for positive in (True, False)] == [[0.0, 0.0]] * 2


def test_wheels_that_stand_explain_nothing() -> None:
    """Two regressors that never change; their product of scales ended a calibration in a traceback."""
    y = np.sin(np.arange(50.0))
    assert _r_squared(y, np.ones((3, 2, 50)), positive=True).tolist() == [0.0, 0.0, 0.0]
    values, r2, _ = trimmed(y, np.column_stack([2.0 * y, np.ones(50)]), positive=True)
    assert values == pytest.approx([0.5, 0.0])
    assert r2 == pytest.approx(1.0)


def test_truth_is_not_read() -> None:
    log = made("nxt")
    liar = Log(log.t, {**log.channels, "truth/pitch": np.full(len(log), 99.0)}, log.units)
    assert doctor(liar).findings == doctor(log).findings


@pytest.mark.parametrize("periods", [2, 4, 6, 7, 20])
def test_a_pause_is_a_gap_and_dropped_rows_are_not(periods: int) -> None:
    """A step of up to five periods is rows that were dropped, and is interpolated; a longer one is a pause of the
    recording, and is left. Five is the rule of docs/logs.md; the rows are cut out of one run, all else is equal."""
    log = made("nxt")
    keep = np.ones(len(log), dtype=bool)
    keep[500 : 500 + periods - 1] = False
    cut = RawTable({"t": log.t[keep], **{name: x[keep] for name, x in log.channels.items()}}, dict(log.units))
    diagnosis = doctor(cut)
    expected = "time/gap" if periods > 5 else "time/dropped"
    assert [code for code in diagnosis.codes() if code in ("time/gap", "time/dropped")] == [expected]
    repaired, step = diagnosis.repaired(), periods * log.period
    assert np.diff(repaired.t).max() == pytest.approx(step if periods > 5 else log.period, rel=1e-6)


@pytest.mark.parametrize("by", [20.0, 1e9, 1e29])
def test_a_clock_that_jumps_leaves_its_longest_part(by: float) -> None:
    log = made("nxt")
    t = log.t.copy()
    t[300:] += by
    diagnosis = doctor(RawTable({"t": t, **log.channels}, dict(log.units)))
    (jump,) = [finding for finding in diagnosis.findings if finding.code == "time/jump"]
    assert jump.facts["row"] == 300
    repaired = diagnosis.repaired()
    assert len(repaired) <= len(log) - 300
    assert np.diff(repaired.t).max() < 0.1
    (left,) = {f.code for f in doctor(log).findings} - {f.code for f in diagnosis.findings} or {""}
    assert left == ""  # what is found without the jump is found with it


def test_a_clock_that_jumps_all_the_time_is_no_clock() -> None:
    log = made("nxt")
    t = log.t + 1e3 * (np.arange(len(log)) // 5)
    with pytest.raises(InvalidLog, match="jumps"):
        doctor(RawTable({"t": t, **log.channels}, dict(log.units)))


@pytest.mark.parametrize("fit", [calibrate, identify, post_mortem])
def test_no_fit_follows_a_robot_through_a_jump_of_the_clock(fit: Callable[..., object]) -> None:
    log = made("nxt")
    t = log.t.copy()
    t[300:] += 1e9
    with pytest.raises(InvalidLog, match=r"jumps by 1e\+09 s .*row 300.*--fix"):
        fit(Log(t, log.channels, log.units), "nxtway-gs")


def still(n: int) -> dict[str, np.ndarray]:
    rng = np.random.Generator(np.random.Philox(1))
    return {name: rng.normal(size=n) for name in (bench.LEFT, bench.RIGHT, bench.GYRO)}


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ({"t": np.zeros(1), **still(1)}, "1 row"),
        ({"t": np.full(50, np.nan), **still(50)}, "holds no numbers"),
        ({"t": np.ones(50), **still(50)}, "never changes"),
        ({"t": np.arange(50.0), bench.LEFT: np.full(50, np.nan)}, "no sensor holds a number"),
    ],
)
def test_what_is_no_log_gets_one_line(columns: dict[str, np.ndarray], said: str) -> None:
    with pytest.raises(InvalidLog, match=said):
        doctor(RawTable(columns))


def test_text_in_a_channel_gets_one_line(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text("t,sensor/gyro\n0,ERR\n1,2\n")
    with pytest.raises(InvalidLog, match="'sensor/gyro' holds the text 'ERR' at row 0"):
        doctor(tmp_path / "x.csv")


def test_dead_channels_are_named() -> None:
    log = made("nxt")
    columns = {"t": log.t, **log.channels, bench.GYRO: np.zeros(len(log)), "sensor/compass": np.full(len(log), np.nan)}
    found = {(f.code, f.channel) for f in doctor(RawTable(columns, dict(log.units))).findings}
    assert {("channel/constant", bench.GYRO), ("channel/empty", "sensor/compass")} <= found


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("seed", range(4))
def test_noise_is_no_robot_and_breaks_nothing(seed: int) -> None:
    rng = np.random.Generator(np.random.Philox(seed))
    names = [bench.LEFT, bench.RIGHT, bench.GYRO, "applied/left", "applied/right", "estimate/pitch"]
    columns = {name: rng.normal(size=400) * 10.0 ** rng.uniform(-3, 3) for name in names}
    columns[names[seed]][rng.choice(400, 40)] = np.nan
    doctor(RawTable({"t": np.cumsum(rng.uniform(0.001, 0.02, 400)), **columns}))


MEASURED = {
    "twipr": "twipr/run1.csv",
    "ev3way": "ev3way/tilt_000.csv",
    "regbot": "regbot/position_step_2m.txt",
    "ev3-balanc3r": "ev3-balanc3r/datalog.json.txt",
}


def measured(shared: Path, name: str) -> Diagnosis:
    return doctor(shared / "data" / MEASURED[name])


def delay(diagnosis: Diagnosis, channel: str) -> float:
    """Milliseconds by which a sensor is late."""
    return next(
        1e3 * f.fixes[0].numbers[0] for f in diagnosis.findings if (f.code, f.channel) == ("delay/sensor", channel)
    )


@pytest.mark.needs("shared/data/twipr/run1.csv")
def test_twipr(shared: Path) -> None:
    diagnosis = measured(shared, "twipr")
    assert {f.severity for f in diagnosis.findings} == {"warning", "note"}  # units, signs and sides are right
    assert delay(diagnosis, bench.LEFT) == pytest.approx(20, abs=5)  # 73 ms to the wheels, 53 ms to the gyro
    said = {f.code: f.facts for f in diagnosis.findings}
    late = said["delay/command"]
    assert (late["wheels"], late["gyro"]) == (
        pytest.approx(0.073, abs=6e-3),
        pytest.approx(0.053, abs=6e-3),
    )  # half a row
    assert "estimate/accelerometer" in said
    start = next(f.span for f in diagnosis.findings if f.code == "segment/still")
    assert start is not None
    assert start == (pytest.approx(0.0, abs=0.05), pytest.approx(2.0, abs=0.15))  # the first 200 rows stand still


@pytest.mark.needs("shared/data/ev3way/tilt_000.csv")
def test_ev3way(shared: Path) -> None:
    diagnosis = measured(shared, "ev3way")
    assert delay(diagnosis, bench.GYRO) == pytest.approx(22, abs=4)  # about 22 ms; rows are 10.7 ms apart
    assert {"saturation", "segment/fall"} <= set(diagnosis.codes())
    fall = next(f.span for f in diagnosis.findings if f.code == "segment/fall")
    assert fall is not None
    assert 7.2 < fall[0] < 8.2  # its authors use t < 7.4 s, the log ends at 8.24 s
    assert all(f.severity != "error" for f in diagnosis.findings)


CUT = ["twipr/run1.csv", "ev3way/nn_v17_005.csv", "ev3way/nn_v7_000.csv", MEASURED["regbot"]]


@pytest.mark.needs("shared/data/twipr/run1.csv")
@pytest.mark.parametrize(
    ("log", "rows"),
    [
        (CUT[0], 140),
        *(pytest.param(log, 140, marks=pytest.mark.evidence) for log in CUT[1:]),
    ],
)
def test_a_real_log_that_is_cut_anywhere_has_no_wrong_sign_unit_or_offset(shared: Path, log: str, rows: int) -> None:
    """Whole, none of these logs has one: their authors balanced with these readings. 140 rows are 1.4 to 2.1 s."""
    table = read_table(shared / "data" / log)
    for first in range(0, len(table) - rows, rows):
        cut = replace(table, columns={name: x[first : first + rows] for name, x in table.columns.items()})
        codes = doctor(cut, robot="ev3way-large-wheels" if "ev3" in log else None).codes()
        false = [code for code in codes if code.startswith(("gyro/bias", "motion/f", "motion/d", "units/", "encoder/"))]
        assert not false, (first, false)


@pytest.mark.needs("shared/data/ev3way/tilt_000.csv")
def test_ev3way_units_are_found_without_its_mapping(shared: Path) -> None:
    table = read_table(shared / "data" / MEASURED["ev3way"])
    raw = {"sensor/encoder_left": "cnt_l", "sensor/encoder_right": "cnt_r", "sensor/gyro": "gyro_spd_x10",
           "applied/left": "pwm_l", "applied/right": "pwm_r", "sensor/battery": "batt_mV"}  # fmt: skip
    channels = {name: Source(column=column) for name, column in raw.items()}
    channels |= {name: Source(column=channels[name].column, unit="deg") for name in (bench.LEFT, bench.RIGHT)}
    diagnosis = doctor(table, mapping=Mapping("raw", Source(column="t_ms"), channels))
    found = {(f.code, f.channel): f.facts for f in diagnosis.findings}
    assert ("time/unit", "t") in found
    assert found["units/scale", "sensor/battery"]["factor"] == 1000
    assert ("units/command", "applied/left") in found
    assert found["units/scale", bench.GYRO]["factor"] == pytest.approx(10)


def foreign(shared: Path, **changes: np.ndarray) -> RawTable:
    """The EV3 log under names that say what its columns are, with other columns in place or beside."""
    table = read_table(shared / "data" / MEASURED["ev3way"])
    names = {"time_s": "t_ms", "gyro": "gyro_raw", "encoder_left": "cnt_l", "encoder_right": "cnt_r"}
    columns = {name: table.columns[column] for name, column in names.items()}
    columns |= {f"volt_{side}": 0.08 * table.columns[f"pwm_{side[0]}"] for side in ("left", "right")}
    columns |= {name: np.radians(columns[name]) for name in ("gyro", "encoder_left", "encoder_right")}
    columns["time_s"] = columns["time_s"] / 1000
    return RawTable(columns | changes)


@pytest.mark.needs("shared/data/ev3way/tilt_000.csv")
def test_a_gyro_in_raw_counts_gets_a_range_and_no_guess(shared: Path) -> None:
    counts = np.round(np.degrees(foreign(shared).columns["gyro"]) * 131)  # an MPU-6050's at ±250 °/s: 7506 make 1 rad/s
    diagnosis = doctor(foreign(shared, gyro=counts))
    (said,) = [f for f in diagnosis.findings if f.severity == "error"]
    assert (said.code, said.channel, said.fixes) == ("units/counts", bench.GYRO, ())
    least, most = said.facts["counts"]
    assert least < 7506 < most
    assert not diagnosis.segments  # no pose without a rate
    assert np.array_equal(diagnosis.repaired()[bench.GYRO], counts)


@pytest.mark.needs("shared/data/ev3way/tilt_000.csv")
def test_an_accelerometer_under_the_gyros_name_is_not_repaired_into_one(shared: Path) -> None:
    """What it reads at the axle: R θ̈ − g ψ, for wheels of 40 mm."""
    plain = foreign(shared).columns
    t, wheel = plain["time_s"], (plain["encoder_left"] + plain["encoder_right"]) / 2
    pull = 0.04 * np.gradient(np.gradient(wheel, t), t) - 9.81 * np.cumsum(plain["gyro"]) * 0.0107
    diagnosis = doctor(foreign(shared, gyro=pull, other=plain["gyro"]))
    assert [f.code for f in diagnosis.findings if f.severity == "error"] == ["columns/gyro"]
    assert diagnosis.findings[0].facts["best"] == "other"
    assert not diagnosis.segments


@pytest.mark.needs("shared/data/ev3way/nn_v17_005.csv")
def test_what_shakes_at_half_the_rate_is_no_rest(shared: Path) -> None:
    table = read_table(shared / "data/ev3way/nn_v17_005.csv")
    half = RawTable({name: values[::2] for name, values in table.columns.items()})
    assert [s.kind for s in doctor(half).segments] == ["balancing", "falling"]  # at the full rate as well


@pytest.mark.needs("shared/data/twipr/run1.csv")
def test_one_encoder_tells_nothing_of_sides_and_half_a_log_no_delay(shared: Path) -> None:
    table = read_table(shared / "data/twipr/run1.csv")
    t, left = table.columns["t_s"], np.cumsum(table.columns["speed_left_radps"]) * 0.01
    names = ("gyro_rad_s", "torque_left_Nm", "torque_right_Nm")
    raw = dict(zip(names, ("theta_dot_radps", "u_left_Nm", "u_right_Nm"), strict=True))
    columns = {"time_s": t, "encoder_left": left} | {name: table.columns[column] for name, column in raw.items()}
    assert all(f.severity != "error" for f in doctor(RawTable(columns)).findings)
    rows = slice(0, 500)  # of which 180 stand still: the longest delay that is tried fits best, 120 ms instead of 74
    half = RawTable({name: values[rows] for name, values in table.columns.items()})
    assert "delay/command" not in doctor(half).codes()


def table(log: Log, **columns: np.ndarray) -> RawTable:
    """A log as another program writes it: time, gyro and these columns, and nothing that says more."""
    return RawTable({"t": log.t, "gyro": log[bench.GYRO], **columns}, source="theirs.csv")


def test_a_speed_in_rad_per_second_under_a_name_that_says_rpm_is_named() -> None:
    """It is read as rpm, and the wheels then turn 9.55 times too slowly: no unit of an angle explains that."""
    log = made("nxt")
    speeds = {f"rpm_{side}": np.gradient(log[f"sensor/encoder_{side}"], log.t) for side in ("left", "right")}
    found = [f for f in doctor(table(log, **speeds)).findings if f.code == "units/scale"]
    assert [f.channel for f in found] == [bench.LEFT]
    assert found[0].facts["unit"]["text"] == "rad/s under a name that says rpm"
    right = {name: x * 60 / math.tau for name, x in speeds.items()}
    assert "units/scale" not in doctor(table(log, **right)).codes()


def test_metres_of_travel_are_no_angle_of_a_known_factor() -> None:
    """Radians are metres over a radius that the log does not state, so no number is offered."""
    log = made("nxt")
    metres = {f"enc_{side}": 0.04 * log[f"sensor/encoder_{side}"] for side in ("left", "right")}
    found = [f for f in doctor(table(log, **metres)).findings if f.code == "units/scale"]
    assert [f.channel for f in found] == [bench.LEFT]
    assert "metres of travel" in found[0].facts["units"]
    assert not found[0].fixes


@pytest.mark.parametrize(("most", "open_"), [(35.0, True), (100.0, False)])
def test_a_duty_below_a_half_may_be_of_255_and_one_that_ends_at_100_is_per_cent(most: float, open_: bool) -> None:
    log = made("nxt")
    volts = (log["applied/left"] + log["applied/right"]) / 2
    duty = np.rint(volts / np.abs(volts).max() * most)
    wheels = {f"enc_{side}": log[f"sensor/encoder_{side}"] for side in ("left", "right")}
    found = [f for f in doctor(table(log, pwmOutput=duty, **wheels)).findings if f.code == "units/command"]
    assert len(found) == 1
    assert (found[0].facts["fulls"] == [100, 255]) == open_
    assert "--robot" in str(found[0].repair)  # neither log nor robot tells the battery
    assert not found[0].fixes


@pytest.mark.parametrize(
    ("full", "part", "battery"),
    [
        (255, 0.3, True),
        (1023, 0.2, False),
        pytest.param(255, 0.7, False, marks=pytest.mark.evidence),
        pytest.param(1023, 0.2, True, marks=pytest.mark.evidence),
    ],
)
def test_a_duty_is_made_volts_of_its_own_full_number_and_battery_or_asked(
    full: int, part: float, battery: bool
) -> None:
    """Its largest duty is a part of full: never per cent, never 7.5 V, and never silently anything."""
    log, robot = made("nxt"), find_robot("nxtway-gs")
    volts = {side: log[f"applied/{side}"] for side in ("left", "right")}
    supply = max(float(np.abs(u).max()) for u in volts.values()) / part
    kit = find_kit(robot.kit)
    robot = replace(robot, kit=replace(kit, battery=replace(kit.battery, voltage=supply)))
    columns = {f"pwm_{side}": np.rint(u / supply * full) for side, u in volts.items()}
    columns |= {f"enc_{side}": log[f"sensor/encoder_{side}"] for side in volts}
    columns |= {"vbat": np.full(len(log.t), supply)} if battery else {}
    for known in (None, robot):
        found = doctor(table(log, **columns), known)
        said = [f for f in found.findings if f.code == "units/command"]
        assert said
        if said[0].fixes:  # 1000 for 1023 is not told from the motor's spread
            large = np.abs(volts["left"]) > 0.2 * supply * part
            ratio = found.repaired()["command/left"][large] / volts["left"][large]
            assert float(np.median(ratio)) == pytest.approx(1, abs=0.05)
        else:
            assert full in said[0].facts.get("fulls", ()) or "--robot" in str(said[0].repair)


@pytest.mark.needs("shared/cases/pwm-and-battery/mylog_vbat.csv")
def test_a_strangers_duty_of_255_is_not_read_as_per_cent(shared: Path) -> None:
    """2.05 V were written for 0.80 V, without a finding."""
    folder = shared / "cases" / "pwm-and-battery"
    for robot in (None, folder / "mine2.toml"):
        found = doctor(folder / "mylog_vbat.csv", robot)
        (said,) = (f for f in found.findings if f.code == "units/command")
        assert 255 in said.facts["fulls"] if not said.fixes else said.facts["full"] == 255


def test_a_tilt_alone_says_only_near_upright() -> None:
    log = made("nxt, tall")
    found = doctor(RawTable({"t": log.t, "tilt": np.degrees(log[bench.PITCH])}, source="theirs.csv")).findings
    assert any("near upright" in str(f.evidence) for f in found if f.code == "columns/missing")


@pytest.mark.needs("shared/data/ev3-balanc3r/datalog.json.txt")
def test_balanc3r_is_too_quiet(shared: Path) -> None:
    diagnosis = measured(shared, "ev3-balanc3r")
    assert diagnosis.healthy
    assert "motion/quiet" in diagnosis.codes()


@pytest.mark.needs("shared/data/regbot/position_step_2m.txt")
def test_regbot_commands_are_not_those_between_the_rows(shared: Path) -> None:
    diagnosis = measured(shared, "regbot")
    assert diagnosis.healthy
    assert "samples/controller" in diagnosis.codes()


def test_the_diagnosis_says_itself(tmp_path: Path) -> None:
    case = next(case for case in bench.CASES if case.name == "gyro turned")
    diagnosis = doctor(case.plant(made("nxt"), np.random.Generator(np.random.Philox(0))))
    assert "wrong sign" in str(diagnosis)
    assert diagnosis.to_json()["findings"][0]["channel"] == bench.GYRO
    assert not diagnosis.healthy


def test_progress_goes_from_nothing_to_all() -> None:
    shares: list[float] = []
    doctor(made("nxt"), progress=shares.append)
    assert shares == sorted(shares)
    assert shares[-1] == 1.0


def test_the_command_library_never_writes_over_the_log(tmp_path: Path) -> None:
    from upright.cli.destination import Destination
    from upright.cli.doctor import doctor as command
    from upright.errors import UprightError

    path = made("nxt").save(tmp_path / "run.parquet")
    with pytest.raises(UprightError, match="is a log itself"):
        command(path, fix=path, out=Destination())
    command(path, fix=tmp_path / "fixed.parquet", out=Destination())
    assert Log.load(tmp_path / "fixed.parquet").origin["repaired"] == []


def test_a_slow_motion_tells_no_lag_and_a_quiet_gyro_no_range() -> None:
    """A robot held and let go rolls so slowly that any lag fits its commands; one at rest reads only −1, 0 and 1 step
    of its gyro. Neither is a fault."""
    robot, spike, ev3 = Robot.preset("nxtway-gs"), Kit.preset("spike"), Kit.preset("ev3")
    held = run(Electronics(Twin(robot), spike), lqg(robot, spike), [Hold(pitch=0.1, until=2.0)], seconds=6.0)
    assert "samples/controller" not in doctor(bench.stripped(held)).codes()
    still = run(Electronics(Twin(robot), ev3), lqg(robot, ev3), seconds=5.0)
    assert "saturation" not in doctor(bench.stripped(still)).codes()


@pytest.mark.parametrize("impulse", [0.1, -0.25])
def test_a_knock_is_no_odd_reading(impulse: float) -> None:
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    knocks = [
        Impulse(impulse=impulse, start=at, duration=lasts) for at, lasts in ((0.5, 0.005), (1.5, 0.01), (2.5, 0.02))
    ]
    log = run(Electronics(Twin(robot), kit), lqg(robot, kit, 0.01), knocks, seconds=3.5, seed=2)
    assert np.abs(log[bench.GYRO]).max() > 5 * np.abs(log.between(0, 0.5)[bench.GYRO]).max()  # one that is felt
    assert not single(log.t, log[bench.GYRO]).any()


@pytest.mark.parametrize("knock", [0.12, 0.2])
def test_what_a_law_asks_for_beyond_the_battery_is_no_per_cent(knock: float) -> None:
    """A program may log its command before the limit: 16 V of a battery of 7.5 V after a knock of 0.12 N s a kilogram,
    and over 100 V in the fall after 0.2."""
    robot = Robot.preset("ev3way")
    kit = find_kit(robot.kit)
    law = make_controller("hinf", robot, kit, kit.period)
    pushes = [Impulse(impulse=knock * robot.body_mass, start=t, duration=0.02) for t in (2.0, 5.5)]
    drives = [Drive(speed=0.08, start=3.0), Drive(speed=-0.16, start=4.5), Drive(speed=0.08, start=6.0)]
    log = run(Electronics(NonlinearBody(robot), kit), law, pushes, reference=drives, seconds=8, seed=3)
    logged = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "sensor/battery", "command/left")
    raw = Log(log.t, {name: log[name] for name in (*logged, "command/right")})
    assert np.abs(raw["command/left"]).max() > 2 * raw["sensor/battery"].max()
    assert "units/command" not in doctor(raw).codes()
    assert contradictions(raw, robot) == []


def test_one_cut_removes_what_comes_with_a_fall() -> None:
    """Pushed over at 5 s: motors and gyro reach their limits in the fall. Without it the same doctor finds no fault."""
    fallen = doctor(example("fall"))
    assert {f.code for f in fallen.faults} == {"saturation", "segment/fall"}
    assert fallen.cut_away() == fallen.faults
    assert doctor(fallen.repaired()).healthy
    assert "removes 3 of 3 faults" in str(fallen)


def test_a_limit_that_is_reached_while_it_balances_too_stays() -> None:
    """The fall's commands again, from 3 s on in a log that goes on: no cut takes them away."""
    log = example("fall")
    early = (log.t > 3.5) & (log.t < 3.6)
    columns = {name: np.where(early, np.abs(log[name]).max(), log[name]) for name in ("applied/left", "applied/right")}
    result = doctor(Log(log.t, {**log.channels, **columns}, log.units, log.origin))
    kept = [f.code for f in result.faults if f not in result.cut_away()]
    assert "saturation" in kept
    assert not re.search(r"removes (\d+) of \1 faults", str(result))


class TooWeak:
    """A tenth of what a controller commands."""

    def __init__(self, inner: object) -> None:
        self._inner = inner
        self.spec, self.reset, self.estimate, self.applied = inner.spec, inner.reset, inner.estimate, inner.applied

    def step(self, measurement: object, reference: object) -> tuple[float, float]:
        left, right = self._inner.step(measurement, reference)
        return 0.1 * left, 0.1 * right

    def to_json(self) -> dict[str, object]:
        return {"kind": "too weak"}


@pytest.mark.parametrize("name", ["nxtway-gs", "tumbller", "twipr", "stepper"])
def test_a_log_that_only_falls_is_sent_to_the_post_mortem_not_to_a_calibration(name: str) -> None:
    """As of a robot with too little gain, which falls when it is let go."""
    robot = find_robot(name)
    kit = find_kit(robot.kit)
    body = Electronics(NonlinearBody(robot), kit)
    log = run(body, TooWeak(lqg(robot, kit)), start=(0.03, 0, 0, 0, 0, 0), seconds=5.0)
    measured = {key: values for key, values in log.channels.items() if not key.startswith("truth/")}
    steps = doctor(Log(log.t, measured, {key: log.units[key] for key in measured}), robot).page().next
    assert "post_mortem" in [step.verb for step in steps]
    assert "calibrate" not in [step.verb for step in steps]


def test_every_finding_and_every_cause_has_words_for_a_page() -> None:
    """The codes as they stand in the checks, and the names of causes: none reaches a reader as it is."""
    codes = {
        node.args[0].value
        for path in Path(checkup.__path__[0]).glob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)
        and node.func.id in ("error", "warning", "note", "Finding")
        and isinstance(node.args[0], ast.Constant)
    }  # fmt: skip
    assert len(codes) > 40
    assert codes - set(TITLES) == set()
    assert {*CAUSES, NONE, CANNOT_TELL} == set(causes.TITLES) == set(causes.REPAIRS)
