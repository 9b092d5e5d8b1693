"""The law behind the commands: the recorded ones against those of the controller's file."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from upright.control import Controller
from upright.diagnose.path import Track, driven
from upright.errors import SpecMismatch
from upright.robots import Kit
from upright.signals import Log
from upright.signals.signal import STATE_NAMES

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Law:
    """How the recorded commands compare with the file's: the `gain` by which they are larger in the last part, how well
    that fits (`share` of the difference explained), and the `misfit` before (rms over rms)."""

    gain: float
    share: float
    misfit: float

    @property
    def known(self) -> bool:
        """Whether the law describes the earlier commands."""
        return self.misfit < 0.05


def replay(found: Track, controller: Controller) -> Array:
    """What the controller gives on the recorded readings, (samples, 2).

    It is told what the motors did as the kit would have it: a dead time of whole periods, and its limits. Raises
    `SpecMismatch` where the log lacks what it reads.
    """
    log, reads = found.log, controller.spec.reads
    missing = [name for name in reads if name not in log]
    if missing:
        raise SpecMismatch(f"the {controller.spec.kind} reads {', '.join(missing)}", expected="channels of the log")
    readings, wanted = np.column_stack([log[n] for n in reads]), references(log)
    told = _told(found, controller.spec.period)
    controller.reset()
    said = np.empty((len(log), 2))
    for i in range(len(log)):
        said[i] = controller.step(readings[i], wanted[i])
        controller.applied(told[i].tolist())
    controller.reset()
    return said


def references(log: Log) -> Array:
    """The wanted states (samples, 6), zero where they were not logged."""
    columns = [f"reference/{name}" for name in STATE_NAMES]
    return np.column_stack([log[n] if n in log else np.zeros(len(log)) for n in columns])


def _told(found: Track, period: float) -> Array:
    """The command at the motors at the end of each period."""
    log = found.log
    if "command/left" in log and "applied/left" in log:
        return np.column_stack([log["applied/left"], log["applied/right"]])
    late = periods_late(found.kit, period)
    sent = driven(found.asked, found.kit, found.robot.command_unit)
    return np.vstack([np.zeros((late, 2)), sent[: len(sent) - late]])


def periods_late(kit: Kit, period: float) -> int:
    """How many periods before the end of one the command was decided that then holds."""
    return max(0, math.ceil((kit.delay + kit.jitter / 2) / period - 0.95))


def by_file(found: Track, controller: Controller, onset: float, end: float) -> Law:
    """The recorded commands from `onset` to `end` [s] against the file's."""
    said = replay(found, controller)
    t = found.log.t
    early, late = t < onset, (t >= onset) & (t <= end)
    return _law(said, found.asked, early if early.any() else late, late)


def _law(said: Array, asked: Array, early: Mask, late: Mask) -> Law:
    n = min(len(early), len(said), len(asked))
    said, asked, early, late = said[:n], asked[:n], early[:n], late[:n]
    misfit = float(np.sqrt(((asked - said)[early] ** 2).mean() / max((asked[early] ** 2).mean(), 1e-12)))
    a, b = asked[late].ravel(), said[late].ravel()
    gain = float(a @ b) / max(float(b @ b), 1e-12) if len(a) else 1.0
    plain, scaled = float(((a - b) ** 2).sum()), float(((a - gain * b) ** 2).sum())
    return Law(gain, 1 - scaled / max(plain, 1e-12), misfit)
