"""Logs as firmware, notebooks and spreadsheets print them: one motion in many forms gives the same channels."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from upright import calibrate, identify
from upright.checkup.doctor import doctor
from upright.cli.main import main
from upright.diagnose import post_mortem
from upright.errors import InvalidLog
from upright.logs.draft import behaviour, draft
from upright.logs.mapping import Mapping, Source, apply, propose
from upright.logs.raw import raw_log
from upright.logs.readers import RawTable, read_table
from upright.signals import Log
from upright.validation.validate import validate

N = 120
T = 0.01 * np.arange(N)
LEAN = 0.05 * np.sin(5 * T)  # [rad]
GYRO = 0.25 * np.cos(5 * T)  # [rad/s] its rate
WHEEL = np.sin(4 * T)  # [rad]
VOLTS = 2 * np.cos(4 * T)
DEGREE = np.pi / 180

SENSORS = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro")


def lines(*columns: np.ndarray, mark: str = ",", digits: int = 9, comma: bool = False) -> list[str]:
    """Rows of a table."""
    rows = [mark.join(f"{value:.{digits}f}" for value in row) for row in zip(*columns, strict=True)]
    return [row.replace(".", ",") for row in rows] if comma else rows


def arduino() -> str:
    """Serial CSV: a greeting, names, a row of units, a separator at the end of each row."""
    rows = lines(T * 1000, GYRO / DEGREE, WHEEL / DEGREE, WHEEL / DEGREE, VOLTS, VOLTS)
    head = ["Gyro calibrated, offset 12", "time,gyro_y,enc_left,enc_right,left_pwm,right_pwm,", "ms,deg/s,deg,deg,V,V,"]
    return "\n".join(head + [f"{row}," for row in rows]) + "\n"


def tagged() -> str:
    """Lines of a logger: other tags between the numbers."""
    rows = lines(T, GYRO, WHEEL, WHEEL, VOLTS, VOLTS)
    body = [f"[INF] MODEL: {row}" for row in rows]
    body.insert(50, "[WRN] RADIO: weak signal, 3 packets lost")
    return "\n".join(["[INF] BOOT: v1.2", "[INF] MODEL: time_s,gyro,enc_l,enc_r,u_l,u_r", *body]) + "\n"


def pairs() -> str:
    """The form of a serial plotter."""
    values = zip(T, GYRO, WHEEL, WHEEL, VOLTS, VOLTS, strict=True)
    names = ("time_s", "gyro", "enc_l", "enc_r", "u_l", "u_r")
    return "\n".join("  ".join(f"{n}: {v:.9f}" for n, v in zip(names, row, strict=True)) for row in values) + "\n"


def json_lines() -> str:
    """ev3dev in Python: an object a line, one motor angle for both wheels."""
    rows = zip(T, GYRO / DEGREE, WHEEL / DEGREE, VOLTS, strict=True)
    return "\n".join(json.dumps({"time": t, "gyro_dps": g, "motor_deg": w, "voltage": u}) for t, g, w, u in rows) + "\n"


def ros() -> str:
    """Messages with nested parts and a stamp of whole seconds and nanoseconds."""
    rows = [
        {"header": {"seq": i, "stamp": {"secs": 1_700_000_000 + int(t), "nsecs": round(1e9 * (t - int(t)))}},
         "imu": {"angular_velocity": {"x": 0.0, "y": g}},
         "wheel": {"left": w, "right": w}, "cmd": {"left": u, "right": u}}
        for i, (t, g, w, u) in enumerate(zip(T, GYRO, WHEEL, VOLTS, strict=True))
    ]  # fmt: skip
    return json.dumps({"topic": "/robot", "messages": rows})


def matlab() -> str:
    """Names in a comment with per cent, spaces between the numbers."""
    rows = lines(T, GYRO, WHEEL, WHEEL, VOLTS, VOLTS, mark="   ")
    return "\n".join(["% written by writematrix", "% time_s gyro enc_l enc_r u_l u_r", *rows]) + "\n"


def german() -> str:
    """A spreadsheet with semicolons, decimal commas, and units in brackets in their own row."""
    rows = lines(T, GYRO / DEGREE, WHEEL, WHEEL, VOLTS, VOLTS, mark=";", comma=True)
    names = "time;gyro;wheel_left;wheel_right;voltage_left;voltage_right"
    return "\n".join([names, "[s];[°/s];[rad];[rad];[V];[V]", *rows]) + "\n"


def tilt_alone() -> str:
    """No gyro, but a tilt in degrees; names in camel case."""
    rows = lines(T, LEAN / DEGREE, WHEEL, WHEEL, VOLTS, VOLTS, mark="\t")
    return "\n".join(["time_s\ttilt_deg\tmotorLeft\tmotorRight\tleftPwm\trightPwm", *rows]) + "\n"


FORMS = {
    "arduino.csv": arduino, "tagged.txt": tagged, "pairs.log": pairs, "rows.jsonl": json_lines, "ros.json": ros,
    "matlab.txt": matlab, "german.csv": german, "tilt.tsv": tilt_alone,
}  # fmt: skip


@pytest.mark.parametrize("name", FORMS)
def test_one_motion_in_the_forms_of_others(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    path.write_text(FORMS[name](), "utf-8")
    log = raw_log(path)
    assert log.t - log.t[0] == pytest.approx(T, abs=1e-6)
    inside = slice(2, -2)  # a difference quotient is coarser at its ends
    near = 1e-3 if name == "tilt.tsv" else 1e-6
    assert log["sensor/gyro"][inside] == pytest.approx(GYRO[inside], abs=near)
    for side in ("left", "right"):
        assert log[f"sensor/encoder_{side}"] == pytest.approx(WHEEL, abs=1e-6)
        assert log[f"command/{side}"] == pytest.approx(VOLTS, abs=1e-6)


def ours(folder: Path) -> Path:
    channels = {"sensor/gyro": GYRO, "sensor/encoder_left": WHEEL, "sensor/encoder_right": WHEEL}
    channels |= {f"applied/{side}": VOLTS for side in ("left", "right")}
    return Log(T, channels, {"applied/left": "V"}, {"robot": {"name": "nxtway-gs"}}).save(folder / "run.csv")


def test_our_own_log_comes_back_from_a_spreadsheet(tmp_path: Path) -> None:
    """The comment split at its commas into cells and padded, each with a quote in it quoted again; numbers with commas
    and semicolons between them."""
    note, *table = ours(tmp_path).read_text("utf-8").splitlines()
    cells = ['"' + cell.replace('"', '""') + '"' if '"' in cell else cell for cell in note.split(",")]
    for mark in (",", ";"):
        body = table if mark == "," else [row.replace(",", ";").replace(".", ",") for row in table]
        path = tmp_path / f"saved{ord(mark)}.csv"
        path.write_text("\n".join([mark.join([*cells, "", ""]), *body]) + "\n", "utf-8-sig")
        log = raw_log(path)
        assert log["sensor/gyro"] == pytest.approx(GYRO)
        assert log.origin["robot"] == {"name": "nxtway-gs"}
        assert log.units["applied/left"] == "V"


def test_another_encoding_is_read(tmp_path: Path) -> None:
    for encoding in ("cp1252", "utf-16"):
        (tmp_path / "x.csv").write_bytes(german().encode(encoding))
        assert raw_log(tmp_path / "x.csv")["sensor/gyro"] == pytest.approx(GYRO, abs=1e-6)


def test_an_angle_is_differentiated_and_a_log_without_time_has_a_period(tmp_path: Path) -> None:
    text = '[time]\nperiod = 0.01\n[channels."sensor/gyro"]\ncolumn = "a"\nunit = "deg"\ndifferentiate = true\n'
    (tmp_path / "m.toml").write_text(text)
    mapping = Mapping.load(tmp_path / "m.toml")
    log = apply(mapping, RawTable({"a": LEAN / DEGREE}))
    assert log.t == pytest.approx(T)
    assert log["sensor/gyro"][2:-2] == pytest.approx(GYRO[2:-2], abs=1e-3)
    assert Mapping.load(_written(tmp_path / "again.toml", mapping.to_toml())) == mapping
    with pytest.raises(InvalidLog, match="integrated and differentiated"):
        Source(column="a", integrate=True, differentiate=True)


def _written(path: Path, text: str) -> Path:
    path.write_text(text, "utf-8")
    return path


def test_columns_without_names_are_drafted_by_how_they_behave(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _written(tmp_path / "x.txt", "\n".join(lines(LEAN, GYRO, WHEEL, VOLTS, mark=" ")) + "\n")
    words = behaviour(read_table(path))
    assert "the rate of c1" in words["c2"]
    assert "the rate of c3" in words["c4"]
    assert main(["doctor", str(path), "--write-mapping", str(tmp_path / "m.toml")]) == 0
    assert "a draft is in" in capsys.readouterr().out
    assert "the rate of c1" in (tmp_path / "m.toml").read_text("utf-8")
    assert Mapping.load(tmp_path / "m.toml").time.period == 0.01
    clocked = draft(RawTable({"a": np.asarray(1000 * T, dtype=np.float64), "b": GYRO}))
    assert 'column = "a"' in clocked


def test_the_doctor_prints_its_columns(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = _written(tmp_path / "x.csv", arduino().replace("enc_right", "temperature"))
    assert main(["doctor", str(path)]) == 0
    shown = " ".join(capsys.readouterr().out.split())
    assert "gyro gyro_y deg/s" in shown
    assert "not used temperature" in shown


def test_one_encoder_stands_for_both_wheels_only_where_no_side_is_named() -> None:
    zeros = np.zeros(3)
    assert propose(RawTable({"t": zeros, "enc": zeros})).channels.keys() == {*SENSORS[:2]}
    named = propose(RawTable({"t": zeros, "enc": zeros, "enc_l": zeros, "enc_r": zeros}))
    assert {s.column for s in named.channels.values()} == {"enc_l", "enc_r"}


def test_names_of_other_programs_are_understood() -> None:
    """Motors beside encoders are commands, and alone angles; `encoder` ends in no side; a row counter is no wheel."""
    zeros = np.zeros(3)

    def read(*names: str) -> dict[str, tuple[str, str]]:
        mapping = propose(RawTable(dict.fromkeys(("t", *names), zeros)))
        return {channel: (source.column, source.unit) for channel, source in mapping.channels.items()}

    both = read("left_motor", "right_motor", "left_encoder", "right_encoder")
    assert both[SENSORS[0]] == ("left_encoder", "")
    assert both["command/right"] == ("right_motor", "")
    assert read("left_motor", "right_motor") == {SENSORS[0]: ("left_motor", ""), SENSORS[1]: ("right_motor", "")}
    assert read("encoder", "gyro").keys() == {*SENSORS}
    assert read("counter", "gyro").keys() == {SENSORS[2]}
    assert read("enc_l_rev", "enc_r_rev")[SENSORS[0]] == ("enc_l_rev", "turn")
    bought = read("wl", "wr", "tau_l_mNm", "tau_r_mNm")
    assert bought[SENSORS[1]] == ("wr", "")
    assert bought["command/left"] == ("tau_l_mNm", "mN m")
    assert SENSORS[2] in read("psi_dot", "phi")  # pitch is ψ to some, as here, and θ to others
    assert SENSORS[2] not in read("psi_dot", "theta_rad", "enc")
    assert SENSORS[2] not in read("theta_dot", "psi", "enc")
    assert read("torque_left", "torque_right")["command/left"] == ("torque_left", "N m")


def test_a_command_has_the_unit_that_somebody_stated_or_none() -> None:
    """Volts taken for torques, or torques for volts, are refused for a robot of the other drive; what nobody stated is
    not."""
    columns = {"t": T, "gyro": GYRO, "enc": WHEEL, "u_l": VOLTS, "u_r": VOLTS}
    assert apply(propose(RawTable(columns)), RawTable(columns)).unit("command/left") == ""
    ours = RawTable({"t": T, "applied/left": VOLTS, "applied/right": VOLTS}, {"applied/left": "N m"})
    assert apply(propose(ours), ours).unit("applied/left") == "N m"
    channels = {"applied/left": VOLTS, "applied/right": VOLTS, SENSORS[0]: WHEEL, SENSORS[2]: GYRO}
    for judge in (lambda log: validate(log, "twipr"), lambda log: post_mortem(log, "twipr")):
        with pytest.raises(InvalidLog, match="in V; expected N m, as those of 'twipr'"):
            judge(Log(T, channels, origin={"file": "run.csv"}))


def test_columns_that_no_name_tells_are_missed_and_nothing_is_read_into_the_rest() -> None:
    """A gyro in degrees alone: no pose is known without wheels, so that its mean is no offset."""
    found = doctor(RawTable({"t": T, "gyro": (GYRO + 0.2) / DEGREE, "alpha": WHEEL, "beta": VOLTS}))
    assert found.codes() == ["columns/missing"]
    assert found.findings[0].facts["what"] == ["encoders", "commands"]


@pytest.mark.parametrize(("largest", "volts"), [(0.8, 6.4), (80.0, 6.4), (200.0, 8.0 * 200 / 255), (1023.0, 8.0)])
def test_full_duty_is_the_smallest_usual_number_that_no_row_exceeds(largest: float, volts: float) -> None:
    """A duty of 0.8 of 1, 80 of 100, 200 of 255 and 1023 of 1023, on a battery of 8 V."""
    columns = {"time_s": T, "gyro": GYRO, "pwm_left": largest * np.cos(4 * T), "vbat": np.full(N, 8.0)}
    table = RawTable(columns)
    assert apply(propose(table), table)["command/left"].max() == pytest.approx(volts, rel=1e-9)


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("left_encoder_speed", "right_encoder_speed"), ("motor1TicksPerSec", "motor2TicksPerSec"),
        ("enc_l_cps", "enc_r_cps"), ("leftEncoderCounts/s", "rightEncoderCounts/s"),
        ("wheel_left_rad_s", "wheel_right_rad_s"), ("left wheel velocity", "right wheel velocity"),
    ],
)  # fmt: skip
def test_a_speed_of_a_wheel_is_no_angle(left: str, right: str) -> None:
    """A rate that is read as an angle has one derivative too many, in whatever unit."""
    mapping = propose(RawTable({"t": T, left: WHEEL, right: WHEEL, "gyro": GYRO}))
    assert mapping.channels[SENSORS[0]].column == left
    assert all(mapping.channels[name].integrate for name in SENSORS[:2])


def test_counts_of_a_second_are_faster_than_any_wheel() -> None:
    """An encoder of 2000 counts, 320 of which are a radian, at the speed of a robot that drives."""
    counts = 320 * 10 * np.sin(3 * T)
    tilt = 0.1 * np.sin(3 * T) + 0.01 * np.random.default_rng(1).normal(size=len(T))  # else the counts were its copy
    found = doctor(RawTable({"t": T, "l_ticks_per_s": counts, "r_ticks_per_s": counts, "pitch": tilt}))
    assert [f.channel for f in found.findings if f.code == "units/speed"] == [*SENSORS[:2]]


def swing(rows: int = 300, period: float = 0.01) -> dict[str, np.ndarray]:
    """Time [s], a tilt [rad] that swings by 6 degrees twice a second, and its rate."""
    t = period * np.arange(rows)
    return {"t": t, "tilt": 0.1 * np.sin(12 * t), "rate": 1.2 * np.cos(12 * t)}


def test_a_tilt_alone_shows_poses_and_what_is_missing() -> None:
    """An angle in degrees, its rate beside it under a name that says nothing, a duty beyond 100, and no encoder: a body
    that falls over is seen to fall, and nothing is said of the wheels."""
    s = swing()
    falls = np.where(s["t"] > 2.4, s["tilt"] + 0.02 * (np.exp(7.5 * (s["t"] - 2.4)) - 1), s["tilt"])
    rate = np.gradient(falls, s["t"])
    columns = {"t": s["t"], "Angle (deg.)": falls / DEGREE, "Speed (deg./s)": rate / DEGREE}
    found = doctor(RawTable(columns | {"PWM": np.clip(-2500 * falls, -255, 255)}))
    assert [pose.kind for pose in found.segments] == ["balancing", "falling"]
    assert found.mapping.channels[SENSORS[2]].column == "Speed (deg./s)"
    assert any(f.facts["what"] == ["encoders"] for f in found.findings if f.code == "columns/missing")
    (command,) = (f for f in found.findings if f.code == "units/command")
    assert command.facts["unit"]["full"] == 255  # a duty: its name says so, and that it stays at 255 in the fall
    asked = doctor(RawTable(columns | {"command": -7500.5 * falls}))  # a law's output, before any limit
    (command,) = (f for f in asked.findings if f.code == "units/command")
    assert len(command.facts["units"]) > 1
    assert not command.fixes


@pytest.mark.parametrize("quarters", [1, 2, -1])
def test_a_tilt_that_counts_from_another_zero_is_no_robot_on_its_back(quarters: int) -> None:
    """Upright at 180 degrees, or at 90: a body that swings to both sides is not on the floor."""
    s = swing()
    wheels = 5 * s["tilt"] + 0.01 * np.random.default_rng(1).normal(size=len(s["t"]))  # else it were a copy
    columns = {"t": s["t"], "pitch": s["tilt"] + quarters * np.pi / 2, "enc": wheels, "u": 10 * s["tilt"]}
    found = doctor(RawTable(columns))
    assert {pose.kind for pose in found.segments} == {"balancing"}
    assert "estimate/zero" in found.codes()
    assert np.abs(found.repaired()["estimate/pitch"]).max() == pytest.approx(0.1, abs=0.02)


def test_rows_a_fifth_of_a_second_apart_tell_no_pose() -> None:
    s = swing(60, 0.25)
    found = doctor(RawTable({"t": s["t"], "pitch": s["tilt"] + 0.6}))
    assert "time/slow" in found.codes()
    assert found.segments == ()


def test_an_offset_is_not_read_into_a_gap() -> None:
    """The body turns by half a radian while nothing is logged; the gyro itself is true."""
    t = np.concatenate([0.01 * np.arange(100), 3 + 0.01 * np.arange(400)])
    lean = np.where(t < 2, 0.45, 0.0) + 0.03 * np.sin(9 * t)
    found = doctor(RawTable({"t": t, "pitch_rad": lean, "gyro_rad_s": 0.27 * np.cos(9 * t), "enc": -2 * lean}))
    assert "time/gap" in found.codes()
    assert "gyro/bias" not in found.codes()


def test_motors_that_are_off_have_no_unit() -> None:
    zeros = np.zeros(len(T))
    found = doctor(RawTable({"t": T, "gyro": GYRO, "enc_l": WHEEL, "enc_r": WHEEL, "pwm_l": zeros, "pwm_r": zeros}))
    assert "units/command" not in found.codes()


@pytest.mark.parametrize("unit", [1e-3, 1e-6])
def test_a_timer_of_32_bits_in_seconds_goes_on(unit: float) -> None:
    """A program that divides its micros() by a million counts to 4294.967296 s."""
    size = 2.0**32 * unit
    t = (size - 1 + 0.01 * np.arange(400)) % size
    found = doctor(RawTable({"elapsed_s": t, "gyro": np.sin(0.05 * np.arange(400)), "pitch": np.zeros(400)}))
    assert found.seconds == pytest.approx(3.99, abs=1e-3)
    assert "time/backwards" not in found.codes()


def test_a_draft_holds_what_the_names_say(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No clock, and no name for the tilt: the rest is written, with what is left to be named."""
    table = {"Theta": GYRO, "Lmot_RPM": WHEEL, "Rmot_RPM": WHEEL, "minus": -4 * GYRO}
    path, draft = tmp_path / "run.csv", tmp_path / "m.toml"
    rows = np.column_stack(list(table.values()))
    np.savetxt(path, rows, "%.6f", delimiter=",", header=",".join(table), comments="")
    assert main(["doctor", str(path), "--write-mapping", str(draft)]) == 0
    text = draft.read_text("utf-8")
    assert 'column = "Lmot_RPM"\nunit = "rpm"\nintegrate = true' in text
    assert '# [channels."sensor/gyro"]' in text
    assert "-4 times Theta" in text
    assert Mapping.load(draft).time.period == 0.01
    capsys.readouterr()


