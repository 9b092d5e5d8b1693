"""How well a post-mortem measures the push that felled a robot: planted impulses on twins, beside what it says.

python benchmarks/push_size.py --runs 12 --seed 1 --robot nxtway-gs
"""

from __future__ import annotations

import argparse

import numpy as np

from upright.bodies import Electronics, make_body
from upright.control import find_controller
from upright.diagnose.evidence import gather
from upright.experiment import Impulse, run
from upright.logs.raw import raw_log
from upright.progress import unwatched
from upright.robots import find_kit, find_robot

LENGTHS = (0.005, 0.01, 0.02, 0.04)  # [s] of a push


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--runs", type=int, default=12)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--robot", default="nxtway-gs")
    options.add_argument("--body", default="twin")
    options.add_argument(
        "--least", type=float, default=0.38, help="smallest impulse [N s]; the largest is 1.6 times it"
    )
    chosen = options.parse_args()
    random, robot = np.random.default_rng(chosen.seed), find_robot(chosen.robot)
    kit, ratios = find_kit(robot.kit), list[float]()
    for _ in range(chosen.runs):
        impulse = float(random.uniform(1.0, 1.6) * chosen.least * random.choice([-1, 1]))
        length, start = float(random.choice(LENGTHS)), float(random.uniform(3.0, 4.0))
        controller = find_controller("lqg", robot, kit, kit.period)
        body = Electronics(make_body(chosen.body, robot), kit)
        blow = Impulse(impulse=impulse, start=start, duration=length)
        log = run(body, controller, [blow], seconds=6.0, seed=int(random.integers(10**6)))
        _, evidence = gather(raw_log(log), robot, kit, None, unwatched)
        pushes = (
            [p for p in evidence.pushes_only.pushes if p.start > evidence.fell_at - evidence.excursion]
            if evidence
            else []
        )
        if evidence is None or not pushes:
            print(
                f"{impulse:+.3f} N s for {1e3 * length:g} ms: {'no push seen' if evidence else 'it stood'}", flush=True
            )
            continue
        lean = evidence.toppling.lean
        push = max(pushes, key=lambda p: abs(lean(p)))
        ratios.append(push.impulse / impulse)
        print(
            f"{impulse:+.3f} N s for {1e3 * length:g} ms: {push.impulse:+.3f} N s, {ratios[-1]:.3f} of it", flush=True
        )
    if ratios:
        least, most, middle = min(ratios), max(ratios), float(np.median(ratios))
        print(
            f"{len(ratios)} falls of {robot.name} ({chosen.body}): {least:.3f} to {most:.3f} of it, median {middle:.3f}"
        )


if __name__ == "__main__":
    main()
