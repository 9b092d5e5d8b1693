"""`upright sweep`: a campaign of robots, controllers and scenarios."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.cli.destination import Destination
from upright.cli.output import goes_on_from
from upright.progress import progress


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
    kept = f"finished chunks are kept in {place}: the same command goes on"
    with goes_on_from(place, kept), progress("campaign") as show:
        cases = run_campaign(
            campaign, place, workers=workers, cluster=cluster, progress=lambda done, total, _: show(done / total)
        )
    out.finish(cases, place)
