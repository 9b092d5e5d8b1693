"""Readings that no robot has in the unit that they are read in: a battery, gravity, wheels. And rows written twice."""

from __future__ import annotations

import numpy as np

from upright.checkup import sensors
from upright.checkup.counts import STATE_SCALE
from upright.checkup.duty import counted
from upright.checkup.finding import BATTERY, FEWEST, FORWARD, LEFT, RIGHT, UP, Finding, Record, error, plain, warning
from upright.checkup.poses import FASTEST_WHEEL
from upright.checkup.units import divide
from upright.pages import Quantity, Say

STANDARD_GRAVITY = 9.80665
MOST_VOLTS, LEAST_MILLIVOLTS = 50.0, 2500.0  # of a scooter, and of one lithium cell that is empty


def constants(record: Record) -> list[Finding]:
    """Battery and accelerometer, against usual voltages and gravity."""
    findings: list[Finding] = []
    if BATTERY in record:
        volts = float(np.nanmedian(record[BATTERY]))
        whole = counted(record[BATTERY])
        if whole and (MOST_VOLTS < volts <= 100 or 100 < volts < LEAST_MILLIVOLTS):
            evidence = Say("Whole numbers about {median}: per cent or raw counts, and no volts.", median=plain(volts))
            repair = Say("Leave it out of the mapping, and state the voltage there under [constants].")
            findings.append(error("units/battery", BATTERY, evidence, repair))
        elif 100 < volts < 1e5:
            evidence = Say("The median is {median}: millivolts, and no volts.", median=plain(volts))
            findings.append(divide((BATTERY,), evidence, 1000.0))
    if FORWARD in record and UP in record:
        weight = float(np.nanmedian(np.hypot(record[FORWARD], record[UP])))
        for unit, pull in (("g", 1 / STANDARD_GRAVITY), ("mg", 1000 / STANDARD_GRAVITY)):
            if 0.7 < weight / (pull * STANDARD_GRAVITY) < 1.4:
                evidence = Say(
                    "The median is {median}, so its unit is {unit}: gravity is 9.81 m/s².",
                    median=plain(weight),
                    unit=unit,
                )
                findings.append(divide((FORWARD, UP), evidence, pull))
    return findings


def speeds(record: Record) -> list[Finding]:
    """Wheels that turn faster than any robot's: counts of an encoder that were read as radians."""
    findings: list[Finding] = []
    for name in (name for name in (LEFT, RIGHT) if name in record):
        steps = np.diff(record.t)
        moved = np.abs(np.diff(record[name]))
        rates = moved[(steps > 0) & np.isfinite(moved)] / steps[(steps > 0) & np.isfinite(moved)]
        rate = float(np.percentile(rates, 90)) if len(rates) else 0.0
        if rate > FASTEST_WHEEL:
            evidence = Say(
                "It turns at {rate} or more in a tenth of the rows; no wheel exceeds {limit}.",
                rate=Quantity(rate, "rad/s"),
                limit=Quantity(FASTEST_WHEEL, "rad/s"),
            )
            findings.append(error("units/speed", name, evidence, STATE_SCALE))
    return findings


_REGULAR = 0.95  # of the groups of equal rows that have the commonest size


def repeated(record: Record) -> list[Finding]:
    """Rows that stand several times; where none do, single readings."""
    return _doubled(record) or sensors.repeated(record)


def _doubled(record: Record) -> list[Finding]:
    """Rows that a program writes two or more times each, all readings and commands alike."""
    moving = [x for x in record.channels.values() if np.isfinite(x).all() and np.ptp(x) > 0]
    if len(moving) < 2:
        return []
    first = np.flatnonzero(np.concatenate([[True], np.any(np.diff(moving, axis=1) != 0, axis=0)]))
    sizes = np.diff(first)
    if len(sizes) < FEWEST / 2 or (times := int(np.median(sizes))) < 2 or (sizes == times).mean() < _REGULAR:
        return []
    evidence = Say(
        "Each row stands {times} times: only {n} of {rows} differ from the row before.",
        times=times,
        n=len(first),
        rows=len(record.t),
    )
    return [warning("samples/doubled", "t", evidence, Say("Keep one row of {times}.", times=times))]
