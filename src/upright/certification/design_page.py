"""The page of a design: the robot let go, its margins, and the numbers that the controller was found by."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from upright.certification.weights import Weight
from upright.control.lqr import Lqr
from upright.control.pid_angle_design import AngleDesign
from upright.loops.analysis_page import analysis_page
from upright.loops.places import place_of
from upright.pages import (
    Block,
    Column,
    Fold,
    Items,
    KeyNumber,
    Message,
    Next,
    Page,
    Picture,
    Quantity,
    Say,
    Table,
    Verdict,
)
from upright.pages.terms import short
from upright.signals import STATE_NAMES

Designed = Any  # these are those of `design.py`, which imports this file
Release = Any

NAMES = {
    "pitch": Say("pitch"), "pitch_rate": Say("pitch rate"), "wheel": Say("wheel angle"),
    "wheel_rate": Say("wheel rate"), "yaw": Say("yaw"), "yaw_rate": Say("yaw rate"), "gyro_bias": Say("gyro bias"),
    "push": Say("push"), "integral": Say("integral of the wheel angle"),
    "p": Say("p, on pitch"), "i": Say("i, on its integral"), "d": Say("d, on pitch rate"),
    "filter_time": Say("filter time of d"), "motor": Say("against friction and back-EMF"),
    "p_wheel": Say("p, on the wheel angle"), "d_wheel": Say("d, on the wheel rate"), "p_yaw": Say("p, on yaw"),
    "d_yaw": Say("d, on yaw rate"), "command": Say("command of a motor"),
    "disturbance": Say("disturbance at the command"), "encoder": Say("error of an encoder"),
    "gyro": Say("error of the gyro"),
}  # fmt: skip
"""Name of a weight → what it is called; one of a plug-in keeps its name."""


def design_page(designed: Designed) -> Page:
    """The page of a designed controller."""
    run: Release | None = designed.release
    picture = _let_go(run, designed.controller.spec.reads) if run else None
    controller = Fold(Say("The controller"), _controller(designed))
    if not designed.analysis:
        return replace(
            unknown_margins(designed.remark), picture=picture, numbers=[_number(run)] if run else [],
            blocks=[controller], next=[Next("certify", designed.method, robot=designed.robot.name)],
        )  # fmt: skip
    page = analysis_page(designed.analysis, picture)
    stands = designed.analysis.stable or designed.analysis.free
    if isinstance(designed.record, AngleDesign) and not designed.record.searched and stands:
        file = f"{designed.method}.json"
        why = Say("First save it: add `-o {file}` to this command.", file=file)
        page = replace(page, next=[Next("certify", file, robot=designed.robot.name, why=why)])
    lines = [*designed.reasons, *designed.words]
    words: list[Block] = [Items(lines)] if lines else []
    feedback = getattr(designed.record, "feedback", designed.record)
    if isinstance(feedback, Lqr):
        words += _regulator(feedback)
    page = replace(page, blocks=[*words, *page.blocks, controller], origin={**page.origin, "kit": designed.kit.name})
    if run and stands:
        page = replace(page, numbers=[*page.numbers[:2], _number(run)])
    if run and run.fell_at is not None and stands:
        assert picture
        return replace(page, title=picture.claim, verdict=Verdict(Say("falls when let go"), "bad"))
    return page


def unknown_margins(reason: object) -> Page:
    """The first screen of a controller without margins, for this `reason`."""
    return Page(
        Say("No linear margins are known: the certificate tries it by simulation"),
        verdict=Verdict(Say("no margins known"), "unknown"), lead=[Say("Why: {reason}", reason=Message(reason))],
    )  # fmt: skip


def _lean(run: Release) -> Quantity:
    return Quantity(run.lean, "rad")


def _let_go(run: Release, reads: Sequence[str]) -> Picture:
    """Pitch and travel of the run of a controller that `reads` these channels."""
    claim = Say("Let go at {lean}, it is upright again after {time} and rolls {travel}", lean=_lean(run),
                time=Quantity(run.upright, "s", digits=2), travel=Quantity(run.travel, "m", digits=2))  # fmt: skip
    if run.fell_at is not None:
        claim = Say(
            "Let go at {lean}, it falls after {time}", lean=_lean(run), time=Quantity(run.fell_at, "s", digits=2)
        )
    elif not math.isfinite(run.upright):
        band = Quantity(run.band, "rad")
        claim = Say("Let go at {lean}, it stands, but keeps swinging beyond ±{band}", lean=_lean(run), band=band)
    note = Say("Nonlinear model with the kit's noise, delay, dead zone and limits.")
    if "sensor/pitch" not in reads:
        note = Say("Nonlinear model of robot and kit. No sensor shows the lean at first, so it grows.")
    return Picture(claim, run.plot, note)


def _number(run: Release) -> KeyNumber:
    if run.fell_at is not None:
        return KeyNumber(Quantity(run.fell_at, "s", digits=2), Say("until it falls, let go at {lean}", lean=_lean(run)))
    if not math.isfinite(run.upright):
        meaning = Say("beyond ±{band}, let go at {lean}", lean=_lean(run), band=Quantity(run.band, "rad"))
        return KeyNumber(Say("keeps swinging"), meaning)
    return KeyNumber(
        Quantity(run.upright, "s", digits=2), Say("until upright again, let go at {lean}", lean=_lean(run))
    )


def _regulator(record: Lqr) -> list[Block]:
    """The gain K, the solution S of the Riccati equation, and the poles of A − B K."""
    states = [NAMES[name] for name in STATE_NAMES]
    columns = [Column(Say("motor")), *map(Column, states)]
    gain = [
        [side, *_four_digits(row)] for side, row in zip((Say("left"), Say("right")), record.gain.tolist(), strict=True)
    ]
    # what is zero but for rounding would need a power of ten
    cost = np.where(np.abs(record.cost) < ROUNDED * np.abs(record.cost).max(), 0.0, record.cost)
    rows = [[state, *_four_digits(row)] for state, row in zip(states, cost.tolist(), strict=True)]
    poles = [_pole(pole) for pole in record.poles().tolist() if pole.imag >= 0]
    return [
        Table(columns, gain, Say("K of u = −K (x − r), in {unit} per rad and rad/s", unit=record.command_unit)),
        Table([Column(Say("state")), *columns[1:]], rows, Say("S of the Riccati equation, J = xᵀ S x")),
        Say("Poles z of A − B K: {poles}", poles=poles),
    ]


def _pole(pole: complex) -> Quantity | Say:
    """A real pole, or one with its conjugate."""
    real, size = _four_digits([pole.real, pole.imag])
    return Say("{real} ± {size} j", real=real, size=size) if pole.imag else real


def _four_digits(row: list[float]) -> list[Quantity]:
    return [Quantity(value, "1", digits=4) for value in row]


ROUNDED = 1e-9  # of the largest element of S


def _controller(designed: Designed) -> list[Block]:
    """What it reads and commands, and the numbers that it was found by."""
    spec = designed.controller.spec
    reads = [place_of(short(name)) for name in spec.reads]
    blocks: list[Block] = [
        Say("Every {period} it reads: {reads}.", period=Quantity(spec.period, "s"), reads=reads),
    ]
    if designed.weights:
        blocks.append(_weights(designed.weights, spec.command_unit, spec.period))
    residual = designed.facts()["residual"]
    if residual is not None:
        blocks.append(Say("Residual of the equations that were solved: {size}", size=Quantity(residual, "1", digits=2)))
    return blocks


def _weights(weights: tuple[Weight, ...], unit: str, period: float) -> Table:
    sizes = [None if w.size is None else Quantity(w.size, w.unit) for w in weights]
    names = [_name(w.name, period) for w in weights]
    if not any(w.gain for w in weights):
        rows = [[name, size] for name, size in zip(names, sizes, strict=True)]
        return Table([Column(Say("weight")), Column(Say("size"))], rows)
    rows = [
        [name, size, *(Quantity(gain, f"{unit}/{_whole(w.unit)}") for gain in w.gain)]
        for name, size, w in zip(names, sizes, weights, strict=True)
    ]
    columns = [Column(Say("state")), Column(Say("costs 1 at")), Column(Say("left gain")), Column(Say("right gain"))]
    return Table(columns, rows)


def _name(name: str, period: float) -> Say | str:
    """A state of the robot or the filter, or a command on its way, such as sent_2/left, of so many periods [s] ago."""
    if not name.startswith("sent_"):
        return NAMES.get(name, name)
    ago, side = name.removeprefix("sent_").split("/")
    time = Quantity(int(ago) * period, "s")
    return Say("left command {time} ago", time=time) if side == "left" else Say("right command {time} ago", time=time)


def _whole(unit: str) -> str:
    return f"({unit})" if "/" in unit or " " in unit else unit
