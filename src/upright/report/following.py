"""What to run next, with the robot, the kit and the files of the command that made a page."""

from __future__ import annotations

import re
import shlex
from collections.abc import Sequence

from upright.report.page import NEXT

LONG = {"-r": "--robot", "-c": "--controller", "-o": "--output", "-n": "--samples", "-s": "--seconds"}
DESIGNS = ("design", "tune")  # commands that write a controller
TAKES = ("certify", "firmware")  # commands whose argument is a controller


def completed(lead: str, command: str) -> str:
    """A page's lead whose next commands go on from the `command` that was typed.

    The same verb with the same argument keeps all that was typed. Another one takes over its `--robot`, its `--kit` and
    the file of its controller, but where the page names files itself.
    """
    answer, mark, following = lead.partition(NEXT)
    typed = shlex.split(command)[1:]
    if not mark or not typed:
        return lead
    return answer + mark + _COMMAND.sub(lambda match: f"`{_continued(shlex.split(match[1]), typed)}`", following)


_COMMAND = re.compile(r"`(upright [^`]+)`")


def _continued(words: Sequence[str], typed: Sequence[str]) -> str:
    verb, (names, options) = words[1], _split(words[2:])
    before, was = _split(typed[1:])
    known = {LONG.get(name, name): value for name, value in was}
    if verb == typed[0] and any(LONG.get(name, name) == "--output" for name, _ in options):
        return _quoted(words)  # a page that names the file to write names all
    if verb == typed[0] and names == before:
        kept = [pair for pair in was if LONG.get(pair[0], pair[0]) != "--output"]
        added = [pair for pair in options if LONG.get(pair[0], pair[0]) not in {**known, "--output": ""}]
        return _joined(verb, names, [*kept, *added])
    controller = known.get("--output" if typed[0] in DESIGNS else "--controller", "")
    controller = before[0] if typed[0] in TAKES and before else "" if typed[0] == "bench-controllers" else controller
    if verb in TAKES and controller and names and "." not in names[0]:
        names = [controller, *names[1:]]
    same = {"--robot": known.get("--robot"), "--controller": controller}
    by_name = "--robot" in (long := [LONG.get(name, name) for name, _ in options]) and not any(
        LONG.get(name, name) == "--robot" and "." in value for name, value in options
    )
    options = [(name, value if "." in value else same.get(LONG.get(name, name)) or value) for name, value in options]
    if by_name and known.get("--kit") and "--kit" not in long:
        options.insert(long.index("--robot") + 1, ("--kit", known["--kit"]))
    return _joined(verb, names, options)


def _split(words: Sequence[str]) -> tuple[list[str], list[tuple[str, str]]]:
    """The arguments and the options with their values, as they were written."""
    arguments, options = list[str](), list[tuple[str, str]]()
    rest = list(words)
    while rest:
        word = rest.pop(0)
        if not word.startswith("-"):
            arguments.append(word)
            continue
        name, _, value = word.partition("=")
        options.append((name, value or (rest.pop(0) if rest and not rest[0].startswith("-") else "")))
    return arguments, options


def _joined(verb: str, names: Sequence[str], options: Sequence[tuple[str, str]]) -> str:
    return _quoted(["upright", verb, *names, *(word for pair in options for word in pair if word)])


def _quoted(words: Sequence[str]) -> str:
    """A command as it can be typed: names of files may have spaces. Words that stand for others, LOG or …, stay."""
    return " ".join(shlex.quote(word) if re.search(r"""[\s'"]""", word) else word for word in words)
