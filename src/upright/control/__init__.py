"""Controllers: the contract, estimators, and one file for each method of design.

`CONTROLLERS` names every method. A new one is one file and one line in `methods`, or `my.py:Rod`, or an entry point of
the group `upright.controllers` in another package.
"""

from upright.control.controller import Controller as Controller
from upright.control.controller import ControllerSpec as ControllerSpec
from upright.control.controller import controller_hash as controller_hash
from upright.control.design import Design as Design
from upright.control.design import design_of as design_of
from upright.control.design import gain_of as gain_of
from upright.control.design import residual_of as residual_of
from upright.control.estimators import Complementary as Complementary
from upright.control.estimators import Estimated as Estimated
from upright.control.estimators import Kalman as Kalman
from upright.control.estimators import complementary as complementary
from upright.control.estimators import kalman as kalman
from upright.control.feedback import StateFeedback as StateFeedback
from upright.control.files import read_controller as read_controller
from upright.control.files import write_controller as write_controller
from upright.control.hinf import hinf as hinf
from upright.control.law import as_linear as as_linear
from upright.control.linear_controller import LinearController as LinearController
from upright.control.lqg import lqg as lqg
from upright.control.lqi import lqi as lqi
from upright.control.lqr import Lqr as Lqr
from upright.control.lqr import dlqr as dlqr
from upright.control.lqr import lqr as lqr
from upright.control.lqr import lqr_state as lqr_state
from upright.control.methods import CONTROLLERS as CONTROLLERS
from upright.control.methods import Method as Method
from upright.control.methods import find_controller as find_controller
from upright.control.methods import make_controller as make_controller
from upright.control.mpc import mpc as mpc
from upright.control.observed import observed as observed
from upright.control.pid import pid as pid
from upright.control.pid_angle import AnglePid as AnglePid
from upright.control.pid_angle_design import pid_angle as pid_angle
from upright.control.riccati import bryson as bryson
from upright.control.robust import robust as robust
from upright.control.sliding import sliding as sliding
