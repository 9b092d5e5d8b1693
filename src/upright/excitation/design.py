"""Designs the next experiment: the excitation of a balancing robot's commands whose log is most informative.

    excite(controller, robot) → ExcitationPlan

Every way of exciting is a set of signals. One energy is divided among them by the information that each gives to the
predictor of `calibrate`. How large the excitation may be follows from robots drawn from their uncertainty, run by the
fleet's kernel with the kit's faults.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from os import PathLike

from upright.control import Controller, find_controller
from upright.errors import InvalidScenario, check_within
from upright.excitation.loop import ExcitedLoop
from upright.excitation.plan import ExcitationPlan
from upright.excitation.planned import Limits
from upright.excitation.search import Search
from upright.logs.recording import check_examined
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.uncertainty import Family, Uncertainty, at_medians

ENOUGH = 1.1
"""Width of the intervals over that of the largest allowed excitation: 1.1 takes a half to a quarter of its energy."""

LONGEST = 600.0
"""[s] of an excitation, whose search runs hundreds of robots for as long."""


def excite(
    controller: Controller | str,
    robot: Robot | str,
    kit: Kit | str | None = None,
    *,
    seconds: float = 20.0,
    focus: Sequence[str] = (),
    limits: Limits | None = None,
    enough: float = ENOUGH,
    known: Sequence[str] = (),
    posterior: Uncertainty | str | PathLike[str] | None = None,
    samples: int = 600,
    seed: int = 0,
    progress: Progress | None = None,
) -> ExcitationPlan:
    """The plan of a run of `seconds` for `robot` with `kit` (None: its own) under `controller`.

    `focus` names the parameters in question (none: all), `known` those that are exact. Of what the `limits` allow no
    more is used than is `enough` for intervals at most so many times as wide (1: all of it). `samples` robots are drawn
    from the `posterior`, whose medians are then the robot, or from what the robot's sources leave open. Robot, kit,
    controller and posterior may be names or files.

    Raises `UnknownName`, `InvalidScenario`, `SpecMismatch` for a controller that does not fit, `DesignFailed` where it
    does not hold the robot or no limit can be kept.
    """
    if not 1 <= enough < math.inf:
        raise InvalidScenario(f"enough is {enough:g}", expected="1 or a little more")
    show = progress or unwatched
    nominal, unknown = at_medians(find_robot(robot), posterior)
    parts = find_kit(kit or nominal.kit)
    check_examined(nominal)
    holding = find_controller(controller, nominal, parts, parts.period)
    check_within("seconds of excitation", seconds, 0, LONGEST)
    design = Search(ExcitedLoop(nominal, parts, holding, seconds, seed), limits or Limits(), tuple(known), tuple(focus))
    design.draw(Family(nominal, parts, unknown or Uncertainty.of(nominal, known)), samples)
    show(0.1)
    design.begin()
    show(0.25)
    tried = design.loudest(lambda fraction: show(0.25 + 0.4 * fraction))
    way = design.quieter(tried, enough)
    show(0.75)
    excitation, checked = design.settled(way)
    show(0.95)
    return design.plan(way, tried, excitation, checked)
