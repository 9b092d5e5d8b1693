"""All controllers on one robot under the same pushes: one row for each."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies import Body, Electronics, make_body
from upright.certify.checks import Course, kernel_controller, watched
from upright.comparison.comparison import compare
from upright.control import CONTROLLERS, Controller, make_controller
from upright.errors import UprightError
from upright.experiment import Hold, Impulse, outcome_of, run
from upright.fleet.push_map import CEILING, FLOOR, largest
from upright.robots import Kit, Robot
from upright.robots.uncertainty import draw

Array = NDArray[np.float64]

PUSHES = {"front": 0.1, "back": -0.12}
"""Pitch [rad] at which each push holds the robot (Herrera et al. 2015, section 3.2)."""
UNTIL, SECONDS = 3.0, 7.0  # [s]
STRUCK, KNOCK, WATCHED = 1.0, 0.02, 3.0  # [s] when a knock comes, how long it is, and how long it is watched
GUESS = 0.3  # [m/s] of the whole robot: what most controllers survive about
TOLERANCE = 0.03
"""Relative: readings of a degree make the last few per cent a matter of chance."""
DRAWN = 200
"""Robots over the spreads: a fraction of one in a hundred shows."""


@dataclass(frozen=True, kw_only=True)
class BenchRow:
    """One controller under one push; numbers are None where there was nothing to run.

    `outcome` is "yes", "fell at … s" or why there is no design; `peak` [rad], `settling` to 5 % [s], `travel` of the
    wheels [rad], `effort` [V² s or (N m)² s], `saturated` fraction [1]. `impulse` [N s] is the largest knock of
    `KNOCK` at the centre of mass from that side after which the robot still stands `WATCHED` later, to `TOLERANCE`.
    `spread` is the fraction of `DRAWN` robots over the spreads of this one's sources that fall under the same push, in
    the nonlinear model; only of linear controllers.
    """

    controller: str
    push: str
    outcome: str
    peak: float | None = None
    settling: float | None = None
    travel: float | None = None
    effort: float | None = None
    saturated: float | None = None
    impulse: float | None = None
    spread: float | None = None

    @property
    def holds(self) -> bool:
        return self.outcome == "yes"


def bench_controllers(
    robot: Robot,
    kit: Kit,
    body: str = "twin",
    seed: int = 1,
    methods: Sequence[str] = (),
    progress: Callable[[float], None] = lambda _fraction: None,
    knocks: bool = True,
) -> tuple[BenchRow, ...]:
    """Each of `methods` (none: all registered ones that are `benched`) on the sensors of `kit` through both pushes of
    the paper, held until 3 s and released; with `knocks` also the largest impulse that each recovers from, which takes
    ten runs a row.

    A method that has no design for this robot gets a row that says why.
    """
    methods = methods or [name for name, method in CONTROLLERS.items() if method.benched]
    rows, drawn = list[BenchRow](), draw(robot, DRAWN, seed)
    for method in methods:
        for side in PUSHES:
            rows.append(bench_one(method, side, robot, kit, body=body, seed=seed, drawn=drawn, knocks=knocks))
            progress(len(rows) / (len(methods) * len(PUSHES)))
    return tuple(rows)


def bench_one(
    method: str, side: str, robot: Robot, kit: Kit, *, body: str, seed: int, drawn: Sequence[Robot],
    knocks: bool = True,
) -> BenchRow:  # fmt: skip
    """One controller under one push, of `robot` and of the `drawn` ones."""
    push = f"{side}, {PUSHES[side]:+.2f} rad".replace("-", "−")
    try:
        controller = make_controller(method, robot, kit, kit.period)
    except UprightError as error:
        return BenchRow(controller=method, push=push, outcome=f"no design: {str(error).split(';')[0]}")
    plant = Electronics(make_body(body, robot), kit)
    log = run(plant, controller, Hold(pitch=PUSHES[side], until=UNTIL), seconds=SECONDS, seed=seed)
    impulse = largest_knock(plant, controller, math.copysign(1.0, PUSHES[side]), seed) if knocks else None
    plant.close()
    numbers = compare({body: log}).to_json()["logs"]
    measured = next(iter(numbers.values()))["metrics"]
    end = outcome_of(log)
    outcome = f"fell at {end.seconds:.1f} s" if end.fell else "yes"
    spread = _spread(Course(kernel_controller(controller, robot, kit), robot, drawn, kit, seed), side)
    names = {"peak": "pitch_peak", "settling": "settling_5", "travel": "wheel_travel"}
    numbers = {n: measured[names.get(n, n)] for n in ("peak", "settling", "travel", "effort", "saturated")}
    return BenchRow(controller=method, push=push, outcome=outcome, **numbers, impulse=impulse, spread=spread)


def largest_knock(plant: Body, controller: Controller, way: float, seed: int) -> float:
    """The largest impulse [N s] from one side that the robot recovers from (`BenchRow`); 0 where it never does."""
    robot = plant.spec.robot
    mass = robot.body_mass + 2 * robot.wheel_mass

    def stands(sizes: Array, _: Any) -> NDArray[np.bool_]:
        knock = Impulse(impulse=way * float(sizes[0]), start=STRUCK, duration=KNOCK)
        log = run(plant, controller, knock, seconds=STRUCK + KNOCK + WATCHED, seed=seed)
        return np.array([not outcome_of(log).fell])

    impulse = largest(stands, [GUESS * mass], CEILING * mass, FLOOR * mass, TOLERANCE, 2.0)
    return float(impulse[0])


def _spread(course: Course, side: str) -> float | None:
    """Fraction of drawn robots that fall, in the kernel."""
    if course.controller.called:
        return None
    runs = watched(course, Hold(pitch=PUSHES[side], until=UNTIL), 0, ())
    return float(np.concatenate([result.fell for result in runs]).mean())


def bench_json(rows: Sequence[BenchRow]) -> list[dict[str, Any]]:
    """The rows as plain values."""
    return [asdict(row) for row in rows]
