"""The lines of a running program on a screen, as fast as one can read them."""

from __future__ import annotations

import time

from upright.errors import InvalidLog
from upright.flight.program_logs import TELEMETRY, checked_line, is_signed, status_text
from upright.messages import in_language


class Screen:
    """Prints lines as they arrive, telemetry at most at `fastest` [Hz]; `kept` holds those of the log."""

    def __init__(self, fastest: float) -> None:
        self.kept = list[str]()
        self.damaged = 0
        self._pause = 1 / fastest
        self._next = 0.0

    def receive(self, line: str) -> None:
        if not is_signed(line):
            _show(line.rstrip("\n"))
            return
        try:
            signed = checked_line(line)
        except InvalidLog:
            self.damaged += 1
            return
        if signed.kind == "S":
            _show(in_language(f"the program stopped by itself: {status_text(signed.text)}; its button gives its log"))
        elif signed.kind != "T":
            self.kept.append(line)
        elif (now := time.monotonic()) >= self._next:
            self._next = now + self._pause
            _show(in_language(_telemetry(signed.text)))


def _telemetry(text: str) -> str:
    values = dict(zip(TELEMETRY, map(int, text.split()), strict=False))
    if len(values) < len(TELEMETRY):
        return text
    return (
        f"{values['period']:6d}  pitch {values['pitch'] / 10_000:+.3f} rad  "
        f"wheels {values['encoder_left']:+5d} {values['encoder_right']:+5d} °  "
        f"duty {values['duty_left']:+4d} {values['duty_right']:+4d} %  battery {values['battery'] / 1000:.2f} V"
    )


def _show(line: str) -> None:
    print(line, flush=True)
