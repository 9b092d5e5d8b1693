"""Robots (physical parameters) and kits (what their electronics do), with presets as TOML files."""

from upright.robots.files import kit_names as kit_names
from upright.robots.files import preset_names as preset_names
from upright.robots.kit import Battery as Battery
from upright.robots.kit import Kit as Kit
from upright.robots.kit import Motor as Motor
from upright.robots.kit import Sensor as Sensor
from upright.robots.robot import PARAMETERS as PARAMETERS
from upright.robots.robot import Provenance as Provenance
from upright.robots.robot import Robot as Robot
