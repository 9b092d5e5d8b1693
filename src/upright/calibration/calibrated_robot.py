"""What a calibration says: every number with its interval and its prior, what the log could not tell, and how it was
checked, as data: it can check itself, and is written as JSON."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array, Whole
from upright.atomic import finite
from upright.calibration.decision import DOUBTFUL, EXCITE, UNKNOWN, USABLE, Decision, came_out
from upright.calibration.estimate import HELD, MOVED, NORMAL, REFUSED, SURPRISE, Estimate
from upright.errors import InvalidRobot
from upright.languages import ENGLISH, speaking
from upright.pages import Message, Next, Quantity, Result, Say
from upright.pages.terms import channel, term
from upright.pages.words import shown_in
from upright.physics.linear import unstable_pole
from upright.robots import Kit, Robot

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PREDICTED = {
    "sensor/gyro": "rad/s",
    "sensor/encoder_left": "rad",
    "sensor/encoder_right": "rad",
    "sensor/encoder_rate_left": "rad/s",
    "sensor/encoder_rate_right": "rad/s",
}
"""Readings by which a calibration is judged, with their units."""
DRAWN = PREDICTED | {"sensor/compass": "rad"}
"""Readings that `Calibration.plot_prediction` draws, with their units."""

HELD_OUT = 0.1  # [s] a shorter end of a log is none that was held out
GOOD = 0.9
"""[1] R² of half seconds from which a channel is predicted."""
ENOUGH = 0.25
"""[1] Half of the unstable pole's interval over its value, up to which a controller may be designed: what topples the
robot goes with the pole's square, 1.25² = 1.56, and a linear quadratic regulator stands a motor half as strong, 2
(Safonov and Athans 1977), of which delays take a part."""
FAR = 4.0  # a reading missed by more than twice its deviation counts as missed by that: one fall is not the whole score


@dataclass(frozen=True)
class Whiteness:
    """Two tests of a sensor's innovations: whether they predict one another, and whether the commands predict them.

    `ljung_box` and `input_test` are χ² statistics of `lags` degrees of freedom; both are to stay below `threshold`
    (the 99 % point). `worst` is the largest autocorrelation of the first five lags, `rms` that of the innovations over
    what the filter expected.
    """

    sensor: str
    rms: float
    worst: float
    ljung_box: float
    input_test: float
    lags: int
    threshold: float

    @property
    def white(self) -> bool:
        return self.ljung_box < self.threshold and self.input_test < self.threshold


@dataclass(frozen=True, eq=False)
class Segments:
    """Readings, measured and predicted by a free simulation from the first state of their segment, which alone is
    fitted; NaN where the simulated robot fell. All arrays (readings,)."""

    rows: tuple[str, ...]
    row: Whole
    when: Array
    measured: Array
    predicted: Array
    segment: Whole

    def r_squared(self, name: str) -> float:
        """1 − Σ(y − ŷ)²/Σ(y − ȳ)² of one reading, or of the mean of a pair ("encoder", "encoder_rate"); a reading
        beyond a simulated fall, or further off, counts as missed by twice the deviation."""
        y, predicted, _ = self._of(name)
        variance = float(y.var())
        missed = np.where(np.isfinite(predicted), (y - predicted) ** 2, np.inf)
        return 1 - float(np.minimum(missed, FAR * variance).mean()) / max(variance, 1e-30)

    def score(self) -> float:
        """Mean over the readings of R² against each segment's own mean, falls and misses counted up to `FAR`."""
        scores: list[float] = []
        for name in self.rows:
            y, predicted, segment = self._of(name)
            mean = np.bincount(segment, y) / np.maximum(np.bincount(segment), 1)
            variance = float(((y - mean[segment]) ** 2).mean())
            missed = np.where(np.isfinite(predicted), (y - predicted) ** 2, np.inf)
            scores.append(1 - float(np.minimum(missed, FAR * variance).mean()) / max(variance, 1e-30))
        return float(np.mean(scores))

    def series(self, name: str) -> tuple[Array, Array, Array]:
        """Times [s], measured and predicted values (n + gaps,) of one reading, with a gap of NaN between segments."""
        at = np.flatnonzero(self.row == self.rows.index(name))
        breaks = np.flatnonzero(np.diff(self.segment[at])) + 1
        measured, predicted = (np.insert(column[at], breaks, np.nan) for column in (self.measured, self.predicted))
        return np.insert(self.when[at], breaks, self.when[at][breaks]), measured, predicted

    @property
    def lost(self) -> float:
        """Fraction of readings beyond a simulated fall."""
        return float((~np.isfinite(self.predicted)).mean())

    def _of(self, name: str) -> tuple[Array, Array, Whole]:
        pair = [i for i, row in enumerate(self.rows) if row in (name, f"sensor/{name}_left", f"sensor/{name}_right")]
        parts = [
            (self.measured[self.row == i], self.predicted[self.row == i], self.segment[self.row == i]) for i in pair
        ]
        least = min(len(p[0]) for p in parts)
        mean = [np.mean([p[k][:least] for p in parts], axis=0) for k in (0, 1)]
        return mean[0], mean[1], parts[0][2][:least]


