"""How far the predictive controller is from the exact minimum of the problem it stands for, by iterations.

    python benchmarks/mpc.py [--robot nxtway-gs] [--runs 500]

The judge solves the whole problem in each period by DAQP: every command of the horizon free and limited. First table:
along its own runs under knocks of growing size, the command of each controller from the same state, where a limit or a
bound counts; pitch and travel are bounded at the same instants. Second: the same robots, noise and pushes as a
certificate's, each under both, and the largest knock; the judge bounds pitch and travel at ten instants.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import harness
import numpy as np
from numpy.typing import NDArray

from planted.exact_mpc import Array, Exact, Watched, exact
from upright.bodies import Electronics, NonlinearBody
from upright.certification.checks import TrialSetup, kernel_controller, trials
from upright.comparison.bench import largest_knock
from upright.compiled.program import Program
from upright.control import mpc
from upright.control.law import as_law, program
from upright.control.mpc import PredictiveController, doubling
from upright.experiment import Impulse, run
from upright.robots import Kit, Robot
from upright.robots.uncertainty import draw

ITERATIONS = (1, 2, 4, 6, 8, 12, 20)
KNOCKS = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6)  # [m/s] of the body: from never at the limit to beyond what it survives


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
    setup = TrialSetup(robot, draw(robot, runs, 0, None), kit, controller=kernel_controller(controller, robot, kit))
    clock = harness.Clock()
    results = trials(setup).trials
    return np.array([t.fell for t in results]), clock.wall, max(t.residual for t in results)


def main() -> None:
    options = harness.options(__doc__, robot="nxtway-gs", runs=500)
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
