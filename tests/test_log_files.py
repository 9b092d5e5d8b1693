"""A log survives its file exactly, a file is whole or absent, and a bad file says what is wrong with it."""

from __future__ import annotations

import json
import math
import os
import zipfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mcap.reader import make_reader
from mcap.writer import Writer

import upright.signals.mcap
import upright.signals.parquet
import upright.signals.text
from upright.arrays import floats_of
from upright.errors import InvalidLog
from upright.signals import Log
from upright.signals.files import FORMATS

SUFFIXES = sorted(FORMATS)
MODULES = {".csv": upright.signals.text, ".mcap": upright.signals.mcap, ".parquet": upright.signals.parquet}

every_format = pytest.mark.parametrize("suffix", SUFFIXES)


def awkward() -> Log:
    """Numbers, names and notes that a careless format would change."""
    t = [-0.25, 0.0, 0.1, 0.30000000000000004, 1e-9 + 0.30000000000000004, 7.0]
    channels = {
        "truth/pitch": [math.nan, -0.0, 1e-300, 5e-324, 0.1 + 0.2, 1.7976931348623157e308],
        "truth/pitch_rate": [math.inf, -math.inf, math.nan, 1 / 3, -1e22, 123456789012345678.0],
        "all/nan": [math.nan] * 6,
        "plain": [1, 2, 3, 4, 5, 6],
        "plain/value": [6, 5, 4, 3, 2, 1],
        "three/steps/down": [0] * 6,
        'comma, "quote", 100 % é ψ #': [1] * 6,
    }
    origin = {"robot": "NXT\n# t,a", "seed": 3, "gain": [0.1, None, {"x": 1e-300}], "ψ": "✓\u2028"}
    return Log(t, channels, {"plain": "m/s², °", "all/nan": ""}, origin)


def identical(one: Log, other: Log) -> bool:
    """Equal, and with the same sign of every zero, the same order of channels."""
    pairs = [(one.t, other.t), *((one[name], other[name]) for name in one.channels)]
    signs = all(np.array_equal(np.signbit(a[~np.isnan(a)]), np.signbit(b[~np.isnan(b)])) for a, b in pairs)
    return one == other and signs and len(one.channels) == len(other.channels)


def complaint(act: Callable[[], object]) -> str:
    with pytest.raises(InvalidLog) as caught:
        act()
    message = str(caught.value)
    assert "\n" not in message
    return message


def csv(folder: Path, content: str | bytes) -> Path:
    path = folder / "run.csv"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return path


# There and back


@every_format
def test_awkward_numbers_names_and_notes_come_back_exactly(tmp_path: Path, suffix: str) -> None:
    log = awkward()
    assert identical(Log.load(log.save(tmp_path / f"run{suffix}")), log)


NAMES = st.text(max_size=12).filter(lambda name: name.isprintable() and name != "t")
FLOATS = st.floats(width=64)
JSON = st.dictionaries(st.text(max_size=5), st.none() | st.booleans() | st.integers() | st.text(max_size=5), max_size=3)


@st.composite
def logs(draw: st.DrawFn) -> Log:
    # 9e8 s: within MCAP's clock. The file formats see nothing of the distance between two times.
    t = sorted(draw(st.sets(st.floats(-9e8, 9e8), min_size=1, max_size=5)))
    column = st.lists(FLOATS, min_size=len(t), max_size=len(t))
    channels = draw(st.dictionaries(NAMES, column, max_size=4))
    units = {name: draw(st.text(max_size=4)) for name in channels}
    return Log(t, channels, units, draw(JSON))


@every_format
@settings(max_examples=12, derandomize=True, deadline=None, database=None)
@given(log=logs())
def test_any_log_comes_back(tmp_path_factory: pytest.TempPathFactory, suffix: str, log: Log) -> None:
    path = tmp_path_factory.getbasetemp() / f"any{suffix}"
    assert identical(Log.load(log.save(path)), log)


