"""What a log contradicts of a certificate: planted in the body or the kit, found with its size, and nothing else."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Sequence
from functools import cache
from importlib import import_module
from itertools import pairwise
from types import SimpleNamespace
from typing import Any
from unittest.mock import MagicMock

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.body import Sample
from upright.calibration.estimate import Estimate
from upright.calibration.knocks import _calm, first_state, unpushed, without_knocks
from upright.certification.certificate import Certificate, _made, certify
from upright.certification.checks import PushTrial, TrialSetup, followed_runs, kernel_controller
from upright.certification.mass import on_the_scale
from upright.certification.pushes import standard_pushes
from upright.certification.recovery import _rest
from upright.certification.verdict import AMBER, LARGER, RED, Examined, LinearMargins, judge
from upright.control import Controller, make_controller
from upright.control.delay import sampled
from upright.errors import InvalidLog, InvalidRobot, InvalidScenario
from upright.experiment import Drive, Impulse, Slope, run
from upright.kernel.batch import parameters_of
from upright.likelihood.actual import as_logged, doubted
from upright.likelihood.agreement import Agreement, agreement
from upright.likelihood.assumptions import Assumptions, Logged, as_sent, batteries, loaded
from upright.likelihood.calibrated import Learnt, _weighed, calibrated, guessed, learnt, weighed
from upright.likelihood.support import LOAD_KNOWN, Support, slope, supported
from upright.physics.dynamics import CALM, Disturbance
from upright.physics.linear import linearise_rolling
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
GYRO = "sensor/gyro"
KNOWN = Uncertainty.of(ROBOT).scaled(0.2)
DRIVEN = [Drive(speed=0.1, start=2.0), Drive(speed=-0.2, start=4.0), Drive(speed=0.1, start=7.0)]
KNOCKS = [Impulse(impulse=0.04, start=s, duration=0.02) for s in (1.5, 5.5)]


class Altered:
    """A body whose right motor is stronger than its left by `unequal` [1], and whose gyro counts `scale` times."""

    def __init__(self, unequal: float = 0.0, scale: float = 1.0) -> None:
        self.inner = NonlinearBody(ROBOT)
        self.spec, self.gains = self.inner.spec, (1 - unequal / 2, 1 + unequal / 2)
        self.counts = np.array([scale if s.name == GYRO else 1.0 for s in self.spec.channels])

    def reset(self, start: Sequence[float] = (0.0,) * 6, seed: int = 0) -> Sample:
        return self._read(self.inner.reset(start, seed))

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        left, right = (g * u for g, u in zip(self.gains, command, strict=True))
        return self._read(self.inner.step((left, right), disturbance))

    def close(self) -> None:
        self.inner.close()

    def _read(self, sample: Sample) -> Sample:
        return sample._replace(numbers=tuple(sample.values * self.counts))


@cache
def designed() -> Controller:
    return make_controller("lqg", ROBOT, KIT, KIT.period)


def kit_with(**changes: Any) -> Kit:
    return dataclasses.replace(KIT, **changes)


def logged(body: Any = None, kit: Kit = KIT, pushes: Sequence[Any] = ()) -> Log:
    """What a real robot would have logged under a controller that holds it."""
    log = run(Electronics(body or NonlinearBody(ROBOT), kit), designed(), [*KNOCKS, *pushes], reference=DRIVEN,
              seconds=9.0, seed=5)  # fmt: skip
    assert not log.origin["outcome"]["fell"]
    names = [n for n in log.channels if n.startswith(("sensor/", "command/"))]
    return Log(log.t, {n: log[n] for n in names})


@cache
def plain_log() -> Log:
    return logged()


PLANTED: dict[str, tuple[str, float, float, dict[str, Any]]] = {
    "battery": ("battery", 4.2, 0.1, {"kit": kit_with(battery=dataclasses.replace(KIT.battery, voltage=4.2))}),
    # the likeliest scale is up to 12 % off: the filter does not know the size of the pushes
    "gyro's scale": ("gyro's scale", 1.5, 0.2, {"body": Altered(scale=1.5)}),
    "asymmetry": ("difference of the motors", 0.4, 0.08, {"body": Altered(unequal=0.4)}),
    # 0.1 V more or less swallows commands that moved the robot, or passes others
    "dead zone": ("dead zone", 2.7, 0.1, {"kit": kit_with(motor=dataclasses.replace(KIT.motor, dead_zone=2.7))}),
    "delay": ("further delay", 0.02, 0.006, {"kit": kit_with(delay=KIT.delay + 0.02)}),
    "gyro's noise": (
        "gyro's noise", 0.08, 0.03,
        {"kit": kit_with(sensors=KIT.sensors | {GYRO: dataclasses.replace(KIT.sensors[GYRO], noise=0.08)})},
    ),
}  # fmt: skip


def within(s: Support) -> bool:
    return s.least <= s.value <= s.most


@cache
def trial_setup() -> TrialSetup:
    return TrialSetup(ROBOT, draw(ROBOT, 100, 3, KNOWN), KIT, controller=kernel_controller(designed(), ROBOT, KIT))


def found(log: Log) -> dict[str, Support]:
    return {s.name: s for s in supported(log, trial_setup())}


def certified(log: Log) -> Certificate:
    return certify(designed(), ROBOT, KIT, samples=100, posterior=KNOWN, sweeps=False, log=log)


# of the battery and the asymmetry whole certificates are judged below
@pytest.mark.parametrize(
    "planted",
    [
        "gyro's scale",
        pytest.param("delay", marks=pytest.mark.evidence),
        pytest.param("dead zone", marks=pytest.mark.evidence),
        pytest.param("gyro's noise", marks=pytest.mark.evidence),
    ],
)
def test_what_was_planted_is_taken_over_with_its_size(planted: str) -> None:
    log, (met, left, taken) = taken_over(planted)
    explained(planted, taken, left, agreement(log, met, followed_runs(met), KIT.period))


@cache
def taken_over(planted: str) -> tuple[Log, Any]:
    """A log, and what a certificate makes of it."""
    log = logged(**PLANTED[planted][3])
    return log, as_logged(log, trial_setup())


def explained(planted: str, taken: Sequence[Support], left: Sequence[Support], compared: Sequence[Agreement]) -> None:
    """The number is taken over with its size, and what is then assumed explains the log."""
    name, value, near, _ = PLANTED[planted]
    sizes = {s.name: s for s in taken}
    assert not within(sizes[name]), str(sizes[name])
    assert sizes[name].value == pytest.approx(value, abs=near)
    assert not [str(s) for s in left if s.outside]
    surprises = [a.ratio for a in compared]
    assert max(surprises) < LARGER, surprises


@pytest.mark.evidence
def test_a_floor_s_slope_is_that_of_a_calibration_and_tried() -> None:
    """4°, to the degree within which a floor counts as level. The filter's steady push said -8° of an EV3way on a level
    floor; without a calibration the log does not tell."""
    log = logged(pushes=[Slope(angle=math.radians(4.0))])
    assert "slope" not in found(log)
    floor = slope(guessed(log, trial_setup()))
    assert math.degrees(floor[0]) == pytest.approx(4.0, abs=1.0)
    met, left, taken = as_logged(log, dataclasses.replace(trial_setup(), floor=floor))
    assert [s.name for s in taken] == ["slope"]
    assert met.logged is not None
    assert met.logged.slopes == (floor[0],)
    assert not [str(s) for s in left if s.outside]


def test_a_swing_of_the_frame_is_not_the_gyro_s_noise() -> None:
    """.3 rad/s of a band below half of Nyquist, as a frame swings; white noise of .08 is known (`PLANTED`)."""
    log, rng = plain_log(), np.random.default_rng(4)
    phases = rng.uniform(0, 2 * math.pi, 40)
    swing = sum(np.sin(2 * math.pi * f * log.t + p) for f, p in zip(np.linspace(15, 25, 40), phases, strict=True))
    swung = Log(log.t, {**log.channels, GYRO: log[GYRO] + 0.3 * swing / np.std(swing)}, log.units, log.origin)
    met, left, taken = as_logged(swung, trial_setup())
    assert "gyro's noise" not in [s.name for s in taken]
    assert any(s.left_open and s.low == 0 for s in left if s.name == "gyro's noise")
    assert met.logged is not None
    drawn = met.logged.changes["sensors.gyro.noise"]  # no robot that is pushed has the swing for noise
    assert drawn == pytest.approx(KIT.sensors[GYRO].noise)


def test_a_log_of_the_robot_as_it_was_assumed_contradicts_nothing() -> None:
    shown = found(plain_log())
    assert not [str(s) for s in shown.values() if s.outside]
    assert shown["battery"].value == pytest.approx(8.0, abs=0.05)


@pytest.mark.evidence
def test_a_body_half_as_heavy_is_seen() -> None:
    _, _, taken = as_logged(logged(body=NonlinearBody(loaded(ROBOT, 0.5))), trial_setup())
    assert [s.name for s in taken] == ["body's mass"]
    assert taken[0].value < 0.75 * ROBOT.body_mass


def test_a_calibration_names_knocks_and_leaves_them_out_where_asked() -> None:
    log = plain_log()
    (whole,), (note,) = without_knocks([log], ROBOT, KIT, cut=False)
    assert whole is log
    # the first reading after it has left: a period, and another of dead time
    assert list(note.times) == pytest.approx([knock.start for knock in KNOCKS], abs=0.03)
    assert "--between-knocks" in str(note.remark)
    parts, (cut,) = without_knocks([log], ROBOT, KIT, cut=True)
    assert [len(part) for part in parts] == [len(part) for part in unpushed(log, ROBOT, KIT)]
    assert cut.used == pytest.approx(sum(map(len, parts)) * log.period)
    assert "is left out" in str(cut.remark)
    near = log.between(0.0, KNOCKS[0].start + 1.9)  # without 2 s in a row that are calm
    (same,), (why,) = without_knocks([near], ROBOT, KIT, cut=True)
    assert same is near
    assert "too little lies between" in str(why.remark)
    quiet = log.between(KNOCKS[-1].start + 1.0, log.t[-1])
    assert without_knocks([quiet], ROBOT, KIT, cut=True) == ([quiet], [])


@pytest.mark.parametrize("row", [200, 405])
def test_a_lost_row_is_no_knock(row: int) -> None:
    """The command of that row is unknown: 2.00 and 4.05 s are moments at which the reference sets the robot off."""
    log = plain_log()
    kept = np.delete(np.arange(len(log)), row)
    lossy = Log(log.t[kept], {name: values[kept] for name, values in log.channels.items()}, log.units, log.origin)
    (of_lossy,), (of_whole,) = (without_knocks([one], ROBOT, KIT, cut=False)[1] for one in (lossy, log))
    assert of_lossy.times == of_whole.times


def test_a_part_between_knocks_in_which_the_wheels_stand_is_left_out() -> None:
    """It tells of no motion: a robot that stuck by dry friction until it was knocked was refused as unlike its file."""
    t = np.arange(0.0, 8.0, 0.01)
    wheel = np.where(t < 2.5, 1e-3 * np.sin(3 * t), np.sin(3 * t))
    log = Log(t, {"sensor/encoder_left": wheel, "sensor/encoder_right": wheel, GYRO: np.cos(3 * t)})
    knock = (t > 2.5) & (t < 2.8)
    assert [part.t[0] for part in _calm(log, knock)] == [pytest.approx(2.8)]


def test_a_gyro_s_scale_is_corrected_once_before_a_calibration(monkeypatch: pytest.MonkeyPatch) -> None:
    """Either the readings or the kit, not both: a gyro that counts 1.5 times was calibrated as one of 1.5²."""
    given: list[Any] = []
    monkeypatch.setattr(
        import_module("upright.likelihood.calibrated"),
        "calibrate",
        lambda *args, **_: given.append(args) or SimpleNamespace(refused=("enough",)),
    )
    log, made = taken_over("gyro's scale")
    monkeypatch.setattr(import_module("upright.likelihood.calibrated"), "as_logged", lambda *_: made)
    with pytest.raises(InvalidLog):
        calibrated(log, trial_setup())
    parts, _, kit = given[0]
    assert kit.sensors[GYRO].gain == pytest.approx(1.5, abs=0.2)  # as planted, see there
    for part in parts:
        assert np.array_equal(part[GYRO], log[GYRO][np.searchsorted(log.t, part.t)])


def test_a_knocked_robot_is_calibrated_from_what_lies_between_the_knocks() -> None:
    parts = unpushed(plain_log(), ROBOT, KIT)
    gone = [(a.t[-1], b.t[0]) for a, b in pairwise(parts)]
    assert len(gone) == 1  # before the first knock, at 1.5 s, there is too little
    assert gone[0][0] == pytest.approx(KNOCKS[1].start, abs=0.03)  # a period, and another of dead time
    assert 0.3 < gone[0][1] - gone[0][0] < 0.7  # the 0.3 s in which a filter finds the state again, after the last


def test_what_robots_within_their_spreads_explain_is_taken_for_no_other_mass() -> None:
    # this robot's log is likeliest with two thirds of its mass, and as likely with another robot of the same spreads
    robot = Robot.preset("nxtway-gs-measured")
    known, design = Uncertainty.of(robot).scaled(0.2), make_controller("hinf", robot, KIT, KIT.period)
    truth = Electronics(NonlinearBody(draw(robot, 1, 1, known)[0]), KIT)
    log = run(truth, design, KNOCKS, reference=DRIVEN, seconds=9.0, seed=5)
    assumed = Assumptions(robot, draw(robot, 100, 3, known), KIT)
    assert not as_logged(log, assumed)[2]


def test_a_jittering_clock_is_reported() -> None:
    log = plain_log()
    rng = np.random.default_rng(1)
    t = np.maximum.accumulate(log.t + rng.uniform(-0.002, 0.002, len(log))) + 1e-6 * np.arange(len(log))
    assert found(Log(t, dict(log.channels)))["jitter"].outside


def test_a_certificate_on_a_weak_battery_tries_it_with_the_pushes_that_were_expected() -> None:
    given = certified(logged(**PLANTED["battery"][3]))
    explained("battery", given.taken, given.support, given.agreement)
    weak = [t for t in given.trials if t.battery == "4.2 V"]
    low = [t for t in given.trials if t.battery == "low"]
    assert [t.size for t in weak] == [t.size for t in low]  # no push is made softer for it
    assert given.light == RED  # 0.85 of 8 V barely: of the pushes sized for 6.8 V a motor at 4.2 V cannot take all
    said = [str(reason).replace("\u00a0", " ") for reason in given.reasons]
    assert "Tried as the log shows it: the battery is 4.2 V, assumed 6.8 to 8.96 V." in said
    assert Certificate.from_json(json.loads(json.dumps(given.to_json()))) == given


def test_motors_that_differ_are_certified_as_the_log_shows_them() -> None:
    given = certified(logged(**PLANTED["asymmetry"][3]))
    explained("asymmetry", given.taken, given.support, given.agreement)
    assert given.light == AMBER  # 0.4 for at most 0.1 is a fault to mend, though every robot with it holds
    assert given.fell == 0
    assert given.reasons[0].message.facts["number"].facts["name"] == given.taken[0].named
    assert given.check() == ()


def with_channels(log: Log, prefixes: tuple[str, ...]) -> Log:
    names = [n for n in log.channels if n.startswith(prefixes)]
    return Log(log.t, {n: log[n] for n in names})


def test_what_was_sent_is_examined_where_the_log_also_tells_what_the_motors_got() -> None:
    """Of commands that arrive late those at the motors say nothing: the log of `upright simulate` has both."""
    log = run(Electronics(NonlinearBody(ROBOT), KIT), designed(), seconds=0.1)
    assert {"command/left", "applied/left"} <= set(log.channels)
    assert "command/left" in as_sent(log)
    assert "applied/left" not in as_sent(log)
    only = with_channels(log, ("sensor/", "applied/"))
    assert as_sent(only) is only


@pytest.mark.evidence
def test_readings_that_come_late_show_beside_what_the_motors_got() -> None:
    sensors = {n: dataclasses.replace(s, delay=s.delay + 0.02) for n, s in KIT.sensors.items()}
    log = run(Electronics(NonlinearBody(ROBOT), kit_with(sensors=sensors)), designed(), KNOCKS, reference=DRIVEN,
              seconds=9.0, seed=5)  # fmt: skip
    _, _, taken = as_logged(with_channels(log, ("sensor/", "applied/")), trial_setup())
    found = next(s.value for s in taken if s.name == "further delay")
    assert found == pytest.approx(0.02, abs=0.00125)


@pytest.mark.evidence
def test_half_the_mass_is_taken_over_or_doubted_where_the_file_knows_the_robot_badly() -> None:
    """Robots within the file's spreads may explain the log as well; then it is calibrated both ways."""
    log = logged(NonlinearBody(loaded(ROBOT, 0.4)))
    wide = dataclasses.replace(trial_setup(), robots=draw(ROBOT, 100, 0))
    met, _, taken = as_logged(log, wide)
    doubt = doubted(log, met, {s.name for s in taken})
    numbers = {s.name: s.value for s in (*taken, *([doubt[1]] if doubt else []))}
    assert numbers["body's mass"] == pytest.approx(0.24, rel=0.5)  # the likeliest is 1.0 to 1.5 times a lighter body's


