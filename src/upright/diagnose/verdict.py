"""From evidence to ranked causes: what is asked first, and in which words the answer is given.

The order is that of cause and effect. A law that is changed by an exact number and a loop that did not run are plain
facts. A robot, sensor or floor that changed comes before pushes and demands, which a good one survives; what is left is
the gain, or saturation, in which every fall ends. Each question takes its share of the probability and leaves the rest
to the next.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from upright.diagnose.evidence import EXCURSION, FOREIGN, Evidence
from upright.diagnose.fall import LEANING
from upright.diagnose.fits import Fit, Pushed

NO_FALL, CANNOT_TELL = "it did not fall", "cannot tell"
SATURATION, BIAS, DROPPED, SLIP, BATTERY = "saturation", "gyro bias", "dropped samples", "wheel slip", "weak battery"
PUSH, DELAY, LOW, HIGH = "push too large", "delay grown", "gain too low", "gain too high"
CAUSES = (SATURATION, BIAS, DROPPED, SLIP, BATTERY, PUSH, DELAY, LOW, HIGH)

NAMES = {"bias": BIAS, "weak": BATTERY, "late": DELAY, "slip": SLIP, "dropped": DROPPED}
SURE, SHARP = 15.0, 3.0
"""Nats by which a fault must explain more than pushes alone to be as likely as not, and how sharply."""

EXPLAINED, LIKE_A_PUSH = 0.55, 0.47
"""Share of what pushes alone leave of the innovations' squares that a fault may leave at most, and a slip beside a push
that topples."""

TEMPER = 6.0
"""Nats that count as one between two faults: what is wrong with the model is shared by neighbouring rows."""

MOST_OFFSET = {"step": 4.0, "ramp": 5.0}
"""Offset of a gyro [rad/s], and what it may grow by a second, that are still an offset."""

LOST_ROWS = 0.14  # share of periods without a row that a loop of these robots hardly survives
SHOVE = 0.3  # [rad] lean that a push must be worth to topple, or
SHOVE_OF_REACH = 0.4  # of the lean that no motor brings back
JUMP = 0.22  # [m/s] sudden change of the wanted speed that asks too much, or
JUMP_OF_TOP = 0.6  # of the speed at which the motors have nothing left
SWINGS = 7.0  # changes of the command's sign a second, from which a robot falls by swinging
EXACT = 0.9999  # of the difference between commands and law that a changed gain explains

REPAIRS = {
    SATURATION: "ask for less (slower changes of speed, less slope), or fit stronger motors or a higher voltage",
    BIAS: "calibrate the gyro at rest before every start; take a controller that estimates the offset (lqg, lqi)",
    DROPPED: "free the loop and the bus (no logging or sockets in it), and let a watchdog count what is missed",
    SLIP: "clean tyres and floor, take softer tyres, or limit the command to what the floor holds",
    BATTERY: "charge or change the battery; scale the duty by the measured voltage",
    PUSH: "nothing is broken: push less, or design for larger pushes (see `upright certify`)",
    DELAY: "find what became slow (bus, filter, sensor mode), or design for the longer delay",
    LOW: "raise the gain again, or design anew (`upright design`)",
    HIGH: "lower the gain again, or design anew (`upright design`)",
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
class _Said:
    """What one question says of a cause before it is weighed against the others."""

    name: str
    onset: float
    evidence: str


LEAST = 1e-4  # of a likelihood, below which a cause is not worth a line


def ranked(seen: Evidence) -> tuple[Cause, ...]:
    """All causes that have some likelihood, the likeliest first; none where the robot did not fall."""
    if seen.fall is None:
        return ()
    left, found = 1.0, dict[str, tuple[float, _Said]]()
    for question in QUESTIONS:
        answers = question(seen)
        taken = sum(p for p, _ in answers)
        for p, said in answers:
            before, first = found.get(said.name, (0.0, said))
            larger = said if left * p > before else first
            found[said.name] = (before + left * p, larger)
        left *= 1 - min(taken, 1.0)
    found[CANNOT_TELL] = (left, _Said(CANNOT_TELL, math.nan, _nothing(seen)))
    order = sorted((f for f in found.values() if f[0] > LEAST), key=lambda f: -f[0])
    total = sum(p for p, _ in order)
    return tuple(
        Cause(said.name, p / total, min(said.onset, seen.fall.at), said.evidence, REPAIRS[said.name])
        for p, said in order
    )


Answers = list[tuple[float, _Said]]


def _logistic(x: float) -> float:
    return 1 / (1 + math.exp(-min(max(x, -50.0), 50.0)))


def _stuck(seen: Evidence) -> Answers:
    """Whether the motors got one and the same command all through the fall."""
    if not seen.stuck:
        return []
    name, why = (
        (SATURATION, "the motors stood at their limit") if seen.pegged > 0.95 else (DROPPED, "the loop did not run")
    )
    said = f"no command changed in the last {EXCURSION:g} s, while the robot fell: {why}"
    return [(0.98, _Said(name, _since(seen), said))]


def _changed_law(seen: Evidence) -> Answers:
    """Whether the recorded commands are the file's law times a number."""
    law = seen.law
    if law is None or law.share < EXACT or abs(math.log(max(law.gain, 1e-9))) < 0.03:
        return []
    assert seen.fall is not None
    name = LOW if law.gain < 1 else HIGH
    said = (
        f"the commands are {law.gain:.2f} times those of the controller's file on the same readings, which explains "
        f"{_most(law.share)} of their difference"
    )
    said += f"; before, they agreed to {_percent(law.misfit)}" if law.known else ""
    return [(0.98, _Said(name, _since(seen), said))]


