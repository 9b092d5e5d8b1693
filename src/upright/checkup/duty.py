"""What commands may be in: volts, a duty of the battery, millivolts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from upright.checkup.finding import BATTERY, Array, Record, plain
from upright.checkup.physics import Resampled, motor
from upright.logs.mapping import FULL_DUTIES, full_duty
from upright.pages import Say
from upright.robots import Robot, find_kit

ALIKE = math.log(20)
"""Of two explanations of which neither is likelier by odds of twenty to one, the log does not tell which."""

FAULT = 6.0
"""Prior of a fault in natural log odds: one log in 400 has a given unit wrong."""

UNCLIPPED = 4.0
"""Negative log odds that commands are larger than the battery: one program in fifty logs what its law asked for, before
the limit."""

VOLTS, MILLIVOLTS, PER_CENT = Say("volts"), Say("millivolts"), Say("per cent")
FRACTION = Say("a fraction of full duty")
USUAL_DUTIES = (100.0, 255.0)  # full duty where people program LEGO, and where they program an Arduino: equally usual
LARGER_DUTY = 2.0  # negative log odds that a full duty is a number beyond these and the smallest usual one
USUAL_BATTERY = 7.5  # [V] for the size of commands whose log and robot tell no battery; no repair is made of it


class CommandUnit(NamedTuple):
    """What commands may be in: how many of it are a volt, and the negative log prior of that, by their size alone."""

    name: Say
    factor: float
    prior: float


def command_units(record: Record, robot: Robot | None = None) -> list[CommandUnit]:
    """Volts, a duty or millivolts; a duty alone where a name or the mapping says so, of whatever number is full: a
    robot that stands seldom needs a half of 255."""
    names = record.commands
    if names is None:
        return [CommandUnit(VOLTS, 1.0, 0.0)]
    largest, battery = largest_command(record, names), battery_of(record, robot)

    def size(factor: float) -> float:
        total = (max(0.0, math.log(largest / factor / 9.0)) / 0.6) ** 2 / 2 if largest else 0.0
        return total + UNCLIPPED * (battery > 0 and largest / factor > 1.25 * battery)

    name, full = _duty(record, names, largest)
    duty = CommandUnit(name, full / (battery or USUAL_BATTERY), 0.0)
    if record.units.get(names[0]) == "1":
        larger = [f for f in FULL_DUTIES if f > full > 1]
        rare = {f: 0.0 if f in USUAL_DUTIES else LARGER_DUTY for f in larger}
        return [duty, *(CommandUnit(_counts(f), duty.factor * f / full, rare[f]) for f in larger)]
    others = [(name, duty.factor), (MILLIVOLTS, 1e3)]
    if largest <= 1 and record.unnamed:
        others.append((FRACTION, 1 / (battery or USUAL_BATTERY)))
    if largest > 100 and not counted(record[names[0]]):  # a law's output, not yet rounded to a timer's counts
        most = full_duty(np.array(largest))
        others.append((_counts(most), most / (battery or USUAL_BATTERY)))
    return [
        CommandUnit(VOLTS, 1.0, size(1.0)),
        *(CommandUnit(name, factor, FAULT + size(factor)) for name, factor in others),
    ]


def as_likely(units: Sequence[CommandUnit], best: CommandUnit) -> list[CommandUnit]:
    """What the commands may be as well by their size alone, within odds of twenty to one."""
    return [unit for unit in units if unit is not best and unit.prior < best.prior + ALIKE]


def largest_command(record: Record, names: tuple[str, str]) -> float:
    """Of the rows on the wheels, where there are any: in a fall a law asks for more than any battery has."""
    on = record.on_wheels(record.t)
    rows = np.abs(np.array([record[name][on if on.any() else ...] for name in names]))
    return float(np.nanmax(rows))


def battery_of(record: Record, robot: Robot | None = None) -> float:
    """The battery's voltage [V] by the log, or else by the kit of a known robot; 0 where nothing tells it."""
    if BATTERY in record:
        return float(np.nanmedian(record[BATTERY]))
    voltage = find_kit(robot.kit).battery.voltage if robot is not None else math.inf
    return voltage if math.isfinite(voltage) else 0.0


def _duty(record: Record, names: tuple[str, str], largest: float) -> tuple[Say, float]:
    """What the commands are if they are a duty, and the number that is full: per cent, counts of a timer, which are
    whole numbers, or a fraction."""
    if record.units.get(names[0]) == "1" and largest <= 1:
        return FRACTION, 1.0
    whole = counted(record[names[0]]) or (record.units.get(names[0]) == "1" and largest > 100)
    full = full_duty(np.concatenate([record[name] for name in names])) if whole else 100.0
    return (PER_CENT, 100.0) if full <= 100 else (_counts(full), full)


def _counts(full: float) -> Say:
    return Say("counts of a duty, {full} of which are full", full=plain(full, 4))


def counted(values: Array) -> bool:
    """Whether a channel holds whole numbers, but for those that were interpolated; zeros are whole in any unit."""
    fine = values[np.isfinite(values) & (values != 0)]
    return bool(len(fine) and (fine == np.rint(fine)).mean() > 0.8)


def back_emf(record: Record, m: Resampled, robot: Robot | None = None) -> float:
    """Volts for each rad/s of a steady wheel, by the motor equation; 0 where that does not fit, or the commands are
    torques, or in an unknown unit and not those of a `robot` that is driven by volts."""
    in_volts = robot is not None and robot.drive == "voltage"
    if m.commands is None or record.torque_driven or (record.unnamed and not in_volts):
        return 0.0
    fit = motor(m, (m.commands[0] + m.commands[1]) / 2, m.left, m.right, None)
    return fit.values[1] if fit.r2 > 0.8 and len(fit.values) > 1 else 0.0
