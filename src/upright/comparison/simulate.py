"""One robot under one controller, from names: its log, and what it shows."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING, Any

from upright.bodies import equipped
from upright.comparison.comparison import Comparison, compare
from upright.control import Controller, find_controller
from upright.experiment import outcome_of, run
from upright.experiment.pushes import PushProgramme
from upright.experiment.references import Reference
from upright.experiment.run import REST
from upright.interrupts import MOTORS
from upright.pages import Page, Result
from upright.progress import Progress
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False)
class Simulation(Result):
    """The `log` of a run, and its `numbers`."""

    log: Log
    numbers: Comparison

    def page(self) -> Page:
        """The run for people."""
        return self.numbers.page()

    def plot(self, *signals: str) -> Figure:
        """States over time in degrees (default: those that move); the push is shaded."""
        return self.numbers.plot(*signals)

    def to_json(self) -> dict[str, Any]:
        """The metrics, how the run ended, and where it comes from."""
        outcome = outcome_of(self.log).to_json()
        own = {"schema": "upright/simulate/1", "outcome": outcome, "origin": self.log.origin}
        return self.numbers.to_json() | own


def simulate(
    robot: Robot | str = "nxtway-gs",
    controller: Controller | str | PathLike[str] | None = None,
    kit: Kit | str | None = None,
    *,
    body: str = "nonlinear",
    push: PushProgramme | Sequence[PushProgramme] = (),
    reference: Reference | Sequence[Reference] = (),
    seconds: float = 10.0,
    seed: int = 0,
    start: Sequence[float] = REST,
    period: float | None = None,
    progress: Progress | None = None,
) -> Simulation:
    """Run a `robot` with `kit` (None: its own) under a `controller`, each of which may be a name or a file.

    `body` is the equations that move it: "nonlinear", "linear", "twin", or `file.py:Name`. None as `controller` is LQG,
    or LQR on the true state with the ideal kit; `period` [s] is its own where it is designed here (None: the kit's).
    `push`, `reference`, `seconds`, `seed`, `start` and `progress` are those of `run`, which raises like this.

    >>> simulate("nxtway-gs", seconds=1.0)
    <Simulation: nothing disturbed it>
    """
    chosen = find_robot(robot)
    parts = find_kit(kit or chosen.kit)
    law = controller_for(controller, chosen, parts, period)
    plant = equipped(body, chosen, parts)
    with MOTORS, closing(plant):  # hardware is stopped however this ends
        log = run(plant, law, push, reference=reference, seconds=seconds, seed=seed, start=start, progress=progress)
    return Simulation(log, compare({body: log}))


def controller_for(
    controller: Controller | str | PathLike[str] | None,
    robot: Robot,
    kit: Kit,
    period: float | None = None,
    gain: str | None = None,
) -> Controller:
    """The controller as `find_controller` has it, by default one that reads what the kit shows."""
    usual = "lqr-state" if kit.name == "ideal" else "lqg"
    return find_controller(controller or usual, robot, kit, kit.period if period is None else period, gain)
