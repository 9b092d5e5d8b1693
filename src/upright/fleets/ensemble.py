"""A fleet: a family of robots, their controller, pushes and references. `run` simulates any part of it."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from upright.arrays import Array
from upright.bodies.body import REST
from upright.compiled.generated import LANES
from upright.control import Controller, controller_hash
from upright.errors import InvalidScenario, check_within
from upright.experiment.pushes import Hold, Impulse, Push, Slope
from upright.experiment.references import Drive, Turn
from upright.experiment.run import MAX_SECONDS
from upright.kernel.batch import FleetBatch, FleetResult, law_of, parameters_of
from upright.pages import Say
from upright.robots import PARAMETERS
from upright.robots.uncertainty import Family, Uncertainty

Index = NDArray[Any] | range

SETTLED = 0.02
"""|pitch| [rad] inside which a robot counts as settled: about a degree, more than quantised sensors make it sway."""

_TRIED = 0.5  # [s] of some robots, which tells how fast they are simulated

OUTCOMES: dict[str, tuple[str, Say]] = {
    "fell": ("1", Say("falls")),
    "lived": ("s", Say("time until the fall")),
    "peak_pitch": ("rad", Say("largest pitch")),
    "settling": ("s", Say("settling time")),
    "rms_pitch": ("rad", Say("RMS pitch")),
    "effort": ("V² s", Say("effort")),
    "saturated": ("1", Say("saturated fraction")),
    "travel": ("m", Say("furthest from the start")),
}
"""Results of each robot: unit and name. Torque drives have an effort in N² m² s."""


class Programme(NamedTuple):
    """Pushes (·, p, 4), slope (·, 2) and reference (·, q, 4), as `FleetBatch` takes them."""

    pushes: Array
    slope: Array
    reference: Array


@dataclass(frozen=True, eq=False, kw_only=True)
class Ensemble:
    """Robots of a `family` under one `controller`, pushed and driven for `seconds`, from the state `start` (6,).

    `band` [rad] of pitch counts as settled. Everything random follows from `seed` and the robot's number.
    """

    family: Family
    controller: Controller
    pushes: tuple[Any, ...] = ()
    references: tuple[Any, ...] = ()
    start: tuple[float, ...] = REST
    seconds: float = 10.0
    seed: int = 0
    model: str = "complete"
    band: float = SETTLED

    def __post_init__(self) -> None:
        if not 0 <= self.seed < 2**64:
            raise InvalidScenario(f"a seed of {self.seed}", expected="a whole number from 0 to 2⁶⁴ − 1")
        check_within("seconds in a run of a fleet", self.seconds, 0, MAX_SECONDS)
        if not self.band > 0:
            raise InvalidScenario(f"a band of {self.band:g} rad", expected="more than zero")

    def nominal(self) -> Ensemble:
        """The same with nothing varied."""
        return replace(self, family=replace(self.family, uncertainty=Uncertainty()))

    @property
    def called(self) -> bool:
        """Whether its controller is called in Python, robot by robot, since no law describes it."""
        return law_of(self.controller)[1] is not None

    def at_once(self, usual: int) -> int:
        """Robots that are simulated between two reports of progress: the `usual` number, or about a second's work."""
        from upright.kernel.simulate import CALLED

        return CALLED if self.called else usual

    def pace(self) -> float:
        """Seconds that this machine takes for one second of a robot whose controller is called."""
        from upright.kernel.simulate import simulate

        batch = replace(self.nominal(), start=REST).batch(range(LANES))
        simulate(batch, _TRIED)  # which compiles
        begin = time.perf_counter()
        lived = float(simulate(batch, _TRIED).lived.sum())
        return (time.perf_counter() - begin) / lived

    def batch(self, index: Index) -> FleetBatch:
        """The robots number `index` (n,)."""
        numbers = np.asarray(index, dtype=np.uint64)
        parameters, changes = self._numbers(numbers)
        programme = tables(self.pushes, self.references, parameters)
        return FleetBatch(
            parameters=parameters, controller=self.controller, start=np.array([self.start]), pushes=programme.pushes,
            slope=programme.slope, reference=programme.reference, kit=self.family.kit, kit_changes=changes,
            model=self.model, seed=self.seed, index=numbers,
        )  # fmt: skip

    def run(self, index: Index, threads: int | None = None) -> dict[str, Array]:
        """The varied numbers and `OUTCOMES` of the robots number `index` (n,), by name."""
        from upright.kernel.simulate import simulate

        batch = self.batch(index)
        bands = (self.band, math.inf, math.inf)
        result = simulate(batch, self.seconds, bands=bands, threads=threads)
        drawn = self.family.draw(self.seed, np.asarray(index))
        return drawn | self._outcomes(result, batch)

    def origin(self) -> dict[str, Any]:
        """All that determines the outcomes, as JSON: robot, kit, controller and its hash, scenario, seed, versions."""
        from importlib.metadata import version

        family, controller = self.family, self.controller
        kit = asdict(family.kit) if family.kit else {}
        kit.pop("wiring", None)  # of a sketch: it determines no outcome
        scenario = {
            "push": [_entry(p) for p in self.pushes], "reference": [_entry(r) for r in self.references],
            "seconds": self.seconds, "start": list(self.start), "model": self.model, "band": self.band,
        }  # fmt: skip
        return {
            "robot": {"name": family.robot.name, "drive": family.robot.drive, **family.robot.numbers()},
            "kit": _limited(kit) if kit else None,
            "vary": family.uncertainty.to_json(),
            "controller": {**controller.to_json(), "hash": controller_hash(controller)},
            "scenario": scenario,
            "seed": self.seed,
            "versions": {name: version(name) for name in ("upright", "numpy", "numba")},
        }

    def _numbers(self, index: NDArray[Any]) -> tuple[Array, dict[str, Array]]:
        drawn = self.family.draw(self.seed, index)
        own = {name: values for name, values in drawn.items() if name in PARAMETERS}
        rest = {name: values for name, values in drawn.items() if name not in PARAMETERS}
        table = parameters_of(self.family.robot, own)
        return np.repeat(table, len(index), axis=0) if len(table) == 1 else table, rest

    def _outcomes(self, result: FleetResult, batch: FleetBatch) -> dict[str, Array]:
        released = max([0.0, *(end for p in self.pushes if (end := release(p)) < self.seconds)])
        radius = batch.parameters[:, list(PARAMETERS).index("wheel_radius")]
        outcomes: Mapping[str, Any] = {
            "fell": result.fell, "lived": result.lived, "peak_pitch": result.peak[:, 0],
            "settling": np.maximum(result.settled - released, 0.0), "rms_pitch": result.rms_pitch,
            "effort": result.effort, "saturated": result.saturated, "travel": result.peak[:, 1] * radius,
        }  # fmt: skip
        return {name: np.asarray(outcomes[name], dtype=np.float64) for name in OUTCOMES}


