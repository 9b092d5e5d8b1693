"""The balancing program, written once: what `trace` writes down here is what every target runs.

Every raw reading is kept within its range; one that is not a number, or a wheel out of range, stops both motors before
their duty is computed.

reading = scale · (raw − offset), kept within the sensor's range; positions enter the memory by what they moved
u = the controller's output; duty = whole(full · u / battery), zero in the dead zone and within ±full
applied = duty · battery / full, less the driver's drop, which enters the controller's memory in place of u
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from importlib.metadata import version

import numpy as np

from upright.arrays import Array
from upright.compiled.program import Program, Repeat
from upright.compiled.tracer import Form, Tracer
from upright.control.controller import Controller, controller_hash
from upright.control.law import command_forms, dot, memory_forms
from upright.errors import SpecMismatch
from upright.firmware.incremental import incremental
from upright.firmware.readings import calibrate, inputs, kept, moved, numbers, reading
from upright.firmware.setup import (
    BALANCING,
    FALLEN,
    FASTEST,
    HEADING,
    POSITIONS,
    REFERENCE_RANGE,
    STATE_UNITS,
    STUCK,
    STUCK_TIME,
    TILT_TIME,
    TOO_FAR,
    TRAVEL,
    UNPROVEN,
    UPSIDE_DOWN,
    ProgramSetup,
)
from upright.firmware.targets import BATTERY, COMPASS, ENCODERS, GYRO, PITCH, Driver, driver, find_target, largest
from upright.physics.electronics import awake, dropped, switched
from upright.robots import Kit, Robot
from upright.robots.kit import STOP
from upright.signals import SIDES, STATE_NAMES


def trace(
    controller: Controller,
    robot: Robot,
    kit: Kit,
    target: str = "c",
    *,
    reference: bool = False,
    travel: float = TRAVEL,
) -> Program:
    """The program of `controller` for `robot` on `kit`'s electronics.

    `reference` adds the reference state as inputs (a robot that only stands needs none); encoders are followed within
    ±`travel` [rad]. Raises `InvalidController` for a controller that no law describes, `SpecMismatch`
    where target, robot and controller do not fit, `UnknownName` for the target.
    """
    setup = _setup(controller, robot, kit, target=target, reference=reference, travel=travel)
    inner, linear = setup.incremental, setup.linear
    t = Tracer()
    raw = inputs(t, setup)
    held = calibrate(t, setup, raw)
    at_start = t.block("calibrate")
    read = kept(t, raw, "read")
    y = [reading(t, setup, read, channel, held) for channel in linear.reads]
    steps = [moved(t, setup, read, channel) for channel in linear.reads]
    bounds = _bounds(setup)
    sizes = np.full(len(linear.A), UNPROVEN) if bounds is None else bounds
    w = [t.state(f"w{i}", "1", bound) for i, bound in enumerate(sizes.tolist())]
    z = [_counted(t, state, i, inner.X[i], steps) for i, state in enumerate(w)]
    r = _reference(t, setup)
    pitch = _pitch(t, setup, z, y)
    u = command_forms(t, inner.law, z, y, r, unit=setup.driver.unit, most=setup.typed)
    fit = _fit(t, setup, read, [*read.values(), *r, *u[:2]])
    a = _applied(t, setup, u[:2], read, fit)
    command = t.block("command")
    rows = memory_forms(inner.law, z=z, y=y, r=r, u=u, a=_arrived(t, setup, a))
    _remember(t, w, rows, bounds is not None)
    _stop(t, setup, pitch, fit)
    update = t.block("update")
    channels = {form.name: channel for channel, form in raw.items()}
    return Program(
        robot=robot.name,
        kit=kit.name,
        kind=linear.kind,
        hash=controller_hash(controller),
        target=target,
        period=linear.period,
        version=version("upright"),
        command_unit=setup.driver.unit,
        full=setup.driver.full,
        proven=bounds is not None and not any(isinstance(s, Repeat) for s in command.statements),
        lag=setup.lag,
        channels=channels,
        scales={name: setup.raw(channel).scale for name, channel in channels.items()},
        variables=t.variables,
        calibrate=at_start,
        command=command,
        update=update,
    )


def _setup(
    controller: Controller, robot: Robot, kit: Kit, *, target: str, reference: bool, travel: float
) -> ProgramSetup:
    """The checked facts that the program is written from."""
    inner = incremental(controller, POSITIONS)
    place = find_target(target)
    unit = inner.linear.command_unit
    if unit != robot.command_unit:
        raise SpecMismatch(f"the controller commands {unit}", expected=f"{robot.command_unit}")
    setup = ProgramSetup(inner, kit, driver(robot, kit, place), place, travel, reference)
    if not math.isfinite(setup.strongest):
        raise SpecMismatch(
            f"kit '{kit.name}' does not limit the command", expected="a battery or a motor's limit",
            hint="name the robot's own kit",
        )  # fmt: skip
    return setup


def _counted(t: Tracer, state: Form, index: int, row: Array, steps: list[Form]) -> Form:
    """The memory counted from where the positions are now."""
    return t.let(f"z{index}", state - dot(row, steps), "1") if row.any() else state


def _bounds(setup: ProgramSetup) -> Array | None:
    linear = setup.linear
    y = np.array([HEADING if c == COMPASS else largest(setup.kit, c, setup.travel) for c in linear.reads])
    r = np.array(REFERENCE_RANGE) if setup.reference else np.zeros(6)
    rest = setup.incremental.law.nonlinear
    u = np.array([setup.typed, setup.typed, *rest.part.most] if rest else [0.0, 0.0])
    a = np.full(2, setup.strongest)
    return setup.incremental.bounds(change=np.full(len(y), FASTEST * linear.period), y=y, r=r, u=u, a=a)


def _reference(t: Tracer, setup: ProgramSetup) -> list[Form]:
    """The reference state as inputs; zero for states that the controller does not compare."""
    linear = setup.linear
    rest = setup.incremental.law.nonlinear
    rows = np.vstack([linear.Br, linear.Dr, *([rest.Dr] if rest else [])])
    return [
        _bounded_input(t, f"reference_{name}", unit, most) if setup.reference and rows[:, i].any() else Form()
        for i, (name, unit, most) in enumerate(zip(STATE_NAMES, STATE_UNITS, REFERENCE_RANGE, strict=True))
    ]


def _bounded_input(t: Tracer, name: str, unit: str, most: float) -> Form:
    return t.limit(t.input(name, unit, most), -most, most, f"kept_{name}")


def _pitch(t: Tracer, setup: ProgramSetup, z: list[Form], y: list[Form]) -> Form:
    """The controller's estimate of the pitch, or the fused angle, or the gyro's integral, which decays over
    `TILT_TIME`."""
    linear = setup.linear
    if len(linear.S):
        return t.let("pitch", dot(linear.S[0], z) + dot(linear.Sy[0], y), "rad", UPSIDE_DOWN, output=True)
    if PITCH in linear.reads:
        return t.let("angle", y[linear.reads.index(PITCH)], "rad", UPSIDE_DOWN, output=True)
    rate = y[linear.reads.index(GYRO)]
    dt = linear.period
    tilt = t.state("tilt", "rad", UPSIDE_DOWN)
    pitch = t.let("pitch", (tilt + rate * dt) * (1 - dt / TILT_TIME), "rad", UPSIDE_DOWN, output=True)
    t.commit(tilt, pitch)
    return pitch


def _fit(t: Tracer, setup: ProgramSetup, read: dict[str, Form], values: list[Form]) -> Form:
    """The status by what was read: `TOO_FAR` for a wheel out of range, `SENSOR_FAILED` where a value is no number."""
    status: Form | float = float(BALANCING)
    for side, channel in zip(SIDES, ENCODERS, strict=True):
        if channel not in read:
            continue
        far = t.absolute(read[channel], f"far_{side}")
        most = setup.travel / setup.raw(channel).scale
        status = t.choose(far, most, status, float(TOO_FAR), f"near_{side}", whole=True)
    return numbers(t, "fit", values, status)


def _applied(t: Tracer, setup: ProgramSetup, u: list[Form], read: dict[str, Form], fit: Form) -> list[Form]:
    """The applied commands: zero in the dead zone and unless the readings are `fit`, within the limit, in whole steps
    of the battery's voltage, less what the driver drops."""
    d = setup.driver
    full = float(setup.driver.full)
    sure = [
        t.choose(fit, 0.5, _awake(t, d, form, side), 0.0, f"sure_{side}") for form, side in zip(u, SIDES, strict=True)
    ]
    if not full:
        return [
            t.let(f"applied_{s}", form, d.unit, setup.strongest, output=True)
            for form, s in zip(sure, SIDES, strict=True)
        ]
    # the battery is read before the motors load it anew
    volts = t.let("volts", read[BATTERY] * setup.raw(BATTERY).scale, "V")
    measured = t.limit(volts, d.lowest, d.highest, "measured")
    battery = t.choose(fit, 0.5, measured, d.lowest, "battery")
    per_volt = t.quotient("per_volt", full, battery, "1/V")
    step = t.let("step", battery * (1 / full), "V")
    applied: list[Form] = []
    for form, side in zip(sure, SIDES, strict=True):
        exact = t.product(f"exact_duty_{side}", form, per_volt, "1")
        # in the driver's own steps, so that full duty is reached however the battery's voltage was rounded
        duty = switched(exact, full, 1.0, t.called(f"limited_duty_{side}", f"duty_{side}"))
        if not d.drop:
            applied.append(t.product(f"applied_{side}", duty, step, "V", output=True))
            continue
        given = t.product(f"given_{side}", duty, step, "V")
        left = dropped(given, d.drop, t.called(f"dropped_{side}"))
        applied.append(t.let(f"applied_{side}", left, "V", setup.strongest, output=True))
    return applied


