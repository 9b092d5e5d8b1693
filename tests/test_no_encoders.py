"""A robot without encoders: what its sensors show is estimated and regulated, the rest is left alone and said."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import solve_discrete_are
from scipy.signal import cont2discrete

from upright.certification.checks import PushTrial
from upright.certification.design import design
from upright.certification.verdict import AMBER, Examined, judge, linear_margins
from upright.control import CONTROLLERS, Controller, make_controller
from upright.control.delay import RAW, readable, sampled
from upright.control.kalman import kalman_filter
from upright.control.law import near_rest
from upright.control.linear_controller import LinearController
from upright.control.lqg import lqg
from upright.control.lqr import lqr, lqr_state
from upright.control.observed import observed
from upright.control.riccati import LARGEST_COMMAND, LARGEST_STATE
from upright.control.state_space import controller_of
from upright.control.tunable import TUNABLE
from upright.errors import DesignFailed, SpecMismatch, UprightError
from upright.excitation.loop import ExcitedLoop
from upright.loops.analysis import analyse
from upright.loops.loop import robot_loop
from upright.physics.linear import linearise_rolling
from upright.robots import Battery, Kit, Robot, Sensor
from upright.tuning.tune import tune

# an acrylic Arduino robot with TT motors, as owners describe it
ROBOT = Robot(
    name="acrylic", wheel_mass=0.035, wheel_radius=0.0325, wheel_inertia=2.5e-5, body_mass=0.65, track=0.15,
    body_depth=0.06, body_height=0.17, com_height=0.07, pitch_inertia=0.0018, yaw_inertia=0.0012, roll_inertia=0.002,
    rotor_inertia=5e-4, gear_ratio=1.0, motor_resistance=5.0, back_emf=0.3, torque_constant=0.2, motor_friction=5e-4,
    wheel_friction=0.0,
)  # fmt: skip
GYRO, ANGLE = Sensor(noise=0.002, bias=0.01), Sensor(noise=0.002, time_constant=0.5)
FUSED = Kit(name="mpu", period=0.01, battery=Battery(voltage=7.4), sensors={"sensor/gyro": GYRO, "sensor/pitch": ANGLE})
RAW_IMU = replace(FUSED, sensors={"sensor/gyro": GYRO, "sensor/accel_forward": Sensor(noise=0.05)})
ALONE = replace(FUSED, sensors={"sensor/gyro": GYRO})
KITS = {"fused": FUSED, "accelerometer": RAW_IMU, "gyro": ALONE}
METHODS = ["lqr", "lqg", "mpc", "sliding"]


def simulated(controller: Controller, *, knock: float, bias: float, seconds: float) -> np.ndarray:
    """Pitch (n,) of `ROBOT` after a `knock` [rad/s] at 1 s, by its equations of motion in the plane,
    integrated here; the sensors' noise and filters are made here too."""
    p = ROBOT
    gain = p.torque_constant / p.motor_resistance
    drag = gain * p.back_emf + p.motor_friction
    lever = p.body_mass * p.com_height * p.wheel_radius
    weight = p.body_mass * p.gravity * p.com_height
    a11 = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia + 2 * p.rotor_inertia
    a22 = p.body_mass * p.com_height**2 + p.pitch_inertia + 2 * p.rotor_inertia
    rng = np.random.default_rng(7)
    pitch = fused = 0.02
    rate = speed = along = 0.0
    h = 1e-3
    path: list[float] = []
    controller.reset()
    for k in range(round(seconds / 0.01)):
        noise = rng.standard_normal(3)
        shown = {
            "sensor/gyro": rate + bias + 0.002 * noise[0], "sensor/pitch": fused + 0.002 * noise[1],
            "sensor/accel_forward": along + 0.05 * noise[2],
        }  # fmt: skip
        u = controller.step(np.array([shown[name] for name in controller.spec.reads]), np.zeros(6))
        volts = [min(max(one, -7.4), 7.4) for one in u]
        controller.applied(volts)
        rate += knock if k == 100 else 0.0
        for _ in range(10):
            torque = gain * sum(volts) - 2 * drag * (speed - rate)
            a12 = lever * math.cos(pitch) - 2 * p.rotor_inertia
            on_wheel, on_body = torque + lever * rate**2 * math.sin(pitch), weight * math.sin(pitch) - torque
            determinant = a11 * a22 - a12**2
            speeding = (a22 * on_wheel - a12 * on_body) / determinant
            falling = (a11 * on_body - a12 * on_wheel) / determinant
            along = p.wheel_radius * speeding * math.cos(pitch) - p.gravity * math.sin(pitch)
            fused += h * (rate + (-along / p.gravity - fused) / 0.5)
            speed += h * speeding
            rate += h * falling
            pitch += h * rate
        path.append(pitch)
        if abs(pitch) > 1:
            break
    return np.array(path)


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("kit", KITS)
def test_it_stands_after_a_knock(kit, method):
    controller = make_controller(method, ROBOT, KITS[kit], 0.01)
    path = simulated(controller, knock=0.4, bias=0.005, seconds=12)
    assert len(path) == 1200
    assert np.abs(path[-200:]).max() < 0.03  # the lean that a bias of 0.005 rad/s and the noise leave


