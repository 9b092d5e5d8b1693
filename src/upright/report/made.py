"""The command that makes a page: what to run next names the files that it wrote."""

from __future__ import annotations

import shlex
from collections.abc import Generator
from contextlib import contextmanager
from contextvars import ContextVar

_COMMAND: ContextVar[str] = ContextVar("COMMAND", default="")


@contextmanager
def made_by(command: str) -> Generator[None]:
    """Pages made inside know this command; '' where a program made them."""
    token = _COMMAND.set(command)
    try:
        yield
    finally:
        _COMMAND.reset(token)


def command() -> str:
    """The command as it was typed; '' where a program makes the page."""
    return _COMMAND.get()


def typed(*names: str) -> str:
    """What was typed behind one of these options, as a word of a command; '' where none was.

    >>> with made_by("upright design lqg -o 'my lqg.json'"):
    ...     typed("-o", "--output")
    "'my lqg.json'"
    """
    words = shlex.split(command())
    for word, after in zip(words, [*words[1:], ""], strict=False):
        if word in names:
            return shlex.quote(after)
        name, equals, value = word.partition("=")
        if equals and name in names:
            return shlex.quote(value)
    return ""


def chosen(*names: str) -> str:
    """These options with what was typed behind them, each with a space before it; '' where none was typed.

    >>> with made_by("upright identify log.csv --robot nxtway-gs"):
    ...     chosen("--robot", "--kit")
    ' --robot nxtway-gs'
    """
    return "".join(f" {name} {value}" for name in names if (value := typed(name)))


def again(otherwise: str, *without: str) -> str:
    """The same command without some options and what was typed behind them; `otherwise` where a program makes the page.

    >>> with made_by("upright identify log.csv --method all --robot nxtway-gs"):
    ...     again("upright identify LOG", "--method")
    'upright identify log.csv --robot nxtway-gs'
    """
    words = shlex.split(command())
    gone = {k + n for k, word in enumerate(words) if word in without for n in (0, 1)}
    kept = [w for k, w in enumerate(words) if k not in gone and w.partition("=")[0] not in without]
    return shlex.join(kept) or otherwise
