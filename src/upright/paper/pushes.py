"""Chapter 5: both pushes on twin, nonlinear and linear model under the same regulator (figures 5 to 13)."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

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
from upright.paper.claim import Claim, judged, shown_of
from upright.physics.linear import LinearModel
from upright.plotting import legend, line, panels, span
from upright.progress import Progress, unwatched
from upright.robots import Kit, Motor, Robot
from upright.robots.drawing import filmstrip
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

RELEASE, SECONDS = 8.0, 16.0  # [s] long enough to come to rest before the release and after it

MODELS = ("nonlinear", "linear")
PUSHES = {"front": printed.FRONT_PUSH, "back": printed.BACK_PUSH}
PHOTOGRAPHS = {"front": 4, "back": 11}
"""Which figure of the paper shows the robot itself under which push."""
STRIP = (4.0, 8.2, 8.6, 12.0)  # [s] of the filmstrip: held, released at 8 s, swinging over, at rest
FIGURES_AGAIN = {"front": Say("Figures 5 to 10 again"), "back": Say("Figures 12 and 13 again")}
"""The paper's figures of the states under each push."""

YAW_NEGLIGIBLE = NEGLIGIBLE["yaw"]
CONCLUSIONS = {
    "shapes are alike": Say("ψ and θ of robot and models are similar in shape"),
    "settling times differ": Say("the settling times are not equal"),
    "the linear model settles fastest": Say("the linear model responds faster than the other two"),
    "yaw is negligible": Say("the differences in φ are negligible"),
}
"""What is tested → how the paper says it (figure 5 and section 3)."""
ALIKE = 0.8  # correlation with the twin above which two curves count as alike


@dataclass(frozen=True, eq=False)
class RegulatedRobot:
    """A robot, its regulator, and its identified linear model."""

    robot: Robot
    feedback: StateFeedback
    linear: LinearModel


@dataclass(frozen=True)
class Measured:
    """The quantities behind the paper's claims, measured on one robot under one push."""

    correlation: float  # smallest of ψ and θ, both models, with the twin
    settling: dict[str, float]  # of pitch to 5 % after the release [s]; infinite where it never does
    largest_yaw: float  # [rad] over all runs

    @property
    def alike(self) -> bool:
        return self.correlation >= ALIKE

    @property
    def yaw_negligible(self) -> bool:
        return self.largest_yaw <= YAW_NEGLIGIBLE

    @property
    def settling_differs(self) -> bool:
        return max(self.settling.values()) - min(self.settling.values()) > printed.PERIOD

    @property
    def linear_fastest(self) -> bool:
        others = min(value for name, value in self.settling.items() if name != "linear")
        return self.settling["linear"] < others - printed.PERIOD / 2  # closer than half a sample is a tie


def chapter(trials: Sequence[RegulatedRobot], kit: Kit, progress: Progress = unwatched) -> list[Claim]:
    """One result for each robot and push, and one for the paper's claims over all of them."""
    claims: list[Claim] = []
    measured: dict[str, Measured] = {}
    for trial in trials:
        for side in PUSHES:
            progress(len(measured) / (len(trials) * len(PUSHES)))
            comparison = push(trial, side, kit)
            name = f"{trial.robot.name}, {side} push"
            measured[name] = measure(comparison)
            claims.append(_shown(trial, side, comparison, measured[name], f"5{'abcd'[len(claims)]}"))
    return [*claims, _tested(measured)]


def push(trial: RegulatedRobot, side: str, kit: Kit) -> Comparison:
    """The robot held at the paper's pitch and released: the twin on its sensors, both models on their true states.

    The models have the kit's battery and nothing else of its electronics, like the paper's simulations.
    """
    robot = trial.robot
    hold = Hold(pitch=PUSHES[side], until=RELEASE)
    supply = replace(kit, name="battery", sensors={}, motor=Motor(), delay=0.0, jitter=0.0)
    runs: dict[str, tuple[Body, Controller]] = {
        "twin": (Electronics(Twin(robot), kit), Estimated(trial.feedback, kalman(robot, kit))),
        "nonlinear": (Electronics(NonlinearBody(robot), supply), trial.feedback),
        "linear": (Electronics(LinearBody(trial.linear, robot), supply), trial.feedback),
    }
    logs = {name: run(body, controller, hold, seconds=SECONDS, seed=1) for name, (body, controller) in runs.items()}
    return compare(logs)


def measure(comparison: Comparison) -> Measured:
    """The quantities of the paper's claims."""
    logs = comparison.logs
    length = min(len(log) for log in logs.values())
    twin = logs["twin"]
    correlations = [
        np.corrcoef(twin[name][:length], logs[other][name][:length])[0, 1]
        for name in ("truth/pitch", "truth/wheel")
        for other in MODELS
    ]
    yaw = max(float(np.abs(log["truth/yaw"]).max()) for log in logs.values())
    times = {name: numbers.settling_5 for name, numbers in comparison.metrics.items()}
    settling = {name: math.inf if math.isnan(time) else time for name, time in times.items()}
    return Measured(float(min(correlations)), settling, yaw)


