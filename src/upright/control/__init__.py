"""What commands: the contract, estimators, and one file for each method.

`CONTROLLERS` names every controller there is; a new one is one file and one line here.
"""

from collections.abc import Callable
from os import PathLike

from upright.control.controller import Controller as Controller
from upright.control.controller import ControllerSpec as ControllerSpec
from upright.control.controller import controller_hash as controller_hash
from upright.control.estimators import Complementary as Complementary
from upright.control.estimators import Estimated as Estimated
from upright.control.estimators import Kalman as Kalman
from upright.control.estimators import complementary as complementary
from upright.control.estimators import kalman as kalman
from upright.control.feedback import StateFeedback as StateFeedback
from upright.control.files import read_controller as read_controller
from upright.control.files import write_controller as write_controller
from upright.control.hinf import hinf as hinf
from upright.control.linear_controller import LinearController as LinearController
from upright.control.linear_controller import as_linear as as_linear
from upright.control.lqg import lqg as lqg
from upright.control.lqi import lqi as lqi
from upright.control.lqr import Lqr as Lqr
from upright.control.lqr import bryson as bryson
from upright.control.lqr import dlqr as dlqr
from upright.control.lqr import lqr as lqr
from upright.control.mpc import mpc as mpc
from upright.control.observed import observed as observed
from upright.control.pid import pid as pid
from upright.control.robust import robust as robust
from upright.control.sliding import sliding as sliding
from upright.errors import UnknownName
from upright.robots import Kit, Robot

CONTROLLERS: dict[str, Callable[[Robot, Kit, float], Controller]] = {
    "lqr": lambda robot, kit, dt: observed(lqr(robot, dt), robot, kit),  # the baseline of all others
    "lqr-complementary": lambda robot, kit, dt: Estimated(lqr(robot, dt), complementary(robot, kit, dt)),
    "lqi": lqi,
    "lqg": lqg,
    "pid": pid,
    "hinf": hinf,
    "mpc": mpc,
    "sliding": sliding,
    "robust": robust,
    "lqr-state": lambda robot, kit, dt: lqr(robot, dt),  # noqa: ARG005 (it reads the truth, not the kit)
}


def make_controller(name: str, robot: Robot, kit: Kit, dt: float) -> Controller:
    """The registered controller of that name, designed for `robot` under `kit` every `dt` [s]."""
    if name not in CONTROLLERS:
        raise UnknownName("controller", name, CONTROLLERS)
    return CONTROLLERS[name](robot, kit, dt)


def find_controller(controller: Controller | str | PathLike[str], robot: Robot, kit: Kit, dt: float) -> Controller:
    """The controller itself, the one in the file where this is a path to `.json`, else the registered one."""
    if not isinstance(controller, str | PathLike):
        return controller
    name = str(controller)
    return read_controller(name) if name.endswith(".json") else make_controller(name, robot, kit, dt)
