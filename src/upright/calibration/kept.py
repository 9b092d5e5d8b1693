"""Functions that Numba compiles and calls, kept in the store of machine code.

Numba's own cache on disk knows neither that a file has changed which a function's file imports, nor damage.
"""

from __future__ import annotations

import pickle
from collections.abc import Callable
from importlib import import_module
from typing import Any

from upright.compiled.jit import numba
from upright.kernel import store

_caching: Any = import_module("numba.core.caching")
_compiler: Any = import_module("numba.core.compiler")
_serialize: Any = import_module("numba.core.serialize")


class Kept(_caching.NullCache):
    """What Numba asks for the code of `function`, and gives it to: each signature is a file of the store."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self._name = function.__qualname__
        self._module = function.__module__

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        target_context.refresh()
        code = store.kept(self._path(sig))
        return None if code is None else _compiler.CompileResult._rebuild(target_context, *pickle.loads(code))

    def save_overload(self, sig: Any, cres: Any) -> None:
        if not cres.library.has_dynamic_globals:  # addresses of this process alone
            store.keep(self._path(sig), _serialize.dumps(cres._reduce()))

    def _path(self, sig: Any) -> Any:
        return store.path_of(self._name, f"{self._module} {sig}", store.ALSO)


def njit(function: Callable[..., Any]) -> Any:
    """A compiled function, kept on disk, that lets other threads run and divides as IEEE says."""
    made: Any = numba.njit(nogil=True, error_model="numpy")(function)
    if store.known_numba():
        made._cache = Kept(function)
    return made
