"""The electronics that a calibration has learnt: dead times, two motors that differ, a dead zone, and a drop."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from upright.calibration.calibration import Calibration
from upright.calibration.electronics import ASYMMETRY, BATTERY, DEAD_ZONE, DROP, MISALIGNED
from upright.calibration.resonance import DAMPING, FREQUENCY
from upright.logs.recording import SENSOR
from upright.robots import Kit

OWN = "calibrated"  # name of electronics that were none before


def learnt_kit(result: Calibration, kit: Kit, delays: Mapping[str, float], hidden: float) -> Kit:
    """`kit` with what the log shows of its electronics.

    `delays` [s] are those of the sensors before the calibration, `hidden` [s] the dead time that a log of applied
    commands does not show. The time that all sensors are behind the command counts as the command's, with no more
    jitter than that allows, the rest as each sensor's. A motor that a refused fit turns backwards has no strength.
    """
    learnt = {e.name.removeprefix("delay/"): e.value for e in result.delays}
    delays = {name: learnt.get(name, delay) for name, delay in delays.items()}
    common = max(min(delays.values()), 0.0)
    sensors = {
        name: replace(sensor, delay=max(delays[SENSOR[name]] - common, 0.0)) if SENSOR.get(name) in delays else sensor
        for name, sensor in kit.sensors.items()
    }
    factors = {e.name: e.value for e in result.electronics}
    strength = factors.get(BATTERY, 1.0)
    half = factors.get(ASYMMETRY, 0.0) / 2
    zone = factors.get(DEAD_ZONE, kit.motor.dead_zone)
    drop = factors[DROP] / strength if DROP in factors else kit.motor.drop
    if FREQUENCY in factors and "sensor/gyro" in sensors:
        gyro = replace(sensors["sensor/gyro"], resonance=factors[FREQUENCY], damping=factors[DAMPING])
        sensors |= {"sensor/gyro": gyro}
    if MISALIGNED in factors and "sensor/gyro" in sensors:
        sensors |= {"sensor/gyro": replace(sensors["sensor/gyro"], misalignment=factors[MISALIGNED])}
    sides = {"left": max(strength * (1 - half), 0.0), "right": max(strength * (1 + half), 0.0)}
    motor = replace(kit.motor, **sides, dead_zone=zone, drop=drop)
    behind = max(hidden + common, 0.0)
    jitter = min(kit.jitter, 2 * behind)  # of which half is in every dead time
    name = OWN if kit.name == "ideal" else kit.name
    return replace(kit, name=name, sensors=sensors, motor=motor, delay=behind - jitter / 2, jitter=jitter)
