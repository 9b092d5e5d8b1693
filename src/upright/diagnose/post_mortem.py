"""The post-mortem: why did it fall? From a log alone, or with the controller's file beside it.

    post_mortem(log, robot, kit, controller) → PostMortem

What each possible fault predicts for the last seconds decides whether the robot or its controller changed, and how
(`signatures`, `law`, `verdict`); docs/post-mortem.md says how well.
"""

from __future__ import annotations

import math
import re
import time
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.checkup.doctor import contradictions
from upright.checkup.finding import FEWEST as FEWEST_POSES
from upright.checkup.finding import Segment
from upright.checkup.wheels import passed_stop, record_of
from upright.control import Controller, controller_hash, find_controller
from upright.diagnose.causes import CANNOT_TELL, NO_FALL, NONE
from upright.diagnose.evidence import FOREIGN, Evidence, gather
from upright.diagnose.examined import FallExamined
from upright.diagnose.fall import against, last_fall
from upright.diagnose.remedy import UNTIL, timed_out
from upright.diagnose.saved import with_saved
from upright.diagnose.series import Series, series_of
from upright.diagnose.supply import of_supply
from upright.diagnose.verdict import ranked, reversed_causes, stated
from upright.errors import InvalidLog, InvalidRobot
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import RATES, LogSource, raw_log
from upright.logs.recording import FEWEST, check_drive, commanded
from upright.pages import Page, Quantity, Result, Say
from upright.progress import Progress, unwatched
from upright.robots import PARAMETERS, Kit, Robot, find_kit, find_robot, kit_names, preset_names
from upright.robots.facts import recorded
from upright.signals import SIDES, Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

UNFINISHED = Say("The search ended after {seconds}: try `--seconds {longer}`.")
SIDEWAYS = Say("A fall to the side, or after the last row, does not show in a log.")


class PostMortem(FallExamined, Result):
    """Why a robot fell, for people, as data and as a picture."""

    def page(self) -> Page:
        """The post-mortem for people."""
        from upright.diagnose.post_mortem_page import post_mortem_page

        return post_mortem_page(self)

    def plot(self) -> Figure | None:
        """Pitch, and how far it is beyond recovery, in the last seconds; None where the log does not tell."""
        picture = self.page().picture
        return picture and picture.draw()


def post_mortem(
    source: LogSource,
    robot: Robot | str | None = None,
    kit: Kit | str | None = None,
    controller: Controller | str | Path | None = None,
    *,
    mapping: Columns | str | None = None,
    seconds: float = math.inf,
    progress: Progress | None = None,
) -> PostMortem:
    """Why the robot of this log fell. No search begins after so many `seconds` of processor time.

    `robot` (default: that of the log's origin) is the robot without faults, `kit` (default: its own) its electronics,
    `controller` what should have driven it, also my.py:Name. `mapping` names the columns of a foreign file. All may be
    names or files.
    Raises `InvalidLog` for a file without a log, `InvalidRobot` where no robot is given or named in the log.
    """
    log = raw_log(source, mapping)
    nominal = find_robot(robot) if robot else robot_of(log)
    parts = find_kit(kit) if kit else kit_of(log, nominal)
    controller = find_controller(controller, nominal, parts, parts.period) if controller else None
    kind, mark = (controller.spec.kind, controller_hash(controller)) if controller else ("", "")
    head: dict[str, Any] = {"robot": nominal.name, "kit": parts.name, "rows": len(log), "controller": kind}
    head |= {"hash": mark, "source": fspath(source) if isinstance(source, str | PathLike) else ""}
    check_drive(log, nominal)
    if (untold := _untold(log, head)) is not None:
        return untold
    if (short := _short(log, head) if len(log) < FEWEST else None) and short.verdict != CANNOT_TELL:
        return short
    until = UNTIL.set(time.thread_time() + seconds)
    try:
        run, evidence = gather(log, nominal, parts, controller, progress or unwatched)
        unfinished = timed_out()
    except InvalidLog:
        if short is None:
            raise
        return short  # too few of its readings are within their ranges for a filter
    finally:
        UNTIL.reset(until)
    if evidence is None:
        return PostMortem(
            verdict=NO_FALL, causes=(), fell_at=math.nan, onset=math.nan, missing=(), notes=(SIDEWAYS,),
            series=series_of(run, float(run.t[-1])), **head,
        )  # fmt: skip
    before = log.between(float(log.t[0]), evidence.fell_at)  # then a program stops its motors, as no law says
    causes = with_saved(stated(ranked(evidence), unfinished=unfinished), before, nominal, run.kit, controller)
    verdict = causes[0].name
    missing = _helpful(evidence) if verdict == CANNOT_TELL else ()
    notes = (*evidence.notes, *of_supply(parts, run.kit), *_wiring(log, verdict))
    if unfinished:
        notes = (UNFINISHED.about(seconds=Quantity(seconds, "s"), longer=round(5 * seconds)), *notes)
    return PostMortem(
        verdict=verdict, causes=causes, fell_at=evidence.stopped_at, onset=causes[0].onset,
        missing=missing, notes=notes, series=series_of(run, evidence.fell_at), misfit=math.sqrt(evidence.ordinary),
        **head,
    )  # fmt: skip


