"""Files that appear whole or not at all."""

from __future__ import annotations

import json
import math
import os
import uuid
from collections.abc import Callable
from pathlib import Path
from typing import Any, BinaryIO

from upright.errors import UprightError


def write_whole(target: Path, write: Callable[[BinaryIO], None]) -> None:
    """Let `write` fill a stream beside `target`, then move it there: a failure leaves an older file as it was.

    Raises whatever `write` raises, and `OSError` where the folder cannot be written.
    """
    # Beside the target, because only within one file system is the move a single step.
    unfinished = target.with_name(f".{target.name}.{uuid.uuid4().hex[:8]}.part")
    try:
        with unfinished.open("xb") as stream:
            write(stream)
        os.replace(unfinished, target)
    finally:
        unfinished.unlink(missing_ok=True)


def write_text(target: str | Path, text: str) -> Path:
    """Write `text` as UTF-8, whole or not at all; raises `UprightError` where that cannot be done."""
    path = Path(target).expanduser()
    if not path.parent.is_dir():
        raise UprightError(f"there is no folder {path.parent} for {path.name}", hint=f"mkdir -p {path.parent}")
    try:
        write_whole(path, lambda stream: _fill(stream, text))
    except OSError as error:
        raise UprightError(
            f"cannot write {path}: {error.strerror}", hint="choose a place that can be written"
        ) from None
    return path


def json_text(data: Any) -> str:
    """Indented JSON; NaN and infinity, which JSON does not have, are an error of the caller."""
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False)


def write_json(target: str | Path, data: Any) -> Path:
    """Write JSON, whole or not at all."""
    return write_text(target, json_text(data) + "\n")


def finite(value: Any) -> Any:
    """The value, or None for a number that JSON does not have: NaN and infinity."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _fill(stream: BinaryIO, text: str) -> None:
    stream.write(text.encode("utf-8"))
