"""Linearisation, discretisation, integration and energy against closed forms and independent routes."""

import cmath
import math
import re
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.integrate import quad_vec, solve_ivp
from scipy.linalg import expm

from upright.bodies import NonlinearBody
from upright.control import lqr_state
from upright.errors import InvalidModel, InvalidRobot, SpecMismatch
from upright.experiment.standup import lift
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.physics.dynamics import Disturbance, derivative, mass_matrix, turn_ratio
from upright.physics.integrate import PREDICTED, SIMULATED, rk4_step
from upright.physics.linear import LinearModel, delay_line, linearise
from upright.physics.sensing import readings, sensor_matrix
from upright.physics.steps import substeps
from upright.robots import PARAMETERS, Kit, Robot
from upright.signals import STATE_NAMES

NXT = Robot.preset("nxtway-gs")
KIT = Kit.preset("nxt")
LOSSLESS = NXT.replace(back_emf=0.0, motor_friction=0.0)


def test_poles_of_nxtway_gs_are_the_published_ones():
    # docs/model.md: 0, −241.19, 7.437, −6.520 1/s (and the yaw pair); half a unit of the last printed digit
    poles = np.sort(linearise(NXT, model="published").poles().real)
    for pole, digits in ((-241.19, 0.005), (-6.520, 0.0005), (0.0, 1e-9), (7.437, 0.0005)):
        assert np.abs(poles - pole).min() <= digits


@pytest.mark.parametrize("x", [(0,) * 6, (0.3, 1.0, 0.0, 4.0, 0.5, 3.0)])
def test_linearisation_is_the_derivative_of_the_dynamics(x):
    # central differences: error h²/6·f''' + ε/h ≈ 1e-9 of the largest slope for h = 1e-5
    model, h = linearise(NXT, x, (1.0, -0.5)), 1e-5
    for i in range(6):
        up, down = list(x), list(x)
        up[i] += h
        down[i] -= h
        slope = (np.array(derivative(up, (1.0, -0.5), NXT)) - derivative(down, (1.0, -0.5), NXT)) / (2 * h)
        assert np.allclose(model.A[:, i], slope, rtol=1e-6, atol=1e-8 * np.abs(model.A).max())


def test_disturbance_columns_are_what_a_small_push_does():
    model, small = linearise(NXT), 1e-6
    pushed = np.array(derivative((0,) * 6, (0, 0), NXT, Disturbance(small, 0.05))) / small
    assert np.allclose(model.E @ [1.0, 0.05, 0.0], pushed, rtol=1e-9)  # upright the push enters linearly
    sloped = np.array(derivative((0,) * 6, (0, 0), NXT, Disturbance(slope=small))) / small
    assert np.allclose(model.E @ [0.0, 0.0, 1.0], sloped, rtol=1e-9)  # sin γ = γ − γ³/6: relative error 2e-13


def test_zero_order_hold_is_the_matrix_exponential_and_its_integral():
    # the integral ∫ e^{As} ds B by quadrature is a route that shares nothing with the augmented exponential
    model = linearise(NXT)
    held = model.c2d(0.01)
    integral = quad_vec(lambda s: expm(model.A * s), 0, 0.01, epsrel=1e-12)[0]
    assert np.allclose(held.A, expm(model.A * 0.01), rtol=1e-12, atol=1e-13)
    assert np.allclose(held.B, integral @ model.B, rtol=1e-9, atol=1e-12)
    assert np.allclose(held.E, integral @ model.E, rtol=1e-9, atol=1e-12)


def test_operating_point_that_is_no_equilibrium_keeps_its_drift():
    x = (0.0, 0.0, 0.0, 5.0, 0.0, 0.0)  # rolling on without voltage: back-EMF brakes
    model = linearise(NXT, x)
    exact = solve_ivp(lambda _t, y: derivative(y, (0, 0), NXT), (0, 1e-3), x, rtol=1e-10, atol=1e-12).y[:, -1]
    moved = exact - x
    # over 1 ms the curvature left out is of the order of pitch² ~ 1e-6 of the motion
    assert np.allclose(model.c2d(1e-3).next(x, (0, 0)) - x, moved, rtol=1e-3, atol=1e-6)


