"""Messages as JSON, and back: whatever is not exactly a message is refused with one line."""

from __future__ import annotations

import json
import math
from dataclasses import fields, is_dataclass
from functools import cache
from typing import TYPE_CHECKING, Annotated, Any, TypeVar, get_args

from upright.errors import UprightError
from upright.lab.messages import ClientMessage

if TYPE_CHECKING:
    from pydantic import TypeAdapter

LARGEST = 64 * 1024
"""Characters of a client's message beyond which it is not even parsed."""

T = TypeVar("T")

KINDS: dict[str, type] = {kind.__name__: kind for kind in get_args(ClientMessage)}


class InvalidMessage(UprightError):
    """Text that is no message of a client."""


_JSON = json.JSONEncoder(separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode


def encode(message: Any) -> str:
    """A message as compact JSON with its `kind`; NaN and infinity become null."""
    try:
        return _JSON(vars(message))  # most hold numbers, text and tuples alone, and fifty a second go out
    except (TypeError, ValueError):
        return _JSON(plain(message))


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
    return validated(_messages(), text)


def validated(kind: TypeAdapter[T], text: str) -> T:
    """What the JSON in `text` says of that kind; raises `InvalidMessage` for anything else."""
    try:
        return kind.validate_json(text)
    except ValueError as error:
        raise _refusal(error) from None


@cache
def _messages() -> TypeAdapter[Any]:
    from pydantic import Field, TypeAdapter  # slow to load, and only the server decodes

    return TypeAdapter(Annotated[ClientMessage, Field(discriminator="kind")])


def _refusal(error: ValueError) -> InvalidMessage:
    """The first thing that pydantic objects to, in one line."""
    from pydantic import ValidationError

    if not isinstance(error, ValidationError):  # half a surrogate pair cannot be text
        return InvalidMessage(f"this is no JSON ({type(error).__name__})")
    first = error.errors(include_url=False)[0]
    value, objection = first["input"], first["msg"]
    if first["type"].startswith("union_tag"):
        return InvalidMessage(f"a message of kind {_short(value.get('kind'))}", expected="one of " + ", ".join(KINDS))
    where = ".".join(str(part) if str(part).isprintable() else "…" for part in first["loc"])[:120] or "the message"
    if objection.startswith(EXPECTED):
        return InvalidMessage(f"{where} is {_short(value)}", expected=objection.removeprefix(EXPECTED)[:200])
    return InvalidMessage(f"{where}: {objection.removeprefix('Value error, ')[:200]}")


EXPECTED = "Input should be "


def _short(value: Any) -> str:
    if isinstance(value, int) and abs(value) > 2**63:  # Python itself refuses to print the longest
        return "a number beyond 2^63"
    return repr(value)[:40] if isinstance(value, str | int | float | None) else f"a {type(value).__name__}"
