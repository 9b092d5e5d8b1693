"""Files that appear whole or not at all, and folders that vanish with the process that made them.

Everything this package writes is written here. An output is filled in a folder beside its place and moved there; a link
is followed, and an older file's mode kept; a pipe or a device gets the bytes once there are all of them.
"""

from __future__ import annotations

import errno
import json
import math
import os
import platform
import shutil
import stat
import sys
import tempfile
from collections.abc import Generator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any, BinaryIO

from upright import interrupts
from upright.errors import UprightError

_OURS = f".upright-{platform.node()}-"
"""How the name of every temporary folder of this machine begins, before its process."""


class TemporaryFolder(tempfile.TemporaryDirectory[str]):
    """A folder, at `path`, that vanishes with this process unless that is killed; files in it appear at once.

    It is made beside a file, since only within one file system is a move a single step, or among temporary files. Its
    name has those of the machine and the process, so that the next one there removes what a killed one has left.
    """

    def __init__(self, beside: Path | None = None) -> None:
        parent = None if beside is None or _is_stream(beside) else beside.parent
        _remove_left(Path(tempfile.gettempdir()) if parent is None else parent)
        super().__init__(prefix=f"{_OURS}{os.getpid()}-", dir=parent, ignore_cleanup_errors=True)
        self.path = Path(os.path.realpath(self.name))
        _Run.folders.add(self.path)

    def cleanup(self) -> None:
        super().cleanup()
        _Run.folders.discard(self.path)


class _Run:
    """What this process has begun: `folders` that vanish with it, outputs that are `waiting` for the end of `together`
    with their places (None: they appear at once), and folders `made` for them."""

    folders: set[Path] = set()  # noqa: RUF012 (there is one process)
    waiting: list[tuple[TemporaryFolder, Path]] | None = None
    made: list[Path] = []  # noqa: RUF012


def place_of(name: str | Path, *, folder: bool = False) -> Path:
    """Where the links of a name lead, or the name itself of a pipe or a device, which a path may not lead to.

    Raises `UprightError` where no file, or no `folder`, can be written.
    """
    path = _expanded(name)
    if str(path).startswith("--"):
        raise UprightError(f"{path.parts[0]} looks like an option", expected="the name of a file or folder")
    with _reported(path):
        mode, stream = _mode(path), _is_stream(path)
    if mode and not (stat.S_ISDIR(mode) if folder else stat.S_ISREG(mode) or stream):
        kind = "folder" if folder else "file"
        came = "a folder" if stat.S_ISDIR(mode) else f"no {kind}"
        raise UprightError(f"{path} is {came}", expected=f"the name of a {kind}")
    place = path if stream else Path(os.path.realpath(path))
    if not place.parent.is_dir():
        raise UprightError(f"there is no folder {path.parent} for {path.name}", hint=f"mkdir -p {path.parent}")
    needed = [path] if stream else [place.parent, *[place] * bool(mode)]
    if not all(os.access(needs, os.W_OK) for needs in needed):
        raise UprightError(f"cannot write {path}: Permission denied", hint="choose a place that can be written")
    return place


def _is_stream(path: Path) -> bool:
    """Whether bytes do not stay there: a pipe, a device (but no disk), or the file that stdout is redirected to, which
    has what was printed."""
    mode = _mode(path)
    return stat.S_ISFIFO(mode) or stat.S_ISCHR(mode) or _is_stdout(path)


def _is_stdout(path: Path) -> bool:
    return sys.stdout is not None and path.exists() and os.path.samestat(path.stat(), os.fstat(1))


@contextmanager
def writing(target: str | Path, *, at_once: bool = False) -> Generator[BinaryIO]:
    """A stream whose bytes are at `target` when this ends, or at the end of `together` unless `at_once`. A failure
    leaves an older file as it was.

    Raises `UprightError` where that cannot be done, and `KeyboardInterrupt` in an interrupted run.
    """
    with filling(target, at_once=at_once) as path, path.open("xb") as file:
        yield file


@contextmanager
def filling(target: str | Path, *, folder: bool = False, at_once: bool = False) -> Generator[Path]:
    """The name of a file, or of a `folder`, to be made, which replaces what is at `target`; as `writing`."""
    place = place_of(target, folder=folder)
    interrupts.check()
    with _reported(target):
        scratch = TemporaryFolder(place)
        try:
            yield scratch.path / "new"
        except BaseException:
            scratch.cleanup()
            raise
        within = not _Run.folders.isdisjoint(place.parents)  # a temporary folder
        if _Run.waiting is None or at_once or within or interrupts.Run.lasting:
            interrupts.check()
            _arrive(scratch, place)
        else:
            _Run.waiting.append((scratch, place))


