"""What the page has from Python: types from the dataclasses of `lab.messages`, limits of margins, its Spanish from the
catalogue of all pages, and their script.

Run `python -m upright.lab.typescript` after a change of a message, of `texts/en.json`, of a translation or of that
script.
"""

from __future__ import annotations

import json
import types
from dataclasses import fields, is_dataclass
from importlib import resources
from pathlib import Path
from typing import Any, Literal, get_args, get_origin, get_type_hints

from upright.atomic import write_text
from upright.lab import message_types, messages
from upright.lab.codec import plain
from upright.languages import ENGLISH, LANGUAGES, catalogue
from upright.loops.targets import LEAST_DELAY, LEAST_GAIN, PHASE, STRONG, WEAK

SOURCE = Path(__file__).parent / "web" / "src"
TARGET = SOURCE / "messages.ts"
SCRIPT = SOURCE / "hover.js"
TEXTS = SOURCE / "texts"

NAMES = ("BodyName", "Job", "Keep", "Language", "PushName", "Work")

_SCALARS: dict[Any, str] = {str: "string", float: "number", int: "number", bool: "boolean", type(None): "null"}


def generate() -> str:
    """The whole of `messages.ts`."""
    known = vars(message_types) | vars(messages)
    homes = (messages.__name__, message_types.__name__)
    kinds = [k for k in vars(messages).values() if isinstance(k, type) and is_dataclass(k) and k.__module__ in homes]
    parts = [
        "// Generated from src/upright/lab/messages.py by python -m upright.lab.typescript; do not edit.",
        f"export const VERSION = {messages.VERSION};",
        f"export const LEAST_GAIN = {LEAST_GAIN}; // [1] below which a margin is thin, as in designs and certificates",
        f"export const LEAST_DELAY = {LEAST_DELAY}; // [periods]",
        f"export const [WEAK, STRONG, PHASE] = [{WEAK}, {STRONG}, {PHASE}]; // usual: factors of the motors, [°]",
        *(f"export type {name} = {_type(known[name])};" for name in NAMES),
        *map(_interface, kinds),
        f"export const DEFAULT_SETUP: Setup = {json.dumps(plain(messages.Setup()))};",
        _union("ClientMessage", messages.ClientMessage),
        _union("ServerMessage", messages.ServerMessage),
    ]
    return "\n\n".join(parts) + "\n"


def spoken(language: str) -> str:
    """The page's texts in another language, in the places of the English ones."""
    words = catalogue(language)

    def other(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: other(item) for key, item in value.items()}
        return [other(item) for item in value] if isinstance(value, list) else words.get(value, value)

    english = json.loads((TEXTS / "en.json").read_text("utf-8"))
    return json.dumps(other(english), ensure_ascii=False, indent=2) + "\n"


def script() -> str:
    """The script of a page of results, for such pages within the lab."""
    text = resources.files("upright.pages").joinpath("hover.js").read_text("utf-8")
    return f"// @ts-nocheck: pages/hover.js, written here by python -m upright.lab.typescript; do not edit.\n{text}"


def write() -> list[Path]:
    """Write `messages.ts`, the script and the texts of each language, and return their paths."""
    made = {TARGET: generate(), SCRIPT: script()} | {
        TEXTS / f"{name}.json": spoken(name) for name in LANGUAGES if name != ENGLISH
    }
    return [write_text(path, text) for path, text in made.items()]


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
    print("wrote", *write())
