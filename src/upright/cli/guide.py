"""`upright start`: from nothing to a verdict, one question at a time, by the commands that it prints."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import typer

from upright.atomic import make_folder, write_json
from upright.cli.options import MOST_ROBOTS, complete_robot
from upright.cli.output import AGAINST
from upright.errors import UnknownName, UprightError
from upright.reading import expanded, read_json, understood

STATE = "upright-start.json"
"""Where the answers and the steps that are done are kept, in the folder of the study."""

KIND, VERSION = "upright start", 1
FEWEST = 100  # robots of a certificate
PATIENCE = 5  # answers to one question that cannot be taken, before it is given up
WHERE = ("simulated", "log", "here")
BRICKS = {"nxt": ("nxc", "balance.nxc"), "spike": ("pybricks", "balance.py"), "ev3": ("ev3dev", "balance.py")}
PUSH = ("--push", "hold:0.1,until=4", "--seconds", "8")


@dataclass(frozen=True)
class Question:
    """What is asked under `name`; `check` raises an `UprightError` for an answer that cannot be."""

    name: str
    text: str
    usual: str
    check: Callable[[str], None] = lambda answer: None  # noqa: ARG005


@dataclass(frozen=True)
class GuidedStep:
    """A command and why it is run; `of` names the answers to ask again where it fails."""

    why: str
    command: tuple[str, ...]
    of: tuple[str, ...] = ()


@dataclass
class GuidedStudy:
    """The answers and the commands that are done, in a folder."""

    folder: Path
    answers: dict[str, str] = field(default_factory=dict[str, str])
    done: list[list[str]] = field(default_factory=list[list[str]])

    @classmethod
    def of(cls, folder: Path) -> GuidedStudy:
        """The study of a folder, empty where none was begun."""
        path = folder / STATE
        if not path.exists():
            return cls(folder)
        expected = f"a file that `upright start` wrote; delete {path} to begin anew"
        data = read_json(path, UprightError, expected)
        with understood(str(path), UprightError, expected):
            if (data["kind"], data["version"]) != (KIND, VERSION):
                raise ValueError("another version")
            answers = {str(name): str(text) for name, text in data["answers"].items()}
            done = [[str(word) for word in line] for line in data["done"]]
        return cls(folder, answers, done)

    def save(self) -> None:
        """Keep it at once: an interruption loses nothing."""
        data = {"kind": KIND, "version": VERSION, "answers": self.answers, "done": self.done}
        write_json(self.folder / STATE, data, at_once=True)


class EndOfAnswers(Exception):
    """There are no more answers."""


def start(
    folder: Annotated[Path, typer.Argument(help="Folder of the study, made if there is none.")] = Path(),
    *,
    robot: Annotated[
        str | None, typer.Option("--robot", "-r", help="Answer to the first question.", autocompletion=complete_robot)
    ] = None,
    samples: Annotated[
        int, typer.Option("--samples", "-n", min=FEWEST, max=MOST_ROBOTS, help="Robots that the certificate draws.")
    ] = 1000,
    again: Annotated[bool, typer.Option("--again", help="Forget all answers and begin anew.")] = False,
) -> None:
    """Go from nothing to a verdict, one question at a time.

    Prints every command that it runs. Enter takes the answer in brackets. Stop at any question or step: the next call
    goes on there. Answers may come from a file or a pipe.
    """
    make_folder(folder)
    study = GuidedStudy.of(folder)
    if again:
        study.answers, study.done = {}, []
    if robot is not None:
        _check_robot(robot)
        study.answers["robot"] = robot
    try:
        for part in _parts(study, samples):
            if isinstance(part, Question):
                _ask(part, study)
            else:
                _run(part, study)
    except EndOfAnswers:
        again_with = shlex.join(["upright", "start", *([str(folder)] if folder != Path() else [])])
        typer.echo(f"\nno more answers; `{again_with}` goes on from here")
        return
    _conclude(study)


def _parts(study: GuidedStudy, samples: int) -> Iterator[Question | GuidedStep]:
    """What to ask and to run in turn; what comes later depends on what was answered."""
    answers = study.answers
    yield ROBOT
    yield PLACE
    robot = answers["robot"]
    if answers["where"] == "log":
        yield from _from_log(answers)
        robot = "mine.toml"
    yield METHOD
    chosen = ("--robot", robot)
    design = ("design", answers["method"], *chosen, "-o", "controller.json")
    yield GuidedStep("The controller is designed for this robot.", design, ("method",))
    if answers["where"] == "simulated":
        yield BODY
        run = ("simulate", *chosen, "--controller", "controller.json", "--body", answers["body"], *PUSH)
        yield GuidedStep(
            "It is pushed for four seconds, and let go.", (*run, "-o", "run.csv", "--report", "run.html"),
            ("body", "method"),
        )  # fmt: skip
    certify = ("certify", "controller.json", *chosen, "--samples", str(samples), "-o", "certificate.json")
    why = "Many robots, as uncertain as this one, are pushed: may the controller drive?"
    yield GuidedStep(why, (*certify, "--report", "certificate.html"), ("method",))
    if answers["where"] == "here" and _light(study) not in ("red", "unknown"):
        yield from _onto_a_brick(answers, chosen)


def _from_log(answers: dict[str, str]) -> Iterator[Question | GuidedStep]:
    yield LOG
    log = answers["log"]
    if log == "example":
        log = "example.csv"
        yield GuidedStep("A log of a twin, as a robot would write it.", ("example", "excited", "-o", log))
    chosen = ("--robot", answers["robot"])
    yield GuidedStep("First: is anything wrong with the log?", ("doctor", log, *chosen), ("log",))
    calibrate = ("calibrate", log, *chosen, "-o", "mine.toml", "--report", "calibration.html")
    yield GuidedStep("The robot's parameters are estimated from it.", calibrate, ("log", "robot"))
    yield SECOND
    if answers["second"] != "none":
        validate = ("validate", "mine.toml", answers["second"], "--report", "validation.html")
        why = "What is known of the robot has to predict a log that it was not learnt from."
        yield GuidedStep(why, validate, ("second",))


def _onto_a_brick(answers: dict[str, str], chosen: tuple[str, str]) -> Iterator[Question | GuidedStep]:
    yield BRICK
    target, program = BRICKS[answers["brick"]]
    firmware = ("firmware", "controller.json", *chosen, "--target", target, "--certificate", "certificate.json")
    yield GuidedStep("The controller becomes a program.", (*firmware, "-o", program), ("brick",))
    why = "The program is executed on a virtual brick, and compared with its design."
    yield GuidedStep(why, ("parity", program, "controller.json"), ("brick",))


def _ask(question: Question, study: GuidedStudy) -> None:
    """The answer, from an earlier call or from stdin."""
    if question.name in study.answers:
        typer.echo(f"{question.text}: {study.answers[question.name]} (answered before)")
        return
    study.answers[question.name] = _from_folder(answered(question), study.folder)
    study.save()


def answered(question: Question) -> str:
    """What stdin answers, for an empty line the usual answer; raises `UprightError` after too many that cannot be."""
    for _ in range(PATIENCE):
        typer.echo(f"{question.text} [{question.usual}]: ", nl=False)
        sys.stdout.flush()
        line = sys.stdin.readline(1000)
        if not line:
            raise EndOfAnswers
        answer = line.strip() or question.usual
        if not sys.stdin.isatty():
            typer.echo(answer)
        try:
            question.check(answer)
        except UprightError as error:
            typer.echo(f"  {error}")
            continue
        return answer
    raise UprightError(f"no answer to '{question.name}' after {PATIENCE} attempts", hint="the same command, once more")


def _from_folder(answer: str, folder: Path) -> str:
    """A file's name as the commands need it, which run in the folder of the study."""
    path = expanded(answer, UprightError)
    inside = folder.resolve() == Path.cwd() or not path.is_file()
    return answer if inside else os.path.relpath(path.resolve(), folder.resolve())


