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