def test_a_body_as_heavy_as_the_log_shows_keeps_its_source_and_is_known_as_well_as_that() -> None:
    """Without a source it would be a guess, within a factor of two, and a short log moves a guess far."""
    light = dataclasses.replace(trial_setup(), logged=dataclasses.replace(Logged.alone(KIT), load=0.5))
    known = _weighed(light)
    assert known.body_mass == pytest.approx(0.5 * ROBOT.body_mass)
    assert known.provenance["body_mass"].spread == pytest.approx(LOAD_KNOWN * known.body_mass)
    assert known.provenance["wheel_mass"] == ROBOT.provenance["wheel_mass"]


def estimate(name: str, value: float, prior: float, spread: float, shift: float, **more: Any) -> Estimate:
    return Estimate(name=name, unit="m", value=value, low=0.9 * value, high=1.1 * value, prior=prior,
                    prior_spread=spread, verdict="visible", shift=shift, shrink=0.2, **more)  # fmt: skip


def test_a_number_that_the_file_states_and_the_log_contradicts_makes_the_light_amber() -> None:
    """Whatever else makes the calibration's innovations white: a body of a quarter of its mass was green with a wheel's
    radius moved by 4.6 deviations in its place. 23 mm for 21 ± 0.5 mm are 3.8 deviations of its logarithm."""
    radius = estimate("wheel_radius", 0.023, 0.021, 0.0005, math.log(23 / 21) * 21 / 0.5, scale="logarithm")
    within = estimate("track", 0.162, 0.16, 0.001, 2.0)
    guessed = estimate("com_height", 0.3, 0.1, 0.03, 6.0, guess=True)  # a guess is not stated
    calibration: Any = MagicMock(
        names=("wheel_radius",), covariance=np.array([[1e-8]]), robot=ROBOT, delays=(),
        parameters=(radius, within, guessed),
    )  # fmt: skip
    calibration.__getitem__.return_value = estimate("constant_command", 0.0, 0.0, 0.1, 0.0, guess=True)
    (found,) = learnt(calibration, KIT).contradicted
    assert _made(Support, json.loads(json.dumps(dataclasses.asdict(found)))) == found
    trial = PushTrial("hold", "low", 1000, 0, saturated=0.0, travel=0.2, peak=0.1, cycle=0.01)
    light, reasons = judge(Examined(1000, 0, LinearMargins(0.99, 0.5, 2.0, 0.02), [trial], 0.01, support=[found]))
    assert light == AMBER
    said = str(reasons[0]).replace("\u00a0", " ")
    assert said == "The log contradicts what was assumed: wheel radius is 2.3 cm, in the file 2.1 cm ± 0.05 cm."


