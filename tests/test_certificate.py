"""The certificate: what it proves, when it refuses, and that it is right about robots it has never seen."""

from __future__ import annotations

import dataclasses
import json
import math
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.certification.certificate import Certificate, certify, read_certificate
from upright.certification.checks import PushTrial, TrialSetup, kernel_controller, trials
from upright.certification.pushes import RELEASE, standard_pushes
from upright.certification.recovery import means, recoverable
from upright.certification.verdict import AMBER, GREEN, RED, UNKNOWN, Examined, LinearMargins, judge, linear_margins
from upright.cli.main import main
from upright.control import LinearController, as_linear, controller_hash, make_controller, write_controller
from upright.errors import InvalidController, InvalidScenario, SpecMismatch
from upright.experiment import run
from upright.fleets.binomial import upper_bound
from upright.kernel.batch import parameters_of
from upright.languages import speaking
from upright.likelihood.support import Support
from upright.loops.analysis import analyse
from upright.loops.loop import robot_loop
from upright.pages import html
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty, deviations

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
CALIBRATED = Uncertainty.of(ROBOT).scaled(0.2)


@cache
def designed(name: str) -> LinearController:
    return as_linear(make_controller(name, ROBOT, KIT, KIT.period))


def scaled(controller: LinearController, factor: float) -> LinearController:
    changes = {name: factor * getattr(controller, name) for name in ("C", "Dy", "Dr")}
    return dataclasses.replace(controller, **changes)


@cache
def green() -> Certificate:
    return certify(designed("pid"), ROBOT, KIT, samples=200, posterior=CALIBRATED)


RADIANS = re.compile(r"\d rad\b(?!/)")


@pytest.mark.parametrize("cycle", [0.01, 0.2])
def test_who_reads_a_certificate_reads_degrees_wherever_it_is_shown(cycle: float) -> None:
    """Reasons, table and page: an angle in rad on one line and in degrees on the next is read as another."""
    shaky = tuple(dataclasses.replace(t, cycle=cycle) for t in green().trials)
    examined = {f.name: getattr(green(), f.name) for f in dataclasses.fields(Examined)} | {"trials": shaky}
    light, reasons = judge(Examined(**examined))
    certificate = dataclasses.replace(green(), trials=shaky, light=light)
    assert any("sways" in str(reason) for reason in reasons) == (cycle > 0.1)
    page = html.document(certificate.page())
    assert f">{math.degrees(cycle):.2g}<" in page
    for shown in (str(certificate), page, certificate.refuses()):
        assert not RADIANS.search(shown), RADIANS.search(shown)


def test_bound_is_clopper_and_pearsons() -> None:
    # Without a fall the bound is 1 − 0.05^(1/n) in closed form; "rule of three": about 3/n
    assert math.isclose(upper_bound(0, 1000), 1 - 0.05 ** (1 / 1000), rel_tol=1e-9)
    assert upper_bound(7, 7) == 1.0


def test_bound_has_the_coverage_it_claims() -> None:
    # P(no more than k falls | p = bound) is 5 %, summed term by term
    for fell, samples in ((1, 100), (12, 1000), (300, 400)):
        p = upper_bound(fell, samples)
        terms = (math.comb(samples, i) * p**i * (1 - p) ** (samples - i) for i in range(fell + 1))
        assert math.isclose(math.fsum(terms), 0.05, rel_tol=1e-6)


def test_a_good_controller_of_a_known_robot_is_green() -> None:
    # pid holds every draw of the full spreads (see docs/certificate.md), and these are five times narrower
    assert green().light == GREEN
    assert green().refuses(designed("pid")) == ""


def test_an_unstable_loop_is_red() -> None:
    certificate = certify(scaled(designed("pid"), -1.0), ROBOT, KIT, samples=100, sweeps=False)
    assert certificate.light == RED
    assert certificate.fell == 100  # positive feedback of an unstable body holds nobody
    assert certificate.bound == 1.0
    assert certificate.refuses().startswith("red: The nominal loop is unstable")
    assert certificate.standing.fell_at is not None
    assert [reason.kind for reason in certificate.reasons] == ["loop", "alone"]