def _short(log: Log, head: dict[str, Any]) -> PostMortem:
    """What a short log shows without any filter: whether it fell, and against what its motors worked."""
    if len(log) < FEWEST_POSES:
        raise InvalidLog(f"the log has {len(log)} samples", expected=f"at least {FEWEST_POSES} to see a fall")
    fall = last_fall(log)
    fell, onset = _dated(log, fall)
    causes = reversed_causes(against(log, fall), onset) if fall else ()
    too_few = Say("{n} rows", n=FEWEST)
    return PostMortem(
        verdict=causes[0].name if causes else CANNOT_TELL if fall else NO_FALL, causes=causes,
        fell_at=fell, onset=onset, missing=(too_few,) if fall and not causes else (),
        notes=(Say("The log has only {n} rows.", n=len(log)),),
        series=Series.none(), **head,
    )  # fmt: skip


def _off(log: Log) -> bool:
    """Whether the motors are off in every row."""
    prefix = commanded(log)
    return bool(prefix) and not any(np.nan_to_num(log[f"{prefix}/{side}"]).any() for side in SIDES)


def _untold(log: Log, head: dict[str, Any]) -> PostMortem | None:
    """Whether a robot fell whose motors are off, when why is no question, or whose log lacks what would tell why; None
    of any other."""
    missing = missing_channels(log)
    off = _off(log)
    if not missing and not off:
        return None
    fall = last_fall(log) if len(log) >= FEWEST_POSES else None
    fell, onset = _dated(log, fall)
    if missing and not (off and fall):
        return PostMortem(
            verdict=CANNOT_TELL, causes=(), fell_at=fell, onset=onset, missing=missing, notes=(),
            series=Series.none(), **head,
        )  # fmt: skip
    notes = (Say("Both commands are 0 in every row: without motors every robot falls.") if fall else SIDEWAYS,)
    return PostMortem(
        verdict=CANNOT_TELL if fall else NO_FALL, causes=(), fell_at=fell, onset=onset,
        missing=(Say("motors at work"),) if fall else (), notes=notes, series=Series.none(), **head,
    )  # fmt: skip


def _dated(log: Log, fall: Segment | None) -> tuple[float, float]:
    """When a robot fell by the motion of its body alone, and when that began [s]; NaN without a fall."""
    return (passed_stop(record_of(log), fall), fall.start) if fall else (math.nan, math.nan)


def _wiring(log: Log, verdict: str) -> tuple[Say, ...]:
    """What the doctor finds wrong in signs, units and sensors of a log that no cause explains."""
    if verdict not in (NONE, CANNOT_TELL):
        return ()
    return tuple(contradictions(log))


def missing_channels(log: Log) -> tuple[Say, ...]:
    """What a log lacks of commands, gyro and encoders, without which the motion is unknown."""

    def holds(name: str) -> bool:
        return name in log and bool(np.isfinite(log[name]).any())

    def moves(name: str) -> bool:
        return holds(name) and float(np.nanmax(log[name]) - np.nanmin(log[name])) > 0

    commands = any(all(holds(f"{prefix}/{side}") for side in ("left", "right")) for prefix in ("command", "applied"))
    missing = [] if commands else [Say("commands (command/left and command/right)")]
    if not moves("sensor/gyro"):
        missing.append(Say("a gyro that changes (sensor/gyro)"))
    if not any(moves(n) for pair in RATES.items() for n in pair):
        missing.append(Say("an encoder that changes (sensor/encoder_left)"))
    return tuple(missing)


def _helpful(evidence: Evidence) -> tuple[Say, ...]:
    """What would help where no cause is likely."""
    if evidence.ordinary > FOREIGN:
        return (Say("the robot's own numbers"),)
    seconds = evidence.fell_at - float(evidence.run.log.t[0])
    if seconds < evidence.excursion:
        after = Quantity(seconds, "s", digits=2)
        return (Say("the seconds before: the fall began {seconds} after the first row", seconds=after),)
    files = [Say("the controller's file")] if evidence.match is None else []
    return (*files, *([Say("the references, if it was driven")] if evidence.demand is None else []))


def robot_of(log: Log) -> Robot:
    """The robot that the log's origin names, with its numbers; `InvalidRobot` where it names none."""
    origin: Any = log.origin.get("robot")
    if not isinstance(origin, dict) or "name" not in origin:
        raise InvalidRobot("the log names no robot", expected="a robot", hint="name it with --robot")
    preset = Robot.preset(origin["name"]) if origin["name"] in preset_names() else None
    if preset and not set(PARAMETERS) & set(origin):
        return preset
    try:
        numbers: dict[str, Any] = {name: float(value) for name, value in recorded(origin).items()}
        return preset.replace(**numbers) if preset else Robot(name=origin["name"], drive=origin["drive"], **numbers)
    except (KeyError, TypeError, ValueError) as error:
        raise InvalidRobot(f"the log's robot is broken ({error})", hint="name it with --robot") from None


def kit_of(log: Log, robot: Robot) -> Kit:
    """The electronics that the log's origin names, else the robot's own."""
    body: Any = log.origin.get("body")
    kind = str(body.get("kind", "")) if isinstance(body, dict) else ""
    named = re.search(r" with (\S+) electronics$", kind)
    if isinstance(robot.kit, Kit):
        return robot.kit
    return find_kit(named[1] if named and named[1] in kit_names() else robot.kit)
