"""How far a loop is from instability: gain, phase, delay and disk margins, and the sensitivity peaks.

A margin is of one channel with all others closed: l = 1/[(I + L)⁻¹]ᵢᵢ − 1 (Maciejowski 1989, section 3.12). Disk
margins follow Seiler, Packard and Gahinet (2020), "An introduction to disk margins".
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import KW_ONLY, asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Complex
from upright.atomic import finite
from upright.control.state_space import continuous
from upright.errors import InvalidModel
from upright.physics.linear import LinearModel, decays

ScalarLoop = Callable[[Array], Complex]

GRID = 3000
"""Frequencies looked at; crossovers between them are found to rounding, resonances narrower than the grid are not."""

AT_ONCE = 256  # frequencies for which the matrices of a response are in memory together
FEW = 8  # frequencies for which a solution for each is quicker than one for all, of 18 to 56 states
_UNBOUNDED = 1e6  # a response as large as this at a crossing is that of a pole, one as small is nothing but rounding
_NEARLY_REAL = 1e-3  # a zero this near the real axis, relative to its size, may be a double one that rounding has split

SLOWEST = 1e-3  # [rad/s] two hours: nothing of a robot's loop is slower
LEVEL = 1e-3  # [1] change of a response from there to half of it: with a pole at zero it doubles


@dataclass(frozen=True)
class Margins:
    """The margins of one loop, broken at `channel`.

    The loop stays stable for one of these changes: a gain factor in (`gain_low`, `gain_high`) [1], a phase change below
    `phase` [rad], a delay below `delay` [s]. `disk` α is the balanced disk margin, for gain and phase changed together:
    gains in ((2 − α)/(2 + α), (2 + α)/(2 − α)), phases below 2 atan(α/2). `Ms` and `Mt` are the peaks of |1/(1 + l)|
    and |l/(1 + l)|. `crossover` [rad/s] is the highest frequency with |l| = 1. Each `…_at` is the frequency [rad/s]
    that sets a margin, NaN where none does; `leads` tells that the phase margin is one of phase lead.
    """

    channel: str
    _: KW_ONLY
    gain_low: float
    gain_high: float
    phase: float
    delay: float
    disk: float
    Ms: float
    Mt: float
    crossover: float
    gain_low_at: float = math.nan
    gain_high_at: float = math.nan
    phase_at: float = math.nan
    delay_at: float = math.nan
    leads: bool = False

    def words(self) -> str:
        """One sentence for a reader without the mathematics."""
        if not self.delay > 0:
            return f"{self.channel}: unstable, so there is no margin."
        low = f"as weak as {self.gain_low * 100:.0f} %" if self.gain_low > 0 else "however weak"
        high = f"as strong as {self.gain_high * 100:.0f} %" if self.gain_high < 1e3 else "however strong"
        delay = f"{self.delay * 1e3:.0f} ms more delay" if math.isfinite(self.delay) else "any delay"
        return f"{self.channel}: survives {delay}, and {low} or {high} of its gain."

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; None for what is unlimited."""
        return {key: finite(value) for key, value in asdict(self).items()}


def disk_gain(alpha: float) -> tuple[float, float]:
    """The interval of gains of a balanced disk of size `alpha`."""
    high = math.inf if alpha >= 2 else (2 + alpha) / (2 - alpha)
    return (0.0 if alpha >= 2 else 1 / high), high


def disk_phase(alpha: float) -> float:
    """The phase [rad] of a balanced disk of size `alpha`."""
    return 2 * math.atan(alpha / 2)


def frequencies(dt: float, fastest: float = 1e4, count: int = GRID) -> Array:
    """A grid [rad/s]: logarithmic from `SLOWEST` up to the Nyquist frequency, which is in it, or `fastest`."""
    top = math.pi / dt if dt else fastest
    grid = np.geomspace(min(SLOWEST, top / 1e6), top, count)
    return np.union1d(grid, np.linspace(top / 300, top, 300)) if dt else grid


