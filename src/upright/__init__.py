"""upright: the workbench for two-wheeled balancing robots.

`import upright as up` offers a verb for each command (`up.doctor("run.csv")`, `up.design("lqg", "nxtway-gs")`) and the
nouns that they take. `__init__.pyi` lists them; each is loaded when it is first used, so that this import is quick.
"""

import functools
import inspect
from collections.abc import Callable
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
            signature.bind(*given, **named)
        except TypeError as error:
            from upright.errors import WrongArguments

            expected = f"{function.__name__}({', '.join(signature.parameters)})"
            raise WrongArguments(f"{function.__name__}: {error}", expected=expected) from None
        return function(*given, **named)

    return called