def tables(pushes: Sequence[Any], references: Sequence[Any], parameters: Array) -> Programme:
    """Pushes, slopes, drives and turns as tables for robots with `parameters` (n, 25); a hold has a force for each.

    Raises `InvalidScenario` for a push or reference that the kernel does not know, or slopes from different times.
    """
    robots = SimpleNamespace(**dict(zip(PARAMETERS, parameters.T, strict=True)))
    slopes = [p for p in pushes if isinstance(p, Slope)]
    if len({slope.start for slope in slopes}) > 1:
        raise InvalidScenario("slopes from different times", expected="one slope in a fleet")
    slope = [sum(s.angle for s in slopes), slopes[0].start if slopes else 0.0]
    rows = [_push_row(p, robots) for p in pushes if not isinstance(p, Slope)]
    wide = [np.stack(np.broadcast_arrays(*row), axis=-1).reshape(-1, 4) for row in rows]
    n = max([1, *(len(row) for row in wide)])
    pushed = [np.broadcast_to(row, (n, 4)) for row in wide]
    ramps = [_ramp(r) for r in references]
    return Programme(
        np.stack(pushed, axis=1) if pushed else np.zeros((1, 0, 4)),
        np.array([slope]),
        np.array(ramps, dtype=np.float64).reshape(1, -1, 4),
    )


def release(push: Any) -> float:
    """When a push ends [s]; 0 for one that does not end."""
    if isinstance(push, Hold):
        return push.until
    return push.start + push.duration if isinstance(push, Push | Impulse) else 0.0


def _push_row(push: Any, robots: Any) -> tuple[Any, float, float, float]:
    height = math.nan if getattr(push, "height", None) is None else float(push.height)
    kinds: dict[type, Callable[[], tuple[Any, float, float, float]]] = {
        Push: lambda: (push.force, height, push.start, push.duration),
        Impulse: lambda: (push.impulse / push.duration, height, push.start, push.duration),
        Hold: lambda: (push.force(robots), height, push.start, push.until - push.start),
    }
    if type(push) not in kinds:
        raise InvalidScenario(f"a {type(push).__name__} in a fleet", expected="Push, Impulse, Hold or Slope")
    return kinds[type(push)]()


def _ramp(reference: Any) -> list[float]:
    if isinstance(reference, Drive):
        return [reference.speed, 0.0, reference.start, reference.until]
    if isinstance(reference, Turn):
        return [0.0, reference.rate, reference.start, reference.until]
    raise InvalidScenario(f"a {type(reference).__name__} in a fleet", expected="Drive or Turn")


def _entry(part: Any) -> dict[str, Any]:
    return {"kind": type(part).__name__, **_limited(asdict(part))}


def _limited(data: Any) -> Any:
    """The same without infinities, which JSON does not have: an absent number means no limit."""
    if isinstance(data, dict):
        entries = cast(dict[str, Any], data).items()
        return {k: _limited(v) for k, v in entries if not (isinstance(v, float) and not math.isfinite(v))}
    return data
