"""What somebody tries who has read nothing: every verb takes what every other takes, and says what it takes."""

from __future__ import annotations

import inspect
import json
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import upright as up
from firmware_cases import GOLDEN
from upright.cli.main import USER_ERROR, main
from upright.control.controller import controller_hash
from upright.errors import UnknownName, UprightError, WrongArguments
from upright.identification.identify import study_of
from upright.signals import STATE_NAMES

ROBOT, KIT = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
TINY = up.Log(np.arange(20) * 0.01, {f"truth/{name}": np.linspace(0.1, 0, 20) for name in STATE_NAMES})


def test_the_package_runs_as_a_module() -> None:
    done = subprocess.run([sys.executable, "-m", "upright", "--version"], capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert done.stdout.startswith("upright ")


@pytest.mark.parametrize(("typed", "meant"), [("lgq", "lqg"), ("lrq", "lqr"), ("mcp", "mpc")])
def test_two_letters_in_the_wrong_order_are_put_right(typed: str, meant: str) -> None:
    with pytest.raises(UnknownName, match=f"did you mean '{meant}'"):
        up.design(typed, "nxtway-gs")


@pytest.mark.parametrize("call", [lambda: up.certify(robots=50), lambda: up.compare(logs=[], nosuch=1), up.doctor])
def test_a_wrong_argument_is_one_line_with_the_right_ones(call) -> None:
    with pytest.raises(UprightError, match=r"expected .*\("):
        call()
    with pytest.raises(TypeError):
        call()


def test_logs_are_compared_in_a_list(tmp_path: Path) -> None:
    path = TINY.save(tmp_path / "run.csv")
    comparison = up.compare([TINY, path, TINY])
    assert len(comparison.logs) == 3
    assert up.compare(TINY).metrics.keys() == {"1"}


@pytest.mark.parametrize("name", ["lqg", "lqi", "mpc", "sliding", "hinf", "kalman", "complementary"])
def test_a_design_takes_names(name: str) -> None:
    named, given = (getattr(up, name)(*pair, 0.01) for pair in (("nxtway-gs", "nxt"), (ROBOT, KIT)))
    if hasattr(given, "step"):
        assert controller_hash(named) == controller_hash(given)


def test_lqr_state_takes_a_name() -> None:
    assert np.array_equal(up.lqr_state("nxtway-gs", 0.01).gain, up.lqr_state(ROBOT, 0.01).gain)


def test_lqr_in_python_is_that_of_the_command(tmp_path: Path) -> None:
    """`upright design` prints what `up.design` prints, and writes what it saves."""
    designed = up.design("lqr", "nxtway-gs")
    controller = up.lqr("nxtway-gs", "nxt")
    written = json.loads(designed.save(tmp_path / "lqr.json").read_text("utf-8"))
    assert written["hash"] == controller_hash(controller)
    assert np.array_equal(written["gain"], up.lqr_state(ROBOT, KIT.period).gain)
    poles = next(line for line in str(controller).splitlines() if line.startswith("Poles"))
    assert poles in str(designed).replace("\n  ", " ")


def test_a_flight_that_nobody_can_confirm_says_so(tmp_path: Path, capsys, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(GOLDEN / "controller.json", "c.json")
    assert main(["firmware", "c.json", "-t", "pybricks", "-o", "p.py"]) == 0
    capsys.readouterr()
    with Path("/dev/null").open() as nothing:
        monkeypatch.setattr(sys, "stdin", nothing)
        assert main(["fly", "p.py", "c.json", "--json"]) == USER_ERROR  # JSON is no permit
    said = capsys.readouterr()
    assert said.err.splitlines()[-1].startswith("upright: nobody answered")
    assert "--yes" in said.err
    assert said.out == ""


SIZES = {
    "a run": lambda: up.run(up.NonlinearBody(ROBOT), up.lqr_state(ROBOT, 0.01), seconds=1e9),
    "a fleet": lambda: up.fleet("nxtway-gs", n=10**9),
    "a long fleet": lambda: up.fleet("nxtway-gs", seconds=1e9, n=10),
    "a certificate": lambda: up.certify("lqr", ROBOT, samples=10**9),
    "an excitation": lambda: up.excite("lqg", "nxtway-gs", seconds=1e9),
    "what is held out": lambda: up.calibrate(TINY, ROBOT, held_out=2.0),
    "repeats": lambda: study_of(TINY, ROBOT, runs=10**9),
    "a negative seed": lambda: up.fleet("nxtway-gs", n=10, seed=-1),
    "a seed of 400 digits": lambda: up.run(
        up.NonlinearBody(ROBOT), up.lqr_state(ROBOT, 0.01), seconds=1.0, seed=10**400
    ),
}


@pytest.mark.parametrize("what", SIZES)
def test_what_would_take_days_or_all_memory_is_refused_with_its_limit(what: str) -> None:
    with pytest.raises(UprightError, match=r"expected .*\d"):
        SIZES[what]()


@pytest.mark.parametrize(
    "arguments",
    [
        "push-map --points 100000 -n 0", "basin --points 1000000", "simulate --seed -1", "fleet -n 1000000000",
        "simulate -s 1e9", "fleet --threads 1000000000", "sweep x.toml --workers 1000000",
    ],
)  # fmt: skip
def test_sizes_are_refused_before_the_work(arguments: str, capsys, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "x.toml").write_text("n = 1\n")
    assert main(arguments.split()) == USER_ERROR
    assert len(capsys.readouterr().err.splitlines()) == 1


def test_numbers_beyond_every_robot_are_one_line(tmp_path: Path) -> None:
    huge = up.Log(TINY.t, {"sensor/gyro": np.full(20, 1e308), "sensor/encoder_left": np.linspace(0, 1, 20)})
    push = up.Push(force=1e308, start=0.0, duration=1.0)
    body, gain = up.NonlinearBody(ROBOT), up.lqr_state(ROBOT, 0.01)
    (tmp_path / "exits.py").write_text("raise SystemExit(7)\n")
    for call in (
        lambda: up.doctor(huge),
        lambda: up.run(body, gain, push, seconds=0.1),
        lambda: up.run(body, gain, start=(1e308, 0, 0, 0, 0, 0), seconds=0.1),
        lambda: up.push_map(ROBOT, watch=1e308),
        lambda: up.design(f"{tmp_path / 'exits.py'}:X", ROBOT),
    ):
        with pytest.raises(UprightError):
            call()


CONTROLLER = up.lqr_state(ROBOT, 0.01)
SWAPPED = {
    "its controller is a Robot": [lambda: up.certify(ROBOT, CONTROLLER), lambda: up.excite(ROBOT, CONTROLLER)],
    "its logs is a Robot": [lambda: up.calibrate(ROBOT, TINY), lambda: up.validate(ROBOT, TINY)],
    "its source is a Robot": [lambda: up.doctor(ROBOT, TINY), lambda: up.post_mortem(ROBOT, TINY)],
    "its log is a Robot": [lambda: up.identify(ROBOT, TINY)],
    "its body is a Robot": [lambda: up.run(ROBOT, CONTROLLER)],
    "its method is a Robot": [lambda: up.tune(ROBOT, "lqg"), lambda: up.design(ROBOT, "lqg")],
    "its kit is a float": [lambda: up.lqr("nxtway-gs", 0.01), lambda: up.lqg(ROBOT, 0.01)],
    "its robot is a LinearController": [lambda: up.fleet(up.lqg(ROBOT, KIT)), lambda: up.push_map(up.lqg(ROBOT, KIT))],
}


@pytest.mark.parametrize("said", SWAPPED)
def test_what_is_examined_stands_first_and_another_order_is_one_line(said: str) -> None:
    for call in SWAPPED[said]:
        with pytest.raises(WrongArguments, match=rf"{said}; expected \w+\("):
            call()


def test_what_a_verb_gives_is_a_noun_of_the_package() -> None:
    """Also the parts of results and the contracts that an own body or controller keeps."""
    contracts = {"Body", "BodySpec", "Sample", "Controller", "ControllerSpec", "Analysis", "Margins"}
    elsewhere = {"None", "Path", "Dataset"}  # of Python and of xarray
    for name in up.__all__:
        function = inspect.unwrap(getattr(up, name))
        if inspect.isfunction(function):
            given = function.__annotations__["return"]
            contracts |= set(given.split(" | ")) - elsewhere
    missing = {name for name in contracts if not inspect.isclass(getattr(up, name, None))}
    assert not missing