@every_format
def test_the_order_of_the_channels_is_kept(tmp_path: Path, suffix: str) -> None:
    names = ["b/x", "a/x", "b/y", "a/y"]  # two topics, interleaved
    log = Log([0.0], {name: [0.0] for name in names})
    assert list(Log.load(log.save(tmp_path / f"run{suffix}")).channels) == names


def test_rows_beyond_one_block_of_text_are_all_there(tmp_path: Path) -> None:
    n = upright.signals.text._ROWS_AT_ONCE + 1  # one block and one row
    log = Log(np.arange(n) / 128, {"a": np.arange(n)[::-1]})  # 1/128 s: exact in binary
    assert Log.load(log.save(tmp_path / "run.csv")) == log


@every_format
def test_the_same_log_gives_the_same_bytes(tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch) -> None:
    first = awkward().save(tmp_path / f"one{suffix}").read_bytes()
    monkeypatch.setattr("time.time", lambda: 0.0)  # a clock read anywhere would now say another time
    monkeypatch.setattr("time.time_ns", lambda: 0)
    assert awkward().save(tmp_path / f"two{suffix}").read_bytes() == first


def test_save_and_load_are_the_same_functions_and_the_suffix_may_be_large(tmp_path: Path) -> None:
    path = awkward().save(str(tmp_path / "run.CSV"))
    assert path == tmp_path / "run.CSV"
    assert Log.load(path) == awkward()


