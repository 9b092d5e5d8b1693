"""Work for several threads, whose results come in the order in which they were asked for."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import TypeVar

Thing = TypeVar("Thing")
Result = TypeVar("Result")


@contextmanager
def working(work: Callable[[Thing], Result], threads: int) -> Generator[Callable[[Iterable[Thing]], Iterator[Result]]]:
    """`work` of many things, so many at once. Where an exception ends this, what has not begun is given up, and what
    has is not waited for."""
    pool = ThreadPoolExecutor(threads)
    try:
        yield lambda things: pool.map(work, things)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
