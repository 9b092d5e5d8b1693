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
from upright.calibration.calibration import GOOD, PREDICTED, Segments
from upright.calibration.contradicted import Freed, in_words
from upright.calibration.electronics import MEANING
from upright.calibration.estimate import FOREIGN, Estimate
from upright.calibration.fitting import Problem
from upright.calibration.parameters import LOSSES, columns
from upright.calibration.validate import score
from upright.logs.recording import SENSOR, Recording, first_noise
from upright.physics.dynamics import turn_ratio
from upright.physics.linear import unstable_pole
from upright.robots import Robot, preset_names
from upright.tables import short

WORSE = 0.02  # [1] R² of half seconds by which the prior's own numbers may predict better
NEARER = 2 / 3  # [1] of what the file's numbers leave of half seconds: another preset that leaves less is proposed
LEVEL = 1.1  # [1] of what the best leaves: presets that leave no more are proposed beside it, those of the kit first
MOST_LAGS = 8  # readings by which a prediction is shifted to see whether it is a delay
HALF = 0.5  # [1] of the readings' deviation: what a sign, a unit or a delay must explain of them to be named
NOISY = 4.0  # times the variance that a sensor's noise and steps give: what is left beyond is of the motion
LEAST = 8  # readings of a half second from which a turn is estimated
TURNED = 1.5  # a factor between prediction and reading that no tolerance of a motor makes


def reasons(
    problem: Problem, z: Array, free: Sequence[Segments], estimates: Sequence[Estimate], other: str = "",
    wrong: Sequence[str] = (), freed: Sequence[Freed] = (),
) -> tuple[str, ...]:  # fmt: skip
    """Why the fit at z (parameters,) is refused as a description of the robot, in words; nothing where it stands.

    `free` are the half seconds of each recording, simulated freely; `other` is what `proposed` proposes. `wrong` is
    what the doctor finds wrong in signs, sides and units: it is then the cause, and no other is guessed. A fit that
    predicts wheels and gyro well stands all the same.
    Of the numbers that are `freed` each alone explains the log; then no other is accused.
    """
    faults = [reason for parts in free for reason in unpredicted(parts)]
    well = min((p.r_squared(name) for p in free for name in p.rows if name in PREDICTED), default=-1.0) >= GOOD
    if wrong and not well:
        return tuple(wrong)
    own = score(problem, np.zeros_like(z))
    if own > score(problem, z) + WORSE:
        faults.append(
            "the numbers of the robot's file predict half seconds of this log better than the fitted ones do: "
            "the log has too little in it, or something that no robot of this kind does"
        )
    foreign = sorted((e for e in estimates if not e.guess and abs(e.shift) > FOREIGN), key=lambda e: -abs(e.shift))
    losses = [e for e in estimates if e.name in LOSSES and e.guess and e.shift > FOREIGN]
    if freed and (foreign or losses):
        faults.append(f"{in_words(freed)}: measure {'these' if len(freed) > 1 else 'it'} again")
    elif foreign:
        stated = "; ".join(
            f"{e.name} {e.prior:.3g} ± {e.prior_spread:.2g} {e.unit}, the log {e.value:.3g}" for e in foreign
        )
        faults.append(
            f"the log is of another robot than the file, which says {stated}: measure these, or choose another robot"
            f"{other}"
        )
    faults += [
        f"{e.name} of {e.value:.3g} {e.unit}, {e.shift:.0f} deviations more than a robot like the file's may lose: its "
        "back_emf, which counts at the wheel, behind the gear, its torque_constant or its gear_ratio is likely wrong"
        for e in losses
        if not freed
    ]
    return tuple(wrong or faults) if faults else ()


