"""Columns without names are found by the robot's own motion, whatever their order, unit and sign."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import upright as up
from upright.checkup import volts
from upright.checkup.columns import by_physics
from upright.checkup.doctor import proposed
from upright.checkup.finding import Record
from upright.cli.main import main
from upright.errors import InvalidLog
from upright.experiment.examples import example
from upright.logs.mapping import Mapping, channels_of, propose
from upright.logs.outliers import single
from upright.logs.readers import RawTable, read_table
from upright.logs.recording import check_unit
from upright.signals import Log

DEGREE = np.pi / 180
NAMES = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "applied/left", "applied/right")


@cache
def parts() -> dict[str, np.ndarray]:
    log = example("excited")
    several = {name: log[name] for name in NAMES} | {"t": log.t, "pitch": log["estimate/pitch"]}
    rng = np.random.default_rng(1)
    return several | {"noise": rng.standard_normal(len(log)), "row": np.arange(len(log), dtype=np.float64)}


LEFT, RIGHT, GYRO, ONE, OTHER = NAMES
LAYOUTS: dict[str, list[tuple[str, float, bool]]] = {
    "as ours": [("t", 1, False), *((name, 1.0, False) for name in NAMES)],
    "an NXT's whole numbers": [
        ("t", 1000, True), (LEFT, 1 / DEGREE, True), (RIGHT, 1 / DEGREE, True), (GYRO, 1 / DEGREE, True),
        (ONE, 12.5, True), (OTHER, 12.5, True),
    ],
    "commands first, 8 bits": [
        ("t", 1e6, True), (ONE, 31.9, True), (OTHER, 31.9, True), (LEFT, 1 / DEGREE, True), (RIGHT, 1 / DEGREE, True),
        (GYRO, 1 / DEGREE, True),
    ],
    "a row number, the tilt, a turned gyro, the battery": [
        ("row", 1, False), ("t", 1, False), ("pitch", 1, False), (GYRO, -1, False), (LEFT, 1, False), (RIGHT, 1, False),
        (ONE, 1, False), (OTHER, 1, False), ("noise", 0.01, False),
    ],
    "degrees and noise": [
        ("noise", 1, False), ("t", 1000, True), (GYRO, 1 / DEGREE, False), (LEFT, 1 / DEGREE, False),
        (RIGHT, 1 / DEGREE, False), ("noise", 7, False), (ONE, 1, False), (OTHER, 1, False),
    ],
    "no clock": [(name, 1.0, False) for name in NAMES],
}  # fmt: skip


def table(layout: str) -> RawTable:
    columns = [parts()[name] * scale for name, scale, _ in LAYOUTS[layout]]
    whole = [np.rint(x) if rounds else x for x, (_, _, rounds) in zip(columns, LAYOUTS[layout], strict=True)]
    return RawTable({f"c{i}": x for i, x in enumerate(whole)})


@pytest.mark.parametrize("layout", LAYOUTS)
def test_a_layout_without_names_is_found(layout: str) -> None:
    mapping = by_physics(table(layout))
    assert mapping is not None
    at = {name: (f"c{i}", scale, rounds) for i, (name, scale, rounds) in enumerate(LAYOUTS[layout])}
    assert {name: mapping.channels[name].column for name in NAMES} == {name: at[name][0] for name in NAMES}
    assert mapping.time.column == (at["t"][0] if "t" in at else "")
    if "t" in at:
        assert mapping.time.unit == {1: "s", 1000: "ms", 1e6: "us"}[at["t"][1]]
    gyro = mapping.channels[GYRO]
    assert gyro.sign == np.sign(at[GYRO][1])
    # unit and angle together: a robot's coupling is known to a factor of a few, not of 57
    degrees = [mapping.channels[n].unit.startswith("deg") for n in (LEFT, GYRO)]
    stated = [abs(at[n][1]) != 1 for n in (LEFT, GYRO)]
    assert degrees == stated or not at[LEFT][2]  # angles with fractions are taken for radians, and the gyro with them


def test_columns_of_something_else_are_not_taken() -> None:
    rng = np.random.default_rng(0)
    walks = {f"c{i}": np.cumsum(rng.standard_normal(1000)) for i in range(6)}
    assert by_physics(RawTable({"t": np.linspace(0.0, 9.99, 1000), **walks})) is None


def test_the_doctor_says_which_columns_it_took_and_writes_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, written = tmp_path / "run.csv", tmp_path / "mine.toml"
    rows = np.column_stack(list(table("an NXT's whole numbers").columns.values()))
    path.write_text("\n".join(",".join(f"{x:g}" for x in row) for row in rows) + "\n")
    assert main(["doctor", str(path), "--write-mapping", str(written)]) == 0
    shown = " ".join(capsys.readouterr().out.split())
    assert "gyro c4 deg/s" in shown
    assert "columns guessed" in shown
    assert Mapping.load(written).channels[LEFT].column == "c2"
    assert up.doctor(path, mapping=written).codes() == [c for c in up.doctor(path).codes() if c != "columns/unnamed"]


def test_without_a_clock_the_columns_are_drafted_and_the_period_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, written = tmp_path / "run.csv", tmp_path / "mine.toml"
    rows = np.column_stack(list(table("no clock").columns.values()))
    path.write_text("\n".join(",".join(f"{x:.6g}" for x in row) for row in rows) + "\n")
    assert main(["doctor", str(path)]) == 2
    assert "--write-mapping" in capsys.readouterr().err
    assert main(["doctor", str(path), "--write-mapping", str(written)]) == 0
    assert "a draft is in" in capsys.readouterr().out
    assert "state the period" in written.read_text()
    assert Mapping.load(written).channels[GYRO].column == "c3"


TRUE = {
    "t": "t", LEFT: "l", RIGHT: "r", GYRO: "g", "command/left": "ul", "command/right": "ur", "estimate/pitch": "p",
    "sensor/battery": "b",
}  # fmt: skip
STRANGERS = (
    "t=t gyro_dps=g° left_deg=l° right_deg=r° left_v=ul right_v=ur",
    "t=t gyro_dps=g° left_deg=l° right_deg=r° pwm_left=ul% pwm_right=ur%",
    "millis=t‰ gyroY=g° enc_l=l° enc_r=r° pwmL=ul% pwmR=ur% vbat=b",
    "time_ms=t‰ encL=l° encR=r° gyro=g° uL=ul uR=ur",
    "ts=t posLeft=l posRight=r gyro_y_dps=g° voltLeft=ul voltRight=ur",
    "us=tµ motorPosL=l° motorPosR=r° gyro_rate=g° powerL=ul% powerR=ur%",
    "t_us=tµ ticks_left=l° ticks_right=r° gyro_deg_s=g° duty_l=ul% duty_r=ur% batt_mV=b‰",
    "dt=Δ gyro=g encoderLeft=l encoderRight=r u_left=ul u_right=ur",
    "dt_ms=Δ‰ gyro=g encoderLeft=l encoderRight=r u_left=ul u_right=ur",
    "time=t theta_deg=p° gyro_deg_per_s=g° left_rad=l right_rad=r volt_l=ul volt_r=ur",
    "timestamp=t‰ pitch=p° pitch_rate_dps=g° wheel_l_rad=l wheel_r_rad=r motor_l_V=ul motor_r_V=ur",
    "millis=t‰ angle=p° gyroRate=g° leftPosition=l° rightPosition=r° pwmLeft=ul% pwmRight=ur%",
    "t=t roll=p roll_rate=g phi_l=l phi_r=r u_l=ul u_r=ur",
    "t_ms=t‰ gyr_y=g° m1_pos=l° m2_pos=r° m1_pwm=ul% m2_pwm=ur%",
    "t=t tacho_l=l° tacho_r=r° gyro_raw=g° power_l=ul% power_r=ur% battery_mV=b‰",
    "time_us=tµ gy=g° ml_deg=l° mr_deg=r° ul=ul ur=ur",
    "time_s=t pitch_rate=g rotation_left_deg=l° rotation_right_deg=r° voltage_left_mV=ul‰ voltage_right_mV=ur‰",
    "t=t gyroX=noise gyroY=g gyroZ=noise leftEncoder=l rightEncoder=r leftVoltage=ul rightVoltage=ur",
    "t=t gyroX=g° encA=l° encB=r° pwmA=ul% pwmB=ur%",
    "t=t pitch_deg=p° pitch_rate_deg_s=g° x_left=l x_right=r u_left_V=ul u_right_V=ur",
    "ms=t‰ gyro=g° lw=l° rw=r° lpwm=ul% rpwm=ur%",
    "elapsed_ms=t‰ rate=g° deg_l=l° deg_r=r° cmd_l=ul% cmd_r=ur% volt=b",
    "millis=t‰ gyroAngle=p° gyroRate=g° countLeft=l° countRight=r° motorLeft=ul% motorRight=ur%",
    "t=t omega=g alpha_l=l alpha_r=r U_l=ul U_r=ur",
    "tick=row t_ms=t‰ gyro_dps=g° left=l° right=r° left_u=ul right_u=ur",
    "tiempo=t giro=g enc_izq=l enc_der=r volt_izq=ul volt_der=ur",
    "hora=t giro_(°/s)=g° ángulo_izq_(º)=l° ángulo_der_(º)=r° mando_izq=ul mando_der=ur",
    "t=t gyro=g enc1=l enc2=r m1=ul m2=ur left_motor_current=noise target_left_pos=row",
    "t=t gyro=g encoder1=l encoder2=r motor1=ul motor2=ur left_speed_cmd=noise",
    "t=t gyro=g enc_left=l enc_right=r motor_left_pwm=ul% pwm_motor_right=ur%",
    "ts=t imu.gyro.0=noise imu.gyro.1=g imu.gyro.2=row wheels.l=l wheels.r=r cmd.l=ul cmd.r=ur",
    "/imu/header/stamp=t /imu/angular_velocity/y=g /left_wheel/angle=l /right_wheel/angle=r /u/left=ul /u/right=ur",
)
"""Headers of Arduino, EV3, NXT and ESP32 programs: the name of each column, what it holds, and its unit: ° degrees, ‰
thousandths, µ millionths, % counts of a duty of 255."""


@cache
def held() -> dict[str, np.ndarray]:
    names = {"l": LEFT, "r": RIGHT, "g": GYRO, "ul": ONE, "ur": OTHER, "p": "pitch"}
    own = {short: parts()[name] for short, name in names.items()}
    return own | {n: parts()[n] for n in ("t", "noise", "row")} | {
        "b": 8.0 + 0.01 * own["ul"], "Δ": np.diff(parts()["t"], prepend=parts()["t"][0] - 0.01)
    }  # fmt: skip


@pytest.mark.parametrize("header", STRANGERS)
def test_what_a_stranger_calls_a_column_is_proposed(header: str) -> None:
    """Each column is read as what it holds, whatever it is called; volts, where the battery or the names tell them."""
    factor = {"°": 1 / DEGREE, "‰": 1e3, "µ": 1e6, "%": 255 / 8.0}
    columns, at = dict[str, NDArray[np.float64]](), dict[str, str]()
    for name, _, what in (part.partition("=") for part in header.split(" ")):
        scaled = held()[what.rstrip("°‰µ%")] * factor.get(what[-1], 1.0)
        columns[name] = np.rint(scaled) if what[-1] in "‰µ%" and what[0] != "Δ" else 1.0 * scaled
        at[what.rstrip("°‰µ%")] = name
    draft = proposed(RawTable(columns))[0]
    read = {name.replace("applied/", "command/"): source.column for name, source in draft.channels.items()}
    wanted = {name: at[what] for name, what in TRUE.items() if what in at and name != "t"}
    assert read == wanted
    t, channels, _ = channels_of(draft, RawTable(columns))
    assert np.diff(t) == pytest.approx(np.diff(parts()["t"]), abs=1.1e-3)  # of whole milliseconds
    for name, what in TRUE.items():  # a unit is right, or nothing states one, and the doctor's checks find it
        if name in channels and draft.channels[name].unit not in ("", "1") and draft.channels[GYRO].unit:
            assert channels[name] == pytest.approx(held()[what], abs=0.05), name


def test_a_duty_of_eight_bits_is_no_per_cent_and_no_millivolts() -> None:
    """Commands of an Arduino reach 255; without a battery nobody knows of what voltage, and a fit refuses them."""
    duty = np.rint(255 * np.sin(50 * parts()["t"]))
    columns = {"t": parts()["t"], "gyro": parts()[GYRO], "enc_l": parts()[LEFT], "enc_r": parts()[RIGHT]}
    for names in (("motor_l", "motor_r"), ("pwm_l", "pwm_r")):
        table = RawTable(columns | dict.fromkeys(names, duty))
        t, channels, stated = channels_of(propose(table), table)
        record = Record(t, channels, stated)
        (found,) = volts.commands(record)
        assert found.facts["unit"]["full"] == 255
        assert "--robot" in str(found.repair)
        assert not found.fixes
    with pytest.raises(InvalidLog, match="a duty"):
        check_unit(Log(t, channels, stated), "command", up.Robot.preset("nxtway-gs"))


def sensors(**changes: NDArray[np.float64] | None) -> dict[str, NDArray[np.float64]]:
    """Columns of an Arduino's log, in SI units and a duty of 8 bits, with some of them changed."""
    duty = {f"pwm_{side}": np.rint(held()[u] * 255 / 8.0) for side, u in (("left", "ul"), ("right", "ur"))}
    plain = {"t": parts()["t"], "enc_left": held()["l"], "enc_right": held()["r"], "gyro": held()["g"], **duty}
    return plain | {name: values for name, values in changes.items() if values is not None}


