"""From evidence to ranked causes: what is asked first, and in which words the answer is given.

The order is that of cause and effect. Commands that were changed by an exact number and a loop that did not run are
plain facts. A robot, sensor or floor that changed comes before pushes and demands, which a good one survives; what is
left is the gain, or saturation, in which every fall ends. Each question takes its part of the probability and leaves
the rest to the next. Numbers without a reason of their own were settled on the tuning runs of
`benchmarks/postmortem.py` (seeds 1000 to 1005 and 9000 to 9005).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from upright.diagnose.evidence import EXCURSION, FOREIGN, Demand, Evidence
from upright.diagnose.fall import LEANING, stuck_sensor
from upright.diagnose.fault_fits import FaultFit, PushEstimate

NO_FALL, CANNOT_TELL = "it did not fall", "cannot tell"
SATURATION, BIAS, DROPPED, SLIP, BATTERY = "saturation", "gyro bias", "dropped samples", "wheel slip", "weak battery"
PUSH, DELAY, LOW, HIGH = "push too large", "delay grown", "gain too low", "gain too high"
STUCK, REVERSED = "sensor stuck", "motor or sensor reversed"
CAUSES = (SATURATION, BIAS, DROPPED, SLIP, BATTERY, PUSH, DELAY, LOW, HIGH, STUCK, REVERSED)

NAMES = {"bias": BIAS, "weak": BATTERY, "delay": DELAY, "slip": SLIP, "dropped": DROPPED}

FACT = 0.98  # probability of what the commands themselves show
LIKELY = 0.95  # most probability of a demand or a steady load, PUSHED of a push: a fault may look like either
PUSHED = 0.97
PEGGED = 0.95  # fraction of the last second at the limit, where a constant command means saturation
GAIN_STEP = 0.03  # |ln| of a gain from which it is another one
EXACT = 0.9999  # fraction of the difference between commands and file that a changed gain explains

SURE, SURE_WIDTH = 15.0, 3.0
"""Nats by which a fault must explain more than pushes alone to be as likely as not, and the width of that step."""

EXPLAINED, LIKE_A_PUSH, EXPLAINED_WIDTH = 0.55, 0.47, 0.04
"""Most NIS that a fault may leave over what pushes alone leave, that a slip may leave beside a push that topples, and
the width of both steps."""

TEMPER = 6.0  # nats that count as one between two faults: neighbouring rows share what is wrong with the model
LARGEST_OFFSET = {"step": 4.0, "ramp": 5.0}  # of a gyro [rad/s, rad/s²]: more is a filter that is lost

LOST_ROWS, LOST_WIDTH = 0.14, 0.02  # fraction of periods without a row that these robots' loops hardly survive
FEW_LOST = 0.05  # below which lost rows are no cause
LOST_BEFORE = 1.2  # times the fraction before: a loop that always loses so many rows has survived them

TOPPLES = 0.3  # [rad] lean that a push must be worth to topple, or
TOPPLES_OF_LARGEST = 0.4  # of the largest lean that the motors bring back
JUMP = 0.22  # [m/s] sudden change of the reference speed that asks too much, or
JUMP_OF_TOP = 0.6  # of the speed at which the motors have no torque left
LIMIT_WIDTH = 0.1  # of these limits: the width of their steps
PUSH_SCORE, PUSH_SCORE_WIDTH = 8.0, 2.0  # nats that a push must add to be one

SATURATED = 0.3  # fraction of the last excursion at the limit from which it counts as saturated
FOREIGN_PEGGED, FOREIGN_WIDTH, FOREIGN_MOST = 0.4, 0.04, 0.7  # fraction of the last second, for another robot
SWINGS = 7.0  # changes of the command's sign a second from which a robot falls by swinging
SAME_GAIN = 0.1  # of one: a gain that the file confirms
GAIN_WITHOUT_FILE, GAIN_WITH_FILE, AT_LIMIT = 0.8, 0.9, 0.5  # probability that is left to the gain, or to saturation
CLEAR = 0.9  # of it for the gain that the fall's shape shows
SOUND = 4.0  # NIS over the ordinary one, below which robot and sensors are sound
LEAST = 1e-4  # of a likelihood, below which a cause is left out

REPAIRS = {
    SATURATION: "reduce the demand (slower changes of speed, less slope), or fit stronger motors or a higher voltage",
    BIAS: "calibrate the gyro at rest before every start; use a controller that estimates the offset (lqg, lqi)",
    DROPPED: "take logging and sockets out of the loop, relieve the bus, and count missed periods with a watchdog",
    SLIP: "clean tyres and floor, use softer tyres, or limit the command to the grip of the floor",
    BATTERY: "charge or change the battery; scale the duty by the measured voltage",
    PUSH: "nothing is broken: push less, or design for larger pushes (see `upright certify`)",
    DELAY: "find the cause of the delay (bus, filter, sensor mode), or design for it",
    LOW: "raise the gain again, or design a new controller (`upright design`)",
    HIGH: "lower the gain again, or design a new controller (`upright design`)",
    STUCK: "check the plug and the cable of the sensor, and whether its wheel is jammed",
    REVERSED: "turn the motor or the sensor round, or its sign in the program's first constants",
    CANNOT_TELL: "",
}


@dataclass(frozen=True)
class Cause:
    """A possible cause: its `likelihood`, since when [s] (NaN: unknown), evidence in words and numbers, the repair."""

    name: str
    likelihood: float
    onset: float
    evidence: str
    repair: str


@dataclass(frozen=True)
class _Answer:
    """What one question gives for a cause before it is weighed against the others."""

    probability: float
    name: str
    onset: float
    evidence: str


def ranked(evidence: Evidence) -> tuple[Cause, ...]:
    """All causes that have some likelihood, the likeliest first."""
    left, odds, best = 1.0, dict[str, float](), dict[str, _Answer]()
    for question in QUESTIONS:
        answers = question(evidence)
        for answer in answers:
            odds[answer.name] = (before := odds.get(answer.name, 0.0)) + left * answer.probability
            if left * answer.probability > before or answer.name not in best:
                best[answer.name] = answer
        left *= 1 - min(sum(answer.probability for answer in answers), 1.0)
    odds[CANNOT_TELL], best[CANNOT_TELL] = left, _Answer(left, CANNOT_TELL, math.nan, _nothing(evidence))
    order = sorted((name for name in odds if odds[name] > LEAST), key=lambda name: -odds[name])
    total = sum(odds[name] for name in order)
    return tuple(
        Cause(name, odds[name] / total, min(best[name].onset, evidence.fell_at), best[name].evidence, REPAIRS[name])
        for name in order
    )


def reversed_causes(notes: Sequence[str], onset: float) -> tuple[Cause, ...]:
    """The causes of a fall in which something worked against its purpose, by what `fall.against` says of it."""
    if not notes:
        return ()
    rest = 1 - LIKELY
    first = Cause(REVERSED, LIKELY, onset, "; ".join(notes), REPAIRS[REVERSED])
    return first, Cause(CANNOT_TELL, rest, onset, "too few rows to tell it from a push", REPAIRS[CANNOT_TELL])


def _step(x: float, width: float) -> float:
    """From 0 to 1 round x = 0 over some `width`s (logistic)."""
    return 1 / (1 + math.exp(-min(max(x / width, -50.0), 50.0)))


def _stuck(evidence: Evidence) -> list[_Answer]:
    """Whether the motors got one and the same command all through the fall."""
    if not evidence.motors.stuck:
        return []
    pegged = evidence.motors.pegged > PEGGED
    name, why = (SATURATION, "the motors were at their limit") if pegged else (DROPPED, "the loop did not run")
    text = f"no command changed in the last {EXCURSION:g} s, while the robot fell: {why}"
    return [_Answer(FACT, name, _since(evidence), text)]


def _stuck_sensor(evidence: Evidence) -> list[_Answer]:
    """Whether a sensor gave one and the same reading up to the fall, while another moved."""
    stuck = stuck_sensor(evidence.run.log, evidence.run.kit, evidence.fell_at)
    if stuck is None:
        return []
    name, since = stuck.channel.removeprefix("sensor/").replace("_", " "), evidence.fell_at - stuck.start
    text = f"the {name} reads {stuck.reading:.3g} in every row of the last {since:.2g} s, while the wheels turn"
    jam = "; a jammed wheel looks alike" if "encoder" in stuck.channel else ""
    return [_Answer(FACT, STUCK, stuck.start, text + jam)]


def _changed_gain(evidence: Evidence) -> list[_Answer]:
    """Whether the recorded commands are the file's times a number."""
    match = evidence.match
    if match is None or match.explained < EXACT or abs(math.log(max(match.gain, 1e-9))) < GAIN_STEP:
        return []
    text = (
        f"the commands are {match.gain:.2f} times those of the controller's file on the same readings; this explains "
        f"{_most(match.explained)} of their difference"
    )
    text += f"; before, they agreed to {_percent(match.misfit)}" if match.known else ""
    return [_Answer(FACT, LOW if match.gain < 1 else HIGH, _since(evidence), text)]


