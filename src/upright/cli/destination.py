"""Where the result of a command goes: the options that every command with a result has."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from upright.atomic import write_json
from upright.cli.output import check_targets, continued, print_page, typed_line
from upright.pages import Result
from upright.pages.result import check_page, write_page


@dataclass(frozen=True, kw_only=True)
class Destination:
    """A page, a file of data, JSON on stdout; without these the page as text."""

    report: Path | None = None
    save: Path | None = None
    json: bool = False
    wide: bool = False

    def __post_init__(self) -> None:
        if self.report:
            check_page(self.report)

    def check(self, *files: Path | None, logs: Iterable[Path] = ()) -> None:
        """Refuse, before the work, what could not be written after it: `files`, and what the options name."""
        check_targets(*files, self.report, self.save, logs=logs)

    def finish(self, result: Result, *written: Path | None, **facts: Any) -> None:
        """Write the result's page and data, with further `facts`, and print it; `written` are its other files."""
        page = continued(result.page())
        others = [path for path in written if path]
        data = result.to_json() | facts
        if others:
            data["files"] = [str(path) for path in others]
        if self.report:
            write_page(page, self.report, typed_line())
        if self.save:
            write_json(self.save, data)
        print_page(page, data if self.json else None, (self.save, *others, self.report), wide=self.wide)