def test_an_unstable_loop_whose_robots_still_stand_is_red() -> None:
    # the rule by itself, since dead zones and limits can hold a loop upright that linear theory calls unstable
    light, reasons = judge(Examined(1000, 0, LinearMargins(1.01, 1.0, 1.0, 0.0), [_trial()], 0.01))
    assert light == RED
    assert "= 1.01)" in str(reasons[0])
    assert "doubles every 0.7\u00a0s" in str(reasons[0])  # 0.01 s log 2 / log 1.01
    # first of all reasons, whatever the motors could do: a push that is too hard is no answer to it
    trial = dataclasses.replace(_trial(fell=1000), beyond=900)
    _, reasons = judge(Examined(1000, 1000, LinearMargins(1.01, 1.0, 1.0, 0.0), [trial], 0.01, beyond=900))
    assert reasons[0].kind == "loop"


def test_a_robot_that_an_unstable_loop_does_not_fell_stands_in_a_limit_cycle() -> None:
    """Friction and the motors' limit stop what linear theory says grows for ever; the page says so, and how far."""
    certificate = certify(scaled(designed("pid"), 2.5), ROBOT, KIT, samples=100, sweeps=False)
    assert certificate.light == RED
    assert certificate.reasons[0].kind == "loop"
    # a lean of a degree that doubles so often in 20 s is beyond every lean
    assert math.radians(1.0) * certificate.linear.radius ** (20.0 / certificate.period) > 1e6
    assert certificate.standing.fell_at is None
    sway = math.degrees(max(trial.cycle for trial in certificate.trials))
    answers = str(certificate)
    assert f"in a limit cycle of ±{sway:.2g}°" in " ".join(answers.split())
    # at this growth a degree is no fall after 20 s, and nothing is said of a cycle
    slow = dataclasses.replace(certificate, linear=LinearMargins(1.0005, 1.0, 1.0, 0.0))
    assert math.radians(1.0) * 1.0005 ** (20.0 / slow.period) < 0.8
    assert "limit cycle" not in str(slow)


def gyro_alone(kp: float, ki: float, kd: float) -> LinearController:
    """A PID on the sum of the gyro's readings, as of a robot without encoders."""
    dt, one = KIT.period, np.ones((2, 1))
    A, By = np.array([[1.0, 0.0], [dt, 1.0]]), np.array([[dt], [0.0]])
    C, Dy = one @ np.array([[kp, ki]]), one * (kp * dt + kd)
    none, unused = np.zeros((2, 6)), np.zeros((2, 2))
    return LinearController(A, By, none, unused, C, Dy, none, reads=("sensor/gyro",), period=dt)


def test_a_free_place_is_no_instability() -> None:
    """No command depends on how far the wheels have turned: poles at z = 1 for ever, and where all others decay the
    robot stands."""
    loop = robot_loop(gyro_alone(20.0, 100.0, 1.0), ROBOT, KIT)
    poles = np.sort(np.abs(loop.closed.poles()))
    assert poles[-4] < 0.9999  # beside position, heading and the sum of the readings
    margins = linear_margins(gyro_alone(20.0, 100.0, 1.0), ROBOT, KIT)
    assert margins is not None
    assert margins.free
    for fell, light, at in ((0, AMBER, 0), (1000, RED, 1)):
        given, reasons = judge(Examined(1000, fell, margins, [_trial(fell=fell)], KIT.period))
        assert given == light
        assert reasons[at].kind == "free"
        assert "loop" not in [reason.kind for reason in reasons]
    weak = linear_margins(gyro_alone(5.0, 10.0, 0.2), ROBOT, KIT)
    assert weak is not None
    assert not weak.free
    assert not weak.stable


