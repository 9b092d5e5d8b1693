"""The twin: MuJoCo's own physics against the equations, closed forms and symmetries."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Sequence
from pathlib import Path

import mujoco
import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_are
from scipy.optimize import brentq

import upright.robots
from upright.bodies.body import REST, Body
from upright.bodies.mjcf import mjcf
from upright.bodies.models import NonlinearBody
from upright.bodies.twin import Twin
from upright.errors import InvalidRobot, InvalidScenario, SpecMismatch, UprightError
from upright.physics.dynamics import CALM, Disturbance, mass_matrix, motor_damping, motor_gain
from upright.physics.linear import linearise
from upright.robots import Robot

Array = NDArray[np.float64]

ROBOT = Robot.preset("nxtway-gs")
LOSSLESS = ROBOT.replace(back_emf=0.0, motor_friction=0.0)
PRESETS = sorted((Path(upright.robots.__file__).parent / "presets").glob("*.toml"))


def gain(robot: Robot, states: Sequence[int]) -> Array:
    """A regulator of the named states at 1 ms, zero for the others: any that is well damped will do."""
    model = linearise(robot).c2d(0.001)
    A, B = model.A[np.ix_(states, states)], model.B[list(states)]
    Q, R = np.diag([100.0 if state in (0, 2) else 1.0 for state in states]), 10 * np.eye(2)
    P = solve_discrete_are(A, B, Q, R)
    K = np.zeros((2, 6))
    K[:, list(states)] = np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)
    return K


def driven(body: Body, seconds: float = 3.0) -> Array:
    """States while a feedback drives `body` at 4.3 rad/s of wheel and turns it at 3.3 rad/s, from rest."""
    robot, reference = body.spec.robot, np.array([0, 0, 0, 4.3, 0, 3.3])
    K = gain(robot, [0, 1, 3, 5])
    turn = robot.track / (2 * robot.wheel_radius) * 3.3
    steady = motor_damping(robot) / motor_gain(robot) * np.array([4.3 - turn, 4.3 + turn])
    states = [body.reset().values[:6]]
    for _ in range(round(seconds / body.spec.period)):
        states.append(body.step(steady - K @ (states[-1] - reference)).values[:6])
    return np.array(states)


def off(a: Array, b: Array, state: int) -> float:
    """RMS difference over the peak of `b`."""
    return float(np.sqrt(np.mean((a[:, state] - b[:, state]) ** 2)) / np.abs(b[:, state]).max())


def coast(body: Body, start: Sequence[float], command: Sequence[float], steps: int, w: Disturbance = CALM) -> Array:
    rows = [body.reset(start).values, *(body.step(command, w).values for _ in range(steps))]
    return np.array(rows)


@pytest.mark.parametrize("robot", [ROBOT, LOSSLESS], ids=["nominal", "lossless"])
def test_the_complete_model_is_what_the_twin_does_while_driving_and_turning(robot: Robot) -> None:
    twin = driven(Twin(robot))
    complete, published = driven(NonlinearBody(robot)), driven(NonlinearBody(robot, "published"))
    assert abs(twin[-1, 3] - 4.3) < 0.01  # the manoeuvre is the stated one
    assert abs(twin[-1, 5] - 3.3) < 0.01
    assert off(complete, twin, 0) < 0.002  # the bar: 0.2 % of the peak pitch
    assert off(complete, twin, 3) < 0.002
    # The published equations miss terms of the size MLR φ̇² and MLR φ̇ θ̇: about 1 % here, five times the bar.
    assert off(published, twin, 0) > 0.005
    assert off(published, twin, 3) > 0.005


def test_stiffer_contact_converges_to_the_complete_model() -> None:
    complete, published = driven(NonlinearBody(LOSSLESS), 1.5), driven(NonlinearBody(LOSSLESS, "published"), 1.5)
    twins = [driven(Twin(LOSSLESS, contact_time=2 * h, timestep=h), 1.5) for h in (0.0005, 0.00025, 0.000125)]
    errors = [off(complete, twin, 0) for twin in twins]
    # Slip relaxes at a rate 2/contact_time, and the time step is of first order: halving both halves the error.
    assert errors[0] / errors[1] == pytest.approx(2, rel=0.25)
    assert errors[1] / errors[2] == pytest.approx(2, rel=0.25)
    wrong = [off(published, twin, 0) for twin in twins]
    assert wrong[2] > 0.9 * wrong[0]  # the published model is not the limit


def test_an_uncontrolled_robot_falls_along_the_unstable_pole() -> None:
    # The largest eigenvalue of NXTway-GS, of the corrected equations linearised by hand, is 7.437 1/s.
    poles, vectors = np.linalg.eig(linearise(ROBOT).A)
    mode = np.real(vectors[:, np.argmax(poles.real)])
    start = 1e-4 * mode / mode[0]  # along the unstable mode, so that no other pole shows
    pitch = coast(Twin(ROBOT), tuple(start), (0, 0), 500)[:, 0]
    rate = float(np.polyfit(np.arange(100, 501) * 0.001, np.log(pitch[100:]), 1)[0])
    assert rate == pytest.approx(7.437, rel=2e-3)  # first order: pole × timestep is 0.0019


def test_energy_is_kept_without_losses() -> None:
    def energy(x: Array) -> float:
        a11, a12, a22, a33 = mass_matrix(math.cos(x[0]), math.sin(x[0]), LOSSLESS)
        motion = (a11 * x[3] ** 2 + a22 * x[1] ** 2 + a33 * x[5] ** 2) / 2 + a12 * x[3] * x[1]
        return float(motion + LOSSLESS.gravity * LOSSLESS.body_mass * LOSSLESS.com_height * math.cos(x[0]))

    states = coast(Twin(LOSSLESS), (0.1, 0, 0, 4, 0, 3), (0, 0), 200)[:, :6]
    assert states[-1, 0] > 0.8  # it fell far enough to exchange energy
    energies = np.array([energy(x) for x in states])
    assert np.ptp(energies) < 0.005 * energies[0]  # half a percent: first-order steps and a little slip


def test_a_mirrored_robot_moves_mirrored() -> None:
    a = coast(Twin(ROBOT), (0.05, 0, 0, 1, 0.3, 2), (1.0, 0.4), 200)[:, :6]
    b = coast(Twin(ROBOT), (0.05, 0, 0, 1, -0.3, -2), (0.4, 1.0), 200)[:, :6]
    np.testing.assert_allclose(b, a * [1, 1, 1, 1, -1, -1], atol=1e-6)  # the contact solver's tolerance


def test_front_and_back_are_alike() -> None:
    a = coast(Twin(ROBOT), (0.05, 0.1, 0, 1, 0, 0), (1.0, 0.4), 200)[:, :6]
    b = coast(Twin(ROBOT), (-0.05, -0.1, 0, -1, 0, 0), (-1.0, -0.4), 200)[:, :6]
    np.testing.assert_allclose(b, -a, atol=1e-6)  # the contact solver's tolerance


@pytest.mark.parametrize("force", [-0.5])
def test_a_constant_force_holds_the_pitch_of_the_closed_form(force: float) -> None:
    height, p = 0.1, ROBOT
    weight = p.body_mass * p.gravity * p.com_height

    def moment(pitch: float) -> float:  # MgL sin ψ = −F (h cos ψ + R)
        return weight * math.sin(pitch) + force * (height * math.cos(pitch) + p.wheel_radius)

    expected = brentq(moment, -1, 1)
    body, K = Twin(ROBOT), gain(ROBOT, [0, 1, 2, 3, 5])
    x, u = body.reset().values[:6], np.zeros(2)
    for _ in range(12000):  # 12 s: the term in θ is slow to roll to the rest that it finds
        u = -K @ x
        x = body.step(u, Disturbance(force, height, 0.0)).values[:6]
    assert abs(x[1]) + abs(x[3]) < 1e-3  # at rest
    assert x[0] == pytest.approx(expected, abs=1e-4)
    assert motor_gain(p) * u.sum() == pytest.approx(-force * p.wheel_radius, rel=1e-3)


@pytest.mark.parametrize(
    ("robot", "push"),
    [
        (ROBOT.replace(wheel_friction=0.002), CALM),
        (ROBOT.replace(rolling_friction=0.01), CALM),
        (ROBOT, Disturbance(0.3, 0.1, 0.0)),
        (ROBOT, Disturbance(0.0, 0.0, 0.1)),
        (ROBOT, Disturbance(-0.2, 0.05, -0.05)),
    ],
    ids=["wheel friction", "rolling friction", "push", "slope", "push and slope"],
)
def test_loads_act_as_in_the_equations(robot: Robot, push: Disturbance) -> None:
    start, command = (0.0, 0.0, 0.0, 5.0, 0.4, 2.0), (0.5, 0.6)
    twin = coast(Twin(robot), start, command, 200, push)
    model = coast(NonlinearBody(robot), start, command, 200, push)
    scale = np.abs(model).max(axis=0)
    # First order in the time step: fall pole 7.4 1/s × 0.25 ms is 0.2 %, and an error grows e^(7.4·0.2) = 4 times.
    assert (np.abs(twin - model)[-1, :6] < 0.008 * scale[:6]).all()


def test_rolling_friction_brakes_like_mujoco_s_own_and_the_closed_form() -> None:
    # Coasting upright without a rotor or a lever, a11 θ̈ = −2τ. MuJoCo has a rolling friction of its own in contacts
    # with six directions: a torque of at most the coefficient [m] times the load of the wheel. Its start from rest at
    # the contact, slip included, takes 2 ms of the 200; twice that of the change of rate is 2 %.
    torque, seconds, first = 0.004, 0.2, 10.0
    robot = LOSSLESS.replace(com_height=1e-6, rotor_inertia=0.0)
    mass = robot.body_mass + 2 * robot.wheel_mass
    a11 = mass * robot.wheel_radius**2 + 2 * robot.wheel_inertia
    change = -2 * torque / a11 * seconds
    ours = coast(Twin(robot.replace(rolling_friction=torque)), (0, 0, 0, first, 0, 0), (0, 0), round(seconds / 0.001))
    text = mjcf(robot, timestep=0.00025, contact_time=0.0005, grip=10.0)
    coefficient = torque / (mass * robot.gravity / 2)
    model = mujoco.MjModel.from_xml_string(
        text.replace('condim="3" friction="10.0 0 0"', f'condim="6" friction="10.0 0 {coefficient}"')
    )
    data = mujoco.MjData(model)
    data.qvel[0], data.qvel[6:8] = robot.wheel_radius * first, first
    mujoco.mj_step(model, data, round(seconds / 0.00025))
    theirs = (data.qvel[6] + data.qvel[7]) / 2 + data.qvel[4]
    assert ours[-1, 3] - first == pytest.approx(change, rel=0.02)
    assert theirs - first == pytest.approx(change, rel=0.02)


def test_dry_friction_holds_a_wheel_up_to_its_torque() -> None:
    # Locked to the body by dry friction, the wheels do not turn against it below τ_c and do above.
    robot = ROBOT.replace(coulomb_friction=0.01)
    volts = 0.01 / motor_gain(robot)
    below = coast(Twin(robot), REST, (0.9 * volts, 0.9 * volts), 20)[-1, 6]
    above = coast(Twin(robot), REST, (1.5 * volts, 1.5 * volts), 20)[-1, 6]
    assert abs(below) < 0.01 * abs(above)


def test_sensors_read_what_they_are_called() -> None:
    body = Twin(ROBOT)
    rows = coast(body, (0.05, 0, 0, 2, 0, 1), (0.5, 0.9), 150)
    pitch, rate, wheel, yaw = rows[:, 0], rows[:, 1], rows[:, 2], rows[:, 4]
    turn = ROBOT.track / (2 * ROBOT.wheel_radius) * yaw
    # Slip of the contact, 2/contact_time fast, lets the wheels' turn and the yaw part by well under a milliradian.
    np.testing.assert_allclose(rows[:, 6], wheel - turn - pitch, atol=1e-3)
    np.testing.assert_allclose(rows[:, 7], wheel + turn - pitch, atol=1e-3)
    np.testing.assert_allclose(
        rows[:, 8], rate, atol=1e-9
    )  # the gyro is MuJoCo's, the rate is read from its velocities
    np.testing.assert_array_equal(rows[:, 9], yaw)
    slope = np.gradient(pitch, 0.001)[20:-1]  # after the 95 1/s pole has died out
    # Pitch is stepped with the new rate, a shift of half a time step: |ψ̈| · 0.25 ms / 2 with ψ̈ up to 50 rad/s².
    np.testing.assert_allclose(rows[20:-1, 8], slope, atol=0.0065)


def test_the_accelerometer_reads_gravity_at_rest_and_the_model_in_motion() -> None:
    np.testing.assert_allclose(Twin(ROBOT).reset().values[10:], [0, 9.81], atol=1e-6)  # the settled contact's residue
    start = (0.2, 0.5, 0.0, 3.0, 0.7, 1.0)
    twin, model = Twin(ROBOT).reset(start).values, NonlinearBody(ROBOT).reset(start).values
    np.testing.assert_allclose(twin, model, rtol=0.01, atol=1e-9)  # 1 %: the contact lags by 0.25 ms of 7 to 240 1/s


def test_the_right_wheel_turns_the_robot_anticlockwise_and_yaw_is_unwrapped() -> None:
    rows = coast(Twin(ROBOT), (0, 0, 0, 0, 3.0, 6), (-0.2, 1.6), 200)
    assert rows[-1, 4] > math.pi  # past the cut, still counting up
    assert (np.abs(np.diff(rows[:, 4])) < 0.1).all()


def test_wheels_start_without_a_bounce() -> None:
    for start in (REST, (0.2, 0, 0, 3, 0, 1)):
        body = Twin(ROBOT)
        body.reset(start)
        heights = [float(body._data.qpos[2])]
        for _ in range(20):
            body.step((0, 0))
            heights.append(float(body._data.qpos[2]))
        assert np.ptp(heights) < 1e-6  # a micrometre, of a wheel of 40 mm
    body.reset()
    body.step((0, 0))
    assert np.abs(body._data.qvel).max() < 1e-9  # upright and at rest it stays exactly so


def test_any_state_can_be_set_and_read_back() -> None:
    start = (0.3, -0.4, 5.0, 2.0, 9.0, -1.5)  # yaw beyond a turn too
    np.testing.assert_allclose(Twin(ROBOT).reset(start).values[:6], start, atol=1e-12)


def test_the_same_run_twice_is_the_same() -> None:
    body, push = Twin(ROBOT), Disturbance(0.2, 0.1, 0.02)
    first = coast(body, (0.1, 0, 0, 0, 0, 0), (1, 2), 50, push)
    np.testing.assert_array_equal(coast(body, (0.1, 0, 0, 0, 0, 0), (1, 2), 50, push), first)
    np.testing.assert_array_equal(coast(Twin(ROBOT), (0.1, 0, 0, 0, 0, 0), (1, 2), 50, push), first)


def test_a_fallen_robot_lies_on_the_floor_and_physics_goes_on() -> None:
    body = Twin(ROBOT)
    body.reset((0.5, 0, 0, 0, 0, 0))
    samples = [body.step((0, 0)) for _ in range(3000)]
    assert samples[-1].fallen
    assert not samples[0].fallen
    assert abs(samples[-1].values[1]) < 0.01  # lies still
    assert 1.4 < samples[-1].values[0] < 2.2  # on its face: about π/2, and somewhat beyond for a top-heavy box


@pytest.mark.parametrize("path", PRESETS, ids=lambda path: path.stem)
def test_every_preset_stands_and_falls_in_the_twin_as_in_the_model(path: Path) -> None:
    robot = Robot.load(path)
    start = (0.05, 0.0, 0.0, 0.0, 0.0, 0.0)
    twin = coast(Twin(robot), start, (0, 0), 100)[-1, 0]
    model = coast(NonlinearBody(robot), start, (0, 0), 100)[-1, 0]
    tolerance = 0.1 if robot.coulomb_friction else 0.005  # the model smooths dry friction, MuJoCo does not
    assert twin == pytest.approx(model, rel=tolerance)


def test_what_does_not_fit_is_refused_in_one_line() -> None:
    refused = [
        (lambda: Twin(ROBOT, period=0.001, timestep=0.0003), InvalidScenario),
        (lambda: Twin(ROBOT, period=-1.0), InvalidScenario),
        (lambda: Twin(ROBOT, timestep=0.0), InvalidScenario),
        (lambda: Twin(ROBOT, contact_time=0.0001), InvalidScenario),
        (lambda: Twin(ROBOT, grip=math.nan), InvalidScenario),
        (lambda: Twin(ROBOT.replace(wheel_inertia=2e-3)), InvalidRobot),
        (lambda: Twin(ROBOT).step((math.nan, 0.0)), SpecMismatch),
        (lambda: Twin(ROBOT).step((0.0,)), SpecMismatch),
        (lambda: Twin(ROBOT).step((0.0, 0.0), Disturbance(math.inf, 0.0, 0.0)), SpecMismatch),
        (lambda: Twin(ROBOT).step((1e12, 1e12)), UprightError),
    ]
    for action, error in refused:
        with pytest.raises(error) as caught:
            action()
        assert "\n" not in str(caught.value)


def test_motion_without_bounds_is_an_error_not_a_number(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)  # MuJoCo writes its own log file into the working directory
    body = Twin(LOSSLESS)
    body.reset((0.1, 0, 0, 0, 0, 0))
    command = (0.9 * body._wildest, -0.9 * body._wildest)
    with pytest.raises(UprightError, match="unstable"):
        deque((body.step(command) for _ in range(2000)), maxlen=0)


def test_a_name_cannot_break_the_model_file() -> None:
    robot = ROBOT.replace()
    object.__setattr__(robot, "name", 'a <"b"> & c')  # past the check of names: the printer escapes by itself
    text = mjcf(robot, timestep=0.001, contact_time=0.002, grip=1.0)
    assert "a &lt;&quot;b&quot;> &amp; c" in text
    Twin(robot)


def test_an_unstable_twin_leaves_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    twin = Twin(Robot.preset("nxtway-gs"))
    with pytest.raises(UprightError, match="unstable"):
        twin.step((0.0, 0.0), Disturbance(9e11, 0.05, 0.0))
    assert list(tmp_path.iterdir()) == []
