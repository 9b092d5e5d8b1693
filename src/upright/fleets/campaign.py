"""Fleets larger than memory, or than one machine: cut into chunks, run anywhere, resumed from the chunks on disk.

A chunk's file depends on the campaign alone: every robot draws from its own streams, so that one process, many, or many
of which some were killed write the same bytes. A chunk is on disk whole or not at all, and is not run twice.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from upright.atomic import make_folder, place_of, write_bytes, write_json
from upright.errors import InvalidScenario, SpecMismatch, require
from upright.fleets.cases import Cases
from upright.fleets.ensemble import OUTCOMES, Ensemble
from upright.fleets.results import labelled, load, unit_of, write_parquet
from upright.fleets.tally import tally
from upright.fleets.unfinished import stoppable
from upright.fleets.workers import connected, run_all
from upright.progress import Progress, unwatched

if TYPE_CHECKING:
    from xarray import Dataset

CHUNK = 16384
"""Robots in a chunk: some seconds of work and about a megabyte of result, so that neither start nor loss costs much."""

_PLAN, _CHUNKS = "plan.json", "chunks"
_CHECKSUM = hashlib.sha256().digest_size


@dataclass(frozen=True, eq=False)
class Case:
    """One point of a campaign: its `labels`, and robots 0 to `n` − 1 of an ensemble."""

    labels: Mapping[str, str | float]
    ensemble: Ensemble
    n: int


class Chunk(NamedTuple):
    """Robots `start` to `stop` − 1 of case number `case`; chunk `number` of the campaign."""

    number: int
    case: int
    start: int
    stop: int


@dataclass(frozen=True, eq=False)
class Campaign:
    """Cases in chunks of `chunk` robots; `keep` names the columns to be written (empty: all).

    A robot's parameters can be drawn again from the seed, so `keep=("fell",)` loses no information about them.
    """

    cases: tuple[Case, ...]
    chunk: int = CHUNK
    keep: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if not self.cases or any(case.n < 1 for case in self.cases) or self.chunk < 1:
            raise InvalidScenario("a campaign without robots", expected="one case or more, one robot or more in each")
        for case in self.cases:
            known = {*case.ensemble.family.names, *OUTCOMES}
            if strangers := set(self.keep) - known:
                raise InvalidScenario(f"keep = '{strangers.pop()}'", expected="some of " + ", ".join(sorted(known)))

    def chunks(self) -> Iterator[Chunk]:
        """All chunks, by number."""
        number = 0
        for index, case in enumerate(self.cases):
            for start in range(0, case.n, self.chunk):
                yield Chunk(number, index, start, min(case.n, start + self.chunk))
                number += 1

    def plan(self) -> dict[str, Any]:
        """Everything that determines the bytes of the chunks, as JSON."""
        cases = [{"labels": dict(c.labels), "n": c.n, "origin": c.ensemble.origin()} for c in self.cases]
        return {"chunk": self.chunk, "keep": list(self.keep), "pyarrow": version("pyarrow"), "cases": cases}

    def part(self, chunk: Chunk) -> tuple[Any, ...]:
        """What `run_part` takes to make the chunk's file."""
        return self.cases[chunk.case].ensemble, chunk.start, chunk.stop, self.keep, _versions()


def run_campaign(
    campaign: Campaign,
    folder: str | Path,
    *,
    workers: int | None = None,
    cluster: str | None = None,
    progress: Progress | None = None,
) -> Cases:
    """Run what `folder` lacks of the campaign, and summarise.

    `cluster` is a Dask scheduler's address; without one, `workers` processes on this machine (None: one a processor),
    or with 0 this process alone. `progress` is called with the fraction on disk. Ctrl-C raises `interrupts.Stopped`,
    whose `result` is that of the chunks on disk. Raises `InvalidScenario` where the folder holds another campaign,
    `UprightError` for a chunk that kills its workers, `MissingTool` for an address where Dask is not installed.
    """
    if cluster is not None:
        require("--cluster", "distributed")
    place = Path(os.path.expanduser(folder))
    plan = json.loads(json.dumps(campaign.plan()))
    digest = _digest(plan)
    _check_folder(place, digest)
    todo: list[Chunk] = []
    done: list[Chunk] = []
    for chunk in campaign.chunks():
        (done if _there(place, chunk.number, digest) else todo).append(chunk)
    total = len(done) + len(todo)
    show = progress or unwatched
    show(len(done) / total)

    def keep(chunk: Chunk, data: bytes) -> None:
        if not (place / _PLAN).exists():  # not before there is a result: a faulty plan leaves nothing
            make_folder(place / _CHUNKS)
            write_json(place / _PLAN, plan, at_once=True)
        write_bytes(chunk_path(place, chunk.number), _sealed(data, digest, chunk.number), at_once=True)
        done.append(chunk)
        show(len(done) / total)

    with stoppable(lambda: summaries(campaign, place, done) if done else None):
        if todo and workers == 0 and cluster is None:
            for chunk in todo:
                keep(chunk, run_part(*campaign.part(chunk), threads=None))
        elif todo:
            with connected(workers, cluster) as all_workers:
                run_all(todo, lambda worker, chunk: worker.submit(run_part, *campaign.part(chunk)), keep, all_workers)
    return summaries(campaign, place, done)