def test_a_design_says_of_a_free_place_what_the_certificate_says() -> None:
    for gains, word, kind in (
        ((20.0, 100.0, 1.0), "nothing holds its position", "free"), ((5.0, 10.0, 0.2), "unstable", "loop"),
    ):  # fmt: skip
        controller = gyro_alone(*gains)
        margins = linear_margins(controller, ROBOT, KIT)
        page = analyse(controller, ROBOT, KIT, robots=[]).page()
        _, reasons = judge(Examined(1000, 0, margins, [_trial()], KIT.period))
        assert word in page.title.template.lower()
        assert word in str(reasons[0]).lower()
        assert reasons[0].kind == kind


@pytest.mark.parametrize(
    ("linear", "trial", "word"),
    [
        (LinearMargins(0.99, 0.5, 1.02, 0.02), {}, "higher"),  # 2 % < 4 %
        (LinearMargins(0.99, 0.97, 3.0, 0.02), {}, "lower"),  # 3 % < 4 %
        (LinearMargins(0.99, 0.5, 2.0, 0.002), {}, "delay"),  # a fifth of the period < a quarter
        (LinearMargins(0.99, 0.5, 2.0, 0.02), {"saturated": 0.3}, "saturated"),
        (LinearMargins(0.99, 0.5, 2.0, 0.02), {"travel": 1.5}, "rolls"),
        (LinearMargins(0.99, 0.5, 2.0, 0.02), {"cycle": 0.2}, "sways"),
    ],
)
def test_thin_margins_and_hard_work_are_amber(linear: LinearMargins, trial: dict[str, Any], word: str) -> None:
    light, reasons = judge(Examined(1000, 0, linear, [_trial(**trial)], 0.01))
    assert light == AMBER
    assert word in str(reasons[0])
    assert judge(Examined(1000, 0, LinearMargins(0.99, 0.5, 2.0, 0.02), [_trial()], 0.01))[0] == GREEN


@pytest.mark.parametrize(("fell", "light"), [(38, GREEN), (39, RED)])
def test_falls_decide_by_their_bound(fell: int, light: str) -> None:
    # one-sided 95 % bounds of 1000 by summing the binomial: 38 falls → 4.951 %, 39 → 5.063 %; the limit is 5 %
    assert judge(Examined(1000, fell, LinearMargins(0.99, 0.5, 2.0, 0.02), [_trial(fell=fell)], 0.01))[0] == light


def test_trials_are_the_loop_of_run() -> None:
    # the same robot in the one loop of `experiment.run`: peaks differ by noise alone, below some hundredths of a radian
    driving = kernel_controller(designed("pid"), ROBOT, KIT)
    found, fell, _ = trials(TrialSetup(ROBOT, [ROBOT] * 20, KIT, controller=driving))
    for trial in found[1::2]:  # one battery: a motor is at its limit for a few hundredths of the time, with either
        push = standard_pushes(ROBOT, KIT, 1.12 * KIT.battery.voltage)[trial.push].push
        log = run(Electronics(NonlinearBody(ROBOT), KIT), designed("pid"), push, seconds=RELEASE + 1, seed=3)
        assert abs(np.abs(log["truth/pitch"]).max() - trial.peak) < 0.03
    assert not fell.any()


def test_more_delay_and_other_periods_are_swept() -> None:
    certificate = green()
    assert [s.value for s in certificate.delayed] == pytest.approx([0.002, 0.005, 0.01, 0.015, 0.02])  # of 10 ms
    assert [s.value for s in certificate.slower] == pytest.approx([0.005, 0.008, 0.01, 0.012, 0.015, 0.02])
    assert certificate.slower[-1].fell == certificate.slower[-1].runs  # half the rate: far beyond the margin


def test_margins_are_those_of_the_analysis() -> None:
    both = analyse(designed("pid"), ROBOT, KIT, robots=[]).both()
    linear = green().linear
    assert (linear.gain_low, linear.gain_high, linear.delay) == (both.gain_low, both.gain_high, both.delay)


def test_same_seed_same_certificate() -> None:
    first, second = (certify(designed("pid"), ROBOT, KIT, samples=100, seed=4, sweeps=False) for _ in range(2))
    assert first == second


def test_file_brings_the_certificate_back() -> None:
    assert Certificate.from_json(json.loads(json.dumps(green().to_json()))) == green()
    assert green().check() == ()


