"""Which channel is what, which way it counts, and on which side it sits: decided by the laws of motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.doctor.finding import COMPASS, GYRO, LEFT, RIGHT, Array, Finding, Fix, Record, error
from upright.doctor.physics import Fit, Motion, answers, backward_rate, motion, motor, pendulum, smooth, widths

TRUSTED = 0.6
"""R² from which a law is taken to hold; on measured logs the right hypothesis reaches 0.75 to 0.99."""

_MARGIN = 0.2  # by which the R² of another hypothesis must beat the one that takes the log at its word
_SURE = 8.0  # t-value of an answer that counts as clear


def kinds(record: Record) -> list[Finding]:
    """An angle where a rate should be, or a rate where an angle should be."""
    m = motion(record)
    if m is None or m.gyro is None or m.gyro_name != GYRO or not _moves(m):
        return []
    plain = pendulum(m, m.wheel)
    other = pendulum(m, m.wheel, gyro_order=1)
    as_logged = plain.r2 if _direction(plain) else 0.0
    if other.r2 < TRUSTED or not _direction(other) or other.r2 < as_logged + _MARGIN:
        return []
    shown = f"obey the pendulum's law (R² {other.r2:.2f})"
    if _wheel_is_rate(m):
        said = f"as rates the encoders {shown} and the motor's, as angles they do not ({as_logged:.2f})"
        fix = Fix("integrate", (LEFT, RIGHT))
        return [error("motion/differentiated", LEFT, said, "integrate both encoders", fix)]
    said = f"as angles the gyro's readings {shown}, as rates they do not ({as_logged:.2f})"
    return [error("motion/integrated", GYRO, said, "differentiate it", Fix("differentiate", (GYRO,)))]


def _wheel_is_rate(m: Motion) -> bool:
    """Whether the commands fit the encoders' sums better than the encoders: the pendulum's law cannot tell a gyro
    that was integrated from encoders that were differentiated, the motor's can."""
    if m.commands is None:
        return False
    mean = (m.commands[0] + m.commands[1]) / 2
    summed = [np.cumsum(wheel) * m.period for wheel in (m.left, m.right)]
    plain = max(motor(m, way * mean, m.left, m.right, None).r2 for way in (1, -1))
    return max(motor(m, way * mean, summed[0], summed[1], None).r2 for way in (1, -1)) > plain


def signs(record: Record) -> list[Finding]:
    """Gyro, encoders and commands that count the wrong way.

    The pendulum's law needs q > 0 between gyro and each encoder, the motor's law needs commands that turn the wheels
    forward; what disagrees with both of the others is turned. All turned together is a robot seen from behind,
    and no fault.
    """
    m = motion(record)
    if m is None or not _moves(m):
        return []
    wheels = _against_gyro(m)
    drive = _against_command(m, wheels)
    return _verdict(record, wheels, drive, m.gyro_name)


@dataclass(frozen=True)
class _Wheels:
    """Signs of left and right encoder against the gyro (0: cannot tell), and the worst R² behind them."""

    left: int
    right: int
    r2: float
    q: float


def _against_gyro(m: Motion) -> _Wheels:
    if m.gyro is None:
        return _Wheels(0, 0, 0.0, 0.0)
    fits = [pendulum(m, wheel) for wheel in (m.left, m.right)]
    pair = {+1: pendulum(m, m.wheel), -1: pendulum(m, (m.left - m.right) / 2)}
    best = max(pair.values(), key=lambda fit: fit.r2)
    if best.r2 < TRUSTED or not best.values:
        return _Wheels(0, 0, 0.0, 0.0)
    if best is pair[1]:
        both = _direction(best)
        return _Wheels(both, both, best.r2, best.values[0])
    clear = pair[-1].r2 > pair[1].r2 + _MARGIN and min(fit.r2 for fit in fits) > TRUSTED / 2
    turned = [_direction(fit) for fit in fits]
    if clear and turned[0] == -turned[1]:
        return _Wheels(turned[0], turned[1], best.r2, best.values[0])
    return _Wheels(0, 0, 0.0, 0.0)


