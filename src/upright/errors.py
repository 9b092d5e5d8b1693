"""The tree of exceptions: every error a user can cause is an `UprightError` that says what to try."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from importlib.util import find_spec

LONGEST_SHOWN = 80
"""Letters of a name that a message repeats."""
MOST_LISTED = 40
"""Names that a message lists beside the one that is meant: more fill the screen."""
LONGEST_REASON = 200
"""Letters of another library's message that ours repeats."""
EXTRAS = {
    "cma": "tune", "control": "control", "cvxpy": "robust", "distributed": "cluster", "gymnasium": "gym",
    "imageio_ffmpeg": "film", "mcap": "mcap", "nxt": "nxt", "pybricksdev": "pybricks", "zarr": "zarr",
}  # fmt: skip
"""Modules that a plain installation lacks, and the extra of this package that brings each."""


class UprightError(Exception):
    """Root of all errors of this package.

    The message is one line: what came, what was expected, the likely cause and what to try. Its `parts` are these,
    `came`, `expected`, `likely` and `hint`, each empty where nothing is said; one may be a sentence that knows its
    translation, or a command to run.

    >>> str(UprightError("period is -1 s", expected="a positive number", hint="use 0.01"))
    'period is -1 s; expected a positive number; try: use 0.01'
    """

    def __init__(self, came: object, *, expected: object = "", likely: object = "", hint: object = "") -> None:
        self.parts = {"came": came, "expected": expected, "likely": likely, "hint": hint}
        parts = [str(came)]
        parts += [f"expected {expected}"] if expected else []
        parts += [f"likely {likely}"] if likely else []
        parts += [f"try: {hint}"] if hint else []
        super().__init__("; ".join(" ".join(part.split()) for part in parts))


class InvalidRobot(UprightError):
    """Parameters that no balancing robot can have, or a robot file that cannot be read."""


class InvalidLog(UprightError):
    """Data that is not a log: missing columns, NaN, time that does not increase, a broken file."""


class InvalidModel(UprightError):
    """Matrices of the wrong size, or continuous and discrete models mixed."""


class InvalidScenario(UprightError):
    """A push, reference or duration that cannot be run."""


class InvalidController(UprightError):
    """A gain of the wrong size, or a controller file that cannot be read."""


class InvalidPlugin(UprightError):
    """A controller or body from outside the package that cannot be loaded, or that lacks part of the contract."""


class SpecMismatch(UprightError):
    """A body and a controller that do not fit each other."""


class DesignFailed(UprightError):
    """A controller or estimator design that has no solution for this robot."""


class NotPermitted(UprightError):
    """A controller that its certificate forbids to drive hardware."""


class MissingTool(UprightError):
    """An optional package or program that is not installed."""


def lacking(what: str, module: str) -> str:
    """Where a module of `EXTRAS` is not installed, one line: `what` needs it, and how to install it; "" where it is."""
    return "" if find_spec(module) else f"{what} needs {module}: pip install 'upright[{EXTRAS[module]}]'"


def require(what: str, module: str) -> None:
    """Raise `MissingTool` where a module of `EXTRAS` is not installed, which `what` needs."""
    if line := lacking(what, module):
        raise MissingTool(line)


class WrongArguments(UprightError, TypeError):
    """A verb that was called with arguments that it does not take."""


class UnknownName(UprightError):
    """A name that is in no registry; the message lists what there is, or says which is meant."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        names = sorted(known)
        hint = meant(name, names)
        expected = "one of " + ", ".join(names)
        if hint and len(names) > MOST_LISTED:
            expected = ""
        shown = name if len(name) <= LONGEST_SHOWN else f"{name[:LONGEST_SHOWN]}…"
        super().__init__(f"no {kind} is called '{shown}'", expected=expected, hint=hint)


def one_line(error: BaseException, longest: int = LONGEST_REASON) -> str:
    """The message of any exception on one line; of one that is not ours at most `longest` letters, or its type."""
    line = " ".join(str(error).split())
    return line if isinstance(error, UprightError) else line[:longest] or type(error).__name__


def meant(name: str, names: Iterable[str], text: str = "{}") -> str:
    """A question for a hint: the one of `names` that is closest to `name`, put into `text`; "" where none is close.

    Of those that are equally close, the one of the same letters: who types `lgq` means `lqg`.
    """
    names = list(names)
    same = [one for one in names if one.lower() == name.lower()]  # `PWM` means `pwm`
    close = same or difflib.get_close_matches(name[:LONGEST_SHOWN], names, n=5, cutoff=0.5)
    if not close:
        return ""
    return f"did you mean '{text.format(min(close, key=lambda c: sorted(c) != sorted(name)))}'?"


def check_within(what: str, value: float, least: float, most: float) -> None:
    """Raise `InvalidScenario` for a size not from `least` to `most`, which would take days or all memory."""
    if not least <= value <= most:
        shown = f"{value:g}" if isinstance(value, float) else str(value)[:20]
        raise InvalidScenario(f"{shown} {what}", expected=f"from {least:g} to {most:g}")
