"""The help of `upright`: commands by what one does with them, each with two examples."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator, Mapping
from importlib import import_module
from itertools import pairwise
from typing import Any

import typer
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from upright.cli.command import parameters, spoken
from upright.cli.typed import GIVEN
from upright.errors import UprightError
from upright.messages import in_language

GROUPS = {
    "Begin": {
        "start": ("upright start", "upright start study --robot ev3way"),
        "lab": ("upright lab", "upright lab --class", "upright lab --export site --robots herrera2015,mine.toml"),
        "simulate": ("upright simulate --push hold:0.1,until=1", "upright simulate -r ev3way -b twin -o run.parquet"),
        "compare": ("upright compare run.csv twin.parquet", "upright compare a=run1.csv b=run2.csv --report page.html"),
        "doctor": ("upright doctor run.csv", "upright doctor run.csv --robot ev3way --fix repaired.csv"),
        "calibrate": (
            "upright calibrate run.csv --robot ev3way",
            "upright calibrate run1.csv run2.csv --robot my.toml -o mine.toml",
        ),
        "design": ("upright design lqg -o controller.json", "upright design hinf -r ev3way --report margins.html"),
        "certify": ("upright certify lqg", "upright certify controller.json --log run.csv --report page.html"),
        "post-mortem": (
            "upright post-mortem fall.csv --robot ev3way",
            "upright post-mortem fall.csv --report why.html",
        ),
        "firmware": (
            "upright firmware lqg --target nxc -o balance.nxc",
            "upright firmware controller.json -t pybricks -o balance.py",
        ),
        "fly": ("upright fly balance.nxc controller.json", "upright fly balance.py controller.json -o flight.parquet"),
        "reproduce": ("upright reproduce", "upright reproduce --log run.csv --robot mine.toml -o study"),
    },
    "Robots and logs": {
        "robots": ("upright robots show ev3way", "upright robots new mine --gear 30 --encoder none"),
        "example": ("upright example", "upright example excited -o run.csv"),
        "film": ("upright film run.parquet", "upright film robot=run.csv model=model.parquet -o run.mp4 --speed 0.5"),
    },
    "Learn": {
        "linearise": ("upright linearise", "upright linearise -r ev3way --period 0.01"),
        "excite": ("upright excite -o plan.json", "upright excite -r my-robot.toml --seconds 30 --report plan.html"),
        "identify": (
            "upright identify run.csv --robot ev3way",
            "upright identify run.csv --method all --report id.html",
        ),
        "validate": (
            "upright validate mine.toml run2.csv",
            "upright validate mine.toml run2.csv --report prediction.html",
        ),
    },
    "Many robots": {
        "fleet": (
            "upright fleet -n 1000 --vary com_height=±10%",
            "upright fleet -c lqg -p impulse:0.1 --report f.html",
        ),
        "push-map": ("upright push-map", "upright push-map -c pid --report map.html"),
        "basin": ("upright basin", "upright basin -c lqg --report basin.html"),
        "sweep": ("upright sweep campaign.toml -o results", "upright sweep campaign.toml -o results --workers 2"),
        "tune": ("upright tune lqg -o tuned.json", "upright tune lqr -r herrera2015 --report tune.html"),
        "bench-controllers": ("upright bench-controllers", "upright bench-controllers -r ev3way --json"),
    },
    "Programs": {
        "parity": ("upright parity balance.nxc controller.json", "upright parity balance.py controller.json --json"),
        "monitor": ("upright monitor", "upright monitor -o run.csv"),
    },
    "Classes": {
        "grade": ("upright grade handed-in -o grades.csv", "upright grade --worksheet es -o worksheet.md"),
    },
}
"""Heading → command → calls that show what it is for. The first dozen is what most people need."""

EXAMPLES = {name: examples for commands in GROUPS.values() for name, examples in commands.items()}


def epilog(name: str) -> str:
    """What stands below the options of a command: its examples, one line each."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in EXAMPLES[name])


