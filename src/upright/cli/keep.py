"""The log of a robot, which nobody can run again: its place is tried before, and another one is found for it after."""

from __future__ import annotations

import itertools
import tempfile
import uuid
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from upright.atomic import place_of
from upright.errors import UprightError

if TYPE_CHECKING:
    from upright.signals import Log


def check_log_target(path: Path) -> None:
    """Refuse, before a robot moves, a place where no log could be written, by writing one beside it."""
    from upright.signals import Log

    place = place_of(path)
    trial = (place.path if place.keeps else Path(tempfile.gettempdir()) / path.name).with_name(
        f".{uuid.uuid4().hex[:8]}{path.suffix}"
    )
    try:
        Log([0.0, 1.0], {"truth/pitch": [0.0, 0.0]}).save(trial)
    except UprightError as error:
        raise type(error)(str(error).replace(trial.name, path.name)) from None
    finally:
        trial.unlink(missing_ok=True)


def save_log(log: Log, path: Path) -> tuple[Path, str]:
    """Write the log to `path`, or where that fails beside it, here, or among temporary files.

    Returns where it is, and what was wrong with `path`. Raises the first error where no place takes it.
    """
    first: Exception | None = None
    for place in _places(path):
        try:
            return log.save(place), str(first or "")
        except (OSError, UprightError) as error:
            first = first or error
    assert first
    raise first


def _places(path: Path) -> Iterator[Path]:
    yield path
    for folder in (path.parent, Path.cwd(), Path(tempfile.gettempdir())):
        names = (folder / f"{path.stem}-{n}{path.suffix}" for n in itertools.count(1))
        yield next(name for name in names if not name.exists())
