"""The result of a flight, and what flights of all bricks share."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from upright.compiled.program import Program
from upright.errors import UprightError
from upright.firmware.generate import longest_run
from upright.flight.program_logs import ProgramLog

Clock = Callable[[], float]
"""The time [s] of a real or virtual brick."""


STOPS = 3
"""Attempts to stop a program, and to fetch its log; none depends on the one before."""
INTERRUPTED = "stopped by Ctrl-C"
RUNNING = ("", "balancing")  # how the log of a program ends that others stopped, or that was cut off
DRIVEN = ("applied/left", "applied/right")


class FlightRefused(UprightError):
    """A robot that is not ready to be driven."""


class MotorsMayRun(UprightError):
    """A flight that went wrong, of a robot that did not confirm that it stopped."""


@dataclass(kw_only=True)
class Flight:
    """Result of a flight: its `log` if one arrived, whether the connection was `lost`, and `notes` of one line each.

    `robot`, controller `hash`, `port` and `where` (a description of the brick) say whose it is. A virtual robot `fell`
    where it lies at the end; of a real one nobody knows.
    """

    log: ProgramLog | None = None
    lost: bool = False
    notes: list[str] = field(default_factory=list[str])
    robot: str = ""
    hash: str = ""
    port: str = ""
    where: str = ""
    fell: bool = False

    @property
    def drove(self) -> bool:
        """Whether a motor got a command that is not zero, by the log: without one nothing balances."""
        return bool(self.log and any(self.log.log[name].any() for name in DRIVEN if name in self.log.log))

    @property
    def balanced(self) -> bool:
        """Whether motors were driven, no virtual robot fell, and the program did not stop by itself."""
        return self.drove and not self.fell and bool(self.log and self.log.ended in RUNNING)

    @property
    def seconds(self) -> float:
        """Time [s] of the last row of the log."""
        return float(self.log.log.t[-1]) if self.log else 0.0

    @property
    def largest_pitch(self) -> float | None:
        """Largest |pitch| [rad] that the program estimated; None without a log."""
        return float(abs(self.log.log["estimate/pitch"]).max()) if self.log else None

    def keep(self, log: ProgramLog, program: Program) -> None:
        """Keep a log, with a note for each of its flaws."""
        self.log = log
        if log.head["hash"] != program.hash:
            hashes = f"{log.head['hash'][:12]}, not {program.hash[:12]}"
            self.notes.append(f"the log is of another controller ({hashes}), from an earlier flight")
        self.notes += log.flaws
        if log.ended not in RUNNING:
            self.notes.append(f"the program stopped by itself: {log.ended}")

    def to_json(self) -> dict[str, Any]:
        shown = ("seconds", "largest_pitch", "hash", "port", "balanced", "drove", "fell", "lost", "notes")
        return {"rows": len(self.log.log) if self.log else 0} | {name: getattr(self, name) for name in shown}

    def __str__(self) -> str:
        ran = f"{'fell; ran' if self.fell else 'balanced' if self.balanced else 'ran'} for {self.seconds:.1f} s"
        did = ran if self.drove else f"did not balance: no motor was driven in {self.seconds:.1f} s"
        result = f"{did}; largest estimated pitch {self.largest_pitch or 0.0:.3f} rad"
        return "\n".join([f"{self.robot} ({self.where}): {result if self.log else 'no log'}", *self.notes])


def may_run(brick: str, text: str = "") -> str:
    """What its user must know of a brick that did not confirm that its program, `text` where known, stopped."""
    fate = f"; {without_connection(text)}" if text else ""
    return f"motors may be running: {brick} did not confirm its stop: press its button{fate}"


def without_connection(text: str) -> str:
    """What the program `text` does after its connection is lost."""
    longest = longest_run(text)
    return f"its program stops after {longest} s at most" if longest else "its program runs until its button is pressed"