def _changed_robot(seen: Evidence) -> Answers:
    """Whether a fault of robot, sensors or floor explains the innovations better than pushes alone."""
    assert seen.none is not None
    usual = max(seen.none.score, 0.0)
    best: dict[str, Fit] = {}
    for fit in seen.fits:
        if fit.fault in NAMES and _possible(fit) and fit.score > best.get(fit.fault, fit).score - 1e-9:
            best[fit.fault] = fit
    if not best:
        return []
    top = max(fit.score for fit in best.values())
    weights = {name: math.exp(max((fit.score - top) / TEMPER, -50.0)) for name, fit in best.items()}
    total = sum(weights.values())
    return [
        (weights[name] / total * _holds(seen, fit, usual), _Said(NAMES[name], fit.onset, _of_fit(seen, fit, usual)))
        for name, fit in best.items()
    ]


def _holds(seen: Evidence, fit: Fit, usual: float) -> float:
    """How likely a fault is a cause at all: it explains more than pushes alone by far, and most of what those leave;
    a slip, which looks much like a push, has to leave less where a push would topple by itself."""
    assert seen.none is not None
    sure = _logistic((fit.score - usual - SURE) / SHARP) * _enough(seen, fit, EXPLAINED)
    if fit.fault != "slip":
        return sure
    toppled = _toppled(seen, seen.none.pushes)[0]
    return sure * (1 - toppled * (1 - _enough(seen, fit, LIKE_A_PUSH)))


def _enough(seen: Evidence, fit: Fit, most: float) -> float:
    """Whether it leaves at most such a share of what pushes alone leave."""
    assert seen.none is not None
    return _logistic((most - fit.left / seen.none.left) / 0.04)


def _possible(fit: Fit) -> bool:
    """Whether a gyro can be off by so much: larger offsets are what pushes look like to a filter that is lost."""
    return fit.fault != "bias" or abs(fit.size) < MOST_OFFSET[fit.way]


def _lost(seen: Evidence) -> Answers:
    """Whether the loop did not run."""
    share, before = seen.lost
    if share <= 1.2 * before and before > LOST_ROWS / 2:
        share = min(share, LOST_ROWS)
    said = f"{_percent(share)} of the periods in the last second have no row ({_percent(before)} before): the loop "
    said += "did not run"
    assert seen.fall is not None
    return [(_logistic((share - LOST_ROWS) / 0.02), _Said(DROPPED, seen.fall.at - 1.0, said))] if share > 0.05 else []


