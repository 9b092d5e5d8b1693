"""Many robots as one vector environment of Gymnasium, moved by the kernel."""

from __future__ import annotations

from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from upright.arrays import Array, Mask, Whole
from upright.gym import PERIODS
from upright.gym.task import fallen, reward, task_of
from upright.kernel.batch import NAMES
from upright.kernel.stepped import Stepped
from upright.robots import Kit, Robot


class BalanceVector(VectorEnv[Array, Array, Any]):
    """`num_envs` robots, each as in `Balance`; the step after the last of an episode begins the next one.

    `reset(seed=s)` draws robots and noise by s and a number: those of the first episodes are 0, 1, …, and each later
    episode has the next. A robot that falls stops there, so that its last observation is of the fall itself.
    """

    metadata: dict[str, Any] = {"autoreset_mode": AutoresetMode.NEXT_STEP}  # noqa: RUF012 (as Gymnasium declares it)

    def __init__(
        self,
        num_envs: int = 1,
        max_episode_steps: int = PERIODS,
        robot: Robot | str = "nxtway-gs",
        kit: Kit | str | None = None,
        **choices: Any,
    ) -> None:
        self._task = task_of(robot, kit, **choices)
        self.num_envs = num_envs
        self._most = max_episode_steps
        self.channels = self._task.channels
        self.single_observation_space = self._task.observations
        self.single_action_space = self._task.actions
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        super().reset(seed=seed)
        start = self._task.start(self.np_random, self.num_envs, options)
        self._pool = self._task.pool(int(self.np_random.integers(2**63)) if seed is None else seed)
        self._robots = Stepped(self._pool, self.num_envs)
        self._episodes = 0
        self._periods = np.zeros(self.num_envs, dtype=np.int64)
        self._radius = np.zeros(self.num_envs)
        self._over: Mask = np.zeros(self.num_envs, dtype=bool)
        self._begin(np.arange(self.num_envs), start)
        return self._robots.readings, self._info(self._robots.state)

    def step(self, actions: Array) -> tuple[Array, Any, Any, Any, dict[str, Any]]:
        self._robots.step(np.asarray(actions, dtype=np.float64))
        self._periods += 1
        fresh = self._over
        places = np.flatnonzero(fresh)
        if len(places):
            self._begin(places, self._task.start(self.np_random, len(places)))
        state = self._robots.state
        worth = np.where(fresh, 0.0, reward(state, self._radius))
        terminated = fallen(state) & ~fresh
        truncated = self._periods >= self._most
        self._over = terminated | truncated
        return self._robots.readings, worth, terminated, truncated, self._info(state)

    def _begin(self, places: Whole, start: Array) -> None:
        """New episodes in these places, of the next robots."""
        numbers = self._episodes + np.arange(len(places))
        self._episodes += len(places)
        robots = numbers % self._pool.n
        self._robots.begin(places, robots, numbers, start)
        self._radius[places] = self._pool.parameters[robots, NAMES.index("wheel_radius")]
        self._periods[places] = 0

    def _info(self, state: Array) -> dict[str, Any]:
        every = np.ones(self.num_envs, dtype=bool)
        return {"truth": state, "_truth": every, "applied": self._robots.applied, "_applied": every}
