"""The causes of a fall by name, and what repairs each."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from upright.robots import Robot
from upright.tables import sentence

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

REPAIRS = {
    SATURATION: "reduce the demand (slower changes of speed, less slope), or fit stronger motors or a higher voltage",
    BIAS: "calibrate the gyro at rest before every start; use a controller that estimates the offset (lqg, lqi)",
    DROPPED: "take logging and sockets out of the loop, relieve the bus, and count missed periods with a watchdog",
    SLIP: "clean tyres and floor, use softer tyres, or limit the command to the grip of the floor",
    BATTERY: "charge or change the battery; scale the duty by the measured voltage",
    PUSH: "nothing looks broken: push less, or design for more (`upright push-map --robot ROBOT` finds the largest)",
    DELAY: "find the cause of the delay (bus, filter, sensor mode), or design for it",
    LOW: "raise the gain, or design a new controller (`upright design lqg --robot ROBOT`)",
    HIGH: "lower the gain, or design a new controller (`upright design lqg --robot ROBOT`)",
    STUCK: "check the plug and the cable of the sensor, and whether its wheel is jammed",
    SCALED: "check the sensor's unit, range and gear in the program's constants, and its supply",
    DEAD: "check the motor's plug and cable, its driver's output and fuse",
    JAMMED: "free the wheel and its gear: hair, thread, a stone, a bent axle",
    WALL: "leave more room, drive slower near walls, or stop when the wheels are held",
    RAMP: "drive slower on slopes, or design for them (`upright design lqi --robot ROBOT`)",
    LOAD: "fix the load, or calibrate again with it and design anew",
    TYRE: "put the tyre back on its wheel, and glue it; look at both wheels",
    OFF: "if somebody stopped the program, this fall is no fault; else look for why it stopped, or who cut its motors",
    NONE: "look at the robot where the evidence points; `upright doctor LOG` tests it for signs, units and plugs",
    REVERSED: "turn the motor or the sensor round, or its sign in the program's first constants",
    CANNOT_TELL: "",
}


@dataclass(frozen=True, kw_only=True)
class Blow:
    """A push that fells a robot: its `impulse` [N s], positive forward, `start` [s], `duration` [s] and `height` [m]
    above the axle, the lean [rad] that its speed `counts` as, the `largest` lean [rad] and the impulse, `most` [N s],
    that the motors bring back with the kit's `battery` [V] (infinite for a torque drive), the fraction of the
    innovations `explained` by it, whether it was too `brief` for its length to show, and what the robot's own
    controller `saves` [N s], where one is known `by` name. Commands name the robot as `--robot` has it."""

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
    robot: str = "ROBOT"

    @property
    def remedy(self) -> str:
        """What helps: a smaller push, and a better controller where one may save this one."""
        less = "push less" if self.saves is None else f"push with less than {self.saves:.2g} N s"
        if abs(self.impulse) < (1 + KNOWN) * self.most:
            less += f", or compare controllers: `upright bench-controllers --robot {self.robot}`"
        return f"nothing in the log looks broken. {sentence(less)}"

    @property
    def repair(self) -> str:
        """What helps, and why."""
        hint = (
            ""
            if self.saves is not None
            else " Name the robot's controller with --controller to see what that survives."
        )
        return f"{self.remedy} {sentence(self.limits)}{hint}"

    @property
    def limits(self) -> str:
        """What the robot's own controller survives, and the best possible one."""
        size = abs(self.impulse)
        best = f"the best possible {'one' if self.by else 'controller'} survives"
        limit = f"{best} {self.most:.2g} N s"
        if size > (1 + KNOWN) * self.most:
            limit += ", so no controller could have saved this one"
        elif size > (1 - KNOWN) * self.most:
            limit += ", which is within the error of this one"
        if self.saves is None:
            return limit
        return f"its controller ({self.by}) survives pushes up to {self.saves:.2g} N s; {limit}"

    @property
    def lasted(self) -> str:
        """How long it was, in words."""
        return "within one sample" if self.brief else f"{float(f'{1e3 * self.duration:.2g}'):g} ms long"

    @property
    def powered(self) -> str:
        """With which battery the motors bring back so much; empty for a torque drive."""
        return f" with a battery of {self.battery:.3g} V" if math.isfinite(self.battery) else ""

    @property
    def size(self) -> str:
        """The impulse in words, with its error."""
        return f"{_with_error(abs(self.impulse))} N s"

    @property
    def lean(self) -> str:
        """The lean at rest [°] that its speed counts as, with its error."""
        return _with_error(math.degrees(abs(self.counts)))

    def __str__(self) -> str:
        way = "forward" if self.impulse > 0 else "backward"
        return f"a push {way} of {self.size} at t = {self.start:.2f} s"


def _with_error(size: float) -> str:
    """What is known of a push to `KNOWN`, to the digits that its error has."""
    error = KNOWN * size
    return f"{size:.{max(0, -math.floor(math.log10(error)))}f} ± {error:.1g}" if error else "0"


KNOWN = 0.07
"""How well an impulse is known: planted ones come out between 7 % small and 1 % large (twins of nxtway-gs,
25 November 2026)."""


@dataclass(frozen=True)
class Cause:
    """A possible cause: its `likelihood`, since when [s] (NaN: unknown), evidence in words and numbers, the repair; of
    a push also its numbers."""

    name: str
    likelihood: float
    onset: float
    evidence: str
    repair: str
    push: Blow | None = None


def as_typed(text: str, robot: str, log: str) -> str:
    """A text whose commands can be typed as they are: with the name or file of the robot, and the log's."""
    return text.replace("--robot ROBOT", f"--robot {robot}").replace(" LOG ", f" {log} ").replace(" LOG`", f" {log}`")


def noisy(noise: Mapping[str, float]) -> str:
    """What a filter of a calibrated robot cannot see."""
    units = {"gyro": "rad/s", "encoder": "rad"}
    sizes = " and ".join(f"{name} {noise[name]:.2g} {unit}" for name, unit in units.items() if name in noise)
    return f"the noise is that of the robot's calibration ({sizes} from reading to reading): a smaller fault is hidden"


def foreign(ordinary: float, robot: Robot) -> str:
    """Why no cause is named that rests on the innovations of a `robot` that they do not fit."""
    text = (
        f"the given robot does not fit this log, even before the fall: innovations are {math.sqrt(ordinary):.0f} times "
        "the expected size, so no cause is named that rests on them"
    )
    if any(origin.source.startswith("calibrated from ") for origin in robot.provenance.values()):
        return f"{text}. Its calibration is of another run, or without the noise of one: calibrate it from this log too"
    return f"{text}. Calibrate it first (`upright calibrate LOG --robot ROBOT -o robot.toml`), or name another robot"
