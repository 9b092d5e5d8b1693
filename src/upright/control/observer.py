"""The memory behind every output feedback: the filter's state, the command applied last, and those on their way."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.control.delay import SampledRobot
from upright.control.design import Design
from upright.control.kalman import Filter, one_step
from upright.control.linear_controller import LinearController
from upright.physics.linear import delay_line, linearise_rolling
from upright.robots import Robot


def observer(estimator: Filter) -> LinearController:
    """The memory behind `estimator`: commands on their way are remembered as sent, the last one as it was applied.

    Its outputs are what is known after the reading: the regulator's state ξ (six states, then earlier commands) and
    the push F [N]. No reference enters.
    """
    model = estimator.sampled
    n = len(model.linear.A)
    m = len(model.reads)
    d = model.delay
    h = model.history
    size = n + 2 * h
    gain = estimator.L
    A = np.zeros((size, size))
    By = np.zeros((size, m))
    Bu = np.zeros((size, 2))
    Ba = np.zeros((size, 2))
    A[:n, :n], By[:n], after = one_step(model.linear.A, model.linear.C, gain)
    Ba[:n] = model.now
    line = delay_line(2, d, model.dt)
    A[n : n + 2 * d, n : n + 2 * d], Bu[n : n + 2 * d] = line.A, line.B
    if h > d:
        A[:n, n + 2 * d :], Ba[n + 2 * d :] = model.before, np.eye(2)
    C = np.zeros((7 + 2 * h, size))  # zero for what no reading shows
    Dy = np.zeros((7 + 2 * h, m))
    k = len(model.shown)
    C[model.shown, :n], Dy[model.shown], C[6:-1, n:] = after[:k], gain[:k], np.eye(2 * h)
    if "push" in model.linear.states:
        push = model.linear.states.index("push")
        C[-1, :n], Dy[-1] = after[push], gain[push]
    none = np.zeros((size, 6))
    return LinearController(
        A, By, none, Ba, C, Dy, np.zeros((len(C), 6)), reads=model.reads, period=model.dt, S=C[:6], Sy=Dy[:6], Bu=Bu,
        command_unit=model.robot.command_unit, kind="observer",
    )  # fmt: skip


def memory(estimator: Filter, G: Array, g: Array, H: Array, *, kind: str) -> LinearController:
    """The `observer` with the outputs G ξ + g F + H r, for a method that is not linear."""
    watch = observer(estimator)
    C, Dy = (G @ M[:-1] + np.outer(g, M[-1]) for M in (watch.C, watch.Dy))
    return replace(watch, C=C, Dy=Dy, Dr=H, kind=kind)


@dataclass(frozen=True, eq=False)
class Steady:
    """x = x_r r + x_push F is steady at the reference r and a constant push F [N] under u = u_r r + u_push F."""

    x_r: Array
    u_r: Array
    x_push: Array
    u_push: Array


def steady(robot: Robot) -> Steady:
    """Pitch and both commands that make the three accelerations zero, from the dynamics linearised upright."""
    model = linearise_rolling(robot)
    rows = [1, 3, 5]
    unknown = np.column_stack([model.A[rows, 0], model.B[rows]])
    push = model.E[rows, 0] + robot.com_height * model.E[rows, 1]
    rates = np.zeros((3, 6))
    rates[:, [3, 5]] = model.A[np.ix_(rows, [3, 5])]
    by_reference: Array = -np.linalg.solve(unknown, rates).astype(np.float64)
    by_push: Array = -np.linalg.solve(unknown, push).astype(np.float64)
    x_r = np.diag([0.0, 0, 1, 1, 1, 1])
    x_r[0] = by_reference[0]
    return Steady(x_r, by_reference[1:], np.eye(6)[0] * by_push[0], by_push[1:])


@dataclass(frozen=True, eq=False)
class Extra:
    """States of the control law's own: w⁺ = A w + X (ξ − ξ_r) + back (a − u_due), and u gets − K w.

    u_due is the command that should have arrived when a was applied, so that what saturation takes flows back.
    """

    A: Array
    X: Array
    K: Array
    back: Array


def output_feedback(
    estimator: Filter, K: Array, kind: str, design: Design, extra: Extra | None = None
) -> LinearController:
    """u = u_r r − K (ξ − ξ_r) − K_w w, with ξ_r the steady motion at the reference r: K (2, 6 + earlier commands)."""
    model = estimator.sampled
    watch = observer(estimator)
    X, Xy = watch.C[:-1], watch.Dy[:-1]
    more = extra or Extra(np.zeros((0, 0)), np.zeros((0, K.shape[1])), np.zeros((2, 0)), np.zeros((0, 2)))
    n, m = len(watch.A), len(more.A)
    xi_r, u_r = steady_state(model)
    C = np.hstack([-K @ X, -more.K])
    Dy = -K @ Xy
    Dr = u_r + K @ xi_r
    open_loop = np.block([[watch.A, np.zeros((n, m))], [more.X @ X, more.A]])
    Bu = np.vstack([watch.Bu, np.zeros((m, 2))])
    Ba = np.vstack([watch.Ba, more.back])
    if model.delay:
        due = len(model.linear.A) + 2 * model.delay - 2
        open_loop[n:, due : due + 2] -= more.back
    else:
        Bu[n:] -= more.back
    By = np.vstack([watch.By, more.X @ Xy]) + Bu @ Dy
    Br = np.vstack([np.zeros((n, 6)), -more.X @ xi_r]) + Bu @ Dr
    S = np.hstack([watch.S, np.zeros((6, m))])
    A = open_loop + Bu @ C
    return LinearController(
        A, By, Br, Ba, C, Dy, Dr, reads=model.reads, period=model.dt, S=S, Sy=watch.Sy,
        command_unit=watch.command_unit, kind=kind, design=design,
    )  # fmt: skip


def steady_state(model: SampledRobot) -> tuple[Array, Array]:
    """ξ_r (6 + earlier commands, 6) and u_r (2, 6): what the steady motion at a reference needs."""
    rest = steady(model.robot)
    return np.vstack([rest.x_r, np.tile(rest.u_r, (model.history, 1))]), rest.u_r


def steady_push(model: SampledRobot) -> tuple[Array, Array]:
    """ξ_F (6 + earlier commands,) and u_F (2,): what the rest under a push of 1 N needs."""
    rest = steady(model.robot)
    return np.concatenate([rest.x_push, np.tile(rest.u_push, model.history)]), rest.u_push