def test_the_home_folder_is_understood(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    assert awkward().save("~/run.csv") == tmp_path / "run.csv"
    assert Log.load("~/run.csv") == awkward()
    assert "home folder" in complaint(lambda: Log.load("~nobody-of-this-name/run.csv"))


# Whole or absent


@every_format
@pytest.mark.parametrize(
    "fault", [RuntimeError("planted"), OSError(28, "No space left on device")], ids=["bug", "full"]
)
def test_a_failure_in_the_middle_leaves_the_old_file_and_nothing_else(
    tmp_path: Path, suffix: str, fault: Exception, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = awkward().save(tmp_path / f"run{suffix}")
    before = path.read_bytes()

    def half(log: Log, stream: object) -> None:
        stream.write(b"half a file")  # pyright: ignore
        raise fault

    monkeypatch.setattr(MODULES[suffix], "write", half)
    with pytest.raises((RuntimeError, InvalidLog), match=r"planted|No space left"):
        Log([0.0], {}).save(path)
    assert path.read_bytes() == before
    assert os.listdir(tmp_path) == [path.name]


@every_format
def test_an_older_file_is_replaced(tmp_path: Path, suffix: str) -> None:
    path = awkward().save(tmp_path / f"run{suffix}")
    log = Log([0.0], {"a": [1.0]})
    assert Log.load(log.save(path)) == log
    assert os.listdir(tmp_path) == [path.name]


@every_format
def test_what_cannot_be_written_is_refused(tmp_path: Path, suffix: str) -> None:
    log, name = Log([0.0], {}), f"run{suffix}"
    assert "there is no folder" in complaint(lambda: log.save(tmp_path / "none" / name))
    (tmp_path / name).mkdir()
    assert "is a folder" in complaint(lambda: log.save(tmp_path / name))
    assert "suffix '.xlsx'; expected one of .parquet, .csv, .mcap" in complaint(lambda: log.save("run.xlsx"))
    assert "called 't'" in complaint(lambda: Log([0.0], {"t": [0.0]}).save(tmp_path / f"a{suffix}"))
    for name in ("a\nb", "a\0b", "\ud800"):
        channels = {name: [0.0]}
        assert "printable" in complaint(lambda c=channels: Log([0.0], c).save(tmp_path / f"a{suffix}"))
    assert os.listdir(tmp_path) == [f"run{suffix}"]


# Other people's tables


@pytest.mark.parametrize(
    "content",
    [
        "t,a\n0,1\n1,\n2,3\n",
        "\ufefft,a\r\n0,1\r\n1,NaN\r\n2,3\r\n",
        "# a comment, with a comma\n\n t , a\n0, 1\n1, nan\n\n2, 3",
        '"a","t"\n1,"0"\nNA,1\n3e0,2.0\n',
    ],
    ids=["plain", "excel", "spaced", "quoted"],
)
def test_a_csv_without_our_note_is_read(tmp_path: Path, content: str) -> None:
    assert Log.load(csv(tmp_path, content)) == Log([0.0, 1.0, 2.0], {"a": [1.0, math.nan, 3.0]})


def test_a_parquet_without_our_note_is_read(tmp_path: Path) -> None:
    fields = [pa.field("a", pa.int32(), metadata={"unit": "V"}), pa.field("t", pa.float32())]
    columns = [pa.array([1, None, 3], pa.int32()), pa.array([0, 1, 2], pa.float32())]
    folder = tmp_path / "robot=2"  # a folder name that dataset readers turn into a column
    folder.mkdir()
    pq.write_table(pa.table(columns, schema=pa.schema(fields)), folder / "run.parquet")
    assert Log.load(folder / "run.parquet") == Log([0, 1, 2], {"a": [1, math.nan, 3]}, {"a": "V"})


@pytest.mark.parametrize(
    "column",
    [
        pa.chunked_array([[1, None], [3]]),
        pa.chunked_array([pa.array([1.0, None, 3.0, None]).slice(1, 2)]),
        pa.chunked_array([pa.nulls(2), pa.nulls(9)]),
        pa.chunked_array([[math.inf], []], pa.float32()),
        pa.chunked_array([], pa.int64()),
    ],
    ids=["chunks", "slice", "nulls", "float32", "empty"],
)
def test_the_numbers_of_a_column_are_those_of_arrow(column: pa.ChunkedArray) -> None:
    theirs = np.asarray(column.cast(pa.float64()).to_numpy(), dtype=np.float64)
    np.testing.assert_array_equal(floats_of(column), theirs)


def test_units_stand_in_the_metadata_of_each_parquet_field(tmp_path: Path) -> None:
    schema = pq.read_schema(Log([0.0], {"truth/pitch": [0.0]}).save(tmp_path / "run.parquet"))
    assert {field.name: field.metadata[b"unit"] for field in schema} == {"t": b"s", "truth/pitch": b"rad"}


def test_the_head_of_a_csv_can_be_read_by_eye(tmp_path: Path) -> None:
    log = Log([0.0, 0.1], {"truth/pitch": [0.1, -0.0], "applied/left": [math.nan, 2]}, origin={"seed": 7})
    assert log.save(tmp_path / "run.csv").read_text() == (
        '# upright-log: {"units": {"truth/pitch": "rad", "applied/left": "V"}, "origin": {"seed": 7}}\n'
        "t,truth/pitch,applied/left\n"
        "0.0,0.1,nan\n"
        "0.1,-0.0,2.0\n"
    )


# MCAP, seen by its own library


def test_an_mcap_has_topics_that_foxglove_and_plotjuggler_plot(tmp_path: Path) -> None:
    log = Log([0.0, 0.01], {"truth/pitch": [0.5, math.nan], "truth/yaw": [1, 2], "push/force": [math.inf, 0]})
    with log.save(tmp_path / "run.mcap").open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True)
        found = list(reader.iter_messages(log_time_order=False))
        notes = [(record.name, json.loads(record.metadata["log"])) for record in reader.iter_metadata()]
    said: dict[str, list[object]] = {}
    for schema, channel, message in found:
        assert schema is not None
        assert (channel.message_encoding, schema.encoding) == ("json", "jsonschema")
        definition = json.loads(schema.data)
        assert definition["type"] == "object"  # Foxglove's condition
        fields = json.loads(message.data)
        assert {name: of["type"] for name, of in definition["properties"].items()} == dict.fromkeys(fields, "number")
        said.setdefault(channel.topic, []).append((message.log_time, message.publish_time, fields))
    ms = 1_000_000  # [ns]
    assert said == {
        "t": [(0, 0, {"value": 0.0}), (10 * ms, 10 * ms, {"value": 0.01})],
        "/truth": [(0, 0, {"pitch": 0.5, "yaw": 1.0}), (10 * ms, 10 * ms, {"pitch": None, "yaw": 2.0})],
        "/push": [(0, 0, {"force": "Infinity"}), (10 * ms, 10 * ms, {"force": 0.0})],
    }
    units = {"truth/pitch": "rad", "truth/yaw": "rad", "push/force": "N"}
    assert notes == [("upright", {"units": units, "origin": {}})]


def test_the_messages_of_an_mcap_are_json_by_the_standard(tmp_path: Path) -> None:
    def refuse(word: str) -> None:
        raise AssertionError(f"{word} is no JSON")

    with awkward().save(tmp_path / "run.mcap").open("rb") as stream:
        for _, _, message in make_reader(stream).iter_messages():
            json.loads(message.data, parse_constant=refuse)


def test_the_times_of_an_mcap_never_run_backwards_and_start_at_zero_if_t_is_negative(tmp_path: Path) -> None:
    log = awkward()  # its t starts at −0.25 s and ends at 7 s
    with log.save(tmp_path / "run.mcap").open("rb") as stream:
        times = [message.log_time for _, _, message in make_reader(stream).iter_messages(log_time_order=False)]
    assert times == sorted(times)
    assert (times[0], times[-1]) == (0, 7_250_000_000)


def test_an_mcap_refuses_times_beyond_its_clock(tmp_path: Path) -> None:
    message = complaint(lambda: Log([0.0, 1e10], {}).save(tmp_path / "run.mcap"))  # 1e19 ns > 2⁶³ = 9.2e18
    assert "64 bits" in message
    assert "save as .parquet or .csv" in message
    assert os.listdir(tmp_path) == []


# What is wrong with it


def test_a_missing_file_a_folder_and_a_wrong_suffix(tmp_path: Path) -> None:
    awkward().save(tmp_path / "push.csv")
    assert "did you mean 'push.csv'?" in complaint(lambda: Log.load(tmp_path / "puhs.csv"))
    assert "no folder" in complaint(lambda: Log.load(tmp_path / "none" / "push.csv"))
    assert "is a folder; expected the file of a log" in complaint(lambda: Log.load(tmp_path))
    (tmp_path / "run.xlsx").write_bytes(b"x")
    assert "suffix '.xlsx'; expected one of .parquet, .csv, .mcap" in complaint(lambda: Log.load(tmp_path / "run.xlsx"))


@every_format
def test_an_empty_file(tmp_path: Path, suffix: str) -> None:
    (tmp_path / f"run{suffix}").touch()
    assert "the file is empty" in complaint(lambda: Log.load(tmp_path / f"run{suffix}"))


@pytest.mark.parametrize("name", ["time", "t_s", "timestamp", "Time [s]", "T"])
@pytest.mark.parametrize("suffix", [".csv", ".parquet"])
def test_a_time_under_another_name_is_pointed_out(tmp_path: Path, suffix: str, name: str) -> None:
    path = tmp_path / f"run{suffix}"
    if suffix == ".csv":
        path.write_text(f"gyro,{name}\n1,0\n")
    else:
        pq.write_table(pa.table({"gyro": [1.0], name: [0.0]}), path)
    message = complaint(lambda: Log.load(path))
    assert f"no column 't' among gyro, {name}; " in message
    assert f"likely the time is '{name}'; try: rename it to 't', in seconds, or make Log(table['{name}'], …)" in message


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("gyro,acc\n1,2\n", "no column 't' among gyro, acc; expected time in seconds in a column 't'"),
        ("t;gyro\n0;1\n", "likely semicolons"),
        ("u;gyro\n0;1\n", "likely semicolons"),
        ("0.0,1.5\n0.1,2\n", "likely no header row"),
        ("t,a\n", "no rows below the header"),
        ("t,a\n\n\n", "the log holds no samples"),
        ("# only a comment\n", "no header row"),
        ("t,a\n0,1\n1,fell\n2,3\n", "column 'a' holds the text 'fell' at row 1 (line 3 of the file)"),
        ("t,a\n2026-01-01,1\n", "holds the text '2026-01-01' at row 0 (line 2 of the file); expected seconds"),
        ("t,a\n0,1\n\n1,2,3\n", "row 1 (line 4 of the file) has 3 values; expected 2"),
        ("t,a,b\n0,1,2\n1,2\n", "row 1 (line 3 of the file) has 2 values; expected 3"),
        ("t,a,a\n0,1,2\n", "column 'a' appears 2 times"),
        ("t,t\n0,1\n", "column 't' appears 2 times"),
        ("t,a\n,1\n,2\n", "t is nan at row 0"),
        ("t,a\nnan,1\nnan,2\n", "t is nan at row 0"),
        ("t,a\n0,1\n1,2\n0.5,3\n", "t goes from 1 to 0.5 s at row 2"),
        (b"t,a\n0,\xff\xfe\n", r"column 'a' holds the text '\xff\xfe' at row 0"),
        (b"t,a\n0,1\x00\n", r"column 'a' holds the text '1\0' at row 0"),
        (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR", "not text in UTF-8; likely a binary file"),
        ("t,a\n0,1\n".encode("utf-16"), "not text in UTF-8"),
        ("# upright-log: {broken\nt,a\n0,1\n", "is no JSON"),
        ('# upright-log: {"units": 3}\nt,a\n0,1\n', "is incomplete"),
        ('# upright-log: [1]\nt,a\n0,1\n', "is incomplete"),
    ],
)  # fmt: skip
def test_a_bad_csv_says_what_is_wrong(tmp_path: Path, content: str | bytes, says: str) -> None:
    path = csv(tmp_path, content)
    message = complaint(lambda: Log.load(path))
    assert message.startswith(f"{path}: ")
    assert says in message


