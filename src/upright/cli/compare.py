"""`upright compare`: several logs of the same experiment, as numbers and as a page."""

from __future__ import annotations

from typing import Annotated

from upright.cli.destination import Destination
from upright.cli.logs import labelled


def compare(
    logs: Annotated[list[str], "Logs (.parquet, .csv, .mcap), or LABEL=FILE."],
    *,
    reference: str | None = None,
    release: float | None = None,
    out: Destination,
) -> None:
    """Compare logs of the same push.

    Prints settling, overshoot, effort and other metrics of each log, and its fit to the reference.
    """
    from upright.comparison import compare as compare_logs
    from upright.signals import Log

    out.check()
    loaded = {label: Log.load(path) for label, path in labelled(logs).items()}
    out.finish(compare_logs(loaded, reference=reference, release=release))
