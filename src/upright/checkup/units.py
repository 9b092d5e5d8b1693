"""Units: the scale of gyro, encoders and commands that gives a physically possible robot."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Mask
from upright.checkup.counts import DEGREE, STATE_SCALE, encoder_counts, raw_counts, whole_numbers
from upright.checkup.duty import (
    ALIKE,
    FAULT,
    CommandUnit,
    back_emf,
    command_units,
    counted,
)
from upright.checkup.finding import (
    GYRO,
    LEFT,
    RIGHT,
    SPEED,
    STATE,
    Array,
    Finding,
    Fix,
    Record,
    error,
    plain,
    warning,
)  # fmt: skip
from upright.checkup.motion import TRUSTED
from upright.checkup.physics import Resampled, gyro_by_gravity, motion, pitch_slope, smooth, widths
from upright.checkup.poses import LARGEST_OFFSET
from upright.checkup.swings import rests
from upright.logs.outliers import grain_of
from upright.pages import Quantity, Say
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain
from upright.robots import Robot, find_kit
from upright.signals.units import UNITS


@dataclass(frozen=True)
class _Suspect:
    """In which `unit` they may be, and by which factors the gyro and the encoders are then too large: `about` so much,
    where that depends on the robot."""

    unit: Say
    gyro: float = 1.0
    encoder: float = 1.0
    about: bool = False


_SUSPECTS = (
    _Suspect(Say("degrees per second"), gyro=1 / DEGREE),
    _Suspect(Say("tenths of a radian per second"), gyro=10.0),
    _Suspect(Say("gyro degrees converted twice"), gyro=DEGREE),
    _Suspect(Say("milliradians per second"), gyro=1000.0),
    _Suspect(Say("millidegrees per second"), gyro=1000.0 / DEGREE),
    _Suspect(Say("degrees"), encoder=1 / DEGREE),
    _Suspect(Say("tenths of a radian"), encoder=10.0),
    _Suspect(Say("turns"), encoder=1 / math.tau),
    _Suspect(Say("metres of travel"), encoder=0.04, about=True),
    _Suspect(Say("encoder degrees converted twice"), encoder=DEGREE),
    _Suspect(Say("degrees in gyro and encoders"), gyro=1 / DEGREE, encoder=1 / DEGREE),
    _Suspect(Say("degrees converted twice in gyro and encoders"), gyro=DEGREE, encoder=DEGREE),
)
"""One mistake of a program each: who prints degrees prints them everywhere. Usual wheels have a radius of 0.04 m."""

_OF_RPM = tuple(
    _Suspect(Say("{unit} under a name that says rpm", unit=unit), encoder=UNITS["rpm"][0] / factor)
    for unit, factor in (("rad/s", 1.0), ("deg/s", DEGREE), (Say("turns per second"), math.tau), ("m/s", 25.0))
)
"""Instead of those of an angle, for wheels whose speed was read in rpm."""

_SPEEDS = (("rpm", UNITS["rpm"][0]), (Say("degrees per second"), DEGREE), (Say("turns per second"), math.tau))
_OF_SPEED = (
    *(_Suspect(Say("{unit} of the wheels", unit=unit), encoder=1 / factor) for unit, factor in _SPEEDS),
    *(
        _Suspect(
            Say("{unit} of the wheels and degrees per second of the gyro", unit=unit),
            gyro=1 / DEGREE,
            encoder=1 / factor,
        )
        for unit, factor in _SPEEDS
    ),
)
"""The same for wheels whose speed was read, where nothing says in what."""

_COUNTS = 500.0
"""Of 1 rad/s, fewer than any chip of 16 bits has: 940 where its range is ±2000 degrees per second."""

# Logarithms of usual values and their spreads over known robots: q from 1.2 (low, heavy wheels) to 15 (tall, slender),
# p = MgL/(a11 + a12) < g/R, motors of 0.05 to 1.5 V s/rad, pitch of 0.002 to 1 rad, wheels of 0.2 to 40 rad/s,
# encoders of 90 (a wheel with Hall sensors) to 5000 counts a turn.
_USUAL = {
    "q": (math.log(3.0), 0.8),
    "p": (math.log(110.0), 0.9),
    "back_emf": (math.log(0.3), 1.0),
    "pitch": (math.log(0.04), 1.5),
    "wheel_rate": (math.log(3.0), 1.3),
    "grain": (math.log(math.tau / 700), 1.3),
}

_SHORTER = {"q": 1.2, "p": 1.2, "back_emf": 2.4}
"""[s] over the length of a log: the deviation of the logarithms of what is estimated from a short part of real logs."""
_SAME_STEP = 0.02  # of a degree: a step that is one
_FINEST = math.tau / 20000  # [rad] a step of an encoder; smaller ones are of numbers that were computed from it


def expected(robot: Robot | None) -> dict[str, tuple[float, float]]:
    """The usual values, or those of a known robot to within a third."""
    if robot is None:
        return dict(_USUAL)
    a11, a12, a22, _ = mass_matrix(1.0, 0.0, robot)
    known = {
        "q": (a11 + 2 * a12 + a22) / (a11 + a12),
        "p": robot.gravity * robot.body_mass * robot.com_height / (a11 + a12),
    }
    if robot.drive == "voltage":
        known["back_emf"] = motor_damping(robot) / motor_gain(robot)
    return {**_USUAL, **{name: (math.log(value), 0.35) for name, value in known.items() if value > 0}}


def scales(record: Record, robot: Robot | None = None) -> list[Finding]:
    """Scales of gyro and encoders, against each other and against possible robots; without a gyro that works nothing
    says what whole numbers of an encoder are."""
    m = motion(record)
    if m is None or m.gyro is None or m.gyro_name != GYRO:
        return whole_numbers(record)
    fit = m.law
    if fit.r2 < TRUSTED or min(fit.values, default=0.0) <= 0 or rests(record):
        return _of_no_unit(record, m.good, m.gyro)
    return _scaled(record, robot, m, fit.values)


def _scaled(record: Record, robot: Robot | None, m: Resampled, values: tuple[float, ...]) -> list[Finding]:
    """The likeliest mistake where the pendulum equation holds with these values, or counts of which nobody knows what
    one is."""
    assert m.gyro is not None
    doubt = 1 / (float(m.good.sum()) * m.period)
    usual = {n: (at, math.hypot(s, _SHORTER.get(n, 0.0) * doubt)) for n, (at, s) in expected(robot).items()}
    estimated = _estimated(record, m, values)
    units = command_units(record, robot)
    estimated["most q"] = estimated["q"] * math.exp(_SHORTER["q"] * doubt)
    by_gravity = gyro_by_gravity(record, m)
    by_pitch = _gyro_by_pitch(record, m)

    def penalty(s: _Suspect) -> float:
        return _penalty(estimated, usual, by_gravity, by_pitch, units, s)

    as_logged = penalty(_Suspect(Say("none of these")))
    stated = _of_kit(record, robot)
    graded = sorted([(FAULT + penalty(s), i, s) for i, s in enumerate((*_suspects(record), *stated))])
    if graded[0][0] >= as_logged:
        return []
    suspect = graded[0][2]
    odds = as_logged - graded[0][0]
    alike = [s for p, _, s in graded if p < graded[0][0] + ALIKE]
    q = estimated["q"] * suspect.gyro / suspect.encoder
    possible = q > 1 and _fine(estimated, suspect)
    if counted(record[GYRO]) and suspect not in stated and (suspect.gyro >= _COUNTS or not possible):
        return raw_counts(record, estimated["q"], usual["q"])
    counts = suspect.encoder != 1 and suspect not in stated and counted(record[LEFT]) and counted(record[RIGHT])
    wrong = _ambiguous(alike, estimated)
    if len(alike) == 1:
        wrong = _wrong(suspect, estimated, counts=counts, odds=odds, by_gravity=by_gravity)
    if odds < ALIKE:
        return [_perhaps(one) for one in wrong]
    if not counts or (possible and _usual(record, estimated, usual, suspect)):
        return wrong
    unknown = _of_no_unit(record, m.good, m.gyro) if suspect.gyro == 1 else []
    if any(f.channel == GYRO for f in unknown):
        return unknown
    gyro = [f for f in wrong if f.channel == GYRO]
    return gyro + encoder_counts(estimated["q"] * suspect.gyro, usual["q"])


def _suspects(record: Record) -> Sequence[_Suspect]:
    """What may be wrong with the units of a log, as they were read."""
    of_wheels = {"rpm": _OF_RPM, SPEED: _OF_SPEED}.get(record.read.get(LEFT, ""), ())
    return (*(s for s in _SUSPECTS if s.encoder == 1), *of_wheels) if of_wheels else _SUSPECTS


def _of_kit(record: Record, robot: Robot | None) -> Sequence[_Suspect]:
    """Counts of encoders whose number to a turn the known robot's kit states: alone, and beside a gyro in degrees."""
    if robot is None or not (counted(record[LEFT]) and counted(record[RIGHT])):
        return ()
    sensor = find_kit(robot.kit).sensors.get(LEFT)
    if sensor is None or not sensor.quantum or abs(sensor.quantum / DEGREE - 1) < _SAME_STEP:
        return ()
    counts = 1 / sensor.quantum
    turn = plain(math.tau / sensor.quantum, 5)
    both = Say("the kit's counts, {turn} a turn, and the gyro's degrees per second", turn=turn)
    return (
        _Suspect(Say("the kit's counts, {turn} a turn", turn=turn), encoder=counts),
        _Suspect(both, gyro=1 / DEGREE, encoder=counts),
    )