def test_a_zip_called_csv(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "run.csv", "w") as archive:
        archive.writestr("inside.csv", "t,a\n0,1\n")
    assert "a binary file called .csv" in complaint(lambda: Log.load(tmp_path / "run.csv"))


def test_a_fault_deep_in_a_large_csv_is_found(tmp_path: Path) -> None:
    # 150 000 rows are two of the blocks of a megabyte that the fast reader takes; the fault is beyond the first.
    rows = [f"{i},{i}" for i in range(150_000)]
    rows[140_000] = "140000,oops"
    message = complaint(lambda: Log.load(csv(tmp_path, "t,a\n" + "\n".join(rows))))
    assert "'oops' at row 140000 (line 140002 of the file)" in message


@pytest.mark.parametrize(
    ("table", "says"),
    [
        ({"t": [0.0, 1.0], "a": [None, "fell"]}, "column 'a' is string: 'fell' at row 1; expected numbers"),
        ({"t": [0.0], "a": [[1.0, 2.0]]}, "column 'a' is list"),
        ({"t": pa.array([], pa.float64())}, "no samples"),
        ({"t": [None, None], "a": [1.0, 2.0]}, "t is nan at row 0"),
        ({"t": [1.0, 0.0]}, "t goes from 1 to 0 s"),
    ],
)
def test_a_bad_parquet_says_what_is_wrong(tmp_path: Path, table: dict[str, list[object]], says: str) -> None:
    pq.write_table(pa.table(table), tmp_path / "run.parquet")
    assert says in complaint(lambda: Log.load(tmp_path / "run.parquet"))


