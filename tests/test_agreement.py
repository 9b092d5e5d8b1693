"""The certificate's other ways: controllers that are called, logs it is compared with, and hardware that it guards."""

from __future__ import annotations

import dataclasses
import json
import math
from functools import cache
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.body import Sample
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import HELD
from upright.certification import checks
from upright.certification.certificate import Certificate, certify, read_certificate
from upright.certification.checks import (
    KernelController,
    PushTrial,
    TrialSetup,
    followed_runs,
    kernel_controller,
    trials,
    tried,
)
from upright.certification.pushes import standard_pushes
from upright.certification.verdict import AMBER, GREEN, RED, Examined, LinearMargins, judge
from upright.cli.main import main
from upright.comparison.bench import TOLERANCE, bench_one, largest_knock
from upright.control import ControllerSpec, LinearController, as_linear, make_controller
from upright.control.linear_controller import Law
from upright.errors import InvalidController, InvalidLog, NotPermitted, SpecMismatch
from upright.experiment import Hold, run
from upright.experiment.examples import example
from upright.experiment.permit import permitted
from upright.kernel.batch import idle
from upright.likelihood.actual import as_logged
from upright.likelihood.agreement import Agreement, agreement
from upright.likelihood.assumptions import Assumptions
from upright.likelihood.calibrated import Learnt, learnt
from upright.physics.dynamics import CALM
from upright.robots import Kit, Robot
from upright.robots.sections import Conditions
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
CALIBRATED = Uncertainty.of(ROBOT).scaled(0.2)
LINEAR, TRIAL = (
    LinearMargins(0.99, 0.5, 2.0, 0.02),
    PushTrial("hold", "low", 1000, 0, saturated=0.0, travel=0.2, peak=0.1, cycle=0.01),
)


@cache
def designed(name: str) -> LinearController:
    return as_linear(make_controller(name, ROBOT, KIT, KIT.period))


def scaled(controller: LinearController, factor: float) -> LinearController:
    return dataclasses.replace(controller, **{n: factor * getattr(controller, n) for n in ("C", "Dy", "Dr")})


@cache
def green() -> Certificate:
    return certify(designed("pid"), ROBOT, KIT, samples=100, posterior=CALIBRATED, sweeps=False)


@cache
def red() -> Certificate:
    return certify(scaled(designed("pid"), -1.0), ROBOT, KIT, samples=100, sweeps=False)


def test_a_controller_that_is_called_falls_where_its_matrices_fall(monkeypatch: pytest.MonkeyPatch) -> None:
    # the same lqg once as gains in compiled code and once called for each of 66 robots, more than one block of them,
    # under the first of the pushes
    plan = checks._plan
    monkeypatch.setattr(checks, "_plan", lambda setup: plan(setup)[:1])
    family = draw(ROBOT, 66, 3)
    trial_setup = TrialSetup(ROBOT, family, KIT, controller=kernel_controller(designed("lqg"), ROBOT, KIT))
    called = dataclasses.replace(
        trial_setup, controller=KernelController(Law(idle(designed("lqg").spec)), designed("lqg"))
    )
    (first, fell, _), (second, dropped, _) = trials(trial_setup), trials(called)
    assert np.array_equal(fell, dropped)
    # products are summed in another order: rounding, which quantised sensors now and then make a step of
    assert [t.peak for t in first] == pytest.approx([t.peak for t in second], abs=2e-3)


