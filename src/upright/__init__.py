"""upright: the workbench for two-wheeled balancing robots.

`import upright as up` offers a verb for each command (`up.doctor("run.csv")`, `up.design("lqg", "nxtway-gs")`) and the
nouns that they take. `__init__.pyi` lists them; each is loaded when it is first used, so that this import is quick.
"""

import sys
from types import ModuleType

from lazy_loader import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)


class _Package(ModuleType):
    """A package whose verbs win over its rooms: `upright.calibrate` is the function, whatever was imported before.

    Importing a room sets an attribute of its name on the package; where a verb has this name, it is not set.
    `from upright.calibrate.fitting import …` works as ever, since imports look rooms up in `sys.modules`.
    """

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in __all__ and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
