"""The tree of exceptions: every error a user can cause is an `UprightError` that says what to try."""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class UprightError(Exception):
    """Root of all errors of this package.

    The message is one line: what came, what was expected, the likely cause and what to try.

    >>> str(UprightError("period is -1 s", expected="a positive number", hint="use 0.01"))
    'period is -1 s; expected a positive number; try: use 0.01'
    """

    def __init__(self, came: str, *, expected: str = "", likely: str = "", hint: str = "") -> None:
        parts = [came]
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


class UnknownName(UprightError):
    """A name that is in no registry; the message lists what there is."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        names = sorted(known)
        close = difflib.get_close_matches(name, names, n=1, cutoff=0.5)
        hint = f"did you mean '{close[0]}'?" if close else ""
        super().__init__(f"no {kind} is called '{name}'", expected="one of " + ", ".join(names), hint=hint)
