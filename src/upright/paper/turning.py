"""Chapter 2: terms missing from the published model, with MuJoCo as the reference.

The published equations put the rolling constraint into the Lagrangian before differentiating, which a non-holonomic
constraint does not allow, and take the body's roll inertia for its yaw inertia. Both matter only to a robot that turns.
"""

from __future__ import annotations

import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.bodies import Body, NonlinearBody
from upright.bodies.twin import Twin
from upright.comparison import rms
from upright.control import StateFeedback, lqr_state
from upright.experiment import Drive, Turn, run
from upright.pages import Column, Picture, Quantity, Say, Table
from upright.paper.claim import BEYOND, Claim
from upright.physics.dynamics import accelerations, mass_matrix, motor_damping, motor_gain, turn_ratio
from upright.plotting import legend, line, panels
from upright.progress import Progress, unwatched
from upright.robots import Robot
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure


RATES = (1.0, 3.0, 6.0)  # [rad/s] of yaw
SHOWN = 3.0  # [rad/s] the rate that is drawn, and at which the contact is stiffened
WHEEL_RATE = 4.3  # [rad/s] driving forward meanwhile
SECONDS = 3.0
JOLT = 0.1  # [s] the start from rest is a jolt of a few milliseconds, whose torques would dwarf all others
PERIOD = 0.001  # [s] a fast loop, so that the models alone differ and not how long a command is held
CONTACTS = (0.001, 0.0005, 0.00025)  # [s] contact times of the twin, its own step half of each
JUDGED = ("pitch", "wheel_rate")
MODELS = ("complete", "published")


@dataclass(frozen=True, eq=False)
class Terms:
    """The terms of one equation along a run, each (n,) in N m, on one side, so that they add up to zero: those that the
    published model keeps, and those that it leaves out, by their formulas."""

    kept: Sequence[Array]
    left_out: Mapping[str, Array]

    def fractions(self) -> dict[str, float]:
        """The RMS of each term left out over that of the largest one kept."""
        largest = max(map(rms, self.kept))
        return {text: rms(values) / largest for text, values in self.left_out.items()}


@dataclass(frozen=True)
class Deviation:
    """A model's difference from the twin in one state: RMS and largest, relative to the twin's peak."""

    rms: float
    largest: float


def chapter(progress: Progress = unwatched) -> list[Claim]:
    """The size of the terms left out at each yaw rate, and both models against the twin."""
    robot = Robot.preset("nxtway-gs")
    feedback = lqr_state(robot, PERIOD)
    logs: dict[float, dict[str, Log]] = {}
    for rate in RATES:
        logs[rate] = {name: drive(body, feedback, rate) for name, body in bodies(robot).items()}
        progress(len(logs) / (len(RATES) + 1))
    twins = {contact: Twin(robot, PERIOD, contact_time=contact, timestep=contact / 2) for contact in CONTACTS}
    stiffened = {contact: drive(twin, feedback, SHOWN) for contact, twin in twins.items()}
    progress(1.0)
    return [_sizes(robot, logs), _judged(logs, stiffened)]


def bodies(robot: Robot) -> dict[str, Body]:
    """The twin, both models, and the complete one without a separate roll inertia: the effect of rolling alone."""
    return {
        "twin": Twin(robot, PERIOD),
        "complete": NonlinearBody(robot, "complete", PERIOD),
        "complete, J_ρ = J_φ": NonlinearBody(robot.replace(roll_inertia=robot.yaw_inertia), "complete", PERIOD),
        "published": NonlinearBody(robot, "published", PERIOD),
    }


def drive(body: Body, feedback: StateFeedback, rate: float) -> Log:
    """`body` from rest under `feedback`; the reference is `WHEEL_RATE` forward and yaw at `rate` [rad/s]."""
    reference = [Drive(speed=WHEEL_RATE * body.spec.robot.wheel_radius), Turn(rate=rate)]
    return run(body, feedback, reference=reference, seconds=SECONDS)


