"""Kind, sign and side of each channel, decided by the equations of motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.checkup.delays import CLEAR
from upright.checkup.finding import COMPASS, GYRO, LEFT, RIGHT, Array, Finding, Fix, Record, error, plain
from upright.checkup.physics import (
    LaggedFit,
    Resampled,
    backward_rate,
    gyro_by_gravity,
    motion,
    motor,
    pendulum,
    pitch_slope,
    responses,
    smooth,
    widths,
)
from upright.checkup.swings import rests
from upright.pages import Say

TRUSTED = 0.6
"""R² above which an equation is taken to hold; on measured logs the correct hypothesis reaches 0.75 to 0.99."""

ONE_WHEEL = 0.8  # the same where it holds of one wheel against the other, as a robot that turns on the spot may show
MARGIN = 0.2  # margin in R² by which another hypothesis must exceed that of the log as it stands
SURE = 8.0  # t-value of a clear response
LASTING = 0.25  # of it, in the next row
_AS_WELL = 2.0  # times what the better fit leaves: of 1.4 s of a real log one with q < 0 may leave a little less


def kinds(record: Record) -> list[Finding]:
    """An angle logged instead of a rate, or a rate instead of an angle."""
    m = motion(record)
    if m is None or m.gyro is None or m.gyro_name != GYRO or not _moves(m) or rests(record):
        return []
    law = m.law
    other = pendulum(m, m.wheel, gyro_order=1)
    as_logged = law.r2 if _direction(law) else 0.0
    least = max(TRUSTED if as_logged < TRUSTED else CLEAR, as_logged + MARGIN, law.r2)
    if not law.values or other.r2 < least or not _direction(other):
        return []  # as logged it fits better, though a wheel that friction holds may hide what gravity does
    fits = {"r2": plain(other.r2, 2), "logged": plain(as_logged, 2)}
    if _wheel_is_rate(m):
        evidence = Say("The pendulum equation fits the encoders as rates (R² {r2}), not as angles ({logged}).", **fits)
        fix = Fix("integrate", (LEFT, RIGHT))
        return [error("motion/differentiated", LEFT, evidence, Say("Integrate both encoders."), fix)]
    evidence = Say("The pendulum equation fits the gyro as an angle (R² {r2}), not as a rate ({logged}).", **fits)
    return [error("motion/integrated", GYRO, evidence, Say("Differentiate it."), Fix("differentiate", (GYRO,)))]


def _wheel_is_rate(m: Resampled) -> bool:
    """Whether the commands fit the integrated encoders better than the encoders. The pendulum equation cannot separate
    an integrated gyro from differentiated encoders; the motor equation does."""
    if m.commands is None:
        return False
    mean = (m.commands[0] + m.commands[1]) / 2
    summed = [np.cumsum(wheel) * m.period for wheel in (m.left, m.right)]
    plain = max(motor(m, way * mean, m.left, m.right, None).r2 for way in (1, -1))
    return max(motor(m, way * mean, summed[0], summed[1], None).r2 for way in (1, -1)) > plain


def signs(record: Record) -> list[Finding]:
    """Wrong signs of gyro, encoders and commands.

    The pendulum equation requires q > 0 between gyro and each encoder; the motor equation requires positive commands
    to turn the wheels forward. The channel that disagrees with both others has the wrong sign. All three reversed
    together is the same robot with its front and back exchanged, and no fault.
    """
    m = motion(record)
    if m is None or not _moves(m) or rests(record):
        return []
    wheels = _against_gyro(m)
    drive = _against_command(m, wheels)
    return _verdict(record, m, wheels, drive)


@dataclass(frozen=True)
class _Wheels:
    """Signs of left and right encoder against the gyro (0: undetermined), and the smallest R² behind them."""

    left: int
    right: int
    r2: float
    q: float


def _against_gyro(m: Resampled) -> _Wheels:
    if m.gyro is None:
        return _Wheels(0, 0, 0.0, 0.0)
    pair = {+1: m.law, -1: pendulum(m, (m.left - m.right) / 2)}
    best = max(pair.values(), key=lambda fit: fit.r2)
    if best.r2 < TRUSTED or not best.values:
        return _Wheels(0, 0, 0.0, 0.0)
    if best is pair[1]:
        both = _direction(best)
        alike = both < 0 and 1 - pendulum(m, m.wheel, positive=True).r2 < _AS_WELL * (1 - best.r2)
        return _Wheels(0, 0, 0.0, 0.0) if alike else _Wheels(both, both, best.r2, best.values[0])
    if best.r2 < ONE_WHEEL or pair[-1].r2 < pair[1].r2 + MARGIN:
        return _Wheels(0, 0, 0.0, 0.0)
    left = _direction(best)
    return _Wheels(left, -left, best.r2, best.values[0])


def _direction(fit: LaggedFit) -> int:
    """The sign of q; 0 where p has the other sign, since then the fit is not that of a pendulum."""
    if len(fit.values) < 2:
        return 0
    q, p = fit.values[:2]
    return int(np.sign(q)) if q * p > 0 else 0


@dataclass(frozen=True)
class _Drive:
    """Signs of left and right command against wheels that count forward, and the evidence."""

    left: int
    right: int
    evidence: Say | None = None


def _against_command(m: Resampled, wheels: _Wheels) -> _Drive:
    """By the response to what is unpredictable in the commands, or else by the motor equation. Where that equation
    holds as logged, a response the other way is what the controller does of pushes and of wheels that stick."""
    if m.commands is None or m.gyro is None or _quiet(m.commands[0]) or _quiet(m.commands[1]):
        return _Drive(0, 0)  # what a controller does of a lean that was not logged looks like its surprise
    # Wheels are corrected against the gyro first: left and right then mean the same direction.
    left = m.left * (-1 if wheels.left * wheels.right < 0 and wheels.left < 0 else 1)
    right = m.right * (-1 if wheels.left * wheels.right < 0 and wheels.right < 0 else 1)
    mixed = () if _one_encoder(m) else ((1, -1), (-1, 1))
    answer = _by_responses(m, left, right)
    if answer is not None and (answer.left, answer.right) == (1, 1):
        return answer
    fits: dict[tuple[int, int], LaggedFit] = {}
    for side in ((1, 1), (-1, -1), *mixed):
        fits[side] = motor(m, (side[0] * m.commands[0] + side[1] * m.commands[1]) / 2, left, right, None)
    if answer is not None:
        against = fits[1, 1].r2 > max(TRUSTED, fits[answer.left, answer.right].r2 + MARGIN)
        return _Drive(0, 0) if against else answer
    best = max(fits, key=lambda side: fits[side].r2)
    as_logged = fits[1, 1].r2
    least = TRUSTED if best[0] == best[1] else CLEAR  # what turns alone is little, and its equation leaves out the gyro
    if fits[best].r2 < least or (best != (1, 1) and fits[best].r2 < as_logged + MARGIN):
        return _Drive(0, 0)
    return _Drive(
        *best,
        Say(
            "With the sign changed the motor equation fits (R² {r2}), as logged less ({logged}).",
            r2=plain(fits[best].r2, 2),
            logged=plain(as_logged, 2),
        ),
    )


def _by_responses(m: Resampled, left: Array, right: Array) -> _Drive | None:
    """By the response of the wheels to unpredictable commands, equal or opposite on both sides; None if unclear."""
    assert m.commands is not None
    assert m.gyro is not None
    rate = {"wheel": backward_rate((left + right) / 2, m.period)}
    halves = {"same": (m.commands[0] + m.commands[1]) / 2}
    halves |= {} if _one_encoder(m) else {"opposite": (m.commands[1] - m.commands[0]) / 2}
    clear = dict.fromkeys(halves, 0.0)
    for name, command in halves.items():
        if not _quiet(command):
            response = responses(m, command, rate | {"gyro": m.gyro}).get("wheel")
            clear[name] = _first_clear(response.t_value) if response is not None else 0.0
    name = max(clear, key=lambda name: abs(clear[name]))
    t = clear[name]
    if t == 0 or (len(clear) > 1 and min(map(abs, clear.values())) > 0.5 * abs(t)):
        return None
    way = 1 if t > 0 else -1
    sure = {"t": round(abs(t)), "limit": round(SURE)}
    if name == "same":
        return _Drive(
            way, way, Say("A sudden command turns the wheels backwards (t = {t}, sure from {limit}).", **sure)
        )
    return _Drive(-way, way, Say("A sudden turn drives both wheels one way (t = {t}, sure from {limit}).", **sure))


def _verdict(record: Record, m: Resampled, wheels: _Wheels, drive: _Drive) -> list[Finding]:
    commands = record.commands or ("", "")
    by_motor = drive.evidence or Say("")
    findings: list[Finding] = []
    if wheels.left * wheels.right < 0:
        name = LEFT if wheels.left < 0 else RIGHT
        alone = Say("Its sign is opposite to those of gyro and other wheel (R² {r2}).", r2=plain(wheels.r2, 2))
        findings.append(_flip((name,), alone))
    disagree = wheels.left < 0 and wheels.right < 0
    backwards = drive.left < 0 and drive.right < 0
    if disagree:
        opposite = Say(
            "As logged the wheels turn with a thrown body, {q} times as fast; every robot's turn against it.",
            q=plain(abs(wheels.q)),
        )
        alike = drive.left * (drive.left == drive.right) or -np.sign(gyro_by_gravity(record, m))
        witness = int(alike or pitch_slope(record, m)[0] < 0)
        findings += contrary((m.gyro_name,), (LEFT, RIGHT), opposite, witness)
    elif backwards:
        findings.append(_flip(commands, by_motor))
    elif drive.left * drive.right < 0:
        findings.append(_flip((commands[0] if drive.left < 0 else commands[1],), by_motor))
    return findings


def contrary(one: tuple[str, ...], other: tuple[str, ...], evidence: Say, witness: int) -> list[Finding]:
    """Channels on two sides whose signs contradict each other: the repair of the one against which a third is a
    `witness` (positive: the other is right), or both without a repair where none is (0)."""
    if witness:
        return [_flip(one if witness > 0 else other, evidence)]
    which = Say("Check both signs on the robot, and state the wrong one in a mapping.")
    return [error("motion/contradicted", names[0], evidence, which) for names in (one, other)]


def follows_wheels(m: Resampled) -> int:
    """The sign of the gyro against the wheels, where the pendulum equation tells it; else 0."""
    return _direction(m.law) if m.law.r2 > TRUSTED else 0


def _flip(channels: tuple[str, ...], evidence: Say) -> Finding:
    also = tuple(name.replace("applied/", "command/") for name in channels if name.startswith("applied/"))
    fix = Fix("scale", (*channels, *also), (-1.0,))
    return error("motion/flipped", channels[0], evidence, Say("Multiply by −1."), fix)


def sides(record: Record) -> list[Finding]:
    """Left and right swapped between commands and encoders, or a compass that turns against the encoders."""
    m = motion(record)
    if m is None:
        return []
    turn = m.right - m.left
    findings = list[Finding]()
    compass = _compass(record, m, turn)
    t = _turn_answer(m, turn)
    if t < -SURE:
        findings.append(_swapped(record, t, compass))
    if compass < -TRUSTED and not findings:
        against = Say("It turns against the encoders (correlation {correlation}).", correlation=plain(compass, 2))
        findings.append(_flip((COMPASS,), against))
    return findings


def _turn_answer(m: Resampled, turn: Array) -> float:
    """t-value of the first clear yaw response of the wheels to an unpredictable turn command; 0 where there is none.

    The yaw equation itself is not used: without excitation its regression finds the feedback, of opposite sign.
    """
    if m.commands is None or _still(m, turn):
        return 0.0
    command = m.commands[1] - m.commands[0]
    if _quiet(command):
        return 0.0
    response = responses(m, command, {"turn": backward_rate(turn, m.period)}).get("turn")
    return _first_clear(response.t_value) if response is not None else 0.0


def _first_clear(t_value: Array) -> float:
    """The t-value of the first row that is clear, half as clear as the clearest, and whose next row goes the same way:
    a rate lasts, where a step of an encoder that a command answers is gone in the next row."""
    size = np.abs(t_value)
    after = np.append(t_value[1:], t_value[-1])
    clear = (size > SURE) & (size > 0.5 * size.max()) & (after * np.sign(t_value) > LASTING * size)
    return float(t_value[int(np.argmax(clear))]) if clear.any() else 0.0


def _swapped(record: Record, t: float, compass: float) -> Finding:
    sure = {"t": round(-t), "limit": round(SURE)}
    if compass > TRUSTED:
        commands = record.commands or ("", "")
        also = ("command/left", "command/right") if "command/left" in record else commands
        pairs = tuple(dict.fromkeys((*commands, *also)))
        evidence = Say("Commands to the left turn wheels and compass right (t = {t}, sure from {limit}).", **sure)
        return error("motion/swapped", commands[0], evidence, Say("Swap left and right command."), Fix("swap", pairs))
    evidence = Say("Commands to the left turn the wheels right (t = {t}, sure from {limit}).", **sure)
    repair = Say("Swap the encoders, or the commands if the motor cables are swapped.")
    return error("motion/swapped", LEFT, evidence, repair, Fix("swap", (LEFT, RIGHT)))


def _compass(record: Record, m: Resampled, turn: Array) -> float:
    """Correlation of the yaw rates of compass and encoders; 0 where neither turns."""
    if COMPASS not in record or not np.isfinite(record[COMPASS]).all():
        return 0.0
    heading = np.interp(m.t, record.t, np.unwrap(record[COMPASS]))
    wide = 4 * widths(m.period)[-1]
    a, b = (smooth(x, m.period, wide, 1)[m.good] for x in (heading, turn))
    if a.std() < 0.05 or b.std() < 0.05:  # [rad/s] below the resolution of a compass
        return 0.0
    return float(np.corrcoef(a, b)[0, 1])


def _one_encoder(m: Resampled) -> bool:
    """Whether one encoder stands for both wheels, so that nothing is known of either side."""
    return np.array_equal(m.left, m.right)


def _quiet(command: Array) -> bool:
    return float(command.std()) <= 1e-9 * (1 + float(np.abs(command).max()))


def _still(m: Resampled, turn: Array) -> bool:
    return float(smooth(turn, m.period, widths(m.period)[-1]).std()) < 1e-3


def _moves(m: Resampled) -> bool:
    return float(m.left.std() + m.right.std()) > 0 and (m.gyro is None or float(m.gyro.std()) > 0)
