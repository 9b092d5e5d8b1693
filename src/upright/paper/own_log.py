"""The paper's experiment on a robot of one's own: its log beside both models, under the same push and law.

The law and the push are read from the log, or given. The models have the numbers of the robot's file, ideal sensors and
no dead time, like the paper's. A calibration from the same log says which numbers bring the settling times together.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from upright.arrays import Array
from upright.bodies import LinearBody
from upright.calibration.calibrate import calibrate, prepared
from upright.calibration.estimate import NORMAL
from upright.calibration.filter_log import filter_log
from upright.checkup.finding import instant
from upright.checkup.wheels import on_its_wheels
from upright.comparison import compare
from upright.comparison.drawing import state_words
from upright.comparison.metrics import active_intervals
from upright.control import Controller, find_controller
from upright.errors import DesignFailed, InvalidLog, InvalidRobot
from upright.experiment import Push
from upright.experiment.pushes import PushProgramme
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import LogSource, raw_log
from upright.pages import Message, Quantity, Say
from upright.paper.own_robot import Adjustment, LearntNumber, OwnRobot
from upright.paper.own_trial import CALIBRATED, LINEAR, MEASURED, NONLINEAR, Trial, pushed_in, trial_of
from upright.physics.linear import linearise_rolling
from upright.progress import Progress, unwatched
from upright.robots import PARAMETERS, Kit, Robot, find_kit, find_robot
from upright.robots.uncertainty import GUESS, stated
from upright.signals import STATE_NAMES, Log
from upright.validation.law import CommandLaw, LinearLaw, law_by, law_of, recorded
from upright.validation.loop import first_state

ELECTRONICS = "with electronics"
DISTURBED = 0.03  # [1] process noise of the filter that rebuilds states, as a fraction of the commands
MOVED = 0.25  # [deviations] a number that the calibration moved less is not tried
TRIED, MOST_STEPS = 6, 3  # numbers that are tried: those that moved most; numbers that are put right
WORTH = 0.1  # [1] of the gap that is left: what a further number must close


class _Learnt(NamedTuple):
    """A robot and its electronics as a calibration has them, and the numbers that it moved, most moved first."""

    robot: Robot
    kit: Kit
    numbers: tuple[LearntNumber, ...]


def compare_own(
    source: LogSource,
    robot: Robot | str | Path,
    kit: Kit | str | None = None,
    *,
    controller: Controller | str | Path | None = None,
    push: Sequence[PushProgramme] = (),
    learnt: Robot | str | Path | None = None,
    mapping: Columns | str | None = None,
    progress: Progress = unwatched,
) -> OwnRobot:
    """The log of a robot beside its nonlinear and linear model, under the log's push and law.

    Without `controller` the law is read from the log. Without `push` it is the log's `push/…`, or none: then the models
    start from the log's first state alone. Times of a push count from the first row. `learnt` is the robot as another
    log calibrated it; without it the part of this log without a push is calibrated. Raises `InvalidLog` where no law
    explains the commands.
    """
    log, left = on_its_wheels(raw_log(source, mapping))
    log = _from_zero(log)
    nominal = find_robot(robot)
    parts = find_kit(kit or nominal.kit)
    law = _law(log, find_controller(controller, nominal, parts, parts.period) if controller else None)
    pushes = tuple(push) or _logged(log)
    if learnt:
        best = find_robot(learnt)
        known = _other(nominal, best, find_kit(best.kit))
        notes: tuple[Say, ...] = ()
    else:
        known, notes = _calibrated(log, pushes, nominal, parts)
    progress(0.4)
    measured, first, how = _with_states(log, known.robot, known.kit)
    trial = trial_of(measured, first, law, pushes, nominal, parts)
    runs = {
        MEASURED: measured,
        NONLINEAR: trial.simulated(nominal),
        LINEAR: trial.simulated(nominal, body=LinearBody(linearise_rolling(nominal), nominal, period=trial.step)),
        CALIBRATED if known.numbers else ELECTRONICS: trial.simulated(known.robot, known.kit),
    }
    progress(0.6)
    comparison = compare(runs, release=trial.release)
    judged = {label: trial.judged(one) for label, one in comparison.logs.items()}
    adjusted = _adjusted(trial, judged, comparison.reference, known)
    progress(1.0)
    force = pushes[0].at(_start(pushes[0]), nominal).force if pushes else 0.0
    return OwnRobot(
        robot=nominal, comparison=comparison, law=law.name, push=_words(pushes, nominal), adjusted=adjusted,
        side="back" if force > 0 else "front", band=trial.band,
        notes=(*([left] if left else []), *how, *notes),
        settling={n: settling for n, (settling, _) in judged.items()}, fits={n: fit for n, (_, fit) in judged.items()},
    )  # fmt: skip


def _from_zero(log: Log) -> Log:
    return Log(log.t - log.t[0], dict(log.channels), log.units, log.origin)


def _law(log: Log, controller: Controller | None) -> CommandLaw:
    if controller is not None:
        return law_by(controller, log)
    if known := recorded(log):
        return known
    rows = [n for n in log.channels if n.startswith("sensor/") and np.isfinite(log[n]).all() and np.ptp(log[n]) > 0]
    law = law_of(log, rows)
    if isinstance(law, LinearLaw):
        return law
    raise InvalidLog(
        f"the law is unknown: the best linear feedback of the readings explains {max(law, 0.0):.0%} of the commands",
        expected="the law that drove the log", hint="--controller names its file",
    )  # fmt: skip


def _logged(log: Log) -> tuple[PushProgramme, ...]:
    """The pushes that a log says it had, each with its mean force and height."""
    if "push/force" not in log:
        return ()
    pushes: list[PushProgramme] = []
    for start, stop in active_intervals(log.t, log["push/force"]):
        at = (log.t >= start) & (log.t < stop)
        force = float(log["push/force"][at].mean())
        height = float(log["push/height"][at].mean()) if "push/height" in log else None
        last = min(stop, float(log.t[-1]) + log.period)
        pushes.append(Push(force=force, start=start, duration=last - start, height=height))
    return tuple(pushes)


def _start(push: PushProgramme) -> float:
    return float(getattr(push, "start", 0.0))


def _words(pushes: Sequence[PushProgramme], robot: Robot) -> Say:
    if not pushes:
        return Say("no push is known; --push impulse:0.06,start=3 says one")
    forces = [
        Say(
            "{force} from {start}", force=Quantity(push.at(_start(push), robot).force, "N"), start=instant(_start(push))
        )
        for push in pushes
    ]
    return Say("pushed by {forces}", forces=forces)


def _calibrated(log: Log, pushes: Sequence[PushProgramme], robot: Robot, kit: Kit) -> tuple[_Learnt, tuple[Say, ...]]:
    """What the longest part without a push says of the robot, or its file and why there is no more."""
    edges = [0.0, *(t for pair in pushed_in(log, pushes, robot) for t in pair), float(log.t[-1])]
    parts = [(a, b) for a, b in zip(edges[::2], edges[1::2], strict=False) if math.isfinite(a)]
    start, stop = max(parts, key=lambda part: part[1] - part[0])
    try:
        result = calibrate(log.between(start, stop), robot, kit)
    except (DesignFailed, InvalidLog) as error:
        return _Learnt(robot, kit, ()), (Say("Nothing is learnt from this log: {why}", why=Message(error)),)
    reasons = [*result.refused, *([result.quiet] if result.quiet else [])]
    if reasons:
        return _Learnt(robot, kit, ()), tuple(Say("Nothing is learnt from this log: {why}", why=why) for why in reasons)
    return _other(robot, result.known_robot(), result.kit or kit), ()


def _other(robot: Robot, best: Robot, kit: Kit) -> _Learnt:
    """What is known better of a robot than its file says: the numbers that moved, most moved first."""
    numbers: list[LearntNumber] = []
    for name, (unit, _) in PARAMETERS.items():
        before, after = getattr(robot, name), getattr(best, name)
        if after != before:
            half = NORMAL * (stated(best, name) or 0.0)
            spread = stated(robot, name) or GUESS * abs(before) or abs(after)
            numbers.append(
                LearntNumber(name, unit, before, after, after - half, after + half, (after - before) / spread)
            )
    most = sorted((n for n in numbers if abs(n.moved) > MOVED), key=lambda n: -abs(n.moved))[:TRIED]
    return _Learnt(best, kit, tuple(most))


def _with_states(log: Log, robot: Robot, kit: Kit) -> tuple[Log, Array, tuple[Say, ...]]:
    """The log with six states: its true ones, its own estimates, or for what is missing those of a filter along its
    readings; the first state (6,); and a note on what was rebuilt."""
    for prefix in ("truth", "estimate"):
        if all(f"{prefix}/{name}" in log for name in STATE_NAMES):
            return log, np.array([log[f"{prefix}/{name}"][0] for name in STATE_NAMES]), ()
    problem, _ = prepared([log], robot, kit, (), 0.0)
    first = first_state(problem, problem.recordings[0], np.zeros(len(problem.parameters)))[3][:6]
    filtered = filter_log(log, robot, kit, delay=kit.delay, disturbance=DISTURBED)
    last = np.searchsorted(filtered.sample, np.arange(len(log)), side="right") - 1
    states = filtered.after[np.clip(last, 0, None), :6]
    begin = int(filtered.sample[int((filtered.row >= 0).argmax())])
    states[: begin + 1] = first
    rebuilt = {f"estimate/{name}": states[:, i] for i, name in enumerate(STATE_NAMES)}
    missing = [state_words(name) for name in STATE_NAMES if f"estimate/{name}" not in log]
    note = Say("Rebuilt by a Kalman filter, since the log lacks them: {states}.", states=missing)
    return Log(log.t, rebuilt | dict(log.channels), log.units, log.origin), first, (note,)


def _adjusted(
    trial: Trial, judged: Mapping[str, tuple[float, float]], reference: str, known: _Learnt
) -> tuple[Adjustment, ...]:
    """Of the numbers that were learnt, and the electronics, what brings the model nearest to the log, one on top of the
    other."""
    measured = judged[reference][0]
    left = _gap(judged[reference][0], *judged[NONLINEAR])
    at: tuple[Robot, Kit | None] = (trial.robot, None)
    candidates: list[LearntNumber | None] = [*known.numbers, None]  # None: the electronics
    steps: list[Adjustment] = []
    while candidates and len(steps) < MOST_STEPS:
        tries = [(n, changed) for n in candidates if (changed := _with(at, n, known.kit))]
        results = [(*trial.judged(trial.simulated(*changed)), n, changed) for n, changed in tries]
        settling, fit, number, changed = min(results, key=lambda one: _gap(measured, one[0], one[1]))
        gap = _gap(measured, settling, fit)
        if not gap < (1 - WORTH) * left:
            break
        steps.append(Adjustment(number=number, settling=settling, fit=fit))
        at = changed
        left = gap
        candidates = [n for n in candidates if n is not number]
    unlike = math.isnan(measured) and steps and steps[-1].fit <= 0  # less far from the robot, and still another motion
    return () if unlike else tuple(steps)


def _with(at: tuple[Robot, Kit | None], number: LearntNumber | None, kit: Kit) -> tuple[Robot, Kit | None] | None:
    """The model with that number, or with the electronics of `kit`; None where no robot has that number alone."""
    if number is None:
        return at[0], kit
    try:
        return at[0].replace(**{number.name: number.value}), at[1]
    except InvalidRobot:  # such a pitch inertia needs the roll inertia that goes with it
        return None


def _gap(measured: float, settling: float, fit: float) -> float:
    """How far a model is from the log: in settling time [s], or in the fit of pitch [%] where the log never settles."""
    if math.isnan(measured):
        return 100 - fit if math.isfinite(fit) else math.inf
    return abs(settling - measured) if math.isfinite(settling) else math.inf
