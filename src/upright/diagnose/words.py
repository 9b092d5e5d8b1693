"""What speaks for a cause, in words and numbers."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

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
from upright.physics.dynamics import motor_gain

_PLACES = {
    "left motor": ("a torque on the left wheel", "N m"), "right motor": ("a torque on the right wheel", "N m"),
    "both motors": ("a torque on both wheels", "N m"), "force": ("a force on the robot", "N"),
    "moment": ("a torque on the body", "N m"),
}  # fmt: skip
SOUND = 4.0  # NIS over the ordinary one, below which robot and sensors are sound


def gained(evidence: Evidence, fit: FaultFit) -> float:
    """Nats by which a fit explains more than pushes alone."""
    return fit.score - max(evidence.pushes_only.score, 0.0)


def began(evidence: Evidence) -> float:
    return evidence.fell_at - evidence.excursion


def of_fault(evidence: Evidence, fit: FaultFit) -> str:
    """A fault of the robot in words: what it is, since when, and how much of the innovations it explains, where that
    was examined apart from another fault."""
    text = f"{_FAULT_TEXTS[fit.fault](evidence, fit)} since t = {fit.onset:.2f} s"
    if not math.isfinite(fit.nis):
        return text
    return (
        f"{text} explains {most(fit.explained)} of the innovations: NIS falls from {evidence.nis:.3g} to {fit.nis:.3g} "
        f"({gained(evidence, fit):+.0f} nats)"
    )


def _bias_text(_: Evidence, fit: FaultFit) -> str:
    return f"a gyro offset of {fit.size:+.2g} rad/s" + ("" if fit.way == "step" else " that grows by this each second")


def _weak_text(evidence: Evidence, fit: FaultFit) -> str:
    fit = replace(fit, size=1 - fit.size) if fit.way == PART else fit
    part = "as the largest command" if fit.way == "limit" else "of every command"
    before, last = evidence.battery
    volts = f" (the battery shows {last:.2f} V after {before:.2f} V)" if math.isfinite(last + before) else ""
    fades = f", fading to it within {fit.rise:.2g} s," if fit.rise > 0 else ""
    return f"motors that get {percent(fit.size)} {part}{volts}{fades}"


def _delay_text(evidence: Evidence, fit: FaultFit) -> str:
    milliseconds = 1e3 * fit.size * evidence.run.log.period
    return f"{fit.size:.2g} periods ({milliseconds:.0f} ms) more from command to reading"


def _slip_text(_: Evidence, fit: FaultFit) -> str:
    return f"wheels that slip and spin, as on a floor with a friction coefficient of {fit.size:.2g},"


def _dropped_text(_: Evidence, fit: FaultFit) -> str:
    return f"readings that repeat exactly in {percent(fit.size)} of the rows while the wheels turn,"


def _scale_text(evidence: Evidence, fit: FaultFit) -> str:
    several = len(channels_of(evidence.run, fit.way)) == 2
    name = "both encoders" if several else "the " + fit.way.replace("_", " ")
    verb = "show" if several else "shows"
    if turned(fit):
        return f"{name} that {verb} the motion with the wrong sign"
    return f"{name} that {verb} {1 / max(1 - fit.size, 1e-3):.2g} times the motion"


def _motor_text(_: Evidence, fit: FaultFit) -> str:
    side, _space, braked = fit.way.partition(" ")
    if side == "both":
        return "two motors that give no torque"
    return f"a {side} motor that gives no torque" + (" and is braked" if braked else "")


def _ramp_text(_: Evidence, fit: FaultFit) -> str:
    way = "climbs" if fit.size > 0 else "falls"
    return f"a floor that {way} by {math.degrees(math.asin(min(abs(fit.size), 1.0))):.2g}°"


def _payload_text(evidence: Evidence, fit: FaultFit) -> str:
    way = "added" if fit.size > 0 else "lost"
    return f"a load of about {abs(fit.size) * evidence.run.robot.body_mass:.1g} kg that was {way}"


def _friction_text(evidence: Evidence, fit: FaultFit) -> str:
    several = fit.way == "both"
    torque = fit.size * motor_gain(evidence.run.robot)
    return f"{'both wheels' if several else f'a {fit.way} wheel'} held by a dry friction of {torque:.2g} N m"


def _radius_text(_: Evidence, fit: FaultFit) -> str:
    return f"wheels of {1 - fit.size:.2g} times their radius, as without tyres,"


def _load_text(_: Evidence, fit: FaultFit) -> str:
    return f"a steady force of {fit.size:+.2g} N at the axle"


_FAULT_TEXTS = {
    "scale": _scale_text, "motor": _motor_text, "ramp": _ramp_text, "payload": _payload_text, "load": _load_text,
    "friction": _friction_text, "radius": _radius_text,
    "bias": _bias_text, "weak": _weak_text, "delay": _delay_text, "slip": _slip_text, "dropped": _dropped_text,
}  # fmt: skip


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


def of_push(evidence: Evidence, push: PushEstimate, numbers: Blow) -> str:
    way = "forward" if numbers.impulse > 0 else "backward"
    several = numbers.counts > 1.01 * abs(evidence.toppling.lean(push))
    speed = "With smaller pushes the same way, its speed" if several else "Its speed"
    lean, largest = (math.degrees(abs(angle)) for angle in (numbers.counts, numbers.largest))
    return (
        f"a push {way} of {abs(numbers.impulse):.2g} N s at t = {numbers.start:.2f} s explains "
        f"{most(numbers.explained)} of the innovations. {speed} is as hard to stop as a lean at rest of {lean:.2g}°; "
        f"the motors bring back {largest:.3g}° at most"
    )


def of_throw(throw: Throw) -> str:
    """A blow that the readings alone show."""
    more = "more than " if throw.clipped else ""
    return (
        f"at t = {throw.start:.2f} s something hit the robot: within {1e3 * throw.seconds:.0f} ms its body turned at "
        f"{more}{abs(throw.after):.2g} rad/s, {more or 'about '}{throw.times:.1g} times what the motors stop. Neither "
        "they nor gravity do that so fast. Wheels may slide or lift off then, so size and direction do not show. The "
        f"log ends {1e3 * throw.left:.0f} ms after it"
    )


def of_demand(evidence: Evidence, demand: Demand) -> str:
    top = f", and these motors reach {demand.top_speed:.2f} m/s" if math.isfinite(demand.top_speed) else ""
    return (
        f"the reference speed changed by {demand.jump:.2f} m/s at once at t = {demand.at:.2f} s{top}; "
        f"{at_limit(evidence)}; robot and commands are sound"
    )


def of_low(evidence: Evidence) -> str:
    half, pole = evidence.motors.half_swing, evidence.toppling.pole
    if began(evidence) < evidence.run.log.t[0] and (grows := growth(evidence.run, evidence.fell_at)) > 0:
        return (
            f"{sound(evidence)}, and the loop as programmed is unstable: by its commands from the first row on a lean "
            f"doubles every {math.log(2) / grows:.2g} s, without motors every {math.log(2) / pole:.2g} s"
        )
    gave = "the motors had torque left"
    if math.isfinite(evidence.motors.help):
        gave = f"the motors gave {evidence.motors.help:.2g} of the torque that stops the fall, and had more"
    how = f"in slow swings of {half / pole:.2g} s each way" if half > SLOWLY else "without swings"
    return f"{sound(evidence)}, and the fall grew {how}: {gave}"


def of_high(evidence: Evidence) -> str:
    if math.isfinite(evidence.slid):
        until = f"{sound(evidence)} until t = {evidence.slid:.2f} s"
        return f"{until}; then the commands ask more of the floor than it holds, and the wheels slide"
    if evidence.motors.swings < 1:
        return f"{sound(evidence)}; a high gain shows mostly in swings, and this log has none"
    return (
        f"{sound(evidence)}, and the commands changed sign {evidence.motors.swings:.1g} times a second with growing "
        "swings"
    )


def of_pegged(evidence: Evidence) -> str:
    return f"the motors were at their limit for {percent(evidence.motors.pegged)} of the last second; {sound(evidence)}"


def at_limit(evidence: Evidence) -> str:
    return f"the motors were at their limit for {percent(evidence.motors.saturated)} of the last excursion"


def nothing(evidence: Evidence) -> str:
    """Why no other cause is likely."""
    return f"{sound(evidence)}; nothing else in the log is large enough"


def sound(evidence: Evidence) -> str:
    """Whether anything is left that no hypothesis explains."""
    nis = evidence.pushes_only.nis
    if evidence.run.robot.noise and nis < SOUND * evidence.ordinary:
        return f"nothing beyond the noise of its calibration shows (NIS {nis:.2g})"
    if nis < SOUND * evidence.ordinary < SOUND * FOREIGN:
        return f"robot and sensors are sound (NIS {nis:.2g} apart from pushes)"
    return f"no single fault explains the innovations (NIS {nis:.2g})"


def of_leftover(evidence: Evidence, left: Leftover) -> str:
    """What is left where no known cause explains a fall: by which channel it enters, and since when."""
    place, unit = _PLACES.get(left.channel, (f"a wrong reading of the {left.channel}", "rad"))
    if "gyro" in left.channel or "rate" in left.channel:
        unit = "rad/s"
    if not len(left.values):
        return f"what is left looks like something rapid, most like {place}, from t = {left.onset:.2f} s on"
    size = motor_gain(evidence.run.robot) if "motor" in left.channel else 1.0
    return (
        f"what is left looks like {place} from t = {left.onset:.2f} s on, up to "
        f"{np.abs(size * left.values).max():.2g} {unit}"
    )


def percent(fraction: float) -> str:
    return f"{100 * fraction:.0f} %" if fraction >= 0.005 or fraction == 0 else f"{100 * fraction:.1g} %"


def most(fraction: float) -> str:
    """A fraction near one without rounding it to all."""
    return f"{100 * min(fraction, 0.999):.3g} %"
