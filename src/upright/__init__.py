"""upright: the workbench for two-wheeled balancing robots.

`import upright as up` offers a verb for each command (`up.doctor("run.csv")`, `up.design("lqg", "nxtway-gs")`) and the
nouns that they take. `__init__.pyi` lists them; each is loaded when it is first used, so that this import is quick.
"""

import functools
import inspect
from collections.abc import Callable, Mapping
from types import FunctionType
from typing import Any

from lazy_loader import attach_stub

_loaded, __dir__, __all__ = attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    thing = _loaded(name)
    if isinstance(thing, FunctionType):
        thing = globals()[name] = _verb(thing)
    return thing


def _verb(function: Callable[..., Any]) -> Callable[..., Any]:
    """The function, whose wrong arguments are an error of this package too: one line with the right ones."""
    signature = inspect.signature(function)

    @functools.wraps(function)
    def called(*given: Any, **named: Any) -> Any:
        try:
            wrong = _misplaced(signature.bind(*given, **named).arguments)
        except TypeError as error:
            wrong = str(error)
        if wrong:
            from upright.errors import WrongArguments

            expected = f"{function.__name__}({', '.join(signature.parameters)})"
            raise WrongArguments(f"{function.__name__}: {wrong}", expected=expected)
        return function(*given, **named)

    return called


def _misplaced(arguments: Mapping[str, Any]) -> str:
    """Which argument is a thing of another kind, as where two were given in the wrong order; "" where none is."""
    if not _KINDS.keys() & arguments.keys():
        return ""
    from upright.bodies.body import Body
    from upright.control.controller import Controller
    from upright.robots import Kit, Robot
    from upright.signals import Log

    things = {"robot": Robot, "kit": Kit, "body": Body, "controller": Controller, "log": Log}
    for name, value in arguments.items():
        others = [thing for kind, thing in things.items() if kind != _KINDS[name]] if name in _KINDS else []
        if others and isinstance(value, (*others, int, float)):
            return f"its {name} is a {type(value).__name__}"
    return ""


_KINDS = {
    **{name: name for name in ("robot", "kit", "body", "controller", "log", "method", "program")},
    **{"logs": "log", "source": "log"},
}
"""Name of an argument → what it takes."""
