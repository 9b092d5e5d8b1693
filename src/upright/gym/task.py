"""The task of balancing: which robots, what is observed and commanded, where it begins, and what it is worth."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from os import PathLike
from typing import Any

import numpy as np
from gymnasium.spaces import Box

from upright.arrays import Array
from upright.bodies import Body, Electronics, NonlinearBody
from upright.bodies.body import checked
from upright.bodies.electronics import BATTERY
from upright.control.controller import ControllerSpec
from upright.fleets.ensemble import Ensemble
from upright.fleets.sweep import electronics
from upright.fleets.vary import Vary, varied, with_number
from upright.kernel.batch import FleetBatch, idle
from upright.robots import PARAMETERS, Kit, Robot, find_robot
from upright.robots.kit import STOP
from upright.robots.uncertainty import BLOCK, Family, Uncertainty, at_medians
from upright.signals.signal import SENSORS

LEAN = 0.05
"""[rad] The largest pitch that an episode begins with: 3°, from which the controllers here recover every preset."""

NEAR = 0.5
"""[m] The distance from the start at which standing is worth half."""


@dataclass(frozen=True, eq=False)
class BalanceTask:
    """Robots of a `family`, whose `channels` are observed every `period` [s], beginning within a pitch of `lean` [rad].

    `period` is cut into `stride` steps of the body, of about a millisecond.
    """

    family: Family
    channels: tuple[str, ...]
    period: float
    lean: float

    @property
    def stride(self) -> int:
        return max(1, round(self.period / 0.001))

    @property
    def observations(self) -> Box[np.float64]:
        """What the sensors read, within their ranges."""
        kit = self.family.kit
        ranges = np.array([kit.sensors[name].range if kit else np.inf for name in self.channels])
        return Box(-ranges, ranges, dtype=np.float64)

    @property
    def actions(self) -> Box[np.float64]:
        """Commands (left, right) in the drive's unit, as far as the motors get them."""
        kit = self.family.kit
        most = kit.most(self.family.robot.command_unit) if kit else np.inf
        return Box(-most, most, (2,), np.float64)

    def start(self, rng: np.random.Generator, count: int, options: Mapping[str, Any] | None = None) -> Array:
        """States (count, 6) to begin in: those in `options`, else at rest with a drawn pitch."""
        if options and "start" in options:
            rows = np.atleast_2d(np.asarray(options["start"], dtype=np.float64)).tolist()
            return np.broadcast_to([checked(row, 6, "start") for row in rows], (count, 6))
        state = np.zeros((count, 6))
        state[:, 0] = rng.uniform(-self.lean, self.lean, count)
        return state

    def body(self, seed: int) -> tuple[Body, Robot]:
        """The robot number 0 of those that this seed draws, with its electronics."""
        kit = self.family.kit
        drawn = {name: float(values[0]) for name, values in self.family.draw(seed, [0]).items()}
        robot = self.family.robot.replace(**{name: value for name, value in drawn.items() if name in PARAMETERS})
        for name in drawn.keys() - PARAMETERS.keys():
            _, kit = with_number(name, drawn[name], robot, kit)
        body = NonlinearBody.dividing(robot, self.period)
        return Electronics(body, kit) if kit else body, robot

    def pool(self, seed: int) -> FleetBatch:
        """The robots number 0 to `BLOCK` − 1 that this seed draws; one where all are alike."""
        spec = ControllerSpec("policy", self.channels, self.period, self.family.robot.command_unit)
        robots = Ensemble(family=self.family, controller=idle(spec), seed=seed)
        return replace(robots.batch(range(BLOCK if self.family.names else 1)), period=self.period / self.stride)


def task_of(
    robot: Robot | str = "nxtway-gs",
    kit: Kit | str | None = None,
    *,
    vary: Vary = (),
    posterior: Uncertainty | str | PathLike[str] | None = None,
    lean: float = LEAN,
) -> BalanceTask:
    """Balancing `robot` with `kit` (None: its own); `vary` and `posterior` are those of `upright.fleet`.

    All sensors of the kit are observed but its battery's, which the kernel does not read.
    """
    nominal, unknown = at_medians(find_robot(robot), posterior)
    parts = electronics(kit or nominal.kit)
    read = parts.sensors if parts else [signal.name for signal in SENSORS]
    channels = tuple(name for name in read if name != BATTERY)
    family = Family(nominal, parts, varied(vary, nominal, parts, unknown))
    return BalanceTask(family, channels, parts.period if parts else Kit.preset("ideal").period, lean)


def fallen(state: Array) -> Any:
    """Whether robots in these states (…, 6) lean beyond `STOP`, where every program stops the motors."""
    return ~(np.abs(state[..., 0]) <= STOP)


def reward(state: Array, wheel_radius: Any) -> Any:
    """(1 − (ψ/STOP)²) / (1 + (r θ/NEAR)²) of states (…, 6), for wheels of radius r [m]: upright, and near the start.

    It lies between 0 and 1, and is 0 from a fall on, so that no fall is ever worth while.
    """
    upright = np.maximum(0.0, 1 - (state[..., 0] / STOP) ** 2)
    return upright / (1 + (wheel_radius * state[..., 2] / NEAR) ** 2)
