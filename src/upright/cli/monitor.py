"""`upright monitor`: what a running program says, line by line, and its log when it stops."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import typer

from upright.cli import options
from upright.cli.output import check_folder
from upright.errors import InvalidLog, UprightError

VIRTUAL, AIR = "virtual", "ble"
FASTEST = 20.0  # [Hz] at which a live robot is shown: more nobody reads


def monitor(
    source: Annotated[
        str,
        typer.Argument(
            help="A hub at ble or ble:NAME; a file, a serial device, or - for what another command prints; virtual, a "
            "hub with the twin round it."
        ),
    ] = "-",
    *,
    program: Annotated[Path | None, typer.Option(help="virtual: the .py that it runs.")] = None,
    seconds: Annotated[
        float, typer.Option("--seconds", "-s", help="How long to follow a hub [s] (default: to its end).")
    ] = float("inf"),
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the log that the program dumps: .parquet, .csv, .mcap.")
    ] = None,
) -> None:
    """Follow a Pybricks or ev3dev program: its telemetry as it comes, then its log.

    On a hub it follows the program that the hub's button starts, and leaves it alone. Every line's CRC is checked.
    """
    from upright.flight.program_logs import read_lines

    if output:
        check_folder(output)
    if (program is not None) != (source == VIRTUAL):
        raise UprightError("a virtual hub needs a program, and nothing else does", expected="virtual --program FILE")
    live = source == VIRTUAL or source.partition(":")[0] == AIR
    shown = Shown(FASTEST if live else float("inf"))
    try:
        if live:
            _follow(source, program, seconds, shown)
        else:
            for line in _lines(source):
                shown.hear(line)
    finally:
        if shown.damaged:
            typer.secho(f"{shown.damaged} damaged lines were left out", err=True)
        if output and shown.kept:
            found = read_lines(shown.kept)
            typer.echo("\n".join([*found.flaws, f"wrote {found.log.save(output)}: {len(found.log)} rows"]))
    if output and not shown.kept:
        raise InvalidLog(f"{source} held no log", expected="the program's lines from H to E", likely="it still runs")


class Shown:
    """Prints lines as they are heard, telemetry at most `fastest` [Hz] times a second; `kept` is the log's."""

    def __init__(self, fastest: float) -> None:
        self.kept, self.damaged = list[str](), 0
        self._pause, self._next = 1 / fastest, 0.0

    def hear(self, line: str) -> None:
        from upright.flight.program_logs import checked_line, is_signed, status_said

        if not is_signed(line):
            typer.echo(line.rstrip("\n"))
            return
        try:
            found = checked_line(line)
        except InvalidLog:
            self.damaged += 1
            return
        if found.kind == "S":
            typer.echo(f"the program stopped by itself: {status_said(found.text)}; its button gives its log")
        elif found.kind != "T":
            self.kept.append(line)
        elif (now := time.monotonic()) >= self._next:
            self._next = now + self._pause
            typer.echo(_said(found.text))


def _follow(source: str, program: Path | None, seconds: float, shown: Shown) -> None:
    from upright.bricks.virtual_robot import virtual_hub
    from upright.firmware import head
    from upright.flight.follow import follow
    from upright.robots import find_kit, find_robot

    if program is None:
        follow(source, shown.hear, seconds=seconds)
        return
    facts = head(options.program_text(program))
    with virtual_hub(find_robot(facts["robot"]), find_kit(facts["kit"]), speed=1.0) as hub:
        follow(hub, shown.hear, program, seconds, lambda: hub.seconds)


def _lines(source: str) -> Iterator[str]:
    if source == "-":
        yield from sys.stdin
        return
    with Path(source).open(encoding="utf-8", errors="replace") as stream:
        yield from stream


def _said(text: str) -> str:
    from upright.flight.program_logs import TELEMETRY

    values = dict(zip(TELEMETRY, map(int, text.split()), strict=False))
    if len(values) < len(TELEMETRY):
        return text
    return (
        f"{values['period']:6d}  pitch {values['pitch'] / 10_000:+.3f} rad  "
        f"wheels {values['encoder_left']:+5d} {values['encoder_right']:+5d} °  "
        f"duty {values['duty_left']:+4d} {values['duty_right']:+4d} %  battery {values['battery'] / 1000:.2f} V"
    )
