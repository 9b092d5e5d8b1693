"""What to run next, with the robot, the kit and the files of the command that made a page."""

from __future__ import annotations

import re

from upright.reports.made import Typed, long, parsed
from upright.reports.page import NEXT

DESIGNS = ("design", "tune")  # commands that write a controller
TAKES = ("certify", "firmware")  # commands whose argument is a controller


def completed(lead: str, command: str) -> str:
    """A page's lead whose next commands go on from the `command` that was typed.

    The same verb with the same argument keeps all that was typed. Another one takes over its `--robot`, its `--kit` and
    the file of its controller, but where the page names files itself.
    """
    answer, mark, following = lead.partition(NEXT)
    made = parsed(command)
    if not mark or not made.verb:
        return lead
    return answer + mark + _COMMAND.sub(lambda match: f"`{_continued(parsed(match[1]), made)}`", following)


_COMMAND = re.compile(r"`(upright [^`]+)`")


def _continued(following: Typed, made: Typed) -> Typed:
    verb, names, options = following
    known = {long(name): value for name, value in made.options}
    if verb == made.verb and any(long(name) == "--output" for name, _ in options):
        return following  # a page that names the file to write names all
    if verb == made.verb and names == made.arguments:
        kept = [pair for pair in made.options if long(pair[0]) != "--output"]
        added = [pair for pair in options if long(pair[0]) not in {**known, "--output": ""}]
        return Typed(verb, names, [*kept, *added])
    controller = known.get("--output" if made.verb in DESIGNS else "--controller", "")
    controller = (
        made.arguments[0]
        if made.verb in TAKES and made.arguments
        else ""
        if made.verb == "bench-controllers"
        else controller
    )
    if verb in TAKES and controller and names and "." not in names[0]:
        names = [controller, *names[1:]]
    same = {"--robot": known.get("--robot"), "--controller": controller}
    by_name = "--robot" in (named := [long(name) for name, _ in options]) and not any(
        long(name) == "--robot" and "." in value for name, value in options
    )
    options = [(name, value if "." in value else same.get(long(name)) or value) for name, value in options]
    if by_name and known.get("--kit") and "--kit" not in named:
        options.insert(named.index("--robot") + 1, ("--kit", known["--kit"]))
    return Typed(verb, names, options)
