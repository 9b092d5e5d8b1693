"""What a certificate measures: drawn robots under the standard pushes, and how much later or slower the loop may run.

All of it is the nonlinear model in the batch kernel, with the kit's quanta, noise, dead time, limits and battery.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.control.controller import Controller
from upright.control.linear_controller import as_linear
from upright.errors import InvalidController, SpecMismatch
from upright.experiment.pushes import Hold, Impulse
from upright.fleet.ensemble import tables
from upright.fleet.kernel import simulate
from upright.fleet.kernel_batch import NAMES, FleetBatch, FleetResult, Gains, parameters_of
from upright.robots import Kit, Robot

Array = NDArray[np.float64]

SECONDS = 8.0  # [s] a push, what follows it, and `TAIL` to see what the robot does at rest
RELEASE = 3.0  # [s] a hold of this length lets every preset come to rest against it
TAIL = 2.0  # [s] at the end, over which the limit cycle is measured: several of its periods
FRONT, BACK = 0.1, -0.12  # [rad] both holds of Herrera et al. (2015)
KNOCK = 0.15  # [m/s] of the body's speed by the impulse: half of walking into it slowly
BATTERIES = {"low": 0.85, "full": 1.12}
"""Shares of the kit's voltage: six AA cells under load give 7 to 9 V for 8, two lithium cells 6.4 to 8.4 V for 7.5."""

LATER = (0.25, 0.5, 1.0, 1.5, 2.0)
"""Further dead times that are tried, in periods."""

SLOWER = (0.5, 0.8, 1.25, 1.5, 2.0)
"""Periods that are tried, as shares of the controller's own."""

SWEPT = 100
"""How many of the drawn robots the sweeps are run with."""

_STEP = 0.001  # [s] of the body, as everywhere
_MOST = 95  # per cent: what one run in twenty exceeds


@dataclass(frozen=True)
class Trial:
    """One push at one battery: `runs`, how many `fell`, and what 95 % of the standing ones stay below: `saturated`
    (share of periods), `travel` [m], `peak` pitch [rad] and `cycle`, half of pitch's range in the last seconds [rad].

    The numbers are zero where nothing stood.
    """

    push: str
    battery: str
    runs: int
    fell: int
    saturated: float
    travel: float
    peak: float
    cycle: float


@dataclass(frozen=True)
class Swept:
    """`fell` of `runs` with `value` [s] of further dead time, or as the period."""

    value: float
    runs: int
    fell: int


def linear_gains(controller: Controller, robot: Robot, kit: Kit) -> Gains:
    """The controller as the kernel runs it; `SpecMismatch` for one that is not linear, that reads what no sensor of the
    kit gives, or that commands another unit."""
    try:
        gains = Gains.of(as_linear(controller))
    except InvalidController:
        raise SpecMismatch(
            f"a {controller.spec.kind} cannot be certified", expected="a linear controller, which the kernel can run",
            mend="certify an lqg, lqi, hinf, pid or robust one",
        ) from None  # fmt: skip
    if gains.command_unit != robot.command_unit:
        raise SpecMismatch(f"the controller commands {gains.command_unit}", expected=f"{robot.command_unit}")
    if controller.spec.reads_truth and kit.name != "ideal":
        raise SpecMismatch(
            f"a {controller.spec.kind} that reads the true state, on kit '{kit.name}'",
            expected="a controller of its sensors", mend="put a filter before it, or certify on the kit 'ideal'",
        )  # fmt: skip
    return gains


def standard_pushes(robot: Robot) -> dict[str, Any]:
    """Both holds of the paper, then released, and a knock at the centre of mass."""
    return {
        f"hold at {FRONT:+.2f} rad": Hold(pitch=FRONT, until=RELEASE),
        f"hold at {BACK:+.2f} rad": Hold(pitch=BACK, until=RELEASE),
        f"knock by {KNOCK:g} m/s": Impulse(impulse=KNOCK * robot.body_mass, at_time=1.0, duration=0.02),
    }


