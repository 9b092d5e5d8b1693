"""What is said in one line outside of pages, such as errors and help, in the chosen language.

Such a text is English until somebody reads it. `messages.es.json` holds each as a template, `{}` standing for a fact;
the line that is shown is found among these templates whole, the most literal one first. A line that none fits, as of a
plug-in, stays English.
"""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Callable
from importlib import resources

from upright.languages import ENGLISH, chosen

HOLE = "{}"
TELLING = 7
"""Letters of a template that say something by themselves: fewer, as in "{} is {}", fit what is no message, too."""
NAMES = 2  # words of a name, as in "wheel radius"
PART = re.compile(r"; (expected|likely|try:|or) ")
"""What begins another part of an error."""


class _Template:
    """An English text with holes, and what it is in another language."""

    def __init__(self, english: str, other: str) -> None:
        self.other = other
        self.letters = len(re.findall("[A-Za-z]", english))
        self.begins = not english.startswith(HOLE)
        self._english = english
        self._pieces = [piece.strip() for piece in english.split(HOLE)]

    def facts(self, text: str) -> list[str] | None:
        """What stands in the holes, where the text fits."""
        pieces = self._pieces
        if not (text.startswith(pieces[0]) and text.endswith(pieces[-1]) and all(piece in text for piece in pieces)):
            return None  # before a pattern is compiled, which takes longer than all of this
        pattern = re.escape(self._english).replace(r"\ \{\}", r"(?:\ (.*?))?")  # a fact may be empty
        pattern = re.sub(r"^\\{\\}\\ ", r"(?:(.*?)\\ )?", pattern).replace(r"\{\}", "(.*?)")
        match = re.fullmatch(pattern, text)
        return [fact or "" for fact in match.groups()] if match else None

    def filled(self, facts: list[str]) -> str:
        """The text of the other language with these facts, of which those in quotation marks are names."""
        quoted = [piece.endswith(("'", "`")) for piece in self._pieces]
        shown = [fact if name else _fact(fact) for fact, name in zip(facts, quoted, strict=False)]
        return " ".join(self.other.format(*shown).split())


@functools.cache
def sections(language: str) -> dict[str, dict[str, str]]:
    """English text → text in another language, of messages that are said `here` and `elsewhere`, by libraries."""
    return json.loads(resources.files("upright").joinpath(f"messages.{language}.json").read_text("utf-8"))


@functools.cache
def catalogue(language: str) -> dict[str, str]:
    """English text → text in another language, of all messages."""
    return sections(language)["elsewhere"] | sections(language)["here"]


@functools.cache
def _templates(language: str) -> list[_Template]:
    made = [_Template(english, other) for english, other in catalogue(language).items() if HOLE in english]
    return sorted(made, key=lambda template: -template.letters)


def said(text: str) -> str:
    """A text of one or more lines in the chosen language."""
    return text if chosen() == ENGLISH else "\n".join(map(_line, text.split("\n")))


def _line(line: str) -> str:
    """A line whose parts, as an error has them, are found one by one."""
    first, *parts = PART.split(" ".join(line.split()))
    shown = _whole(first)
    for heading, part in zip(parts[::2], parts[1::2], strict=True):
        shown += f"; {_whole(heading)} {_whole(part)}"
    return line[: len(line) - len(line.lstrip())] + shown


def _whole(text: str) -> str:
    """A part of a message: behind the name of a file stands another message, unless a template holds both."""
    known = _found(text, _telling)
    if known is None:
        head, colon, tail = text.partition(": ")
        if colon and (behind := _whole(tail)) != tail:
            return f"{_fact(head)}: {behind}"
        known = _found(text, _short)
    return text if known is None else known


def _fact(text: str) -> str:
    """A fact, which is a message itself or the name of something."""
    known = _found(text, lambda one, facts: _telling(one, facts) or one.begins or one.letters == 0)
    return text if known is None else known


def _telling(template: _Template, _: list[str]) -> bool:
    return template.letters >= TELLING


def _short(_: _Template, facts: list[str]) -> bool:
    """Whether facts may be names and numbers: around few letters longer ones are another message."""
    return all(len(fact.split()) <= NAMES or _fact(fact) != fact for fact in facts)


def _found(text: str, meant: Callable[[_Template, list[str]], bool]) -> str | None:
    if text in catalogue(chosen()):
        return catalogue(chosen())[text]
    for template in _templates(chosen()):
        facts = template.facts(text)
        if facts is not None and meant(template, facts):
            return template.filled(facts)
    return None