def proposed(stated: Problem, problem: Problem, estimates: Sequence[Estimate]) -> str:
    """The presets whose numbers predict half seconds of these logs far better than those of the robot's file, all as
    they stand, in words; '' where there is none, or no cause to ask: a stated number contradicted, or innovations that
    are not white in the fit of `problem`. That fit may predict better than all of them and be of another robot: it has
    bent what its file leaves open."""
    if problem.temper == 1 and not any(e.surprising for e in estimates):
        return ""
    kept = tuple(p for p in stated.parameters if p.name.startswith("delay/") or p.name in MEANING)

    def predicts(robot: Robot) -> float:
        return score(replace(stated, robot=robot, parameters=kept, held=frozenset()), np.zeros(len(kept)))

    robot = stated.robot
    named = {name: Robot.preset(name) for name in preset_names() if name != robot.name}
    left = {name: 1 - predicts(other) for name, other in named.items() if other.drive == robot.drive}
    least = min(left.values(), default=1.0)
    own = min(1 - predicts(robot), 1.0)
    if least > NEARER * own:
        return ""
    level = sorted(
        (n for n in left if left[n] <= LEVEL * least), key=lambda n: (named[n].kit_name != robot.kit_name, left[n])
    )
    better = ", or ".join(f"--robot {name} (R² {1 - left[name]:.2f})" for name in level)
    return f"; half seconds are better predicted as they stand by other presets (this file: R² {1 - own:.2f}): {better}"


def unpredicted(parts: Segments) -> list[str]:
    """Readings that half a second of free simulation predicts worse than their mean does: how badly, where, and why."""
    return [
        f"{name.removeprefix('sensor/').replace('_', ' ')}: half a second of free simulation predicts worse than the "
        f"mean does (R² {parts.r_squared(name):.2g}), worst at t = {worst(parts, name):.3g} s; "
        f"likely {_likely(parts, name)}"
        for name in parts.rows
        if parts.r_squared(name) < 0
    ]


def poorly(problem: Problem, recording: Recording, z: Array, parts: Segments, *, only_known: bool = False) -> list[str]:
    """Readings of which half a second of free simulation leaves more than the target and more than noise, and what
    explains that, in words; those without a known cause are left out where `only_known`."""
    texts: list[str] = []
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
        if only_known and not fraction:
            continue
        why = (
            f"it also measures the turn (yaw), {fraction:.2g} of it. Mount the sensor level, or take that part of the "
            "wheels' turn off its column"
            if fraction
            else "the cause was not found"
        )
        texts.append(f"{short(name)}: half a second of free simulation explains {max(r2, 0):.0%} of it; {why}")
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


def _likely(parts: Segments, name: str) -> str:
    """What explains most of the misses: a sign, a unit, a delay, or none of these."""
    at = parts.row == parts.rows.index(name)
    y, predicted = _about_means(parts.measured[at], parts.predicted[at], parts.segment[at])
    if len(y) < 3 * MOST_LAGS or not predicted.any():
        return "a robot that falls where this one did not: another robot, a flipped sign or a wrong unit"
    slope = float(y @ predicted) / float(predicted @ predicted)
    lags = [_left(y[lag:], predicted[: len(y) - lag]) for lag in range(MOST_LAGS)]
    lags += [_left(y[: len(y) - lag], predicted[lag:]) for lag in range(1, MOST_LAGS)]
    best = int(np.argmin(lags))
    if best and lags[best] < HALF:
        behind = best < MOST_LAGS
        return f"a delay: {best if behind else best - MOST_LAGS + 1} readings {'later' if behind else 'earlier'}"
    if _left(y, slope * predicted) < HALF and slope < 0:
        return "a flipped sign"
    if _left(y, slope * predicted) < HALF and not 1 / TURNED < slope < TURNED:
        return f"a wrong unit: the readings are {slope:.3g} times the prediction"
    return "wheels that slip, another controller period, or a robot unlike the file"


def _about_means(y: Array, predicted: Array, segment: Whole) -> tuple[Array, Array]:
    """Both without the mean of each half second, where the prediction is finite."""
    there = np.isfinite(predicted)
    y, predicted, segment = y[there], predicted[there], segment[there]
    count = np.maximum(np.bincount(segment), 1)
    return tuple(v - (np.bincount(segment, v) / count)[segment] for v in (y, predicted))  # type: ignore[return-value]


def _left(y: Array, predicted: Array) -> float:
    """What of the readings' deviation a prediction leaves [1]."""
    return float(np.sqrt(np.mean((y - predicted) ** 2))) / max(float(np.std(y)), 1e-300)
