"""The law of a log: what gave its commands, from a controller's file or read from the log itself.

Read from the log, a law is a linear feedback of readings, of their steps and sums, and of logged estimates, with what
was added to it (`excitation/…`, `reference/…`). It is the shortest one that explains the commands of the last quarter,
on which it was not fitted.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from typing import Protocol, TypeVar

import numpy as np

from upright.arrays import Array, Mask
from upright.control import Controller
from upright.control.files import FORMS
from upright.errors import UprightError
from upright.pages import Quantity, Say
from upright.signals import Log
from upright.signals.signal import STATE_NAMES

Values = TypeVar("Values", float, Array)

EXPLAINED = 0.99  # [1] R² of the commands from which a law is known
EXACT = 1e-6  # [1] unexplained fraction at which no further term is sought
WORTH = 0.8  # [1] factor by which a further term must lower what is unexplained
MOST_TERMS = 10
FITTED = 0.75  # of the rows; the rest judges

READINGS = ("encoder", "encoder_rate", "gyro", "compass")
ESTIMATES = tuple(f"estimate/{name}" for name in STATE_NAMES)
ADDED = ("excitation", "reference")


class CommandLaw(Protocol):
    """What commands a simulated robot: `reset()`, then for each row of the log `step` gives (left, right) from the
    row's number, the readings by channel and the true state (6,)."""

    @property
    def name(self) -> Say: ...

    def reset(self) -> None: ...

    def step(self, row: int, readings: Mapping[str, float], state: Array) -> tuple[float, float]: ...

    def applied(self, command: Sequence[float]) -> None: ...


@dataclass(frozen=True, eq=False)
class ControllerLaw:
    """A controller, with the logged references (rows, 6), the excitation (rows, 2), and logged channels that no model
    gives, such as the battery (rows,). `by_log`: the log itself names it."""

    controller: Controller
    references: Array
    excitation: Array
    logged: Mapping[str, Array]
    by_log: bool = False

    @property
    def name(self) -> Say:
        kind = self.controller.spec.kind
        if self.by_log:
            return Say("the controller that the log names ({kind})", kind=kind)
        return Say("the given controller ({kind})", kind=kind)

    def reset(self) -> None:
        self.controller.reset()

    def step(self, row: int, readings: Mapping[str, float], state: Array) -> tuple[float, float]:
        own = dict(zip((f"truth/{name}" for name in STATE_NAMES), state.tolist(), strict=True)) | dict(readings)
        measurement = np.array([own[n] if n in own else self.logged[n][row] for n in self.controller.spec.reads])
        left, right = self.controller.step(measurement, self.references[row])
        return left + float(self.excitation[row, 0]), right + float(self.excitation[row, 1])

    def applied(self, command: Sequence[float]) -> None:
        self.controller.applied(command)


@dataclass(frozen=True, eq=False, kw_only=True)
class LinearLaw:
    """Commands, as mean and half difference of both, that are linear in `terms`: gains (2, terms), `constant` (2,).

    `added` (rows, 2) is what the log says was added. `delay` counts rows from reading to command; `explained` is R².
    """

    terms: tuple[str, ...]
    gains: Array
    constant: Array
    added: Array
    delay: int
    explained: float
    _past: list[dict[str, float]] = field(default_factory=list[dict[str, float]], repr=False)
    _sums: dict[str, float] = field(default_factory=dict[str, float], repr=False)

    @property
    def name(self) -> Say:
        part = Quantity(self.explained, "fraction", digits=4)
        return Say("read from the log: {terms} explain {part} of the commands", terms=self.terms, part=part)

    @property
    def estimates(self) -> tuple[str, ...]:
        """The terms that a filter of the program computed, which no model of the robot gives."""
        return tuple(name for name in self.terms if name in ESTIMATES)

    def reset(self) -> None:
        self._past.clear()
        self._sums.clear()

    def step(self, row: int, readings: Mapping[str, float], state: Array) -> tuple[float, float]:
        self._past.append(self._values(readings, state))
        terms = self._past[max(0, len(self._past) - 1 - self.delay)]
        mean, half = self.gains @ [terms[name] for name in self.terms] + self.constant + self.added[row]
        return float(mean - half), float(mean + half)

    def applied(self, command: Sequence[float]) -> None:
        """Nothing depends on it."""

    def _values(self, readings: Mapping[str, float], state: Array) -> dict[str, float]:
        values = _paired(readings) | dict(zip(ESTIMATES, state.tolist(), strict=True))
        values |= {name: readings[name] for name in ESTIMATES if name in readings}
        before = self._past[-1] if self._past else values
        for name in [name for name in values if not name.startswith("estimate/")]:
            self._sums[name] = self._sums.get(name, 0.0) + values[name]
            values |= {f"step of {name}": values[name] - before[name], f"sum of {name}": self._sums[name]}
        return values


