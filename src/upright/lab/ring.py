"""The last rows of a recording, in memory of a fixed size."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from upright.arrays import Array


class Ring:
    """The last `length` rows of `width` numbers each."""

    def __init__(self, length: int, width: int) -> None:
        self._rows = np.zeros((length, width))
        self._count = 0

    def __len__(self) -> int:
        return min(self._count, len(self._rows))

    def append(self, row: Sequence[float]) -> None:
        """Add a row, in the place of the oldest where there is no more room."""
        self._rows[self._count % len(self._rows)] = row
        self._count += 1

    def back(self, periods: int) -> Array:
        """The row so many before the newest one, or the oldest there is; raises `IndexError` while it is empty."""
        if not self._count:
            raise IndexError("nothing was recorded yet")
        return self._rows[(self._count - 1 - min(max(periods, 0), len(self) - 1)) % len(self._rows)]

    def rows(self, every: int = 1) -> Array:
        """A copy, oldest first, of every so-manyth row, the newest among them."""
        first = self._count - len(self)
        first += (self._count - 1 - first) % every
        return self._rows[np.arange(first, self._count, every) % len(self._rows)]
