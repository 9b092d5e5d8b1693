"""A controller that runs faster than the log."""

from __future__ import annotations

import numpy as np

from upright.doctor.delays import command_delay
from upright.doctor.finding import Finding, Record, note, warning
from upright.doctor.fixes import grain_of
from upright.doctor.physics import Motion, answers, backward_rate, motion, motor, pendulum

_SURE = 3.0  # standard deviations by which the answer must fall short
_GRAINS = 3.0  # a surprise of less than so many steps of the command is the driver's rounding, not the controller's


_LAW = 0.98  # R² of the motor equation from which its lag is known to a few hundredths of a row
_SHARP = 2.0  # how sharp the lag must be: a slow motion fits any
_EARLY = 0.05  # rows by which the wheels may seem to answer before a command that was held


def faster_controller(record: Record) -> list[Finding]:
    """Wheels that answer before the command, or hardly at all to what is unforeseen in it."""
    m = motion(record)
    if m is None or m.commands is None or record.torque_driven:
        return []
    return _too_early(m) or _swallowed(m)


def _too_early(m: Motion) -> list[Finding]:
    """An effect before its cause: a command that is held from row to row acts half a row late in the mean, and no dead
    time is negative; one that moves on between the rows acts at once."""
    assert m.commands is not None
    mean, lag = (m.commands[0] + m.commands[1]) / 2, 0.0
    if m.gyro is not None:
        law = pendulum(m, m.wheel)
        lag = law.lag if law.r2 > 0.6 else 0.0
    fit = motor(m, mean, m.left, m.right, m.gyro, lag)
    if fit.r2 < _LAW or fit.sharp < _SHARP or fit.lag > -_EARLY * m.period:
        return []
    said = f"the wheels answer {-fit.lag * 1e3:.1f} ms before the command, were it held for {m.period * 1e3:.3g} ms "
    said += f"(motor equation, R² {fit.r2:.3f}): the motors got other commands between the rows"
    repair = "log at the controller's rate; a one-step regression on this log is biased"
    return [warning("samples/controller", "command", said, repair)]


def _swallowed(m: Motion) -> list[Finding]:
    """Wheels that hardly answer to what is unforeseen in a logged command.

    Were a command held from its row to the next, its unforeseen part would move the wheels as the motor equation says.
    Under a faster controller the logged value is only one of several between two rows, and its surprises pass at once.
    Friction can swallow them as well, so this stays a note.
    """
    measured = held(m)
    if measured is None:
        return []
    share, spread = measured
    if share + _SURE * spread > 1:
        return []
    said = (
        f"what is unforeseen in a command moves the wheels only {max(share, 0):.0%} (± {2 * spread:.0%}) as far as if "
    )
    said += f"it were held for {m.period * 1e3:.3g} ms: the motors got other commands between the rows, or friction "
    said += "swallows the small ones"
    repair = "if the controller is faster, log at its rate; a one-step regression on this log is biased"
    return [note("samples/controller", "command", said, repair)]


def held(m: Motion) -> tuple[float, float] | None:
    """Measured over expected answer of the wheels to an unforeseen command, with its standard deviation.

    By the motor equation a unit of command, held for one row and no longer, turns the wheels by T/D in all, after a
    first-order lag of (A − B/q)/D; the first three rows' share of that is what is expected at least.
    """
    assert m.commands is not None
    mean, lag, q = (m.commands[0] + m.commands[1]) / 2, 0.0, 0.0
    if m.gyro is not None:
        law = pendulum(m, m.wheel)
        lag, q = (law.lag, law.values[0]) if law.r2 > 0.6 and law.values else (0.0, 0.0)
    fit = motor(m, mean, m.left, m.right, m.gyro, lag)
    if fit.r2 < 0.9 or len(fit.values) < 2 or fit.values[1] <= 0:
        return None
    seen = {"wheel": backward_rate(m.wheel, m.period)} | ({"gyro": m.gyro} if m.gyro is not None else {})
    answer = answers(m, mean, seen, reach=10).get("wheel")
    if answer is None or answer.surprise < _GRAINS * max(grain_of(command) for command in m.commands):
        return None
    inertia = fit.values[0] - (fit.values[3] / q if q > 0 and len(fit.values) > 3 else 0.0)
    keep = np.exp(-m.period * fit.values[1] / max(inertia, 0.1 * fit.values[0], 0.05 * m.period * fit.values[1]))
    dead = command_delay(m, lag)
    first = 1 + int((dead[0] if dead else 0.0) / m.period)
    rows = slice(first, first + 3)
    gain, t = answer.gain[rows], answer.t_value[rows]
    if len(gain) < 3 or not t.all():
        return None
    expected = (1 + (1 - keep) * keep**2 / np.log(keep)) / fit.values[1]
    spread = float(np.sqrt(((gain / t) ** 2).sum()))
    return float(gain.sum() / expected), spread / float(expected)