def _paired(readings: Mapping[str, Values]) -> dict[str, Values]:
    """Readings, of a row or of all rows, by name; those of two sides as `name` (their mean) and `name turn` (half their
    difference)."""
    values: dict[str, Values] = {}
    for name in READINGS:
        sides = [readings.get(f"sensor/{name}_{side}") for side in ("left", "right")]
        if sides[0] is not None:
            right = sides[0] if sides[1] is None else sides[1]
            values |= {name: (sides[0] + right) / 2, f"{name} turn": (right - sides[0]) / 2}
        elif f"sensor/{name}" in readings:
            values[name] = readings[f"sensor/{name}"]
    return values


def law_of(log: Log, rows: Sequence[str]) -> LinearLaw | float:
    """The linear law of a log from its readings `rows` (channels), or how much of its commands the best one explains.

    The commands are `command/…`, or `applied/…` where those were not logged.
    """
    prefix = "command" if "command/left" in log and "command/right" in log else "applied"
    left, right = log[f"{prefix}/left"], log[f"{prefix}/right"]
    u = np.column_stack([(left + right) / 2, (right - left) / 2])
    terms = _terms(log, rows)
    added = _added(log)
    laws: list[LinearLaw] = []
    for choice in (_forward, _states, _backward):  # states that move together hide each other from one at a time
        laws += [_fitted(u, terms, added, delay, choice) for delay in (0, 1)]
        if max(law.explained for law in laws) >= EXPLAINED:
            break
    best = max(laws, key=lambda law: law.explained)
    return best if best.explained >= EXPLAINED else best.explained


def _terms(log: Log, rows: Sequence[str]) -> dict[str, Array]:
    """What a command may depend on, each (rows,)."""
    table = _paired({row: log[row] for row in rows})
    levels = {name: values for name, values in table.items() if np.isfinite(values).all()}
    for name, values in levels.items():
        table |= {f"step of {name}": np.diff(values, prepend=values[:1]), f"sum of {name}": np.cumsum(values)}
    table |= {name: log[name] for name in ESTIMATES if name in log and np.isfinite(log[name]).all()}
    return {name: values for name, values in table.items() if np.isfinite(values).all() and np.ptp(values) > 0}


def _added(log: Log) -> dict[str, Array]:
    """What was added to the feedback, each (rows,): excitations as mean and half difference, references as they are."""
    added: dict[str, Array] = {}
    if "excitation/left" in log and "excitation/right" in log:
        left, right = log["excitation/left"], log["excitation/right"]
        added |= {"excitation": (left + right) / 2, "excitation turn": (right - left) / 2}
    added |= {n: log[n] for n in log.channels if n.startswith("reference/")}
    return {name: values for name, values in added.items() if np.isfinite(values).all() and np.ptp(values) > 0}


Choice = Callable[[Array, Mapping[str, Array], Array, Mask], list[str]]


def _fitted(u: Array, terms: Mapping[str, Array], added: Mapping[str, Array], delay: int, choice: Choice) -> LinearLaw:
    """The shortest law with this delay, of the terms that `choice` finds."""
    n = len(u) - delay
    y = u[delay:]
    fitted = np.arange(n) < FITTED * n
    known = np.column_stack([np.ones(n), *(values[delay:] for values in added.values())])
    pool = {name: values[:n] for name, values in terms.items()}
    chosen = choice(known, pool, y, fitted)
    weights, _ = _of(known, pool, chosen, y, fitted)
    k = known.shape[1]
    whole = np.column_stack([known, *(pool[c] for c in chosen)]) if chosen else known
    rest = (y - whole @ weights)[~fitted]
    power = float(((y - y.mean(axis=0))[~fitted] ** 2).sum())
    explained = 1 - float((rest**2).sum()) / max(power, 1e-300)
    replayed = np.column_stack(list(added.values())) @ weights[1:k] if added else np.zeros((len(u), 2))
    return LinearLaw(
        terms=tuple(chosen), gains=weights[k:].T, constant=weights[0], added=replayed, delay=delay, explained=explained
    )


