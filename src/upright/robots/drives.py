"""What a robot's two commands are: the motors' voltage, their torque, or the speed of the wheels."""

from upright.pages import Say

COMMAND_UNITS = {"voltage": "V", "torque": "N m", "speed": "rad/s"}
"""Drive → unit of the command."""
DRIVES = {"voltage": Say("voltage"), "torque": Say("torque"), "speed": Say("speed")}
"""Drive → what it is called."""

EFFORT_UNITS = {"V": "V² s", "N m": "N² m² s", "rad/s": "rad²/s"}
"""Unit of a command → that of the integral of its square."""

_ELECTRICAL = ("motor_resistance", "torque_constant", "back_emf")
SPEED_DRIVE = ("speed_lag", "acceleration_limit", "slip_torque")
UNUSED = {
    "voltage": SPEED_DRIVE,
    "torque": (*_ELECTRICAL, *SPEED_DRIVE),
    "speed": (*_ELECTRICAL, "motor_friction", "coulomb_friction"),
}
"""Drive → the robot's parameters that keep their defaults with it."""


def drive_of(unit: str) -> str:
    """The drive that is commanded in this unit."""
    return next(drive for drive, own in COMMAND_UNITS.items() if own == unit)