def _lost(evidence: Evidence) -> list[_Answer]:
    """Whether the loop did not run."""
    lost, before = evidence.lost
    if lost <= LOST_BEFORE * before and before > LOST_ROWS / 2:
        lost = min(lost, LOST_ROWS)
    if lost <= FEW_LOST:
        return []
    text = f"{_percent(lost)} of the periods in the last second have no row ({_percent(before)} before): the loop "
    text += "did not run"
    return [_Answer(_step(lost - LOST_ROWS, LOST_WIDTH), DROPPED, evidence.fell_at - 1.0, text)]


def _changed_robot(evidence: Evidence) -> list[_Answer]:
    """Whether a fault of robot, sensors or floor explains the innovations better than pushes alone."""
    best: dict[str, FaultFit] = {}
    for fit in evidence.fits:
        if fit.fault in NAMES and _possible(fit) and fit.score > best.get(fit.fault, fit).score - 1e-9:
            best[fit.fault] = fit
    top = max((fit.score for fit in best.values()), default=0.0)
    weights = {name: math.exp(max((fit.score - top) / TEMPER, -50.0)) for name, fit in best.items()}
    total = sum(weights.values())
    return [
        _Answer(weights[name] / total * _holds(evidence, fit), NAMES[name], fit.onset, _of_fault(evidence, fit))
        for name, fit in best.items()
    ]


