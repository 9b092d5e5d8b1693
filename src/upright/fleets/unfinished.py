"""What Ctrl-C leaves of a fleet, a map, a basin or a campaign: a smaller one, which says of how much it is a part."""

from __future__ import annotations

import json
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from upright.arrays import Whole
from upright.interrupts import Stopped
from upright.pages import Page, Result, Say, Verdict

if TYPE_CHECKING:
    from xarray import Dataset


@contextmanager
def stoppable(so_far: Callable[[], Result | None]) -> Generator[None]:
    """Ctrl-C in here raises `Stopped` with what `so_far` makes of the part that is done, where there is one."""
    try:
        yield
    except KeyboardInterrupt:
        result = so_far()
        if result is None:
            raise
        raise Stopped(result) from None


def thinned(count: int, most: int) -> Whole:
    """At most `most` of `count` rows, evenly, the ends included."""
    return np.unique(np.rint(np.linspace(0, count - 1, max(1, min(most, count)))).astype(np.int64))


def coarse_first(*counts: int) -> Iterator[tuple[tuple[Whole, ...], Whole]]:
    """The points of a grid of `counts` in turns, so that after each a grid is whole, finer every time: its rows along
    each axis, and the numbers (new,) of its points that no turn before had."""
    had = np.zeros(counts, dtype=np.bool_)
    steps = 4  # of the first grid, which is soon done, and shows a border at all
    while not had.all():
        rows = tuple(thinned(count, steps + 1) for count in counts)
        grid = np.zeros(counts, dtype=np.bool_)
        grid[np.ix_(*rows)] = True
        yield rows, np.flatnonzero(grid & ~had)
        had |= grid
        steps *= 2


def marked(data: Dataset, what: Literal["robots", "points"], done: int, of: int) -> Dataset:
    """The data; of a part, with how many robots or points were `done` `of` those asked for in its origin."""
    if done == of:
        return data
    origin = json.loads(data.attrs["origin"]) | {"unfinished": {what: done, "of": of}}
    return data.assign_attrs(origin=json.dumps(origin, ensure_ascii=False))


def as_far(page: Page, origin: Mapping[str, Any]) -> Page:
    """The page; of a part, with a verdict that says so: what it would be of the whole is not known."""
    part = origin.get("unfinished")
    if not part:
        return page
    text = Say("unfinished: {points} of {of} points", **part)
    if "robots" in part:
        text = Say("unfinished: {robots} of {of} robots", **part)
    return replace(page, verdict=Verdict(text, "unknown"))