def make_folder(target: str | Path) -> Path:
    """A folder, made where it is missing, and removed again where the run fails before there is anything in it."""
    path = _expanded(target)
    missing = [p for p in (path, *path.parents) if not os.path.lexists(p)]
    with _reported(path):
        path.mkdir(parents=True, exist_ok=True)
    if _Run.waiting is not None:
        _Run.made += missing
    return path


@contextmanager
def together() -> Generator[None]:
    """All files that are written inside appear at the end; after an error, or in an interrupted run, none.

    One inside another is a step of a longer run: its files appear at its own end.
    """
    around = _Run.waiting
    waiting = _Run.waiting = []
    try:
        yield
        for scratch, place in waiting:  # streams first, since one may wait for a reader, and be interrupted
            if _is_stream(place):
                _arrive(scratch, place)
        if around is None:
            interrupts.complete()
        else:
            interrupts.check()
        for scratch, place in waiting:
            if not _is_stream(place):
                _arrive(scratch, place)
    finally:
        _Run.waiting = around
        for scratch, _ in waiting:
            scratch.cleanup()
        _remove_made()


def write_bytes(target: str | Path, data: bytes, *, at_once: bool = False) -> Path:
    """Write `data`, whole or not at all, and return the path; as `writing`."""
    with writing(target, at_once=at_once) as stream:
        stream.write(data)
    return _expanded(target)


def write_text(target: str | Path, text: str, *, at_once: bool = False) -> Path:
    """Write `text` as UTF-8, whole or not at all; as `writing`."""
    return write_bytes(target, text.encode("utf-8", "replace"), at_once=at_once)


def json_text(data: Any, encoding: str = "utf-8") -> str:
    """Indented JSON, in ASCII for another encoding than UTF-8; NaN and infinity, which JSON does not have, are an error
    of the caller."""
    return json.dumps(data, indent=2, ensure_ascii=encoding.lower() != "utf-8", allow_nan=False)


def write_json(target: str | Path, data: Any, *, at_once: bool = False) -> Path:
    """Write JSON, whole or not at all; as `writing`."""
    return write_text(target, json_text(data) + "\n", at_once=at_once)


def finite(value: Any) -> Any:
    """The value, or None for a number that JSON does not have: NaN and infinity."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _arrive(scratch: TemporaryFolder, place: Path) -> None:
    """Move what is complete to its place."""
    new = scratch.path / "new"
    with scratch, _reported(place):
        if _is_stream(place):
            print(end="", flush=True)
            with new.open("rb") as source, open(os.dup(1) if _is_stdout(place) else place, "wb") as stream:
                shutil.copyfileobj(source, stream)
            return
        if place.is_dir():
            os.replace(place, scratch.path / "old")  # a folder replaces none that is not empty
        elif place.exists():
            shutil.copymode(place, new)
        os.replace(new, place)


def _expanded(name: str | Path) -> Path:
    return Path(os.path.expanduser(name))  # which leaves a home that does not exist as it is


def _mode(path: Path) -> int:
    """The mode of what a name leads to; 0 where there is nothing."""
    try:
        return path.stat().st_mode
    except FileNotFoundError:
        return 0


@contextmanager
def _reported(path: str | Path) -> Generator[None]:
    try:
        yield
    except OSError as error:
        if error.errno is None:
            raise  # a time limit of whoever writes
        hint = "make room, then run it again" if error.errno == errno.ENOSPC else "choose a place that can be written"
        raise UprightError(f"cannot write {path}: {error.strerror}", hint=hint) from None


def _remove_made() -> None:
    for path in _Run.made:
        with suppress(OSError):
            path.rmdir()
    _Run.made.clear()


def _remove_left(parent: Path) -> None:
    """Remove the temporary folders in `parent` whose process is no more."""
    if os.name != "posix":
        return  # where asking for a process may end it
    with suppress(OSError):  # a folder may be written that may not be read
        for name in os.listdir(parent):
            process = name.removeprefix(_OURS).partition("-")[0]
            if name.startswith(_OURS) and process.isdecimal() and not _runs(int(process)):
                shutil.rmtree(parent / name, ignore_errors=True)


def _runs(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (PermissionError, OverflowError):
        return True  # of another user, or no process's number
    return True


def _vanish() -> None:
    for folder in list(_Run.folders):
        shutil.rmtree(folder, ignore_errors=True)
    _remove_made()


interrupts.Run.end += (_vanish,)
