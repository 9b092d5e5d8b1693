"""The search behind `excite`: ways of exciting, as loud as drawn robots allow, then as quiet as will do."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from upright.arrays import Array
from upright.calibration.fitting import Problem
from upright.calibration.summary import NORMAL
from upright.control.excited import random_binary
from upright.errors import DesignFailed, InvalidScenario, UnknownName
from upright.excitation.information import added, best_division, fisher, problem_of, quiet, score, shrunk
from upright.excitation.loop import ExcitedLoop, stacked
from upright.excitation.plan import ExcitationPlan
from upright.excitation.planned import Checked, Limits, Predicted, Tried
from upright.excitation.signals import mixture, signals
from upright.kernel.batch import NAMES, FleetResult, parameters_of
from upright.pages import Say
from upright.progress import Progress
from upright.robots import PARAMETERS
from upright.robots.uncertainty import Family
from upright.signals import Log

MARGIN = 1.1
"""The plan is checked so much larger than it is: a real motor may be stronger, a floor smoother than the model's."""

FEWEST = 100  # robots that stand, below which nothing can be said of falls
LEAST_STANDING = 0.5  # of the robots drawn: if fewer stand, the controller does not hold this robot
SWAY = 0.5  # [rad] beyond this a robot that nothing excites does not stand, but is about to fall
LEAST_LOUD = 0.7  # of a plan ought still to move the robot enough for a calibration to give inertias
SEARCHED = 32  # robots with which a size is searched; the final check takes all
HARDLY = 1  # of these may fall: one that hardly stands alone would keep every plan too quiet to tell an inertia
COARSE = 2.0 ** np.arange(-4.0, 3.0)
FINE = 2.0 ** (np.arange(4) / 4)
SMALLER, TRIES = 0.85, 12  # how much smaller, and how often, a plan is made that does not keep the limits
COMBINED = "combination"
HELD = 4  # periods for which the second dither is held, as in benchmarks/calibrate.py
PER_CENT = 95
MANY = 100
"""Runs after which what is left of an interval is what no run of this kind takes away: the other numbers' spreads."""


@dataclass(frozen=True, eq=False)
class Way:
    """A way of exciting: the division of energy among its signals, and their sum (rows, 2), as large as is allowed."""

    name: str
    division: Mapping[str, float]
    excitation: Array
    energy: float
    score: float