def _forward(known: Array, pool: Mapping[str, Array], y: Array, fitted: Mask) -> list[str]:
    """One term after the other, each the one that explains most."""
    chosen = list[str]()
    left = _of(known, pool, [], y, fitted)[1]
    while pool.keys() - chosen and len(chosen) < MOST_TERMS and left > EXACT:
        tries = {name: _of(known, pool, [*chosen, name], y, fitted)[1] for name in pool if name not in chosen}
        name = min(tries, key=lambda one: tries[one])
        if tries[name] > WORTH * left:
            break
        chosen.append(name)
        left = tries[name]
    return chosen


def _states(known: Array, pool: Mapping[str, Array], y: Array, fitted: Mask) -> list[str]:  # noqa: ARG001
    """Every logged estimate: state feedback."""
    return [name for name in pool if name in ESTIMATES]


def _backward(known: Array, pool: Mapping[str, Array], y: Array, fitted: Mask) -> list[str]:
    """All terms, less one after the other that explains least, down to those that all count; none where more than
    `MOST_TERMS` do."""
    chosen = list(pool)
    left = _of(known, pool, chosen, y, fitted)[1]
    while chosen:
        tries = {name: _of(known, pool, [c for c in chosen if c != name], y, fitted)[1] for name in chosen}
        name = min(tries, key=lambda one: tries[one])
        if tries[name] > max(left / WORTH, EXACT):
            break
        chosen.remove(name)
        left = max(left, EXACT)
    return chosen if len(chosen) <= MOST_TERMS else []


def _of(known: Array, pool: Mapping[str, Array], chosen: Sequence[str], y: Array, fitted: Mask) -> tuple[Array, float]:
    """Least squares on what is known and the chosen terms."""
    return _solved(np.column_stack([known, *(pool[name] for name in chosen)]), y, fitted)


def _solved(X: Array, y: Array, fitted: Mask) -> tuple[Array, float]:
    """Least squares (columns, 2) on the `fitted` rows, and the fraction of `y` that they leave there."""
    scale = np.maximum(np.sqrt((X[fitted] ** 2).mean(axis=0)), 1e-300)
    W = np.asarray(np.linalg.lstsq(X[fitted] / scale, y[fitted], rcond=1e-10)[0]) / scale[:, None]
    power = float(((y[fitted] - y[fitted].mean(axis=0)) ** 2).sum())
    return W, float(((y[fitted] - X[fitted] @ W) ** 2).sum()) / max(power, 1e-300)


def law_by(controller: Controller, log: Log) -> ControllerLaw:
    """The law of a controller with what the log has of references and excitation."""
    references = [log[f"reference/{n}"] if f"reference/{n}" in log else np.zeros(len(log)) for n in STATE_NAMES]
    sides = [log[f"excitation/{s}"] if f"excitation/{s}" in log else np.zeros(len(log)) for s in ("left", "right")]
    return ControllerLaw(controller, np.column_stack(references), np.column_stack(sides), dict(log.channels))


def recorded(log: Log) -> ControllerLaw | None:
    """The controller that a log of ours names, where it gives the log's commands from the log's readings."""
    named = log.origin.get("controller")
    facts = {k: v for k, v in named.items() if k not in ("hash", "excitation")} if isinstance(named, Mapping) else {}
    for made in FORMS.values() if facts else ():
        try:
            controller = made(deepcopy(facts))
        except (KeyError, TypeError, ValueError, AttributeError, UprightError):
            continue  # of another form
        if all(name in log for name in controller.spec.reads):
            law = replace(law_by(controller, log), by_log=True)
            if _replayed(law, log) >= EXPLAINED:
                return law
    return None


def _replayed(law: ControllerLaw, log: Log) -> float:
    """R² of the commands that a controller gives on the log's own readings."""
    reads = law.controller.spec.reads
    state = log.state() if law.controller.spec.reads_truth else np.zeros((len(log), len(STATE_NAMES)))
    table = np.column_stack([log[name] for name in reads])
    prefixes = [p for p in ("command", "applied") if f"{p}/left" in log and f"{p}/right" in log]
    if not prefixes:
        return -np.inf
    asked, applied = (np.column_stack([log[f"{p}/left"], log[f"{p}/right"]]) for p in (prefixes[0], prefixes[-1]))
    given = np.empty_like(asked)
    law.reset()
    for row in range(len(log)):
        given[row] = law.step(row, dict(zip(reads, table[row].tolist(), strict=True)), state[row])
        law.applied(applied[row].tolist())
    return 1 - float(((asked - given) ** 2).sum()) / max(float(((asked - asked.mean(axis=0)) ** 2).sum()), 1e-300)
