"""What a designed excitation gains over a random binary dither of its energy, and how often a robot falls with it.

    python benchmarks/excite.py                               # three presets, five robots each, 300 twin runs each
    python benchmarks/excite.py --robots nxtway-gs --seeds 3 --runs 0

Energy is ∫ u_l² + u_r² dt of what the motors of the nominal robot get by an excitation, the loop's answer included, so
that a slow turn, most of whose added voltage the controller takes back, and a dither are measured alike.

A run fixes few combinations of the robot's numbers, and each number no better than its partners are known. So every
preset comes thrice: as its file has it; with what scales, calipers and an ohmmeter tell taken for exact (`--known`);
and as the next run of a robot that was calibrated once, from a dither as loud as the first plan, planned with its
posterior and its own regulator (`--posterior`), which is louder where drawn robots would have fallen. Where even a
hundred such runs would not halve the dither's interval, the table says that no run could.

Robots are drawn from the spreads of the preset's file. Those that do not stand unexcited are left out: of the drawn
ones the kernel tells which, and a twin that falls with the plan is tried again without it. Twins are MuJoCo in the
kit's electronics; plan, controller and calibration know the preset alone.
"""

from __future__ import annotations

import json
import os
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import islice, product
from pathlib import Path
from tempfile import TemporaryDirectory

import harness
import numpy as np

from upright.bodies import Electronics
from upright.bodies.twin import Twin
from upright.calibration.calibrate import calibrate
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import VISIBLE
from upright.control import make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.excitation import excite
from upright.excitation.loop import ExcitedLoop
from upright.excitation.plan import ExcitationPlan
from upright.excitation.search import SWAY
from upright.experiment import run
from upright.fleets.binomial import clopper_pearson
from upright.kernel.batch import parameters_of
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Family, Uncertainty, read_posterior
from upright.signals import Log

PRESETS = ("nxtway-gs", "ev3way", "twipr")
SECONDS = 20.0
MEASURED = ("wheel_mass", "body_mass", "wheel_radius", "track", "motor_resistance")
"""What scales, calipers and an ohmmeter tell, of those that the robot has."""
KINDS = {"plan": 0, "dither": 1, "held 40 ms": 4}
"""How each log was excited, and for how many periods a value of a dither is held."""
Found = dict[str, Calibration | None]
UNSEEN = 1000  # added to the seed: robots and noise that the plan was not made with


def robots(name: str, count: int, seed: int, known: tuple[str, ...] = ()) -> list[Robot]:
    """Drawn robots, but for what is `known`, that stand unexcited and that are rigid bodies in the twin."""
    robot = Robot.preset(name)
    kit = Kit.preset(robot.kit)
    drawn = Family(robot, kit, Uncertainty.of(robot, known)).draw(seed, np.arange(4 * count + 20))
    loop = ExcitedLoop(robot, kit, make_controller("lqg", robot, kit, kit.period), SECONDS, seed)
    result = loop.run(np.zeros((1, 1, 2)), parameters_of(robot, drawn), hold=loop.periods)
    stands = np.flatnonzero(~result.fell & (result.peak[:, 0] < SWAY))
    found = (robot.replace(**{n: float(v[i]) for n, v in drawn.items()}) for i in stands)
    return list(islice(filter(possible, found), count))


def possible(robot: Robot) -> bool:
    """Whether the twin can be: its wheels' own inertias must leave the body a rigid one."""
    try:
        Twin(robot)
    except (ValueError, UprightError):  # MuJoCo says the first
        return False
    return True


def twin_log(name: str, sequence: np.ndarray, true: Robot, seed: int, learnt: Robot | None = None) -> Log:
    """A twin of `true` under the controller of the preset, or of what was `learnt`, with `sequence` (n, 2) added."""
    robot = learnt or Robot.preset(name)
    kit = Kit.preset(robot.kit)
    controller = Excited(make_controller("lqg", robot, kit, kit.period), sequence)
    return run(Electronics(Twin(true), kit), controller, seconds=SECONDS, seed=seed)


