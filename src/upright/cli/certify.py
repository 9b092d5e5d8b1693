"""`upright certify`: may this controller drive this robot?"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json, progress
from upright.errors import InvalidController

if TYPE_CHECKING:
    from upright.certify.certificate import Certificate
    from upright.certify.learnt import Learnt
    from upright.robots import Kit, Robot
    from upright.signals import Log

RED = 3
"""Exit code of a red light, so that a script stops before the robot moves."""


def certify(
    controller: Annotated[str, typer.Argument(help="A controller.json, or a controller by name.")],
    *,
    robot: RobotOption = "nxtway-gs",
    kit: Annotated[
        str | None, typer.Option(help="Electronics by name or TOML file (default: the robot's own).")
    ] = None,
    log: Annotated[
        Path | None,
        typer.Option(help="A raw log of this robot: it is calibrated first, and compared with what is assumed."),
    ] = None,
    mapping: Annotated[
        str | None,
        typer.Option(help="How to read the log: by name or TOML file (default: what seems to fit)."),
    ] = None,
    posterior: Annotated[
        Path | None,
        typer.Option(help="What is known of the robot, as by `upright calibrate --save` (default: its sources)."),
    ] = None,
    samples: Annotated[
        int, typer.Option("--samples", "-n", help="How many robots are drawn; mpc and sliding take minutes for 1000.")
    ] = 1000,
    seed: Annotated[int, typer.Option(help="Seed of all draws and all noise.")] = 0,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the certificate as JSON.")] = None,
    report: Annotated[Path | None, typer.Option(help="Write a page with figures: .html.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Say whether a controller may drive a robot: green, amber or red.

    Many robots drawn from what is not known of it are pushed; prints how many fell and what that proves. The exit code
    is 0 for green and amber, 3 for red.
    """
    from upright.certify.certificate import certify as judge
    from upright.control import find_controller
    from upright.robots import find_kit, find_robot

    if log and posterior:
        raise InvalidController("both --log and --posterior", expected="one of them: the log gives its own posterior")
    for target in (output, report):
        if target:
            check_folder(target)
    nominal = find_robot(robot)
    parts, recording = find_kit(kit or nominal.kit), _recorded(log, mapping)
    known: dict[str, Any] = {"log": recording}
    if recording:
        found = _calibrated(recording, nominal, parts)
        nominal, parts = found.robot, found.kit
        known |= {"sizes": found.sizes, "covariance": found.covariance}
    elif posterior:
        from upright.fleet.vary import known as posterior_of

        nominal, sizes, covariance = posterior_of(nominal, posterior)
        known |= {"sizes": sizes, "covariance": covariance}
    brain = find_controller(controller, nominal, parts, parts.period)
    with progress("certifying") as share:
        certificate = judge(brain, nominal, parts, samples=samples, seed=seed, progress=share, **known)
    _say(certificate, output, report, as_json)
    if certificate.light == "red":
        raise typer.Exit(RED)


def _say(certificate: Certificate, output: Path | None, report: Path | None, as_json: bool) -> None:
    from upright.atomic import write_json

    if output:
        write_json(output, certificate.to_json())
    if report:
        from upright.report.certificate import certificate_page

        certificate_page(certificate, report)
    if as_json:
        print_json(certificate.to_json())
        return
    typer.echo("\n".join([str(certificate), *(f"wrote {path}" for path in (output, report) if path)]))


def _recorded(path: Path | None, mapping: str | None) -> Log | None:
    if path is None:
        return None
    from upright.logs.mapping import find_mapping
    from upright.logs.raw import raw_log

    return raw_log(path, find_mapping(mapping) if mapping else None)


def _calibrated(log: Log, robot: Robot, kit: Kit) -> Learnt:
    from upright.calibrate.calibrate import calibrate
    from upright.certify.learnt import learnt

    with progress("calibrating") as share:
        return learnt(calibrate(log, robot, kit, progress=share), kit)