def _direction(fit: Fit) -> int:
    """The sign of q; where p disagrees with it the fit says nothing."""
    if len(fit.values) < 2:
        return 0
    q, p = fit.values[:2]
    return int(np.sign(q)) if q * p > 0 else 0


@dataclass(frozen=True)
class _Drive:
    """Signs of left and right command against wheels that count forward, and how this was found."""

    left: int
    right: int
    said: str


def _against_command(m: Motion, wheels: _Wheels) -> _Drive:
    if m.commands is None or _quiet(m.commands[0]) or _quiet(m.commands[1]):
        return _Drive(0, 0, "")
    # Wheels are put right against the gyro first: left and right then mean the same direction.
    left = m.left * (-1 if wheels.left * wheels.right < 0 and wheels.left < 0 else 1)
    right = m.right * (-1 if wheels.left * wheels.right < 0 and wheels.right < 0 else 1)
    sides = _by_answers(m, left, right)
    if sides is not None:
        return sides
    fits: dict[tuple[int, int], Fit] = {}
    for side in ((1, 1), (-1, -1), (1, -1), (-1, 1)):
        fits[side] = motor(m, (side[0] * m.commands[0] + side[1] * m.commands[1]) / 2, left, right, None)
    best = max(fits, key=lambda side: fits[side].r2)
    plain = fits[1, 1].r2
    if fits[best].r2 < TRUSTED or (best != (1, 1) and fits[best].r2 < plain + _MARGIN):
        return _Drive(0, 0, "")
    return _Drive(*best, f"the motor equation fits with R² {fits[best].r2:.2f} when turned, {plain:.2f} as logged")


def _by_answers(m: Motion, left: Array, right: Array) -> _Drive | None:
    """By what an unforeseen command, on both sides the same or opposite, does to the wheels; None if unclear."""
    assert m.commands is not None
    rate = {"wheel": backward_rate((left + right) / 2, m.period)}
    halves = {"same": (m.commands[0] + m.commands[1]) / 2, "opposite": (m.commands[1] - m.commands[0]) / 2}
    clear = dict.fromkeys(halves, 0.0)
    for name, command in halves.items():
        if not _quiet(command):
            answer = answers(m, command, rate | ({"gyro": m.gyro} if m.gyro is not None else {})).get("wheel")
            clear[name] = _first_clear(answer.t_value) if answer is not None else 0.0
    name = max(clear, key=lambda name: abs(clear[name]))
    t = clear[name]
    if t == 0 or min(map(abs, clear.values())) > 0.5 * abs(t):
        return None
    said = f"an unforeseen command, {name} on both sides, turns the wheels "
    said += f"{'forward' if t > 0 else 'backward'} (t = {abs(t):.0f})"
    way = 1 if t > 0 else -1
    return _Drive(way, way, said) if name == "same" else _Drive(-way, way, said)


def _verdict(record: Record, wheels: _Wheels, drive: _Drive, name_of_gyro: str) -> list[Finding]:
    commands = record.commands or ("", "")
    by_gyro = f"q = {wheels.q:.2f} in δ⃛ = −qψ⃛ + pψ̇ (R² {wheels.r2:.2f}), where every robot has q > 0"
    by_motor = drive.said
    found: list[Finding] = []
    if wheels.left * wheels.right < 0:
        name = LEFT if wheels.left < 0 else RIGHT
        found.append(_flip((name,), f"it counts against the other wheel and against the gyro (R² {wheels.r2:.2f})"))
    disagree = wheels.left < 0 and wheels.right < 0
    backwards = drive.left < 0 and drive.right < 0
    if disagree and backwards:
        found.append(_flip((LEFT, RIGHT), f"both encoders count against gyro and commands: {by_gyro}; {by_motor}"))
    elif disagree:
        found.append(_flip((name_of_gyro,), f"it turns against the encoders: {by_gyro}"))
    elif backwards:
        found.append(_flip(commands, f"both commands drive the wheels backwards: {by_motor}"))
    elif drive.left * drive.right < 0:
        found.append(
            _flip((commands[0] if drive.left < 0 else commands[1],), f"it opposes the other motor: {by_motor}")
        )
    return found


