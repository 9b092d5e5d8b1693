"""Models of one log by several methods: which of their regulators hold the robot, and which model to take."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from upright.atomic import finite
from upright.identification.identified import OUTPUTS, Identified, doubling, known_bias, known_pole
from upright.identification.judge import HELD, Judge, LoopTrial
from upright.identification.methods import TITLES
from upright.identification.order import OrderChoice
from upright.identification.samples import Samples
from upright.logs.raw import named
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
    Result,
    Say,
    Table,
    Verdict,
    english,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PRIOR = "calibrate"  # the method that starts from what is known of the robot
ALIKE = 1.1  # times the least lean: the same to within what another seed changes


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class MethodComparison(Result):
    """The models of one log by method, the trial of each in the loop of the `judge`, and why a method has none.

    `true_pole` [1/s] is that of the twin that made the log, with dry friction as the damping with the same braking; NaN
    where it is unknown.
    """

    samples: Samples
    models: Mapping[str, Identified]
    trials: Mapping[str, LoopTrial]
    failed: Mapping[str, str]
    orders: Mapping[str, OrderChoice]
    judge: Judge
    true_pole: float
    notes: tuple[Say, ...] = ()

    @property
    def delays(self) -> dict[str, int]:
        """How many periods each output comes after a command, which is taken out before any fit."""
        return {name: n for part in self.samples.parts for name, n in zip(part.outputs, part.delays, strict=True)}

    @property
    def holding(self) -> list[str]:
        """Methods whose regulators hold the robot, the one first after whose release it leans least."""
        leans = {name: trial.largest or 0.0 for name, trial in self.trials.items() if trial.holds}
        return sorted(leans, key=leans.__getitem__)

    @property
    def alike(self) -> list[str]:
        """Of these, those that lean about as little as the least."""
        leans = {name: self.trials[name].largest or 0.0 for name in self.holding}
        return [name for name in self.holding if leans[name] <= ALIKE * min(leans.values())]

    @property
    def best(self) -> str:
        """Of those that lean alike the one with the surest pole, since their order is chance; empty where none holds
        the robot."""
        widths = {name: self.models[name].pole.high - self.models[name].pole.low for name in self.alike}
        return min(widths, key=lambda name: widths[name] if math.isfinite(widths[name]) else math.inf, default="")

    def check(self) -> tuple[str, ...]:
        """What is wrong with the comparison, from its own numbers."""
        return tuple(f"{name}: its halves do not make it up" for name, m in self.models.items() if m.check() > 1e-6)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        return {
            "schema": "upright/identify-all/1",
            "models": {name: model.to_json() for name, model in self.models.items()},
            "in_the_loop": {name: trial.to_json() for name, trial in self.trials.items()},
            "best": self.best, "alike": self.alike, "failed": dict(self.failed), "judge": english(self.judge.who),
            "orders": {name: order.to_json() for name, order in self.orders.items()}, "delays": self.delays,
            "notes": [english(note) for note in self.notes], "true_pole": finite(self.true_pole),
        }  # fmt: skip

    def plot(self) -> Figure:
        """The unstable pole of each method with its 95 % interval, in a colour that says whether its regulator holds
        the robot, and the true pole where it is known."""
        from upright.plotting import AXIS, COLOURS, legend, rows_of

        figure, ax = rows_of(list(self.models), str(Say("unstable pole [1/s]")), "")
        if math.isfinite(self.true_pole):
            label = str(Say("true pole"))
            ax.axvline(self.true_pole, linestyle="--", linewidth=1, color=AXIS, label=label, zorder=1)
        kinds = ((Say("regulator holds"), True, COLOURS[2], "o"), (Say("does not"), False, COLOURS[1], "x"))
        for words, holds, colour, mark in kinds:
            rows = [k for k, n in enumerate(self.models) if (n not in self.trials or self.trials[n].holds) == holds]
            poles = [m.pole for k, m in enumerate(self.models.values()) if k in rows]
            ax.hlines(rows, [p.low for p in poles], [p.high for p in poles], linewidth=2.5, color=colour)
            ax.plot([p.value for p in poles], rows, mark, markersize=5, color=colour, label=str(words))
        return legend(figure)

    def page(self) -> Page:
        """The comparison for people."""
        holding = self.holding
        data = self.samples
        verdict = Verdict(Say("none can be used"), "bad")
        following: list[Next] = []
        if self.best:
            verdict = Verdict(Say("take the model of {method}", method=self.best), "good")
            following = [
                Next(
                    "identify",
                    named(data.log),
                    method=self.best,
                    output="model.json",
                    regulator="regulator.json",
                    why=Say("It writes that model and a regulator for it."),
                )
            ]
        facts = {"n": len(holding), "all": len(self.models), "robot": data.robot.name}
        title = Say("{n} of {all} methods give a model that balances {robot}", **facts)
        if len(holding) == 1:
            title = Say("One of {all} methods gives a model that balances {robot}", **facts)
        lead = [
            Say("Each model's regulator had to hold {robot}, let go at {angle}.",
                robot=self.judge.who, angle=Quantity(HELD, "rad", digits=2)),
        ]  # fmt: skip
        if len(self.alike) > 1:
            part = Quantity(self.models[self.best].pole.within, "fraction", digits=2)
            lead.append(Say("Several lean about equally far; {method} knows the pole best, to ±{part}.",
                            method=self.best, part=part))  # fmt: skip
        return Page(
            title, verdict=verdict, lead=lead, numbers=_numbers(self), picture=Picture(_claim(self), self.plot),
            next=following, blocks=[_trials(self), *_folds(self)],
            origin={"log": named(data.log), "robot": data.robot.name, "kit": data.kit.name},
        )  # fmt: skip


def _numbers(compared: MethodComparison) -> list[KeyNumber]:
    best = compared.best
    numbers: list[KeyNumber] = []
    if best:
        pole = compared.models[best].pole
        meaning = Say("unstable pole by {method}", method=best)
        if math.isfinite(pole.low):
            within = Quantity(None, "1/s", low=pole.low, high=pole.high)
            meaning = Say("unstable pole by {method}; 95 % interval {within}", method=best, within=within)
        numbers.append(KeyNumber(Quantity(pole.value, "1/s"), meaning))
        numbers.append(KeyNumber(doubling(pole), Say("in which a lean doubles")))
        lean = Quantity(compared.trials[best].largest, "rad", digits=3)
        numbers.append(KeyNumber(lean, Say("largest lean under the regulator of {method}", method=best)))
    return numbers


def _claim(compared: MethodComparison) -> Say:
    inside = {n for n, m in compared.models.items() if m.pole.low <= compared.true_pole <= m.pole.high}
    if inside and inside == set(compared.holding):
        return Say("A regulator holds where the 95 % interval of the pole contains the true one")
    return Say("The unstable pole, the rate at which a lean grows, with its 95 % interval")


def _trials(compared: MethodComparison) -> Table:
    rows = [
        [name, trial.verdict, known_pole(compared.models[name].pole, ""), trial.largest, trial.restless]
        for name, trial in compared.trials.items()
    ]
    columns = [
        Column(Say("method")), Column(Say("in the loop")), Column(Say("unstable pole [1/s]")),
        Column(Say("largest lean"), "rad"), Column(Say("rms at rest"), "rad"),
    ]  # fmt: skip
    return Table(columns, rows)


def _folds(compared: MethodComparison) -> list[Fold]:
    methods = Table([Column(Say("method")), Column(Say("how"))], [[n, TITLES.get(n)] for n in compared.trials])
    folds = [
        Fold(Say("How far each pole is off"), _biases(compared)),
        Fold(Say("Predictions"), [_predictions(compared)]),
        Fold(Say("What the methods are"), [methods]),
    ]
    notes = list(compared.notes)
    notes += [
        Say("{method}: {note}", method=name, note=note)
        for name, model in compared.models.items()
        for note in model.notes
        if note not in compared.notes
    ]
    notes += [Say("{method}: {note}", method=name, note=Message(why)) for name, why in compared.failed.items()]
    if notes:
        folds.append(Fold(Say("Notes"), [Items(notes)]))
    return folds


def _biases(compared: MethodComparison) -> list[Block]:
    rows: list[list[Any]] = []
    for name, model in compared.models.items():
        pole = model.pole
        bias = known_bias(pole) if math.isfinite(pole.bias) else None
        free = None
        if pole.without_friction:
            value, low, high = pole.without_friction
            free = Quantity(value, "1/s", low=low, high=high)
        rows.append([name, bias, Quantity(pole.corrected, "1/s"), free])
    columns = [Column(Say("method")), Column(Say("bias")), Column(Say("pole − bias")),
               Column(Say("pole without dry friction"))]  # fmt: skip
    kept = 4 if any(row[3] for row in rows) else 3  # a column of dashes says nothing
    items = [
        Say("The bias is the median error on logs simulated with the subspace model, whose pole is known."),
        Say("An interval holds the scatter of noise; dry friction and dead zones may move the pole further."),
    ]
    if PRIOR in compared.models:
        items.append(Say("Calibrate starts from the robot's file, which narrows its interval."))
    if math.isfinite(compared.true_pole):
        items.append(Say("The true pole is {pole}.", pole=Quantity(compared.true_pole, "1/s")))
    return [Table(columns[:kept], [row[:kept] for row in rows]), Items(items)]


def _predictions(compared: MethodComparison) -> Picture:
    outputs = compared.samples.parts[0].outputs

    def draw() -> Figure:
        from upright.plotting import legend, line, panels

        labels = [str(Say("skill for {output} [%]", output=OUTPUTS[output])) for output in outputs]
        figure, axes = panels(labels, str(Say("samples predicted ahead")), "log")
        for ax, output in zip(axes, outputs, strict=True):
            for name, m in compared.models.items():
                line(ax, name, [float(h) for h in m.fits], [fit.get(output, math.nan) for fit in m.fits.values()])
            ax.set_ylim(0, 100)
        return legend(figure)

    note = Say("A stable model forgets an error of its start; far ahead it may predict better, and is wrong.")
    return Picture(Say("Skill of predictions on the held-out part of the log"), draw, note)
