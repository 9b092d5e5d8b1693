"""`upright bench-controllers`: all controllers in one table."""

from __future__ import annotations

from upright.cli.destination import Destination
from upright.progress import progress


def bench_controllers(
    methods: list[str] | None = None,
    *,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    body: str = "twin",
    seed: int = 1,
    out: Destination,
) -> None:
    """Compare all controllers under the same pushes.

    Tests: both pushes of Herrera et al. (2015), and the largest impulse that the robot recovers from. Linear
    controllers are also tested on 200 robots drawn from the spreads. Takes a minute.
    """
    from upright.comparison.bench import bench_controllers as bench

    out.check()
    with progress("simulating") as show:
        result = bench(robot, kit, body, seed=seed, methods=methods or (), progress=show)
    out.finish(result)
