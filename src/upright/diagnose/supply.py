"""The battery of a log: a kit's file says what such batteries usually have, the log what this one had."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.calibration.electronics import MEASURED
from upright.checkup.finding import BATTERY
from upright.diagnose.innovations import asked_of
from upright.pages import Quantity, Say
from upright.robots import Kit, Robot
from upright.signals import Log

ENDS = 3  # rows in which commands end at one largest value, that show a program's limit


def with_supply(kit: Kit, log: Log, robot: Robot) -> Kit:
    """The kit with the battery of a log where that gives more than the kit's: more is no fault, while commands that end
    too early look like one. A battery that gives less may be the fault, and the kit's stays."""
    shown = as_shown(kit, log, robot)
    return shown if shown.battery.voltage > kit.battery.voltage else kit


def as_shown(kit: Kit, log: Log, robot: Robot) -> Kit:
    """The kit with the battery that a log of commands in volts shows, by its own reading, or else by what a foreign
    program's commands end at; as it is where a log shows neither, or the same voltage."""
    usual = kit.battery
    if robot.command_unit != "V" or not math.isfinite(usual.voltage):
        return kit
    asked = np.abs(np.column_stack([log[name] for name in asked_of(log)]))
    volts, sag = _ends(asked, log) if BATTERY not in log else _measured(np.nan_to_num(asked), log[BATTERY], usual.sag)
    if not (volts > 0 and abs(volts / usual.voltage - 1) > MEASURED):
        return kit
    return kit if BATTERY not in log and volts < usual.voltage else _with(kit, volts, sag)


def of_supply(kit: Kit, used: Kit) -> tuple[Say, ...]:
    """A note, where the kit that was `used` has another battery."""
    volts, usual = used.battery.voltage, kit.battery.voltage
    if volts == usual:
        return ()
    both = {"volts": Quantity(volts, "V"), "usual": Quantity(usual, "V")}
    return (Say("The log's battery, {volts}, is used, and not the kit's, {usual}.", **both),)


def _with(kit: Kit, volts: float, sag: float) -> Kit:
    return replace(kit, battery=replace(kit.battery, voltage=volts, sag=sag))


def _ends(asked: Array, log: Log) -> tuple[float, float]:
    """What both `asked` commands (samples, 2) of a foreign program end at [V], NaN where they do not; no sag, since
    they are what it gives."""
    most = float(np.nanmax(asked, initial=0.0))
    rows = int((asked >= most * (1 - 1e-9)).any(axis=1).sum())
    return (most if rows >= ENDS and "body" not in log.origin else math.nan), 0.0


def _measured(asked: Array, shown: Array, usual: float) -> tuple[float, float]:
    """The voltage without load [V], NaN where it is never shown, and the sag [V for each volt of both commands], by
    least squares; no more than the `usual` one, and that where the load never changes."""
    there = np.isfinite(shown) & (shown > 0)
    if not there.any():
        return math.nan, usual
    load = np.minimum(asked, shown[there].max()).sum(axis=1)
    load = np.concatenate([[0.0], load[:-1]])[there]  # a row's reading precedes its command
    change = load - load.mean()
    squares = float(change @ change)
    sag = float(np.clip(-(change @ shown[there]) / squares, 0.0, usual)) if squares > 0 else usual
    return float(np.median(shown[there] + sag * load)), sag