def summaries(campaign: Campaign, folder: Path, done: Iterable[Chunk]) -> Cases:
    """One summary for each case, of its chunks that are `done`; a case without any is left out."""
    chunks: dict[int, list[Chunk]] = {}
    for chunk in sorted(done):
        chunks.setdefault(chunk.case, []).append(chunk)
    begun = [campaign.cases[number] for number in chunks]
    robots = [sum(chunk.stop - chunk.start for chunk in some) for some in chunks.values()]
    paths = [[chunk_path(folder, chunk.number) for chunk in some] for some in chunks.values()]
    cases = Cases(tally(case.labels, n, files) for case, n, files in zip(begun, robots, paths, strict=True))
    asked = sum(case.n for case in campaign.cases)
    cases.unfinished = {"robots": sum(robots), "of": asked} if sum(robots) < asked else None
    cases.origins = [case.ensemble.origin() for case in begun]
    origin = cases.origins[0]
    family = begun[0].ensemble.family
    cases.spreads = (origin.get("vary") or {}).get("spreads", ())
    numbers = {*family.names, *(n for case in cases for n, value in case.labels.items() if not isinstance(value, str))}
    cases.units = {name: unit_of(name, family) for name in numbers}
    return cases


def run_part(
    ensemble: Ensemble, start: int, stop: int, keep: Sequence[str], versions: Mapping[str, str], threads: int | None = 1
) -> bytes:
    """Robots `start` to `stop` − 1 as the bytes of a Parquet file; `SpecMismatch` where a worker's versions differ."""
    if (mine := _versions()) != dict(versions):
        raise SpecMismatch(
            f"a worker has {mine}", expected=f"{dict(versions)}, as here", hint="install the same versions"
        )
    index = range(start, stop)
    columns = ensemble.run(index, threads)
    data = labelled({n: v for n, v in columns.items() if not keep or n in keep}, index, ensemble)
    stream = io.BytesIO()
    write_parquet(data, stream)
    return stream.getvalue()


def chunk_path(folder: Path, number: int) -> Path:
    """Where a chunk's file is."""
    return folder / _CHUNKS / f"{number:08d}.parquet"


def collect(folder: str | Path) -> Dataset:
    """All runs of a finished campaign in one dataset, with each one's `case` by number; they must fit into memory."""
    import xarray as xr

    place = Path(os.path.expanduser(folder))
    plan = _read_plan(place)
    digest = _digest(plan)
    parts: list[Any] = []
    number = 0
    for index, case in enumerate(plan["cases"]):
        for _ in range(0, case["n"], plan["chunk"]):
            if not _there(place, number, digest):
                raise InvalidScenario(f"{folder} lacks chunk {number}", hint="run the campaign again: it resumes")
            part = load(chunk_path(place, number))
            parts.append(part.assign(case=("robot", np.full(part.sizes["robot"], index), {"unit": "1"})))
            number += 1
    data = xr.concat(parts, "robot", data_vars="all", coords="minimal", compat="override", join="outer")
    return data.assign_attrs(origin=json.dumps(plan, ensure_ascii=False))


def _check_folder(folder: Path, digest: str) -> None:
    """Refuse a folder that cannot be made or written, one with a name that Parquet's reader cannot open, and one that
    holds the results of another campaign."""
    if any("\ud800" <= letter <= "\udfff" for letter in str(folder)):
        raise InvalidScenario(f"the folder {str(folder)!r}", expected="a name in UTF-8", hint="another name")
    place_of(next(path for path in (folder, *folder.parents) if path.exists()) / "any")
    if (folder / _PLAN).exists() and _digest(_read_plan(folder)) != digest:
        raise InvalidScenario(
            f"{folder} holds another campaign", expected="the same robots, controllers, seeds and versions to resume",
            hint="choose another folder, or remove this one",
        )  # fmt: skip


def _read_plan(folder: Path) -> dict[str, Any]:
    try:
        return json.loads((folder / _PLAN).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise InvalidScenario(
            f"{folder} holds no campaign ({type(error).__name__})", expected="a folder of upright sweep"
        ) from None


def _digest(plan: Mapping[str, Any]) -> str:
    return hashlib.sha256(json.dumps(plan, sort_keys=True).encode()).hexdigest()


def _versions() -> dict[str, str]:
    return {name: version(name) for name in ("upright", "numpy", "numba", "pyarrow")}


def _sealed(data: bytes, digest: str, number: int) -> bytes:
    """A chunk's file with the checksum of its bytes, its plan and its number, before the footer, where no reader of
    Parquet looks."""
    at = _footer(data)
    return data[:at] + _checksum(data, digest, number) + data[at:]


def _there(folder: Path, number: int, digest: str) -> bool:
    """Whether this chunk of the plan is there, as it was written."""
    try:
        data = chunk_path(folder, number).read_bytes()
    except OSError:
        return False
    at = _footer(data)
    start = max(0, at - _CHECKSUM)
    return data[start:at] == _checksum(data[:start] + data[at:], digest, number)


def _footer(data: bytes) -> int:
    """Where the footer of a Parquet file begins: before it ends with its own length and the format's name."""
    return max(0, len(data) - 8 - int.from_bytes(data[-8:-4], "little"))


def _checksum(data: bytes, digest: str, number: int) -> bytes:
    return hashlib.sha256(f"{digest} {number} ".encode() + data).digest()
