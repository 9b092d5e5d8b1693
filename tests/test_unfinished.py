"""Ctrl-C in a long computation leaves the result of what was done before, which says so, and the exit code 130."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import upright.kernel.simulate as kernel
from upright import interrupts
from upright.cli.main import main
from upright.fleets import fleet as fleets
from upright.fleets import push_map
from upright.fleets.results import load
from upright.fleets.unfinished import coarse_first

FLEET = "fleet -n 30 -s 1 -p impulse:0.2 --vary com_height=±10%"
BASIN = "basin --points 10 --watch 1"
MAP = "push-map --points 7 -n 3 --watch 1"


@pytest.fixture(autouse=True)
def _state() -> Iterator[None]:
    yield
    interrupts.reset()


def stopped_at(monkeypatch: pytest.MonkeyPatch, owner: Any, name: str, call: int) -> None:
    """Ctrl-C in that call of a function, the first being 1."""
    calls = [0]
    function = getattr(owner, name)

    def counted(*given: Any, **settings: Any) -> Any:
        calls[0] += 1
        if calls[0] == call:
            raise KeyboardInterrupt
        return function(*given, **settings)

    monkeypatch.setattr(owner, name, counted)


def ran(command: str, capsys: pytest.CaptureFixture[str]) -> tuple[int, Any]:
    code = main([*command.split(), "-o", "data.parquet", "--json"])
    out = capsys.readouterr().out
    return code, json.loads(out) if out else None


@pytest.fixture
def here(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_stopped_fleet_is_the_fleet_of_its_first_robots(here, monkeypatch, capsys):
    monkeypatch.setattr(fleets, "CHUNK", 10)
    whole = ran(FLEET, capsys)[1]
    everyone = load("data.parquet")
    assert "unfinished" not in whole["origin"]
    stopped_at(monkeypatch, kernel, "simulate", 3)
    code, part = ran(FLEET, capsys)
    data = load("data.parquet")
    assert code == 130
    assert part["n"] == 20
    assert part["origin"]["unfinished"] == {"robots": 20, "of": 30}
    assert part["head"]["verdict"] == {"text": "unfinished: 20 of 30 robots", "level": "unknown"}
    for name in everyone.data_vars:
        np.testing.assert_array_equal(data[name].values, everyone[name].values[:20])


@pytest.mark.parametrize(
    ("command", "where", "call", "part"),
    [
        (BASIN, (kernel, "simulate"), 3, {"points": 9 * 9, "of": 10 * 10}),
        (MAP, (push_map._Search, "first"), 2, {"points": 2 * 5 * 5, "of": 2 * 7 * 7}),
        # a search over 8 × 8 points, one over all, two of the three robots
        (MAP, (push_map._Search, "_find"), 5, {"robots": 2, "of": 3}),
    ],
    ids=["basin", "map", "band"],
)
def test_a_stopped_map_is_the_finest_that_is_whole(command, where, call, part, here, monkeypatch, capsys):
    """Where the part has a point, it has the whole's value."""
    monkeypatch.setattr(push_map, "_AT_ONCE", 1)  # one robot of the band after another
    assert ran(command, capsys)[0] == 0
    whole = load("data.parquet")
    stopped_at(monkeypatch, *where, call)
    code, result = ran(command, capsys)
    data = load("data.parquet")
    assert code == 130
    assert result["origin"]["unfinished"] == part
    assert result["head"]["verdict"]["text"].startswith("unfinished: ")
    for name in {"recovered", "settling", "impulse", "last"} & set(data.data_vars):
        np.testing.assert_array_equal(data[name], whole[name].sel({d: data[d] for d in data[name].dims}))
    assert ("low" in data) == ("robots" in part)


def test_what_follows_an_interrupt_is_announced_where_there_is_a_part(here, monkeypatch, capsys):
    """And a second run in the process is neither interrupted nor half."""
    monkeypatch.setattr(fleets, "CHUNK", 10)
    with monkeypatch.context() as during:
        stopped_at(during, kernel, "simulate", 3)
        assert main([*FLEET.split(), "--json"]) == 130
    assert capsys.readouterr().err.endswith("what is done so far:\n")
    interrupts.Run.number = 2
    assert main([*FLEET.split(), "--json"]) == 0


def test_what_is_stopped_before_anything_is_whole_leaves_nothing(here, monkeypatch, capsys):
    for command in (FLEET, BASIN, MAP):
        stopped_at(monkeypatch, kernel, "simulate", 1)
        assert main([*command.split(), "-o", "data.parquet", "--report", "page.html"]) == 130
        said = capsys.readouterr()
        assert (said.out, said.err) == ("", interrupts.STOPPED)
    assert list(here.iterdir()) == []


@pytest.mark.parametrize("counts", [(1,), (2, 3), (41, 41), (2, 64, 8)])
def test_every_point_of_a_grid_has_its_turn_once_and_a_grid_is_whole_after_each(counts):
    had = np.zeros(counts, dtype=bool)
    for rows, points in coarse_first(*counts):
        assert not had.reshape(-1)[points].any()
        had.reshape(-1)[points] = True
        assert had[np.ix_(*rows)].all()
        assert all({0, count - 1} <= set(some.tolist()) for some, count in zip(rows, counts, strict=True))
    assert had.all()
