"""A fused angle's filter and a gyro's resonance, between a motion and its reading, are part of the linear loop."""

import math
from dataclasses import replace

import control
import numpy as np
import pytest

from upright.bodies import Electronics, make_body
from upright.control.delay import sampled
from upright.control.kalman import kalman_filter
from upright.control.lqg import lqg
from upright.control.state_space import plant_of
from upright.loops.analysis import analyse
from upright.physics.linear import linearise, linearise_rolling
from upright.physics.sensing import sensed
from upright.robots import Kit, Robot, Sensor

NXT = Robot.preset("nxtway-gs")
TAU, HERTZ, ZETA, TILT = 0.4, 6.0, 0.15, 0.1
SWINGING = Sensor(resonance=HERTZ, damping=ZETA, misalignment=TILT)
FUSED = Sensor(time_constant=TAU)
PROMPT = Kit(name="prompt", period=0.01, sensors={"sensor/gyro": SWINGING, "sensor/pitch": FUSED})


def transfer(state: str, side: int) -> control.TransferFunction:
    """From one motor to a state of the robot, by python-control alone."""
    model = linearise_rolling(NXT)
    row = np.eye(6)[model.states.index(state)][None]
    # the wheels' angle and the heading, which nothing here reads, are integrators whose poles would be cancelled
    keep = [i for i, name in enumerate(model.states) if name not in ("wheel", "yaw")]
    return control.ss2tf(model.A[np.ix_(keep, keep)], model.B[keep][:, [side]], row[:, keep], [[0.0]])


def shown(side: int) -> dict[str, control.TransferFunction]:
    """The transfer functions to both sensors, by the definitions of their filters."""
    s = control.tf("s")
    lean, wheel_rate, turn = (transfer(state, side) for state in ("pitch", "wheel_rate", "yaw_rate"))
    gravity = lean - NXT.wheel_radius / NXT.gravity * s * wheel_rate
    omega = 2 * math.pi * HERTZ
    gyro = omega**2 / (s**2 + 2 * ZETA * omega * s + omega**2) * s * lean + TILT * turn
    return {"sensor/pitch": (TAU * gyro + gravity) / (TAU * s + 1), "sensor/gyro": gyro}


@pytest.mark.parametrize("name", ["sensor/pitch", "sensor/gyro"])
@pytest.mark.parametrize("side", [0, 1])
def test_a_reading_answers_a_command_as_python_control_says(name, side):
    omega = np.geomspace(0.1, 300, 40)
    reads = ("sensor/pitch", "sensor/gyro")
    continuous, _ = sensed(linearise_rolling(NXT), reads, NXT, PROMPT.sensors)
    expected = shown(side)[name](1j * omega)
    ours = continuous.response(omega)[reads.index(name), side]
    # transfer functions of order six in polynomials lose some ten digits
    np.testing.assert_allclose(ours, expected, rtol=1e-6)


@pytest.mark.parametrize("name", ["sensor/pitch", "sensor/gyro"])
def test_and_so_it_does_once_a_period(name):
    omega = np.geomspace(0.5, 300, 30)
    plant = plant_of(sampled(NXT, PROMPT, 0.01, (name,)))
    held = control.sample_system(control.ss(control.minreal(shown(0)[name], 1e-6, verbose=False)), 0.01, "zoh")
    np.testing.assert_allclose(plant.response(omega)[0, 0], held(np.exp(1j * omega * 0.01)), rtol=1e-4)


def slopes(x: np.ndarray, u: np.ndarray, force: float) -> tuple[np.ndarray, float]:
    """ẋ of [the six states, fused angle, swing, its rate], and what the accelerometer reads along the body."""
    model = linearise(NXT)
    moved = model.A @ x[:6] + model.B @ u + (model.E[:, 0] + NXT.com_height * model.E[:, 1]) * force
    along = NXT.wheel_radius * moved[3] - NXT.gravity * x[0]
    omega = 2 * math.pi * HERTZ
    fused = x[7] + TILT * x[5] + (-along / NXT.gravity - x[6]) / TAU
    swung = omega**2 * (x[1] - x[7]) - 2 * ZETA * omega * x[8]
    return np.array([*moved, fused, x[8], swung]), along