def test_doubled_columns_in_a_parquet(tmp_path: Path) -> None:
    pq.write_table(pa.Table.from_arrays([pa.array([0.0])] * 3, names=["t", "a", "a"]), tmp_path / "run.parquet")
    assert "column 'a' appears 2 times" in complaint(lambda: Log.load(tmp_path / "run.parquet"))


@pytest.mark.parametrize("suffix", [".mcap", ".parquet"])
def test_a_binary_file_that_was_cut_off_anywhere_is_refused(tmp_path: Path, suffix: str) -> None:
    path = awkward().save(tmp_path / f"run{suffix}")
    whole = path.read_bytes()
    for length in range(1, len(whole), 97):  # 97: a prime, so that cuts fall on every kind of boundary
        path.write_bytes(whole[:length])
        assert "cannot be read" in complaint(lambda: Log.load(path))


@pytest.mark.parametrize("suffix", [".mcap", ".parquet"])
def test_another_kind_of_file_under_the_name_is_refused(tmp_path: Path, suffix: str) -> None:
    path = tmp_path / f"run{suffix}"
    path.write_text("t,a\n0,1\n")
    assert "another kind of file under this name" in complaint(lambda: Log.load(path))


def test_a_changed_byte_in_the_data_of_a_parquet_is_noticed(tmp_path: Path) -> None:
    log = Log(np.arange(100.0), {"a": np.random.default_rng(1).normal(size=100)})  # too irregular to be compressed
    path = log.save(tmp_path / "run.parquet")
    start = pq.read_metadata(path).row_group(0).column(1).dictionary_page_offset  # where the values are
    content = bytearray(path.read_bytes())
    content[start + 200] ^= 1  # well inside the 800 bytes of values
    path.write_bytes(content)
    assert "cannot be read" in complaint(lambda: Log.load(path))


