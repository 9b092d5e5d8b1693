"""What changed parts add to the innovations: sensors of another scale, motors that are dead, loads that come or go,
and disturbances of any shape by the channel that they enter by."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.diagnose.fall import limit
from upright.diagnose.innovations import FilterRun, Signature, answer, entering, propagated
from upright.pages.terms import short

GYRO = "sensor/gyro"
RATE_TIME = 0.02  # [s] before and after, over which a wheel's rate follows from its angle
PAYLOADS = (0.3, 1.0, 2.0, -0.3, -0.7)  # over the body's mass, that come or go in a signature
LEAST_PART = 0.2  # of a signature's payload, from which a torque beside it is its weight
PAYLOAD_HEIGHTS = (0.8, 1.5)  # above the axle, over that of the centre of mass
LOST_RADII = (0.2, 0.35, 0.5)  # of the wheels' radius, that go in a signature
SLOW = 1.0  # [rad/s] against the body, below which a wheel rests: a step of 1° within 2 `RATE_TIME` is 0.4 rad/s
HELD = (0.1, 0.3, 0.6)  # of the largest command, by which dry friction holds a wheel, or both
DRAGGED = {"left": (True, False), "right": (False, True), "both": (True, True)}
PART = "part"  # the way of what is only looked for beside another fault: alone, the filter itself searches for it
LIMITS = (0.05, 0.15, 0.3, 0.5)  # of the largest command, that a weak battery still gives
DELAYS = (1.0, 2.0, 3.5, 5.0, 7.0, 10.0)  # periods

FREE = ("left motor", "right motor", "both motors", "force", "moment")
"""Channels of torque or force by which a disturbance of any shape may enter; readings are the others."""

MOTORS = {
    "left": (True, False, False), "right": (False, True, False), "both": (True, True, False),
    "left braked": (True, False, True), "right braked": (False, True, True),
}  # fmt: skip
"""Dead motors: which of both, and whether a short circuit brakes them. Both braked are a battery without charge."""


def scaled_sensors(run: FilterRun) -> dict[str, tuple[str, ...]]:
    """The sensors that a wrong scale may concern, each and both encoders, by name."""
    encoders = tuple(name for name in run.rows if "encoder" in name)
    several = {"encoders": encoders} if len(encoders) == 2 else {}
    names = (GYRO, *encoders)
    return {n.removeprefix("sensor/").replace("_rate", ""): (n,) for n in names if n in run.rows} | several


def channels_of(run: FilterRun, way: str) -> tuple[str, ...]:
    """The log's channels that a wrong scale concerns: of encoders that agree, which the filter reads as one, both."""
    names = scaled_sensors(run)[way]
    encoders = [name for name in run.rows if "encoder" in name]
    if len(encoders) > 1 or list(names) != encoders:
        return names
    both = (names[0].replace("left", side).replace("right", side) for side in ("left", "right"))
    return tuple(name for name in both if name in run.log)


def scales(run: FilterRun, onsets: Array) -> list[Signature]:
    """Readings of the wrong scale from an onset on: the amplitude is the fraction of the reading that is too much."""
    several = scaled_sensors(run)
    shifts = [sum(_grown(run, name, onsets) for name in names) for names in several.values()]
    response = propagated(run, None, np.concatenate(shifts, axis=1))[run.readings]
    return _several("scale", dict.fromkeys(several), onsets, response)


def _grown(run: FilterRun, name: str, onsets: Array) -> Array:
    """A sensor's readings from each onset on (events, onsets); of an angle, what it grew by since."""
    values = run.log[name]
    first = np.zeros(len(onsets))
    if "encoder" in name and "rate" not in name:
        rows = np.clip(np.searchsorted(run.log.t, onsets) - 1, 0, len(run.log) - 1)
        first = np.nan_to_num(values[rows])
    mine = (run.row == run.rows.index(name))[:, None] & (run.log.t[run.sample][:, None] >= onsets)
    return np.where(mine, np.nan_to_num(values[run.sample])[:, None] - first, 0.0)


def dead_motors(run: FilterRun) -> tuple[str, ...]:
    """The dead motors that a log may show: with one of two the robot turns, while encoders that always agree show that
    it does not."""
    alike = "encoder_left" in scaled_sensors(run) and len(channels_of(run, "encoder_left")) == 2
    return ("both",) if alike else tuple(MOTORS)


