"""How fast the fleet's kernel is: beside hand-written C on the same loop, beside MuJoCo, and against itself.

    python benchmarks/fleet.py            # everything, about four minutes on two cores
    python benchmarks/fleet.py --quick    # fewer repeats

One step is one Runge–Kutta step of 1 ms of one robot; feedback is held over 10 ms; every robot has its own parameters.
Times are the best of several repeats taken in turns.
"""

# ruff: noqa: E501 (what is printed, and code for other processes, is clearer in one piece)

from __future__ import annotations

import ctypes
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

import harness
import numpy as np

from upright.bodies import NonlinearBody
from upright.compiled.generated import Constants
from upright.control import Estimated, kalman, lqr_state, make_controller
from upright.control.law import as_law, program
from upright.experiment import Push, run
from upright.fleets.ensemble import Ensemble
from upright.fleets.push_map import PushGrid, push_map
from upright.fleets.sweep import find_controller
from upright.kernel import store
from upright.kernel.batch import FleetBatch, idle, parameters_of
from upright.kernel.functions import compiled
from upright.kernel.pack import constants
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Family, Uncertainty

HERE = Path(__file__).parent
ROBOT = Robot.preset("nxtway-gs")
PERIOD, STRIDE, STEP = 0.01, 10, 0.001
CONSTANTS = [
    Constants._fields.index(name)
    for name in (
        "motor_damping", "centrifugal", "weight", "motor_torque", "lever", "rolling_damping", "turning_lever",
        "yaw_coriolis", "yaw_lever", "yaw_damping", "yaw_motor_torque", "rotor_coupling", "pitch_inertia", "yaw_swing",
    )
]  # fmt: skip
"""Which of the kernel's the C needs, in the order of its enum."""

FLAGS = ("-O3", "-march=native", "-ffast-math", "-mprefer-vector-width=512", "-shared", "-fPIC")


def spread_fleet(n: int) -> np.ndarray:
    """Parameters of n robots whose centre of mass and body differ by up to 10 %."""
    rng = np.random.default_rng(1)
    around = {
        name: getattr(ROBOT, name) * rng.uniform(0.9, 1.1, n) for name in ("com_height", "body_mass", "pitch_inertia")
    }
    return parameters_of(ROBOT, around)


def start_of(n: int) -> np.ndarray:
    start = np.zeros((n, 6))
    start[:, 0] = np.linspace(-0.05, 0.05, n)
    return start


def bare(n: int, **options: Any) -> FleetBatch:
    return FleetBatch(
        parameters=spread_fleet(n), controller=lqr_state(ROBOT, 0.01), start=start_of(n), substeps=1, **options
    )


def full(n: int, jitter: float = 0.0) -> FleetBatch:
    """A Kalman filter on quantised, noisy sensors, dead time, saturation with sag, dead zone and a push.

    `jitter` [s] counts in whole steps of 1 ms: the kit's own 0.5 ms would be none.
    """
    kit = replace(Kit.preset("nxt"), jitter=jitter)
    controller = Estimated(lqr_state(ROBOT, 0.01), kalman(ROBOT, kit))
    push = [[[0.5, np.nan, 0.2, 0.1]]]
    return FleetBatch(
        parameters=spread_fleet(n), controller=controller, start=start_of(n), kit=kit, pushes=push, substeps=1
    )