def test_a_robot_whose_motors_are_off_has_no_cause_to_fall_for() -> None:
    """A body of which nothing is asked topples like a rising exponential: no loop stopped, and nothing broke."""
    t = 0.01 * np.arange(150)
    lean = np.where(t < 0.6, 0.002 * np.sin(9 * t), 0.01 * np.exp(5 * (t - 0.6)))
    zeros = np.zeros(len(t))
    names = {SENSORS[0]: -0.1 * lean, SENSORS[1]: -0.1 * lean, SENSORS[2]: np.gradient(lean, t)}
    found = post_mortem(Log(t, names | {"command/left": zeros, "command/right": zeros}), "nxtway-gs")
    assert found.fell
    assert found.causes == ()
    assert found.check() == []
    assert "Both commands are 0 in every row" in str(found)


def test_rows_without_names_are_read_beside_the_settings_of_a_program(tmp_path: Path) -> None:
    """One object of settings, among them short lists, and of rows of numbers; every row was written twice."""
    s = swing(60)
    rows = np.repeat(np.column_stack([s["tilt"], s["rate"], 3 * s["tilt"]]), 2, axis=0)
    path = tmp_path / "run.json"
    path.write_text(json.dumps({"gains": {"Q": [1, 1, 100], "R": [9]}, "note": "fast", "rows": rows.tolist()}))
    table = read_table(path)
    assert list(table.columns) == ["c1", "c2", "c3"]
    tilt, gyro = Source(column="c1", unit="rad"), Source(column="c2", unit="rad/s")
    mapping = Mapping("mine", Source(column="", period=0.005), {"estimate/pitch": tilt, SENSORS[2]: gyro})
    (found,) = (f for f in doctor(table, mapping=mapping).findings if f.code == "samples/doubled")
    assert found.facts == {"times": 2, "n": 60, "rows": 120}


