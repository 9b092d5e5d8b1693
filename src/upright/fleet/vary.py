"""What differs from robot to robot: ranges, normal spreads, and the posterior of a calibration.

A draw depends on the seed and the robot's number alone, so any part of a family can be drawn by itself: on another
worker, in another order, or again after a crash.
"""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.errors import InvalidRobot, InvalidScenario, UnknownName
from upright.robots import PARAMETERS, Kit, Robot

Array = NDArray[np.float64]

BLOCK = 4096
"""Robots whose numbers are drawn together: one counter of Philox (Salmon et al. 2011) for each block and try."""

TRIES = 200
MAY_BE_ZERO = ("rotor_inertia", "back_emf", "motor_friction", "wheel_friction", "coulomb_friction")

_PURPOSE = 0x76617279  # "vary" in ASCII: a stream apart from the kernel's noise under the same seed
_TRIANGLE = 1 + 1e-9  # as in robots.robot


@dataclass(frozen=True)
class Spread:
    """One number, by name: `uniform` between `low` and `high`, or `normal` of mean `low` and deviation `high`."""

    name: str
    kind: str
    low: float
    high: float

    def at(self, share: Array) -> Array:
        """The quantile (n,) for each `share` in (0, 1)."""
        if self.kind == "uniform":
            return self.low + (self.high - self.low) * share
        from scipy.special import ndtri

        return self.low + self.high * ndtri(share)

    def __str__(self) -> str:
        low, high = f"{self.low:.4g}", f"{self.high:.4g}"
        return f"{self.name} {low} … {high}" if self.kind == "uniform" else f"{self.name} {low} ± {high} (normal)"


@dataclass(frozen=True, eq=False)
class Posterior:
    """Several numbers, jointly normal: `mean` (k,) and `covariance` (k, k) in the order of `names`.

    Raises `InvalidRobot` for names that are no parameters, wrong sizes, or a matrix that is no covariance.
    """

    names: tuple[str, ...]
    mean: Array
    covariance: Array
    root: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        mean, covariance = (np.array(v, dtype=np.float64) for v in (self.mean, self.covariance))
        for name in self.names:
            if name not in PARAMETERS:
                raise UnknownName("parameter", name, PARAMETERS)
        k = len(self.names)
        if mean.shape != (k,) or covariance.shape != (k, k):
            raise InvalidRobot(
                f"{k} names, a mean of shape {mean.shape} and a covariance of shape {covariance.shape}",
                expected=f"shapes ({k},) and ({k}, {k})",
            )
        if not (np.isfinite(mean).all() and np.isfinite(covariance).all()):
            raise InvalidRobot("the posterior holds NaN or infinity", expected="finite numbers")
        scale = np.sqrt(np.maximum(np.diag(covariance), 1e-300))
        relative = covariance / np.outer(scale, scale)
        values, vectors = np.linalg.eigh((relative + relative.T) / 2)
        if values[0] < -1e-6 or np.abs(relative - relative.T).max() > 1e-6:
            raise InvalidRobot("the covariance is not one", expected="a symmetric matrix without negative eigenvalues")
        root = scale[:, None] * vectors * np.sqrt(np.maximum(values, 0.0))
        for name, value in (("mean", mean), ("covariance", covariance), ("root", root)):
            value.setflags(write=False)
            object.__setattr__(self, name, value)

    def at(self, share: Array) -> Array:
        """Numbers (n, k) for shares (n, k) in (0, 1)."""
        from scipy.special import ndtri

        return self.mean + ndtri(share) @ self.root.T


