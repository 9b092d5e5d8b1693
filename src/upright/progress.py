"""How far a long computation is: what is called with the fraction done, and what shows nothing of it."""

from __future__ import annotations

from collections.abc import Callable

Progress = Callable[[float], None]
"""Called with the fraction done [1], from 0 to 1."""


def unwatched(fraction: float) -> None:
    """Progress that nobody watches: nothing is shown of the `fraction`."""