def margins(
    loop: LinearModel, direction: ArrayLike = (1.0,), channel: str = "the loop", *, peaks: bool = True
) -> Margins:
    """Margins of the square loop gain `loop` (1 + L = 0), broken along `direction` (m,) with all else closed.

    Zero margins where the closed loop is unstable. Without `peaks` neither Ms, Mt nor the disk is computed (NaN), which
    takes half as long.
    """
    v = np.asarray(direction, dtype=np.float64)
    if loop.D.shape != (len(v), len(v)):
        raise InvalidModel(f"a direction of {len(v)} in a loop of shape {loop.D.shape}", expected="as many as channels")
    if not closed_stable(loop):
        return Margins(
            channel, gain_low=1.0, gain_high=1.0, phase=0.0, delay=0.0, disk=0.0, Ms=math.inf, Mt=math.inf,
            crossover=math.nan,
        )  # fmt: skip
    return _scalar_margins(broken_at(loop, v / np.linalg.norm(v)), channel, peaks=peaks)


def broken_at(loop: LinearModel, v: Array) -> LinearModel:
    """The scalar loop gain l, 1 + l = 0, where `loop` is broken along the unit vector v (m,) and all else is closed."""
    others = np.eye(len(v)) - np.outer(v, v)
    W = np.linalg.inv(np.eye(len(v)) + others @ loop.D)  # u = W (v e − (I − v vᵀ) C x)
    back = W @ others @ loop.C
    enters = (W @ v)[:, None]
    C = v[None] @ (loop.C - loop.D @ back)
    D = v[None] @ loop.D @ enters
    return LinearModel(loop.A - loop.B @ back, loop.B @ enters, C, D, loop.dt)


def closed_stable(loop: LinearModel) -> bool:
    """Whether the loop gain under unit negative feedback gives a stable closed loop."""
    through = np.eye(len(loop.D)) + loop.D
    if np.linalg.cond(through) > 1e12:
        raise InvalidModel("the loop passes −1 at once", expected="a loop that can be closed", hint="add its delay")
    closed = loop.A - loop.B @ np.linalg.solve(through, loop.C)
    return decays(closed, continuous=loop.continuous, B=loop.B, C=loop.C)