def _shown(trial: RegulatedRobot, side: str, comparison: Comparison, measured: Measured, part: str) -> Claim:
    robot = trial.robot
    stood = not any(numbers.fell for numbers in comparison.metrics.values())
    swing, band = _swing(comparison)
    settles = math.isfinite(measured.settling["twin"]) or swing < band
    fit = Quantity(min(fits["pitch"] for fits in comparison.fits.values()) / 100, "fraction", digits=2)
    summary = Say("Pitch of both models fits the twin to {fit}.", fit=fit)
    if not settles:
        summary = Say(
            "Pitch fits the twin to {fit}, but the twin keeps swinging by {swing}.",
            fit=fit,
            swing=Quantity(swing, "rad", digits=2),
        )
    twin = comparison.logs["twin"]
    strip = Picture(
        Say("Figure {n} again, by the twin", n=PHOTOGRAPHS[side]),
        functools.partial(filmstrip, robot, twin, STRIP),
        Say("Under each time: pitch, and how far the axle has rolled."),
    )
    _, *tables = shown_of(comparison)
    under = Say("Under {law}; yaw is not drawn where the robot does not turn.", law=trial.feedback.spec.kind)
    states = Picture(FIGURES_AGAIN[side], comparison.plot, under)
    force = Hold(pitch=PUSHES[side], until=RELEASE).force(robot)
    numbers = {"force": force, "hold": PUSHES[side], **comparison.to_json()}
    logs = {f"{robot.name}-{side}-{name}": log for name, log in comparison.logs.items()}
    title = Say("{robot}, front push", robot=robot.name)
    if side == "back":
        title = Say("{robot}, back push", robot=robot.name)
    return Claim(part, title, judged([stood, settles]), summary, numbers, [states, strip, *tables], logs)


def _swing(comparison: Comparison) -> tuple[float, float]:
    """Of the twin's pitch [rad]: how far it swings in the last two seconds, and the 5 % band after the release."""
    twin = comparison.logs["twin"]
    swing = float(np.abs(twin.between(SECONDS - 2.0, SECONDS)["truth/pitch"]).max())
    return swing, 0.05 * float(np.abs(twin.between(RELEASE, SECONDS)["truth/pitch"]).max())


def _tested(measured: Mapping[str, Measured]) -> Claim:
    every = measured.values()
    held = {
        "shapes are alike": sum(c.alike for c in every),
        "settling times differ": sum(c.settling_differs for c in every),
        "the linear model settles fastest": sum(c.linear_fastest for c in every),
        "yaw is negligible": sum(c.yaw_negligible for c in every),
    }
    verdicts = {claim: count == len(every) for claim, count in held.items()}
    summary = Say("{n} of {all} conclusions hold under every push.", n=sum(verdicts.values()), all=len(verdicts))
    cases = {n: {**vars(c), "settling": {r: finite(s) for r, s in c.settling.items()}} for n, c in measured.items()}
    rows = [[CONCLUSIONS[c], Say("{n} of {all} cases", n=n, all=len(every))] for c, n in held.items()]
    columns = [Column(Say("the paper concludes")), Column(Say("it holds in"))]
    title = Say("The paper's conclusions")
    numbers = {"claims": verdicts, "cases": cases}
    blocks = [Table(columns, rows), settling_table({name: case.settling for name, case in measured.items()})]
    return Claim("5e", title, judged(verdicts.values()), summary, numbers, blocks)


def settling_table(cases: Mapping[str, Mapping[str, float]]) -> Table:
    """Settling times [s] of the runs of each case, which may be infinite."""
    runs = next(iter(cases.values()))
    columns = [Column(Say("robot and push")), *(Column(Say("{run}", run=run), "s") for run in runs)]
    rows: list[list[Cell]] = []
    for name, settling in cases.items():
        rows.append([name, *(Say("never") if math.isinf(time) else time for time in settling.values())])
    return Table(columns, rows, Say("Pitch settles to 5 % after the release in"))


def draw_push(logs: Mapping[str, Log]) -> Figure:
    """Pitch of the first of the `logs`, the twin, and of its models, and below how far each model is from the twin."""
    figure, (above, below) = panels([str(Say("pitch [°]")), str(Say("model less twin [°]"))], str(Say("time [s]")))
    twin, *_ = logs.values()
    for style, (name, log) in enumerate(logs.items()):
        line(above, name, log.t, np.degrees(log["truth/pitch"]), style=style, below=log is twin)
        if log is not twin:
            n = min(len(log), len(twin))
            line(below, name, log.t[:n], np.degrees(log["truth/pitch"][:n] - twin["truth/pitch"][:n]), style=style)
    span([above, below], 0.0, RELEASE, str(Say("push acts")))
    return legend(figure)
