"""Chapter 5: both pushes on twin, nonlinear and linear model under the same regulator (figures 5 to 13)."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.atomic import finite
from upright.bodies import Body, Electronics, LinearBody, NonlinearBody
from upright.bodies.twin import Twin
from upright.comparison import Comparison, compare
from upright.comparison.runs import NEGLIGIBLE
from upright.control import Controller, Estimated, StateFeedback, kalman
from upright.experiment import Hold, run
from upright.pages import Cell, Column, Picture, Quantity, Say, Table
from upright.paper import printed
from upright.paper.claim import Claim, agreed, judged, shown_of
from upright.physics.linear import LinearModel
from upright.progress import Progress, unwatched
from upright.robots import Kit, Motor, Robot
from upright.robots.drawing import filmstrip
from upright.signals import Log

RELEASE, SECONDS = 8.0, 16.0  # [s] long enough to come to rest before the release and after it
SEEDS = (1, 2, 3, 4, 5, 6)
"""Of the twin's noise. The median of whatever such runs show lies between the least and the most of six with
1 − 2⁻⁵ = 97 %; of five with 94 % only."""

MODELS = ("nonlinear", "linear")
PUSHES = {"front": printed.FRONT_PUSH, "back": printed.BACK_PUSH}
TITLES = {"front": Say("{robot}, front"), "back": Say("{robot}, back")}
PHOTOGRAPHS = {"front": 4, "back": 11}
"""Which figure of the paper shows the robot itself under which push."""
STRIP = (4.0, 8.2, 8.6, 12.0)  # [s] of the filmstrip: held, released at 8 s, swinging over, at rest
FIGURES_AGAIN = {"front": Say("Figures 5 to 10 again"), "back": Say("Figures 12 and 13 again")}
"""The paper's figures of the states under each push."""

ALIKE = 0.8  # correlation with the twin above which two curves count as alike


@dataclass(frozen=True, eq=False)
class RegulatedRobot:
    """A robot, its regulator, and its identified linear model."""

    robot: Robot
    feedback: StateFeedback
    linear: LinearModel


@dataclass(frozen=True)
class Measured:
    """The quantities behind the paper's claims on one robot under one push, a value for each of `SEEDS`; models have
    no noise, and one value. What holds under some seeds only is None."""

    correlation: list[float]  # smallest of ψ and θ, both models, with the twin
    settling: dict[str, list[float]]  # of pitch to 5 % after the release [s]; infinite where it never does
    largest_yaw: list[float]  # [rad] over twin and models

    @property
    def alike(self) -> bool | None:
        return agreed(correlation >= ALIKE for correlation in self.correlation)

    @property
    def yaw_negligible(self) -> bool | None:
        return agreed(yaw <= NEGLIGIBLE["yaw"] for yaw in self.largest_yaw)

    @property
    def settling_differs(self) -> bool | None:
        """By more than a sample, and not by chance: every twin is later than both models, or every one earlier."""
        models = [self.settling[name][0] for name in MODELS]
        after = agreed(time > max(models) + printed.PERIOD for time in self.settling["twin"])
        before = agreed(time < min(models) - printed.PERIOD for time in self.settling["twin"])
        if after or before or max(models) - min(models) > printed.PERIOD:
            return True
        return None if None in (after, before) else False

    @property
    def linear_fastest(self) -> bool | None:
        nonlinear, linear = (self.settling[name][0] for name in MODELS)
        closer = printed.PERIOD / 2  # than half a sample is a tie
        return agreed(linear < min(time, nonlinear) - closer for time in self.settling["twin"])


CONCLUSIONS = {
    "shapes are alike": (Say("ψ and θ of robot and models are similar in shape"), "alike"),
    "settling times differ": (Say("the settling times are not equal"), "settling_differs"),
    "the linear model settles fastest": (Say("the linear model responds faster than the other two"), "linear_fastest"),
    "yaw is negligible": (Say("the differences in φ are negligible"), "yaw_negligible"),
}
"""What is tested → how the paper says it (figure 5 and section 3), and which property of `Measured` tells it."""


def chapter(trials: Sequence[RegulatedRobot], kit: Kit, progress: Progress = unwatched) -> list[Claim]:
    """One result for each robot and push, and one for the paper's claims over all of them."""
    claims: list[Claim] = []
    measured: dict[str, Measured] = {}
    for trial in trials:
        for side in PUSHES:
            progress(len(measured) / (len(trials) * len(PUSHES)))
            comparisons = push(trial, side, kit)
            name = f"{trial.robot.name}, {side} push"
            measured[name] = measure(comparisons)
            claims.append(_shown(trial, side, comparisons, measured[name], f"5{'abcd'[len(claims)]}"))
    return [*claims, _tested(measured)]


def push(trial: RegulatedRobot, side: str, kit: Kit) -> list[Comparison]:
    """The robot held at the paper's pitch and released, for each of `SEEDS`: the twin on its sensors, beside both
    models on their true states."""
    robot = trial.robot
    supply = battery_of(kit)
    bodies = {"nonlinear": NonlinearBody(robot), "linear": LinearBody(trial.linear, robot)}
    models = {name: released(Electronics(body, supply), trial.feedback, side) for name, body in bodies.items()}
    sensed = Estimated(trial.feedback, kalman(robot, kit))
    twins = [released(Electronics(Twin(robot), kit), sensed, side, seed) for seed in SEEDS]
    return [compare({"twin": twin, **models}) for twin in twins]


