"""Options that `fleet`, `push-map` and `basin` share: robots, controller and where the result goes."""

from __future__ import annotations

import dataclasses
import functools
import inspect
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, get_type_hints

import typer

from upright.cli.options import (
    IdealKitOption,
    JsonOption,
    KernelOption,
    PosteriorOption,
    ReportOption,
    RobotOption,
    SeedOption,
)
from upright.cli.output import check_targets

if TYPE_CHECKING:
    from upright.fleets.ensemble import Ensemble

VARY_HELP = (
    "Varied number, repeatable: com_height=±10%, com_height=0.06..0.08, com_height=normal:5%, com_height=normal (the "
    "spread of the robot's file); also delay, motor.limit, sensors.gyro.noise; 'spread': all parameters; "
    "'conditions': the battery."
)


@dataclass(frozen=True, kw_only=True)
class Asked:
    """The options, in the order of `--help`."""

    robot: RobotOption = "nxtway-gs"
    controller: KernelOption = "lqr"
    kit: IdealKitOption = None
    vary: Annotated[list[str] | None, typer.Option("--vary", metavar="NAME=...", help=VARY_HELP)] = None
    posterior: PosteriorOption = None
    seed: SeedOption = 0
    threads: Annotated[
        int | None, typer.Option("--threads", min=1, max=1024, help="Threads (default: all processors).")
    ] = None
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the result: .parquet or .zarr.")] = None
    report: ReportOption = None
    as_json: JsonOption = False

    def check(self) -> None:
        """Refuse, before the work, what could not be written after it."""
        if self.output:
            from upright.fleets.results import check_target

            check_target(self.output)
        check_targets(self.report)

    def ensemble(self, vary: Sequence[str] = (), **scenario: Any) -> Ensemble:
        """The fleet; without --vary, `vary` differs."""
        from upright.fleets.fleet import ensemble_of

        return ensemble_of(
            self.robot, self.controller, self.kit, vary=self.vary or vary, posterior=self.posterior, seed=self.seed,
            **scenario,
        )  # fmt: skip


def asked_alike(command: Callable[..., None]) -> Callable[..., None]:
    """The command with every option of `Asked` in place of its argument `asked`."""
    hints = get_type_hints(Asked, include_extras=True)
    kind = inspect.Parameter.KEYWORD_ONLY
    shared = [
        inspect.Parameter(f.name, kind, default=f.default, annotation=hints[f.name]) for f in dataclasses.fields(Asked)
    ]
    own = [p for p in inspect.signature(command, eval_str=True).parameters.values() if p.name != "asked"]
    middle = [parameter.name for parameter in shared].index("seed")

    @functools.wraps(command)
    def asking(**given: Any) -> None:
        known = {parameter.name: given.pop(parameter.name) for parameter in shared if parameter.name in given}
        command(asked=Asked(**known), **given)

    setattr(asking, "__signature__", inspect.Signature([*shared[:middle], *own, *shared[middle:]]))  # noqa: B010
    return asking
