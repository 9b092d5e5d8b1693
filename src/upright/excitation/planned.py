"""The next experiment to run: an excitation, what it is expected to tell, and what it was checked to keep."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from typing import Any, Self, TypeVar

import numpy as np

from upright.arrays import Array
from upright.calibration.estimate import BOUNDED, CLOSE, MEASURED, NOT_VISIBLE
from upright.control import Controller
from upright.control.excited import Excited
from upright.control.identity import Identity, identity
from upright.errors import InvalidScenario, SpecMismatch
from upright.fleets.binomial import upper_bound
from upright.pages import Message, Quantity, Say, english
from upright.reading import check_schema, check_types, understood
from upright.robots import PARAMETERS

CONFIDENCE = 0.95
SCHEMA = "upright/excite/3"


@dataclass(frozen=True)
class Limits:
    """What a run may risk: the probability of a fall (`falls`), bounded from above; the fraction of periods in which a
    motor is `saturated`, and `travel` [m] from the start, both for 95 of 100 robots."""

    falls: float = 0.01
    saturated: float = 0.05
    travel: float = 0.5

    def __post_init__(self) -> None:
        for name, most in (("falls", 1.0), ("saturated", 1.0), ("travel", math.inf)):
            value = getattr(self, name)
            if not 0 < value <= most:
                raise InvalidScenario(f"a limit of {value:g} on {name}", expected=f"above 0, at most {most:g}")


@dataclass(frozen=True)
class Checked:
    """`samples` robots of which `fell` fell, and the 95th percentiles of the standing ones: fraction of periods
    `saturated`, `travel` [m] and `peak` pitch [rad].

    `dropped` more were drawn, but do not stand without an excitation either: a robot to be excited does.
    """

    samples: int
    fell: int
    dropped: int
    saturated: float
    travel: float
    peak: float

    @property
    def bound(self) -> float:
        """Upper bound of the probability of a fall, with 95 % confidence (Clopper and Pearson 1934)."""
        return upper_bound(self.fell, self.samples, CONFIDENCE)

    def broken(self, limits: Limits) -> dict[str, Say]:
        """The limits that are exceeded, in words, by name."""
        texts = {
            "falls": (
                self.bound,
                Say(
                    "{n} of {all} robots fall, so the probability may be up to {bound}",
                    n=self.fell,
                    all=self.samples,
                    bound=Quantity(self.bound, "fraction"),
                ),
            ),
            "saturated": (
                self.saturated,
                Say("a motor is at its limit in {part} of the time", part=Quantity(self.saturated, "fraction")),
            ),
            "travel": (self.travel, Say("it travels {distance}", distance=Quantity(self.travel, "m"))),
        }
        return {name: text for name, (value, text) in texts.items() if value > getattr(limits, name)}


@dataclass(frozen=True, kw_only=True)
class Predicted:
    """A parameter's `value`, and the widths of its 95 % interval in its `unit`: `before`, `after` the plan, after a
    random binary dither of the plan's energy, drawn anew in every period (`dither`) or `held` for 40 ms, and the
    `least`, after a hundred such runs: what the spreads of other numbers leave, which are to be measured then."""

    name: str
    unit: str
    value: float
    before: float
    after: float
    dither: float
    held: float
    least: float

    @property
    def kind(self) -> str:
        """What a calibration's log will be said to tell: `MEASURED`, `BOUNDED` or `NOT_VISIBLE`."""
        if self.after >= VISIBLE * self.before:
            return NOT_VISIBLE
        return MEASURED if self.after / 2 <= CLOSE * abs(self.value) else BOUNDED


