"""What `upright tune` gains: default against tuned weights on robots that the search never saw.

python benchmarks/tune.py                             # lqr and lqg on five robots: a minute or two each
python benchmarks/tune.py --robots twipr --methods lqr pid hinf sliding mpc --seed 1
"""

from __future__ import annotations

import harness

from upright.errors import UprightError
from upright.tuning.figures import Figures
from upright.tuning.tune import BUDGET, tune

ROBOTS = ("herrera2015", "ev3way", "ev3way-large-wheels", "nxtway-gs", "twipr")


def cells(f: Figures) -> str:
    margin = f"{f.linear.gain_low:.2f}–{f.linear.gain_high:.2f}" if f.linear else "–"
    return (
        f"{f.light:<6}{100 * f.falls:>6.1f} %{f.knock:>8.3f}{margin:>11}{1e3 * f.delay:>7.1f}{f.settling:>7.2f}"
        f"{f.effort:>9.3g}{f.travel:>6.2f}"
    )


def main() -> None:
    asked = harness.options(__doc__, robots=ROBOTS, methods=("lqr", "lqg"), budget=BUDGET, seed=0, threads=int)
    head = f"{'light':<6}{'fell':>8}{'knock':>8}{'gains':>11}{'delay':>7}{'settle':>7}{'effort':>9}{'roll':>6}"
    print(f"{'':<32}{head}")
    for robot in asked.robots:
        for method in asked.methods:
            clock = harness.Clock()
            try:
                found = tune(method, robot, budget=asked.budget, seed=asked.seed, threads=asked.threads)
            except UprightError as error:
                print(f"{robot} {method}: {error}", flush=True)
                continue
            print(f"{robot:<20}{method:<8}{'was':<4}{cells(found.default)}")
            took, why = f"{clock.wall:.0f} s", found.kept or f"{clock.cpu:.0f} s CPU"
            print(f"{'':<20}{took:<8}{'now':<4}{cells(found.chosen)}  {why}")
            print(" " * 32 + ", ".join(f"{n} {v:.4g}" for n, v in found.weights.items()), flush=True)


if __name__ == "__main__":
    main()
