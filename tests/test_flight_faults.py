"""Whatever goes wrong in a flight: the motors are off or the user is told, and the log is kept where it can be."""

from __future__ import annotations

import asyncio
import random
from collections.abc import Callable
from contextlib import suppress
from functools import wraps

import pytest

from conftest import PATIENCE
from planted.abuse import flights as abuse_flights

Test = Callable[..., None]


def patiently(test: Test) -> Test:
    """The test, with more patience for an answer where it fails: a busy machine may not answer in the first of them,
    and what is wrong is so with all."""

    @wraps(test)
    def tried(**given: str) -> None:
        for patience in (abuse_flights.PATIENCE, 10.0):
            with pytest.MonkeyPatch.context() as patch, suppress(AssertionError, AttributeError):
                patch.setattr(abuse_flights, "PATIENCE", patience)
                return test(**given)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(abuse_flights, "PATIENCE", 60.0)
            return test(**given)

    return tried


pytestmark = pytest.mark.needs("nbc", "module:nxt", "module:pybricksdev", "module:micropython_unix")


@pytest.mark.parametrize(
    ("moment", "fault"),
    [
        ("start", "refused"),
        ("start", "lost reply"),
        ("running", "garbled"),
        ("running", "Ctrl-C"),
        ("stop", "busy twice"),
        ("stop", "lost reply"),
        ("fetch", "refused"),
    ],
)
@patiently
def test_one_fault_on_the_line_to_a_brick_leaves_it_stopped_and_its_log_here(moment: str, fault: str) -> None:
    outcome = abuse_flights.on_brick(fault, moment)
    assert outcome.off
    assert outcome.flight is not None or not outcome.drove
    assert not outcome.drove or outcome.flight.log is not None
    assert outcome.wrong == ""


@pytest.mark.parametrize("fault", ["refused for ever", "garbled for ever", "cable out"])
@patiently
def test_who_could_not_stop_a_brick_says_so(fault: str) -> None:
    outcome = abuse_flights.on_brick(fault, "stop")
    assert outcome.off is (fault == "garbled for ever")  # which it obeyed
    assert outcome.flight.notes[0].startswith("motors may be running: ")
    assert "stops after 60 s at most" in outcome.flight.notes[0]
    assert outcome.flight.lost


@patiently
def test_a_brick_that_never_began_is_no_flight() -> None:
    outcome = abuse_flights.on_brick("wrong file", "start")
    assert (outcome.drove, outcome.off, outcome.flight) == (False, True, None)
    assert "refused 'start'" in str(outcome.error)


@pytest.mark.parametrize(
    ("moment", "fault"),
    [
        ("start", "refused"),
        ("start", "lost reply"),
        ("stop", "refused"),
        ("stop", "wrong answer twice"),
        ("stop", "Ctrl-C"),
    ],
)
@patiently
def test_one_fault_on_the_line_to_a_hub_leaves_it_stopped_and_its_log_here(moment: str, fault: str) -> None:
    outcome = abuse_flights.on_hub(fault, moment)
    assert outcome.off
    assert outcome.wrong == ""
    assert not (outcome.drove and moment == "stop") or outcome.flight.log is not None


@pytest.mark.parametrize("fault", ["refused for ever", "out of reach", "deaf to a stop"])
@patiently
def test_who_could_not_stop_a_hub_says_so(fault: str) -> None:
    moment = "running" if fault == "deaf to a stop" else "stop"
    outcome = abuse_flights.on_hub(fault, moment)
    assert any(note.startswith("motors may be running: ") for note in outcome.flight.notes)
    assert outcome.flight.lost


@patiently
def test_a_part_of_benchmarks_abuse_flights() -> None:
    """The whole is: python benchmarks/abuse.py flights."""
    faults = random.Random(14).sample(abuse_flights.cases(), 3)
    assert {case: complaint for case in faults if (complaint := abuse_flights.wrong(*case))} == {}


def test_a_program_that_ended_before_anybody_looked_is_not_waited_for() -> None:
    """Its last news came while its start was confirmed, so that no other follows; the flight's clock stands still."""
    from upright.flight.fly_hub import _watch

    class Ended:
        running, begun, lost, patience, lines = False, True, False, 1.0, ()

        async def news(self, timeout: float) -> bool:
            await asyncio.sleep(timeout)
            return False

    asyncio.run(asyncio.wait_for(_watch(Ended(), 10.0, None, lambda: 0.0), PATIENCE))
