"""A mass that the log of a robot leaves open, and robots at both of its ends."""

from __future__ import annotations

from dataclasses import dataclass, replace

from upright.certify.actual import as_logged
from upright.certify.checks import TrialSetup, trials
from upright.certify.support import Support
from upright.errors import InvalidRobot
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log


@dataclass(frozen=True, eq=False)
class MassOpen:
    """The robot, its kit and the posterior of a calibration that takes the body's `mass` for a guess. The interval of
    that reaches from the lightest to the heaviest that any estimate leaves open."""

    robot: Robot
    kit: Kit
    uncertainty: Uncertainty
    mass: Support


def tried_at_both_ends(log: Log, setup: TrialSetup, left: MassOpen) -> tuple[Support, ...]:
    """The mass with how many robots fell that have its lightest and its heaviest body in equal parts, and every other
    number as the log has it beside such a body. Nothing where no robot can have these.

    It stands for what the calibration of the stated mass contradicts: this one contradicts nothing of the robot's file,
    and where few readings count, the posterior is as wide as they leave it.
    """
    half = (len(setup.robots) + 1) // 2
    try:
        ends = [
            robot
            for value in (left.mass.low, left.mass.high)
            for robot in draw(left.robot, half, setup.seed, left.uncertainty.given("body_mass", value))
        ]
        within = draw(left.robot, len(setup.robots), setup.seed, left.uncertainty)
    except InvalidRobot:
        return ()
    met, _, _ = as_logged(log, replace(setup, robot=left.robot, robots=within, kit=left.kit))
    _, fallen, _ = trials(replace(met, robots=ends))
    return (replace(left.mass, tried=(int(fallen.sum()), len(ends))),)
