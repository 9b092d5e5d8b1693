"""Are calibrations true on logs that nobody here made: do runs of one robot agree, and do they predict each other?

    python benchmarks/real_logs.py                 # all of ../shared/data: about five minutes on two quiet cores
    python benchmarks/real_logs.py --only twipr    # one robot's runs
    python benchmarks/real_logs.py --preset ev3way --only ev3way    # from the file of another robot

Every EV3 run is calibrated alone from three cuts, TWIPR's two runs from their first row, then each robot's runs
together. Printed are R² of half seconds simulated freely, on the run itself, crossed to the others, and of one set of
numbers for all; how many numbers are visible; which pairs of their 95 % intervals overlap; how wide these are beside
those of a right model (Fisher's information at the noise that was found); and the time. TWIPR's loop is also simulated
freely from its first state, under the law that its authors state.
"""

from __future__ import annotations

import argparse
import os
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, permutations
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command `upright` does

import numpy as np

from upright.bodies import NonlinearBody
from upright.calibrate.calibrate import calibrate, prepared
from upright.calibrate.calibration import VISIBLE, Calibration, Estimate
from upright.calibrate.filter_log import filter_log
from upright.calibrate.own_run import of_this_run
from upright.calibrate.validate import segments
from upright.control.controller import TRUE_STATE, ControllerSpec
from upright.errors import UprightError
from upright.experiment import run
from upright.logs.raw import raw_log
from upright.robots import Robot, find_kit
from upright.signals import Log

DATA = Path(__file__).parents[1] / "../shared/data"
CUTS = (0.0, 0.15, 0.4)  # [s] off the end of an EV3 run, which ends in a fall: the same answer is wanted for each
BANDS = (0, 6, 12)  # [Hz]
PRESETS = {"ev3way": "ev3way-large-wheels", "twipr": "twipr"}
GAINS = {"run1": (0.020, 0.040, 0.006, 0.007), "run2": (0.025, 0.040, 0.007, 0.007)}
"""TWIPR's law, by its authors: of speed, pitch, pitch rate and yaw rate."""


@dataclass(frozen=True)
class Run:
    """A run of a robot: which it is, how it was cut, and its log."""

    name: str
    cut: float
    log: Log

    def __str__(self) -> str:
        return f"{self.name} −{self.cut:g} s" if self.cut else self.name


def runs(robot: str) -> Iterator[Run]:
    """The runs of "ev3way", each with three ends, or of "twipr"."""
    if robot == "ev3way":
        for name, end in (("tilt_000", 7.4), ("nn_v7_000", np.inf), ("nn_v17_005", np.inf)):
            log = raw_log(DATA / f"ev3way/{name}.csv").between(0.0, end)
            for cut in CUTS:
                yield Run(name, cut, log.between(0.0, log.t[-1] - cut))
    else:
        second = raw_log(DATA / "twipr/run2_all.csv")
        yield Run("run1", 0.0, raw_log(DATA / "twipr/run1.csv"))
        yield Run("run2", 0.0, second.between(second.t[1283], second.t[2282]))


def visible(found: Calibration) -> dict[str, Estimate]:
    """What a calibration calls visible."""
    every = (*found.parameters, *found.combinations, *found.delays, *found.electronics)
    return {e.name: e for e in every if e.verdict == VISIBLE}


def crossed(found: Calibration, other: Run) -> dict[str, float]:
    """R² of half seconds of another run, of which the first states alone are fitted."""
    problem, _ = prepared([other.log], found.robot, find_kit(found.robot.kit), (), 0.0)
    beside = {e.name: e.value for e in (*found.delays, *found.electronics)}
    z = np.array([p.coordinate(beside[p.name]) if p.name in beside else 0.0 for p in problem.parameters])
    parts = segments(problem, problem.recordings[0], z)
    return {name: parts.r_squared(name) for name in parts.rows}


def own_effects(found: Calibration, other: Run) -> dict[str, float]:
    """The same with what belongs to the other run fitted to it, as `upright validate` does; as known, where that
    predicts no better."""
    robot = found.known_robot()
    fitted = of_this_run(*prepared([other.log], robot, find_kit(robot.kit), (), 0.0))
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


def alone(robot: str, model: Robot) -> list[tuple[Run, Calibration]]:
    """Each run calibrated alone, with a line for each."""
    results: list[tuple[Run, Calibration]] = []
    for one in runs(robot):
        clock, busy = time.perf_counter(), time.process_time()
        try:
            found = calibrate(one.log, model)
        except UprightError as error:
            print(f"  {one!s:<18} {error}", flush=True)
            continue
        took = f"{time.perf_counter() - clock:.1f} s, {time.process_time() - busy:.1f} s of processors"
        widths = f"visible {len(visible(found))}, widths {found.widening:.2f} × Fisher's"
        print(f"  {one!s:<18} {line(dict(found.segments))}  {widths}, {took}")
        print("".join(f"      refused: {reason}\n" for reason in found.refused), end="", flush=True)
        if not one.cut:
            print(f"      {left_by_band(found)}", flush=True)
        if not found.refused:
            results.append((one, found))
    return results