def test_settings_beside_columns_are_no_columns(tmp_path: Path) -> None:
    path = tmp_path / "run.json"
    path.write_text(json.dumps({"R": [1000], "t": T.tolist(), "gyro": GYRO.tolist()}))
    assert list(read_table(path).columns) == ["t", "gyro"]


def wheels(per_speed: float, per_angle: float, delay: int = 0) -> dict[str, np.ndarray]:
    """A wheel's speed (of which `per_speed` are 1 rad/s, `delay` rows late) and angle (of which `per_angle` are 1 rad),
    of a robot that drives to and fro."""
    t = 0.01 * np.arange(600)
    speed = 6 * np.sin(1.3 * t) + 3 * np.sin(4.1 * t)
    angle = -6 / 1.3 * np.cos(1.3 * t) - 3 / 4.1 * np.cos(4.1 * t)
    return {"t": t, "speed": per_speed * np.interp(t - 0.01 * delay, t, speed), "angle": per_angle * angle}


@pytest.mark.parametrize(("per_speed", "wrong"), [(60 / (2 * np.pi), False), (1.0, True), (1 / DEGREE, True)])
def test_a_speed_in_another_unit_than_its_name_says_contradicts_the_angle(per_speed: float, wrong: bool) -> None:
    """A column `rpm` that holds rad/s, or degrees a second, beside the wheel's angle in radians, 5 rows late."""
    w = wheels(per_speed, 1.0, delay=5)
    table = RawTable({"t": w["t"], "left_rpm": w["speed"], "right_rpm": w["speed"], "wheelpos_rad": w["angle"],
                      "gyro": 0.2 * np.cos(9 * w["t"])})  # fmt: skip
    mapping = Mapping("mine", Source(column="t", unit="s"), {
        name: Source(column=f"{side}_rpm", unit="rpm", integrate=True)
        for name, side in zip(SENSORS, ("left", "right"), strict=False)
    } | {SENSORS[2]: Source(column="gyro", unit="rad/s")})  # fmt: skip
    found = [f for f in doctor(table, mapping=mapping).findings if f.code == "units/contradicted"]
    assert bool(found) == wrong
    if wrong:
        true = "rad/s" if per_speed == 1 else "deg/s"
        assert found[0].facts["unit"] == true


