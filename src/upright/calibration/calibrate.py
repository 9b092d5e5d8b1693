"""The robot from its own raw logs: start, anneal, learn the noise, and say what came of it.

    calibrate(log, robot) → Calibration

The predictor's gains belong to noise that is learnt with the parameters. Its process noise may not exceed `FREEDOM`: a
filter that trusts its model little predicts the next sample well whatever the model is, and nothing beyond.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from upright.calibration.annealing import ANNEALING_NOISE, annealed, lost
from upright.calibration.calibrated_robot import GOOD
from upright.calibration.calibration import Calibration
from upright.calibration.coefficients import EQUATIONS
from upright.calibration.contradicted import Explained, doubted, explained, guessed
from upright.calibration.decision import EXCITE
from upright.calibration.effects import effects_of
from upright.calibration.electronics import DROP, electronics_of
from upright.calibration.filter_log import one_step_noise
from upright.calibration.fitting import Fitted, Problem
from upright.calibration.informativity import INERTIAL, STRAIGHT, TURNING, drives_straight, too_quiet
from upright.calibration.knocks import Knocks, without_knocks
from upright.calibration.learnt_kit import learnt_kit
from upright.calibration.parameters import parameters_of, smooth
from upright.calibration.process_noise import arrival, process
from upright.calibration.refined import refined, settled, simulated
from upright.calibration.resonance import FIRST, SWING, resonance_of, resonates, swing_noise
from upright.calibration.stated_gain import as_meant
from upright.checkup.doctor import contradictions, record_of
from upright.checkup.rates import faster_controller
from upright.checkup.wheels import on_its_wheels
from upright.errors import InvalidLog, check_within
from upright.logs.mapping import Mapping as Columns
from upright.logs.pace import pace_of
from upright.logs.raw import LogSource, named, raw_log
from upright.logs.recording import MOST_HELD_OUT, SENSOR, check_complete, commanded, first_noise, foreign, record
from upright.pages import Next, Quantity, Say
from upright.pages.terms import term
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log

CERTAIN = 2.58  # standard deviations below zero: a dead time that is not negative is so in fewer than one log in 100


def calibrate(
    logs: LogSource | Sequence[LogSource],
    robot: Robot | str,
    kit: Kit | str | None = None,
    *,
    mapping: Columns | str | None = None,
    known: Sequence[str] = (),
    held_out: float = 0.25,
    between_knocks: bool = False,
    progress: Progress | None = None,
) -> Calibration:
    """Physical parameters, dead times and noise of `robot` from one or several logs of raw sensors and commands.

    Logs are `Log`s or files, which `mapping` reads (default: the one that fits); robot and kit may be names or files.

    `robot` gives the prior: each number with the spread of its provenance, a guess with a factor of two. `kit`
    (default: the robot's own) gives first delays and noise. `known` names parameters taken for exact. The last fraction
    `held_out` of each log is not fitted; predictions are tested on it. Knocks in a log are named, and left out with
    `between_knocks`. Raises `InvalidLog` for unusable logs, `DesignFailed` where no start follows the log.
    """
    from upright.calibration.apart import apart
    from upright.calibration.summary import summarised, untold

    began, show = time.perf_counter(), progress or unwatched
    given = [raw_log(log, mapping) for log in ([logs] if isinstance(logs, Log | str | os.PathLike) else logs)]
    several, left = zip(*map(on_its_wheels, given), strict=True) if given else ((), ())
    nominal = find_robot(robot)
    nominal = smooth(nominal) if foreign(several) else nominal
    parts = find_kit(kit or nominal.kit)
    several, knocked = without_knocks(several, nominal, parts, cut=between_knocks)
    stated, _ = prepared(several, nominal, parts, known, held_out)
    reason, straight = too_quiet(stated), drives_straight(stated)
    held = (*(INERTIAL if reason else ()), *(TURNING if straight else ()))
    wrong = [fault for log in several for fault in contradictions(log, nominal)]

    def searched(
        logs: Sequence[Log], start: float = 0.7, stop: float = 0.77, guesses: Sequence[str] = (), doubt: float = 1.0,
        *, brief: bool = False,
    ) -> Fitted:  # fmt: skip
        problem, limits = prepared(logs, nominal, parts, known, held_out)
        parameters = guessed(nominal, doubted(problem.parameters, doubt), guesses)
        own = frozenset(p.name for p in parameters if p.name in held)
        problem = replace(problem, parameters=parameters, held=own)
        return _searched(problem, limits, lambda fraction: show(start + fraction * (stop - start)), brief=brief)

    show(0.01)  # these shares are of the time that logs of half a minute took
    best, several, meant = _described(searched, several, parts, quiet=bool(reason), wrong=bool(wrong))
    problem, z, *_ = best.fit
    show(0.77)
    result = summarised(best, several, reason, began, stated=stated, wrong=wrong)
    hidden = parts.delay + parts.jitter / 2 - _dead_time(parts, several)
    remarks = [*filter(None, left), *(p.in_words() for p in map(pace_of, several) if p and not p.kept)]
    notes = [*meant, *(one.remark for one in knocked), *([STRAIGHT] if straight else []), *remarks]
    result = untold(result, _unknown(result, several, knocked, cut=between_knocks, wrong=bool(wrong)))
    result = replace(result, kit=learnt_kit(result, parts, problem.delays, hidden), notes=(*result.notes, *notes))
    if problem.temper < 1 and not result.decision.withheld:  # else the noise of the kit is that of the filter
        own = result.kit or parts
        noise = one_step_noise(max(several, key=len), result.robot, own, delay=_dead_time(own, several))
        result = replace(result, robot=result.robot.replace(noise=noise))
    return result if reason or result.untold else replace(result, apart=apart(problem, z, result.sources))


def _unknown(
    result: Calibration, logs: Sequence[Log], knocked: Sequence[Knocks], *, cut: bool, wrong: bool = False
) -> tuple[Say, Next] | None:
    """Why these logs cannot tell the robot, and what to try; None where they can. With pushes that were `cut` out, a
    fit that is refused is bent by softer ones, and of no other robot. What is `wrong` in the logs is mended first."""
    if wrong and result.refused:
        return None
    if knocked and (not cut or result.refused or any(one.used is None for one in knocked)):
        when = Quantity(knocked[0].times[0], "s")
        return Say("Somebody seems to push the robot at {time}, which no channel of the log shows.", time=when), EXCITE
    dropped = any(e.name == DROP for e in result.electronics)  # by a driver, which absorbs small commands too
    for finding in (f for log in logs for f in faster_controller(record_of(log)) if not dropped):
        return Say("The log lacks commands. {evidence}", evidence=finding.evidence), EXCITE
    for e in () if result.refused else result.delays:
        if "−" not in e.name and e.value + CERTAIN * e.spread < 0:
            early = Say(
                "The {name} is {time} below zero: the model lacks something that moves this robot.",
                name=term(e.name),
                time=Quantity(-e.value, "s", digits=2),
            )
            return early, Next("doctor", *map(named, logs[:1]))
    return None


def _described(
    searched: Callable[..., Fitted], logs: Sequence[Log], kit: Kit, *, quiet: bool, wrong: bool
) -> tuple[Explained, Sequence[Log], list[Say]]:
    """The fit that `searched` finds, with its doubtful numbers; the logs as they are meant; and what their files state.
    Where something is `wrong` in the logs, and half seconds are not predicted all the same, no cause is
    looked for: they are of no robot."""
    fit = searched(logs, 0.01, 0.1 if wrong else 0.7, brief=wrong)
    meant = list[Say]()
    if wrong and simulated(fit) < GOOD:
        return Explained(fit, [], 0.0), logs, meant
    if wrong:
        fit = searched(logs, 0.1, 0.7)
    if quiet:
        return Explained(fit, [], 0.0), logs, meant
    fit, logs, meant = as_meant(fit, logs, kit, searched)
    return explained(fit, partial(searched, logs)), logs, meant


def prepared(
    logs: Sequence[Log], robot: Robot, kit: Kit, known: Sequence[str], held_out: float
) -> tuple[Problem, dict[str, float]]:
    """The problem at its prior, and each sensor's variance as its kit has it."""
    check_within("of a log held out", held_out, 0, MOST_HELD_OUT)
    delay = kit.delay + max([0.0, *(s.delay for s in kit.sensors.values())])
    for log in logs:
        check_complete(log, robot)
    if any(_idle(log) for log in logs):
        likely = "a log of a robot switched off, or of motors at one speed"
        raise InvalidLog("the commands never change", expected="motors at work", likely=likely)
    recordings = tuple(record(log, robot, kit, skip=delay + 0.02, held_out=held_out) for log in logs)
    sensors = dict.fromkeys(s for r in recordings for s in r.sensors)
    delays = {s: _dead_time(kit, logs) + _delay(kit, s) for s in sensors}
    variances = [first_noise(r) for r in recordings]
    limits = {s: max(v[s] for v in variances if s in v) for s in delays}
    noise = {s: float(np.log(v)) for s, v in limits.items()}
    noise |= arrival(kit, logs)
    other = foreign(logs)
    electronics = electronics_of(robot, kit, logs)
    parameters = parameters_of(robot, delays, known, electronics, foreign=other)
    parameters += resonance_of(kit)  # which is learnt together, and no `known` number
    if resonates(parameters):
        recordings = tuple(recording.swinging() for recording in recordings)
        noise |= {SWING: math.log(swing_noise(recordings, FIRST))}
    every = (*parameters, *EQUATIONS, *effects_of(parameters, len(recordings)))
    problem = Problem(
        recordings=recordings, robot=robot, parameters=every, delays=delays,
        noise=noise | process(recordings, robot, ANNEALING_NOISE[0]), foreign=other,
        exact={p.name: p.prior for p in electronics if p.name in known},
    )  # fmt: skip
    return problem, limits


def _idle(log: Log) -> bool:
    """Whether the commands never change."""
    prefix = commanded(log)
    return bool(prefix) and not any(np.ptp(log[f"{prefix}/{side}"]) for side in ("left", "right"))


def _dead_time(kit: Kit, logs: Sequence[Log]) -> float:
    """From a logged command to the motor [s]: of what was really applied, only what is less than a period."""
    whole = any(commanded(log) == "command" for log in logs)
    periods = 0 if whole else math.floor(kit.delay / kit.period + 1e-9)
    return kit.delay - periods * kit.period + kit.jitter / 2


def _delay(kit: Kit, sensor: str) -> float:
    return max((s.delay for name, s in kit.sensors.items() if SENSOR.get(name) == sensor), default=0.0)


def _searched(problem: Problem, limits: Mapping[str, float], show: Progress, *, brief: bool) -> Fitted:
    """The fit of a problem from its prior, or a `brief` one of a log that no fit may describe; raises `DesignFailed`
    where the filter loses the robot."""
    start = annealed(problem, limits)
    show(0.1)
    fit = settled(*start, limits) if brief else None
    if fit is None or not np.isfinite(fit.normal.objective):
        fit = refined(*start, limits, show)
    if not np.isfinite(fit.normal.objective):
        raise lost()
    return fit
