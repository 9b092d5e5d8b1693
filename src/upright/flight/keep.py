"""The log of a robot, which nobody can run again: its place is tried before, and another one is found for it after."""

from __future__ import annotations

import tempfile
import uuid
from pathlib import Path
from typing import TYPE_CHECKING

from upright.atomic import TemporaryFolder, place_of
from upright.errors import UprightError

if TYPE_CHECKING:
    from upright.signals import Log


def check_log_target(path: Path) -> None:
    """Refuse, before a robot moves, a place where no log could be written, by writing one beside it."""
    from upright.signals import Log

    with TemporaryFolder(place_of(path)) as folder:
        try:
            Log([0.0, 1.0], {"truth/pitch": [0.0, 0.0]}).save(Path(folder) / path.name)
        except UprightError as error:
            raise type(error)(str(error).replace(folder, str(path.parent))) from None


def save_log(log: Log, path: Path) -> tuple[Path, str]:
    """Write the log to `path`, or where that fails beside it, here, or among temporary files.

    Returns where it is, and what was wrong with `path`. Raises the first error where no place takes it.
    """
    other = f"{path.stem}-{uuid.uuid4().hex[:8]}{path.suffix}"
    wrong = ""
    for place in (path, path.with_name(other), Path.cwd() / other, Path(tempfile.gettempdir(), other)):
        try:
            return log.save(place), wrong
        except UprightError as error:
            wrong = wrong or str(error)
    raise UprightError(wrong)
