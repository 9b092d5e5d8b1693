"""Example logs are always the same, hold what a robot knows, and show what they say they do."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import upright as up
from upright.cli.main import main
from upright.experiment.examples import EXAMPLES, example

FOUND = {
    "gyro-degrees": "units/scale", "gyro-flipped": "motion/flipped", "gyro-behind": "delay/sensor",
    "sides-swapped": "motion/swapped", "rows-lost": "time/dropped",
}  # fmt: skip


@pytest.mark.parametrize("name", ["excited", "standing", "pushed", "fall"])
def test_an_example_shows_what_it_says_and_no_more_than_a_robot_knows(name: str) -> None:
    log = example(name)
    assert not [n for n in log.channels if n.startswith(("truth/", "push/"))]
    swing = np.ptp(np.cumsum(log["sensor/gyro"]) * log.period)
    assert (swing > 1.0) == (name == "fall")  # [rad] a fall turns the body by more than anything that balances
    assert (np.std(log["sensor/gyro"]) > 0.1) == (name != "standing")
    assert up.doctor(log).healthy or name == "fall"
    assert ("excitation/left" in log) == (name == "excited")


@pytest.mark.parametrize("name", list(FOUND))
def test_the_doctor_names_what_was_planted(name: str) -> None:
    assert FOUND[name] in up.doctor(example(name)).codes()


def test_the_command_lists_writes_and_refuses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["example"]) == 0
    listed = capsys.readouterr().out
    assert all(name in listed for name in EXAMPLES)
    assert main(["example", "standing"]) == 0
    assert up.Log.load(tmp_path / "standing.csv") == up.Log.load(example("standing").save(tmp_path / "again.csv"))
    assert main(["example", "stading"]) == 2
    assert "standing" in capsys.readouterr().err


def test_no_pose_is_read_into_a_gyro_that_is_dead() -> None:
    log = example("excited")
    raw = {n: x for n, x in log.channels.items() if n.startswith(("sensor/", "applied/"))}
    dead = up.Log(log.t, raw | {"sensor/gyro": np.zeros(len(log))}, log.units)
    diagnosis = up.doctor(dead)
    assert diagnosis.codes()[0] == "channel/constant"
    assert diagnosis.segments == ()


def test_a_duty_without_a_unit_is_not_shown_as_volts(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = example("excited")
    columns = {"time_ms": 1000 * log.t, "gyro": log["sensor/gyro"]}
    for side in ("left", "right"):
        columns |= {f"enc_{side}": log[f"sensor/encoder_{side}"]}
        columns |= {f"pwm_{side}": np.clip(log[f"applied/{side}"] / 7.5 * 100, -30, 30)}
    table = np.column_stack(list(columns.values()))
    path = tmp_path / "run.csv"
    np.savetxt(path, table, delimiter=",", header=",".join(columns), comments="")
    mapping = tmp_path / "m.toml"
    assert main(["doctor", str(path), "--write-mapping", str(mapping)]) == 0
    shown = capsys.readouterr().out
    assert "30 V" not in shown
    assert "State full duty (100, 255)" in " ".join(shown.split())  # up to 30, a PWM may be of either: none is said
    assert "enc_left" in mapping.read_text()


def test_a_log_that_cannot_be_examined_still_gives_a_draft(tmp_path: Path) -> None:
    path, mapping = tmp_path / "short.csv", tmp_path / "m.toml"
    path.write_text("time,enc_l,enc_r,gyro\n" + "".join(f"{0.01 * k},{k},{k},0\n" for k in range(5)))
    assert main(["doctor", str(path), "--write-mapping", str(mapping)]) == 0
    assert "enc_l" in mapping.read_text()
    assert main(["doctor", str(path)]) == 2


def test_rows_that_came_late_are_reported_by_their_own_times() -> None:
    log = example("excited")
    keep = {n: x for n, x in log.channels.items() if n.startswith(("sensor/", "applied/"))}
    origin = {"controller": {"period": 0.01}, "outcome": {"late": 30}}
    slow = up.Log(1.2 * log.t, keep, log.units, origin)
    finding = next(f for f in up.doctor(slow).findings if f.code == "time/pace")
    assert finding.facts == {"late": 30, "rows": 1199, "median": pytest.approx(0.012), "period": 0.01}
    assert "time/pace" not in up.doctor(up.Log(log.t, keep, log.units, {**origin, "outcome": {"late": 0}})).codes()