def _shoved(seen: Evidence) -> Answers:
    """Whether a push in the last excursion is worth a lean that topples."""
    assert seen.none is not None
    chance, whole, push = _toppled(seen, seen.none.pushes)
    return [(0.97 * chance, _Said(PUSH, push.start, _of_push(seen, push, whole)))] if push else []


def _toppled(seen: Evidence, pushes: Sequence[Pushed]) -> tuple[float, float, Pushed | None]:
    """How likely such pushes topple in the last excursion, the lean [rad] that they are worth, and the largest."""
    assert seen.fall is not None
    late = [push for push in pushes if push.start > seen.fall.at - EXCURSION]
    if not late:
        return 0.0, 0.0, None
    push = max(late, key=lambda p: abs(seen.worth(p)))
    whole = abs(sum(worth for p in late if (worth := seen.worth(p)) * seen.worth(push) > 0))
    limit = min(SHOVE, SHOVE_OF_REACH * seen.lean_limit)
    return _logistic((whole / limit - 1) / 0.1) * _logistic((push.score - 8) / 2), whole, push


def _steady_load(seen: Evidence) -> Answers:
    """Whether a force that stays explains what pushes do not."""
    assert seen.none is not None
    loads = [fit for fit in seen.fits if fit.fault == "load"]
    if not loads:
        return []
    fit = max(loads, key=lambda f: f.score)
    chance = 0.95 * _logistic((fit.score - max(seen.none.score, 0.0) - SURE) / SHARP) * _enough(seen, fit, EXPLAINED)
    said = f"a steady force of {fit.size:+.2g} N at the axle since t = {fit.onset:.2f} s, such as a slope or a rope, "
    said += f"explains {_percent(fit.share)} of what the model does not foresee"
    name = SATURATION if seen.saturated > 0.3 else PUSH
    said += f"; the motors stood at their limit in {_percent(seen.saturated)} of the last excursion"
    return [(chance, _Said(name, fit.onset, said))]


def _demanded(seen: Evidence) -> Answers:
    """Whether the reference asked for more than the motors have."""
    if not seen.driven:
        return []
    limit = min(JUMP, JUMP_OF_TOP * seen.top_speed)
    chance = 0.95 * _logistic((seen.demand / limit - 1) / 0.1)
    top = f", of at most {seen.top_speed:.2f} m/s that these motors reach" if math.isfinite(seen.top_speed) else ""
    said = (
        f"the wanted speed changed by {seen.demand:.2f} m/s at once at t = {seen.demanded_at:.2f} s{top}; the motors "
        f"stood at their limit in {_percent(seen.saturated)} of the last excursion, and robot and commands are as they "
        "should be"
    )
    return [(chance, _Said(SATURATION, seen.demanded_at, said))]


def _weak_or_wild(seen: Evidence) -> Answers:
    """What is left: the gain, by how the robot fell; not where the file says that it is what it should be."""
    if seen.usual > FOREIGN:
        return [(0.7 * _logistic((seen.pegged - 0.4) / 0.04), _Said(SATURATION, _since(seen), _pegged(seen)))]
    unchanged = seen.law is not None and seen.law.known and abs(seen.law.gain - 1) < 0.1 and seen.stable is not False
    if unchanged:
        return [(0.5, _Said(SATURATION, _since(seen), _at_limit(seen)))] if seen.saturated > 0.3 else []
    slow = seen.swings < SWINGS and 0.0 < seen.help < 1.0
    low = 0.9 if slow else 0.1
    whole = 0.8 if seen.law is None else 0.9
    return [
        (whole * low, _Said(LOW, _since(seen), _of_low(seen))),
        (whole * (1 - low), _Said(HIGH, _since(seen), _of_high(seen))),
    ]


QUESTIONS: tuple[Callable[[Evidence], Answers], ...] = (
    _stuck, _changed_law, _lost, _changed_robot, _shoved, _steady_load, _demanded, _weak_or_wild,
)  # fmt: skip


