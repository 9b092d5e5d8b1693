"""Spellings that commands once had, and what to type now: an old one is answered with a line, not obeyed."""

from __future__ import annotations

from typing import Any

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


def instead(error: Any) -> str:
    """What to type in place of the option that a command does not have; "" where it never had it."""
    typed = getattr(error, "option_name", "")
    path = error.ctx.command_path if getattr(error, "ctx", None) else ""
    for spellings, commands, now in RETIRED:
        if typed in spellings.split() and path.removeprefix("upright ") in commands:
            return f"{typed} of {path} has another name; try: {now}"
    return ""
