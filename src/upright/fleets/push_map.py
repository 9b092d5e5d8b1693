"""The largest push from which a robot recovers, by direction, height and duration, with a band for its uncertainty.

Where survival is not monotone the result is the *first* border: the least impulse beyond which some push fells the
robot. A larger one may be survived again; the map marks such points as islands.

A robot has *recovered* if it has not fallen (`robots.kit.STOP`) `watch` seconds after the push ended. The search
for the last border runs only until `glance` seconds after the push, since most falls come soon; each result is then
tried for the whole `watch`, and searched again at full length where the robot fell. Smaller impulses are tried for the
whole `watch`: some controllers fell a robot later than a glance by a push smaller than one that it survives.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Mask, Whole
from upright.errors import InvalidScenario, check_within
from upright.experiment.run import MAX_SECONDS
from upright.fleets.ensemble import Ensemble
from upright.fleets.fleet import ensemble_of
from upright.fleets.maps import PushMap
from upright.fleets.unfinished import coarse_first, marked, stoppable, thinned
from upright.fleets.usual import MAP_POINTS, MAP_ROBOTS
from upright.kernel.batch import FleetBatch
from upright.progress import Progress, unwatched
from upright.robots import Robot

if TYPE_CHECKING:
    from xarray import Dataset

Stands = Callable[[Array, Whole], Mask]
Points = tuple[Array, ...]
"""Direction, height and duration (n,) of n points."""

CEILING = 5.0
"""[m/s] The largest impulse of the search, as speed of the whole robot in free flight."""
FLOOR = 1e-3
"""[m/s] The smallest impulse of the search, as such a speed: a robot that it fells recovers from none."""

BAND = (0.025, 0.975)

LOWEST = 0.35
"""Of an impulse that is survived, from which on smaller ones are tried too."""
SCANNED = 35
"""Number of smaller impulses that are tried: 3 % from one to the next, so that a narrower gap is not seen."""

GLANCE = 1.0
"""[s] after a push in which most falls come."""

NODES = (16, 16)
"""Heights and durations at which the band is computed."""

_TRIES = 8.0  # impulses of a search until the bracket is within 1 %, as counted of the presets
_AT_ONCE = 16384  # searches of drawn robots in one batch, which bounds the memory
_LEAP = 16.0  # largest factor between two tries while the bracket grows


def largest(stands: Stands, guess: ArrayLike, ceiling: float, floor: float, tolerance: float, factor: float) -> Array:
    """For each of n searches the largest impulse that is survived: one `tolerance` (relative) larger is not.

    `stands(impulse, which)` is True where search number `which` survives `impulse`. The bracket grows from
    `guess` by `factor` and its powers, then halves on a logarithmic scale. The result is `ceiling` where that is
    survived, and 0 where `floor` is not.
    """
    trial = np.clip(np.asarray(guess, dtype=np.float64), floor, ceiling)
    low = np.zeros_like(trial)
    high = np.full_like(trial, np.inf)
    stride = np.full_like(trial, factor)
    active = np.arange(trial.size)
    while active.size:
        tried = trial[active]
        good = stands(tried, active)
        low[active[good]], high[active[~good]] = tried[good], tried[~good]
        lo, hi = low[active], high[active]
        with np.errstate(invalid="ignore"):
            trial[active] = np.where(
                np.isinf(hi), lo * stride[active], np.where(lo == 0, hi / stride[active], np.sqrt(lo * hi))
            )
        trial[active] = np.clip(trial[active], floor, ceiling)
        stride[active] = np.minimum(stride[active] ** 2, _LEAP)
        done = (hi <= lo * (1 + tolerance)) | (lo >= ceiling) | (hi <= floor)
        active = active[~done]
    return low


def first_border(stands: Stands, survived: Array, floor: float, tolerance: float) -> Array:
    """For each of n searches the least border of survival from `LOWEST` of `survived` [N s] up to it."""
    first = survived.copy()
    alive = np.flatnonzero(survived > 0)
    steps = np.geomspace(LOWEST, 1.0, SCANNED + 1)
    tried = survived[alive, None] * steps[:-1]
    stood = stands(tried.reshape(-1), np.repeat(alive, SCANNED)).reshape(tried.shape)
    fell = np.flatnonzero(~stood.all(axis=1))
    place = np.argmin(stood[fell], axis=1)
    low = np.where(place > 0, survived[alive[fell]] * steps[np.maximum(place - 1, 0)], floor)
    high = survived[alive[fell]] * steps[place]
    while (wide := np.flatnonzero(high > low * (1 + tolerance))).size:
        middle = np.sqrt(low[wide] * high[wide])
        good = stands(middle, alive[fell[wide]])
        low[wide[good]], high[wide[~good]] = middle[good], middle[~good]
    first[alive[fell]] = low
    return first


@dataclass(frozen=True, eq=False, kw_only=True)
class PushGrid:
    """Points of the map: `directions` (+1 forward, −1 backward), `heights` above the axle [m], `durations` [s]."""

    directions: Sequence[int] = (1, -1)
    heights: Array
    durations: Array

    def __post_init__(self) -> None:
        for name, lowest in (("heights", -math.inf), ("durations", 0.0)):
            values = np.array(getattr(self, name), dtype=np.float64).reshape(-1)
            if not (
                values.size and np.isfinite(values).all() and (values > lowest).all() and (np.diff(values) > 0).all()
            ):
                raise InvalidScenario(
                    f"{name} of {values.tolist()[:5]} …", expected="finite, increasing, durations above 0"
                )
            values.setflags(write=False)
            object.__setattr__(self, name, values)
        if not self.directions or any(d not in (1, -1) for d in self.directions):
            raise InvalidScenario(f"directions {self.directions}", expected="1 (forward), -1 (backward) or both")

    @property
    def shape(self) -> tuple[int, int, int]:
        """(directions, heights, durations)."""
        return len(self.directions), len(self.heights), len(self.durations)

    def flat(self) -> Points:
        """Direction, height and duration of every point, in that order of axes."""
        axes = np.meshgrid(np.array(self.directions, dtype=np.float64), self.heights, self.durations, indexing="ij")
        return tuple(axis.reshape(-1) for axis in axes)

    @classmethod
    def usual(cls, ensemble: Ensemble) -> PushGrid:
        """Heights up to the body's, durations up to 0.5 s, as many as usual."""
        points = MAP_POINTS[ensemble.called]
        heights = np.linspace(0.0, ensemble.family.robot.body_height, points)
        return cls(heights=heights, durations=np.linspace(0.01, 0.5, points))

    def thinned(self, heights: int, durations: int) -> PushGrid:
        """At most `heights` heights and `durations` durations of the grid, the ends included."""
        rows, columns = thinned(len(self.heights), heights), thinned(len(self.durations), durations)
        return PushGrid(directions=self.directions, heights=self.heights[rows], durations=self.durations[columns])