def test_a_file_of_before_is_refused_with_what_to_do() -> None:
    # its pushes were the same for every robot, so that its light means something else
    older = {name: value for name, value in green().to_json().items() if name != "beyond"}
    with pytest.raises(InvalidController, match=r"certify/7; expected upright/certify/8; try: .*upright certify"):
        Certificate.from_json(older | {"schema": "upright/certify/7"})
    # the first versions named themselves otherwise
    named = {"file": "upright certificate", "version": 7}
    with pytest.raises(InvalidController, match=r"JSON without a schema; expected upright/certify/8"):
        Certificate.from_json({name: value for name, value in older.items() if name != "schema"} | named)


def test_what_no_controller_could_do_is_no_fault_of_this_one() -> None:
    # of 1000 that fell 100 lie beyond their motors: more than the 5 % that may fall under the best of controllers
    trial = dataclasses.replace(_trial(fell=300), beyond=100)
    light, reasons = judge(Examined(1000, 300, LinearMargins(0.99, 0.5, 2.0, 0.02), [trial], 0.01, beyond=100))
    assert light == RED
    assert str(reasons[0]).startswith("300 of 1000 similar robots fell")  # the 200 others are the controller's
    assert str(reasons[1]).startswith("No controller could: 100 of 1000")
    light, reasons = judge(Examined(1000, 110, LinearMargins(0.99, 0.5, 2.0, 0.02), [trial], 0.01, beyond=100))
    assert light == AMBER  # of 10 others alone it would not be red: weak motors are the robot's, not the controller's
    assert str(reasons[0]).startswith("No controller could: 100 of 1000")
    light, reasons = judge(Examined(1000, 300, LinearMargins(0.99, 0.5, 2.0, 0.02), [trial], 0.01, beyond=50))
    assert light == RED
    assert "weak" not in [reason.kind for reason in reasons]


def test_motors_too_weak_for_the_spreads_are_distinguished(tmp_path: Path) -> None:
    # half of these motors turn a third as fast at a volt: too slow for a push that asks 0.6 of the others
    weak = ROBOT.replace(back_emf=3 * ROBOT.back_emf)
    certificate = certify(designed("pid"), ROBOT, KIT, robots=[ROBOT, weak] * 50, sweeps=False)
    assert certificate.light == RED  # left alone they fall, too: this controller is tuned for the others
    assert str(certificate.reasons[1]).startswith("No controller could: 50 of 100")
    assert certificate.beyond == 50
    stronger = means(ROBOT, KIT, certificate.strength.battery)
    assert all(recoverable(parameters_of([weak]), stronger, p.push)[0] for p in standard_pushes(ROBOT, KIT).values())
    assert read_certificate(certificate.save(tmp_path / "c.json")) == certificate
    assert "too weak for 50 of 100 robots, of which 50 fell" in " ".join(str(certificate).split())


@pytest.mark.parametrize("change", [{"light": RED}, {"bound": 0.5}, {"fell": 199}, {"reasons": ["trust me"]}])
def test_a_changed_certificate_is_found_out(change: dict[str, object]) -> None:
    with pytest.raises(InvalidController):
        Certificate.from_json(green().to_json() | change)
    if "reasons" not in change:
        assert "contradicts itself" in dataclasses.replace(green(), **change).refuses()


def test_it_is_of_one_controller() -> None:
    other = scaled(designed("pid"), 1.001)
    assert green().hash == controller_hash(designed("pid"))
    assert "another" in green().refuses(other)


def test_a_covariance_keeps_what_is_known_together() -> None:
    # Only the product of both motor constants' errors is unknown here: draws move along one line of the plane
    names = ("torque_constant", "back_emf")
    s = np.array([0.2 * deviations(ROBOT)[name] for name in names])
    one = Uncertainty.joint(names, [getattr(ROBOT, name) for name in names], np.outer(s, s))
    certificate = certify(designed("pid"), ROBOT, KIT, samples=200, posterior=one, sweeps=False)
    assert certificate.light == GREEN


