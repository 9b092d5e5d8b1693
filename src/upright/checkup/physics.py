"""Two regressions on the equations of motion that need no parameter of the robot.

With δ the wheels' angle relative to the body (what encoders read), ψ the pitch and u the command, the model's two rows
give, near the upright,

    pendulum   δ⃛ = −q ψ⃛ + p ψ̇      q = (a11 + 2 a12 + a22)/(a11 + a12) > 1,   p = MgL/(a11 + a12)
    motor      u = A δ̈ + B ψ̈ + D δ̇ + C sign δ̇      no gravity in it; A, B, C, D ≥ 0

(the sum of both rows contains no motor torque, the first row no gravity). No sensor stands on both sides, so that its
noise is not correlated with itself. Derivatives are those of a Gaussian kernel, the same for all channels, which keeps
linear equations valid and attenuates quantisation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.checkup.finding import FEWEST, FORWARD, GAP, GYRO, LEFT, PITCH, RIGHT, UP, Array, Record
from upright.checkup.fixes import beside

WIDTHS = (0.03, 0.06)
"""Standard deviations [s] of the kernel: band limits of 5 and 2.7 Hz, about the motion of balancing robots."""

_MOST_ROWS = 6_000  # of a regression, spread over the log; more do not change the findings
_MOST_RESPONSE_ROWS = 20_000  # of a response, which is small against the noise
_TRIM = 0.9  # fraction of the rows that are kept: pushes, slip and stops affect the rest
REACH = 0.12  # [s] largest delay of the search
LEAST_ROWS = 100
FAR, LOUD = 8.0, 3.0
"""Standard deviations of an equation's residual, and times the usual motion, that a push or a slip exceeds: rows of
real logs without one are within 6."""
_ALIGNED = 0.6  # R² of the pendulum equation above which its delay is taken
_LEAST_KERNELS = 2.0 * 2 * np.sqrt(np.pi)
"""[kernel widths] of motion that a fit needs: 2√π of them are one independent sample, and two are fewer than the
numbers that are fitted."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Resampled:
    """Encoders, gyro and commands, resampled every `period` [s]; None where missing; `good` rows lie in no gap, and
    in a pose in which the equations of motion hold.

    Without a gyro, `gyro` is the rate of the logged pitch estimate, and `gyro_name` is that channel. `wheels` tells
    whether the log has encoders.
    """

    t: Array
    period: float
    left: Array
    right: Array
    gyro: Array | None
    commands: tuple[Array, Array] | None
    good: NDArray[Any]
    gyro_name: str = GYRO
    wheels: bool = True

    @cached_property
    def wheel(self) -> Array:
        """Mean of both encoders [rad]."""
        return (self.left + self.right) / 2

    @cached_property
    def law(self) -> LaggedFit:
        """`pendulum` of the mean wheel."""
        return pendulum(self, self.wheel)

    @cached_property
    def alignment(self) -> tuple[float, float]:
        """The delay [s] of the gyro behind the wheels and q, where `law` fits; else zeros."""
        fits = self.gyro is not None and self.law.r2 > _ALIGNED
        return (self.law.lag, self.law.values[0]) if fits else (0.0, 0.0)

    @cached_property
    def drive(self) -> LaggedFit:
        """`motor` of the mean command, with the gyro aligned."""
        assert self.commands is not None
        mean = (self.commands[0] + self.commands[1]) / 2
        return motor(self, mean, self.left, self.right, self.gyro, self.alignment[0])


@dataclass(frozen=True)
class LaggedFit:
    """Coefficients of a regression, its R² on the rows kept, the lag [s] of the first regressor's channel, how `sharp`
    it is: the residual two rows away over the residual at the lag, and how many standard deviations `off` the equation
    a row is at most; 0 where that is little beside the usual motion."""

    values: tuple[float, ...]
    r2: float
    lag: float = 0.0
    sharp: float = 1.0
    off: float = 0.0

    @property
    def pushed(self) -> bool:
        """Whether something that the log does not name moves the robot, more than its usual motion: the fit bends."""
        return self.off > FAR


@lru_cache(maxsize=2)  # every check of a record asks for it, and for the fits that it keeps
def motion(record: Record) -> Resampled | None:
    """The record resampled at even times, its `good` rows those on the wheels; None without encoders or with too few
    such rows."""
    m = resampled(record)
    if m is None:
        return None
    good = m.good & record.on_wheels(m.t)
    return replace(m, good=good) if good.sum() >= LEAST_ROWS else None


