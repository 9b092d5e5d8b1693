"""The uncertainty of a robot's parameters: one meaning of spread and guess, one draw, one reader of posteriors.

- A *spread* is one standard deviation of a normal distribution, in the number's own unit.
- A *guess* is a number that nobody measured. It is right within a factor of two: log-normal about the value, with ln 2
  as standard deviation of the logarithm. A narrower meaning would be wrong. The guessed rotor inertia of the NXT's
  motor was wrong by two orders of magnitude, box formulas for a body's inertia by a half.
- A friction or an inertia with a guess of zero stays zero. Friction that no source names makes a robot easier to
  balance, and a certificate must not count on it. A calibration does leave room for it (`calibrate.parameters`).
- A gear ratio that is a guess stays, since teeth can be counted. Numbers for drawing and smoothing stay too.

Distributions are not cut. Where the numbers make no robot (`robot.possible`), all of them are drawn again. The roll
inertia is an exception: it is moved to the nearest value of a rigid body with the other two inertias. It matters least,
and drawing again would narrow all three.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from types import SimpleNamespace
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Mask, read_only
from upright.errors import InvalidRobot, InvalidScenario, UnknownName, check_within
from upright.reading import read_json, understood
from upright.robots.kit import Kit
from upright.robots.robot import PARAMETERS, Robot, possible, refuse_misfit

GUESS = math.log(2.0)
"""Standard deviation of the logarithm of a number that is a guess: right within a factor of two."""

GRAVITY = 0.02
"""[m/s²] Spread of gravity from the equator to the poles."""

COUNTED = ("gear_ratio",)
CHOSEN = ("body_depth", "body_height", "stiction_rate")
"""For pictures, or a choice of the model: they differ between no two robots."""

BLOCK = 4096
"""Robots whose numbers are drawn together: one counter of Philox (Salmon et al. 2011) for each block and try."""

TRIES = 1000
MOST_DRAWN = 100_000
"""Robots that are drawn as objects, each of 2 kB and designed for one by one; a fleet takes more as plain numbers."""

_PURPOSE = 0x76617279  # "vary" in ASCII: a stream apart from the kernel's noise under the same seed
_ROLL = "roll_inertia"
_BODY = ("pitch_inertia", "yaw_inertia", _ROLL)


@dataclass(frozen=True)
class Spread:
    """The distribution of one number.

    `uniform` from `low` to `high`; `normal` with mean `low` and standard deviation `high`; `lognormal` with median
    `low` and `high` as the standard deviation of the logarithm.
    """

    name: str
    kind: Literal["uniform", "normal", "lognormal"]
    low: float
    high: float

    def at(self, z: Array) -> Array:
        """The quantile (n,) at Φ(z), for standard normal `z` (n,)."""
        if self.kind == "normal":
            return self.low + self.high * z
        if self.kind == "lognormal":
            return self.low * np.exp(self.high * z)
        from scipy.special import ndtr

        return self.low + (self.high - self.low) * ndtr(z)

    def scaled(self, factor: float) -> Spread:
        """As wide as `factor` times this one, about the same median."""
        if self.kind == "uniform":
            half = factor * (self.high - self.low) / 2
            return replace(self, low=self.middle - half, high=self.middle + half)
        return replace(self, high=factor * self.high)

    @property
    def middle(self) -> float:
        """The median."""
        return (self.low + self.high) / 2 if self.kind == "uniform" else self.low

    def __str__(self) -> str:
        low, high = f"{self.low:.4g}", f"{self.high:.4g}"
        words = {"uniform": f"{low} … {high}", "normal": f"{low} ± {high} (normal)"}
        return f"{self.name} {words.get(self.kind, f'{low} ×÷ {math.exp(self.high):.4g} (log-normal)')}"


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """Distributions of k numbers, and the `correlation` (k, k) of their normal quantiles (None: independent).

    For normal distributions that is the correlation of the numbers themselves. `a + b` are both, independent of each
    other. Raises `InvalidScenario` for a name that stands twice, `InvalidRobot` for a matrix that is no correlation.
    """

    spreads: tuple[Spread, ...] = ()
    correlation: Array | None = None
    root: Array | None = field(init=False, repr=False, default=None)

    def __post_init__(self) -> None:
        twice = [name for name in self.names if self.names.count(name) > 1]
        if twice:
            raise InvalidScenario(f"{twice[0]} varies twice", expected="each name once")
        if self.correlation is not None:
            object.__setattr__(self, "correlation", read_only(self.correlation))
            object.__setattr__(self, "root", read_only(_root(self.correlation, len(self.spreads))))

    @classmethod
    def of(cls, robot: Robot, known: Sequence[str] = ()) -> Uncertainty:
        """The uncertainty in the robot's file: each parameter with its spread or as a guess, correlated as in the file.

        Parameters that are `known` are left out.
        """
        kept = {name: size for name, size in deviations(robot).items() if name not in known}
        spreads = tuple(_spread(robot, name, size) for name, size in kept.items())
        place = {name: i for i, name in enumerate(kept)}
        correlation = np.eye(len(kept))
        for (first, second), value in robot.correlation.items():
            if first in place and second in place:
                correlation[place[first], place[second]] = correlation[place[second], place[first]] = value
        return cls(spreads, correlation if robot.correlation else None)

    @classmethod
    def normal(cls, robot: Robot, sizes: Mapping[str, float]) -> Uncertainty:
        """Normal about the numbers of `robot`, independent, with the standard deviations `sizes` by name."""
        for name in sizes:
            if name not in PARAMETERS:
                raise UnknownName("parameter", name, PARAMETERS)
        return cls(tuple(Spread(name, "normal", getattr(robot, name), size) for name, size in sizes.items()))

    @classmethod
    def joint(cls, names: Sequence[str], mean: ArrayLike, covariance: ArrayLike) -> Uncertainty:
        """Jointly normal: `mean` (k,) and `covariance` (k, k), in the order of `names`.

        Raises `UnknownName` for what is no parameter, `InvalidRobot` for wrong sizes or a matrix that is no covariance.
        """
        centre, matrix = (np.array(v, dtype=np.float64) for v in (mean, covariance))
        for name in names:
            if name not in PARAMETERS:
                raise UnknownName("parameter", name, PARAMETERS)
        k = len(names)
        if centre.shape != (k,) or matrix.shape != (k, k):
            raise InvalidRobot(
                f"{k} names, a mean of shape {centre.shape} and a covariance of shape {matrix.shape}",
                expected=f"shapes ({k},) and ({k}, {k})",
            )
        if not (np.isfinite(centre).all() and np.isfinite(matrix).all()):
            raise InvalidRobot("the posterior holds NaN or infinity", expected="finite numbers")
        if (np.diag(matrix) < 0).any():
            raise InvalidRobot("the covariance has a negative variance", expected="a covariance matrix")
        sizes = np.sqrt(np.diag(matrix))
        scale = np.where(sizes > 0, sizes, 1.0)
        correlation = matrix / np.outer(scale, scale)
        np.fill_diagonal(correlation, 1.0)
        rows = zip(names, centre.tolist(), sizes.tolist(), strict=True)
        return cls(tuple(Spread(name, "normal", value, size) for name, value, size in rows), correlation)

    def __add__(self, other: Uncertainty) -> Uncertainty:
        both = (self, other)
        if all(u.correlation is None for u in both):
            return Uncertainty(self.spreads + other.spreads)
        first, second = (np.eye(len(u.spreads)) if u.correlation is None else u.correlation for u in both)
        corner = np.zeros((len(first), len(second)))
        return Uncertainty(self.spreads + other.spreads, np.block([[first, corner], [corner.T, second]]))

    @property
    def names(self) -> tuple[str, ...]:
        """What is uncertain, in the order of `spreads`."""
        return tuple(s.name for s in self.spreads)

    def scaled(self, factor: float) -> Uncertainty:
        """Every distribution `factor` times as wide, with the same correlation."""
        return Uncertainty(tuple(s.scaled(factor) for s in self.spreads), self.correlation)

    def middle(self, robot: Robot) -> Robot:
        """`robot` with the medians in place of its own numbers."""
        numbers = {s.name: s.middle for s in self.spreads if s.name in PARAMETERS}
        return robot.replace(**{name: float(value) for name, value in _rigid(robot, numbers).items()})

    def at(self, fraction: Array) -> Array:
        """Numbers (n, k) for `fraction` (n, k), independent and uniform in (0, 1)."""
        from scipy.special import ndtri

        z = ndtri(fraction)
        z = z if self.root is None else z @ self.root.T
        columns = [s.at(column) for s, column in zip(self.spreads, z.T, strict=True)]
        return np.column_stack(columns) if columns else fraction

    def to_json(self) -> dict[str, Any]:
        """Plain numbers, for a record."""
        correlation = {} if self.correlation is None else {"correlation": self.correlation.tolist()}
        return {"spreads": [vars(s) for s in self.spreads], **correlation}


@dataclass(frozen=True, eq=False)
class Family:
    """Robots round `robot` under `kit` (None: the bare body), as far as the `uncertainty` goes.

    Robot number 17 follows from the seed and the number 17 alone. So any part of a family can be drawn by itself: on
    another worker, in another order, or again after a crash.
    """

    robot: Robot
    kit: Kit | None = None
    uncertainty: Uncertainty = field(default_factory=Uncertainty)

    @property
    def names(self) -> tuple[str, ...]:
        """The parameters that differ between robots: the uncertain ones, perhaps with the roll inertia."""
        return tuple(_rigid(self.robot, dict.fromkeys(self.uncertainty.names, 1.0)))

    def draw(self, seed: int, index: ArrayLike) -> dict[str, Array]:
        """The numbers (n,) of the robots number `index` (n,), by name.

        What no robot can be is drawn again. Raises `InvalidRobot` where nearly nothing can be.
        """
        check_within("as a seed", seed, 0, 2**64 - 1)
        numbers = np.asarray(index, dtype=np.int64)
        if not self.names:
            return {}
        table = np.empty((len(numbers), len(self.names)))
        blocks = numbers // BLOCK
        for block in np.unique(blocks).tolist():
            mine = blocks == block
            table[mine] = self._block(seed, block)[numbers[mine] % BLOCK]
        return dict(zip(self.names, table.T.copy(), strict=True))

    def robots(self, count: int, seed: int = 0) -> list[Robot]:
        """The robots number 0 to `count` − 1; numbers of the kit are left out."""
        check_within("robots drawn", count, 0, MOST_DRAWN)
        drawn = {name: values for name, values in self.draw(seed, range(count)).items() if name in PARAMETERS}
        if not drawn:
            return [self.robot] * count
        rows = zip(*(values.tolist() for values in drawn.values()), strict=True)
        return [self.robot.replace(**dict(zip(drawn, row, strict=True))) for row in rows]

    def possible(self, values: Array) -> Mask:
        """Which rows (n, len(names)) make a robot and a kit, by the rules of `Robot` and `Kit`."""
        column: dict[str, Any] = {name: np.full(len(values), v) for name, v in self.robot.numbers().items()}
        good = np.isfinite(values).all(axis=1)
        for name, numbers in zip(self.names, values.T, strict=True):
            if name in PARAMETERS:
                column[name] = numbers
            else:
                good &= numbers > 0 if name == "battery.voltage" else numbers >= 0
        return good & possible(SimpleNamespace(**column, drive=self.robot.drive))

    def _block(self, seed: int, block: int) -> Array:
        values = np.empty((BLOCK, len(self.names)))
        missing = np.ones(BLOCK, dtype=bool)
        for attempt in range(TRIES):
            counter = np.array([0, attempt, block, 0], dtype=np.uint64)
            key = np.array([seed, _PURPOSE], dtype=np.uint64)
            generator = np.random.Generator(np.random.Philox(key=key, counter=counter))
            fraction = generator.random((BLOCK, len(self.uncertainty.names)))
            fresh = self._rows(np.clip(fraction[missing], 2.0**-54, 1 - 2.0**-53))
            values[missing] = fresh
            missing[missing] = ~self.possible(fresh)
            if not missing.any():
                return values
        raise InvalidRobot(
            f"{int(missing.sum())} of {BLOCK} robots are impossible, also after {TRIES} draws",
            expected="spreads well below the values", hint="vary less",
        )  # fmt: skip

    def _rows(self, fraction: Array) -> Array:
        column = dict(zip(self.uncertainty.names, self.uncertainty.at(fraction).T, strict=True))
        return np.column_stack(list(_rigid(self.robot, column).values()))


def draw(robot: Robot, count: int, seed: int = 0, uncertainty: Uncertainty | None = None) -> list[Robot]:
    """`count` robots drawn from the `uncertainty` (None: that of the robot's file).

    They are the robots number 0 to `count` − 1 of a fleet with the same seed. Raises `InvalidRobot` where nearly no
    draw is a possible robot.
    """
    return Family(robot, None, Uncertainty.of(robot) if uncertainty is None else uncertainty).robots(count, seed)


def deviations(robot: Robot) -> dict[str, float]:
    """One standard deviation of each uncertain parameter, in its own unit. Of a guess: `GUESS` times the value, which
    is that of the log-normal distribution to first order."""
    sizes: dict[str, float] = {}
    for name in (name for name in PARAMETERS if name in robot.provenance and name not in CHOSEN):
        guess = 0.0 if name in COUNTED else GUESS * getattr(robot, name)
        spread = stated(robot, name)
        sizes[name] = guess if spread is None else spread
    return {name: size for name, size in sizes.items() if size > 0}


def stated(robot: Robot, name: str) -> float | None:
    """The spread that the source of a parameter states; None where the number is a guess, or has no source. Gravity
    without a source is the usual one."""
    source = robot.provenance.get(name)
    return source.spread if source else GRAVITY if name == "gravity" else None


def at_medians(robot: Robot, posterior: Uncertainty | str | PathLike[str] | None) -> tuple[Robot, Uncertainty | None]:
    """`robot` at the medians of a posterior, whose sources stay on record, and that posterior; alone without one."""
    unknown = posterior if posterior is None or isinstance(posterior, Uncertainty) else read_posterior(posterior)
    return (unknown.middle(robot).replace(provenance=robot.provenance), unknown) if unknown else (robot, None)


def read_posterior(path: str | PathLike[str]) -> Uncertainty:
    """A JSON file of `parameters` (names), `mean` and `covariance`, or what `upright calibrate --save` writes.

    Of a calibration the robot's parameters are taken, and its dead times left out. Raises `InvalidRobot`.
    """
    expected = '{"parameters": [names], "mean": [numbers], "covariance": [[numbers]]}'
    data = read_json(Path(path), InvalidRobot, expected)
    with understood(f"the posterior {path}", InvalidRobot, expected):
        refuse_misfit(data, Path(path))
        if "mean" in data:
            return Uncertainty.joint(data["parameters"], data["mean"], data["covariance"])
        names: Sequence[str] = data["names"]
        rows = [row for row, name in enumerate(names) if name in PARAMETERS]
        kept = [names[row] for row in rows]
        covariance = np.array(data["covariance"], dtype=np.float64)[np.ix_(rows, rows)]
        return Uncertainty.joint(kept, [data["robot"][name] for name in kept], covariance)


def roll_bounds(pitch: Any, yaw: Any) -> tuple[Any, Any]:
    """The least and the largest roll inertia of a rigid body with these two other inertias [kg m²]."""
    return np.abs(pitch - yaw), pitch + yaw


def _spread(robot: Robot, name: str, size: float) -> Spread:
    value = getattr(robot, name)
    guess = stated(robot, name) is None
    return Spread(name, "lognormal", value, GUESS) if guess else Spread(name, "normal", value, size)


def _rigid(robot: Robot, numbers: Mapping[str, Any]) -> dict[str, Any]:
    """The `numbers` by name, with the nearest roll inertia that a rigid body of the others has, where one is drawn."""
    if not any(name in _BODY for name in numbers):
        return dict(numbers)
    pitch, yaw, roll = (numbers.get(name, getattr(robot, name)) for name in _BODY)
    low, high = roll_bounds(pitch, yaw)
    return {**numbers, _ROLL: np.clip(roll, low, high)}


def _root(correlation: ArrayLike, size: int) -> Array:
    """S (k, k) with S Sᵀ = `correlation`."""
    matrix = np.asarray(correlation, dtype=np.float64)
    if matrix.shape != (size, size):
        raise InvalidRobot(f"a correlation of shape {matrix.shape}", expected=f"shape ({size}, {size})")
    values, vectors = np.linalg.eigh((matrix + matrix.T) / 2)
    if values[0] < -1e-6 or np.abs(matrix - matrix.T).max() > 1e-6:
        raise InvalidRobot("the covariance is not one", expected="a symmetric matrix without negative eigenvalues")
    return vectors * np.sqrt(np.maximum(values, 0.0))
