"""What linear theory says of a controller on a robot: poles, margins, ν-gap, and what the spreads do to them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array, Complex
from upright.control.controller import Controller, controller_hash
from upright.control.riccati import LARGEST_COMMAND
from upright.loops.gap import nu_gap, stability_margin
from upright.loops.loop import LATEST, Loop, RobotLoop, robot_loop
from upright.loops.margins import Margins, ScalarResponse, broken_at, disk_margin, frequencies, margins
from upright.loops.mu import Mu, parameter_mu
from upright.loops.targets import ROUNDED, Thinnest, reached, thinnest
from upright.pages import Result, Say
from upright.pages.terms import short
from upright.physics.dynamics import motor_gain
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot
from upright.robots.uncertainty import draw

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page


INPUTS = {"left motor": (1.0, 0.0), "right motor": (0.0, 1.0), "both motors": (1.0, 1.0), "steering": (-1.0, 1.0)}
"""Where the loop is broken at the robot's input: one motor, both alike, both opposed."""

SHOWN_GAIN = 0.01  # a smaller loop gain sets no margin, and is not drawn
DRAWN = 200
COMPARABLE = {"sensor/gyro": 1.5, "sensor/compass": 0.5, "sensor/pitch": 0.15, "sensor/accel_forward": 1.5}
"""[rad/s, rad, rad, m/s²] Bryson's sizes of the readings; an accelerometer shows g times a lean."""
_ANGLE = 1.0  # [rad] of an encoder


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Analysis(Result):
    """A controller on a robot: closed-loop `poles`, margins at `inputs` and `outputs`, `disk` α for both motors at
    once.

    `delay` [s] is the delay margin, found by increasing the dead time of the sampled robot itself. `coprime` is b(P,
    C), and `gap` the largest ν-gap of the drawn robots, both with inputs and outputs in comparable units. `radii` (n,)
    are the largest |pole| of each drawn robot, `drawn` (n, states) their poles, and `strengths` (n,) how strong their
    motors are, over the nominal ones. `loop` is what all this is of.
    """

    robot: str
    controller: str
    hash: str
    period: float
    poles: Complex
    inputs: tuple[Margins, ...]
    outputs: tuple[Margins, ...]
    disk: float
    delay: float
    coprime: float
    gap: float
    drawn: Complex
    strengths: Array
    loop: RobotLoop

    @property
    def stable(self) -> bool:
        """Whether the nominal loop is."""
        return self.radius < 1 - ROUNDED

    @property
    def free(self) -> bool:
        """Whether it is not, only because nothing holds a place: a pole at 1, and none beyond."""
        return not self.stable and self.radius <= 1 + ROUNDED

    @property
    def radius(self) -> float:
        """The largest |pole|."""
        return float(np.abs(self.poles).max())

    @property
    def radii(self) -> Array:
        """The largest |pole| of each drawn robot."""
        return np.abs(self.drawn).max(axis=1) if len(self.drawn) else np.empty(0)

    @property
    def fell(self) -> int:
        """How many of the drawn robots are unstable: a pole at 1, which is a free position's, is not."""
        return int((self.radii > 1 + ROUNDED).sum())

    @property
    def thinnest(self) -> Thinnest:
        """The margin that comes nearest to what a certificate asks for, of all places of the stable loop."""
        return thinnest((*self.inputs, *self.outputs), self.period)

    @property
    def reached(self) -> dict[str, float]:
        """The part of its usual target that each margin reaches."""
        return reached(self.both(), self.weakest.delay, self.period)

    @property
    def weakest(self) -> Margins:
        """The loop that the smallest delay makes unstable, when it is broken alone."""
        return min((*self.inputs, *self.outputs), key=lambda m: m.delay)

    def mu(self) -> Mu:
        """Bounds on the structured singular value over the robot's spreads, which take a few seconds."""
        return parameter_mu(self.loop)

    def both(self) -> Margins:
        """The margins of both motors together, which describe the pitch loop best."""
        return self._of("both motors")

    def page(self) -> Page:
        """The analysis for people."""
        from upright.loops.analysis_page import analysis_page

        return analysis_page(self)

    def plot(self, channel: str = "both motors") -> Figure:
        """Bode diagram of the loop broken at `channel`, one of the margins, with its gain and phase margins."""
        from upright.loops.diagrams import mark_margins
        from upright.plotting import AXIS, legend, line, numbered, panels

        omega, response = response_of(self._broken(channel))
        figure, (size, phase) = panels(
            [str(Say("magnitude [1]")), str(Say("phase [°]"))], str(Say("frequency [rad/s]")), "log"
        )
        size.set_yscale("log")
        numbered(size.yaxis)
        angle: Array = np.degrees(np.unwrap(np.angle(response)))
        line(size, str(Say("loop gain")), omega, np.abs(response))
        line(phase, str(Say("loop gain")), omega, angle)
        point = str(Say("gain 1 and phase ±180°: the point −1"))
        size.axhline(1.0, linestyle="--", color=AXIS, linewidth=1.0, label=point)
        ends = np.log10([max(float(np.abs(response).min()), SHOWN_GAIN), 1.05 * float(np.abs(response).max())])
        size.set_ylim(10.0 ** math.floor(ends[0]), 10.0 ** math.ceil(ends[1]))
        mark_margins(size, phase, self._of(channel), (omega, angle))
        return legend(figure)

    def turns(self, channel: str = "both motors") -> int:
        """The unstable poles of the loop broken at `channel`: so often a stable loop's Nyquist curve goes round −1,
        anticlockwise."""
        return int((np.abs(self._broken(channel).poles()) > 1 + ROUNDED).sum())

    def nearest_at(self, channel: str = "both motors") -> float:
        """The frequency [rad/s] at which the loop broken at `channel` comes nearest to −1."""
        omega, response = _for_nyquist(self._broken(channel))
        return float(omega[np.argmin(np.abs(response + 1))])

    def _of(self, channel: str) -> Margins:
        return next(m for m in (*self.inputs, *self.outputs) if m.channel == channel)

    def _broken(self, channel: str) -> LinearModel:
        """The scalar loop gain broken at `channel`, all else closed."""
        if channel in INPUTS:
            return broken_input(self.loop, INPUTS[channel])
        place = [m.channel for m in self.outputs].index(channel)
        return broken_at(self.loop.at_output, np.eye(len(self.outputs))[place])

    def plot_nyquist(self) -> Figure:
        """Nyquist diagram of the loop broken at both motors, with an arrow towards rising frequency.

        It shows the region round −1, and the circle of radius 1 / Ms that the loop touches and does not enter.
        """
        from upright.plotting import nyquist

        _, response = _for_nyquist(self._broken("both motors"))
        return nyquist(response, 1 / self.both().Ms)

    def plot_poles(self, *, slow: int = 0) -> Figure:
        """Poles of the nominal loop, and of the loops of the drawn robots, beside the unit circle.

        With `slow` only the part round 1 that holds so many of the nominal loop's poles.
        """
        from upright.plotting import legend, plane, points

        figure, ax = plane(circle=True)
        if self.drawn.size:
            points(ax, str(Say("drawn robots")), self.drawn.ravel().tolist(), style=1, size=2.5)
        points(ax, str(Say("nominal robot")), self.poles.tolist(), style=0)
        if slow:
            reach = 1.3 * float(np.sort(np.abs(self.poles - 1))[:slow].max())
            ax.set(xlim=(1 - 1.4 * reach, 1 + 0.6 * reach), ylim=(-reach, reach))
        return legend(figure)

    def check(self) -> float:
        """How far off the unit circle the largest pole is at the gain margins of both motors: zero is perfect."""
        both = self.both()
        v = np.array(INPUTS["both motors"]) / math.sqrt(2)
        ends = [k for k in (both.gain_low, both.gain_high) if 0 < k < math.inf]
        return max((abs(_radius(self.loop, np.eye(2) + (k - 1) * np.outer(v, v)) - 1) for k in ends), default=0.0)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        numbers = {
            key: getattr(self, key) for key in ("robot", "controller", "hash", "period", "disk", "coprime", "gap")
        }
        return (
            {"schema": "upright/analyse/1"}
            | numbers
            | {
                "stable": self.stable,
                "delay": self.delay if math.isfinite(self.delay) else None,
                "poles": [[float(p.real), float(p.imag)] for p in self.poles],
                "inputs": [m.to_json() for m in self.inputs],
                "outputs": [m.to_json() for m in self.outputs],
                "radii": self.radii.tolist(),
                "fell": self.fell,
                "hidden": [*self.loop.hidden],
            }
            | (self._judged() if self.stable else {})
        )

    def _judged(self) -> dict[str, Any]:
        """What is said of the margins of a stable loop."""
        nearest = {"distance": 1 / self.both().Ms, "frequency": self.nearest_at()}
        return {"thinnest": asdict(self.thinnest), "reached": self.reached, "turns": self.turns(), "nearest": nearest}