@dataclass(frozen=True, repr=False, kw_only=True)
class CalibratedRobot(Result):
    """A robot learnt from logs. `parameters` are what was fitted, `combinations` what the log really sees (ratios of
    them, and the unstable pole), `delays` the dead times, `electronics` what commands go through; `covariance` (n, n)
    is that of the parameters' names in `names`, in SI units. `fits` holds [%] h-step fits by horizon and sensor on the
    part kept back, `segments` R² of free simulation. `notes` are remarks for the reader. `refused` says why the fit is
    no description of this robot: then no number is called visible; where its log can tell no robot, `untold` says what
    to run. One of `suspects`, numbers of the file, is wrong. What was found beside the robot, as a tilt of its gyro,
    makes the logs so many nats `likelier`. `saved` is the file of the robot, once it is written. `widening` is by how
    much the intervals of what is visible are wider than those of a right model, `supported` how many numbers and
    combinations such a model would have visible. `quiet` says why the logs can give no inertia, `apart` which of
    several runs differs from the rest, `missed` which readings half seconds explain too little of, and why where that
    is known."""

    robot: Robot
    prior: Robot
    parameters: tuple[Estimate, ...]
    combinations: tuple[Estimate, ...]
    delays: tuple[Estimate, ...]
    names: tuple[str, ...]
    covariance: Array
    noise: Mapping[str, float]
    whiteness: tuple[Whiteness, ...]
    fits: Mapping[str, Mapping[str, float]]
    segments: Mapping[str, float]
    temper: float
    samples: int
    seconds: float
    sources: tuple[str, ...] = ()
    notes: tuple[Say, ...] = ()
    unseen: tuple[Say, ...] = ()
    electronics: tuple[Estimate, ...] = ()
    free: tuple[Segments, ...] = ()
    refused: tuple[Say, ...] = ()
    suspects: tuple[str, ...] = ()
    kit: Kit | None = None
    widening: float = 1.0
    supported: int = 0
    quiet: Say | None = None
    apart: tuple[Say, ...] = ()
    missed: tuple[Say, ...] = ()
    untold: Next | None = None
    likelier: Mapping[str, float] = dataclasses.field(default_factory=dict[str, float])
    saved: str = ""

    def __post_init__(self) -> None:
        covariance = np.array(self.covariance, dtype=np.float64)
        covariance.setflags(write=False)
        object.__setattr__(self, "covariance", covariance)

    def __getitem__(self, name: str) -> Estimate:
        return next(
            e for e in (*self.parameters, *self.combinations, *self.delays, *self.electronics) if e.name == name
        )

    def check(self) -> tuple[Say, ...]:
        """What is wrong with this calibration, from its own numbers; nothing where it may be trusted."""
        if self.untold:
            return self.refused
        wrong = [*self.refused, *([self.quiet] if self.quiet else []), *map(came_out, self.off)]
        wrong += [*self.apart, *self.missed]
        wrong += [
            Say("The interval of the {name} does not hold its value.", name=term(e.name))
            for e in self.parameters
            if not e.low <= e.value <= e.high
        ]
        values = np.linalg.eigvalsh(self.covariance / np.sqrt(np.outer(*[np.diag(self.covariance)] * 2)))
        wrong += [Say("The covariance of the numbers is not positive.")] if values[0] < -1e-9 else []
        try:
            self.robot.replace()
        except InvalidRobot as error:
            wrong.append(Say("This is no robot: {error}.", error=Message(error)))
        return tuple(wrong)

    @property
    def uneven(self) -> Say | None:
        """In which sensors the model leaves more than noise; of how much weight that is, only R² says."""
        sensors = dict.fromkeys(channel(w.sensor) for w in self.whiteness if not w.white)
        return (
            Say("The model does not explain all of these readings: {sensors}.", sensors=[*sensors]) if sensors else None
        )

    @property
    def doubts(self) -> tuple[Say, ...]:
        """What speaks against a design with this robot, or for a test on another log first."""
        doubts = [*self.check()]
        if self.refused:
            return tuple(doubts)
        if not (self.missed or self.least_score >= GOOD):
            doubts.append(Say("Not every sensor is predicted well enough for a design."))
        width = self["unstable_pole"].width
        if not width <= ENOUGH:
            facts = {"part": Quantity(width, "fraction", digits=2), "most": Quantity(ENOUGH, "fraction")}
            doubts.append(Say("The unstable pole is known to ±{part} only; a design needs ±{most}.", **facts))
        return tuple(doubts)

    @property
    def decision(self) -> Decision:
        """Whether a controller may be designed with this robot: for terminal, page, file and exit code alike."""
        if self.refused:
            if self.untold:
                return Decision(UNKNOWN, self.refused[0], self.untold)
            why = Say("Measure that number first, and correct the robot's file.")
            again = Next("calibrate", *self.sources, robot="MEASURED.toml", why=why)
            return Decision(REFUSED, self.refused[0], again if self.suspects else Next("doctor", *self.sources[:1]))
        if self.quiet:
            return Decision(UNKNOWN, self.quiet, EXCITE)
        if off := self.off:
            # such a number makes up for something else
            bent = any(e.kind == MOVED and abs(e.shift) > SURPRISE for e in off)
            first, *others = off
            why = came_out(first)
            if others:
                why = Say("Far from the robot's file: {names}.", names=[term(e.name) for e in off])
            known = Next(
                "calibrate",
                *self.sources,
                known=first.name,
                why=Say("Measure it first, and write it into the robot's file."),
            )
            return Decision(UNKNOWN if bent else DOUBTFUL, why, known)
        return Decision(USABLE)

    @property
    def off(self) -> tuple[Estimate, ...]:
        """Numbers that the log puts outside the 95 % interval that was known before."""
        return () if self.refused else tuple(e for e in self.parameters if e.off)

    @property
    def least_score(self) -> float:
        """The smallest of the `scores`."""
        return min(self.scores.values(), default=math.nan)

    @property
    def scores(self) -> dict[str, float]:
        """R² of half seconds of each sensor that counts, the smaller one of all and of those that were not fitted; a
        compass, which also turns with iron nearby, counts alone."""
        rest = self.unfitted
        every = {name: min(self.segments[name], rest.get(name, math.inf)) for name in self.channels}
        return {name: r2 for name, r2 in every.items() if name in PREDICTED} or every

    @property
    def unfitted(self) -> dict[str, float]:
        """R² of the half seconds that were not fitted, of each sensor; empty where all were."""
        if not self.held_out or not self.free:
            return {}
        free, (start, _) = self.free[0], self.held_out
        rest = free.when >= start
        part = dataclasses.replace(free, **{name: getattr(free, name)[rest] for name in _READINGS})
        return {name: part.r_squared(name) for name in free.rows if (part.row == free.rows.index(name)).sum() > 2}

    @property
    def correlation(self) -> Array:
        """Correlation matrix (n, n) of `names`."""
        spread = np.sqrt(np.diag(self.covariance))
        return self.covariance / np.outer(spread, spread)

    def known_robot(self) -> Robot:
        """The robot with its posterior: beside each number's deviation, how the errors of each two go together, and the
        electronics with the dead times and the motors that the log shows."""
        fitted = [e.name for e in self.parameters if e.verdict != HELD]
        rows = [self.names.index(name) for name in fitted]
        rho = self.correlation
        pairs = {
            (b, a): float(rho[j, i])
            for n, (a, i) in enumerate(zip(fitted, rows, strict=True))
            for b, j in zip(fitted[n + 1 :], rows[n + 1 :], strict=True)
        }
        own = {} if self.kit is None else {"kit": self.kit}
        return dataclasses.replace(self.robot, correlation=pairs, **own)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers, and remarks in English; what is not finite is null."""
        with speaking(ENGLISH):
            return self._data()

    def _data(self) -> dict[str, Any]:
        def plain(items: Sequence[Any]) -> list[dict[str, Any]]:
            return [{k: finite(v) for k, v in dataclasses.asdict(item).items()} for item in items]

        decision = self.decision
        uneven = [self.uneven] if self.uneven and not self.untold else []
        return {
            "schema": "upright/calibrate/1",
            "robot": {"name": self.robot.name, "drive": self.robot.drive, **self.robot.numbers()},
            "prior": {"name": self.prior.name, **self.prior.numbers()},
            "parameters": plain(self.parameters),
            "combinations": plain(self.combinations),
            "delays": plain(self.delays),
            "electronics": plain(self.electronics),
            "names": list(self.names),
            "covariance": self.covariance.tolist(),
            "noise": dict(self.noise),
            "whiteness": [{**d, "white": w.white} for d, w in zip(plain(self.whiteness), self.whiteness, strict=True)],
            "fits": {k: {n: finite(v) for n, v in row.items()} for k, row in self.fits.items()},
            "segments": {k: finite(v) for k, v in self.segments.items()},
            "temper": self.temper,
            "widening": self.widening,
            "supported": self.supported,
            "samples": self.samples,
            "computing_time": self.seconds,
            "sources": list(self.sources),
            **{name: list(map(str, getattr(self, name))) for name in ("notes", "unseen", "refused", "apart", "missed")},
            "quiet": str(self.quiet or ""),
            "wrong": list(map(str, [*self.check(), *uneven])),
            "doubts": list(map(str, self.doubts)),
            "bars": {"r2": GOOD, "pole": ENOUGH},
            "suspects": list(self.suspects),
            "likelier": dict(self.likelier),
            "unfitted": {k: finite(v) for k, v in self.unfitted.items()},
            "decision": {"verdict": decision.verdict, "why": str(decision.why or ""), "hint": decision.hint},
            "toml": self.known_robot().to_toml(),
        }

    def plot(self) -> Figure:
        """Each parameter's estimate and 95 % interval against its prior, in standard deviations of the prior (of the
        logarithm where that has them); what the log determines best comes first."""
        from upright.plotting import intervals, legend, span

        known = sorted((e for e in self.parameters if 0 < e.prior_spread < np.inf), key=lambda e: e.shrink)
        shifts = np.array([[e.asked.coordinate(x) for x in (e.value, e.low, e.high)] for e in known]).reshape(-1, 3)
        x_label = str(Say("difference from the value before [its standard deviations]"))
        names = [str(term(e.name)) for e in known]
        figure = intervals(names, shifts[:, 0], shifts[:, 1:], x_label, str(Say("parameter")))
        span(figure.axes, -NORMAL, NORMAL, str(Say("95 % before this log")))
        return legend(figure)

    def plot_prediction(self) -> Figure:
        """Measured readings, and what the calibrated robot predicts from the commands alone for half a second at a
        time; one panel for the gyro, each encoder and the compass of the first log."""
        from upright.plotting import COLOURS, legend, line, panels, span

        free = self.free[0]
        names = [name for name in free.rows if name in DRAWN] or list(free.rows)
        shown = [shown_in(DRAWN.get(name, ""), 1.0) for name in names]
        labels = [f"{channel(name)} [{unit}]" for name, (_, unit) in zip(names, shown, strict=True)]
        figure, axes = panels(labels)
        for ax, name, (factor, _) in zip(axes, names, shown, strict=True):
            t, measured, predicted = free.series(name)
            line(ax, str(Say("measured")), t, factor * measured, style=4, below=True)
            line(ax, str(Say("predicted")), t, factor * predicted, style=1, solid=True)
        if self.held_out:
            span(axes, *self.held_out, str(Say("not fitted")), COLOURS[0])
        return legend(figure)

    @property
    def held_out(self) -> tuple[float, float] | None:
        """From when to when [s] the first log was not fitted; None where all of it was, or nobody knows."""
        last = float(self.free[0].when.max(initial=-np.inf)) if self.free else -np.inf
        stop = self.robot.fitted[0].stop if self.robot.fitted else np.inf
        return (stop, last) if last - stop > HELD_OUT else None

    @property
    def which_pole(self) -> tuple[Say, ...]:
        """What `upright identify` gives instead of the unstable pole, of a robot with dry friction."""
        damped = self.robot.rolling()
        if damped is self.robot:
            return ()
        pole = Quantity(unstable_pole(damped), "1/s")
        return (
            Say("The pole is that without dry friction; `upright identify` counts it as damping: {pole}.", pole=pole),
        )

    @property
    def channels(self) -> list[str]:
        """The sensors of which half a second was predicted."""
        return [name for name in self.segments if name.startswith("sensor/")]


_READINGS = ("row", "when", "measured", "predicted", "segment")
