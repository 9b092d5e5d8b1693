"""Arrays by kind of number, as signatures name them, and arrays that nobody changes."""

from __future__ import annotations

from typing import Any

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


def floats_of(column: Any) -> Array:
    """A column of numbers of Arrow (n,) as float64, NaN where it is null; Arrow's own way imports pandas (0.4 s)."""
    import pyarrow as pa

    whole = column.cast(pa.float64(), safe=False).combine_chunks()
    valid, numbers = whole.buffers()
    values = np.frombuffer(numbers or b"", np.float64, len(whole), 8 * whole.offset).copy()
    if whole.null_count:
        bits = np.unpackbits(np.frombuffer(valid, np.uint8), bitorder="little")
        values[bits[whole.offset : whole.offset + len(whole)] == 0] = np.nan
    return values