def _since(seen: Evidence) -> float:
    assert seen.fall is not None
    return seen.fall.at - EXCURSION


def _of_fit(seen: Evidence, fit: Fit, usual: float) -> str:
    """A fault of the robot in words: what it is, since when, and how much of the innovations it explains."""
    words = {
        "bias": _bias_words,
        "weak": _weak_words,
        "late": _late_words,
        "slip": _slip_words,
        "dropped": _dropped_words,
    }
    after = (
        f" explains {_most(fit.share)} of what the model does not foresee: NIS {seen.misfit:.3g} becomes {fit.left:.3g}"
    )
    return f"{words[fit.fault](seen, fit)} since t = {fit.onset:.2f} s{after} ({fit.score - usual:+.0f} nats)"


def _bias_words(_: Evidence, fit: Fit) -> str:
    return f"a gyro offset of {fit.size:+.2g} rad/s" + ("" if fit.way == "step" else " that grows by this each second")


def _weak_words(seen: Evidence, fit: Fit) -> str:
    what = "of every command" if fit.way == "pwm" else "as the largest command"
    early, late = seen.battery
    volts = f" (the battery shows {late:.2f} V after {early:.2f} V)" if math.isfinite(late + early) else ""
    return f"motors that get {_percent(fit.size)} {what}{volts}"


def _late_words(seen: Evidence, fit: Fit) -> str:
    milliseconds = 1e3 * fit.size * seen.found.log.period
    return f"{fit.size:.2g} periods ({milliseconds:.0f} ms) more from command to reading"


def _slip_words(_: Evidence, fit: Fit) -> str:
    return f"wheels that slip, as on a floor that holds {fit.size:.2g} of the weight, spinning as no rolling wheel can,"


def _dropped_words(_: Evidence, fit: Fit) -> str:
    return f"readings that repeat exactly in {_percent(fit.size)} of the rows while the wheels turn,"


def _of_push(seen: Evidence, push: Pushed, lean: float) -> str:
    assert seen.none is not None
    way = "forward" if push.impulse > 0 else "backward"
    return (
        f"a push {way} of {abs(push.impulse):.2g} N s within {push.stop - push.start:.2g} s at t = {push.start:.2f} s "
        f"explains {_most(seen.none.share)} of what the model does not foresee; with what followed it is worth "
        f"{lean:.2g} rad of lean, and the motors bring back {min(seen.lean_limit, LEANING):.2g} rad at most"
    )


def _of_low(seen: Evidence) -> str:
    gave = "the motors had more to give"
    if math.isfinite(seen.help):
        gave = f"the motors gave {seen.help:.2g} of what stops the fall although they had more"
    return f"{_sound(seen)}, no push is seen, and the fall grew without swings: {gave}"


def _of_high(seen: Evidence) -> str:
    return (
        f"{_sound(seen)}, no push is seen, and the commands changed sign {seen.swings:.0f} times a second with "
        "growing swings"
    )


def _at_limit(seen: Evidence) -> str:
    return (
        f"{_sound(seen)}, the commands are the law's, and the motors stood at their limit in "
        f"{_percent(seen.saturated)} of the last excursion"
    )


def _nothing(seen: Evidence) -> str:
    return f"{_sound(seen)}; no push, no demand and no change is seen that is large enough"


def _pegged(seen: Evidence) -> str:
    share = _percent(seen.pegged)
    return f"the motors stood at their limit in {share} of the last second; all else asks for the right robot"


def _sound(seen: Evidence) -> str:
    """Whether anything is left that no hypothesis explains."""
    if _left(seen) < 4 * seen.usual < 4 * FOREIGN:
        return f"robot and sensors are as they should be (NIS {_left(seen):.2g})"
    return f"no single fault explains what the model does not foresee (NIS {_left(seen):.2g})"


def _left(seen: Evidence) -> float:
    return seen.none.left if seen.none else math.nan


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %" if share >= 0.005 or share == 0 else f"{100 * share:.1g} %"


def _most(share: float) -> str:
    """A share near one without rounding it to all."""
    return f"{100 * min(share, 0.999):.3g} %"
