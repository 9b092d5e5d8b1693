"""`upright fleet`: many robots at once, pushed alike."""

from __future__ import annotations

from typing import Annotated

from upright.cli.destination import Destination
from upright.cli.fleet_options import Asked, say_how_long
from upright.fleets.usual import FLEET
from upright.progress import progress


def fleet(
    *,
    asked: Asked,
    samples: Annotated[int | None, "Robots drawn (default: 10000; 1000 of a controller called in Python)."] = None,
    push: list[str] | None = None,
    drive: str | None = None,
    turn: str | None = None,
    start: str = "",
    seconds: float = 10.0,
    out: Destination,
) -> None:
    """Simulate many different robots and count the falls.

    Prints the probability of a fall with its 95 % interval, and quantiles of pitch, settling, effort and travel.
    """
    from upright.experiment.notation import first_state, pushes_and_references
    from upright.fleets.fleet import fleet as simulate

    asked.check(out)
    pushes, references = map(tuple, pushes_and_references(push, drive, turn))
    first = first_state(start, "--start")
    ensemble = asked.ensemble(pushes=pushes, references=references, start=first, seconds=seconds)
    number = FLEET[ensemble.called] if samples is None else samples
    say_how_long(asked, ensemble, {f"-n {n}": n * seconds for n in (number, *FLEET)})
    asked.run(
        progress("simulating"), lambda show: simulate(ensemble, number, threads=asked.threads, progress=show), out
    )
