"""Robots (physical parameters) and kits (electronics), with presets as TOML files."""

from upright.robots.facts import offered as offered
from upright.robots.kit import Battery as Battery
from upright.robots.kit import Kit as Kit
from upright.robots.kit import Motor as Motor
from upright.robots.kit import Sensor as Sensor
from upright.robots.kit import find_kit as find_kit
from upright.robots.kit import kit_names as kit_names
from upright.robots.robot import PARAMETERS as PARAMETERS
from upright.robots.robot import Robot as Robot
from upright.robots.robot import find_robot as find_robot
from upright.robots.robot import preset_names as preset_names
from upright.robots.sections import FittedLog as FittedLog
from upright.robots.toml import Provenance as Provenance
from upright.robots.wiring import BoardWiring as BoardWiring
