"""A controller as a program for a brick, traced from its one definition, and the check that it does as designed."""

from upright.firmware.balance import trace as trace
from upright.firmware.generate import Firmware as Firmware
from upright.firmware.generate import generate as generate
from upright.firmware.generate import head as head
from upright.firmware.generate import longest_run as longest_run
from upright.firmware.targets import TARGETS as TARGETS