def told(columns: dict[str, NDArray[np.float64]], robot: str | None = "nxtway-gs") -> dict[tuple[str, str], Any]:
    return {(f.code, f.channel): f.facts for f in up.doctor(RawTable(columns), robot).findings}


COMMAND, WRONG = ("units/command", "command/left"), ("error", "warning")


@pytest.mark.parametrize("robot", ["nxtway-gs", None])
def test_a_duty_beside_right_units_spoils_no_unit(robot: str | None) -> None:
    """Its back-EMF is of a count, and no reason to take radians for something else."""
    findings = up.doctor(RawTable(sensors()), robot).findings
    assert [(f.code, f.channel) for f in findings if f.severity in WRONG] == [COMMAND]
    (found,) = (f for f in findings if f.code == COMMAND[0])
    # the motor's own 0.468 V s/rad, and what its friction takes: 6.69 · 0.0022 / 0.317
    assert found.facts["emf"] == pytest.approx(0.49, abs=0.025)


def test_a_duty_that_stays_small_is_of_the_number_that_the_motor_needs() -> None:
    """A robot that stands uses a third of 255, which could be per cent: only the file of the robot tells. (A battery of
    8.9 V in place of 8.)"""
    small = {n: np.rint(0.9 * sensors()[n]) for n in ("pwm_left", "pwm_right")}
    assert max(np.abs(x).max() for x in small.values()) < 100
    # of 255 as full the motor has its own back-EMF: 0.468 V s/rad, and what its friction takes
    assert told(sensors(**small))[COMMAND]["emf"] == pytest.approx(0.49, abs=0.03)


