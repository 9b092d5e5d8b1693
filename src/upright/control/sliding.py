"""Sliding mode in discrete time: a reaching law with a boundary layer, behind the Kalman filter."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Complex
from upright.compiled.tracer import Form, Tracer
from upright.control.delay import sampled
from upright.control.design import Design
from upright.control.kalman import RECOVERED, Disturbed, kalman_filter
from upright.control.linear_controller import Law, LinearController, Nonlinearity, Remembering
from upright.control.lqg import Lqg, regulated
from upright.control.observer import memory, steady_state
from upright.errors import DesignFailed, InvalidController
from upright.physics.linear import poles_of
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import SIDES

SINGULAR = 1e9  # [1] condition of a cost that is of rank one but for rounding
TIME, REACH, LAYER = 0.05, 0.02, 0.1
"""[s] in which the distance to the surface decays, and step and half width of the layer, of the usual command."""


@dataclass(frozen=True, eq=False)
class Sliding(Design):
    """The surface S with S B = I, from the cost P of the regulator `base`; `keep` of s is left each period. Where
    nothing shows the heading, S B = I for both motors alike, and S B = 0 for both opposed.

    On s = 0 the state moves by A − B S A, which lowers xᵀPx at least as much as the regulator itself does.
    """

    base: Lqg
    S: Array
    keep: float

    def poles(self) -> Complex:
        """Of the loop outside the layer's switching: those of the sliding motion and `keep` twice; largest first."""
        plant = self.base.plant
        closed = plant.A - plant.B @ self.S @ (plant.A - self.keep * np.eye(len(plant.A)))
        return poles_of(closed, continuous=False)

    def check(self) -> float:
        """The largest of both Riccati residuals and of |S B S − S|, over the largest of S."""
        left = self.S @ self.base.plant.B @ self.S - self.S
        return max(self.base.check(), float(np.abs(left).max() / np.abs(self.S).max()))


@dataclass(frozen=True, eq=False)
class Switching(Nonlinearity):
    """u loses `reach` · sat(s / `layer`), s (2,)."""

    reach: float
    layer: float

    @property
    def slope(self) -> Array:
        """That of sat inside the layer."""
        return -self.reach / self.layer * np.eye(2)

    def forms(self, t: Tracer, linear: Sequence[Form], s: Sequence[Form], /) -> tuple[list[Form], list[Form]]:
        """The command of each motor."""
        bounded = [
            t.let(f"surface_{side}", form * (1 / self.layer), "1", 1.0) for side, form in zip(SIDES, s, strict=True)
        ]
        return [row - surface * self.reach for row, surface in zip(linear, bounded, strict=True)], []


@dataclass(eq=False, repr=False)
class SlidingMode(Remembering):
    """u = u_lin − reach · sat(s / layer) for each motor, from the outputs [s, u_lin] of `memory`, in command units.

    With u_lin = u_r r − S A ξ + keep · s follows s⁺ = keep · s − reach · sat(s / layer). (Gao, Wang and Homaifa 1995,
    with a boundary layer in place of the sign.) Inside the layer nothing chatters while reach ≤ keep · layer.
    """

    form: ClassVar[str] = "sliding"
    memory: LinearController
    reach: float
    layer: float
    design: Sliding | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        if not (0 <= self.reach < math.inf and 0 < self.layer < math.inf):
            raise InvalidController(
                f"reach is {self.reach} and layer {self.layer}", expected="a reach of zero or more, a positive layer"
            )

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        s_left, s_right, left, right = self.memory.outputs(measurement, reference).tolist()
        left -= self.reach * min(max(s_left / self.layer, -1.0), 1.0)
        right -= self.reach * min(max(s_right / self.layer, -1.0), 1.0)
        self.memory.decided(left, right)
        return left, right

    def law(self) -> Law:
        return self.memory.law_with(Switching(self.reach, self.layer), np.eye(2, 4, 2), slice(2))

    def to_json(self) -> dict[str, Any]:
        return self.memory.facts() | {"reach": self.reach, "layer": self.layer, "memory": self.memory.matrices()}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> SlidingMode:
        """The inverse of `to_json`; the design's record stays behind."""
        return cls(LinearController.memory_from_json(data), data["reach"], data["layer"])


def sliding(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    time: float = TIME,
    reach: float = REACH,
    layer: float = LAYER,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed = RECOVERED,
) -> SlidingMode:
    """The sliding mode controller of `robot` on the sensors of `kit`, on the surface s = (BᵀPB)⁻¹BᵀP ξ (Utkin 1992).

    P is the regulator's cost under Q and R, as in `lqg`; s shrinks with the time constant `time` [s] and by `reach`
    each period outside of ± `layer`, both as fractions of the largest usual command. Raises `DesignFailed` like `lqg`.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    if not (time > 0 and layer > 0 and reach >= 0):
        raise DesignFailed(
            f"time {time}, reach {reach}, layer {layer}", expected="positive numbers, reach zero or more"
        )
    model = sampled(robot, kit, dt, reads)
    keep = math.exp(-model.dt / time)
    if reach > keep * layer:
        raise DesignFailed(
            f"a reach of {reach:g} chatters in a layer of {layer:g}", expected=f"at most {keep * layer:.3g} of reach",
            hint="widen the layer",
        )  # fmt: skip
    base = regulated(kalman_filter(model, disturbed), Q, R)
    B = model.plant.B
    S = _divided(B.T @ base.P, B.T @ base.P @ B)
    design = Sliding(base, S, keep)
    usual = 1 / math.sqrt(float(base.R.diagonal().mean()))
    return SlidingMode(_memory(design), reach * usual, layer * usual, design)


def _divided(row: Array, by: Array) -> Array:
    """`by`⁻¹ `row`, where `by` (2, 2) is of lower rank where nothing shows the heading: it asks nothing then."""
    regular = np.linalg.cond(by) < SINGULAR
    result = np.linalg.solve(by, row) if regular else np.linalg.pinv(by, rcond=1 / SINGULAR) @ row
    return np.asarray(result, dtype=np.float64)


def _memory(design: Sliding) -> LinearController:
    """Outputs s = S (ξ − ξ_r) and u_r r − S (A − keep) (ξ − ξ_r)."""
    estimator = design.base.filter
    A, (xi_r, u_r) = estimator.sampled.plant.A, steady_state(estimator.sampled)
    G = np.vstack([design.S, -design.S @ (A - design.keep * np.eye(len(A)))])
    H = np.vstack([np.zeros((2, 6)), u_r]) - G @ xi_r
    return memory(estimator, G, np.zeros(4), H, kind="sliding")
