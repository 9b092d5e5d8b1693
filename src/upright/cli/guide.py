"""`upright start`: from nothing to a verdict, one question at a time, by the commands that it prints."""

from __future__ import annotations

import contextlib
import os
import shlex
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any

import typer

from upright.atomic import make_folder, write_json
from upright.cli.output import AGAINST, goes_on_from, tell
from upright.cli.vocabulary import MOST_ROBOTS, controllers
from upright.errors import UnknownName, UprightError, check_within
from upright.languages import translated
from upright.messages import in_language
from upright.reading import expanded, read_json, understood

STATE = "upright-start.json"
"""Where the answers and the steps that are done are kept, in the folder of the study."""

FEWEST = 100  # robots of a certificate
PATIENCE = 5  # answers to one question that cannot be taken, before it is given up
JUDGES = ("certify", "calibrate")
"""Commands whose verdict against does not end the study: the first is its end, after the second it goes on without."""
BRICKS = {"nxt": ("nxc", "balance.nxc"), "spike": ("pybricks", "balance.py"), "ev3": ("ev3dev", "balance.py")}
PUSH = "--push hold:0.1,until=4 --seconds 8"


@dataclass(frozen=True)
class Question:
    """What is asked under `name`; `check` raises an `UprightError` for an answer that cannot be."""

    name: str
    text: str
    usual: str
    check: Callable[[str], None] = lambda answer: None  # noqa: ARG005


@dataclass(frozen=True)
class GuidedStep:
    """A command, as typed after `upright`, and why it is run; `of` names the answers to ask again where it fails."""

    why: str
    line: str
    of: tuple[str, ...] = ()


@dataclass
class GuidedStudy:
    """The answers and the commands that are done, in a folder."""

    folder: Path
    answers: dict[str, str] = field(default_factory=dict[str, str])
    done: list[str] = field(default_factory=list[str])

    @classmethod
    def of(cls, folder: Path) -> GuidedStudy:
        """The study of a folder, empty where none was begun."""
        path = folder / STATE
        if not path.exists():
            return cls(folder)
        expected = f"a file that `upright start` wrote; delete {path} to begin anew"
        data = read_json(path, UprightError, expected)
        with understood(str(path), UprightError, expected):
            return cls(folder, dict(data["answers"]), list(data["done"]))

    def save(self) -> None:
        """Keep it at once: an interruption loses nothing."""
        write_json(self.folder / STATE, {"answers": self.answers, "done": self.done}, at_once=True)

    def given(self, name: str) -> str:
        """An answer as a word of a command."""
        return shlex.quote(self.answers[name])

    def named(self, file: str) -> str:
        """A file's name as the commands need it, which run in the folder; other answers as they are."""
        path = expanded(file, UprightError)
        if not path.is_file():
            return file
        whole = str(path.resolve())
        return min(os.path.relpath(whole, self.folder.resolve()), whole, key=len)

    @property
    def again(self) -> str:
        """What goes on from here."""
        return shlex.join(["upright", "start", *([str(self.folder)] if self.folder != Path() else [])])


class EndOfAnswers(Exception):
    """There are no more answers."""


def start(
    folder: Path = Path(),
    *,
    robot: str | None = None,
    samples: Annotated[int, "Robots drawn for the certificate."] = 1000,
    again: bool = False,
) -> None:
    """Go from nothing to a verdict, one question at a time.

    Prints every command that it runs. Enter takes the answer in brackets. Stop at any question or step: the next call
    goes on there. Answers may come from a file or a pipe.
    """
    check_within("robots of a certificate", samples, FEWEST, MOST_ROBOTS)
    make_folder(folder)
    study = GuidedStudy(folder) if again else GuidedStudy.of(folder)
    if robot is not None:
        _check_robot(robot)
        study.answers["robot"] = study.named(robot)
    if folder != Path():
        tell(f"$ cd {shlex.quote(str(folder))}")
    try:
        with goes_on_from(folder / STATE, f"the answers are kept: `{study.again}` goes on from here"):
            for part in _parts(study, samples):
                if isinstance(part, Question):
                    _ask(part, study)
                else:
                    _run(part, study)
    except EndOfAnswers:
        tell(f"\nno more answers; `{study.again}` goes on from here")
        return
    _conclude(study)


