"""How commands print: tables, JSON, progress."""

from __future__ import annotations

import itertools
import os
import shlex
import shutil
import sys
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from upright import interrupts
from upright.atomic import json_text, place_of
from upright.cli.typed import GIVEN, TYPED
from upright.errors import UprightError
from upright.languages import ENGLISH, speaking
from upright.messages import in_language
from upright.pages import Next, Page, Say
from upright.pages.blocks import is_placeholder
from upright.pages.terminal import WIDTH
from upright.pages.terminal import text as page_text
from upright.progress import Progress

if TYPE_CHECKING:
    from upright.robots import Robot


def tell(text: str, *, err: bool = False, nl: bool = True) -> None:
    """Print in the chosen language what is said beside a result, on stderr where `err`."""
    typer.echo(in_language(text), err=err, nl=nl)


@contextmanager
def goes_on_from(place: Path | None, how: str) -> Generator[None]:
    """Say, where the run is interrupted, `how` to go on from what it keeps at `place`, if anything is there yet."""
    try:
        yield
    except KeyboardInterrupt:
        if place and place.exists():
            tell(how, err=True)
        raise


def print_json(data: Any) -> None:
    """Print JSON on stdout."""
    typer.echo(json_text(data, sys.stdout.encoding))


def as_far_as_it_goes(
    shown: AbstractContextManager[Progress], work: Callable[[Progress], Any], finish: Callable[[Any], None]
) -> None:
    """`finish` what the `work` finds; after Ctrl-C what it found until then, with the exit code of such a run."""

    def first() -> None:
        tell("stopping; Ctrl-C again ends at once", err=True)

    def going_on(fraction: float) -> None:
        interrupts.check()  # a signal's exception may have been lost in C
        show(fraction)

    try:
        with shown as show, interrupts.keeping(first):
            result = work(going_on)
    except interrupts.Stopped as stopped:
        tell("what is done so far:", err=True)
        finish(stopped.result)
        raise typer.Exit(interrupts.exit_code()) from None
    finish(result)


AGAINST = 3
"""Exit code of a verdict against, or unknown, so that a script stops before the robot moves."""


def print_page(
    page: Page, data: dict[str, Any] | None = None, written: Iterable[Path | None] = (), *, wide: bool = False
) -> None:
    """Print a page for people, or its head as JSON beside the `data`; the files `written` end it."""
    if data is not None:
        with speaking(ENGLISH):  # what a program reads is in one language
            print_json({"head": page.head()} | data)
        return
    terminal = sys.stdout.isatty()
    width = shutil.get_terminal_size().columns if terminal else WIDTH
    colour = terminal and not os.environ.get("NO_COLOR")
    files = "\n".join(str(Say("wrote {file}", file=str(path))) for path in written if path)
    typer.echo("\n\n".join(filter(None, [page_text(page, width, colour=colour, wide=wide), files])))


CARRIED = ("robot", "kit", "controller", "mapping", "posterior")
"""Options that the next command takes over from this one."""


def continued(page: Page) -> Page:
    """The page whose next commands are for the robot, the kit and the files that were typed."""
    typed = {name: value for name, value in GIVEN.get().items() if name in CARRIED and not isinstance(value, list)}
    steps = [_for_typed(step, typed) for step in page.next]
    return replace(page, next=[step for step in steps if not _typed_already(step)])


def _for_typed(step: Next, typed: Mapping[str, Any]) -> Next:
    from upright.cli.help import parameters_of
    from upright.robots import offered

    known = parameters_of(step.verb)
    changed = {name for name, value in step.options.items() if is_placeholder(value) and value != name.upper()}
    kept = {name: value for name, value in typed.items() if name in known and name not in changed}
    given = step.given
    method, file = (GIVEN.get().get(name) for name in ("method", "output"))
    if step.verb == "certify" and method and file and step.given[0].startswith(str(method)):
        # the controller that was made goes on, not another like it
        return Next(step.verb, str(file), why=None, **{**step.options, **kept})
    for name in ("robot", "controller"):
        if name in kept and known[name]:  # of a name or a file that is typed first
            given = [str(kept.pop(name)), *given[1:]]
    options = {name: _free(value) if name in WRITTEN else value for name, value in step.options.items()}
    if "robot" in options and "robot" not in changed:
        options["robot"] = offered(options["robot"])
    return Next(step.verb, *given, why=step.why, **{**options, **kept})


