"""From raw readings to SI units: the start, in which the gyro's offset is found, and every period after it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from upright.compiled.tracer import Form, Tracer
from upright.errors import InvalidController
from upright.firmware.setup import (
    CALIBRATION_TIME,
    FASTEST,
    FLAT_BATTERY,
    GYRO_MARGIN,
    HEADING,
    LEAST_SCATTER,
    SENSOR_FAILED,
    ProgramSetup,
)
from upright.firmware.targets import BATTERY, COMPASS, ENCODERS, GYRO, PITCH, SI, largest


def inputs(t: Tracer, setup: ProgramSetup) -> dict[str, Form]:
    """The raw readings, by channel."""
    reads = setup.linear.reads
    missing = [channel for channel in (*ENCODERS, GYRO) if channel not in reads]
    if missing and PITCH not in reads:
        raise InvalidController(
            f"the controller does not read {missing[0]}", expected="both encoders and the gyro, or a fused angle"
        )
    raws: dict[str, Form] = {}
    for channel in dict.fromkeys((*reads, GYRO)):  # an angle's filter and the start need the gyro
        raw = setup.raw(channel)
        most = largest(setup.kit, channel, setup.travel) / setup.raw(channel).scale
        most *= GYRO_MARGIN if channel == GYRO else 1.0
        name = "raw_" + channel.removeprefix("sensor/")
        raws[channel] = t.input(name, raw.unit, math.ceil(most) if raw.whole else most, raw.whole)
    if setup.driver.full:
        raw = setup.raw(BATTERY)
        most = 2 * setup.driver.highest / raw.scale
        raws[BATTERY] = t.input("raw_battery", raw.unit, math.ceil(most) if raw.whole else most, raw.whole, low=0.0)
    return raws


def kept(t: Tracer, raw: dict[str, Form], when: str) -> dict[str, Form]:
    """The readings within the ranges that everything after them is proven for; what is not a number stays none."""
    within: dict[str, Form] = {}
    for channel, form in raw.items():
        v = t.variables[form.name]
        name = channel.rpartition("/")[2]
        within[channel] = t.limit(form, v.low, v.high, f"{when}_{name}")
    return within


def numbers(t: Tracer, name: str, values: Sequence[Form], status: Form | float) -> Form:
    """`status` where all `values` are numbers, else `SENSOR_FAILED`: their sum stays below its range's end, and only
    what is not a number is not below it."""
    total = t.let(f"{name}_sum", sum(values, Form()), "1")
    return t.choose(total, 1.5 * t.variables[total.name].most + 1, status, float(SENSOR_FAILED), name, whole=True)


@dataclass(frozen=True)
class Held:
    """What the start leaves for the run: the gyro's offset, and the compass reading before this one."""

    offset: Form
    heading: Form | None


def calibrate(t: Tracer, setup: ProgramSetup, raw: dict[str, Form]) -> Held:
    """The gyro's mean over a second in which its readings stay within what a still gyro scatters; else anew."""
    first = kept(t, {channel: form for channel, form in raw.items() if channel not in ENCODERS}, "first")
    g = first[GYRO]
    most = t.variables[raw[GYRO].name].most
    unit = setup.raw(GYRO).unit
    count = setup.periods(CALIBRATION_TIME)
    offset = t.state("gyro_offset", unit, most)
    counted = t.state("still", "1", float(count), True)
    total = t.state("gyro_total", unit, most * count)
    low, high = t.state("gyro_low", unit, most), t.state("gyro_high", unit, most)
    lower = t.choose(g, low, g, low, "lower")
    higher = t.choose(high, g, g, high, "higher")
    spread = t.let("gyro_spread", higher - lower, unit)
    fresh = t.choose(spread, _scatter(setup), counted, 0.0, "counted", whole=True)  # moved: counted from nothing
    before = t.choose(fresh, 0.5, 0.0, total, "summed")
    more = t.let("more", fresh + 1.0, "1")
    total_now = t.let("gyro_sum", before + g, unit)
    t.commit(counted, t.limit(more, 0.0, float(count), "counted_now"))
    t.commit(total, t.limit(total_now, -most * count, most * count, "gyro_sum_kept"))
    t.commit(low, t.choose(fresh, 0.5, g, lower, "gyro_least"))
    t.commit(high, t.choose(fresh, 0.5, g, higher, "gyro_most"))
    t.commit(offset, t.let("gyro_mean", total_now * (1.0 / count), unit, most))
    t.choose(more, count - 0.5, 0.0, 1.0, "ready", output=True, whole=True)
    flat: Form | float = 0.0
    if BATTERY in raw:
        volts = t.let("start_battery", first[BATTERY] * setup.raw(BATTERY).scale, "V")
        flat = t.choose(volts, setup.driver.empty, float(FLAT_BATTERY), 0.0, "flat", whole=True)
    t.let("start_status", numbers(t, "first_fit", list(first.values()), flat), "1", output=True)
    return Held(offset, _heading_at_start(t, first))


def _heading_at_start(t: Tracer, first: dict[str, Form]) -> Form | None:
    if COMPASS not in first:
        return None
    before = t.state("compass_before", "deg", t.variables[first[COMPASS].name].most)
    t.commit(before, first[COMPASS])
    return before


def _scatter(setup: ProgramSetup) -> float:
    """The largest difference between readings of a still gyro: ±4 deviations and a step to either side, [raw]."""
    sensor = setup.kit.sensors[GYRO]
    raw = setup.raw(GYRO)
    step = max(sensor.quantum, raw.scale if raw.whole else 0.0)
    return (8 * sensor.noise + 2 * step + LEAST_SCATTER) / raw.scale


def reading(t: Tracer, setup: ProgramSetup, read: dict[str, Form], channel: str, held: Held) -> Form:
    """The channel in SI units, within what the sensor can say."""
    name = channel.removeprefix("sensor/")
    scale = setup.raw(channel).scale
    if channel == COMPASS:
        return _heading(t, read[channel], held, scale)
    value = read[channel] - held.offset if channel == GYRO else read[channel]
    return t.let(name, value * scale, SI[channel], largest(setup.kit, channel, setup.travel))


def _heading(t: Tracer, raw: Form, held: Held, scale: float) -> Form:
    """A compass that counts clockwise from 0 to 359, as an angle anticlockwise that knows no wrap."""
    assert held.heading is not None
    most = HEADING / scale
    turned = t.state("compass_turned", "deg", most)
    step = t.let("compass_step", held.heading - raw, "deg")
    less = t.let("compass_less", step - 360.0, "deg")
    more = t.let("compass_more", step + 360.0, "deg")
    down = t.choose(step, 180.0, step, less, "compass_down")
    way = t.choose(step, -180.0, more, down, "compass_way")
    now = t.let("compass_now", turned + way, "deg", most)
    t.commit(turned, now)
    t.commit(held.heading, raw)
    return t.let("compass", now * scale, "rad")


def moved(t: Tracer, setup: ProgramSetup, read: dict[str, Form], channel: str) -> Form:
    """How far a position has moved since the period before [SI], within what a wheel can do; 0 for a rate."""
    name = channel.removeprefix("sensor/")
    scale = setup.raw(channel).scale
    most = FASTEST * setup.linear.period
    if channel in ENCODERS:
        variable = t.variables[read[channel].name]
        before = t.state(f"before_{name}", variable.unit, variable.most, variable.whole)
        step = read[channel] - before
        t.commit(before, read[channel])
    elif channel == COMPASS:
        step = Form({"compass_way": 1.0})
    else:
        return Form()
    return t.let(f"moved_{name}", step * scale, "rad", most)
