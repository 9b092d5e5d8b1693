"""A controller by name: designed, checked, analysed on its robot, and let go from a lean."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.atomic import finite
from upright.bodies import Electronics, NonlinearBody
from upright.certification.weights import Weight, weights_of
from upright.control import (
    Controller,
    Design,
    controller_hash,
    design_of,
    make_controller,
    residual_of,
    robust,
    write_controller,
)  # fmt: skip
from upright.errors import InvalidController, SpecMismatch
from upright.experiment import outcome_of, run
from upright.experiment.outcome import last_part
from upright.loops.analysis import Analysis, analyse
from upright.pages import Quantity, Result, Say
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.uncertainty import Uncertainty, at_medians
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page


LEAN = math.radians(5.0)
"""[rad] At which it is let go, at rest."""
UPRIGHT = math.radians(1.0)
"""[rad] Within this pitch the robot counts as upright: many times what sensor noise makes of it on the presets."""
SMALLER = UPRIGHT / LEAN
"""[1] Of that lean, one at which it still counts as upright: the motors' limits are far, and sin ψ is ψ."""
SECONDS = 8.0


@dataclass(frozen=True, eq=False)
class Release:
    """The `log` of a run that starts at rest at a `lean` [rad], on wheels of this `radius` [m]; upright within a `band`
    [rad]."""

    log: Log
    lean: float
    radius: float
    band: float = UPRIGHT

    @property
    def fell_at(self) -> float | None:
        """When it fell [s]; None where it did not."""
        outcome = outcome_of(self.log)
        return outcome.seconds if outcome.fell else None

    @property
    def upright(self) -> float:
        """From when on [s] pitch stays within the `band`; infinite where that is not so in the last quarter."""
        t = self.log.t
        outside = np.flatnonzero(np.abs(self.log["truth/pitch"]) > self.band)
        first = int(outside[-1]) + 1 if len(outside) else 0
        return math.inf if self.fell_at is not None or first > last_part(len(t)) else float(t[first])

    @property
    def largest(self) -> float:
        """The largest pitch [rad]."""
        return float(np.abs(self.log["truth/pitch"]).max())

    @property
    def travel(self) -> float:
        """The largest distance of the wheels from where they stood [m]."""
        return float(np.abs(self.log["truth/wheel"]).max()) * self.radius

    def to_json(self) -> dict[str, Any]:
        """Plain numbers in SI; None for what did not happen."""
        return {
            "lean": self.lean, "fell_at": self.fell_at, "upright": finite(self.upright), "largest": self.largest,
            "travel": self.travel,
        }  # fmt: skip

    def plot(self) -> Figure:
        """Pitch and travel over time."""
        from upright.plotting import AXIS, legend, line, panels

        figure, (pitch, travel) = panels([str(Say("pitch [°]")), str(Say("travel of the wheels [cm]"))])
        line(pitch, str(Say("pitch")), self.log.t, np.degrees(self.log["truth/pitch"]), style=0, solid=True)
        rolled = 100 * self.radius * self.log["truth/wheel"]
        line(travel, str(Say("travel of the wheels")), self.log.t, rolled, style=1, solid=True)
        band = math.degrees(self.band)
        within = Say("±{band}: upright", band=Quantity(self.band, "rad"))
        for level, name in ((-band, "_"), (band, str(within))):
            pitch.axhline(level, linestyle="--", color=AXIS, linewidth=1.0, label=name)
        return legend(figure)


def let_go(controller: Controller, robot: Robot, kit: Kit, lean: float = LEAN, seconds: float = SECONDS) -> Release:
    """The nonlinear model of `robot` inside `kit`, noise, dead zone and limits included, let go at `lean` [rad]."""
    body = NonlinearBody.dividing(robot, controller.spec.period)
    log = run(Electronics(body, kit), controller, seconds=seconds, start=[lean, 0.0, 0.0, 0.0, 0.0, 0.0])
    return Release(log, lean, robot.wheel_radius)


def reliefs(robot: Robot, kit: Kit, lean: float) -> list[tuple[Say, Robot, Kit, float]]:
    """What a linear loop knows nothing of, each with the robot, the kit and the lean [rad] without it."""
    exact, quiet = (
        replace(kit, sensors={name: replace(sensor, **faults) for name, sensor in kit.sensors.items()})
        for faults in ({"bias": 0.0, "bias_walk": 0.0, "offset": 0.0}, {"noise": 0.0, "quantum": 0.0})
    )
    smooth = replace(kit, motor=replace(kit.motor, dead_zone=0.0, quantum=0.0, drop=0.0, backlash=0.0))
    return [
        (Say("Without the offsets of its sensors it stands."), robot, exact, lean),
        (Say("Without the noise and steps of its sensors it stands."), robot, quiet, lean),
        (
            Say("Without dry friction, dead zone, voltage drop, command steps and backlash it stands."),
            robot.without_dry_friction(),
            smooth,
            lean,
        ),
        (Say("Let go at {lean} it stands.", lean=Quantity(SMALLER * lean, "rad")), robot, kit, SMALLER * lean),
    ]