@pytest.mark.parametrize("gyro", [1, -1])
def test_a_mirrored_side_is_found_though_the_robot_turns_much(gyro: int) -> None:
    """A motor that is mounted the other way round turns encoder and command; which side it is follows the gyro."""
    mirrored = {"enc_right": -held()["r"], "pwm_right": -sensors()["pwm_right"], "gyro": gyro * held()["g"]}
    found = told(sensors(**mirrored))
    side = "right" if gyro > 0 else "left"
    assert {("motion/flipped", f"sensor/encoder_{side}"), ("motion/flipped", f"command/{side}")} <= found.keys()
    assert not [code for code, _ in found if code == "units/scale"]


@pytest.mark.parametrize("turn", [1320.0, 2400.0, 4096.0])
def test_ticks_of_an_encoder_are_no_degrees(turn: float) -> None:
    """How many are a turn cannot be said to better than what is not known of the robot; the range has the true one."""
    ticks = {f"enc_{side}": np.rint(held()[side[0]] * turn / math.tau) for side in ("left", "right")}
    low, high = told(sensors(**ticks))["units/counts", LEFT]["counts"]
    assert low < turn < high < 2.5 * low
    raw = told(sensors(**ticks, gyro=np.rint(held()["g"] / DEGREE * 131)))  # an MPU-6050 at its finest range
    assert {("units/counts", name) for name in (LEFT, RIGHT, GYRO)} <= raw.keys()
    assert not [code for code, _ in raw if code == "units/scale"]


