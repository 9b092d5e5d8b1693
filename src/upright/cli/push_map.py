"""`upright push-map`: the largest push that a robot recovers from."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from upright.cli.destination import Destination
from upright.cli.fleet_options import Asked, say_how_long
from upright.errors import InvalidScenario
from upright.fleets.usual import MAP_POINTS, MAP_ROBOTS
from upright.progress import Progress, progress

if TYPE_CHECKING:
    from upright.fleets.maps import PushMap

WAYS = {"forward": (1,), "backward": (-1,), "both": (1, -1)}
"""Direction of a push → its signs."""


def push_map(
    *,
    asked: Asked,
    direction: str = "both",
    heights: str | None = None,
    durations: str = "0.01..0.5",
    points: Annotated[int | None, "Values along each axis (default: 64; 8 of a controller called in Python)."] = None,
    samples: Annotated[
        int | None, "Robots drawn for the band; 0: none (default: 200; 20 of a controller called in Python)."
    ] = None,
    tolerance: float = 0.01,
    watch: float = 5.0,
    out: Destination,
) -> None:
    """Find the largest push a robot recovers from.

    By direction, height and duration, with a 95 % band over the uncertain parameters (default: --vary spread). Ctrl-C
    shows what is found until then.
    """
    import numpy as np

    from upright.experiment.notation import limits
    from upright.fleets.push_map import PushGrid, robot_seconds
    from upright.fleets.push_map import push_map as search

    asked.check(out)
    if direction not in WAYS:
        raise InvalidScenario(f"--direction {direction}", expected=" or ".join(WAYS))
    ensemble = asked.ensemble(vary=() if asked.posterior else ("spread",))
    within = limits(heights or f"0..{ensemble.family.robot.body_height}", "--heights")
    lasting = limits(durations, "--durations")

    def grid_of(each: int) -> PushGrid:
        return PushGrid(
            directions=WAYS[direction], heights=np.linspace(*within, each), durations=np.linspace(*lasting, each)
        )

    count = MAP_POINTS[ensemble.called] if points is None else points
    drawn = MAP_ROBOTS[ensemble.called] if samples is None else samples
    work: dict[str, float] = {}
    for p, n in ((count, drawn), *zip(MAP_POINTS, MAP_ROBOTS, strict=True)):
        work[f"--points {p} -n {n}"] = robot_seconds(ensemble, grid_of(p), n, tolerance=tolerance, watch=watch)
    say_how_long(asked, ensemble, work)

    def run(show: Progress) -> PushMap:
        return search(
            ensemble,
            grid_of(count),
            samples=drawn,
            tolerance=tolerance,
            watch=watch,
            threads=asked.threads,
            progress=show,
        )

    asked.run(progress("searching"), run, out)
