"""No fit without a judge: what half seconds of free simulation miss is named, and such a fit is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from test_calibrate import short_calibration
from upright.bodies import NonlinearBody
from upright.calibration import judge
from upright.calibration.calibrate import prepared
from upright.calibration.calibrated_robot import Segments
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import FOREIGN, REFUSED, VISIBLE, Estimate
from upright.calibration.fitting import normal_equations, objective
from upright.calibration.informativity import student
from upright.calibration.judge import reasons, unpredicted
from upright.certification import certify
from upright.cli.main import main
from upright.control import lqr_state
from upright.control.excited import Excited, random_binary
from upright.errors import InvalidLog, InvalidRobot
from upright.experiment import run
from upright.pages import Say
from upright.robots import Kit, Robot
from upright.robots.uncertainty import read_posterior
from upright.signals import Log

ROBOT = Robot.preset("nxtway-gs").replace(coulomb_friction=0.0)


def half_seconds(measured: np.ndarray, predicted: np.ndarray) -> Segments:
    n = len(measured)
    t = 0.01 * np.arange(n)
    return Segments(("sensor/gyro",), np.zeros(n, dtype=int), t, measured, predicted, (t // 0.5).astype(int))


RNG = np.random.default_rng(0)
GYRO = np.convolve(RNG.standard_normal(430), np.ones(30) / 30, "valid")


@pytest.mark.parametrize(
    ("predicted", "says"),
    [
        (lambda y: -y, "flipped sign"),
        (lambda y: 10 * y, "unit: readings are 0.1"),
        (lambda y: np.roll(2 * np.sign(y) * y**2 / 0.1, 60), "slip"),
        (lambda y: np.nan * y, "another robot, a flipped sign"),
    ],
)
def test_what_is_predicted_worse_than_its_mean_is_named_with_a_reason(
    predicted: Callable[[np.ndarray], np.ndarray], says: str
) -> None:
    (sentence,) = unpredicted(half_seconds(GYRO, predicted(GYRO)))
    assert says in str(sentence.facts["cause"])


def test_a_late_reading_is_a_delay() -> None:
    late = RNG.standard_normal(401)
    (sentence,) = unpredicted(half_seconds(np.roll(late, 3), late))
    assert str(sentence.facts["cause"]) == "it comes late by 3 of its readings"


def test_what_is_predicted_is_no_reason() -> None:
    assert not unpredicted(half_seconds(GYRO, 0.9 * GYRO))


@pytest.fixture(scope="module")
def model_log() -> Log:
    log = run(NonlinearBody(ROBOT), lqr_state(ROBOT, 0.01), seconds=2.0, start=(0.15, 0.0, 0.0, 0.0, 0.0, 0.3))
    return Log(log.t, {n: v for n, v in log.channels.items() if not n.startswith("truth/")}, log.units, log.origin)


def test_a_number_many_deviations_from_its_source_is_of_another_robot(model_log: Log) -> None:
    problem, _ = prepared([model_log], ROBOT, Kit.preset("ideal"), (), 0.25)
    z = np.zeros(len(problem.parameters))
    far = Estimate(
        name="wheel_radius", unit="m", value=0.05, low=0.04, high=0.06, prior=0.04, prior_spread=0.001,
        verdict=VISIBLE, shift=FOREIGN + 1, shrink=0.4,
    )  # fmt: skip
    (sentence,) = reasons(problem, z, (), [far])
    assert [sentence.facts[name].value for name in ("value", "stated")] == [0.05, 0.04]
    assert not reasons(problem, z, (), [replace(far, guess=True), replace(far, shift=3.5)])


def test_what_the_doctor_finds_refuses_a_fit_unless_it_predicts_the_log(model_log: Log) -> None:
    """Predictions of 0.4 and 0.9 of the readings have R² of 1 − 0.6² and 1 − 0.1²: under and over 0.9."""
    problem, _ = prepared([model_log], ROBOT, Kit.preset("ideal"), (), 0.25)
    z, wrong = np.zeros(len(problem.parameters)), [Say("The log contradicts itself.")]
    assert list(reasons(problem, z, (half_seconds(GYRO, 0.4 * GYRO),), (), wrong=wrong)) == wrong
    assert not reasons(problem, z, (half_seconds(GYRO, 0.9 * GYRO),), (), wrong=wrong)
    far = half_seconds(GYRO, -GYRO)
    assert list(reasons(problem, z, (far,), (), wrong=wrong)) == wrong  # the cause is known: no other is guessed


@pytest.mark.parametrize(("true", "named"), [("ev3way-large-wheels", True), ("ev3way", False)])
def test_a_log_of_another_preset_names_it(true: str, named: bool) -> None:
    """A log of the robot on large wheels under the file of the small ones; the file's own log proposes nothing. Nothing
    is asked where innovations are white and no stated number is contradicted."""
    robot, kit = Robot.preset(true), Kit.preset("ideal")
    log = run(NonlinearBody(robot), Excited(lqr_state(robot, 0.01), random_binary(150, 2.0, 1, 4)), seconds=1.5)
    raw = Log(log.t, {n: v for n, v in log.channels.items() if not n.startswith("truth/")}, log.units, log.origin)
    problem, _ = prepared([raw], Robot.preset("ev3way"), kit, (), 0.0)
    coloured = replace(problem, temper=0.5)
    assert ("ev3way-large-wheels" in judge.proposed(problem, coloured, ())) == named
    assert judge.proposed(problem, problem, ()) == []


def test_numbers_that_predict_worse_than_the_file_are_refused(model_log: Log, monkeypatch: pytest.MonkeyPatch) -> None:
    problem, _ = prepared([model_log], ROBOT, Kit.preset("ideal"), (), 0.25)
    z = np.ones(len(problem.parameters))
    for of_fit, refused in ((0.8, True), (0.89, False), (0.95, False)):  # of a file whose numbers reach 0.9
        monkeypatch.setattr(judge, "score", lambda _, z, of_fit=of_fit: of_fit if z.any() else 0.9)
        assert (
            any("robot's file predicts half seconds" in str(reason) for reason in reasons(problem, z, (), ()))
            == refused
        )


def test_a_log_that_is_lost_leaves_the_equations_of_the_others_whole(model_log: Log) -> None:
    """A filter that begins fallen over ends at once, and each log has its path all the same."""
    problem, _ = prepared([model_log, model_log], ROBOT, Kit.preset("ideal"), (), 0.25)
    fallen, upright = problem.recordings
    fallen = replace(fallen, first=fallen.first + 3.5 * np.eye(len(fallen.first))[0])
    problem = replace(problem, recordings=(fallen, upright))
    z = np.zeros(len(problem.parameters))
    value, paths = objective(problem, z)
    assert not np.isfinite(value)
    assert len(paths) == 2
    assert normal_equations(problem, z, paths, value).hessian.shape == (len(z),) * 2


def test_a_refused_fit_writes_no_robot_unless_asked(
    model_log: Log, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    refused = replace(short_calibration()[0], refused=(Say("The log is of another robot."),))
    monkeypatch.setattr(import_module("upright.calibration.calibrate"), "calibrate", lambda *_, **__: refused)
    monkeypatch.setattr(import_module("upright.logs.raw"), "raw_log", lambda *_: model_log)
    robot = tmp_path / "robot.toml"
    for extra in ([], ["--force"]):
        assert main(["calibrate", "log.csv", "-o", str(robot), *extra]) == 3  # a verdict against, written or not
        assert robot.exists() == bool(extra)


def test_refused_is_a_verdict_with_a_meaning() -> None:
    from upright.calibration.estimate import CALLED

    assert REFUSED in CALLED
    assert "refused" in Calibration.__dataclass_fields__


def test_what_is_refused_is_not_used_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A certificate is not made for the robot of a log that is another one's, nor are robots drawn from such a fit."""
    refused = SimpleNamespace(refused=("the log is of another robot",))
    certificate, handed_over = (
        import_module(f"upright.{name}") for name in ("certification.certificate", "likelihood.calibrated")
    )
    monkeypatch.setattr(handed_over, "calibrate", lambda *_, **__: refused)
    monkeypatch.setattr(handed_over, "as_logged", lambda _, setup: (setup, (), ()))
    monkeypatch.setattr(handed_over, "doubted", lambda *_: None)
    monkeypatch.setattr(handed_over, "unpushed", lambda log, *_: log)
    monkeypatch.setattr(certificate, "raw_log", lambda *_: Log(np.arange(9.0) / 100, {}, {}))
    with pytest.raises(InvalidLog, match="another robot"):
        certify("lqr", ROBOT, "nxt", samples=100, log="run.csv")
    path = tmp_path / "posterior.json"
    path.write_text(json.dumps({"names": ["body_mass"], "refused": ["the log is of another robot"]}))
    with pytest.raises(InvalidRobot, match="another robot"):
        read_posterior(path)