def push_map(
    robot: Robot | str | Ensemble,
    grid: PushGrid | None = None,
    *,
    samples: int | None = None,
    nodes: tuple[int, int] = NODES,
    tolerance: float = 0.01,
    watch: float = 5.0,
    threads: int | None = None,
    progress: Progress | None = None,
    **choices: Any,
) -> PushMap:
    """The nominal robot's largest survived impulse [N s] at every point of `grid` (None: `PushGrid.usual`), within
    `tolerance` (relative), and its band of 95 % over `samples` robots of the family (None: as many as usual).

    An `Ensemble` is taken without its own pushes; for a robot, `ensemble_of` makes one of it and `choices` (controller,
    kit, vary, posterior, seed), which by default varies all parameters by their spreads.

    `impulse` is the first border: every smaller push that was tried is survived. Where a larger one is survived again,
    `island` is true, and `last` [N s] is the largest that was found.

    The band is computed robot by robot at `nodes` (heights, durations) of the grid; between them the ratio to the
    nominal robot is interpolated, linear in both. Robot s has noise from stream s everywhere, the nominal one from 0.

    Ctrl-C raises `interrupts.Stopped`, whose `result` is the finest grid that is whole, with the band of the robots
    until then.
    """
    check_within("samples", samples or 0, 0, 100_000)
    check_within("seconds to stand after a push", watch, 1e-3, MAX_SECONDS)
    if not isinstance(robot, Ensemble):
        choices.setdefault("vary", () if choices.get("posterior") else ("spread",))
    ensemble = robot if isinstance(robot, Ensemble) else ensemble_of(robot, **choices)
    grid = grid or PushGrid.usual(ensemble)
    samples = MAP_ROBOTS[ensemble.called] if samples is None else samples
    search = _Search(ensemble, tolerance, watch, threads)
    small = grid.thinned(*nodes)
    search.expected = search.robot_seconds(grid, small, samples)
    search.show = progress or unwatched
    whole: tuple[Whole, ...] = ()
    drawn: list[Array] = []

    def so_far() -> PushMap:
        part = PushGrid(directions=grid.directions, heights=grid.heights[whole[1]], durations=grid.durations[whole[2]])
        borders = first[np.ix_(*whole)], last[np.ix_(*whole)]
        spread = np.concatenate(drawn) if drawn else None
        data = _labelled(part, part.thinned(*nodes), borders, spread, search)
        data = marked(data, "robots", sum(map(len, drawn)), samples)
        return PushMap(marked(data, "points", borders[0].size, first.size))

    search.show(0.0)
    with stoppable(lambda: so_far() if whole else None):
        last = search.nominal(grid)
        first = np.empty_like(last)
        for rows, points in coarse_first(*grid.shape):
            first.flat[points] = search.first(tuple(axis[points] for axis in grid.flat()), last.flat[points])
            whole = rows
        for robots in search.sampled(small, _at(last, grid, small), samples):
            drawn.append(robots)
    search.show(1.0)
    return so_far()


