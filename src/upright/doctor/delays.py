"""How late each sensor is against the others and against the command, and whether the log holds what the motors got."""

from __future__ import annotations

import numpy as np

from upright.doctor.finding import LEFT, RIGHT, Finding, Fix, Record, warning
from upright.doctor.physics import Answer, Motion, answers, backward_rate, motion, motor, pendulum

CLEAR = 0.9
"""R² of the pendulum's law from which its lag and its misfits mean something; a quiet log drowns in its grain."""

_SURE = 8.0  # t-value of the largest answer from which its first rows are read
_FIRST = 4.0  # t-value from which a row counts as an answer at all
_LATE = 1.5  # periods: up to this a delay is the sampling itself


def delays(record: Record) -> list[Finding]:
    """The gyro against the encoders by the pendulum's law; both against the command by what an unforeseen command does,
    or else by the motor equation."""
    m = motion(record)
    if m is None:
        return []
    found: list[Finding] = []
    lag = 0.0
    if m.gyro is not None:
        fit = pendulum(m, m.wheel)
        if fit.r2 > CLEAR and fit.values and fit.values[0] > 0:
            lag = fit.lag
            found += _between(m, lag, fit.r2)
    if m.commands is not None:
        found += _behind_command(m, lag)
    return found


def _between(m: Motion, lag: float, r2: float) -> list[Finding]:
    if abs(lag) < max(_LATE * m.period, 0.012):
        return []
    late, other = ((m.gyro_name,), "encoders") if lag > 0 else ((LEFT, RIGHT), "gyro")
    milliseconds = f"{abs(lag) * 1e3:.0f} ms"
    said = f"it is {milliseconds} later than the {other}: there the pendulum's law fits best (R² {r2:.2f})"
    fix = Fix("earlier", late, (abs(lag),))
    return [warning("delay/sensor", late[0], said, f"read it {milliseconds} earlier", fix)]


def _behind_command(m: Motion, lag: float) -> list[Finding]:
    """Dead time from the command to the wheels."""
    measured = command_delay(m, lag)
    if measured is None:
        return []
    dead, how = measured
    common = dead + min(lag, 0.0)  # what gyro and encoders share is the input's; the rest has been said of one sensor
    if common < max(2.5 * m.period, 0.02):
        return []
    said = f"the wheels answer {dead * 1e3:.0f} ms and the gyro {(dead + lag) * 1e3:.0f} ms after a command ({how})"
    return [warning("delay/command", "command", said, "give this dead time to the model, or shift the commands")]


def command_delay(m: Motion, lag: float) -> tuple[float, str] | None:
    """Dead time [s] from command to wheels, and how it was found; None where the log cannot tell."""
    assert m.commands is not None
    if m.gyro is not None:
        mean = (m.commands[0] + m.commands[1]) / 2
        answer = answers(m, mean, {"wheel": backward_rate(m.wheel, m.period), "gyro": m.gyro}).get("gyro")
        if answer is not None:
            first = _first(answer)
            if first is not None:
                return max(0.0, first * m.period - lag), f"an unforeseen command, t = {abs(answer.t_value).max():.0f}"
    mean = (m.commands[0] + m.commands[1]) / 2
    fit = motor(m, mean, m.left, m.right, m.gyro, lag)
    if fit.r2 < 0.9:
        return None
    return max(0.0, fit.lag), f"the motor equation, R² {fit.r2:.2f}"


def _first(answer: Answer) -> float | None:
    """Rows until an answer sets in: where it passes from nothing to its first lasting level, by area over the step."""
    t = np.abs(answer.t_value)
    if t.max() < _SURE:
        return None
    start = int(np.argmax(t > max(_FIRST, 0.1 * t.max())))
    if start + 1 >= len(t):
        return None
    level = answer.gain[start + 1]
    share = float(np.clip(answer.gain[start] / level, 0.0, 1.0)) if level else 1.0
    return start - share
