"""The predictive controller against the regulator, OSQP, planted limits and planted failures."""

import copy

import numpy as np
import pytest

from upright.bodies import Electronics, LinearBody, NonlinearBody
from upright.control import controller_hash, lqg, mpc, read_controller, write_controller
from upright.control.mpc import PredictiveController, QuadraticProgram, largest_command, predicted
from upright.errors import DesignFailed, InvalidController
from upright.experiment import Drive, Hold, run
from upright.physics.linear import linearise
from upright.robots import Kit, Robot, preset_names

NXT = Robot.preset("nxtway-gs")
KIT = Kit.preset("nxt")
IDEAL = Kit.preset("ideal")


@pytest.mark.parametrize("preset", preset_names())
def test_without_active_limits_it_is_the_regulator(preset):
    # the terminal cost is the regulator's own, so the minimiser is −K ξ whatever the horizon
    robot = Robot.preset(preset)
    kit = Kit.preset(robot.kit)
    controller, same = mpc(robot, kit, limit=1e6, pitch=1e6, travel=1e6), lqg(robot, kit)
    plant, K = controller.design.filter.sampled.plant, controller.design.K
    assert np.array_equal(K, same.design.K)
    rng = np.random.default_rng(0)
    free, forced = predicted(plant, 30)
    weights = np.repeat(controller.design.Q[None], 30, axis=0)
    weights[-1] = controller.design.P
    for _ in range(5):
        xi = rng.normal(size=len(plant.states)) * 0.1
        f = np.einsum("kia,kij,kjb,b->a", forced, weights, free, xi)
        U, residual = controller.solve(f, np.zeros(len(controller.programme.rows)))
        assert U[:2] == pytest.approx(-K @ xi, rel=1e-6, abs=1e-8)
        assert residual < 1e-6


def test_prediction_is_the_model_stepped():
    plant = mpc(NXT, KIT).design.filter.sampled.plant
    free, forced = predicted(plant, 5)
    rng = np.random.default_rng(1)
    first, commands = rng.normal(size=len(plant.states)), rng.normal(size=(5, 2))
    x = first
    for i, u in enumerate(commands):
        x = plant.A @ x + plant.B @ u
        assert np.allclose(free[i] @ first + forced[i] @ commands.ravel(), x, rtol=1e-12)


def recorded(controller, body, *args, **options):
    """The f and c of every step of a run, and the log."""
    seen, step = [], controller.memory.outputs

    def spy(y, r):
        outputs = step(y, r)
        seen.append(outputs.copy())
        return outputs

    controller.memory.outputs = spy
    log = run(body, controller, *args, **options)
    del controller.memory.outputs
    n = len(controller.programme.H)
    return [(out[:n], out[n:-2]) for out in seen], log


def test_daqp_and_osqp_agree_with_limits_active():
    osqp = pytest.importorskip("osqp")
    from scipy import sparse

    controller = mpc(NXT, KIT, limit=1.5, travel=0.02)
    body = Electronics(NonlinearBody(NXT, period=0.002), KIT)
    steps, _ = recorded(controller, body, Hold(pitch=0.1, until=0.5), seconds=1.5)
    p, compared = controller.programme, 0
    n, rows = len(p.H), len(p.rows)
    # a soft row is |rows U + c| ≤ 1 + slack with slack²/(2 softness) in the cost: slack as further variables
    H = sparse.block_diag([p.H, sparse.eye(rows) / p.softness], format="csc")
    A = sparse.bmat([[sparse.eye(n), None], [p.rows, -sparse.eye(rows)], [p.rows, sparse.eye(rows)]], format="csc")
    for f, c in steps[::10]:
        upper = np.concatenate([np.full(n, p.limit), 1 - c, np.full(rows, np.inf)])
        lower = np.concatenate([np.full(n, -p.limit), np.full(rows, -np.inf), -1 - c])
        problem = osqp.OSQP()
        settings = {"eps_abs": 1e-8, "eps_rel": 1e-8, "max_iter": 100_000, "polishing": True, "verbose": False}
        problem.setup(H, np.append(f, np.zeros(rows)), A, lower, upper, **settings)
        other = problem.solve(raise_error=True).x[:n]
        U, residual = controller.solve(f, c)
        assert residual < 1e-6
        # OSQP's own tolerance, 1e-8 of a problem whose entries reach hundreds
        assert np.allclose(U, other, atol=1e-4)
        compared += bool((np.abs(U) > p.limit * 0.999).any() or (np.abs(p.rows @ U + c) > 1).any())
    assert compared >= 3  # limits were indeed active


def test_warm_started_steps_equal_fresh_solutions():
    controller = mpc(NXT, KIT, limit=1.5)
    body = Electronics(NonlinearBody(NXT, period=0.002), KIT)
    steps, log = recorded(controller, body, Hold(pitch=0.1, until=0.5), seconds=1.5)
    left = log["command/left"]
    for k, (f, c) in list(enumerate(steps))[::7]:
        assert left[k] == pytest.approx(controller.solve(f, c)[0][0], abs=1e-6)
    assert np.abs(left).max() == pytest.approx(1.5, abs=1e-9)


def test_no_command_exceeds_the_limit():
    for preset in ("ev3way", "twipr"):
        robot = Robot.preset(preset)
        kit = Kit.preset(robot.kit)
        controller = mpc(robot, kit)
        body = Electronics(NonlinearBody(robot, period=0.002), kit)
        log = run(body, controller, Hold(pitch=-0.12, until=2), seconds=4)
        most = largest_command(robot, kit)
        assert np.abs([log["command/left"], log["command/right"]]).max() <= most * (1 + 1e-9)
        assert controller.failures == 0


