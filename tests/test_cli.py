"""The command line: quick to start, and every mistake of a user is one clear line and exit code 2."""

from __future__ import annotations

import json
import math
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from conftest import PATIENCE
from upright.atomic import write_json
from upright.cli import main as cli
from upright.cli.destination import Destination
from upright.cli.help import EXAMPLES
from upright.cli.main import BUG, USER_ERROR, group, main
from upright.cli.mistyped import RETIRED
from upright.cli.output import goes_on_from
from upright.cli.vocabulary import complete_controller, complete_kit, complete_robot
from upright.control import CONTROLLERS, make_controller, write_controller
from upright.errors import InvalidLog, UprightError
from upright.pages import Page, Result, Say, Verdict
from upright.progress import progress
from upright.reading import check_schema
from upright.robots import PARAMETERS, Kit, Robot, kit_names
from upright.robots.drives import UNUSED

TIME = "t,truth/pitch,truth/pitch_rate,truth/wheel,truth/wheel_rate,truth/yaw,truth/yaw_rate\n"
ROW = ",0,0,0,0,0,0\n"

FILES = {
    "good.csv": TIME + "".join(f"{0.01 * k:.2f}{ROW}" for k in range(5)),
    "later.csv": TIME + "".join(f"{9 + 0.01 * k:.2f}{ROW}" for k in range(5)),
    "nan.csv": TIME + "0" + ROW + "nan" + ROW,
    "backwards.csv": TIME + "0.01" + ROW + "0.00" + ROW,
    "no-time.csv": "seconds,truth/pitch\n0,0\n0.01,0\n",
    "wrong-column.csv": "t,truth/lean\n0,0\n0.01,0\n",
    "words.csv": "t,truth/pitch\n0,upright\n",
    "empty.csv": "",
    "header.csv": TIME,
    "broken.parquet": "this is no Parquet file",
    "broken.mcap": "nor is this MCAP",
    "log.docx": "t\n0\n",
    "broken.toml": "name = \n",
    "unknown-field.toml": 'name = "x"\nwheel_count = 2\n',
    "nan-gain.json": '{"gain": [[1, 2, 3, 4, 5, NaN], [1, 2, 3, 4, 5, 6]]}',
    "flat-gain.json": '{"gain": [1, 2, 3, 4, 5, 6]}',
    "no-gain.json": '{"K": []}',
    "not.json": "{",
}
"""What the mistaken calls below are given to read, by file name."""

