"""The post-mortem: why did it fall? From a log alone, or with the controller's file beside it.

    post_mortem(log, robot, kit, controller) → PostMortem

Whether the robot or the law behind its commands changed, and how, is decided by what each possible fault foretells of
the last seconds (`faults`, `law`, `verdict`); docs/post-mortem.md says how well.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.atomic import finite
from upright.control import Controller, controller_hash
from upright.diagnose.evidence import Evidence, Series, gathered, series_of
from upright.diagnose.verdict import CANNOT_TELL, NO_FALL, Cause, ranked
from upright.errors import InvalidLog, InvalidRobot
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import RATES, raw_log
from upright.robots import PARAMETERS, Kit, Robot, kit_names, preset_names
from upright.signals import Log

Array = NDArray[np.float64]
KIND, VERSION = "upright post-mortem", 1


@dataclass(frozen=True, eq=False)
class PostMortem:
    """Why a robot fell: the `verdict` is the likeliest of `causes`, "it did not fall" or "cannot tell".

    `fell_at` is when its lean passed 0.7 rad for good, `onset` when the trouble began [s] (NaN where there is none);
    `missing` names what the log would have to hold for more. `series` are the last seconds, for drawing.
    """

    verdict: str
    causes: tuple[Cause, ...]
    robot: str
    kit: str
    controller: str
    hash: str
    fell_at: float
    onset: float
    rows: int
    missing: tuple[str, ...]
    notes: tuple[str, ...]
    series: Series = field(repr=False)

    @property
    def fell(self) -> bool:
        """Whether the robot fell."""
        return math.isfinite(self.fell_at)

    def check(self) -> list[str]:
        """What in the result contradicts itself, in words; empty where nothing does."""
        odds = [cause.likelihood for cause in self.causes]
        first = self.causes[0].name if self.causes else CANNOT_TELL if self.missing else NO_FALL
        wrong = [f"the verdict is '{self.verdict}' but the likeliest is '{first}'"] if self.verdict != first else []
        wrong += ["the causes are not in order"] if odds != sorted(odds, reverse=True) else []
        wrong += [f"the likelihoods sum to {sum(odds):.3f}"] if odds and abs(sum(odds) - 1) > 1e-6 else []
        wrong += ["a cause stands beside no fall"] if self.causes and not self.fell else []
        late = self.fell and self.onset > self.fell_at
        return wrong + ([f"the trouble begins at {self.onset:g} s, after the fall"] if late else [])

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; None for what is not known."""
        numbers = {k: finite(v) for k, v in asdict(self).items() if k not in ("causes", "series")}
        causes = [{k: finite(v) for k, v in asdict(cause).items()} for cause in self.causes]
        return {"file": KIND, "version": VERSION} | numbers | {"causes": causes, "series": self.series.to_json()}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> PostMortem:
        """The inverse of `to_json`; raises `InvalidLog` for what is no post-mortem or contradicts itself."""
        try:
            given = dict(data)
            if (given.pop("file"), given.pop("version")) != (KIND, VERSION):
                raise ValueError(f"it is no '{KIND}' of version {VERSION}")
            listed: list[dict[str, Any]] = given.pop("causes")
            causes = tuple(_cause(one) for one in listed)
            times: dict[str, Any] = {name: _number(given.pop(name)) for name in ("fell_at", "onset")}
            lists: dict[str, Any] = {name: tuple(given.pop(name)) for name in ("missing", "notes")}
            found = cls(causes=causes, series=Series.from_json(given.pop("series")), **times, **lists, **given)
            if wrong := found.check():
                raise ValueError(wrong[0])
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise InvalidLog(
                f"this is no post-mortem ({type(error).__name__}: {error})", expected="JSON by upright post-mortem"
            ) from None
        return found

    def __str__(self) -> str:
        by = f" under {self.controller}" if self.controller else ""
        when = f" at t = {self.fell_at:.2f} s" if self.fell else ""
        lines = [f"{self.verdict.upper()}: {self.robot} with kit {self.kit}{by}{when}"]
        for cause in (c for c in self.causes if c.likelihood >= 0.02):
            lines += ["", f"{cause.likelihood:>5.0%}  {cause.name}", f"       {cause.evidence}"]
            lines += [f"       → {cause.repair}"] if cause.repair else []
        lines += [f"missing: {', '.join(self.missing)}"] if self.missing else []
        return "\n".join([*lines, *(f"- {note}" for note in self.notes)])