def _parts(study: GuidedStudy, samples: int) -> Iterator[Question | GuidedStep]:
    """What to ask and to run in turn; what comes later depends on what was answered."""
    given = study.given
    yield ROBOT
    yield PLACE
    robot = given("robot")
    tests = ""
    if given("where") == "log":
        yield from _from_log(study)
        if (study.folder / "mine.toml").exists():
            robot = "mine.toml"
        else:
            tests = f" --log {given('log')}{_mapping(study)}"
            tell("\nThe log does not tell this robot: the numbers of its file go on, and the log tests them.")
        yield SECOND
        if given("second") != "none":
            line = f"validate {robot} {given('second')}{_mapping(study)} --report validation.html"
            why = "What is known of the robot has to predict a log that it was not learnt from."
            yield GuidedStep(why, line, ("second",))
    yield METHOD
    line = f"design {given('method')} --robot {robot} -o controller.json"
    yield GuidedStep("The controller is designed for this robot.", line, ("method",))
    if given("where") == "simulated":
        yield BODY
        line = f"simulate --robot {robot} --controller controller.json --body {given('body')} {PUSH}"
        why = "It is pushed for four seconds, and let go."
        yield GuidedStep(why, f"{line} -o run.csv --report run.html", ("body", "method"))
    line = f"certify controller.json --robot {robot}{tests} --samples {samples}"
    why = "Many robots, as uncertain as this one, are pushed: may the controller drive?"
    yield GuidedStep(why, f"{line} -o certificate.json --report certificate.html", ("method",))
    if given("where") == "here" and _light(study) not in ("red", "unknown"):
        yield BRICK
        target, program = BRICKS[given("brick")]
        line = f"firmware controller.json --robot {robot} --target {target} --certificate certificate.json -o {program}"
        yield GuidedStep("The controller becomes a program.", line, ("brick",))
        why = "The program is executed on a virtual brick, and compared with its design."
        yield GuidedStep(why, f"parity {program} controller.json", ("brick",))


def _from_log(study: GuidedStudy) -> Iterator[Question | GuidedStep]:
    yield LOG
    if study.given("log") == "example":
        yield GuidedStep("A log of a twin, as a robot would write it.", "example excited -o example.csv")
        study.answers |= {"log": "example.csv", "mapping": "none"}
    yield MAPPING
    mapping = _mapping(study)
    log = f"{study.given('log')} --robot {study.given('robot')}"
    line = f"doctor {log}{mapping or ' --write-mapping mapping.toml'}"
    again = ("mapping",) if mapping else ("log", "mapping")
    yield GuidedStep("First: is anything wrong with the log?", line, again)
    line = f"calibrate {log}{mapping} -o mine.toml --report calibration.html"
    yield GuidedStep("The robot's parameters are estimated from it.", line, ("mapping",))


def _mapping(study: GuidedStudy) -> str:
    mapping = study.given("mapping")
    return "" if mapping == "none" else f" --mapping {mapping}"


def _ask(question: Question, study: GuidedStudy) -> None:
    """The answer, from an earlier call or from stdin."""
    if question.name in study.answers:
        tell(f"{question.text}: {study.answers[question.name]} (answered before)")
        return
    study.answers[question.name] = study.named(answered(question))
    study.save()


def answered(question: Question) -> str:
    """What stdin answers, for an empty line the usual answer; raises `UprightError` after too many that cannot be."""
    for _ in range(PATIENCE):
        typer.echo(f"{in_language(question.text)} [{question.usual}]: ", nl=False)
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
            tell(f"  {error}")
            continue
        return answer
    raise UprightError(f"no answer to '{question.name}' after {PATIENCE} attempts", hint="the same command, once more")


def _run(step: GuidedStep, study: GuidedStudy) -> None:
    """Run the command in the folder, unless it is done."""
    done = step.line in study.done and _complete(step, study.folder)
    tell(f"\n{step.why}\n$ upright {step.line}{'   (done before)' * done}")
    if done:
        return
    verb = step.line.split()[0]
    try:
        code = _executed(shlex.split(step.line), study.folder)
    except (UprightError, typer.TyperException) as error:
        raise _failed(step, study, str(error)) from None
    if code != 0 and not (code == AGAINST and verb in JUDGES):
        raise _failed(step, study, f"`upright {verb}` has a verdict against, or unknown: see above")
    study.done.append(step.line)
    study.save()


