"""The page of a post-mortem: the likeliest cause, what speaks for it, and the last seconds."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from upright.checkup.finding import instant
from upright.diagnose.causes import (
    BIAS,
    CANNOT_TELL,
    DELAY,
    HIGH,
    KNOWN,
    LOAD,
    LOW,
    NO_FALL,
    OFF,
    PUSH,
    RAMP,
    SATURATION,
    Blow,
    Cause,
)
from upright.diagnose.fall_pictures import last_seconds
from upright.diagnose.usual import FOREIGN
from upright.pages import (
    MOST_NUMBERS,
    Block,
    Column,
    Fold,
    Items,
    KeyNumber,
    Next,
    Page,
    Picture,
    Quantity,
    Say,
    Table,
    Verdict,
)
from upright.robots.kit import STOP

if TYPE_CHECKING:
    from upright.diagnose.examined import FallExamined

SHOWN = 0.02
"""Less likely causes are only in the JSON."""
SURE = 0.5  # probability from which a cause is named
WORTH = 0.05  # from which one beside the first is among the three numbers

DESIGNED_FOR = {LOW: "lqg", HIGH: "lqg", BIAS: "lqg", DELAY: "lqg", SATURATION: "lqg", RAMP: "lqi"}
"""Cause → the method of a controller that allows for it."""


def post_mortem_page(result: FallExamined) -> Page:
    """The page of a post-mortem."""
    push = result.causes[0].push if result.causes else None
    title = Say("{robot} did not fall in this log", robot=result.robot)
    if result.fell and _is_named(result):
        cause = result.causes[0].title
        title = Say("{robot} fell at {time}: {cause}", robot=result.robot, time=instant(result.fell_at), cause=cause)
    elif result.fell:
        title = Say("{robot} fell at {time} of the log", robot=result.robot, time=instant(result.fell_at))
    elif result.verdict == CANNOT_TELL:
        title = Say("The log of {robot} does not tell whether it fell", robot=result.robot)
    reservations = [
        *(Say("The log lacks {what}.", what=what) for what in result.missing),
        *result.notes,
    ]
    blocks: list[Block] = [_causes(result)] if result.causes else []
    if reservations:
        blocks.append(Items(reservations))
    if len(result.causes) > 1:
        blocks.append(Fold(Say("What helps"), [_repairs(result)]))
    by = {"controller": f"{result.controller}, {result.hash[:12]}"} if result.controller else {}
    return Page(
        title, verdict=_verdict(result), lead=_lead(result, push), numbers=_numbers(result, push),
        picture=_picture(result, push), next=[_next(result, push)], blocks=blocks,
        origin={"robot": result.robot, "kit": result.kit, "rows": str(result.rows)} | by,
    )  # fmt: skip


def _is_named(result: FallExamined) -> bool:
    """Whether one cause is likelier than not."""
    return bool(result.causes) and result.verdict != CANNOT_TELL and result.causes[0].likelihood >= SURE


def _verdict(result: FallExamined) -> Verdict:
    if result.verdict == NO_FALL:
        return Verdict(Say("no fall"), "good")
    if not result.causes or result.verdict == CANNOT_TELL:
        return Verdict(Say("the cause is not clear"), "unknown")
    first = result.causes[0]
    likely = Quantity(first.likelihood, "fraction", digits=2)
    if not _is_named(result):
        return Verdict(Say("perhaps {cause}: {likely}", cause=first.title, likely=likely), "unknown")
    return Verdict(Say("{cause}: {likely} likely", cause=first.title, likely=likely), "bad")


def _lead(result: FallExamined, push: Blow | None) -> list[Say]:
    if not result.fell:
        return [Say("A fall is a lean beyond {lean} that lasts.", lean=Quantity(STOP, "rad", digits=2))]
    if push:
        facts = {"size": Quantity(abs(push.impulse), "N s", digits=2), "at": instant(push.start)}
        threw = Say("A push of {size} forward at {at} most likely threw it over.", **facts)
        if push.impulse < 0:
            threw = Say("A push of {size} backward at {at} most likely threw it over.", **facts)
        return [threw, _saved(push)]
    if result.misfit**2 > FOREIGN:
        return [Say("The given robot does not fit this log, even before the fall.")]
    if not result.causes:
        return [Say("The log shows the fall, and not its cause.")]
    repairs = result.causes[0].repairs
    if len(repairs) > 1 or not math.isfinite(result.onset):
        return repairs
    return [Say("The trouble began at {at}.", at=instant(result.onset)), *repairs]


def _saved(push: Blow) -> Say:
    """Whether any controller could have saved it: an impulse is known to `KNOWN`."""
    if abs(push.impulse) > (1 + KNOWN) * push.most:
        return Say("Probably no controller could have saved it.")
    if abs(push.impulse) > (1 - KNOWN) * push.most:
        return Say("The best possible controller may have saved it or not.")
    return Say("A better controller may save it.")


def _numbers(result: FallExamined, push: Blow | None) -> list[KeyNumber]:
    numbers = list[KeyNumber]()
    if push:
        size = abs(push.impulse)
        error = Quantity(KNOWN * size, "N s", digits=1)
        impulse = Say("{size} ± {error}", size=Quantity(size, "1", digits=2), error=error)
        height = Quantity(push.height, "m", digits=2)
        numbers.append(KeyNumber(impulse, Say("the push, if it hit {height} above the axle", height=height)))
        if push.saves is not None:
            own = Quantity(push.saves, "N s", digits=2)
            numbers.append(KeyNumber(own, Say("its controller ({by}) survives", by=push.by)))
        best = Quantity(push.most, "N s", digits=2)
        numbers.append(KeyNumber(best, Say("the best possible controller survives")))
    elif result.causes and math.isfinite(result.onset):
        lasted = Quantity(result.fell_at - result.onset, "s", digits=2)
        numbers.append(KeyNumber(lasted, Say("from the first sign to the fall")))
        lost = lost_at(result)
        if lost is not None and OFF not in result.causes[0].parts:  # motors that are off save nothing
            left = Quantity(lost - result.onset, "s", digits=2)
            numbers.append(KeyNumber(left, Say("from the first sign until no motor could save it")))
    second = result.causes[1] if len(result.causes) > 1 else None
    if len(numbers) < MOST_NUMBERS and second and second.likelihood >= WORTH and second.name != CANNOT_TELL:
        likely = Quantity(second.likelihood, "fraction", digits=2)
        numbers.append(KeyNumber(likely, Say("next likely: {cause}", cause=second.title)))
    return numbers


def lost_at(result: FallExamined) -> float | None:
    """From when on the drawn lean stays beyond the largest one to recover from, up to the fall [s]."""
    s = result.series
    examined = np.flatnonzero((s.t >= result.onset) & (s.t <= result.fell_at) & np.isfinite(s.reserve))
    inside = np.flatnonzero(s.reserve[examined] < 1)
    after = examined[inside[-1] + 1 :] if len(inside) else examined
    if not len(after):
        return None
    row = int(after[0])
    low, high = s.reserve[max(row - 1, 0) : row + 1][[0, -1]].tolist()
    if not low < 1 <= high:  # it was beyond before, or is not known there
        return float(s.t[row])
    crossing = float(s.t[row - 1] + (1 - low) / (high - low) * (s.t[row] - s.t[row - 1]))
    return max(crossing, result.onset)


def _likely(result: FallExamined) -> list[Cause]:
    return [cause for cause in result.causes if cause.likelihood >= SHOWN]


def _causes(result: FallExamined) -> Table:
    columns = [
        Column(Say("cause")),
        Column(Say("probability"), "fraction", digits=2),
        Column(Say("what the log shows")),
    ]
    rows = [[cause.title, cause.likelihood, cause.evidence] for cause in _likely(result)]
    return Table(columns, rows, Say("A cause keeps a probability until the log excludes it"))


def _repairs(result: FallExamined) -> Table:
    rows = [[cause.title, repair] for cause in _likely(result) for repair in cause.repairs]
    return Table([Column(Say("cause")), Column(Say("what helps"))], rows)


def _picture(result: FallExamined, push: Blow | None) -> Picture | None:
    if len(result.series.t) < 2:
        return None
    if not (result.fell and math.isfinite(result.onset)):
        return Picture(Say("The last seconds"), functools.partial(last_seconds, result))
    lasted = Quantity(result.fell_at - result.onset, "s", digits=2)
    draw = functools.partial(last_seconds, result, push, None if push else lost_at(result))
    if push:
        note = Say("Shaded: from the push to the fall. The dot is the push, estimated from the whole log.")
        return Picture(Say("It fell {lasted} after the push", lasted=lasted), draw, note)
    note = Say("Shaded: from the first sign to the fall. Above 1 the motors cannot bring it back.")
    return Picture(Say("It fell {lasted} after the first sign of trouble", lasted=lasted), draw, note)


def _next(result: FallExamined, push: Blow | None) -> Next:
    """What to run next, by what was found."""
    log, robot = result.source or "LOG", result.robot
    parts = result.causes[0].parts if result.causes else []
    if result.misfit**2 > FOREIGN or LOAD in parts:
        why = Say("It learns the robot of this log.")
        return Next("calibrate", log, robot=robot, output="robot.toml", why=why)
    if push and abs(push.impulse) < (1 + KNOWN) * push.most:
        why = Say("It compares controllers under pushes; until a better one runs, push less.")
        return Next("bench_controllers", robot=robot, why=why)
    if PUSH in parts:
        why = Say("It finds the largest push that the robot survives, at each height.")
        if push and push.saves is not None:
            size = Quantity(push.saves, "N s", digits=2)
            why = Say("It finds the largest push at each height. Until you know it, stay below {size}.", size=size)
        return Next("push_map", robot=robot, controller=(push and push.by) or None, why=why)
    for part in parts:
        if part in DESIGNED_FOR:
            return Next("design", DESIGNED_FOR[part], robot=robot)
    return Next("doctor", log, robot=robot, why=Say("It tests the log for signs, units and plugs."))
