"""Robots that are commanded by wheel speed: steppers, and wheels in a closed loop of their own.

The robot is that of an owner (`shared/cases/stepper`), whose program beside it simulates it by itself.
"""

import importlib.util
import math
import re
import shlex
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import solve_discrete_are

from upright import calibrate, identify, post_mortem
from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.certification.recovery import largest_hold, largest_knock
from upright.checkup.doctor import doctor
from upright.cli.main import main
from upright.control import CONTROLLERS, StateFeedback
from upright.control.delay import sampled
from upright.control.kalman import kalman_filter
from upright.errors import DesignFailed, InvalidLog, InvalidRobot, SpecMismatch
from upright.excitation.design import excite
from upright.experiment.outcome import outcome_of
from upright.experiment.pushes import Hold, Impulse, Push, Slope
from upright.experiment.run import run
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.paper.derivation import derive
from upright.physics.dynamics import MODELS, Disturbance, accelerations
from upright.physics.linear import linearise
from upright.robots import Kit, Motor, Robot

PERIOD, LAG = 0.005, 0.002  # [s]
STEPPER = Robot(
    name="own stepper", drive="speed", wheel_mass=0.05, wheel_radius=0.04, wheel_inertia=4e-5, body_mass=0.9, track=0.2,
    com_height=0.11, pitch_inertia=0.006, yaw_inertia=0.003, roll_inertia=0.008, rotor_inertia=0.0, speed_lag=LAG,
    acceleration_limit=200.0,
)  # fmt: skip
KIT = Kit(name="own kit", drive="speed", motor=Motor(limit=20.0), period=PERIOD)
ROUGH = STEPPER.replace(rotor_inertia=1e-5, gear_ratio=2.0, wheel_friction=1e-3, rolling_friction=2e-3)