@pytest.mark.parametrize("kit", KITS)
def test_the_regulator_is_that_of_what_is_shown(kit):
    # the wheels' speed shows by its back-EMF; their angle, the heading and its rate move nothing that is read
    model = linearise_rolling(ROBOT)
    kept = [0, 1, 3]
    A, B, *_ = cont2discrete((model.A, model.B, np.eye(6), np.zeros((6, 2))), 0.01)
    A, B = A[np.ix_(kept, kept)], B[kept]
    Q, R = np.diag(1 / np.array(LARGEST_STATE)[kept] ** 2), np.eye(2) / LARGEST_COMMAND["V"] ** 2
    P = solve_discrete_are(A, B, Q, R)
    K = np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)
    gain = lqr(ROBOT, KITS[kit], 0.01).design.gain
    np.testing.assert_allclose(gain[:, kept], K, rtol=1e-6)
    assert not gain[:, [2, 4, 5]].any()


def test_poles_are_those_of_the_whole_loop_but_for_the_free_ones():
    controller = lqg(ROBOT, RAW_IMU)
    found = analyse(controller, ROBOT, RAW_IMU, robots=[])
    # the loop with all six states and the command that the accelerometer shows, closed by NumPy
    model = linearise_rolling(ROBOT)
    A, B, *_ = cont2discrete((model.A, model.B, np.eye(6), np.zeros((6, 2))), 0.01)
    forward = np.eye(6)[0] * -ROBOT.gravity + ROBOT.wheel_radius * model.A[3]
    C = np.vstack([forward, np.eye(6)[1]])
    D = np.vstack([ROBOT.wheel_radius * model.B[3], np.zeros(2)])  # of the command before this reading
    K = controller_of(near_rest(controller), 0)
    plant = np.block([[A, np.zeros((6, 2))], [np.zeros((2, 8))]])
    enters = np.vstack([B, np.eye(2)])
    seen = np.hstack([C, D])
    whole = np.block([[plant + enters @ K.D @ seen, enters @ K.C], [K.B @ seen, K.A]])
    turning = math.exp(0.01 * float(model.A[5, 5]))
    expected = np.sort(np.abs([*found.poles, 1.0, 1.0, turning]))
    # the plant of the analysis remembers the accelerometer's reading, not both commands: one pole at zero less
    np.testing.assert_allclose(np.sort(np.abs(np.linalg.eigvals(whole)))[-len(expected) :], expected, atol=2e-5)
    assert found.stable
    assert found.loop.hidden == ("wheel", "yaw", "yaw_rate")
    said = "nothing holds the wheels where they are: the robot stands, and may roll away"
    assert found.page().verdict.text.template == "stable, but may roll away"
    margins = linear_margins(controller, ROBOT, RAW_IMU)
    assert margins is not None
    assert (margins.stable, margins.free) == (True, True)
    trial = PushTrial("hold", "low", 1000, 0, saturated=0.0, travel=0.2, peak=0.1, cycle=0.01)
    light, reasons = judge(Examined(1000, 0, margins, [trial], 0.01))
    assert light == AMBER
    assert str(reasons[0]).lower().startswith(said)


