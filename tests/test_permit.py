"""What a certificate allows: this controller, robot, kit and period, on every processor, and nothing else."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from firmware_cases import NXT, ROBOT, frozen
from upright.atomic import write_json
from upright.certification.certificate import Certificate, certify
from upright.certification.checks import PushTrial
from upright.certification.design import design
from upright.cli.main import USER_ERROR, main
from upright.control import (
    CONTROLLERS,
    LinearController,
    controller_hash,
    find_controller,
    read_controller,
    write_controller,
)
from upright.control.identity import identity
from upright.firmware.program_file import read_program
from upright.likelihood.assumptions import BATTERIES
from upright.pages import html
from upright.robots import Kit


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
    assert "battery/voltage" in said
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
    data = {k: v for k, v in certificate().to_json().items() if k != "subject"} | {"schema": "upright/certify/1"}
    write_json(tmp_path / "old.json", data)
    write_controller(frozen(), tmp_path / "controller.json")
    call = ["firmware", str(tmp_path / "controller.json"), "-t", "nxc", "--certificate", str(tmp_path / "old.json")]
    assert main(call) == USER_ERROR
    assert "make it anew with upright certify" in capsys.readouterr().err


def on_kernel(kernel: str, *arguments: str) -> None:
    """A command with the matrix routines of another processor, as OpenBLAS has them."""
    from os import environ

    command = [sys.executable, *arguments]
    subprocess.run(command, env={**environ, "OPENBLAS_CORETYPE": kernel}, check=True, capture_output=True)


WRITTEN = """
import sys
from upright.control import make_controller, write_controller
from upright.robots import Kit, Robot
kit = Kit.preset("nxt")
write_controller(make_controller("lqg", Robot.preset("nxtway-gs"), kit, kit.period), sys.argv[1])
"""


@pytest.fixture(scope="module")
def elsewhere(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a design, and a program of it, each of another processor."""
    folder = tmp_path_factory.mktemp("elsewhere")
    # the design alone: `upright design` analyses it, too
    on_kernel("Nehalem", "-c", WRITTEN, str(folder / "nehalem.json"))
    on_kernel("Sandybridge", "-m", "upright", "firmware", "lqg", "-t", "nxc", "-o", str(folder / "balance.nxc"))
    return folder


def test_a_design_is_the_same_on_every_processor(elsewhere: Path) -> None:
    """Its numbers differ in their last digits, and with them its hash; what was asked for does not."""
    here, there = find_controller("lqg", ROBOT, NXT, NXT.period), read_controller(elsewhere / "nehalem.json")
    if controller_hash(here) == controller_hash(there):
        pytest.skip("this processor computes as Nehalem does")
    assert identity(here).differs(identity(there)) == ""
    given = certify("lqg", ROBOT, NXT, robots=[ROBOT] * 100, sweeps=False)
    assert given.refuses(there, ROBOT, NXT) == ""
    assert read_program(elsewhere / "balance.nxc", "lqg").controller.spec.kind == "lqg"
    assert read_program(elsewhere / "balance.nxc", there).robot == ROBOT


def test_a_flight_of_a_program_made_elsewhere_knows_its_log(elsewhere: Path) -> None:
    file = read_program(elsewhere / "balance.nxc", "lqg")
    assert file.program.hash == file.head["hash"]


def test_another_design_with_nearly_the_same_numbers_is_another_controller() -> None:
    """Asked for with a radius that differs by a nanometre: the commands differ by less than the tolerance."""
    near = CONTROLLERS["lqg"](ROBOT.replace(wheel_radius=0.04 + 1e-12), NXT, NXT.period)
    here = CONTROLLERS["lqg"](ROBOT, NXT, NXT.period)
    assert "asked" in identity(here).differs(identity(near))
    assert identity(here).differs(identity(CONTROLLERS["lqg"](ROBOT, NXT, NXT.period))) == ""


def test_numbers_that_do_not_come_from_what_was_asked_for_are_another_controller(tmp_path: Path) -> None:
    """A file whose gains were changed by a hundred-thousandth, with a hash that fits them."""
    here = CONTROLLERS["lqg"](ROBOT, NXT, NXT.period)
    path = write_controller(here, tmp_path / "c.json")
    data = json.loads(path.read_text())
    data["controller"]["C"] = [[1.00001 * x for x in row] for row in data["controller"]["C"]]
    data["hash"] = controller_hash(LinearController.from_json(data["controller"]))
    path.write_text(json.dumps(data))
    assert "commands differ" in identity(read_controller(path)).differs(identity(here))


def test_what_was_asked_for_is_forgotten_by_a_change() -> None:
    here = CONTROLLERS["lqg"](ROBOT, NXT, NXT.period)
    changed = replace(here, C=1.0000001 * here.C)  # type: ignore[type-var, attr-defined]
    assert identity(changed).differs(identity(here)) != ""


def test_what_nobody_survived_has_no_number() -> None:
    """Quantiles of the robots that stand, of which there are none."""
    trial = PushTrial("hold", "low", 100, 100, saturated=0.0, travel=0.0, peak=0.0, cycle=0.0, size=0.1)
    page = html.document(replace(certificate(), trials=(trial,)).page())
    *_, row = page.partition("Every push")[2].partition("</table>")[0].split("<tr>")
    cells = re.findall(r"<td[^>]*>([^<]*)</td>", row)
    low = f"low, {BATTERIES['low'] * NXT.battery.voltage:.1f}\u00a0V"
    assert cells == ["knock of 0.1\u00a0N\u00a0s", low, "100", "0", "–"]


def test_a_certificate_has_a_figure() -> None:
    """The bound on all pushes, then a bar for each push at each battery, the worst first, as on its page."""
    trials = [PushTrial("knock", "low", 100, fell, saturated=0.0, travel=0.0, peak=0.0, cycle=0.0, size=0.1 * fell)
              for fell in (1, 30, 7)]  # fmt: skip
    result = replace(certificate(), trials=tuple(trials))
    (ax,) = result.plot().axes
    assert [bar.get_width() for bar in ax.patches] == [100 * result.bound, 30, 7, 1]
    names = [label.get_text() for label in ax.get_yticklabels()]
    assert names[1] == "knock of 3\u00a0N\u00a0s, low battery"
    picture = html.document(result.page()).partition("</figure>")[0]
    assert all(name in picture for name in names)


def test_a_design_prints_numbers_as_far_as_they_mean_something() -> None:
    text = str(design("lqg", ROBOT, NXT))
    assert max(len(word) for word in re.findall(r"[0-9.e+-]+", text) if "." in word) <= 9
    assert "\n\n\n" not in text
