"""`upright fly`: a program onto a brick or a hub, into balance, and its log home."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from upright.cli import options
from upright.cli.keep import check_log_target, save_log
from upright.cli.output import AGAINST, print_json, progress
from upright.errors import UprightError

if TYPE_CHECKING:
    from upright.flight import Flight
    from upright.flight.fly import FlightPlan


def fly(
    program: Annotated[Path, typer.Argument(help="A program by upright firmware for nxc (.nxc) or pybricks (.py).")],
    controller: options.DesignArgument,
    *,
    robot: Annotated[
        str | None,
        typer.Option(
            "--robot",
            "-r",
            help="Robot (name, TOML file) or brick (nxt, spike, ev3) it must be made for.",
            autocompletion=options.complete_robot,
        ),
    ] = None,
    kit: options.ProgramKitOption = None,
    port: Annotated[
        str,
        typer.Option(help="NXT: usb or a device such as /dev/rfcomm0. Hub: ble or ble:NAME. virtual: a simulated one."),
    ] = "virtual",
    certificate: options.CertificateOption = None,
    anyway: options.AnywayOption = False,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="Start without asking.")] = False,
    seconds: Annotated[float, typer.Option("--seconds", "-s", help="Duration with the calibration [s].")] = 20.0,
    push: Annotated[
        list[str] | None,
        typer.Option("--push", "-p", metavar="KIND:NUMBER,...", help="Only with --port virtual. " + options.PUSH_HELP),
    ] = None,
    seed: options.SeedOption = 0,
    output: options.LogOutputOption = None,
    fetch: Annotated[
        bool,
        typer.Option("--fetch", help="Start nothing; stop the running program and fetch its log."),
    ] = False,
    as_json: options.JsonOption = False,
) -> None:
    """Upload a program, start it, and fetch its log.

    Shows robot, controller and certificate, and asks before the start. The motors are off when this ends, Ctrl-C
    included. Exit code 3 where the connection was lost.
    """
    from upright.flight import fetch as fetch_log
    from upright.flight import fly as run_flight

    if output:
        check_log_target(output)
    if fetch:
        flight = fetch_log(program, controller, robot=robot, kit=kit, port=port)
    else:
        pushes = [options.push(p) for p in push or []]
        with progress("flying") as show:
            flight = run_flight(
                program, controller, robot=robot, kit=kit, port=port, certificate=certificate, anyway=anyway,
                seconds=seconds, pushes=pushes, seed=seed, confirm=None if yes or as_json else _ask, progress=show,
            )  # fmt: skip
    path, wrong = save_log(flight.log.log, output) if flight.log and output else (None, "")
    _print(flight, path, as_json)
    if flight.lost:
        raise typer.Exit(AGAINST)  # nobody knows: the program runs on without the connection
    if wrong:
        raise UprightError(f"cannot write {output} ({wrong}); the log is in {path}")


def _print(flight: Flight, path: Path | None, as_json: bool) -> None:
    if as_json:
        print_json(flight.to_json() | {"log": str(path) if path else None})
    else:
        typer.echo(f"{flight}\n\nwrote {path}" if path else str(flight))


def _ask(plan: FlightPlan) -> None:
    typer.echo(str(plan), err=True)
    try:
        typer.confirm("Hold it upright and still. Start?", abort=True, err=True)
    except typer.Abort as stop:
        if not isinstance(stop.__context__, EOFError):
            raise
        raise UprightError(
            "nobody answered: the input is no terminal, and has ended", hint="--yes, or a terminal"
        ) from None
