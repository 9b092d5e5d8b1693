"""On a robot that hardly moves the predictor is a textbook Kalman filter: gains, variances and innovations."""

from __future__ import annotations

import inspect
import math

import numpy as np
import pytest
from scipy.linalg import expm, solve_discrete_are

from upright.calibration.coefficients import LEVEL, ROLLING_DRY
from upright.calibration.predictor import WIDE, Events, Noise, RobotLanes, innovations, kalman_path
from upright.compiled.generated import Constants, constants
from upright.compiled.generated_motion import rk4_free
from upright.physics.linear import linearise
from upright.robots import Robot

ROBOT = Robot.preset("nxtway-gs").replace(coulomb_friction=0.0)
SIZE = 7  # the six states and the offset of the gyro
HALF = ROBOT.track / (2 * ROBOT.wheel_radius)
C = np.zeros((3, SIZE))
C[0, [0, 2, 4]], C[1, [0, 2, 4]], C[2, [1, 6]] = (-1, 1, -HALF), (-1, 1, HALF), (1, 1)  # encoders, gyro
R = np.array([1e-6, 2e-6, 1e-4])  # [rad², rad², (rad/s)²]
LONGEST = 2e-4  # [s] of a Runge–Kutta step: its error is below 1e-8 of a state then
ROUTES = 1e-6
"""By how much of the largest the two may differ: the flow is differentiated by steps of 1e-6, which leaves 1e-9, and
cubic terms of what `SMALL` readings move are 1e-8 of it."""
SMALL = 1e-5  # [rad, rad/s, V]


def process() -> np.ndarray:
    """Process noise a second: of the motors' commands, and of the offset."""
    model = linearise(ROBOT)
    Q = np.zeros((SIZE, SIZE))
    Q[:6, :6] = 0.1 * model.B @ model.B.T + 1e-4 * np.eye(6)
    Q[6, 6] = 1e-4
    return Q


START = np.diag([1e-3, 1e-2, 1e-3, 1e-2, 1e-3, 1e-2, 1e-2])


def filtered(events: Events, delays: np.ndarray) -> tuple[np.ndarray, ...]:
    """Innovations, variances, gains and states of the predictor."""
    robot = np.array([*constants(list(ROBOT.numbers().values()), 1.0), 1.0, 1.0, 0.0, 0.0, 0.0])
    lanes = RobotLanes(*(np.repeat(a[..., None], WIDE, axis=-1) for a in (C, delays, robot)))
    noise = Noise(START, np.array([process()] * 2), 0.0, R, np.inf)
    return kalman_path(events, lanes, np.zeros(SIZE), noise, LONGEST, True)


def uneven_log(count: int = 80) -> Events:
    """Small readings on a clock that wavers, a fifth of them missing, each sensor under another command."""
    rng = np.random.default_rng(0)
    t = np.cumsum(rng.uniform(0.008, 0.012, count))
    kind, when = np.repeat(np.arange(-1, 3), count), np.tile(t, 4)
    value = np.concatenate([np.arange(count), SMALL * rng.standard_normal(3 * count)])
    kept = (kind < 0) | (rng.random(4 * count) < 0.8)
    kind, when, value = kind[kept], when[kept], value[kept]
    return Events(np.arange(0), kind, when, value, SMALL * rng.standard_normal((count, 2)))


def test_on_small_motions_it_is_a_textbook_kalman_filter() -> None:
    """x⁻ = Φ x + Γ u, P⁻ = Φ P Φᵀ + Q h, K = P⁻ Cᵀ / (C P⁻ Cᵀ + R) and Joseph's P, with Φ and Γ by the exponential of
    the linear model: delays, missing readings and an uneven clock included."""
    delays = np.array([0.0, 0.0, 0.0035])
    events = uneven_log()
    then = events.when - np.append(delays, 0.0)[events.kind]
    events = events._replace(order=np.lexsort((events.kind, then)))
    e, s, gains, states = filtered(events, delays)
    model, Q = linearise(ROBOT), process()
    x, cov, u, now = np.zeros(SIZE), START.copy(), events.commands[0], None
    for event in events.order:
        h = 0.0 if now is None else then[event] - now
        now, row = then[event], events.kind[event]
        flow = expm(h * np.block([[model.A, model.B], [np.zeros((2, 8))]]))
        phi = np.eye(SIZE)
        phi[:6, :6] = flow[:6, :6]
        x[:6] = flow[:6, :6] @ x[:6] + flow[:6, 6:] @ u
        cov = phi @ cov @ phi.T + Q * h
        if row < 0:
            u = events.commands[int(events.value[event])]
            assert np.isnan(e[event])
            assert not gains[event].any()
            continue
        c = C[row]
        S = c @ cov @ c + R[row]
        K = cov @ c / S
        innovation = events.value[event] - c @ x
        x = x + K * innovation
        left = np.eye(SIZE) - np.outer(K, c)
        cov = left @ cov @ left.T + R[row] * np.outer(K, K)
        assert s[event] == pytest.approx(S, rel=ROUTES)
        assert gains[event] == pytest.approx(K, abs=ROUTES * np.abs(K).max())
        assert e[event] == pytest.approx(innovation, abs=ROUTES * SMALL)
        assert states[event] == pytest.approx(x, abs=ROUTES * np.abs(x).max())


