"""Commands that are no volts: a duty, of which full number and of what voltage, or millivolts."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.checkup.duty import (
    ALIKE,
    USUAL_BATTERY,
    CommandUnit,
    as_likely,
    back_emf,
    battery_of,
    command_units,
    counted,
    largest_command,
)
from upright.checkup.finding import BATTERY, Finding, Fix, Record, error, note
from upright.checkup.physics import motion
from upright.checkup.units import expected
from upright.logs.mapping import COMMANDS, GUESS, Mapping, full_duty
from upright.logs.readers import RawTable
from upright.robots import Robot

_VOLTS = ("volts", "millivolts")


def commands(record: Record, robot: Robot | None = None) -> list[Finding]:
    """Per cent or millivolts instead of volts: by battery voltage, back-EMF and magnitude. What full duty is, and of
    which voltage, is asked where neither log nor robot tells it."""
    names = record.commands
    m = motion(record)
    if names is None or record.torque_driven:
        return []
    largest, battery = largest_command(record, names), battery_of(record, robot)
    if not largest:
        return []  # motors that are off, in any unit
    emf = back_emf(record, m, robot) if m is not None else 0.0
    centre, spread = expected(robot)["back_emf"]

    def penalty(unit: CommandUnit) -> float:
        return unit.prior + (((math.log(emf / unit.factor) - centre) / spread) ** 2 / 2 if emf else 0.0)

    units = command_units(record, robot)
    unit = min(units, key=penalty)
    if unit.name == "volts":
        evidence = f"no name says their unit, and they reach {largest:.3g}: N m, a fraction of full duty, or V"
        which = note("units/command", names[0], evidence, "state it in a mapping: V, N m or %, and its scale")
        return [which] if record.unnamed and largest <= 1 and not emf else []
    duty = record.units.get(names[0]) == "1"  # by its name
    if not emf and not duty and not counted(record[names[0]]) and (others := as_likely(units, unit)):
        which = " or ".join(one.name.rstrip(",") for one in (unit, *others))
        evidence = f"no volts, since they reach {largest:.3g}: {which}; without wheels that turn nothing tells which"
        return [error("units/command", names[0], evidence, "state the unit in a mapping: V, mV or %, and its scale")]
    alike = [u for u in units if u is not unit and penalty(u) < penalty(unit) + ALIKE and u.name not in _VOLTS]
    repair, fixes = _repair(record, unit, alike, largest, battery)
    name = "a duty" if "full duty" in repair else unit.name
    evidence = f"{name} instead of volts: they reach {largest:.3g}" + (
        f" on a battery of {battery:.3g} V" if battery else ""
    )
    if emf:
        evidence += (
            f"; back-EMF {emf:.3g} V s/rad as logged, {emf / unit.factor:.3g} V s/rad with {unit.name.rstrip(',')}"
        )
    return [error("units/command", names[0], evidence, repair, *fixes)]


def _repair(
    record: Record, unit: CommandUnit, alike: Sequence[CommandUnit], largest: float, battery: float
) -> tuple[str, tuple[Fix, ...]]:
    """How commands in `unit` become volts, or the question where `alike` units, or no battery, leave that open."""
    names = record.commands or ()
    channels = (*names, *(n for n in ("command/left", "command/right") if n in record and n not in names))
    by_volts = Fix("scale", channels, (1 / unit.factor,))
    if unit.name == "millivolts":
        return f"divide by {unit.factor:.4g}", (by_volts,)
    full, *others = (u.factor * (battery or USUAL_BATTERY) for u in (unit, *alike))
    # a duty that is reached is full
    asked = [f"what full duty is: {_or(sorted([full, *others]))}"] if others and largest < full else []
    asked += [] if battery else ['of what voltage: [constants] "sensor/battery" = …, or --robot with its kit']
    if asked:
        return f"state in a mapping {'; and '.join(asked)}", ()
    if BATTERY not in record:
        return f"multiply by the {battery:.4g} V of the kit over {full:g}", (by_volts,)
    fixes = (Fix("scale", channels, (100 / full,)),) if full != 100 else ()
    return f"multiply by the battery over {full:g}", (*fixes, Fix("percent", (*channels, BATTERY)))


def _or(fulls: Sequence[float]) -> str:
    *most, last = (f"{full:g}" for full in fulls)
    return f"{', '.join(most)} or {last}"


def assumed(mapping: Mapping, table: RawTable) -> list[Finding]:
    """What was taken for full duty where a mapping by names makes volts of a duty that never is full."""
    sources = {name: s for name, s in mapping.channels.items() if name in COMMANDS and s.times}
    findings: list[Finding] = []
    for name, source in sources.items() if mapping.name == GUESS else ():
        values = np.abs(table.columns[source.column])
        full = full_duty(values)
        largest = float(np.nanmax(values))
        if largest < full and "percent" not in source.column.lower():
            evidence = f"'{source.column}' is taken for a duty of which {full:g} are full: it reaches {largest:.4g}"
            findings.append(note("units/duty", name, evidence, "if another number is full, state it in a mapping"))
    return findings
