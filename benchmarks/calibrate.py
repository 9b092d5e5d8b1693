"""How long a calibration takes, and how often its intervals hold the truth.

    python benchmarks/calibrate.py                   # time: 2000 samples, eight parameters, against SciPy
    python benchmarks/calibrate.py --seeds 100       # coverage and unstable pole on twins of three kits
    python benchmarks/calibrate.py --quiet 100       # coverage on logs that nobody excited: a hold and its release
    python benchmarks/calibrate.py --families 100    # coverage where friction, winding and floor differ between runs

Truth is drawn from what each preset says of its own numbers (value and spread); the controller and the calibration know
the preset alone. Robots that the preset's controller cannot hold fall, and are left out and counted.
"""

from __future__ import annotations

import argparse
import math
import os
import platform
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command `upright` does

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.twins import DITHER, FLOOR, RUNS, drawn, runs_of, truth, twin_log
from upright.calibrate.annealing import annealed
from upright.calibrate.calibrate import calibrate, prepared
from upright.calibrate.estimate import VISIBLE
from upright.calibrate.fitting import Problem, events_of
from upright.calibrate.gauss_newton import gauss_newton
from upright.calibrate.parameters import ROLLING
from upright.calibrate.refined import refined
from upright.calibrate.summary import rolling_pole
from upright.errors import UprightError
from upright.physics.dynamics import derivative
from upright.robots import PARAMETERS, Kit, Robot
from upright.signals import Log

EIGHT = (
    "com_height", "pitch_inertia", "yaw_inertia", "torque_constant", "motor_friction", "coulomb_friction",
    "delay/encoder", "delay/gyro",
)  # fmt: skip


GAP = "delay/gyro−encoder"  # a difference of two that are counted
HEAVIER = 1.2  # [1] the body's mass in one run of three, over that in the others


def families(name: str, seeds: Sequence[int], *, plain: bool = False) -> None:
    """How often the robot's own number lies in the interval of what is called visible, of its three runs together and
    of the first alone, where friction, winding and floor differ from run to run; and how often a run is said to differ
    from the others, where none does and where one has another body. With `plain`, of the three runs together alone."""
    robot = Robot.preset(name)
    held: dict[str, dict[str, list[bool]]] = {"three runs": {}} | ({} if plain else {"one of them": {}})
    left_out, apart = 0, {"alike": [], "one is heavier": []}
    for seed in seeds:
        true = drawn(robot, seed)
        if ROLLING in robot.provenance:
            true = true.replace(rolling_friction=FLOOR)
        logs = runs_of(name, true, seed)
        if any(log.origin["outcome"]["fell"] for log in logs):
            left_out += 1
            continue
        if not plain:
            heavier = runs_of(name, true.replace(body_mass=HEAVIER * true.body_mass), seed)[seed % RUNS]
            mixed = [heavier if run == seed % RUNS else log for run, log in enumerate(logs)]
            if not heavier.origin["outcome"]["fell"]:
                said = calibrate(mixed, robot).apart
                apart["one is heavier"].append(bool(said) and said[0].startswith(f"Log {seed % RUNS + 1},"))
        right = truth(name, true) | {"unstable_pole": rolling_pole(true)}
        for (which, inside), several in zip(held.items(), (logs, logs[:1]), strict=False):
            started = time.perf_counter()
            found = calibrate(several, robot)
            if several is logs:
                apart["alike"].append(bool(found.apart))
            told = [e for e in (*found.parameters, *found.delays, found["asymmetry"], found["unstable_pole"])
                    if e.verdict == VISIBLE]  # fmt: skip
            for e in told:
                inside.setdefault(e.name, []).append(e.low <= right[e.name] <= e.high)
            missed = [f"{e.name} {(e.value - right[e.name]) / e.spread:+.1f} deviations"
                      for e in told if not inside[e.name][-1]]  # fmt: skip
            print(f"    seed {seed}, {which}: {len(told) - len(missed)} of {len(told)}"
                  + (f" ({', '.join(missed)})" if missed else "")
                  + f"; {time.perf_counter() - started:.0f} s", flush=True)  # fmt: skip
    for which, inside in held.items():
        every = [one for several in inside.values() for one in several]
        rate = np.mean(every) if every else math.nan
        print(f"\n{name}, {which}, {len(seeds) - left_out} robots ({left_out} with a fall left out): truth inside "
              f"{sum(every)} of {len(every)} intervals, {rate:.1%}")  # fmt: skip
        missing = {n: f"{len(v) - sum(v)} of {len(v)}" for n, v in inside.items() if not all(v)}
        print("  missed:", ", ".join(f"{n} {count}" for n, count in missing.items()) or "none", flush=True)
    alike, heavier = (f"{sum(several)} of {len(several)}" for several in apart.values())
    print(f"  a run is said to differ from the others: {alike} where all are alike", flush=True)
    if not plain:
        print(f"  the right one in {heavier} where its body weighs {HEAVIER:g} times as much", flush=True)


