"""What is not known of a robot: distributions by their moments, and one draw for certificates, designs and fleets."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from upright.calibration.parameters import parameters_of
from upright.certification.checks import TrialSetup, kernel_controller, trials
from upright.control import make_controller
from upright.errors import InvalidRobot, InvalidScenario, UnknownName
from upright.fleets.ensemble import Ensemble
from upright.fleets.vary import variation
from upright.robots import PARAMETERS, Kit, Provenance, Robot
from upright.robots.drives import UNUSED
from upright.robots.robot import MAY_BE_ZERO
from upright.robots.uncertainty import BLOCK, GUESS, Family, Spread, Uncertainty, deviations, draw, read_posterior

ROBOT, NXT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
N = 20000


def drawn(uncertainty: Uncertainty, seed: int = 0, robot: Robot = ROBOT) -> dict[str, np.ndarray]:
    return Family(robot, None, uncertainty).draw(seed, range(N))


def guessed(**values: float) -> Robot:
    """The robot, with these numbers as guesses and nothing else unknown."""
    sources = {name: Provenance("nobody measured it") for name in values}
    return replace(ROBOT.replace(**values), provenance=sources)


# Moments, against closed forms; tolerances are five standard errors


def test_a_spread_is_the_standard_deviation_of_a_normal_distribution():
    values = drawn(Uncertainty.normal(ROBOT, {"com_height": 0.0036}))["com_height"]
    assert abs(values.mean() - ROBOT.com_height) < 5 * 0.0036 / math.sqrt(N)
    assert values.std() == pytest.approx(0.0036, rel=5 / math.sqrt(2 * N))
    assert (np.abs(values - ROBOT.com_height) > 3 * 0.0036).mean() == pytest.approx(0.0027, abs=0.002)  # it is not cut


def test_a_guess_is_log_normal_within_a_factor_of_two():
    robot = guessed(wheel_inertia=2e-5)
    values = drawn(Uncertainty.of(robot), robot=robot)["wheel_inertia"]
    logs = np.log(values / 2e-5)
    assert abs(logs.mean()) < 5 * GUESS / math.sqrt(N)
    assert logs.std() == pytest.approx(math.log(2), rel=5 / math.sqrt(2 * N))
    inside = ((values > 1e-5) & (values < 4e-5)).mean()
    assert inside == pytest.approx(math.erf(1 / math.sqrt(2)), abs=5 * math.sqrt(0.68 * 0.32 / N))


def test_a_guess_is_the_same_to_a_draw_and_to_a_calibration():
    robot = guessed(wheel_inertia=2e-5)
    prior = next(p for p in parameters_of(robot, {}) if p.name == "wheel_inertia")
    (spread,) = Uncertainty.of(robot).spreads
    z = np.linspace(-3, 3, 7)
    np.testing.assert_allclose(spread.at(z), prior.value(z), rtol=1e-14)
    assert prior.guess


def test_a_posterior_is_drawn_with_its_mean_and_covariance(tmp_path):
    mean, covariance = [0.072, 0.6], [[1e-6, 8e-6], [8e-6, 1e-4]]  # a correlation of 0.8
    file = tmp_path / "posterior.json"
    file.write_text(json.dumps({"parameters": ["com_height", "body_mass"], "mean": mean, "covariance": covariance}))
    values = drawn(read_posterior(file), seed=3)
    sampled = np.cov([values[name] for name in ("com_height", "body_mass")])
    # relative standard error of a variance √(2/n) = 1 %, of this covariance √((1 + 1/0.64)/n) = 1.1 %: five of them
    np.testing.assert_allclose(sampled, covariance, rtol=0.055)
    for i, name in enumerate(("com_height", "body_mass")):
        assert abs(values[name].mean() - mean[i]) < 5 * math.sqrt(covariance[i][i] / N)


def test_a_robots_own_correlations_are_drawn():
    # standard error of a correlation of 0.9: (1 − 0.81)/√n = 0.0013; of none: 1/√n = 0.007
    robot = replace(ROBOT, correlation={("com_height", "body_mass"): 0.9})
    values = drawn(Uncertainty.of(robot), robot=robot)
    pairs = np.corrcoef([values[name] for name in ("com_height", "body_mass", "track")])
    assert pairs[0, 1] == pytest.approx(0.9, abs=0.007)
    assert abs(pairs[0, 2]) < 0.036


def test_what_varies_beside_a_posterior_is_independent_of_it():
    both = Uncertainty.joint(["com_height", "body_mass"], [0.072, 0.6], [[1e-6, 8e-6], [8e-6, 1e-4]])
    values = drawn(both + variation("track=±5%", ROBOT))
    pairs = np.corrcoef(list(values.values()))
    assert pairs[0, 1] == pytest.approx(0.8, abs=0.013)  # five of (1 − 0.64)/√n
    assert np.abs(pairs[2, :2]).max() < 0.036


def test_narrower_is_narrower_about_the_same_median():
    for spread in (
        Spread("track", "uniform", 1, 3),
        Spread("track", "normal", 2, 0.5),
        Spread("track", "lognormal", 2, 1),
    ):
        z = np.array([-1.0, 0.0, 1.0])
        wide, small = spread.at(z), spread.scaled(0.1).at(z)
        assert small[1] == pytest.approx(wide[1]) == pytest.approx(spread.middle)
        assert 0 < small[2] - small[0] < 0.15 * (wide[2] - wide[0])


# What stays


def test_a_gears_teeth_are_counted_unless_a_spread_is_stated():
    assert "gear_ratio" not in deviations(ROBOT)  # its source calls it an estimate: a guess
    stated = {**ROBOT.provenance, "gear_ratio": Provenance("slips", 0.01)}
    assert deviations(ROBOT.replace(provenance=stated))["gear_ratio"] == 0.01


def test_no_friction_is_drawn_that_no_source_names():
    robot = guessed(coulomb_friction=0.0, motor_friction=0.002)
    assert Uncertainty.of(robot).names == ("motor_friction",)


def test_what_is_known_is_not_drawn():
    assert set(Uncertainty.of(ROBOT).names) - set(Uncertainty.of(ROBOT, ["track"]).names) == {"track"}


# What a robot can be


def test_possible_robots_are_those_that_can_be_made():
    own = {name: value for name, value in ROBOT.numbers().items() if name not in UNUSED[ROBOT.drive]}
    wide = Uncertainty(tuple(Spread(n, "normal", v, 0.5 * abs(v) + 0.01) for n, v in own.items()))
    family = Family(ROBOT, uncertainty=wide)
    rng = np.random.Generator(np.random.Philox(1))
    values = np.abs(np.array(list(own.values())) * (1 + 0.3 * rng.standard_normal((400, len(wide.names)))))
    values[::7, rng.integers(0, len(wide.names), 58)] *= -1
    values[::11, list(PARAMETERS).index("track")] = 3.5  # beyond the largest robot
    values[::13, list(PARAMETERS).index(MAY_BE_ZERO[0])] = 0.0
    made = []
    for row in values.tolist():
        try:
            made.append(bool(ROBOT.replace(**dict(zip(family.names, row, strict=True)))))
        except InvalidRobot:
            made.append(False)
    assert family.possible(values).tolist() == made
    assert 0.1 < np.mean(made) < 0.9  # both kinds are well represented, else the test would say nothing


def test_a_torque_drive_has_no_electrical_numbers_to_vary():
    twipr = Robot.preset("twipr")
    with pytest.raises(InvalidRobot, match="vary less"):
        Family(twipr, uncertainty=Uncertainty.normal(twipr, {"motor_resistance": 0.1})).draw(0, range(3))


def test_what_no_robot_can_be_is_drawn_again():
    # a normal distribution of deviation σ about σ, above zero alone: mean σ (1 + φ(1)/Φ(1)) = 1.2876 σ
    values = drawn(Uncertainty.normal(ROBOT, {"track": ROBOT.track}))["track"]
    assert values.min() > 0
    ratio = math.exp(-0.5) / math.sqrt(2 * math.pi) / (0.5 * (1 + math.erf(1 / math.sqrt(2))))
    assert values.mean() == pytest.approx(ROBOT.track * (1 + ratio), rel=5 * 0.8 / 1.29 / math.sqrt(N))
    with pytest.raises(InvalidRobot, match="vary less"):
        Family(ROBOT, uncertainty=Uncertainty((Spread("com_height", "uniform", -2.0, -1.0),))).draw(0, range(10))


def test_the_other_inertias_keep_their_spreads_whatever_the_roll_inertia():
    sizes = {name: 0.25 * getattr(ROBOT, name) for name in ("pitch_inertia", "yaw_inertia", "roll_inertia")}
    values = drawn(Uncertainty.normal(ROBOT, sizes))
    for name in ("pitch_inertia", "yaw_inertia"):
        assert values[name].mean() == pytest.approx(getattr(ROBOT, name), rel=5 * 0.25 / math.sqrt(N))
        assert values[name].std() == pytest.approx(sizes[name], rel=5 / math.sqrt(2 * N))


def test_a_roll_inertia_follows_the_other_two():
    values = drawn(variation("pitch_inertia=±30%", ROBOT))
    pitch, roll = values["pitch_inertia"], values["roll_inertia"]
    assert pitch.min() < 0.71 * ROBOT.pitch_inertia  # the range is not cut where the nominal roll inertia ends it
    assert (roll <= pitch + ROBOT.yaw_inertia).all()
    assert (roll >= np.abs(pitch - ROBOT.yaw_inertia)).all()
    free = (pitch + ROBOT.yaw_inertia > ROBOT.roll_inertia) & (np.abs(pitch - ROBOT.yaw_inertia) < ROBOT.roll_inertia)
    assert (roll[free] == ROBOT.roll_inertia).all()


# One draw for all


def test_any_part_of_a_family_is_drawn_by_itself():
    family = Family(ROBOT, NXT, Uncertainty.of(ROBOT) + variation("delay=0..0.01", ROBOT, NXT))
    whole = family.draw(7, range(2 * BLOCK))
    some = np.array([5, BLOCK + 3, BLOCK - 1, 5])  # out of order, twice, and from two blocks
    part = family.draw(7, some)
    for name, values in whole.items():
        assert (part[name] == values[some]).all()
    assert (family.draw(8, some)["delay"] != part["delay"]).all()


@pytest.mark.parametrize("source", ["robot", "posterior"])
def test_a_certificate_and_a_fleet_draw_the_same_robots(source, tmp_path):
    # one file and one seed: the certificate's robots are the fleet's, to the last bit
    if source == "robot":
        robot = replace(ROBOT, correlation={("com_height", "body_mass"): -0.8}).save(tmp_path / "robot.toml")
        robot = Robot.load(robot)
        uncertainty = Uncertainty.of(robot)
    else:
        file = tmp_path / "posterior.json"
        names, covariance = ["com_height", "body_mass"], [[1e-6, 8e-6], [8e-6, 1e-4]]
        file.write_text(json.dumps({"parameters": names, "mean": [0.07, 0.6], "covariance": covariance}))
        uncertainty = read_posterior(file)
        robot = uncertainty.middle(ROBOT)
        assert (robot.com_height, robot.body_mass) == (0.07, 0.6)
    controller = make_controller("lqr", robot, NXT, NXT.period)
    ensemble = Ensemble(family=Family(robot, NXT, uncertainty), controller=controller, seed=5)
    batch = ensemble.batch(range(100)).parameters
    certified = draw(robot, 100, 5, uncertainty)
    assert (batch == np.array([list(each.numbers().values()) for each in certified])).all()
    trial_setup = TrialSetup(robot, certified, NXT, 5, controller=kernel_controller(controller, robot, NXT))
    assert len(trials(trial_setup)[1]) == 100


def test_draws_repeat_with_the_seed():
    assert draw(ROBOT, 3, seed=7) == draw(ROBOT, 3, seed=7)
    assert draw(ROBOT, 3, seed=7) != draw(ROBOT, 3, seed=8)
    assert draw(ROBOT, 3, seed=7) == draw(ROBOT, 5, seed=7)[:3]
    assert draw(ROBOT, 2, uncertainty=Uncertainty()) == [ROBOT, ROBOT]


# Files, and what is refused


def test_a_calibrations_own_file_is_a_posterior(tmp_path):
    file = tmp_path / "calibration.json"
    names = ["com_height", "encoder_delay"]
    file.write_text(json.dumps({"robot": {"com_height": 0.07}, "names": names, "covariance": [[1e-6, 0], [0, 1e-6]]}))
    assert read_posterior(file).spreads == (Spread("com_height", "normal", 0.07, 1e-3),)  # a dead time is no parameter


@pytest.mark.parametrize("text", ["{}", "[", '{"parameters": ["com_height"], "mean": [1], "covariance": [[NaN]]}'])
def test_a_file_that_holds_no_posterior_is_refused(text, tmp_path):
    file = tmp_path / "posterior.json"
    file.write_text(text)
    with pytest.raises(InvalidRobot, match="posterior"):
        read_posterior(file)
    with pytest.raises(InvalidRobot, match="cannot read"):
        read_posterior(tmp_path / "none.json")


def test_what_cannot_be_is_refused():
    with pytest.raises(UnknownName, match="did you mean 'body_mass'"):
        Uncertainty.normal(ROBOT, {"bodymass": 0.1})
    with pytest.raises(InvalidScenario, match="twice"):
        variation("com_height=±10%", ROBOT) + variation("com_height=±5%", ROBOT)
    for covariance in ([[1.0, 2.0], [2.0, 1.0]], [[-1.0, 0.0], [0.0, 1.0]], [[1.0, 0.5], [0.0, 1.0]]):
        with pytest.raises(InvalidRobot, match="covariance"):
            Uncertainty.joint(["com_height", "body_mass"], [0.0, 0.0], covariance)