def test_converts_to_and_from_control():
    control = pytest.importorskip("control")
    model = linearise(NXT).c2d(0.01)
    system = model.to_control()
    back = LinearModel.from_control(system)
    assert isinstance(system, control.StateSpace)
    assert np.array_equal(back.A, model.A)
    assert np.array_equal(back.B, model.B)
    assert (back.dt, back.states, back.inputs) == (model.dt, model.states, model.inputs)


@pytest.mark.needs("module:control")
def test_a_linear_model_computes_as_python_control_does():
    # an independent route: poles, response and a series connection, with a direct path, in both times
    control = pytest.importorskip("control")
    rng = np.random.default_rng(4)
    for dt in (0, 0.1):
        first, second = (control.rss(n, 2, 2, dt=dt) if dt == 0 else control.drss(n, 2, 2, dt=dt) for n in (3, 2))
        first.D = rng.normal(size=(2, 2))
        ours = LinearModel.from_control(second) * LinearModel.from_control(first)
        theirs = second * first
        w = np.array([0.1, 1.0, 7.0])
        assert np.allclose(ours.response(w), theirs.frequency_response(w).frdata, atol=1e-9)
        assert np.allclose(ours.matrices(w), [theirs(1j * x if dt == 0 else np.exp(1j * x * dt)) for x in w], atol=1e-9)
        assert np.allclose(np.sort_complex(ours.poles()), np.sort_complex(theirs.poles()), atol=1e-6)
        assert ours.stable
        assert (ours.dt, ours.inputs) == (dt, tuple(first.input_labels))
    with pytest.raises(InvalidModel, match="in one loop"):
        LinearModel.gain([[1.0]], 0.1) * LinearModel.gain([[1.0]])


@pytest.mark.parametrize("periods", [0, 1, 3])
def test_a_delay_line_is_a_power_of_the_shift(periods):
    # e^{−jωk dt}: the definition of k periods of delay, whatever the model behind it
    model = LinearModel(linearise(NXT).c2d(0.01).A * 0.9, linearise(NXT).c2d(0.01).B, dt=0.01)
    w = np.array([0.3, 30.0, 200.0])
    expected = np.exp(-1j * w * periods * 0.01) * model.response(w)
    assert np.allclose((model * delay_line(2, periods, 0.01)).response(w), expected, rtol=1e-9, atol=1e-12)


def test_mixing_continuous_and_discrete_is_refused():
    model = linearise(NXT)
    with pytest.raises(InvalidModel, match="discrete already"):
        model.c2d(0.01).c2d(0.01)
    with pytest.raises(InvalidModel, match="c2d"):
        model.next([0] * 6, [0, 0])


def test_model_survives_json_and_is_read_only():
    model = linearise(NXT).c2d(0.01)
    assert np.array_equal(LinearModel.from_json(model.to_json()).E, model.E)
    with pytest.raises(ValueError, match="read-only"):
        model.A[0, 0] = 1
    old = linearise(NXT).to_json() | {"dt": None}  # as files were written before models had outputs
    del old["C"], old["D"], old["outputs"]
    back = LinearModel.from_json(old)
    assert (back.continuous, back.outputs) == (True, back.states)
    assert np.array_equal(back.C, np.eye(6))


@pytest.mark.parametrize(("inputs", "names"), [(1, ("u[0]",)), (2, ("left", "right")), (3, ("u[0]", "u[1]", "u[2]"))])
def test_six_states_with_two_inputs_are_those_of_the_robot(inputs, names):
    """Other numbers of inputs are named as python-control names them."""
    model = LinearModel(np.zeros((6, 6)), np.zeros((6, inputs)))
    assert model.states == STATE_NAMES
    assert model.inputs == names


def test_wrong_sizes_are_named():
    with pytest.raises(InvalidModel, match=r"B has shape \(2, 6\).*transpose"):
        LinearModel(np.eye(6), np.zeros((2, 6)))


