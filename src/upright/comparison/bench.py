"""All controllers on one robot under the same pushes: one row for each."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from upright.arrays import Array, Mask
from upright.atomic import finite
from upright.bodies import Body, equipped
from upright.certification.checks import TrialSetup, kernel_controller, watched
from upright.comparison.bench_page import PUSH_WORDS, PUSHES, push_name
from upright.comparison.comparison import compare
from upright.control import CONTROLLERS, Controller, make_controller
from upright.errors import DesignFailed, UprightError
from upright.experiment import Hold, Impulse, outcome_of, run
from upright.firmware.balance import trace
from upright.firmware.targets import computing_time
from upright.fleets.push_map import CEILING, FLOOR, largest
from upright.pages import Message, Result, Say, english
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.drives import EFFORT_UNITS
from upright.robots.uncertainty import draw
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page


UNTIL, SECONDS = 3.0, 7.0  # [s]
STRUCK, KNOCK, WATCHED = 1.0, 0.02, 3.0  # [s] when a knock comes, how long it is, and how long it is watched
GUESS = 0.3  # [m/s] of the whole robot: what most controllers survive about
TOLERANCE = 0.03
"""Relative: readings of a degree make the last few per cent a matter of chance."""
RANGE = 0.3  # [rad] of the responses that are drawn: a fall leaves them
DRAWN = 200
"""Robots over the spreads: a fraction of one in a hundred shows."""


@dataclass(frozen=True, kw_only=True)
class BenchRow:
    """One controller under one push; numbers are None where there was nothing to run.

    `outcome` is "yes", "fell at … s" or why there is no design; `peak` [rad], `settling` to 5 % [s] (None where it
    swings further to the end), `travel` of the wheels [rad], `effort` [V² s or (N m)² s], `saturated` fraction [1].
    `impulse` [N s] is the largest knock of `KNOCK` at the centre of mass from that side after which the robot still
    stands `WATCHED` later, to `TOLERANCE`.
    `spread` is the fraction of `DRAWN` robots over the spreads of this one's sources that fall under the same push, in
    the nonlinear model; only of linear controllers. `products` counts multiplications and divisions of its program in
    a period; None where there is no program of it. `fell_at` is when it fell [s].
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
    products: int | None = None
    fell_at: float | None = None

    @property
    def holds(self) -> bool:
        return self.outcome == "yes"