def _flip(channels: tuple[str, ...], evidence: str) -> Finding:
    also = tuple(name.replace("applied/", "command/") for name in channels if name.startswith("applied/"))
    return error("motion/flipped", channels[0], evidence, "multiply by −1", Fix("scale", (*channels, *also), (-1.0,)))


def sides(record: Record) -> list[Finding]:
    """Left and right swapped between commands and encoders, or a compass that turns against the encoders."""
    m = motion(record)
    if m is None:
        return []
    turn, found = m.right - m.left, list[Finding]()
    compass = _compass(record, m, turn)
    t = _turn_answer(m, turn)
    if t < -_SURE:
        found.append(_swapped(record, t, compass))
    if compass < -TRUSTED and not found:
        found.append(_flip((COMPASS,), f"it turns against the encoders (correlation {compass:.2f})"))
    return found


def _turn_answer(m: Motion, turn: Array) -> float:
    """t-value of the first clear answer of the wheels' turn to an unforeseen turn command; 0 where there is none.

    Not by the turning equation: without excitation that finds the feedback, whose sign is the opposite one.
    """
    if m.commands is None or _still(m, turn):
        return 0.0
    command = m.commands[1] - m.commands[0]
    if _quiet(command):
        return 0.0
    answer = answers(m, command, {"turn": backward_rate(turn, m.period)}).get("turn")
    return _first_clear(answer.t_value) if answer is not None else 0.0


def _first_clear(t_value: Array) -> float:
    """The t-value of the first row that is clear and half as clear as the clearest."""
    size = np.abs(t_value)
    clear = (size > _SURE) & (size > 0.5 * size.max())
    return float(t_value[int(np.argmax(clear))]) if clear.any() else 0.0


def _swapped(record: Record, t: float, compass: float) -> Finding:
    said = f"each motor turns the other wheel: an unforeseen command to turn left turns them right (t = {t:.0f})"
    if compass > TRUSTED:
        commands = record.commands or ("", "")
        also = ("command/left", "command/right") if "command/left" in record else commands
        pairs = tuple(dict.fromkeys((*commands, *also)))
        said += f"; the compass agrees with the encoders ({compass:.2f}), so it is the commands"
        return error("motion/swapped", commands[0], said, "swap left and right command", Fix("swap", pairs))
    repair = "swap the encoders, or the commands if their cables are wrong"
    return error("motion/swapped", LEFT, said, repair, Fix("swap", (LEFT, RIGHT)))


def _compass(record: Record, m: Motion, turn: Array) -> float:
    """Correlation of the compass's turning with that of the encoders, 0 where neither turns."""
    if COMPASS not in record or not np.isfinite(record[COMPASS]).all():
        return 0.0
    heading = np.interp(m.t, record.t, np.unwrap(record[COMPASS]))
    wide = 4 * widths(m.period)[-1]
    a, b = (smooth(x, m.period, wide, 1) for x in (heading, turn))
    if a.std() < 0.05 or b.std() < 0.05:  # [rad/s] below a compass's grain
        return 0.0
    return float(np.corrcoef(a, b)[0, 1])


def _quiet(command: Array) -> bool:
    return float(command.std()) <= 1e-9 * (1 + float(np.abs(command).max()))


def _still(m: Motion, turn: Array) -> bool:
    return float(smooth(turn, m.period, widths(m.period)[-1]).std()) < 1e-3


def _moves(m: Motion) -> bool:
    return float(m.left.std() + m.right.std()) > 0 and (m.gyro is None or float(m.gyro.std()) > 0)
