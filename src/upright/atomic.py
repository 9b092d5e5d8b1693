"""Files that appear whole or not at all, and folders that vanish with the process that made them.

Everything this package writes is written here. A file is filled beside its place and moved there; a link is followed,
and an older file's mode kept; a pipe or a device gets the bytes once there are all of them. What a killed process left
is removed by the next one: it is what nobody holds a lock on.
"""

from __future__ import annotations

import errno
import io
import json
import math
import os
import re
import shutil
import stat
import sys
import tempfile
import time
import uuid
import weakref
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, BinaryIO

from upright import interrupts
from upright.errors import UprightError

fcntl: Any = import_module("fcntl") if find_spec("fcntl") else None  # Windows has none

MOST_LINKS = 40
YOUNG = 60.0  # [s] in which a folder may have no lock yet

_OPEN = re.compile(r"/dev/fd/(\d+)|/proc/(\d+)/fd/(\d+)")
_KINDS = {
    stat.S_IFDIR: ("is a folder", "the name of a file in it"), stat.S_IFSOCK: ("is a socket", "a file"),
    stat.S_IFBLK: ("is a disk", "a file on it"),
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Place:
    """Where the links of a name lead: a `path`, the `mode` of what stands there (0: nothing), and for a stream that is
    open in this process, such as /dev/stdout, its number."""

    path: Path
    mode: int
    stream: int | None = None

    @property
    def keeps(self) -> bool:
        """Whether a file is, or will be there, rather than what passes the bytes on."""
        return self.stream is None and (not self.mode or stat.S_ISREG(self.mode))


class _Pending:
    """What this process has begun: the `moves` that wait for the end of `together` (None: files appear at once), with
    whether one may wait for a reader; what is `unfinished`, with its lock; folders `made` for it; `temporary` ones."""

    moves: list[tuple[bool, Callable[[], None]]] | None = None
    unfinished: dict[Path, int | None] = {}  # noqa: RUF012 (there is one process)
    made: list[Path] = []  # noqa: RUF012
    temporary: set[Path] = set()  # noqa: RUF012


def place_of(name: str | Path, *, folder: bool = False) -> Place:
    """Where `name` leads; raises `UprightError` where no file, or no `folder`, can be written."""
    path = Path(os.path.expanduser(name))
    if str(path).startswith("--"):
        raise UprightError(f"{path.parts[0]} looks like an option", expected="the name of a file or folder")
    place = path
    for _ in range(MOST_LINKS):
        place = Path(os.path.realpath(place.parent)) / place.name
        if (stream := _OPEN.fullmatch(str(place))) and stream[2] in (None, str(os.getpid())):
            return Place(place, stat.S_IFIFO, int(stream[1] or stream[3]))
        if not place.is_symlink():
            break
        place = place.parent / os.readlink(place)
    else:
        raise UprightError(f"cannot write {path}: its links lead in a ring", hint="choose another place")
    if not place.parent.is_dir():
        raise UprightError(f"there is no folder {path.parent} for {path.name}", hint=f"mkdir -p {path.parent}")
    with _reported(path):
        mode = place.stat().st_mode if os.path.lexists(place) else 0
    if folder and mode and not stat.S_ISDIR(mode):
        raise UprightError(f"{path} is no folder", expected="a folder, or nothing there yet")
    if not folder and (why := _KINDS.get(stat.S_IFMT(mode))):
        raise UprightError(f"{path} {why[0]}", expected=why[1])
    result = Place(place, mode)
    needed = ([place] if mode else []) + ([place.parent] if result.keeps else [])
    if not all(os.access(path, os.W_OK) for path in needed):
        raise UprightError(f"cannot write {path}: Permission denied", hint="choose a place that can be written")
    return result


@contextmanager
def writing(target: str | Path, *, at_once: bool = False) -> Generator[BinaryIO]:
    """A stream whose bytes are at `target` when this ends, or at the end of `together` unless `at_once`. A failure
    leaves an older file as it was.

    Raises `UprightError` where that cannot be done, and `KeyboardInterrupt` in an interrupted run.
    """
    path = Path(os.path.expanduser(target))
    place = place_of(path)
    interrupts.check()
    with _reported(path):
        if not place.keeps:
            stream = io.BytesIO()
            yield stream
            _when_complete(path, lambda: _pass_on(place, stream.getbuffer()), now=at_once, waits=True)
            return
        unfinished = _beside(place.path)
        with _removed_after_failure(unfinished):
            with unfinished.open("xb") as file:
                _Pending.unfinished[unfinished] = _locked(unfinished)
                yield file
            if place.mode:
                unfinished.chmod(stat.S_IMODE(place.mode))
            now = at_once or not _Pending.temporary.isdisjoint(place.path.parents)
            _when_complete(path, lambda: _move(unfinished, place.path), now=now, waits=False)


def write_folder(target: str | Path, fill: Callable[[Path], object]) -> Path:
    """Let `fill` make a folder, which then is at `target`, in place of an older one; as `writing`."""
    path = Path(os.path.expanduser(target))
    place = place_of(path, folder=True).path
    interrupts.check()
    with _reported(path):
        unfinished = _beside(place)
        with _removed_after_failure(unfinished):
            unfinished.mkdir()
            _Pending.unfinished[unfinished] = _locked(unfinished)
            fill(unfinished)
            _when_complete(path, lambda: _move(unfinished, place), now=False, waits=False)
    return path


def make_folder(target: str | Path) -> Path:
    """A folder, made where it is missing, and removed again where the run fails before there is anything in it."""
    path = Path(os.path.expanduser(target))
    missing = [p for p in (path, *path.parents) if not os.path.lexists(p)]
    with _reported(path, "make", "choose another folder"):
        path.mkdir(parents=True, exist_ok=True)
    if _Pending.moves is not None:
        _Pending.made += missing
    return path


@contextmanager
def together() -> Generator[None]:
    """All files that are written inside appear at the end; after an error, or in an interrupted run, none."""
    if _Pending.moves is not None:
        yield
        return
    moves: list[tuple[bool, Callable[[], None]]] = []
    _Pending.moves = moves
    try:
        yield
        for move in [move for waits, move in moves if waits]:
            move()
        interrupts.close()
        for move in [move for waits, move in moves if not waits]:
            move()
    finally:
        _Pending.moves = None
        discard()


def discard() -> None:
    """Remove what is unfinished, and the folders made for it."""
    for path in list(_Pending.unfinished):
        _remove(path)
    for path in list(_Pending.made):
        with suppress(OSError):
            path.rmdir()
    _Pending.made.clear()


class TemporaryFolder(tempfile.TemporaryDirectory[str]):
    """A folder, at `path`, that vanishes with this process, however it ends; files in it appear at once."""

    def __init__(self) -> None:
        _sweep(Path(tempfile.gettempdir()), "upright-run-*")
        super().__init__(prefix="upright-run-", ignore_cleanup_errors=True)
        self.path = Path(os.path.realpath(self.name))
        lock = _locked(self.path)
        if lock is not None:
            weakref.finalize(self, os.close, lock)
        _Pending.temporary.add(self.path)

    def cleanup(self) -> None:
        super().cleanup()
        _Pending.temporary.discard(self.path)


def write_bytes(target: str | Path, data: bytes, *, at_once: bool = False) -> Path:
    """Write `data`, whole or not at all, and return the path; as `writing`."""
    with writing(target, at_once=at_once) as stream:
        stream.write(data)
    return Path(os.path.expanduser(target))


def write_text(target: str | Path, text: str, *, at_once: bool = False) -> Path:
    """Write `text` as UTF-8, whole or not at all; as `writing`."""
    return write_bytes(target, text.encode("utf-8", "replace"), at_once=at_once)


def json_text(data: Any, encoding: str = "utf-8") -> str:
    """Indented JSON, in ASCII where `encoding` lacks a character; NaN and infinity, which JSON does not have, are an
    error of the caller."""
    text = json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False)
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return json.dumps(data, indent=2, allow_nan=False)
    return text


