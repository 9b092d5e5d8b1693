"""`upright robots new`: a robot of one's own as two files, from what its owner knows of it."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from upright.cli.command import flag
from upright.cli.guide import EndOfAnswers, Question, answered
from upright.cli.owner import A_GUESS, DRIVE, DRIVES, NONE, Answers, FileNumber, OwnerQuestion, file_numbers, questions
from upright.errors import InvalidRobot, UprightError


def new(name: Annotated[str, typer.Argument(help="Name of the robot, and of its file.")], **given: str | None) -> None:
    """Write a robot of one's own, with its electronics.

    NAME.toml and NAME-kit.toml say of each number what it is. At a terminal it asks for what no option says. What
    nobody answers is a guess, and the files say so. A number takes a unit: 65 mm, 6,5 cm, 48:1.
    """
    from upright.atomic import write_text
    from upright.physics.linear import unstable_pole
    from upright.reading import parse_toml
    from upright.robots import PARAMETERS, toml
    from upright.robots.kit import kit_of
    from upright.robots.robot import robot_of

    path, kit_path = _files(name)
    drive = _plain(_answer("motors", DRIVE, given["motors"], lacks=False))
    asked = questions(drive)
    if foreign := [key for key, text in given.items() if text is not None and key not in ("motors", *asked)]:
        others = [other for other in DRIVES if foreign[0] in questions(other)]
        raise UprightError(f"{flag(foreign[0])} with a {drive} drive", hint=f"--motors {' or '.join(others)}")
    answers: dict[str, str] = {}
    for key, question in asked.items():
        lacks = _plain(answers.get(question.needs, "")) == NONE
        answers[key] = _answer(key, question, given[key], lacks=lacks)
    head = {"name": path.stem, "title": "As its owner says.", "drive": drive, "kit": kit_path.name}
    robot = toml.rows("", head)
    kit = toml.rows("", {"name": path.stem, "drive": drive})
    for number, row in file_numbers(drive).items():
        entry = _entry(number, row, answers, drive)
        if number in PARAMETERS:
            robot += entry
        else:
            kit += entry
    kit_of(parse_toml(kit, str(kit_path), InvalidRobot, "a kit"), str(kit_path))
    made = robot_of(parse_toml(robot, str(path), InvalidRobot, "a robot"), str(path))
    write_text(kit_path, kit)
    write_text(path, robot)
    guesses = (robot + kit).count('spread = "guess"')
    typer.echo(f"wrote {path} and {kit_path}: {guesses} numbers are guesses, marked so; each says what it is")
    typer.echo(f"{path.stem} falls at {unstable_pole(made):.3g} 1/s; try: upright simulate --robot {path}")


def _files(name: str) -> tuple[Path, Path]:
    """The files of the robot and its kit; raises `UprightError` where one is there, or a preset has the name."""
    from upright.robots import preset_names

    path = Path(name.removesuffix(".toml") + ".toml")
    if path.stem.lower() in preset_names():
        raise UprightError(
            f"{path.stem} is a robot that comes with upright", expected="another name", hint=f"my-{path.stem}"
        )
    kit_path = path.with_name(f"{path.stem}-kit.toml")
    for target in (path, kit_path):
        if target.exists():
            raise UprightError(f"{target} exists already", hint="another name, or move the file away")
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


def _plain(answer: str) -> str:
    return answer.removesuffix(A_GUESS)


def _answer(name: str, question: OwnerQuestion, given: str | None, *, lacks: bool) -> str:
    """What an option or the terminal says; the usual answer, marked as a guess, where neither does; none where the
    robot lacks what the question is about."""
    guess = question.usual + A_GUESS
    if lacks:
        if given not in (None, NONE):
            raise UprightError(f"{flag(name)} without {question.needs}", hint=f"{flag(question.needs)} as well")
        return NONE
    if given is not None:
        question.check(given)
        return " ".join(given.split())
    if not sys.stdin.isatty():
        return guess
    try:
        return answered(Question(name, question.asked, guess, question.check))
    except EndOfAnswers:
        raise UprightError("no more answers", hint="options, such as --gear 30") from None


def _entry(number: str, row: FileNumber, answers: Mapping[str, str], drive: str) -> str:
    """The number as its file has it, under the questions that it is from; nothing where the robot lacks the part."""
    from upright.robots import PARAMETERS, toml
    from upright.robots.drives import COMMAND_UNITS
    from upright.robots.kit import quantity_of

    asked = questions(drive)
    used = Answers(answers, asked)
    value = row.formula(used) if callable(row.formula) else row.formula
    if NONE in map(_plain, (*used.read.values(), answers.get(row.needs, ""))):
        return ""
    comments = [f"{asked[key].asked}: {answer}" for key, answer in used.read.items()] or [f"A guess: {row.why}"]
    if isinstance(value, str):
        table, _, key = number.rpartition(".")
        return f"\n# {comments[0]}" + toml.rows(f"[{table}]", {key: value}) if value else ""
    if number in PARAMETERS:
        unit = PARAMETERS[number][0]
    else:
        units, meaning = quantity_of(number)
        unit = COMMAND_UNITS[drive] if COMMAND_UNITS[drive] in units else units[0]
        comments.insert(0, f"{number}: {meaning}")
    guessed = not used.read or any(answer.endswith(A_GUESS) for answer in used.read.values())
    source = ": ".join(filter(None, ("a guess" if guessed else "as its owner says", row.why)))
    spread = None if guessed else float(f"{row.error * abs(value):.2g}")
    entry = toml.number_text(number, float(f"{value:.6g}"), unit, toml.Provenance(source, spread))
    return "".join(f"\n# {comment}" for comment in comments) + entry
