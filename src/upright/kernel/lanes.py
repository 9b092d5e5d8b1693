"""Controllers without a linear form, called by the compiled loop: one copy for each robot of a block."""

from __future__ import annotations

import copy
import ctypes
import math
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.compiled.generated import LANES, ROW, H
from upright.control import Controller
from upright.errors import SpecMismatch
from upright.kernel.pack import Packed
from upright.kernel.rows import COMMAND, REFERENCE

_CALLED = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64)


class Lanes:
    """The function that `Plan.called` points to. Compiled code passes no exception on: an error is kept, commands are
    zero from then on, and `check` raises it after the run."""

    def __init__(self, controller: Controller, packed: Packed) -> None:
        at = packed.at
        self._applied = slice(packed.applied, packed.applied + 2)
        self._copies = [copy.deepcopy(controller) for _ in range(LANES)]
        self._reading = slice(at.reading, at.reading + len(controller.spec.reads))
        self._rows = max(at.reading + len(controller.spec.reads), COMMAND + 2, REFERENCE + 6)
        self._error: BaseException | None = None
        self._function: Any = _CALLED(self._decide)
        self.address = int(ctypes.cast(self._function, ctypes.c_void_p).value or 0)

    def check(self) -> None:
        """Raise the error of a controller, if there was one."""
        if self._error:
            raise self._error

    def _decide(self, block: int, count: int, k: int) -> None:
        numbers = (ctypes.c_double * (self._rows * ROW)).from_address(block)
        w: Array = np.ctypeslib.as_array(numbers).reshape(self._rows, ROW)[:, :count]
        try:
            if not self._error:
                self._command(w, k)
        except BaseException as error:  # a compiled caller would print it and go on, Ctrl-C included
            self._error = error
        if self._error:
            w[COMMAND : COMMAND + 2] = 0.0

    def _command(self, w: Array, k: int) -> None:
        readings = w[self._reading].T.copy()
        references = w[REFERENCE : REFERENCE + 6].T.copy()
        applied = w[self._applied].T.tolist()
        standing = w[H] > 0
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
