"""`upright start`: from nothing to a verdict with piped answers, interrupted and gone on with."""

from __future__ import annotations

import contextlib
import io
import json
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import pytest

from conftest import PATIENCE
from upright.certification import certificate
from upright.cli import guide
from upright.cli.guide import STATE
from upright.cli.main import main
from upright.control import make_controller, write_controller
from upright.errors import UprightError
from upright.robots import find_robot
from upright.robots.kit import find_kit

START = (sys.executable, "-m", "upright", "start")


@pytest.fixture
def started(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """`started(answers, folder)`: what `upright start` prints in that folder; less is simulated and drawn, and nothing
    is analysed."""
    executed = guide._executed

    def here(command: Sequence[str], folder: Path) -> int:
        if command[0] != "design":
            return executed(command, folder)
        with contextlib.chdir(folder):
            _, method, _, name, _, file = command  # without its analysis, which takes longest
            robot = find_robot(name)
            kit = find_kit(robot.kit_name)
            write_controller(make_controller(method, robot, kit, kit.period), file)
            return 0

    def started(answers: str, folder: str = ".", robot: str | None = None) -> str:
        monkeypatch.setattr("sys.stdin", io.StringIO(answers))
        guide.start(Path(folder), robot=robot, samples=100)  # the fewest that bound a fall to a few per cent
        return capsys.readouterr().out

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(guide, "_executed", here)
    monkeypatch.setattr(guide, "PUSH", "--push hold:0.1,until=1 --seconds 2")
    monkeypatch.setattr(certificate, "certify", partial(certificate.certify, sweeps=False))
    return started


def printed_commands(text: str) -> list[list[str]]:
    return [
        shlex.split(line[2:].removesuffix("   (done before)"))
        for line in text.splitlines()
        if line.startswith("$ upright ")
    ]


def test_a_simulated_robot_comes_to_a_verdict_and_goes_on_where_it_stopped(started, tmp_path):
    """Enter takes what is usual. The answers end at the simulation; the second call asks for the rest alone."""
    first = started("\n\nnonsense\nlqg\n")
    assert "no controller is called 'nonsense'" in first
    assert "`upright start` goes on from here" in first
    assert [line[1] for line in printed_commands(first)] == ["design"]
    second = started("nonlinear\n")
    commands = printed_commands(second)
    assert [line[1] for line in commands] == ["design", "simulate", "certify"]
    assert second.count("(done before)") == 1
    assert json.loads((tmp_path / "certificate.json").read_text())["light"] == "green"
    assert "Verdict: green" in second
    assert (tmp_path / "run.html").exists()
    third = started("")  # all is answered and done
    assert third.count("(done before)") == 3
    assert "Verdict: green" in third


@pytest.mark.parametrize("light", ["red", "unknown"])
def test_what_a_certificate_refuses_is_not_flown_next(tmp_path, capsys, light):
    (tmp_path / "certificate.json").write_text(json.dumps({"light": light}))
    guide._conclude(guide.GuidedStudy(tmp_path, {"where": "here", "brick": "nxt"}))
    assert "fly" not in capsys.readouterr().out


@pytest.mark.evidence
def test_a_log_is_examined_calibrated_and_certified(started, tmp_path):
    run = started("nxtway-gs\nlog\nno-such.csv\nexample\nnone\nlqr\n", "study")
    assert "$ cd study" in run
    assert "there is no file no-such.csv" in run
    assert [line[1] for line in printed_commands(run)] == ["example", "doctor", "calibrate", "design", "certify"]
    assert "Verdict: " in run
    assert (tmp_path / "study" / "mine.toml").exists()


def test_a_step_that_fails_asks_its_question_again(tmp_path, monkeypatch, capfd):
    """A file that is no log ends the doctor with exit code 2; the answer is forgotten, and the rest kept."""
    (tmp_path / "bad.csv").write_bytes(b"\x00\x01")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", io.StringIO("\nlog\nbad.csv\nnone\n"))
    assert main(["start"]) == 2
    complaints = capfd.readouterr().err
    assert "asks again for log" in complaints
    assert "Traceback" not in complaints
    assert set(json.loads((tmp_path / STATE).read_text())["answers"]) == {"robot", "where"}


def test_a_robot_is_looked_for_from_where_one_stands(started, tmp_path):
    """The commands run in the folder of the study, and find it there too."""
    (tmp_path / "mine.toml").write_text(find_robot("ev3way").save(tmp_path / "x.toml").read_text())
    (tmp_path / "work").mkdir()
    with contextlib.chdir(tmp_path / "work"):
        said = started("simulated\nlqr\n", "study", "../mine.toml")
    (design,) = printed_commands(said)
    assert design[:5] == ["upright", "design", "lqr", "--robot", "../../mine.toml"]
    assert (tmp_path / "work" / "study" / "controller.json").exists()


def test_a_log_whose_columns_nobody_knows_asks_for_a_mapping_and_goes_on(started, tmp_path):
    """The doctor drafts one; whoever completes it answers with it, and the same log is read."""
    rows = "".join(f"{k},{k + 1},{2 * k}\n" for k in range(9))
    (tmp_path / "own.csv").write_text("a,b,c\n" + rows)
    with pytest.raises(UprightError, match=r"complete mapping\.toml and answer with it: upright start"):
        started("\nlog\nown.csv\nnone\n")
    assert "?" in (tmp_path / "mapping.toml").read_text()
    (tmp_path / "done.toml").write_text("name = 'mine'\n")
    with pytest.raises(UprightError):
        started("done.toml\n")
    state = json.loads((tmp_path / STATE).read_text())
    assert "doctor own.csv --robot nxtway-gs --write-mapping mapping.toml" in state["done"]
    assert state["answers"]["log"] == "own.csv"


def test_a_log_that_does_not_tell_the_robot_tests_its_file(started, monkeypatch, tmp_path):
    """A calibration that is refused writes no robot; the study goes on with the numbers of the file, and says so."""
    (tmp_path / "quiet.csv").write_text("t\n0\n")
    answers = "\nlog\nquiet.csv\nnone\nnone\nlqr\n"
    monkeypatch.setattr(guide, "_executed", lambda command, _: 3 if command[0] in ("calibrate", "certify") else 0)
    (tmp_path / "certificate.json").write_text('{"light": "unknown"}')
    said = started(answers)
    commands = printed_commands(said)
    assert [line[1] for line in commands] == ["doctor", "calibrate", "design", "certify"]
    assert "does not tell this robot" in said
    assert commands[-1][3:7] == ["--robot", "nxtway-gs", "--log", "quiet.csv"]


def test_without_answers_it_stops_and_says_how_to_go_on(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.stdin", (tmp_path / "none").open("w+"))
    assert main(["start"]) == 0
    assert "goes on from here" in capsys.readouterr().out


def test_a_broken_state_is_one_line(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for text in ("{", "[]", '{"answers": 3, "done": []}'):
        Path(STATE).write_text(text)
        assert main(["start"]) == 2
        assert "delete" in capsys.readouterr().err


@pytest.mark.skipif(sys.platform == "win32", reason="a signal to another process")
def test_ctrl_c_keeps_what_was_answered(tmp_path):
    """While it waits for the third answer."""
    process = subprocess.Popen(
        START, cwd=tmp_path, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdin
    process.stdin.write("ev3way\nsimulated\n")
    process.stdin.flush()
    end, state = time.monotonic() + PATIENCE, tmp_path / STATE
    while not (state.exists() and "where" in state.read_text()):
        assert time.monotonic() < end
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, wrong = process.communicate(timeout=PATIENCE)
    assert process.returncode == 130
    assert "Traceback" not in wrong
    assert "the answers are kept: `upright start` goes on from here" in wrong
    assert json.loads((tmp_path / STATE).read_text())["answers"] == {"robot": "ev3way", "where": "simulated"}
