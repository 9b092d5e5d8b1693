"""Chapter 5: both pushes on twin, nonlinear and linear model under the same regulator (figures 5 to 13)."""

from __future__ import annotations

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
from upright.paper import printed
from upright.paper.claim import Claim, judged
from upright.physics.linear import LinearModel
from upright.plotting import legend, line, panels
from upright.progress import Progress, unwatched
from upright.reports import Figure, Table
from upright.reports.page import Cell, cell_text
from upright.reports.robot import filmstrip
from upright.reports.states import fit_table, metrics_table, state_figure
from upright.robots import Kit, Motor, Robot
from upright.tables import sentence

RELEASE, SECONDS = 8.0, 16.0  # [s] long enough to come to rest before the release and after it

PUSHES = {"front": printed.FRONT_PUSH, "back": printed.BACK_PUSH}
FIGURES = {
    "front": {"pitch": 5, "pitch_rate": 6, "wheel": 7, "wheel_rate": 8, "yaw": 9, "yaw_rate": 10},
    "back": {"pitch": 12, "wheel": 13},
}
"""Which figure of the paper shows which state under which push."""
PHOTOGRAPHS = {"front": 4, "back": 11}
"""Which figure of the paper shows the robot itself under which push."""
STRIP = (4.0, 8.2, 8.6, 12.0)  # [s] of the filmstrip: held, released at 8 s, swinging over, at rest
NAMED = {"front": "figures 5 to 10", "back": "figures 12 and 13"}

YAW_NEGLIGIBLE = NEGLIGIBLE["yaw"]
CONCLUSIONS = {
    "shapes are alike": "ψ and θ of robot and models are similar in shape",
    "settling times differ": "the settling times are not equal",
    "the linear model settles fastest": "the linear model responds faster than the other two",
    "yaw is negligible": "the differences in φ are negligible",
}
"""What is tested → how the paper says it (figure 5 and section 3)."""
ALIKE = 0.8  # correlation with the twin above which two curves count as alike


@dataclass(frozen=True, eq=False)
class RegulatedRobot:
    """A robot, its regulator, and its identified linear model; `why` explains the choice of regulator."""

    robot: Robot
    feedback: StateFeedback
    linear: LinearModel
    why: str


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

    @property
    def linear_ties(self) -> bool:
        """Whether linear and nonlinear model settle at once, to half a sample."""
        return abs(self.settling["linear"] - self.settling["nonlinear"]) <= printed.PERIOD / 2


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
        for other in ("nonlinear", "linear")
    ]
    yaw = max(float(np.abs(log["truth/yaw"]).max()) for log in logs.values())
    times = {name: numbers.settling_5 for name, numbers in comparison.metrics.items()}
    settling = {name: math.inf if math.isnan(time) else time for name, time in times.items()}
    return Measured(float(min(correlations)), settling, yaw)


def _shown(trial: RegulatedRobot, side: str, comparison: Comparison, measured: Measured, part: str) -> Claim:
    robot = trial.robot
    stood = not any(numbers.fell for numbers in comparison.metrics.values())
    force = Hold(pitch=PUSHES[side], until=RELEASE).force(robot)
    fits, rates = ({n: cell_text(f[state], 2) for n, f in comparison.fits.items()} for state in ("pitch", "pitch_rate"))
    why = _why_long(comparison, measured)
    both = f"Pitch of both models fits the twin to {fits['linear']} %"
    if fits["nonlinear"] != fits["linear"]:
        both = f"Pitch fits the twin to {fits['nonlinear']} % (nonlinear) and {fits['linear']} % (linear)"
    summary = (
        f"{both}, and settles to 5 % after the release: {_times(measured.settling)}. Held at "
        f"{cell_text(PUSHES[side])} rad by {cell_text(force, 2)} N at the centre of mass, then released.{why} "
        f"Pitch rate, where noise lowers the fit, fits to {rates['nonlinear']} and {rates['linear']} %. {trial.why}"
    )
    figures = _figures(comparison, measured, FIGURES[side])
    strip = Figure(
        f"Figure {PHOTOGRAPHS[side]} again, by the twin", filmstrip(robot, comparison.logs["twin"], STRIP),
        "Under each time: pitch, and how far the axle has rolled.",
    )  # fmt: skip
    title = f"{robot.name}: force on the {side}, {NAMED[side]}"
    items = [*figures[:1], strip, metrics_table(comparison), _restless(comparison), _fits(comparison, measured)]
    items += figures[1:]
    numbers = {"force": force, "hold": PUSHES[side], **comparison.to_json()}
    logs = {f"{robot.name}-{side}-{name}": log for name, log in comparison.logs.items()}
    verdict = judged([stood])
    swing, band = (cell_text(math.degrees(value), 2) for value in _swing(comparison))
    aside = f"the curves agree, but the twin keeps swinging by {swing}°, beyond the 5 % band of {band}°" if why else ""
    return Claim(part, title, verdict, summary, numbers, items, logs, aside=aside)


def _why_long(comparison: Comparison, measured: Measured) -> str:
    """Why the twin has no settling time, where its swing at rest leaves the band."""
    swing, band = _swing(comparison)
    if math.isfinite(measured.settling["twin"]) or swing < band:
        return ""
    return (
        f" The twin's swing at rest, up to {cell_text(1000 * swing, 2)} mrad, is wider than the band of "
        f"{cell_text(1000 * band, 2)} mrad; the models have no such swing."
    )


