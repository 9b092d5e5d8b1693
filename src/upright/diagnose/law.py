"""The recorded commands against those of the controller's file on the same readings."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array
from upright.control import Controller
from upright.diagnose.fall import authority, limit
from upright.diagnose.innovations import FilterRun, driven
from upright.errors import SpecMismatch
from upright.physics.linear import linearise
from upright.robots import Kit
from upright.signals import Log
from upright.signals.signal import STATE_NAMES

EXACT_BEFORE = 0.05  # rms misfit over rms command, below which the file describes the commands
READY = 0.95  # of a period: a command that arrives this late in one holds at its end
BELOW = 0.95  # of the largest command: rows in which the motors had more
FOLLOWS = 0.9  # of the squared commands, what a law explains
NOTHING = 1e-12  # [command²] that keeps a division by zero away


@dataclass(frozen=True)
class CommandMatch:
    """How the recorded commands compare with the file's: the `gain` by which they are larger in the last part, the
    fraction of the difference that this gain has `explained`, and the `misfit` before (rms over rms)."""

    gain: float
    explained: float
    misfit: float

    @property
    def known(self) -> bool:
        """Whether the file describes the earlier commands."""
        return self.misfit < EXACT_BEFORE


def replay(run: FilterRun, controller: Controller) -> Array:
    """What the controller gives on the recorded readings, (samples, 2).

    It is given the applied command as the kit would have it: a dead time of whole periods, and its limits. Raises
    `SpecMismatch` where the log lacks what it reads.
    """
    log = run.log
    reads = controller.spec.reads
    missing = [name for name in reads if name not in log]
    if missing:
        raise SpecMismatch(f"the {controller.spec.kind} reads {', '.join(missing)}", expected="channels of the log")
    readings = np.column_stack([log[n] for n in reads])
    targets = references(log)
    applied = _applied(run, controller.spec.period)
    controller.reset()
    commands = np.empty((len(log), 2))
    for i in range(len(log)):
        commands[i] = controller.step(readings[i], targets[i])
        controller.applied(applied[i].tolist())
    controller.reset()
    return commands


def growth(run: FilterRun, end: float) -> float:
    """The fastest pole [1/s] of the loop that the commands show from the first row to `end` [s]: a law linear in the
    robot's states, by least squares where its motors had more; NaN where the commands follow no such law."""
    motors = authority(run)
    model = linearise(run.robot)
    most = limit(run.robot, run.kit, run.asked)
    rows = (motors.t <= end) & (np.abs(motors.command) < BELOW)
    x = motors.states[rows][:, :4]
    u = motors.command[rows]
    K = np.linalg.lstsq(x, u, rcond=1e-6)[0]
    if not ((u - x @ K) ** 2).sum() < (1 - FOLLOWS) * (u**2).sum():
        return math.nan
    loop = model.A[:4, :4] + most * np.outer(model.B[:4].sum(axis=1), K)
    return float(np.linalg.eigvals(loop).real.max())


def references(log: Log) -> Array:
    """The reference states (samples, 6), zero where they were not logged."""
    columns = [f"reference/{name}" for name in STATE_NAMES]
    return np.column_stack([log[n] if n in log else np.zeros(len(log)) for n in columns])


def _applied(run: FilterRun, period: float) -> Array:
    """The command at the motors at the end of each period."""
    log = run.log
    if "command/left" in log and "applied/left" in log:
        return np.column_stack([log["applied/left"], log["applied/right"]])
    periods = delay_periods(run.kit, period)
    sent = driven(run.asked, run.kit, run.robot.command_unit)
    return np.vstack([np.zeros((periods, 2)), sent[: len(sent) - periods]])


def delay_periods(kit: Kit, period: float) -> int:
    """How many periods before the end of one the command was decided that then holds."""
    return max(0, math.ceil((kit.delay + kit.jitter / 2) / period - READY))


def matched(run: FilterRun, controller: Controller, onset: float, end: float) -> CommandMatch:
    """The recorded commands from `onset` to `end` [s] against the file's."""
    given = replay(run, controller)
    asked = run.asked
    t = run.log.t
    last = (t >= onset) & (t <= end)
    early = t < onset if (t < onset).any() else last
    misfit = float(np.sqrt(((asked - given)[early] ** 2).mean() / max((asked[early] ** 2).mean(), NOTHING)))
    a, b = asked[last].ravel(), given[last].ravel()
    gain = float(a @ b) / max(float(b @ b), NOTHING) if len(a) else 1.0
    plain = float(((a - b) ** 2).sum())
    scaled = float(((a - gain * b) ** 2).sum())
    return CommandMatch(gain, 1 - scaled / max(plain, NOTHING), misfit)
