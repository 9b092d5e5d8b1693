"""A robot let go from a lean under its controller: when it stands upright again, and how far it rolls meanwhile."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.control.controller import Controller
from upright.experiment import outcome_of, run
from upright.experiment.outcome import last_part
from upright.robots import Kit, Robot
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEAN = math.radians(5.0)
"""[rad] At which it is let go, at rest."""
UPRIGHT = math.radians(1.0)
"""[rad] Within this pitch the robot counts as upright: many times what sensor noise makes of it on the presets."""
SECONDS = 8.0


@dataclass(frozen=True, eq=False)
class Release:
    """The `log` of a run that starts at rest at a `lean` [rad], on wheels of this `radius` [m]."""

    log: Log
    lean: float
    radius: float

    @property
    def fell(self) -> float | None:
        """When it fell [s]; None where it did not."""
        outcome = outcome_of(self.log)
        return outcome.seconds if outcome.fell else None

    @property
    def upright(self) -> float:
        """From when on [s] pitch stays within `UPRIGHT`; infinite where that is not so in the last quarter."""
        t = self.log.t
        outside = np.flatnonzero(np.abs(self.log["truth/pitch"]) > UPRIGHT)
        first = int(outside[-1]) + 1 if len(outside) else 0
        return math.inf if self.fell is not None or first > last_part(len(t)) else float(t[first])

    @property
    def largest(self) -> float:
        """The largest pitch [rad]."""
        return float(np.abs(self.log["truth/pitch"]).max())

    @property
    def travel(self) -> float:
        """The largest distance of the wheels from where they stood [m]."""
        return float(np.abs(self.log["truth/wheel"]).max()) * self.radius

    def plot(self) -> Figure:
        """Pitch and travel over time."""
        from upright.plotting import AXIS, legend, line, panels

        figure, (pitch, travel) = panels(["pitch [°]", "travel of the wheels [cm]"])
        line(pitch, "pitch", self.log.t, np.degrees(self.log["truth/pitch"]), style=0, solid=True)
        line(
            travel, "travel of the wheels", self.log.t, 100 * self.radius * self.log["truth/wheel"], style=1, solid=True
        )
        band = math.degrees(UPRIGHT)
        for level, name in ((-band, "_"), (band, f"±{band:g}°: upright")):
            pitch.axhline(level, linestyle="--", color=AXIS, linewidth=1.0, label=name)
        return legend(figure)


def let_go(controller: Controller, robot: Robot, kit: Kit, lean: float = LEAN, seconds: float = SECONDS) -> Release:
    """The nonlinear model of `robot` inside `kit`, noise, dead zone and limits included, let go at `lean` [rad]."""
    body = NonlinearBody.dividing(robot, controller.spec.period)
    log = run(Electronics(body, kit), controller, seconds=seconds, start=[lean, 0.0, 0.0, 0.0, 0.0, 0.0])
    return Release(log, lean, robot.wheel_radius)