def _for_nyquist(gain: LinearModel) -> tuple[Array, Complex]:
    """Frequencies [rad/s] from far out on the curve, fine enough for its point nearest to −1, and the loop gain."""
    grid = frequencies(gain.dt)
    return grid, ScalarResponse(gain)(grid)


def _radius(loop: Loop, gains: Array) -> float:
    """The largest |pole| with these gains (2, 2) between the commands and the robot."""
    K = loop.controller
    return float(abs(Loop(loop.plant, LinearModel(K.A, K.B, gains @ K.C, gains @ K.D, K.dt)).poles()[0]))


def analyse(
    controller: Controller,
    robot: Robot,
    kit: Kit,
    *,
    robots: Sequence[Robot] | None = None,
    seed: int = 0,
) -> Analysis:
    """All margins of `controller` on `robot` under `kit`, and its poles on `robots` (None: `DRAWN` draws of the
    spreads).

    Raises `InvalidController` where the controller has no linear form.
    """
    loop = robot_loop(controller, robot, kit)
    family = draw(robot, DRAWN, seed) if robots is None else list(robots)
    loops = [loop.on(each) for each in family]
    drawn = [other.poles() for other in loops]
    readings = [COMPARABLE.get(name, _ANGLE) for name in loop.linear.reads]
    command = [LARGEST_COMMAND[robot.command_unit]] * 2
    scaled = Loop(loop.plant.scaled(command, readings), loop.controller.scaled(readings, command))
    near = [other.plant.scaled(command, readings) for other in loops[:GAPS] if loop.stable]
    dead_time = loop.delay_margin()
    every = loop_margins(loop, dead_time=dead_time)
    return Analysis(
        robot=robot.name, controller=controller.spec.kind, hash=controller_hash(controller), period=loop.linear.period,
        poles=loop.poles(), loop=loop, drawn=np.array(drawn),
        strengths=np.array([motor_gain(each) for each in family]) / motor_gain(robot),
        inputs=every[: len(INPUTS)], outputs=every[len(INPUTS) :],
        disk=disk_margin(loop.at_input), delay=dead_time, coprime=stability_margin(scaled),
        gap=max((nu_gap(scaled.plant, other) for other in near), default=0.0),
    )  # fmt: skip


