"""What commands: the contract, estimators, and one file for each method.

`CONTROLLERS` names every controller there is; a new one is one file and one line here.
"""

from collections.abc import Callable

from upright.control.controller import Controller as Controller
from upright.control.controller import ControllerSpec as ControllerSpec
from upright.control.controller import controller_hash as controller_hash
from upright.control.estimators import Complementary as Complementary
from upright.control.estimators import Estimated as Estimated
from upright.control.estimators import Kalman as Kalman
from upright.control.estimators import complementary as complementary
from upright.control.estimators import kalman as kalman
from upright.control.feedback import StateFeedback as StateFeedback
from upright.control.lqr import Lqr as Lqr
from upright.control.lqr import bryson as bryson
from upright.control.lqr import dlqr as dlqr
from upright.control.lqr import lqr as lqr
from upright.errors import UnknownName
from upright.robots import Kit, Robot

CONTROLLERS: dict[str, Callable[[Robot, Kit, float], Controller]] = {
    "lqr": lambda robot, kit, dt: Estimated(lqr(robot, dt), kalman(robot, kit, dt)),
    "lqr-complementary": lambda robot, kit, dt: Estimated(lqr(robot, dt), complementary(robot, kit, dt)),
    "lqr-state": lambda robot, kit, dt: lqr(robot, dt),  # noqa: ARG005 (it reads the truth, not the kit)
}


def make_controller(name: str, robot: Robot, kit: Kit, dt: float) -> Controller:
    """The registered controller of that name, designed for `robot` under `kit` every `dt` [s]."""
    if name not in CONTROLLERS:
        raise UnknownName("controller", name, CONTROLLERS)
    return CONTROLLERS[name](robot, kit, dt)