@lru_cache(maxsize=2)
def resampled(record: Record) -> Resampled | None:
    """The record resampled at even times, in whatever pose; None without encoders or with too few rows."""
    if LEFT not in record or RIGHT not in record or len(record.t) < FEWEST:
        return None
    period = record.period
    rows = (record.t[-1] - record.t[0]) / period + 1
    if not rows <= 4 * len(record.t):
        return None
    t = record.t[0] + np.arange(int(rows)) * period

    def even(name: str) -> Array:
        values = record[name]
        fine = np.isfinite(values)
        return np.interp(t, record.t[fine], values[fine]) if fine.sum() > 1 else np.zeros(len(t))

    after = np.clip(np.searchsorted(record.t, t, side="right"), 1, len(record.t) - 1)
    good = (record.t[after] - record.t[after - 1]) < GAP * period
    name = GYRO if GYRO in record else PITCH
    gyro = even(GYRO) if GYRO in record else backward_rate(even(PITCH), period) if PITCH in record else None
    pair = record.commands
    commands = (even(pair[0]), even(pair[1])) if pair else None
    return Resampled(
        t=t, period=period, left=even(LEFT), right=even(RIGHT), gyro=gyro, commands=commands, good=good, gyro_name=name
    )


def smooth(values: Array, period: float, width: float, order: int = 0) -> Array:
    """The `order`-th time derivative under a Gaussian kernel of standard deviation `width` [s]."""
    from scipy.ndimage import gaussian_filter1d

    sigma = max(width / period, 1.0)
    return gaussian_filter1d(values, sigma, order=order, mode="nearest", truncate=4.0) / period**order


def widths(period: float) -> tuple[float, ...]:
    """The kernels that rows of this period [s] allow."""
    return tuple(dict.fromkeys(max(width, 2 * period) for width in WIDTHS))


