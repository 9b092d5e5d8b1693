"""Can this log tell? Which directions of the parameters its readings fix, and how surely.

Information about z, the parameters in deviations of their prior, is J'J of the whitened innovations; the prior's is the
identity. Where a direction has less than the prior, the log tells nothing of it that was not known before.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.special import ndtri, stdtrit

from upright.arrays import Array
from upright.calibration.electronics import ASYMMETRY
from upright.calibration.fitting import Normal, Path, Problem, fitted_readings
from upright.calibration.parameters import ROLL_FRACTION, rows_of
from upright.logs.outliers import grain_of
from upright.logs.recording import SENSOR, Recording
from upright.pages import Quantity, Say
from upright.pages.terms import term

INERTIAL = ("com_height", "pitch_inertia", "yaw_inertia", "rotor_inertia", "wheel_inertia", ROLL_FRACTION)
TURNING = (ASYMMETRY, "yaw_inertia", "track", ROLL_FRACTION)
"""What moves nothing but the turning of the robot."""
STRAIGHT = Say("The robot drives straight: track, yaw and roll inertia stay as they were.")
AGREE = 2
"""[1] Steps of an encoder: two that show one motion differ by one, or two where they are read a moment apart."""
QUIET = 4.0
"""Root mean square of the pitch rate, in steps of its gyro, below which no inertia is given: the errors of the readings
then are no longer small beside the motion, and what the fit calls an inertia is partly their image."""

MARGIN = 10.0
"""[nats] of likelihood, readings weighted by what they count for it, by which a cause must be likelier that a log may
have beside its robot: a resonance, a gain that its file states, a factor on the commands of a run. Odds of e¹⁰, twenty
thousand to one: a log has many causes of innovations that are not white, and each of these is only one."""

WINDOW = 1.0  # [s] beyond which innovations are taken to be independent: many times the time in which a robot falls


def too_quiet(problem: Problem) -> Say | None:
    """Why these logs can give no inertia; None where they can."""
    motions = [_motion(r, np.exp(0.5 * problem.noise["gyro"])) for r in problem.recordings]
    loudest = max(motions)
    if loudest >= QUIET:
        return None
    return Say(
        "Too quiet for an inertia: the gyro moves by {steps} of its steps (rms); {least} are needed.",
        steps=Quantity(loudest, "1", digits=2),
        least=Quantity(QUIET, "1"),
    )


def drives_straight(problem: Problem) -> bool:
    """Whether nothing is known of turning: in every log there is one encoder, or both agree to `AGREE` of their
    steps."""
    return all(map(_straight, problem.recordings))


def _straight(recording: Recording) -> bool:
    wheels = [recording.value[recording.kind == i] for i, row in enumerate(recording.rows) if SENSOR[row] == "encoder"]
    if len(wheels) < 2:
        return True
    if len({len(wheel) for wheel in wheels}) > 1:  # some reading is missing of one
        return False
    return float(np.ptp(wheels[0] - wheels[1])) < (AGREE + 0.5) * max(map(grain_of, wheels))


def _motion(recording: Recording, deviation: float) -> float:
    gyro = recording.value[recording.kind == [SENSOR[r] for r in recording.rows].index("gyro")]
    step = deviation * np.sqrt(12.0)
    return float(np.std(gyro) / step)


def scores(problem: Problem, normal: Normal, paths: Sequence[Path]) -> list[Array]:
    """For each recording the gradient's parts (periods, parameters), summed over the readings of a period."""
    by_recording: list[Array] = []
    start = 0
    each = (normal.weight * normal.whitened)[:, None] * normal.slopes
    for recording, path in zip(problem.recordings, paths, strict=True):
        use = fitted_readings(recording, path)
        period = np.round((recording.when[use] - recording.when[0]) / recording.period).astype(np.int64)
        summed = np.zeros((int(period.max()) + 1, normal.slopes.shape[1]))
        np.add.at(summed, period, each[start : start + len(period)])
        by_recording.append(summed)
        start += len(period)
    return by_recording


def score_covariance(problem: Problem, normal: Normal, paths: Sequence[Path]) -> Array:
    """Covariance of the gradient's data part with its correlation in time up to `WINDOW` (Newey and West 1987)."""
    total = np.zeros((len(problem.parameters),) * 2)
    for recording, G in zip(problem.recordings, scores(problem, normal, paths), strict=True):
        lags = min(max(1, round(WINDOW / recording.period)), len(G) - 1)
        total += G.T @ G
        for lag in range(1, lags):
            C = G[lag:].T @ G[:-lag]
            total += (1 - lag / lags) * (C + C.T)
    return total


