"""The causes of a fall by name, and what repairs each."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from upright.pages import Quantity, Say
from upright.robots import Robot

NO_FALL, CANNOT_TELL = "it did not fall", "cannot tell"
SATURATION, BIAS, DROPPED, SLIP, BATTERY = "saturation", "gyro bias", "dropped samples", "wheel slip", "weak battery"
PUSH, DELAY, LOW, HIGH = "push too large", "delay grown", "gain too low", "gain too high"
STUCK, REVERSED = "sensor stuck", "motor or sensor reversed"
SCALED, DEAD, JAMMED, WALL = "sensor mis-scaled", "motor dead", "wheel jammed", "wall"
RAMP, LOAD, TYRE, OFF, NONE = "ramp", "load changed", "tyre lost", "motors off", "none of these"
CAUSES = (
    SATURATION, BIAS, DROPPED, SLIP, BATTERY, PUSH, DELAY, LOW, HIGH, STUCK, REVERSED, SCALED, DEAD, JAMMED, WALL, RAMP,
    LOAD, TYRE, OFF,
)  # fmt: skip

NAMES = {
    "bias": BIAS, "weak": BATTERY, "delay": DELAY, "slip": SLIP, "dropped": DROPPED, "scale": SCALED, "motor": DEAD,
    "ramp": RAMP, "payload": LOAD, "friction": JAMMED, "radius": TYRE,
}  # fmt: skip

TITLES = {
    SATURATION: Say("saturation"), BIAS: Say("gyro bias"), DROPPED: Say("dropped samples"),
    SLIP: Say("wheel slip"), BATTERY: Say("weak battery"), PUSH: Say("push too large"), DELAY: Say("delay grown"),
    LOW: Say("gain too low"), HIGH: Say("gain too high"), STUCK: Say("sensor stuck"),
    REVERSED: Say("motor or sensor reversed"), SCALED: Say("sensor mis-scaled"), DEAD: Say("motor dead"),
    JAMMED: Say("wheel jammed"), WALL: Say("wall"), RAMP: Say("ramp"), LOAD: Say("load changed"),
    TYRE: Say("tyre lost"), OFF: Say("motors off"), NONE: Say("none of these"), CANNOT_TELL: Say("cannot tell"),
}  # fmt: skip
"""Cause → what people read."""

REPAIRS = {
    SATURATION: Say("Change speed more slowly, or use stronger motors or a higher voltage."),
    BIAS: Say("Calibrate the gyro at rest before every start, or use a controller that estimates its bias."),
    DROPPED: Say("Take logging and sockets out of the loop, relieve the bus, and count missed periods."),
    SLIP: Say("Clean tyres and floor, use softer tyres, or limit the command to the grip of the floor."),
    BATTERY: Say("Charge or change the battery; scale the duty by the measured voltage."),
    PUSH: Say("Nothing in the log looks broken: push less, or design for more."),
    DELAY: Say("Look for the new delay in bus, filter and sensor mode, or design for it."),
    LOW: Say("Raise the gain, or design a new controller."),
    HIGH: Say("Lower the gain, or design a new controller."),
    STUCK: Say("Check plug and cable of the sensor, and whether its wheel is jammed."),
    SCALED: Say("Check the sensor's unit, range, gear and supply against the program's constants."),
    DEAD: Say("Check the motor's plug and cable, its driver's output and its fuse."),
    JAMMED: Say("Free the wheel and its gear from hair, thread or a stone, and look for a bent axle."),
    WALL: Say("Leave more room, drive slower near walls, or stop when the wheels are held."),
    RAMP: Say("Drive slower on slopes, or design for them."),
    LOAD: Say("Fix the load, or calibrate with it and design anew."),
    TYRE: Say("Put the tyre back on its wheel and glue it; look at both wheels."),
    OFF: Say("Find out why the program stopped or who cut its motors; a stop by hand is no fault."),
    NONE: Say("Look at the robot where the evidence points."),
    REVERSED: Say("Turn the motor or the sensor round, or its sign in the program's first constants."),
    CANNOT_TELL: Say("Log the robot again, from before the fall."),
}


@dataclass(frozen=True, kw_only=True)
class Blow:
    """A push that fells a robot: its `impulse` [N s], positive forward, `start` [s], `duration` [s] and `height` [m]
    above the axle, the lean [rad] that its speed `counts` as, the `largest` lean [rad] and the impulse, `most` [N s],
    that the motors bring back with the kit's `battery` [V] (infinite for a torque drive), the fraction of the
    innovations `explained` by it, whether it was too `brief` for its length to show, and what the robot's own
    controller `saves` [N s], where one is known `by` name."""

    impulse: float
    start: float
    duration: float
    height: float
    counts: float
    largest: float
    most: float
    explained: float
    brief: bool = False
    battery: float = math.inf
    by: str = ""
    saves: float | None = None


KNOWN = 0.07
"""How well an impulse is known: planted ones come out between 7 % small and 1 % large (twins of nxtway-gs,
25 November 2026)."""


@dataclass(frozen=True)
class Cause:
    """A possible cause: its `likelihood`, since when [s] (NaN: unknown), evidence in words and numbers; of a push also
    its numbers. The name of two at once joins theirs."""

    name: str
    likelihood: float
    onset: float
    evidence: Say
    push: Blow | None = None

    @property
    def parts(self) -> list[str]:
        """The names of one cause, or of two at once."""
        return self.name.split(AND)

    @property
    def title(self) -> Say:
        """The cause, as people read it."""
        first, *second = (TITLES.get(part, Say("{name}", name=part)) for part in self.parts)
        return Say("{one} and {other}", one=first, other=second[0]) if second else first

    @property
    def repairs(self) -> list[Say]:
        """What helps against it, or against each of two."""
        return [REPAIRS[part] for part in self.parts if part in REPAIRS]


AND = " and "
"""Between the names of two causes at once."""


def noisy(noise: Mapping[str, float]) -> Say:
    """What a filter of a calibrated robot cannot see."""
    gyro = Quantity(noise.get("gyro", 0.0), "rad/s", digits=2)
    return Say("Faults below the noise of the robot's calibration are hidden (gyro {gyro}).", gyro=gyro)


def foreign(ordinary: float, robot: Robot) -> Say:
    """Why no cause is named that rests on the innovations of a `robot` that they do not fit."""
    times = round(math.sqrt(ordinary))
    if any(origin.source.startswith("calibrated from ") for origin in robot.provenance.values()):
        return Say(
            "The filter's errors are {times} times the expected ones: calibrate from this log, too.", times=times
        )
    return Say(
        "The filter's errors are {times} times the expected ones: calibrate, or name another robot.", times=times
    )
