"""Where the result of a command goes: the options that every command with a result has."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from upright.cli.output import check_targets, finish
from upright.errors import UprightError
from upright.pages.result import PICTURES


@dataclass(frozen=True, kw_only=True)
class Destination:
    """A page, a file of data, JSON on stdout; without these the page as text."""

    report: Path | None = None
    save: Path | None = None
    json: bool = False
    wide: bool = False

    def __post_init__(self) -> None:
        if self.report and self.report.suffix not in (".html", *PICTURES):
            expected = f"a page, .html, or its picture, {' '.join(PICTURES)}"
            raise UprightError(f"--report {self.report}", expected=expected, hint=f"--report {self.report.stem}.html")

    def check(self, *files: Path | None, logs: Iterable[Path] = ()) -> None:
        """Refuse, before the work, what could not be written after it: `files`, and what the options name."""
        check_targets(*files, self.report, self.save, logs=logs)

    def finish(self, result: Any, *written: Path | None, **facts: Any) -> None:
        """Write the result's page and data, with further `facts`, and print it; `written` are its other files."""
        files = [str(path) for path in written if path]
        facts |= {"files": files} if files else {}
        finish(result, self.json, output=self.save, page=self.report, written=written, wide=self.wide, **facts)