BRICKS = {"nxt": ("nxc", "NXT"), "spike": ("pybricks", "SPIKE hub")}
"""Kit → the target of its firmware whose time for a product is known, and the name of its brick."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Bench(Result):
    """All controllers of one robot under the same pushes; `logs` are the runs by controller and push, and `period` [s]
    is the kit's. `left_out` says which methods need an extra that is not installed."""

    tolerance: ClassVar[float] = TOLERANCE
    drawn: ClassVar[int] = DRAWN

    robot: str
    kit: str
    body: str
    seed: int
    rows: tuple[BenchRow, ...]
    logs: Mapping[tuple[str, str], Log]
    period: float = math.nan
    left_out: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """Plain numbers, without the logs."""
        rows = [asdict(row) | {"rest": finite(self.rest(row.push).get(row.controller, math.nan))} for row in self.rows]
        times = {name: self.computing_time(name) for name in self.ranked()}
        return {
            "schema": "upright/bench-controllers/1",
            "robot": self.robot,
            "kit": self.kit,
            "body": self.body,
            "seed": self.seed,
            "left_out": "; ".join(self.left_out),
            "rows": rows,
            "take": self.take,
            "places": self.places(),
            "computing_time": times,
        }

    def ranked(self) -> dict[str, float]:
        """Controllers by the largest impulse [N s] that they survive from the worse side; NaN where there is none."""
        rows: dict[str, list[float]] = {}
        for row in self.rows:
            rows.setdefault(row.controller, []).append(math.nan if row.impulse is None else row.impulse)
        worst = {name: min(values) for name, values in rows.items()}
        return dict(sorted(worst.items(), key=lambda item: -np.nan_to_num(item[1], nan=-1.0)))

    def places(self) -> dict[str, int]:
        """The place of each controller by the impulse that it survives; those within `TOLERANCE` of the best of a place
        share it."""
        places = dict[str, int]()
        best = math.nan
        place = 0
        for k, (name, size) in enumerate(self.ranked().items(), 1):
            if not size >= best * (1 - TOLERANCE):
                best, place = size, k
            places[name] = place
        return places

    @property
    def held(self) -> list[str]:
        """The controllers that hold the robot through both pushes, the best first."""
        return [name for name in self.ranked() if all(row.holds for row in self.rows if row.controller == name)]

    @property
    def quick(self) -> list[str]:
        """Those whose program is not known to take longer than a period."""
        return [name for name in self.ranked() if not (self.computing_time(name) or 0.0) > self.period]

    @property
    def tied(self) -> list[str]:
        """Of those that hold the robot and are quick the ones whose knocks are within `TOLERANCE` of the largest."""
        sizes = {name: size for name, size in self.ranked().items() if name in self.held and name in self.quick}
        return [name for name, size in sizes.items() if size >= (1 - TOLERANCE) * max(sizes.values())]

    @property
    def take(self) -> str:
        """Of the `tied` ones that which needs the least effort; "" where there is none."""
        return min(self.tied, key=lambda name: self.worse(name, "effort") or 0.0, default="")

    def worse(self, controller: str, figure: str) -> float | None:
        """A number of a row of this controller, under the push where it is larger; None where it is not known."""
        values = (getattr(row, figure) for row in self.rows if row.controller == controller)
        return max((value for value in values if value is not None), default=None)

    def computing_time(self, controller: str) -> float | None:
        """What a period of its program takes on the kit's brick [s], by its products; None where that is not known."""
        products = self.worse(controller, "products")
        return computing_time(int(products), BRICKS[self.kit][0]) if products and self.kit in BRICKS else None

    def rest(self, push: str) -> dict[str, float]:
        """How long after the release each controller's pitch comes to rest [s], as a comparison judges it; NaN where it
        never does."""
        logs = {name: log for (name, under), log in self.logs.items() if under == push}
        if not logs:
            return {}
        comparison = compare(logs)
        return {name: comparison.at_rest(label)[0] for name, label in zip(logs, comparison.logs, strict=True)}

    @property
    def effort_unit(self) -> str:
        """As the motors are commanded: in volts, or by torque."""
        units = {log.unit("command/left") for log in self.logs.values() if "command/left" in log}
        return EFFORT_UNITS[units.pop()] if len(units) == 1 else EFFORT_UNITS["V"]

    def page(self) -> Page:
        """The bench for people."""
        from upright.comparison.bench_page import bench_page

        return bench_page(self)

    def plot(self) -> Figure:
        """The largest impulse that each controller survives, the best first, in the order of their `places`; green is
        that to `take`, grey what is too slow for the brick."""
        from upright.plotting import AXIS, COLOURS, bars

        names = [f"{place}. {name}" for name, place in self.places().items()]
        label = str(Say("largest knock survived [N s]"))
        figure = bars(names, list(self.ranked().values()), label, str(Say("controller")), digits=3)
        for bar, name in zip(figure.axes[0].patches, self.ranked(), strict=True):
            bar.set_color(COLOURS[2] if name == self.take else COLOURS[0] if name in self.quick else AXIS)
        return figure

    def plot_responses(self, *controllers: str) -> Figure:
        """Pitch under each of some controllers (default: all), one panel for each push; a fall ends its line. The first
        one has the solid line."""
        from upright.plotting import legend, line, panels, span

        pushes = list(dict.fromkeys(push for _, push in self.logs))
        labels = [str(Say("pitch, {push} [°]", push=PUSH_WORDS.get(push, push))) for push in pushes]
        figure, axes = panels(labels)
        order = controllers or tuple(dict.fromkeys(name for name, _ in self.logs))
        most = 0.0
        for controller, push in ((c, p) for c in order for p in pushes if (c, p) in self.logs):
            log = self.logs[controller, push]
            line(axes[pushes.index(push)], controller, log.t, np.degrees(log["truth/pitch"]))
            most = max(most, float(np.nanmax(np.abs(log["truth/pitch"]), initial=0.0)))
        limit = math.degrees(min(RANGE, 1.15 * most or RANGE))
        for ax in axes:
            ax.set_ylim(-limit, limit)
        span(axes, 0.0, UNTIL, str(Say("push acts")))
        return legend(figure)


def bench_controllers(
    robot: Robot | str,
    kit: Kit | str | None = None,
    body: str = "twin",
    *,
    seed: int = 1,
    methods: Sequence[str] = (),
    progress: Progress = unwatched,
    knocks: bool = True,
) -> Bench:
    """Each of `methods` (none: all registered ones that are `benched`) on the sensors of `kit` through both pushes of
    the paper, held until 3 s and released; with `knocks` also the largest impulse that each recovers from, which takes
    ten runs a row.

    None of `methods` leaves out those that need an extra that is not installed.
    A method that has no design for this robot gets a row that says why. Raises `UnknownName` for one that there is not,
    and `DesignFailed` where none of them has a design.
    """
    nominal = find_robot(robot)
    parts = find_kit(kit or nominal.kit)
    left_out: tuple[str, ...] = ()
    if not methods:
        methods = [name for name, method in CONTROLLERS.items() if method.benched and not method.lacks]
        left_out = tuple(method.lacks for method in CONTROLLERS.values() if method.lacks)
    for method in methods:
        _ = CONTROLLERS[method]  # raises for a name that there is not, before the work
    rows = list[BenchRow]()
    logs = dict[tuple[str, str], Log]()
    drawn = draw(nominal, DRAWN, seed)
    for method in methods:
        controller = _designed(method, nominal, parts)
        for side in PUSHES:
            row, log = bench_one(
                method, side, nominal, parts, body=body, seed=seed, drawn=drawn, knocks=knocks, controller=controller
            )
            rows.append(row)
            if log:
                logs[row.controller, row.push] = log
            progress(len(rows) / (len(methods) * len(PUSHES)))
    if not logs:
        why = "; ".join(dict.fromkeys(f"{row.controller}: {row.outcome}" for row in rows))
        raise DesignFailed(f"nothing to compare for {nominal.name}: {why}", expected="a method that has a design")
    return Bench(
        robot=nominal.name, kit=parts.name, body=body, seed=seed, rows=tuple(rows), logs=logs, period=parts.period,
        left_out=left_out,
    )  # fmt: skip


