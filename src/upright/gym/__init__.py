"""Balancing as an environment of Gymnasium; importing this room registers `upright/Balance-v0`."""

from upright.errors import require

ID = "upright/Balance-v0"

PERIODS = 1000
"""Of an episode, where nobody asks for another number: ten seconds of most kits."""


def _register() -> None:
    require("upright.gym", "gymnasium")
    from gymnasium import register

    register(
        ID,
        entry_point="upright.gym.balance:Balance",
        vector_entry_point="upright.gym.vector:BalanceVector",
        max_episode_steps=PERIODS,
    )


_register()