def _run(step: GuidedStep, study: GuidedStudy) -> None:
    """Run the command in the folder, unless it is done."""
    line = shlex.join(("upright", *step.command))
    if list(step.command) in study.done and _complete(step, study.folder):
        typer.echo(f"\n{step.why}\n$ {line}   (done before)")
        return
    typer.echo(f"\n{step.why}\n$ {line}")
    sys.stdout.flush()
    code = _executed(step.command, study.folder)
    if code != 0 and not (code == AGAINST and step.command[0] == "certify"):  # whose verdict ends the study
        for name in step.of:
            study.answers.pop(name, None)
        study.save()
        asks = f"asks again for {' and '.join(step.of)}" if step.of else "tries it again"
        why = "has a verdict against, or unknown: see above" if code == AGAINST else f"ended with exit code {code}"
        raise UprightError(f"`{line}` {why}", hint=f"upright start, which {asks}")
    study.done.append(list(step.command))
    study.save()


def _executed(command: Sequence[str], folder: Path) -> int:
    """The exit code of a command of ours, in a process of its own, which ends with this one."""
    process = subprocess.Popen([sys.executable, "-m", "upright", *command], cwd=folder, stdin=subprocess.DEVNULL)
    try:
        code = process.wait()
    except BaseException:
        process.terminate()
        process.wait()
        raise
    if code < 0 or code > 128:
        raise KeyboardInterrupt
    return code


