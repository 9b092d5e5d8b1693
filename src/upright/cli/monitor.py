"""`upright monitor`: what a running program says, line by line, and its log when it stops."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import typer

from upright.cli.output import check_folder
from upright.errors import InvalidLog

FIELDS = ("period", "encoder_left", "encoder_right", "pitch", "duty_left", "duty_right", "battery")


def monitor(
    source: Annotated[str, typer.Argument(help="A file, a serial device, or - for what another command prints.")] = "-",
    *,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the log that the program dumps: .parquet, .csv, .mcap.")
    ] = None,
) -> None:
    """Follow a Pybricks or ev3dev program: its telemetry as it comes, then its log.

    For example `pybricksdev run ble balance.py | upright monitor - -o run.parquet`. Every line's CRC is checked.
    """
    from upright.firmware.logs import checked_line, read_lines

    if output:
        check_folder(output)
    kept, damaged = list[str](), 0
    for line in _lines(source):
        kind = line[:2]
        if kind not in ("T ", "H ", "D ", "E "):
            typer.echo(line.rstrip("\n"))
            continue
        try:
            _, text = checked_line(line)
        except InvalidLog:
            damaged += 1
            continue
        if kind == "T ":
            typer.echo(_said(text))
        else:
            kept.append(line)
    if damaged:
        typer.secho(f"{damaged} damaged lines were left out", err=True)
    if kept and output:
        log = read_lines(kept, partial=True)
        typer.echo(f"wrote {log.save(output)}: {len(log)} rows")
    elif output:
        raise InvalidLog(f"{source} held no log", expected="the program's lines from H to E", likely="it still runs")


def _lines(source: str) -> Iterator[str]:
    if source == "-":
        yield from sys.stdin
        return
    with Path(source).open(encoding="utf-8", errors="replace") as stream:
        yield from stream


def _said(text: str) -> str:
    values = dict(zip(FIELDS, map(int, text.split()), strict=False))
    if len(values) < len(FIELDS):
        return text
    return (
        f"{values['period']:6d}  pitch {values['pitch'] / 10_000:+.3f} rad  "
        f"wheels {values['encoder_left']:+5d} {values['encoder_right']:+5d} °  "
        f"duty {values['duty_left']:+4d} {values['duty_right']:+4d} %  battery {values['battery'] / 1000:.2f} V"
    )
