"""What is known of a robot, judged on other logs of it.

    validate(logs, robot) → Validation

Nothing is fitted but the state from which a prediction starts: half a second of free simulation under the logged
commands, and the whole log under its law. Where that predicts only in part, half seconds are told again with what
belongs to the run (friction, winding, supply, floor, dead times) fitted to it. Then one step of Gauss–Newton says which
number would have to move.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from upright.arrays import Array
from upright.calibration.calibrate import prepared
from upright.calibration.calibrated_robot import GOOD, PREDICTED, Segments
from upright.calibration.coefficients import EQUATION
from upright.calibration.fitting import Problem, normal_equations, objective
from upright.calibration.informativity import effective_fraction
from upright.calibration.noise import learn_noise
from upright.calibration.own_run import as_driven, of_this_run
from upright.calibration.process_noise import process
from upright.calibration.refined import SEGMENT, SEGMENT_NOISE
from upright.calibration.validate import segments
from upright.checkup.doctor import contradictions
from upright.checkup.wheels import on_its_wheels
from upright.control import Controller, find_controller
from upright.errors import InvalidLog, SpecMismatch
from upright.logs.mapping import Mapping as Columns
from upright.logs.marks import known_fraction
from upright.logs.raw import LogSource, named, raw_log
from upright.logs.recording import SENSOR
from upright.progress import Progress
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log
from upright.validation.fits import WORTH, LogJudged, Shift, channels_of, least, loop_channels
from upright.validation.law import CommandLaw, LinearLaw, law_by, law_of, recorded
from upright.validation.loop import FreeLoop, closed_loop
from upright.validation.validation import Validation

CHANCE = 2.0  # [deviations] of the gradient below which chance makes it
TRIED = 3  # steps that are tried, each whole and halved
TRIED_SECONDS = 4.0  # [s] of the log, on which they are tried
LARGEST_STEP = 3.0  # deviations of what is known: beyond, the equations are not straight
NOISE_RANGE = (0.25, 1e6)  # variances of the readings that are learnt, over those of the kit
SAME_PERIOD = 0.02  # [1] by which a log's period and its controller's may differ


def validate(
    logs: LogSource | Sequence[LogSource],
    robot: Robot | str | Path,
    kit: Kit | str | None = None,
    controller: Controller | str | Path | None = None,
    *,
    mapping: Columns | str | None = None,
    progress: Progress | None = None,
) -> Validation:
    """How well `robot` with `kit` (default: its own) predicts `logs` that it was not calibrated from.

    All may be names or files; `robot` also a posterior by `upright calibrate --save`. `controller` is the law that
    drove the logs; without it a law is read from each log, where a linear feedback of its readings explains 99 % of its
    commands. Raises `InvalidLog` for a log without commands, encoders or gyro.
    """
    nominal = find_robot(robot)
    parts = find_kit(kit or nominal.kit)
    several = [logs] if isinstance(logs, Log | str | os.PathLike) else list(logs)
    if not several:
        raise InvalidLog("no log is given", expected="at least one")
    given = find_controller(controller, nominal, parts, parts.period) if controller else None
    judged: list[LogJudged] = []
    for i, source in enumerate(several):
        judged.append(_judged(raw_log(source, mapping), nominal, parts, given))
        if progress:
            progress((i + 1) / len(several))
    return Validation(robot=nominal.name, kit=parts.name, logs=tuple(judged))


def _judged(log: Log, robot: Robot, kit: Kit, controller: Controller | None) -> LogJudged:
    log, left = on_its_wheels(log)
    log, meant = as_driven(log, robot, kit)
    problem, limits = prepared([log], robot, kit, (), 0.0)
    recording = problem.recordings[0]
    z = np.zeros(len(problem.parameters))
    whole = segments(problem, recording, z)
    parts, pushed = unpushed(whole, log)
    law, explained = _law(log, recording.rows, controller)
    loop: FreeLoop | None = closed_loop(problem, recording, z, log, kit, law) if law else None
    notes = [*([left] if left else []), *meant, *contradictions(log, robot)]
    dead = tuple(n for n in log.channels if n in SENSOR and n not in recording.rows and _never_changes(log[n]))
    half_seconds = channels_of(parts)
    own = of_this_run(problem, limits) if 0 <= least(half_seconds).r2 < GOOD else None
    if own and least(channels_of(own[0])).r2 < least(half_seconds).r2:
        own = None  # better on the mean, not of what decides
    return LogJudged(
        source=named(log),
        fitted=known_fraction(log, [one.marks for one in robot.fitted]) if robot.fitted else None,
        samples=len(log),
        seconds=float(log.t[-1] - log.t[0]),
        half_seconds=half_seconds,
        own_run=channels_of(own[0]) if own else (),
        effects=own[1] if own else (),
        halves=len(np.unique(whole.segment)),
        pushed=pushed,
        law=law.name if law else None,
        explained=explained,
        estimates=law.estimates if isinstance(law, LinearLaw) else (),
        dead=dead,
        loop=loop_channels(loop) if loop else (),
        shifts=_shifts(problem, limits, log),
        notes=tuple(notes),
        segments=parts,
        simulated=loop,
    )


def unpushed(parts: Segments, log: Log) -> tuple[Segments, int]:
    """The half seconds in which the log records no push, and how many were pushed; all of them where every one was. A
    push acts on in the half second in which it ends; the next one starts from a fitted state."""
    channels = [log[name] for name in ("push/force", "push/slope") if name in log and log[name].any()]
    if not channels:
        return parts, 0
    times = log.t[np.any(channels, axis=0)]
    starts, stops = (np.full(int(parts.segment.max(initial=0)) + 1, sign * np.inf) for sign in (1, -1))
    np.minimum.at(starts, parts.segment, parts.when)
    np.maximum.at(stops, parts.segment, parts.when)
    there = np.isfinite(starts)
    inside = (times >= starts[:, None] - log.period) & (times <= stops[:, None])
    struck = inside.any(axis=1) & there
    count = int(struck.sum())
    if count == there.sum():
        return parts, count
    keep = ~struck[parts.segment]
    changed = {name: getattr(parts, name)[keep] for name in ("row", "when", "measured", "predicted", "segment")}
    return replace(parts, **changed), count


def _never_changes(reading: Array) -> bool:
    there = reading[np.isfinite(reading)]
    return not len(there) or not np.ptp(there)


def _law(log: Log, rows: Sequence[str], controller: Controller | None) -> tuple[CommandLaw | None, float]:
    """What drove the log; and how much of its commands a linear law of the readings explains, where that was asked."""
    if controller is None:
        if known := recorded(log):
            return known, math.nan
        law = law_of(log, rows)
        return (law, law.explained) if isinstance(law, LinearLaw) else (None, law)
    if abs(controller.spec.period / log.period - 1) > SAME_PERIOD:
        came = f"a controller of {controller.spec.period * 1e3:.4g} ms and a log of {log.period * 1e3:.4g} ms"
        raise SpecMismatch(came, expected="one row of the log for each step of its controller")
    given = {*rows, *(n for n in log.channels if n.startswith("sensor/"))}
    missing = [n for n in controller.spec.reads if not n.startswith("truth/") and n not in given]
    if missing:
        raise SpecMismatch(f"the {controller.spec.kind} reads {', '.join(missing)}", expected="channels of the log")
    return law_by(controller, log), math.nan


def _shifts(problem: Problem, limits: dict[str, float], log: Log) -> tuple[Shift, ...]:
    """Parameters that, moved alone by one step, would predict half seconds visibly better; best first.

    The gradient proposes: of each parameter the Gauss–Newton step, and how far beyond chance it is. The half seconds
    decide: they are predicted again after each of the likeliest steps.
    """
    z = np.zeros(len(problem.parameters))
    gradient, curvature = _slopes(problem, limits)
    beyond = np.abs(gradient) / np.sqrt(curvature)
    steps = -gradient / curvature
    likely = [i for i, p in enumerate(problem.parameters) if beyond[i] > CHANCE and not p.name.startswith(EQUATION)]
    before = _score(problem, z, log)
    shifts = list[Shift]()
    for i in sorted(likely, key=lambda i: -beyond[i])[:TRIED]:
        p = problem.parameters[i]
        full = float(np.clip(steps[i], max(p.least, -LARGEST_STEP), LARGEST_STEP))
        tries = {
            part * full: _score(problem, np.where(np.arange(len(z)) == i, part * full, z), log) for part in (1.0, 0.5)
        }
        step = max(tries, key=lambda one: tries[one])
        explains = (tries[step] - before) / max(1 - before, 1e-9)
        if explains > WORTH:
            shifts.append(Shift(name=p.name, unit=p.unit, value=p.prior, proposed=float(p.value(step)), deviations=step,
                                explains=explains))  # fmt: skip
    return tuple(sorted(shifts, key=lambda shift: -shift.explains))


def _score(problem: Problem, z: Array, log: Log) -> float:
    """How well half seconds follow gyro and encoders at z (parameters,), against each one's own mean: 1 is perfect."""
    recording = problem.recordings[0]
    early = recording.when <= recording.when.min() + TRIED_SECONDS
    parts, _ = unpushed(segments(problem, recording, z, among=early), log)
    return replace(parts, rows=tuple(row for row in parts.rows if row in PREDICTED)).score()  # a compass is the last


def _slopes(problem: Problem, limits: dict[str, float]) -> tuple[Array, Array]:
    """Gradient and curvature (parameters,) of the posterior where the robot is, with half seconds that begin anew; zero
    and one where the filter loses the robot."""
    z = np.zeros(len(problem.parameters))
    noise = {**problem.noise, **process(problem.recordings, problem.robot, SEGMENT_NOISE)}
    problem = replace(problem, restart=SEGMENT, noise=noise)
    low, high = NOISE_RANGE
    if np.isfinite(objective(problem, z)[0]):
        problem = learn_noise(problem, z, {name: (low * v, high * v) for name, v in limits.items()}, iterations=5)
    value, paths = objective(problem, z)
    if not np.isfinite(value):
        return z, z + 1
    normal = normal_equations(problem, z, paths, value)
    weight = effective_fraction(problem, normal, paths)
    return weight * (normal.slopes.T @ (normal.weight * normal.whitened)), 1 + weight * (
        normal.weight @ normal.slopes**2
    )
