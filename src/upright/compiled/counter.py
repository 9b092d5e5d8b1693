"""Random numbers by counting: what a robot draws depends on seed, number of the robot, time and purpose, and on nothing
else.

Philox 4×32-10 (Salmon et al. 2011) turns a counter (time, the robot's two words, purpose) and a key (the seed's two
words) into four independent words; Box and Muller (1958) turn two words into two normal numbers. Times count the body's
steps: noise has that of the sensor's sample, a jitter that of the command. So bodies, the kernel and an exported page,
where `random` and `lab/web/src/simulator.js` say the same again, draw the same. A body is robot 0.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from upright.arrays import Array, Whole
from upright.signals.signal import FUSED, SENSORS

FOR_NOISE = 0
FOR_WALK = 2
FOR_BIAS = 4
FOR_JITTER = 6
FOR_STILL = 8  # noise of sensors while a hand holds the robot
FOR_HAND = 10  # what the hand does
"""Purposes; all but jitter and hand have room for eight kinds of sensors, two times the four normal numbers of a
counter."""

KINDS = (*(s.name for s in SENSORS[:-1]), FUSED[0].name, SENSORS[-1].name)
"""Sensors by kind; the kernel knows all but the last, the battery."""

BLOCK = 128
"""Numbers that are drawn at once: enough that NumPy takes a microsecond for each, few enough to be thrown away."""

LOW = np.uint64(0xFFFFFFFF)
SHIFT = np.uint64(32)
_M0, _M1 = np.uint64(0xD2511F53), np.uint64(0xCD9E8D57)  # multipliers and Weyl steps of Salmon et al. (2011), table 2
_W0, _W1 = np.uint64(0x9E3779B9), np.uint64(0xBB67AE85)


def two_rounds(c0: Any, c1: Any, c2: Any, c3: Any, k0: Any, k1: Any) -> Any:
    """Counter and key two rounds on."""
    p0, p1 = _M0 * c0, _M1 * c2
    c0 = (p1 >> SHIFT) ^ c1 ^ k0
    c1 = p1 & LOW
    c2 = (p0 >> SHIFT) ^ c3 ^ k1
    c3 = p0 & LOW
    k0, k1 = (k0 + _W0) & LOW, (k1 + _W1) & LOW
    p0, p1 = _M0 * c0, _M1 * c2
    c0 = (p1 >> SHIFT) ^ c1 ^ k0
    c1 = p1 & LOW
    c2 = (p0 >> SHIFT) ^ c3 ^ k1
    c3 = p0 & LOW
    return c0, c1, c2, c3, (k0 + _W0) & LOW, (k1 + _W1) & LOW


def philox(c0: Any, c1: Any, c2: Any, c3: Any, k0: Any, k1: Any) -> Any:
    """Four words of 32 bits, each in 64, from four words of counter and two of key: numbers or arrays.

    Its ten rounds are written out, since a loop inside would keep the kernel's loop over robots from being vectorised.
    """
    c0, c1, c2, c3, k0, k1 = two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, k0, k1 = two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, k0, k1 = two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, k0, k1 = two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, _, _ = two_rounds(c0, c1, c2, c3, k0, k1)
    return c0, c1, c2, c3


def words(times: Any, purpose: int, seed: int, index: Any) -> Any:
    """Four words for each of the whole `times`, of the robot number `index`."""
    robot = np.uint64(index)
    key = np.uint64(seed)
    return philox(np.uint64(times), robot & LOW, robot >> SHIFT, np.uint64(purpose), key & LOW, key >> SHIFT)


def normals(times: Whole, purpose: int, kind: int, seed: int) -> Array:
    """A standard normal number (n,) for a sensor of this `kind` at each of the whole `times` (n,)."""
    four = words(times, purpose + kind // 4, seed, 0)
    first, second = four[:2] if kind % 4 < 2 else four[2:]
    radius = np.sqrt(-2 * np.log((first + 0.5) / 2**32))
    angle = np.pi * (second / 2**31 - 1)
    return radius * (np.sin(angle) if kind % 2 else np.cos(angle))


def walk_steps(every: int, loop: float) -> int:
    """Steps of the body from one draw of a sensor's walk to the next: as many whole samples, `every` steps each, as
    take about the `loop` of the kit's program [steps]."""
    return every * max(1, round(loop / every))


def whole(time: int, purpose: int, below: int, seed: int, index: int = 0) -> int:
    """A whole number from 0 to `below` − 1 for robot `index`, evenly to within 2⁻³² of each."""
    return int(np.int64((words(time, purpose, seed, index)[0] * np.uint64(below)) >> SHIFT))


class Normals:
    """`normals` of one purpose and kind at one time after another, drawn ahead at the pace at which they are taken."""

    def __init__(self, purpose: int, kind: int, seed: int) -> None:
        self._of = (purpose, kind, seed)
        self._first, self._last, self._pace = 0, 0, 1
        self._drawn = list[float]()

    def at(self, time: int) -> float:
        place, between = divmod(time - self._first, self._pace)
        if between or not 0 <= place < len(self._drawn):
            self._first, self._pace = time, max(1, time - self._last)
            self._drawn = normals(time + self._pace * np.arange(BLOCK), *self._of).tolist()
            place = 0
        self._last = time
        return self._drawn[place]
