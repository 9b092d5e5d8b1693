"""Text, JSON and TOML from files that anybody may have written: bounded in size and depth, refused in one line."""

from __future__ import annotations

import dataclasses
import json
import math
import re
import sys
import tomllib
from collections.abc import Generator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, cast

from upright.errors import UprightError

LARGEST = 64 << 20
"""[bytes] of a file that is read as one text."""

LONGEST_NUMBER = 300
"""Digits of a whole number: a float holds one of 308."""

_DEEP_KEY = re.compile(r"""(?:[\w"'-]{1,80}\s*\.\s*){50}""")
_SURROGATE = re.compile(r"\\u[dD][89a-fA-F]")

Refused = type[UprightError]
"""The class of the error for a file that is refused."""


def expanded(path: str | Path, refused: Refused) -> Path:
    """The path with `~` expanded, of a file or of none; raises `refused` for one that no system takes."""
    try:
        place = Path(path).expanduser()
        place.lstat()
    except (FileNotFoundError, NotADirectoryError, PermissionError):
        return Path(path).expanduser()
    except RuntimeError:
        raise refused(f"{path} names a home folder that is not known", hint="write the path in full") from None
    except (OSError, ValueError) as error:  # too long, or with a zero in it
        why = (error.strerror if isinstance(error, OSError) else None) or str(error)
        raise refused(f"{str(path)[:60]!a} is no path: {why}") from None
    return place


def read_text(path: str | Path, refused: Refused, expected: str) -> str:
    """The file at `path`, with `~` expanded, as UTF-8; raises `refused` for no such text, or beyond `LARGEST`."""
    source = expanded(path, refused)
    try:
        with source.open("rb") as stream:
            raw = stream.read(LARGEST + 1)
    except OSError as error:
        raise refused(f"cannot read {path}: {error.strerror or error}", expected=expected) from None
    if len(raw) > LARGEST:
        raise refused(f"{path} is larger than {LARGEST >> 20} MB", expected=expected)
    try:
        return raw.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise refused(f"{path} is not text in UTF-8", expected=expected) from None


def parse_json(text: str, where: str, refused: Refused, expected: str) -> Any:
    """The values of JSON; raises `refused` for what is none, nests too deeply, or has longer numbers than may be."""
    try:
        data = json.loads(text, parse_int=_whole, parse_float=_finite)
        if _SURROGATE.search(text):
            json.dumps(data, ensure_ascii=False).encode()
        return data
    except RecursionError:
        why = "it nests too deeply"
    except UnicodeEncodeError:
        why = "half of a character, a lone surrogate"
    except ValueError as error:
        why = str(error)
    raise refused(f"{where} is no JSON ({why})", expected=expected)


def parse_toml(text: str, where: str, refused: Refused, expected: str) -> dict[str, Any]:
    """The table of TOML; raises `refused` as `parse_json` does, and for a whole number beyond 64 bits."""
    try:
        if _DEEP_KEY.search(text):  # before tomllib, whose memory grows with the square of a key's parts
            raise RecursionError
        table = tomllib.loads(text, parse_float=_finite)
        _check_whole(table)
        return table
    except RecursionError:
        why = "it nests too deeply"
    except tomllib.TOMLDecodeError as error:
        why = f'"{error}"'
    except ValueError as error:
        why = str(error)
    raise refused(f"{where} is broken TOML: {why}", expected=expected)


def read_json(path: str | Path, refused: Refused, expected: str) -> Any:
    """The values of a JSON file; raises `refused`."""
    return parse_json(read_text(path, refused, expected), str(path), refused, expected)


def read_toml(path: str | Path, refused: Refused, expected: str) -> dict[str, Any]:
    """The table of a TOML file; raises `refused`."""
    return parse_toml(read_text(path, refused, expected), str(path), refused, expected)


@contextmanager
def understood(where: str, refused: Refused, expected: str) -> Generator[None]:
    """While plain data becomes an object: what is missing in it, or of another type or size, raises `refused`."""
    try:
        yield
    except (LookupError, TypeError, ValueError, AttributeError, ArithmeticError, RecursionError, MemoryError) as error:
        why = f"{type(error).__name__}: {str(error)[:200]}"
        raise refused(f"{where} is broken ({why})", expected=expected) from None


@contextmanager
def named(path: str | Path, refused: Refused) -> Generator[None]:
    """While an object is made of the file at `path`: what raises `refused` begins with the file's name."""
    try:
        yield
    except refused as error:
        raise refused(f"{path}: {error}") from None


def check_schema(given: dict[str, Any], schema: str, refused: Refused) -> None:
    """Take the name of its schema, and what a command adds, off the JSON of a result; raises `refused` for another
    schema."""
    for added in ("head", "files"):
        given.pop(added, None)
    named = given.pop("schema", None)
    if named != schema:
        verb = schema.split("/")[1]
        came = "JSON without a schema" if named is None else f"JSON {str(named)[:60]}"
        raise refused(came, expected=schema, hint=f"make it anew with upright {verb}")


def limit_memory(size: int) -> None:
    """Let this process take at most `size` [bytes] of addresses and leave no core file, where the system has such
    limits: Windows has none, and macOS may refuse one below what is mapped already."""
    with suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        hard = resource.getrlimit(resource.RLIMIT_AS)[1]
        resource.setrlimit(resource.RLIMIT_AS, (size, hard))


def give_back() -> None:
    """Memory that is free goes back to the system, where the C library would keep it (glibc; about 1 ms)."""
    if sys.platform != "linux":
        return
    import ctypes

    if trim := getattr(ctypes.CDLL(None), "malloc_trim", None):
        trim(0)


_PLAIN: dict[str, Any] = {"str": str, "float": (int, float), "int": int, "bool": bool}


def check_types(thing: Any) -> None:
    """Raise `TypeError` for a field of a dataclass, or of one inside what `thing` keeps, that is not its text or
    number."""
    kinds = (
        {field.name: str(field.type) for field in dataclasses.fields(thing)} if dataclasses.is_dataclass(thing) else {}
    )
    for name, value in vars(thing).items() if hasattr(thing, "__dict__") else ():
        kind = _PLAIN.get(kinds.get(name, ""))
        if kind and not (isinstance(value, kind) and (kind is bool) == isinstance(value, bool)):
            raise TypeError(f"{name} is {str(value)[:60]!r}, not {kinds[name]}")
        for inner in cast("tuple[Any, ...]", value if isinstance(value, tuple) else (value,)):
            if dataclasses.is_dataclass(inner):
                check_types(inner)


def _whole(digits: str) -> int:
    if len(digits.lstrip("-")) > LONGEST_NUMBER:
        raise ValueError(f"a whole number of {len(digits.lstrip('-'))} digits")
    return int(digits)


def _finite(text: str) -> float:
    value = float(text)
    if math.isinf(value) and "inf" not in text:
        raise ValueError(f"{text[:20]} is beyond every number")
    return value


def _check_whole(table: dict[str, Any]) -> None:
    """Raise `ValueError` for a whole number of more than 64 bits."""
    left: list[Any] = [table]
    while left:
        value = left.pop()
        left += value.values() if isinstance(value, dict) else value if isinstance(value, list) else []
        if isinstance(value, int) and abs(value) >= 2**63:
            raise ValueError("a whole number beyond 64 bits")