def write_json(target: str | Path, data: Any, *, at_once: bool = False) -> Path:
    """Write JSON, whole or not at all; as `writing`."""
    return write_text(target, json_text(data) + "\n", at_once=at_once)


def finite(value: Any) -> Any:
    """The value, or None for a number that JSON does not have: NaN and infinity."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


@contextmanager
def _reported(path: Path, verb: str = "write", hint: str = "choose a place that can be written") -> Generator[None]:
    try:
        yield
    except OSError as error:
        if error.errno is None:
            raise  # a time limit of whoever writes
        hint = "make room, then run it again" if error.errno == errno.ENOSPC else hint
        raise UprightError(f"cannot {verb} {path}: {error.strerror or error}", hint=hint) from None


def _when_complete(path: Path, action: Callable[[], None], *, now: bool, waits: bool) -> None:
    def move() -> None:
        with _reported(path):
            action()

    if now or _Pending.moves is None or interrupts.lasts():
        interrupts.check()
        move()
    else:
        _Pending.moves.append((waits, move))


def _move(unfinished: Path, target: Path) -> None:
    older = None
    if unfinished.is_dir() and target.exists():  # a folder replaces none that is not empty
        older = _beside(target)
        os.replace(target, older)
    os.replace(unfinished, target)
    _remove(unfinished)
    if older:
        _remove(older)


def _pass_on(place: Place, data: memoryview) -> None:
    """To a pipe or a device, in whatever pieces it takes."""
    if sys.stdout:
        sys.stdout.flush()
    with open(place.path if place.stream is None else os.dup(place.stream), "wb", buffering=0) as stream:
        while data:
            data = data[stream.write(data) :]


def _beside(target: Path) -> Path:
    """A name beside the target, because only within one file system is the move a single step."""
    _sweep(target.parent, ".upright-*.part")
    return target.with_name(f".upright-{uuid.uuid4().hex[:8]}.part")


@contextmanager
def _removed_after_failure(unfinished: Path) -> Generator[None]:
    _Pending.unfinished[unfinished] = None
    try:
        yield
    except BaseException:
        _remove(unfinished)
        raise


def _remove(unfinished: Path) -> None:
    """Remove it and forget it, in this order: the run may end in between."""
    if unfinished.is_dir():
        shutil.rmtree(unfinished, ignore_errors=True)
    else:
        unfinished.unlink(missing_ok=True)
    lock = _Pending.unfinished.pop(unfinished, None)
    if lock is not None:
        os.close(lock)


def _locked(path: Path) -> int | None:
    """A lock on a file or a folder, which ends with this process; None where another has it, or where there is none."""
    if fcntl is None:
        return None
    descriptor = os.open(path, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(descriptor)
        return None
    return descriptor


@cache
def _sweep(folder: Path, pattern: str) -> None:
    """Remove what killed processes left."""
    for path in folder.glob(pattern):
        with suppress(OSError):
            if time.time() - path.lstat().st_mtime > YOUNG and (lock := _locked(path)) is not None:
                _Pending.unfinished[path] = lock
                _remove(path)


def _vanish() -> None:
    discard()
    for folder in list(_Pending.temporary):
        shutil.rmtree(folder, ignore_errors=True)


interrupts.at_end(_vanish)
