"""Controllers that no matrices describe, called by the compiled loop: one copy for each robot of a block."""

from __future__ import annotations

import copy
import ctypes
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.compiled.generated import LANES, LEFT, ROW, H
from upright.control import Controller
from upright.errors import SpecMismatch
from upright.kernel.rows import COMMAND, REFERENCE, Rows

Array = NDArray[np.float64]

_CALLED = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64)


class Lanes:
    """What `Plan.called` points to. It keeps an error, since compiled code passes no exception on; `check` raises it
    afterwards, and until then the robots get no command."""

    def __init__(self, controller: Controller, at: Rows) -> None:
        self._copies = [copy.deepcopy(controller) for _ in range(LANES)]
        self._reading = slice(at.reading, at.reading + len(controller.spec.reads))
        self._rows = max(at.reading + len(controller.spec.reads), COMMAND + 2, REFERENCE + 6)
        self._wrong: Exception | None = None
        self._function: Any = _CALLED(self._decide)
        self.address = int(ctypes.cast(self._function, ctypes.c_void_p).value or 0)

    def check(self) -> None:
        """Raise what went wrong in a controller."""
        if self._wrong:
            raise self._wrong

    def _decide(self, block: int, count: int, k: int) -> None:
        numbers = (ctypes.c_double * (self._rows * ROW)).from_address(block)
        w: Array = np.ctypeslib.as_array(numbers).reshape(self._rows, ROW)[:, :count]
        try:
            if not self._wrong:
                self._command(w, k)
        except Exception as error:  # a compiled caller would print it and go on
            self._wrong = error
        if self._wrong:
            w[COMMAND : COMMAND + 2] = 0.0

    def _command(self, w: Array, k: int) -> None:
        readings, references = w[self._reading].T.copy(), w[REFERENCE : REFERENCE + 6].T.copy()
        applied, standing = w[LEFT : LEFT + 2].T.tolist(), w[H] > 0
        for i in np.flatnonzero(standing).tolist():
            one = self._copies[i]
            if k == 0:
                one.reset()
            else:
                one.applied(applied[i])
            left, right = one.step(readings[i], references[i])
            if not (math.isfinite(left) and math.isfinite(right)):
                raise SpecMismatch(f"command is [{left}, {right}]", expected="finite numbers")
            w[COMMAND, i], w[COMMAND + 1, i] = left, right
