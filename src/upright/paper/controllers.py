"""Chapter 6, beyond the paper: seven controllers under the paper's pushes."""

from __future__ import annotations

from upright import pages
from upright.comparison.bench import bench_controllers
from upright.comparison.bench_page import push_table, responses
from upright.pages.cells import columns_of
from upright.paper.claim import BEYOND, Claim
from upright.progress import Progress, unwatched
from upright.reports import Figure, Table
from upright.robots import Kit, Robot

METHODS = ("lqr", "lqi", "lqg", "pid", "hinf", "mpc", "sliding")


def chapter(robot: Robot, kit: Kit, progress: Progress = unwatched) -> Claim:
    """Seven kinds of controllers on the twin of `robot` with its kit's sensors, held and released as in chapter 5."""
    bench = bench_controllers(robot, kit, methods=METHODS, progress=progress, knocks=False)
    rows = bench.rows
    held = [name for name in METHODS if all(row.holds for row in rows if row.controller == name)]
    travels = {name: max(row.travel or 0.0 for row in rows if row.controller == name) for name in held}
    least = min(travels, key=lambda name: travels[name], default="")
    summary = (
        f"{len(held)} of {len(METHODS)} controllers balance {robot.name} on its sensors through both pushes. The "
        "paper's state feedback has no integral action, so the robot rolls away under a constant force. "
        f"{f'{least} travels least, {travels[least]:.2g} rad of wheel at most.' if least else ''}"
    )
    numbers = {"rows": bench.to_json()["rows"]}
    drawn = responses(bench)
    tables = [push_table(bench, push) for push in dict.fromkeys(row.push for row in rows)]
    items = [Figure(str(drawn.claim), drawn.draw()), *map(_table, tables)]
    return Claim("6", "Every controller under the same pushes", BEYOND, summary, numbers, items)


def _table(table: pages.Table) -> Table:
    """The table for this chapter's page: its cells as texts."""
    names, cells = zip(*columns_of(table), strict=True)
    rows = [[text.text for text in row] for row in zip(*cells, strict=True)]
    return Table(names, rows, str(table.caption))