def test_a_push_is_estimated_where_it_can_be_told_from_a_lean():
    # Hautus: a lean of zero rate whose gravity a push balances is another steady motion with the same gyro reading
    for kit, told in ((FUSED, True), (RAW_IMU, True), (ALONE, False)):
        assert ("push" in kalman_filter(sampled(ROBOT, kit)).sampled.linear.states) == told


def test_wheels_without_back_emf_or_friction_show_nothing_of_their_speed():
    free = Robot.preset("twipr").replace(motor_friction=0.0, wheel_friction=0.0).without_dry_friction()
    model = sampled(free, replace(FUSED, battery=Battery()), 0.01)
    assert model.hidden == (("wheel", "wheel_rate", "yaw", "yaw_rate") if free.drive == "torque" else ("wheel",))


def test_what_a_kit_shows_is_read():
    assert readable(Kit.preset("nxt")) == RAW
    assert readable(FUSED) == ("sensor/pitch", "sensor/gyro")
    assert readable(RAW_IMU) == ("sensor/accel_forward", "sensor/gyro")
    assert readable(ALONE) == ("sensor/gyro",)


@pytest.mark.parametrize("method", [name for name in CONTROLLERS if name not in (*METHODS, "lqr-state", "pid-angle")])
def test_what_needs_encoders_says_so_in_one_line(method):
    if CONTROLLERS[method].lacks:
        pytest.skip(CONTROLLERS[method].lacks)
    with pytest.raises(UprightError, match="encoder") as caught:
        make_controller(method, ROBOT, FUSED, 0.01)
    assert "\n" not in str(caught.value)


def test_and_so_do_a_plan_and_a_feedback_of_all_states():
    with pytest.raises(SpecMismatch, match="no encoders"):
        ExcitedLoop(ROBOT, FUSED, lqg(ROBOT, FUSED), 20.0)
    with pytest.raises(SpecMismatch, match="feeds back wheel"):
        observed(lqr_state(ROBOT, 0.01), ROBOT, FUSED)
    with pytest.raises(DesignFailed):
        lqg(ROBOT, replace(FUSED, sensors={"sensor/compass": Sensor()}), reads=("sensor/compass",))


def test_design_and_tune_of_a_user():
    result = design("lqr", ROBOT, FUSED)
    assert "may roll away" in str(result)
    assert "wheel" not in TUNABLE["lqr"].defaults(ROBOT, FUSED, 0.01)
    tuned = tune("lqr", ROBOT, RAW_IMU, budget=4, samples=300)
    assert set(tuned.weights) == {"pitch", "pitch_rate", "wheel_rate", "motor_noise"}


def pid_on_the_angle(kp: float, ki: float, kd: float, dt: float) -> LinearController:
    """u = kp e + ki ∫e + kd ψ̇ of both motors [V], on the angle e [rad] and the gyro."""
    one = np.ones((2, 1))
    none = np.zeros((2, 6))
    return LinearController(
        np.eye(1), np.array([[dt, 0.0]]), np.zeros((1, 6)), np.zeros((1, 2)), one * ki, one * [kp, kd], none,
        reads=("sensor/pitch", "sensor/gyro"), period=dt,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("scale", "ki", "slowest"), [(0.55, 60, [0.15, 0.0]), (1.0, 60, [0.0, -0.5]), (1.0, 0, [0.75])]
)
def test_a_pid_on_the_angle_stands_by_its_integral_and_full_motors(scale, ki, slowest):
    # an owner's gains per degree and PWM step; rates [1/s] are the eigenvalues of the plane with the integral in
    # continuous time, to two digits, which a period of 1 ms hardly changes. The zero of the plant at zero leaves a free
    # mode to any integral, a steady speed, and without one the robot always falls
    volts = math.degrees(1) * 7.4 / 255 * scale
    kit = replace(FUSED, period=0.001, sensors={"sensor/gyro": Sensor(), "sensor/pitch": Sensor()})
    loop = robot_loop(pid_on_the_angle(50 * volts, ki * volts, 1.4 * volts, 0.001), ROBOT, kit)
    rates = np.log(np.abs(loop.poles())) / 0.001
    np.testing.assert_allclose(rates[: len(slowest)], slowest, atol=0.01)
