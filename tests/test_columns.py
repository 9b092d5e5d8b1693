"""Columns without names are found by the robot's own motion, whatever their order, unit and sign."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import upright as up
from upright.cli.main import main
from upright.doctor.columns import by_physics
from upright.experiment.examples import example
from upright.logs.mapping import Mapping
from upright.logs.readers import RawTable

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
    assert by_physics(RawTable({"t": 0.01 * np.arange(1000), **walks})) is None


def test_the_doctor_says_which_columns_it_took_and_writes_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, written = tmp_path / "run.csv", tmp_path / "mine.toml"
    rows = np.column_stack(list(table("an NXT's whole numbers").columns.values()))
    path.write_text("\n".join(",".join(f"{x:g}" for x in row) for row in rows) + "\n")
    assert main(["doctor", str(path), "--write-mapping", str(written)]) == 0
    shown = " ".join(capsys.readouterr().out.split())
    assert "sensor/gyro = c4 (deg/s)" in shown
    assert "columns/unnamed" in shown
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