BAD = {
    "unknown command": ("simulat", "Did you mean 'simulate'"),
    "command unlike any": ("campaign", "'campaign'; try: upright --help"),
    "unknown option": ("simulate --xyz 1", "--xyz; try: upright simulate --help"),
    "missing argument": ("compare", "LOG'; try: upright compare run.csv"),
    "missing value": ("simulate --seconds", "--seconds"),
    "an option in place of a value": ("simulate --robot --seconds 2", "'--robot' requires an argument"),
    "missing argument of one command of several": ("robots new", "try: upright robots new mine"),
    "a robot without a name": ("robots new .", "'.' is no name"),
    "missing option": ("firmware lqg", "try: upright firmware lqg --target nxc"),
    "more than a number may be": ("identify good.csv --order 99", "--order: '99'; expected 50 or less"),
    "one wrong name of a hundred": ("fleet --vary com_heigt=±10%", "'com_heigt'; try: did you mean 'com_height'?"),
    "a varied number that is none": (
        "fleet --vary com_height=a..b",
        "--vary 'com_height=a..b': 'a'; expected a finite number",
    ),
    "a word for a number": ("simulate --seconds long", "--seconds"),
    "unknown robot": ("simulate --robot nxtway", "nxtway-gs"),
    "unknown robot shown": ("robots show segway", "segway"),
    "missing robot file": ("linearise --robot missing.toml", "missing.toml"),
    "robot file that is no TOML": ("linearise --robot broken.toml", "broken.toml"),
    "robot file with an unknown field": ("robots show unknown-field.toml", "wheel_count"),
    "unknown body": ("simulate --body twinn", "twin"),
    "unknown kit": ("simulate --kit lego", "lego"),
    "a controller without its option": ("push-map lqg", "--controller lqg"),
    "a robot without its option": ("certify lqg twipr", "--robot twipr"),
    "a word that no option has": ("basin fast", "upright basin --help"),
    "unknown controller": ("simulate --controller pidd", "pidd"),
    "a start in degrees": ("simulate --start pitch=9", "--start"),
    "a fleet's start in degrees": ("fleet --start pitch=9", "9 rad of pitch in --start"),
    "a basin's start in degrees": ("basin --start pitch=9", "9 rad of pitch in --start"),
    "a mapping that is there": ("doctor good.csv --write-mapping broken.toml", "broken.toml exists already"),
    "negative seconds": ("simulate --seconds -1", "-1 s"),
    "no seconds": ("simulate --seconds 0", "0 s"),
    "seconds that are not a number": ("simulate --seconds nan", "nan"),
    "endless run": ("simulate --seconds inf", "inf"),
    "fewer seconds than a period": ("simulate --seconds 0.001", "0.001"),
    "negative period": ("simulate --period -0.01", "-0.01"),
    "period that does not divide": ("simulate --kit ideal --period 0.0105", "0.0105"),
    "five gains": ("simulate --feedback 1,2,3,4,5", "six"),
    "a word among the gains": ("simulate --feedback 1,2,3,4,5,yaw", "yaw"),
    "NaN among the gains": ("simulate --feedback 1,2,3,4,5,nan", "nan"),
    "gain file of six numbers": ("simulate --feedback flat-gain.json", "(2, 6)"),
    "gain file with NaN": ("simulate --feedback nan-gain.json", "NaN"),
    "gain file without a gain": ("simulate --feedback no-gain.json", "gain"),
    "gain file that is no JSON": ("simulate --feedback not.json", "not.json"),
    "missing gain file": ("simulate --feedback missing.json", "missing.json"),
    "controller and gains": ("simulate --controller lqr --feedback 1,2,3,4,5,6", "--feedback"),
    "push without a kind": ("simulate --push 0.1", "hold:0.1"),
    "unknown push": ("simulate --push shove:0.1", "shove"),
    "hold without an end": ("simulate --push hold:0.1", "until"),
    "hold in degrees": ("simulate --push hold:6,until=1", "degrees"),
    "hold that ends before it starts": ("simulate --push hold:0.1,start=2,until=1", "end after"),
    "push with an unknown name": ("simulate --push force:1,length=2", "length"),
    "push with a word": ("simulate --push force:hard", "hard"),
    "push given twice": ("simulate --push force:1,force=2", "twice"),
    "push of no duration": ("simulate --push force:1,duration=0", "duration"),
    "push with a stray number": ("simulate --push force:1,2", "name=NUMBER"),
    "wall for a slope": ("simulate --slope 1.5", "slope"),
    "drive that ends before it starts": ("simulate --drive 0.1,start=2,until=1", "end after"),
    "turn with a word": ("simulate --turn left", "left"),
    "unknown state at the start": ("simulate --start lean=0.1", "pitch"),
    "start that is not a number": ("simulate --start pitch=nan", "nan"),
    "log of an unknown kind": ("simulate --seconds 0.1 -o log.docx", ".docx"),
    "log of an unknown kind before the work": ("simulate --controller pidd -o log.docx", ".docx"),
    "repair of an unknown kind before the work": ("doctor missing.csv --fix log.docx", ".docx"),
    "log into a missing folder": ("simulate --seconds 0.1 -o nowhere/log.csv", "nowhere"),
    "unknown model": ("linearise --model printed", "published"),
    "unknown state of the operating point": ("linearise --at lean=0.1", "pitch"),
    "period of no length": ("linearise --period 0", "positive"),
    "model into a missing folder": ("linearise -o nowhere/model.json", "nowhere"),
    "missing log": ("compare missing.csv", "missing.csv"),
    "missing program": ("parity missing.nxc missing.json", "a program by upright firmware"),
    "two logs of one name": ("compare good.csv good.csv", "good"),
    "unknown reference": ("compare good.csv --reference twin", "twin"),
    "log without time": ("compare no-time.csv", "'t'"),
    "log without the states": ("compare wrong-column.csv", "truth/lean"),
    "log with words": ("compare words.csv", "words.csv"),
    "log whose time is NaN": ("compare nan.csv", "nan"),
    "log whose time runs backwards": ("compare backwards.csv", "increasing"),
    "empty log": ("compare empty.csv", "empty"),
    "log of no rows": ("compare header.csv", "no rows"),
    "logs that share no time": ("compare good.csv later.csv", "later"),
    "broken Parquet": ("compare broken.parquet", "broken.parquet"),
    "broken MCAP": ("compare broken.mcap", "broken.mcap"),
    "no log at all": ("compare log.docx", ".docx"),
    "reproduction into a file": ("reproduce -o good.csv", "good.csv"),
    "folder for a log": ("compare .", ". is a folder"),
    "folder for a foreign log": ("doctor .", ". is a folder"),
    "foreign log that is not there": ("doctor god.csv", "did you mean 'good.csv'"),
}
"""Mistake → (the call, what its line must name for the user to find the mistake)."""


