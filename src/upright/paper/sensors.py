"""Beyond chapter 3: the paper's chain from log to regulator on real sensors, by five ways to the linear model."""

from __future__ import annotations

from upright.atomic import finite
from upright.identification.identify import identify_all, study_of
from upright.identification.method_comparison import MethodComparison
from upright.pages import Quantity, Say
from upright.paper.claim import BEYOND, Claim, shown_of
from upright.physics.linear import unstable_pole
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot
from upright.signals import Log

REPEATS = 20
"""Simulated repetitions behind each interval and bias: 20 give a standard deviation to 16 % (1/√(2·19))."""


def chapter(robot: Robot, kit: Kit, log: Log, progress: Progress = unwatched) -> Claim:
    """All identifiers on the twin's `log` of 3b, beside the truth, and the regulators designed on their models."""
    compared = identify_all(study_of(log, robot, kit, runs=REPEATS), progress=progress)
    true = unstable_pole(robot.rolling())
    poles = [model.pole for model in compared.models.values()]
    summary = Say(
        "{holding} of {n} methods give a regulator that holds the robot; {inside} have the true pole, {true}.",
        holding=len(compared.holding),
        n=len(poles),
        inside=sum(pole.low <= true <= pole.high for pole in poles),
        true=Quantity(true, "1/s"),
    )
    title = Say("Other ways to the linear model")
    return Claim("3c", title, BEYOND, summary, _numbers(compared, true), shown_of(compared))


def _numbers(compared: MethodComparison, true: float) -> dict[str, object]:
    return {
        "true_unstable_pole": true,
        "poles": {name: model.pole.to_json() for name, model in compared.models.items()},
        "holds": {name: trial.holds for name, trial in compared.trials.items()},
        "one_step": {
            name: {output: finite(value) for output, value in model.fits["1"].items()}
            for name, model in compared.models.items()
        },
        "failed": dict(compared.failed),
    }