def _executed(command: Sequence[str], folder: Path) -> int:
    """The exit code of a command of ours, called in the folder."""
    from upright.cli.main import run

    with contextlib.chdir(folder):
        return run(command)


def _failed(step: GuidedStep, study: GuidedStudy, why: str) -> UprightError:
    """The error of a step that failed, whose answers are forgotten."""
    for name in step.of:
        study.answers.pop(name, None)
    study.save()
    complete = f"complete {study.folder / 'mapping.toml'} and answer with it: " if step.of == ("mapping",) else ""
    asks = f"asks again for {' and '.join(step.of)}" if step.of else "tries it again"
    return UprightError(why.replace("; try: ", "; or "), hint=f"{complete}{study.again}, which {asks}")


def _complete(step: GuidedStep, folder: Path) -> bool:
    """Whether the files that the step wrote are still there; a robot is not written where it cannot be told."""
    words = shlex.split(step.line)
    named = pairwise(words)
    files = [name for flag, name in named if flag in ("-o", "--report") and name != "mine.toml"]
    return all((folder / name).exists() for name in files)


def _light(study: GuidedStudy) -> str:
    data: Any = read_json(study.folder / "certificate.json", UprightError, "the certificate of this study")
    return str(data.get("light", "")) if isinstance(data, dict) else ""


def _conclude(study: GuidedStudy) -> None:
    """The verdict once more, where its pages are, and what is next where the certificate has not said it."""
    light = _light(study)
    tell(f"\nVerdict: {translated(light)}. The pages (.html) in {study.folder.resolve()} show why.")
    if study.answers["where"] == "here" and light not in ("red", "unknown"):
        program = BRICKS[study.answers["brick"]][1]
        tell(f"Next: connect the brick, hold the robot upright, and: upright fly {program} controller.json")
    else:
        tell(f"Another answer: {study.again} --again")


def _check_robot(answer: str) -> None:
    from upright.robots import find_robot

    find_robot(answer)


def _check_method(answer: str) -> None:
    if answer not in (known := list(controllers())):
        raise UnknownName("controller", answer, known)


def _one_of(what: str, choices: Sequence[str]) -> Callable[[str], None]:
    def check(answer: str) -> None:
        if answer not in choices:
            raise UnknownName(what, answer, choices)

    return check


def _file_or(word: str) -> Callable[[str], None]:
    def check(answer: str) -> None:
        if answer != word and not expanded(answer, UprightError).is_file():
            raise UprightError(f"there is no file {answer[:100]}", expected=f"a file, or `{word}`")

    return check


ROBOT = Question("robot", "Which robot? A name (`upright robots` lists them) or a TOML file", "nxtway-gs", _check_robot)
PLACE = Question(
    "where",
    "Is it simulated, do you have a log of it, or is it here? (simulated, log, here)",
    "simulated",
    _one_of("answer", ("simulated", "log", "here")),
)
METHOD = Question("method", "Which controller? lqg, lqr, lqi, pid, hinf, mpc, sliding, robust", "lqg", _check_method)
BODY = Question(
    "body",
    "Which simulation? twin (MuJoCo, stands in for hardware) or nonlinear (the equations)",
    "twin",
    _one_of("body", ("twin", "nonlinear")),
)
LOG = Question(
    "log", "Where is its log? A file, or `example` for one of nxtway-gs to try", "example", _file_or("example")
)
MAPPING = Question(
    "mapping", "Its columns: a mapping (TOML), or `none`: the doctor guesses, and drafts one", "none", _file_or("none")
)
SECOND = Question(
    "second", "Another log of the same robot, to judge what was learnt? A file, or `none`", "none", _file_or("none")
)
BRICK = Question("brick", "Which brick? nxt, ev3 (ev3dev) or spike (Pybricks)", "nxt", _one_of("brick", tuple(BRICKS)))
