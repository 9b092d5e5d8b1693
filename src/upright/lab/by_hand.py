"""Gains by hand as a program: state feedback behind the kit's filter, whose six gains are inputs."""

from __future__ import annotations

from dataclasses import replace

from upright.compiled.program import INFINITY, Program
from upright.compiled.tracer import Form, Tracer
from upright.control.delay import RAW, sampled
from upright.control.feedback import StateFeedback
from upright.control.kalman import RECOVERED, kalman_filter
from upright.control.law import as_law, dot, program
from upright.control.observed import observed
from upright.control.observer import observer, steady_state
from upright.robots import Kit, Robot
from upright.signals import SIDES, STATE_NAMES


def gains_program(robot: Robot, kit: Kit) -> Program:
    """The statements of `observed(StateFeedback.symmetric(k, …), robot, kit)` with k as its inputs `gain_…`.

    Raises `SpecMismatch` for a kit without both encoders and a gyro, `DesignFailed` where no filter exists.
    """
    zero = StateFeedback.symmetric((0.0,) * 6, kit.period, command_unit=robot.command_unit)
    estimator = kalman_filter(sampled(robot, kit, kit.period, RAW), RECOVERED)
    model = estimator.sampled
    watch = observer(estimator)
    like = program(as_law(observed(zero, robot, kit)))
    xi_r, u_r = steady_state(model)
    ahead = model.ahead
    t = Tracer()
    z = [t.state(f"z{i}", "1", INFINITY) for i in range(len(watch.A))]
    y = [t.input(name, "1", INFINITY) for name in like.channels]
    r = [t.input(f"reference_{name}", "1", INFINITY) for name in STATE_NAMES]
    k = [t.input(f"gain_{name}", "1", INFINITY) for name in STATE_NAMES]
    rows = [(row @ watch.C[:-1], row @ watch.Dy[:-1], -row @ xi_r) for row in ahead]
    error = [t.let(f"error{i}", dot(C, z) + dot(Dy, y) + dot(Dr, r), "1") for i, (C, Dy, Dr) in enumerate(rows)]
    parts = [t.product(f"part{i}", *pair, "1") for i, pair in enumerate(zip(k, error, strict=True))]
    pull, turn = (sum(some, Form()) for some in (parts[:4], parts[4:]))
    rows_u = (dot(u_r[0], r) - pull - turn, dot(u_r[1], r) - pull + turn)
    u = [
        t.let(f"command_{side}", row, robot.command_unit, output=True) for side, row in zip(SIDES, rows_u, strict=True)
    ]
    command = t.block("command")
    a = [t.input(f"applied_{side}", robot.command_unit, INFINITY) for side in SIDES]
    pairs = [(watch.A, z), (watch.By, y), (watch.Bu, u), (watch.Ba, a)]
    for i, state in enumerate(z):
        row = sum((dot(M[i], values) for M, values in pairs), Form())
        t.commit(state, t.let(f"next_z{i}", row, "1"))
    return replace(like, kind="gains by hand", variables=t.variables, command=command, update=t.block("update"))
