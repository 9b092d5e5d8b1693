"""Files that a page sends: limited in size and number, under a safe name, in the session's own folder."""

from __future__ import annotations

import asyncio
import re
import shutil
import threading
from collections.abc import AsyncGenerator, AsyncIterator, Generator
from contextlib import ExitStack, asynccontextmanager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from upright.atomic import writing
from upright.errors import UprightError
from upright.pages import Quantity, Say

LARGEST = 32 * 1024 * 1024
"""Bytes of a file: an hour of raw sensors at 100 Hz is a third of it."""

MOST_FILES = 20

SPARED = 1 << 30
"""[bytes] of the disk that files from pages leave free."""

PATIENCE = 120.0
"""[s] in which a file must have arrived."""

_COUNTING = threading.Lock()
"""Held from the count of a folder's files until there is one more."""

SUFFIXES = {
    "log": {".csv", ".txt", ".log", ".tsv", ".dat", ".json", ".mat", ".parquet", ".mcap"},
    "robot": {".toml"},
}


@dataclass(frozen=True)
class Uploaded:
    """A file of kind `what` that lies at `path` in the session's folder: the server tells the session so."""

    what: str
    path: str


class UploadRefused(UprightError):
    """A file of a wrong kind, or one too many."""


class TooLarge(UploadRefused):
    """A file that is too large."""


def safe_name(name: str, what: str) -> str:
    """The last part of `name`, of letters, digits, dots and dashes; raises `UploadRefused` for a wrong kind."""
    if what not in SUFFIXES:
        raise UploadRefused(f"a file of kind '{what[:20]}'", expected=", ".join(SUFFIXES))
    last = re.sub(r"[^A-Za-z0-9._-]+", "_", name.replace("\\", "/").rpartition("/")[2]).lstrip("._-")[-60:]
    stem, dot, suffix = last.rpartition(".")
    if not (stem and dot) or f".{suffix.lower()}" not in SUFFIXES[what]:
        endings = Say("one that ends in {endings}", endings=sorted(SUFFIXES[what]))
        raise UploadRefused(Say("the file {name}", name=last), expected=endings)
    return f"in-{stem}.{suffix.lower()}"


async def receive(chunks: AsyncIterator[bytes], folder: Path, name: str, what: str) -> Path:
    """Write what arrives into `folder`, which is made where it is missing; nothing of a file that is refused stays.

    A disk may take seconds, so the server's loop waits for none: everything that touches one runs in a thread.
    """
    target = folder / safe_name(name, what)
    size = 0
    try:
        async with asyncio.timeout(PATIENCE), _filled(target) as stream:
            async for chunk in chunks:
                size += len(chunk)
                if size > LARGEST:
                    most = Say("{name} is larger than {size} MB", name=name[:60], size=LARGEST >> 20)
                    raise TooLarge(most, hint=Say("cut it, or use the terminal"))
                await asyncio.to_thread(stream.write, chunk)
    except TimeoutError:
        overdue = Say("{name} did not arrive within {time}", name=name[:60], time=Quantity(PATIENCE, "s"))
        raise UploadRefused(overdue, hint=Say("send it again")) from None
    except UploadRefused:
        raise
    except (OSError, UprightError):
        why = Say("{name} could not be kept", name=name[:60])
        raise UploadRefused(why, likely=Say("a session that has ended, or a full disk")) from None
    return target


@contextmanager
def _admitted(target: Path) -> Generator[BinaryIO]:
    """`writing`, where there is room for one more file."""
    target.parent.mkdir(mode=0o700, exist_ok=True)
    with ExitStack() as stack:
        with _COUNTING:
            if len(list(target.parent.iterdir())) - target.exists() >= MOST_FILES:
                many = Say("{n} files lie here already", n=MOST_FILES)
                raise UploadRefused(many, hint=Say("reload the page without its session"))
            if shutil.disk_usage(target.parent).free < SPARED + LARGEST:
                raise UploadRefused(Say("the disk of this lab is nearly full"), hint=Say("tell whoever started it"))
            stream = stack.enter_context(writing(target))
        yield stream


@asynccontextmanager
async def _filled(target: Path) -> AsyncGenerator[BinaryIO]:
    """`_admitted`, entered and left in a thread."""
    manager = _admitted(target)
    stream = await asyncio.to_thread(manager.__enter__)
    try:
        yield stream
    except BaseException as error:
        await asyncio.to_thread(manager.__exit__, type(error), error, error.__traceback__)
        raise
    await asyncio.to_thread(manager.__exit__, None, None, None)
