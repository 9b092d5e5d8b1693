"""What a command line is answered with that no command takes: what came, and what to type instead."""

from __future__ import annotations

import re
from typing import Any

import typer

RETIRED = (
    ("--start", ("calibrate", "identify", "validate", "reproduce"), "--from SECONDS"),
    ("-o --output", ("compare", "doctor", "validate", "post-mortem", "bench-controllers", "parity"), "--save FILE"),
    ("-c --controller", ("identify",), "--regulator FILE"),
    ("-c --controller", ("bench-controllers",), "upright bench-controllers METHOD METHOD"),
    ("-c --controller", ("lab",), "--controllers NAME,NAME"),
    ("-r --robot", ("lab",), "--robots NAME,NAME"),
    ("-s --seconds", ("tune", "post-mortem"), "--time-limit SECONDS"),
    ("-s --seconds", ("basin",), "--watch SECONDS"),
    ("--gains", ("simulate",), "--feedback GAINS"),
    ("--reference", ("firmware",), "--reference-inputs"),
    ("--port", ("fly",), "--link LINK"),
    ("--drive", ("robots new",), "--motors voltage, torque or speed"),
    ("--period", ("robots new",), "--loop-period TIME"),
)
"""Old spellings, the commands that had them, and what each is called now."""


def mistyped(error: typer.TyperException) -> str:
    """The line about what was typed."""
    plain = error.format_message().rstrip(".")
    return _renamed(error) or _refused(error) or plain + _option_of(error, plain)


def _renamed(error: Any) -> str:
    """What to type in place of the option that a command does not have; "" where it never had it."""
    typed = getattr(error, "option_name", "")
    path = error.ctx.command_path if getattr(error, "ctx", None) else ""
    for spellings, commands, now in RETIRED:
        if typed in spellings.split() and path.removeprefix("upright ") in commands:
            return f"{typed} of {path} has another name; try: {now}"
    return ""


def _refused(error: Any) -> str:
    """The number that an option does not take, and which it takes; "" where that is not what is wrong."""
    causes = getattr(error.__cause__, "errors", list)()  # of pydantic
    if not causes:
        return ""
    bounds = causes[0].get("ctx", {})
    if "ge" in bounds:
        expected = f"{bounds['ge']:.19g} or more"
    elif "le" in bounds:
        expected = f"{bounds['le']:.19g} or less"
    else:
        expected = "a whole number" if causes[0]["type"].startswith("int") else "a number"
    return f"{max(error.param.opts, key=len)}: '{causes[0]['input']}'; expected {expected}"


def _option_of(error: Any, plain: str) -> str:
    """What to try after a word too many: the option whose values have such a name, or ""."""
    extra = re.fullmatch(r"Got unexpected extra arguments?(?:\(s\))? \((\S+).*\)", plain)
    if extra is None or getattr(error, "ctx", None) is None:
        return ""
    for option in error.ctx.command.params:
        if extra[1] in (item.value for item in option.shell_complete(error.ctx, extra[1])):
            return f"; try: {max(option.opts, key=len)} {extra[1]}"
    return ""
