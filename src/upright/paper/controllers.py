"""Chapter 6, beyond the paper: seven controllers under the paper's pushes."""

from __future__ import annotations

from upright.comparison.bench import bench_controllers
from upright.comparison.bench_page import push_table, responses
from upright.pages import Say
from upright.paper.claim import BEYOND, Claim
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot

METHODS = ("lqr", "lqi", "lqg", "pid", "hinf", "mpc", "sliding")


def chapter(robot: Robot, kit: Kit, progress: Progress = unwatched) -> Claim:
    """Seven kinds of controllers on the twin of `robot` with its kit's sensors, held and released as in chapter 5."""
    bench = bench_controllers(robot, kit, methods=METHODS, progress=progress, knocks=False)
    rows = bench.rows
    held = [name for name in METHODS if all(row.holds for row in rows if row.controller == name)]
    summary = Say(
        "{n} of {all} controllers balance {robot} through both pushes; without integral action it rolls away.",
        n=len(held),
        all=len(METHODS),
        robot=robot.name,
    )
    tables = [push_table(bench, push) for push in dict.fromkeys(row.push for row in rows)]
    title = Say("Other controllers under these pushes")
    return Claim("6", title, BEYOND, summary, {"rows": bench.to_json()["rows"]}, [responses(bench), *tables])