class ScalarResponse:
    """C (λI − A)⁻¹ B + D of a (1, 1) system, in n² steps for each frequency, by its Hessenberg form (Laub 1981)."""

    def __init__(self, system: LinearModel) -> None:
        from scipy.linalg import hessenberg

        self._system = system
        reduced: Any = hessenberg(system.A, calc_q=True) if len(system.A) else (system.A, system.A)
        Q: Array = reduced[1]
        self._H: Array = reduced[0]
        self._b = Q.T @ system.B[:, 0]
        self._c = system.C[0] @ Q
        self._d = float(system.D[0, 0])

    def __call__(self, omega: Array) -> Complex:
        """The response (len(omega),) at `omega` [rad/s]."""
        if len(omega) < FEW:
            matrices = self._system.points(omega)[:, None, None] * np.eye(len(self._b)) - self._H
            return np.linalg.solve(matrices, self._b[:, None])[..., 0] @ self._c + self._d
        parts = np.array_split(omega, max(1, len(omega) // AT_ONCE))
        return np.concatenate([self._solved(self._system.points(part)) for part in parts])

    def _solved(self, points: Complex) -> Complex:
        n = len(self._b)
        both = np.column_stack([-self._H, self._b]).astype(np.complex128)  # beside the matrix its right side
        rows = np.repeat(both[:, :, None], len(points), axis=2)  # (row, column, point): points lie side by side
        for k in range(n):
            rows[k, k] += points
        for k in range(n - 1):  # below the diagonal there is one number; the larger of both is the pivot
            upper = rows[k, k:]
            lower = rows[k + 1, k:]
            swap = np.abs(lower[0]) > np.abs(upper[0])
            if swap.any():
                upper[:], lower[:] = np.where(swap, lower, upper), np.where(swap, upper, lower)
            lower[1:] -= lower[0] / upper[0] * upper[1:]
        x = np.empty((n, len(points)), np.complex128)
        for k in reversed(range(n)):
            x[k] = (rows[k, n] - np.einsum("jp,jp->p", rows[k, k + 1 : n], x[k + 1 :])) / rows[k, k]
        return self._c @ x + self._d


def _scalar_margins(system: LinearModel, channel: str, *, peaks: bool) -> Margins:
    """Margins of a loop gain (1, 1) whose closed loop is stable."""
    scalar = ScalarResponse(system)
    grid = frequencies(system.dt)
    loop = scalar(grid)
    (low, low_at), (high, high_at) = _gain_interval(system, scalar, grid, loop)
    crossings = sign_changes(lambda w: np.abs(scalar(w)) - 1, grid, np.abs(loop) - 1)
    lag = np.mod(np.angle(scalar(crossings)) + math.pi, 2 * math.pi) if len(crossings) else np.empty(0)
    turn = np.minimum(lag, 2 * math.pi - lag)
    wait = lag / crossings
    first, soonest = (int(np.argmin(values)) if len(values) else None for values in (turn, wait))
    result = Margins(
        channel, gain_low=low, gain_high=high, gain_low_at=low_at, gain_high_at=high_at,
        phase=math.inf if first is None else float(turn[first]), disk=math.nan, Ms=math.nan, Mt=math.nan,
        delay=math.inf if soonest is None else float(wait[soonest]),
        crossover=float(crossings.max()) if len(crossings) else math.nan,
        phase_at=math.nan if first is None else float(crossings[first]),
        delay_at=math.nan if soonest is None else float(crossings[soonest]),
        leads=first is not None and bool(lag[first] > math.pi),
    )  # fmt: skip
    if not peaks:
        return result

    def largest(size: Callable[[Complex], Array]) -> float:
        """The peak of a `size` of the sensitivity 1/(1 + l)."""
        return peak(lambda w: size(1 / (1 + scalar(w))), grid, size(1 / (1 + loop)))

    disk = 1 / largest(lambda S: np.abs(S - 0.5))
    Ms = largest(np.abs)
    Mt = largest(lambda S: np.abs(1 - S))
    return replace(result, disk=disk, Ms=Ms, Mt=Mt)


def _gain_interval(system: LinearModel, scalar: ScalarLoop, grid: Array, loop: Complex) -> list[tuple[float, float]]:
    """The factors of gain next to one at which a pole of the closed loop lies on the border of stability, each with its
    frequency [rad/s]: first the one below one, zero where there is none, then the one above, or infinity.

    There l is real and −1/factor: at frequency zero, at the highest one, and where Im l changes its sign. Between two
    points of the grid, at which l is `loop`, it may do so twice, so that its own zeros split the grid.
    """
    between = _between(real_frequencies(system))
    split = np.append(grid, between)
    order = np.argsort(split)
    crossings = sign_changes(lambda w: scalar(w).imag, split[order], np.append(loop, scalar(between)).imag[order])
    ends = [_at_zero(system), system.D[0, 0] if system.continuous else scalar(grid[-1:])[0].real]
    real = np.append(scalar(crossings).real, ends)
    at = np.append(crossings, [0.0, grid[-1]])
    kept = (real < -1 / _UNBOUNDED) & (real > -_UNBOUNDED)
    factors = np.append(-1 / real[kept], [0.0, math.inf])
    at = np.append(at[kept], [math.nan, math.nan])
    low = int(np.argmax(np.where(factors < 1, factors, -1.0)))
    high = int(np.argmin(np.where(factors > 1, factors, math.inf)))
    high = high if factors[high] > 1 else len(factors) - 1
    return [(float(factors[k]), float(at[k])) for k in (low, high)]


def real_frequencies(system: LinearModel) -> Array:
    """Frequencies [rad/s] above zero at which the response of a (1, 1) system is real, to rounding.

    In continuous time l(s) − l(−s) = 2 s c (s² − A²)⁻¹ b. So s² = −ω² is a zero of (A², b, c, 0). A discrete system is
    mapped first.
    """
    from scipy.linalg import eigvals

    mapped = continuous(system)
    n = len(system.A)
    pencil = np.block([[mapped.A @ mapped.A, mapped.B], [mapped.C, np.zeros((1, 1))]])
    zeros = np.asarray(eigvals(pencil, np.diag([1.0] * n + [0.0])), dtype=np.complex128)
    zeros = zeros[np.isfinite(zeros)]
    omega = np.sqrt(-zeros.real[(zeros.real < 0) & (np.abs(zeros.imag) < _NEARLY_REAL * np.abs(zeros))])
    return np.sort(omega if system.continuous else 2 / system.dt * np.arctan(omega))


def _between(points: Array) -> Array:
    """Points that separate the given positive ones from each other, and from zero."""
    return np.concatenate([points[:1] / 2, np.sqrt(points[1:] * points[:-1]), points[-1:] * 1.01])


def _at_zero(system: LinearModel) -> float:
    """The real response at frequency zero, infinite where a pole lies there that the response shows."""
    near, nearer = system.response([SLOWEST, SLOWEST / 2])[0, 0].tolist()
    level = abs(near - nearer) < LEVEL * abs(nearer)
    try:
        exact = float(system.response(0.0)[0, 0, 0].real)
    except np.linalg.LinAlgError:
        exact = math.inf
    return nearer.real if level and not math.isclose(exact, nearer.real, rel_tol=LEVEL) else exact


def sign_changes(f: Callable[[Array], Array], grid: Array, values: Array) -> Array:
    """Where f changes its sign between two points of the grid, at which it has these `values`."""
    from scipy.optimize import brentq

    changes = np.flatnonzero(np.signbit(values[1:]) != np.signbit(values[:-1]))

    def at(w: float) -> float:
        return float(f(np.array([w]))[0])

    def root(a: float, b: float) -> float:
        try:
            place: Any = brentq(at, a, b, xtol=1e-12)
            return float(place)
        except ValueError:  # zero to rounding at one end, where one frequency alone and many give either sign
            return min(a, b, key=lambda w: abs(at(w)))

    return np.array([root(grid[i], grid[i + 1]) for i in changes], dtype=np.float64)


def peak(f: Callable[[Array], Array], grid: Array, values: Array | None = None) -> float:
    """The largest value, refined between the neighbours of the grid's largest; `values` are f(grid), if known."""
    values = f(grid) if values is None else values
    i = int(np.argmax(values))
    best = float(values[i])
    a = grid[max(i - 1, 0)]
    b = grid[min(i + 1, len(grid) - 1)]
    for _ in range(3):
        finer = np.linspace(a, b, 41)
        values = f(finer)
        i = int(np.argmax(values))
        best = max(best, float(values.max()))
        a = finer[max(i - 1, 0)]
        b = finer[min(i + 1, 40)]
    return best


def disk_margin(loop: LinearModel) -> float:
    """α of all channels varying at once and independently: 1/max μ(S − I/2) (SLICOT AB13MD).

    The bound is exact for up to three channels. Zero where the closed loop is unstable.
    """
    if not closed_stable(loop):
        return 0.0
    from slycot import ab13md

    m = len(loop.D)
    grid = frequencies(loop.dt)

    def mu(w: Array) -> Array:
        matrices = np.linalg.inv(np.eye(m) + loop.matrices(w)) - np.eye(m) / 2
        return np.array([ab13md(matrix, [1] * m, [2] * m)[0] for matrix in matrices])

    coarse = grid[:: max(1, len(grid) // 600)]
    return 1 / peak(mu, coarse)
