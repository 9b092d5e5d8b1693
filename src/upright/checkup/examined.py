"""What was found on a log, as data."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from typing import Any

from upright.checkup.finding import Finding, Record, Segment
from upright.checkup.measured import CheckNumber, measured
from upright.logs.mapping import Mapping


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class LogExamined:
    """All findings on one log, worst first; `mapping` says which column was read as which channel, `ignored` names the
    others; `segments` are the poses in the order of time, `fell_at` when each fall among them passed the lean at which
    programs stop [s]: times of the repaired log.

    `robot` is the one that the log names, if any; `mapped` and `saved` are the files of its mapping and of its repair,
    where there are such.
    """

    source: str
    mapping: Mapping
    findings: tuple[Finding, ...]
    rows: int
    seconds: float
    period: float
    segments: tuple[Segment, ...]
    fell_at: tuple[float, ...]
    ignored: tuple[str, ...]
    mapped: str = ""
    saved: str = ""
    _raw: Record = field(repr=False)
    _origin: dict[str, Any] = field(repr=False, default_factory=dict[str, Any])

    @property
    def healthy(self) -> bool:
        """Whether there is no error and no warning."""
        return all(finding.severity == "note" for finding in self.findings)

    @property
    def read(self) -> Record:
        """The log as it was read, before any repair."""
        return self._raw

    def codes(self) -> list[str]:
        """The codes of all findings, in order."""
        return [finding.code for finding in self.findings]

    @property
    def faults(self) -> list[Finding]:
        """What is not a mere note."""
        return [finding for finding in self.findings if finding.severity != "note"]

    @property
    def kept(self) -> tuple[float, float] | None:
        """The longest time on the wheels [s], to which a repair cuts the log; None where it keeps all rows."""
        cuts = (fix.numbers for finding in self.findings for fix in finding.fixes if fix.kind == "cut")
        return next(((start, stop) for start, stop in cuts), None)

    def cut_away(self) -> list[Finding]:
        """The faults that lie outside the time that is kept, so that the cut removes them."""
        if self.kept is None:
            return []
        start, stop = self.kept
        return [f for f in self.faults if f.span and (f.span[0] >= stop or f.span[1] < start)]

    @property
    def robot(self) -> str:
        """The name of the robot that the log's origin has; empty where it has none."""
        named = self._origin.get("robot")
        return str(named.get("name", "")) if isinstance(named, dict) else ""

    @cached_property
    def measured(self) -> dict[str, CheckNumber]:
        """What the checks measured, by check, as far as it is a number."""
        wrong = any(code.startswith(("units/", "motion/int", "motion/diff", "time/")) for code in self.codes())
        return measured(self._raw, None if wrong else replace(self._raw, segments=self.segments), self.period)

    def to_json(self) -> dict[str, Any]:
        """As plain data for programs."""
        columns = {name: source.column for name, source in self.mapping.channels.items()}
        return {
            "schema": "upright/doctor/1",
            "source": self.source,
            "rows": self.rows,
            "seconds": self.seconds,
            "period": self.period,
            "mapping": {"name": self.mapping.name, "columns": columns, "ignored": list(self.ignored)},
            "segments": [segment.to_json() for segment in self.segments],
            "findings": [finding.to_json() for finding in self.findings],
            "measured": {name: asdict(number) for name, number in self.measured.items()},
        }