def test_a_stated_number_is_contradicted_from_three_deviations_on() -> None:
    """On either scale on which a calibration moves it: three of 10 % are 30 %, or a factor of exp 0.3."""
    for shift, outside in ((2.9, False), (3.1, True), (-3.1, True)):
        for scale, value in (("linear", 1 + 0.1 * shift), ("logarithm", math.exp(0.1 * shift))):
            assert Support.of_estimate(estimate("track", value, 1.0, 0.1, shift, scale=scale)).outside is outside


@pytest.mark.evidence
def test_a_calibration_that_takes_the_mass_for_a_guess_sees_a_lighter_body() -> None:
    """Its interval holds the true mass."""
    log = with_channels(logged(NonlinearBody(loaded(ROBOT, 0.6))), ("sensor/enc", GYRO, "command/"))
    wide = dataclasses.replace(trial_setup(), robots=draw(ROBOT, 100, 0))
    (mass,) = weighed(guessed(log, wide), wide)
    assert mass.low < 0.6 * ROBOT.body_mass < mass.high < ROBOT.body_mass


def test_neither_mass_nor_strength_is_asked_of_a_linear_filter_where_the_file_states_dry_friction() -> None:
    """Of TWIPRs that differ in none it said 1.5 to 3 times the mass, and motors of half their strength."""
    rubs = dataclasses.replace(trial_setup(), dry_friction=True)
    assert {s.name for s in supported(plain_log(), trial_setup())} - {s.name for s in supported(plain_log(), rubs)} == {
        "body's mass", "motors' strength"
    }  # fmt: skip