@pytest.mark.parametrize(("unit", "factor"), [("mm", 1e-3), ("cm", 0.01), ("m", 1.0)])
def test_a_distance_is_no_angle_of_a_wheel(unit: str, factor: float) -> None:
    """Odometry: the wheel's angle times its radius of 40 mm, that of the robot's file. Without a robot nothing is
    divided, and nothing rests on the encoders."""
    columns = sensors(enc_left=None, enc_right=None)
    columns |= {f"{side} distance ({unit})": held()[side[0]] * 0.04 / factor for side in ("left", "right")}
    table = RawTable({name: x for name, x in columns.items() if not name.startswith("enc")})
    robot = up.Robot.preset("nxtway-gs").replace(wheel_radius=0.04)
    found = next(f for f in up.doctor(table, robot).findings if f.channel == LEFT)
    assert found.fixes[0].numbers == pytest.approx((25.0,))
    assert not [f for f in up.doctor(table, robot).findings if f.code == "units/scale" and f.channel == GYRO]
    unknown = [f for f in up.doctor(table).findings if f.severity == "error" and f.channel in (LEFT, RIGHT)]
    assert [f.code for f in unknown] == ["units/counts"] * 2
    assert unknown[0].facts["unit"] == unit


def test_speeds_of_no_stated_unit_may_be_turns_a_minute() -> None:
    """Who prints rpm prints degrees of the body: both are found, in the gyro and in an angle, and nothing else."""
    speeds = {f"speed_{side}": np.gradient(held()[side[0]], held()["t"]) * 60 / math.tau for side in ("left", "right")}
    columns = {n: x for n, x in sensors(gyro=held()["g"] / DEGREE).items() if not n.startswith("enc")}
    found = told(columns | speeds | {"angle": held()["p"] / DEGREE})
    assert {c for code, c in found if code == "units/scale"} == {GYRO, LEFT, "estimate/pitch"}
    assert found["units/scale", LEFT]["unit"]["unit"] == "rpm"
    assert "estimate/zero" not in {code for code, _ in found}