def test_a_changed_byte_in_the_data_of_an_mcap_is_noticed(tmp_path: Path) -> None:
    path = Log([0.0], {"a": [0.0]}, origin={"seed": 1}).save(tmp_path / "run.mcap")
    path.write_bytes(path.read_bytes().replace(b'"seed\\": 1', b'"seed\\": 2').replace(b'"seed": 1', b'"seed": 2'))
    assert "CRC" in complaint(lambda: Log.load(path)).upper()


def test_an_mcap_larger_than_any_log_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its chunks are compressed: a small file may hold more than fits."""
    path = Log(np.arange(1000.0), {"a": np.zeros(1000)}).save(tmp_path / "run.mcap")
    monkeypatch.setattr("upright.signals.mcap.LARGEST", 1 << 14)  # its thousand messages have 16 bytes and more each
    assert "more than 0 MB" in complaint(lambda: Log.load(path))


def mcap_of(path: Path, note: str | None, messages: dict[str, list[object]]) -> Path:
    """An MCAP with JSON messages of our choice, written with nothing of ours."""
    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start()
        if note is not None:
            writer.add_metadata("upright", {"log": note})
        for topic, values in messages.items():
            channel = writer.register_channel(topic, "json", 0)
            for i, value in enumerate(values):
                writer.add_message(channel, log_time=i, data=json.dumps(value).encode(), publish_time=i)
        writer.finish()
    return path


NOTE = '{"units": {"truth/pitch": "rad"}, "origin": {}}'


@pytest.mark.parametrize(
    ("note", "messages", "says"),
    [
        (None, {"t": [{"value": 0}]}, "no metadata record 'upright'; likely a recording of another program"),
        (NOTE, {"/truth": [{"pitch": 0}]}, "no column 't' among /truth"),
        (NOTE, {"t": [{"value": 0}]}, "no topic '/truth' for channel 'truth/pitch'"),
        (NOTE, {"t": [{"value": 0}], "/truth": [{"pitch": "fell"}]}, "'truth/pitch' holds something else than numbers"),
        (NOTE, {"t": [{"value": 0}], "/truth": [3]}, "'truth/pitch' holds something else than numbers"),
        (NOTE, {"t": [{"value": 0}], "/truth": []}, "'truth/pitch' has 0 samples but t has 1"),
        (NOTE, {"t": [{"value": 1}, {"value": 0}], "/truth": [{}, {}]}, "t goes from 1 to 0 s at row 1"),
        ("{", {"t": [{"value": 0}]}, "is no JSON"),
    ],
)
def test_a_bad_mcap_says_what_is_wrong(
    tmp_path: Path, note: str | None, messages: dict[str, list[object]], says: str
) -> None:
    path = mcap_of(tmp_path / "run.mcap", note, messages)
    assert says in complaint(lambda: Log.load(path))


@every_format
def test_a_file_that_the_system_will_not_open(tmp_path: Path, suffix: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = awkward().save(tmp_path / f"run{suffix}")

    def refuse(path: Path) -> Log:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(MODULES[suffix], "read", refuse)
    assert f"{path} cannot be read: Permission denied" in complaint(lambda: Log.load(path))
