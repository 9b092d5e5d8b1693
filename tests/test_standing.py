"""Does it stand, how hard may it be pushed, and which numbers are guesses: each against a truth of its own."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.stats import binom

from upright.calibration.parameters import parameters_of
from upright.certification.certificate import Certificate, certify
from upright.certification.checks import PushTrial, TrialSetup, kernel_controller
from upright.certification.narrowing import BY_HAND, Guessed, by_run
from upright.certification.recovery import largest_slope, means
from upright.certification.standing import Endured, Standing, Strength, endured, standing
from upright.certification.verdict import RED, UNKNOWN, Examined, judge
from upright.cli.main import main
from upright.control import find_controller
from upright.errors import InvalidScenario
from upright.physics.dynamics import Disturbance, accelerations
from upright.physics.linear import linearise
from upright.robots import PARAMETERS, Kit, Robot
from upright.robots.drives import UNUSED

ROBOT, IDEAL, NXT = Robot.preset("nxtway-gs"), Kit.preset("ideal"), Kit.preset("nxt")
GUESSED = """
name = "thirteen"
drive = "torque"
kit = "ideal"
{numbers}"""
NUMBERS = {
    "wheel_mass": (1.0, 0.03), "wheel_radius": (0.1, 0.003), "wheel_inertia": (0.005, None), "body_mass": (11.0, 0.33),
    "track": (0.5, 0.015), "com_height": (0.3, None), "pitch_inertia": (0.4, None), "yaw_inertia": (0.3, None),
    "roll_inertia": (0.5, None), "rotor_inertia": (0.0, 0.0),
}  # fmt: skip
UNITS = {"mass": "kg", "inertia": "kg m^2"}


def guessed_robot(folder: Path) -> Path:
    """A robot whose height and inertias are guesses, as a student's file is."""
    tables = []
    for name, (value, spread) in NUMBERS.items():
        unit = UNITS.get(name.rpartition("_")[2], "m")
        known = '"guess"' if spread is None else spread
        tables.append(f'[{name}]\nvalue = {value}\nunit = "{unit}"\nsource = "a scale"\nspread = {known}\n')
    path = folder / "robot.toml"
    path.write_text(GUESSED.format(numbers="\n".join(tables)))
    return path


def test_what_hangs_on_guesses_is_unknown(tmp_path: Path) -> None:
    """A factor of two in the height of its mass is more than any controller bears; the file's robot stands."""
    certificate = certify("lqr", str(guessed_robot(tmp_path)), samples=200)
    assert certificate.light == UNKNOWN
    assert certificate.standing.fell_at is None
    assert certificate.guessed is not None
    assert set(certificate.guessed.names) == {name for name, (_, spread) in NUMBERS.items() if spread is None}
    assert certificate.guessed.fell <= 0.05 * certificate.guessed.runs
    assert certificate.to_measure()[0] in certificate.guessed.names
    assert certificate.reasons[1].kind == "measure"
    assert certificate.refuses().startswith("unknown")
    assert Certificate.from_json(certificate.to_json()) == certificate


@pytest.mark.parametrize(("fell", "light"), [(0, UNKNOWN), (10, UNKNOWN), (21, UNKNOWN), (25, RED), (300, RED)])
def test_red_needs_a_reason_that_holds_with_the_guesses_as_the_file_has_them(fell: int, light: str) -> None:
    """Most robots of the spreads fall. Of 300 with the guesses as the file has them 5 % are 15: binomial, 22 or more
    of them fall by chance in one of twenty such robots at most."""
    assert binom.sf(21, 300, 0.05) < 0.05 < binom.sf(20, 300, 0.05)
    trial = PushTrial("hold at +0.17 rad", "full", 200, 150, saturated=0.0, travel=0.0, peak=0.0, cycle=0.0)
    known = Standing(None, 0.1, 200, 88)
    given, reasons = judge(
        Examined(200, 150, None, [trial], 0.01, standing=known, guessed=Guessed(("com_height",), 300, fell))
    )
    assert given == light
    said = str(reasons[0])
    assert f"{fell} of 300" in (said if light == UNKNOWN else str(reasons[1]))
    assert "With every guess exactly as in the file" in (said if light == UNKNOWN else str(reasons[1]))


@pytest.mark.parametrize("drive", ["voltage", "torque", "speed"])
def test_every_advised_run_is_one_that_excite_plans(drive: str) -> None:
    """Of a drive by speed it plans none: then each number that such a robot's file may guess is measured by hand."""
    robot = Robot.preset({"voltage": "nxtway-gs", "torque": "twipr", "speed": "stepper"}[drive])
    used = [name for name in PARAMETERS if name not in UNUSED[drive]]
    asked = [p.name for p in parameters_of(robot, {}, foreign=True)]
    for name in used:
        assert not by_run([name], drive) or (drive != "speed" and name in asked)
    drawn = {name for name, source in robot.provenance.items() if source.spread is None}
    if drive == "speed":
        assert all(name in BY_HAND for name in drawn)


