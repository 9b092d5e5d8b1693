"""`upright certify`: may this controller drive this robot?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.destination import Destination
from upright.cli.output import AGAINST
from upright.progress import progress


def certify(
    controller: str,
    *,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    log: Annotated[Path | None, "Log of this robot: calibrates it first and tests the assumptions."] = None,
    mapping: str | None = None,
    posterior: Path | None = None,
    weighed: float | None = None,
    period: float | None = None,
    samples: int = 1000,
    seed: int = 0,
    output: Annotated[Path | None, "Write the certificate as JSON."] = None,
    out: Destination,
) -> None:
    """Certify a controller for a robot: green, amber, red or unknown.

    Does it stand? How hard may I push it? Which of its numbers are guesses, and which decides? Exit code 0 for green
    and amber, 3 for red and unknown.
    """
    from upright.certification.certificate import certify as examine

    out.check(output)
    with progress("certifying") as show:
        certificate = examine(
            controller,
            robot,
            kit,
            log=log,
            mapping=mapping,
            posterior=posterior,
            weighed=weighed,
            period=period,
            samples=samples,
            seed=seed,
            progress=show,
        )
    out.finish(certificate, output and certificate.save(output))
    if certificate.light in ("red", "unknown"):
        raise typer.Exit(AGAINST)
