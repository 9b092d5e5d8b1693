"""A recorded run: strictly increasing time, named channels with units, and where they came from."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, read_only
from upright.errors import InvalidLog
from upright.languages import translated
from upright.pages import Column, Page, Quantity, Say, Table
from upright.signals import files
from upright.signals.header import Columns
from upright.signals.signal import KNOWN, STATE_NAMES, Signal

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame
    from xarray import Dataset


PLOTTED = r"^(truth|estimate)/(pitch|wheel)$|^applied/"
"""The channels of a plot where none are named."""


@dataclass(frozen=True, eq=False, repr=False)
class Log:
    """Time `t` [s], shape (n,), and `channels`: name → values, shape (n,).

    Arrays are copied and read-only. `units` gives the unit of channels that are not in the catalogue, or differ from
    it. `origin` is the provenance of the log, as JSON: robot, body, controller with its hash, scenario, seed, versions.

    Raises `InvalidLog` for no samples, unequal lengths, NaN in time, or time that does not increase.

    >>> log = Log([0.0, 0.01], {"truth/pitch": [0.0, 0.1]})
    >>> log["truth/pitch"].tolist(), log.unit("truth/pitch"), log.period
    ([0.0, 0.1], 'rad', 0.01)
    """

    t: Array
    channels: Mapping[str, Array]
    units: Mapping[str, str] = field(default_factory=dict)
    origin: Mapping[str, Any] = field(default_factory=dict)

    def __init__(
        self,
        t: ArrayLike,
        channels: Mapping[str, ArrayLike],
        units: Mapping[str, str] | None = None,
        origin: Mapping[str, Any] | None = None,
    ) -> None:
        time = _column("t", t)
        columns = {name: _column(name, values) for name, values in channels.items()}
        _check(time, columns)
        units = units or {}
        known = {name: units.get(name, KNOWN[name].unit if name in KNOWN else "") for name in columns}
        object.__setattr__(self, "t", time)
        object.__setattr__(self, "channels", columns)
        object.__setattr__(self, "units", known)
        object.__setattr__(self, "origin", json.loads(json.dumps(origin or {})))

    def __repr__(self) -> str:
        return f"Log({len(self)} samples, {self.t[-1] - self.t[0]:.4g} s, {len(self.channels)} channels)"

    def _repr_html_(self) -> str:
        from upright.pages.html import fragment

        rows = [[f"`{n}`", self.units[n], Quantity(x.min()), Quantity(x.max())] for n, x in self.channels.items()]
        columns = [Column(Say("channel")), Column(Say("unit")), Column(Say("least")), Column(Say("largest"))]
        length = Quantity(self.t[-1] - self.t[0], "s")
        return fragment(
            Page(Say("Log of {n} samples, {length}", n=len(self), length=length), blocks=[Table(columns, rows)])
        )

    def __len__(self) -> int:
        return len(self.t)

    def __contains__(self, name: object) -> bool:
        return name in self.channels

    def __getitem__(self, name: str) -> Array:
        if name not in self.channels:
            have = ", ".join(sorted(self.channels))
            raise InvalidLog(f"the log has no channel '{name}'", expected=f"one of {have}")
        return self.channels[name]

    __hash__ = None  # type: ignore[assignment]  # equal logs may be far too long to hash

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Log)
            and np.array_equal(self.t, other.t)
            and self.channels.keys() == other.channels.keys()
            and all(np.array_equal(self[n], other[n], equal_nan=True) for n in self.channels)
            and self.units == other.units
            and self.origin == other.origin
        )

    @property
    def period(self) -> float:
        """Median time between samples [s]; a log of one sample has none and raises."""
        if len(self.t) < 2:
            raise InvalidLog("the log has a single sample", expected="at least two, to have a period")
        return float(np.median(np.diff(self.t)))

    def unit(self, name: str) -> str:
        """Unit of a channel, '' where none is known."""
        self[name]
        return self.units[name]

    def signal(self, name: str) -> Signal:
        """The channel's `Signal`, with the unit this log has it in."""
        symbol = KNOWN[name].symbol if name in KNOWN else name
        return Signal(name, self.unit(name), symbol)

    def state(self, prefix: str = "truth") -> Array:
        """The six states as an array (n, 6), from `truth/…` (which no real robot has) or `estimate/…`."""
        return np.column_stack([self[f"{prefix}/{name}"] for name in STATE_NAMES])

    def between(self, start: float, stop: float) -> Log:
        """The part with start ≤ t < stop [s], time unchanged."""
        keep = (self.t >= start) & (self.t < stop)
        channels = {name: values[keep] for name, values in self.channels.items()}
        return Log(self.t[keep], channels, self.units, self.origin)

    def to_pandas(self) -> DataFrame:
        """The channels as columns over the index `t` [s]."""
        from pandas import DataFrame, Index

        return DataFrame(dict(self.channels), index=Index(self.t, name="t"))

    def to_xarray(self) -> Dataset:
        """The channels as variables over the coordinate `t` [s], each with its unit; the origin as JSON."""
        from xarray import Dataset

        variables = {name: ("t", values, {"units": self.units[name]}) for name, values in self.channels.items()}
        return Dataset(variables, {"t": ("t", self.t, {"units": "s"})}, {"origin": json.dumps(dict(self.origin))})

    def plot(self, *channels: str) -> Figure:
        """Channels over time, those of one quantity in one panel (default: pitch, wheel and commands), by matplotlib.

        Raises `InvalidLog` for a channel that the log does not have.
        """
        from upright.plotting import legend, line, panels

        names = channels or tuple(name for name in self.channels if re.search(PLOTTED, name)) or tuple(self.channels)
        groups: dict[tuple[str, str], list[str]] = {}
        for name in names:
            quantity = re.sub(r"^.*/|_?(left|right)$", "", name).replace("_", " ") or "commands"
            groups.setdefault((quantity, self.unit(name)), []).append(name)
        labels = [
            f"{called(group[0]) if len(group) == 1 else translated(quantity)} [{unit}]"
            for (quantity, unit), group in groups.items()
        ]
        figure, axes = panels(labels)
        for ax, group in zip(axes, groups.values(), strict=True):
            for name in group:
                line(ax, called(name), self.t, self[name])
        return legend(figure)

    def save(self, path: str | Path) -> Path:
        """Write as Parquet, CSV or MCAP, chosen by the suffix; `load` gives back an equal log.

        Raises `InvalidLog` for an unknown suffix, a missing folder, or a channel name that no column can have.

        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     log = Log([0.0, 0.1], {"truth/pitch": [0.0, float("nan")]}, origin={"seed": 1})
        ...     Log.load(log.save(folder + "/run.csv")) == log
        True
        """
        return files.write(Columns(self.t, self.channels, self.units, self.origin), path)

    @classmethod
    def load(cls, path: str | Path) -> Log:
        """Read a log written by `save` (Parquet, CSV or MCAP), or any CSV or Parquet with a column `t` [s].

        Cells that are empty or say NaN are NaN. Raises `InvalidLog`, which names the file and the fault in it.
        """
        return files.read(path, lambda columns: cls(*columns))


