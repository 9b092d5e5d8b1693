"""What the models of one's own robot go through: a log's length, first state, law and pushes, and their judgement."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from upright.arrays import Array
from upright.bodies import Body, Electronics, NonlinearBody
from upright.comparison import compare
from upright.comparison.metrics import active_intervals, settling_time
from upright.control.controller import ControllerSpec
from upright.experiment import run
from upright.experiment.pushes import PushProgramme
from upright.paper.pushes import battery_of
from upright.physics.dynamics import turn_ratio
from upright.robots import Kit, Robot, Sensor
from upright.signals import STATE_NAMES, TRUE_STATE, Log
from upright.validation.law import CommandLaw

MEASURED, NONLINEAR, LINEAR, CALIBRATED = "robot", "nonlinear", "linear", "calibrated"
SENSED = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "sensor/compass")
REST = 1.0  # [s] at the end of the log, where the robot rests
ROUND = 1.5  # [s] after the push, where pitch is compared; the whole log where there is no push
WIDEST = 0.5  # [1] of the largest deviation: a robot that swings more at rest never settles
FINE = 0.001  # [s] step of a model with dead times


@dataclass(frozen=True, eq=False)
class _LawController:
    """The law of a log as a controller of models, on true states and on what their sensors read, row by row."""

    law: CommandLaw
    spec: ControllerSpec
    turn: float
    rows: int
    _row: list[int] = field(default_factory=lambda: [0], repr=False)

    def reset(self) -> None:
        self.law.reset()
        self._row[0] = 0

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:  # noqa: ARG002 (the law has the log's)
        x = measurement[: len(STATE_NAMES)]
        readings = dict(zip(self.spec.reads[len(x) :], measurement[len(x) :].tolist(), strict=True))
        rate = float(x[3] - x[1])
        half = self.turn * float(x[5])
        readings |= {"sensor/encoder_rate_left": rate - half, "sensor/encoder_rate_right": rate + half}
        row = min(self._row[0], self.rows - 1)
        self._row[0] += 1
        return self.law.step(row, readings, x)

    def estimate(self) -> tuple[float, ...]:
        return ()

    def applied(self, command: Sequence[float]) -> None:
        self.law.applied(command)

    def to_json(self) -> dict[str, str]:
        return {"kind": self.spec.kind, "law": str(self.law.name)}


@dataclass(frozen=True, eq=False, kw_only=True)
class Trial:
    """What every model goes through: the `measured` log's length, `first` state, law and pushes, the first of
    which begins at `pushed` [s] and the last ends at `release` [s]; and what settled means, `band`."""

    measured: Log
    first: Array
    law: CommandLaw
    pushes: tuple[PushProgramme, ...]
    robot: Robot
    kit: Kit
    pushed: float
    release: float
    band: float

    @property
    def step(self) -> float:
        """A step of a model [s]: each row of the log."""
        return self.measured.period

    def simulated(self, robot: Robot, kit: Kit | None = None, body: Body | None = None) -> Log:
        """The log of the nonlinear model, or of `body`, with ideal electronics or those of `kit`."""
        chosen = kit or battery_of(self.kit)
        chosen = replace(chosen, sensors={name: chosen.sensors.get(name, Sensor()) for name in SENSED})
        body = body or NonlinearBody(robot, period=FINE if kit else self.step)
        spec = ControllerSpec("the law of the log", (*TRUE_STATE, *SENSED), self.step, robot.command_unit)
        law = _LawController(self.law, spec, turn_ratio(robot), len(self.measured))
        seconds = len(self.measured) * self.step
        return run(Electronics(body, chosen), law, self.pushes, seconds=seconds, seed=1, start=self.first.tolist())

    def judged(self, log: Log) -> tuple[float, float]:
        """How long pitch takes to settle [s], and its fit to the measured one round the push [%]."""
        pitch = _pitch(log)
        until = self.release + ROUND if self.pushes else math.inf
        both = compare(
            {n: one.between(self.pushed, until) for n, one in ((MEASURED, self.measured), (NONLINEAR, log))},
            signals=("pitch",),
        )
        (fit,) = both.fits.values()
        settles = self.band <= WIDEST
        settling = settling_time(log.t, pitch - _rest(log).mean(), band=self.band, start=self.release)
        return settling if settles else math.nan, fit["pitch"]


def _pitch(log: Log) -> Array:
    return log["truth/pitch" if "truth/pitch" in log else "estimate/pitch"]


def _rest(log: Log) -> Array:
    """Pitch at the end of a log: where a robot that leans, or whose gyro is off, comes to rest."""
    return _pitch(log)[log.t > log.t[-1] - REST]


def pushed_in(log: Log, pushes: Sequence[PushProgramme], robot: Robot) -> tuple[tuple[float, float], ...]:
    """From when to when [s] some push acts in a log."""
    force = [sum(abs(push.at(float(t), robot).force) for push in pushes) for t in log.t]
    return active_intervals(log.t, force)


def trial_of(
    measured: Log, first: Array, law: CommandLaw, pushes: tuple[PushProgramme, ...], robot: Robot, kit: Kit
) -> Trial:
    """What the models go through, with the times of the pushes, and how much the resting robot swings."""
    t = measured.t
    pitch = _pitch(measured)
    times = [time for pair in pushed_in(measured, pushes, robot) for time in pair if math.isfinite(time)]
    pushed, release = (times[0], times[-1]) if times else (0.0, 0.0)
    rest = _rest(measured)
    swing = float(np.ptp(rest)) / 2
    peak = float(np.abs(pitch[t >= release] - rest.mean()).max(initial=1e-9))
    return Trial(
        measured=measured, first=first, law=law, pushes=pushes, robot=robot, kit=kit, pushed=pushed, release=release,
        band=max(0.05, 1.1 * swing / peak),
    )  # fmt: skip