def together(robot: str, model: Robot) -> None:
    """One set of numbers for all runs, on each of them."""
    whole = [one for one in runs(robot) if not one.cut]
    began = time.perf_counter()
    found = calibrate([one.log for one in whole], model)
    print(f"  together: visible {len(visible(found))}, {time.perf_counter() - began:.1f} s")
    print("".join(f"      refused: {reason}\n" for reason in found.refused), end="")
    for one, parts in zip(whole, found.free, strict=True):
        own = {name: parts.r_squared(name) for name in parts.rows}
        print(f"      {one.name:<12} with its own friction {line(own)}; the robot alone {line(crossed(found, one))}")


class StatedLaw:
    """u = k1 v + k2 ψ + k3 ψ̇ ∓ k4 φ̇ + excitation [N m], on readings as late as the robot's sensors; v [m/s] is the
    speed of the wheels relative to the body."""

    spec = ControllerSpec("law of twipr's authors", TRUE_STATE, 0.001, "N m")

    def __init__(self, name: str, found: Calibration, log: Log, error: np.ndarray | None = None) -> None:
        """With `error` [rad] (rows,), the law reads a pitch as wrong as the log's own estimate, and the motors have the
        run's constant torque."""
        self._error = np.zeros(len(log)) if error is None else error
        self._constant = 0.0 if error is None else found["constant_command"].value
        self._gains, self._radius = GAINS[name], found.robot.wheel_radius
        self._late = {sensor: round(found[f"delay/{sensor}"].value / 0.001) for sensor in ("gyro", "encoder")}
        self._rows = np.searchsorted(log.t - log.t[0], np.arange(0.0, log.t[-1] - log.t[0] + 1.0, 0.001) + 1e-6) - 1
        self._excitation = np.column_stack([log["excitation/left"], log["excitation/right"]])
        self.reset()

    def reset(self) -> None:
        self._past: list[np.ndarray] = []
        self._command = (0.0, 0.0)

    def step(self, measurement: np.ndarray, reference: np.ndarray) -> tuple[float, float]:  # noqa: ARG002 (the contract)
        now, (k1, k2, k3, k4) = len(self._past), self._gains
        self._past.append(measurement.copy())
        row = self._rows[now]
        if now == 0 or row > self._rows[now - 1]:  # held from one row of the log to the next
            gyro, wheels = (self._past[max(0, now - self._late[sensor])] for sensor in ("gyro", "encoder"))
            both = k1 * self._radius * (wheels[3] - wheels[1]) + k2 * (gyro[0] + self._error[row]) + k3 * gyro[1]
            extra = self._excitation[row] + self._constant
            self._command = (both - k4 * wheels[5] + extra[0], both + k4 * wheels[5] + extra[1])
        return self._command

    def estimate(self) -> tuple[float, ...]:
        return ()

    def applied(self, command: Sequence[float]) -> None:
        pass

    def to_json(self) -> dict[str, str]:
        return {"kind": self.spec.kind}


def loop(one: Run, found: Calibration) -> None:
    """The whole closed loop simulated freely from the first state of the log, under the stated law: with the true
    pitch, and with one as wrong as the estimate that the law read, by the filter of the calibrated robot."""
    log, kit = one.log, found.kit or find_kit(found.robot.kit)
    wheel = (log["sensor/encoder_rate_left"] + log["sensor/encoder_rate_right"]) / 2
    estimate, rate = log["estimate/pitch"], float(log["sensor/gyro"][0])
    late = {sensor: found[f"delay/{sensor}"].value for sensor in ("gyro", "encoder")}
    first = (float(estimate[0]), rate, 0.0, float(wheel[0]) + rate, 0.0, 0.0)
    path = filter_log(log, found.known_robot(), kit, delay=kit.delay, disturbance=0.03)
    held = path.row < 0
    pitch = np.interp(log.t - late["gyro"], path.t[held], path.after[held, 0])

    def r_squared(measured: np.ndarray, simulated: np.ndarray, t: np.ndarray, sensor: str) -> float:
        there = np.interp(log.t - log.t[0] - late[sensor], t, simulated)
        return 1 - float(((measured - there) ** 2).sum() / ((measured - measured.mean()) ** 2).sum())

    for words, error in (("the true pitch", None), ("a pitch as wrong as its estimate", estimate - pitch)):
        free = run(
            NonlinearBody(found.robot), StatedLaw(one.name, found, log, error),
            seconds=float(log.t[-1] - log.t[0]), start=first,
        )  # fmt: skip
        scores = (
            r_squared(estimate if error is None else pitch, free["truth/pitch"], free.t, "gyro"),
            r_squared(wheel, free["truth/wheel_rate"] - free["truth/pitch_rate"], free.t, "encoder"),
        )
        fell = ", and falls" if free.origin["outcome"]["fell"] else ""
        print(f"  {one.name}: its loop with {words}: pitch {scores[0]:.3f}, wheel rate {scores[1]:.3f}{fell}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=tuple(PRESETS), nargs="*", default=list(PRESETS))
    parser.add_argument("--preset", help="calibrate from this preset instead of the robot's own")
    parser.add_argument("--alone", action="store_true", help="leave the runs together out")
    asked = parser.parse_args()
    for robot in asked.only:
        if not (DATA / robot).is_dir():
            print(f"{robot}: skipped, since {DATA / robot} is missing")
            continue
        model = Robot.preset(asked.preset or PRESETS[robot])
        print(f"{robot}, each run alone from {model.name}")
        results = alone(robot, model)
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
            loop(one, found)
        if not asked.alone:
            together(robot, model)


if __name__ == "__main__":
    main()