def test_counts_beside_a_speed_say_what_a_turn_is() -> None:
    """An encoder of 330 counts: in rpm as it is named the speed makes 3150 of them a turn, as an owner can compare."""
    w = wheels(1.0, 330 / (2 * np.pi))
    table = RawTable({"t": w["t"], "left_rpm": w["speed"], "right_rpm": w["speed"], "n": np.rint(w["angle"]),
                      "pitch": 0.1 * np.sin(9 * w["t"])})  # fmt: skip
    (finding, *_) = (f for f in doctor(table).findings if f.code == "units/turn")
    assert finding.facts["turn"] == pytest.approx(330 * 60 / (2 * np.pi), rel=0.01)
    assert (finding.facts["column"], finding.facts["unit"]) == ("left_rpm", "rpm")


def test_pairs_with_units_are_read_between_the_messages_of_a_program(tmp_path: Path) -> None:
    """`pitch=1.2°, dpitch=-3°` after a greeting with numbers, and one line of another kind among them."""
    rows = [f"pitch={a:.6f}°, dpitch={g:.6f}°, time={t:.3f}"
            for a, g, t in zip(LEAN / DEGREE, GYRO / DEGREE, T, strict=True)]  # fmt: skip
    greeting = ["Starting IMU.", "ODR=833.000000; accel now=833.000000", "Polling …"]
    path = _written(tmp_path / "x.log", "\n".join([*greeting, *rows[:40], "battery low", *rows[40:]]) + "\n")
    log = raw_log(path)
    assert log["estimate/pitch"] == pytest.approx(LEAN, abs=1e-6)
    assert log[SENSORS[2]] == pytest.approx(GYRO, abs=1e-6)


