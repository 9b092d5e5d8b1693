"""A gain that a log's file states: are the logged commands those before it, or those after it?

Both are tried, with the same parameters: the commands as they are logged, and times the gain, up to full duty. Where
the motors were driven by the second, rows beyond full duty over the gain act less than in proportion, and the robot's
own numbers, which its file gives, fit. So they would under a driver whose curve is concave, as bridges with slow decay
are: small duties then act more than in proportion, whatever the program logs. Such curves are tried beside the gain.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from upright.arrays import Array
from upright.calibration.fitting import Fitted, Problem
from upright.calibration.gauss_newton import gauss_newton
from upright.calibration.informativity import MARGIN
from upright.errors import DesignFailed
from upright.logs.raw import named
from upright.logs.readers import GAINS
from upright.logs.recording import commanded
from upright.pages import Say
from upright.robots import Kit
from upright.signals import SIDES, Log

ITERATIONS = 10  # of Gauss–Newton, from each start
CURVES = (0.5, 0.7, 0.85)
"""Exponents γ of a driver's curve V = U (v/U)^γ, where the full voltage U is kept: 1 is in proportion, and 0.5 triples
a duty of a ninth."""


def stated_gains(log: Log) -> dict[str, float]:
    """The gains that the log's file states, by its words; of a body of ours none, since it logs what was applied."""
    given = log.origin.get(GAINS)
    return {str(words): float(gain) for words, gain in given.items()} if isinstance(given, dict) else {}


def amplified(log: Log, gain: float, kit: Kit) -> Log:
    """`log` with its commands times `gain`, up to full duty: the logged battery's voltage, or what the kit's motors get
    at most."""
    prefix = commanded(log)
    most = _full(log, kit)
    channels = {f"{prefix}/{side}": log[f"{prefix}/{side}"] for side in SIDES}
    changed = {name: np.clip(gain * values, -most, most) for name, values in channels.items()}
    origin = {name: value for name, value in log.origin.items() if name != GAINS} | {"times": gain}
    return Log(log.t, {**log.channels, **changed}, log.units, origin)


def _full(log: Log, kit: Kit) -> Array:
    """The voltage of full duty in each row: the logged battery's, or what the kit's motors get at most."""
    prefix = commanded(log)
    most = np.full(len(log), kit.most("V"))
    if "sensor/battery" in log and log.unit(f"{prefix}/left") == log.unit("sensor/battery"):
        most = log["sensor/battery"]
    return np.maximum(most, np.abs(commands_of(log)).max(axis=1))  # what was logged was possible


def _curved(log: Log, kit: Kit, exponent: float) -> Array:
    """The commands (rows, 2) through a driver of this curve."""
    commands = commands_of(log)
    largest = float(np.abs(commands).max()) or 1.0
    full = _full(log, kit)[:, None]
    most = np.where(np.isfinite(full), full, largest)  # a kit without a battery has no full duty but the largest
    return np.sign(commands) * most * np.abs(commands / most) ** exponent


def commands_of(log: Log) -> Array:
    """The commands of both motors (rows, 2)."""
    return np.column_stack([log[f"{commanded(log)}/{side}"] for side in SIDES])


def nats(fit: Fitted, run: int, commands: Array, rival: Fitted | None = None) -> float:
    """By how much the log posterior is larger, at the noise and weights of a fit, where a run's commands are `commands`
    (rows, 2). Parameters are fitted anew from the fit's, and from those of a `rival` or the prior."""
    recordings = list(fit.problem.recordings)
    recordings[run] = replace(recordings[run], commands=np.ascontiguousarray(commands))
    here = fit.problem
    there = replace(fit.problem, recordings=tuple(recordings))
    rivals = {p.name: at for p, at in zip(rival.problem.parameters, rival.z, strict=True)} if rival else {}
    other = np.array([rivals.get(p.name, 0.0) for p in here.parameters])
    own = [fit.normal.objective, *([_least(here, other)] if rival else [])]
    return min(own) - min(_least(there, z) for z in (fit.z, other))


def _least(problem: Problem, z: Array) -> float:
    value = gauss_newton(problem, z, iterations=ITERATIONS).normal.objective
    return float(value) if np.isfinite(value) else math.inf


def as_meant(
    fit: Fitted, logs: Sequence[Log], kit: Kit, search: Callable[[Sequence[Log]], Fitted]
) -> tuple[Fitted, list[Log], list[Say]]:
    """The fit of the logs with the commands that drove the motors, these logs, and what was found of stated gains.
    `fit` is that of the commands as logged, `search` fits other logs anew."""
    chosen = list(logs)
    notes = dict[int, Say]()
    while tries := _tries(fit, chosen, kit, set(notes)):
        likelier, run, words, log = max(tries, key=lambda one: one[0])
        facts = {"log": Path(named(chosen[run])).name, "gain": words}
        if likelier < MARGIN:
            notes |= {i: _as_logged(chosen[i], what) for _, i, what, _ in sorted(tries, key=lambda t: t[0])}
            break
        uncut = log.origin["times"] * commands_of(chosen[run])
        if likelier <= nats(fit, run, uncut):  # a factor is also what another motor would be, or another dead zone
            notes[run] = Say(
                "The file {log} states {gain}; commands are taken as logged: a stronger motor explains as much.",
                **facts,
            )
            continue
        curves = [nats(fit, run, _curved(chosen[run], kit, exponent)) for exponent in CURVES]
        if likelier < max(curves) + MARGIN:
            notes[run] = Say(
                "The file {log} states {gain}; commands are taken as logged: a curved driver explains as much.", **facts
            )
            continue
        anew = [log if i == run else one for i, one in enumerate(chosen)]
        try:
            other = search(anew)
        except DesignFailed:
            notes[run] = _as_logged(chosen[run], words)
            continue
        if min(likelier, -nats(other, run, commands_of(chosen[run]), fit)) < MARGIN:
            notes[run] = _as_logged(chosen[run], words)
            continue
        notes[run] = Say(
            "The file {log} states {gain}: its commands are those before that gain, and were multiplied.", **facts
        )
        fit = other
        chosen = anew
    return fit, chosen, [notes[run] for run in sorted(notes)]


def _tries(fit: Fitted, logs: Sequence[Log], kit: Kit, notes: set[int]) -> list[tuple[float, int, str, Log]]:
    """For each run and each gain that its file states, by how many nats commands before it are likelier."""
    others = [
        (run, words, amplified(log, gain, kit))
        for run, log in enumerate(logs)
        if run not in notes
        for words, gain in stated_gains(log).items()
    ]
    return [(nats(fit, run, commands_of(other)), run, words, other) for run, words, other in others]


def _as_logged(log: Log, words: str) -> Say:
    name = Path(named(log)).name
    return Say(
        "The file {log} states {gain}; commands are taken as logged, which explain it as well.", log=name, gain=words
    )
