"""Commands that are no volts: a duty, of which full number and of what voltage, or millivolts."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.checkup.duty import (
    ALIKE,
    MILLIVOLTS,
    USUAL_BATTERY,
    VOLTS,
    CommandUnit,
    as_likely,
    back_emf,
    battery_of,
    command_units,
    counted,
    largest_command,
)
from upright.checkup.finding import BATTERY, Finding, Fix, Record, error, note, plain
from upright.checkup.physics import motion
from upright.checkup.units import expected
from upright.logs.mapping import COMMANDS, GUESS, Mapping, full_duty
from upright.logs.readers import RawTable
from upright.pages import Quantity, Say
from upright.robots import Robot

_STATE = Say("State their unit and scale in a mapping: V, mV, N m or %.")
_DUTY = Say("a duty")


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
    reach = plain(largest)
    if unit.name == VOLTS:
        evidence = Say("They reach {largest}, and no name says their unit: V, N m or a duty.", largest=reach)
        which = note("units/command", names[0], evidence, _STATE)
        return [which] if record.unnamed and largest <= 1 and not emf else []
    duty = record.units.get(names[0]) == "1"  # by its name
    if not emf and not duty and not counted(record[names[0]]) and (others := as_likely(units, unit)):
        evidence = Say(
            "They reach {largest}, no volts; without wheels that turn nothing tells which of these: {units}.",
            largest=reach,
            units=[one.name for one in (unit, *others)],
        )
        return [error("units/command", names[0], evidence, _STATE)]
    alike = [
        u for u in units if u is not unit and penalty(u) < penalty(unit) + ALIKE and u.name not in (VOLTS, MILLIVOLTS)
    ]
    repair, fixes = _repair(record, unit, alike, largest, battery)
    name = _DUTY if "fulls" in repair.facts else unit.name
    evidence = Say("They reach {largest}: {unit} instead of volts.", largest=reach, unit=name, battery=plain(battery))
    if emf:
        evidence = Say(
            "They are {unit} instead of volts: the back-EMF is {emf}, and read as volts {logged}.",
            unit=name,
            emf=Quantity(emf / unit.factor, "V s/rad"),
            logged=Quantity(emf, "V s/rad"),
        )
    return [error("units/command", names[0], evidence, repair, *fixes)]


def _repair(
    record: Record, unit: CommandUnit, alike: Sequence[CommandUnit], largest: float, battery: float
) -> tuple[Say, tuple[Fix, ...]]:
    """How commands in `unit` become volts, or the question where `alike` units, or no battery, leave that open."""
    names = record.commands or ()
    channels = (*names, *(n for n in ("command/left", "command/right") if n in record and n not in names))
    by_volts = Fix("scale", channels, (1 / unit.factor,))
    if unit.name == MILLIVOLTS:
        return Say("Divide by {factor}.", factor=plain(unit.factor)), (by_volts,)
    full, *others = (u.factor * (battery or USUAL_BATTERY) for u in (unit, *alike))
    # a duty that is reached is full
    fulls = sorted(round(one) for one in (full, *others))
    open_ = bool(others) and largest < full
    if open_ and battery:
        return Say("State in a mapping what full duty is, of these: {fulls}.", fulls=fulls), ()
    if open_:
        return Say(
            "State full duty ({fulls}) in a mapping, and the battery: `--robot`, or [constants].", fulls=fulls
        ), ()
    if not battery:
        return Say("State the battery's voltage: `--robot`, or [constants] of a mapping."), ()
    if BATTERY not in record:
        volts = Quantity(battery, "V")
        return Say("Multiply by the kit's {battery} over {full}.", battery=volts, full=plain(full, 4)), (by_volts,)
    fixes = (Fix("scale", channels, (100 / full,)),) if full != 100 else ()
    repair = Say("Multiply by the battery over {full}.", full=plain(full, 4))
    return repair, (*fixes, Fix("percent", (*channels, BATTERY)))


def assumed(mapping: Mapping, table: RawTable) -> list[Finding]:
    """What was taken for full duty where a mapping by names makes volts of a duty that never is full."""
    sources = {name: s for name, s in mapping.channels.items() if name in COMMANDS and s.times}
    findings: list[Finding] = []
    for name, source in sources.items() if mapping.name == GUESS else ():
        values = np.abs(table.columns[source.column])
        full = full_duty(values)
        largest = float(np.nanmax(values))
        if largest < full and "percent" not in source.column.lower():
            evidence = Say(
                "'{column}' reaches {largest}: taken for a duty of which {full} are full.",
                column=source.column,
                largest=plain(largest, 4),
                full=plain(full, 4),
            )
            repair = Say("If another number is full, state it in a mapping.")
            findings.append(note("units/duty", name, evidence, repair))
    return findings