def terms(robot: Robot, log: Log) -> dict[str, Terms]:
    """The terms of the equations of θ, ψ and φ of the complete model along `log`, from `JOLT` on. A motor's voltage and
    back-EMF nearly cancel, so that their net torque is one term. Friction of the floor and dry friction are not among
    them; NXTway-GS has none."""
    log = log.between(JOLT, SECONDS)
    x = log.state().T
    u = np.array([log["applied/left"], log["applied/right"]])
    pitch, pitch_rate, _, wheel_rate, _, yaw_rate = x
    sin, cos = np.sin(pitch), np.cos(pitch)
    a11, a12, a22, a33 = mass_matrix(cos, sin, robot, "published")
    pitch_acc, wheel_acc, yaw_acc = accelerations(list(x), list(u), robot, xp=np)
    alpha, beta = motor_gain(robot), motor_damping(robot)
    lever = robot.body_mass * robot.com_height * robot.wheel_radius
    point = robot.body_mass * robot.com_height**2
    half = turn_ratio(robot)
    roll = robot.roll_inertia - robot.yaw_inertia
    motors = alpha * (u[0] + u[1]) - 2 * beta * (wheel_rate - pitch_rate)
    turning = half * alpha * (u[1] - u[0]) - 2 * half**2 * beta * yaw_rate
    weight = robot.body_mass * robot.gravity * robot.com_height * sin
    centrifugal = point * yaw_rate**2 * sin * cos
    coriolis = 2 * point * pitch_rate * yaw_rate * sin * cos
    return {
        "θ": Terms(
            [a11 * wheel_acc, a12 * pitch_acc, -lever * pitch_rate**2 * sin, -motors],
            {"M L R φ̇² sin ψ": -lever * yaw_rate**2 * sin},
        ),
        "ψ": Terms(
            [a12 * wheel_acc, a22 * pitch_acc, -weight, -centrifugal, motors],
            {"(J_ρ − J_φ) φ̇² sin ψ cos ψ": -roll * yaw_rate**2 * sin * cos},
        ),
        "φ": Terms(
            [a33 * yaw_acc, coriolis, -turning],
            {
                "M L R φ̇ θ̇ sin ψ": lever * yaw_rate * wheel_rate * sin,
                "(J_ρ − J_φ) sin² ψ φ̈": roll * sin**2 * yaw_acc,
                "2 (J_ρ − J_φ) ψ̇ φ̇ sin ψ cos ψ": 2 * roll * pitch_rate * yaw_rate * sin * cos,
            },
        ),
    }


def deviation(log: Log, twin: Log, state: str) -> Deviation:
    """The difference of `log` from the twin's in one state."""
    difference = np.abs(log[f"truth/{state}"] - twin[f"truth/{state}"])
    peak = float(np.abs(twin[f"truth/{state}"]).max())
    return Deviation(rms(difference) / peak, float(difference.max() / peak))


def _sizes(robot: Robot, logs: Mapping[float, Mapping[str, Log]]) -> Claim:
    left_out: dict[str, dict[float, float]] = {}
    for rate, runs in logs.items():
        for equation in terms(robot, runs["complete"]).values():
            for text, fraction in equation.fractions().items():
                left_out.setdefault(text, {})[rate] = fraction
    size = Quantity(max(of[SHOWN] for of in left_out.values()), "fraction", digits=2)
    summary = Say(
        "Turning at {rate}, one left-out term has {size} of the largest kept one.", rate=_rate(SHOWN), size=size
    )
    rows = [[text, *of.values()] for text, of in left_out.items()]
    columns = [
        Column(Say("left-out term")),
        *(Column(Say("{rate}", rate=_rate(rate)), "fraction") for rate in RATES),
    ]
    caption = Say("RMS over that of the largest kept term, by the rate of turning")
    fractions = {text: {f"{rate:g}": value for rate, value in of.items()} for text, of in left_out.items()}
    numbers = {"share_of_largest_kept_term": fractions}
    return Claim("2a", Say("Terms left out by the paper"), BEYOND, summary, numbers, [Table(columns, rows, caption)])


def _judged(logs: Mapping[float, Mapping[str, Log]], stiffened: Mapping[float, Log]) -> Claim:
    errors = {
        rate: {
            name: {state: deviation(log, runs["twin"], state) for state in JUDGED}
            for name, log in runs.items()
            if name != "twin"
        }
        for rate, runs in logs.items()
    }
    limits = {
        contact: {name: deviation(logs[SHOWN][name], twin, "pitch").rms for name in MODELS}
        for contact, twin in stiffened.items()
    }
    complete, published = (Quantity(errors[SHOWN][name]["pitch"].rms, "fraction", digits=2) for name in MODELS)
    summary = Say(
        "Turning at {rate}, the complete model differs from MuJoCo by {complete}, the published by {published}.",
        rate=_rate(SHOWN),
        complete=complete,
        published=published,
    )
    numbers = {
        "off_the_twin": {
            f"{rate:g}": {name: {state: vars(o) for state, o in of.items()} for name, of in models.items()}
            for rate, models in errors.items()
        },
        "pitch_rms_by_contact_time": {f"{contact:g}": of for contact, of in limits.items()},
    }
    claim = Say("The published model's error grows with the rate of turning; the complete model follows")
    blocks = [Picture(claim, functools.partial(_draw, logs))]
    saved = {f"turning-{name}": log for name, log in logs[SHOWN].items() if name in ("twin", *MODELS)}
    return Claim("2b", Say("MuJoCo beside both models"), BEYOND, summary, numbers, blocks, saved)


def _draw(logs: Mapping[float, Mapping[str, Log]]) -> Figure:
    labels = [str(Say("model less twin at {rate} [°]", rate=_rate(rate))) for rate in logs]
    figure, axes = panels(labels, str(Say("time [s]")))
    for ax, runs in zip(axes, logs.values(), strict=True):
        twin = runs["twin"]["truth/pitch"]
        for style, name in enumerate(MODELS, start=1):
            line(ax, name, runs[name].t, np.degrees(runs[name]["truth/pitch"] - twin), style=style)
    return legend(figure)


def _rate(rate: float) -> Quantity:
    return Quantity(rate, "rad/s")