@pytest.fixture
def own(shared):
    spec = importlib.util.spec_from_file_location("own", shared / "cases/stepper/own.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def held(K, dt=PERIOD):
    """The speed that the owner's program commands: K gives the wheels' acceleration over a period, from [ψ, ψ̇, δ, δ̇]
    with δ = θ − ψ; it does not steer."""
    lean, rate, angle, speed = (dt * k for k in K)
    row = (lean - angle, rate - speed + 1, angle, speed - 1, 0.0, 1.0)
    return StateFeedback.symmetric(row, dt, command_unit="rad/s")


def test_held_wheels_obey_the_sum_of_both_equations():
    """Lagrange's equation for θ = δ(t) + ψ with δ given, from the energies of a body on an axle that rolls."""
    t = sp.Symbol("t")
    psi, delta = (sp.Function(name)(t) for name in ("psi", "delta"))
    p = ROUGH
    theta = delta + psi
    x, z = p.wheel_radius * theta + p.com_height * sp.sin(psi), p.com_height * sp.cos(psi)
    wheels = 2 * (p.wheel_mass * p.wheel_radius**2 + p.wheel_inertia) * theta.diff(t) ** 2
    rotors = 2 * p.gear_ratio**2 * p.rotor_inertia * delta.diff(t) ** 2
    body = p.body_mass * (x.diff(t) ** 2 + z.diff(t) ** 2) + p.pitch_inertia * psi.diff(t) ** 2
    L = (wheels + rotors + body) / 2 - p.body_mass * p.gravity * z
    equation = L.diff(psi.diff(t)).diff(t) - L.diff(psi)
    acc = sp.solve(equation, psi.diff(t, 2))[0]
    lean, rate, speed, command = 0.2, -0.7, 3.0, 3.1
    point = {delta.diff(t, 2): (command - speed) / LAG, psi.diff(t): rate, delta.diff(t): speed, psi: lean}
    still = ROUGH.replace(wheel_friction=0.0, rolling_friction=0.0)
    found = accelerations((lean, rate, 0.4, speed + rate, 0.0, 0.0), (command, command), still)
    # a dozen terms in floats of 15 digits
    assert found[0] == pytest.approx(float(acc.subs(point)), rel=1e-11)
    assert found[1] - found[0] == pytest.approx((command - speed) / LAG, rel=1e-11)


@pytest.mark.parametrize("model", MODELS)
def test_the_torques_are_those_that_turn_the_wheels_as_commanded(model):
    """The derived equations with a torque on each wheel, which NumPy solves for the two accelerations asked for."""
    exact = derive(model).evaluator("numpy")
    rng = np.random.default_rng(3)
    half = ROUGH.track / (2 * ROUGH.wheel_radius)
    to_wheels = np.array([[-1.0, 1.0, -half], [-1.0, 1.0, half]])  # ψ̈, θ̈, φ̈ → θ̈_l − ψ̈, θ̈_r − ψ̈
    for _ in range(50):
        x = rng.uniform(-1, 1, 6) * (0.6, 4.0, 6.0, 15.0, 3.0, 6.0)
        u = to_wheels @ x[[1, 3, 5]] + rng.uniform(-0.3, 0.3, 2)  # within what 200 rad/s² make of the lag
        w = Disturbance(*rng.uniform(-1, 1, 3) * (3.0, 0.2, 0.3))
        free = np.array(exact(x, (0.0, 0.0), ROUGH, w))
        effect = np.column_stack([np.array(exact(x, one, ROUGH, w)) - free for one in np.eye(2)])
        asked = (u - to_wheels @ x[[1, 3, 5]]) / LAG
        torque = np.linalg.solve(to_wheels @ effect, asked - to_wheels @ free)
        found = np.array(accelerations(x.tolist(), u, ROUGH, w, model=model))
        # differences of accelerations of 1e4 rad/s² per N m leave 1e-12 of them, the solution some times that
        assert np.allclose(found, free + effect @ torque, rtol=0, atol=1e-9 * np.abs(effect @ torque).max())


def test_the_poles_are_those_of_held_wheels():
    """√(MgL / (a11 + 2 a12 + a22)), which the rotors, that turn against the body alone, do not change."""
    p = ROUGH
    total = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia
    total += 2 * p.body_mass * p.com_height * p.wheel_radius + p.body_mass * p.com_height**2 + p.pitch_inertia
    pole = math.sqrt(p.body_mass * p.gravity * p.com_height / total)
    frictionless = ROUGH.replace(wheel_friction=0.0, rolling_friction=0.0)
    poles = np.sort(linearise(frictionless).poles().real)
    # twice zero: where the wheels stand and where the robot heads are free; twice the lag
    assert poles == pytest.approx([-1 / LAG, -1 / LAG, -pole, 0, 0, pole], rel=1e-9, abs=1e-6)
    assert pole == pytest.approx(6.0550, abs=5e-5)  # the owner's, `shared/cases/stepper`


def test_a_wheel_takes_up_its_speed_within_the_lag():
    """u (1 − e^{−t/T}) where nothing limits it, α_max t where that does, whatever the robot falls meanwhile."""
    slow = STEPPER.replace(speed_lag=0.02)
    body = NonlinearBody(slow)
    body.reset((0.1, 0, 0, 0, 0, 0))
    for k in range(1, 41):
        x = body.step((2.0, 1.0)).numbers
        mean, half = x[3] - x[1], x[5] * slow.track / (2 * slow.wheel_radius)
        rise = 1 - math.exp(-k * 0.001 / 0.02)
        # Runge and Kutta at h = T/20: (1/20)⁵/120 of the speed in a step, 20 of them count
        assert (mean - half, mean + half) == pytest.approx((2 * rise, rise), rel=1e-6)
    body.reset()
    for k in range(1, 41):
        x = body.step((15.0, 15.0)).numbers
        assert x[3] - x[1] == pytest.approx(200.0 * k * 0.001, rel=1e-9)


@pytest.mark.needs("shared/cases/stepper")
@pytest.mark.parametrize("impulse", [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4])
def test_the_owners_gains_stand_with_the_owners_peaks(own, impulse):
    K = own.gains()[0]
    peak = float(own.run(K, impulse)[1].split()[1])
    body = Electronics(NonlinearBody(STEPPER), KIT)
    log = run(body, held(K), Impulse(impulse=impulse, duration=0.005), seconds=6)
    assert outcome_of(log).to_json() == {"fell": False, "seconds": pytest.approx(6)}
    # his knock is in no time, ours in 5 ms; his speed rises over 5 ms, ours within 2: 2 % of the peak, and his rounding
    assert np.abs(log["truth/pitch"]).max() == pytest.approx(peak, rel=0.02, abs=0.0005)


@pytest.mark.needs("shared/cases/stepper")
def test_the_linear_model_has_the_owners_gains(own):
    """His weights are on [ψ, ψ̇, δ, δ̇] and on the acceleration over a period, (u − δ̇)/dt, so that u and state share one.
    Without our lag the two designs would be one; with 2 ms of it in 5 ms they differ by little."""
    quick = STEPPER.replace(speed_lag=1e-4)
    model = linearise(quick).c2d(PERIOD)
    A, B = model.A[:4, :4], model.B[:4].sum(axis=1, keepdims=True)
    to_own = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [-1, 0, 1, 0], [0, -1, 0, 1.0]])
    price = 1 / (100.0 * PERIOD) ** 2
    speed = to_own[3:]
    Q = to_own.T @ np.diag([1 / 0.1**2, 1, 1 / 5.0**2, 1 / 10.0**2]) @ to_own + price * speed.T @ speed
    R, S = np.array([[price]]), -price * speed.T
    P = solve_discrete_are(A, B, Q, R, s=S)
    gain = np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A + S.T)[0]
    expected = np.array(held(own.gains()[0]).gain[0, :4])
    # his speed rises evenly over the period, ours at its start: half a period, 2.5 ms, of poles up to 15 1/s
    assert np.abs(gain - expected).max() <= 0.05 * np.abs(expected).max()