def information(problem: Problem, normal: Normal) -> Array:
    """What the readings alone say of z, as if their innovations were white."""
    return (normal.hessian - np.eye(len(normal.hessian))) / problem.temper


def effective_fraction(problem: Problem, normal: Normal, paths: Sequence[Path]) -> float:
    """Effective sample size over the number of readings: white over true covariance of the score."""
    white = information(problem, normal)
    true = score_covariance(problem, normal, paths)
    values, directions = np.linalg.eigh(white)
    visible = values > 4.0
    if not visible.any():
        return 1.0
    ratio = np.einsum("ij,ik,kj->j", directions, true, directions)[visible] / values[visible]
    return float(np.clip(1 / ratio.mean(), 1e-3, 1.0))


def posterior(problem: Problem, z: Array, normal: Normal, paths: Sequence[Path]) -> Array:
    """Covariance of the errors of z (n,), as (n, n): the larger of the one that takes innovations for white and the one
    that does not.

    Held parameters keep their prior's unit variance, and its share in the others (Schmidt 1966). A short log's scores
    tell their own covariance badly: it is larger by what Student's distribution has beyond the normal one. Nothing is
    less known than by the prior alone.
    """
    active = problem.active
    H = normal.hessian[np.ix_(rows_of(active), rows_of(active))]
    cross = normal.hessian[np.ix_(rows_of(active), rows_of(~active))]
    inverse = np.linalg.inv(H)
    meat = (student(problem) * problem.temper) ** 2 * score_covariance(problem, normal, paths)[
        np.ix_(rows_of(active), rows_of(active))
    ] + np.eye(len(H))
    robust = inverse @ meat @ inverse
    scale = np.sqrt(np.maximum(1.0, np.diag(inverse) / np.maximum(np.diag(robust), 1e-30)))
    known = inverse @ cross
    total = np.eye(len(active))
    total[np.ix_(rows_of(active), rows_of(active))] = robust * np.outer(scale, scale) + known @ known.T
    total[np.ix_(rows_of(active), rows_of(~active))] = -known
    total[np.ix_(rows_of(~active), rows_of(active))] = -known.T
    return _within_prior(total, z)


def _within_prior(C: Array, z: Array) -> Array:
    """C (n, n), in no direction larger than I + zzᵀ: by the prior alone the mean square error of z (n,) is that."""
    root = np.linalg.cholesky(np.eye(len(z)) + np.outer(z, z))
    values, directions = np.linalg.eigh(np.linalg.solve(root, np.linalg.solve(root, C).T))
    if values[-1] <= 1:
        return C
    half = root @ directions
    return (half * np.minimum(values, 1.0)) @ half.T


def between_optima(C: Array, z: Array, others: Sequence[Array]) -> Array:
    """C (n, n), the covariance about z (n,), in each direction as large as the mean square distance at least from the
    `others` (m, n) of which any may be the right one as well."""
    if not len(others):
        return C
    away = np.array([other - z for other in others])
    root = np.linalg.cholesky(C)
    apart = np.linalg.solve(root, away.T)
    values, directions = np.linalg.eigh(apart @ apart.T / (1 + len(others)))
    half = root @ directions
    return (half * np.maximum(values, 1.0)) @ half.T


def student(problem: Problem) -> float:
    """By how much wider 95 % of Student's distribution is than of the normal one, for the degrees of freedom of a
    covariance from Bartlett's window at frequency zero, 3T/2M (Jenkins and Watts 1968); 1 for white innovations."""
    if problem.temper == 1:
        return 1.0
    seconds = sum(float(np.ptp(r.when[r.fitted])) for r in problem.recordings)
    return float(stdtrit(1.5 * seconds / WINDOW, 0.975) / ndtri(0.975))


def unseen_directions(problem: Problem, normal: Normal) -> list[Say]:
    """The directions of the parameters that the log does not fix, though each alone might seem fixed."""
    names = [p.name for p in problem.asked]
    C = np.linalg.inv(np.eye(len(problem.parameters)) + information(problem, normal))[: len(names), : len(names)]
    values, directions = np.linalg.eigh(np.linalg.inv(C) - np.eye(len(names)))
    unfixed: list[Say] = []
    for value, v in zip(values, directions.T, strict=True):
        if value >= 1.0:
            break
        large = np.flatnonzero(np.abs(v) > 0.4)
        if len(large) > 1:
            together = [
                Say("{name} up", name=term(names[i]))
                if v[i] * v[large[0]] > 0
                else Say("{name} down", name=term(names[i]))
                for i in large
            ]
            unfixed.append(Say("The readings hardly change with these together: {numbers}.", numbers=together))
    return unfixed
