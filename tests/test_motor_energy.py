"""No motor gives more power than it takes: what drives a robot refuses such a file, what computes says so first."""

from __future__ import annotations

from pathlib import Path

import pytest

from conftest import SHARED
from upright.cli.main import main
from upright.robots import Provenance, Robot, preset_names
from upright.robots.motor import makes_energy

NXT = Robot.preset("nxtway-gs")


def geared(factor: float) -> Robot:
    """The preset with a gear of 9.7, and a torque constant that is `factor` times what its back-EMF allows."""
    numbers = {"gear_ratio": 9.7, "torque_constant": factor * NXT.back_emf / 9.7}
    sources = {name: Provenance("measured", 0.05 * value) for name, value in numbers.items()}
    return NXT.replace(**numbers, provenance={**NXT.provenance, **sources})


# 5 % of both numbers are 7 % of their product, and the back-EMF's own 5 % make 9: three of them are a quarter
@pytest.mark.parametrize(("factor", "makes"), [(0.7, False), (1.0, False), (1.1, False), (3.3, True), (9.7, True)])
def test_a_torque_constant_above_the_back_emf_is_told(factor: float, makes: bool) -> None:
    assert bool(makes_energy(geared(factor))) == makes


@pytest.mark.parametrize("name", preset_names())
def test_shipped_motors_are_motors(name: str) -> None:
    assert makes_energy(Robot.preset(name)) == ""


def test_what_drives_refuses_and_what_computes_warns(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = str(geared(3.3).save(tmp_path / "robot.toml"))
    for command in (["certify", "lqr"], ["firmware", "lqr", "--target", "nxc"]):
        assert main([*command, "--robot", file]) == 2
        (line,) = capsys.readouterr().err.strip().splitlines()
        assert "makes energy" in line
        assert "other side of the gear" in line
    for command in (["linearise"], ["simulate", "-s", "0.5"], ["design", "lqr"]):
        assert main([*command, "--robot", file]) == 0
        assert "makes energy" in capsys.readouterr().err


@pytest.mark.needs("shared/cases/kt-above-kb")
@pytest.mark.parametrize(("name", "makes"), [("as-published", True), ("true", False)])
def test_a_robot_as_published_is_told_from_the_measured_one(name: str, makes: bool) -> None:
    """3.3 times the back-EMF in the script, equal where it was measured."""
    assert bool(makes_energy(Robot.load(SHARED / "cases" / "kt-above-kb" / f"{name}.toml"))) == makes
