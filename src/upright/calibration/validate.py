"""How well a calibrated robot predicts a log: free simulation of segments, steps ahead, and innovations tested."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from upright.arrays import Array, Mask, Whole
from upright.calibration.calibrated_robot import Segments, Whiteness
from upright.calibration.fitting import Normal, Path, Problem, fitted_readings
from upright.calibration.stretch import Stretch, free
from upright.calibration.threads import in_threads
from upright.logs.recording import Recording

HORIZONS = (1, 10, 50)
LAGS = 20


def segments(
    problem: Problem, recording: Recording, z: Array, seconds: float = 0.5, among: Mask | None = None
) -> Segments:
    """Every segment of `seconds` of a recording simulated from its first state, which is fitted to its readings;
    `among` (events,) restricts it to a part."""
    order = problem.order(recording, z)
    order = order if among is None else order[among[order]]
    moment = recording.when[order] - problem.own_delays(recording, z)[order]
    states = problem.filtered(recording, z, keep=True).states
    edges = np.arange(moment[0], moment[-1], seconds)
    scale = _variation(recording, order, moment, edges)
    inside = [np.flatnonzero((moment >= start) & (moment < start + seconds)) for start in edges]
    places = [(n, at) for n, at in enumerate(inside) if (recording.kind[order[at]] >= 0).sum() >= 12]
    stretches = [Stretch(problem, recording, z, order[at], _before(recording, order, at[0]), scale) for _, at in places]
    filtered = [states[order[at[0]]] for _, at in places]
    predicted = [np.empty(0), *in_threads(lambda one: one[0].predicted(one[1]), zip(stretches, filtered, strict=True))]
    events = np.concatenate([np.empty(0, np.int64), *(stretch.events for stretch in stretches)])
    number = np.repeat([n for n, _ in places], [len(stretch.events) for stretch in stretches])
    return Segments(
        recording.rows, recording.kind[events], recording.when[events], recording.value[events],
        np.concatenate(predicted), number.astype(np.int64),
    )  # fmt: skip


def score(problem: Problem, z: Array) -> float:
    """How well free simulation over half seconds follows the fitted parts: 1 is perfect."""
    return _score(problem, np.ascontiguousarray(z, dtype=np.float64).tobytes())


@lru_cache(maxsize=8)
def _score(problem: Problem, of: bytes) -> float:
    """The same at the numbers z that these bytes hold: several judges ask it of one fit."""
    z = np.frombuffer(of)
    return float(np.mean([segments(problem, r, z, among=r.fitted).score() for r in problem.recordings]))


def steps_ahead(problem: Problem, recording: Recording, z: Array, every: int = 5) -> dict[str, dict[str, float]]:
    """Fit [%], 100 (1 − rms(y − ŷ)/std(y)), of free simulation 1, 10 and 50 samples ahead on the part kept back."""
    order = problem.order(recording, z)
    states = problem.filtered(recording, z, keep=True).states
    kept = np.flatnonzero(~recording.fitted[order] & (recording.kind[order] == recording.kind[order].max()))
    moment = recording.when - problem.own_delays(recording, z)
    robot = problem.lanes(recording, z[:, None])
    errors: dict[tuple[int, int], list[float]] = {}
    for first in kept[::every]:
        now = moment[order[first]]
        ahead = order[first + 1 :]
        ahead = ahead[: np.searchsorted(moment[ahead], now + (HORIZONS[-1] + 0.5) * recording.period)]
        begin = states[order[first]][:, None]
        part = order[first : first + 1 + len(ahead)]
        e = free(robot, recording, part, _before(recording, order, first), begin, problem.longest)[1:]
        steps = np.round((moment[ahead] - now) / recording.period)
        for horizon in HORIZONS:
            for i in np.flatnonzero((steps == horizon) & (recording.kind[ahead] >= 0)):
                errors.setdefault((horizon, int(recording.kind[ahead[i]])), []).append(float(e[i, 0]))
    return {
        str(h): {row: _percent(recording, i, errors.get((h, i), [])) for i, row in enumerate(recording.rows)}
        for h in HORIZONS
    }


def _percent(recording: Recording, row: int, errors: Sequence[float]) -> float:
    y = recording.value[(recording.kind == row) & ~recording.fitted]
    if not errors or np.std(y) == 0:
        return float("nan")
    missed = np.where(np.isfinite(errors), errors, 2 * np.std(y))
    return 100 * (1 - float(np.sqrt(np.mean(np.square(missed)))) / float(np.std(y)))


def whiteness(recording: Recording, path: Path) -> list[Whiteness]:
    """Both tests for each reading over the fitted part (Ljung and Box 1978; Ljung 1999, section 16.6)."""
    from scipy.special import chdtri

    threshold = float(chdtri(LAGS, 0.01))
    command = recording.commands.mean(axis=1)
    tests: list[Whiteness] = []
    for row, name in enumerate(recording.rows):
        at = fitted_readings(recording, path) & (recording.kind == row)
        r = path.e[at] / np.sqrt(path.s[at])
        rho = correlations(r, LAGS)
        n = len(r)
        box = n * (n + 2) * float((rho**2 / (n - np.arange(1, LAGS + 1))).sum())
        held = np.interp(recording.when[at], recording.when[recording.kind < 0], command)
        rms = float(np.sqrt(np.mean(r**2)))
        worst = float(np.abs(rho[:5]).max())
        tests.append(Whiteness(name, rms, worst, box, _input_test(r, held), LAGS, threshold))
    return tests


def correlations(r: Array, lags: int) -> Array:
    """Autocorrelation at lags 1 to `lags`; zero of fewer readings than that."""
    if len(r) <= lags:
        return np.zeros(lags)
    r = r - r.mean()
    power = max(float(r @ r), 1e-300)
    return np.array([float(r[lag:] @ r[:-lag]) / power for lag in range(1, lags + 1)])


def _input_test(r: Array, u: Array) -> float:
    """N cᵀ R⁻¹ c / σ²: the covariance c of innovations with earlier commands, against what chance gives."""
    n = len(r)
    r, u = r - r.mean(), u - u.mean()
    c = np.array([float(r[LAGS:] @ u[LAGS - lag : n - lag]) / n for lag in range(LAGS)])
    power = [float(u[lag:] @ u[: n - lag]) / n for lag in range(LAGS)]
    R = np.array([[power[abs(i - j)] for i in range(LAGS)] for j in range(LAGS)])
    return float(n * c @ np.linalg.solve(R + 1e-9 * power[0] * np.eye(LAGS), c) / max(np.mean(r**2), 1e-300))


def worst_correlation(problem: Problem, z: Array, normal: Normal, paths: Sequence[Path]) -> float:  # noqa: ARG001 (the whole of a fit)
    """Largest autocorrelation of any sensor's innovations over five lags."""
    worst = 0.0
    for recording, path in zip(problem.recordings, paths, strict=True):
        for row in range(len(recording.rows)):
            at = fitted_readings(recording, path) & (recording.kind == row)
            worst = max(worst, float(np.abs(correlations(path.e[at] / np.sqrt(path.s[at]), 5)).max()))
    return worst


def _before(recording: Recording, order: Whole, first: int) -> Whole:
    """The last command before the event at place `first`."""
    earlier = order[:first]
    return earlier[recording.kind[earlier] < 0][-1:]


def _variation(recording: Recording, order: Whole, moment: Array, edges: Array) -> Array:
    """A hundredth of how much each row varies within a segment (rows,)."""
    segment = np.searchsorted(edges, moment, side="right")
    variation = np.ones(len(recording.rows))
    for row in range(len(recording.rows)):
        at = recording.kind[order] == row
        y = recording.value[order[at]]
        number = segment[at]
        mean = np.bincount(number, y) / np.maximum(np.bincount(number), 1)
        variation[row] = max(0.01 * float(np.sqrt(np.mean((y - mean[number]) ** 2))), 1e-9)
    return variation
