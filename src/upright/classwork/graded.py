"""What became of one hand-in: its verdict, and how two machines may differ."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from upright.lab.handin import RunResult
from upright.languages import ENGLISH, speaking
from upright.pages import Quantity, Say, Verdict

OK, MISSED, DIFFERS, EDITED, COPIED, CHANGED, BROKEN = (
    "ok", "not reached", "differs", "edited", "copied", "other set-up", "broken",
)  # fmt: skip
SHOWN = {
    OK: Verdict(Say("ok"), "good"), MISSED: Verdict(Say("not reached"), "warn"),
    CHANGED: Verdict(Say("other set-up"), "warn"), DIFFERS: Verdict(Say("differs"), "bad"),
    EDITED: Verdict(Say("edited"), "bad"), COPIED: Verdict(Say("copied"), "bad"),
    BROKEN: Verdict(Say("cannot be run"), "unknown"),
}  # fmt: skip
"""Verdicts for people: not genuine is bad, what cannot be run is unknown."""

TOLERANCE = {"seconds": (0.25, 0.0), "peak": (0.01, 0.05), "travel": (0.02, 0.05), "best": (0.003, 0.02)}
"""Largest difference between two machines: absolute [s, rad, m, N s], and as a fraction. They differ in the last bit of
a reading, and a reading in one step of an encoder (0.017 rad of a wheel); a fall is passed through within 0.25 s."""

MEASURED = {
    "seconds": (Say("time"), "s"), "peak": (Say("largest pitch"), "rad"), "travel": (Say("distance rolled"), "m"),
    "best": (Say("largest knock survived"), "N s"),
}  # fmt: skip
"""Numbers of a run: what each is, and its unit."""


@dataclass(frozen=True, kw_only=True)
class Grade:
    """One hand-in: its `verdict`, and in `why` the reason for it."""

    file: str
    student: str = ""
    task: str = ""
    claimed: RunResult | None = None
    replayed: RunResult | None = None
    verdict: str = BROKEN
    why: Say | None = None
    run: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain values; the reason is in English."""
        results = {name: asdict(run) if run else None for name, run in self.runs.items()}
        with speaking(ENGLISH):
            why = str(self.why or "")
        return {"file": self.file, "student": self.student, "task": self.task, "verdict": self.verdict, "why": why,
                "run": self.run} | results  # fmt: skip

    @property
    def level(self) -> str:
        """The level of the verdict."""
        return SHOWN[self.verdict].level

    @property
    def runs(self) -> dict[str, RunResult | None]:
        """What was claimed, and what came of it when it was run again."""
        return {"claimed": self.claimed, "replayed": self.replayed}


def differs(claimed: RunResult, replayed: RunResult) -> Say | None:
    """How a claim differs from the replay by more than two machines do; None where it does not."""
    if replayed.fell and not claimed.fell:
        time = Quantity(replayed.seconds, "s")
        return Say("claimed that it stood; replayed, it fell at {time}", time=time)
    if claimed.fell and not replayed.fell:
        return Say("claimed that it fell; replayed, it stood")
    numbers = ("seconds",) if claimed.fell else TOLERANCE  # a fall magnifies what differs, but for its time
    for name in numbers:
        absolute, relative = TOLERANCE[name]
        before, now = getattr(claimed, name), getattr(replayed, name)
        if abs(before - now) > absolute + relative * abs(now):
            what, unit = MEASURED[name]
            return Say("claimed {what}: {before}; replayed: {now}", what=what, before=Quantity(before, unit),
                       now=Quantity(now, unit))  # fmt: skip
    return None