def _holds(evidence: Evidence, fit: FaultFit) -> float:
    """How likely a fault is a cause at all: it explains much more than pushes alone, and most of what those leave; a
    slip, which looks like a push, has to leave less where a push would topple by itself."""
    sure = _surer(evidence, fit) * _enough(evidence, fit, EXPLAINED)
    if fit.fault != "slip":
        return sure
    return sure * (1 - _toppled(evidence)[0] * (1 - _enough(evidence, fit, LIKE_A_PUSH)))


def _gained(evidence: Evidence, fit: FaultFit) -> float:
    """Nats by which a fit explains more than pushes alone."""
    return fit.score - max(evidence.pushes_only.score, 0.0)


def _surer(evidence: Evidence, fit: FaultFit) -> float:
    return _step(_gained(evidence, fit) - SURE, SURE_WIDTH)


def _enough(evidence: Evidence, fit: FaultFit, most: float) -> float:
    """Whether it leaves at most such a fraction of the NIS that pushes alone leave."""
    return _step(most - fit.nis / evidence.pushes_only.nis, EXPLAINED_WIDTH)


def _possible(fit: FaultFit) -> bool:
    """Whether a gyro can be off by so much: larger offsets are what pushes look like to a filter that is lost."""
    return fit.fault != "bias" or abs(fit.size) < LARGEST_OFFSET[fit.way]


def _pushed(evidence: Evidence) -> list[_Answer]:
    """Whether a push in the last excursion is worth a lean that topples."""
    chance, lean, push = _toppled(evidence)
    return [_Answer(PUSHED * chance, PUSH, push.start, _of_push(evidence, push, lean))] if push else []