def flown(x: np.ndarray, u: np.ndarray, force: float, seconds: float) -> np.ndarray:
    """By Runge and Kutta's fourth order, in steps of at most 0.1 ms."""
    steps = max(1, round(seconds / 1e-4))
    h = seconds / steps
    for _ in range(steps):
        k1 = slopes(x, u, force)[0]
        k2 = slopes(x + h / 2 * k1, u, force)[0]
        k3 = slopes(x + h / 2 * k2, u, force)[0]
        x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + slopes(x + h * k3, u, force)[0])
    return x


def test_commands_and_pushes_reach_every_reading_after_dead_time_and_delays():
    # commands act after 0.3 of a period; readings are 0, 0.4 and 1 period late; the push is constant in a period
    dt, dead, late = 0.01, 0.003, 0.004
    sensors = {
        "sensor/pitch": replace(FUSED, delay=late), "sensor/gyro": replace(SWINGING, delay=dt),
        "sensor/accel_forward": Sensor(),
    }  # fmt: skip
    kit = Kit(name="late", period=dt, delay=dead, sensors=sensors)
    model = sampled(NXT, kit, dt, tuple(sensors))
    rng = np.random.default_rng(2015)
    p = np.zeros(len(model.linear.A))
    x = np.zeros(9)
    before = np.zeros(2)
    gyro, worst = 0.0, 0.0
    for _ in range(30):
        u, force = rng.normal(size=2), float(rng.normal())
        p = model.linear.A @ p + model.linear.B @ [*u, *before] + model.linear.E[:, 0] * force
        x = flown(x, before, force, dead)
        x = flown(x, u, force, dt - late - dead)
        pitch = x[6]
        x = flown(x, u, force, late)
        expected = np.array([pitch, gyro, slopes(x, u, force)[1]])
        gyro, before = x[7] + TILT * x[5], u
        worst = max(worst, float(np.abs(model.linear.C @ p - expected).max()))
    # Runge and Kutta's error (h⁴) in 0.3 s; readings are of the order of 1 to 10
    assert worst < 1e-7


def test_a_swing_of_the_gyro_is_seen_by_margins_and_filter():
    # a filter at 6 Hz delays by 2ζ/ω = 8 ms at low frequency; who knows it keeps the margins that who does not loses
    kit = Kit.preset("nxt")
    gyro = replace(kit.sensors["sensor/gyro"], resonance=6.0, damping=0.7)
    swinging = replace(kit, sensors=kit.sensors | {"sensor/gyro": gyro})
    unaware = analyse(lqg(NXT, kit), NXT, swinging, robots=[])
    aware = analyse(lqg(NXT, swinging), NXT, swinging, robots=[])
    assert unaware.delay < aware.delay
    assert unaware.disk < aware.disk
    estimator = kalman_filter(sampled(NXT, swinging))
    assert {"sensor/gyro@swing", "sensor/gyro@swing_rate"} <= set(estimator.sampled.linear.states)
    assert estimator.check() < 1e-9


def test_readings_of_a_small_motion_are_those_of_the_linear_model():
    robot = Robot.preset("nxtway-gs").without_dry_friction()
    sensors = {
        "sensor/pitch": Sensor(time_constant=0.4, delay=0.004),
        "sensor/gyro": Sensor(resonance=6.0, damping=0.2, misalignment=0.1),
        "sensor/accel_forward": Sensor(), "sensor/encoder_left": Sensor(delay=0.01),
    }  # fmt: skip
    kit = Kit(name="filtered", period=0.01, delay=0.003, sensors=sensors)
    model = sampled(robot, kit, 0.01, tuple(sensors))
    body = Electronics(make_body("nonlinear", robot), kit)
    names = [channel.name for channel in body.spec.channels]
    rng = np.random.default_rng(0)
    body.reset()
    p = np.zeros(len(model.linear.A))
    before = np.zeros(2)
    rows: list[tuple[np.ndarray, np.ndarray]] = []
    for _ in range(20):
        u = 0.05 * rng.normal(size=2)
        for _ in range(round(0.01 / body.spec.period)):
            sample = body.step(u)
        p = model.linear.A @ p + model.linear.B @ [*u, *before]
        before = u
        rows.append((np.array([sample.numbers[names.index(name)] for name in sensors]), model.linear.C @ p))
    shown, expected = (np.array(column) for column in zip(*rows, strict=True))
    off = np.abs(shown - expected).max(axis=0) / np.abs(expected).max(axis=0)
    # the angle's filter takes steps of 1 ms with the specific force at their ends, half a step late; the gyro's takes a
    # rate as straight over each; the rest is what is not linear of a lean of a milliradian
    assert (off < [0.1, 2e-3, 1e-3, 1e-4]).all(), off