def test_pushes_that_share_a_batch_give_the_bytes_of_one_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Five robots, so that one block of the kernel holds several pushes, at both batteries and on two slopes."""
    robot = ROBOT.replace(conditions=Conditions(slope=(0.0, 0.05)))
    setup = TrialSetup(robot, draw(robot, 5, 3), KIT, controller=kernel_controller(designed("lqg"), robot, KIT))
    together = [(one.counted, one.run) for one in tried(setup)]
    monkeypatch.setattr(checks, "TOGETHER", 1)
    alone = [(one.counted, one.run) for one in tried(setup)]
    assert len(alone) == 12
    for (first, run_together), (second, run_alone) in zip(together, alone, strict=True):
        assert first == second
        assert np.array_equal(run_together.trace, run_alone.trace, equal_nan=True)


def test_a_predictive_controller_holds_in_the_compiled_loop_as_in_run() -> None:
    controller = make_controller("mpc", ROBOT, KIT, KIT.period)
    found, fell, _ = trials(TrialSetup(ROBOT, [ROBOT] * 3, KIT, controller=kernel_controller(controller, ROBOT, KIT)))
    assert not fell.any()
    push = standard_pushes(ROBOT, KIT, 1.12 * KIT.battery.voltage)[found[1].push].push
    log = run(Electronics(NonlinearBody(ROBOT), KIT), controller, push, seconds=4, seed=3)
    # peaks differ by noise alone, as for a linear controller: below some hundredths of a radian
    assert abs(np.abs(log["truth/pitch"]).max() - found[1].peak) < 0.03


def test_a_sliding_mode_is_certified_without_calling_it(monkeypatch: pytest.MonkeyPatch) -> None:
    shares: list[float] = []
    controller = make_controller("sliding", ROBOT, KIT, KIT.period)
    monkeypatch.setattr(type(controller), "__deepcopy__", None, raising=False)  # a called one is copied for each robot
    found = certify(controller, ROBOT, KIT, samples=100, posterior=CALIBRATED, sweeps=False, progress=shares.append)
    assert found.fell == 0
    assert found.linear is not None  # near rest it is linear
    assert found.linear.stable
    assert shares == sorted(shares)
    # 5 of 6 pushes on 100 robots are together within 512 runs; then the file's robot is left alone 4 times, and all
    assert shares == pytest.approx([500 / 704, 600 / 704, 604 / 704, 1.0])
    # 100 robots without a fall prove 1 − 0.05^(1/100) = 2.95 % and no less, and the certificate says so
    assert math.isclose(found.bound, 1 - 0.05**0.01)


@pytest.mark.evidence
def test_of_a_law_that_is_not_linear_a_certificate_holds_no_margins() -> None:
    measured = Robot.preset("nxtway-gs-measured")
    controller = make_controller("lqr-complementary", measured, KIT, KIT.period)
    found = certify(controller, measured, KIT, samples=100, posterior=Uncertainty(), sweeps=False)
    assert found.linear is None
    assert Certificate.from_json(json.loads(json.dumps(found.to_json()))) == found


def test_where_nothing_linear_is_known_it_says_so() -> None:
    light, reasons = judge(Examined(1000, 0, None, [TRIAL], 0.01))
    assert light == GREEN
    assert str(reasons[1]) == "No linear margins are known."


class Broken:
    """A controller whose command is no number."""

    @property
    def spec(self) -> ControllerSpec:
        return designed("pid").spec

    def reset(self) -> None: ...

    def step(self, _y: object, _r: object) -> tuple[float, float]:
        return math.nan, 0.0

    def estimate(self) -> tuple[()]:
        return ()

    def applied(self, _command: object) -> None: ...

    def to_json(self) -> dict[str, Any]:
        return {}


def test_a_controller_that_breaks_is_named_not_swallowed() -> None:
    with pytest.raises(SpecMismatch, match="finite"):
        certify(Broken(), ROBOT, KIT, samples=100, sweeps=False)


@cache
def recording(noise: float = 0.0) -> Log:
    """8 s of the robot under pid, its left encoder noisier by `noise` [rad], which no certificate learns from a log."""
    name = "sensor/encoder_left"
    louder = dataclasses.replace(KIT.sensors[name], noise=math.hypot(KIT.sensors[name].noise, noise))
    kit = dataclasses.replace(KIT, sensors=KIT.sensors | {name: louder})
    return run(Electronics(NonlinearBody(ROBOT), kit), designed("pid"), Hold(pitch=0.05, until=3.0), seconds=8, seed=11)


@pytest.mark.parametrize(("noise", "light"), [(0.0, GREEN), (0.015, AMBER), (0.06, RED)])
def test_a_log_that_surprises_more_than_the_drawn_robots_tells_on_the_light(noise: float, light: str) -> None:
    # the encoder's quantum is 1°, a scatter of 0.005 rad: 0.015 rad are a few times that, 0.06 far more than five times
    found = certify(designed("pid"), ROBOT, KIT, samples=100, posterior=CALIBRATED, sweeps=False, log=recording(noise))
    assert found.light == light
    assert [a.sensor for a in found.agreement] == ["encoder_left", "encoder_right", "gyro"]
    assert light == GREEN or "innovations of the left encoder" in str(found.reasons[0])
    assert Certificate.from_json(json.loads(json.dumps(found.to_json()))) == found


def test_the_thresholds_of_surprise_stand_between_the_lights() -> None:
    lights = [
        judge(Examined(1000, 0, LINEAR, [TRIAL], 0.01, [Agreement("gyro", s, 1.0)]))[0] for s in (1.9, 2.1, 4.9, 5.1)
    ]
    assert lights == [GREEN, AMBER, AMBER, RED]


def test_missing_readings_are_left_out_and_short_or_uneven_logs_refused() -> None:
    log = recording()
    setup = TrialSetup(ROBOT, [ROBOT] * 12, KIT, controller=kernel_controller(designed("pid"), ROBOT, KIT))
    drawn = followed_runs(setup)

    def compared(log: Log) -> tuple[Agreement, ...]:
        return agreement(log, setup, drawn, KIT.period)

    holes = np.array(log["sensor/gyro"])
    holes[::7] = np.nan
    with_holes = Log(log.t, {**log.channels, "sensor/gyro": holes})
    # one gyro reading in seven less: the filter foretells the others about as well
    assert compared(with_holes)[2].measured == pytest.approx(compared(log)[2].measured, rel=0.3)
    with pytest.raises(InvalidLog, match="lasts"):
        compared(log.between(0.0, 1.5))
    rows = np.sort(np.random.default_rng(0).choice(len(log), 400, replace=False))
    with pytest.raises(InvalidLog, match="uneven"):
        compared(Log(log.t[rows], {n: v[rows] for n, v in log.channels.items()}))
    silent = {n: v for n, v in log.channels.items() if "applied" not in n and "command" not in n}
    with pytest.raises(InvalidLog, match="no commands"):
        compared(Log(log.t, silent))


class Hardware:
    """A body that says it is real: the nonlinear model behind electronics, its sensors alone."""

    def __init__(self) -> None:
        self.body = Electronics(NonlinearBody(ROBOT), KIT)
        channels = tuple(s for s in self.body.spec.channels if s.name.startswith("sensor/"))
        self.spec = dataclasses.replace(self.body.spec, kind="brick", real=True, channels=channels)
        self.steps, self._skip = 0, len(self.body.spec.channels) - len(channels)

    def _seen(self, now: Sample) -> Sample:
        return now._replace(numbers=now.numbers[self._skip :])

    def reset(self, start: Any = (0.0,) * 6, seed: int = 0) -> Sample:
        return self._seen(self.body.reset(start, seed))

    def step(self, command: Any, disturbance: Any = CALM) -> Sample:
        self.steps += 1
        return self._seen(self.body.step(command, disturbance))

    def close(self) -> None:
        self.body.close()


def test_hardware_is_not_driven_on_a_red_certificate_unless_demanded() -> None:
    wrong, brick = scaled(designed("pid"), -1.0), Hardware()
    with pytest.raises(NotPermitted, match="red: The nominal loop is unstable"):
        run(brick, wrong, seconds=0.1, certificate=red())
    assert brick.steps == 0  # it is refused before the motors turn
    log = run(brick, wrong, seconds=0.1, certificate=red(), anyway=True)
    assert log.origin["scenario"]["certificate"].startswith("overridden: red")
    with pytest.raises(NotPermitted, match="another"):
        run(brick, scaled(designed("pid"), 1.01), seconds=0.1, certificate=green())
    assert (
        run(brick, designed("pid"), seconds=0.1, certificate=green()).origin["scenario"]["certificate"] == "certified"
    )
    model = Electronics(NonlinearBody(ROBOT), KIT)
    assert "certificate" not in run(model, wrong, seconds=0.1, certificate=red()).origin["scenario"]  # nothing breaks


def test_a_program_for_a_brick_asks_the_same_question(tmp_path: Path) -> None:
    path = tmp_path / "c.json"
    path.write_text(json.dumps(green().to_json()))
    assert permitted(designed("pid"), read_certificate(path), ROBOT, KIT) == "certified"
    assert permitted(designed("pid"), None, ROBOT) == "not certified"
    with pytest.raises(NotPermitted, match="another"):
        permitted(designed("lqg"), read_certificate(path), ROBOT, KIT)
    path.write_text("{")
    with pytest.raises(InvalidController, match="no JSON"):
        read_certificate(path)
    with pytest.raises(InvalidController, match="cannot read"):
        read_certificate(tmp_path / "none.json")


def test_a_calibration_hands_on_its_posterior_and_longer_dead_times() -> None:
    names, covariance = ("com_height", "delay/gyro", "torque_constant"), np.diag([1e-6, 1e-8, 4e-6])
    late = SimpleNamespace(name="delay/gyro", value=0.03, verdict="visible")
    calibration: Any = MagicMock(names=names, covariance=covariance, robot=ROBOT, delays=(late,), parameters=())
    calibration.__getitem__.return_value = SimpleNamespace(
        value=-0.1, low=-0.2, high=0.1
    )  # of a constant command, in V
    found = learnt(calibration, KIT)
    assert found.floor is not None
    assert found.floor[1] < 0 < found.floor[0] < found.floor[2]  # what drives it back is a floor that rises
    assert {s.kind for s in found.uncertainty.spreads} == {"lognormal"}  # as a calibration takes positive numbers
    sizes = {s.name: s.high * s.low for s in found.uncertainty.spreads}  # to first order
    assert sizes == pytest.approx({"com_height": 1e-3, "torque_constant": 2e-3})
    assert np.array_equal(found.uncertainty.correlation, np.eye(2))
    # 30 ms from command to gyro, of which the kit's own dead time and half its jitter are the command's
    assert found.kit.sensors["sensor/gyro"].delay == pytest.approx(0.03 - KIT.delay - KIT.jitter / 2)
    assert found.kit.sensors["sensor/encoder_left"] == KIT.sensors["sensor/encoder_left"]


def test_a_calibrated_robots_file_says_how_its_errors_go_together() -> None:
    # what is held at its prior was not found with the others, and a dead time is no number of a robot
    estimates = tuple(SimpleNamespace(name=n, verdict=v) for n, v in (("track", "visible"), ("body_mass", HELD),
                                                                      ("com_height", "visible")))  # fmt: skip
    names, root = ("track", "delay/gyro", "body_mass", "com_height"), np.random.default_rng(0).normal(size=(4, 4))
    calibration: Any = SimpleNamespace(
        names=names, parameters=estimates, correlation=np.corrcoef(root @ root.T), robot=ROBOT, kit=None
    )
    robot = Calibration.known_robot(calibration)
    assert dict(robot.correlation) == {("com_height", "track"): pytest.approx(np.corrcoef(root @ root.T)[3, 0])}


def test_command_draws_its_robots_from_what_a_calibration_makes_of_the_log(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Here it makes a robot of a name that nothing else has; what it makes of planted numbers is in `test_support`."""
    asked: list[tuple[Log, Robot]] = []

    def calibrated(log: Log, setup: TrialSetup, progress: object = None) -> tuple[Learnt, tuple[()]]:
        asked.append((log, setup.robot))
        return Learnt(ROBOT.replace(name="found", body_mass=1.01 * ROBOT.body_mass), KIT, CALIBRATED), ()

    monkeypatch.setattr(import_module("upright.likelihood.calibrated"), "calibrated", calibrated)
    whole = recording()
    whole.save(tmp_path / "run.csv")
    assert main(["certify", "pid", "--log", str(tmp_path / "run.csv"), "-n", "100", "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    ((log, robot),) = asked
    assert robot == ROBOT
    assert np.allclose(log["sensor/gyro"], whole["sensor/gyro"])
    assert (said["robot"], said["light"]) == ("found", GREEN)
    # a log of this very robot: nothing in it surprises more than the drawn robots do
    assert all(a["measured"] < 2 * a["expected"] for a in said["agreement"])
    assert len(said["agreement"]) == 3


def test_a_log_with_a_flipped_gyro_or_of_a_robot_that_is_held_is_refused_at_once() -> None:
    """No scale that a certificate tries is negative, and what spins its wheels on a stand shows nothing of the loop."""
    log = example("excited")
    noise = np.random.default_rng(1).normal(0.0, 0.005, len(log))
    spun = {f"sensor/encoder_{side}": 10 * (1 - np.cos(2 * log.t)) for side in ("left", "right")}
    for changed, words in (
        ({"sensor/gyro": -log["sensor/gyro"]}, r"wrong sign, gyro.* --fix"),
        ({"sensor/gyro": noise, **spun}, "never on its wheels"),
    ):
        with pytest.raises(InvalidLog, match=words):
            certify("pid", ROBOT, KIT, samples=100, log=Log(log.t, {**log.channels, **changed}, log.units))


def test_a_quiet_log_of_this_very_robot_shows_no_other_one() -> None:
    """A filter that expects larger disturbances than there are finds the gyro to count 0.83 times: its innovations are
    then expected to be smaller."""
    assumed = Assumptions(ROBOT, draw(ROBOT, 100, 0), KIT)
    assert as_logged(recording(), assumed)[2] == ()


def test_the_table_of_controllers_counts_drawn_robots_that_fall() -> None:
    # of a robot about which nothing is unknown every draw is the robot itself, and falls or holds as it does
    known = ROBOT.replace(provenance={})
    row, _ = bench_one("pid", "front", known, KIT, body="nonlinear", seed=1, drawn=draw(known, 20))
    assert row.holds
    assert row.spread == 0.0
    assert row.impulse
    knock = list(standard_pushes(ROBOT, KIT).values())[-1].size
    assert row.impulse > knock  # the certificate's, which it survives with both batteries
    plant = Electronics(NonlinearBody(known), KIT)
    again = largest_knock(plant, make_controller("pid", known, KIT, KIT.period), 1.0, seed=1)
    # begun at the kernel's border or far off, the search ends at the same border, to its tolerance from either side
    assert abs(math.log(row.impulse / again)) < 2 * math.log(1 + TOLERANCE)
    name = "lqr-complementary"
    slow, _ = bench_one(name, "front", known, KIT, body="nonlinear", seed=1, drawn=[known], knocks=False)
    assert slow.spread is None  # called in Python, which is too slow for a table