@dataclass(eq=False)
class Search:
    """The search; `stand` (n, 25) are robots that stand unexcited."""

    loop: ExcitedLoop
    limits: Limits
    known: tuple[str, ...]
    focus: tuple[str, ...]
    stand: Array = field(init=False)
    dropped: int = field(init=False)
    problem: Problem = field(init=False)
    weights: Array = field(init=False)
    made: Mapping[str, Mapping[str, Array]] = field(init=False)
    parts: Mapping[str, Array] = field(init=False)
    at_rest: Array = field(init=False)

    def draw(self, family: Family, samples: int) -> None:
        """Robots of the family, without those that fall with no excitation at all."""
        if samples < FEWEST:
            raise InvalidScenario(f"{samples} robots", expected=f"{FEWEST} or more, for a bound on falls")
        drawn = family.draw(self.loop.seed, np.arange(samples))
        table = parameters_of(self.loop.robot, drawn)
        table = np.repeat(table, samples, axis=0) if len(table) == 1 else table
        result = self.loop.run(self._nothing(), table, hold=self.loop.periods)
        stands = ~result.fell & (result.peak[:, 0] < SWAY)
        self.stand = table[stands]
        self.dropped = int((~stands).sum())
        if len(self.stand) < max(FEWEST, LEAST_STANDING * samples):
            raise DesignFailed(
                f"{self.dropped} of {samples} robots drawn round {self.loop.robot.name} do not stand unexcited",
                expected=f"a controller that holds {LEAST_STANDING:.0%} of them", likely="a controller that does not "
                f"hold this robot under kit {self.loop.kit.name}", hint="give another --controller",
            )  # fmt: skip
        broken = self._measured(result, table).broken(self.limits)
        broken.pop("falls", None)
        if broken:
            raise DesignFailed(
                f"without any excitation {next(iter(broken.values()))}",
                expected="the limits kept at rest",
                hint="raise that limit",
            )

    def begin(self) -> None:
        """The parameters to estimate, and the information of a run without excitation."""
        largest = self.largest(random_binary(self.loop.rows, 1.0, self.loop.seed))
        (log,) = self._logs(largest[None])
        self.problem = problem_of(log, self.loop.robot, self.loop.kit, self.known)
        names = [p.name for p in self.problem.asked]
        for name in self.focus:
            if name not in names:
                raise UnknownName("parameter to focus on", name, names)
        focus = self.focus or [name for name in names if name in PARAMETERS]
        self.weights = np.array([float(p.name in focus) for p in self.problem.parameters])
        self.at_rest = self._at_rest()
        self.size = float(self.loop.energies(largest[None])[0])

    def loudest(self, show: Progress) -> list[Way]:
        """Every way of exciting as large as it may be, the best first."""
        made = signals(self.loop.rows, self.loop.hold * self.loop.gains.period, self.loop.seed)
        every = {name: wave for parts in made.values() for name, wave in parts.items()}
        parts = self._parts(every, self.size)
        show(0.3)
        self.made = {**made, COMBINED: every}
        self.parts = parts
        ways: list[Way] = []
        for i, name in enumerate(self.made):
            division = self._division(name, self.size)
            ways += [self._way(name, division, self.largest(self._mixed(name, division)))] if division else []
            show(0.3 + 0.7 * (i + 1) / len(self.made))
        if not ways or min(way.score for way in ways) == np.inf:
            raise DesignFailed("no excitation keeps the limits", expected="room for some", hint="raise a limit")
        return sorted(ways, key=lambda way: way.score)

    def quieter(self, tried: Sequence[Way], enough: float) -> Way:
        """The way of least energy, halving by halving, for intervals at most `enough` times the narrowest."""
        best = tried[0]
        energy = tried[0].energy
        while enough > 1:
            energy = energy / 2
            able = [way for way in tried if way.energy >= energy]
            divisions = [(way.name, self._division(way.name, energy)) for way in able]
            several = [
                self._way(name, division, self.loop.scaled(self._mixed(name, division)[None], energy)[0])
                for name, division in divisions
                if division
            ]
            way = min(several, key=lambda w: w.score)
            if way.score > tried[0].score + np.log(enough) or not self._loud(way):
                break
            best = way
        return best

    def _loud(self, way: Way) -> bool:
        """Whether a part of it still moves the nominal robot enough to estimate an inertia: another may move less."""
        logs = self._logs(LEAST_LOUD * way.excitation[None])
        return bool(logs) and not quiet(logs[0], self.loop.robot, self.loop.kit, self.known)

    def settled(self, way: Way) -> tuple[Array, Checked]:
        """The excitation as large as all robots allow, and what was measured of them."""
        excitation = way.excitation
        broken = dict[str, Say]()
        for _ in range(TRIES):
            checked = self._measured(self.loop.run(MARGIN * excitation, self.stand), self.stand)
            broken = checked.broken(self.limits)
            if not broken:
                return excitation, checked
            excitation = SMALLER * excitation
        raise DesignFailed(
            f"no {way.name} keeps the limits: {next(iter(broken.values()))}", expected="limits that can be kept",
            hint="raise that limit, draw more samples, or give a better --controller",
        )  # fmt: skip

    def plan(self, way: Way, tried: Sequence[Way], excitation: Array, checked: Checked) -> ExcitationPlan:
        """The way as a plan, with the predicted intervals of it and of dithers of its energy."""
        loop = self.loop
        who = self.loop.identity
        energy = float(loop.energies(excitation[None])[0])
        (log,) = self._logs(excitation[None])
        gained = self.information(log)
        after = shrunk(gained)
        least = shrunk(MANY * gained)
        dither, held = (shrunk(self._dither(energy, hold)) for hold in (1, HELD))
        division = {name: part / sum(way.division.values()) for name, part in way.division.items()}
        return ExcitationPlan(
            robot=loop.robot.name, kit=loop.kit.name, controller=loop.controller.spec.kind, hash=who.hash,
            asked=who.asked, response=who.response,
            period=loop.gains.period, unit=loop.gains.command_unit, hold=loop.hold, way=way.name, division=division,
            excitation=excitation, energy=energy, focus=self.focus, limits=self.limits, margin=MARGIN, checked=checked,
            added=float((excitation**2).sum() * loop.hold * loop.gains.period),
            predicted=self._predicted(after, dither, held, least),
            tried=tuple(Tried(w.name, w.energy, float(np.exp(w.score))) for w in tried),
            seed=loop.seed, notes=tuple(filter(None, [quiet(log, loop.robot, loop.kit, self.known)])),
        )  # fmt: skip

    def largest(self, shape: Array) -> Array:
        """`shape` (rows, 2) as large as `SEARCHED` robots allow, to a fifth; zeros where they allow nothing."""
        size = _most(self.loop) / 8 / np.sqrt(np.mean(shape**2))
        low = self._largest(shape, size * COARSE)
        return shape * (self._largest(shape, low * FINE) if low else 0.0)

    def _at_rest(self) -> Array:
        """Information of a run without excitation; none where no encoder moves, as in a dead zone."""
        (log,) = self._logs(np.zeros((1, self.loop.rows, 2)))
        moves = any(np.ptp(log[name]) > 0 for name in log.channels if "encoder" in name)
        return self.information(log) if moves else np.zeros((len(self.weights),) * 2)

    def information(self, log: Log) -> Array:
        """Information (n, n) of a log of the nominal robot."""
        return fisher(problem_of(log, self.loop.robot, self.loop.kit, self.known))

    def _nothing(self) -> Array:
        return np.zeros((1, 1, 2))

    def _logs(self, excitations: Array) -> list[Log]:
        return self.loop.logs(self.loop.run(excitations, record=True))

    def _measured(self, result: FleetResult, table: Array) -> Checked:
        stood = ~result.fell
        radius = table[:, NAMES.index("wheel_radius")]
        numbers = (result.saturated, result.peak[:, 1] * radius, result.peak[:, 0])
        most = [float(np.percentile(values[stood], PER_CENT)) if stood.any() else np.inf for values in numbers]
        return Checked(len(stood), int(result.fell.sum()), self.dropped, *most)

    def _largest(self, shape: Array, sizes: Array) -> float:
        """The largest of growing `sizes` up to which hardly a robot falls and the other limits are kept, or 0."""
        robots = self.stand[:SEARCHED]
        several = np.repeat(MARGIN * sizes[:, None, None] * shape, len(robots), axis=0)
        result = self.loop.run(several, np.tile(robots, (len(sizes), 1)))
        good = 0.0
        for i, size in enumerate(sizes):
            part = slice(i * len(robots), (i + 1) * len(robots))
            travel = result.peak[part, 1] * robots[:, NAMES.index("wheel_radius")]
            most = [np.percentile(values, PER_CENT) for values in (result.saturated[part], travel)]
            if result.fell[part].sum() > HARDLY or most[0] > self.limits.saturated or most[1] > self.limits.travel:
                break
            good = float(size)
        return good

    def _parts(self, parts: Mapping[str, Array], energy: float) -> dict[str, Array]:
        """Information of all of `energy` in each part alone, from a run with half of it."""
        shapes = self.loop.scaled(stacked(list(parts.values())), energy / 2)
        result = self.loop.run(shapes, record=True)
        logs = iter(self.loop.logs(result))
        return {
            name: 2 * added(self.information(next(logs)), self.at_rest)
            for name, fell in zip(parts, result.fell, strict=True)
            if not fell
        }

    def _division(self, name: str, energy: float) -> dict[str, float]:
        """How a way divides that energy among its signals; nothing where the nominal robot falls under each of them."""
        gained = {n: self.parts[n] for n in self.made[name] if n in self.parts}
        if not gained:
            return {}
        fractions = best_division(self.at_rest, stacked(list(gained.values())) * (energy / self.size), self.weights)
        return {n: float(f) for n, f in zip(gained, fractions, strict=True) if f > 0}

    def _mixed(self, name: str, division: Mapping[str, float]) -> Array:
        """The way's signals, each of the same energy, by their fractions."""
        equal = self.loop.scaled(stacked([self.made[name][n] for n in division]), self.size / 4)
        return mixture(dict(zip(division, equal, strict=True)), division)

    def _way(self, name: str, division: Mapping[str, float], excitation: Array) -> Way:
        logs = self._logs(excitation[None]) if excitation.any() else []
        value = score(self.information(logs[0]), self.weights) if logs else np.inf
        return Way(name, division, excitation, float(self.loop.energies(excitation[None])[0]), value)

    def _dither(self, energy: float, hold: int) -> Array:
        """Information of a random binary dither of that energy, drawn anew every `hold` periods."""
        rows = -(-self.loop.periods // hold)
        shape = self.loop.scaled(
            random_binary(rows, 1.0, self.loop.seed + 1)[None] * _most(self.loop) / 8, energy, hold
        )
        logs = self.loop.logs(self.loop.run(shape, record=True, hold=hold))
        return self.information(logs[0]) if logs else np.zeros_like(self.at_rest)

    def _predicted(self, *several: Array) -> tuple[Predicted, ...]:
        """Widths of the intervals, from the fractions (n,) that are left of them."""
        predicted: list[Predicted] = []
        for i, p in enumerate(self.problem.asked):
            widths = [
                float(p.value(NORMAL * s) - p.value(max(-NORMAL * s, p.least)))
                for s in (1.0, *(left[i] for left in several))
            ]
            names = ("before", "after", "dither", "held", "least")
            numbers = dict(zip(names, widths, strict=True))
            predicted.append(Predicted(name=p.name, unit=p.unit, value=p.prior, **numbers))
        return tuple(predicted)


def _most(loop: ExcitedLoop) -> float:
    """The largest command of the kit, or where it has none, one that is a few times Bryson's."""
    limit = loop.kit.most(loop.gains.command_unit)
    return limit if np.isfinite(limit) else {"V": 8.0, "N m": 0.5}[loop.gains.command_unit]
