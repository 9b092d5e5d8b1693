"""What the doctor prints of how it read a log: its columns and its poses, in a line each."""

from __future__ import annotations

from collections.abc import Sequence

from upright.checkup.finding import Segment
from upright.logs.mapping import Mapping, Source

MOST_POSES = 12  # in one line
MOST_IGNORED = 20


def columns_line(mapping: Mapping, ignored: Sequence[str]) -> str:
    """Which column was taken for which channel, and which for none."""
    time = _source(mapping.time) if mapping.time.column else f"a row every {mapping.time.period:g} s"
    parts = [f"t = {time}"] + [f"{name} = {_source(source)}" for name, source in mapping.channels.items()]
    more = ", …" if len(ignored) > MOST_IGNORED else ""
    rest = f"; ignored: {', '.join(ignored[:MOST_IGNORED])}{more}" if ignored else ""
    return f"columns: {'; '.join(parts)}{rest}"


def _source(source: Source) -> str:
    done = "integrated" if source.integrate else "differentiated" if source.differentiate else ""
    signed = f"sign of {source.direction}" if source.direction else ""
    notes = ", ".join(note for note in (source.unit, done, signed) if note)
    return f"{'-' if source.sign < 0 else ''}{source.column}" + (f" ({notes})" if notes else "")


def poses_line(several: Sequence[Segment]) -> str:
    """The poses in a line."""
    more = f"; and {len(several) - MOST_POSES} more" if len(several) > MOST_POSES else ""
    return "poses: " + "; ".join(map(str, several[:MOST_POSES])) + more if several else ""