def _part(name: str) -> Any:
    """The function of a command, or the `typer.Typer` of several; each stands in the module of its name."""
    function = name.replace("-", "_")
    return getattr(import_module(f"upright.cli.{'guide' if name == 'start' else function}"), function)


def parameters_of(verb: str) -> Mapping[str, bool]:
    """The names of what a command takes, as Python writes them, and whether each is an argument, not an option."""
    part = _part(verb.replace("_", "-"))
    known = () if isinstance(part, typer.Typer) else parameters(part)
    return {one.name: one.kind is not one.KEYWORD_ONLY for one in known}


class _Remembered(TyperCommand):
    """A command that leaves behind which of its options were typed, and takes none of them for a value."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        every: list[Any] = self.get_params(ctx)
        options = {flag: option for option in every for flag in option.opts if flag.startswith("-")}
        for word, following in pairwise(args):
            if word in options and following in options and not options[word].is_flag:
                raise UprightError(f"Option '{word}' requires an argument")
        return super().parse_args(ctx, args)

    def invoke(self, ctx: Any) -> Any:
        named = {name for name in ctx.params if ctx.get_parameter_source(name).name == "COMMANDLINE"}
        GIVEN.set({name: ctx.params[name] for name in named})
        return super().invoke(ctx)


def _command(name: str) -> Any:
    whole = part = _part(name)
    if not isinstance(part, typer.Typer):
        whole = typer.Typer(add_completion=False, rich_markup_mode=None)
        whole.command(name, cls=_Remembered)(spoken(part))
    made = get_command(whole)
    made.name, made.epilog = name, epilog(name)
    return made


class Commands(Mapping[str, Any]):
    """All commands by name, each made when it is first asked for: to make one takes longer than to import it."""

    def __init__(self) -> None:
        self._made = dict[str, Any]()

    def __getitem__(self, name: str) -> Any:
        if name not in EXAMPLES:
            raise KeyError(name)
        if name not in self._made:
            self._made[name] = _command(name)
        return self._made[name]

    def __iter__(self) -> Iterator[str]:
        return iter(EXAMPLES)

    def __len__(self) -> int:
        return len(EXAMPLES)


def summary(name: str) -> str:
    """The first sentence of a command's help."""
    part = _part(name)
    if isinstance(part, typer.Typer):
        return str(_command(name).get_short_help_str(limit=200))
    first = " ".join((inspect.getdoc(part) or "").partition("\n\n")[0].split())
    return first.partition(". ")[0] + "." * (". " in first)


_Formatter: Any = typer.Context.formatter_class


class SpokenHelp(_Formatter):
    """Help in the chosen language, which is found sentence by sentence."""

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        super().write_usage(prog, " ".join(map(in_language, args.split(" "))), in_language(prefix or "Usage:") + " ")

    def write_heading(self, heading: str) -> None:
        super().write_heading(in_language(heading))

    def write_text(self, text: str) -> None:
        super().write_text("\n\n".join(map(_paragraph, text.split("\n\n"))))

    def write_dl(self, rows: Any, col_max: int = 30, col_spacing: int = 2) -> None:
        super().write_dl([(_kind(name), _described(text)) for name, text in rows], col_max, col_spacing)


def _kind(name: str) -> str:
    """An option or an argument, with the kind of its values behind it."""
    return re.sub("<.+>", lambda kind: in_language(kind[0]), name)


def _described(text: str) -> str:
    """What an option is, and what is written behind it in brackets: its default, its range."""
    about, bracket, notes = text.partition("  [")
    return _sentences(about) + bracket + "; ".join(map(in_language, notes.split("; ")))


def _paragraph(text: str) -> str:
    return in_language(text) if text.startswith("\b") else _sentences(" ".join(text.split()))


def _sentences(text: str) -> str:
    return " ".join(map(in_language, re.split(r"(?<=\.) (?=[A-Z])", text)))


class Grouped(TyperGroup):
    """A group whose help lists its commands under the headings of `GROUPS`, with full lines."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        del ctx
        for heading, names in GROUPS.items():
            rows = [(name, summary(name)) for name in names]
            with formatter.section(heading):
                formatter.write_dl(rows, col_max=20)
