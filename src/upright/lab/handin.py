"""A hand-in: what a student did to the robot, as set-up and actions, so that anybody can run it again."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from annotated_types import Interval, MaxLen

from upright.atomic import write_json
from upright.errors import InvalidScenario, UprightError, one_line
from upright.lab.codec import InvalidMessage, plain, validated
from upright.lab.message_types import STRICT
from upright.lab.messages import Drag, Setup, Steer, Strike
from upright.lab.plant import COARSE, EXPORTED, FINE
from upright.pages import Say
from upright.reading import parse_json, read_text
from upright.robots import Robot
from upright.signals import Log

if TYPE_CHECKING:
    from pydantic import TypeAdapter

KIND, VERSION = "upright hand-in", 1
LONGEST = 60.0
"""[s] of a run that is handed in."""

MOST_ACTIONS = 5000
"""Of one run: a mouse that is dragged for a minute makes two thousand."""

MOST_TEXT = 1 << 20
"""Characters of a file."""

LONGEST_NAME = 40

STEPS = (EXPORTED, FINE, COARSE)
"""[s] of a body's step: in a page without Python, alone, and in a class."""

Action = Drag | Steer | Strike
EXPECTED = "a hand-in, as the lab saves it under Keep"


class InvalidHandIn(UprightError):
    """A file that is no hand-in."""


class Unfit(UprightError, ValueError):
    """What a field of a hand-in cannot hold; pydantic tells a `ValueError` with the name of the field."""


@dataclass(frozen=True)
class Through:
    """A function through which pydantic passes a field on, and which returns it or raises `Unfit`."""

    check: Callable[[Any], Any]

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        from pydantic import AfterValidator  # slow to load

        return AfterValidator(self.check).__get_pydantic_core_schema__(source, handler)


def _named(student: str) -> str:
    name = student.strip()
    if not (name.isprintable() and 1 <= len(name) <= LONGEST_NAME):
        raise Unfit(f"no name of 1 to {LONGEST_NAME} letters")
    return name


def _can_be_run(setup: Setup) -> bool:
    return bool(setup.bodies) and setup.bodies[0] != "calibrated"


def _that_runs(setup: Setup) -> Setup:
    if not _can_be_run(setup):
        raise Unfit("its first body cannot be run again")
    return setup


def _known_step(step: float) -> float:
    if step not in STEPS:
        raise Unfit(f"none of the steps {', '.join(f'{one:g}' for one in STEPS)} s")
    return step


def _short_enough(seconds: float) -> float:
    if not 0 < seconds <= LONGEST:
        raise Unfit(f"no length of 0 to {LONGEST:g} s")
    return seconds


def _in_order(actions: tuple[tuple[float, Action], ...]) -> tuple[tuple[float, Action], ...]:
    times = [t for t, _ in actions]
    if times != sorted(times):
        raise Unfit("the actions are out of order")
    return actions


@dataclass(frozen=True, kw_only=True)
class RunResult:
    """How a run ended: whether the robot `fell`, after how many `seconds`, the largest |ψ| `peak` [rad], the largest
    way `travel` [m] from its beginning, and the largest short push `best` [N s] from which it came back."""

    fell: bool
    seconds: float
    peak: float
    travel: float
    best: float