def coverage(name: str, seeds: Sequence[int], *, quiet: bool = False) -> None:
    """How often the truth lies in the interval of what is called visible, and how far the unstable pole is off; on logs
    of 20 s, or `quiet` ones of 10 s. Each interval that misses is printed."""
    robot = Robot.preset(name)
    held: dict[str, list[bool]] = {}
    poles: list[float] = []
    fallen = refused = told = supported = 0
    for tried, seed in enumerate(seeds, 1):
        true = drawn(robot, seed)
        log = twin_log(name, true, seed, 10.0 if quiet else 20.0, quiet=quiet)
        if log.origin["outcome"]["fell"]:
            fallen += 1
        else:
            try:
                found = calibrate(log, robot)
            except UprightError:
                refused += 1
            else:
                right = truth(name, true)
                numbers = (*found.parameters, *found.delays, *found.electronics)
                told += len({e.name for e in (*numbers, *found.combinations) if e.verdict == VISIBLE} - {GAP})
                supported += found.supported
                for e in numbers:
                    if e.verdict == VISIBLE:
                        held.setdefault(e.name, []).append(e.low <= right[e.name] <= e.high)
                        if not held[e.name][-1]:
                            off = (e.value - right[e.name]) / e.spread
                            print(f"    seed {seed}: {e.name} {e.value:.4g} ({e.low:.4g} to {e.high:.4g}), "
                                  f"truth {right[e.name]:.4g}, {off:+.1f} deviations", flush=True)  # fmt: skip
                poles.append(abs(rolling_pole(found.robot) / rolling_pole(true) - 1))
        if poles and (tried % 10 == 0 or tried == len(seeds)):
            logs = "quiet logs of 10 s" if quiet else "logs of 20 s"
            print(f"\n{name}: {len(poles)} {logs} ({fallen} of {tried} fell and are left out, {refused} refused)")
            say(held, poles)
            print(f"  numbers and combinations called visible: {told}; that a right model's Fisher information halves: "
                  f"{supported}", flush=True)  # fmt: skip


def say(held: dict[str, list[bool]], poles: list[float]) -> None:
    """The table so far: how far the pole was off, and how often each visible parameter's interval held the truth."""
    every = [one for inside in held.values() for one in inside]
    print(f"  truth inside {sum(every)} of {len(every)} intervals ({np.mean(every) if every else math.nan:.1%})")
    print(f"  unstable pole: median error {np.median(poles):.2%}, worst {max(poles):.2%}")
    for parameter, inside in held.items():
        print(f"  {parameter:<18} visible in {len(inside):3d}, truth inside in {np.mean(inside):.0%}", flush=True)


def best_of(repeats: int, work: Callable[[], object]) -> tuple[float, float]:
    """Least time [s] on the clock and of the processor; on a busy machine only the second says something."""
    times: list[tuple[float, float]] = []
    for _ in range(repeats):
        start, busy = time.perf_counter(), time.process_time()
        work()
        times.append((time.perf_counter() - start, time.process_time() - busy))
    return min(t[0] for t in times), min(t[1] for t in times)


def timing(whole: bool) -> None:
    """The optimisation of eight parameters from 2000 samples, and SciPy's on the same residuals. All others are known:
    the file has their true values."""
    preset = Robot.preset("nxtway-gs")
    kit, true = Kit.preset(preset.kit), drawn(preset, 0)
    robot = true.replace(**{name: getattr(preset, name) for name in EIGHT if name in PARAMETERS})
    log = twin_log("nxtway-gs", true, 0)
    log = Log(log.t, {n: v for n, v in log.channels.items() if n != "sensor/compass"}, log.units, log.origin)
    every, _ = prepared([log], robot, kit, (), 0.0)
    known = [p.name for p in every.asked if p.name not in EIGHT]
    problem, limits = prepared([log], robot, kit, known, 0.0)

    def ours() -> None:
        refined(*annealed(problem, limits), limits)

    start = time.perf_counter()
    ours()
    print(f"first call, with compiling or loading what was compiled: {time.perf_counter() - start:.1f} s")
    clock, busy = best_of(5, ours)
    print(f"optimisation, {len(log)} samples, {len(problem.asked)} parameters: {clock:.3f} s, "
          f"{busy:.3f} s of processors (best of 5)")  # fmt: skip
    scipy_time(problem, limits, whole)