def test_a_robot_that_is_held_slips_beyond_what_statics_ask():
    """A hold asks F R/2 of each wheel (docs/conventions.md)."""
    push = Hold(pitch=0.1, until=2.0)
    torque = abs(push.force(STEPPER)) * STEPPER.wheel_radius / 2
    still = StateFeedback.symmetric((0,) * 6, PERIOD, command_unit="rad/s")
    for share, slips in ((1.05, False), (0.95, True)):
        body = NonlinearBody(STEPPER.replace(slip_torque=share * torque))
        log = run(body, still, push, seconds=0.2, start=(0.1, 0, 0, 0, 0, 0))
        assert math.isfinite(outcome_of(log).slipped) == slips
        assert (outcome_of(log).slipped < 0.01) == slips


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize(
    ("changes", "slope"), [({}, 0.0), ({"wheel_friction": 1e-3, "rolling_friction": 2e-3, "slip_torque": 0.15}, 0.03)]
)
def test_the_kernel_moves_it_as_a_run_does(changes, slope, model):
    """Also where it slips and turns, and on a slope."""
    robot, start, knock = STEPPER.replace(**changes), (0.02, 0, 0, 0, 0.3, 0), Impulse(impulse=0.3, duration=0.005)
    controller = StateFeedback.symmetric((-8, -1.2, -0.09, -1.1, 0.5, 1.0), PERIOD, command_unit="rad/s")
    pushes = (knock, Slope(angle=slope))
    log = run(Electronics(NonlinearBody(robot, model), KIT), controller, pushes, seconds=2, start=start)
    assert math.isfinite(outcome_of(log).slipped) == bool(changes)
    batch = FleetBatch(
        parameters=parameters_of(robot), controller=controller, kit=KIT, start=np.array([start]), model=model,
        pushes=np.array([[[knock.impulse / 0.005, math.nan, knock.start, 0.005]]]), slope=np.array([[slope, 0.0]]),
    )  # fmt: skip
    names = ("truth/pitch", "truth/wheel", "truth/yaw")
    trace = simulate(batch, 2.0, record=1, channels=names).trace[0]
    assert len(log) == len(trace)
    for column, name in zip(trace.T, names, strict=True):
        # two seconds of one arithmetic in two orders; what is unstable is held
        assert np.abs(column - log[name]).max() < 1e-9


@pytest.mark.parametrize(("changes", "message"), [
    ({"speed_lag": 0.0}, "a speed drive without speed_lag"),
    ({"coulomb_friction": 0.01}, "a speed drive with coulomb_friction = 0.01"),
    ({"torque_constant": 0.3}, "a speed drive with torque_constant = 0.3"),
    ({"drive": "voltage"}, "a voltage drive with speed_lag = 0.002"),
])  # fmt: skip
def test_numbers_of_another_drive_are_refused(changes, message):
    with pytest.raises(InvalidRobot, match=message):
        STEPPER.replace(**changes)


def test_kit_and_robot_must_have_one_drive(tmp_path):
    with pytest.raises(SpecMismatch, match="drives by speed"):
        Electronics(NonlinearBody(Robot.preset("nxtway-gs")), KIT)
    assert STEPPER.command_unit == "rad/s"
    again = Robot.load(STEPPER.save(tmp_path / "own.toml"))
    assert again == STEPPER
    assert "motor_resistance" not in (tmp_path / "own.toml").read_text("utf-8")


