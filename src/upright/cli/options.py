"""Options that several commands share, and the notation `KIND:NUMBER,name=NUMBER` of pushes and references."""

from __future__ import annotations

import dataclasses
import glob
import inspect
import math
from collections.abc import Callable, Iterable, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.errors import InvalidScenario, UnknownName, UprightError
from upright.pages.result import PICTURES

if TYPE_CHECKING:
    from upright.signals import Log

Names = Callable[[], Iterable[str]]

MOST_ROBOTS = 10_000_000


def completed(names: Names, suffix: str = "") -> Callable[[str], list[str]]:
    """Completion in the shell: registered names, and files of that suffix."""

    def complete(incomplete: str) -> list[str]:
        files = glob.glob(f"{glob.escape(incomplete)}*{suffix}") if suffix else []
        return [name for name in (*names(), *files) if name.startswith(incomplete)]

    return complete


def registered(module: str, name: str) -> Names:
    """The names in the registry `name` of a module, or by its function of that name; it is imported when they are asked
    for."""

    def names() -> Iterable[str]:
        entries: Any = getattr(import_module(module), name)
        return entries() if inspect.isfunction(entries) else entries

    return names


controllers = registered("upright.control", "CONTROLLERS")


def _tunable() -> Iterable[str]:
    from upright.control import CONTROLLERS

    return [name for name, method in CONTROLLERS.items() if method.tunable]


complete_parameter = completed(registered("upright.robots", "PARAMETERS"))
complete_model = completed(registered("upright.physics.dynamics", "MODELS"))
complete_robot = completed(registered("upright.robots", "preset_names"), ".toml")
complete_kit = completed(registered("upright.robots", "kit_names"), ".toml")
complete_mapping = completed(registered("upright.logs.mapping", "mappings"), ".toml")
complete_controller = completed(controllers, ".json")
complete_body = completed(registered("upright.bodies", "BODIES"))
complete_method = completed(controllers)
complete_tunable = completed(_tunable)

ROBOT_HELP = "Robot by name (see `upright robots`) or TOML file"
KIT_HELP = "Electronics by name or TOML file"
CONTROLLER_HELP = "Controller by name, controller.json or my.py:Name"

RobotOption = Annotated[str, typer.Option("--robot", "-r", help=f"{ROBOT_HELP}.", autocompletion=complete_robot)]
LogRobotOption = Annotated[
    str | None,
    typer.Option("--robot", "-r", help=f"{ROBOT_HELP} (default: the log's).", autocompletion=complete_robot),
]
KitOption = Annotated[
    str | None, typer.Option("--kit", help=f"{KIT_HELP} (default: the robot's).", autocompletion=complete_kit)
]
ProgramRobotOption = Annotated[
    str | None,
    typer.Option("--robot", "-r", help="Robot by name or TOML file (default: the program's).",
                 autocompletion=complete_robot),
]  # fmt: skip
ProgramKitOption = Annotated[
    str | None,
    typer.Option(help="Kit by name or TOML file (default: the program's).", autocompletion=complete_kit),
]
IdealKitOption = Annotated[
    str | None,
    typer.Option("--kit", help=f"{KIT_HELP}; ideal for none (default: the robot's).", autocompletion=complete_kit),
]
ControllerArgument = Annotated[str, typer.Argument(help=f"{CONTROLLER_HELP}.", autocompletion=complete_controller)]
LogArgument = Annotated[Path, typer.Argument(help="Log: .csv, .txt, .json, .mat, .parquet or .mcap.")]
MappingOption = Annotated[
    str | None,
    typer.Option(help="Mapping of columns by name or TOML file (default: the one that fits).",
                 autocompletion=complete_mapping),
]  # fmt: skip
PosteriorOption = Annotated[
    Path | None,
    typer.Option("--posterior", help="Posterior by `upright calibrate --save` (default: the robot's spreads)."),
]
CertificateOption = Annotated[
    Path | None, typer.Option(help="Certificate by `upright certify`; refused if red or of another controller.")
]
AnywayOption = Annotated[bool, typer.Option("--anyway", help="Go on although the certificate refuses it.")]
KernelOption = Annotated[
    str,
    typer.Option("--controller", "-c", help=f"{CONTROLLER_HELP}; what is not compiled takes long.",
                 autocompletion=complete_controller),
]  # fmt: skip
LawOption = Annotated[
    str | None,
    typer.Option("--controller", "-c", help=f"{CONTROLLER_HELP}, of the log (default: read from it).",
                 autocompletion=complete_controller),
]  # fmt: skip
DesignArgument = Annotated[str, typer.Argument(help="The controller.json of its design.")]
PeriodOption = Annotated[float | None, typer.Option(help="Period of the controller [s] (default: the kit's).")]
AfterOption = Annotated[float | None, typer.Option("--start", help="Ignore the log before this time [s].")]
BeforeOption = Annotated[float | None, typer.Option("--until", help="Ignore the log from this time on [s].")]
KnownOption = Annotated[
    list[str] | None,
    typer.Option(metavar="NAME", help="Parameter taken as exact, such as body_mass; repeatable.",
                 autocompletion=complete_parameter),
]  # fmt: skip
HeldOutOption = Annotated[float, typer.Option(help="Last fraction of each log, kept for validation.")]
SamplesOption = Annotated[int, typer.Option("--samples", "-n", min=1, max=MOST_ROBOTS, help="Number of robots drawn.")]
SeedOption = Annotated[int, typer.Option("--seed", min=0, max=2**63 - 1, help="Seed of all random draws and noise.")]
BodyOption = Annotated[
    str, typer.Option("--body", "-b", help="Body by name or my.py:Name, such as nonlinear or twin (MuJoCo).",
                      autocompletion=complete_body),
]  # fmt: skip
DriveOption = Annotated[
    str | None, typer.Option("--drive", metavar="M/S[,start=S,until=S]", help="Drive at this speed.")
]
TurnOption = Annotated[
    str | None, typer.Option("--turn", metavar="RAD/S[,start=S,until=S]", help="Turn at this rate, anticlockwise.")
]
StartOption = Annotated[str, typer.Option("--start", help="Initial state, such as pitch=0.05; the others are zero.")]
LogOutputOption = Annotated[Path | None, typer.Option("--output", "-o", help="Write the log: .parquet, .csv or .mcap.")]
ControllerOutputOption = Annotated[Path | None, typer.Option("--output", "-o", help="Write the controller as JSON.")]
ModelOutputOption = Annotated[Path | None, typer.Option("--output", "-o", help="Write the model as JSON.")]
OutputOption = Annotated[Path | None, typer.Option("--output", "-o", help="Write the result as JSON.")]