def test_largest_command_is_what_is_left_of_the_battery():
    # 8 V of the NXT's pack, less 0.02 V for each volt to both motors at full: 8·(1 − 2·0.02)
    assert largest_command(NXT, KIT) == pytest.approx(7.68)
    assert largest_command(Robot.preset("twipr"), Kit.preset("twipr")) == 0.5  # the driver's limit [N m]
    assert largest_command(NXT, IDEAL) == np.inf


def test_a_travel_limit_is_kept_where_the_regulator_goes_beyond():
    body = LinearBody(linearise(NXT), NXT, period=0.01)
    goal = Drive(speed=0.15, start=0.2, until=1.7)
    free, tight = mpc(NXT, IDEAL, travel=10.0), mpc(NXT, IDEAL, travel=0.03)
    off = []
    for controller in (free, tight):
        log = run(body, controller, reference=goal, seconds=4)
        off.append(np.abs(log["truth/wheel"] - log["reference/wheel"]).max() * NXT.wheel_radius)
        assert not log.origin["outcome"]["fell"]
    assert off[0] > 0.036
    assert off[1] < 0.033  # soft: a tenth beyond the 3 cm at most


def test_a_pitch_limit_is_kept_where_the_regulator_goes_beyond():
    body = LinearBody(linearise(NXT), NXT, period=0.01)
    goal = Drive(speed=0.5, start=0.2)
    peaks = [
        np.abs(run(body, mpc(NXT, IDEAL, pitch=pitch), reference=goal, seconds=4)["truth/pitch"]).max()
        for pitch in (1.0, 0.08)
    ]
    assert peaks[0] > 0.1
    assert peaks[1] < 0.088  # soft: a tenth beyond at most


def test_a_steady_push_leaves_no_offset():
    body = Electronics(LinearBody(linearise(NXT), NXT), IDEAL)
    log = run(body, mpc(NXT, IDEAL), Hold(pitch=0.05, until=100), seconds=40)
    assert abs(log["truth/wheel"][-1]) < 1e-3  # [rad]; the regulator alone stands more than a radian off


def test_where_no_solution_exists_the_regulator_takes_over_and_it_is_counted():
    # hard limits on pitch, started beyond them with little voltage: infeasible at first
    controller = mpc(NXT, IDEAL, limit=2.0, pitch=0.05, soft=False)
    body = LinearBody(linearise(NXT), NXT, period=0.01)
    log = run(body, controller, start=(0.1, 0, 0, 0, 0, 0), seconds=4)
    assert controller.failures > 0
    assert not log.origin["outcome"]["fell"]
    assert np.abs(log["command/left"]).max() <= 2.0 * (1 + 1e-9)  # DAQP's rounding
    assert abs(log["truth/pitch"][-1]) < 0.01
    rows = len(controller.programme.rows)
    with pytest.raises(DesignFailed, match="no solution"):
        controller.solve(np.zeros(60), np.full(rows, 100.0))
    controller.reset()
    assert controller.failures == 0


def test_kkt_residual_finds_a_planted_error():
    controller = mpc(NXT, KIT, limit=1.0)
    p = controller.programme
    f = p.H @ np.full(60, 2.0)
    U, residual = controller.solve(f, np.zeros(len(p.rows)))
    assert residual < 1e-6
    zero = np.zeros(60 + len(p.rows))
    assert p.kkt(U, f, np.zeros(len(p.rows)), zero) > 0.01  # multipliers forgotten
    assert p.kkt(U * 1.5, f, np.zeros(len(p.rows)), zero) >= 0.4  # half beyond the limit


@pytest.mark.parametrize(
    ("options", "word"),
    [({"horizon": 0}, "horizon"), ({"horizon": 0.3}, "seconds"), ({"limit": -1.0}, "limit is -1"),
     ({"pitch": 0.0}, "pitch is 0"), ({"travel": -2.0}, "travel"), ({"R": [0, 0]}, "R is not positive")],
)  # fmt: skip
def test_bad_arguments_are_named(options, word):
    with pytest.raises(DesignFailed, match=word):
        mpc(NXT, KIT, **options)


def test_a_solver_that_refuses_is_named():
    good = mpc(NXT, KIT)
    p = good.programme
    with pytest.raises(DesignFailed, match="DAQP refuses"):
        PredictiveController(good.memory, QuadraticProgram(-p.H, p.rows, p.limit))
    with pytest.raises(InvalidController, match="do not fit"):
        PredictiveController(good.memory, QuadraticProgram(p.H, p.rows[1:], p.limit))


def test_copies_and_files_command_alike(tmp_path):
    controller = mpc(NXT, KIT)
    again = read_controller(write_controller(controller, tmp_path / "mpc.json"))
    unlimited = mpc(NXT, IDEAL)
    back = read_controller(write_controller(unlimited, tmp_path / "free.json"))
    assert back.programme.limit == np.inf
    for other in (again, copy.deepcopy(controller)):
        assert controller_hash(other) == controller_hash(controller)
        body = Electronics(NonlinearBody(NXT, period=0.002), KIT)
        logs = [run(body, c, Hold(pitch=0.05, until=0.5), seconds=1) for c in (controller, other)]
        assert np.allclose(logs[0]["command/left"], logs[1]["command/left"], atol=1e-9)