def trials(
    gains: Gains, robot: Robot, robots: Sequence[Robot], kit: Kit, seed: int, threads: int | None = None
) -> tuple[tuple[Trial, ...], NDArray[np.bool_]]:
    """Every standard push at every battery on all `robots`, and which robots (n,) fell in any of them."""
    parameters = parameters_of(robots)
    fell = np.zeros(len(robots), dtype=np.bool_)
    found: list[Trial] = []
    for name, push in standard_pushes(robot).items():
        for battery, share in BATTERIES.items():
            batch = _batch(gains, parameters, [push], kit, seed, len(found), _battery(kit, robot, share))
            result = simulate(batch, SECONDS, record=1, channels=("truth/pitch",), threads=threads)
            found.append(_trial(name, battery, result, parameters, gains.period))
            fell |= result.fell
    return tuple(found), fell


def later(
    gains: Gains, robot: Robot, robots: Sequence[Robot], kit: Kit, seed: int, threads: int | None = None
) -> tuple[Swept, ...]:
    """Falls under every standard push with `LATER` periods of further dead time, which the controller does not know."""
    extra = sorted({round(share * gains.period / _STEP) * _STEP for share in LATER} - {0.0})
    return tuple(
        _swept(value, gains, robot, robots, kit, seed, {"delay": [kit.delay + value]}, threads) for value in extra
    )


def slower(
    gains: Gains, robot: Robot, robots: Sequence[Robot], kit: Kit, seed: int, threads: int | None = None
) -> tuple[Swept, ...]:
    """Falls under every standard push where the loop runs every `SLOWER` share of its period with the same gains."""
    periods = sorted({max(1, round(share * gains.period / _STEP)) * _STEP for share in SLOWER})
    allowed = [period for period in periods if period >= kit.jitter]  # the kernel takes no later command than that
    return tuple(
        _swept(period, gains._replace(period=period), robot, robots, kit, seed, {}, threads) for period in allowed
    )


def _swept(
    value: float, gains: Gains, robot: Robot, robots: Sequence[Robot], kit: Kit, seed: int,
    changes: Mapping[str, Any], threads: int | None,
) -> Swept:  # fmt: skip
    parameters = parameters_of(robots[:SWEPT])
    fell = runs = 0
    for row, push in enumerate(standard_pushes(robot).values()):
        batch = _batch(gains, parameters, [push], kit, seed, row, changes)
        result = simulate(batch, SECONDS, threads=threads)
        fell, runs = fell + int(result.fell.sum()), runs + batch.n
    return Swept(value, runs, fell)


def _batch(
    gains: Gains, parameters: Array, pushes: Sequence[Any], kit: Kit, seed: int, row: int, changes: Mapping[str, Any]
) -> FleetBatch:
    """The robots once each; `row` numbers the trial, so that each has its own noise."""
    n = len(parameters)
    index = np.arange(row * n, (row + 1) * n, dtype=np.uint64)
    pushed = tables(pushes, (), parameters).pushes
    return FleetBatch(
        parameters=parameters, controller=gains, kit=kit, kit_changes=changes, pushes=pushed, seed=seed, index=index,
        period=_STEP,
    )  # fmt: skip


def _battery(kit: Kit, robot: Robot, share: float) -> dict[str, list[float]]:
    """A torque drive has no battery in its equations."""
    known = robot.command_unit == "V" and math.isfinite(kit.battery.voltage)
    return {"battery.voltage": [share * kit.battery.voltage]} if known else {}


def _trial(push: str, battery: str, result: FleetResult, parameters: Array, period: float) -> Trial:
    stood = ~result.fell
    radius = parameters[:, NAMES.index("wheel_radius")]
    ending = result.trace[stood, -max(1, round(TAIL / period)) :, 0]
    swings = (ending.max(axis=1) - ending.min(axis=1)) / 2
    numbers = (result.saturated[stood], (result.peak[:, 1] * radius)[stood], result.peak[stood, 0], swings)
    return Trial(push, battery, len(stood), int((~stood).sum()), *(_most(values) for values in numbers))


def _most(values: Array) -> float:
    return float(np.percentile(values, _MOST)) if len(values) else 0.0
