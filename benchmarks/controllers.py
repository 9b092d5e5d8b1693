"""Every registered controller on every preset through both of the paper's pushes, on raw sensors: one table.

Run: python benchmarks/controllers.py [--body twin|nonlinear] [--robot NAME ...] [--controller NAME ...] [--seeds N].
The robot is held at +0.1 and −0.12 rad until 3 s, as in a certificate, and then released. The last lines say who holds
all of it, and who falls where. Each row is the worst of its seeds: how many fell,
the largest pitch, when it settled after the release, how far it stood from its place at the end of the hold, the mean
size of the applied command, the share of samples at the limit, and the chattering of the command.
"""

from __future__ import annotations

from dataclasses import astuple, dataclass
from typing import Any

import harness
import numpy as np

from upright.bodies import Electronics, make_body
from upright.control import CONTROLLERS, make_controller
from upright.control.reach import largest_command
from upright.errors import UprightError
from upright.experiment import Hold, run
from upright.robots import Kit, Robot, preset_names
from upright.signals import Log

HOLDS, RELEASE, SECONDS = (0.1, -0.12), 3.0, 11.0
BAND = 0.1  # of the hold: what is called settled; sensors of a degree leave no less


@dataclass
class Row:
    """One run in numbers."""

    fell_at: float
    peak: float
    settling: float
    offset: float
    effort: float
    limited: float
    chatter: float


def main() -> None:
    every = tuple(name for name in CONTROLLERS if name != "lqr-state")
    options = harness.options(__doc__, body="twin", robot=tuple(preset_names()), controller=every, seeds=1)
    print(f"{options.body}, {options.seeds} seed(s)")
    table = harness.Table(
        "robot <20", "controller <18", "hold >6.2f", "fell >6", "peak >7.3f", "settled >9.2f", "offset >8.3f",
        "effort >8.3f", "limit >7.1%", "chatter >9.2f",
    )  # fmt: skip
    falls: dict[str, list[str]] = {name: [] for name in options.controller}
    for name in options.robot:
        robot = Robot.preset(name)
        for controller in options.controller:
            for pitch in HOLDS:
                cells, fell = line(robot, controller, pitch, options.body, options.seeds)
                table.row(name, controller, pitch, *cells)
                falls[controller] += [f"{name} at {pitch:+.2f} rad"] if fell else []
    print("\nholds all of these:", ", ".join(name for name, where in falls.items() if not where) or "none")
    print(*(f"{name} falls: {', '.join(where)}" for name, where in falls.items() if where), sep="\n")


def line(robot: Robot, name: str, pitch: float, body: str, seeds: int) -> tuple[tuple[Any, ...], bool]:
    """The numbers of a row of the table, and whether it fell in any seed; what cannot be designed says why."""
    kit = Kit.preset(robot.kit)
    try:
        controller = make_controller(name, robot, kit, kit.period)
    except UprightError as error:
        return (f"  {error}",), False
    plant = Electronics(make_body(body, robot), kit)
    hold = Hold(pitch=pitch, until=RELEASE)
    logs = [run(plant, controller, hold, seconds=SECONDS, seed=seed) for seed in range(1, seeds + 1)]
    rows = [row(log, robot, kit, pitch) for log in logs]
    plant.close()
    falls = [r.fell_at for r in rows if np.isfinite(r.fell_at)]
    worst = (max(column) for column in list(zip(*map(astuple, rows), strict=True))[1:])
    return (f"{min(falls):.1f}s" if falls else "no", *worst), bool(falls)


def chattering(command: np.ndarray, period: float) -> float:
    """How much a command (n, 2) turns back on itself in a second: |Δu| where Δu changes its sign, over `period` [s]."""
    steps = np.diff(command, axis=0)
    turns = steps[1:] * steps[:-1] < 0
    return float(np.abs(np.where(turns, steps[1:], 0.0)).mean() / period)


def row(log: Log, robot: Robot, kit: Kit, pitch: float) -> Row:
    """Pitch [rad], settling [s], offset [m], effort [V or N m], chatter [the same per second] of one run."""
    t, truth, wheel = log.t, log["truth/pitch"], log["truth/wheel"]
    command = np.column_stack([log["command/left"], log["command/right"]])
    applied = np.column_stack([log["applied/left"], log["applied/right"]])
    fell = log.origin["outcome"]["fell"]
    moving = np.flatnonzero((np.abs(truth) > BAND * abs(pitch)) & (t >= RELEASE))
    settling = np.inf if fell else (t[moving[-1]] - RELEASE if len(moving) else 0.0)
    held = wheel[t < RELEASE][-1]
    return Row(
        float(log.origin["outcome"]["seconds"]) if fell else np.inf,
        float(np.abs(truth).max()), float(settling), float(abs(held) * robot.wheel_radius),
        float(np.abs(applied).mean()), float((np.abs(command) > largest_command(robot, kit)).any(axis=1).mean()),
        chattering(command, kit.period),
    )  # fmt: skip


if __name__ == "__main__":
    main()