def test_the_sensor_matrix_is_the_slope_of_the_readings():
    # the readings are linear in the state but for the accelerometer, so that one step in each state gives the matrix;
    # a rate of an encoder reads the rates as its angle reads the angles
    names = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "sensor/compass")
    turn = turn_ratio(NXT)
    slopes = np.array([readings(row, 0.0, NXT)[:4] for row in np.eye(6)]).T
    assert np.allclose(sensor_matrix(names, turn), slopes)
    rates = sensor_matrix(("sensor/encoder_rate_left", "sensor/encoder_rate_right"), turn)
    assert np.allclose(rates[:, [1, 3, 5]], slopes[:2][:, [0, 2, 4]])
    assert not rates[:, [0, 2, 4]].any()
    assert np.array_equal(sensor_matrix([f"truth/{name}" for name in STATE_NAMES], turn), np.eye(6))
    several = sensor_matrix(names, [turn, 2 * turn])  # robots on a last axis
    assert np.array_equal(several[..., 1], sensor_matrix(names, 2 * turn))
    with pytest.raises(SpecMismatch, match="no linear row"):
        sensor_matrix(["sensor/accel_up"], turn)


def test_rk4_has_order_four():
    # halving the step of a method of order p divides the error by 2^p: slope 4 ± 0.1 over three halvings
    start, stop = (0.2, 0.0, 0.0, 2.0, 0.0, 1.0), 0.2

    def f(x):
        return derivative(x, (0.5, 0.2), LOSSLESS)

    exact = solve_ivp(lambda _t, y: f(y), (0, stop), start, method="DOP853", rtol=1e-13, atol=1e-14).y[:, -1]
    errors = []
    for steps in (20, 40, 80, 160):
        x = start
        for _ in range(steps):
            x = rk4_step(f, x, stop / steps)
        errors.append(np.linalg.norm(np.array(x) - exact))
    slopes = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.allclose(slopes, 4, atol=0.1)


def energy(x, p, xp, model):
    """T + V [J], constant without voltage, friction, back-EMF and pushes: the forces that keep the wheels rolling do no
    work. V is zero where the centre of mass is at the axle's height, on a level floor."""
    pitch, pitch_rate, _, wheel_rate, _, yaw_rate = x
    a11, a12, a22, a33 = mass_matrix(xp.cos(pitch), xp.sin(pitch), p, model)
    kinetic = (a11 * wheel_rate**2 + 2 * a12 * wheel_rate * pitch_rate + a22 * pitch_rate**2 + a33 * yaw_rate**2) / 2
    return kinetic + p.body_mass * p.gravity * p.com_height * xp.cos(pitch)


@pytest.mark.parametrize("model", ["complete", "published"])
def test_energy_is_conserved_to_the_order_of_the_integrator(model):
    # the energy error of RK4 falls with h⁴ to h⁵: at least 2^3.8 a halving
    start = (0.3, 0.0, 0.0, 3.0, 0.0, 4.0)
    drifts = []
    for steps in (100, 200, 400):
        x = start
        for _ in range(steps):
            x = rk4_step(lambda s: derivative(s, (0, 0), LOSSLESS, model=model), x, 0.5 / steps)
        before, after = (energy(s, LOSSLESS, math, model) for s in (start, x))
        drifts.append(abs(after - before))
    assert np.log2(drifts[0] / drifts[1]) > 3.8
    assert drifts[2] < 1e-7  # joules, of 0.4 J


