"""The command `upright`: its commands, and how errors become one line and an exit code."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import Annotated, Any

import typer
from typer.main import get_command

from upright import interrupts
from upright.atomic import together
from upright.cli.help import EXAMPLES, Commands, Grouped, SpokenHelp
from upright.cli.mistyped import mistyped
from upright.cli.typed import TYPED
from upright.errors import UprightError
from upright.messages import in_language
from upright.plugins import where

USER_ERROR, BUG = 2, 1
"""Exit codes: an error that the user can correct, and a bug. An interrupted run has 128 and the signal's number, as in
shells: 130 for Ctrl-C."""

INTERRUPTED = 130  # into which typer turns a `KeyboardInterrupt`, whatever the signal was

LASTING = ("fly", "monitor", "lab")
"""Commands that Ctrl-C ends as they usually end: they stop motors then, and write what they have."""

PROPOSALS = ("; try: ", "Did you mean", "Possible options", ": pip install ")
"""Words before what a message says to type; to one without them the help of the command is added."""

app = typer.Typer(
    name="upright", cls=Grouped, rich_markup_mode=None, context_settings={"help_option_names": ["-h", "--help"]}
)


def group() -> Grouped:
    """`upright` with all its commands."""
    whole = get_command(app)
    assert isinstance(whole, Grouped)
    whole.commands = Commands()  # type: ignore[assignment] (it only reads them)
    whole.context_class.formatter_class = SpokenHelp  # of each command: they share the class
    return whole


def _print_version(asked: bool) -> None:
    if asked:
        from importlib.metadata import version

        typer.echo(f"upright {version('upright')}")
        raise typer.Exit


@app.callback(invoke_without_command=True)
def start(
    context: typer.Context,
    debug: Annotated[bool, typer.Option("--debug", help="Show tracebacks, as UPRIGHT_DEBUG=1 does.")] = False,  # noqa: ARG001 (main reads it)
    version: Annotated[  # noqa: ARG001 (its callback acts)
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """The workbench for two-wheeled balancing robots: model, identify, control, certify, compare."""
    interrupts.Run.lasting = context.invoked_subcommand in LASTING
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code: 0, 2 for an error of the user, 1 for a bug, 130 for Ctrl-C.

    All its files appear at the end, if it is neither interrupted nor fails.
    """
    arguments = sys.argv[1:] if argv is None else list(argv)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # matrices here are small: more threads only wait for each other
    interrupts.reset()
    interrupts.Run.message = in_language(interrupts.STOPPED)
    try:
        return run(arguments)
    except (KeyboardInterrupt, typer.Abort):
        pass
    except Exception as error:  # whatever it is, a user gets one line
        if not interrupts.interrupted():  # which may end in any exception
            if _debugging(arguments):
                raise
            return _code_of(error, arguments)
    typer.echo(interrupts.Run.message, err=True, nl=False)
    return interrupts.exit_code()


def run(arguments: Sequence[str]) -> int:
    """Run one command, whose files appear together at its end, and return its exit code; raises whatever it raises."""
    TYPED.set(arguments)
    with together():
        code = group().main(list(arguments), prog_name="upright", standalone_mode=False)
        if code == INTERRUPTED and not interrupts.Run.kept:
            raise KeyboardInterrupt
    return code if isinstance(code, int) else 0


def _code_of(error: Exception, arguments: Sequence[str]) -> int:
    """Print the error as one line on stderr, which ends with what to try, and return the exit code."""
    code = USER_ERROR
    if isinstance(error, typer.TyperException):
        message = mistyped(error)
    elif isinstance(error, UprightError):
        message = str(error)
    elif isinstance(error, OSError) and error.filename is not None:
        message = f"{error.filename}: {error.strerror}"
    elif where(error):
        message = f"{where(error)}: {type(error).__name__}: {error}; try: correct it, or UPRIGHT_DEBUG=1 for more"
    else:
        code = BUG
        message = f"unexpected {type(error).__name__}: {error}; try: UPRIGHT_DEBUG=1, and report the traceback"
    if not any(proposal in message for proposal in PROPOSALS):
        called = _called(arguments)
        examples = [line for lines in EXAMPLES.values() for line in lines if line.startswith(f"{called} ")]
        lacks = message.startswith("Missing") and examples
        message += f"; try: {examples[0] if lacks else f'{called} --help'}"
    complain(message)
    return code


def _called(arguments: Sequence[str]) -> str:
    """The command that was called, with its own, such as `upright robots new`."""
    path = "upright"
    command: Any = group()
    for word in arguments:
        known = getattr(command, "commands", {})
        if word in known:
            command = known[word]
            path += f" {word}"
    return path


def complain(message: str) -> None:
    """Print one line on stderr."""
    colour = None if "NO_COLOR" not in os.environ else False
    typer.secho(f"upright: {in_language(' '.join(message.split()))}", fg="red", err=True, color=colour)


def _debugging(arguments: Sequence[str]) -> bool:
    return "--debug" in arguments or os.environ.get("UPRIGHT_DEBUG", "") not in ("", "0")