def post_mortem(
    source: str | Path | Log,
    robot: Robot | None = None,
    kit: Kit | None = None,
    controller: Controller | None = None,
    mapping: Columns | None = None,
    progress: Callable[[float], None] | None = None,
) -> PostMortem:
    """Why the robot of this log fell.

    `robot` (default: that of the log's origin) is the robot as it should be, `kit` (default: the robot's own) its
    electronics, `controller` what should have driven it; with it the recorded commands are compared with the law's.
    `mapping` says which column of a foreign file is what. Raises `InvalidLog` for what is no log, `InvalidRobot` where
    no robot is given or named in the log.
    """
    show = progress or _unwatched
    log = source if isinstance(source, Log) else raw_log(source, mapping)
    nominal = robot or robot_of(log)
    parts = kit or kit_of(log, nominal)
    name, mark = (controller.spec.kind, controller_hash(controller)) if controller else ("", "")
    missing = lacking(log)
    head: dict[str, Any] = {
        "robot": nominal.name,
        "kit": parts.name,
        "controller": name,
        "hash": mark,
        "rows": len(log),
    }
    if missing:
        notes = ("without these nothing can be said of the robot's motion",)
        return PostMortem(
            CANNOT_TELL,
            (),
            fell_at=math.nan,
            onset=math.nan,
            missing=missing,
            notes=notes,
            series=Series.none(),
            **head,
        )
    seen = gathered(log, nominal, parts, controller, show)
    causes = ranked(seen)
    verdict = causes[0].name if causes else NO_FALL
    onset = causes[0].onset if causes else math.nan
    fell_at = seen.fall.at if seen.fall else math.nan
    wanted = _wanted(seen, verdict)
    return PostMortem(
        verdict, causes, fell_at=fell_at, onset=onset, missing=wanted, notes=seen.notes, series=series_of(seen), **head
    )


def _unwatched(share: float) -> None:
    """Nobody watches the `share` done."""


def lacking(log: Log) -> tuple[str, ...]:
    """What a log lacks of commands, gyro and encoders, without which no motion is told."""

    def says(name: str) -> bool:
        return name in log and bool(np.isfinite(log[name]).any())

    def moves(name: str) -> bool:
        return says(name) and float(np.nanmax(log[name]) - np.nanmin(log[name])) > 0

    commands = any(all(says(f"{prefix}/{side}") for side in ("left", "right")) for prefix in ("command", "applied"))
    found = [] if commands else ["commands (command/left and command/right)"]
    found += [] if moves("sensor/gyro") else ["a gyro (sensor/gyro)"]
    return tuple(found + ([] if any(moves(n) for pair in RATES.items() for n in pair) else ["encoders"]))


def _wanted(seen: Evidence, verdict: str) -> tuple[str, ...]:
    """What would help where nothing could be told."""
    if verdict != CANNOT_TELL:
        return ()
    return tuple(
        ["the controller's file"] * (seen.law is None) + ["the references, if it was driven"] * (not seen.driven)
    )


def robot_of(log: Log) -> Robot:
    """The robot that the log's origin names, with its numbers; `InvalidRobot` where it names none."""
    said: Any = log.origin.get("robot")
    if not isinstance(said, dict) or "name" not in said:
        raise InvalidRobot("the log does not say of which robot it is", expected="a robot", hint="name it with --robot")
    if said["name"] in preset_names() and not set(PARAMETERS) & set(said):
        return Robot.preset(said["name"])
    try:
        base = Robot.preset(said["name"]) if said["name"] in preset_names() else None
        numbers: dict[str, Any] = {name: float(said[name]) for name in PARAMETERS}
        return base.replace(**numbers) if base else Robot(name=said["name"], drive=said["drive"], **numbers)
    except (KeyError, TypeError, ValueError) as error:
        raise InvalidRobot(f"the log's robot is broken ({error})", hint="name it with --robot") from None


def kit_of(log: Log, robot: Robot) -> Kit:
    """The electronics that the log's origin names, else the robot's own."""
    body: Any = log.origin.get("body")
    kind = str(body.get("kind", "")) if isinstance(body, dict) else ""
    named = re.search(r" with (\S+) electronics$", kind)
    return Kit.preset(named[1] if named and named[1] in kit_names() else robot.kit)


def _cause(data: dict[str, Any]) -> Cause:
    given: dict[str, Any] = data | {"onset": _number(data["onset"])}
    return Cause(**given)


def _number(value: float | None) -> float:
    return math.nan if value is None else float(value)