def _page(path: Path | None) -> Path | None:
    if path and path.suffix not in (".html", *PICTURES):
        expected = f"a page, .html, or its picture, {' '.join(PICTURES)}"
        raise UprightError(f"--report {path}", expected=expected, hint=f"--report {path.stem}.html")
    return path


ReportOption = Annotated[
    Path | None,
    typer.Option("--report", callback=_page, help="Write a page, .html, or its first picture, .svg .pdf .png."),
]
JsonOption = Annotated[bool, typer.Option("--json", help="Print JSON.")]

PUSH_HELP = (
    "Push, repeatable; pushes add up. hold:RAD,until=S holds a pitch and releases it; force:N,start=S,duration=S; "
    "impulse:NS,start=S. Each takes height=M above the axle (default: the centre of mass)."
)
PushOption = Annotated[list[str] | None, typer.Option("--push", "-p", metavar="KIND:NUMBER,...", help=PUSH_HELP)]


def part_of_log(path: Path, mapping: str | None, start: float | None, until: float | None) -> Log:
    """The raw log of a file between two of its times [s]; None: from its begin, or to its end."""
    from upright.logs.raw import raw_log

    ends = (-math.inf if start is None else start, math.inf if until is None else until)
    return raw_log(path, mapping).between(*ends)


def number(text: str, where: str) -> float:
    """A finite number, or `InvalidScenario` naming the option."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InvalidScenario(f"{where}: '{text.strip()}'", expected="a finite number")
    return value


def named_numbers(text: str, names: Sequence[str], option: str, bare: str = "") -> dict[str, float]:
    """`name=NUMBER,name=NUMBER` as a dictionary; a first number without a name belongs to `bare`."""
    values: dict[str, float] = {}
    for index, part in enumerate(text.split(",")):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals and bare and index == 0:
            name, value = bare, name
        elif not equals:
            raise InvalidScenario(f"{option}: '{part}'", expected=f"name=NUMBER, with a name of {', '.join(names)}")
        if name not in names:
            raise UnknownName(f"entry of {option}", name, names)
        if name in values:
            raise InvalidScenario(f"{option}: {name} is given twice", expected="each name once")
        values[name] = number(value, f"{option} {name}")
    return values


def named_values(text: str, option: str) -> dict[str, float | str]:
    """`name=VALUE,name=VALUE` as a dictionary, numbers as such and other words as text."""
    values: dict[str, float | str] = {}
    for part in text.split(","):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not (equals and name and value):
            raise InvalidScenario(f"{option}: '{part}'", expected="name=VALUE")
        if name in values:
            raise InvalidScenario(f"{option}: {name} is given twice", expected="each name once")
        try:
            values[name] = float(value)
        except ValueError:
            values[name] = value
    return values


def vector(text: str, names: Sequence[str], option: str) -> list[float]:
    """`name=NUMBER,…` as one number for each of `names`; the others are zero."""
    given = named_numbers(text, names, option) if text else {}
    return [given.get(name, 0.0) for name in names]


def programme(kind: Any, text: str, option: str) -> Any:
    """A push or reference from `NUMBER,name=NUMBER,…`, whose names are the fields of the dataclass `kind`."""
    fields = dataclasses.fields(kind)
    values = named_numbers(text, [f.name for f in fields], option, bare=fields[0].name)
    absent = [f.name for f in fields if f.default is dataclasses.MISSING and f.name not in values]
    if absent:
        raise InvalidScenario(f"{option}: '{text}' lacks {', '.join(absent)}", expected=f"{absent[0]}=NUMBER as well")
    return kind(**values)


def pushes_and_references(
    pushed: Sequence[str] | None, drive: str | None, turn: str | None, slope: str | None = None
) -> tuple[list[Any], list[Any]]:
    """The pushes and references of a command's options."""
    from upright.experiment import Drive, Slope, Turn

    pushes = [push(text) for text in pushed or ()] + ([programme(Slope, slope, "--slope")] if slope else [])
    asked = ((Drive, drive, "--drive"), (Turn, turn, "--turn"))
    return pushes, [programme(kind, text, option) for kind, text, option in asked if text]


def push(text: str) -> Any:
    """A push from `KIND:NUMBER,name=NUMBER,…`, where KIND is hold, force or impulse."""
    from upright.experiment import Hold, Impulse, Push

    kinds = {"hold": Hold, "force": Push, "impulse": Impulse}
    kind, colon, rest = text.partition(":")
    if not colon:
        raise InvalidScenario(
            f"--push '{text}'", expected="KIND:NUMBER,name=NUMBER", hint="for example hold:0.1,until=1"
        )
    if kind.strip() not in kinds:
        raise UnknownName("push", kind.strip(), kinds)
    return programme(kinds[kind.strip()], rest, f"--push {kind.strip()}")