def dither(name: str, energy: float, seed: int, hold: int, learnt: Robot | None = None) -> np.ndarray:
    """A random binary dither (n, 2) of that energy, at the preset or at what was `learnt`."""
    robot = learnt or Robot.preset(name)
    kit = Kit.preset(robot.kit)
    loop = ExcitedLoop(robot, kit, make_controller("lqg", robot, kit, kit.period), SECONDS, seed)
    first = 1.0 if loop.gains.command_unit == "V" else 0.02
    rows = random_binary(-(-loop.periods // hold), first, seed)
    return np.repeat(loop.scaled(rows[None], energy, hold)[0], hold, axis=0)


Job = tuple[str, np.ndarray, Robot, int, tuple[str, ...]]


def calibrated(job: Job, learnt: Robot | None = None) -> Calibration | None:
    """What a calibration makes of a twin's log; None where it fell or nothing follows the log."""
    name, sequence, true, seed, known = job
    log = twin_log(name, sequence, true, seed, learnt)
    if log.origin["outcome"]["fell"]:
        return None
    try:
        return calibrate(log, Robot.preset(name), known=known)
    except UprightError:
        return None


def next_run(name: str, energy: float, job: tuple[int, Robot]) -> tuple[ExcitationPlan, Found] | None:
    """A plan made with what a dither of that `energy` told of a twin, and what its log and dithers' tell; None where
    the first log tells nothing or no plan can be made."""
    seed, true = job
    first = calibrated((name, dither(name, energy, seed, 1), true, seed, ()))
    if first is None:
        return None
    with TemporaryDirectory() as folder:
        file = Path(folder) / "first.json"
        file.write_text(json.dumps(first.to_json()), encoding="utf-8")
        posterior = read_posterior(file)
    try:
        plan = excite("lqg", first.robot, seconds=SECONDS, posterior=posterior)
    except UprightError:
        return None
    later = UNSEEN + seed
    return plan, {
        kind: calibrated(
            (name, dither(name, plan.energy, later, hold, first.robot) if hold else plan.sequence, true, later, ()),
            first.robot,
        )
        for kind, hold in KINDS.items()
    }


def fell(name: str, sequence: np.ndarray, job: tuple[int, Robot]) -> tuple[bool, bool]:
    """Whether a twin falls with the sequence, and then also without it."""
    seed, true = job
    falls = twin_log(name, sequence, true, seed).origin["outcome"]["fell"]
    return falls, falls and twin_log(name, 0 * sequence, true, seed).origin["outcome"]["fell"]


def widths(plan: ExcitationPlan, name: str, seeds: int, known: tuple[str, ...], pool: ProcessPoolExecutor) -> None:
    """Median ratios of interval widths from the plan's logs to those from dithers of its energy."""
    true = robots(name, seeds, UNSEEN, known)
    jobs = [
        (name, dither(name, plan.energy, UNSEEN + i, hold) if hold else plan.sequence, robot, UNSEEN + i, known)
        for hold in KINDS.values()
        for i, robot in enumerate(true)
    ]
    found = list(pool.map(calibrated, jobs))
    by_kind = {kind: found[i * seeds : (i + 1) * seeds] for i, kind in enumerate(KINDS)}
    table([plan], by_kind)


def next_runs(plan: ExcitationPlan, name: str, seeds: int, pool: ProcessPoolExecutor) -> None:
    """The same for the next run of each robot, after a first one with a dither of this plan's energy."""
    true = list(enumerate(robots(name, seeds, UNSEEN), UNSEEN))
    found = [f for f in pool.map(partial(next_run, name, plan.energy), true) if f]
    print(f"\n{name}, calibrated once: {len(found)} of {seeds} plans could be made")
    if found:
        louder = np.median([later.energy for later, _ in found]) / plan.energy
        print(f"  energy {louder:.2g} times the first plan's (median)")
        table([later for later, _ in found], {kind: [c[kind] for _, c in found] for kind in KINDS})


def table(plans: list[ExcitationPlan], by_kind: dict[str, list[Calibration | None]]) -> None:
    """Every parameter's interval widths by plan and dithers."""
    lost = {kind: sum(c is None for c in several) for kind, several in by_kind.items()}
    print(
        f"  interval widths from calibrations of twin logs, medians over {len(by_kind['plan'])} robots; "
        f"fell or not followed: {lost}"
    )
    print("  bar: at most half of the dither's")
    columns = harness.Table(
        "  parameter <22", "visible in >11", "plan/dither >13.2f", "plan/held >11.2f", "100/dither >12.2f",
        "± plan >12.3g", "± dither >12.3g", "bar >13",
    )  # fmt: skip
    in_all = [c.to_json() for several in by_kind.values() for c in several if c]
    there = {e["name"] for e in (*in_all[0]["parameters"], *in_all[0]["delays"])} if in_all else set()
    for i, p in enumerate(plans[0].predicted):
        if p.name in there:
            least = (plan.predicted[i].least / plan.predicted[i].dither for plan in plans)
            row(columns, p.name, float(np.median(list(least))), by_kind)


def row(columns: harness.Table, name: str, least: float, by_kind: dict[str, list[Calibration | None]]) -> None:
    """One parameter that the plan's logs make visible, in half of them or more, and the `least` ratio that a hundred
    such runs are predicted to reach."""
    seen = [c[name] for c in by_kind["plan"] if c]
    visible = sum(e.verdict == VISIBLE for e in seen)
    if 2 * visible < len(seen) or not seen:
        return
    half = {
        kind: [(c[name].high - c[name].low) / 2 if c else np.nan for c in several] for kind, several in by_kind.items()
    }
    ratio, held = (float(np.nanmedian(np.divide(half["plan"], half[kind]))) for kind in ("dither", "held 40 ms"))
    kind = "" if "/" in name else "met" if ratio <= 0.5 else "no run could" if least > 0.5 else "not met"
    sizes = (np.nanmedian(half["plan"]), np.nanmedian(half["dither"]))
    columns.row(f"  {name}", f"{visible}/{len(seen)}", ratio, held, least, *sizes, kind)


def falls(plan: ExcitationPlan, name: str, runs: int, pool: ProcessPoolExecutor) -> None:
    """How many of `runs` twins fall."""
    jobs = list(enumerate(robots(name, runs, UNSEEN + 1), UNSEEN))
    outcomes = list(pool.map(partial(fell, name, plan.sequence), jobs, chunksize=4))
    count, anyway = (sum(column) for column in zip(*outcomes, strict=True))
    high = clopper_pearson(count, len(jobs)).high
    print(f"\n{name}: {count} of {len(jobs)} twins fall ({count / len(jobs):.2%}, at most {high:.2%}; bar: 1 %),")
    print(f"{anyway} of them without the excitation too", flush=True)


def main() -> None:
    asked = harness.options(__doc__, robots=PRESETS, seeds=5, runs=300, workers=os.cpu_count() or 1)
    harness.machine("numpy", "numba", "mujoco")
    plans: dict[str, ExcitationPlan] = {}
    with ProcessPoolExecutor(asked.workers) as pool:
        for name, measured in product(asked.robots, (False, True)):
            robot = Robot.preset(name)
            known = tuple(n for n in MEASURED if measured and (robot.drive == "voltage" or n != "motor_resistance"))
            clock = harness.Clock()
            try:
                plan = excite("lqg", robot, seconds=SECONDS, known=known)
            except UprightError as error:
                print(f"\n{name}: {error}")
                continue
            told = f"known: {', '.join(known)}" if known else "as its file has it"
            print(f"\n{name}, {told}\n{plan}\n\n  designed in {clock.wall:.1f} s")
            plans.setdefault(name, plan)
            print(f"  energy {plan.energy:.3g} ({plan.unit})² s, of the excitation alone {plan.added:.3g}", flush=True)
            if asked.seeds:
                widths(plan, name, asked.seeds, known, pool)
            if asked.seeds and measured:
                next_runs(plans[name], name, asked.seeds, pool)
        for name, plan in plans.items() if asked.runs else ():
            falls(plan, name, asked.runs, pool)


if __name__ == "__main__":
    main()
