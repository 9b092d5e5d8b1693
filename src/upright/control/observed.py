"""Any state feedback on raw sensors: the Kalman filter of the delayed robot, then the state when the command arrives.

A command sent at t reaches the motors at t + τ. The state at that moment follows from x̂ of the filter and the commands
on their way. Then u = u_r − K (x̂(t + τ) − x_r) has the poles of A − B K, as without dead time, and those of the filter
(Artstein 1982). The filter handles sensor delays: delayed readings are among its states.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from upright.arrays import Array
from upright.control.controller import Controller
from upright.control.delay import sampled
from upright.control.design import Design
from upright.control.feedback import StateFeedback
from upright.control.kalman import RECOVERED, Disturbed, Filter, kalman_filter
from upright.control.linear_controller import LinearController
from upright.control.observer import output_feedback
from upright.errors import InvalidController, SpecMismatch
from upright.pages import Say
from upright.reading import read_json, understood
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES


@dataclass(frozen=True, eq=False)
class Observed(Design):
    """A `feedback` behind a `filter`."""

    filter: Filter
    feedback: StateFeedback

    def check(self) -> float:
        """The larger of the residuals of both."""
        return max(self.filter.check(), self.feedback.check())

    @property
    def gain(self) -> Array:
        """That of the feedback."""
        return self.feedback.gain

    def words(self) -> Sequence[Say | str]:
        """Those of the feedback."""
        return self.feedback.words()


def observed(
    feedback: StateFeedback,
    robot: Robot,
    kit: Kit,
    *,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed = RECOVERED,
) -> LinearController:
    """`feedback` of the true state, designed without dead time, for `robot` on the sensors of `kit`.

    Raises `SpecMismatch` for a sensor the kit does not have, a state that no reading shows, or a command in another
    unit than the robot's, `DesignFailed` where no filter exists.
    """
    if feedback.command_unit != robot.command_unit:
        raise SpecMismatch(
            f"the {feedback.kind} commands {feedback.command_unit}", expected=f"{robot.command_unit}, as '{robot.name}'"
        )
    model = sampled(robot, kit, feedback.period, reads)
    blind = [name for name in model.hidden if feedback.gain[:, STATE_NAMES.index(name)].any()]
    if blind:
        raise SpecMismatch(
            f"the {feedback.kind} feeds back {' and '.join(blind)}, which {' and '.join(model.reads)} do not show",
            expected="a feedback of what they show",
            hint="lqr(robot, kit)",
        )
    estimator = kalman_filter(model, disturbed)
    design = Observed(estimator, feedback)
    return output_feedback(estimator, feedback.gain @ model.ahead, feedback.kind, design)


def by_gain(gain: str | Sequence[float], robot: Robot, kit: Kit, dt: float) -> Controller:
    """u = −K x by the left motor's six gains, numbers or "k1,…,k6", or by a JSON file with a 2×6 "gain": of the true
    state on the ideal kit, else `observed`. Raises `InvalidController` for what is no gain."""
    if isinstance(gain, str) and gain.endswith(".json"):
        expected = 'JSON such as {"gain": [[six], [six]]}'
        data = read_json(Path(gain), InvalidController, expected)
        with understood(f"the gain in {gain}", InvalidController, expected):
            feedback = StateFeedback(data["gain"], dt, robot.command_unit)
    else:
        with understood("the gains", InvalidController, "six numbers"):
            row = list(map(float, gain.split(","))) if isinstance(gain, str) else gain
        feedback = StateFeedback.symmetric(row, dt, command_unit=robot.command_unit)
    return feedback if kit.name == "ideal" else observed(feedback, robot, kit)
