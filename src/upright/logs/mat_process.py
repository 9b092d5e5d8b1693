"""A MAT file's columns of numbers, on stdout as NumPy's `.npz`: run by `readers` in a process of its own.

A damaged file makes SciPy's parser read beyond its memory, which no `except` can catch.
"""

from __future__ import annotations

import io
import sys
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.errors import one_line
from upright.reading import limit_memory

ROOM = 2 << 30
"""[bytes] of addresses that the parser may take, where the system can limit them."""


def columns_of(content: dict[str, Any]) -> dict[str, Array]:
    """The longest columns of numbers in what `scipy.io.loadmat` returned; the parts of a structure by `name.part`."""
    columns: dict[str, Array] = {}
    for name, value in content.items():
        if not name.startswith("__"):
            _collect(name, value, columns)
    longest = max((len(value) for value in columns.values()), default=0)
    return {name: value for name, value in columns.items() if len(value) == longest}


def _collect(name: str, value: Any, columns: dict[str, Array]) -> None:
    array = np.asarray(value)
    if array.dtype.names:
        for part in array.dtype.names:
            _collect(f"{name}.{part}", array[part].item() if array.ndim == 0 else array[part], columns)
    elif array.dtype.kind in "fiub" and array.ndim == 1:
        columns[name] = array.astype(np.float64)
    elif array.dtype.kind in "fiub" and array.ndim == 2:
        for i in range(array.shape[1]):
            columns[f"{name}_{i + 1}"] = array[:, i].astype(np.float64)


def main(path: str) -> int:
    """Read `path`; exit code 1 with a line on stderr where that cannot be done."""
    from scipy.io import loadmat

    limit_memory(ROOM)
    try:
        columns = columns_of(loadmat(path, squeeze_me=True, struct_as_record=True))
    except Exception as error:  # damaged bytes make the parser raise any exception
        print(one_line(error), file=sys.stderr)
        return 1
    stored = io.BytesIO()
    numbered = {f"column{i}": values for i, values in enumerate(columns.values())}
    np.savez(stored, names=np.array(list(columns), dtype=np.str_), **numbered)  # type: ignore[arg-type]
    sys.stdout.buffer.write(stored.getvalue())
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
