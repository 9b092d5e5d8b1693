"""Are calibrations true on logs that nobody here made: do runs of one robot agree, and do they predict each other?

    python benchmarks/real_logs.py                 # all of ../shared/data: about five minutes on two quiet cores
    python benchmarks/real_logs.py --only twipr    # one robot's runs
    python benchmarks/real_logs.py --preset ev3way --only ev3way    # from the file of another robot
    python benchmarks/real_logs.py --only ev3way --alone --swing 14    # what a swing of the gyro at 14 Hz would bend

Every EV3 run is calibrated alone from three cuts, TWIPR's two runs from their first row, then each robot's runs
together. Printed are R² of half seconds simulated freely, on the run itself, crossed to the others, and of one set of
numbers for all; how many numbers are visible; which pairs of their 95 % intervals overlap; how wide these are beside
those of a right model (Fisher's information at the noise that was found); and the time. TWIPR's loop is also simulated
freely from its first state, under the law that its commands show.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import combinations, permutations

import harness
import numpy as np

from planted.real_runs import DATA, PRESETS, Run, crossed, loops, runs
from upright.calibration.calibrate import calibrate, prepared
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import VISIBLE, Estimate
from upright.calibration.own_run import as_driven, of_this_run
from upright.errors import UprightError
from upright.robots import Robot, find_kit

BANDS = (0, 6, 12)  # [Hz]
ASKED = (3.0, 4.5)  # [Hz]
FAST = (5.7, 7.1, 8.5, 10.0, 11.4)  # [Hz]
PUT_DOWN = 0.4  # [s] until then a hand may hold the robot


def visible(found: Calibration) -> dict[str, Estimate]:
    """What a calibration calls visible."""
    every = (*found.parameters, *found.combinations, *found.delays, *found.electronics)
    return {e.name: e for e in every if e.verdict == VISIBLE}


def own_effects(found: Calibration, other: Run) -> dict[str, float]:
    """The same with what belongs to the other run fitted to it, as `upright validate` does; as known, where that
    predicts no better."""
    robot = found.known_robot()
    log, _ = as_driven(other.log, robot, find_kit(robot.kit))
    fitted = of_this_run(*prepared([log], robot, find_kit(robot.kit), (), 0.0))
    return {name: fitted[0].r_squared(name) for name in fitted[0].rows} if fitted else crossed(found, other)


def line(scores: dict[str, float]) -> str:
    """R² of the gyro, and the least of the wheels."""
    wheels = [v for n, v in scores.items() if n.startswith("sensor/encoder")]
    return f"gyro {scores['sensor/gyro']:.4f}  wheels {min(wheels):.4f}"


def left_by_band(found: Calibration) -> str:
    """What half seconds leave of the gyro in each band, over what it has there; and which part of all that this is."""
    parts = found.free[0]
    at = (parts.row == parts.rows.index("sensor/gyro")) & np.isfinite(parts.predicted)
    measured, left = parts.measured[at], (parts.measured - parts.predicted)[at]
    frequency = np.fft.rfftfreq(len(left), float(np.median(np.diff(parts.when[at]))))
    power, of_all = (np.abs(np.fft.rfft(y - y.mean())) ** 2 for y in (left, measured))
    words: list[str] = []
    for low, high in zip(BANDS, (*BANDS[1:], np.inf), strict=True):
        inside = (frequency >= low) & (frequency < high)
        share, part = power[inside].sum() / of_all[inside].sum(), power[inside].sum() / power.sum()
        words.append(f"from {low} Hz {share:.0%} of the gyro, {part:.0%} of what is left")
    return "; ".join(words)


def per_volt(one: Run) -> str:
    """How many rad/s gyro and wheels turn for a volt near `ASKED`, where every EV3 run has coherent motion, and how far
    the gyro turns for the wheels near `FAST`: Welch's cross-spectra with the command, and no model. Runs of one robot
    agree in the first, if the logged command is what reached the motors. The second is constant for a stiff body."""
    from scipy.signal import csd, welch

    log = one.log.between(PUT_DOWN, np.inf)
    t = np.arange(log.t[0], log.t[-1], log.period)
    volts, gyro, wheels = (
        np.interp(t, log.t, column)
        for column in (
            (log["applied/left"] + log["applied/right"]) / 2, log["sensor/gyro"],
            (log["sensor/encoder_left"] + log["sensor/encoder_right"]) / 2,
        )
    )  # fmt: skip
    size = min(64, len(t) // 2)
    frequency, power = welch(volts, 1 / log.period, nperseg=size, detrend="linear")
    turn, roll = (abs(csd(volts, y, 1 / log.period, nperseg=size, detrend="linear")[1]) / power for y in (gyro, wheels))
    rate, words = 2 * np.pi * frequency * roll, list[str]()
    for asked in ASKED:
        at = int(np.argmin(np.abs(frequency - asked)))
        words.append(f"at {frequency[at]:.1f} Hz gyro {turn[at]:.2f}, wheels {rate[at]:.2f} rad/s")
    fast = [int(np.argmin(np.abs(frequency - asked))) for asked in FAST]
    over = ", ".join(f"{turn[at] / rate[at]:.2f} at {frequency[at]:.1f} Hz" for at in fast)
    return f"for a volt, {'; '.join(words)}; gyro over wheels {over}"


def overlap(results: Sequence[tuple[Run, Calibration]], *, runs_apart: bool) -> str:
    """Pairs of intervals of one number that overlap, of two runs or of two cuts of one, and what is apart."""
    there, apart = 0, Counter[str]()
    for (one, first), (two, second) in combinations(results, 2):
        if (one.name != two.name) == runs_apart:
            a, b = visible(first), visible(second)
            for name in a.keys() & b.keys():
                together = a[name].low <= b[name].high and b[name].low <= a[name].high
                there += together
                apart[name] += not together
    every = there + apart.total()
    worst = ", ".join(f"{name} {count}" for name, count in apart.most_common(8) if count)
    return f"{there} of {every} pairs overlap ({there / max(every, 1):.0%}); apart: {worst or 'none'}"


def alone(robot: str, model: Robot, swing: float = 0.0) -> list[tuple[Run, Calibration]]:
    """Each run calibrated alone, with a line for each; without a `swing` [Hz] where one is named."""
    results: list[tuple[Run, Calibration]] = []
    for one in runs(robot, swing):
        clock = harness.Clock()
        try:
            found = calibrate(one.log, model)
        except UprightError as error:
            print(f"  {one!s:<18} {error}", flush=True)
            continue
        widths = f"visible {len(visible(found))}, widths {found.widening:.2f} × Fisher's"
        print(f"  {one!s:<18} {line(dict(found.segments))}  {widths}, {clock}")
        print("".join(f"      refused: {reason}\n" for reason in found.refused), end="", flush=True)
        if swing:
            every = {e.name: e for e in found.combinations}
            numbers = (f"{every[n].value:.3g} ({every[n].low:.3g} to {every[n].high:.3g})" for n in ("a11", "a22/a11"))
            print("      a11 [kg m²] {}, a22/a11 {}".format(*numbers), flush=True)
        elif not one.cut:
            print(f"      {left_by_band(found)}", flush=True)
            if robot == "ev3way":
                print(f"      {per_volt(one)}", flush=True)
        if not found.refused:
            results.append((one, found))
    return results


def together(robot: str, model: Robot, swing: float = 0.0) -> None:
    """One set of numbers for all runs, on each of them; without a `swing` [Hz] where one is named."""
    whole = [one for one in runs(robot, swing) if not one.cut]
    clock = harness.Clock()
    found = calibrate([one.log for one in whole], model)
    print(f"  together: visible {len(visible(found))}, {clock}")
    print("".join(f"      refused: {reason}\n" for reason in found.refused), end="")
    for one, parts in zip(whole, found.free, strict=True):
        own = {name: parts.r_squared(name) for name in parts.rows}
        print(f"      {one.name:<12} with its own friction {line(own)}; the robot alone {line(crossed(found, one))}")


def main() -> None:
    asked = harness.options(__doc__, only=tuple(PRESETS), preset=str, alone=False, swing=0.0)
    for robot in asked.only:
        if not (DATA / robot).is_dir():
            print(f"{robot}: skipped, since {DATA / robot} is missing")
            continue
        model = Robot.preset(asked.preset or PRESETS[robot])
        print(f"{robot}, each run alone from {model.name}")
        results = alone(robot, model, asked.swing)
        print(f"  runs: {overlap(results, runs_apart=True)}")
        print(f"  cuts: {overlap(results, runs_apart=False)}")
        whole = [(one, found) for one, found in results if not one.cut]
        for (one, found), (other, _) in permutations(whole, 2):
            own = line(own_effects(found, other))
            print(
                f"  {one.name} predicts {other.name}: {line(crossed(found, other))}; with its run's effects {own}",
                flush=True,
            )
        for one, found in whole if robot == "twipr" else ():
            for words, (pitch, rate, fell) in loops(one, found).items():
                ends = "" if fell is None else f", and falls at {fell:.2f} s"
                print(f"  {one.name}: its loop with {words}: pitch {pitch:.3f}, wheel rate {rate:.3f}{ends}")
        if not asked.alone:
            together(robot, model, asked.swing)


if __name__ == "__main__":
    main()
