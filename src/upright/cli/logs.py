"""What commands read: logs by their files, and the part of them that is looked at."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from upright.errors import InvalidLog

if TYPE_CHECKING:
    from upright.signals import Log


@dataclass(frozen=True, kw_only=True)
class LogPart:
    """Logs as a mapping of their columns reads them, between two of their times [s]."""

    mapping: str | None = None
    from_: float | None = None
    until: float | None = None

    def read(self, paths: Iterable[Path]) -> list[Log]:
        """That part of each log; raises `InvalidLog`."""
        from upright.logs.raw import raw_log

        first = -math.inf if self.from_ is None else self.from_
        last = math.inf if self.until is None else self.until
        return [raw_log(path, self.mapping).between(first, last) for path in paths]


def labelled(arguments: list[str]) -> dict[str, Path]:
    """The files of LABEL=FILE, or of FILE, which is called as its file is."""
    labelled: dict[str, Path] = {}
    for argument in arguments:
        label, equals, file = argument.partition("=")
        path = Path(file if equals else argument)
        name = label if equals else path.stem
        if name in labelled:
            raise InvalidLog(f"two logs are called '{name}'", expected="one label each", hint=f"write OTHER={path}")
        labelled[name] = path
    return labelled