def _usual(
    record: Record, estimated: dict[str, float], usual: dict[str, tuple[float, float]], suspect: _Suspect
) -> bool:
    """Whether whole numbers, read as the suspect says, make a usual robot. Who counts whole degrees in the gyro too, as
    LEGO does, counts degrees of the wheels."""
    spreads = 2.0 if counted(record[GYRO]) else 1.0
    values = {name: estimated[name] * suspect.gyro / suspect.encoder for name in ("q", "p")}
    return all(abs(math.log(x) - usual[name][0]) < spreads * usual[name][1] for name, x in values.items())


_TURNED = 1.5  # [rad] from lean to lean, of a robot that swings as widely as TWIPR does in a log of a second or two
_FASTEST = 35.0  # [rad/s] 2000 degrees per second, the largest range of the chips that people use


def _of_no_unit(record: Record, on: Mask, gyro: Array) -> list[Finding]:
    """Channels that are not in radians, where no motion tells in what: whole numbers of an encoder, and a gyro whose
    mean or largest reading no gyro in rad/s has."""
    findings = whole_numbers(record)
    mean = float(gyro[on].mean())
    most = float(np.abs(gyro).max())
    offset = LARGEST_OFFSET + _TURNED / (float(on.mean() * (record.t[-1] - record.t[0])) or math.inf)
    if abs(mean) > offset or most > _FASTEST:
        evidence = Say(
            "It reaches {most}; a gyro in rad/s reaches {limit} at most.", most=plain(most), limit=plain(_FASTEST)
        )
        if abs(mean) > offset:
            evidence = Say(
                "Its mean is {mean}; that of a gyro in rad/s is {limit} at most.", mean=plain(mean), limit=plain(offset)
            )
        findings.append(error("units/counts", GYRO, evidence, STATE_SCALE))
    return findings


