"""How far the predictive controller is from the exact minimum of the problem it stands for, by iterations.

    python benchmarks/mpc.py [--robot nxtway-gs] [--runs 500]

The judge solves the whole problem in each period by DAQP: every command of the horizon free and limited. First table:
along its own runs under knocks of growing size, the command of each controller from the same state, where a limit or a
bound counts; pitch and travel are bounded at the same instants. Second: the same robots, noise and pushes as a
certificate's, each under both, and the largest knock; the judge bounds pitch and travel at ten instants.
"""

from __future__ import annotations

import argparse
import copy
import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies import Electronics, NonlinearBody
from upright.certify.checks import TrialSetup, kernel_controller, trials
from upright.comparison.bench import largest_knock
from upright.compiled.program import Program
from upright.control import mpc
from upright.control.controller import ControllerSpec
from upright.control.law import as_law, program
from upright.control.linear_controller import LinearController
from upright.control.lqg import Lqg
from upright.control.mpc import SOFTNESS, UNLIMITED, PredictiveController, doubling, largest_command, predicted
from upright.control.observer import memory, steady_push, steady_state
from upright.errors import DesignFailed
from upright.experiment import Impulse, run
from upright.robots import Kit, Robot
from upright.robots.uncertainty import draw
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

ITERATIONS = (1, 2, 4, 6, 8, 12, 20)
KNOCKS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)  # [m/s] of the body: from never at the limit to beyond what it survives
SOFT, HARD = 8, 0  # DAQP's names for a constraint that may and one that may not be broken


@dataclass(frozen=True, eq=False)
class QuadraticProgram:
    """min ½ UᵀH U + fᵀU over |U| ≤ limit, |rows U + c| ≤ 1, soft: breaking a row by e costs e²/(2 softness)."""

    H: Array
    rows: Array
    limit: float
    softness: Array

    def solver(self) -> Any:
        """A DAQP workspace."""
        daqp: Any = import_module("daqp")
        model, n, k = daqp.Model(), len(self.H), len(self.rows)
        upper = np.concatenate([np.full(n, self.limit), np.ones(k)])
        sense = np.array([HARD] * n + [SOFT] * k, dtype=np.int32)
        flag, _ = model.setup(self.H, np.zeros(n), self.rows, upper, -upper, sense)
        if flag < 0:
            raise DesignFailed(f"DAQP refuses the programme (flag {flag})", expected="a positive definite H")
        weights = np.concatenate([np.ones(n), self.softness])
        model.soft_weights(rho_l=weights, rho_u=weights)
        return model

    def solve(self, solver: Any, f: Array, c: Array) -> Array:
        """U (2N,); raises `DesignFailed` where DAQP gives none."""
        limit = np.full(len(self.H), self.limit)
        solver.update(f=f, bupper=np.concatenate([limit, 1 - c]), blower=np.concatenate([-limit, -1 - c]))
        U, _, flag, _ = solver.solve()
        if flag <= 0:
            raise DesignFailed(f"DAQP gives no solution (flag {flag})", expected="limits that can be kept")
        return U


@dataclass(eq=False)
class Exact:
    """The controller of the exact minimum: outputs of `memory` are [f (2N), c]."""

    memory: LinearController
    programme: QuadraticProgram
    solver: Any = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.reset()

    @property
    def spec(self) -> ControllerSpec:
        return self.memory.spec

    def reset(self) -> None:
        self.memory.reset()
        self.solver = self.programme.solver()

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        outputs, n = self.memory.outputs(measurement, reference), len(self.programme.H)
        left, right = self.programme.solve(self.solver, outputs[:n], outputs[n:])[:2].tolist()
        self.memory.decided(left, right)
        return left, right

    def estimate(self) -> Sequence[float]:
        return self.memory.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.memory.applied(command)

    def to_json(self) -> dict[str, Any]:
        return self.memory.facts()

    def __deepcopy__(self, memo: dict[int, Any]) -> Exact:
        return Exact(copy.deepcopy(self.memory, memo), self.programme)


def exact(
    robot: Robot, kit: Kit, *, pitch: float = 0.3, travel: float = 1.0, limit: float | None = None,
    instants: Sequence[int] = range(3, 31, 3), horizon: int = 30,
) -> Exact:  # fmt: skip
    """The judge of `mpc` with the same arguments; pitch and travel are bounded after so many `instants` periods, each
    for the periods since the one before."""
    design = mpc(robot, kit).design
    assert isinstance(design, Lqg)
    model, plant = design.filter.sampled, design.filter.sampled.plant
    free, forced = predicted(plant.A, plant.B, (1,) * horizon)
    weights = np.repeat(design.Q[None], horizon, axis=0)
    weights[-1] = design.P
    H = np.einsum("kia,kij,kjb->ab", forced[1:], weights, forced[1:]) + np.kron(np.eye(horizon), design.R)
    gradient = np.einsum("kia,kij,kjb->ab", forced[1:], weights, free[1:])
    bounds = [(STATE_NAMES.index("pitch"), pitch), (STATE_NAMES.index("wheel"), travel / robot.wheel_radius)]
    when = list(instants)
    rows = np.vstack([forced[when, i] / b for i, b in bounds])
    drift = np.vstack([free[when, i] / b for i, b in bounds])
    lean = np.concatenate([np.full(len(when), (i == 0) / b) for i, b in bounds])
    G, every = np.vstack([gradient, drift]), np.tile(np.eye(2), (horizon, 1))

    def outputs(xi_s: Array, u_s: Array) -> Array:
        return np.vstack([-H @ every @ u_s, -rows @ every @ u_s + np.outer(lean, xi_s[0])]) - G @ xi_s

    (xi_r, u_r), (xi_push, u_push) = steady_state(model), steady_push(model)
    g = outputs(xi_push[:, None], u_push[:, None])[:, 0]
    most = min(largest_command(robot, kit) if limit is None else limit, UNLIMITED)
    recursion = memory(design.filter, G, g, outputs(xi_r, u_r), kind="exact mpc")
    softness = SOFTNESS / np.tile(np.diff([0, *when]), 2)
    return Exact(recursion, QuadraticProgram((H + H.T) / 2, rows, most, softness))