def _toppled(evidence: Evidence) -> tuple[float, float, PushEstimate | None]:
    """How likely pushes topple in the last excursion, the lean [rad] that they are worth, and the largest."""
    toppling, start = evidence.toppling, evidence.fell_at - EXCURSION
    pushes: Sequence[PushEstimate] = [push for push in evidence.pushes_only.pushes if push.start > start]
    if not pushes:
        return 0.0, 0.0, None
    largest = max(pushes, key=lambda push: abs(toppling.lean(push)))
    lean = abs(sum(one for push in pushes if (one := toppling.lean(push)) * toppling.lean(largest) > 0))
    limit = min(TOPPLES, TOPPLES_OF_LARGEST * toppling.largest)
    chance = _step(lean / limit - 1, LIMIT_WIDTH) * _step(largest.score - PUSH_SCORE, PUSH_SCORE_WIDTH)
    return chance, lean, largest


def _steady_load(evidence: Evidence) -> list[_Answer]:
    """Whether a force that stays explains what pushes do not."""
    loads = [fit for fit in evidence.fits if fit.fault == "load"]
    if not loads:
        return []
    fit = max(loads, key=lambda f: f.score)
    text = (
        f"a steady force of {fit.size:+.2g} N at the axle since t = {fit.onset:.2f} s explains "
        f"{_percent(fit.explained)} of the innovations (a slope or a rope?); {_at_limit(evidence)}"
    )
    name = SATURATION if evidence.motors.saturated > SATURATED else PUSH
    chance = LIKELY * _surer(evidence, fit) * _enough(evidence, fit, EXPLAINED)
    return [_Answer(chance, name, fit.onset, text)]


def _demanded(evidence: Evidence) -> list[_Answer]:
    """Whether the reference asked for more than the motors have."""
    demand = evidence.demand
    if demand is None:
        return []
    limit = min(JUMP, JUMP_OF_TOP * demand.top_speed)
    chance = LIKELY * _step(demand.jump / limit - 1, LIMIT_WIDTH)
    return [_Answer(chance, SATURATION, demand.at, _of_demand(evidence, demand))]


def _weak_or_wild(evidence: Evidence) -> list[_Answer]:
    """What is left: the gain, by how the robot fell, unless the file shows that it is right."""
    motors, match, since = evidence.motors, evidence.match, _since(evidence)
    if evidence.ordinary > FOREIGN:
        chance = FOREIGN_MOST * _step(motors.pegged - FOREIGN_PEGGED, FOREIGN_WIDTH)
        return [_Answer(chance, SATURATION, since, _of_pegged(evidence))]
    if match is not None and match.known and abs(match.gain - 1) < SAME_GAIN and evidence.stable is not False:
        text = f"{_sound(evidence)}, the commands are the file's, and {_at_limit(evidence)}"
        return [_Answer(AT_LIMIT, SATURATION, since, text)] if motors.saturated > SATURATED else []
    low = CLEAR if motors.swings < SWINGS and 0.0 < motors.help < 1.0 else 1 - CLEAR
    gain = GAIN_WITHOUT_FILE if match is None else GAIN_WITH_FILE
    return [
        _Answer(gain * low, LOW, since, _of_low(evidence)),
        _Answer(gain * (1 - low), HIGH, since, _of_high(evidence)),
    ]


QUESTIONS: tuple[Callable[[Evidence], list[_Answer]], ...] = (
    _stuck, _stuck_sensor, _changed_gain, _lost, _changed_robot, _pushed, _steady_load, _demanded, _weak_or_wild,
)  # fmt: skip


def _since(evidence: Evidence) -> float:
    return evidence.fell_at - EXCURSION


def _of_fault(evidence: Evidence, fit: FaultFit) -> str:
    """A fault of the robot in words: what it is, since when, and how much of the innovations it explains."""
    return (
        f"{_FAULT_TEXTS[fit.fault](evidence, fit)} since t = {fit.onset:.2f} s explains {_most(fit.explained)} of the "
        f"innovations: NIS falls from {evidence.nis:.3g} to {fit.nis:.3g} ({_gained(evidence, fit):+.0f} nats)"
    )