def test_rows_that_hold_fewer_values_in_a_first_phase_are_read(tmp_path: Path) -> None:
    """A program that appends a value once its controller runs; a single row that is cut off is still left out."""
    full = [f"{t:.3f},{a:.6f},{g:.6f},{u:.3f}" for t, a, g, u in zip(T, LEAN, GYRO, VOLTS, strict=True)]
    short = [line.rsplit(",", 1)[0] for line in full]
    head = "t,pitch_rad,gyro_rad_s,integral"
    log = read_table(_written(tmp_path / "x.csv", "\n".join([head, *short[:50], *full[50:]]) + "\n"))
    assert log.columns["gyro_rad_s"] == pytest.approx(GYRO, abs=1e-6)
    assert np.isnan(log.columns["integral"][:50]).all()
    assert log.columns["integral"][50:] == pytest.approx(VOLTS[50:], abs=1e-3)
    cut = read_table(_written(tmp_path / "y.csv", "\n".join([head, *full[:-1], short[-1]]) + "\n"))
    assert len(cut) == N - 1
    assert len(cut.skipped) == 1


def test_a_column_without_a_name_has_one(tmp_path: Path) -> None:
    """The index of a table that Python wrote: times of day, and nothing above them."""
    rows = [f"2021-02-18 05:21:{7 + t:09.6f},{a:.6f}" for t, a in zip(T, LEAN / DEGREE, strict=True)]
    found = doctor(read_table(_written(tmp_path / "x.csv", "\n".join([",pitch(y)", *rows]) + "\n")))
    assert found.mapping.time.column == "c1"
    assert found.mapping.channels["estimate/pitch"].column == "pitch(y)"
    assert found.period == pytest.approx(0.01, rel=1e-3)


