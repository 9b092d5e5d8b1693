"""How often the intervals of identified linear models hold the truth, and whether the estimated bias is the real one.

    python benchmarks/identify.py --seeds 40                  # three kits, all linear methods
    python benchmarks/identify.py --seeds 40 --facts          # the sensors of the project's facts: ½°, 1 °/s, 10 ms

A log is 20 s of a simulated robot under its own regulator, excited; 15 s of it are fitted. The truth is the pole of the
robot linearised, dry friction taken for the damping that brakes alike. With `--facts` the robot is the nonlinear model,
else the MuJoCo twin on its kit.
"""

from __future__ import annotations

import math
from dataclasses import replace

import harness
import numpy as np

from planted.twins import DITHER, twin_log
from upright.bodies import NonlinearBody
from upright.bodies.twin import Twin
from upright.errors import UprightError
from upright.identification.identify import identify_one, study_of
from upright.identification.judge import judge_of, loop_trial
from upright.physics.linear import unstable_pole
from upright.robots import Kit, Robot, Sensor

METHODS = ("least-squares", "total-least-squares", "instrumental", "subspace")


def facts_kit() -> Kit:
    """Encoders of ½°, a gyro with noise of 1 °/s, and nothing else."""
    nxt = Kit.preset("nxt")
    encoder, gyro = Sensor(quantum=math.radians(0.5)), Sensor(noise=math.radians(1.0))
    sensors = {"sensor/encoder_left": encoder, "sensor/encoder_right": encoder, "sensor/gyro": gyro}
    return replace(nxt, name="facts", sensors=sensors, delay=0.0, jitter=0.0)


def coverage(name: str, seeds: int, facts: bool) -> None:
    robot = Robot.preset(name)
    kit = facts_kit() if facts else Kit.preset(robot.kit)
    true = unstable_pole(robot.rolling())
    poles: dict[str, list[float]] = {m: [] for m in METHODS}
    inside: dict[str, list[bool]] = {m: [] for m in METHODS}
    biases: dict[str, list[float]] = {m: [] for m in METHODS}
    holds: dict[str, list[bool]] = {m: [] for m in METHODS}
    failed, clock = 0, harness.Clock()
    for seed in range(seeds):
        body = NonlinearBody if facts else Twin
        study = study_of(twin_log(name, robot, seed, kit=kit, body=body), robot, kit)
        judge = judge_of(study.samples)
        for method in METHODS:
            try:
                found = identify_one(study, method)
            except UprightError:
                failed += 1
                continue
            poles[method].append(found.pole.value)
            inside[method].append(found.pole.low <= true <= found.pole.high)
            biases[method].append(found.pole.bias)
            holds[method].append(loop_trial(study.samples, found.halves, judge).holds)
    spent = clock.cpu / seeds
    print(
        f"\n{name} on kit {kit.name}, {seeds} logs; unstable pole {true:.3f} 1/s; {failed} failed; {spent:.1f} s a log"
    )
    table = harness.Table(
        "  method <22", "mean >8.2f", "scatter >9.2f", "bias >8.2f", "its estimate >17", "truth inside >32",
        "holds >7.0%",
    )  # fmt: skip
    for method in METHODS:
        values = np.array(poles[method])
        estimate = f"{np.mean(biases[method]):.2f} ± {np.std(biases[method]):.2f}"
        held, bias = harness.share(sum(inside[method]), len(values)), values.mean() - true
        table.row(f"  {method}", values.mean(), values.std(), bias, estimate, held, np.mean(holds[method]))


def main() -> None:
    asked = harness.options(__doc__, seeds=10, robots=tuple(DITHER), facts=False)
    harness.machine("numpy", "scipy")
    for name in ["nxtway-gs"] if asked.facts else asked.robots:
        coverage(name, asked.seeds, asked.facts)


if __name__ == "__main__":
    main()