@pytest.fixture
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(("call", "named"), BAD.values(), ids=BAD.keys())
def test_a_mistake_is_one_line_that_names_it(
    call: str, named: str, files: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = sorted(files.rglob("*"))
    assert main(call.split()) == USER_ERROR
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.startswith("upright: ")
    assert said.err.count("\n") == 1
    assert named.lower() in said.err.lower()
    assert re.search(r"; try: |Did you mean|Possible options", said.err), "every refusal ends with what to type"
    assert sorted(files.rglob("*")) == before, "a refused call leaves no file"


@pytest.mark.parametrize("call", ["simulate --robot nxtway", "compare backwards.csv"])
def test_a_mistake_in_a_real_process_shows_no_traceback(call: str, files: Path) -> None:
    said = subprocess.run(
        [sys.executable, "-m", "upright", *call.split()],
        cwd=files,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert said.returncode == USER_ERROR
    assert said.stderr.startswith("upright: ")
    assert said.stderr.count("\n") == 1


@pytest.mark.parametrize(
    "call",
    [
        "robots show mine.toml -o ./mine.toml", "tune lqr --robot=mine.toml -o mine.toml",
        "linearise --robot mine.toml -o new.html --report new.html",
    ],
)  # fmt: skip
def test_no_file_that_is_read_or_written_is_written_over(
    call: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    mine = Robot.preset("nxtway-gs").save("mine.toml").read_text(encoding="utf-8")
    assert main(shlex.split(call)) == USER_ERROR
    assert re.search(r"named twice; expected .*; try: (mine-new\.toml|new-new\.html)", capsys.readouterr().err)
    assert Path("mine.toml").read_text(encoding="utf-8") == mine


def test_debug_shows_the_traceback(files: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(InvalidLog, match="increasing"):
        main(["--debug", "compare", "backwards.csv"])
    monkeypatch.setenv("UPRIGHT_DEBUG", "1")
    with pytest.raises(InvalidLog, match="increasing"):
        main(["compare", "backwards.csv"])


def broken(error: BaseException) -> object:
    def call(*_: object, **__: object) -> None:
        raise error

    return call


def test_a_bug_is_one_line_that_says_how_to_see_more(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Robot, "preset", broken(ZeroDivisionError("by\nzero")))
    assert main(["robots"]) == BUG
    said = capsys.readouterr().err
    assert "UPRIGHT_DEBUG=1" in said
    assert said.count("\n") == 1


OWN = """
from upright.control import lqg

class Mine:
    def __init__(self, robot, kit, dt):
        self.lqg = lqg(robot, kit, dt)
        self.spec = self.lqg.spec
        self.reset, self.estimate, self.applied = self.lqg.reset, self.lqg.estimate, self.lqg.applied

    def to_json(self):
        return {"kind": "mine"}

    def step(self, measurement, reference):
        return self.lqg.step(measurement, reference)[0] / {}
"""
"""A controller of one's own with a mistake in its last line."""


@pytest.mark.parametrize("call", ["simulate -s 1", "fleet -n 2 -s 1"])
def test_an_error_in_ones_own_step_names_file_and_line(
    call: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("mine.py").write_text(OWN)
    assert main([*call.split(), "-c", "mine.py:Mine"]) == USER_ERROR
    (line,) = [said for said in capsys.readouterr().err.splitlines() if said.startswith("upright: ")]
    number = len(OWN.splitlines())
    assert line.startswith(f"upright: mine.py line {number}: ")
    assert "TypeError" in line


def test_ctrl_c_ends_with_130(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(Robot, "preset", broken(KeyboardInterrupt()))
    assert main(["robots"]) == 128 + 2  # SIGINT is signal 2
    assert capsys.readouterr().err == "stopped; no incomplete file is left\n"


def test_an_interrupted_run_says_what_it_keeps(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for place in (tmp_path / "nothing yet", tmp_path):
        with pytest.raises(KeyboardInterrupt), goes_on_from(place, f"kept in {place.name}"):
            raise KeyboardInterrupt
    assert capsys.readouterr().err == f"kept in {tmp_path.name}\n"


def test_every_command_has_a_help_page(capsys: pytest.CaptureFixture[str]) -> None:
    registered = group().commands  # type: ignore[attr-defined]
    assert len(registered) == 28
    for command in registered:
        assert main([command, "--help"]) == 0
        page = capsys.readouterr().out
        assert f"Usage: upright {command}" in page
        assert "None" not in page


def options() -> list[tuple[str, Any]]:
    """Every option and argument of every command, and of the commands of `robots`."""
    every: list[tuple[str, Any]] = []
    for name, command in group().commands.items():  # type: ignore[attr-defined]
        within = {f"{name} {part}": one for part, one in getattr(command, "commands", {}).items()}
        for where, one in {name: command, **within}.items():
            every += [(f"{where} {option.name}", option) for option in one.params]
    return every


@pytest.mark.parametrize(("where", "option"), options(), ids=[where for where, _ in options()])
def test_every_option_has_a_short_help(where: str, option: Any) -> None:
    """At most 20 words a sentence: a native reader's limit for one breath."""
    assert option.help, where
    assert max(len(sentence.split()) for sentence in re.split(r"[.;:] ", option.help)) <= 20


def test_an_option_means_one_thing() -> None:
    """Everywhere its help begins with the same words, after which a command may say more; its values are of one kind; a
    letter belongs to one option. What `-o` writes differs, but it always writes the artefact."""
    helps: dict[str, set[str]] = {}
    kinds: dict[str, set[str]] = {}
    letters: dict[str, set[str]] = {}
    for _, option in options():
        for flag in [flag for flag in option.opts if flag.startswith("-")]:
            helps.setdefault(flag, set()).add(option.help)
            kinds.setdefault(flag, set()).add("number" if option.bare_type in (int, float) else str(option.bare_type))
            if len(flag) == 2:
                letters.setdefault(flag, set()).add(option.name)
    for flag, texts in helps.items():
        meaning = min((re.split(r"[.,:;(]", text)[0].strip() for text in texts), key=len)
        meaning = "Write the " if flag in ("-o", "--output") else meaning
        assert [text for text in texts if not text.startswith(meaning)] == [], flag
    assert {flag: names for flag, names in kinds.items() if len(names) > 1} == {}
    assert {flag: names for flag, names in letters.items() if len(names) > 1} == {}


def test_json_of_a_result_is_never_the_artefact() -> None:
    """`-o` is there where a command makes something that another one, or a robot, reads; JSON is printed or saved."""
    flags = {where.split()[0]: set[str]() for where, _ in options()}
    for where, option in options():
        flags[where.split()[0]] |= {*option.opts}
    assert {name for name, known in flags.items() if "--report" in known} == {
        name for name, known in flags.items() if "--save" in known
    }
    assert {name for name, known in flags.items() if "--report" in known and "-o" not in known} == {
        "bench-controllers", "compare", "doctor", "parity", "post-mortem", "validate",
    }  # fmt: skip


@pytest.mark.parametrize("line", [
    f"{command} {flag}" for flags, commands, _ in RETIRED
    for command in commands for flag in flags.split()
])  # fmt: skip
def test_an_old_spelling_is_answered_with_what_to_type_now(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([*line.split(), "1"]) == USER_ERROR
    said = capsys.readouterr()
    (told,) = said.err.splitlines()
    assert "has another name; try: " in told
    now = told.partition("; try: ")[2].split()[0]
    *command, _ = line.split()
    known = {flag for where, option in options() for flag in option.opts if where.split()[: len(command)] == command}
    assert now in known or now == "upright"


def test_the_shell_completes_names_of_robots_and_kits(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "nxtway-mine.toml").touch()
    assert complete_robot("nxtway") == ["nxtway-gs", "nxtway-gs-measured", "nxtway-mine.toml"]
    assert complete_kit("nx") == [name for name in kit_names() if name.startswith("nx")] + ["nxtway-mine.toml"]
    assert complete_controller("lq") == [name for name in CONTROLLERS if name.startswith("lq")]


def test_no_argument_prints_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([]) == 0
    assert "simulate" in capsys.readouterr().out


def test_version_is_that_of_the_package(capsys: pytest.CaptureFixture[str]) -> None:
    from importlib.metadata import version

    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"upright {version('upright')}\n"


def test_the_shell_completes_commands() -> None:
    # The protocol of bash's completion: the words so far and which of them is being typed.
    asked = {**os.environ, "_UPRIGHT_COMPLETE": "complete_bash", "COMP_WORDS": "upright lin", "COMP_CWORD": "1"}
    said = subprocess.run(
        [sys.executable, "-c", "from upright.cli.main import main; main()"],
        env=asked,
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,  # completion has exit codes of its own
    )
    assert said.stdout.split() == ["linearise"]


def test_robots_are_listed_with_mass_and_pole(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["robots", "--json"]) == 0
    listed = {entry["name"]: entry for entry in json.loads(capsys.readouterr().out)}
    # Yamamoto (2008): a body of 0.6 kg on two wheels of 0.03 kg.
    assert listed["nxtway-gs"]["mass"] == pytest.approx(0.66, abs=1e-12)
    assert all(entry["unstable_pole"] > 0 for entry in listed.values())
    assert main(["robots"]) == 0
    table = capsys.readouterr().out
    assert listed.keys() <= set(table.split())
    assert "2.15" in table  # wheels tell one EV3way from the other
    assert max(map(len, table.splitlines())) <= 80
    assert main(["robots", "list"]) == 0  # which is what many type
    assert capsys.readouterr().out == table
    assert main(["robots", "list", "--json"]) == 0
    assert {entry["name"]: entry for entry in json.loads(capsys.readouterr().out)} == listed


def test_a_robot_is_shown_with_every_number_and_its_source(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["robots", "show", "nxtway-gs"]) == 0
    shown = capsys.readouterr().out
    assert Robot.preset("nxtway-gs").title in " ".join(shown.split())
    assert max(map(len, shown.splitlines())) <= 80
    lines = {line.split()[0]: line for line in shown.partition("source")[0].splitlines() if line}
    assert set(PARAMETERS) - set(UNUSED["voltage"]) <= lines.keys()
    assert "0.04" in lines["wheel_radius"]  # [m], Yamamoto (2008)
    assert main(["robots", "show", "nxtway-gs", "--json"]) == 0
    shown = {p["name"]: p for p in json.loads(capsys.readouterr().out)["parameters"]}
    assert shown["wheel_radius"]["value"] == 0.04
    assert shown["wheel_radius"]["unit"] == "m"


def test_linearise_prints_the_yaw_pole_of_the_closed_form(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # Upright, yaw is a first order lag of its own: Herrera et al. (2015), eq. (13) corrected, with ψ = 0.
    p = Robot.preset("nxtway-gs")
    lever = p.track**2 / (2 * p.wheel_radius**2)
    damping = lever * (p.gear_ratio * p.torque_constant * p.back_emf / p.motor_resistance + p.motor_friction)
    wheels = p.wheel_mass * p.track**2 / 2 + lever * (p.wheel_inertia + p.gear_ratio**2 * p.rotor_inertia)
    pole = -damping / (wheels + p.yaw_inertia)
    assert main(["linearise", "-o", "model.json"]) == 0
    said = capsys.readouterr().out
    rows = said.partition("pole [1/s]")[2].splitlines()[1:7]
    printed = [float(line.split()[0].replace("−", "-")) for line in rows]
    assert min(abs(other - pole) for other in printed) < 5e-4 * abs(pole)  # four digits are printed
    assert "Not an equilibrium" not in said
    model = json.loads((files / "model.json").read_text(encoding="utf-8"))
    assert model["A"][5][5] == pytest.approx(pole, rel=1e-12)  # rounding


def test_linearise_says_that_driving_against_friction_is_no_equilibrium(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["linearise", "--at", "wheel_rate=4"]) == 0  # the motors' back-EMF brakes at once
    assert "Not an equilibrium: θ̇ changes by itself" in capsys.readouterr().out


def test_simulate_stands_and_writes_its_log(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    call = "simulate --kit ideal --start pitch=0.02 --seconds 0.5 -o run.csv --json"
    assert main(call.split()) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["outcome"]["fell"] is False
    assert said["origin"]["scenario"]["start"][0] == 0.02
    assert main(["compare", "run.csv"]) == 0
    assert "largest pitch" in capsys.readouterr().out


def test_simulate_tells_a_fall(capsys: pytest.CaptureFixture[str]) -> None:
    # No gain at all: an inverted pendulum started off its top falls, here in well under 2 s (its pole is 7.4 1/s).
    call = "simulate --kit ideal --feedback 0,0,0,0,0,0 --start pitch=0.05 --seconds 2"
    assert main(call.split()) == 0
    text = capsys.readouterr().out
    assert text.startswith("it fell\nIt fell at ")
    assert main([*call.split(), "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["outcome"]["fell"] is told["logs"]["nonlinear"]["metrics"]["fell"] is True


def test_a_robot_that_cannot_stand_up_says_why_in_one_line(capsys: pytest.CaptureFixture[str]) -> None:
    for call, word in (("--lying 1.6", "from at most 0.62 rad"), ("--lying 1.6 --start pitch=0.1", "both --start")):
        assert main(["simulate", "--robot", "nxtway-gs", *call.split()]) == 2
        said = capsys.readouterr().err.strip()
        assert word in said
        assert len(said.splitlines()) == 1


def test_a_robot_that_lies_stands_up(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", "--robot", "twipr", "--lying", "1.57", "--seconds", "2", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert told["outcome"]["fell"] is False
    assert told["logs"]["nonlinear"]["metrics"]["pitch_peak"] == pytest.approx(1.57, abs=0.1)  # where it begins


def test_a_push_reads_like_its_class(files: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pushed = "--push hold:0.05,until=0.1 --push force:0.1,start=0.1 --slope 0.01 --turn 0.5"
    assert main(f"simulate --kit ideal --seconds 0.2 {pushed} --json".split()) == 0
    scenario = json.loads(capsys.readouterr().out)["origin"]["scenario"]
    assert [part["kind"] for part in scenario["push"]] == ["Hold", "Push", "Slope"]
    assert scenario["push"][0] == {"kind": "Hold", "pitch": 0.05, "until": 0.1, "start": 0.0}
    assert scenario["reference"][0]["rate"] == 0.5


def test_json_is_written_whole_or_not_at_all(tmp_path: Path) -> None:
    target = tmp_path / "model.json"
    write_json(target, {"dt": 0.01})
    with pytest.raises(ValueError, match="not JSON compliant"):
        write_json(target, {"dt": math.nan})
    assert json.loads(target.read_text(encoding="utf-8")) == {"dt": 0.01}
    assert list(tmp_path.iterdir()) == [target]


def test_the_exit_codes_are_those_that_shells_know() -> None:
    assert (cli.USER_ERROR, cli.BUG) == (2, 1)  # 2 as for usage errors


def test_no_summary_in_the_help_is_cut_at_80_columns(capsys, monkeypatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert main(["robots", "--help"]) == 0
    listed = capsys.readouterr().out.partition("Commands:")[2].splitlines()
    assert len(listed) > 1
    assert [line for line in listed if line.endswith("...")] == []


@pytest.mark.parametrize("name", sorted(group().commands))
def test_no_help_shows_a_type_of_python_or_a_default_twice(name, capsys, monkeypatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    assert main([name, "--help"]) == 0
    text = " ".join(capsys.readouterr().out.partition("Options:")[2].split())
    assert not re.search(r"<list\[|\[default: inf\]", text)
    assert not re.search(r"\(default: [^)]*\)\.? \[default:", text)


FIRST = "start lab simulate compare doctor calibrate design certify post-mortem firmware fly reproduce"
"""What a newcomer reads before the other commands: a way from nothing to a robot that stands, and the paper."""


def test_help_shows_a_dozen_commands_first(capsys):
    assert main(["--help"]) == 0
    first = capsys.readouterr().out.partition("Begin:")[2].partition("\n\n")[0]
    assert re.findall(r"^  ([a-z-]+)  ", first, re.MULTILINE) == FIRST.split()


def test_help_names_every_command_once_under_a_heading_and_nothing_is_clipped(capsys):
    assert main(["--help"]) == 0
    text = capsys.readouterr().out
    assert "..." not in text.split("Begin:")[1]
    listed = re.findall(r"^  ([a-z-]+)  ", text.split("Begin:")[1], re.MULTILINE)
    assert sorted(listed) == sorted(group().commands)


def test_a_long_command_without_a_terminal_says_how_far_it_is(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A line for each tenth, from the time on when one begins to wonder; a quick one says nothing."""
    clock = [0.0]
    monkeypatch.setattr("time.monotonic", lambda: clock[0])
    with progress("searching") as show:
        for second, fraction in ((0, 0.0), (5, 0.125), (20, 0.25), (21, 0.26), (40, 0.5), (80, 1.0)):
            clock[0] = second
            show(fraction)
    assert capsys.readouterr().err.splitlines() == [
        "searching: 20 %, about 60 s left", "searching: 50 %, about 40 s left",
    ]  # fmt: skip


@pytest.mark.parametrize("line", [line for lines in EXAMPLES.values() for line in lines])
def test_the_examples_of_the_help_are_calls_that_the_command_takes(line):
    name, *arguments = shlex.split(line)[1:]
    assert len(line) + 4 <= 80  # a terminal's width, indented as help is
    group().commands[name].make_context(name, arguments)  # raises where an option or an argument is wrong


@pytest.mark.parametrize("spelling", ["--report {}", "--report={}"])
def test_the_foot_of_a_page_names_it_without_its_folder(
    spelling: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A page is passed on: its folder tells whose machine it is, and is not there on another. So are logs."""
    monkeypatch.chdir(tmp_path)
    page, log = tmp_path / "page.html", tmp_path / "good.csv"
    log.write_text(FILES["good.csv"])
    assert main(["compare", f"a={log}", str(log), *spelling.format(page).split(" ")]) == 0, capsys.readouterr()
    written = page.read_text(encoding="utf-8")
    assert str(tmp_path) not in written
    shown = re.search(r"<code>(.*?)</code>", written[written.index("<footer") :])
    assert shown
    typed = re.sub(r"</?span>", "", shown[1])  # each word with a hyphen is in a span, in which no line breaks
    assert typed == f"upright compare a=good.csv good.csv {spelling.format('page.html')}"


FILES_OF_THEIR_OWN = {"reproduce", "firmware", "fly", "monitor", "start", "lab", "robots", "example", "film"}
"""A folder with its page, a program, a log, a film, nothing."""


def test_every_command_with_a_result_writes_it_and_its_page() -> None:
    commands = group().commands  # type: ignore[attr-defined]
    flags = {name: {flag for option in command.params for flag in option.opts} for name, command in commands.items()}
    lacking = [name for name, known in flags.items() if not {"--save", "--report"} <= known]
    assert set(lacking) == FILES_OF_THEIR_OWN


@pytest.mark.parametrize(
    ("command", "option", "value"),
    [("linearise", "model", "published"), ("push-map", "direction", "backward"), ("parity", "body", "twin"),
     ("parity", "robot", "ev3way"), ("fly", "kit", "nxt"), ("calibrate", "known", "body_mass"),
     ("firmware", "target", "nxc"), ("simulate", "controller", "lqg")],
)  # fmt: skip
def test_the_shell_completes_values(command: str, option: str, value: str) -> None:
    asked = group().commands[command]  # type: ignore[attr-defined]
    (parameter,) = [p for p in asked.params if p.name == option]
    context = asked.make_context(command, [], resilient_parsing=True)
    assert value in [item.value for item in parameter.shell_complete(context, value[:2])]


class Stood(Result):
    """A result with a long title and a good verdict."""

    def page(self) -> Page:
        return Page(Say("{words}", words="word " * 20), verdict=Verdict(Say("{words}", words="stood"), "good"))

    def to_json(self) -> dict[str, Any]:
        return {}


@pytest.mark.parametrize(("no_color", "coloured"), [("", True), ("1", False)])
def test_a_verdict_has_its_colour_on_a_terminal(no_color: str, coloured: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_COLOR", no_color)
    monkeypatch.setenv("COLUMNS", "40")
    master, slave = os.openpty()
    with os.fdopen(slave, "w", encoding="utf-8") as screen, monkeypatch.context() as here:
        here.setattr(sys, "stdout", screen)
        Destination().finish(Stood())
    lines = os.read(master, 10_000).decode().splitlines()
    os.close(master)
    assert lines[0].startswith("\x1b[1;32m" if coloured else "stood")
    assert max(map(len, lines[1:])) <= 40


def test_a_verdict_has_no_colour_in_a_file(capsys: pytest.CaptureFixture[str]) -> None:
    Destination().finish(Stood())
    assert capsys.readouterr().out.startswith("stood\n")


def test_a_page_is_built_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    built: list[Page] = []

    class Counted(Stood):
        def page(self) -> Page:
            built.append(super().page())
            return built[-1]

    Destination(report=tmp_path / "page.html", save=tmp_path / "all.json", json=True).finish(Counted())
    assert len(built) == 1
    assert json.loads(capsys.readouterr().out)["head"]["verdict"]["text"] == "stood"


def test_what_a_command_adds_to_a_result_is_no_part_of_it(capsys: pytest.CaptureFixture[str]) -> None:
    """So a certificate or a plan is read back as --save and --json wrote it, with what else was written beside."""
    Destination(json=True).finish(Stood(), Path("controller.json"))
    printed = json.loads(capsys.readouterr().out)
    assert printed.keys() - Stood().to_json().keys() == {"head", "files"}
    given = printed | {"schema": "upright/excite/3", "seconds": 2}
    check_schema(given, "upright/excite/3", UprightError)
    assert given == {"seconds": 2}


def test_a_run_that_nothing_disturbs_says_so(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", "-s", "0.1"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("nothing disturbed it\n")
    assert "--push hold:0.1,until=1`\n" in text
    assert main(["simulate", "-s", "0.1", "--push", "impulse:0.1"]) == 0
    assert "nothing disturbed" not in capsys.readouterr().out


@pytest.mark.parametrize("command", ["simulate", "compare good.csv", "linearise", "fleet", "certify lqg", "parity a b"])
@pytest.mark.parametrize("name", ["fig.doc", "fig", "fig.html.txt"])
def test_a_page_is_no_other_kind_of_file(
    command: str, name: str, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One place for all commands, before their work: what came, what is expected, what to try."""
    monkeypatch.chdir(tmp_path)
    assert main([*command.split(), "--report", name]) == USER_ERROR
    said = capsys.readouterr().err
    expected = "a page, .html, or its picture, .svg .pdf .png"
    assert said == f"upright: {name} has no known format; expected {expected}; try: {Path(name).stem}.html\n"
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("command", ["parity balance.nxc lqr.json", "fly balance.nxc lqr.json"])
def test_a_program_for_nbc_names_it_before_anything_is_asked(
    command: str, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`fly` asks to hold the robot, but not where its program cannot be built: one line says what to install, and which
    target needs no compiler."""
    monkeypatch.chdir(tmp_path)
    kit = Kit.preset("nxt")
    write_controller(make_controller("lqr", Robot.preset("nxtway-gs"), kit, kit.period), "lqr.json")
    assert main(["firmware", "lqr.json", "-t", "nxc", "-o", "balance.nxc"]) == 0
    monkeypatch.setenv("PATH", str(tmp_path))
    capsys.readouterr()
    assert main(command.split()) == USER_ERROR
    (line,) = capsys.readouterr().err.splitlines()
    assert all(word in line for word in ("nbc is not installed", "apt install nbc", "--target pybricks"))


@pytest.mark.needs("shared/cases/pyboard-pid")
def test_a_run_that_stood_says_that_it_rolled_away(
    shared: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its owner's program has no encoders: 2.8 to 4.7 m in 10 s, by a simulation of the case's own without a bias of
    the gyro, under which most seeds fall; here noise and push are others, which moves that by a fifth."""
    case = shared / "cases" / "pyboard-pid"
    kit = tmp_path / "kit.toml"
    kit.write_text(
        (case / "kit.toml").read_text().replace('value = 0.01\nunit = "rad/s"', 'value = 0.0\nunit = "rad/s"')
    )
    robot = ["--robot", str(case / "robot.toml"), "--kit", str(kit)]
    assert main(["simulate", *robot, "--controller", f"{case}/mine.py:Pyb", "--push", "impulse:0.01"]) == 0
    said = re.search(r"stood for 10 s and rolled ([\d.]+) m$", capsys.readouterr().out, re.MULTILINE)
    assert said
    assert 0.8 * 2.8 <= float(said[1]) <= 1.2 * 4.7