LIGHTER = Support("body's mass", "kg", 0.2, 0.16, 0.24, 0.42, 0.78)  # kg, of a filter: to 20 %


@pytest.mark.parametrize(
    ("seen", "others", "temper", "doubted"),
    [
        (True, 0, 0.9, set()),
        (False, 0, 0.9, {"body's mass"}),
        (False, 0, 0.2, {"body's mass", "share of readings that count"}),
        (False, 1, 0.9, set()),  # the mass was the image of a delay
        (False, 1, 0.2, {"body's mass"}),
    ],
)
def test_a_mass_is_that_of_a_calibration_or_counts_as_contradicted(
    monkeypatch: pytest.MonkeyPatch, temper: float, others: int, doubted: set[str], *, seen: bool
) -> None:
    """An ev3way of 0.63 kg that differed in none passed for one of 0.093 kg. Innovations of which one reading in five
    counts are explained by nothing."""
    module, asked = import_module("upright.likelihood.calibrated"), list[Assumptions]()
    setup = dataclasses.replace(trial_setup(), logged=dataclasses.replace(Logged.alone(KIT), load=1 / 3))
    own = SimpleNamespace(refused=(), temper=temper)
    found = dataclasses.replace(LIGHTER, value=0.25, low=0.2, high=0.3)
    late = (Support("further delay", "s", 0.02, 0.019, 0.021, -0.02, 0.005),) * others
    later = iter([(setup, (), (LIGHTER,)), (trial_setup(), (), late)])
    monkeypatch.setattr(module, "as_logged", lambda _, given: asked.append(given) or next(later))
    monkeypatch.setattr(module, "_own", lambda *_: own)
    monkeypatch.setattr(module, "doubted", lambda *_: None)
    monkeypatch.setattr(module, "guessed", lambda *_: own)
    monkeypatch.setattr(module, "weighed", lambda _, met: [found] if seen and met.actual_robot is ROBOT else [])
    monkeypatch.setattr(module, "learnt", lambda _, kit, others=(): Learnt(ROBOT, kit, Uncertainty(), others))
    left = dataclasses.replace(LIGHTER, left_open=True)
    monkeypatch.setattr(module, "_open", lambda *_: left)
    result, taken = calibrated(plain_log(), setup)
    assert taken == ((found,) if seen else late)
    assert result.contradicted == (() if seen else (left,))
    assert [given.is_weighed for given in asked] == ([False] if seen else [False, True])