def lost_command(run: FilterRun, way: str) -> Array:
    """What a dead motor takes from the commands over each span (events, 2)."""
    left, right, braked = MOTORS[way]
    lost = -run.command * np.array([left, right])
    if braked:
        return lost
    return lost + run.robot.back_emf * turning(run) * np.array([left, right])


def turning(run: FilterRun) -> Array:
    """How fast both wheels turn against the body at each event [rad/s], (events, 2), as the encoders show it: a filter
    that does not know of a fault is not to be asked."""
    log = run.log
    near = run.log.t
    rates: list[Array] = []
    for sides in (("left", "right"), ("right", "left")):  # a wheel without an encoder turns like the other one
        names = [f"sensor/encoder_{kind}{side}" for side in sides for kind in ("rate_", "")]
        name = next(name for name in names if name in run.rows)
        if "rate" in name:
            rates.append(np.nan_to_num(log[name]))
            continue
        angle = log[name]
        there = np.isfinite(angle)
        ends = [np.interp(near + shift, near[there], angle[there]) for shift in (-RATE_TIME, RATE_TIME)]
        rates.append((ends[1] - ends[0]) / (2 * RATE_TIME))
    return np.column_stack([np.interp(run.t, near, rate) for rate in rates])


def motors(run: FilterRun, onsets: Array) -> list[Signature]:
    """Motors that give nothing from an onset on."""
    ways = dead_motors(run)
    lost = [lost_command(run, way) for way in ways]
    return _several("motor", dict.fromkeys(ways, 1.0), onsets, _commanded(run, onsets, lost))


def drag(run: FilterRun, way: str, size: float) -> Array:
    """What dry friction of a `size` takes from the commands at each event (events, 2): it opposes the turning of its
    wheels, and holds one that rests against its command."""
    turn = turning(run)
    held = np.clip(run.command, -size, size)
    return -np.where(np.abs(turn) < SLOW, held, size * np.sign(turn)) * np.array(DRAGGED[way])


def frictions(run: FilterRun, onsets: Array) -> list[Signature]:
    """Wheels that grow stiff against the body, by dry friction of a free part of each of `HELD`."""
    most = limit(run.robot, run.kit, run.asked)
    n = len(onsets)
    kinds = [(way, part * most) for way in DRAGGED for part in HELD]
    response = _commanded(run, onsets, [drag(run, way, size) for way, size in kinds])
    return [
        replace(one, size=size)
        for i, (way, size) in enumerate(kinds)
        for one in _several("friction", {way: None}, onsets, response[:, i * n : (i + 1) * n])
    ]


def radii(run: FilterRun, onsets: Array) -> list[Signature]:
    """Wheels that lose a free part of each of `LOST_RADII`; errors then grow as those of a robot on smaller wheels."""
    when = onsets[::2]
    on = ((run.t - run.spans / 2)[:, None] >= when)[:, None, :]
    radius = run.robot.wheel_radius
    signatures = list[Signature]()
    for part in LOST_RADII:
        entered = entering(run, [{"wheel_radius": -part * radius}])
        smaller = replace(run, robot=run.robot.replace(wheel_radius=(1 - part) * radius))
        response = propagated(smaller, entered * on)[run.readings]
        signatures += [replace(one, size=part) for one in _several("radius", {"lost": None}, when, response)]
    return signatures


def commands(run: FilterRun, onsets: Array) -> list[Signature]:
    """Both motors weaker by a free fraction, or later by some periods: small enough to stand beside another fault."""
    changes = [-run.command]
    for periods in DELAYS:
        before = np.clip(np.searchsorted(run.t, run.t - periods * run.log.period, side="right") - 1, 0, None)
        changes.append(run.command[before] - run.command)
    most = limit(run.robot, run.kit, run.asked)
    changes += [np.clip(run.command, -part * most, part * most) - run.command for part in LIMITS]
    response = _commanded(run, onsets, changes)
    n = len(onsets)
    signatures = _several("weak", {PART: None}, onsets, response[:, :n])
    sizes = [("delay", PART, periods) for periods in DELAYS] + [("weak", "limit", part) for part in LIMITS]
    for i, (fault, way, size) in enumerate(sizes, 1):
        signatures += _several(fault, {way: size}, onsets, response[:, i * n : (i + 1) * n])
    return signatures


