"""What a result says to run next works when it is typed, is not what was typed, and changes something."""

from __future__ import annotations

import json
import shlex
from collections.abc import Sequence
from pathlib import Path

import pytest

import upright
from upright.cli.main import group, main
from upright.cli.output import WRITTEN, continued
from upright.cli.typed import GIVEN, TYPED
from upright.control import CONTROLLERS
from upright.logs.mapping import find_mapping
from upright.pages import Next, Page, Say
from upright.pages.blocks import is_placeholder
from upright.robots import find_kit, find_robot

FOUND = {"robot": find_robot, "kit": find_kit, "mapping": find_mapping}
"""What finds a robot, a kit and a mapping by the name of its option; it raises where there is none."""
MADE = ("standing", "excited", "pushed", "fall", "gyro-degrees", "gyro-flipped", "gyro-behind", "rows-lost")
CASES = {
    "a robot that is no preset": "weak-gain/log.csv",
    "motors that are off": "motors-off/wrap.csv",
    "a free fall": "motors-off/freefall.csv",
    "a late gyro": "late-loop/run.csv",
    "a duty of nobody knows what": "pwm-and-battery/mylog_vbat.csv",
    "pushes by hand": "hand-pushed/p2.csv",
    "a gyro of half its scale": "half-gyro/known_1_5_gyro_scale.csv",
}
"""Logs whose owners were told what to run next (shared/cases/README.md)."""


def following(typed: str, capsys: pytest.CaptureFixture[str]) -> list[list[str]]:
    """The commands to run next after the one that was typed, as words."""
    capsys.readouterr()
    code = main([*shlex.split(typed), "--json"])
    said = capsys.readouterr()
    assert code in (0, 3), f"upright {typed}: {said.err}"
    return [shlex.split(command)[1:] for command in json.loads(said.out)["head"]["next"]]


def check(words: Sequence[str]) -> None:
    """Read the command as the command line does, and find what it names."""
    context = group().make_context("upright", list(words))
    name, command, rest = group().resolve_command(context, list(words))
    assert command
    rest = ["1" if word == "KG" else word for word in rest]  # a number, which has no letters
    given = command.make_context(name, rest, parent=context).params  # which refuses what it does not know
    for option, value in given.items():
        if value is None or is_placeholder(Path(str(value)).name):
            continue
        if option in FOUND:
            FOUND[option](value)
        elif option in ("log", "excite"):
            assert Path(value).exists(), words
        elif option in ("logs", "controllers"):
            assert all(is_placeholder(str(one)) or Path(one).exists() for one in value), words
        elif option == "controller" and isinstance(value, str):
            assert value in CONTROLLERS or Path(value).exists(), words
        elif option in WRITTEN:
            assert not Path(value).exists(), words


def told(typed: str, capsys: pytest.CaptureFixture[str]) -> list[list[str]]:
    """What follows, of which nothing is refused, unknown or what was typed already."""
    steps = following(typed, capsys)
    for words in steps:
        assert words != shlex.split(typed)
        check(words)
    return steps


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("name", MADE)
def test_the_doctor_of_an_example(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["example", name]) == 0
    assert told(f"doctor {name}.csv", capsys)