def scipy_time(problem: Problem, limits: dict[str, float], whole: bool) -> None:
    """`least_squares` with differences over `solve_ivp`: one pass is timed, the passes are counted on our own
    residuals, which are the same numbers; the product is what the whole would take. With `whole` it is run."""
    from scipy.optimize import least_squares

    from upright.calibrate.predictor import innovations

    found, z, *_ = refined(*annealed(problem, limits), limits)
    settled, z = replace(found, parameters=found.asked), z[: len(found.asked)]  # those that are told, for both alike
    same, _ = best_of(5, lambda: gauss_newton(settled, np.zeros(len(z)), iterations=20))
    print(f"its one fit at known noise from the prior, as SciPy's below: {same:.3f} s")
    recording = settled.recordings[0]
    path = settled.filtered(recording, z)
    use = (recording.kind >= 0) & np.isfinite(path.s)
    calls = 0

    def residuals(at: np.ndarray) -> np.ndarray:
        nonlocal calls
        calls += 1
        events, lanes = events_of(recording, settled.order(recording, at)), settled.lanes(recording, at[:, None])
        e = innovations(events, lanes, recording.first[:, None], path.gains, settled.longest)[use, 0]
        return np.concatenate([e / np.sqrt(path.s[use]), at])

    bounds = ([p.least for p in settled.parameters], np.inf)
    least_squares(residuals, np.zeros(len(z)), bounds=bounds, diff_step=1e-4)
    start = time.perf_counter()
    stiff = solve_ivp_pass(settled, z, path.gains)
    one = time.perf_counter() - start
    difference = np.abs(stiff[use] - residuals(z)[: use.sum()] * np.sqrt(path.s[use])).max()
    print(
        f"one pass over solve_ivp (RK45, rtol 1e-6): {one:.2f} s; largest difference of an innovation {difference:.1e}"
    )
    print(f"least_squares asks for {calls - 1} passes: {one * (calls - 1):.0f} s for its one fit at known noise")
    if whole:

        def slow(at: np.ndarray) -> np.ndarray:
            return np.concatenate([solve_ivp_pass(settled, at, path.gains)[use] / np.sqrt(path.s[use]), at])

        start = time.perf_counter()
        theirs = least_squares(slow, np.zeros(len(z)), bounds=bounds, diff_step=1e-4)
        took = time.perf_counter() - start
        print(
            f"the whole of it over solve_ivp, run: {took:.0f} s, {theirs.nfev} steps: {took / same:.0f} times as long"
        )


def solve_ivp_pass(problem: Problem, z: np.ndarray, gains: np.ndarray) -> np.ndarray:
    """The innovations with SciPy's integrator between events."""
    from scipy.integrate import solve_ivp

    from upright.calibrate.parameters import with_values

    recording = problem.recordings[0]
    robot = with_values(problem.robot, {p.name: float(p.value(z[i])) for i, p in enumerate(problem.parameters)})
    reads = problem.lanes(recording, z[:, None]).reads[:, :, 0]
    moment = recording.when - problem.own_delays(recording, z)
    x, u, found, now = recording.first.copy(), recording.commands[0], np.full(len(moment), np.nan), None
    for event in problem.order(recording, z):
        if now is not None and moment[event] > now:
            span = (now, moment[event])
            x[:6] = solve_ivp(lambda _, s, u=u: derivative(s, u, robot), span, x[:6], rtol=1e-6, atol=1e-9).y[:, -1]
        now = moment[event]
        row = recording.kind[event]
        if row < 0:
            u = recording.commands[int(recording.value[event])]
        else:
            found[event] = recording.value[event] - reads[row] @ x
            x = x + gains[event] * found[event]
    return found


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=0, help="logs of each kit for coverage (default: time only)")
    parser.add_argument("--quiet", type=int, default=0, help="the same on logs that nobody excited")
    parser.add_argument("--families", type=int, default=0, help="robots of each kit with three runs that differ")
    parser.add_argument("--plain", action="store_true", help="of a family, its three runs together and no more")
    parser.add_argument("--first", type=int, default=0, help="the first seed of coverage (default 0)")
    parser.add_argument("--whole", action="store_true", help="run SciPy's fit to its end too (several minutes)")
    parser.add_argument("--untimed", action="store_true", help="leave the timing out")
    parser.add_argument("--robots", nargs="*", default=list(DITHER), help="presets to draw from")
    asked = parser.parse_args()
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy", "numba"))
    processor = platform.processor() or platform.machine()
    print(f"{processor}, {os.cpu_count()} cores; Python {platform.python_version()}, {packages}")
    if not asked.untimed:
        timing(asked.whole)
    for name in asked.robots if asked.seeds else ():
        coverage(name, range(asked.first, asked.first + asked.seeds))
    for name in asked.robots if asked.quiet else ():
        coverage(name, range(asked.first, asked.first + asked.quiet), quiet=True)
    for name in asked.robots if asked.families else ():
        families(name, range(asked.first, asked.first + asked.families), plain=asked.plain)


if __name__ == "__main__":
    main()
