"""The runs of robots in `../shared/data`, and how well the numbers of one predict another or its whole loop."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from upright.calibration.calibrate import prepared
from upright.calibration.calibration import Calibration
from upright.calibration.filter_log import filter_log
from upright.calibration.fitting import Problem
from upright.calibration.own_run import as_driven
from upright.calibration.validate import segments
from upright.logs.raw import raw_log
from upright.robots import find_kit
from upright.signals import Log
from upright.validation.law import LinearLaw, law_of
from upright.validation.loop import PITCH, closed_loop

DATA = Path(__file__).parents[2] / "../shared/data"
CUTS = (0.0, 0.15, 0.4)  # [s] off the end of an EV3 run, which ends in a fall: the same answer is wanted for each
SLOW, FADES = 12.0, 3.0  # [Hz] up to which the gyro is kept with `--swing`, and the width in which it then fades
MIRRORED = 64  # rows by which a gyro is continued at its ends before it is filtered
PRESETS = {"ev3way": "ev3way-large-wheels", "twipr": "twipr"}


@dataclass(frozen=True)
class Run:
    """A run of a robot: which it is, how it was cut, and its log."""

    name: str
    cut: float
    log: Log

    def __str__(self) -> str:
        return f"{self.name} −{self.cut:g} s" if self.cut else self.name


def without_swing(log: Log, frequency: float) -> Log:
    """`log` with its gyro up to `SLOW` alone, without phase; where its mount swings at a `frequency` [Hz] with little
    damping, as it would be on a stiff one: a swing turns 1/(1 − (f/frequency)²) times as far. inf: none swings."""
    grid = np.arange(log.t[0], log.t[-1] + log.period / 2, log.period)
    y = np.interp(grid, log.t, log["sensor/gyro"])
    padded = np.pad(y, MIRRORED, mode="reflect", reflect_type="odd")
    f = np.fft.rfftfreq(len(padded), log.period)
    gain = np.clip(1 - (f - SLOW) / FADES, 0, 1) * np.maximum(1 - (f / frequency) ** 2, 0)
    stiff = np.fft.irfft(gain * np.fft.rfft(padded), len(padded))[MIRRORED:-MIRRORED]
    channels = {**log.channels, "sensor/gyro": np.interp(log.t, grid, stiff)}
    return Log(log.t, channels, log.units, log.origin)


def runs(robot: str, swing: float = 0.0) -> Iterator[Run]:
    """The runs of "ev3way", each with three ends and without a `swing` [Hz] where one is named, or of "twipr"."""
    if robot == "ev3way":
        for name, end in (("tilt_000", 7.4), ("nn_v7_000", np.inf), ("nn_v17_005", np.inf)):
            log = raw_log(DATA / f"ev3way/{name}.csv").between(0.0, end)
            log = without_swing(log, swing) if swing else log
            for cut in CUTS:
                yield Run(name, cut, log.between(0.0, log.t[-1] - cut))
    else:
        second = raw_log(DATA / "twipr/run2_all.csv")
        yield Run("run1", 0.0, raw_log(DATA / "twipr/run1.csv"))
        yield Run("run2", 0.0, second.between(second.t[1283], second.t[2282]))


def known(found: Calibration, other: Run) -> tuple[Problem, np.ndarray]:
    """The problem of a run, and what a calibration says of its parameters."""
    kit = find_kit(found.known_robot().kit)
    log, _ = as_driven(other.log, found.known_robot(), kit)
    problem, _ = prepared([log], found.robot, kit, (), 0.0)
    beside = {e.name: e.value for e in (*found.delays, *found.electronics)}
    return problem, np.array([p.coordinate(beside[p.name]) if p.name in beside else 0.0 for p in problem.parameters])


def crossed(found: Calibration, other: Run) -> dict[str, float]:
    """R² of half seconds of another run, of which the first states alone are fitted."""
    problem, z = known(found, other)
    parts = segments(problem, problem.recordings[0], z)
    return {name: parts.r_squared(name) for name in parts.rows}


class ReadLaw:
    """The law of a log as it was read from its commands, on an estimate of the pitch that is as wrong as the log's own
    by `error` [rad] (rows,), from the row `simulated` on."""

    name = "read from the log"

    def __init__(self, law: LinearLaw, error: np.ndarray, simulated: int) -> None:
        self._law, self._error, self._simulated = law, error, simulated

    def reset(self) -> None:
        self._law.reset()

    def step(self, row: int, readings: Mapping[str, float], state: np.ndarray) -> tuple[float, float]:
        error = self._error[row] if row >= self._simulated else 0.0
        return self._law.step(row, {**readings, PITCH: readings[PITCH] + error}, state)

    def applied(self, command: Sequence[float]) -> None:
        pass


def loops(one: Run, found: Calibration) -> dict[str, tuple[float, float, float | None]]:
    """R² of pitch and wheel rate, and when the robot falls [s], of the whole closed loop simulated freely from the
    first state of the log, under the law read from it and with the run's constant torque: on the true pitch, as late as
    the gyro, and on one as wrong as the estimate that the law read, by the filter of the calibrated robot."""
    log, kit = one.log, found.kit or find_kit(found.robot.kit)
    problem, z = known(found, one)
    recording, late = problem.recordings[0], found["delay/gyro"].value
    law = law_of(log, recording.rows)
    if not isinstance(law, LinearLaw):
        return {}
    path = filter_log(log, found.known_robot(), kit, delay=kit.delay, disturbance=0.03)
    held = path.row < 0
    pitch = np.interp(log.t - late, path.t[held], path.after[held, 0])
    wrong, simulated = log[PITCH] - pitch, int(np.searchsorted(log.t, recording.when[recording.kind >= 0].min()))
    wheels = [f"sensor/encoder_rate_{side}" for side in ("left", "right")]
    scores: dict[str, tuple[float, float, float | None]] = {}
    for words, error, true in (("the true pitch", 0 * wrong, log[PITCH]), ("one as wrong as its own", wrong, pitch)):
        free = closed_loop(problem, recording, z, log, kit, ReadLaw(law, error, simulated))
        column = {name: free.simulated[:, i] for i, name in enumerate(free.names)}
        measured, rate = (np.mean([of[name] for name in wheels], axis=0) for of in (log, column))
        scores[words] = r_squared(true, column[PITCH]), r_squared(measured, rate), free.fell_at
    return scores


def r_squared(measured: np.ndarray, simulated: np.ndarray) -> float:
    """Of what was simulated; the first rows are before that."""
    there = np.isfinite(simulated)
    left = ((measured - simulated)[there] ** 2).sum()
    return 1 - float(left / ((measured[there] - measured[there].mean()) ** 2).sum())