def test_a_fraction_of_full_duty_is_no_volt_where_the_robot_is_known() -> None:
    """No name says its unit: with a robot the back-EMF does, without one the doctor asks."""
    columns = {n: x for n, x in sensors().items() if not n.startswith("pwm")}
    columns |= {f"cmd_{side}": held()[u] / 8.0 for side, u in (("l", "ul"), ("r", "ur"))}
    assert told(columns)[COMMAND]["unit"] == "a fraction of full duty"
    volts = told(columns | {f"cmd_{side}": held()[u] for side, u in (("l", "ul"), ("r", "ur"))})
    assert COMMAND not in volts
    (question,) = (f for f in up.doctor(RawTable(columns)).findings if f.code == COMMAND[0])
    assert question.severity == "note"


def test_the_stamps_of_ros_and_a_clock_in_brackets_are_times(tmp_path: Path) -> None:
    """As ROS prints them, in seconds and nanoseconds, and as dmesg does, before values with their names."""
    t, rows = held()["t"], range(400)
    seconds, path = np.floor(t).astype(int), tmp_path / "run.csv"
    path.write_text(
        "stamp_sec,stamp_nanosec,gyro\n"
        + "".join(f"{1764000000 + seconds[k]},{(t[k] - seconds[k]) * 1e9:.0f},{held()['g'][k]}\n" for k in rows)
    )
    assert read_table(path).columns["stamp"] == pytest.approx(t[:400] - seconds[0], abs=1e-6)
    for line in ("[{:9.4f}] gy={} el=3", "[{:.4f}] {},3"):
        path.write_text("booting\n" + "".join(line.format(t[k], held()["g"][k]) + "\n" for k in rows))
        first = next(iter(read_table(path).columns.values()))
        assert first == pytest.approx(t[:400], abs=1e-4)