def _arrived(t: Tracer, setup: ProgramSetup, a: list[Form]) -> list[Form]:
    """The commands that reach the motors now, applied `lag` periods ago."""
    if not setup.lag:
        return a
    arrived: list[Form] = []
    for form, side in zip(a, SIDES, strict=True):
        unit = setup.driver.unit
        most = t.variables[form.name].most
        line = [t.state(f"sent_{side}_{k}", unit, most) for k in range(1, setup.lag + 1)]
        for k, (place, before) in enumerate(zip(line[1:], line, strict=False), 2):
            t.commit(place, t.let(f"next_sent_{side}_{k}", before, unit))
        t.commit(line[0], form)
        arrived.append(line[-1])
    return arrived


def _awake(t: Tracer, d: Driver, command: Form, side: str) -> Form:
    """The command within the driver's limit, zero in the dead zone."""
    value = command
    if d.dead_zone:
        value = awake(command, d, t.called(f"size_{side}", f"awake_{side}"))
    if math.isfinite(d.limit) and d.full:
        return t.limit(value, -d.limit, d.limit, f"bounded_{side}")
    return value


def _remember(t: Tracer, w: list[Form], rows: Sequence[Form], proven: bool) -> None:
    """The memory `w` of the next period from its `rows`, limited to its range where that is not proven."""
    keep = t.claim if proven else t.let
    after = [
        keep(f"next_{state.name}", row, "1", t.variables[state.name].most) for state, row in zip(w, rows, strict=True)
    ]
    for state, value in zip(w, after, strict=True):
        t.commit(state, value)


def _stop(t: Tracer, setup: ProgramSetup, pitch: Form, fit: Form) -> None:
    """The status: not `fit`, fallen, or stuck at full duty."""
    lean = t.absolute(pitch, "lean")
    status = t.choose(lean, STOP, float(BALANCING), float(FALLEN), "fallen", whole=True)
    if setup.driver.full:
        status = _stuck(t, setup, status)
    t.choose(fit, 0.5, status, fit, "status", output=True, whole=True)


def _stuck(t: Tracer, setup: ProgramSetup, status: Form) -> Form:
    full = float(setup.driver.full)
    longest = setup.periods(STUCK_TIME)
    count = t.state("stuck", "1", float(longest), True)
    sizes = [t.absolute(Form({f"duty_{side}": 1.0}), f"strength_{side}") for side in SIDES]
    both = t.let("strength", sizes[0] + sizes[1], "1")
    more = t.let("stuck_more", count + 1.0, "1")
    held = t.choose(both, 2 * full - 0.5, 0.0, more, "stuck_now", whole=True)
    t.commit(count, t.limit(held, 0.0, float(longest), "stuck_kept"))
    return t.choose(held, longest - 0.5, status, float(STUCK), "stuck_status", whole=True)
