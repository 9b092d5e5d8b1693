"""Messages as JSON, and back: whatever is not exactly a message is refused with one line."""

from __future__ import annotations

import functools
import json
import math
import types
from dataclasses import MISSING, Field, fields, is_dataclass
from typing import Any, Literal, get_args, get_origin, get_type_hints

from upright.errors import UprightError
from upright.lab import messages
from upright.lab.messages import LONGEST_TEXT, MOST_ITEMS, ClientMessage

LARGEST = 64 * 1024
"""Characters of a client's message beyond which it is not even parsed."""

KINDS: dict[str, type] = {kind.__name__: kind for kind in get_args(ClientMessage)}


class InvalidMessage(UprightError):
    """Text that is no message of a client."""


_JSON = json.JSONEncoder(separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode


def encode(message: Any) -> str:
    """A message as compact JSON with its `kind`; NaN and infinity become null."""
    kind = {"kind": type(message).__name__}
    try:
        return _JSON(kind | vars(message))  # most hold numbers, text and tuples alone, and fifty a second go out
    except (TypeError, ValueError):
        return _JSON(kind | plain(message))


def plain(value: Any) -> Any:
    """Dataclasses, tuples and numbers as what JSON has."""
    if is_dataclass(value) and not isinstance(value, type):
        return {f.name: plain(getattr(value, f.name)) for f in fields(value)}
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, tuple | list):
        return [plain(item) for item in value]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value


def decode(text: str) -> Any:
    """The client's message in `text`; raises `InvalidMessage` for anything else."""
    if len(text) > LARGEST:
        raise InvalidMessage(f"a message of {len(text)} characters", expected=f"at most {LARGEST}")
    try:
        data = json.loads(text, parse_constant=_no_constant)
    except (ValueError, RecursionError) as error:
        raise InvalidMessage(f"this is no JSON ({str(error)[:80]})") from None
    if not isinstance(data, dict):
        raise InvalidMessage(f"a message that is a {type(data).__name__}", expected="an object")
    kind = data.pop("kind", None)
    if not isinstance(kind, str) or kind not in KINDS:
        raise InvalidMessage(f"a message of kind {str(kind)[:40]!r}", expected="one of " + ", ".join(KINDS))
    return build(KINDS[kind], data, kind)


def build(kind: type, data: Any, where: str) -> Any:
    """The dataclass `kind` from a dictionary, every field checked."""
    if not isinstance(data, dict):
        raise InvalidMessage(f"{where} is {_short(data)}", expected="an object")
    known, needed = _fields_of(kind)
    if stranger := next((key for key in data if key not in known), None):
        raise InvalidMessage(f"{where} has no field '{stranger[:40]}'", expected="one of " + ", ".join(known))
    if absent := [name for name in needed if name not in data]:
        raise InvalidMessage(f"{where} lacks {', '.join(absent)}")
    hints = hints_of(kind)
    return kind(**{n: _checked(data[n], hints[n], known[n], f"{where}.{n}") for n in data})


@functools.cache
def _fields_of(kind: type) -> tuple[dict[str, Field[Any]], list[str]]:
    """A dataclass's fields by name, and which of them have no default."""
    known = {f.name: f for f in fields(kind)}
    return known, [n for n, f in known.items() if f.default is MISSING and f.default_factory is MISSING]


@functools.cache
def hints_of(kind: type) -> dict[str, Any]:
    """The types of a dataclass's fields, evaluated."""
    return get_type_hints(kind, dict(vars(messages)))


def _checked(value: Any, hint: Any, field: Field[Any], where: str) -> Any:
    result = _convert(value, hint, where)
    low, high = field.metadata.get("low", -math.inf), field.metadata.get("high", math.inf)
    if isinstance(result, int | float) and not low <= result <= high:
        raise InvalidMessage(f"{where} is {result:g}", expected=f"between {low:g} and {high:g}")
    return result


def _convert(value: Any, hint: Any, where: str) -> Any:
    origin = get_origin(hint)
    if is_dataclass(hint) and isinstance(hint, type):
        return build(hint, value, where)
    if origin is Literal:
        if value in get_args(hint) and isinstance(value, str):
            return value
        raise InvalidMessage(f"{where} is {_short(value)}", expected="one of " + ", ".join(map(str, get_args(hint))))
    if origin is types.UnionType:
        inner = next(part for part in get_args(hint) if part is not type(None))
        return None if value is None else _convert(value, inner, where)
    if origin is tuple:
        return tuple(_convert(item, get_args(hint)[0], where) for item in _few(value, list, where))
    if origin is dict:
        items = _few(value, dict, where)
        return {_text(key, where): _convert(item, get_args(hint)[1], where) for key, item in items.items()}
    return _SCALARS[hint](value, where)


def _few(value: Any, kind: type, where: str) -> Any:
    if not isinstance(value, kind) or len(value) > MOST_ITEMS:  # type: ignore[arg-type]
        raise InvalidMessage(f"{where} is {_short(value)}", expected=f"at most {MOST_ITEMS} items")
    return value


def _text(value: Any, where: str) -> str:
    if not isinstance(value, str) or len(value) > LONGEST_TEXT or not value.isprintable():
        raise InvalidMessage(f"{where} is {_short(value)}", expected=f"text of at most {LONGEST_TEXT} characters")
    return value


def _float(value: Any, where: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) < 1e12:
        raise InvalidMessage(f"{where} is {_short(value)}", expected="a number")
    return float(value)


def _int(value: Any, where: str) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not abs(value) < 2**53:
        raise InvalidMessage(f"{where} is {_short(value)}", expected="a whole number")
    return value


def _bool(value: Any, where: str) -> bool:
    if not isinstance(value, bool):
        raise InvalidMessage(f"{where} is {_short(value)}", expected="true or false")
    return value


_SCALARS: dict[Any, Any] = {str: _text, float: _float, int: _int, bool: _bool}


def _short(value: Any) -> str:
    return repr(value)[:40] if isinstance(value, str | int | float | bool | None) else f"a {type(value).__name__}"


def _no_constant(text: str) -> float:
    raise ValueError(f"{text} is not a number")
