"""Beyond chapter 3: the paper's chain from log to regulator on real sensors, by five ways to the linear model."""

from __future__ import annotations

import math

from upright.errors import UprightError
from upright.identification.identify import identify_all, study_of
from upright.identification.method_comparison import MethodComparison
from upright.identification.methods import TITLES
from upright.paper.claim import BEYOND, Claim
from upright.physics.linear import unstable_pole
from upright.progress import Progress, unwatched
from upright.reports.page import Cell, Item, Table, Verdict, cell_text
from upright.robots import Kit, Robot
from upright.signals import Log
from upright.tables import joined

REPEATS = 20
"""Simulated repetitions behind each interval and bias: 20 give a standard deviation to 16 % (1/√(2·19))."""


def chapter(robot: Robot, kit: Kit, log: Log, progress: Progress = unwatched) -> Claim:
    """All identifiers on the twin's `log` of 3b, beside the truth, and the regulators designed on their models."""
    try:
        compared = identify_all(study_of(log, robot, kit, runs=REPEATS), progress=progress)
    except UprightError as error:
        return Claim("3c", TITLE, BEYOND, f"No model was identified from the twin's log: {error}", {})
    true = unstable_pole(robot.rolling())
    return Claim("3c", TITLE, BEYOND, _summary(compared, true), _numbers(compared, true), _items(compared))


TITLE = "The same sensors, other ways to the linear model"


def _summary(compared: MethodComparison, true: float) -> str:
    poles = {name: model.pole for name, model in compared.models.items()}
    inside = [name for name, pole in poles.items() if pole.low <= true <= pole.high]
    holding = [name for name, trial in compared.trials.items() if trial.holds]
    text = (
        f"The true unstable pole, {cell_text(true, 3)} 1/s, lies in the 95 % interval of {len(inside)} of "
        f"{len(poles)} methods{f': {joined(inside)}' if inside else ''}. The "
        f"regulator designed on the identified model balances the twin for {joined(holding) or 'no method'}."
    )
    least = poles.get("least-squares")
    if least is None or math.isnan(least.bias):
        return text
    return (
        f"{text} Least squares as in `upright identify`, another regression than the paper's in 3b, estimates "
        f"{cell_text(least.value, 3)} 1/s. Simulated closed-loop logs of a consistent "
        f"model show its bias: {cell_text(least.bias, 2)} ± {cell_text(2 * least.bias_error, 1)} 1/s. The corrected "
        f"estimate is {cell_text(least.corrected, 3)} 1/s."
    )


def _items(compared: MethodComparison) -> list[Item]:
    rows = [
        [name, *(model.fits["1"].get(output) for output in ("gyro", "wheel", "turn"))]
        for name, model in compared.models.items()
    ]
    one_step = Table(
        ["method", "gyro", "wheels", "turn"], rows, "One-step prediction: fit [%] on held-out data", digits=3
    )
    why = (
        "Total least squares assumes white errors that are independent of the controller, which feedback "
        "contradicts. The other three methods account for the loop: instrumental variables by signals free of noise; "
        "the subspace method and calibration by predictors with white innovations."
    )
    return [
        _poles(compared),
        _trials(compared),
        Table(["method", "how"], [[name, str(TITLES[name])] for name in compared.trials]),
        one_step,
        why,
        *(f"{n}: {w}" for n, w in compared.failed.items()),
    ]


def _poles(compared: MethodComparison) -> Table:
    rows: list[list[Cell]] = []
    for name, model in compared.models.items():
        p = model.pole
        known = f"{cell_text(p.low, 3)} to {cell_text(p.high, 3)}" if math.isfinite(p.low) else "none"
        rows.append([name, p.value, known, p.bias, p.corrected])
    rows.append(["the robot itself", compared.true_pole, "", None, None])
    header = ["method", "pole [1/s]", "95 % interval", "bias [1/s]", "pole − bias"]
    return Table(header, rows, "Unstable pole; intervals and bias from repeated logs", digits=3)


def _trials(compared: MethodComparison) -> Table:
    rows: list[list[Cell]] = []
    for name, trial in compared.trials.items():
        leans = [None if x is None else math.degrees(x) for x in (trial.largest, trial.restless)]
        rows.append([name, Verdict(str(trial.verdict.text), "good" if trial.holds else "bad"), *leans])
    header = ["method", "in the loop", "largest lean [°]", "rms at rest [°]"]
    return Table(header, rows, "Largest lean after the release, and its rms in the last two seconds", digits=3)


def _numbers(compared: MethodComparison, true: float) -> dict[str, object]:
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