@pytest.mark.parametrize(("before", "after", "taken"), [(0.04, 0.08, False), (0.4, 0.95, True), (0.9, 0.95, False)])
def test_a_doubtful_number_is_taken_over_where_it_leaves_white_innovations(
    monkeypatch: pytest.MonkeyPatch, before: float, after: float, *, taken: bool
) -> None:
    """Whiter alone is no reason: 0.04 and 0.08 are of a dead zone that passed for twice the mass; see `WHITE`."""
    handed_over = import_module("upright.likelihood.calibrated")
    number, setup = (
        SimpleNamespace(name="number"),
        SimpleNamespace(kit=None, dry_friction=False, actual_kit=None, is_weighed=False),
    )
    fits = iter([SimpleNamespace(refused=(), temper=temper) for temper in (before, after)])
    monkeypatch.setattr(handed_over, "as_logged", lambda _, setup: (setup, (), ()))
    monkeypatch.setattr(handed_over, "_own", lambda *_: next(fits))
    monkeypatch.setattr(handed_over, "doubted", lambda *_: (setup, number))
    monkeypatch.setattr(handed_over, "guessed", lambda *_: SimpleNamespace(refused=("no mass is asked here",)))
    monkeypatch.setattr(handed_over, "unloaded", lambda met: met)
    monkeypatch.setattr(handed_over, "learnt", lambda own, *_: handed_over.Learnt(own, None, None))
    own, numbers = handed_over.calibrated(Log(np.arange(9.0) / 100, {}, {}), setup)
    assert (own.robot.temper, numbers) == ((after, (number,)) if taken else (before, ()))


@pytest.mark.parametrize(("seconds", "quantile"), [(2.0, 3.182), (10.0, 2.131), (20.0, 2.042)])
def test_intervals_of_a_short_log_are_those_of_student(seconds: float, quantile: float) -> None:
    """Tables of Student's distribution, 97.5 %, for 3, 15 and 30 degrees of freedom: 3T/2M with a window of 1 s."""
    t = np.linspace(0.0, seconds, 50)
    recording = SimpleNamespace(when=t, fitted=np.ones(50, bool))
    coloured, white = (SimpleNamespace(temper=temper, recordings=(recording,)) for temper in (0.4, 1))
    assert student(coloured) == pytest.approx(quantile / 1.96, abs=3e-4)  # type: ignore[arg-type]
    assert student(white) == 1.0  # type: ignore[arg-type]