def _commanded(run: FilterRun, onsets: Array, changes: Sequence[Array]) -> Array:
    """What changes of both commands (events, 2) from each onset on do to the readings (readings, changes × onsets)."""
    on = (run.t - run.spans / 2)[:, None] >= onsets
    entered = np.zeros((len(run.t), 4, len(changes) * len(onsets)))
    entered[:, :2] = np.concatenate([one[:, :, None] * on[:, None, :] for one in changes], axis=2)
    return answer(run, entered)[run.readings]


def payloads(run: FilterRun, onsets: Array) -> list[Signature]:
    """A mass that comes or goes above the axle, of a free part of each of `PAYLOADS`."""
    p = run.robot
    when = onsets[::2]
    on = ((run.t - run.spans / 2)[:, None] >= when)[:, None, :]
    kinds = [(mass, height) for mass in PAYLOADS for height in PAYLOAD_HEIGHTS]
    changes = entering(run, [with_mass(p, mass * p.body_mass, height * p.com_height) for mass, height in kinds])
    pushed = np.concatenate([changes[:, :, i, None] * on for i in range(len(kinds))], axis=2)
    response = propagated(run, pushed)[run.readings]
    n = len(when)
    return [
        replace(one, size=mass)
        for i, (mass, _) in enumerate(kinds)
        for one in _several(
            "payload", {"added" if mass > 0 else "dropped": None}, when, response[:, i * n : (i + 1) * n]
        )
    ]


def placed(payloads: Sequence[Signature], y: Array, moments: Array, onsets: Array) -> list[Signature]:
    """The same with the mass in front of the axle or behind it by what explains the innovations `y` best; `moments`
    (readings, onsets) are steps of a torque on the body."""
    index = {float(t): i for i, t in enumerate(onsets)}
    signatures: list[Signature] = []
    for one in payloads:
        m = moments[:, index[one.onset]]
        v = one.values
        vv, mm, vm, vy, my = v @ v, m @ m, v @ m, v @ y, m @ y
        whole = vv * mm - vm**2
        mass = (vy * mm - my * vm) / max(whole, 1e-12)
        moment = (my * vv - vy * vm) / max(whole, 1e-12)
        sound = whole > 1e-9 * vv * mm and -mass > LEAST_PART
        signatures.append(replace(one, values=v + moment / mass * m) if sound else one)
    return signatures


def with_mass(p: Any, mass: float, height: float) -> dict[str, float]:
    """How a point mass at a height changes mass, centre of mass and inertia about it."""
    total = p.body_mass + mass
    lower = mass * (height - p.com_height) / total
    inertia = p.body_mass * mass / total * (height - p.com_height) ** 2
    return {"body_mass": mass, "com_height": lower, "pitch_inertia": max(inertia, -0.9 * p.pitch_inertia)}


def free_steps(run: FilterRun, onsets: Array) -> dict[str, Array]:
    """Steps of what may enter by each channel: (readings, onsets) by its name."""
    n = len(onsets)
    use = run.readings
    on = (run.t - run.spans / 2)[:, None] >= onsets
    entered = np.zeros((len(run.t), 4, 5 * n))
    for place, inputs in enumerate(((0,), (1,), (0, 1), (2,), (3,))):
        for i in inputs:
            entered[:, i, place * n : (place + 1) * n] = on
    response = answer(run, entered)[use]
    free = {name: response[:, i * n : (i + 1) * n] for i, name in enumerate(FREE)}
    after = run.log.t[run.sample][:, None] >= onsets
    rows = [i for i, name in enumerate(run.rows) if name != "sensor/compass"]
    shift = np.concatenate([after * (run.row == i)[:, None] for i in rows], axis=1)
    response = propagated(run, None, shift)[use]
    names = [short(run.rows[i]) for i in rows]
    return free | {name: response[:, i * n : (i + 1) * n] for i, name in enumerate(names)}


def _several(fault: str, ways: Mapping[str, float | None], onsets: Array, response: Array) -> list[Signature]:
    """One signature for each way and onset; of the way's size, or free where that is None."""
    places = [(way, size, float(t)) for way, size in ways.items() for t in onsets]
    return [
        Signature(fault=fault, way=way, onset=t, values=one, size=size or 0.0, free=size is None)
        for (way, size, t), one in zip(places, response.T, strict=True)
    ]