@pytest.mark.parametrize(
    ("interval", "sees", "others", "ends"),
    [
        ((0.5, 0.7), (), (), None),  # kg, of 0.42 to 0.78 that are assumed
        ((0.31, 0.89), (), (), (0.31, 0.89)),  # a robot of 0.26 kg that contradicted nothing, and fell
        ((0.5, 0.7), (LIGHTER,), (), (0.16, 0.7)),
        ((0.31, 0.89), (), (LIGHTER,), None),
    ],
)
def test_a_mass_is_open_where_what_is_left_of_it_reaches_beyond_what_is_assumed(
    monkeypatch: pytest.MonkeyPatch, interval: tuple[float, float], sees: tuple[Support, ...],
    others: tuple[Support, ...], ends: tuple[float, float] | None,
) -> None:  # fmt: skip
    """A calibration that contradicts another number of the file as well explains nothing."""
    module = import_module("upright.likelihood.calibrated")
    monkeypatch.setattr(module, "learnt", lambda *_: Learnt(ROBOT, KIT, Uncertainty(), others))
    low, high = interval
    asked = MagicMock(refused=())
    asked.__getitem__.return_value = SimpleNamespace(value=0.6, low=low, high=high)
    left = module._open(asked, trial_setup(), sees)
    assert (left and (left.low, left.high, left.outside)) == (ends and (*ends, True))