SOURCES = {"truth": "truth", "estimate": "estimate", "applied": "applied", "sensor": "", "command": ""}
"""Kind of a channel → where its values come from, in brackets behind its name."""


def called(channel: str) -> str:
    """A channel in words: `truth/pitch_rate` as pitch rate (truth); one of another kind as it is."""
    kind, _, name = channel.partition("/")
    if kind not in SOURCES:
        return channel
    side = f"{name} command" if kind in ("command", "applied") else name.replace("_", " ")
    words = translated(side)
    return str(Say("{name} ({source})", name=words, source=translated(SOURCES[kind]))) if SOURCES[kind] else words


def _column(name: str, values: ArrayLike) -> Array:
    column = read_only(values)
    if column.ndim != 1:
        raise InvalidLog(f"channel '{name}' has shape {column.shape}", expected="one number per sample")
    return column


def _check(time: Array, columns: Mapping[str, Array]) -> None:
    if len(time) == 0:
        raise InvalidLog("the log holds no samples", expected="at least one row", likely="an empty recording")
    for name, column in columns.items():
        if len(column) != len(time):
            raise InvalidLog(
                f"channel '{name}' has {len(column)} samples but t has {len(time)}", expected="equal lengths"
            )
    if not np.isfinite(time).all():
        row = int(np.argmin(np.isfinite(time)))
        raise InvalidLog(f"t is {time[row]} at row {row}", expected="seconds", hint="drop that row")
    steps = np.diff(time)
    if (steps <= 0).any():
        row = int(np.argmax(steps <= 0)) + 1
        raise InvalidLog(
            f"t goes from {time[row - 1]:g} to {time[row]:g} s at row {row}",
            expected="strictly increasing seconds",
            likely="repeated rows, or two recordings in one file",
            hint="sort and drop repeats, or split the file there",
        )
