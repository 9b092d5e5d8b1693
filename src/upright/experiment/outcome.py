"""How a run ended: the one definition of a fall, shared by every table, page and line of text."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.bodies.body import FALLEN
from upright.experiment.described import law_in
from upright.pages import Quantity, Say
from upright.signals import Log


@dataclass(frozen=True)
class RunOutcome:
    """Whether the robot `fell`, and after how many `seconds`; else these are those of the run. `fell` is None where
    nobody knows. At `slipped` [s] a motor of a speed drive first lacked the torque for its speed, never where infinite.
    """

    fell: bool | None
    seconds: float
    slipped: float = math.inf

    @property
    def in_words(self) -> Say:
        """The outcome as the title of a page."""
        time = Quantity(self.seconds, "s", digits=4)
        if self.fell is None:
            return Say("A log of {time}", time=time)
        if math.isfinite(self.slipped):
            when = Quantity(self.slipped, "s")
            if self.fell:
                return Say("Its motors slipped at {when}, and it fell at {time}", when=when, time=time)
            return Say("Its motors slipped at {when}; it stood for {time}", when=when, time=time)
        return Say("It fell at {time}", time=time) if self.fell else Say("It stood for {time}", time=time)

    def __str__(self) -> str:
        return str(self.in_words)

    def to_json(self) -> dict[str, Any]:
        lost = {"slipped": self.slipped} if math.isfinite(self.slipped) else {}
        return {"fell": self.fell, "seconds": self.seconds, **lost}


def outcome_of(log: Log) -> RunOutcome:
    """The outcome that the run recorded in the log's origin.

    A log from elsewhere has none. A pitch beyond `FALLEN` in it is then a fall, unless the robot comes back from there;
    without one nobody knows, since such a log may end as the robot begins to fall.
    """
    recorded: Any = log.origin.get("outcome")
    if isinstance(recorded, Mapping) and isinstance(recorded.get("fell"), bool):
        seconds = float(recorded.get("seconds", log.t[-1]))
        return RunOutcome(recorded["fell"], seconds, float(recorded.get("slipped", math.inf)))
    pitch = next((log[name] for name in ("truth/pitch", "estimate/pitch") if name in log), np.empty(0))
    upright = np.flatnonzero(np.abs(pitch) < FALLEN / 2)
    lying = np.flatnonzero(np.abs(pitch) > FALLEN)
    lying = lying[lying > (upright[-1] if len(upright) else -1)]
    return RunOutcome(True, float(log.t[lying[0]])) if len(lying) else RunOutcome(None, float(log.t[-1] - log.t[0]))


CALM = 0.25
"""[1] of a record: what has settled stays in its band at least so long."""


def last_part(n: int) -> int:
    """The first of the last `CALM` of n samples."""
    return n - math.ceil(CALM * n)


def undisturbed(log: Log) -> bool:
    """Whether nothing but its own sensors disturbed the robot: by the log's origin it began at rest, exactly upright,
    without a push, a slope, a reference or an excitation. False where the origin does not say."""
    scenario: Any = log.origin.get("scenario")
    if not isinstance(scenario, Mapping) or "start" not in scenario:
        return False
    excited = "excitation" in law_in(log.origin)
    return not (any(scenario["start"]) or scenario.get("push") or scenario.get("reference") or excited)


def motionless(log: Log) -> Say | None:
    """Why an undisturbed robot never moved; None where it moved, or the log lacks its state or commands.

    A controller that reads noise commands something; a kit's dead zone and resolution take away what is small.
    """
    sides = ("left", "right")
    if not all(f"{kind}/{side}" in log for kind in ("command", "applied") for side in sides):
        return None
    if not all(name in log and not np.ptp(log[name]) for name in ("truth/pitch", "truth/wheel")):
        return None
    if any(log[f"applied/{side}"].any() for side in sides):
        return None
    asked = max(float(np.abs(log[f"command/{side}"]).max()) for side in sides)
    if not asked:
        return Say("Exactly upright it reads no lean, so every command is 0.")
    most = Quantity(asked, log.unit("command/left"), digits=2)
    return Say("Sensor noise asks for {most} at most, too little to turn the motors.", most=most)