@dataclass(frozen=True, eq=False)
class Family:
    """Robots round `robot` under `kit` (None: the bare body), with what varies among them; a name stands once."""

    robot: Robot
    kit: Kit | None = None
    spreads: tuple[Spread, ...] = ()
    posterior: Posterior | None = None

    def __post_init__(self) -> None:
        twice = [name for name in self.names if self.names.count(name) > 1]
        if twice:
            raise InvalidScenario(f"{twice[0]} varies twice", expected="each name once")

    @property
    def names(self) -> tuple[str, ...]:
        """What varies, the posterior's first."""
        return (*(self.posterior.names if self.posterior else ()), *(s.name for s in self.spreads))

    def draw(self, seed: int, index: ArrayLike) -> dict[str, Array]:
        """The varied numbers (n,) of the robots number `index` (n,), by name.

        What no robot can be is drawn again. Raises `InvalidRobot` where nearly nothing can be.
        """
        wanted = np.asarray(index, dtype=np.int64)
        if not self.names:
            return {}
        table = np.empty((len(wanted), len(self.names)))
        blocks = wanted // BLOCK
        for block in np.unique(blocks).tolist():
            mine = blocks == block
            table[mine] = self._block(seed, block)[wanted[mine] % BLOCK]
        return dict(zip(self.names, table.T.copy(), strict=True))

    def _block(self, seed: int, block: int) -> Array:
        values = np.empty((BLOCK, len(self.names)))
        missing = np.ones(BLOCK, dtype=bool)
        for attempt in range(TRIES):
            counter = np.array([0, attempt, block, 0], dtype=np.uint64)
            key = np.array([seed, _PURPOSE], dtype=np.uint64)
            share = np.random.Generator(np.random.Philox(key=key, counter=counter)).random(values.shape)
            fresh = self._values(np.clip(share, 2.0**-54, 1 - 2.0**-53))
            values[missing] = fresh[missing]
            missing[missing] = ~self.possible(fresh[missing])
            if not missing.any():
                return values
        raise InvalidRobot(
            f"of {BLOCK} draws {int(missing.sum())} are no robots after {TRIES} tries each",
            expected="a variation well below the values", hint="vary less",
        )  # fmt: skip

    def _values(self, share: Array) -> Array:
        joint = len(self.posterior.names) if self.posterior else 0
        columns = [s.at(share[:, joint + i]) for i, s in enumerate(self.spreads)]
        first = self.posterior.at(share[:, :joint]) if self.posterior else share[:, :0]
        return np.column_stack([first, *columns]) if columns else first

    def possible(self, values: Array) -> NDArray[np.bool_]:
        """Which rows (n, len(names)) make a robot, by the rules of `Robot` and `Kit`, for all rows at once."""
        column = {name: np.full(len(values), value) for name, value in self.robot.numbers().items()}
        good = np.isfinite(values).all(axis=1)
        for name, numbers in zip(self.names, values.T, strict=True):
            if name in PARAMETERS:
                column[name] = numbers
            else:
                good &= numbers > 0 if name == "battery.voltage" else numbers >= 0
        for name, numbers in column.items():
            good &= numbers >= 0 if name in MAY_BE_ZERO else numbers > 0
        for name in ("wheel_radius", "track", "com_height"):
            good &= column[name] <= 3.0
        inertias = np.stack([column[f"{axis}_inertia"] for axis in ("pitch", "yaw", "roll")])
        return good & (inertias.max(axis=0) * 2 <= inertias.sum(axis=0) * _TRIANGLE)


def spread(text: str, robot: Robot, kit: Kit | None = None) -> tuple[Spread, ...]:
    """What one `--vary` says: `name=±10%`, `name=±0.005`, `name=0.06..0.08`, `name=normal` (the robot file's own
    spread), `name=normal:5%`, `name=normal:0.002`; or `spread`: all parameters, normal with the file's own.

    A name is a robot's parameter or a kit's number such as `delay` or `sensors.gyro.noise`. Raises `InvalidScenario`,
    `UnknownName`.
    """
    if text.strip() == "spread":
        return own_spreads(robot)
    name, equals, said = (part.strip() for part in text.partition("="))
    value = nominal(name, robot, kit)
    said = said.replace("+-", "±").replace("+/-", "±").replace(" ", "")
    if not equals or not said:
        raise InvalidScenario(f"--vary '{text}'", expected="NAME=±10%, NAME=LOW..HIGH or NAME=normal:5%")
    if said == "normal":
        own = {s.name: s for s in own_spreads(robot)}
        if name not in own:
            raise InvalidScenario(f"--vary '{text}', but {name} has no spread", hint=f"{name}=normal:5%")
        return (own[name],)
    if said.startswith("normal:"):
        return (Spread(name, "normal", value, _size(said[7:].lstrip("±"), value, text)),)
    if ".." in said:
        low, high = (_number(part, text) for part in said.split("..", 1))
        if not low < high:
            raise InvalidScenario(f"--vary '{text}'", expected="a low end below the high one")
        return (Spread(name, "uniform", low, high),)
    if not said.startswith("±"):
        raise InvalidScenario(f"--vary '{text}'", expected="±10%, LOW..HIGH or normal:5%", hint=f"{name}=±{said}")
    half = _size(said[1:], value, text)
    return (Spread(name, "uniform", value - half, value + half),)


def own_spreads(robot: Robot, known: Sequence[str] = ()) -> tuple[Spread, ...]:
    """Every parameter that is not `known` normal with the spread of its source, guesses by a fifth (see
    `control.uncertain.spreads`)."""
    from upright.control.uncertain import spreads

    sizes = {
        name: size for name, size in spreads(robot).items() if name not in ("gear_ratio", *known)
    }  # teeth are counted
    return tuple(Spread(name, "normal", getattr(robot, name), size) for name, size in sizes.items())


