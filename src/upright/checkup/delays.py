"""Delays: gyro against encoders, and both against the command."""

from __future__ import annotations

import numpy as np

from upright.checkup.finding import LEFT, RIGHT, Finding, Fix, Record, note, plain, warning
from upright.checkup.physics import FAR, REACH, Resampled, Response, backward_rate, motion, motor, responses
from upright.pages import Quantity, Say

CLEAR = 0.9
"""R² of the pendulum equation above which its lag and residuals are used; below it, quantisation dominates."""

SHARP = 3.0
"""Sharpness of that lag below which it is not reported: pushes, and friction that holds the wheels, fit a wrong lag
almost as well as the right one."""

_SURE = 8.0  # t-value that the largest response must reach before its onset is read
_FIRST = 4.0  # t-value above which a row belongs to the response


def shortest(period: float) -> tuple[float, float]:
    """From which [s] a delay between gyro and encoders, and one behind the command, is told: shorter ones are an effect
    of sampling every `period` [s]."""
    return max(1.5 * period, 0.012), max(2.5 * period, 0.02)


def delays(record: Record) -> list[Finding]:
    """Delay between gyro and encoders by the pendulum equation; delay behind the command by the response to the
    unpredictable part of the command, or else by the motor equation."""
    m = motion(record)
    if m is None:
        return []
    if m.gyro is not None and m.law.pushed:
        evidence = Say(
            "Pushes move it, {off} standard deviations off the pendulum equation (limit {limit}): no delay is judged.",
            off=round(m.law.off),
            limit=round(FAR),
        )
        repair = Say("Dither, and do not push: `upright excite -o plan.json`.")
        return [note("delay/untold", m.gyro_name, evidence, repair)]
    findings: list[Finding] = []
    lag = 0.0
    if m.gyro is not None:
        fit = m.law
        if fit.r2 > CLEAR and fit.sharp > SHARP and min(fit.values, default=0.0) > 0:
            lag = fit.lag
            findings += _between(m, lag, fit.r2)
    if m.commands is not None:
        findings += _behind_command(m, lag)
    return findings


def _between(m: Resampled, lag: float, r2: float) -> list[Finding]:
    limit = shortest(m.period)[0]
    if abs(lag) < limit:
        return []
    delayed = (m.gyro_name,) if lag > 0 else (LEFT, RIGHT)
    delayed_by = {"delay": Quantity(abs(lag), "s"), "limit": Quantity(limit, "s"), "r2": plain(r2)}
    evidence = Say("It comes {delay} after the encoders; sampling explains up to {limit}.", **delayed_by)
    if lag < 0:
        evidence = Say("They come {delay} after the gyro; sampling explains up to {limit}.", **delayed_by)
    repair = Say("Shift the readings {delay} earlier.", delay=delayed_by["delay"])
    return [warning("delay/sensor", delayed[0], evidence, repair, Fix("earlier", delayed, (abs(lag),)))]


def _behind_command(m: Resampled, lag: float) -> list[Finding]:
    """Dead time from the command to the wheels."""
    dead = command_delay(m, lag)
    limit = shortest(m.period)[1]
    if dead is None or dead + min(lag, 0.0) < limit:  # a delay common to gyro and encoders belongs to the command
        return []
    evidence = Say(
        "The wheels answer a command after {wheels}, the gyro after {gyro}; sampling explains up to {limit}.",
        wheels=Quantity(dead, "s"),
        gyro=Quantity(dead + lag, "s"),
        limit=Quantity(limit, "s"),
    )
    repair = Say("Put this dead time into the model, or shift the commands.")
    return [warning("delay/command", "command", evidence, repair)]


def command_delay(m: Resampled, lag: float) -> float | None:
    """Dead time [s] from command to wheels; None where the log does not determine it."""
    assert m.commands is not None
    if m.gyro is not None:
        mean = (m.commands[0] + m.commands[1]) / 2
        several = responses(m, mean, {"wheel": backward_rate(m.wheel, m.period), "gyro": m.gyro})
        onsets = {name: _first(response) for name, response in several.items()}
        if (first := onsets.get("gyro")) is not None:
            dead = first * m.period - lag
            if (own := onsets.get("wheel")) is not None:
                dead = min(dead, own * m.period)  # wheels that respond at once are not late, whatever the gyro shows
            return max(0.0, dead)
    mean = (m.commands[0] + m.commands[1]) / 2
    fit = motor(m, mean, m.left, m.right, m.gyro, lag)
    if fit.r2 < 0.9 or fit.lag > REACH - 1.5 * m.period:  # the best of the lags that are tried is none of them
        return None
    return max(0.0, fit.lag)


def _first(response: Response) -> float | None:
    """Rows until the response begins, interpolated between the last row without it and the first with its full "
    "level."""
    t = np.abs(response.t_value)
    if t.max() < _SURE:
        return None
    start = int(np.argmax(t > max(_FIRST, 0.1 * t.max())))
    if start + 1 >= len(t):
        return None
    level = response.gain[start + 1]
    fraction = float(np.clip(response.gain[start] / level, 0.0, 1.0)) if level else 1.0
    return start - fraction
