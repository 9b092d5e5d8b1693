"""Registries that packages and files extend: `my.py:Rod`, and entry points of what is installed."""

from __future__ import annotations

import importlib.util
import traceback
from collections.abc import Callable, Iterator, Mapping
from importlib import metadata
from pathlib import Path
from types import ModuleType
from typing import Any, Generic, TypeVar

from upright.errors import InvalidPlugin, UnknownName, UprightError

Entry = TypeVar("Entry")
Made = TypeVar("Made")


OUTSIDE = "upright_plugin_"
"""How the names of modules begin that are a user's own files."""


class Registry(Mapping[str, Entry], Generic[Entry]):
    """Entries by name: ours, those registered at run time, and those of the entry-point `group`, loaded when asked for.

    `registry["my.py:Rod"]` is the class or function `Rod` of that file. `entry` makes an entry of (name, object) from
    outside. Of two with one name the first of ours, registered, installed counts. Raises `UnknownName`, or
    `InvalidPlugin` in one line for a plug-in that cannot be loaded.
    """

    def __init__(self, kind: str, group: str, own: Mapping[str, Entry], entry: Callable[[str, Any], Entry]) -> None:
        self.kind = kind
        self.group = group
        self._own = dict(own)
        self._entry = entry

    def register(self, name: str, thing: Any) -> None:
        """Add an entry while the program runs; raises `InvalidPlugin` for a name that is taken."""
        if name in self:
            raise InvalidPlugin(f"a {self.kind} is called '{name}' already", expected="a new name")
        self._own[name] = self._entry(name, thing)

    def __getitem__(self, name: str) -> Entry:
        if name in self._own:
            return self._own[name]
        if ".py:" in name or name.endswith(".py"):
            return self._entry(name, from_file(name))
        for point in metadata.entry_points(group=self.group):
            if point.name == name:
                return self._entry(name, _loaded(f"{self.kind} '{name}' ({point.value})", point.load))
        raise UnknownName(self.kind, name, self)

    def __iter__(self) -> Iterator[str]:
        installed = (point.name for point in metadata.entry_points(group=self.group))
        return iter(dict.fromkeys((*self._own, *installed)))

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __contains__(self, name: object) -> bool:
        return name in self._own or name in list(self)


def from_file(place: str) -> Any:
    """The object `Name` of the Python file in "file.py:Name"; raises `InvalidPlugin` in one line."""
    file, _, name = place.rpartition(":") if ".py:" in place else (place, "", "")
    path = Path(file)
    if not path.is_file():
        raise InvalidPlugin(f"there is no file {path}", expected="file.py:Name")
    spec = importlib.util.spec_from_file_location(f"{OUTSIDE}{path.stem}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    loader = spec.loader
    _loaded(str(path), lambda: loader.exec_module(module))
    if not hasattr(module, name):
        what = f"{path} has no {name}" if name else f"{path} without a name"
        raise InvalidPlugin(what, expected=f"{path}:Name, with Name one of {', '.join(_callables(module)) or 'none'}")
    return getattr(module, name)


def made(what: str, kind: type[Made], make: Callable[..., Any], *arguments: Any) -> Made:
    """What `make` of a plug-in returns for `arguments`; `InvalidPlugin` where it fails or returns no `kind`."""
    result = _loaded(what, lambda: make(*arguments))
    if not isinstance(result, kind):
        lacks = [name for name in _members(kind) if not hasattr(result, name)]
        raise InvalidPlugin(f"{what} gives a {type(result).__name__} without {', '.join(lacks)}",
                            expected=f"an object like {kind.__name__}")  # fmt: skip
    return result


def _loaded(what: str, load: Callable[[], Any]) -> Any:
    """The result of code from outside, whose every error becomes one line."""
    try:
        return load()
    except UprightError:
        raise
    except (Exception, SystemExit) as error:
        line = where(error)
        raise InvalidPlugin(
            f"{what} gives an error: {f'{line}: ' * bool(line)}{type(error).__name__}: {error}"
        ) from error


def where(error: BaseException) -> str:
    """File and line of a user's own code that an error came through last, such as "my.py line 12"; "" where it is none
    of it."""
    frames = traceback.walk_tb(error.__traceback__)
    own = [(frame, line) for frame, line in frames if str(frame.f_globals.get("__name__")).startswith(OUTSIDE)]
    return f"{Path(own[-1][0].f_code.co_filename).name} line {own[-1][1]}" if own else ""


def _callables(module: ModuleType) -> list[str]:
    """Names that are defined in the file itself."""
    own = vars(module).items()
    return [n for n, v in own if callable(v) and getattr(v, "__module__", "") == module.__name__ and n[0] != "_"]


def _members(kind: type) -> list[str]:
    return sorted(name for name in vars(kind) if not name.startswith("_"))
