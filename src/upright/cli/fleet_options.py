"""Options that `fleet`, `push-map` and `basin` share: robots, controller and the data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from upright.cli.destination import Destination
from upright.cli.output import as_far_as_it_goes, tell
from upright.progress import Progress

if TYPE_CHECKING:
    from upright.fleets.ensemble import Ensemble


@dataclass(frozen=True, kw_only=True)
class Asked:
    """Which robots under which controller; the data may go to a file."""

    robot: str = "nxtway-gs"
    controller: Annotated[
        str, "Controller by name, controller.json or my.py:Name; what is not compiled takes long."
    ] = "lqg"
    kit: Annotated[str | None, "Electronics by name or TOML file; ideal for none (default: the robot's)."] = None
    vary: list[str] | None = None
    posterior: Path | None = None
    seed: int = 0
    threads: int | None = None
    output: Annotated[Path | None, "Write the data: .parquet or .zarr."] = None

    def check(self, out: Destination) -> None:
        """Refuse, before the work, what could not be written after it."""
        from upright.fleets.results import check_target

        if self.output:
            check_target(self.output)
        out.check()

    def ensemble(self, vary: Sequence[str] = (), **scenario: Any) -> Ensemble:
        """The fleet; without --vary, `vary` differs."""
        from upright.fleets.fleet import ensemble_of

        return ensemble_of(
            self.robot,
            self.controller,
            self.kit,
            vary=self.vary or vary,
            posterior=self.posterior,
            seed=self.seed,
            **scenario,
        )

    def run(self, shown: AbstractContextManager[Progress], work: Callable[[Progress], Any], out: Destination) -> None:
        """Do the work with its progress `shown`; write the data of its fleet, map or basin, and print the page."""
        from upright.fleets.results import save

        as_far_as_it_goes(shown, work, lambda it: out.finish(it, self.output and save(it.data, self.output)))


def say_how_long(asked: Asked, ensemble: Ensemble, work: Mapping[str, float]) -> None:
    """Before a controller is called in Python: how long what is asked takes on this machine, and the usual sizes.

    `work` has the options of each size and its robot seconds, what is asked first.
    """
    if not ensemble.called:
        return
    pace = ensemble.pace()
    (chosen, own), *others = ((options, _clock(pace * seconds)) for options, seconds in work.items())
    instead = "".join(f"; {options}: {time}" for options, time in others)
    tell(f"{asked.controller} is called in Python, not compiled. {chosen}: {own}{instead}", err=True)


def _clock(seconds: float) -> str:
    for unit, length in (("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * length:
            return f"about {seconds / length:.0f} {unit}"
    return f"about {max(1.0, seconds):.0f} s"
