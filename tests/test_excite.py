"""Excitation: what a run tells follows from closed forms; a plan tells more than a dither, and keeps its limits."""

from __future__ import annotations

import dataclasses
import json
import sys
from functools import cache
from pathlib import Path

import control
import numpy as np
import pytest

from heads import shown_alike
from upright.bodies import Electronics, NonlinearBody
from upright.calibration.calibrate import calibrate
from upright.cli.main import main
from upright.control import Estimated, StateFeedback, kalman, lqr_state, make_controller
from upright.control.excited import Excited, random_binary
from upright.control.identity import asked_of, designed_from
from upright.control.law import as_law, near_rest
from upright.errors import DesignFailed, InvalidScenario, SpecMismatch, UnknownName
from upright.excitation import excite
from upright.excitation.information import HELD_OUT, best_division, fisher, problem_of, shrunk
from upright.excitation.loop import ExcitedLoop, perfect
from upright.excitation.plan import ExcitationPlan, read_plan
from upright.excitation.planned import Limits
from upright.excitation.signals import band, signals, unit
from upright.experiment import run
from upright.fleets.binomial import clopper_pearson
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.pages import html
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain
from upright.physics.linear import linearise
from upright.robots import Kit, Robot
from upright.signals import TRUE_STATE, Log

NXT = Robot.preset("nxtway-gs")
KIT = Kit.preset("nxt")
LQG = make_controller("lqg", NXT, KIT, 0.01)
SECONDS = 3.0
FEW = Limits(falls=0.05, travel=0.4)
"""A hundred robots without a fall prove 2.95 %, not 1 %."""


@cache
def plan() -> ExcitationPlan:
    """A short run tried on few robots: what is claimed of it holds for every plan."""
    return excite(LQG, NXT, KIT, seconds=SECONDS, limits=FEW, samples=100)


def test_the_kernel_adds_what_the_wrapper_adds() -> None:
    """Both motors under an excitation in the kernel and in `experiment.run`: equal to rounding."""
    kit = perfect(KIT)
    loop = ExcitedLoop(NXT, kit, LQG, 2.0)
    rows = random_binary(loop.rows, 0.8, 3)
    result = loop.run(rows, record=True)
    log = run(Electronics(NonlinearBody(NXT), kit), Excited(LQG, np.repeat(rows, loop.hold, axis=0)), seconds=2.0)
    for i, name in enumerate(result.channels):
        assert np.abs(result.trace[0, :, i] - log[name]).max() < 1e-9, name
    assert np.ptp(log["applied/left"] - log["applied/right"]) > 0.5  # it turned, or half of this were not tried


def test_what_is_added_is_a_disturbance_at_the_plant_s_input() -> None:
    """x⁺ = (A − B K) x + B d of python-control for commands d that are added, each held for two periods.

    They are so small that the robot is its tangent to rounding; steps of Runge and Kutta of 1 ms follow it to 1e-6.
    """
    feedback, tangent = lqr_state(NXT, 0.01), linearise(NXT)
    plant = control.sample_system(control.ss(tangent.A, tangent.B, np.eye(6), np.zeros((6, 2))), 0.01)
    d = random_binary(100, 1e-7, seed=1)
    batch = FleetBatch(parameters=parameters_of(NXT), controller=feedback, excitation=d, excitation_hold=2)
    result = simulate(batch, 2.0, record=1, channels=TRUE_STATE)
    closed = control.ss(plant.A - plant.B @ feedback.gain, plant.B, np.eye(6), np.zeros((6, 2)), 0.01)
    truth = control.forced_response(closed, result.t, np.repeat(d, 2, axis=0).T).outputs.T
    assert (np.abs(result.trace[0] - truth).max(axis=0) < 1e-5 * np.ptp(truth, axis=0)).all()


@pytest.mark.parametrize("kind", ["sliding", "mpc", "lqg"])
def test_an_excited_controller_runs_compiled(kind: str) -> None:
    """As in `experiment.run`, for laws with limits of their own and after the end of the excitation: to rounding."""
    kit, channels = perfect(KIT), ("truth/pitch", "command/left", "applied/right")
    excited = Excited(make_controller(kind, NXT, kit, 0.01), random_binary(60, 0.8, seed=2, hold=4))
    batch = FleetBatch(parameters=parameters_of(NXT), controller=excited, kit=kit)
    assert batch.called is None
    result = simulate(batch, 1.0, record=1, channels=channels)
    log = run(Electronics(NonlinearBody(NXT), kit), excited, seconds=1.0)
    for i, name in enumerate(result.channels):
        assert np.abs(result.trace[0, :, i] - log[name]).max() < 1e-9, name
    assert np.ptp(log["command/left"]) > 1.0


