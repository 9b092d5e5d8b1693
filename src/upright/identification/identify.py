"""One log, one or all methods: `identify` gives a linear model, `identify_all` compares all methods."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from upright.errors import UprightError, check_within
from upright.identification.identified import Identified, assembled
from upright.identification.judge import Judge, judge_of, loop_trial
from upright.identification.method_comparison import MethodComparison
from upright.identification.methods import IDENTIFIERS, find_identifier
from upright.identification.prediction import prediction_fits
from upright.identification.samples import samples
from upright.identification.study import Study
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import LogSource, named, raw_log
from upright.physics.linear import unstable_pole
from upright.progress import Progress
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log

ALL = "all"
"""The method that stands for all of them."""


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
    return Identified(
        method=method, model=model, a_deviation=dA, b_deviation=dB, pole=fit.pole, halves=fit.halves,
        delays={name: n for part in data.parts for name, n in zip(part.outputs, part.delays, strict=True)},
        orders=study.orders if method == "subspace" else {}, source=data.source, samples=data.fitted,
        fits=prediction_fits(data, fit.halves),
        notes=(*data.notes, *fit.notes), log=named(data.log),
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
    orders = study.orders if {"subspace", "instrumental"} & models.keys() else {}
    return MethodComparison(
        samples=study.samples, models=models, trials=trials, failed=failed, orders=orders, judge=judge,
        true_pole=unstable_pole(judge.robot.rolling()) if judge.made_the_log else np.nan, notes=study.samples.notes,
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
