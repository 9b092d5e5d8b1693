"""Hand-ins: what a student did, run again on another machine, and what was forged."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from upright.lab.desk import InlineDesk
from upright.lab.handin import read_hand_in
from upright.lab.messages import Change, Drag, Made, Notice, Save, Setup, StandUp, Steer, Strike
from upright.lab.plant import COARSE
from upright.lab.rerun import rerun
from upright.lab.session import Session

MODEL = Setup(bodies=("nonlinear",), seed=7)


def a_run(folder: Path, setup: Setup = MODEL, student: str = "Ana", seconds: float = 4.0) -> Path:
    """What a student does: some seconds that do not count, then Stand up, a knock, a drag, and the hand-in."""
    desk = InlineDesk()
    session = Session(setup, desk, folder, fine=COARSE, certified=False)
    for (_, job), status, result in desk.poll():
        session.reported(job, status, result)
    session.handle(Strike("impulse", 0.05))
    session.handle(Steer(0.1, 0.5))
    session.advance(0.7)
    session.handle(StandUp(0.05))
    session.advance(0.5)
    session.handle(Strike("impulse", 0.1))
    session.advance(1.0)
    session.handle(Drag(0.3, 0.1))
    session.advance(0.3)
    session.handle(Drag(0.0, 0.0))
    while session.result().seconds < seconds - 0.02:
        session.advance(0.1)
    session.handle(Save("handin", student))
    for (_, job), status, result in desk.poll():
        session.reported(job, status, result)
    events = session.events()
    assert [event.text for event in events if isinstance(event, Notice)] == []
    made = [event for event in events if isinstance(event, Made)]
    return (folder / made[-1].name).rename(folder / f"{student}.json")


@pytest.mark.parametrize("controller", ["lqg", "pid"])
def test_a_hand_in_runs_again_as_it_was(tmp_path, controller):
    """To the last digit on the machine where it was made; `pid` is designed beside the loop."""
    done = read_hand_in(a_run(tmp_path, replace(MODEL, controller=controller)))
    assert done.sealed
    assert done.student == "Ana"
    assert [type(action).__name__ for _, action in done.actions] == ["Steer", "Strike", "Drag", "Drag"]
    assert [t for t, _ in done.actions] == pytest.approx([0.0, 0.5, 1.5, 1.8], abs=0.011)  # a period
    assert rerun(done) == done.claimed


def test_after_a_change_there_is_nothing_to_hand_in(tmp_path):
    """A run whose set-up was changed on its way cannot be run again from its beginning."""
    desk = InlineDesk()
    session = Session(MODEL, desk, tmp_path, fine=COARSE, certified=False)
    session.handle(StandUp(0.0))
    session.advance(0.5)
    session.handle(Change(replace(MODEL, slope=0.02)))
    session.advance(0.5)
    session.handle(Save("handin", "Ana"))
    (notice,) = [event for event in session.events() if isinstance(event, Notice)]
    assert "Stand up" in notice.text