@pytest.mark.parametrize("model", ["complete", "published"])
def test_dry_frictions_take_the_power_of_their_torques(model):
    # dE/dt, by a complex step along the motion: each wheel loses τ_w ω σ(ω) to the floor at its rate ω over it, and
    # τ_c ω' σ(ω') at its rate against the body
    p = LOSSLESS.replace(rolling_friction=0.02, coulomb_friction=0.01)
    for x in np.random.default_rng(2).normal(size=(20, 6)) * (0.6, 4.0, 6.0, 15.0, 3.0, 6.0):
        rate = derivative(x, (0, 0), p, model=model)
        gained = energy([a + 1e-30j * b for a, b in zip(x, rate, strict=True)], p, cmath, model).imag / 1e-30
        floor = x[3] + turn_ratio(p) * x[5] * np.array([-1, 1])
        lost = [t * w**2 / np.hypot(w, p.stiction_rate) for t, w in ((0.02, floor), (0.01, floor - x[1]))]
        # powers of up to 1e3 W (weights and inertias times rates) cancel to these of 0.1 W: 1e3 · 2e-16, several times
        assert gained == pytest.approx(-np.sum(lost), abs=1e-11)


def test_mirrored_robot_does_the_mirrored_thing():
    rng = np.random.default_rng(1)
    mirror = np.array([1, 1, 1, 1, -1, -1.0])
    for _ in range(20):
        x, u = rng.normal(size=6), rng.normal(size=2)
        plain = np.array(derivative(x, u, NXT))
        assert np.allclose(derivative(mirror * x, u[::-1], NXT), mirror * plain, rtol=1e-13, atol=1e-13)


def test_parameters_may_be_arrays_over_a_batch():
    numbers = NXT.numbers() | {"com_height": np.array([0.07, 0.08])}
    batch = derivative([np.full(2, 0.1)] * 6, (1.0, 1.0), SimpleNamespace(**numbers), xp=np)
    single = derivative([0.1] * 6, (1.0, 1.0), NXT.replace(com_height=0.08))
    assert math.isclose(batch[1][1], single[1], rel_tol=1e-13)


def test_robot_is_frozen():
    with pytest.raises(AttributeError):
        NXT.track = 1.0  # type: ignore[misc]
    assert replace(NXT, track=0.2).track == 0.2


@pytest.mark.parametrize(("limit", "error"), [(SIMULATED, 2.41e-4), (PREDICTED, 1.26e-3)])
def test_a_step_at_its_limit_is_off_by_what_is_stated(limit, error):
    # of ẋ = −x, one step against e^(−h); numbers are those of the series 1 − h + h²/2 − h³/6 + h⁴/24 by hand
    (value,) = rk4_step(lambda x: (-x[0],), (1.0,), limit)
    assert value - math.exp(-limit) == pytest.approx(error, rel=0.01)


@pytest.mark.parametrize(("name", "value"), [("torque_constant", 7750.0), ("stiction_rate", 1e-6)])
def test_a_pole_that_no_step_can_follow_is_named_with_what_is_out_of_its_range(name, value):
    robot = NXT.replace(coulomb_friction=0.01, **{name: value})  # 0.317 is shipped: a slip of the decimal point
    fastest = f"{max(abs(linearise(robot).poles())):.2g}"
    batch = FleetBatch(parameters=parameters_of([robot]), controller=lqr_state(NXT, 0.01))
    for make in (lambda: NonlinearBody(robot), lambda: simulate(batch, 0.1), lambda: lift(robot, KIT, 0.3, 0.01)):
        with pytest.raises(InvalidRobot, match=f"pole of {re.escape(fastest)}.* steps.*{name}"):
            make()


@pytest.mark.parametrize("name", PARAMETERS)
@pytest.mark.parametrize("value", [5e-324, 1e-200, 1e12, 1.7e308])
def test_a_number_that_no_robot_has_is_refused_before_it_divides(name, value):
    with pytest.raises(InvalidRobot, match=name):
        NXT.replace(**{name: value})


def test_numbers_that_are_possible_one_by_one_but_not_together_are_refused():
    with pytest.raises(InvalidRobot, match="too far apart"):
        linearise(NXT.replace(gear_ratio=1e6, rotor_inertia=1e6))


def test_substeps_keep_every_step_within_its_limit():
    for period, fastest in ((0.01, 241.19), (0.001, 241.19), (0.1, 3.0), (0.01, 0.0)):
        n = substeps(period, fastest)
        assert fastest * period / n <= SIMULATED
        assert n == 1 or fastest * period / (n - 1) > SIMULATED  # and no more of them than that takes
