"""`upright monitor`: the output of a running program, line by line, and its log when it stops."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import Annotated

import typer

from upright.errors import InvalidLog
from upright.flight.keep import check_log_target, save_log

FASTEST = 20.0  # [Hz] of telemetry on the screen: faster is not readable


def monitor(
    source: str = "-",
    *,
    program: Annotated[Path | None, "Program by `upright firmware` (.py) that the virtual hub runs."] = None,
    seconds: Annotated[float | None, "Length of the run [s] that is followed (default: to its end)."] = None,
    output: Annotated[Path | None, "Write the log: .parquet, .csv or .mcap."] = None,
) -> None:
    """Show the telemetry of a running program, then its log.

    On a hub the program is started by the hub's button and not stopped from here. The CRC of every line is checked.
    """
    from upright.flight.follow import follow, is_live
    from upright.flight.program_logs import read_lines

    if output:
        check_log_target(output)
    shown = Screen(FASTEST if is_live(source) else math.inf)
    try:
        follow(source, shown.receive, program=program, seconds=math.inf if seconds is None else seconds)
    finally:
        if shown.damaged:
            typer.secho(f"{shown.damaged} damaged lines were left out", err=True)
        if output and shown.kept:
            result = read_lines(shown.kept)
            path, wrong = save_log(result.log, output)
            typer.echo("\n".join([*result.flaws, wrong, f"wrote {path}: {len(result.log)} rows"]).replace("\n\n", "\n"))
    if output and not shown.kept:
        raise InvalidLog(f"{source} held no log", expected="the program's lines from H to E", likely="it still runs")


class Screen:
    """Prints lines as they arrive, telemetry at most at `fastest` [Hz]; `kept` holds those of the log."""

    def __init__(self, fastest: float) -> None:
        self.kept = list[str]()
        self.damaged = 0
        self._pause = 1 / fastest
        self._next = 0.0

    def receive(self, line: str) -> None:
        from upright.flight.program_logs import checked_line, is_signed, status_text

        if not is_signed(line):
            typer.echo(line.rstrip("\n"))
            return
        try:
            signed = checked_line(line)
        except InvalidLog:
            self.damaged += 1
            return
        if signed.kind == "S":
            typer.echo(f"the program stopped by itself: {status_text(signed.text)}; its button gives its log")
        elif signed.kind != "T":
            self.kept.append(line)
        elif (now := time.monotonic()) >= self._next:
            self._next = now + self._pause
            typer.echo(_telemetry(signed.text))


def _telemetry(text: str) -> str:
    from upright.flight.program_logs import TELEMETRY

    values = dict(zip(TELEMETRY, map(int, text.split()), strict=False))
    if len(values) < len(TELEMETRY):
        return text
    return (
        f"{values['period']:6d}  pitch {values['pitch'] / 10_000:+.3f} rad  "
        f"wheels {values['encoder_left']:+5d} {values['encoder_right']:+5d} °  "
        f"duty {values['duty_left']:+4d} {values['duty_right']:+4d} %  battery {values['battery'] / 1000:.2f} V"
    )
