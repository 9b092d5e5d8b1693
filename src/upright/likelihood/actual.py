"""The robot that a log shows, in place of the one that was assumed.

A number of the log that is not within what was assumed is taken over: the filter of the next turn knows it, and the
certificate's robots have it, each a value of its own out of the interval. What is still outside after that is not
understood, and counts against the certificate.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.likelihood.assumptions import NOISED, Assumptions, Logged, delaying
from upright.likelihood.followed import as_disturbed, filtered_log, surprise, surprises
from upright.likelihood.support import NORMAL, Support, supported
from upright.robots import Kit
from upright.signals import Log

TURNS = 12  # of Gauss and Newton's method
LEAST_GAIN = 20.0  # of −2 log likelihood: robots as they were assumed gain 3 to 10 by another mass
TRIED = 5  # values of a number's interval
WITHIN = 100  # robots within their spreads: where one predicts the log as well, they explain what a number would
AT_ONCE = 20  # of these: of most logs one of the first explains a number that is none
GYRO, ENCODER = "sensor/gyro", "sensor/encoder_left"
LEAST_FACTOR, MOST_UNEQUAL = 0.05, 0.95  # of a scale, a strength or a mass; of half the difference of two motors
LIGHTER = 1.0  # times what is missing of a body's mass: where rotors are heavy, a log shows half of what is missing
NOT_LEARNT = frozenset({"jitter"})  # the kernel draws none longer than a period
DIRECT = frozenset({"battery", "battery's sag", "slope"})  # read off, whatever the filter knows
FROM_ZERO = frozenset({"further delay", "gyro's further delay", "gyro's noise"})  # ranges that do not lie round nominal


def as_logged(log: Log, setup: Assumptions) -> tuple[Assumptions, tuple[Support, ...], tuple[Support, ...]]:
    """`setup` with what `log` shows in it, what the log then says of the numbers, and those that were taken over, each
    beside what had been assumed. Raises like `supported`.

    What is read off directly is taken over first, then one number after the other: the one with which the filter
    predicts the log best, since the rest may only be its image. The next one is looked for where those taken over
    stand. A number with which it predicts no better than robots within their spreads do is neither taken over nor said.
    """
    setup, now = as_disturbed(log, setup)
    shown = first = supported(log, setup)
    names = set[str]()
    stands = True
    for _ in range(TURNS):
        new = _next(log, setup, shown, names, now) if stands else set[str]()
        if stands and not new:
            break
        moved, then = _likeliest(log, setup, [s for s in shown if s.name in names | new])
        stands = not new and then > now - LEAST_GAIN
        if new or then < now:
            names |= new
            setup, now = as_disturbed(log, moved)
            shown = supported(log, setup)
    shown = tuple(s for s in shown if s.name in (*names, *DIRECT, *NOT_LEARNT) or not is_beyond(s))
    last = {s.name: s for s in shown}
    known = (s for s in first if s.name in names and not s.left_open)
    return setup, shown, tuple(_in_place_of(s, last.get(s.name, s), setup) for s in known)


def _next(log: Log, setup: Assumptions, shown: Sequence[Support], names: set[str], now: float) -> set[str]:
    """Which numbers to take over besides those of these `names`, with which the log surprises by `now`."""
    strays = [s for s in shown if is_beyond(s) and s.name not in (*names, *NOT_LEARNT)]
    if direct := {s.name for s in strays if s.name in DIRECT}:
        return direct
    if not strays:
        return set()
    best, then = _best(log, setup, strays, [s for s in shown if s.name in names])
    if not then < now - LEAST_GAIN:
        return set()
    within = [(setup.actual(robot), setup.actual_kit) for robot in setup.robots[:WITHIN]]
    parts = (within[i : i + AT_ONCE] for i in range(0, len(within), AT_ONCE))
    return set() if any(min(surprises(log, part, setup.disturbed)) <= then for part in parts) else {best.name}


def _best(log: Log, setup: Assumptions, several: Sequence[Support], known: Sequence[Support]) -> tuple[Support, float]:
    """Of `several` numbers the one that makes the log likeliest beside those that are `known`, and its surprise."""
    then = [surprise(filtered_log(log, _learnt(setup, [*known, s]))[0]) for s in several]
    best = int(np.argmin(then))
    return several[best], then[best]


def doubted(log: Log, setup: Assumptions, names: Collection[str]) -> tuple[Assumptions, Support] | None:
    """`setup` with a number that makes the log much likelier, beside those of these `names` that it knows, and what
    the log says of it; None where there is none. Robots within their spreads may explain the log as well."""
    known = (s for s in supported(log, setup) if s.name not in (*names, *DIRECT, *NOT_LEARNT) and not s.left_open)
    strays = [s for s in known if is_beyond(s)]
    if not strays:
        return None
    now, (best, then) = surprise(filtered_log(log, setup)[0]), _best(log, setup, strays, ())
    if not then < now - LEAST_GAIN:
        return None
    moved, _ = _likeliest(log, setup, [best])
    last = next(s for s in supported(log, moved) if s.name == best.name)
    return moved, _in_place_of(best, last, moved)


def _likeliest(log: Log, setup: Assumptions, numbers: Sequence[Support]) -> tuple[Assumptions, float]:
    """The setup moved to these `numbers`, each at the value within its interval with which the log surprises least,
    and that surprise."""
    result = list(numbers)
    now = math.inf
    for place, s in enumerate(result):
        values = [] if s.name in DIRECT else np.linspace(s.low, s.high, TRIED).tolist()
        for value in (s.value, *values):
            shifted = replace(s, value=value, low=s.low + value - s.value, high=s.high + value - s.value)
            then = surprise(filtered_log(log, _learnt(setup, [*result[:place], shifted, *result[place + 1 :]]))[0])
            if then < now:
                result[place], now = shifted, then
    return _learnt(setup, result), now


def _in_place_of(assumed: Support, last: Support, setup: Assumptions) -> Support:
    """What was taken over in all, with the width of the `last` interval, beside what had been `assumed`."""
    kit, before, logged = setup.actual_kit, setup.kit, setup.logged
    motor = kit.motor
    gyro = kit.sensors[GYRO]
    mean = (motor.left + motor.right) / 2
    difference = motor.right - motor.left
    encoder, turning = (kit.sensors[name].delay - before.sensors[name].delay for name in (ENCODER, GYRO))
    totals = {
        "battery's sag": kit.battery.sag, "further delay": encoder, "dead zone": motor.dead_zone,
        "drop": motor.drop, "gyro's scale": gyro.gain / before.sensors[GYRO].gain, "gyro's noise": gyro.noise,
        "gyro's further delay": turning - encoder, "motors' strength": mean,
        "difference of the motors": difference / mean,
        "body's mass": setup.robot.body_mass * (logged.load if logged else 1.0),
    }  # fmt: skip
    value = totals.get(assumed.name, last.value)
    half = (last.high - last.low) / 2
    return replace(assumed, value=value, low=value - half, high=value + half)


def is_beyond(s: Support) -> bool:
    """Whether the log says another number than the one assumed, and its interval is not within what was assumed."""
    if s.left_open:
        return True
    if "delay" in s.name and s.value <= 0:
        return False  # it harms no loop
    nominal = 0.0 if s.name in FROM_ZERO else (s.least + s.most) / 2
    return not (s.least <= s.low and s.high <= s.most) and not s.low <= nominal <= s.high


def _learnt(setup: Assumptions, shown: Sequence[Support]) -> Assumptions:
    """The setup moved by what the filter of it shows."""
    n = len(setup.robots)
    kit = setup.actual_kit
    logged = setup.logged or Logged.alone(kit)
    changes = dict(logged.changes)
    for s in shown:
        rng = np.random.Generator(np.random.Philox([setup.seed, sum(s.name.encode())]))
        drawn = s.value + (s.high - s.low) / (2 * NORMAL) * rng.standard_normal(n)
        if s.name == "battery":
            kit = replace(kit, battery=replace(kit.battery, voltage=s.value))
            logged = replace(logged, batteries=(s.value,))
        elif s.name == "slope":
            logged = replace(logged, slopes=(s.value,), tilts=drawn / s.value)
        elif s.name == "body's mass":
            load = s.value / setup.robot.body_mass
            loads = drawn / setup.robot.body_mass
            loads -= rng.uniform(0.0, LIGHTER, n) * np.maximum(1 - loads, 0.0)
            logged = replace(logged, load=max(load, LEAST_FACTOR), loads=np.maximum(loads, LEAST_FACTOR))
        else:
            kit, changed = _fitted(kit, s, drawn)
            changes |= {NOISED: np.full(n, setup.kit.sensors[GYRO].noise)} if s.left_open else changed
    return replace(setup, logged=replace(logged, kit=kit, changes=changes))


def _fitted(kit: Kit, s: Support, drawn: Array) -> tuple[Kit, dict[str, Array]]:
    """The kit with one number as the log shows it, and what is drawn of it for each robot (n,)."""
    motor = kit.motor
    gyro = kit.sensors[GYRO]

    def other(**numbers: Any) -> Kit:
        return replace(kit, sensors={**kit.sensors, GYRO: replace(gyro, **numbers)})

    zero = np.maximum(drawn, 0.0)
    factors = np.maximum(drawn, LEAST_FACTOR)
    value = max(s.value, 0.0)
    factor = max(s.value, LEAST_FACTOR)
    match s.name:
        case "battery's sag":
            result = replace(kit, battery=replace(kit.battery, sag=value)), {}
        case "further delay":
            result = delaying(kit, s.value), dict[str, Array]()
        case "dead zone":
            result = replace(kit, motor=replace(motor, dead_zone=value)), {"motor.dead_zone": zero}
        case "drop":
            result = replace(kit, motor=replace(motor, drop=value)), {"motor.drop": zero}
        case "gyro's scale":
            result = other(gain=gyro.gain * factor), {"sensors.gyro.gain": gyro.gain * factors}
        case "gyro's noise":
            result = other(noise=value), {NOISED: zero}
        case "gyro's further delay":
            result = other(delay=max(gyro.delay + s.value, 0.0)), dict[str, Array]()
        case "motors' strength":
            sides = {"left": motor.left, "right": motor.right}
            changed = replace(motor, **{side: factor * own for side, own in sides.items()})
            result = replace(kit, motor=changed), {f"motor.{side}": factors * own for side, own in sides.items()}
        case _:  # the difference of the motors
            mean = (motor.left + motor.right) / 2
            halves = [(motor.right - mean) / mean + x / 2 for x in (s.value, drawn)]
            one, each = (np.clip(half, -MOST_UNEQUAL, MOST_UNEQUAL) for half in halves)
            changed = replace(motor, left=mean * float(1 - one), right=mean * float(1 + one))
            result = replace(kit, motor=changed), {"motor.left": mean * (1 - each), "motor.right": mean * (1 + each)}
    return result