def _swing(comparison: Comparison) -> tuple[float, float]:
    """Of the twin's pitch [rad]: how far it swings in the last two seconds, and the 5 % band after the release."""
    twin = comparison.logs["twin"]
    swing = float(np.abs(twin.between(SECONDS - 2.0, SECONDS)["truth/pitch"]).max())
    return swing, 0.05 * float(np.abs(twin.between(RELEASE, SECONDS)["truth/pitch"]).max())


def _restless(comparison: Comparison) -> str:
    """The twin's residual oscillation, which affects its settling time as much as its dynamics do."""
    swing, band = _swing(comparison)
    outside = "wider" if swing > band else "narrower"
    return (
        "The twin never settles completely. Encoder and driver resolution, the motors' dead zone and gyro noise keep "
        f"its pitch oscillating. In the last 2 s it swings by up to {cell_text(1000 * swing, 2)} mrad, {outside} than "
        f"the 5 % band ({cell_text(1000 * band, 2)} mrad). The models have none of these: their poles alone set the "
        "settling time."
    )


def _fits(comparison: Comparison, measured: Measured) -> Table:
    """The fits; those of yaw only where the robot turns."""
    table = fit_table(comparison)
    kept = [k for k, name in enumerate(table.header) if not (measured.yaw_negligible and name.startswith("yaw"))]
    return replace(table, header=[table.header[k] for k in kept], rows=[[row[k] for k in kept] for row in table.rows])


def _figures(comparison: Comparison, measured: Measured, numbers: Mapping[str, int]) -> list[Figure]:
    """The paper's figures by their numbers; where the robot does not turn, a small one for yaw and its rate."""
    still = [state for state in ("yaw", "yaw_rate") if state in numbers and measured.yaw_negligible]
    figures = [
        replace(drawn, title=f"Figure {number} again. {drawn.title}")
        for state, number in numbers.items() if state not in still
        for drawn in [state_figure(comparison, state)]
    ]  # fmt: skip
    if not still:
        return figures
    drawing, (ax,) = panels(["yaw [°]"], height=0.6)
    for name, log in comparison.logs.items():
        line(ax, name, log.t, np.degrees(log["truth/yaw"]))
    ax.set_ylim(-1, 1)
    degrees = cell_text(math.degrees(measured.largest_yaw), 2)
    named = " and ".join(str(numbers[s]) for s in still)
    title = f"Figures {named} again. Yaw is at most {degrees}°, where the compass reads whole degrees"
    return [*figures, Figure(title, legend(drawing))]


def _tested(measured: dict[str, Measured]) -> Claim:
    every = list(measured.values())
    held = {
        "shapes are alike": sum(c.alike for c in every),
        "settling times differ": sum(c.settling_differs for c in every),
        "the linear model settles fastest": sum(c.linear_fastest for c in every),
        "yaw is negligible": sum(c.yaw_negligible for c in every),
    }
    verdicts = {claim: count == len(every) for claim, count in held.items()}
    apart = f" (by more than a sample, {cell_text(printed.PERIOD)} s)"
    text = "; ".join(
        f"“{claim}”{apart if 'differ' in claim else ''} holds in "
        + ("all" if count == len(every) else f"{count or 'none'} of {len(every)} cases")
        + (" (it ties with the nonlinear one)" if "fastest" in claim and all(c.linear_ties for c in every) else "")
        for claim, count in sorted(held.items(), key=lambda item: item[1])
    )
    summary = (
        f"{sentence(text)} A case is one robot under one push; a claim holds where it does in every case. A twin that "
        f"never settles counts as later than its models."
    )
    cases = {n: {**vars(c), "settling": {r: finite(s) for r, s in c.settling.items()}} for n, c in measured.items()}
    numbers = {"claims": verdicts, "cases": cases}
    count = sum(verdicts.values())
    holding = f"{count} of {len(verdicts)} conclusions hold in every case" if count < len(verdicts) else ""
    compared: list[list[Cell]] = [[CONCLUSIONS[c], f"in {n} of {len(every)} cases"] for c, n in held.items()]
    caption = "The paper's conclusions beside these runs; it prints curves, and no settling time as a number"
    items = [Table(["the paper", "here"], compared, caption), *_claim_tables(measured)]
    title = "The paper's conclusions, tested"
    return Claim("5e", title, judged(verdicts.values()), summary, numbers, items, aside=holding)


def _claim_tables(measured: dict[str, Measured]) -> list[Table]:
    settling: list[list[Cell]] = [
        [name, *("never" if math.isinf(s) else s for s in c.settling.values()), c.linear_fastest]
        for name, c in measured.items()
    ]
    shapes: list[list[Cell]] = [
        [name, c.correlation, c.alike, math.degrees(c.largest_yaw), c.yaw_negligible] for name, c in measured.items()
    ]
    runs = [f"{name} [s]" for name in next(iter(measured.values())).settling]
    caption = f"Smallest correlation with the twin ({ALIKE:g} and more counts as alike), and largest yaw"
    return [
        Table(["robot and push", *runs, "linear fastest"], settling, "Pitch settles to 5 % after the release", 3),
        Table(["robot and push", "correlation", "alike", "yaw [°]", "negligible"], shapes, caption, digits=3),
    ]


def _times(settling: dict[str, float]) -> str:
    return ", ".join(f"{name} {'never' if math.isinf(s) else f'{s:.2f} s'}" for name, s in settling.items())