def test_the_steady_filter_is_that_of_the_riccati_equation() -> None:
    """After ten seconds of readings that come together, the gain of the first and the innovations' whole covariance are
    those that `scipy.linalg.solve_discrete_are` gives."""
    period, count = 0.01, 1000
    t = period * np.arange(count)
    kind, when = np.tile(np.arange(-1, 3), count), np.repeat(t, 4)
    value = np.zeros(4 * count)
    value[::4] = np.arange(count)
    _, s, gains, _ = filtered(Events(np.arange(4 * count), kind, when, value, np.zeros((count, 2))), np.zeros(3))
    phi = np.eye(SIZE)
    phi[:6, :6] = expm(period * linearise(ROBOT).A)
    P = solve_discrete_are(phi.T, C.T, process() * period, np.diag(R))
    S = C @ P @ C.T + np.diag(R)
    assert s[-3] == pytest.approx(S[0, 0], rel=ROUTES)
    assert gains[-3] == pytest.approx(P @ C[0] / S[0, 0], abs=ROUTES * np.abs(P @ C[0] / S[0, 0]).max())
    assert np.prod(s[-3:]) == pytest.approx(np.linalg.det(S), rel=3 * ROUTES)  # one after the other or all at once


def test_what_is_estimated_is_what_a_level_floor_shows() -> None:
    """The constants with an error of their own are those that the generated step takes, the track that tells the wheels
    apart, the dry friction that the predictor makes sharp, and the rate below which rolling friction is smooth."""
    taken = set(inspect.signature(rk4_free.py_func).parameters) & set(Constants._fields)
    beside = {"half_track", "coulomb_torque", "stiction_rate_squared"}
    assert {Constants._fields[i] for i in (*LEVEL, *ROLLING_DRY)} == taken | beside


def test_the_flow_of_wheels_that_stick_is_smooth() -> None:
    """Held by dry friction, body and wheels are one: a pitch rate or a wheel rate is shared by both after the step, and
    a yaw rate is gone. Rolling friction changes that by its own slope at rest alone, 2τ_w/(a ω_c) h = 0.02."""
    robot = Robot.preset("twipr").replace(rolling_friction=0.001)
    numbers = np.array([*constants(list(robot.numbers().values()), 1.0), 1.0, 1.0, 0.0, 0.0, 0.0])
    pitch_rate = np.repeat(np.eye(SIZE)[[1]], 3, axis=0)  # is what each reading is of
    lanes = RobotLanes(*(np.repeat(a[..., None], WIDE, axis=-1) for a in (pitch_rate, np.zeros(3), numbers)))
    events = Events(np.arange(2), np.array([-1, 2]), np.array([0.0, 0.004]), np.zeros(2), np.full((1, 2), 0.002))

    def answers(state: int) -> np.ndarray:
        """What pitch rate and wheel rate make of one in `state`, times what the pitch rate makes of it: the filter that
        is unsure of that state alone has just this between them."""
        noise = Noise(np.diag(np.eye(SIZE)[state]), np.zeros((2, SIZE, SIZE)), 0.0, R, np.inf)
        _, s, gains, _ = kalman_path(events, lanes, np.zeros(SIZE), noise, 0.004, True)
        return gains[1, [1, 3]] * s[1]

    (body, of_body), (wheels, of_wheels), turn = (answers(state) for state in (1, 3, 5))
    assert (of_body, of_wheels) == pytest.approx((body, wheels), abs=1e-4)  # one motion
    assert math.sqrt(body) + math.sqrt(wheels) == pytest.approx(1.0, abs=0.03)
    assert min(body, wheels) > 0.01
    assert np.abs(turn).max() < 1e-6


def test_innovations_at_the_filter_s_gains_are_the_filter_s() -> None:
    """Lanes that are corrected by given gains do what the filter did that gave these gains, whatever the company."""
    delays = np.array([0.0, 0.0, 0.0035])
    events = uneven_log()
    events = events._replace(order=np.lexsort((events.kind, events.when - np.append(delays, 0.0)[events.kind])))
    e, _, gains, _ = filtered(events, delays)
    robot = np.array([*constants(list(ROBOT.numbers().values()), 1.0), 1.0, 1.0, 0.0, 0.0, 0.0])
    lanes = RobotLanes(*(np.repeat(a[..., None], 3, axis=-1) for a in (C, delays, robot)))
    lanes.robots[-3, 2] = 1.1  # a neighbour whose left motor is stronger
    alone = innovations(events, lanes, np.zeros((SIZE, 3)), gains, LONGEST)
    readings = events.kind >= 0
    assert alone[readings, 0] == pytest.approx(e[readings], abs=1e-12 * np.abs(e[readings]).max())
    assert np.array_equal(alone[readings, 0], alone[readings, 1])
    assert np.abs(alone[readings, 2] - e[readings]).max() > 1e-3 * np.abs(e[readings]).max()