@dataclass(frozen=True, eq=False, repr=False)
class Designed(Result):
    """The `controller` that `method` gives for `robot` with `kit`, and the `analysis` of its linear loop.

    `analysis` is None where the controller is not linear near rest, for the reason in `remark`.
    """

    method: str
    robot: Robot
    kit: Kit
    controller: Controller
    analysis: Analysis | None
    remark: str = ""

    def let_go(self) -> Release:
        """A run in which the robot is let go from a lean at rest."""
        return let_go(self.controller, self.robot, self.kit)

    @cached_property
    def release(self) -> Release | None:
        """The same, run once; None where the kit lacks what the controller reads."""
        try:
            return self.let_go()
        except SpecMismatch:
            return None

    @cached_property
    def reasons(self) -> list[Say]:
        """Of a robot that falls when let go under a loop that stands where it is linear: what by itself decides it."""
        run, loop = self.release, self.analysis
        if not (run and loop and run.fell_at is not None and (loop.stable or loop.free)):
            return []
        stood = list[Say]()
        for word, robot, kit, lean in reliefs(self.robot, self.kit, run.lean):
            if let_go(self.controller, robot, kit, lean).fell_at is None:
                stood.append(word)
        return stood or [Say("The linear loop stands; no single fault of sensors or motors decides the fall.")]

    @cached_property
    def weights(self) -> tuple[Weight, ...]:
        """What the controller was found by."""
        return weights_of(self.controller)

    @property
    def record(self) -> Design | None:
        """How the controller was found, where that is known."""
        return design_of(self.controller)

    @property
    def words(self) -> list[Say]:
        """What its method says of it."""
        return [word for word in self.record.words() if isinstance(word, Say)] if self.record else []

    def plot(self) -> Figure:
        """Pitch and travel of the robot that is let go; raises `InvalidController` where it cannot run."""
        if not self.release:
            raise InvalidController(self.remark, expected="a kit with the sensors that it reads")
        return self.release.plot()

    def page(self) -> Page:
        """The design for people."""
        from upright.certification.design_page import design_page

        return design_page(self)

    def save(self, path: str | Path) -> Path:
        """Write the controller as JSON; raises `InvalidController` for a kind that no file can hold."""
        return write_controller(self.controller, path)

    def facts(self) -> dict[str, Any]:
        """Method, robot, kit, period [s], channels read, hash, and the residual of the equations that were solved."""
        return {
            "method": self.method, "robot": self.robot.name, "kit": self.kit.name,
            "period": self.controller.spec.period, "reads": list(self.controller.spec.reads),
            "residual": residual_of(self.controller), "hash": controller_hash(self.controller),
        }  # fmt: skip

    def to_json(self) -> dict[str, Any]:
        """The facts, what the method says of its design, its weights, the run in which the robot is let go, and the
        analysis or, as a `remark`, the reason for none."""
        return (
            {"schema": "upright/design/1"}
            | self.facts()
            | {
                "design": self.record.to_json() if self.record else None,
                "weights": [asdict(weight) for weight in self.weights],
                "let_go": self.release.to_json() if self.release else None,
                "reasons": [str(word) for word in self.reasons],
                "analysis": self.analysis.to_json() if self.analysis else None,
                "remark": self.remark,
            }
        )


def design(
    method: str,
    robot: Robot | str,
    kit: Kit | str | None = None,
    *,
    period: float | None = None,
    own: Mapping[str, float | str] | None = None,
    posterior: Uncertainty | str | PathLike[str] | None = None,
) -> Designed:
    """The controller of that `method` for a robot with `kit` (None: its own), every `period` [s] (None: the kit's).

    `own` are the method's own numbers and words, as pid-angle takes them. `posterior`, such as a file by
    `upright calibrate --save`, puts the robot at its medians; the method robust alone uses it. Raises `UnknownName` for
    a method that is not registered, `DesignFailed` where it has no solution.
    """
    nominal, unknown = at_medians(find_robot(robot), posterior)
    parts = find_kit(kit or nominal.kit)
    dt = parts.period if period is None else period
    if unknown is None:
        controller = make_controller(method, nominal, parts, dt, own)
    elif method == "robust":
        controller = robust(nominal, parts, dt, uncertainty=unknown)
    else:
        raise InvalidController(f"a posterior with {method}", expected="the method robust, which alone uses it")
    try:
        return Designed(method, nominal, parts, controller, analyse(controller, nominal, parts))
    except (InvalidController, SpecMismatch) as error:
        return Designed(method, nominal, parts, controller, None, str(error))