@dataclass(eq=False)
class Watched:
    """`judge` drives; `other` gets the same readings and what was really applied, and its commands are kept."""

    judge: Any
    other: PredictiveController
    commands: list[tuple[float, ...]] = field(default_factory=list)
    counted: list[bool] = field(default_factory=list)
    residual: float = 0.0

    @property
    def spec(self) -> ControllerSpec:
        return self.judge.spec

    def reset(self) -> None:
        self.judge.reset()
        self.other.reset()

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        command, own = self.judge.step(measurement, reference), self.other.step(measurement, reference)
        self.other.memory.decided(*command)
        self.commands.append((*command, *own))
        self.counted.append(self.other.limited)
        self.residual = max(self.residual, self.other.residual)
        return command

    def estimate(self) -> Sequence[float]:
        return self.judge.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.judge.applied(command)
        self.other.applied(command)

    def to_json(self) -> dict[str, Any]:
        return self.judge.to_json()


def gaps(judge: Exact, other: PredictiveController, robot: Robot, kit: Kit) -> tuple[Array, float]:
    """Differences of commands over the limit (n,) wherever one counts, and the worst residual."""
    off, residual = list[Array](), 0.0
    for size in KNOCKS:
        for seed, way in enumerate((1.0, -1.0)):
            pair = Watched(judge, other)
            push = Impulse(impulse=way * size * robot.body_mass, start=0.5, duration=0.02)
            run(Electronics(NonlinearBody(robot), kit), pair, push, seconds=2.0, seed=seed)
            table = np.array(pair.commands)[pair.counted]
            off.append(np.abs(table[:, :2] - table[:, 2:]).max(axis=1) / other.splitting.limit)
            residual = max(residual, pair.residual)
    return np.concatenate(off), residual


def falls(controller: Any, robot: Robot, kit: Kit, runs: int) -> tuple[NDArray[np.int64], float, float]:
    """Falls of each trial of a certificate, the seconds that took, and the worst residual."""
    setup = TrialSetup(kernel_controller(controller, robot, kit), robot, draw(robot, runs, 0, None), kit)
    start = time.perf_counter()
    results = trials(setup).trials
    return np.array([t.fell for t in results]), time.perf_counter() - start, max(t.residual for t in results)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--robot", default="nxtway-gs")
    parser.add_argument("--runs", type=int, default=500, help="robots of the second table, 0: without it")
    options = parser.parse_args()
    robot = Robot.preset(options.robot)
    kit = Kit.preset(robot.kit)
    judge, base = exact(robot, kit), mpc(robot, kit)
    alike = exact(robot, kit, instants=np.cumsum(doubling(30)).tolist())
    print("| iterations | products | commands | within 1 % | within 5 % | largest | residual |")
    print("|---:|---:|---:|---:|---:|---:|---:|")
    for count in ITERATIONS:
        one = replace(base, splitting=replace(base.splitting, iterations=count))
        text: Program = program(as_law(one), 0)
        off, residual = gaps(alike, one, robot, kit)
        cells = [len(off), f"{np.mean(off < 0.01):.1%}", f"{np.mean(off < 0.05):.1%}", f"{off.max():.1%}"]
        print(f"| {count} | {text.operations()} | {' | '.join(map(str, cells))} | {residual:.1%} |", flush=True)
    if not options.runs:
        return
    print(f"\n| controller | fell in each of six trials, of {options.runs} | share | largest knock [N s] | time |")
    print("|---|---|---:|---:|---:|")
    for name, controller in (("exact", judge), ("mpc", base)):
        fell, seconds, residual = falls(controller, robot, kit, options.runs)
        plant = Electronics(NonlinearBody(robot), kit)
        knocks = [largest_knock(plant, controller, way, 1) for way in (1.0, -1.0)]
        share = fell.sum() / (len(fell) * options.runs)
        words = f"{' '.join(map(str, fell))} | {share:.2%} | {knocks[0]:.4f}, {knocks[1]:.4f} | {seconds:.1f} s"
        print(f"| {name} | {words} |" + (f" worst residual {residual:.2%}" if residual else ""), flush=True)
    assert math.isfinite(seconds)


if __name__ == "__main__":
    main()
