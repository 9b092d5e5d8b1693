"""What findings, channels, poses and checks are called on a page."""

from __future__ import annotations

from upright.checkup.finding import (
    BALANCING,
    BATTERY,
    COMPASS,
    FALLEN,
    FALLING,
    FORWARD,
    GYRO,
    HELD,
    LEFT,
    LYING,
    MOVED,
    OFF,
    OVER,
    PITCH,
    RIGHT,
    RISING,
    STANDING,
    UP,
    Finding,
)
from upright.pages import Say

POSES = {
    BALANCING: Say("balancing"), STANDING: Say("standing still"), LYING: Say("lying"), OVER: Say("upside down"),
    RISING: Say("standing up"), FALLING: Say("falling"), FALLEN: Say("fallen"), MOVED: Say("moved"),
    HELD: Say("held"), OFF: Say("motors off"),
}  # fmt: skip

TITLES = {
    "time/missing": Say("times missing"), "time/repeated": Say("times repeated"), "time/coarse": Say("coarse clock"),
    "time/backwards": Say("time goes back"), "time/jump": Say("clock jumps"), "time/slow": Say("logged too slowly"),
    "time/unit": Say("unit of the time"), "time/jitter": Say("uneven time steps"), "time/dropped": Say("rows lost"),
    "time/gap": Say("gap in time"), "time/pace": Say("loop ran late"),
    "rows/skipped": Say("lines not read"), "samples/repeated": Say("readings repeated"),
    "samples/doubled": Say("rows doubled"), "samples/controller": Say("rows left out"),
    "columns/gyro": Say("wrong gyro column"), "columns/copied": Say("copied column"),
    "columns/missing": Say("column not found"), "columns/unnamed": Say("columns guessed"),
    "units/counts": Say("raw counts"), "units/scale": Say("another unit"), "units/battery": Say("another unit"),
    "units/speed": Say("another unit"), "units/contradicted": Say("units disagree"), "units/turn": Say("counts a turn"),
    "units/command": Say("unit of the command"), "units/duty": Say("full duty assumed"),
    "command/unsigned": Say("command without a sign"),
    "motion/flipped": Say("wrong sign"), "motion/swapped": Say("sides swapped"),
    "motion/contradicted": Say("signs disagree"), "motion/integrated": Say("angle logged as a rate"),
    "motion/differentiated": Say("rate logged as an angle"), "motion/untold": Say("scale not told"),
    "motion/quiet": Say("too little motion"),
    "delay/sensor": Say("late sensor"), "delay/command": Say("late command"), "delay/untold": Say("delay not told"),
    "gyro/bias": Say("bias"), "channel/empty": Say("no readings"), "channel/holes": Say("readings missing"),
    "channel/constant": Say("never changes"), "channel/stuck": Say("stuck"), "channel/outliers": Say("outliers"),
    "channel/coarse": Say("coarse steps"), "encoder/wrapped": Say("begins again at zero"),
    "encoder/jump": Say("jumps"), "encoder/unequal": Say("sides differ"), "encoder/grain": Say("coarse steps"),
    "estimate/zero": Say("another zero"), "estimate/accelerometer": Say("shaken by acceleration"),
    "saturation": Say("at its limit"),
    "segment/fall": Say("fall"), "segment/slip": Say("wheel slip"), "segment/push": Say("push"),
    "segment/still": Say("at rest"), "segment/none": Say("balances nowhere"), "segment/short": Say("too short"),
    "segment/cut": Say("cut"),
    **{f"segment/{kind.replace(' ', '-')}": title for kind, title in POSES.items()},
}  # fmt: skip
"""Code of a finding → what is wrong."""

CHANNELS = {
    "t": Say("time"), GYRO: Say("gyro"), LEFT: Say("left encoder"), RIGHT: Say("right encoder"),
    PITCH: Say("estimated pitch"), BATTERY: Say("battery"), COMPASS: Say("compass"),
    FORWARD: Say("accelerometer"), UP: Say("accelerometer"), "command": Say("commands"),
    "command/left": Say("left command"), "command/right": Say("right command"),
    "applied/left": Say("left command"), "applied/right": Say("right command"),
}  # fmt: skip
PAIRS = (
    ({LEFT, RIGHT}, Say("encoders")),
    ({"command/left", "command/right"}, Say("commands")),
    ({"applied/left", "applied/right"}, Say("commands")),
)

CHECKS = {
    "time stamps": (Say("time stamps"), ("time/",)),
    "rows": (Say("rows"), ("samples/", "columns/", "rows/")),
    "units": (Say("units"), ("units/",)),
    "signs": (Say("signs and sides"), ("motion/flipped", "motion/swapped", "motion/contra", "command/")),
    "kinds": (Say("rates and angles"), ("motion/int", "motion/diff")),
    "delays": (Say("delays"), ("delay/",)),
    "bias": (Say("bias of the gyro"), ("gyro/",)),
    "readings": (Say("readings"), ("channel/", "estimate/", "encoder/wrapped")),
    "steps": (Say("steps of the encoders"), ("encoder/",)),
    "limits": (Say("limits of motors and gyro"), ("saturation",)),
    "motion": (Say("amplitude of the pitch"), ("motion/", "segment/still", "segment/none")),
    "events": (Say("falls and slips"), ("segment/",)),
}
"""What is checked → what it is called, and how the codes of its findings begin; the first that fits counts."""


def title_of(finding: Finding) -> Say:
    """What is wrong."""
    return TITLES.get(finding.code, Say("{name}", name=finding.code))


def place_of(finding: Finding) -> Say:
    """Where it is wrong: in the channel, or in all those that are repaired or judged together."""
    names = {finding.channel, *(name for fix in finding.fixes for name in fix.channels)}
    if finding.code == "encoder/grain" and finding.severity == "note":
        return PAIRS[0][1]  # of two alike the first is named
    if finding.code == "saturation" and finding.channel != GYRO:
        return Say("motors")
    both = (title for pair, title in PAIRS if pair <= names)
    return next(both, CHANNELS.get(finding.channel, Say("{name}", name=finding.channel)))


def check_of(finding: Finding) -> str:
    """The check that it is of."""
    return next((name for name, (_, heads) in CHECKS.items() if finding.code.startswith(heads)), "readings")
