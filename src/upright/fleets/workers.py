"""Work for many processes: new ones on this machine for as long as they are needed, or those of a Dask scheduler."""

from __future__ import annotations

import multiprocessing
import os
import threading
from collections import Counter
from collections.abc import Callable, Generator, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any, Protocol, TypeVar

from upright.errors import UprightError
from upright.interrupts import without_ctrl_c

T = TypeVar("T")

FAILURES = 3
"""How often the worker of one piece may die before the piece is given up: a worker may also die of another cause."""


class Worker(Protocol):
    """What takes one piece after another."""

    def submit(self, work: Callable[..., Any], /, *given: Any) -> Future[Any]: ...


class Process:
    """One process, so that it is known which piece killed it; the next piece then gets a new one."""

    def __init__(self) -> None:
        self._pool = new_pool(1, end_with_parent)

    def submit(self, work: Callable[..., Any], /, *given: Any) -> Future[Any]:
        with without_ctrl_c():
            try:
                return self._pool.submit(work, *given)
            except BrokenProcessPool:
                self._pool = new_pool(1, end_with_parent)
                return self._pool.submit(work, *given)

    def end(self) -> None:
        """What has begun is not waited for."""
        self._pool.shutdown(wait=False, cancel_futures=True)


def new_pool(count: int, initializer: Callable[[], None]) -> ProcessPoolExecutor:
    """A pool of `count` new processes that each call `initializer` first; submit to it under `without_ctrl_c`."""
    with without_ctrl_c():
        return ProcessPoolExecutor(count, multiprocessing.get_context("spawn"), initializer=initializer)


def run_all(
    work: Iterable[T],
    submit: Callable[[Worker, T], Future[Any]],
    keep: Callable[[T, Any], None],
    workers: Sequence[Worker],
) -> None:
    """`submit(worker, piece)` each piece of `work` and hand its result to `keep` as it comes; as many as there are
    `workers` are under way at a time, so that a long list costs no memory. A dead worker's piece goes to a new one.

    Raises `UprightError` for a piece that kills its workers, and whatever the work itself raises.
    """
    waiting = iter(work)
    running = dict[Future[Any], tuple[Worker, T]]()
    deaths = Counter[T]()
    for worker, piece in zip(workers, waiting, strict=False):
        running[submit(worker, piece)] = worker, piece
    while running:
        for future in wait(running, return_when=FIRST_COMPLETED).done:
            worker, piece = running.pop(future)
            try:
                keep(piece, future.result())
                piece = next(waiting, None)
            except BrokenProcessPool:
                deaths[piece] += 1
                if deaths[piece] > FAILURES:
                    raise _deadly(f"{piece}") from None
            if piece is not None:
                running[submit(worker, piece)] = worker, piece


def _deadly(piece: str) -> UprightError:
    return UprightError(
        f"{piece} killed its worker {FAILURES + 1} times", likely="too little memory for a chunk",
        hint="make chunks smaller",
    )  # fmt: skip


@contextmanager
def connected(workers: int | None = None, cluster: str | None = None) -> Generator[Sequence[Worker]]:
    """Those of the scheduler at the address `cluster`, or so many processes made here (None: one a processor).

    Raises `UprightError` where no scheduler answers.
    """
    if cluster is not None:
        with _of_scheduler(cluster) as far:
            yield far
        return
    made = [Process() for _ in range(workers or os.cpu_count() or 1)]
    try:
        yield made
    finally:
        for process in made:
            process.end()


def end_with_parent() -> None:
    """A worker waits for work, and would for ever where its parent was killed."""
    parent = multiprocessing.parent_process()
    assert parent is not None

    def watch() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


@contextmanager
def _of_scheduler(address: str) -> Generator[Sequence[Worker]]:
    import distributed

    try:
        client: Any = distributed.Client(address, timeout=5)
    except (OSError, ValueError) as error:
        raise UprightError(
            f"no scheduler answers at {address} ({type(error).__name__})", expected="such as tcp://host:8786",
            hint="start one: dask scheduler",
        ) from None  # fmt: skip
    with client:
        # two a thread, so that none waits for the next piece
        ahead = 2 * max(1, sum(client.nthreads().values())) + 2
        try:
            yield [client.get_executor(pure=False)] * ahead
        except distributed.KilledWorker:
            raise _deadly("a chunk") from None
