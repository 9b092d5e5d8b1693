"""One log, one or all methods: `identify` gives a linear model, `identify_all` compares all methods."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.atomic import finite
from upright.errors import UprightError, check_within
from upright.identification.identified import STABLE, WITH_FRICTION, Identified, assembled, interval
from upright.identification.judge import Judge, LoopTrial, judge_of, loop_trial
from upright.identification.methods import IDENTIFIERS, find_identifier
from upright.identification.order import OrderChoice
from upright.identification.prediction import prediction_fits
from upright.identification.samples import Samples, samples
from upright.identification.study import Pole, Study
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import LogSource, raw_log
from upright.physics.linear import unstable_pole
from upright.progress import Progress
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log
from upright.tables import Shown

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

ALL = "all"
"""The method that stands for all of them."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class MethodComparison(Shown):
    """The models of one log by method, the trial of each in the loop of the `judge`, and why a method has none.

    `true_pole` [1/s] is that of the twin that made the log, with dry friction as the damping with the same braking; NaN
    where it is unknown.
    """

    samples: Samples
    models: Mapping[str, Identified]
    trials: Mapping[str, LoopTrial]
    failed: Mapping[str, str]
    orders: Mapping[str, OrderChoice]
    judge: Judge
    true_pole: float
    notes: tuple[str, ...] = ()

    def check(self) -> tuple[str, ...]:
        """What is wrong with the comparison, from its own numbers."""
        return tuple(f"{name}: its halves do not make it up" for name, m in self.models.items() if m.check() > 1e-6)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        return {
            "models": {name: model.to_json() for name, model in self.models.items()},
            "in_the_loop": {name: trial.to_json() for name, trial in self.trials.items()},
            "failed": dict(self.failed), "judge": self.judge.who, "notes": list(self.notes),
            "true_pole": finite(self.true_pole),
        }  # fmt: skip

    def plot(self) -> Figure:
        """The unstable pole of each method with its 95 % interval, in a colour that says whether its regulator holds
        the robot, and the true pole where it is known."""
        from upright.plotting import AXIS, COLOURS, legend, rows_of

        figure, ax = rows_of(list(self.models), "unstable pole [1/s]", "method")
        if math.isfinite(self.true_pole):
            ax.axvline(self.true_pole, linestyle="--", linewidth=1, color=AXIS, label="true pole", zorder=1)
        for name, holds, colour in (("holds the robot", True, COLOURS[2]), ("does not", False, COLOURS[1])):
            rows = [k for k, n in enumerate(self.models) if (n not in self.trials or self.trials[n].holds) == holds]
            poles = [m.pole for k, m in enumerate(self.models.values()) if k in rows]
            ax.hlines(rows, [p.low for p in poles], [p.high for p in poles], linewidth=2.5, color=colour)
            mark = "o" if holds else "x"
            ax.plot([p.value for p in poles], rows, mark, markersize=5, color=colour, label=f"its regulator {name}")
        _beside(ax, [m.pole for m in self.models.values()])
        return legend(figure)

    def __str__(self) -> str:
        lines = [f"{len(self.samples.log)} samples; unstable poles, {WITH_FRICTION}; judged by {self.judge.who}"]
        for name, m in self.models.items():
            lines.append(f"  {name:<20} {m.pole.value:8.3g} 1/s {interval(m.pole):<18} {self.trials[name]}")
            lines += [f"  {'':<20} {free}" for free in (m.pole.in_words(),) if free]
        return "\n".join([*lines, *(f"  {name:<20} {why}" for name, why in self.failed.items()), *self.notes])


def _beside(ax: Axes, poles: Sequence[Pole]) -> None:
    """The numbers of each interval in a column on the right, since a short one hides under its mark."""
    from upright.plotting import BESIDE, WIDTH

    box = ax.get_position()
    left, above = ax.yaxis.label.get_position()
    ax.set_position((box.x0, box.y0, box.width - COLUMN / WIDTH, box.height))
    ax.yaxis.set_label_coords(left * box.width / ax.get_position().width, above)
    for row, p in enumerate(poles):
        if math.isfinite(p.high):
            text = f"{p.low:.3g} to {p.high:.3g}".replace("-", "−")
            beside = ax.annotate(text, (1, row), (8, 0), xycoords=ax.get_yaxis_transform(), textcoords="offset points",
                                 va="center")  # fmt: skip
            beside.set_gid(BESIDE)