def _estimated(record: Record, m: Resampled, values: tuple[float, ...]) -> dict[str, float]:
    """Estimates from the log as it stands: q, p, pitch, wheel rate, resolutions, and back-EMF of a voltage drive."""
    assert m.gyro is not None
    width = widths(m.period)[-1]
    swing = np.cumsum(smooth(m.gyro, m.period, width)) * m.period
    fast = swing - smooth(swing, m.period, 8 * width)
    estimated = {"q": values[0], "p": values[1], "pitch": 2 * float(fast[m.good].std())}
    estimated["wheel_rate"] = float(np.abs(smooth(m.wheel, m.period, width, 1)[m.good]).mean()) + 1e-6
    estimated["grain"] = min(grain_of(record[LEFT]), grain_of(record[RIGHT]))
    estimated["gyro_grain"] = grain_of(record[GYRO])
    emf = back_emf(record, m)
    return estimated | ({"back_emf": emf} if emf else {})


def _gyro_by_pitch(record: Record, m: Resampled) -> float:
    """The factor by which the gyro is too large according to the estimate of the pitch; 0 where there is none."""
    slope, r2 = pitch_slope(record, m)
    return 1 / slope if r2 > 0.7 and slope > 0 else 0.0


def _penalty(
    estimated: dict[str, float], usual: dict[str, tuple[float, float]], gravity: float, pitch: float,
    units: Sequence[CommandUnit], s: _Suspect,
) -> float:  # fmt: skip
    """Negative log prior density of the robot that results from correcting the suspect's scale, its commands in the
    likeliest of their `units`; an estimate of the `pitch` that contradicts it may have a fault of its own."""
    gyro, wheel = s.gyro, s.encoder
    divide = {"q": wheel / gyro, "p": wheel / gyro, "pitch": gyro, "wheel_rate": wheel, "grain": wheel}
    total = 0.0
    for name, divisor in divide.items():
        if name in estimated:
            value, (centre, spread) = estimated[name] / divisor, usual[name]
            value = max(value, _FINEST) if name == "grain" else value
            total += ((math.log(value) - centre) / spread) ** 2 / 2
    if "back_emf" in estimated:
        centre, spread = usual["back_emf"]
        volts = [(u.prior, math.log(estimated["back_emf"] * wheel / u.factor)) for u in units]
        total += min(prior + ((value - centre) / spread) ** 2 / 2 for prior, value in volts)
    total += 20 * max(1 - estimated.get("most q", estimated["q"]) / divide["q"], 0.0)  # masses are positive: q > 1
    total += 0.0 if _fine(estimated, s) else 8.0
    if gravity:
        total += (math.log(abs(gravity) / gyro) / 0.3) ** 2 / 2
    if pitch:
        alike = [pitch] if gyro == 1 / DEGREE else []  # who prints degrees prints them everywhere
        total += min(FAULT, *((math.log(ratio) / 0.3) ** 2 / 2 for ratio in (pitch / gyro, *alike)))
    return total