@pytest.mark.parametrize(
    ("strength", "words"),
    [
        (Strength(14.8, 60.0, 8.3), "a gear ratio of 60 would do"),
        (Strength(14.8, None, 8.3), "a battery of 14.8 V would do, if motors that now get 8.3 V bear it"),
        (Strength(8.1, None, 8.3), "a battery of 8.1 V would do"),
        (Strength(None, None), "not even three times the gear would do"),
        (Strength(None, None, 8.3), "neither three times the voltage nor three times the gear would do"),
    ],
)
def test_no_battery_is_advised_that_motors_may_not_bear_where_a_gear_would_do(strength: Strength, words: str) -> None:
    assert str(strength.message).replace("\u00a0", " ") == words


def test_unknown_stops_a_script(tmp_path: Path) -> None:
    assert main(["certify", "lqr", "--robot", str(guessed_robot(tmp_path)), "-n", "100"]) == 3


def test_the_longest_period_is_that_of_the_sampled_loop() -> None:
    """Without noise or delay the loop is x⁺ = (Φ − Γ K) x: its poles leave the circle at the longest period."""
    robot = ROBOT.without_dry_friction()
    controller = find_controller("lqr-state", robot, IDEAL, 0.01)
    setup = TrialSetup(robot, [robot] * 10, IDEAL, controller=kernel_controller(controller, robot, IDEAL))
    model, K = linearise(robot), np.asarray(controller.gain)
    block = np.zeros((8, 8))
    block[:6] = np.hstack([model.A, model.B])

    def radius(period: float) -> float:
        held = expm(block * period)
        decaying = held[:6, :6] - held[:6, 6:] @ K
        return float(np.abs(np.linalg.eigvals(decaying)).max())

    last = next(k for k in range(10, 500) if radius(k * 1e-3) >= 1) - 1
    longest = standing(setup).longest
    assert longest is not None
    # a lean of 1° that grows by 1.09 in a second has become 0.1 rad in 20 s: slower ones seem to stand
    later = next(k for k in range(last, 500) if radius(k * 1e-3) ** (1 / (k * 1e-3)) > 1.09)
    assert last * 1e-3 <= longest + 1e-9
    assert longest <= later * 1e-3


def test_the_steepest_slope_is_that_of_statics() -> None:
    """Full command there: nothing accelerates at the pitch at which the weight bears the motors' torque."""
    weak = ROBOT.without_dry_friction()
    kit = Kit(name="weak", sensors=IDEAL.sensors, motor=type(IDEAL.motor)(limit=1.0))
    slope = largest_slope(weak, kit)
    most = means(weak, kit).most
    torque = 2 * weak.gear_ratio * weak.torque_constant / weak.motor_resistance * most
    lean = slope + math.asin(torque / (weak.body_mass * weak.gravity * weak.com_height))
    still = accelerations((lean, 0.0, 0.0, 0.0, 0.0, 0.0), (most, most), weak, Disturbance(slope=slope))
    assert np.abs(still).max() < 1e-9  # rounding of accelerations of some 100 rad/s²


def test_what_is_endured_stays_below_what_any_controller_could() -> None:
    controller = find_controller("pid", ROBOT, NXT, NXT.period)
    setup = TrialSetup(ROBOT, [ROBOT], NXT, controller=kernel_controller(controller, ROBOT, NXT))
    knock, hold, slope = endured(setup)
    for push in (knock, hold):
        assert push.best is not None
        assert 0 < push.size <= push.best
    assert (
        knock.size >= 0.5 * knock.best
    )  # of the standard knock, 0.6 of it, this robot falls by no seed of a benchmark
    assert slope.size > 0


@pytest.mark.parametrize(
    ("push", "words"),
    [
        (Endured("knock", 0.05, 0.2), "knock 0.05 N s (best possible 0.2 N s)"),
        (Endured("hold", 1.5, None), "hold 1.5 N"),
        (Endured("slope", math.radians(5), None), "slope 5°"),
    ],
)
def test_a_push_says_its_unit(push: Endured, words: str) -> None:
    assert str(push.message).replace("\u00a0", " ") == words


def test_a_name_is_designed_for_the_period_that_is_asked() -> None:
    certificate = certify("lqg", ROBOT, NXT, samples=100, sweeps=False, period=0.008)
    assert certificate.period == 0.008
    with pytest.raises(InvalidScenario, match=r"0\.02 s for a controller of 0\.01 s"):
        certify(find_controller("lqg", ROBOT, NXT, 0.01), ROBOT, NXT, samples=100, period=0.02)
