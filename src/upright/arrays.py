"""Arrays by kind of number, as signatures name them, and arrays that nobody changes."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Whole = NDArray[np.int64]
Mask = NDArray[np.bool_]


def read_only(values: ArrayLike) -> Array:
    """A copy that nobody changes."""
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array
