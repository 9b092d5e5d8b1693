"""Is a gain that a log's file states found where the motors had it, and never where they had not?

    python benchmarks/gains.py                   # 10 twins, 10 robots of others, 6 families: twenty quiet minutes
    python benchmarks/gains.py --first 9300 --only twins

- **twins**: robots drawn from what the preset says of its own numbers. Their program multiplies its commands by a gain
  and cuts them at full duty, and logs them before that or after it. A battery that is too small cuts one row in ten,
  another none.
- **others**: robots of another simulator (`tests/foreign_robots.py`), within a third of its numbers. The file states
  the gain of something else. The kit has a dead zone that their motors have not.
- **families**: three runs of one twin with another friction, winding and floor each. No file states a gain. In one of
  the runs the commands are those before a gain, or in none.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command `upright` does

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from planted.foreign import Bot, Course, known, logged, metric
from planted.twins import DITHER, drawn, runs_of
from upright.bodies import Electronics
from upright.bodies.twin import Twin
from upright.calibrate.calibrate import calibrate
from upright.control import Estimated, kalman, lqr
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.experiment import run
from upright.logs.mapping import apply, propose
from upright.logs.recording import commanded
from upright.robots import Kit, Robot
from upright.signals import SIDES, Log

NAME = "nxtway-gs"
GAINS = (1.3, 2.0)
CUT = 0.9  # quantile of the commands' sizes at which a battery that is too small cuts
FACTOR = 1.6  # of one run's commands in a family
COMMANDS = tuple(f"command/{side}" for side in SIDES)
SECONDS = 8.0


def outcome(log: Log, robot: Robot) -> str:
    try:
        notes = calibrate(log, robot).notes
    except UprightError as error:
        return f"refused: {str(error)[:60]}"
    (said,) = (note for note in notes if "states gain" in note)
    return "before" if "are those before that gain" in said else "as logged"


def driven(true: Robot, seed: int, kit: Kit) -> Log:
    """Raw sensors, and the commands in volts that the program asked for, beyond full duty too."""
    robot = Robot.preset(NAME)
    controller = Estimated(lqr(robot, kit.period), kalman(robot, kit, kit.period))
    amplitude, hold = DITHER[NAME]
    dither = random_binary(round(SECONDS / kit.period), amplitude, seed, hold)
    log = run(Electronics(Twin(true), kit), Excited(controller, dither), seconds=SECONDS, seed=seed)
    if log.origin["outcome"]["fell"]:
        raise UprightError("it fell")
    names = [n for n in log.channels if n.startswith(("sensor/", "command/"))]
    return Log(log.t, {n: log[n] for n in names}, {n: log.unit(n) for n in names}, {"file": f"{seed}.csv"})


def twins(first: int, count: int) -> Iterator[tuple[str, str]]:
    kit, preset = Kit.preset("nxt"), Robot.preset(NAME)
    for seed in range(first, first + count):
        true = drawn(preset, seed)
        try:
            full = float(np.quantile(np.abs(driven(true, seed, kit)[COMMANDS[0]]), CUT))
            for words, volts in (("cut in one row of ten", full), ("hardly ever cut", kit.battery.voltage)):
                small = replace(kit, battery=replace(kit.battery, voltage=volts, sag=0.0))
                log = driven(true, seed, small)
                for gain in GAINS:
                    origin = {**log.origin, "stated_gains": {f"gain={gain}": gain}}
                    for side in ("before", "as logged"):
                        new = {
                            n: log[n] / gain if side == "before" else np.clip(log[n], -volts, volts) for n in COMMANDS
                        }
                        one = Log(log.t, {**log.channels, **new}, log.units, origin)
                        yield f"twin, {words}, gain {gain:g}, logged {side}", outcome(one, preset)
        except UprightError:
            yield "twin", "left out: it fell"


def foreign(seed: int) -> Bot:
    rng = np.random.default_rng(seed)

    def about(value: float, size: float = 0.3) -> float:
        return float(value * math.exp(size * rng.uniform(-1, 1)))

    return Bot(body=about(1.2), com=about(0.075), radius=about(0.037, 0.2), inertia=about(3.5e-3), dry=about(0.01))


def others(first: int, count: int) -> Iterator[tuple[str, str]]:
    for seed in range(first, first + count):
        bot = foreign(seed)
        columns = logged(bot, Course(free=SECONDS, excitation=1.0), seed)
        if np.abs(columns["duty"]).max() == 1.0 and np.abs(columns["tilt"]).max() > 1.0:
            yield "others", "left out: it fell"
            continue
        table = metric(columns, bot)
        for gain in (0.7, *GAINS):
            log = apply(propose(table), replace(table, comments=(f"gain={gain} (gyro amplifier)",)))
            yield f"robot of others, gain {gain:g} of something else", outcome(log, known(bot))


def families(first: int, count: int) -> Iterator[tuple[str, str]]:
    preset = Robot.preset(NAME)
    for seed in range(first, first + count):
        try:
            logs = runs_of(NAME, drawn(preset, seed), seed)
        except UprightError as error:
            yield "family", f"left out: {str(error)[:40]}"
            continue
        if any(log.origin["outcome"]["fell"] for log in logs):
            yield "family", "left out: one fell"
            continue
        for factor in (1.0, 1 / FACTOR):
            odd = logs[1]
            prefix = commanded(odd)
            changed = {f"{prefix}/{side}": factor * odd[f"{prefix}/{side}"] for side in SIDES}
            weaker = Log(odd.t, {**odd.channels, **changed}, odd.units, odd.origin)
            what = f"family, one run's commands times {factor:.3g}" if factor != 1.0 else "family, all alike"
            try:
                words = calibrate([logs[0], weaker, logs[2]], preset).apart
            except UprightError as error:
                yield what, f"refused: {str(error)[:60]}"
                continue
            yield what, words[0][:150] if words else "nothing is apart"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--first", type=int, default=9300, help="the first seed")
    parser.add_argument("--count", type=int, default=10, help="twins and robots of others; families are six tenths")
    parser.add_argument("--only", choices=("twins", "others", "families"))
    arguments = parser.parse_args()
    found: dict[str, Counter[str]] = {}
    few = arguments.count * 6 // 10
    for kind, cases in (
        ("twins", twins(arguments.first, arguments.count)), ("others", others(arguments.first, arguments.count)),
        ("families", families(arguments.first, few)),
    ):  # fmt: skip
        if arguments.only in (None, kind):
            begin = time.perf_counter()
            for what, said in cases:
                found.setdefault(what, Counter())[said] += 1
                print(f"  {what}: {said}", flush=True)
            print(f"{kind}: {time.perf_counter() - begin:.0f} s", flush=True)
    for what, counted in found.items():
        print(f"{what:<55} " + ", ".join(f"{n} {said}" for said, n in counted.most_common()))


if __name__ == "__main__":
    main()