def released(body: Body, controller: Controller, side: str, seed: int = SEEDS[0]) -> Log:
    """A body held at the paper's pitch, and let go."""
    hold = Hold(pitch=PUSHES[side], until=RELEASE)
    return run(body, controller, hold, seconds=SECONDS, seed=seed)


def battery_of(kit: Kit) -> Kit:
    """A kit's battery and nothing else of its electronics: what models have, like the paper's simulations."""
    return replace(kit, name="battery", sensors={}, motor=Motor(), delay=0.0, jitter=0.0)


def measure(comparisons: Sequence[Comparison]) -> Measured:
    """The quantities of the paper's claims, from the same models beside twins with other noise."""
    runs = [comparison.metrics for comparison in comparisons]
    settling = {"twin": [never(metrics["twin"].settling_5) for metrics in runs]}
    settling |= {name: [never(runs[0][name].settling_5)] for name in MODELS}
    return Measured([_correlation(one) for one in comparisons], settling, [_yaw(one) for one in comparisons])


def _correlation(comparison: Comparison) -> float:
    logs = comparison.logs
    length = min(len(log) for log in logs.values())
    twin = logs["twin"]
    return min(
        float(np.corrcoef(twin[name][:length], logs[other][name][:length])[0, 1])
        for name in ("truth/pitch", "truth/wheel")
        for other in MODELS
    )


def _yaw(comparison: Comparison) -> float:
    return max(float(np.abs(log["truth/yaw"]).max()) for log in comparison.logs.values())


def never(time: float) -> float:
    """A settling time [s], infinite where there is none."""
    return math.inf if math.isnan(time) else time


def _shown(trial: RegulatedRobot, side: str, comparisons: Sequence[Comparison], measured: Measured, part: str) -> Claim:
    robot = trial.robot
    stood = agreed(not numbers.fell for one in comparisons for numbers in one.metrics.values())
    comparison = comparisons[0]
    fit = Quantity(min(fits["pitch"] for fits in comparison.fits.values()) / 100, "fraction", digits=2)
    strip = Picture(
        Say("Figure {n} again, by the twin", n=PHOTOGRAPHS[side]),
        functools.partial(filmstrip, robot, comparison.logs["twin"], STRIP),
        Say("Under each time: pitch, and how far the axle has rolled."),
    )
    _, *tables = shown_of(comparison)
    under = Say("Under {law}; yaw is not drawn where the robot does not turn.", law=trial.feedback.spec.kind)
    states = Picture(FIGURES_AGAIN[side], comparison.plot, under)
    force = Hold(pitch=PUSHES[side], until=RELEASE).force(robot)
    return Claim(
        part,
        TITLES[side].about(robot=robot.name),
        judged([stood, measured.alike]),
        Say("Pitch of both models fits the twin to {fit}.", fit=fit),
        {"force": force, "hold": PUSHES[side], **comparison.to_json()},
        [states, strip, *tables],
        {f"{robot.name}-{side}-{name}": log for name, log in comparison.logs.items()},
        result=Say("fit {fit}", fit=fit),
    )


def _tested(measured: Mapping[str, Measured]) -> Claim:
    verdicts: dict[str, bool | None] = {}
    rows: list[list[Cell]] = []
    for name, (words, quantity) in CONCLUSIONS.items():
        holds: list[bool | None] = [getattr(case, quantity) for case in measured.values()]
        verdicts[name] = False if False in holds else agreed(holds)
        rows.append([words, holds.count(True), holds.count(False), holds.count(None)])
    held = {"n": sum(map(bool, verdicts.values())), "all": len(verdicts)}
    summary = Say("{n} of {all} conclusions hold under every push.", **held)
    columns = [
        Column(Say("the paper concludes")),
        Column(Say("it holds in")),
        Column(Say("it fails in")),
        Column(Say("unknown")),
    ]
    caption = Say("Under how many pushes; unknown where {n} runs of the twin, with other noise, disagree", n=len(SEEDS))
    cases = {name: {**vars(case), "settling": plain(case.settling)} for name, case in measured.items()}
    numbers = {"seeds": list(SEEDS), "claims": verdicts, "cases": cases}
    blocks = [Table(columns, rows, caption), settling_table({name: case.settling for name, case in measured.items()})]
    result = Say("{n} of {all} hold", **held)
    return Claim("5e", Say("Conclusions"), judged(verdicts.values()), summary, numbers, blocks, result=result)


def plain(runs: Mapping[str, Sequence[float]]) -> dict[str, list[float | None]]:
    """Times or sizes of runs as JSON, without infinities."""
    return {name: [finite(value) for value in values] for name, values in runs.items()}


def settling_table(cases: Mapping[str, Mapping[str, Sequence[float]]]) -> Table:
    """Settling times [s] of the runs of each case, one for each seed; they may be infinite."""
    runs = next(iter(cases.values()))
    columns = [Column(Say("robot and push")), *(Column(Say("{name}", name=run)) for run in runs)]
    rows = [[name, *map(_between, settling.values())] for name, settling in cases.items()]
    return Table(columns, rows, Say("Pitch settles to 5 % after the release in"))


def _between(times: Sequence[float]) -> Cell:
    """The least and the most of some times [s]."""
    low, high = min(times), max(times)
    if math.isinf(low):
        return Say("never")
    if math.isinf(high):
        return Say("{time}, or never", time=Quantity(low, "s"))
    return Quantity(low, "s") if low == high else Quantity(None, "s", low=low, high=high)
