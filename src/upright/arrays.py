"""Arrays of numbers by kind, as signatures name them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
Whole = NDArray[np.int64]
Mask = NDArray[np.bool_]