def test_readings_beside_missing_rows_are_no_single_ones() -> None:
    """After four missing rows a swing of 2 Hz looks like a step away and back."""
    t = 0.01 * np.arange(400)
    swing = np.where(np.abs(t - 2.0) < 0.006, 1.0, 0.0) + 0.001 * np.sin(40 * t)
    assert single(t, swing).sum() == 1
    late = np.where(t > 2.0, t + 0.04, t)
    assert not single(late, swing).any()


def test_text_between_the_rows_and_times_of_day_are_read(tmp_path: Path) -> None:
    """Messages of a program, a row that was cut off, a second header; midnight passes; all is left out and told."""
    columns = sensors()
    stamp = np.datetime64("2026-05-01T23:59:55") + np.rint(1e3 * columns.pop("t")).astype("timedelta64[ms]")
    table = np.column_stack(list(columns.values()))
    rows = [f"{s},{','.join(f'{x:.9g}' for x in row)}" for s, row in zip(stamp, table, strict=True)]
    header = ",".join(["timestamp", *columns])
    rows[900:900], rows[700:700], rows[500:500] = [header], ["2026-05-02T00:00:02.000,0.1,"], ["WARN: late"]
    path = tmp_path / "day.csv"
    path.write_text("\n".join([header, *rows, "Done."]))
    found = up.doctor(path, "nxtway-gs")
    assert (found.rows, found.seconds) == (len(stamp), pytest.approx(11.99, abs=1e-3))
    assert {f.code for f in found.findings if f.severity in WRONG} == {"units/command"}
    (skipped,) = (f.facts for f in found.findings if f.code == "rows/skipped")
    assert skipped["n"] == 4
    assert "line 502: WARN: late" in skipped["lines"]
    clock = [s[11:] for s in np.datetime_as_string(stamp)]  # without the date
    path.write_text("\n".join([header, *(f"{c}{row[23:]}" for c, row in zip(clock, rows[:500], strict=False))]))
    assert up.doctor(path).seconds == pytest.approx(4.99, abs=1e-3)


def test_a_table_of_which_many_lines_are_no_rows_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "torn.csv"
    path.write_text("\n".join(["t,gyro", *(f"{0.01 * i},1" if i % 10 else "torn" for i in range(200))]))
    with pytest.raises(InvalidLog, match="cannot be read"):
        up.doctor(path)


@pytest.mark.parametrize(("name", "unit", "bits"), [("micros", 1e6, 32), ("ms", 1e3, 16)])
def test_a_timer_that_begins_again_goes_on(name: str, unit: float, bits: int) -> None:
    columns = sensors()
    counts = np.rint(unit * columns.pop("t")) + 2.0**bits - 5 * unit
    found = up.doctor(RawTable({name: counts % 2.0**bits, **columns}), "nxtway-gs")
    assert found.seconds == pytest.approx(11.99, abs=1e-3)
    assert not [f for f in found.findings if f.code.startswith("time/") and f.severity in WRONG]