def _complete(step: GuidedStep, folder: Path) -> bool:
    """Whether the files that the step wrote are still there."""
    files = [name for flag, name in zip(step.command, step.command[1:], strict=False) if flag in ("-o", "--report")]
    return all((folder / name).exists() for name in files)


def _light(study: GuidedStudy) -> str:
    data: Any = read_json(study.folder / "certificate.json", UprightError, "the certificate of this study")
    return str(data.get("light", "")) if isinstance(data, dict) else ""


def _conclude(study: GuidedStudy) -> None:
    light = _light(study)
    where = study.answers["where"]
    words = {
        "green": "green: the controller may drive this robot", "amber": "amber: it may drive, with care",
        "red": "red: it must not drive", "unknown": "unknown: measure what the certificate names",
    }  # fmt: skip
    typer.echo(f"\nVerdict: {words.get(light, light)}. The pages (.html) in {study.folder.resolve()} show why.")
    if light == "red":
        typer.echo("Next: another controller (upright start --again), or upright tune, which searches for weights.")
    elif light == "unknown":
        typer.echo("Next: measure that, write it into the robot's file with its spread, and: upright start --again")
    elif where == "here":
        program = BRICKS[study.answers["brick"]][1]
        typer.echo(f"Next: connect the brick, hold the robot upright, and: upright fly {program} controller.json")
    elif where == "log":
        typer.echo(
            "Next: upright firmware controller.json --robot mine.toml --certificate certificate.json --target nxc"
        )
    else:
        typer.echo("Next: upright lab, to push it with the mouse; or a log of your own robot: upright start --again")


def _check_robot(answer: str) -> None:
    from upright.robots import find_robot

    find_robot(answer)


def _check_method(answer: str) -> None:
    from upright.cli.options import controllers

    if answer not in (known := list(controllers())):
        raise UnknownName("controller", answer, known)


def _one_of(what: str, choices: Sequence[str]) -> Callable[[str], None]:
    def check(answer: str) -> None:
        if answer not in choices:
            raise UnknownName(what, answer, choices)

    return check


def _log_or(word: str) -> Callable[[str], None]:
    def check(answer: str) -> None:
        if answer != word and not expanded(answer, UprightError).is_file():
            raise UprightError(f"there is no file {answer[:100]}", expected=f"a log, or `{word}`")

    return check


ROBOT = Question("robot", "Which robot? A name (`upright robots` lists them) or a TOML file", "nxtway-gs", _check_robot)
PLACE = Question(
    "where", "Is it simulated, do you have a log of it, or is it here? (simulated, log, here)", "simulated",
    _one_of("answer", WHERE),
)  # fmt: skip
METHOD = Question("method", "Which controller? lqg, lqr, lqi, pid, hinf, mpc, sliding, robust", "lqg", _check_method)
BODY = Question(
    "body", "Which simulation? twin (MuJoCo, stands in for hardware) or nonlinear (the equations)", "twin",
    _one_of("body", ("twin", "nonlinear")),
)  # fmt: skip
LOG = Question(
    "log", "Where is its log? A file, or `example` for one of nxtway-gs to try", "example", _log_or("example")
)
SECOND = Question(
    "second", "Another log of the same robot, to judge what was learnt? A file, or `none`", "none", _log_or("none")
)
BRICK = Question("brick", "Which brick? nxt, ev3 (ev3dev) or spike (Pybricks)", "nxt", _one_of("brick", tuple(BRICKS)))
