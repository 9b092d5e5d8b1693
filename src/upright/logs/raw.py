"""The entry point for foreign logs: a file of any program as raw sensors and commands in our channels."""

from __future__ import annotations

from os import PathLike
from pathlib import Path

import numpy as np

from upright.logs.mapping import Mapping, apply, find_mapping, propose
from upright.logs.readers import read_table
from upright.signals import Log

LogSource = Log | str | PathLike[str]
"""A log, or the file that holds it."""

RATES = {
    "sensor/encoder_left": "sensor/encoder_rate_left",
    "sensor/encoder_right": "sensor/encoder_rate_right",
}
"""Angle channel → the channel of its rate, for logs that hold the rate instead."""

GYRO, PITCH = "sensor/gyro", "estimate/pitch"


def raw_log(source: LogSource, mapping: Mapping | str | Path | None = None) -> Log:
    """The log in the file `source`, read through `mapping` (default: the one that fits its columns); a `Log` as it is.

    An encoder that the mapping integrates from a logged rate is returned as that rate, since the errors of a rate add
    up in its integral. Without a gyro the rate of the logged pitch estimate stands for it. Raises `InvalidLog` for a
    file that cannot be read, `UnknownName` for an unknown mapping.
    """
    if isinstance(source, Log):
        return source
    table = read_table(source)
    chosen = find_mapping(mapping) if mapping else propose(table)
    log = apply(chosen, table)
    summed = [name for name, column in chosen.channels.items() if name in RATES and column.integrate]
    channels = {name: values for name, values in log.channels.items() if name not in summed}
    for name in summed:
        rate = np.diff(log[name]) / np.diff(log.t)
        channels[RATES[name]] = np.concatenate([rate[:1], rate])
    derived: dict[str, str] = {}
    if GYRO not in channels and PITCH in channels and len(log) > 1:
        channels[GYRO], derived = np.gradient(channels[PITCH], log.t), {GYRO: f"the rate of {PITCH}"}
    units = {name: unit for name, unit in log.units.items() if name in channels}
    origin = {**log.origin, "file": str(source)} | ({"derived": derived} if derived else {})
    return Log(log.t, channels, units | {RATES[name]: "rad/s" for name in summed}, origin)


def named(log: Log) -> str:
    """The file of a log, or what body made it."""
    return str(log.origin.get("file", log.origin.get("body", {}).get("kind", "log")))