def test_who_reads_the_truth_is_certified_for_nothing_real() -> None:
    with pytest.raises(SpecMismatch, match="true state"):
        certify(make_controller("lqr-state", ROBOT, KIT, KIT.period), ROBOT, KIT)


def test_too_few_robots_prove_nothing() -> None:
    with pytest.raises(InvalidScenario, match="100 or more"):
        certify(designed("pid"), ROBOT, KIT, samples=50)


def test_what_a_log_shows_is_what_to_mend_next() -> None:
    """A scale tells a mass that is left open; what was not assumed is mended or measured; green goes to the robot."""
    left = {"support": (Support("body's mass", "kg", 0.5, 0.36, 0.61, 0.42, 0.78, left_open=True),)}
    scale = {"taken": (Support("gyro's scale", "1", 2.04, 1.84, 2.24, 0.8, 1.2),)}
    for shown, verb, weighed in ((left, "certify", True), (scale, "certify", False), ({}, "firmware", False)):
        certificate = dataclasses.replace(green(), light=AMBER if shown else GREEN, **shown)
        (step,) = certificate.page().next
        assert (step.verb, "weighed" in step.options) == (verb, weighed)
        assert step.verb in str(certificate)


def test_encoders_are_added_only_where_a_free_place_is_a_reason() -> None:
    """A red certificate whose second reason is a free place gets them; one of motors that saturate gets weights."""
    margins = linear_margins(gyro_alone(20.0, 100.0, 1.0), ROBOT, KIT)
    assert margins is not None
    assert margins.free
    subject = green().subject | {"kit": {"sensor/gyro": {}}}
    bare = dataclasses.replace(green(), linear=margins, subject=subject, controller="pid")
    fallen = dataclasses.replace(bare, light=RED, fell=150)
    assert [reason.kind for reason in fallen.reasons] == ["spread", "free"]
    hard = tuple(dataclasses.replace(t, saturated=0.3) for t in green().trials)
    limited = dataclasses.replace(bare, light=AMBER, linear=green().linear, trials=hard)
    assert limited.reasons[0].kind == "saturated"
    assert ["kit" in one.page().next[0].options for one in (fallen, limited)] == [True, False]


@pytest.mark.parametrize(
    ("trial", "shown"),
    [
        # the limit, what to change, and what to run
        ({"travel": 1.5}, ("1 m are allowed", "the wheels' angle", "upright tune pid")),
        ({"saturated": 0.3}, ("25 % are allowed", "the command", "upright tune pid")),
    ],
)
def test_amber_says_its_limit_the_weight_to_change_and_the_next_command(
    trial: dict[str, Any], shown: tuple[str, ...]
) -> None:
    hard = tuple(dataclasses.replace(t, **trial) for t in green().trials)
    certificate = dataclasses.replace(green(), trials=hard, light=AMBER, controller="pid")
    assert certificate.check() == ()
    text = " ".join(str(certificate).split())
    assert all(part in text for part in shown)


def test_every_rendering_of_a_certificate_has_its_light_and_its_numbers() -> None:
    """Terminal, page, notebook and JSON; in Spanish the same numbers."""
    certificate = green()
    page = certificate.page()
    values = [value.replace("\u00a0", " ") for value, _ in page.head()["numbers"]]
    assert len(values) == 3
    head = json.dumps(page.head(), ensure_ascii=False)
    for rendered in (str(certificate), html.document(page), certificate._repr_html_(), head):
        assert all(value in rendered.replace("\u00a0", " ") for value in values)
        assert "Green" in rendered
    english = [str(reason) for reason in certificate.reasons]
    with speaking("es"):
        spanish = str(certificate)
        assert certificate.to_json()["reasons"] == english
    assert spanish.startswith("Verde")
    digits = [re.findall(r"\d+", text.partition("upright")[0]) for text in (spanish, str(certificate))]
    assert sorted(digits[0]) == sorted(digits[1])