def test_an_array_of_robots_is_many_robots():
    two = {name: np.array([v, v]) for name, v in ROUGH.numbers().items()}
    two["com_height"] = np.array([0.11, 0.08])
    x, u = (0.1, 0.2, 0.0, 3.0, 0.1, 0.5), (3.0, 2.5)
    batch = np.array(accelerations([np.full(2, v) for v in x], u, SimpleNamespace(**two), xp=np))
    single = accelerations(x, u, ROUGH.replace(com_height=0.08))
    assert batch[:, 1] == pytest.approx(single, rel=1e-12)  # the same operations, by NumPy's functions


LEAN = (0.05, 0, 0, 0, 0, 0)
PUSHED = (Impulse(impulse=0.25, duration=0.02), Push(force=0.4, start=2.0, duration=0.5))
HOLDING = StateFeedback.symmetric((-8, -1.2, -0.09, -1.1, 0.5, 1.0), PERIOD, command_unit="rad/s")


def test_the_twin_moves_as_the_model():
    model, twin = (
        run(Electronics(body, KIT), HOLDING, PUSHED, seconds=4, start=(0, 0, 0, 0, 0.3, 0))
        for body in (NonlinearBody(STEPPER), Twin(STEPPER))
    )
    gap = model["truth/pitch"] - twin["truth/pitch"]
    # the twin's drive has a loop of its own, of 400 rad/s, which what the robot weighs on a wheel turns a little
    assert np.sqrt(np.mean(gap**2)) <= 0.002 * np.abs(model["truth/pitch"]).max()
    assert np.abs(model["truth/yaw"] - twin["truth/yaw"]).max() < 0.001 * 0.3


def test_the_twin_slips_as_the_model():
    weak = STEPPER.replace(slip_torque=0.04)
    slipped = [
        outcome_of(run(Electronics(body, KIT), HOLDING, PUSHED, seconds=2)).slipped
        for body in (NonlinearBody(weak), Twin(weak))
    ]
    assert slipped[0] == pytest.approx(slipped[1], abs=2 * PERIOD)  # both as the knock at 1 s is met
    assert 1.0 < slipped[0] < 1.1


@pytest.mark.needs("shared/cases/stepper")
@pytest.mark.parametrize("method", ["lqr", "lqi", "lqg", "hinf", "mpc", "sliding"])
def test_default_designs_meet_the_owners_knocks(own, method):
    """On raw sensors, with a dead time of 1 ms. What the owner's gains of the true state survive, they survive: his
    hardest knock leans his robot by 0.16 rad; theirs lean by up to 0.39 (sliding) as they come back."""
    robot, kit = Robot.preset("stepper"), Kit.preset("stepper")
    controller = CONTROLLERS[method](robot, kit, kit.period)
    peak = float(own.run(own.gains()[0], 0.4)[1].split()[1])
    log = run(Electronics(NonlinearBody(robot), kit), controller, Impulse(impulse=0.4), seconds=5, seed=1)
    assert outcome_of(log).to_json() == {"fell": False, "seconds": pytest.approx(5)}
    assert peak / 2 < np.abs(log["truth/pitch"]).max() < 2.5 * peak


def test_a_cascade_of_torques_is_refused():
    with pytest.raises(DesignFailed, match="pid asks a torque for a lean, and 'stepper' is driven by wheel speed"):
        CONTROLLERS["pid"](Robot.preset("stepper"), Kit.preset("stepper"), PERIOD)


def test_a_filter_keeps_no_push_that_it_cannot_see():
    """A lean and the steady push that balances it leave gyro and step counter at zero, and ask no command: no reading
    tells the pair from nothing. An accelerometer would, and so does the command of a robot whose motors push."""
    kit = Kit.preset("stepper")
    model = sampled(STEPPER, kit).linear
    tangent = linearise(STEPPER)
    push = tangent.E[:, 0] + STEPPER.com_height * tangent.E[:, 1]
    lean = -push[1] / tangent.A[1, 0]
    # ψ̈ = 0 under both, and θ̈ with it; the readings know neither
    assert np.abs(tangent.A @ [lean, 0, 0, 0, 0, 0] + push).max() < 1e-9 * np.abs(push).max()
    assert "push" not in model.states
    assert np.abs(np.linalg.eigvals(model.A - model.A @ kalman_filter(sampled(STEPPER, kit)).L @ model.C)).max() < 1


