"""`upright fly`: a program onto a brick or a hub, into balance, and its log home."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from upright.cli.output import AGAINST, print_json, tell
from upright.errors import UprightError
from upright.progress import progress

if TYPE_CHECKING:
    from upright.flight import Flight
    from upright.flight.fly import FlightPlan


def fly(
    program: Annotated[Path, "Program by `upright firmware` for nxc (.nxc) or pybricks (.py)."],
    controller: Annotated[str, "The controller.json of its design."],
    *,
    robot: Annotated[
        str | None,
        "Robot by name (see `upright robots`) or TOML file, or brick (nxt, spike, ev3), that it must be made for.",
    ] = None,
    kit: Annotated[str | None, "Electronics by name or TOML file (default: the program's)."] = None,
    link: str = "virtual",
    certificate: Path | None = None,
    anyway: bool = False,
    yes: bool = False,
    seconds: Annotated[float, "Length of the run [s], with its calibration."] = 20.0,
    push: list[str] | None = None,
    seed: int = 0,
    output: Annotated[Path | None, "Write the log: .parquet, .csv or .mcap."] = None,
    fetch: bool = False,
    json: bool = False,
) -> None:
    """Upload a program, start it, and fetch its log.

    Shows robot, controller and certificate, and asks before the start. Only a virtual robot can be pushed. The motors
    are off when this ends, Ctrl-C included. Exit code 3 where the connection was lost.
    """
    from upright.experiment.notation import push as push_of
    from upright.flight import fetch as fetch_log
    from upright.flight import fly as run_flight
    from upright.flight.keep import check_log_target, save_log

    if output:
        check_log_target(output)
    if fetch:
        flight = fetch_log(program, controller, robot=robot, kit=kit, port=link)
    else:
        pushes = [push_of(p) for p in push or []]
        with progress("flying") as show:
            flight = run_flight(
                program, controller, robot=robot, kit=kit, port=link, certificate=certificate, anyway=anyway,
                seconds=seconds, pushes=pushes, seed=seed, confirm=None if yes else _ask, progress=show,
            )  # fmt: skip
    path, wrong = save_log(flight.log.log, output) if flight.log and output else (None, "")
    _print(flight, path, json=json)
    if flight.lost:
        raise typer.Exit(AGAINST)  # nobody knows: the program runs on without the connection
    if wrong:
        raise UprightError(f"cannot write {output} ({wrong})", hint=f"the log is in {path}")


def _print(flight: Flight, path: Path | None, *, json: bool) -> None:
    if json:
        print_json(flight.to_json() | {"files": [str(path)] if path else []})
    else:
        tell(f"{flight}\n\nwrote {path}" if path else str(flight))


YES = ("y", "yes", "s", "si", "sí")
"""Answers that start the motors, in any language."""


def _ask(plan: FlightPlan) -> None:
    tell(f"{plan}\nHold it upright and still. Start? [y/N]:", err=True, nl=False)
    typer.echo(" ", err=True, nl=False)
    line = sys.stdin.readline()
    if not line:
        tell("", err=True)
        raise UprightError("nobody answered: the input is no terminal, and has ended", hint="--yes, or a terminal")
    if line.strip().lower() not in YES:
        raise typer.Abort
