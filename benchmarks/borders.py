"""Whether the push map tells the first border: against brute force, robot by robot.

    python benchmarks/borders.py                 # 20 random pushes on each of 3 robots under 3 controllers
    python benchmarks/borders.py --points 5      # fewer

Brute force tries impulses from a tenth of the map's largest one up, each 1 % above the one before, until one fells the
robot: the first border is the last that it survived.
"""

from __future__ import annotations

import argparse
import os
import time

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads

import numpy as np
from numpy.typing import NDArray

from upright.fleet.fleet import ensemble_of
from upright.fleet.push_map import PushGrid, _Search, push_map

ROBOTS = ("nxtway-gs", "ev3way", "herrera2015")
DESIGNS = ("lqg", "hinf", "pid")
BAR = 0.03
STEP = 1.01
Array = NDArray[np.float64]


def brute(search: _Search, direction: int, height: float, duration: float, most: float) -> float:
    """The first border [N s] of one push."""
    tried = np.geomspace(0.1 * most, 1.05 * most, round(np.log(10.5) / np.log(STEP)))
    points = (np.array([float(direction)]), np.array([height]), np.array([duration]))
    table = search.ensemble.nominal().batch(np.zeros(1, dtype=np.int64))
    stood = search._stand(table, points, tried, np.zeros(len(tried), dtype=np.int64), search.watch)
    return float(tried[-1]) if stood.all() else float(tried[max(0, int(np.argmin(stood)) - 1)])


def compared(robot: str, design: str, points: int, rng: np.random.Generator) -> list[tuple[float, float, float]]:
    """(first border of the map, that of brute force, last border) [N s] of random pushes."""
    ensemble = ensemble_of(robot, controller=design, vary=())
    search = _Search(ensemble, 0.01, 5.0, 1.0, None)
    rows: list[tuple[float, float, float]] = []
    for _ in range(points):
        direction = int(rng.choice([1, -1]))
        height = float(rng.uniform(0.0, ensemble.family.robot.body_height))
        duration = float(rng.uniform(0.01, 0.5))
        grid = PushGrid(directions=(direction,), heights=np.array([height]), durations=np.array([duration]))
        data = push_map(ensemble, grid, samples=0)
        first, last = float(data["impulse"].item()), float(data["last"].item())
        if last > 0:
            rows.append((first, brute(search, direction, height, duration, last), last))
    return rows


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng, worst, began = np.random.default_rng(options.seed), 0.0, time.perf_counter()
    print(f"{'robot':<14}{'controller':<12}{'points':>7}{'islands':>9}{'largest error':>15}{'of last border':>16}")
    for robot in ROBOTS:
        for design in DESIGNS:
            rows = compared(robot, design, options.points, rng)
            errors = [abs(first / truth - 1) for first, truth, _ in rows]
            before = [abs(last / truth - 1) for _, truth, last in rows]
            islands = sum(first < 0.999 * last for first, _, last in rows)
            worst = max(worst, *errors)
            told = f"{len(rows):>7}{islands:>9}{max(errors):>15.1%}{max(before):>16.1%}"
            print(f"{robot:<14}{design:<12}{told}", flush=True)
    print(f"largest error {worst:.1%} (bar: {BAR:.0%}), {time.perf_counter() - began:.0f} s")


if __name__ == "__main__":
    main()
