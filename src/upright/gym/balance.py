"""One robot as an environment of Gymnasium, under the loop of `experiment.run`."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np

from upright.arrays import Array
from upright.bodies.electronics import advanced
from upright.gym.task import fallen, reward, task_of
from upright.physics.dynamics import CALM
from upright.robots import Kit, Robot


class Balance(gymnasium.Env[Array, Array]):
    """The nonlinear model of `robot` with `kit`, one period of the kit a step; see `task_of` for the `choices`.

    An observation holds the sensors' readings `channels`, an action the commands (left, right) in the drive's unit.
    `info` has what a real robot does not know, the true state "truth" (6,), and the commands "applied" (2,).
    `reset(seed=s)` makes the robot and the noise of `run(seed=s)`; `options={"start": (6,)}` sets the state.
    """

    def __init__(self, robot: Robot | str = "nxtway-gs", kit: Kit | str | None = None, **choices: Any) -> None:
        self._task = task_of(robot, kit, **choices)
        self.channels = self._task.channels
        self.observation_space = self._task.observations
        self.action_space = self._task.actions

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        super().reset(seed=seed)
        (start,) = self._task.start(self.np_random, 1, options)
        episode = int(self.np_random.integers(2**63)) if seed is None else seed
        self._body, self._robot = self._task.body(episode)
        names = [signal.name for signal in self._body.spec.channels]
        self._read = [names.index(name) for name in self.channels]
        self._now = self._body.reset(start.tolist(), episode)
        return self._observed()

    def step(self, action: Array) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        command = np.asarray(action, dtype=np.float64).tolist()
        self._now = advanced(self._body, self._now.t, command, lambda _: CALM, self._task.stride)
        observation, info = self._observed()
        state = info["truth"]
        return observation, float(reward(state, self._robot.wheel_radius)), bool(fallen(state)), False, info

    def _observed(self) -> tuple[Array, dict[str, Any]]:
        values = np.array(self._now.numbers)
        return values[self._read], {"truth": values[:6], "applied": np.array(self._now.applied)}
