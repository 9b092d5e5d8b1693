"""`upright robots new`: a robot of one's own as two files, from what its owner knows of it."""

from __future__ import annotations

import inspect
import sys
from pathlib import Path
from typing import Annotated

import typer

from upright.cli.command import flag
from upright.cli.guide import EndOfAnswers, Question, answered
from upright.cli.output import refuse_existing, tell
from upright.errors import UprightError
from upright.languages import number, translated
from upright.robots.owner import A_GUESS, DRIVE, DRIVES, NONE, OwnerQuestion, owners_files, plain, questions


def new(name: Annotated[str, typer.Argument(help="Name of the robot, and of its file.")], **given: str | None) -> None:
    """Write a robot of one's own, with its electronics.

    NAME.toml and NAME-kit.toml say of each number what it is. At a terminal it asks for what no option says. What
    nobody answers is a guess, and the files say so. A number takes a unit: 65 mm, 6,5 cm, 48:1.
    """
    from upright.atomic import write_text
    from upright.physics.linear import unstable_pole

    path, kit_path = _files(name)
    drive = plain(_answer("motors", DRIVE, given["motors"], lacks=False))
    asked = questions(drive)
    if foreign := [key for key, text in given.items() if text is not None and key not in ("motors", *asked)]:
        others = [other for other in DRIVES if foreign[0] in questions(other)]
        raise UprightError(f"{flag(foreign[0])} with a {drive} drive", hint=f"--motors {' or '.join(others)}")
    answers: dict[str, str] = {}
    for key, question in asked.items():
        lacks = plain(answers.get(question.needs, "")) == NONE
        answers[key] = _answer(key, question, given[key], lacks=lacks)
    robot, kit, made = owners_files(path, kit_path, drive, answers)
    write_text(kit_path, kit)
    write_text(path, robot)
    of_robot, of_kit = (text.count('spread = "guess"') for text in (robot, kit))
    tell(f"wrote {path} with {of_robot} numbers guessed and {kit_path} with {of_kit}; each says what it is")
    tell(f"{path.stem} falls at {number(unstable_pole(made))} 1/s; try: upright simulate --robot {path}")


def _files(name: str) -> tuple[Path, Path]:
    """The files of the robot and its kit; raises `UprightError` where one is there, or a preset has the name."""
    from upright.robots import preset_names

    path = Path(name.removesuffix(".toml") + ".toml")
    if path.name.startswith("."):
        raise UprightError(f"'{name}' is no name of a robot", expected="a name, which its file gets", hint="mine")
    if path.stem.lower() in preset_names():
        raise UprightError(
            f"{path.stem} is a robot that comes with upright", expected="another name", hint=f"my-{path.stem}"
        )
    kit_path = path.with_name(f"{path.stem}-kit.toml")
    refuse_existing(path, kit_path)
    return path, kit_path


def _option(name: str, question: OwnerQuestion) -> inspect.Parameter:
    asking = [drive for drive in DRIVES if name == "motors" or name in questions(drive)]
    only = "" if len(asking) == len(DRIVES) else f"; --motors {' or '.join(asking)}"
    text = f"{question.asked} (default: {question.usual}{A_GUESS}{only})."
    option = typer.Option(flag(name), help=text, metavar="ANSWER")
    return inspect.Parameter(
        name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=Annotated[str | None, option]
    )


# typer makes one option of each parameter, so each question is one
_NAME = inspect.signature(new, eval_str=True).parameters["name"]
_ALL = {"motors": DRIVE, **questions("speed"), **questions("torque"), **questions("voltage")}
_OPTIONS = [_option(name, question) for name, question in _ALL.items()]
new.__signature__ = inspect.Signature([_NAME, *_OPTIONS])  # type: ignore[attr-defined]


def _answer(name: str, question: OwnerQuestion, given: str | None, *, lacks: bool) -> str:
    """What an option or the terminal says; the usual answer, marked as a guess, where neither does; none where the
    robot lacks what the question is about."""
    guess = question.usual + A_GUESS
    if lacks:
        if given is not None and plain(given) != NONE:
            raise UprightError(f"{flag(name)} without {question.needs}", hint=f"{flag(question.needs)} as well")
        return NONE
    if given is not None:
        question.check(given)
        return NONE if plain(given) == NONE else " ".join(given.split())
    if not sys.stdin.isatty():
        return guess
    try:
        answer = answered(Question(name, question.asked, guess, question.check))
    except EndOfAnswers:
        raise UprightError("no more answers", hint="options, such as --gear 30") from None
    return NONE if answer == translated(NONE) else answer