def nominal(name: str, robot: Robot, kit: Kit | None = None) -> float:
    """The number of that name, of the robot or of the kit; raises `UnknownName`."""
    numbers = robot.numbers() | (kit_numbers(kit) if kit else {})
    if name not in numbers:
        raise UnknownName("number of this robot and kit", name, numbers)
    return numbers[name]


def kit_numbers(kit: Kit) -> dict[str, float]:
    """A kit's numbers by dotted name: `delay`, `jitter`, `motor.limit`, `sensors.gyro.noise`."""
    found = {"delay": kit.delay, "jitter": kit.jitter}
    found |= {f"motor.{name}": value for name, value in vars(kit.motor).items()}
    found |= {f"battery.{name}": value for name, value in vars(kit.battery).items()}
    fixed = ("delay", "period")  # whole numbers of steps, shared by a batch
    for channel, sensor in kit.sensors.items():
        numbers = {name: value for name, value in vars(sensor).items() if name not in fixed}
        found |= {f"sensors.{channel.removeprefix('sensor/')}.{name}": value for name, value in numbers.items()}
    return found


def with_number(name: str, value: float, robot: Robot, kit: Kit | None) -> tuple[Robot, Kit | None]:
    """Robot and kit with one number replaced, checked again; raises `UnknownName`, `InvalidRobot`."""
    nominal(name, robot, kit)
    if name in PARAMETERS:
        return robot.replace(**{name: value}), kit
    assert kit is not None
    owner, _, number = name.rpartition(".")
    if not owner:
        return robot, dataclasses.replace(kit, **{number: value})
    if owner in ("motor", "battery"):
        return robot, dataclasses.replace(kit, **{owner: dataclasses.replace(getattr(kit, owner), **{number: value})})
    channel = f"sensor/{owner.removeprefix('sensors.')}"
    sensor = dataclasses.replace(kit.sensors[channel], **{number: value})
    return robot, dataclasses.replace(kit, sensors=kit.sensors | {channel: sensor})


def read_posterior(path: str | PathLike[str]) -> Posterior:
    """A JSON file of `parameters` (names), `mean` and `covariance`, or what `upright calibrate --save` writes.

    Raises `InvalidRobot`. Of a calibration the robot's parameters are taken, and its dead times left out.
    """
    try:
        data = json.loads(Path(path).read_text(encoding="utf-8"))
        if "mean" in data:
            return Posterior(tuple(data["parameters"]), np.array(data["mean"]), np.array(data["covariance"]))
        names: Sequence[str] = data["names"]
        rows = [row for row, name in enumerate(names) if name in PARAMETERS]
        kept = tuple(names[row] for row in rows)
        covariance = np.array(data["covariance"], dtype=np.float64)[np.ix_(rows, rows)]
        return Posterior(kept, np.array([data["robot"][name] for name in kept]), covariance)
    except OSError as error:
        raise InvalidRobot(f"cannot read {path}: {error.strerror}", expected="a posterior as JSON") from None
    except (ValueError, KeyError, TypeError) as error:
        raise InvalidRobot(
            f"{path} holds no posterior ({type(error).__name__}: {error})",
            expected='{"parameters": [names], "mean": [numbers], "covariance": [[numbers]]}',
        ) from None


def known(robot: Robot, path: str | Path) -> tuple[Robot, dict[str, float], Array]:
    """The robot at the middle of a posterior's file, one standard deviation of each number by name, and the covariance
    (n, n) in that order."""
    found = read_posterior(path)
    deviations = np.sqrt(np.maximum(np.diag(found.covariance), 0.0)).tolist()
    middle = robot.replace(**dict(zip(found.names, found.mean.tolist(), strict=True)))
    return middle, dict(zip(found.names, deviations, strict=True)), found.covariance


def described(family: Family) -> Mapping[str, Any]:
    """What varies, for a record."""
    joint = family.posterior
    listed: dict[str, Any] = {"spreads": [vars(s) for s in family.spreads]}
    if joint:
        listed["posterior"] = {
            "names": joint.names,
            "mean": joint.mean.tolist(),
            "covariance": joint.covariance.tolist(),
        }
    return listed


def _size(text: str, value: float, option: str) -> float:
    share = text.endswith("%")
    size = _number(text.removesuffix("%"), option) * (abs(value) / 100 if share else 1)
    if not (size > 0 and math.isfinite(size)):
        zero = "a share of zero or of infinity" if share else ""
        raise InvalidScenario(f"--vary '{option}' of {value:g}", expected="a size above zero", likely=zero)
    return size


def _number(text: str, option: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InvalidScenario(f"--vary '{option}'", expected=f"a finite number where it says '{text}'")
    return value
