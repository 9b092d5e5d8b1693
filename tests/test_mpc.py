"""The predictive controller against the regulator, the exact minimum by DAQP, OSQP, and planted limits."""

import copy
from dataclasses import replace

import numpy as np
import pytest

from interpreter import Interpreter
from planted import exact_mpc
from upright.bodies import Electronics, LinearBody, NonlinearBody
from upright.control import controller_hash, lqg, mpc, read_controller, write_controller
from upright.control.law import as_law, program
from upright.control.mpc import PredictiveController, doubling, predicted
from upright.control.reach import largest_command
from upright.errors import DesignFailed, InvalidController
from upright.experiment import Drive, Hold, Impulse, run
from upright.physics.linear import linearise
from upright.robots import Kit, Robot, preset_names

NXT = Robot.preset("nxtway-gs")
KIT = Kit.preset("nxt")
IDEAL = Kit.preset("ideal")


@pytest.mark.parametrize("preset", preset_names())
def test_without_active_limits_it_is_the_regulator(preset):
    # the terminal cost is the regulator's own, so the minimum is −K ξ whatever the horizon: for the judge, which knows
    # no K, and for the splitting, whose iterations must not move it
    robot = Robot.preset(preset)
    kit = Kit.preset(robot.kit)
    controller, same = mpc(robot, kit, limit=1e6, pitch=1e6, travel=1e6), lqg(robot, kit)
    exact = exact_mpc.exact(robot, kit, limit=1e6, pitch=1e6, travel=1e6)
    plant, K = controller.design.filter.sampled.plant, controller.design.K
    assert np.array_equal(K, same.design.K)
    rng, n = np.random.default_rng(0), len(exact.programme.H)
    free, forced = predicted(plant.A, plant.B, (1,) * 30)
    weights = np.repeat(controller.design.Q[None], 30, axis=0)
    weights[-1] = controller.design.P
    solver = exact.programme.solver()
    for _ in range(5):
        xi = rng.normal(size=len(plant.states)) * 0.1
        f = np.einsum("kia,kij,kjb,b->a", forced[1:], weights, free[1:], xi)
        U = exact.programme.solve(solver, f, np.zeros(len(exact.programme.rows)))
        assert U[:2] == pytest.approx(-K @ xi, rel=1e-6, abs=1e-8)
        assert len(U) == n
    for _ in range(20):
        y, r = rng.normal(size=3) * 0.1, np.zeros(6)
        outputs = controller.memory.outputs(y, r).copy()
        v, _ = controller.splitting.iterated(outputs, np.zeros(len(outputs)))
        assert v == pytest.approx(outputs, rel=1e-9, abs=1e-15)


def test_prediction_is_the_model_stepped_with_commands_held_in_blocks():
    plant = mpc(NXT, KIT).design.filter.sampled.plant
    free, forced = predicted(plant.A, plant.B, (1, 3, 1))
    rng = np.random.default_rng(1)
    first, commands = rng.normal(size=len(plant.states)), rng.normal(size=(3, 2))
    x = first
    for i, block in enumerate((0, 1, 1, 1, 2)):
        x = plant.A @ x + plant.B @ commands[block]
        assert np.allclose(free[i + 1] @ first + forced[i + 1] @ commands.ravel(), x, rtol=1e-12)


def test_blocks_double_up_to_the_horizon():
    assert doubling(30) == (1, 1, 2, 4, 8, 14)
    assert doubling(7) == (1, 1, 2, 3)
    assert doubling(1) == (1,)


def driven(other, exact, *args, **options):
    """The commands (n, 4) of the judge, which drives, and of the other one from the same readings; and the log."""
    pair = exact_mpc.Watched(exact, other)
    log = run(Electronics(NonlinearBody(NXT, period=0.002), KIT), pair, *args, **options)
    return np.array(pair.commands), log