@pytest.mark.needs("shared/cases")
@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_the_doctor_of_an_owners_log(case: str, shared: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = shared / "cases" / case
    assert told(f"doctor {log}", capsys)
    for step in ("--write-mapping m.toml", "--mapping m.toml"):
        told(f"doctor {log} {step}", capsys)


@pytest.mark.needs("shared/cases")
def test_a_mapping_that_asks_for_numbers_holds_them_in_comments(
    shared: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without their marks of a comment its lines, which are for 1496 counts and a duty of 255, are what is asked for:
    those of the owner's mapping, within the digits of a comment."""
    case = shared / "cases" / "hand-pushed"
    ((*_, file),) = told(f"doctor {case / 'p2.csv'} --write-mapping m.toml", capsys)
    lines = Path(file).read_text("utf-8").splitlines()
    Path(file).write_text("\n".join(line.removeprefix("# ") for line in lines), "utf-8")
    made, owners = (upright.doctor(case / "p2.csv", mapping=one).read for one in (file, case / "m.toml"))
    for name in ("sensor/encoder_left", "sensor/encoder_right", "command/left"):
        ratio = abs(made[name]).max() / abs(owners[name]).max()
        assert ratio == pytest.approx(11.1 / 11.4 if "command" in name else 1.0, rel=1e-3)


@pytest.mark.parametrize(
    "typed",
    [
        "linearise", "linearise --robot ev3way", "design lqr",
        "design lqg -o lqg.json", "simulate --seconds 1", "simulate -o run.csv", "simulate --feedback 0,0,0,0,0,0",
        "fleet --samples 20 --seconds 2",
    ],
)  # fmt: skip
def test_a_result_without_a_log(typed: str, capsys: pytest.CaptureFixture[str]) -> None:
    told(typed, capsys)


def test_a_table_that_was_written_is_not_to_be_written_again(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["example", "handed-in"]) == 0
    assert told("grade handed-in -o mine.csv", capsys) == []
    Path("grades.csv").touch()
    ((*_, file),) = told("grade handed-in", capsys)
    assert file == "grades-2.csv"


def test_a_repair_that_was_written_is_examined(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["example", "gyro-behind"]) == 0
    assert told("doctor gyro-behind.csv --fix repaired.csv", capsys) == [["doctor", "repaired.csv"]]


@pytest.mark.parametrize(
    ("step", "command"),
    [
        (Next("certify", "lqg", robot="esp32-jga25"), "certify lqg --robot ROBOT"),  # as a log called it
        (Next("certify", "lqg", robot="mine"), "certify lqg --robot mine.toml"),
        (Next("certify", "lqg", robot="robot.toml"), "certify lqg --robot robot.toml"),  # written at the end of a run
        (Next("calibrate", "a.csv", output="mine.toml"), "calibrate a.csv --output mine-2.toml"),
    ],
)
def test_a_robot_is_named_by_what_finds_it_and_no_file_is_written_over(step: Next, command: str) -> None:
    Path("mine.toml").touch()
    assert continued(Page(Say("number"), next=[step])).next[0].command == f"upright {command}"


def test_what_is_measured_goes_into_another_file_than_the_one_that_was_typed() -> None:
    tokens = GIVEN.set({"controller": "lqg", "robot": "a.toml"}), TYPED.set(["certify", "lqg", "--robot", "a.toml"])
    (step,) = continued(Page(Say("number"), next=[Next("certify", "lqg", robot="MEASURED.toml")])).next
    assert step.command == "upright certify lqg --robot MEASURED.toml"
    assert continued(Page(Say("number"), next=[Next("certify", "lqg", robot="a.toml")])).next == []
    for variable, token in zip((GIVEN, TYPED), tokens, strict=True):
        variable.reset(token)


@pytest.mark.evidence
@pytest.mark.parametrize(
    "typed",
    [
        "certify lqr", "certify lqg --robot own.toml", "certify pid --robot own.toml", "certify lqg --log excited.csv",
        "calibrate excited.csv", "calibrate excited.csv -o robot.toml", "calibrate pushed.csv --between-knocks",
        "calibrate excited.csv --robot own.toml", "validate nxtway-gs excited.csv", "identify excited.csv",
        "post-mortem fall.csv", "tune lqr --budget 4 --samples 100", "push-map --samples 4", "excite -o plan.json",
        "bench-controllers lqr lqg", "reproduce --log pushed.csv --robot nxtway-gs -o paper", "compare excited.csv",
    ],
)  # fmt: skip
def test_a_result_that_takes_its_time(typed: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["robots", "new", "own"]) == 0
    for name in ("excited", "pushed", "fall"):
        assert main(["example", name]) == 0
    told(typed, capsys)


@pytest.mark.evidence
@pytest.mark.needs("shared/cases")
@pytest.mark.parametrize("case", CASES.values(), ids=CASES.keys())
def test_whoever_runs_what_is_next_does_not_go_round_in_circles(
    case: str, shared: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """From the diagnosis of a log to a placeholder, a certificate or a calibration, and through nothing twice."""
    seen: list[list[str]] = []
    left = [["doctor", str(shared / "cases" / case)]]
    while left:
        words = left.pop()
        assert words not in seen
        seen.append(words)
        more = told(shlex.join(words), capsys)
        left += [one for one in more if one[0] in ("doctor", "post-mortem") and not any(map(is_placeholder, one))]
    assert len(seen) < len(CASES)
