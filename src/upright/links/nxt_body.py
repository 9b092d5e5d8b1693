"""An NXT commanded from this computer: fast enough for measurements, too slow for balancing."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass

from upright.links.brick import GYRO, GYRO_KIND, LEFT, RIGHT, BrickLost, BrickRefused, Connection
from upright.links.remote import STILL, Reading, RemoteBody
from upright.robots import Robot

PERIOD = 0.1  # [s]: six telegrams a step, of 10 to 15 ms each over the cable
FRESH = 9.6  # [V] of six fresh cells
MOTORS = [LEFT, RIGHT]

REACH = 5
"""[° per % of duty] a motor may turn without a new order: 0.5 s, five periods, at its no-load speed of 980 °/s on 8 V
(a back EMF of 0.468 V s/rad: Watanabe 2007)."""
LEAST_REACH = 10  # [°] a motor may always turn


@dataclass
class Leash:
    """Where the brick will stop a motor by itself: at `end` [°], None as long as that is not known.

    The brick adds every limit to the end of the one before, so that an order is given what its end lies short of."""

    end: int | None = None

    def order(self, power: int, at: int) -> tuple[int, bool]:
        """(limit [°], whether it must begin afresh) for a motor that is to get `power` [%] and stands `at` [°]."""
        if not power:
            return 0, False  # nothing to stop, and it leaves the end where it is
        way = 1 if power > 0 else -1
        reach = self._reach(power)
        if self.end is None:
            return reach, True
        more = reach - way * (self.end - at)
        if more < -reach:
            return reach, True  # an end too far ahead cannot be called back
        self.end += way * max(1, more)  # a limit of 0 would be none
        return max(1, more), False

    def begin(self, power: int, at: int) -> None:
        """A fresh order was taken `at` [°]."""
        self.end = at + (1 if power > 0 else -1) * self._reach(power)

    @staticmethod
    def _reach(power: int) -> int:
        return max(LEAST_REACH, REACH * abs(power))


class NxtBody(RemoteBody):
    """`robot` on an NXT at `port` (usb, or a device such as /dev/rfcomm0), its gyro in input 1, motors at C and B.

    Every `PERIOD` both motors get a duty and are read: far too slow for balancing, good for measuring motors and
    sensors on a robot that lies or hangs. There is no truth, it cannot be put into a state, and nothing tells whether
    it has fallen. `overruns` counts steps that took longer than their period.

    Where no order comes, as when the cable is out, the brick stops each motor by itself: an order holds until the motor
    has turned by `REACH` times its duty or `LEAST_REACH`, at most twice that, and then the motor coasts. A motor that
    is blocked, or too weak to turn, keeps its duty: no program runs there that could tell. The first order after a
    `reset`, and one with much less duty than the one before, is without a limit until the brick has answered once
    (some milliseconds, over Bluetooth some tens).

    It connects at the first `reset`, for a second of which it must be still. `wait(seconds)` is how a virtual brick
    lets time pass; without it time passes by itself. Raises `SpecMismatch`, and like `Connection`.
    """

    def __init__(self, robot: Robot, port: str = "usb", *, wait: Callable[[float], None] | None = None) -> None:
        kind = "NXT over a cable" if wait is None else "virtual NXT with the twin round it, over a cable"
        super().__init__(kind, robot, PERIOD, FRESH, real=wait is None)
        self._port = port
        self._wait = wait
        self._brick = None
        self._steps = 0
        self._tick = 0.0
        self._began = 0.0
        self._leashes = [Leash() for _ in MOTORS]
        self._turned = [0 for _ in MOTORS]

    def _begin(self) -> Sequence[Reading]:
        brick = self._connected()
        brick.ask("release", ports=MOTORS)
        brick.ask("sensor", port=GYRO, kind=GYRO_KIND)
        self._steps = 0
        self._leashes = [Leash() for _ in MOTORS]
        still = [self._look() for _ in range(STILL)]
        self._tick = time.monotonic()
        self._began = self._tick
        return still

    def _exchange(self, duties: Sequence[int]) -> tuple[float, Reading, Sequence[int]]:
        self._drive(duties)
        self._pass()
        reading = self._look()
        self._steps += 1
        return self._clock(), reading, duties

    def _clock(self) -> float:
        """The time [s] since the start: the computer's, or that of a virtual brick, which passes in whole periods."""
        return self._steps * PERIOD if self._wait else time.monotonic() - self._began

    def close(self) -> None:
        """Switch the motors off, and let go of the brick."""
        brick = self._brick
        self._brick = None
        if brick is not None:
            with suppress(BrickLost, BrickRefused):
                brick.ask("release", ports=MOTORS)
                brick.ask("battery")  # an answer says that what came before it has arrived
            brick.close()

    def _connected(self) -> Connection:
        if self._brick is None:
            self._brick = Connection(self._port)
        return self._brick

    def _drive(self, duties: Sequence[int]) -> None:
        orders = [leash.order(d, at) for leash, d, at in zip(self._leashes, duties, self._turned, strict=True)]
        limits, fresh = [limit for limit, _ in orders], [new for _, new in orders]
        begun = self._connected().ask("drive", ports=MOTORS, powers=duties, limits=limits, fresh=fresh)
        for leash, power, new, at in zip(self._leashes, duties, fresh, begun, strict=True):
            if new:
                leash.begin(power, at)

    def _look(self) -> Reading:
        left, right, gyro, battery = self._connected().ask("look", motors=MOTORS, gyro=GYRO)
        self._turned = [left, right]
        return Reading(left, right, gyro, battery / 1000)

    def _pass(self) -> None:
        """Wait for the end of the period."""
        if self._wait:
            self._connected().ask("battery")  # an answer says that the orders have arrived: no time passes before
            self._wait(PERIOD)
            return
        self._tick += PERIOD
        rest = self._tick - time.monotonic()
        if rest < 0:
            self.overruns += 1
            self._tick = time.monotonic()
        time.sleep(max(0.0, rest))
