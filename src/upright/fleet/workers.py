"""Work on Dask: a cluster made here for as long as it is needed, or one at an address."""

from __future__ import annotations

import logging
import os
import signal
from collections.abc import Callable, Generator, Iterable
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import Any, TypeVar

from upright.atomic import TemporaryFolder
from upright.errors import MissingTool, UprightError

T = TypeVar("T")

FAILURES = 3
"""How often the worker of one piece may die before the piece is given up: a worker may also die of another cause."""


def run_all(work: Iterable[T], submit: Callable[[Any, T], Any], keep: Callable[[T, Any], None], client: Any) -> None:
    """`submit(client, piece)` each piece of `work` and hand its result to `keep` as it comes; a few for each worker are
    under way at a time, so that a long list costs no memory. A dead worker's pieces go to another one.

    Raises `UprightError` for a piece that kills its workers, and whatever the work itself raises.
    """
    from distributed import KilledWorker, as_completed

    waiting, running = iter(work), dict[Any, T]()

    def following() -> list[Any]:
        piece = next(waiting, None)
        if piece is None:
            return []
        future = submit(client, piece)
        running[future] = piece
        return [future]

    ahead = 2 * max(1, sum(client.nthreads().values())) + 2
    results = as_completed([future for _ in range(ahead) for future in following()])
    for future in results:
        piece = running.pop(future)
        try:
            keep(piece, future.result())
        except KilledWorker:
            raise UprightError(
                f"{piece} killed its worker {FAILURES + 1} times", likely="too little memory for a chunk",
                hint="make chunks smaller",
            ) from None  # fmt: skip
        results.update(following())


@contextmanager
def connected(workers: int | None = None, cluster: str | None = None) -> Generator[Any]:
    """A client of the scheduler at the address `cluster`, or of `workers` processes made here (None: one a processor).

    Raises `MissingTool` where Dask is not installed, `UprightError` where no scheduler answers.
    """
    try:
        import dask.config
        import distributed
    except ImportError:
        raise MissingTool("Dask is not installed", hint="pip install distributed, or use no workers") from None
    with dask.config.set({"distributed.scheduler.allowed-failures": FAILURES}):
        if cluster is not None:
            with _client_of(cluster) as client:
                yield client
            return
        count = workers or os.cpu_count() or 1
        quiet: dict[str, Any] = {"dashboard_address": None, "silence_logs": logging.CRITICAL}
        with TemporaryFolder() as folder, dask.config.set({"temporary-directory": folder}):
            with _not_interrupted():
                started = distributed.LocalCluster(n_workers=count, threads_per_worker=1, processes=True, **quiet)
            with started as local, distributed.Client(local) as client:
                yield client


@contextmanager
def _not_interrupted() -> Generator[None]:
    """Threads and processes that start here never get SIGINT: a terminal sends Ctrl-C to all, and a worker that is
    just importing would print a traceback. This process gets it by another thread, and ends them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # the first process that is spawned starts it, and then unblocks signals
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _client_of(address: str) -> Any:
    import distributed

    try:
        return distributed.Client(address, timeout=5)
    except (OSError, ValueError) as error:
        raise UprightError(
            f"no scheduler answers at {address} ({type(error).__name__})", expected="such as tcp://host:8786",
            hint="start one: dask scheduler",
        ) from None  # fmt: skip
