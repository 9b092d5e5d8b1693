"""A function as a command: its parameters become arguments and options by the words of `vocabulary`.

What stands before the `*` is an argument. A parameter of a dataclass stands for the options that are its fields.
"""

from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Callable
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import typer

from upright.cli.vocabulary import WORDS


def parameters(function: Callable[..., Any]) -> list[inspect.Parameter]:
    """What a command takes, with the fields of a group in place of the group."""
    every: list[inspect.Parameter] = []
    for parameter in inspect.signature(function, eval_str=True).parameters.values():
        kind = parameter.annotation
        if not dataclasses.is_dataclass(kind):
            every.append(parameter)
            continue
        hints = get_type_hints(kind, include_extras=True)
        for one in dataclasses.fields(kind):
            every.append(inspect.Parameter(one.name, parameter.kind, default=one.default, annotation=hints[one.name]))
    return every


def spoken(function: Callable[..., Any]) -> Callable[..., Any]:
    """The command as typer reads it: every parameter with its words; a call puts the groups together again."""
    own = inspect.signature(function, eval_str=True).parameters.values()
    groups: dict[str, Any] = {one.name: one.annotation for one in own if dataclasses.is_dataclass(one.annotation)}

    def called(**given: Any) -> Any:
        for name, group in groups.items():
            given[name] = group(**{one.name: given.pop(one.name) for one in dataclasses.fields(group)})
        return function(**given)

    called.__doc__ = function.__doc__
    setattr(called, "__signature__", inspect.Signature(list(map(_worded, parameters(function)))))  # noqa: B010
    return called


def flag(name: str) -> str:
    """The option of a parameter: `--held-out` of `held_out`, `--class` of `class_`."""
    return f"--{name.strip('_').replace('_', '-')}"


def _worded(parameter: inspect.Parameter) -> inspect.Parameter:
    """The parameter with its option or argument, by the vocabulary and by what its own annotation says."""
    kind = parameter.annotation
    own_help: Any = None
    if get_origin(kind) is Annotated:
        kind, own_help = get_args(kind)
    if kind is typer.Context or not isinstance(own_help, str | None):
        return parameter  # which typer reads as it is
    word = WORDS[parameter.name]
    shown: dict[str, Any] = {
        "help": own_help or word.help, "metavar": word.metavar, "autocompletion": word.complete,
        "min": word.least, "max": word.most,
    }  # fmt: skip
    if parameter.kind is parameter.KEYWORD_ONLY:
        names = flag(parameter.name)
        if word.short.startswith("--"):  # of a switch that is on
            info = typer.Option(f"{names}/{word.short}", **shown)
        else:
            info = typer.Option(*filter(None, (names, word.short)), **shown)
    else:
        info = typer.Argument(**shown)
    return parameter.replace(annotation=Annotated[kind, info])