def test_a_memory_is_driven_by_what_the_controller_commands_itself() -> None:
    """z⁺ = A z + Bu u of a sliding mode inside its layer, where u = C z: the linear controller with A + Bu C, to
    rounding, whatever is added to the command."""
    law = as_law(make_controller("sliding", NXT, KIT, 0.01))
    Bu = 0.01 * np.random.default_rng(0).standard_normal((len(law.linear.A), 2))
    law = dataclasses.replace(law, nonlinear=dataclasses.replace(law.nonlinear, Bu=Bu))
    several = (
        FleetBatch(parameters=parameters_of(NXT), controller=one, kit=perfect(KIT), excitation=0.01 * np.ones((20, 2)))
        for one in (law, near_rest(law))
    )
    one, other = (simulate(batch, 0.5, record=1, channels=["command/left", "truth/wheel"]).trace for batch in several)
    assert np.abs(one - other).max() < 1e-9 * np.abs(one).max()


def turning(noise: float) -> tuple[Log, float]:
    """A log of a robot that stands upright and only turns, and what it tells of z of the yaw inertia, in closed form.

    φ̈ = b d − c φ̇ for d = u_r − u_l, whose solution over a held command is exact. Both encoders read ∓ W/(2R) φ with
    variance `noise`; heading and yaw rate at the start are known as `FIRST_SPREAD` says, and are regressed out.
    """
    dt, n = 0.01, 800
    half = NXT.track / (2 * NXT.wheel_radius)
    d = np.repeat(np.random.default_rng(0).choice([-1.0, 1.0], n // 10), 10)

    def heading(inertia: float) -> np.ndarray:
        a33 = mass_matrix(1.0, 0.0, dataclasses.replace(NXT, yaw_inertia=inertia))[3]
        b, c = half * motor_gain(NXT) / a33, 2 * half**2 * (motor_damping(NXT) + NXT.wheel_friction) / a33
        phi, rate, found = 0.0, 0.0, []
        for command in d:
            found.append(phi)
            end = b * command / c
            phi += end * dt + (rate - end) * (1 - np.exp(-c * dt)) / c
            rate = end + (rate - end) * np.exp(-c * dt)
        return np.array(found)

    t, step = np.arange(n) * dt, 1e-4 * NXT.yaw_inertia
    slope = (heading(NXT.yaw_inertia + step) - heading(NXT.yaw_inertia - step)) / (2 * step)
    a33 = mass_matrix(1.0, 0.0, NXT)[3]
    c = 2 * half**2 * (motor_damping(NXT) + NXT.wheel_friction) / a33
    spread = NXT.provenance["yaw_inertia"].spread
    assert spread is not None
    used = (t >= 0.02) & (t <= t[-1] * (1 - HELD_OUT))  # what a calibration skips and keeps back
    J = np.sqrt(2 / noise) * half * (slope * spread)[used]
    H = np.sqrt(2 / noise) * half * np.column_stack([np.ones(n), (1 - np.exp(-c * t)) / c])[used]
    known = np.diag([1e-2**-2, 2.0**-2])
    told = J @ J - J @ H @ np.linalg.solve(H.T @ H + known, H.T @ J)
    phi, gyro = heading(NXT.yaw_inertia), 1e-6 * np.random.default_rng(1).standard_normal(n)
    channels = {"sensor/encoder_left": -half * phi, "sensor/encoder_right": half * phi, "sensor/gyro": gyro}
    return Log(t, {**channels, "applied/left": -d / 2, "applied/right": d / 2}, origin={"body": {}}), float(told)


def test_information_is_that_of_the_closed_form() -> None:
    """Without process noise the innovations tell of the yaw inertia what linear regression does, to 1 %: the filter
    moves in steps of Runge and Kutta, and parameters by finite differences."""
    noise = 1e-4
    log, told = turning(noise)
    quiet = {"encoder": np.log(noise), "gyro": np.log(noise), "motor": -60.0, "push": -60.0, "gyro_bias": -60.0}
    problem = dataclasses.replace(problem_of(log, NXT, Kit(name="none")), noise=quiet)
    row = [p.name for p in problem.parameters].index("yaw_inertia")
    assert fisher(problem)[row, row] == pytest.approx(told, rel=0.01)


def test_shares_fill_up_like_water() -> None:
    """Two parts that tell one parameter each, 4 and 1: Σ log(1 + s m) is largest where 1/m + s are equal."""
    parts = np.array([np.diag([4.0, 0.0]), np.diag([0.0, 1.0])])
    shares = best_division(np.zeros((2, 2)), parts, np.ones(2))
    assert shares == pytest.approx([0.875, 0.125], abs=1e-4)  # 1/4 + 7/8 = 1 + 1/8
    assert best_division(np.zeros((2, 2)), parts, np.array([1.0, 0.0])) == pytest.approx([1.0, 0.0])
    assert shrunk(parts[0]) == pytest.approx([1 / np.sqrt(5), 1.0])


def test_signals_are_what_their_names_say() -> None:
    rows, step = 500, 0.02
    every = signals(rows, step, 0)
    for parts in every.values():
        for name, wave in parts.items():
            assert np.mean(wave**2) == pytest.approx(1.0), name
            assert np.allclose(wave[:, 0], wave[:, 1] if "turn" not in name else -wave[:, 1]), name
    wave = band(rows, step, 1.0, 2.0, np.random.default_rng(0))
    power = np.abs(np.fft.rfft(wave)) ** 2
    inside = (np.fft.rfftfreq(rows, step) >= 1.0) & (np.fft.rfftfreq(rows, step) < 2.0)
    assert power[inside].sum() == pytest.approx(power.sum())
    assert np.abs(unit(np.ones(rows), step)[0]) < 0.1  # it grows from nothing


def test_a_plan_tells_more_than_a_dither_of_its_energy() -> None:
    """In the geometric mean of the predicted widths of all that is visible, and than the better dither held 40 ms."""
    seen = [p for p in plan().predicted if p.after < 0.5 * p.before and "/" not in p.name]
    gain = {kind: np.mean([np.log(p.after / getattr(p, kind)) for p in seen]) for kind in ("dither", "held")}
    assert len(seen) >= 5  # of NXTway-GS calibration sees com_height, two inertias, rotor, frictions
    assert gain["dither"] < np.log(0.8)  # not just by luck: repeated dithers differ by a few per cent
    assert gain["held"] < 0


@pytest.mark.evidence
def test_a_calibration_finds_it_so() -> None:
    """On logs of a robot that is not the preset: by the plan's log intervals are narrower than by the dither's, by what
    was predicted, to a seventh for one log of each. (A calibration that learns the noise before the parameters takes
    their errors for process noise on such logs, and loses half of that.)"""
    true = NXT.replace(com_height=0.075, pitch_inertia=1.2e-3, yaw_inertia=9e-4)
    loop = ExcitedLoop(NXT, KIT, LQG, SECONDS)
    names = ("wheel_radius", "pitch_inertia", "yaw_inertia", "wheel_friction")
    predicted = np.mean([np.log(plan()[n].after / plan()[n].dither) for n in names])
    for seed in (1, 2):
        dither = loop.scaled(random_binary(loop.periods, 0.5, seed)[None], plan().energy, 1)[0]
        body = Electronics(NonlinearBody(true), KIT)
        logs = [run(body, Excited(LQG, s), seconds=SECONDS, seed=seed) for s in (plan().sequence, dither)]
        ours, theirs = (calibrate(log, NXT, KIT) for log in logs)
        ratios = [(ours[n].high - ours[n].low) / (theirs[n].high - theirs[n].low) for n in names]
        assert np.mean(np.log(ratios)) < predicted + np.log(1.15), ratios


def test_a_hundred_runs_leave_what_other_numbers_leave() -> None:
    """Ten times less of the difference of two motors, which a log tells alone; hardly less of the height of the centre
    of mass, which follows from a product with a mass that is known to a hundredth."""
    assert all(p.least <= p.after * (1 + 1e-9) for p in plan().predicted)
    assert 9 < plan()["asymmetry"].after / plan()["asymmetry"].least < 10  # less what is known before
    assert plan()["body_mass"].least == pytest.approx(plan()["body_mass"].before, rel=0.05)
    assert plan()["com_height"].after / plan()["com_height"].least < 2


def test_both_energies_are_the_same() -> None:
    """The plan's energy is what the motors of the nominal robot get, and a dither of its energy gets as much."""
    loop = ExcitedLoop(NXT, KIT, LQG, SECONDS)
    dither = loop.scaled(random_binary(loop.periods, 0.5, 1)[None], plan().energy, 1)
    assert loop.energies(dither, 1)[0] == pytest.approx(plan().energy, rel=1e-3)
    log = run(Electronics(NonlinearBody(NXT), perfect(KIT)), plan().excited(LQG), seconds=SECONDS)
    motors = np.column_stack([log["applied/left"], log["applied/right"]])
    assert (motors**2).sum() * 0.01 == pytest.approx(plan().energy, rel=0.02)  # the last row may be a part of a period


def test_limits_are_kept() -> None:
    """By the numbers of the plan, and by a run of other robots than those it was tried on."""
    checked = plan().checked
    assert plan().check() == ()
    assert checked.bound == pytest.approx(clopper_pearson(checked.fell, checked.samples).high)
    assert checked.bound <= FEW.falls
    log = run(Electronics(NonlinearBody(NXT), KIT), plan().excited(LQG), seconds=SECONDS, seed=77)
    assert not log.origin["outcome"]["fell"]
    assert np.abs(log["truth/wheel"]).max() * NXT.wheel_radius < FEW.travel


def test_a_tampered_plan_is_found_out() -> None:
    louder = dataclasses.replace(plan(), excitation=2 * plan().excitation)
    assert "what is added" in louder.check()[0]
    fallen = dataclasses.replace(plan(), checked=dataclasses.replace(plan().checked, fell=50))
    assert "fall" in fallen.check()[0]
    with pytest.raises(InvalidScenario, match="contradicts itself"):
        ExcitationPlan.from_json(louder.to_json())


def test_a_plan_survives_a_file(tmp_path: Path) -> None:
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(plan().to_json(), allow_nan=False), encoding="utf-8")
    again = read_plan(path)
    assert again.to_json() == plan().to_json()
    assert np.array_equal(again.sequence, plan().sequence)
    assert not again.excitation.flags.writeable
    path.write_text("{}", encoding="utf-8")
    with pytest.raises(InvalidScenario, match="without a schema; expected upright/excite"):
        read_plan(path)
    with pytest.raises(InvalidScenario, match="cannot read"):
        read_plan(tmp_path / "none.json")


def test_a_plan_fits_its_controller_only() -> None:
    assert isinstance(plan().excited(LQG), Excited)
    with pytest.raises(SpecMismatch, match=r"every 0\.02 s"):
        plan().excited(lqr_state(NXT, 0.02))


def test_another_processor_s_rounding_is_the_same_controller() -> None:
    """The same design with numbers that differ in the twelfth digit, as matrix routines of two processors make them."""
    rounded = dataclasses.replace(LQG, C=LQG.C * (1 + 1e-12))
    assert "another controller" in plan().differs(rounded)  # nobody knows what it was designed from
    assert plan().differs(designed_from(rounded, asked_of(LQG))) == ""
    assert "another controller" in plan().differs(make_controller("lqi", NXT, KIT, LQG.spec.period))


def test_what_cannot_be_designed_gets_one_line() -> None:
    unstable = Estimated(StateFeedback(-lqr_state(NXT, 0.01).gain, 0.01), kalman(NXT, KIT, 0.01))
    wrong = [
        ({"focus": ("com_heigt",)}, UnknownName, "did you mean 'com_height'"),
        ({"limits": Limits(travel=1e-4)}, DesignFailed, "raise that limit"),
        ({"limits": Limits(falls=1e-3)}, DesignFailed, "fall"),  # 100 robots prove 3 % at best
        ({"controller": unstable}, DesignFailed, "do not stand unexcited"),
        ({"controller": lqr_state(NXT, 0.01)}, SpecMismatch, "true state"),
        ({"controller": make_controller("sliding", NXT, KIT, 0.01)}, SpecMismatch, "linear"),
        ({"seconds": 0.1}, InvalidScenario, "a hundred periods"),
        ({"samples": 5}, InvalidScenario, "100 or more"),
        ({"enough": 0.5}, InvalidScenario, "enough"),
    ]
    for changes, error, says in wrong:
        options = {"controller": LQG, "seconds": 2.0, "samples": 100} | changes
        with pytest.raises(error, match=says) as caught:
            excite(robot=NXT, kit=KIT, **options)
        assert "\n" not in str(caught.value)
    with pytest.raises(InvalidScenario, match="travel"):
        Limits(travel=0.0)


def test_the_page_shows_the_excitation_and_what_it_tells() -> None:
    page = plan().page()
    assert "is added to a command" in html.document(page)
    assert "centre of mass height" in str(plan())
    shown_alike(plan())
    assert page.verdict
    assert page.verdict.level == "good"


def test_the_command_plans_runs_and_says_so(tmp_path: Path, monkeypatch, capsys) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys.modules["upright.excitation"], "excite", lambda *_, **__: plan())
    assert main(["excite", "-o", "plan.json", "--report", "plan.html"]) == 0
    said = capsys.readouterr().out
    assert "wrote plan.json" in said
    assert "centre of mass height" in said
    assert main(["simulate", "--excite", "plan.json", "-o", "run.csv"]) == 0
    assert Log.load("run.csv").t[-1] == pytest.approx(SECONDS, abs=KIT.period)  # as long as the plan
    assert main(["simulate", "--excite", "plan.html", "-s", "2"]) == 2
    assert "no JSON" in capsys.readouterr().err


def test_a_design_that_is_stopped_leaves_nothing(tmp_path: Path, monkeypatch, capsys) -> None:
    def stop(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys.modules["upright.excitation"], "excite", stop)
    assert main(["excite", "-o", "plan.json"]) == 130
    assert "stopped" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