def _fine(estimated: dict[str, float], s: _Suspect) -> bool:
    """Whether the sensors resolve enough: no robot balances on twenty counts per turn, nor on steps of 30 °/s."""
    return estimated["grain"] / s.encoder < 0.3 and estimated["gyro_grain"] / s.gyro < 0.5  # [rad] and [rad/s]


_Q = Quantity(None, "1", low=1.2, high=15.0)
"""Usual q of the pendulum equation δ⃛ = −q ψ⃛ + p ψ̇: how fast wheels turn back as the body is thrown forward."""


def _ambiguous(several: Sequence[_Suspect], estimated: dict[str, float]) -> list[Finding]:
    """That a unit is wrong, where several mistakes explain the log about as well."""
    evidence = Say(
        "The wheels turn {q} times as fast as the body; usual is {usual}. Perhaps: {units}.",
        q=plain(estimated["q"]),
        usual=_Q,
        units=[s.unit for s in several],
        p=plain(estimated["p"]),
    )
    channels = [GYRO] * any(s.gyro != 1 for s in several) + [LEFT] * any(s.encoder != 1 for s in several)
    return [error("units/scale", channel, evidence, STATE) for channel in channels]


def _perhaps(finding: Finding) -> Finding:
    """A mistake of a unit that is hardly likelier than none: a question, and no repair."""
    evidence = Say("Perhaps, by odds below 20 to 1: {evidence}", evidence=finding.evidence)
    return warning(finding.code, finding.channel, evidence, STATE)


def _wrong(s: _Suspect, estimated: dict[str, float], *, counts: bool, odds: float, by_gravity: float) -> list[Finding]:
    """The likeliest mistake of a unit; of encoders in whole numbers (`counts`) it may be counts, too."""
    facts = {
        "unit": s.unit,
        "q": plain(estimated["q"]),
        "usual": _Q,
        "p": plain(estimated["p"]),
        "pitch": Quantity(estimated["pitch"], "rad"),
        "rate": Quantity(estimated["wheel_rate"], "rad/s"),
        "log_odds": plain(odds),
        "by_gravity": plain(abs(by_gravity)),
    }
    evidence = Say("Seems to be in {unit}: the wheels turn {q} times as fast as the body; usual is {usual}.", **facts)
    if s.encoder == s.gyro:
        evidence = Say("Seems to be in {unit}: the body sways by {pitch}, the wheels turn at {rate}.", **facts)
    if s.about:
        return [error("units/scale", LEFT, evidence, Say("State scale 1 over the wheel's radius in a mapping."))]
    groups = (((GYRO,), s.gyro), ((LEFT, RIGHT), s.encoder))
    findings: list[Finding] = []
    for channels, factor in groups:
        if factor == 1:
            continue
        facts = {"unit": s.unit, "factor": plain(factor, 6)}
        repair = Say("Seems to be in {unit}: divide by {factor}.", **facts)
        if counts and channels != (GYRO,):
            repair = Say("Divide by {factor}; of counts, state how many are a turn.", **facts)
        findings.append(replace(divide(channels, evidence, factor), repair=repair))
    return findings


def divide(channels: tuple[str, ...], evidence: Say, divisor: float) -> Finding:
    """That channels are too large by a factor, and the repair."""
    repair = Say("Divide by {factor}.", factor=plain(divisor, 6))
    return error("units/scale", channels[0], evidence, repair, Fix("scale", channels, (1 / divisor,)))
