"""The page's types, generated from the dataclasses of `lab.messages`.

Run `python -m upright.lab.typescript` after a change of a message.
"""

from __future__ import annotations

import json
import types
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any, Literal, get_args, get_origin, get_type_hints

from upright.atomic import write_text
from upright.lab import message_types, messages
from upright.lab.codec import plain

TARGET = Path(__file__).parent / "web" / "src" / "messages.ts"

NAMES = ("BodyName", "Job", "Keep", "PushName", "Work")

_SCALARS: dict[Any, str] = {str: "string", float: "number", int: "number", bool: "boolean", type(None): "null"}


def generate() -> str:
    """The whole of `messages.ts`."""
    known = vars(message_types) | vars(messages)
    homes = (messages.__name__, message_types.__name__)
    kinds = [k for k in vars(messages).values() if isinstance(k, type) and is_dataclass(k) and k.__module__ in homes]
    parts = [
        "// Generated from src/upright/lab/messages.py by python -m upright.lab.typescript; do not edit.",
        f"export const VERSION = {messages.VERSION};",
        *(f"export type {name} = {_type(known[name])};" for name in NAMES),
        *map(_interface, kinds),
        f"export const DEFAULT_SETUP: Setup = {json.dumps(plain(messages.Setup()))};",
        _union("ClientMessage", messages.ClientMessage),
        _union("ServerMessage", messages.ServerMessage),
    ]
    return "\n\n".join(parts) + "\n"


def write() -> Path:
    """Write `messages.ts` and return its path."""
    write_text(TARGET, generate())
    return TARGET


def _interface(kind: type) -> str:
    hints = get_type_hints(kind)
    names = sorted((f.name for f in fields(kind)), key=lambda name: name != "kind")  # the kind first
    lines = [f"  {name}: {_type(hints[name])};" for name in names]
    return "\n".join([f"export interface {kind.__name__} {{", *lines, "}"])


def _type(hint: Any) -> str:
    origin, inside = get_origin(hint), get_args(hint)
    if origin is Literal:
        return " | ".join(f'"{value}"' for value in inside)
    if origin is types.UnionType:
        return " | ".join(_type(part) for part in inside)
    if origin is tuple:
        item = _type(inside[0])
        return f"({item})[]" if "|" in item else f"{item}[]"
    if origin is dict:
        return f"Record<string, {_type(inside[1])}>"
    return _SCALARS.get(hint) or hint.__name__


def _union(name: str, hint: Any) -> str:
    return f"export type {name} =\n  | " + "\n  | ".join(kind.__name__ for kind in get_args(hint)) + ";"


if __name__ == "__main__":
    print(f"wrote {write()}")
