"""The draft of a mapping for columns whose names say nothing: how each one behaves, as comments to choose by."""

from __future__ import annotations

from collections.abc import Container

import numpy as np

from upright.arrays import Array
from upright.logs.readers import RawTable

_SURE = 0.9  # correlation from which a column is taken for the rate of another
_EXACT = 0.999999  # correlation of one reading in two units
_EVEN = 0.2  # of its mean: scatter of the steps of a clock
_MOST = 24  # columns that are compared with each other

HEAD = """\
# A draft: no {lacks} was recognised. Choose a column for each channel, and its unit, sign and scale (docs/logs.md).
name = "mine"

[time]
{time}
"""

CHOICES = """
[channels."sensor/encoder_left"]   # wheel relative to the body, forward positive
column = "?"
unit = "deg"

[channels."sensor/encoder_right"]
column = "?"
unit = "deg"

[channels."sensor/gyro"]           # pitch rate, forward positive; a tilt angle with differentiate = true
column = "?"
unit = "deg/s"

[channels."applied/left"]          # command at the motor
column = "?"
unit = "V"

[channels."applied/right"]
column = "?"
unit = "V"
"""


def draft(table: RawTable) -> str:
    """A mapping to be edited, with what each column of `table` looks like."""
    clock = clock_of(table)
    time = (
        f'column = "{clock}"'
        if clock
        else "period = 0.01                      # [s] from row to row: no column is a clock"
    )
    return HEAD.format(lacks="channel" if clock else "time", time=time) + "\n" + looks(table) + "\n" + CHOICES


def still_to_name(lacking: str, known: Container[str]) -> str:
    """What a mapping lacks, as comments to be filled in."""
    same = {"sensor/gyro": "estimate/pitch", "applied/left": "command/left", "applied/right": "command/right"}
    names = {part.split('"')[1]: part for part in CHOICES.strip().split("\n\n")}
    parts = [part for name, part in names.items() if name not in known and same.get(name, name) not in known]
    lines = "\n#\n".join("\n".join(f"# {line}" for line in part.splitlines()) for part in parts)
    return f"\n# Nothing tells which columns are {lacking}. Where they are in the log, add them:\n#\n{lines}\n"


def looks(table: RawTable) -> str:
    """What each column looks like, as comments."""
    lines = [f"#   {name}: {text}" for name, text in behaviour(table).items()]
    return "\n".join(["# What the columns look like:", *lines])


def clock_of(table: RawTable) -> str:
    """The first column that is a clock, '' where none is; one that counts rows only where there is no other."""
    clocks = [name for name, values in table.columns.items() if is_clock(values)]
    return min(clocks, key=lambda name: bool((np.diff(table.columns[name]) == 1).all()), default="")


def behaviour(table: RawTable) -> dict[str, str]:
    """Each column in words: constant, a clock, whole numbers, from where to where, and of which one it is the rate."""
    several = {name: x for name, x in table.columns.items() if np.isfinite(x).all()}
    words = dict.fromkeys(table.text, "text")
    for name, x in table.columns.items():
        words[name] = _alone(x)
    moving = [name for name, x in several.items() if np.ptp(x) > 0 and not is_clock(x)][:_MOST]
    for rate in moving:
        fits = {name: rate_of(several[rate], several[name]) for name in moving if name != rate}
        name = max(fits, key=lambda other: abs(fits[other]), default="")
        if name and abs(fits[name]) > _SURE:
            words[rate] += f"; {'minus ' if fits[name] < 0 else ''}the rate of {name} (correlation {fits[name]:.2f})"
    for name in moving:
        alike = {n: float(np.corrcoef(several[n], several[name])[0, 1]) for n in moving if n != name}
        exact = next((n for n, r in alike.items() if abs(r) > _EXACT and moving.index(n) < moving.index(name)), "")
        if exact:
            times = np.std(several[name]) / np.std(several[exact]) * np.sign(alike[exact])
            words[name] += f"; {times:.4g} times {exact}"
        same = [n for n, r in alike.items() if r > _SURE and n != exact]
        words[name] += f"; moves with {', '.join(same)}" if same else ""
    return {name: words[name] for name in (*table.columns, *table.text)}


def _alone(x: Array) -> str:
    fine = x[np.isfinite(x)]
    if not len(fine):
        return "no numbers"
    if np.ptp(fine) == 0:
        return f"always {fine[0]:g}"
    kind = "a clock, " if is_clock(x) else "whole numbers, " if (fine == np.rint(fine)).all() else ""
    return f"{kind}{fine.min():g} to {fine.max():g}, steps of {np.median(np.abs(np.diff(fine))):.3g}"


def is_clock(x: Array) -> bool:
    """Whether a column rises evenly, but for a few pauses."""
    steps = np.diff(x)
    if len(steps) < 3 or not np.isfinite(steps).all() or steps.min() <= 0:
        return False
    return bool(np.median(np.abs(steps - np.median(steps))) < _EVEN * np.median(steps))


def rate_of(rate: Array, angle: Array) -> float:
    """Correlation of a column with the steps of another, over one row and over three."""
    best = 0.0
    for rows in (1, 3):
        if len(angle) <= 2 * rows + 2:
            continue
        step = angle[2 * rows :] - angle[: -2 * rows]
        middle = rate[rows : len(rate) - rows]
        if np.ptp(step) > 0 and np.ptp(middle) > 0:
            r = float(np.corrcoef(step, middle)[0, 1])
            best = r if abs(r) > abs(best) else best
    return best