COLUMN = 1.2  # [inches] for the numbers of an interval


ELSE = "`upright calibrate` knows dead times, dry friction and the limits of motors, which no linear model has."
OF_NOISE = (
    "The interval holds the scatter of noise. Dry friction and dead zones are in no linear model, and may move the "
    "pole further: `upright calibrate` knows them."
)


def identify(
    log: LogSource, robot: Robot | str, kit: Kit | str | None = None, *, method: str = "subspace",
    mapping: Columns | str | None = None, source: str = "sensors", delay: float | None = None,
    order: int | None = None, held_out: float = 0.25, runs: int = 40, seed: int = 0, progress: Progress | None = None,
) -> Identified | MethodComparison:  # fmt: skip
    """The linear model of a log of `robot` by one `method`, or with "all" a comparison of every method.

    The log may be a file, which `mapping` reads; robot and kit may be names or files. See `study_of` for the others.
    Raises `UnknownName`, `InvalidLog` or `InvalidModel`.
    """
    study = study_of(
        raw_log(log, mapping), find_robot(robot), find_kit(kit) if kit else None, source=source, delay=delay,
        order=order, held_out=held_out, runs=runs, seed=seed,
    )  # fmt: skip
    return identify_all(study, progress=progress) if method == ALL else identify_one(study, method)


def identify_one(study: Study, method: str) -> Identified:
    """The linear model of a study's log by one method; raises `UnknownName`, `InvalidLog` or `InvalidModel`."""
    data = study.samples
    fit = find_identifier(method)(study)
    model, dA, dB = assembled(fit.halves, fit.deviations)
    stable = (f"This is {STABLE}. {ELSE}",)
    of_noise = (OF_NOISE,) if data.source == "sensors" and method != "calibrate" and np.isfinite(fit.pole.low) else ()
    return Identified(
        method=method, model=model, a_deviation=dA, b_deviation=dB, pole=fit.pole, halves=fit.halves,
        delays={name: n for part in data.parts for name, n in zip(part.outputs, part.delays, strict=True)},
        orders=study.orders if method == "subspace" else {}, source=data.source, samples=data.fitted,
        fits=prediction_fits(data, fit.halves),
        notes=(*data.notes, *fit.notes, *(stable if fit.pole.value <= 0 else of_noise)),
    )  # fmt: skip


def identify_all(
    study: Study, methods: Sequence[str] = tuple(IDENTIFIERS), progress: Progress | None = None
) -> MethodComparison:
    """Every method on one log, each judged in the loop; a method without a model gets its reason in `failed`."""
    models: dict[str, Identified] = {}
    failed: dict[str, str] = {}
    for done, method in enumerate(methods):
        try:
            models[method] = identify_one(study, method)
        except UprightError as error:
            failed[method] = str(error)
        if progress:
            progress(0.8 * (done + 1) / len(methods))
    judge = _judge(study)
    trials = {name: loop_trial(study.samples, model.halves, judge) for name, model in models.items()}
    if progress:
        progress(1.0)
    common = study.samples.notes
    own = [f"{name}: {note}" for name, model in models.items() for note in model.notes if note not in common]
    orders = study.orders if {"subspace", "instrumental"} & models.keys() else {}
    return MethodComparison(
        samples=study.samples, models=models, trials=trials, failed=failed, orders=orders, judge=judge,
        true_pole=unstable_pole(judge.robot.rolling()) if judge.made_the_log else np.nan, notes=(*common, *own),
    )  # fmt: skip


def _judge(study: Study) -> Judge:
    """The twin of the log, or its calibration where there is no twin."""
    first = judge_of(study.samples)
    if first.made_the_log:
        return first
    try:
        return judge_of(study.samples, study.calibration)
    except UprightError:
        return first


def study_of(
    log: Log, robot: Robot, kit: Kit | None = None, *, source: str = "sensors", delay: float | None = None,
    order: int | None = None, held_out: float = 0.25, runs: int = 40, seed: int = 0,
) -> Study:  # fmt: skip
    """A log of `robot` made ready for any method: see `samples` for `source` and `delay`, `choose_order` for `order`.

    `runs` is the number of repeated logs behind the intervals.
    """
    check_within("repeated logs", runs, 0, 10_000)
    ready = samples(log, robot, kit, source=source, delay=delay, held_out=held_out)
    return Study(ready, order, runs, seed)