@dataclass(frozen=True)
class Tried:
    """A way of exciting: the `energy` at which it keeps the limits, and the geometric mean by which it `shrinks` the
    intervals in question."""

    name: str
    energy: float
    shrinks: float


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PlannedRun:
    """`excitation` (rows, 2), to be added to the commands [unit] of one controller (by `hash`, or `asked` and
    `response`: see `control/identity.py`), each row for `hold` periods of `period` [s]; read-only.

    `division` gives the fraction of its energy by part. `energy` is ∫ u_l² + u_r² dt at the nominal robot's motors,
    the loop's response included; `added` that of the excitation alone. `checked` was measured with the
    excitation `margin` times as large. `saved` is its file, once it is written.
    """

    robot: str
    kit: str
    controller: str
    hash: str
    period: float
    unit: str
    hold: int
    way: str
    division: Mapping[str, float]
    excitation: Array
    energy: float
    added: float
    focus: tuple[str, ...]
    limits: Limits
    margin: float
    checked: Checked
    predicted: tuple[Predicted, ...]
    tried: tuple[Tried, ...]
    seed: int
    notes: tuple[Say, ...] = ()
    asked: str = ""
    response: tuple[float, ...] = ()
    saved: str = ""

    def __post_init__(self) -> None:
        rows = np.array(self.excitation, dtype=np.float64)
        if rows.ndim != 2 or rows.shape[1] != 2 or not np.isfinite(rows).all():
            raise InvalidScenario(f"an excitation of shape {rows.shape}", expected="finite numbers (rows, 2)")
        rows.setflags(write=False)
        object.__setattr__(self, "excitation", rows)

    def __getitem__(self, name: str) -> Predicted:
        return next(p for p in self.predicted if p.name == name)

    @property
    def seconds(self) -> float:
        """How long it lasts [s]."""
        return len(self.excitation) * self.hold * self.period

    @property
    def own(self) -> list[Predicted]:
        """The parameters of the robot itself, without delays and motors, as a calibration counts them."""
        return [p for p in self.predicted if p.name in PARAMETERS or p.name == "roll_fraction"] or [*self.predicted]

    @property
    def shrinks(self) -> float:
        """The geometric mean by which the plan shrinks the intervals in question, as `Tried` has it."""
        meant = self.focus or [p.name for p in self.predicted if p.name in PARAMETERS]
        return float(np.exp(np.mean([math.log(p.after / p.before) for p in self.predicted if p.name in meant])))

    @property
    def sequence(self) -> Array:
        """(periods, 2): what is added in each period."""
        return np.repeat(self.excitation, self.hold, axis=0)

    def excited(self, controller: Controller) -> Excited:
        """`controller` with this excitation; raises `SpecMismatch` for one of another period or unit."""
        spec = controller.spec
        if not math.isclose(spec.period, self.period, rel_tol=1e-9) or spec.command_unit != self.unit:
            raise SpecMismatch(
                f"a controller of {spec.command_unit} every {spec.period:g} s with a plan of {self.unit} every "
                f"{self.period:g} s", expected="the controller that the plan was made with", hint="make the plan anew",
            )  # fmt: skip
        return Excited(controller, self.sequence)

    def differs(self, controller: Controller) -> str:
        """Why this plan was checked with another controller, as part of a sentence; empty where it was not."""
        return identity(controller).differs(Identity(self.hash, self.asked, self.response))

    def check(self) -> tuple[str, ...]:
        """What of this plan does not follow from its own numbers, or breaks its limits; nothing where it may be run."""
        added = float((self.excitation**2).sum() * self.hold * self.period)
        wrong = (
            []
            if math.isclose(added, self.added, rel_tol=1e-6)
            else [f"what is added has {added:g}, not {self.added:g}"]
        )
        wrong += map(str, self.checked.broken(self.limits).values())
        wrong += [
            f"{p.name}: {p.after:g} is wider than before" for p in self.predicted if p.after > p.before * (1 + 1e-6)
        ]
        total = sum(self.division.values())
        return (*wrong, *(() if abs(total - 1) < 1e-6 else (f"the fractions of the energy sum to {total:g}",)))

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; `upright calibrate` needs none of them, `upright simulate --excite` all."""
        parts = {f.name: getattr(self, f.name) for f in fields(self) if f.name not in ("division", "saved")}
        parts |= {name: asdict(parts[name]) for name in ("limits", "checked")}
        parts["predicted"] = [asdict(p) | {"kind": p.kind} for p in self.predicted]
        parts["tried"] = [asdict(p) for p in self.tried]
        parts |= {name: list(parts[name]) for name in ("focus", "response")}
        parts["notes"] = [english(note) for note in self.notes]
        parts["excitation"] = self.excitation.tolist()
        derived = {"bound": self.checked.bound, "shrinks": self.shrinks}
        return {"schema": SCHEMA} | parts | {"shares": dict(self.division)} | derived

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Self:
        """The inverse of `to_json`; raises `InvalidScenario` for what is no plan, or contradicts itself."""
        with understood("this is no plan: it", InvalidScenario, "JSON by upright excite"):
            plan = _read(cls, data)
            check_types(plan)
            wrong = plan.check()
        if wrong:
            raise InvalidScenario(f"the plan contradicts itself: {wrong[0]}", hint="make it anew with upright excite")
        return plan


VISIBLE = 0.5  # of the interval before: narrower ones are called visible, as in `identify.summary`
P = TypeVar("P", bound=PlannedRun)


def _read(cls: type[P], data: Mapping[str, Any]) -> P:
    given = dict(data)
    check_schema(given, SCHEMA, InvalidScenario)
    given["division"] = given.pop("shares")
    for name in ("bound", "shrinks"):
        given.pop(name, None)
    parts: dict[str, Any] = {
        "limits": Limits(**given["limits"]),
        "checked": Checked(**given["checked"]),
        "predicted": tuple(Predicted(**{k: v for k, v in row.items() if k != "kind"}) for row in given["predicted"]),
        "tried": tuple(Tried(**row) for row in given["tried"]),
        "focus": tuple(given["focus"]),
        "notes": tuple(map(Message, given["notes"])),
        "response": tuple(map(float, given.get("response", ()))),
        "excitation": np.array(given["excitation"], dtype=np.float64),
    }
    return cls(**{**given, **parts})
