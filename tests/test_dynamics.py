"""The equations of motion against a symbolic derivation from the energies, and against their own symmetries."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
import sympy as sp

from upright.errors import UnknownName
from upright.paper.derivation import derive, lagrange, mechanics, symbols
from upright.physics.dynamics import CALM, MODELS, Disturbance, accelerations, derivative
from upright.robots import PARAMETERS, Robot

NXT = Robot.preset("nxtway-gs")
SIZES = np.array([0.6, 4.0, 6.0, 15.0, 3.0, 6.0])  # rad and rad/s: leaning, rolling and turning hard
CASES = 1000


def random_cases(n, seed):
    """States, commands, robots (half NXTway-GS, half every parameter off by up to a factor of 3) and disturbances."""
    rng = np.random.default_rng(seed)
    x, u = SIZES[:, None] * rng.uniform(-1, 1, (6, n)), rng.uniform(-9, 9, (2, n))
    nominal = {**NXT.numbers(), "wheel_friction": 2e-3, "coulomb_friction": 0.01, "rolling_friction": 0.005}
    spread = np.where(np.arange(n) % 2, 1.0, 0.0)
    numbers = {name: nominal[name] * 3.0 ** (spread * rng.uniform(-1, 1, n)) for name in PARAMETERS}
    w = Disturbance(rng.uniform(-3, 3, n), rng.uniform(0, 0.2, n), rng.uniform(-0.3, 0.3, n))
    return x, u, SimpleNamespace(**numbers), w


def pick(i, x, u, p, w):
    """Case `i` as floats."""
    robot = SimpleNamespace(**{name: float(getattr(p, name)[i]) for name in PARAMETERS})
    return [float(v) for v in x[:, i]], [float(v) for v in u[:, i]], robot, Disturbance(*(float(v[i]) for v in w))


@pytest.mark.parametrize("model", MODELS)
def test_accelerations_are_the_derived_ones(model):
    x, u, p, w = random_cases(CASES, seed=1)
    ours = np.array(accelerations(x, u, p, w, np, model))
    theirs = np.array(derive(model).evaluator("numpy")(x, u, p, w))
    # both sum some 20 terms in float64, and the 2×2 solve loses up to a11 a22 / det ≈ 10: 20·10·ε = 4e-14
    # of the largest term; 1e-12 of the largest acceleration leaves room for terms that cancel
    assert (np.abs(ours - theirs).max(axis=0) <= 1e-12 * np.abs(theirs).max(axis=0)).all()


@pytest.mark.parametrize("model", MODELS)
def test_accelerations_are_the_derived_ones_at_thirty_digits(model):
    import mpmath

    cases, exact = random_cases(40, seed=2), derive(model).evaluator("mpmath")
    with mpmath.workdps(30):
        for i in range(40):
            x, u, p, w = pick(i, *cases)
            big = SimpleNamespace(**{name: mpmath.mpf(value) for name, value in vars(p).items()})
            theirs = exact(list(map(mpmath.mpf, x)), list(map(mpmath.mpf, u)), big, Disturbance(*map(mpmath.mpf, w)))
            ours = accelerations(
                list(map(mpmath.mpf, x)), list(map(mpmath.mpf, u)), big, Disturbance(*map(mpmath.mpf, w)), mpmath, model
            )
            # the same numbers as above, with ε = 1e-30 in place of 2e-16
            assert max(abs(a - b) for a, b in zip(ours, theirs, strict=True)) < 1e-26 * max(map(abs, theirs))


def test_complete_model_solves_the_constrained_system_with_its_multipliers():
    # a third route: the six coordinates' own equations and the two kinds of rolling constraint as one linear system,
    # [M −Aᵀ; A 0] [q̈; λ] = [Q − h; −Ȧ q̇], whose accelerations never saw S
    s = symbols()
    system = mechanics(s, roll=s.roll_inertia)
    mass, bias = lagrange(system.energy, system.q, system.v)
    drift = (system.rolling * sp.Matrix(system.v)).jacobian(system.q) * sp.Matrix(system.v)
    torques, evaluated = derive("complete").definitions, None
    for i in range(4):
        x, u, p, w = pick(i, *random_cases(4, seed=3))
        names = ("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate", "left", "right", *Disturbance._fields)
        values = {getattr(s, n): v for n, v in zip(names, (*x, *u, *w), strict=True)}
        values |= {getattr(s, n): v for n, v in vars(p).items()}
        known = {symbol: float(e.subs(values)) for symbol, e in torques.items()}
        values |= known
        turn = p.track / (2 * p.wheel_radius) * x[5]
        for side, command, rate, sign in (("l", u[0], x[3] - turn, s.sign_l), ("r", u[1], x[3] + turn, s.sign_r)):
            torque = known[s.alpha] * command - known[s.beta] * (rate - x[1]) - p.coulomb_friction * known[sign]
            values |= {getattr(s, f"torque_{side}"): torque, getattr(s, f"w{side}"): rate}
        values |= {s.vx: p.wheel_radius * x[3] * math.cos(x[4]), s.vy: p.wheel_radius * x[3] * math.sin(x[4])}
        if evaluated is None:
            evaluated = sp.lambdify(list(values), (mass, bias, system.force, system.rolling, drift))
        M, h, Q, A, c = (np.array(m, dtype=float) for m in evaluated(*values.values()))
        solved = np.linalg.solve(np.block([[M, -A.T], [A, np.zeros((3, 3))]]), np.concatenate([Q - h, -c]))[:, 0]
        ours = np.array(accelerations(x, u, p, w))
        theirs = np.array([solved[3], (solved[4] + solved[5]) / 2, solved[2]])
        # a 9×9 solve of condition about 1e5 for kg beside kg m²: 1e5·ε ≈ 2e-11
        assert np.abs(ours - theirs).max() <= 1e-10 * np.abs(theirs).max()


def test_free_directions_keep_the_wheels_rolling():
    s = symbols()
    system = mechanics(s, roll=s.roll_inertia)
    assert sp.simplify(system.rolling * system.motion) == sp.zeros(3, 3)


def test_the_two_models_differ_by_the_terms_of_rolling_and_roll_inertia():
    # docs/model.md: MLR φ̇² sin ψ and −MLR φ̇ θ̇ sin ψ, and J_ρ − J_φ in three places
    s = symbols()
    sin, cos = sp.sin(s.pitch), sp.cos(s.pitch)
    lever, spare = s.body_mass * s.com_height * s.wheel_radius, s.roll_inertia - s.yaw_inertia
    complete, published = derive("complete"), derive("published")
    expected = sp.Matrix(
        [
            lever * s.yaw_rate**2 * sin,
            spare * s.yaw_rate**2 * sin * cos,
            -lever * s.yaw_rate * s.wheel_rate * sin - 2 * spare * s.pitch_rate * s.yaw_rate * sin * cos,
        ]
    )
    assert sp.expand(complete.force - published.force - expected) == sp.zeros(3, 1)
    assert sp.expand(complete.mass - published.mass) == sp.expand(sp.diag(0, 0, spare * sin**2))
    assert complete.mass[0, 2] == complete.mass[1, 2] == 0  # yaw is uncoupled in the mass matrix
    assert all("=" in line and "φ̇²" in complete.equations[1] for line in complete.equations)


def test_a_model_that_does_not_exist_is_named():
    with pytest.raises(UnknownName, match="complete, published"):
        derive("full")


@pytest.mark.parametrize("model", MODELS)
def test_models_agree_when_not_turning_and_equal_inertias(model):
    robot = NXT.replace(roll_inertia=NXT.yaw_inertia)
    straight = (0.3, 1.0, 0.0, 5.0, 0.2, 0.0)
    # the terms that differ are exact zeros here, so the arithmetic is the same: 4 ε of rounding
    expected = accelerations(straight, (2.0, 3.0), robot, model="published")
    assert accelerations(straight, (2.0, 3.0), robot, model=model) == pytest.approx(expected, rel=1e-15)


@pytest.mark.parametrize("model", MODELS)
def test_the_mirrored_robot_does_the_mirrored_thing(model):
    x, u, p, w = random_cases(200, seed=4)
    mirror = np.array([1, 1, 1, 1, -1, -1])[:, None]
    pitch, wheel, yaw = accelerations(x, u, p, w, np, model)
    reflected = np.array(accelerations(mirror * x, u[::-1], p, w, np, model))
    # only the order of adding left and right changes: as many roundings as in the first test
    scale = np.abs([pitch, wheel, yaw]).max(axis=0)
    assert (np.abs(reflected - [pitch, wheel, -yaw]) <= 1e-12 * scale).all()


@pytest.mark.parametrize("model", MODELS)
def test_arrays_give_the_same_as_floats(model):
    x, u, p, w = random_cases(50, seed=5)
    together = np.array(accelerations(x, u, p, w, np, model))
    alone = np.array([accelerations(*pick(i, x, u, p, w), math, model) for i in range(50)]).T
    # numpy's and the C library's sin and squares may differ in the last bit; the solve enlarges it as above
    assert (np.abs(together - alone) <= 1e-12 * np.abs(alone).max(axis=0)).all()


@pytest.mark.parametrize("model", MODELS)
def test_symbols_go_through(model):
    s = symbols()
    state = [s.pitch, s.pitch_rate, s.wheel, s.wheel_rate, s.yaw, s.yaw_rate]
    traced = accelerations(state, [s.left, s.right], NXT, Disturbance(s.force, s.height, s.slope), sp, model)
    x, u, w = (0.2, -1.0, 0.4, 6.0, 0.7, 3.0), (1.5, -2.0), Disturbance(0.8, 0.1, 0.05)
    point = dict(zip([*state, s.left, s.right, s.force, s.height, s.slope], [*x, *u, *w], strict=True))
    expected = accelerations(x, u, NXT, w, math, model)
    # SymPy adds the same terms in its own order, in floats of 15 digits
    assert [float(e.subs(point)) for e in traced] == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize(("force", "height"), [(-0.5, 0.1), (0.4, 0.0), (-0.2, 0.144)])
def test_a_held_robot_stands_still(force, height):
    # α (v_l + v_r) = −F R and MgL sin ψ = −F (h cos ψ + R): the moments about the axle and about the contact
    weight = NXT.body_mass * NXT.gravity * NXT.com_height
    arm, angle = math.hypot(weight, force * height), math.atan2(force * height, weight)
    lean = math.asin(-force * NXT.wheel_radius / arm) - angle  # a sin ψ + b cos ψ = c in closed form
    volts = -force * NXT.wheel_radius * NXT.motor_resistance / NXT.torque_constant / 2
    slopes = derivative((lean, 0, 1.2, 0, 0.3, 0), (volts, volts), NXT, Disturbance(force, height))
    # moments of 0.05 N m cancel to ε over inertias of 1e-4 kg m²: 0.05 · 2e-16 / 1e-4 = 1e-13, several times
    assert np.abs(slopes).max() < 1e-11
    assert math.copysign(1, lean) == -math.copysign(1, force)  # a force on the front holds a forward lean


@pytest.mark.parametrize("route", ["physics", "derivation"])
def test_poles_upright_are_the_published_ones(route):
    # pitch part of NXTway-GS: 0, −241.19, 7.437, −6.520 1/s, each within half a unit of its last digit
    s = symbols()
    state = [s.pitch, s.pitch_rate, s.wheel, s.wheel_rate]
    if route == "physics":
        pitch, wheel, _ = accelerations([*state, 0, 0], [0, 0], NXT, CALM, sp)
    else:
        d = derive("complete")
        values = {getattr(s, name): value for name, value in NXT.numbers().items()}
        still = {s.left: 0, s.right: 0, s.force: 0, s.slope: 0, s.yaw: 0, s.yaw_rate: 0}
        pitch, wheel, _ = (e.subs(d.definitions).subs(still).subs(values) for e in d.accelerations)
    tangent = sp.Matrix([s.pitch_rate, pitch, s.wheel_rate, wheel]).jacobian(state).subs(dict.fromkeys(state, 0))
    poles = np.sort(np.linalg.eigvals(np.array(tangent, dtype=float)).real)
    for pole, expected, tolerance in zip(poles, (-241.19, -6.520, 0, 7.437), (5e-3, 5e-4, 1e-9, 5e-4), strict=True):
        assert abs(pole - expected) <= tolerance
