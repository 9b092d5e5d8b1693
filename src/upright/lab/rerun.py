"""A hand-in is run again, without a page and without waiting for the clock."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from upright.errors import InvalidScenario
from upright.lab.desk import InlineDesk
from upright.lab.handin import HandIn, RunResult
from upright.lab.messages import StandUp, Step
from upright.lab.plant import EXPORTED, is_slow, plant_of
from upright.lab.session import Session
from upright.languages import ENGLISH

AT_ONCE = 1000  # periods that one message may ask for


def rerun(done: HandIn) -> RunResult:
    """What comes of the hand-in on this machine; raises an `UprightError` for a set-up that cannot be."""
    setup = replace(done.setup, bodies=done.setup.bodies[:1])
    desk = InlineDesk()
    # a page's controllers know the kit's own noise and dead time, whatever the page adds
    known = replace(setup, noise=1.0, delay=-1.0) if done.step == EXPORTED else setup
    session = Session(known, desk, Path(), fine=done.step, certified=False)
    try:
        if is_slow(setup.controller):
            _designed(session, desk)
        session.setup, session.plant = setup, plant_of(setup)
        session.handle(StandUp(done.lean))
        period = session.plant.kit.period
        gone = 0
        for t, action in (*done.actions, (done.seconds, None)):
            periods = round(min(t, done.seconds) / period) - gone
            for piece in (AT_ONCE,) * (periods // AT_ONCE) + (periods % AT_ONCE,):
                session.handle(Step(piece))
            gone += periods
            if action is not None:
                session.handle(action)
        return session.result()
    finally:
        session.close()


def _designed(session: Session, desk: InlineDesk) -> None:
    """A controller that takes long is designed at the desk."""
    for (_, job), status, result in desk.poll():
        if status == "failed":
            raise InvalidScenario(result[ENGLISH].came)
        if job == "design":
            controller, _ = result
            session.designed(controller)
