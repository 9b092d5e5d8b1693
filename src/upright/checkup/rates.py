"""A controller that runs at a higher rate than the log."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from upright.checkup.delays import command_delay
from upright.checkup.finding import Finding, Record, note, plain, warning
from upright.checkup.physics import Resampled, backward_rate, motion, responses
from upright.logs.outliers import grain_of
from upright.pages import Quantity, Say

_SURE = 3.0  # standard deviations by which the response must be too small
_GRAINS = 3.0  # [quantisation steps of the command] a smaller unpredictable part is rounding in the driver
_LAW = 0.98  # R² of the motor equation above which its lag is accurate to a few hundredths of a row
_SHARP = 2.0  # smallest sharpness of the lag: a slow motion fits any lag
SHOWN = 3  # lines without a row that are quoted
_WHOLE = 0.6  # [rows] of lead from which a whole row is likelier than a part of one
_EARLY = 0.05  # [rows] tolerated lead of the wheels over a held command
AT_ITS_RATE = Say("Log at the controller's rate: one-step regression on this log is biased.")


def faster_controller(record: Record) -> list[Finding]:
    """Wheels that respond before the command, or hardly at all to its unpredictable part."""
    m = motion(record)
    if m is None or m.commands is None or record.torque_driven or (m.gyro is not None and m.law.pushed):
        return []
    return _too_early(m) or _swallowed(m)


def stated(decimation: tuple[int, str], findings: Sequence[Finding]) -> list[Finding]:
    """Rows that the file itself says were left out."""
    one_in, words = decimation
    if one_in == 1 or any(finding.code == "samples/controller" for finding in findings):
        return []
    evidence = Say("One row in {n} was logged, as the file says: {words}.", n=one_in, words=words)
    return [warning("samples/controller", "command", evidence, AT_ITS_RATE)]


def skipped(lines: Sequence[str]) -> list[Finding]:
    """Lines of a file that are no rows."""
    if not lines:
        return []
    evidence = Say("Lines without a row: {n}, as {lines}.", n=len(lines), lines=lines[:SHOWN])
    return [note("rows/skipped", "t", evidence, None)]


def _too_early(m: Resampled) -> list[Finding]:
    """An effect before its cause: a command held from row to row acts half a row later in the mean, and no dead time is
    negative; a command that changes between the rows acts earlier."""
    assert m.commands is not None
    fit = m.drive
    if fit.r2 < _LAW or fit.sharp < _SHARP or fit.lag > -_EARLY * m.period:
        return []
    evidence = Say(
        "The wheels lead the commands by {lead} of {period}, which no dead time does.",
        lead=Quantity(-fit.lag, "s"),
        period=Quantity(m.period, "s"),
        r2=plain(fit.r2),
    )
    acted = Say("Log the command that acts from the row on, not the one before.")
    repair = acted if -fit.lag > _WHOLE * m.period else AT_ITS_RATE
    return [warning("samples/controller", "command", evidence, repair)]


def _swallowed(m: Resampled) -> list[Finding]:
    """Wheels that hardly respond to the unpredictable part of a logged command.

    The unpredictable part of a held command moves the wheels as the motor equation says. Under a faster controller the
    logged value is one of several between two rows, and its effect is smaller. Friction can cause the same, so this is
    a note.
    """
    measured = held(m)
    if measured is None:
        return []
    fraction, spread = measured
    if fraction + _SURE * spread > 1:
        return []
    evidence = Say(
        "A sudden command moves the wheels {part} ± {error} of what it should: faster changes, or friction.",
        part=Quantity(max(fraction, 0), "fraction", digits=2),
        error=Quantity(2 * spread, "fraction", digits=2),
    )
    repair = Say("If the controller is faster, log at its rate: one-step regression on this log is biased.")
    return [note("samples/controller", "command", evidence, repair)]


def held(m: Resampled) -> tuple[float, float] | None:
    """Measured over expected response of the wheels to an unpredictable command, with its standard deviation.

    By the motor equation a unit of command held for one row turns the wheels by T/D in all, with a first-order lag of
    (A − B/q)/D; the part of it within the first three rows is expected at least.
    """
    assert m.commands is not None
    mean, fit, (lag, q) = (m.commands[0] + m.commands[1]) / 2, m.drive, m.alignment
    if fit.r2 < 0.9 or len(fit.values) < 2 or fit.values[1] <= 0:
        return None
    channels = {"wheel": backward_rate(m.wheel, m.period)} | ({"gyro": m.gyro} if m.gyro is not None else {})
    response = responses(m, mean, channels, reach=10).get("wheel")
    if response is None or response.surprise < _GRAINS * max(grain_of(command) for command in m.commands):
        return None
    inertia = fit.values[0] - (fit.values[3] / q if q > 0 and len(fit.values) > 3 else 0.0)
    keep = np.exp(-m.period * fit.values[1] / max(inertia, 0.1 * fit.values[0], 0.05 * m.period * fit.values[1]))
    dead = command_delay(m, lag)
    first = 1 + int((dead or 0.0) / m.period)
    rows = slice(first, first + 3)
    gain, t = response.gain[rows], response.t_value[rows]
    if len(gain) < 3 or not t.all():
        return None
    expected = (1 + (1 - keep) * keep**2 / np.log(keep)) / fit.values[1]
    spread = float(np.sqrt(((gain / t) ** 2).sum()))
    return float(gain.sum() / expected), spread / float(expected)
