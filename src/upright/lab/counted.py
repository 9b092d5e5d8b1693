"""Electronics with the random numbers of the page without Python: they depend on seed, sensor and time alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import count
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.arrays import Array, Whole
from upright.bodies import Body, Electronics, Sample
from upright.bodies.body import REST
from upright.lab.plant import is_bare
from upright.physics.dynamics import Disturbance
from upright.robots import Kit, Sensor

BIAS, JITTER = 64, 128
"""Purposes of numbers, as in `web/src/simulator.js`: a sensor's noise has its place k, its bias 64 + k."""

BLOCK = 512
"""Times whose numbers are computed at once."""

MULTIPLIERS, STEPS = (0xD2511F53, 0xCD9E8D57), (0x9E3779B9, 0xBB67AE85)
"""Of Salmon et al. (2011), table 2; the steps are Weyl's."""

Words = NDArray[np.uint64]


class Counted(Electronics):
    """`Electronics` that draws what `web/src/simulator.js` draws."""

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        super().reset(start, seed)
        first = self.body.reset(start, seed)
        period = self.spec.period
        self._steps = 0

        def jitter(low: int, high: int) -> int:
            return low + int(philox(np.array([self._steps]), JITTER, seed)[0][0]) % (high - low)

        self._line.reset(_source(integers=jitter))
        sensors = zip(self.kit.sensors.values(), self._sensors, strict=True)
        for purpose, (sensor, (index, channel)) in enumerate(sensors):
            every = max(1, round(sensor.period / period))
            value = self._voltage if index is None else first.numbers[index]
            channel.reset(_source(standard_normal=_drawn(sensor, every, purpose, seed).__next__), value)
        return self._sample(first)

    def _moved(self, command: tuple[float, ...], disturbance: Disturbance) -> Sample:
        now = super()._moved(command, disturbance)
        self._steps += 1
        return now


def behind_counted(body: Body, kit: Kit) -> Body:
    """The body behind its kit's electronics, as they are in a page without Python."""
    return body if is_bare(kit) else Counted(body, kit)


def _source(**drawn: Callable[..., float]) -> Any:
    """What a channel or a line of commands asks for random numbers, in a generator's place."""
    return SimpleNamespace(**drawn)


def _drawn(sensor: Sensor, every: int, purpose: int, seed: int) -> Iterator[float]:
    """Normal numbers in the order in which a channel asks: of its bias, then at each reading of its walk and noise."""
    if sensor.bias:
        yield float(normals(np.zeros(1, np.int64), BIAS + purpose, seed)[0][0])
    for block in count(0, BLOCK):
        noise, walk = normals(every * np.arange(block, block + BLOCK), purpose, seed)
        for one, two in zip(noise.tolist(), walk.tolist(), strict=True):
            if sensor.bias_walk:
                yield two
            if sensor.noise:
                yield one


def normals(times: Whole, purpose: int, seed: int) -> tuple[Array, Array]:
    """Two independent normal numbers (n,) for each of the whole `times` (n,) (Box and Muller 1958)."""
    first, second, _, _ = philox(times, purpose, seed)
    radius = np.sqrt(-2 * np.log((first + 0.5) / 2**32))
    angle = np.pi * (second / 2**31 - 1)
    return radius * np.cos(angle), radius * np.sin(angle)


def philox(times: Whole, purpose: int, seed: int) -> tuple[Words, Words, Words, Words]:
    """Four words of 32 bits (n,) for each of the whole `times` (n,): Philox 4×32-10 (Salmon et al. 2011)."""
    low, half = np.uint64(0xFFFFFFFF), np.uint64(32)
    m0, m1 = map(np.uint64, MULTIPLIERS)
    zero = np.zeros(len(times), np.uint64)
    c0 = times.astype(np.uint64) & low
    c1 = zero
    c2 = zero
    c3 = zero + np.uint64(purpose)
    k0 = seed & 0xFFFFFFFF
    k1 = 0
    for _ in range(10):
        p0, p1 = m0 * c0, m1 * c2
        c0 = (p1 >> half) ^ c1 ^ np.uint64(k0)
        c1 = p1 & low
        c2 = (p0 >> half) ^ c3 ^ np.uint64(k1)
        c3 = p0 & low
        k0, k1 = ((k + weyl) & 0xFFFFFFFF for k, weyl in zip((k0, k1), STEPS, strict=True))
    return c0, c1, c2, c3
