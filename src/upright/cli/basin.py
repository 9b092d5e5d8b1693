"""`upright basin`: the states from which a robot recovers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from upright.cli.destination import Destination
from upright.cli.fleet_options import Asked, say_how_long
from upright.errors import InvalidScenario
from upright.fleets.usual import BASIN_POINTS
from upright.progress import Progress, progress

if TYPE_CHECKING:
    from upright.fleets.basin import Axis
    from upright.fleets.maps import Basin


def basin(
    *,
    asked: Asked,
    across: str = "pitch=-1..1",
    up: str = "pitch_rate=-10..10",
    points: Annotated[int | None, "Values along each axis (default: 101; 41 of a controller called in Python)."] = None,
    samples: Annotated[int, "Robots drawn at each point; 1: nominal."] = 1,
    start: str = "",
    watch: float = 5.0,
    out: Destination,
) -> None:
    """Find the states from which a robot recovers.

    On a grid of any two of the six states; with samples, the fraction of the robots that recover.
    """
    from upright.experiment.notation import first_state
    from upright.fleets.basin import basin as cut

    asked.check(out)
    first = first_state(start, "--start")
    ensemble = asked.ensemble(start=first, seconds=watch)
    number = BASIN_POINTS[ensemble.called] if points is None else points
    axes = _axis(across, "--across", number), _axis(up, "--up", number)
    say_how_long(asked, ensemble, {f"--points {p}": p * p * samples * watch for p in (number, *BASIN_POINTS)})

    def run(show: Progress) -> Basin:
        return cut(ensemble, *axes, samples=samples, threads=asked.threads, progress=show)

    asked.run(progress("simulating"), run, out)


def _axis(text: str, option: str, points: int) -> Axis:
    from upright.experiment.notation import limits
    from upright.fleets.basin import Axis

    name, equals, ends = (part.strip() for part in text.partition("="))
    if not equals:
        raise InvalidScenario(f"{option} '{text}'", expected="STATE=LOW..HIGH, such as pitch=-1..1")
    return Axis(name, *limits(ends, option), points)
