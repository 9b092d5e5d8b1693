"""The command that makes a page: what to run next names the files that it wrote."""

from __future__ import annotations

import re
import shlex
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import NamedTuple

LONG = {"-r": "--robot", "-c": "--controller", "-o": "--output", "-n": "--samples", "-s": "--seconds", "-b": "--body"}

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


class Typed(NamedTuple):
    """A command in its parts, as they were typed."""

    verb: str
    arguments: list[str]
    options: list[tuple[str, str]]
    """Each name with its value; '' behind a name that takes none, and at the end of a command."""

    def __str__(self) -> str:
        options = (word for pair in self.options for word in pair if word)
        return quoted(["upright", self.verb, *self.arguments, *options])


def parsed(line: str) -> Typed:
    """The parts of a command.

    >>> parsed("upright design lqg -o 'my lqg.json' --json")
    Typed(verb='design', arguments=['lqg'], options=[('-o', 'my lqg.json'), ('--json', '')])
    """
    _, verb, *rest = [*shlex.split(line), "", ""]
    arguments = list[str]()
    options = list[tuple[str, str]]()
    while rest:
        word = rest.pop(0)
        if not word.startswith("-"):
            arguments += [word] if word else []
            continue
        name, _, value = word.partition("=")
        options.append((name, value or (rest.pop(0) if rest and not rest[0].startswith("-") else "")))
    return Typed(verb, arguments, options)


def long(name: str) -> str:
    """The long name of an option: `--output` of `-o`."""
    return LONG.get(name, name)


def quoted(words: Sequence[str]) -> str:
    """A command as it can be typed: names of files may have spaces. Words that stand for others, LOG or …, stay."""
    return " ".join(shlex.quote(word) if re.search(r"""[\s'"]""", word) else word for word in words)


def typed(name: str) -> str:
    """What was typed behind an option, by its long name, as a word of a command; '' where nothing was.

    >>> with made_by("upright design lqg -o 'my lqg.json'"):
    ...     typed("--output")
    "'my lqg.json'"
    """
    return next((quoted([value]) for word, value in parsed(command()).options if long(word) == name and value), "")


def chosen(*names: str) -> str:
    """These options, by their long names, with what was typed behind them and a space before each; '' where none was.

    >>> with made_by("upright identify log.csv -r nxtway-gs"):
    ...     chosen("--robot", "--kit")
    ' --robot nxtway-gs'
    """
    return "".join(f" {name} {value}" for name in names if (value := typed(name)))


def again(otherwise: str, *without: str) -> str:
    """The same command without some options, by their long names; `otherwise` where a program makes the page.

    >>> with made_by("upright identify log.csv --method all --robot nxtway-gs"):
    ...     again("upright identify LOG", "--method")
    'upright identify log.csv --robot nxtway-gs'
    """
    made = parsed(command())
    kept = [(name, value) for name, value in made.options if long(name) not in without]
    return str(made._replace(options=kept)) if made.verb else otherwise