def robot_seconds(
    ensemble: Ensemble, grid: PushGrid, samples: int, *, tolerance: float = 0.01, watch: float = 5.0
) -> float:
    """About how long all robots together run for a map [s]; raises as `push_map`."""
    search = _Search(ensemble, tolerance, watch)
    return search.robot_seconds(grid, grid.thinned(*NODES), samples)


class _Search:
    """Searches with one set of settings; `runs` counts the robots that were simulated, of `expected` robot seconds."""

    def __init__(self, ensemble: Ensemble, tolerance: float, watch: float, threads: int | None = None) -> None:
        if not 1e-6 <= tolerance <= 0.5:
            raise InvalidScenario(f"a tolerance of {tolerance:g}", expected="between 1e-6 and 0.5")
        self.ensemble = ensemble
        self.tolerance = tolerance
        self.watch = watch
        self.glance = min(GLANCE, watch)
        self.threads = threads
        self.runs = 0
        self.expected = math.inf
        self.show: Progress = unwatched
        self._spent = 0.0
        robot = ensemble.family.robot
        mass = robot.body_mass + 2 * robot.wheel_mass
        self.ceiling, self.floor = CEILING * mass, FLOOR * mass

    def robot_seconds(self, grid: PushGrid, small: PushGrid, samples: int) -> float:
        """About how long all robots together will run [s]: bisections take as many tries more as the tolerance is
        finer, each for a glance, then one for the whole watch; of the nominal robot also the smaller impulses."""
        mean = float(grid.durations.mean())
        tries = _TRIES + math.log2(0.01 / self.tolerance)
        watched = self.watch + mean
        search = tries * (self.glance + mean) + watched
        nominal = math.prod(grid.shape) * (search + SCANNED * watched)
        return nominal + samples * math.prod(small.shape) * search

    def nominal(self, grid: PushGrid) -> Array:
        """The nominal robot's impulses, shape of the grid."""
        ensemble = self.ensemble.nominal()
        points = grid.flat()
        zeros = np.zeros(points[0].size, dtype=np.int64)
        coarse = grid.thinned(8, 8)
        first = self._find(ensemble, coarse.flat(), zeros[: math.prod(coarse.shape)], self.ceiling / 20, 2.0)
        guess = _between(first.reshape(coarse.shape), coarse, grid).reshape(-1)
        return self._find(ensemble, points, zeros, guess, 1.06).reshape(grid.shape)

    def first(self, points: Points, last: Array) -> Array:
        """The first borders (n,) of the nominal robot at `points`, below those found."""
        table = self.ensemble.nominal().batch(np.zeros(last.size, dtype=np.int64))

        def stands(impulse: Array, which: Whole) -> Mask:
            return self._stand(table, points, impulse, which, self.watch)

        return first_border(stands, last, self.floor, self.tolerance)

    def sampled(self, grid: PushGrid, nominal: Array, samples: int) -> Iterator[Array]:
        """Impulses (·, *grid.shape) of robots 0 to `samples` − 1 of the family, some at a time."""
        count = math.prod(grid.shape)
        points = grid.flat()
        at_once = max(1, _AT_ONCE // count)
        for start in range(0, samples, at_once):
            robots = np.arange(start, min(samples, start + at_once))
            which = np.repeat(robots, count)
            spread_out = tuple(np.tile(p, len(robots)) for p in points)
            guess = np.tile(np.maximum(nominal.reshape(-1), self.floor), len(robots))
            yield self._find(self.ensemble, spread_out, which, guess, 1.08).reshape(-1, *grid.shape)

    def _find(self, ensemble: Ensemble, points: Points, robots: Whole, guess: Any, factor: float) -> Array:
        """Search with `glance`, try each result for the whole `watch`, and search again where the robot fell."""
        table = ensemble.batch(robots)

        def stands(seconds: float, part: Whole) -> Stands:
            return lambda impulse, which: self._stand(table, points, impulse, part[which], seconds)

        everyone = np.arange(robots.size)
        guessed = np.broadcast_to(np.asarray(guess, dtype=np.float64), robots.shape)
        bounds = (self.ceiling, self.floor, self.tolerance)
        impulses = largest(stands(self.glance, everyone), guessed, *bounds, factor)
        alive = np.flatnonzero(impulses > 0)
        again = alive[~stands(self.watch, alive)(impulses[alive], np.arange(alive.size))]
        if again.size:
            impulses[again] = largest(stands(self.watch, again), impulses[again] / (1 + self.tolerance), *bounds, 1.02)
        return impulses

    def _stand(self, table: FleetBatch, points: Points, impulse: Array, which: Whole, beyond: float) -> Mask:
        """Whether searches number `which` survive `impulse` [N s] (n,), simulated until `beyond` [s] after it."""
        from upright.kernel.simulate import CALLED, simulate

        direction, height, duration = (p[which] for p in points)
        pushes = np.stack([direction * impulse / duration, height, np.zeros(which.size), duration], axis=1)[:, None]
        self.runs += which.size
        stood = np.empty(which.size, dtype=bool)
        # Robots whose pushes last about as long run together: a short push needs a shorter run than a long one.
        parts = -(-which.size // CALLED) if self.ensemble.called else max(1, min(8, which.size // 512))
        for part in np.array_split(np.argsort(duration, kind="stable"), parts):
            batch = table.part(which[part], pushes=pushes[part])
            seconds = float(duration[part].max()) + beyond
            stood[part] = ~simulate(batch, seconds, threads=self.threads).fell
            self._spent += part.size * seconds
            self.show(min(0.99, self._spent / self.expected))  # which is a guess
        return stood


def _at(values: Array, grid: PushGrid, small: PushGrid) -> Array:
    rows = np.searchsorted(grid.heights, small.heights)
    columns = np.searchsorted(grid.durations, small.durations)
    return values[:, rows][:, :, columns]


def _between(values: Array, small: PushGrid, grid: PushGrid) -> Array:
    """Linear in height and in duration between the points of `small`, at those of `grid`."""
    along = np.apply_along_axis(lambda row: np.interp(grid.durations, small.durations, row), 2, values)
    return np.apply_along_axis(lambda column: np.interp(grid.heights, small.heights, column), 1, along)


def _labelled(
    grid: PushGrid, small: PushGrid, borders: tuple[Array, Array], spread: Array | None, search: _Search
) -> Dataset:
    import xarray as xr

    dims = ("direction", "height", "duration")
    newton = {"unit": "N s"}
    first, last = borders
    variables: dict[str, Any] = {
        "impulse": (dims, first, newton | {"long_name": "largest impulse survived, with every smaller one"}),
        "last": (dims, last, newton | {"long_name": "largest impulse survived at all"}),
        "island": (dims, first < last, {"unit": "1", "long_name": "a larger impulse is survived again"}),
        "capped": (dims, last >= search.ceiling, {"unit": "1", "long_name": "at the largest impulse of the search"}),
    }
    coords: dict[str, Any] = {
        "direction": np.array(["forward" if d > 0 else "backward" for d in grid.directions]),
        "height": ("height", grid.heights, {"unit": "m", "long_name": "height above the axle"}),
        "duration": ("duration", grid.durations, {"unit": "s", "long_name": "duration of the push"}),
    }
    if spread is not None:
        base = np.maximum(_at(last, grid, small), search.floor)
        for name, quantile in zip(("low", "high"), BAND, strict=True):
            ratio = np.quantile(spread, quantile, axis=0) / base
            words = {"long_name": f"{100 * quantile:g} % quantile over the family"}
            variables[name] = (dims, first * _between(ratio, small, grid), newton | words)
    settings: dict[str, Any] = {"samples": 0 if spread is None else len(spread), "tolerance": search.tolerance}
    settings |= {"watch": search.watch, "glance": search.glance, "ceiling": search.ceiling, "runs": search.runs}
    settings |= {"nodes": {"height": small.heights.tolist(), "duration": small.durations.tolist()}}
    origin = search.ensemble.origin() | {"push_map": settings}
    return xr.Dataset(variables, coords, {"origin": json.dumps(origin, ensure_ascii=False)})
