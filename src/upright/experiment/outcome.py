"""How a run ended: the one definition of a fall, shared by every table, page and line of text."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.bodies.body import FALLEN
from upright.signals import Log

PUSHED = "--push hold:0.1,until=1"
"""What to add to a run that nothing disturbs."""


@dataclass(frozen=True)
class RunOutcome:
    """Whether the robot `fell`, and after how many `seconds`; else these are those of the run. `fell` is None where
    nobody knows. At `slipped` [s] a motor of a speed drive first lacked the torque for its speed, never where infinite.
    """

    fell: bool | None
    seconds: float
    slipped: float = math.inf

    def __str__(self) -> str:
        words = {True: "fell at", False: "stood for", None: "recorded for"}
        lost = f", motors slipped at {self.slipped:.4g} s" if math.isfinite(self.slipped) else ""
        return f"{words[self.fell]} {self.seconds:.4g} s{lost}"

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
    kind = str(log.origin.get("controller", {}).get("kind", ""))
    return not (any(scenario["start"]) or scenario.get("push") or scenario.get("reference") or "excitation" in kind)


TAKEN = {"dead_zone": "dead zone", "drop": "drop"}
"""Numbers of a motor [V] that keep small commands from it, in words."""


def motionless(log: Log) -> str:
    """Why an undisturbed robot never moved, as a sentence; '' where it moved, or the log lacks its state or commands.

    A controller that reads noise commands something; a kit's dead zone and resolution take away what is small.
    """
    sides = ("left", "right")
    if not all(f"{kind}/{side}" in log for kind in ("command", "applied") for side in sides):
        return ""
    if not all(name in log and not np.ptp(log[name]) for name in ("truth/pitch", "truth/wheel")):
        return ""
    asked, given = (
        max(float(np.abs(log[f"{kind}/{side}"]).max()) for side in sides) for kind in ("command", "applied")
    )
    if given:
        return ""
    if not asked:
        return "Exactly upright it reads no lean, so every command is 0."
    unit = log.unit("command/left")
    asks = f"The sensors' noise makes commands of up to {asked:.2g} {unit}"
    motor = log.origin.get("kit", {}).get("motor", {}) if unit == "V" else {}
    why = [f"{words}: {motor[name]:g} V" for name, words in TAKEN.items() if motor.get(name)]
    within = f" ({', '.join(why)})" if why else ""
    return f"{asks}, too small to turn the motors{within}: 0 {unit} is applied."