@pytest.mark.parametrize(
    ("angle", "rate"), [("pitch", "dpitch"), ("angle", "angle_dt"), ("tilt", "d_tilt"), ("angle", "dangle")]
)
def test_a_rate_is_named_by_its_angle(angle: str, rate: str) -> None:
    mapping = propose(RawTable({"t": T, angle: LEAN, rate: GYRO, "wheel_pos_dt": WHEEL}))
    assert mapping.channels["estimate/pitch"].column == angle
    assert mapping.channels[SENSORS[2]].column == rate


def test_a_filtered_tilt_keeps_its_own_lean() -> None:
    """A tilt whose filter passes 0.6 of the swings, on a robot that hangs at 2.8 rad: no unit is between it and its
    gyro, so that it hangs there, and does not lie at 1.7 rad."""
    s = swing()
    tilt = 2.8 + 0.6 * np.where(s["t"] < 1, s["tilt"], 0.03 * s["tilt"])
    found = doctor(RawTable({"t": s["t"], "angle": tilt, "angle_dt": np.where(s["t"] < 1, 1, 0.03) * s["rate"]}))
    assert {pose.kind for pose in found.segments} == {"upside down"}


def test_what_a_log_lacks_is_said_at_once() -> None:
    """A duty without a battery, and no encoder; a log without encoders whose motors are off."""
    duty = {"t": T, "gyro": GYRO, "pwm_l": np.rint(50 * VOLTS), "pwm_r": np.rint(50 * VOLTS)}
    lacking = apply(propose(RawTable(duty)), RawTable(duty))
    for judge in (calibrate, identify):
        with pytest.raises(InvalidLog, match=r"no encoders and no battery voltage .*sensor/battery") as error:
            judge(lacking, "nxtway-gs")
        assert "a gyro or a tilt" in str(error.value)
    off = Log(T, {SENSORS[2]: GYRO, "command/left": 0 * T, "command/right": 0 * T})
    with pytest.raises(InvalidLog, match="no encoders; expected encoders, a gyro or a tilt, and commands in V"):
        calibrate(off, "nxtway-gs")


