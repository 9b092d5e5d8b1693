"""`upright sweep`: a campaign of robots, controllers and scenarios."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from upright.cli.destination import Destination
from upright.cli.output import as_far_as_it_goes, goes_on_from
from upright.progress import Progress, progress

if TYPE_CHECKING:
    from upright.fleets.cases import Cases


def sweep(
    spec: Path,
    *,
    output: Annotated[Path | None, "Write the results into this folder (default: the file's name)."] = None,
    cluster: str | None = None,
    workers: int | None = None,
    out: Destination,
) -> None:
    """Run a campaign of robots, controllers and scenarios.

    Runs in chunks, in several processes. A stopped campaign goes on from its finished chunks when it is started again.
    """
    from upright.fleets.campaign import run_campaign
    from upright.fleets.sweep import read_campaign

    out.check()
    campaign = read_campaign(spec)
    place = output or spec.with_suffix("")

    def run(show: Progress) -> Cases:
        with goes_on_from(place, f"finished chunks are kept in {place}: the same command goes on"):
            return run_campaign(campaign, place, workers=workers, cluster=cluster, progress=show)

    as_far_as_it_goes(progress("campaign"), run, lambda cases: out.finish(cases, place))
