"""What speaks for a cause, in sentences with their facts; some facts are in no sentence, but in the JSON."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.finding import instant, plain
from upright.checkup.titles import CHANNELS
from upright.diagnose.beyond import Leftover
from upright.diagnose.causes import Blow
from upright.diagnose.changes import PART, channels_of
from upright.diagnose.evidence import FOREIGN, Evidence
from upright.diagnose.fall import LEANING
from upright.diagnose.fault_fits import FaultFit, PushEstimate
from upright.diagnose.law import growth
from upright.diagnose.measured import SLOWLY, Demand
from upright.diagnose.sizes import turned
from upright.diagnose.supply import as_shown
from upright.diagnose.thrown import Throw
from upright.pages import Quantity, Say
from upright.physics.dynamics import motor_gain
from upright.robots import Robot

_PLACES = {
    "left motor": (Say("a torque on the left wheel"), "N m"),
    "right motor": (Say("a torque on the right wheel"), "N m"),
    "both motors": (Say("a torque on both wheels"), "N m"),
    "force": (Say("a force on the robot"), "N"),
    "moment": (Say("a torque on the body"), "N m"),
}
WHEELS = {"left": Say("the left wheel"), "right": Say("the right wheel"), "both": Say("both wheels")}
_FAULTS = {
    "bias": (Say("Since {since} the gyro reads {size} too much."), "rad/s"),
    "drift": (Say("Since {since} the gyro drifts by {size} each second."), "rad/s"),
    "weak": (Say("Since {since} the motors get {size} of every command."), "fraction"),
    "limit": (Say("Since {since} the motors get no more than {size} of their largest command."), "fraction"),
    "delay": (Say("Since {since} readings answer a command {size} later."), "s"),
    "slip": (Say("Since {since} the wheels spin, as on a floor with a friction of {size}."), "1"),
    "dropped": (Say("Since {since} {size} of the rows repeat, while the wheels turn."), "fraction"),
    "scale": (Say("Since {since} readings show {size} times the motion: {where}."), "1"),
    "turned": (Say("Since {since} readings have the wrong sign: {where}."), "1"),
    "motor": (Say("Since {since} no torque reaches {where}."), "1"),
    "braked": (Say("Since {since} a motor gives no torque, and brakes {where}."), "1"),
    "ramp": (Say("Since {since} the floor rises by {size}."), "rad"),
    "payload": (Say("Since {since} the robot's load differs by {size}."), "kg"),
    "friction": (Say("Since {since} a dry friction of {size} brakes {where}."), "N m"),
    "radius": (Say("Since {since} wheels have {size} of their radius, as without tyres."), "fraction"),
    "load": (Say("Since {since} a steady force of {size} acts at the axle."), "N"),
}
"""What a fault is, its size, and the unit of that."""
SOUND = 4.0  # NIS over the ordinary one, below which robot and sensors are sound
ALMOST = 0.999  # [1] most that is said to be explained: nothing explains all
ALL = 1e-3  # [1] least of a reading that is left, where one shows so many times the motion


def gained(evidence: Evidence, fit: FaultFit) -> float:
    """Nats by which a fit explains more than pushes alone."""
    return fit.score - max(evidence.pushes_only.score, 0.0)


def began(evidence: Evidence) -> float:
    return evidence.fell_at - evidence.excursion


def percent(fraction: float) -> Quantity:
    return Quantity(fraction, "fraction", digits=2)


def sensor(name: str) -> Say:
    """What people call a sensor, by its channel or a short name of that."""
    word = name.removeprefix("sensor/").replace("_", " ").replace(" rate", "")
    if word == "encoders":
        return Say("both encoders")
    return CHANNELS.get(f"sensor/{word.replace(' ', '_')}", Say("{name}", name=word))


def of_fault(evidence: Evidence, fit: FaultFit) -> Say:
    """A fault of the robot: what it is, since when, and where it was examined apart from another fault, how much of
    the filter's errors it explains."""
    fault = _fault(evidence, fit)
    if not math.isfinite(fit.nis):
        return fault
    return Say(
        "{fault} This explains {explained} of the filter's errors, pushes alone {pushes}.",
        fault=fault,
        explained=Quantity(min(fit.explained, ALMOST), "fraction"),
        pushes=Quantity(evidence.pushes_only.explained, "fraction"),
        nis=plain(fit.nis),
        nis_without=plain(evidence.nis),
        nats=plain(gained(evidence, fit)),
    )


def _fault(evidence: Evidence, fit: FaultFit) -> Say:
    template, unit = _FAULTS[_kind(fit)]
    robot, way = evidence.run.robot, fit.way.partition(" ")[0]
    sizes = {
        "delay": fit.size * evidence.run.log.period,
        "ramp": math.asin(max(-1.0, min(fit.size, 1.0))),
        "payload": fit.size * robot.body_mass,
        "friction": fit.size * motor_gain(robot),
        "radius": 1 - fit.size,
        "scale": 1 / max(1 - fit.size, ALL),
    }
    size = sizes.get(fit.fault, 1 - fit.size if fit.way == PART else fit.size)
    where = WHEELS.get(way)
    if fit.fault == "scale":
        where = sensor("encoders" if len(channels_of(evidence.run, fit.way)) == 2 else fit.way)
    return template.about(since=instant(fit.onset), size=Quantity(size, unit, digits=2), where=where)