def test_the_largest_step_of_an_experiment_is_no_limit_of_the_motors() -> None:
    """A random binary duty of 30 %, and rests: nothing is clipped; a law that is cut off at 30 % is."""
    on = np.repeat(np.random.default_rng(5).integers(-1, 2, N // 5), 5)
    columns = {"t": T, "angle": LEAN, "angle_dt": GYRO, "vbat": np.full(N, 8.0)}
    assert "saturation" not in doctor(RawTable(columns | {"pwm": 30.0 * on})).codes()
    assert "saturation" in doctor(RawTable(columns | {"pwm": np.clip(60 * np.cos(4 * T), -30, 30)})).codes()


def test_a_speed_that_is_asked_of_a_stepper_is_no_voltage() -> None:
    """Steps per second as the command of an inner loop, and steps as the encoder."""
    names = ("left_actual_steps", "right_actual_steps", "left_applied_sps", "right_applied_sps", "u_sps")
    mapping = propose(RawTable({"t": T, "gyro_dps": GYRO, **dict.fromkeys(names, 100 * WHEEL)}))
    assert mapping.channels[SENSORS[0]].column == "left_actual_steps"
    assert not any(name.startswith(("command/", "applied/")) for name in mapping.channels)


def test_a_tilt_and_its_rate_tell_how_long_a_row_takes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """No clock, an angle and its rate in one unit, rows of 4 ms."""
    s = swing(period=0.004)
    rows = [f"{a:.6f},{g:.6f}" for a, g in zip(s["tilt"], s["rate"], strict=True)]
    path, draft = _written(tmp_path / "x.csv", "\n".join(["theta,theta_dot", *rows]) + "\n"), tmp_path / "m.toml"
    assert main(["doctor", str(path), "--write-mapping", str(draft)]) == 0
    mapping = Mapping.load(draft)
    assert mapping.time.period == 0.004
    assert mapping.channels["estimate/pitch"].column == "theta"
    assert doctor(read_table(path), mapping=mapping).period == pytest.approx(0.004)
    capsys.readouterr()
