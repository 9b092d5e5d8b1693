"""What can be proven of a controller before it drives: margins, gaps, bounds over the robot's parameters."""

from upright.certify.analysis import Analysis as Analysis
from upright.certify.analysis import analyse as analyse
from upright.certify.certificate import Certificate as Certificate
from upright.certify.certificate import certify as certify
from upright.certify.certificate import read_certificate as read_certificate
from upright.certify.gap import nu_gap as nu_gap
from upright.certify.gap import stability_margin as stability_margin
from upright.certify.loop import Loop as Loop
from upright.certify.loop import delay_margin as delay_margin
from upright.certify.loop import robot_loop as robot_loop
from upright.certify.margins import Margins as Margins
from upright.certify.margins import disk_margin as disk_margin
from upright.certify.margins import margins as margins
from upright.certify.mu import Mu as Mu
from upright.certify.mu import parameter_mu as parameter_mu