@pytest.mark.parametrize("limit", [20.0, 8.0])
def test_what_any_controller_survives_is_full_acceleration_up_to_full_speed(limit):
    """The owner's equations under a knock of 20 ms, and from the wait on 200 rad/s² up to the limit of speed: the
    largest impulse after which the lean comes back, by bisection."""
    kit = Kit(name="k", drive="speed", motor=Motor(limit=limit), period=PERIOD)
    p = STEPPER

    def falls(impulse):
        lean = rate = speed = 0.0
        h = 1e-4
        for k in range(20000):
            push = impulse / 0.02 if k * h < 0.02 else 0.0
            acc = min(200.0, (limit - speed) / LAG) if k * h >= PERIOD else 0.0
            c, s = math.cos(lean), math.sin(lean)
            a11 = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia
            a12 = p.body_mass * p.com_height * p.wheel_radius * c
            total = a11 + 2 * a12 + p.body_mass * p.com_height**2 + p.pitch_inertia
            swing = p.body_mass * p.com_height * p.wheel_radius * s * rate**2
            moment = p.body_mass * p.gravity * p.com_height * s + swing + push * (p.wheel_radius + p.com_height * c)
            rate += h * (moment - (a11 + a12) * acc) / total
            lean += h * rate
            speed += h * acc
            if abs(lean) > 0.8:
                return lean > 0
        return False

    low, high = 0.05, 2.0
    for _ in range(12):
        middle = (low + high) / 2
        low, high = (low, middle) if falls(middle) else (middle, high)
    # Euler's steps of 0.1 ms, and sizes that are searched to a 64th of a step of 14 %
    assert largest_knock(STEPPER, kit) == pytest.approx(low, rel=0.01)


def test_no_controller_holds_what_slips():
    """A hold asks F R/2 of each wheel; beyond the slip torque there is no rest to be let go from."""
    torque = abs(Hold(pitch=0.1, until=1.0).force(STEPPER)) * STEPPER.wheel_radius / 2
    weak = STEPPER.replace(slip_torque=torque)
    assert 0.05 < largest_hold(weak, KIT) <= 0.1  # less, since it takes torque to come back
    assert largest_hold(STEPPER, KIT) > 0.3


def test_a_log_of_a_speed_drive_is_refused_in_one_line(tmp_path):
    log = run(Electronics(NonlinearBody(STEPPER), Kit.preset("stepper")), HOLDING, seconds=2, start=LEAN)
    path = log.save(tmp_path / "run.csv")
    for examine in (calibrate, identify, post_mortem):
        with pytest.raises(InvalidLog, match="a log of 'stepper', which is driven by wheel speed, is not examined yet"):
            examine(path, "stepper")


LONG = ("certify", "parity")
PAGE = Path(__file__).parents[1] / "docs" / "steppers.md"


def shown():
    """The commands of the page, in order."""
    blocks = re.findall(r"^```sh\n(.*?)^```", PAGE.read_text("utf-8"), re.MULTILINE | re.DOTALL)
    return [shlex.split(line) for block in blocks for line in block.splitlines()]


@pytest.mark.parametrize("long", [False, pytest.param(True, marks=pytest.mark.evidence)])
def test_the_commands_of_the_page_run_and_say_what_it_says(long, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    said = ""
    for words in shown():
        if long or words[1] not in LONG:
            assert main(words[1:]) == 0, words
            said += capsys.readouterr().out
    assert re.search(r"^ +6\.05", said, re.MULTILINE)
    assert "motors slipped at" in said
    assert (tmp_path / "steps.ino").exists()
    assert len(PAGE.read_text("utf-8").split()) <= 700


def test_no_next_command_and_no_search_of_what_a_speed_drive_lacks() -> None:
    """Nothing is learnt from its log yet: who asks is told so first, and the doctor sends nobody there."""
    robot = Robot.preset("stepper")
    with pytest.raises(InvalidLog, match="driven by wheel speed, is not examined yet"):
        excite("lqg", robot)
    kit = Kit.preset(robot.kit_name)
    log = run(Electronics(NonlinearBody(robot), kit), CONTROLLERS["lqg"](robot, kit, kit.period),
              Impulse(impulse=0.05, start=1.0), seconds=4.0)  # fmt: skip
    verbs = {step.verb for step in doctor(log, robot=robot).page().next}
    assert not verbs & {"excite", "calibrate"}
