"""The parity of a program with its design: the program itself drives the twin, and every command is compared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.bodies import equipped
from upright.control.controller import Controller
from upright.errors import InvalidController
from upright.execution.execute import execute
from upright.execution.executed import TOLERANCE, Executed
from upright.execution.executor import Executor
from upright.experiment import Hold, run
from upright.experiment.references import Reference
from upright.firmware.generate import Firmware
from upright.firmware.program_file import read_program
from upright.firmware.setup import STATUS
from upright.firmware.targets import ENCODERS
from upright.pages import Result, Say, english
from upright.progress import Progress
from upright.robots import Kit, Robot
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page

PUSHES = {"front": (0.1, 0.0), "back": (-0.12, 10.0)}
"""Pitch [rad] at which each push holds the robot (Herrera et al. 2015, section 3.2), and its start [s]."""

HELD, SECONDS = 5.0, 20.0  # [s] duration of each push, and of the run
KNOCKED = 0.1  # [s] of a push on a robot whose program does not know where its wheels are: under a hold it rolls away
LOST = 0.5  # [rad] pitch from which a robot whose program has stopped does not recover


@dataclass(frozen=True)
class PushOutcome:
    """One push in closed loop: whether the executed program stood, its largest |pitch| [rad], and the outcome."""

    push: str
    stood: bool
    peak: float
    outcome: str


@dataclass(frozen=True, kw_only=True, repr=False)
class Parity(Result):
    """The program run on `where` in `numbers` for `periods`: in the first `steps` of them, which can be compared, its
    commands differed by at most `worst` from the design's in `unit`, where `tolerance` is allowed; `duties` counts the
    periods with a duty that does not follow from its command; `as_generated` is False for an edited file."""

    target: str
    where: Say
    numbers: str
    robot: str
    hash: str
    unit: str
    steps: int
    periods: int
    worst: float
    tolerance: float
    duties: int
    pushes: tuple[PushOutcome, ...]
    as_generated: bool = True

    @property
    def passed(self) -> bool:
        """Equal within the tolerance, every duty right, and upright after both pushes."""
        return self.worst <= self.tolerance and not self.duties and all(p.stood for p in self.pushes)

    def to_json(self) -> dict[str, Any]:
        return {"schema": "upright/parity/1", **asdict(self), "where": english(self.where), "passed": self.passed}

    def page(self) -> Page:
        """The parity for people."""
        from upright.execution.parity_page import parity_page

        return parity_page(self)

    def plot(self) -> Figure:
        """The largest difference of a command, beside what is allowed."""
        from upright.execution.parity_page import draw_difference

        return draw_difference(self.worst, self.tolerance, self.unit)


def parity(
    program: str | Path,
    controller: Controller | str | Path,
    *,
    robot: Robot | str | Path | None = None,
    kit: Kit | str | Path | None = None,
    chip: str = "",
    body: str = "twin",
    progress: Progress | None = None,
) -> Parity:
    """Execute a program by `upright firmware` and compare every command with that of its `controller`.

    It drives the `body` in the kit's electronics for 20 s through both pushes of Herrera et al. (2015). `chip` names
    the executor where a target has several. Raises `InvalidController` for a program of another controller or one that
    stops before the end, `ExecutionFailed` for one that does not answer, `MissingTool`, `UnknownName`.
    """
    file = read_program(program, controller, robot, kit)
    if 0 < file.longest <= SECONDS:
        raise InvalidController(
            f"{program} stops by itself after {file.longest} s", expected=f"more than the {SECONDS:g} s of this test",
            hint="test the same controller with upright firmware --seconds 60",
        )  # fmt: skip
    executor = execute(file.path, file.program, file.firmware.number, chip)
    try:
        result = executed_parity(
            executor, file.controller, file.firmware, file.robot, file.kit, body=body, progress=progress
        )
    finally:
        executor.close()
    return replace(result, as_generated=file.as_generated)


def executed_parity(
    executor: Executor,
    controller: Controller,
    firmware: Firmware,
    robot: Robot,
    kit: Kit,
    *,
    body: str = "twin",
    reference: Reference | Sequence[Reference] = (),
    progress: Progress | None = None,
) -> Parity:
    """The parity of a program that `executor` runs; raises `ExecutionFailed` for one that does not answer."""
    program = firmware.program
    fine = replace(kit, motor=replace(kit.motor, quantum=0.0)) if program.full else kit  # its duties are whole already
    plant = equipped(body, robot, fine)
    executed = Executed(executor, program, kit, controller)
    lasting = HELD if set(ENCODERS) & set(program.channels.values()) else KNOCKED
    pushes = [Hold(pitch=p, start=start, until=start + lasting) for p, start in PUSHES.values()]
    log = run(plant, executed, pushes, reference=reference, seconds=SECONDS, seed=1, progress=progress)
    plant.close()
    stopped = STATUS[executed.status] if executed.status else ""
    return Parity(
        target=program.target,
        where=executor.where,
        numbers=executor.numbers,
        robot=robot.name,
        hash=program.hash,
        unit=program.command_unit,
        steps=executed.steps,
        periods=len(log),
        worst=executed.worst,
        tolerance=TOLERANCE[executor.numbers] if firmware.quantum is None else firmware.quantum,
        duties=executed.wrong,
        pushes=tuple(_outcome(push, log, stopped) for push in PUSHES),
    )


def _outcome(push: str, log: Log, stopped: str) -> PushOutcome:
    """The robot's outcome from a push's start until the next one's; `stopped` is why the program ended."""
    start = PUSHES[push][1]
    half = SECONDS / len(PUSHES)
    ended = float(log.t[-1])
    if ended <= start:
        return PushOutcome(push, False, 0.0, "fell before it")
    peak = float(np.abs(log.between(start, min(start + half, ended))["truth/pitch"]).max())
    if ended < start + half - 2 * float(log.t[1]) or (stopped and peak > LOST):
        return PushOutcome(push, False, peak, f"fell ({stopped or 'lost its balance'})")
    return PushOutcome(push, True, peak, "stood")
