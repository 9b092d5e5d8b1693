"""What belongs to a run and not to the robot: how friction, the winding, the supply, the floor and the firmware's dead
times differ from one run of a robot to the next.

A run's own number is the robot's plus a deviation with a normal prior. Of several runs the spread of the deviations is
estimated; of one alone nobody can tell its number from the robot's. The robot is the mean of its runs, with
intervals as wide as the spread between runs makes them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.calibration.electronics import BATTERY, CONSTANT
from upright.calibration.parameters import Parameter

RUN = "run "
"""How the names of deviations begin: "run 0/motor_friction"."""

FRACTIONS = {"motor_friction": 0.3, "wheel_friction": 0.3, "coulomb_friction": 0.3, "rolling_friction": 0.5,
          "motor_resistance": 0.025}  # fmt: skip
"""Standard deviation between runs, over the number. Where one run is 6 K warmer than another, grease has lost a quarter
of its viscosity (half in 15 K) and copper is 2.4 % more resistive; dry friction differs by load, and rolling friction
by floor: 0.01 to 0.02 of the load for rubber on tiles or wood, several times that on a carpet."""
FIRMWARE = 0.005
"""[s] Standard deviation of dead times between runs: half of a period of most programs, since another program reads its
sensors at another moment."""

OWN = {BATTERY: 0.5, CONSTANT: 1.0}
"""Standard deviation between runs, over that of the prior: half a supply's uncertainty is its charge, and every run has
a floor of its own. Where there is one log, these and the dead times are those of this log."""

WORTH = 2.0
"""[runs] What the stated spread counts where runs are there to estimate it from."""


def spread_of(p: Parameter, value: float) -> float:
    """Standard deviation between runs of a number of the robot that is `value`, in deviations of its prior; zero of
    what does not differ."""
    return FRACTIONS.get(p.name, 0.0) * (p.prior if p.scale == "logarithm" else abs(value)) / p.spread


def effects_of(parameters: Sequence[Parameter], runs: int) -> tuple[Parameter, ...]:
    """The deviations of each of several `runs`, by run; none where there is one."""
    return tuple(
        Parameter(f"{RUN}{run}/{name}", "1", 0.0, size, "linear")
        for run in range(runs if runs > 1 else 0)
        for name, size in run_spreads(parameters).items()
    )


def run_spreads(parameters: Sequence[Parameter]) -> dict[str, float]:
    """Standard deviation between runs of each number that differs, in deviations of its prior."""
    sizes = {p.name: spread_of(p, p.prior or p.spread) for p in parameters}
    sizes |= {p.name: OWN[p.name] for p in parameters if p.name in OWN}
    sizes |= {p.name: FIRMWARE / p.spread for p in parameters if p.name.startswith("delay/")}
    return {name: size for name, size in sizes.items() if size > 0}


def maps_of(parameters: Sequence[Parameter], runs: int) -> Array:
    """How the numbers of each run follow from z (runs, shared, parameters): the shared ones, plus its deviations."""
    names = [p.name for p in parameters if not p.name.startswith(RUN)]
    maps = np.repeat(np.eye(len(names), len(parameters))[None], runs, axis=0)
    for column, p in enumerate(parameters):
        if p.name.startswith(RUN):
            run, _, name = p.name.removeprefix(RUN).partition("/")
            maps[int(run), names.index(name), column] = p.spread
    return maps


def of_robot(parameters: Sequence[Parameter], z: Array, C: Array, runs: int) -> tuple[Array, Array]:
    """The robot's coordinates (n,) and their covariance (n, n), from those of a fit of several `runs`, or of one: the
    mean of its runs, with what the spread between runs leaves unknown of it."""
    maps = maps_of(parameters, runs)
    mean = np.zeros_like(C)
    mean[: maps.shape[1]] = maps.mean(axis=0)
    robot = mean @ z
    total = mean @ C @ mean.T
    least = np.array([p.least for p in parameters[: maps.shape[1]]])
    robot[: len(least)] = np.maximum(maps @ z, least).mean(axis=0)  # what no run has less of, their mean has not
    estimated = {p.name.partition("/")[2]: p.spread for p in parameters if p.name.startswith(RUN)}
    for i, p in enumerate(parameters):
        if p.name in FRACTIONS:
            total[i, i] += estimated.get(p.name, spread_of(p, float(p.value(robot[i])))) ** 2 / runs
    return robot, total


def respread(parameters: Sequence[Parameter], z: Array, C: Array) -> tuple[tuple[Parameter, ...], Array]:
    """The parameters with the spreads between runs that z (n,) and its covariance C (n, n) show, and z in these: one
    step of expectation and maximisation (Dempster, Laird and Rubin 1977), the stated spread worth `WORTH` runs."""
    updated = list(parameters)
    new = z.copy()
    rows: dict[str, list[int]] = {}
    for i, p in enumerate(parameters):
        if p.name.startswith(RUN):
            rows.setdefault(p.name.partition("/")[2], []).append(i)
    shared = [p for p in parameters if not p.name.startswith(RUN)]
    stated = {p.name: p.spread for p in effects_of(shared, max(map(len, rows.values()), default=0))}
    for several in rows.values():
        size = stated[parameters[several[0]].name]
        squares = sum(parameters[i].spread ** 2 * (z[i] ** 2 + C[i, i]) for i in several)
        spread = float(((WORTH * size**2 + squares) / (WORTH + len(several))) ** 0.5)
        for i in several:
            updated[i], new[i] = replace(updated[i], spread=spread), z[i] * parameters[i].spread / spread
    return tuple(updated), new