def test_every_command_free_and_iterated_for_long_it_is_the_exact_minimum():
    # two forms of one problem: commands condensed for DAQP, deviations from the regulator for the splitting
    bounds = {"limit": 3.0, "pitch": 0.15}
    one = mpc(NXT, KIT, **bounds, blocks=(1,) * 30, iterations=100)
    exact = exact_mpc.exact(NXT, KIT, **bounds, instants=range(1, 31))
    commands, log = driven(one, exact, Impulse(impulse=0.35 * NXT.body_mass, start=0.2), seconds=1.2)
    assert (np.abs(commands[:, 0]) > 2.999).sum() >= 3  # the limit was reached
    assert np.abs(log["truth/pitch"]).max() > 0.15  # and the bound
    # a hundred warm iterations leave a thousandth of the limit; a wrong problem, some tenths
    assert np.abs(commands[:, :2] - commands[:, 2:]).max() < 0.005 * 3.0


@pytest.mark.parametrize("limit", [3.0, None])
def test_six_iterations_are_near_the_exact_minimum(limit):
    # what its docstring states: limits alone count here, and 98 % of the commands are within 1 % of it
    one = mpc(NXT, KIT, limit=limit)
    most = one.splitting.limit
    push = Impulse(impulse=(0.25 if limit else 0.5) * NXT.body_mass, start=0.2)
    commands, _ = driven(one, exact_mpc.exact(NXT, KIT, limit=limit), push, seconds=2.0)
    off = np.abs(commands[:, :2] - commands[:, 2:]).max(axis=1) / most
    assert (np.abs(commands[:, :2]).max(axis=1) > 0.999 * most).sum() >= 3
    assert np.mean(off < 0.01) >= 0.98


def test_daqp_and_osqp_agree_with_limits_active():
    osqp = pytest.importorskip("osqp")
    from scipy import sparse

    exact, steps = exact_mpc.exact(NXT, KIT, limit=1.5, travel=0.02), []
    outputs = exact.memory.outputs

    def spy(y, r):
        steps.append(outputs(y, r).copy())
        return steps[-1]

    exact.memory.outputs = spy
    body = Electronics(NonlinearBody(NXT, period=0.002), KIT)
    run(body, exact, Hold(pitch=0.1, until=0.5), seconds=1.5)
    p, compared = exact.programme, 0
    n, rows = len(p.H), len(p.rows)
    # a soft row is |rows U + c| ≤ 1 + slack with slack²/(2 softness) in the cost: slack as further variables
    H = sparse.block_diag([p.H, sparse.diags(1 / p.softness)], format="csc")
    A = sparse.bmat([[sparse.eye(n), None], [p.rows, -sparse.eye(rows)], [p.rows, sparse.eye(rows)]], format="csc")
    solver = p.solver()
    for f, c in ((step[:n], step[n:]) for step in steps[::10]):
        upper = np.concatenate([np.full(n, p.limit), 1 - c, np.full(rows, np.inf)])
        lower = np.concatenate([np.full(n, -p.limit), np.full(rows, -np.inf), -1 - c])
        problem = osqp.OSQP()
        settings = {"eps_abs": 1e-8, "eps_rel": 1e-8, "max_iter": 100_000, "polishing": True, "verbose": False}
        problem.setup(H, np.append(f, np.zeros(rows)), A, lower, upper, **settings)
        other = problem.solve(raise_error=True).x[:n]
        U = p.solve(solver, f, c)
        # OSQP's own tolerance, 1e-8 of a problem whose entries reach hundreds
        assert np.allclose(U, other, atol=1e-4)
        compared += bool((np.abs(U) > p.limit * 0.999).any() or (np.abs(p.rows @ U + c) > 1).any())
    assert compared >= 3  # limits were indeed active


