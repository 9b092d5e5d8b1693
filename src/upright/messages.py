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
ARTICLES = ("a", "an", "no", "the")
COMMAND = "upright"
"""How a command begins, whose words stay as they are typed."""
PART = re.compile(r"; (expected|likely|try:|or) ")
"""What begins another part of an error."""


class _Template:
    """An English text with holes, and what it is in another language."""

    def __init__(self, english: str, other: str) -> None:
        self.other = other
        self.pieces = [piece.strip() for piece in english.split(HOLE)]
        self.letters = len(re.findall("[A-Za-z]", english))
        self.signs = len("".join(self.pieces).replace(" ", ""))
        self.begins = not english.startswith(HOLE)
        self._english = english

    def facts(self, text: str) -> list[str] | None:
        """What stands in the holes, where the text fits."""
        pieces = self.pieces
        if not (text.startswith(pieces[0]) and text.endswith(pieces[-1]) and all(piece in text for piece in pieces)):
            return None  # before a pattern is compiled, which takes longer than all of this
        pattern = re.escape(self._english).replace(r"\ \{\}", r"(?:\ (.*?))?")  # a fact may be empty
        pattern = re.sub(r"^\\{\\}\\ ", r"(?:(.*?)\\ )?", pattern).replace(r"\{\}", "(.*?)")
        match = re.fullmatch(pattern, text)
        if not match or (not self.begins and re.match(r"\S+: ", match[1] or "")):
            return None  # behind the name of a file stands another message
        return [fact or "" for fact in match.groups()]

    def filled(self, facts: list[str]) -> str:
        """The text of the other language with these facts."""
        shown = [_shown(fact, before) for fact, before in zip(facts, self.pieces, strict=False)]
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
    return sorted(made, key=lambda one: (-one.letters, -one.signs, len(one.pieces)))


def in_language(text: str) -> str:
    """A text of one or more lines in the chosen language."""
    return text if chosen() == ENGLISH else "\n".join(map(_line, text.split("\n")))


def _line(line: str) -> str:
    """A line whose parts, as an error has them, are found one by one."""
    words = " ".join(line.split())
    parts = [words] if words in catalogue(chosen()) else PART.split(words)
    shown = _whole(parts[0])
    for heading, part in zip(parts[1::2], parts[2::2], strict=True):
        shown += f"; {_whole(heading)} {_whole(part)}"
    return line[: len(line) - len(line.lstrip())] + shown


def _whole(text: str) -> str:
    """A part of a message; behind the name of a file stands another message."""
    known = _matched(text, _telling) or _matched(text, _short)
    if known is not None:
        return known
    head, colon, tail = text.partition(": ")
    return f"{_fact(head)}: {_whole(tail)}" if colon else text


def _shown(fact: str, before: str) -> str:
    """A fact behind these words: a single one is a name, which stays, unless an article makes it a noun."""
    noun = before.rpartition(" ")[2] in ARTICLES
    name = before.endswith(("'", "`")) or not (noun or " " in fact)
    return fact if name else _fact(fact)


def _fact(text: str) -> str:
    """A fact, which is a message itself or the name of something."""
    return _matched(text, _certain) or text


def _telling(template: _Template, _: list[str]) -> bool:
    return template.letters >= TELLING


def _certain(template: _Template, facts: list[str]) -> bool:
    """Whether what fits is no name: one that begins so, or in which brackets stand, is none."""
    return template.begins or _telling(template, facts) or (not template.letters and any(template.pieces))


def _short(template: _Template, facts: list[str]) -> bool:
    """Whether facts may be names, numbers and commands: between few letters words are another message."""
    if facts[:1] == [COMMAND]:
        return False  # what follows it is typed, and is no message
    names = [name for fact in facts for name in fact.split(", ") if not name.startswith(f"{COMMAND} ")]
    return template.begins or not any(" " in name and _fact(name) == name for name in names)


def _matched(text: str, meant: Callable[[_Template, list[str]], bool]) -> str | None:
    known = catalogue(chosen())
    if text in known:
        return known[text]
    for template in _templates(chosen()):
        facts = template.facts(text)
        if facts is not None and meant(template, facts):
            return template.filled(facts)
    return None
