"""No fit without a judge: whether a fit describes the robot of its log, and what is likely wrong where it does not.

A filter follows nearly any robot one sample ahead. What is judged are half seconds of free simulation, each from its
first state: a fit that predicts worse there than the mean of the readings, or than the numbers it began with, is none,
and one that bends numbers which somebody measured is a fit of another robot.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.arrays import Array, Whole
from upright.calibration.calibrated_robot import GOOD, PREDICTED, Segments
from upright.calibration.contradicted import Freed, which
from upright.calibration.electronics import MEANING
from upright.calibration.estimate import FOREIGN, Estimate
from upright.calibration.fitting import Problem
from upright.calibration.parameters import LOSSES, columns
from upright.calibration.validate import score
from upright.logs.recording import SENSOR, Recording, first_noise
from upright.pages import Quantity, Say
from upright.pages.terms import channel, term
from upright.physics.dynamics import turn_ratio
from upright.physics.linear import unstable_pole
from upright.robots import Robot, preset_names

WORSE = 0.02  # [1] R² of half seconds by which the prior's own numbers may predict better
NEARER = 2 / 3  # [1] of what the file's numbers leave of half seconds: another preset that leaves less is proposed
LEVEL = 1.1  # [1] of what the best leaves: presets that leave no more are proposed beside it, those of the kit first
MOST_LAGS = 8  # readings by which a prediction is shifted to see whether it is a delay
HALF = 0.5  # [1] of the readings' deviation: what a sign, a unit or a delay must explain of them to be named
NOISY = 4.0  # times the variance that a sensor's noise and steps give: what is left beyond is of the motion
LEAST = 8  # readings of a half second from which a turn is estimated
TURNED = 1.5  # a factor between prediction and reading that no tolerance of a motor makes


def reasons(
    problem: Problem,
    z: Array,
    free: Sequence[Segments],
    estimates: Sequence[Estimate],
    other: Sequence[str] = (),
    wrong: Sequence[Say] = (),
    freed: Sequence[Freed] = (),
) -> tuple[Say, ...]:
    """Why the fit at z (parameters,) is refused as a description of the robot; nothing where it stands.

    `free` are the half seconds of each recording, simulated freely; `other` are the presets that are `proposed`.
    `wrong` is what the doctor finds wrong in signs, sides and units: it is then the cause, and no other is guessed. A
    fit that predicts wheels and gyro well stands all the same.
    Of the numbers that are `freed` each alone explains the log; then no other is accused.
    """
    faults = [reason for parts in free for reason in unpredicted(parts)]
    well = min((p.r_squared(name) for p in free for name in p.rows if name in PREDICTED), default=-1.0) >= GOOD
    if wrong and not well:
        return tuple(wrong)
    own = score(problem, np.zeros_like(z))
    if own > score(problem, z) + WORSE:
        faults.append(Say("The robot's file predicts half seconds of this log better than the fitted numbers."))
    foreign = sorted((e for e in estimates if not e.guess and abs(e.shift) > FOREIGN), key=lambda e: -abs(e.shift))
    losses = [e for e in estimates if e.name in LOSSES and e.guess and e.shift > FOREIGN]
    if freed and (foreign or losses):
        faults += which(freed)
    elif foreign:
        faults.append(another(foreign))
        faults += better(other)
    faults += [
        Say(
            "The log needs a {name} of {value}: back_emf, torque_constant or gear_ratio of the file is likely wrong.",
            name=term(e.name),
            value=Quantity(e.value, e.unit),
        )
        for e in losses
        if not freed
    ]
    return tuple(wrong or faults) if faults else ()


def another(foreign: Sequence[Estimate]) -> Say:
    """That the log is of another robot, by the number that says so most clearly."""
    most = foreign[0]
    return Say(
        "The log is of another robot than the file: {name} {value}, not {stated}.",
        name=term(most.name),
        value=Quantity(most.value, most.unit),
        stated=Quantity(most.prior, most.unit),
    )


def better(names: Sequence[str]) -> list[Say]:
    """That presets of these names, as far as there are any, predict better."""
    ways = [f"--robot {name}" for name in names]
    return [Say("Other presets predict this log better than the robot's file: {ways}.", ways=ways)] if ways else []


def proposed(stated: Problem, problem: Problem, estimates: Sequence[Estimate]) -> list[str]:
    """The presets whose numbers predict half seconds of these logs far better than those of the robot's file, all as
    they stand; none where there is no cause to ask: a stated number contradicted, or innovations that are not white in
    the fit of `problem`. That fit may predict better than all of them and be of another robot: it has bent what its
    file leaves open."""
    if problem.temper == 1 and not any(e.surprising for e in estimates):
        return []
    kept = tuple(p for p in stated.parameters if p.name.startswith("delay/") or p.name in MEANING)

    def predicts(robot: Robot) -> float:
        return score(replace(stated, robot=robot, parameters=kept, held=frozenset()), np.zeros(len(kept)))

    robot = stated.robot
    named = {name: Robot.preset(name) for name in preset_names() if name != robot.name}
    left = {name: 1 - predicts(other) for name, other in named.items() if other.drive == robot.drive}
    least = min(left.values(), default=1.0)
    own = min(1 - predicts(robot), 1.0)
    if least > NEARER * own:
        return []
    return sorted(
        (n for n in left if left[n] <= LEVEL * least), key=lambda n: (named[n].kit_name != robot.kit_name, left[n])
    )


def unpredicted(parts: Segments) -> list[Say]:
    """Readings that half a second of free simulation predicts worse than their mean does: where, and why."""
    return [
        Say(
            "Half seconds of the {sensor} are not predicted, least at {time}. Likely: {cause}.",
            sensor=channel(name),
            time=Quantity(worst(parts, name), "s"),
            cause=_likely(parts, name),
        )
        for name in parts.rows
        if parts.r_squared(name) < 0
    ]


def poorly(problem: Problem, recording: Recording, z: Array, parts: Segments, *, only_known: bool = False) -> list[Say]:
    """Readings of which half a second of free simulation leaves more than the target and more than noise, and what
    explains that; those without a known cause are left out where `only_known`."""
    texts: list[Say] = []
    noise = first_noise(recording)
    for name in parts.rows:
        r2 = parts.r_squared(name)
        left = (1 - r2) * float(parts.measured[parts.row == parts.rows.index(name)].var())
        if r2 >= GOOD or left < NOISY * noise[SENSOR[name]]:
            continue
        fraction = 0.0
        pair = [i for i, row in enumerate(parts.rows) if SENSOR[row] == "encoder"]
        if SENSOR[name] == "gyro" and len(pair) == 2:
            delays = dict(zip(recording.kind.tolist(), problem.own_delays(recording, z).tolist(), strict=True))
            delay = delays[parts.rows.index(name)] - delays[pair[0]]
            turn = float(np.ravel(turn_ratio(columns(problem.robot, problem.values(z[:, None]))))[0])
            pole = unstable_pole(problem.robot.without_dry_friction())
            fraction = turning(parts, (parts.rows.index(name), *pair), delay, turn, pole)
        if fraction:
            part = Quantity(fraction, "1", digits=2)
            texts.append(Say("The gyro also measures the turn (yaw), {part} of it: mount it level.", part=part))
        elif not only_known:
            explained = Quantity(max(r2, 0.0), "fraction", digits=2)
            texts.append(
                Say(
                    "Half seconds of the {sensor} are predicted to {part}; the cause was not found.",
                    sensor=channel(name),
                    part=explained,
                )
            )
    return texts


def turning(parts: Segments, rows: Sequence[int], delay: float, turn: float, pole: float) -> float:
    """Which fraction of the yaw rate of the simulated wheels the gyro's misses follow; 0 where that explains less
    than half of them. `rows` are those of gyro, left and right encoder; the gyro's `delay` in [s], W/(2R) is `turn`,
    and a lean grows by the `pole` [1/s]."""
    misses, rates = [np.empty(0)], [np.empty(0)]
    for number in np.unique(parts.segment):
        inside = parts.segment == number
        gyro, left, right = (np.flatnonzero(inside & (parts.row == row)) for row in rows)
        both = min(len(left), len(right))
        if min(len(gyro), both) < LEAST or not np.isfinite(parts.predicted[inside]).all():
            continue
        t = parts.when[left[:both]]
        yaw = (parts.predicted[right[:both]] - parts.predicted[left[:both]]) / (2 * turn)
        yaw = yaw if "rate" in parts.rows[rows[1]] else np.gradient(yaw, t)
        now = parts.when[gyro] - delay
        missed = (parts.measured - parts.predicted)[gyro]
        first = np.exp(np.outer(now - now[0], (0.0, pole, -pole)))
        Q = np.linalg.qr(first)[0]  # what a first state, which was fitted to these readings, has taken of them
        rate = np.interp(now, t, yaw)
        misses.append(missed - Q @ (Q.T @ missed))
        rates.append(rate - Q @ (Q.T @ rate))
    e, rate = np.concatenate(misses), np.concatenate(rates)
    power = float(rate @ rate)
    fraction = float(e @ rate) / power if power > 0 else 0.0
    return fraction if fraction**2 * power > HALF * float(e @ e) else 0.0


def worst(parts: Segments, name: str) -> float:
    """When [s] the half second begins that is predicted worst."""
    at = parts.row == parts.rows.index(name)
    missed = np.abs(parts.measured - parts.predicted)[at]
    missed = np.where(np.isfinite(missed), missed, np.inf)
    return float(parts.when[at][parts.segment[at] == parts.segment[at][np.argmax(missed)]].min())


def _likely(parts: Segments, name: str) -> Say:
    """What explains most of the misses: a sign, a unit, a delay, or none of these."""
    at = parts.row == parts.rows.index(name)
    y, predicted = _about_means(parts.measured[at], parts.predicted[at], parts.segment[at])
    if len(y) < 3 * MOST_LAGS or not predicted.any():
        return Say("another robot, a flipped sign or a wrong unit")
    slope = float(y @ predicted) / float(predicted @ predicted)
    lags = [_left(y[lag:], predicted[: len(y) - lag]) for lag in range(MOST_LAGS)]
    lags += [_left(y[: len(y) - lag], predicted[lag:]) for lag in range(1, MOST_LAGS)]
    best = int(np.argmin(lags))
    if best and lags[best] < HALF:
        if best < MOST_LAGS:
            return Say("it comes late by {n} of its readings", n=best)
        return Say("it comes early by {n} of its readings", n=best - MOST_LAGS + 1)
    if _left(y, slope * predicted) < HALF and slope < 0:
        return Say("a flipped sign")
    if _left(y, slope * predicted) < HALF and not 1 / TURNED < slope < TURNED:
        return Say("a wrong unit: readings are {times} times the prediction", times=Quantity(slope, "1"))
    return Say("wheels that slip, another controller period, or another robot")


def _about_means(y: Array, predicted: Array, segment: Whole) -> tuple[Array, Array]:
    """Both without the mean of each half second, where the prediction is finite."""
    there = np.isfinite(predicted)
    y, predicted, segment = y[there], predicted[there], segment[there]
    count = np.maximum(np.bincount(segment), 1)
    return tuple(v - (np.bincount(segment, v) / count)[segment] for v in (y, predicted))  # type: ignore[return-value]


def _left(y: Array, predicted: Array) -> float:
    """What of the readings' deviation a prediction leaves [1]."""
    return float(np.sqrt(np.mean((y - predicted) ** 2))) / max(float(np.std(y)), 1e-300)
