"""What a certificate allows: this controller, this robot, this kit, this period, on every processor, and nothing else."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from firmware_cases import NXT, ROBOT, frozen
from upright.atomic import write_json
from upright.certify.certificate import Certificate, certify
from upright.cli.main import USER_ERROR, main
from upright.control import write_controller
from upright.robots import Kit, Robot


@cache
def certificate(kit: str = "nxt", **changes: float) -> Certificate:
    """Of the frozen design, for a hundred robots that are all known."""
    robot = ROBOT.replace(**changes)
    return certify(frozen(), robot, Kit.preset(kit), robots=[robot] * 100, sweeps=False)


def firmware(tmp_path: Path, given: Certificate, *options: str) -> int:
    write_controller(frozen(), tmp_path / "controller.json")
    write_json(tmp_path / "certificate.json", given.to_json())
    names = [str(tmp_path / name) for name in ("controller.json", "balance.nxc", "certificate.json")]
    return main(["firmware", names[0], "-t", "nxc", "-o", names[1], "--certificate", names[2], *options])


def test_a_certificate_of_this_robot_and_kit_is_accepted(tmp_path: Path) -> None:
    assert certificate().light == "green"
    assert firmware(tmp_path, certificate()) == 0


def test_a_robot_of_other_numbers_is_refused_by_firmware(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert firmware(tmp_path, certificate(wheel_radius=0.041, com_height=0.08)) == USER_ERROR
    said = capsys.readouterr().err
    assert len(said.strip().splitlines()) == 1
    assert "wheel_radius 0.04 instead of 0.041" in said
    assert f"com_height {ROBOT.com_height:g} instead of 0.08" in said
    assert "wheel_mass" not in said
    assert not (tmp_path / "balance.nxc").exists()


def test_another_kit_is_refused_by_firmware(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert certificate("ideal").light == "green"
    assert firmware(tmp_path, certificate("ideal")) == USER_ERROR
    said = capsys.readouterr().err
    assert "kit nxt instead of ideal" in said
    assert "motor/limit" in said
    assert firmware(tmp_path, certificate("ideal"), "--anyway") == 0


def test_a_robot_of_another_file_is_refused_in_flight(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Its name is the same: only its numbers tell it."""
    other = ROBOT.replace(body_mass=0.7).save(tmp_path / "robot.toml")
    assert firmware(tmp_path, certificate()) == 0
    files = [str(tmp_path / name) for name in ("balance.nxc", "controller.json")]
    call = ["fly", *files, "--yes", "--certificate", str(tmp_path / "certificate.json"), "--robot", str(other)]
    assert main(call) == USER_ERROR
    assert "body_mass 0.7 instead of 0.6" in capsys.readouterr().err


def test_another_period_is_named() -> None:
    slower = replace(frozen(), period=0.02)
    assert "period 0.02 s instead of 0.01 s" in certificate().refuses(slower, ROBOT, NXT)


def test_a_name_is_no_difference() -> None:
    assert certificate().refuses(frozen(), ROBOT.replace(name="renamed"), replace(NXT, name="renamed")) == ""


def test_a_certificate_that_names_no_robot_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = {k: v for k, v in certificate().to_json().items() if k != "subject"} | {"version": 1}
    write_json(tmp_path / "old.json", data)
    write_controller(frozen(), tmp_path / "controller.json")
    call = ["firmware", str(tmp_path / "controller.json"), "-t", "nxc", "--certificate", str(tmp_path / "old.json")]
    assert main(call) == USER_ERROR
    assert "certify it again" in capsys.readouterr().err
