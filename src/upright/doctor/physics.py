"""What the laws of motion say of a record: two regressions in which no number of the robot is known.

With δ the wheels' angle relative to the body (what encoders read), ψ the pitch and u the command, the model's two rows
give, near the upright,

    pendulum   δ⃛ = −q ψ⃛ + p ψ̇      q = (a11 + 2 a12 + a22)/(a11 + a12) > 1,   p = MgL/(a11 + a12)
    motor      u = A δ̈ + B ψ̈ + D δ̇ + C sign δ̇      no gravity in it; A, B, C, D ≥ 0

(the sum of both rows has no motor in it; the first row no gravity). No term stands on both sides, so that one sensor's
noise cannot correlate with itself. Derivatives are those of a Gaussian kernel, one for all channels, which
leaves linear equations true and quantisation small.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.doctor.finding import GYRO, LEFT, PITCH, RIGHT, Array, Record

WIDTHS = (0.03, 0.06)
"""Standard deviations [s] of the kernel: band limits of 5 and 2.7 Hz, round the motion of balancing robots."""

_MOST_ROWS = 6_000  # of a regression, spread over the log; more of them change nothing that is reported
_MOST_ANSWERS = 20_000  # rows; an answer is small, so more of them count
_TRIM = 0.9  # share of the rows that are kept: what pushes, slips and stops spoil is the rest
_REACH = 0.12  # [s] largest delay that is looked for
_LEAST_ROWS = 100


@dataclass(frozen=True, eq=False)
class Motion:
    """Encoders, gyro and commands at even times `period` [s]; what the record lacks is None; `good` rows are no gap.

    Without a gyro the rate of the logged pitch estimate stands in for it, and `gyro_name` says so.
    """

    t: Array
    period: float
    left: Array
    right: Array
    gyro: Array | None
    commands: tuple[Array, Array] | None
    good: NDArray[Any]
    gyro_name: str = GYRO

    @property
    def wheel(self) -> Array:
        """Mean of both encoders [rad]."""
        return (self.left + self.right) / 2


@dataclass(frozen=True)
class Fit:
    """Coefficients of a regression, its R² on the rows kept, the lag [s] of the first regressor's channel, and how
    `sharp` that is: what is left unexplained two rows off it, over what is left at it."""

    values: tuple[float, ...]
    r2: float
    lag: float = 0.0
    sharp: float = 1.0


def motion(record: Record) -> Motion | None:
    """The record at even times, or None where there are no encoders or too few rows."""
    if LEFT not in record or RIGHT not in record or len(record.t) < _LEAST_ROWS:
        return None
    period = record.period
    t = record.t[0] + np.arange(int((record.t[-1] - record.t[0]) / period) + 1) * period
    if len(t) > 4 * len(record.t):
        return None

    def even(name: str) -> Array:
        values = record[name]
        fine = np.isfinite(values)
        return np.interp(t, record.t[fine], values[fine]) if fine.sum() > 1 else np.zeros(len(t))

    after = np.clip(np.searchsorted(record.t, t, side="right"), 1, len(record.t) - 1)
    good = (record.t[after] - record.t[after - 1]) < 5 * period
    name = GYRO if GYRO in record else PITCH
    gyro = even(GYRO) if GYRO in record else np.gradient(even(PITCH), period) if PITCH in record else None
    pair = record.commands
    commands = (even(pair[0]), even(pair[1])) if pair else None
    return Motion(t, period, even(LEFT), even(RIGHT), gyro, commands, good, name)


def smooth(values: Array, period: float, width: float, order: int = 0) -> Array:
    """The `order`-th time derivative under a Gaussian kernel of standard deviation `width` [s]."""
    from scipy.ndimage import gaussian_filter1d

    sigma = max(width / period, 1.0)
    return gaussian_filter1d(values, sigma, order=order, mode="nearest", truncate=4.0) / period**order


def widths(period: float) -> tuple[float, ...]:
    """The kernels that rows of this period [s] allow."""
    return tuple(dict.fromkeys(max(width, 2 * period) for width in WIDTHS))


def _rows(m: Motion, width: float) -> NDArray[np.intp]:
    margin = int((4 * width + _REACH) / m.period) + 2
    inside = np.arange(margin, len(m.t) - margin)
    near = int(4 * width / m.period) + 1
    if not m.good.all():
        bad = np.convolve(~m.good, np.ones(2 * near + 1), mode="same") > 0.5
        inside = inside[~bad[inside]]
    return inside[:: max(1, len(inside) // _MOST_ROWS)]


def _regress(y: Array, X: Array, positive: bool) -> tuple[Array, float, NDArray[Any]]:
    """Trimmed least squares with an intercept (its own column is taken out), and R² on the rows kept."""
    keep = np.ones(len(y), dtype=bool)
    values, r2 = np.zeros(X.shape[1]), 0.0
    for last in (False, False, True):
        centre, middle = X[keep].mean(axis=0), y[keep].mean()
        Z, z = X[keep] - centre, y[keep] - middle
        scale = np.maximum(np.sqrt((Z**2).mean(axis=0)), 1e-300)
        power = float(z @ z)
        if power <= 0 or not np.isfinite(Z).all():
            return values, 0.0, keep
        unit = Z / scale
        values = _solved(unit.T @ unit, unit.T @ z, positive) / scale
        residual = y - middle - (X - centre) @ values
        r2 = 1 - float(residual[keep] @ residual[keep]) / power
        if not last:
            keep = np.abs(residual) <= np.quantile(np.abs(residual), _TRIM)
    return values, r2, keep


def lagged(
    m: Motion, width: float, target: Array, shifted: list[Array], fixed: list[Array], *, positive: bool = False,
    reach: tuple[float, float] = (-_REACH, _REACH),
) -> Fit:  # fmt: skip
    """The fit of `target` on `shifted` (read `lag` later, in whole and part rows) and `fixed` with the best lag.

    Rows are trimmed at the best lag of a first pass, so that all lags of the second are judged on the same rows.
    """
    rows = _rows(m, width)
    if len(rows) < _LEAST_ROWS // 2 or not target[rows].any():
        return Fit((), 0.0)
    shifts = np.arange(round(reach[0] / m.period), round(reach[1] / m.period) + 1)
    X0 = np.column_stack([x[rows] for x in fixed]) if fixed else np.empty((len(rows), 0))

    def design(shift: int) -> Array:
        return np.column_stack([*(x[rows + shift] for x in shifted), X0])

    def quick(keep: NDArray[Any]) -> Array:
        return np.array([_share(target[rows][keep], design(s)[keep], positive) for s in shifts.tolist()])

    best = int(shifts[int(np.argmax(quick(np.ones(len(rows), dtype=bool))))])
    keep = _regress(target[rows], design(best), positive)[2]
    shares = quick(keep)
    i = int(np.argmax(shares))
    part = _vertex(shares, i)
    values, r2, _ = _regress(target[rows], design(int(shifts[i])), positive)
    left_over = 1 - shares[[j for j in (i - 2, i, i + 2) if 0 <= j < len(shares)]]
    sharp = float(np.sort(left_over)[1] / max(1 - shares[i], 1e-12))
    return Fit(tuple(values.tolist()), r2, float((shifts[i] + part) * m.period), sharp)


def _share(y: Array, X: Array, positive: bool) -> float:
    centred, z = X - X.mean(axis=0), y - y.mean()
    Z = centred / np.maximum(np.sqrt((centred**2).mean(axis=0)), 1e-300)
    gram, side, power = Z.T @ Z, Z.T @ z, float(z @ z)
    if power <= 0:
        return 0.0
    values = _solved(gram, side, positive)
    return float(2 * values @ side - values @ gram @ values) / power


def _solved(gram: Array, side: Array, positive: bool) -> Array:
    """The coefficients of the normal equations, none below zero if `positive`."""
    if not positive:
        return np.asarray(np.linalg.lstsq(gram, side, rcond=1e-12)[0], dtype=np.float64)
    from scipy.optimize import nnls

    factor = np.linalg.cholesky(gram + 1e-12 * np.trace(gram) * np.eye(len(gram)))
    return nnls(factor.T, np.linalg.solve(factor, side))[0]


def _vertex(shares: Array, i: int) -> float:
    """Where between the neighbours of the largest share a parabola has its top, in rows."""
    if not 0 < i < len(shares) - 1:
        return 0.0
    a, b, c = shares[i - 1 : i + 2].tolist()
    return 0.5 * (a - c) / (a - 2 * b + c) if a - 2 * b + c < 0 else 0.0


def pendulum(m: Motion, wheel: Array, *, gyro_order: int = 0, wheel_order: int = 0) -> Fit:
    """q and p of δ⃛ = −q ψ⃛ + p ψ̇, and how much later than the wheel the gyro is [s].

    `gyro_order=1` takes the gyro's channel for an angle and −1 for an acceleration; `wheel_order=−1` the encoder's
    for a rate.
    """
    fits: list[Fit] = []
    assert m.gyro is not None
    for width in widths(m.period):
        target = smooth(wheel, m.period, width, 3 + wheel_order)
        change = -smooth(m.gyro, m.period, width, 2 + gyro_order)
        level = smooth(m.gyro, m.period, width, gyro_order)
        fits.append(lagged(m, width, target, [change, level], []))
    return max(fits, key=lambda fit: fit.r2)


def motor(m: Motion, command: Array, left: Array, right: Array, gyro: Array | None, gyro_lag: float = 0.0) -> Fit:
    """A, D, C (both wheels), B ≥ 0 of the motor equation, and how much later than the command the wheels answer [s].

    A held command acts half a period after its row; that is not counted as a delay.
    """
    fits: list[Fit] = []
    for width in widths(m.period):
        half = smooth(_late(command, 0.5), m.period, width)
        mean = (left + right) / 2
        rub = sum(_sign(x, m.period, width) for x in (left, right)) / 2
        parts = [smooth(mean, m.period, width, 2), smooth(mean, m.period, width, 1), np.asarray(rub)]
        if gyro is not None:
            aligned = np.interp(m.t + gyro_lag, m.t, gyro)
            parts.append(smooth(aligned, m.period, width, 1))
        fits.append(lagged(m, width, half, parts, [], positive=True, reach=(-0.02, _REACH)))
    return max(fits, key=lambda fit: fit.r2)


def _late(values: Array, share: float) -> Array:
    """`values` half a row later: what a command held over its period does in the mean."""
    return np.concatenate([values[:1], (1 - share) * values[1:] + share * values[:-1]])


def _sign(values: Array, period: float, width: float) -> Array:
    """The direction of motion, smoothed like everything else."""
    rate = smooth(values, period, max(width / 2, period), 1)
    return smooth(np.tanh(rate / 0.5), period, width)


def backward_rate(angle: Array, period: float) -> Array:
    """The last difference quotient: unlike a central one it knows nothing of what follows."""
    return np.diff(angle, prepend=angle[:1]) / period


@dataclass(frozen=True, eq=False)
class Answer:
    """What an unforeseen unit of command does to a channel 0, 1, 2, … rows later, with the t-value of each, and the
    standard deviation of what is unforeseen in the command."""

    gain: Array
    t_value: Array
    surprise: float


def answers(m: Motion, u: Array, channels: dict[str, Array], order: int = 6, reach: int = 14) -> dict[str, Answer]:
    """The response of each of `channels` to the part of the command `u` that the past does not foretell.

    Regressing what follows on the command of row k with all of the past (and of row k) given is free of the bias that
    feedback gives to a plain cross-correlation (Jordà 2005, local projections).
    """
    rows = np.arange(order + 1, len(u) - reach - 1)
    near = np.convolve(~m.good, np.ones(2 * (order + reach)), mode="same") > 0.5
    rows = rows[~near[rows]]
    rows = rows[:: max(1, len(rows) // _MOST_ANSWERS)]
    if len(rows) < _LEAST_ROWS:
        return {}
    past = [x[rows - i] for x in channels.values() for i in range(order)] + [u[rows - i] for i in range(1, order + 1)]
    Q = np.linalg.qr(np.column_stack([*past, np.ones(len(rows))]))[0]

    def rest(x: Array) -> Array:
        return x - Q @ (Q.T @ x)

    surprise = rest(u[rows])
    power = float(surprise @ surprise)
    if power <= 1e-8 * float(u[rows] @ u[rows]) or power == 0:  # rounding is no surprise
        return {}
    return {name: _answer(rest, surprise, power, x, rows, reach) for name, x in channels.items()}


def _answer(rest: Callable[[Array], Array], surprise: Array, power: float, x: Array, rows: Any, reach: int) -> Answer:
    gain, t_value = np.zeros(reach), np.zeros(reach)
    for j in range(reach):
        y = rest(x[rows + j])
        gain[j] = float(surprise @ y) / power
        spread = np.sqrt(float(((y - gain[j] * surprise) ** 2).mean()) / power)
        t_value[j] = gain[j] / spread if spread > 0 else 0.0
    return Answer(gain, t_value, float(np.sqrt(power / len(rows))))