def _rows(m: Resampled, width: float) -> NDArray[np.intp]:
    margin = int((4 * width + REACH) / m.period) + 2
    inside = np.arange(margin, len(m.t) - margin)
    near = int(4 * width / m.period) + 1
    if not m.good.all():
        inside = inside[~beside(~m.good, near)[inside]]
    return inside[:: max(1, len(inside) // _MOST_ROWS)]


def _moving(values: Array) -> float:
    """How many of the rows hold the motion: all of a steady one, one of a single peak."""
    squares = values**2
    most = float(squares.max(initial=0.0))
    return float(squares.sum() ** 2 / (squares @ squares)) if most > 0 else 0.0


def trimmed(y: Array, X: Array, positive: bool = False) -> tuple[Array, float, NDArray[Any]]:
    """Trimmed least squares with an intercept, R² on the rows kept, and these rows."""
    keep = np.ones(len(y), dtype=bool)
    values = np.zeros(X.shape[1])
    columns = X.T
    r2 = 0.0
    for last in (False, False, True):
        some = columns[:, keep]
        centre, middle = some.mean(axis=1), y[keep].mean()
        Z, z = some - centre[:, None], y[keep] - middle
        squares = Z @ Z.T
        power = float(z @ z)
        if power <= 0 or not np.isfinite(squares).all():
            return values, 0.0, keep
        scale = _sizes(squares, len(z))
        values = _solved(squares / np.outer(scale, scale), (Z @ z) / scale, positive) / scale
        residual = y - middle - values @ (columns - centre[:, None])
        r2 = 1 - float(residual[keep] @ residual[keep]) / power
        if not last:
            keep = np.abs(residual) <= np.quantile(np.abs(residual), _TRIM)
    return values, r2, keep


def lagged(
    m: Resampled, width: float, target: Array, shifted: list[Array], *, positive: bool = False,
    reach: tuple[float, float] = (-REACH, REACH),
) -> LaggedFit:  # fmt: skip
    """The fit of `target` on `shifted` (read `lag` later, to a fraction of a row) with the best lag.

    Rows are trimmed at the best lag of a first pass, so that the second compares all lags on the same rows.
    """
    rows = _rows(m, width)
    if len(rows) < LEAST_ROWS // 2 or not target[rows].any():
        return LaggedFit((), 0.0)
    shifts = np.arange(round(reach[0] / m.period), round(reach[1] / m.period) + 1)

    def design(kept: NDArray[np.intp], shift: int) -> Array:
        return np.stack([x[kept + shift] for x in shifted])

    def quick(kept: NDArray[np.intp]) -> Array:
        return _r_squared(target[kept], (design(kept, shift) for shift in shifts.tolist()), positive)

    best = int(shifts[int(np.argmax(quick(rows)))])
    keep = trimmed(target[rows], design(rows, best).T, positive)[2]
    r2s = quick(rows[keep])
    i = int(np.argmax(r2s))
    X = design(rows, int(shifts[i])).T
    values, r2, _ = trimmed(target[rows], X, positive)
    if _moving((X - X.mean(axis=0)) @ values) * m.period < _LEAST_KERNELS * width:
        return LaggedFit((), 0.0)
    left_over = 1 - r2s[[j for j in (i - 2, i, i + 2) if 0 <= j < len(r2s)]]
    sharp = float(np.sort(left_over)[min(1, len(left_over) - 1)] / max(1 - r2s[i], 1e-12))
    miss = np.abs(_centred(target[rows] - X @ values))
    most = float(miss.max())
    usual = float(np.median(np.abs(_centred(target[rows])))) / 0.6745
    off = most / max(float(np.median(miss)) / 0.6745, 1e-300) if most > LOUD * usual else 0.0
    return LaggedFit(tuple(values.tolist()), r2, float((shifts[i] + _vertex(r2s, i)) * m.period), sharp, off)


def _centred(values: Array) -> Array:
    return values - np.median(values)


def _sizes(gram: Array, rows: int) -> Array:
    """RMS of each centred column by the products (…, m, m) of all; 1 for what never changes, as wheels that stand."""
    size = np.sqrt(np.diagonal(gram, axis1=-2, axis2=-1) / rows)
    return np.where(size > 0, size, 1.0)


def _r_squared(y: Array, designs: Iterable[Array], positive: bool) -> Array:
    """R² of y (n,) on each of the designs (m, n), no coefficient below zero if `positive`."""
    z = y - y.mean()
    power = float(z @ z)
    centred = [X - X.mean(axis=1, keepdims=True) for X in designs]
    if power <= 0:
        return np.zeros(len(centred))
    gram = np.stack([X @ X.T for X in centred])
    side = np.stack([X @ z for X in centred])
    scale = _sizes(gram, len(y))
    gram, side = gram / (scale[:, :, None] * scale[:, None, :]), side / scale
    values = (np.linalg.pinv(gram, rcond=1e-12, hermitian=True) @ side[:, :, None])[:, :, 0]
    for i in np.flatnonzero((values < 0).any(axis=1)) if positive else ():
        values[i] = _solved(gram[i], side[i], positive)
    return np.asarray(2 * (values * side).sum(axis=1) - np.einsum("ki,kij,kj->k", values, gram, values)) / power


def _solved(gram: Array, side: Array, positive: bool) -> Array:
    """The coefficients of the normal equations, none below zero if `positive`."""
    if not positive:
        return np.asarray(np.linalg.lstsq(gram, side, rcond=1e-12)[0], dtype=np.float64)
    from scipy.optimize import nnls

    # of a command that never changes the matrix is zero
    factor = np.linalg.cholesky(gram + 1e-12 * (np.trace(gram) or 1.0) * np.eye(len(gram)))
    return nnls(factor.T, np.linalg.solve(factor, side))[0]


def _vertex(r2s: Array, i: int) -> float:
    """The vertex of the parabola through the largest R² and its neighbours, in rows from the largest."""
    if not 0 < i < len(r2s) - 1:
        return 0.0
    a, b, c = r2s[i - 1 : i + 2].tolist()
    return 0.5 * (a - c) / (a - 2 * b + c) if a - 2 * b + c < 0 else 0.0


def pendulum(m: Resampled, wheel: Array, *, gyro_order: int = 0, positive: bool = False) -> LaggedFit:
    """q and p of δ⃛ = −q ψ⃛ + p ψ̇, and the delay of the gyro behind the wheel [s].

    `gyro_order=1` reads the gyro's channel as an angle; `positive` gives the best fit of a robot, q and p ≥ 0.
    """
    fits: list[LaggedFit] = []
    assert m.gyro is not None
    for width in widths(m.period):
        target = smooth(wheel, m.period, width, 3)
        change = -smooth(m.gyro, m.period, width, 2 + gyro_order)
        level = smooth(m.gyro, m.period, width, gyro_order)
        fits.append(lagged(m, width, target, [change, level], positive=positive))
    return max(fits, key=lambda fit: fit.r2)


def motor(
    m: Resampled, command: Array, left: Array, right: Array, gyro: Array | None, gyro_lag: float = 0.0
) -> LaggedFit:
    """A, D, C (both wheels), B ≥ 0 of the motor equation, and the delay of the wheels behind the command [s].

    The half period of a held command is not counted as a delay.
    """
    fits: list[LaggedFit] = []
    for width in widths(m.period):
        half = smooth(_delayed(command, 0.5), m.period, width)
        mean = (left + right) / 2
        rub = sum(_sign(x, m.period, width) for x in (left, right)) / 2
        parts = [smooth(mean, m.period, width, 2), smooth(mean, m.period, width, 1), np.asarray(rub)]
        if gyro is not None:
            aligned = np.interp(m.t + gyro_lag, m.t, gyro)
            parts.append(smooth(aligned, m.period, width, 1))
        fits.append(lagged(m, width, half, parts, positive=True, reach=(-0.02, REACH)))
    return max(fits, key=lambda fit: fit.r2)


def _delayed(values: Array, fraction: float) -> Array:
    """`values` delayed by a fraction of a row; half a row is the mean delay of a held command."""
    return np.concatenate([values[:1], (1 - fraction) * values[1:] + fraction * values[:-1]])


def _sign(values: Array, period: float, width: float) -> Array:
    """The direction of motion, smoothed like everything else."""
    rate = smooth(values, period, max(width / 2, period), 1)
    return smooth(np.tanh(rate / 0.5), period, width)


def backward_rate(angle: Array, period: float) -> Array:
    """The backward difference quotient, which is causal."""
    return np.diff(angle, prepend=angle[:1]) / period


@dataclass(frozen=True, eq=False)
class Response:
    """Response of a channel to one unit of unpredictable command 0, 1, 2, … rows later, the t-value of each, and the
    standard deviation of the unpredictable part (`surprise`)."""

    gain: Array
    t_value: Array
    surprise: float


def responses(
    m: Resampled, u: Array, channels: dict[str, Array], order: int = 6, reach: int = 14
) -> dict[str, Response]:
    """The response of each of `channels` to the part of the command `u` that the past does not predict.

    Regressing later rows on the command of row k, with the past and row k as further regressors, is free of the bias
    that feedback gives to a cross-correlation (Jordà 2005, local projections).
    """
    rows = np.arange(order + 1, len(u) - reach - 1)
    rows = rows[~beside(~m.good, order + reach)[rows]]
    rows = rows[:: max(1, len(rows) // _MOST_RESPONSE_ROWS)]
    if len(rows) < LEAST_ROWS:
        return {}
    past = [x[rows - i] for x in channels.values() for i in range(order)] + [u[rows - i] for i in range(1, order + 1)]
    Q = np.linalg.qr(np.column_stack([*past, np.ones(len(rows))]))[0]

    def rest(x: Array) -> Array:
        return x - Q @ (Q.T @ x)

    surprise = rest(u[rows])
    power = float(surprise @ surprise)
    if power <= 1e-8 * float(u[rows] @ u[rows]) or power == 0:  # rounding errors only
        return {}
    return {name: _response(rest, surprise, power, x, rows, reach) for name, x in channels.items()}


def _response(
    rest: Callable[[Array], Array], surprise: Array, power: float, x: Array, rows: Any, reach: int
) -> Response:
    gain, t_value = np.zeros(reach), np.zeros(reach)
    for j in range(reach):
        y = rest(x[rows + j])
        gain[j] = float(surprise @ y) / power
        spread = np.sqrt(float(((y - gain[j] * surprise) ** 2).mean()) / power)
        t_value[j] = gain[j] / spread if spread > 0 else 0.0
    return Response(gain, t_value, float(np.sqrt(power / len(rows))))


def gyro_by_gravity(record: Record, m: Resampled) -> float:
    """The factor by which the gyro is too large according to the accelerometer; 0 where it is undetermined.

    For small angles the accelerometer's pitch obeys ψ̇_a = ψ̇ − (R/g) θ⃛: it is regressed on the gyro, the gyro's second
    derivative and δ⃛.
    """
    if FORWARD not in record or UP not in record or m.gyro is None:
        return 0.0
    lean = np.arctan2(-record[FORWARD], record[UP])
    if not np.isfinite(lean).all():
        return 0.0
    even = np.interp(m.t, record.t, lean)
    width = widths(m.period)[-1]
    parts = [smooth(m.gyro, m.period, width), smooth(m.gyro, m.period, width, 2), smooth(m.wheel, m.period, width, 3)]
    fit = lagged(m, width, smooth(even, m.period, width, 1), parts, reach=(-0.05, 0.05))
    return 1 / fit.values[0] if fit.r2 > 0.7 and fit.values and fit.values[0] else 0.0


def pitch_slope(record: Record, m: Resampled) -> tuple[float, float]:
    """The rate of the pitch estimate over the gyro, which should be 1, and R² of that; zeros where it is unknown."""
    if PITCH not in record or m.gyro is None or m.gyro_name != GYRO or not np.isfinite(record[PITCH]).all():
        return 0.0, 0.0
    even, width = np.interp(m.t, record.t, record[PITCH]), widths(m.period)[-1]
    fit = lagged(m, width, smooth(even, m.period, width, 1), [smooth(m.gyro, m.period, width)], reach=(-0.06, 0.06))
    return (fit.values[0], fit.r2) if fit.values else (0.0, 0.0)