WRITTEN = ("output", "fix", "write_mapping")
"""Options that name a file to write."""


def _free(file: str) -> str:
    """The name of a file that is proposed, or one like it where there is such a file, which is not written over."""
    path = Path(file)
    names = (path.with_name(f"{path.stem}-{k}{path.suffix}") for k in itertools.count(2))
    return file if not path.exists() else str(next(name for name in names if not name.exists()))


def _typed_already(step: Next) -> bool:
    """Whether it asks for nothing but what was typed, be it into another file."""
    from upright.cli.help import parameters_of

    typed = GIVEN.get()
    arguments = [typed.get(name) for name, first in parameters_of(step.verb).items() if first]
    words = [str(word) for value in arguments for word in (value if isinstance(value, list) else [value])]
    options = ((name, value) for name, value in step.options.items() if not (name in WRITTEN and typed.get(name)))
    return (
        step.verb.replace("_", "-") in TYPED.get()
        and {*step.given} <= {*words}
        and all(str(typed.get(name)) == value for name, value in options)
    )


def warn_of(robot: Robot) -> None:
    """Say first, on stderr, that no such motor exists, where that is so."""
    from upright.robots.motor import makes_energy

    if wrong := makes_energy(robot):
        tell(f"warning: {wrong}", err=True)


def typed_line() -> str:
    """The command as it was typed, to be typed again in the same folder: what stands at the foot of a page. Of files
    elsewhere only the names stand there: a page is passed on, and a folder tells whose machine it was."""
    words = list(TYPED.get())
    kept = (_bare(word, before) for before, word in zip(["", *words], words, strict=False))
    return shlex.join(["upright", *kept]) if words else ""


def _bare(word: str, before: str) -> str:
    """A word of a command; of a file by its whole path what leads there from here, or its name where it is elsewhere,
    also behind `--report=` or the `name=` of a log."""
    name, equals, file = word.rpartition("=")
    if not os.path.isabs(file) or not (before in _WRITTEN or name in _WRITTEN or Path(file).exists()):
        return word
    path = Path(file)
    inside = path.relative_to(Path.cwd()) if path.is_relative_to(Path.cwd()) else path.name
    return f"{name}{equals}{inside}"


_WRITTEN = ("--report", "-o", "--output", "--save")  # what these name may not be there yet


def check_targets(*targets: Path | None, logs: Iterable[Path] = ()) -> None:
    """Refuse, before the work, a place where no file can be written, and a file that would replace a log or another
    file of the command: a robot, a kit, or a second output."""
    named = [Path(word.partition("=")[2] if word.startswith("--") else word) for word in TYPED.get()]
    outputs = [target for target in targets if target]
    for target in outputs:
        place_of(target)  # which refuses it
        other = str(target.with_name(f"{target.stem}-new{target.suffix}"))
        if any(target.exists() and log.exists() and target.samefile(log) for log in logs):
            raise UprightError(f"{target} is a log itself", expected="another file, since a log is kept", hint=other)
        read = target.exists() and _often(target, named)
        if read or _often(target, outputs):
            raise UprightError(f"{target} is named twice", expected="a file for each thing to write", hint=other)


def refuse_existing(*targets: Path | None) -> None:
    """Refuse to write over a file that its owner edits."""
    for target in targets:
        if target and target.exists():
            raise UprightError(f"{target} exists already", hint="another name, or move the file away")


def _often(path: Path, among: Sequence[Path]) -> bool:
    """Whether a file is named more than once."""
    return sum(os.path.realpath(path) == os.path.realpath(other) for other in among) > 1