@pytest.mark.parametrize(
    ("support", "taken", "said"),
    [
        # a gyro that reads twice was green, "tried at 1.84 to 2.01", and the robot fell 4 of 4 times
        (
            (),
            (Support("gyro's scale", "1", 2.04, 1.84, 2.24, 0.8, 1.2),),
            "the gyro's scale is 2.04, assumed 0.8 to 1.2",
        ),
        # a body of .343 kg for .6 was green in 2 of 5 logs: the interval ended above it
        (
            (Support("body's mass", "kg", 0.5, 0.36, 0.61, 0.42, 0.78, left_open=True),),
            (),
            "open, 0.36 to 0.61\u00a0kg",
        ),
    ],
)
def test_what_a_log_shows_or_leaves_open_outside_of_what_was_assumed_is_not_green(
    support: tuple[Support, ...], taken: tuple[Support, ...], said: str
) -> None:
    light, reasons = judge(Examined(1000, 0, None, [_trial()], 0.01, support=support, taken=taken))
    assert light == AMBER
    assert said in str(reasons[0])
    assert "0.66 kg" in html.document(dataclasses.replace(green(), weighed=0.66).page()).replace("\u00a0", " ")


def test_page_and_table_say_the_light() -> None:
    page = html.document(green().page())
    assert green().hash[:12] in page
    assert "may drive" in page.partition("</h1>")[0]
    assert "Green" in page.partition("</header>")[0]
    pushes = page.partition("Every push")[2].partition("</table>")[0]
    assert pushes.count("</tr>") == 1 + len(green().trials)


def test_command_writes_certificate_and_page(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    posterior = {"parameters": ["com_height"], "mean": [0.07], "covariance": [[1e-6]]}
    (tmp_path / "posterior.json").write_text(json.dumps(posterior))
    options = ["--posterior", tmp_path / "posterior.json", "-n", "150", "-o", tmp_path / "c.json"]
    assert main(["certify", "pid", *map(str, options), "--report", str(tmp_path / "c.html")]) == 0
    written = read_certificate(tmp_path / "c.json")
    said = capsys.readouterr().out
    assert said.startswith("Green")
    assert str(written.page().verdict.text) in (tmp_path / "c.html").read_text()
    # the controller is designed for the middle of the posterior, a robot whose centre of mass stands 2 mm lower
    own = make_controller("pid", ROBOT.replace(com_height=0.07), KIT, KIT.period)
    assert written.hash == controller_hash(own)


def test_command_stops_scripts_by_its_exit_code(tmp_path: Path) -> None:
    write_controller(scaled(designed("pid"), -1.0), tmp_path / "wrong.json")
    arguments = ["certify", str(tmp_path / "wrong.json"), "-n", "100", "-o", str(tmp_path / "c.json")]
    assert main(arguments) == 3  # as its help says
    assert read_certificate(tmp_path / "c.json").light == RED  # written all the same, for `run` and firmware to read
    assert main(["certify", "pid", "-n", "100", "--log", "a.csv", "--posterior", "b.json"]) == 2


@pytest.mark.evidence
def test_it_is_right_of_robots_it_has_never_seen() -> None:
    """A lighter benchmarks/certificate.py, on other cases, with fewer robots in each."""
    from planted import controllers as benchmark

    numbers = (1000, 1001, 1004, 1007, 1013, 1016)  # right, gains, and twice a sensor and the period
    cases = [case for n in numbers if (case := benchmark.plant("nxtway-gs", n, samples=200, most=500))]
    many, few = [c for c in cases if c.falls >= 0.1], [c for c in cases if c.falls <= 0.01]
    assert len(many) >= 2  # both kinds are there, so that the two claims are not empty
    assert len(few) >= 2
    assert all(c.light in (RED, UNKNOWN) for c in many)  # a permit refuses both
    assert sum(c.light == GREEN for c in few) >= 0.75 * len(few)  # of so few, one or two are on the edge


def _trial(*, fell: int = 0, saturated: float = 0.0, travel: float = 0.2, cycle: float = 0.01) -> PushTrial:
    return PushTrial("hold", "low", 1000, fell, saturated=saturated, travel=travel, peak=0.1, cycle=cycle)