def _kind(fit: FaultFit) -> str:
    """Which sentence tells of a fault."""
    if fit.fault == "bias" and fit.way != "step":
        return "drift"
    if fit.fault == "weak" and fit.way == "limit":
        return "limit"
    if fit.fault == "scale" and turned(fit):
        return "turned"
    if fit.fault == "motor" and fit.way.endswith("braked"):
        return "braked"
    return fit.fault


def blow(evidence: Evidence, push: PushEstimate, lean: float) -> Blow:
    """The numbers of a push that, with smaller ones the same way, counts as this `lean` [rad]."""
    toppling, run = evidence.toppling, evidence.run
    volts = as_shown(run.kit, run.log, run.robot).battery.voltage
    return Blow(
        impulse=push.impulse, start=push.start, duration=push.stop - push.start, height=push.height, counts=lean,
        largest=min(toppling.largest, LEANING), most=toppling.largest_like(push),
        explained=evidence.pushes_only.explained, brief=push.stop - push.start < run.kit.period,
        battery=volts if run.robot.command_unit == "V" else math.inf,
    )  # fmt: skip


def of_push(numbers: Blow) -> Say:
    """How hard a push is to stop."""
    return Say(
        "A push of {size} at {time} is as hard to stop as a lean of {lean}; the motors bring back {largest}.",
        size=Quantity(abs(numbers.impulse), "N s", digits=2),
        time=instant(numbers.start),
        lean=Quantity(abs(numbers.counts), "rad", digits=2),
        largest=Quantity(numbers.largest, "rad", digits=2),
    )


def of_throw(throw: Throw) -> Say:
    """A blow that the readings alone show."""
    speed, times = abs(throw.after), throw.times
    rate = Quantity(None, "rad/s", low=speed, digits=2) if throw.clipped else Quantity(speed, "rad/s", digits=2)
    return Say(
        "At {time} a blow turned the body at {rate}, {times} times what the motors stop.",
        time=instant(throw.start),
        rate=rate,
        times=plain(times, 1),
        within=Quantity(throw.seconds, "s"),
        left=Quantity(throw.left, "s"),
    )


def of_demand(evidence: Evidence, demand: Demand, limit: float) -> Say:
    return Say(
        "At {time} the reference speed changed by {jump} at once; the robot follows {limit}.",
        time=instant(demand.at),
        jump=Quantity(demand.jump, "m/s"),
        limit=Quantity(limit, "m/s"),
        top=Quantity(demand.top_speed, "m/s"),
        saturated=percent(evidence.motors.saturated),
    )


def of_low(evidence: Evidence) -> Say:
    half, pole = evidence.motors.half_swing, evidence.toppling.pole
    grows = growth(evidence.run, evidence.fell_at) if began(evidence) < evidence.run.log.t[0] else 0.0
    if grows > 0:
        return Say(
            "By its commands a lean doubles every {doubles}, and without motors every {free}.",
            doubles=Quantity(math.log(2) / grows, "s", digits=2),
            free=Quantity(math.log(2) / pole, "s", digits=2),
        )
    if half > SLOWLY:
        swing = Quantity(half / pole, "s", digits=2)
        return Say("The fall grew in slow swings of {swing} each way, and the motors had torque left.", swing=swing)
    if math.isfinite(evidence.motors.help):
        help_ = plain(evidence.motors.help, 2)
        return Say("The motors gave {help} of the torque that stops the fall, and had more.", help=help_)
    return Say("The fall grew without swings, as under too small a gain.")


def of_high(evidence: Evidence, limit: float) -> Say:
    if math.isfinite(evidence.slid):
        return Say("From {time} on the commands ask more of the floor than it holds.", time=instant(evidence.slid))
    facts = {"swings": plain(evidence.motors.swings, 1), "limit": plain(limit)}
    if evidence.motors.swings < limit:
        return Say(
            "The commands changed their sign only {swings} times a second; under a high gain it is {limit} or more.",
            **facts,
        )
    return Say("The commands changed their sign {swings} times a second, as under a high gain.", **facts)


def of_pegged(evidence: Evidence) -> Say:
    pegged = percent(evidence.motors.pegged)
    return Say("The motors were at their limit for {part} of the last second.", part=pegged)


def nothing(evidence: Evidence) -> Say:
    """Why no other cause is likely."""
    nis = plain(evidence.pushes_only.nis, 2)
    is_sound = evidence.pushes_only.nis < SOUND * evidence.ordinary
    if is_sound and evidence.run.robot.noise:
        return Say("Nothing shows beyond the noise of the robot's calibration.", nis=nis)
    if is_sound and evidence.ordinary < FOREIGN:
        return Say("Robot and sensors are sound, and no other cause explains the fall.", nis=nis)
    return Say("No single fault explains the filter's errors.", nis=nis)


def of_leftover(left: Leftover, robot: Robot) -> Say:
    """What is left where no known cause explains a fall: by which channel it enters, and since when."""
    wrong = Say("a wrong reading of the {sensor}", sensor=sensor(left.channel))
    place, unit = _PLACES.get(left.channel, (wrong, "rad"))
    if "gyro" in left.channel or "rate" in left.channel:
        unit = "rad/s"
    since = instant(left.onset)
    if not len(left.values):
        return Say("What is left is rapid, and most like {place}, from {since} on.", place=place, since=since)
    size = motor_gain(robot) if "motor" in left.channel else 1.0
    most = Quantity(float(np.abs(size * left.values).max()), unit, digits=2)
    return Say("What is left looks like {place} from {since} on, up to {most}.", place=place, since=since, most=most)