def _bias_text(_: Evidence, fit: FaultFit) -> str:
    return f"a gyro offset of {fit.size:+.2g} rad/s" + ("" if fit.way == "step" else " that grows by this each second")


def _weak_text(evidence: Evidence, fit: FaultFit) -> str:
    part = "of every command" if fit.way == "pwm" else "as the largest command"
    before, last = evidence.battery
    volts = f" (the battery shows {last:.2f} V after {before:.2f} V)" if math.isfinite(last + before) else ""
    return f"motors that get {_percent(fit.size)} {part}{volts}"


def _delay_text(evidence: Evidence, fit: FaultFit) -> str:
    milliseconds = 1e3 * fit.size * evidence.run.log.period
    return f"{fit.size:.2g} periods ({milliseconds:.0f} ms) more from command to reading"


def _slip_text(_: Evidence, fit: FaultFit) -> str:
    return f"wheels that slip and spin, as on a floor with a friction coefficient of {fit.size:.2g},"


def _dropped_text(_: Evidence, fit: FaultFit) -> str:
    return f"readings that repeat exactly in {_percent(fit.size)} of the rows while the wheels turn,"


_FAULT_TEXTS = {
    "bias": _bias_text, "weak": _weak_text, "delay": _delay_text, "slip": _slip_text, "dropped": _dropped_text,
}  # fmt: skip


def _of_push(evidence: Evidence, push: PushEstimate, lean: float) -> str:
    way = "forward" if push.impulse > 0 else "backward"
    return (
        f"a push {way} of {abs(push.impulse):.2g} N s within {push.stop - push.start:.2g} s at t = {push.start:.2f} s "
        f"explains {_most(evidence.pushes_only.explained)} of the innovations. With later pushes it causes {lean:.2g} "
        f"rad of lean; the motors bring back {min(evidence.toppling.largest, LEANING):.2g} rad at most"
    )


def _of_demand(evidence: Evidence, demand: Demand) -> str:
    top = f", and these motors reach {demand.top_speed:.2f} m/s" if math.isfinite(demand.top_speed) else ""
    return (
        f"the reference speed changed by {demand.jump:.2f} m/s at once at t = {demand.at:.2f} s{top}; "
        f"{_at_limit(evidence)}; robot and commands are sound"
    )


def _of_low(evidence: Evidence) -> str:
    gave = "the motors had torque left"
    if math.isfinite(evidence.motors.help):
        gave = f"the motors gave {evidence.motors.help:.2g} of the torque that stops the fall, and had more"
    return f"{_sound(evidence)}, no push is seen, and the fall grew without swings: {gave}"


def _of_high(evidence: Evidence) -> str:
    return (
        f"{_sound(evidence)}, no push is seen, and the commands changed sign {evidence.motors.swings:.0f} times a "
        "second with growing swings"
    )


def _of_pegged(evidence: Evidence) -> str:
    pegged = _percent(evidence.motors.pegged)
    return (
        f"the motors were at their limit for {pegged} of the last second; to judge other causes, name the right robot"
    )


def _at_limit(evidence: Evidence) -> str:
    return f"the motors were at their limit for {_percent(evidence.motors.saturated)} of the last excursion"


def _nothing(evidence: Evidence) -> str:
    return f"{_sound(evidence)}; no push, demand or change is large enough"


def _sound(evidence: Evidence) -> str:
    """Whether anything is left that no hypothesis explains."""
    nis = evidence.pushes_only.nis
    if nis < SOUND * evidence.ordinary < SOUND * FOREIGN:
        return f"robot and sensors are sound (NIS {nis:.2g})"
    return f"no single fault explains the innovations (NIS {nis:.2g})"


def _percent(fraction: float) -> str:
    return f"{100 * fraction:.0f} %" if fraction >= 0.005 or fraction == 0 else f"{100 * fraction:.1g} %"


def _most(fraction: float) -> str:
    """A fraction near one without rounding it to all."""
    return f"{100 * min(fraction, 0.999):.3g} %"