def test_its_statements_compute_what_its_step_computes():
    # a run with a bound active; the text sums Π over sums and differences of the motors, the step over each motor
    controller = mpc(NXT, KIT, pitch=0.1)
    machine, seen = Interpreter(program(as_law(controller), 0)), []
    step = PredictiveController.step

    class Both(PredictiveController):
        def step(self, measurement, reference):
            command = step(self, measurement, reference)
            inputs = dict(zip((n.replace("/", "_") for n in self.spec.reads), measurement.tolist(), strict=True))
            out = machine.command(inputs)
            seen.append((*command, out["command_left"], out["command_right"], out["residual"]))
            return command

        def applied(self, command):
            super().applied(command)
            machine.values |= {"applied_left": command[0], "applied_right": command[1]}
            machine.update()

    both = Both(controller.memory, controller.splitting)
    body = Electronics(NonlinearBody(NXT, period=0.002), KIT)
    run(body, both, Impulse(impulse=0.2 * NXT.body_mass, start=0.2), seconds=1.0)
    table = np.array(seen)
    assert np.allclose(table[:, :2], table[:, 2:4], rtol=0, atol=1e-9)
    assert both.residual == pytest.approx(table[:, 4].max(), abs=1e-9)
    assert both.residual > 0


def test_no_command_exceeds_the_limit():
    for preset in ("ev3way", "twipr"):
        robot = Robot.preset(preset)
        kit = Kit.preset(robot.kit)
        controller = mpc(robot, kit)
        body = Electronics(NonlinearBody(robot, period=0.002), kit)
        log = run(body, controller, Hold(pitch=-0.12, until=2), seconds=4)
        most = largest_command(robot, kit)
        assert np.abs([log["command/left"], log["command/right"]]).max() <= most


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


def test_bounds_that_cannot_be_kept_are_broken_softly():
    # started beyond the bound with little voltage: no command keeps it at first
    controller = mpc(NXT, IDEAL, limit=2.0, pitch=0.05)
    body = LinearBody(linearise(NXT), NXT, period=0.01)
    log = run(body, controller, start=(0.1, 0, 0, 0, 0, 0), seconds=4)
    assert controller.residual > 0
    assert not log.origin["outcome"]["fell"]
    assert np.abs(log["command/left"]).max() <= 2.0
    assert abs(log["truth/pitch"][-1]) < 0.01
    controller.reset()
    assert controller.residual == 0


@pytest.mark.parametrize(
    ("options", "word"),
    [({"horizon": 0}, "horizon"), ({"horizon": 0.3}, "seconds"), ({"limit": -1.0}, "limit is -1"),
     ({"pitch": 0.0}, "pitch is 0"), ({"travel": -2.0}, "travel"), ({"R": [0, 0]}, "R is not positive"),
     ({"iterations": 0}, "0 iterations"), ({"blocks": (1, 2)}, "sum to 30")],
)  # fmt: skip
def test_bad_arguments_are_named(options, word):
    with pytest.raises(DesignFailed, match=word):
        mpc(NXT, KIT, **options)


def test_a_splitting_that_does_not_fit_is_named():
    good = mpc(NXT, KIT)
    with pytest.raises(InvalidController, match="projection has shape"):
        replace(good.splitting, projection=good.splitting.projection[1:])
    with pytest.raises(InvalidController, match="0 iterations"):
        replace(good.splitting, iterations=0)
    with pytest.raises(InvalidController, match="outputs of the memory"):
        PredictiveController(good.memory, mpc(NXT, KIT, horizon=2).splitting)
    with pytest.raises(InvalidController, match="earlier version"):
        PredictiveController.from_json(good.memory.facts())


def test_copies_and_files_command_alike(tmp_path):
    controller = mpc(NXT, KIT)
    again = read_controller(write_controller(controller, tmp_path / "mpc.json"))
    for other in (again, copy.deepcopy(controller)):
        assert controller_hash(other) == controller_hash(controller)
        body = Electronics(NonlinearBody(NXT, period=0.002), KIT)
        logs = [run(body, c, Hold(pitch=0.05, until=0.5), seconds=1) for c in (controller, other)]
        assert np.allclose(logs[0]["command/left"], logs[1]["command/left"], atol=1e-9)
