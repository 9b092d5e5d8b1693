"""How long a calibration takes, and how often its intervals hold the truth.

    python benchmarks/calibrate.py                   # time: 2000 samples, eight parameters, against SciPy
    python benchmarks/calibrate.py --seeds 100       # coverage and unstable pole on twins of three kits
    python benchmarks/calibrate.py --quiet 100       # coverage on logs that nobody excited: a hold and its release
    python benchmarks/calibrate.py --families 100    # coverage where friction, winding and floor differ between runs

With `--untimed` the timing is left out, with `--whole` SciPy's fit runs to its end (several minutes). Of a family are
calibrated: its three runs together, the first alone, and the three where one body is heavier (`--plain`: the first of
these). Truth is drawn from what each preset says of its own numbers (value and spread), from seed `--first` on; the
controller and the calibration know the preset alone. Robots that the preset's controller cannot hold fall, and are left
out and counted. `--results` is a file in which answers are kept, for a run that goes on later.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import harness
import numpy as np

from planted.twins import DITHER, FLOOR, RUNS, drawn, runs_of, truth, twin_log
from upright.calibration.annealing import annealed
from upright.calibration.calibrate import calibrate, prepared
from upright.calibration.estimate import VISIBLE, Estimate
from upright.calibration.fitting import Problem, events_of
from upright.calibration.gauss_newton import gauss_newton
from upright.calibration.parameters import ROLLING
from upright.calibration.refined import refined
from upright.calibration.summary import rolling_pole
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
EXCITED, QUIET = "20 s, excited", "10 s, quiet"
TOGETHER, ALONE, HEAVY = "three runs", "one of them", "one is heavier"


@dataclass(frozen=True)
class Told:
    """What a calibration of a robot's log, or of its runs, says: how many deviations each visible number is off its
    truth, 0 where its interval holds it; the error of the pole; and `trouble` where there is no calibration."""

    robot: str
    kind: str
    seed: int
    off: dict[str, float]
    pole: float = 0.0
    visible: int = 0
    supported: int = 0
    apart: int = 0
    seconds: float = 0.0
    trouble: str = ""

    def __str__(self) -> str:
        missed = ", ".join(f"{name} {by:+.1f} deviations" for name, by in self.off.items() if by)
        held = f"{sum(not by for by in self.off.values())} of {len(self.off)} hold"
        said = self.trouble or f"{held}{f' ({missed})' if missed else ''}; {self.seconds:.0f} s"
        return f"{self.robot}, {self.kind}, seed {self.seed}: {said}"


def off(estimates: Iterable[Estimate], right: dict[str, float]) -> dict[str, float]:
    """By how many deviations each visible number misses its truth; 0 where its interval holds it."""
    seen = [e for e in estimates if e.verdict == VISIBLE and e.name in right]
    return {e.name: 0.0 if e.low <= right[e.name] <= e.high else (e.value - right[e.name]) / e.spread for e in seen}


def logs_of(name: str, kind: str, true: Robot, seed: int) -> list[Log]:
    """The logs of a robot for one of the kinds of calibration."""
    if kind in (EXCITED, QUIET):
        return [twin_log(name, true, seed, 20.0 if kind == EXCITED else 10.0, quiet=kind == QUIET)]
    logs = runs_of(name, true, seed)
    if kind == HEAVY:
        logs[seed % RUNS] = runs_of(name, true.replace(body_mass=HEAVIER * true.body_mass), seed)[seed % RUNS]
    return logs[:1] if kind == ALONE else logs


def judged(key: tuple[str, str, int]) -> Told:
    """One robot, drawn, logged and calibrated."""
    name, kind, seed = key
    robot = Robot.preset(name)
    true, family = drawn(robot, seed), kind not in (EXCITED, QUIET)
    if family and ROLLING in robot.provenance:
        true = true.replace(rolling_friction=FLOOR)
    logs, clock = logs_of(name, kind, true, seed), harness.Clock()
    if any(log.origin["outcome"]["fell"] for log in logs):
        return Told(name, kind, seed, {}, trouble="fell")
    try:
        found = calibrate(logs, robot)
    except UprightError as error:
        return Told(name, kind, seed, {}, trouble=f"refused: {error}")
    right = truth(name, true) | {"unstable_pole": rolling_pole(true)}
    # floors differ between the runs of a family, and the constant command with them
    besides = (found["asymmetry"], found["unstable_pole"]) if family else found.electronics
    numbers = (*found.parameters, *found.delays, *besides)
    visible = {e.name for e in (*numbers, *found.combinations) if e.verdict == VISIBLE} - {GAP}
    pole = abs(rolling_pole(found.robot) / right["unstable_pole"] - 1)
    apart = int(found.apart[0].facts.get("n", -1)) if found.apart else 0  # no run alone: −1
    return Told(name, kind, seed, off(numbers, right), pole, len(visible), found.supported, apart, clock.wall)


def report(told: Sequence[Told]) -> None:
    """Coverage, pole and visible numbers of each robot and kind."""
    for name, kind in dict.fromkeys((t.robot, t.kind) for t in told):
        every = [t for t in told if (t.robot, t.kind) == (name, kind)]
        runs, held = [t for t in every if not t.trouble], harness.Held()
        for number, by in ((n, by) for t in runs for n, by in t.off.items()):
            held.add(number, not by)
        fell = sum(t.trouble == "fell" for t in every)
        print(f"\n{name}, {kind}: {len(runs)} robots ({fell} fell, {len(every) - len(runs) - fell} refused)")
        if not runs:
            continue
        right = sum(t.apart == t.seed % RUNS + 1 for t in runs)
        if kind == HEAVY:
            print(f"  the heavier run is said to differ in {harness.share(right, len(runs))}")
            continue
        poles = [t.pole for t in runs]
        print(f"  {held}\n  unstable pole: median error {np.median(poles):.2%}, worst {max(poles):.2%}")
        print(f"  visible: {sum(t.visible for t in runs)}; that a right model's Fisher information halves: "
              f"{sum(t.supported for t in runs)}")  # fmt: skip
        if kind == TOGETHER:
            print(f"  a run is said to differ from the others: {sum(bool(t.apart) for t in runs)}")


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
    busy = harness.best({"ours": ours}, 5, time.process_time)["ours"]
    print(f"optimisation, {len(log)} samples, {len(problem.asked)} parameters: {busy:.3f} s of processors (best of 5)")
    scipy_time(problem, limits, whole)


def scipy_time(problem: Problem, limits: dict[str, float], whole: bool) -> None:
    """`least_squares` with differences over `solve_ivp`: one pass is timed, the passes are counted on our own
    residuals, which are the same numbers; the product is what the whole would take. With `whole` it is run."""
    from scipy.optimize import least_squares

    from upright.calibration.predictor import innovations

    found, z, *_ = refined(*annealed(problem, limits), limits)
    settled, z = replace(found, parameters=found.asked), z[: len(found.asked)]  # those that are told, for both alike
    job = {"ours": lambda: gauss_newton(settled, np.zeros(len(z)), iterations=20)}
    same = harness.best(job, 5, time.process_time)["ours"]
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

    from upright.calibration.parameters import with_values

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
    asked = harness.options(
        __doc__, seeds=0, quiet=0, families=0, plain=False, first=0, whole=False, untimed=False, robots=tuple(DITHER),
        workers=1, results=Path,
    )  # fmt: skip
    harness.machine("numpy", "scipy", "numba")
    if not asked.untimed:
        timing(asked.whole)
    kinds = {EXCITED: asked.seeds, QUIET: asked.quiet, TOGETHER: asked.families}
    kinds |= {} if asked.plain else {ALONE: asked.families, HEAVY: asked.families}
    keys = [(n, k, asked.first + i) for n in asked.robots for k, count in kinds.items() for i in range(count)]
    report(harness.cases(judged, keys, Told, asked.workers, asked.results))


if __name__ == "__main__":
    main()
