"""Chapter 6, beyond the paper: seven controllers under the paper's pushes."""

from __future__ import annotations

from upright.comparison.bench import BenchRow, bench_controllers, bench_json
from upright.paper.claim import BEYOND, Claim, Progress, silent
from upright.report import Table
from upright.report.page import Cell
from upright.robots import Kit, Robot

METHODS = ("lqr", "lqi", "lqg", "pid", "hinf", "mpc", "sliding")


def chapter(robot: Robot, kit: Kit, progress: Progress = silent) -> Claim:
    """Seven kinds of controllers on the twin of `robot` with its kit's sensors, held and released as in chapter 5."""
    rows = bench_controllers(robot, kit, methods=METHODS, progress=progress, knocks=False)
    held = [name for name in METHODS if all(row.holds for row in rows if row.controller == name)]
    least = min((row for row in rows if row.holds), key=lambda row: row.travel or 0.0)
    summary = (
        f"{len(held)} of {len(METHODS)} controllers balance {robot.name} on its sensors through both pushes. The "
        "paper's state feedback has no integral action, so the robot rolls away under a constant force. "
        f"{least.controller} travels least, {least.travel:.2g} rad of wheel."
    )
    return Claim(
        "6", "Every controller under the same pushes", BEYOND, summary, {"rows": bench_json(rows)}, [_table(rows)]
    )


def _table(rows: tuple[BenchRow, ...]) -> Table:
    header = [
        "controller",
        "push",
        "holds",
        "peak pitch [rad]",
        "settling 5 % [s]",
        "travel [rad]",
        "effort [V² s]",
        "saturated",
        "falls, random robots",
    ]
    cells: list[list[Cell]] = [
        [r.controller, r.push, r.outcome, r.peak, r.settling, r.travel, r.effort, r.saturated, r.spread] for r in rows
    ]
    return Table(
        header,
        cells,
        "Held until 3 s, then released: the twin with its kit's sensors, and 200 random robots",
        digits=3,
    )
