"""Beyond chapter 3: the paper's chain from log to regulator on real sensors, by five ways to the linear model."""

from __future__ import annotations

import math

from upright.control.delay import rolling
from upright.errors import UprightError
from upright.identify.identify import Comparison, identify_all, study_of
from upright.paper.finding import BEYOND, Finding, Progress, silent
from upright.physics.linear import unstable_pole
from upright.report.identification import pole_table, trial_table
from upright.report.page import Item, Table, cell_text
from upright.robots import Kit, Robot
from upright.signals import Log

REPEATS = 20
"""Repeated logs behind intervals and biases: their scatter is known to a sixth, which a page needs no better."""


def chapter(robot: Robot, kit: Kit, log: Log, progress: Progress = silent) -> Finding:
    """All identifiers on the twin's `log` of 3b, beside the truth, and the regulators designed on their models."""
    try:
        compared = identify_all(study_of(log, robot, kit, runs=REPEATS), progress=progress)
    except UprightError as error:
        return Finding("3c", TITLE, BEYOND, f"No model comes of the twin's log: {error}", {})
    true = unstable_pole(rolling(robot))
    return Finding("3c", TITLE, BEYOND, _summary(compared, true), _numbers(compared, true), _items(compared))


TITLE = "The same sensors, other ways to the linear model"


def _summary(compared: Comparison, true: float) -> str:
    poles = {name: model.pole for name, model in compared.models.items()}
    inside = [name for name, pole in poles.items() if pole.low <= true <= pole.high]
    holding = [name for name, trial in compared.trials.items() if trial.holds]
    said = (
        f"The robot falls at {cell_text(true, 3)} 1/s, which lies in the 95 % interval of {_listed(inside)}; a "
        f"regulator designed on the model holds the twin for {_listed(holding)}."
    )
    least = poles.get("least-squares")
    if least is None or math.isnan(least.bias):
        return said
    return (
        f"{said} Least squares says {cell_text(least.value, 3)} 1/s; logs repeated in the loop of a consistent model "
        f"show a bias of {cell_text(least.bias, 2)} ± {cell_text(2 * least.bias_error, 1)} 1/s, without which it would "
        f"say {cell_text(least.corrected, 3)} 1/s."
    )


def _listed(names: list[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else "".join(names) or "no method"


def _items(compared: Comparison) -> list[Item]:
    rows = [
        [name, *(model.fits["1"].get(output) for output in ("gyro", "wheel", "turn"))]
        for name, model in compared.models.items()
    ]
    one_step = Table(
        ["method", "gyro", "wheels", "turn"], rows, "One step ahead, fit [%] on what was held out", digits=3
    )
    why = (
        "Total least squares takes errors in the states for white and unknown to the controller, which feedback makes "
        "untrue. Instruments, the subspace method and calibration make allowance for the loop: the first by signals "
        "that no noise has moved, the others by predictors whose errors are new to everything before them."
    )
    return [
        pole_table(compared),
        trial_table(compared),
        one_step,
        why,
        *(f"{n}: {w}" for n, w in compared.failed.items()),
    ]


def _numbers(compared: Comparison, true: float) -> dict[str, object]:
    return {
        "true_unstable_pole": true,
        "poles": {name: model.pole.to_json() for name, model in compared.models.items()},
        "holds": {name: trial.holds for name, trial in compared.trials.items()},
        "one_step": {
            name: {output: value if math.isfinite(value) else None for output, value in model.fits["1"].items()}
            for name, model in compared.models.items()
        },
        "failed": dict(compared.failed),
    }
