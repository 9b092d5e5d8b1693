"""`upright certify`: may this controller drive this robot?"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json

if TYPE_CHECKING:
    from upright.robots import Robot


def certify(
    controller: Annotated[str, typer.Argument(help="A controller.json, or a controller by name; it must be linear.")],
    *,
    robot: RobotOption = "nxtway-gs",
    kit: Annotated[
        str | None, typer.Option(help="Electronics by name or TOML file (default: the robot's own).")
    ] = None,
    posterior: Annotated[
        Path | None,
        typer.Option(help="What is known of the robot, as by `upright calibrate --save` (default: its sources)."),
    ] = None,
    samples: Annotated[int, typer.Option("--samples", "-n", help="How many robots are drawn.")] = 1000,
    seed: Annotated[int, typer.Option(help="Seed of all draws and all noise.")] = 0,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the certificate as JSON.")] = None,
    report: Annotated[Path | None, typer.Option(help="Write a page with figures: .html.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Say whether a controller may drive a robot: green, amber or red.

    Many robots drawn from what is not known of it are pushed; prints how many fell and what that proves.
    """
    from upright.atomic import write_json
    from upright.certify.certificate import certify as judge
    from upright.control import find_controller
    from upright.robots.files import find_kit, find_robot

    for target in (output, report):
        if target:
            check_folder(target)
    nominal, known = _known(find_robot(robot), posterior)
    parts = find_kit(kit or nominal.kit)
    brain = find_controller(controller, nominal, parts, parts.period)
    certificate = judge(brain, nominal, parts, samples=samples, seed=seed, **known)
    if output:
        write_json(output, certificate.to_json())
    if report:
        from upright.report.certificate import certificate_page

        certificate_page(certificate, report)
    if as_json:
        print_json(certificate.to_json())
        return
    typer.echo("\n".join([str(certificate), *(f"wrote {path}" for path in (output, report) if path)]))


def _known(robot: Robot, posterior: Path | None) -> tuple[Robot, dict[str, Any]]:
    """The robot at the middle of what is known, and how far from it the draws may be."""
    if posterior is None:
        return robot, {}
    import numpy as np

    from upright.fleet.vary import read_posterior

    found = read_posterior(posterior)
    middle = robot.replace(**dict(zip(found.names, found.mean.tolist(), strict=True)))
    deviations = np.sqrt(np.maximum(np.diag(found.covariance), 0.0))
    sizes = dict(zip(found.names, deviations.tolist(), strict=True))
    return middle, {"sizes": sizes, "covariance": found.covariance}
