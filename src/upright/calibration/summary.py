"""From a finished fit to a `Calibration`: intervals, combinations, verdicts, checks and remarks."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from upright.arrays import Array
from upright.calibration import dropping, misaligned, resonance
from upright.calibration.calibrated_robot import Segments
from upright.calibration.calibration import Calibration
from upright.calibration.coefficients import AT, SHARPER, around, slopes_of
from upright.calibration.contradicted import Explained, which
from upright.calibration.effects import FRACTIONS, of_robot
from upright.calibration.electronics import DEAD_ZONE, DROP, MEANING, MISALIGNED
from upright.calibration.estimate import BOUND, HELD, NORMAL, PRIOR, QUIET, REFUSED, VISIBLE, Estimate
from upright.calibration.fitting import Problem
from upright.calibration.informativity import between_optima, information, posterior, unseen_directions
from upright.calibration.judge import better, poorly, proposed, reasons
from upright.calibration.parameters import GEAR, ROLL_FRACTION, Parameter, columns, with_values
from upright.calibration.resonance import FREQUENCY
from upright.calibration.validate import segments, steps_ahead, whiteness
from upright.logs.marks import marks_of
from upright.logs.raw import named
from upright.logs.recording import Recording
from upright.pages import Next, Say
from upright.pages.terms import term
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain
from upright.physics.linear import unstable_pole
from upright.robots import PARAMETERS, FittedLog, Provenance, Robot
from upright.signals import Log

HALVED = 0.5  # of the prior's deviation: a number known twice as well, or better, is called visible
FINEST_TIME = 0.01  # of a period: no dead time is claimed to be known better, since the integration takes steps

COMBINATIONS: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "roll_inertia": ("kg m²", lambda p: p.roll_inertia),
    "motor_gain": ("N m/V", motor_gain),
    "motor_damping": ("N m s/rad", motor_damping),
    "a11": ("kg m²", lambda p: mass_matrix(1.0, 0.0, p)[0]),
    "a12": ("kg m²", lambda p: mass_matrix(1.0, 0.0, p)[1]),
    "a22": ("kg m²", lambda p: mass_matrix(1.0, 0.0, p)[2]),
    "weight_moment": ("N m", lambda p: p.gravity * p.body_mass * p.com_height),
    "a22/a11": ("1", lambda p: mass_matrix(1.0, 0.0, p)[2] / mass_matrix(1.0, 0.0, p)[0]),
    "weight_moment/a22": ("1/s²", lambda p: p.gravity * p.body_mass * p.com_height / mass_matrix(1.0, 0.0, p)[2]),
}
"""The number that follows from others, then what enters the motion: its coefficients, and two ratios of them."""


def summarised(
    best: Explained, logs: Sequence[Log], reason: Say | None, began: float, *, stated: Problem, wrong: Sequence[Say]
) -> Calibration:
    """The calibration that a fit, with its doubtful numbers, amounts to; `stated` is the problem
    as the files state it, and `wrong` what the doctor finds wrong in the logs."""
    problem, z, normal, paths, _ = best.fit
    free = tuple(segments(problem, recording, z) for recording in problem.recordings)
    fits, scores = _checks(problem, z, free)
    errors, white = _covariances(best)
    problem, fitted = best.as_stated, best.scales * z
    runs = len(problem.recordings)
    _, right = of_robot(problem.parameters, fitted, white, runs)
    z, C = of_robot(problem.parameters, fitted, errors, runs)
    spread = np.sqrt(np.diag(C))
    every = [_estimate(p, float(z[i]), float(spread[i]), p.name in problem.held) for i, p in enumerate(problem.asked)]
    combinations = combined_numbers(problem, z)
    combined = tuple(_combined(c, C) for c in combinations)
    widening = _widening(C, right, every, combinations)
    supported = sum(right[i, i] < HALVED**2 for i, p in enumerate(problem.asked) if p.name not in problem.held)
    supported += sum(_combined(c, right).verdict == VISIBLE for c in combinations[1:])
    other = [] if wrong else proposed(stated, problem, every)
    doubted = [_doubted(e, best.doubt) for e in every]
    refused = () if reason else reasons(problem, fitted, free, doubted, other, wrong, best.freed)
    delays = _delays(problem, z, C, every)
    if withdrawn := REFUSED if refused else QUIET if reason else "":
        every, combined, delays = (tuple(_withdrawn(e, withdrawn) for e in each) for each in (every, combined, delays))
    names, covariance = _in_units(problem, z, C)
    by_name = {e.name: e for e in every} | ({"roll_inertia": _roll_inertia(problem, combined[0])})
    parameters = tuple(by_name[name] for name in names if name in PARAMETERS)
    robot = _calibrated(problem, z, parameters, logs)
    return Calibration(
        robot=robot,
        prior=problem.robot,
        parameters=parameters,
        combinations=combined[1:],
        delays=delays,
        electronics=tuple(e for e in every if e.name in MEANING),
        names=names,
        covariance=covariance,
        noise={name: math.exp(0.5 * value) for name, value in problem.noise.items()},
        whiteness=tuple(w for r, path in zip(problem.recordings, paths, strict=True) for w in whiteness(r, path)),
        fits=fits,
        segments=scores,
        free=free,
        temper=problem.temper,
        samples=int(sum((r.fitted & (r.kind < 0)).sum() for r in problem.recordings)),
        seconds=time.perf_counter() - began,
        sources=tuple(map(named, logs)),
        notes=_notes(problem, () if wrong and refused else every, other, best, None if refused else wrong),
        widening=widening,
        supported=int(supported),
        quiet=reason,
        unseen=tuple(unseen_directions(problem, normal)),
        refused=refused,
        suspects=tuple(one.name for one in best.freed),
        missed=() if reason else _missed(problem, fitted, free, only_known=bool(refused)),
        likelier={name: nats for name, nats in _likelier(problem).items() if nats},
    )


def _covariances(best: Explained) -> tuple[Array, Array]:
    """Of the errors of a fit's parameters (parameters, parameters), by the deviations that are stated; and what it were
    with white innovations."""
    problem, z, normal, paths, others = best.fit
    stated = np.outer(best.scales, best.scales)
    floor = _floor(problem, z)
    errors = between_optima(posterior(problem, z, normal, paths), z, others)
    white = np.linalg.inv(np.eye(len(z)) + information(problem, normal))
    return stated * errors + best.covariance + floor, stated * white + floor


def _likelier(problem: Problem) -> dict[str, float]:
    """By how many nats what was found beside the robot makes the logs likelier."""
    return {FREQUENCY: problem.resonance, MISALIGNED: problem.misalignment, DROP: problem.drop}


def _missed(problem: Problem, z: Array, free: Sequence[Segments], *, only_known: bool) -> tuple[Say, ...]:
    """What half seconds explain too little of, by run where there are several; of a refused fit only where the cause
    is known."""
    texts: list[Say] = []
    for number, (recording, parts) in enumerate(zip(problem.recordings, free, strict=True), 1):
        poor = poorly(problem, recording, z, parts, only_known=only_known)
        texts += [Say("Log {n}: {remark}", n=number, remark=text) for text in poor] if len(free) > 1 else poor
    return tuple(texts)


def _fitted_part(log: Log, recording: Recording) -> FittedLog:
    """Which rows of a log were fitted."""
    times = recording.when[recording.fitted]
    part = log.between(float(times.min()), float(times.max()) + log.period / 2)
    return FittedLog(named(log), float(part.t[0]), float(part.t[-1]), marks_of(part))


def untold(c: Calibration, reason: tuple[Say, Next] | None) -> Calibration:
    """The calibration; where its logs can tell no robot, for a `reason` with what to try, none is accused."""
    if reason is None:
        return c
    groups = ("parameters", "combinations", "delays", "electronics")
    every = {group: tuple(_withdrawn(e, REFUSED) for e in getattr(c, group)) for group in groups}
    return replace(c, **every, refused=reason[:1], untold=reason[1], missed=(), notes=())


def _withdrawn(e: Estimate, verdict: str) -> Estimate:
    """The estimate of a fit that is refused, or of a log too quiet for it."""
    return replace(e, verdict=verdict) if e.verdict == VISIBLE or (verdict == REFUSED and e.verdict != HELD) else e


def _floor(problem: Problem, z: Array) -> Array:
    """Variance of each coordinate (n, n) that no log takes away at z (n,): of dead times, and of a dead zone, which
    changes nothing between two levels of the command."""
    unknown = [_unknown(problem, p, float(p.value(x))) for p, x in zip(problem.parameters, z, strict=True)]
    return np.diag([(size / p.spread) ** 2 for size, p in zip(unknown, problem.parameters, strict=True)])


def _unknown(problem: Problem, p: Parameter, value: float) -> float:
    """The deviation of a parameter at a value that no log takes away, in its unit."""
    if p.name.startswith("delay/"):
        return FINEST_TIME * problem.recordings[0].period
    return _step(problem, value) / NORMAL if p.name == DEAD_ZONE else 0.0


def _step(problem: Problem, zone: float) -> float:
    """From the largest command within a dead zone to the smallest one above it."""
    levels = np.unique(np.concatenate([[0.0], *(np.abs(r.commands).ravel() for r in problem.recordings)]))
    above = int(np.searchsorted(levels, zone, side="right"))
    return float(levels[min(above, len(levels) - 1)] - levels[max(above - 1, 0)])


def _estimate(p: Parameter, z: float, spread: float, held: bool) -> Estimate:
    low, high = (float(p.value(max(z + side * NORMAL * spread, p.least))) for side in (-1, 1))
    pressed = z <= p.least + 1e-9 and p.lower == 0.0 and p.prior > 0
    verdict = HELD if held else BOUND if pressed else VISIBLE if spread < HALVED else PRIOR
    return Estimate(
        name=p.name, unit=p.unit, value=float(p.value(z)), low=low, high=high, prior=p.prior, prior_spread=p.spread,
        verdict=verdict, shift=z, shrink=spread, guess=p.guess, scale=p.scale,
    )  # fmt: skip


def _doubted(e: Estimate, doubt: float) -> Estimate:
    """The estimate by the deviation that a number has in a file that is doubted."""
    return e if e.guess else replace(e, shift=e.shift / doubt)


def _in_units(problem: Problem, z: Array, C: Array) -> tuple[tuple[str, ...], Array]:
    """Names and covariance (n, n) of what was fitted, with the roll inertia in place of its share."""
    lanes = around(z)
    values = problem.values(lanes)
    roll = np.broadcast_to(columns(problem.robot, values).roll_inertia, lanes.shape[1])
    if ROLL_FRACTION in values:
        values = {
            ("roll_inertia" if n == ROLL_FRACTION else n): (roll if n == ROLL_FRACTION else v)
            for n, v in values.items()
        }
    slopes = np.array([slopes_of(v) for v in values.values()])
    return tuple(values), slopes @ C @ slopes.T


def _roll_inertia(problem: Problem, roll: Estimate) -> Estimate:
    """The combination as the parameter that it is."""
    verdict = HELD if ROLL_FRACTION in problem.held else roll.verdict
    return replace(roll, low=max(roll.low, 0.0), verdict=verdict)


def _calibrated(problem: Problem, z: Array, every: Sequence[Estimate], logs: Sequence[Log]) -> Robot:
    """The robot with its new numbers, each with where it comes from and its deviation, and the logs."""
    origin = ", ".join(dict.fromkeys(map(named, logs)))
    sources_of = {
        n.name: Provenance(f"calibrated from {origin}; {n.verdict}", n.spread) for n in every if n.verdict != HELD
    }
    q = problem.coefficients(problem.recordings[0], z[:, None])[AT.stiction_rate_squared, 0]
    sharp = max(math.sqrt(q), problem.robot.stiction_rate / SHARPER)  # sharper ones make simulations slow
    robot = _robot_at(problem, z).replace(stiction_rate=sharp)
    if sharp != problem.robot.stiction_rate:
        sources_of["stiction_rate"] = Provenance(f"calibrated from {origin}; the likeliest, without an interval")
    fitted = tuple(map(_fitted_part, logs, problem.recordings))
    return robot.replace(provenance={**problem.robot.provenance, **sources_of}, name=problem.robot.name, fitted=fitted)


class _Combination(NamedTuple):
    """A number that follows from others: its value, that at the prior, and its slopes (parameters,)."""

    name: str
    unit: str
    value: float
    prior: float
    slopes: Array


def combined_numbers(problem: Problem, z: Array) -> list[_Combination]:
    """Each combination at z (parameters,)."""
    lanes = around(z)
    numbers, prior = (columns(problem.robot, problem.values(at)) for at in (lanes, 0 * lanes))
    combined: list[_Combination] = []
    for name, (unit, formula) in COMBINATIONS.items():
        if problem.robot.drive == "torque" and name == "motor_gain":
            continue
        values = np.broadcast_to(formula(numbers), lanes.shape[1])
        before = float(np.atleast_1d(formula(prior))[0])
        combined.append(_Combination(name, unit, float(values[-1]), before, slopes_of(values)))
    poles = np.array([rolling_pole(_robot_at(problem, lanes[:, i])) for i in range(lanes.shape[1])])
    pole = float(poles[-1])
    before = rolling_pole(problem.robot)
    return [*combined, _Combination("unstable_pole", "1/s", pole, before, slopes_of(poles))]


def rolling_pole(robot: Robot) -> float:
    """The rate [1/s] at which the robot falls while its wheels roll: dry friction, which at rest would hold them, is a
    steady force then and moves no pole."""
    return unstable_pole(robot.without_dry_friction())


def _robot_at(problem: Problem, z: Array) -> Robot:
    values = problem.values(z[:, None])
    return with_values(problem.robot, {n: max(float(v[0]), 0.0) for n, v in values.items()})


def _combined(c: _Combination, C: Array) -> Estimate:
    """A combination with its interval, for the covariance C (n, n) of the coordinates."""
    spread = float(np.sqrt(c.slopes @ C @ c.slopes))
    before = max(float(np.linalg.norm(c.slopes)), 1e-300)
    verdict = HELD if not c.slopes.any() else VISIBLE if spread < HALVED * before else PRIOR
    return Estimate(
        name=c.name, unit=c.unit, value=c.value, low=c.value - NORMAL * spread, high=c.value + NORMAL * spread,
        prior=c.prior, prior_spread=before, verdict=verdict,
        shift=(c.value - c.prior) / before, shrink=spread / before, guess=True,
    )  # fmt: skip


def _widening(C: Array, right: Array, every: Sequence[Estimate], combinations: Sequence[_Combination]) -> float:
    """How many times wider the intervals of what is visible are than those of a right model, whose innovations are
    white and whose covariance is `right`: the geometric mean over them; 1 where nothing is."""
    ratios = [C[i, i] / right[i, i] for i, e in enumerate(every) if e.verdict == VISIBLE]
    slopes = [c.slopes for c in combinations if _combined(c, C).verdict == VISIBLE]
    ratios += [(s @ C @ s) / (s @ right @ s) for s in slopes]
    return float(np.exp(0.5 * np.mean(np.log(ratios)))) if ratios else 1.0


def _delays(problem: Problem, z: Array, C: Array, every: Sequence[Estimate]) -> tuple[Estimate, ...]:
    """Dead times from the command to each sensor, and how much later than the encoders the gyro is."""
    delays = [e for e in every if e.name.startswith("delay/")]
    index = {p.name: i for i, p in enumerate(problem.asked)}
    if {"delay/gyro", "delay/encoder"} <= index.keys():
        i, j = index["delay/gyro"], index["delay/encoder"]
        p, q = problem.parameters[i], problem.parameters[j]
        value = float(p.value(z[i]) - q.value(z[j]))
        prior = p.prior - q.prior
        variance = p.spread**2 * C[i, i] + q.spread**2 * C[j, j] - 2 * p.spread * q.spread * C[i, j]
        half = NORMAL * math.sqrt(variance)
        before = math.hypot(p.spread, q.spread)
        verdict = VISIBLE if half / NORMAL < HALVED * before else PRIOR
        delays.append(Estimate(
            name="delay/gyro−encoder", unit="s", value=value, low=value - half, high=value + half, prior=prior,
            prior_spread=before, verdict=verdict, shift=(value - prior) / before, shrink=half / NORMAL / before,
            guess=True,
        ))  # fmt: skip
    return tuple(delays)


def _checks(
    problem: Problem, z: Array, simulated: Sequence[Segments]
) -> tuple[dict[str, dict[str, float]], dict[str, float]]:
    """h-step fits of the parts kept back, and R² of half seconds simulated freely: means over the recordings."""
    ahead: list[dict[str, dict[str, float]]] = []
    free: list[dict[str, float]] = []
    for recording, parts in zip(problem.recordings, simulated, strict=True):
        r2 = {name: parts.r_squared(name) for name in recording.rows}
        pairs = {n.removeprefix("sensor/").removesuffix("_left") for n in recording.rows if n.endswith("_left")}
        r2 |= {f"mean {pair}": parts.r_squared(pair) for pair in sorted(pairs)}
        free.append({**r2, "lost": parts.lost})
        if (~recording.fitted).sum() > 60 * len(recording.rows):
            ahead.append(steps_ahead(problem, recording, z))
    return {h: _mean([a[h] for a in ahead]) for h in (ahead[0] if ahead else ())}, _mean(free)


def _mean(each: Sequence[Mapping[str, float]]) -> dict[str, float]:
    """Of each name over those that have it."""
    names = dict.fromkeys(name for one in each for name in one)
    return {name: float(np.mean([one[name] for one in each if name in one])) for name in names}


def _notes(
    problem: Problem, every: Sequence[Estimate], other: Sequence[str], best: Explained, wrong: Sequence[Say] | None
) -> tuple[Say, ...]:
    """Remarks on a fit, with what is `wrong` in its logs; None of one that is refused."""
    notes = [] if wrong is None else [*wrong, *which(best.freed)]
    notes += [*dropping.in_words(every, problem.drop), *misaligned.in_words(every, problem.misalignment)]
    notes += resonance.in_words(every)
    contradicted = [e for e in every if e.surprising or e.name in best.contradicted]
    if not best.freed and wrong is not None:
        notes += better(other)
        if best.contradicted:
            names = [term(name) for name in best.contradicted]
            notes.append(
                Say("The log contradicts the stated value of {names}: any of the file may be wrong.", names=names)
            )
        if contradicted and problem.robot.drive == "torque" and GEAR not in (e.name for e in every):
            notes.append(Say("Or the motors give another torque than commanded: give gear_ratio a spread in the file."))
    runs = [e for e in every if e.wider and e.name in FRACTIONS and len(problem.recordings) > 1]
    rest = [term(e.name) for e in every if e.wider and e not in runs]
    if runs:
        names = [term(e.name) for e in runs]
        notes.append(
            Say("The runs differ in these numbers, so that they are less certain than before: {names}.", names=names)
        )
    if rest and best.doubt == 1:
        notes.append(Say("The model's error leaves these numbers less certain than before: {names}.", names=rest))
    elif rest:
        notes.append(Say("Log and file disagree, which leaves these numbers less certain: {names}.", names=rest))
    if best.fit.others:
        notes.append(Say("Other fits predict equally well: the intervals hold each of them."))
    return tuple(notes)