def test_no_motion_shows_how_heavy_all_of_a_robot_is() -> None:
    """M q̈ = f is the same equation where every mass, inertia and torque is multiplied by one factor: what a log shows
    of a mass, it shows beside the motors and rotors of the file. So only a scale tells it."""
    names = [n for n in ROBOT.numbers() if n.endswith(("_mass", "_inertia", "_friction", "torque_constant"))]
    heavy = ROBOT.replace(**{n: 2.0 * getattr(ROBOT, n) for n in names})
    one, other = linearise_rolling(ROBOT), linearise_rolling(heavy)
    np.testing.assert_allclose(other.A, one.A, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(other.B, one.B, rtol=1e-9, atol=1e-12)
    push = one.E[:, :2]  # of a force in N and a torque in N m
    np.testing.assert_allclose(other.E[:, :2], push / 2, rtol=1e-9, atol=1e-12)  # moves the heavier one half as much


def test_a_robot_on_a_scale_has_the_mass_of_the_scale_in_its_own_shape() -> None:
    """Half of the body is gone, and half of its inertia, give or take a half of that."""
    wheels = 2 * ROBOT.wheel_mass
    light = on_the_scale(ROBOT, 0.5 * ROBOT.body_mass + wheels, logged=True)
    assert light.body_mass == pytest.approx(0.5 * ROBOT.body_mass)
    assert light.pitch_inertia == pytest.approx(0.5 * ROBOT.pitch_inertia)
    assert light.com_height == ROBOT.com_height
    spread = light.provenance["body_mass"].spread
    assert spread is not None
    assert spread < 0.02 * ROBOT.body_mass  # 1 % of all, and what is not known of the wheels
    spread = light.provenance["pitch_inertia"].spread
    assert spread is not None
    assert spread >= 0.25 * ROBOT.pitch_inertia
    same = on_the_scale(ROBOT, ROBOT.body_mass + wheels, logged=False)
    assert same.numbers() == pytest.approx(ROBOT.numbers())


@pytest.mark.parametrize(
    ("weighed", "logged"), [(0.01, True), (0.3, False), (math.nan, True), (-1.0, True), (660.0, True)]
)
def test_a_weight_that_is_none_of_this_robot_is_refused(weighed: float, *, logged: bool) -> None:
    """Less than its wheels, or grams; and half of its mass without a log, which would show where the other half was."""
    with pytest.raises(InvalidRobot, match=r"kg"):
        on_the_scale(ROBOT, weighed, logged=logged)


def test_a_weight_goes_with_the_robot_of_a_file_alone() -> None:
    with pytest.raises(InvalidScenario, match="posterior"):
        certify(designed(), ROBOT, KIT, samples=100, posterior=KNOWN, weighed=0.66)


def test_no_log_is_asked_the_mass_of_a_robot_that_was_weighed(monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither the filter nor a calibration that takes it for a guess."""
    module, asked = import_module("upright.likelihood.calibrated"), list[Assumptions]()
    setup = dataclasses.replace(trial_setup(), is_weighed=True)
    monkeypatch.setattr(module, "as_logged", lambda _, given: asked.append(given) or (given, (), ()))
    monkeypatch.setattr(module, "_own", lambda *_: SimpleNamespace(refused=(), temper=0.9))
    monkeypatch.setattr(module, "guessed", lambda *_: pytest.fail("a calibration asked the mass"))
    monkeypatch.setattr(module, "learnt", lambda _, kit, others=(): Learnt(ROBOT, kit, Uncertainty(), others))
    result, taken = calibrated(plain_log(), setup)
    assert [given.is_weighed for given in asked] == [True]
    assert (result.contradicted, taken) == ((), ())


def test_a_weighed_robot_is_pushed_like_that_of_its_file_whatever_a_calibration_makes_of_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A body of half the mass would be pushed half as much; and with slower sensors less can be survived. And its
    certificate holds the weight, of the robot with its wheels."""
    module, asked = import_module("upright.likelihood.calibrated"), list[Assumptions]()
    light, slow = loaded(ROBOT, 0.5), {n: dataclasses.replace(s, delay=s.delay + 0.02) for n, s in KIT.sensors.items()}
    own = Learnt(light, kit_with(sensors=slow), Uncertainty.of(light).scaled(0.1))
    monkeypatch.setattr(module, "calibrated", lambda _, given, __: asked.append(given) or (own, ()))
    weight = 0.8 * ROBOT.body_mass + 2 * ROBOT.wheel_mass
    given = certify(designed(), ROBOT, KIT, samples=100, sweeps=False, log=plain_log(), weighed=weight)
    (setup,) = asked
    assert setup.is_weighed
    assert setup.robot.body_mass == pytest.approx(0.8 * ROBOT.body_mass)
    sizes = {p.size for volts in batteries(ROBOT, KIT) or () for p in standard_pushes(ROBOT, KIT, volts).values()}
    assert {t.size for t in given.trials} == sizes
    assert Certificate.from_json(json.loads(json.dumps(given.to_json()))).weighed == weight
    assert given.page().origin["weighed"]


def test_a_robot_stands_on_the_slope_that_its_motors_bore() -> None:
    """Whatever the parameters, the command at rest is the one of the log, by statics."""
    robots, slope = draw(ROBOT, 20, 1), math.radians(4.0)
    shown = dataclasses.replace(Logged.alone(KIT), slopes=(slope,))
    angles = shown.angles(slope, parameters_of(robots), ROBOT)
    rest = [float(_rest(robot, 0.0, angle)[1]) for robot, angle in zip(robots, angles, strict=True)]
    assert np.ptp(angles) > 0.2 * slope  # spreads of 10 % in the motors' constants
    assert rest == pytest.approx([float(_rest(ROBOT, 0.0, slope)[1])] * 20, rel=1e-9)
    assert (shown.angles(0.0, parameters_of(robots), ROBOT) == 0).all()  # an expected slope is the same for all


def test_a_sensor_that_is_ten_periods_behind_has_a_first_state() -> None:
    """Its readings on their way are numbered by two digits: each of them is the first reading."""
    behind = dataclasses.replace(KIT.sensors["sensor/gyro"], delay=11.5 * KIT.period)
    model = sampled(ROBOT, dataclasses.replace(KIT, sensors={**KIT.sensors, "sensor/gyro": behind}))
    state = first_state(model, np.array([0.1, 0.1, 0.3]))
    waiting = [name for name in model.linear.states if name.startswith("sensor/gyro@")]
    assert "sensor/gyro@10" in waiting
    assert [state[model.linear.states.index(name)] for name in waiting] == [0.3] * len(waiting)