def bench_one(
    method: str, side: str, robot: Robot, kit: Kit, *, body: str, seed: int, drawn: Sequence[Robot],
    knocks: bool = True, controller: Controller | Message | None = None,
) -> tuple[BenchRow, Log | None]:  # fmt: skip
    """One controller under one push, of `robot` and of the `drawn` ones, and the run; None where there is no design.

    `controller` is the method's design for this robot, or why there is none; None: it is designed here.
    """
    push = push_name(side)
    controller = controller or _designed(method, robot, kit)
    if isinstance(controller, Message):
        return BenchRow(controller=method, push=push, outcome=english(controller)), None
    setup = TrialSetup(robot, drawn, kit, seed, controller=kernel_controller(controller, robot, kit))
    plant = equipped(body, robot, kit)
    log = run(plant, controller, Hold(pitch=PUSHES[side], until=UNTIL), seconds=SECONDS, seed=seed)
    way = math.copysign(1.0, PUSHES[side])
    impulse = largest_knock(plant, controller, way, seed, near=_border(setup, way)) if knocks else None
    plant.close()
    (measured,) = compare(log).metrics.values()
    end = outcome_of(log)
    row = BenchRow(
        controller=method,
        push=push,
        outcome=f"fell at {end.seconds:.1f} s" if end.fell else "yes",
        peak=finite(measured.pitch_peak),
        settling=finite(measured.settling_5),
        travel=finite(measured.wheel_travel),
        effort=finite(measured.effort),
        saturated=finite(measured.saturated),
        impulse=impulse,
        spread=_spread(setup, side),
        products=_products(controller, robot, kit),
        fell_at=end.seconds if end.fell else None,
    )
    return row, log


def _products(controller: Controller, robot: Robot, kit: Kit) -> int | None:
    """Of a period of its program on a brick."""
    try:
        return trace(controller, robot, kit).operations()
    except UprightError:
        return None


def largest_knock(
    plant: Body, controller: Controller, way: float, seed: int, *, near: float | None = None
) -> float:  # fmt: skip
    """The largest impulse [N s] from one side that the robot recovers from (`BenchRow`); 0 where it never does.

    The search begins at `near` [N s] in steps of `TOLERANCE`; None: far off, in steps of two.
    """

    def stands(knock: Impulse) -> bool:
        return not outcome_of(run(plant, controller, knock, seconds=STRUCK + KNOCK + WATCHED, seed=seed)).fell

    return _largest(stands, plant.spec.robot, way, near)


def _border(setup: TrialSetup, way: float) -> float | None:
    """`largest_knock` [N s] in the kernel's nonlinear model, which computes a hundred times as fast."""
    if setup.controller.called:
        return None
    one = replace(setup, robots=[setup.robot])
    return _largest(lambda knock: not watched(one, knock, 0, ()).fell[0], setup.robot, way) or None


def _largest(stands: Callable[[Impulse], bool], robot: Robot, way: float, near: float | None = None) -> float:

    def survived(sizes: Array, _: Any) -> Mask:
        return np.array([stands(Impulse(impulse=way * float(sizes[0]), start=STRUCK, duration=KNOCK))])

    guess, factor = (GUESS * robot.mass, 2.0) if near is None else (near, 1 + TOLERANCE)
    return float(largest(survived, [guess], CEILING * robot.mass, FLOOR * robot.mass, TOLERANCE, factor)[0])


def _designed(method: str, robot: Robot, kit: Kit) -> Controller | Message:
    """The method's design for this robot and kit, or why there is none."""
    try:
        return make_controller(method, robot, kit, kit.period)
    except UprightError as error:
        return Message(f"no design: {error.parts['came']}")


def _spread(setup: TrialSetup, side: str) -> float | None:
    """Fraction of drawn robots that fall, in the kernel."""
    if setup.controller.called:
        return None
    return float(watched(setup, Hold(pitch=PUSHES[side], until=UNTIL), 0, ()).fell.mean())