class Roofline:
    """benchmarks/roofline.c, compiled for one width of block."""

    def __init__(self, folder: Path, lanes: int = 64) -> None:
        built = folder / f"roofline-{lanes}.so"
        command = [
            "gcc",
            *FLAGS,
            f"-DLANES={lanes}",
            str(HERE / "roofline.c"),
            "-o",
            str(built),
            "-lm",
        ]
        subprocess.run(command, check=True)
        self._run: Any = ctypes.CDLL(str(built)).simulate
        self._run.argtypes = [ctypes.c_void_p] * 3 + [ctypes.c_long] * 3 + [ctypes.c_double]
        self._lanes = lanes

    def job(self, n: int, periods: int, threads: int = 1) -> Callable[[], None]:
        """The bare loop for n robots (rounded up to whole blocks), as a function to be timed."""
        many = -(-n // self._lanes) * self._lanes
        table = np.ascontiguousarray(constants(bare(many))[:, CONSTANTS])
        gain, start = np.ascontiguousarray(lqr_state(ROBOT, 0.01).gain), start_of(many)
        parts = np.array_split(np.arange(many // self._lanes) * self._lanes, threads)
        bounds = [(int(p[0]), int(p[-1]) + self._lanes) for p in parts if len(p)]

        def part(states: np.ndarray, first: int, last: int) -> None:
            x, c = states[first:last], table[first:last]
            self._run(x.ctypes.data, c.ctypes.data, gain.ctypes.data, last - first, periods, STRIDE, STEP)

        def job() -> None:
            states = start.copy()
            if threads == 1:
                part(states, 0, many)
                return
            with ThreadPoolExecutor(threads) as pool:
                list(pool.map(lambda bound: part(states, *bound), bounds))

        return job


def kernel(batch: FleetBatch, periods: int, threads: int = 1) -> Callable[[], None]:
    return lambda: simulate(batch, periods * PERIOD, threads=threads) and None


def periods_for(n: int, steps: float = 3e7) -> int:
    """Periods that make about `steps` steps: at least 2 s and at most 30 s of simulated time."""
    return int(np.clip(steps / (n * STRIDE), 200, 3000))


def against_c(folder: Path, repeats: int) -> None:
    print("\nbare loop, one thread: M steps/s of the kernel and of the C (bar: 0.9 of it)")
    roof = Roofline(folder)
    for n in (1_000, 10_000, 100_000):
        periods = periods_for(n)
        jobs = {"kernel": kernel(bare(n), periods), "C": roof.job(n, periods)}
        t = harness.best(jobs, max(3, min(repeats, 300_000 // n)), time.thread_time)
        rate = n * periods * STRIDE / 1e6
        print(f"  n = {n:7d}: {rate / t['kernel']:6.1f}  {rate / t['C']:6.1f}  {t['C'] / t['kernel']:5.2f}")
    print("\nsensors, noise, delay, saturation, Kalman filter: M steps/s and share of the bare C (bar 0.5)")
    n = 10_000
    periods = periods_for(n)
    jobs = {"kernel": kernel(full(n), periods), "late": kernel(full(n, 0.001), periods)}
    t = harness.best(jobs | {"C": roof.job(n, periods)}, repeats, time.thread_time)
    rate = n * periods * STRIDE / 1e6
    print(
        f"  n = {n:7d}: {rate / t['kernel']:6.1f}  {t['C'] / t['kernel']:5.2f}"
        f"   with a jitter of 1 ms too: {rate / t['late']:6.1f}  {t['C'] / t['late']:5.2f}"
    )
    scalar = Roofline(folder, lanes=1)
    for periods in (1000, 20_000):
        jobs = {"kernel": kernel(bare(1), periods), "C": scalar.job(1, periods)}
        t = harness.best(jobs, repeats * (20 if periods == 1000 else 1), time.thread_time)
        said = f"one robot for {periods * PERIOD:.0f} s: {1e3 * t['kernel']:.2f} ms, scalar C {1e3 * t['C']:.2f} ms"
        print(f"\n{said}: {t['kernel'] / t['C']:.2f} × (bar 1.5)", end="")
    t = harness.best({"kernel": kernel(bare(1), 1)}, repeats * 20, time.thread_time)
    print(f"\n  of which a call costs {1e3 * t['kernel']:.2f} ms however short")


def laws(repeats: int) -> None:
    """What a controller adds to a run in which the same sensors are read and nothing is commanded."""
    kit, n, periods = Kit.preset("nxt"), 2048, 100
    designs = {name: make_controller(name, ROBOT, kit, PERIOD) for name in ("lqg", "lqi", "pid", "hinf", "sliding")}
    every = {**designs, "nothing": idle(designs["lqg"].spec)}
    print(
        "\ncontrollers in the kernel: products of a period, ns a robot and period, first use without and with the disk"
    )
    jobs: dict[str, Callable[[], None]] = {}
    with tempfile.TemporaryDirectory() as cache, patch.dict(os.environ, UPRIGHT_CACHE=cache):
        first: dict[str, list[float]] = {name: [] for name in designs}
        for _ in range(2):
            compiled.cache_clear()
            store._functions_of.cache_clear()
            for name, controller in designs.items():
                began = time.thread_time()
                compiled(as_law(controller), 0)
                first[name].append(time.thread_time() - began)
    for name, controller in every.items():
        batch = FleetBatch(parameters=spread_fleet(n), controller=controller, kit=kit, substeps=1)
        jobs[name] = kernel(batch, periods)
    t = harness.best(jobs, repeats, time.thread_time)
    for name, controller in designs.items():
        products, added = program(as_law(controller), 0).operations(), (t[name] - t["nothing"]) / (n * periods)
        cold, warm = first[name]
        print(
            f"  {name:8s} {products:5d}  {1e9 * added:6.1f} of {1e9 * t[name] / (n * periods):.0f}  {cold:.3f} s  {warm:.3f} s"
        )


def scaling(folder: Path | None, repeats: int) -> None:
    print("\ntwo threads against one (bar 1.85), n = 100 000")
    n, periods = 100_000, 60
    jobs = {f"kernel {threads}": kernel(bare(n), periods, threads=threads) for threads in (1, 2)}
    if folder:
        roof = Roofline(folder)
        jobs |= {f"C {threads}": roof.job(n, periods, threads) for threads in (1, 2)}
    t = harness.best(jobs, repeats)
    for name in ("kernel", "C") if folder else ("kernel",):
        rate = n * periods * STRIDE / 1e6 / t[f"{name} 2"]
        print(f"  {name:6s} {t[f'{name} 1'] / t[f'{name} 2']:.2f} ×, {rate:.0f} M steps/s on two threads")


def flatness(repeats: int) -> None:
    seconds = 2.0
    print(f"\ncost of a robot [µs of processor time], {seconds:g} s each, two threads (bar: flat within 10 %)")
    costs: list[float] = []
    for n in (1_000, 10_000, 100_000, 1_000_000):
        batch = bare(n)
        # small batches are over before a processor has found its pace
        many = max(1, repeats // 4) if n > 100_000 else max(3, repeats, 40_000 // n)
        job = {"kernel": lambda b=batch: simulate(b, seconds, threads=2) and None}
        t = harness.best(job, many, time.process_time)
        costs.append(1e6 * t["kernel"] / n)
        print(f"  n = {n:8d}: {costs[-1]:.2f}")
    middle = (max(costs) + min(costs)) / 2
    print(f"  within ±{100 * (max(costs) - middle) / middle:.0f} % of {middle:.2f}")


def equality() -> None:
    """Every state of 10 s, under a push, against the single-robot path."""
    push, rows = Push(force=1.0, start=1.0, duration=0.1), [[1.0, np.nan, 1.0, 0.1]]
    start = (0.05, 0.0, 0.1, 0.0, 0.2, 0.0)
    log = run(NonlinearBody(ROBOT), lqr_state(ROBOT, 0.01), push, start=start, seconds=10.0)
    batch = FleetBatch(parameters=parameters_of(ROBOT), controller=lqr_state(ROBOT, 0.01), start=start, pushes=rows)
    fleet = simulate(batch, 10.0, record=1).trace[0]
    apart = np.abs(log.state()[: len(fleet)] - fleet).max()
    print(f"\n10 s under a push, kernel against the single-robot path: {apart:.1e} (bar 1e-9)")


def largest_pushes() -> None:
    family = Family(ROBOT, Kit.preset("nxt"), Uncertainty.of(ROBOT))
    ensemble = Ensemble(family=family, controller=find_controller("lqr", ROBOT, family.kit))
    grid = PushGrid(heights=np.linspace(0.0, ROBOT.body_height, 64), durations=np.linspace(0.01, 0.5, 64))
    wall, used = time.perf_counter(), time.process_time()
    data = push_map(ensemble, grid, samples=200, threads=2).data
    wall, used = time.perf_counter() - wall, time.process_time() - used
    runs = json.loads(data.attrs["origin"])["push_map"]["runs"]
    print(f"\npush map, 64 × 64 points in both directions, band of 200 samples (bar 60 s): {wall:.1f} s", end="")
    print(f", {used:.1f} s of processor time, {runs} runs")


def memory() -> None:
    """Peak memory as Linux counts it; elsewhere nothing is said."""
    if not Path("/proc/self/status").exists():
        return
    code = (
        "import re, sys; sys.path.insert(0, sys.argv[1]); import fleet;"
        "b = fleet.bare(1000); fleet.simulate(b, 0.1, threads=2); r = lambda: re.search(r'VmHWM:\\s+(\\d+)', open('/proc/self/status').read())[1];"
        "a = r(); b = fleet.bare(int(sys.argv[2])); c = r(); fleet.simulate(b, 0.1, threads=2); print(a, c, r())"
    )
    n = 1_000_000
    said = subprocess.run([sys.executable, "-c", code, str(HERE), str(n)], capture_output=True, text=True, check=True)
    before, made, after = map(int, said.stdout.split())
    share = 1024 / n  # the two are counted in KiB
    print(
        f"\nmemory at n = 10⁶: {(made - before) * share:.0f} bytes a robot at the most while the batch is made, {(after - made) * share:.0f} more to run it"
    )


def first_call() -> None:
    code = (
        "import time, numpy, scipy.linalg; from upright.robots import Robot; from upright.control import lqr_state; r = Robot.preset('nxtway-gs');"
        "k = lqr_state(r, 0.01); t = time.perf_counter(); from upright.kernel.simulate import simulate;"
        "from upright.kernel.batch import FleetBatch, parameters_of;"
        "simulate(FleetBatch(parameters=parameters_of(r), controller=k), 1.0); print(time.perf_counter() - t)"
    )
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "UPRIGHT_CACHE": folder}
        for said in ("cold (bar 6)", "warm (bar 0.3)", "warm again"):
            run = subprocess.run(
                [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True
            )
            print(f"\nimport of the kernel and first call in a new process, {said}: {float(run.stdout):.2f} s", end="")
    print()


def against_mujoco(repeats: int) -> None:
    """`mujoco.rollout` of the twin on two threads: contacts solved at 0.25 ms, no controller, commands of zero."""
    from mujoco import MjData, MjModel, rollout

    from upright.bodies.mjcf import mjcf

    contact = {"contact_time": 0.0005, "grip": 10.0}
    model = MjModel.from_xml_string(mjcf(ROBOT, timestep=0.00025, **contact))
    many, seconds = 32, 1.0
    data = [MjData(model) for _ in range(2)]
    import mujoco

    state = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data[0], state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    first, steps = np.tile(state, (many, 1)), round(seconds / 0.00025)
    t_rollout = harness.best(
        {"rollout": lambda: rollout.rollout([model] * many, data, first, nstep=steps) and None}, 2
    )["rollout"]
    n = 100_000
    t_kernel = harness.best({"kernel": lambda: simulate(bare(n), seconds, threads=2) and None}, max(2, repeats // 3))[
        "kernel"
    ]
    ours, theirs = n * seconds / t_kernel, many * seconds / t_rollout
    print(
        "\nrobot-seconds a second on two threads (bar 500 ×): ours in closed loop, RK4 at 1 ms, no contacts to solve (wheels roll);"
    )
    print(
        f"  mujoco.rollout of the twin open loop at 0.25 ms with contacts: {ours:.3g} against {theirs:.3g}: {ours / theirs:.0f} ×"
    )


def main() -> None:
    repeats = 4 if harness.options(__doc__, quick=False).quick else 15
    harness.machine("numpy", "numba", "llvmlite", "mujoco")
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made) if shutil.which("gcc") else None
        if folder:
            against_c(folder, repeats)
        else:
            print("no gcc here, so no roofline")
        laws(repeats)
        scaling(folder, repeats)
    flatness(repeats)
    memory()
    against_mujoco(repeats)
    equality()
    largest_pushes()
    first_call()


if __name__ == "__main__":
    main()