GAPS = 20
"""How many of the drawn robots are measured by their ν-gap, which is slower than their poles."""


def _at_input(loop: Loop, channel: str, delay: float, *, peaks: bool) -> Margins:
    """With both motors alike the delay is the one found on the sampled robot where that is shorter: a delay by a part
    of a period changes what the robot answers near the Nyquist frequency, which e^{−jωτ} does not know."""
    result = margins(loop.at_input, INPUTS[channel], channel, peaks=peaks)
    return replace(result, delay=min(result.delay, delay)) if channel == "both motors" else result


def loop_margins(loop: RobotLoop, *, peaks: bool = True, dead_time: float | None = None) -> tuple[Margins, ...]:
    """The margins of the stable loop broken at each of `INPUTS`, then at each reading; `dead_time` is its
    `delay_margin` [s], where that is known.

    The delays of both motors and of each sensor are not above those by which the sampled robot becomes unstable.
    """
    dead_time = loop.delay_margin() if dead_time is None else dead_time
    every = [_at_input(loop, name, dead_time, peaks=peaks) for name in INPUTS]
    for i, name in enumerate(loop.linear.reads):
        broken_there = margins(loop.at_output, np.eye(len(loop.plant.C))[i], short(name), peaks=peaks)
        least = min(m.delay for m in (*every, broken_there))
        if name in loop.kit.sensors:
            exact = loop.delay_margin(name, min(least, LATEST))
            broken_there = replace(broken_there, delay=min(broken_there.delay, exact))
        every.append(broken_there)
    return tuple(every)


def broken_input(loop: Loop, direction: Sequence[float]) -> LinearModel:
    """The scalar loop gain broken at the commands along `direction`, all else closed."""
    return broken_at(loop.at_input, np.array(direction) / np.linalg.norm(direction))


def response_of(gain: LinearModel, count: int = 400) -> tuple[Array, Complex]:
    """Frequencies [rad/s] up to Nyquist's, and the scalar loop `gain` there."""
    grid = np.geomspace(0.05, math.pi / gain.dt, count)
    return grid, gain.response(grid)[0, 0]
