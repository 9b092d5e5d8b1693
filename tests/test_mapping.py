"""Foreign logs are read, mapped and refused with one line."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from upright.errors import InvalidLog, UnknownName
from upright.logs.mapping import UNITS, Mapping, Source, apply, channels_of, mappings, propose
from upright.logs.readers import RawTable, read_table
from upright.signals import Log

T = np.array([0.0, 0.01, 0.02, 0.03])


@pytest.mark.parametrize(
    "text",
    [
        "t,a b,c\n0,1,2.5\n1,2,3.5\n",
        "# made by hand\nt;a b;c\n0;1;2,5\n1;2;3,5\n",
        "% header\nt\ta b\tc\n0\t1\t2.5\n1\t2\t3.5\n",
        "\ufefft, a b, c\r\n0, 1, 2.5\r\n1, 2, 3.5\r\n",
    ],
)
def test_dialects_of_csv_give_one_table(tmp_path: Path, text: str) -> None:
    path = tmp_path / "x.csv"
    path.write_text(text, encoding="utf-8")
    table = read_table(path)
    assert {name: values.tolist() for name, values in table.columns.items()} == {
        "t": [0, 1], "a b": [1, 2], "c": [2.5, 3.5]
    }  # fmt: skip


def test_columns_of_spaces_without_a_header_are_numbered(tmp_path: Path) -> None:
    path = tmp_path / "x.txt"
    path.write_text("% says nothing\n 0.0  1 on \n\n 0.5  2 off \n")
    table = read_table(path)
    assert table.columns["c1"].tolist() == [0.0, 0.5]
    assert list(table.text) == ["c3"]


def test_json_mat_parquet_and_mcap_give_the_same_numbers(tmp_path: Path) -> None:
    from scipy.io import savemat

    gyro = [0.1, 0.2, 0.3, 0.4]
    (tmp_path / "x.json").write_text(json.dumps({"t": T.tolist(), "sensor/gyro": gyro, "note": "by hand"}))
    savemat(tmp_path / "x.mat", {"run": {"t": T, "gyro": np.array(gyro)}})
    log = Log(T, {"sensor/gyro": gyro})
    tables = [read_table(tmp_path / "x.json")]
    tables += [read_table(log.save(tmp_path / f"x.{suffix}")) for suffix in ("parquet", "mcap", "csv")]
    for table in tables:
        assert table.columns["sensor/gyro"].tolist() == gyro
    assert read_table(tmp_path / "x.mat").columns["run.gyro"].tolist() == gyro


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("empty.csv", "", "empty"),
        ("head.csv", "t,a\n", "no rows"),
        ("short.csv", "t,a\n0,1\n2\n", "rows cannot be read"),
        ("broken.json", '{"t": [0, 1', "is no JSON"),
        ("uneven.json", '{"t": [0, 1], "a": [1]}', "unequal lengths"),
        ("nothing.mat", "no mat file", "MAT file cannot be read"),
        ("nothing.parquet", "no parquet", "Parquet cannot be read"),
        ("twice.csv", "t,a,a\n0,1,2\n", "appears twice"),
    ],
)
def test_garbage_gets_one_line(tmp_path: Path, name: str, text: str, said: str) -> None:
    (tmp_path / name).write_text(text)
    with pytest.raises(InvalidLog, match=said) as caught:
        read_table(tmp_path / name)
    assert "\n" not in str(caught.value)


def test_text_in_a_column_is_named_only_when_it_is_needed(tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text("t,sensor/gyro,state\n0,1,ok\n1,ERR,ok\n")
    table = read_table(path)
    assert table.columns["t"].tolist() == [0, 1]
    with pytest.raises(InvalidLog, match="'sensor/gyro' holds the text 'ERR' at row 1"):
        table.column("sensor/gyro")


def mapped(**channels: Source) -> Mapping:
    names = {name.replace("__", "/"): source for name, source in channels.items()}
    return Mapping("m", Source(column="ms", unit="ms"), names)


def table(**columns: list[float]) -> RawTable:
    return RawTable({"ms": T * 1000, **{name: np.array(values) for name, values in columns.items()}})


EQUAL = [
    # one turn, and one turn in a second
    ("rad", 2 * np.pi, {"turn": 1.0, "deg": 360.0, "mdeg": 360_000.0, "rad": 2 * np.pi, "mrad": 2000 * np.pi}),
    ("rad/s", 2 * np.pi,
     {"rpm": 60.0, "deg/s": 360.0, "mdeg/s": 360_000.0, "rad/s": 2 * np.pi, "mrad/s": 2000 * np.pi}),
    ("s", 2.0, {"s": 2.0, "ms": 2000.0, "us": 2e6, "µs": 2e6, "ns": 2e9}),
    ("V", 8.1, {"V": 8.1, "mV": 8100.0}),
    ("N m", 0.05, {"N m": 0.05, "mN m": 50.0}),
    ("m", 1.5, {"m": 1.5, "cm": 150.0, "mm": 1500.0}),
    ("m/s", 1.5, {"m/s": 1.5, "cm/s": 150.0, "mm/s": 1500.0}),
    ("m/s²", 9.80665, {"m/s²": 9.80665, "g": 1.0}),  # standard gravity, CGPM 1901
    ("1", 0.5, {"1": 0.5, "%": 50.0}),
    ("", 0.5, {"": 0.5}),
]  # fmt: skip
"""SI unit, a quantity in it, and the same quantity in every unit that a column may have."""


@pytest.mark.parametrize(("si", "value", "same"), EQUAL)
def test_one_quantity_is_the_same_in_every_unit(si: str, value: float, same: dict[str, float]) -> None:
    for unit, number in same.items():
        factor, target = UNITS[unit]
        assert target == si
        assert number * factor == pytest.approx(value, rel=1e-15), unit


def test_every_unit_is_tried() -> None:
    assert {unit for _, _, same in EQUAL for unit in same} == UNITS.keys()


def test_unit_sign_scale_and_offset() -> None:
    gyro = Source(column="g", unit="deg/s", sign=-1, scale=0.1, offset=0.5)
    log = apply(mapped(sensor__gyro=gyro), table(g=[0, 1800, 0, 0]))
    assert log["sensor/gyro"] == pytest.approx([0.5, 0.5 - np.pi, 0.5, 0.5])  # −0.1 · 1800 ° = −180 ° = −π
    assert log.t == pytest.approx(T)
    assert log.unit("sensor/gyro") == "rad/s"


def test_per_cent_times_the_battery_is_volts() -> None:
    battery, duty = Source(column="mv", unit="mV"), Source(column="pwm", unit="%", times="sensor/battery")
    log = apply(mapped(applied__left=duty, sensor__battery=battery), table(mv=[8000] * 4, pwm=[50, -100, 0, 25]))
    assert log["applied/left"] == pytest.approx([4, -8, 0, 2])
    assert log.unit("applied/left") == "V"


def test_a_summed_rate_is_the_angle_it_was_made_from() -> None:
    angle = np.array([0.0, 0.3, 0.1, 0.7])
    rate = np.concatenate([[9.0], np.diff(angle) / 0.01])  # the first has no step before it and must not count
    source = Source(column="w", unit="rad/s", integrate=True)
    log = apply(mapped(sensor__encoder_left=source), table(w=rate.tolist()))
    assert log["sensor/encoder_left"] == pytest.approx(angle)
    assert log.unit("sensor/encoder_left") == "rad"


def test_a_delay_reads_later_rows_and_cuts_those_that_lack_them() -> None:
    source = Source(column="g", delay=0.01)
    log = apply(mapped(sensor__gyro=source), table(g=[1, 2, 3, 4]))
    assert log["sensor/gyro"] == pytest.approx([2, 3, 4])
    assert log.t == pytest.approx(T[:3])


@pytest.mark.parametrize("name", mappings())
def test_a_shipped_mapping_reads_back_from_what_it_writes(tmp_path: Path, name: str) -> None:
    mapping = Mapping.preset(name)
    (tmp_path / "m.toml").write_text(mapping.to_toml(), encoding="utf-8")
    assert Mapping.load(tmp_path / "m.toml") == mapping
    assert mapping.name == name


@pytest.mark.parametrize(
    ("text", "error", "said"),
    [
        ("time = 3", InvalidLog, "incomplete"),
        ("= 3", InvalidLog, "broken TOML"),
        ('[time]\ncolumn = "t"\n[channels.x]\ncolumn = "a"\nunit = "furlong"', InvalidLog, "furlong"),
        ('[time]\ncolumn = "t"\n[channels.x]\ncolumn = "a"\ncolour = 1', UnknownName, "colour"),
        ('[time]\ncolumn = "t"\n[channels.x]\ncolumn = "a"\ntimes = "b"', InvalidLog, "times = 'b'"),
        ('[time]\ncolumn = "t"\n[channels.x]\nunit = "V"', InvalidLog, "no column"),
    ],
)
def test_a_wrong_mapping_gets_one_line(tmp_path: Path, text: str, error: type[Exception], said: str) -> None:
    (tmp_path / "m.toml").write_text(text)
    with pytest.raises(error, match=said):
        Mapping.load(tmp_path / "m.toml")


def test_names_with_units_are_guessed() -> None:
    names = ["time_ms", "gyro_dps", "encLeft_deg", "encRight_deg", "pwm_left", "pwm_right", "vbat_mV", "pitch_deg"]
    guess = propose(RawTable({name: np.zeros(3) for name in names}))
    assert guess.time == Source(column="time_ms", unit="ms")
    assert {name: (s.column, s.unit) for name, s in guess.channels.items()} == {
        "sensor/gyro": ("gyro_dps", "deg/s"),
        "sensor/encoder_left": ("encLeft_deg", "deg"),
        "sensor/encoder_right": ("encRight_deg", "deg"),
        "command/left": ("pwm_left", "%"),
        "command/right": ("pwm_right", "%"),
        "sensor/battery": ("vbat_mV", "mV"),
        "estimate/pitch": ("pitch_deg", "deg"),
    }


def test_nothing_recognised_gets_one_line() -> None:
    with pytest.raises(InvalidLog, match="no time is recognised among alpha, beta"):
        propose(RawTable({"alpha": np.zeros(3), "beta": np.zeros(3)}))


REAL = {
    "twipr": "twipr/run1.csv",
    "ev3way": "ev3way/tilt_000.csv",
    "regbot": "regbot/position_step_2m.txt",
    "ev3-balanc3r": "ev3-balanc3r/datalog.json.txt",
}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=pytest.mark.needs(f"shared/data/{f}")) for n, f in REAL.items()]
)
def test_a_measured_log_is_recognised(shared: Path, name: str) -> None:
    table = read_table(shared / "data" / REAL[name])
    mapping = propose(table)
    assert mapping.name == name
    log = apply(mapping, table)
    assert {"sensor/encoder_left", "sensor/encoder_right", "estimate/pitch"} <= log.channels.keys()
    assert all(np.isfinite(values).all() for values in log.channels.values())


@pytest.mark.needs("shared/data/twipr/run1.csv")
def test_twipr_speeds_become_whole_encoder_steps(shared: Path) -> None:
    table = read_table(shared / "data" / REAL["twipr"])
    channels = channels_of(Mapping.preset("twipr"), table)[1]
    counts = channels["sensor/encoder_left"] / (2 * np.pi / 256 * 0.01)
    # Speeds have the step 2π/256 rad/s, printed to nine digits: over 1000 rows of 200 steps that adds up to 1e-3.
    assert np.abs(counts - np.rint(counts)).max() < 5e-3


def test_rows_that_the_file_says_were_left_out_are_known_of_its_log(tmp_path: Path) -> None:
    table = "t_ms,gyro_raw,cnt_l,cnt_r,pwm_l,pwm_r\n" + "".join(
        f"{10 * i},{i % 3},{i},{i},{i % 5},{i % 5}\n" for i in range(30)
    )
    from upright.logs.raw import raw_log

    for head, one_in in (("# wait_ms=5,decim=2,samples=30\n", 2), ("# decimals=3\n", None), ("", None)):
        path = tmp_path / "run.csv"
        path.write_text(head + table, encoding="utf-8")
        assert raw_log(path).origin.get("one_in") == one_in, head