def result_of(log: Log, robot: Robot, *, fell: bool, best: float) -> RunResult:
    """What a log of the true states shows."""
    wheel = log["truth/wheel"]
    return RunResult(
        fell=fell, seconds=round(float(log.t[-1] - log.t[0]), 6), peak=round(float(abs(log["truth/pitch"]).max()), 6),
        travel=round(float(abs(wheel - wheel[0]).max()) * robot.wheel_radius, 6), best=round(best, 6),
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class HandIn:
    """A run of `seconds` of the first body of `setup`, stood up at the pitch `lean` [rad], its `actions` each with its
    time [s]; `step` [s] is the body's. `claimed` is what the student's machine saw, `seal` a checksum of the rest."""

    student: Annotated[str, Through(_named)]
    setup: Annotated[Setup, Through(_that_runs)]
    step: Annotated[float, Through(_known_step)]
    lean: Annotated[float, Interval(ge=-1.2, le=1.2)]
    seconds: Annotated[float, Through(_short_enough)]
    actions: Annotated[
        tuple[tuple[Annotated[float, Interval(ge=0, le=LONGEST)], Action], ...],
        MaxLen(MOST_ACTIONS),
        Through(_in_order),
    ]
    claimed: RunResult
    seal: Annotated[str, MaxLen(64)] = ""

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT

    @property
    def sealed(self) -> bool:
        """Whether nothing was changed in the file. It tells slips and edits, not whoever computes it anew."""
        return self.seal == _seal(self.to_json())

    @property
    def run(self) -> str:
        """What tells one run from another, whoever hands it in."""
        data = self.to_json()
        return _seal({name: data[name] for name in ("setup", "step", "lean", "seconds", "actions")})

    def to_json(self) -> dict[str, Any]:
        """Plain values."""
        actions = [[t, plain(action)] for t, action in self.actions]
        data = {f.name: plain(getattr(self, f.name)) for f in fields(self)}
        return {"kind": KIND, "version": VERSION} | data | {"actions": actions, "claimed": asdict(self.claimed)}


def _seal(data: dict[str, Any]) -> str:
    rest = {name: value for name, value in data.items() if name != "seal"}
    return hashlib.sha256(json.dumps(rest, sort_keys=True, ensure_ascii=False).encode()).hexdigest()


def write_hand_in(done: HandIn, path: Path) -> Path:
    """Write the hand-in with its seal."""
    return write_json(path, replace(done, seal=_seal(done.to_json())).to_json())


def read_hand_in(path: Path) -> HandIn:
    """The hand-in in a file; raises `InvalidHandIn` for anything else."""
    text = read_text(path, InvalidHandIn, EXPECTED)
    if len(text) > MOST_TEXT:
        raise InvalidHandIn(f"{path.name} has {len(text)} characters", expected=f"at most {MOST_TEXT}")
    data = parse_json(text, path.name, InvalidHandIn, EXPECTED)
    if not isinstance(data, dict) or data.get("kind") != KIND:
        raise InvalidHandIn(f"{path.name} is no hand-in", expected=EXPECTED)
    if data.get("version") != VERSION:
        raise InvalidHandIn(f"{path.name} has version {str(data.get('version'))[:20]}", expected=f"version {VERSION}")
    del data["kind"], data["version"]
    try:
        return validated(_hand_ins(), json.dumps(data))
    except InvalidMessage as error:
        raise InvalidHandIn(f"{path.name} is broken: {one_line(error)}", expected=EXPECTED) from None


@cache
def _hand_ins() -> TypeAdapter[HandIn]:
    from pydantic import TypeAdapter  # slow to load

    return TypeAdapter(HandIn)


class Recorder:
    """Notes what is done to a session's robot since it was stood up; after any change of the set-up there is nothing to
    hand in until it is stood up again."""

    def __init__(self, step: float) -> None:
        self._step = step
        self._lean = 0.0
        self._since = -1.0
        self._actions: list[tuple[float, Action]] = []

    def begin(self, t: float, lean: float, speed: float, rate: float) -> None:
        """The robot stands up at the time `t` [s], and rolls and turns as it was asked to before."""
        self._since, self._lean = t, lean
        self._actions = [(0.0, Steer(speed, rate))] if speed or rate else []

    def stop(self) -> None:
        """The run so far cannot be run again."""
        self._since = -1.0

    def note(self, message: Any, t: float) -> None:
        """What came in at the time `t` [s]."""
        if isinstance(message, Action) and self._since >= 0 and len(self._actions) < MOST_ACTIONS:
            self._actions.append((round(t - self._since, 6), message))

    def hand_in(self, student: str, setup: Setup, t: float, claimed: RunResult) -> HandIn:
        """The run up to the time `t` [s]; raises `InvalidScenario` where there is none to hand in."""
        seconds = round(t - self._since, 6)
        if self._since < 0 or not 0 < seconds <= LONGEST or not _can_be_run(setup):
            raise InvalidScenario(
                Say("there is no run to hand in"),
                hint=Say("press Stand up, push the robot, then hand in within a minute"),
            )
        try:
            name = _named(student)
        except Unfit:
            wrong = Say("a name has 1 to {n} letters", n=LONGEST_NAME)
            raise InvalidScenario(wrong, hint=Say("write your name")) from None
        return HandIn(
            student=name, setup=setup, step=self._step, lean=self._lean, seconds=seconds,
            actions=tuple(self._actions), claimed=claimed,
        )  # fmt: skip
