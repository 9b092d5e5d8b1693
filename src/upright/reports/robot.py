"""Drawings of a robot to scale: a filmstrip of a run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib.patches import Circle, Polygon

from upright.plotting import COLOURS, INK, SMALL, empty, number
from upright.robots import Robot
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FLOOR = 0.05  # [m] between the marks on the floor of a filmstrip
BODY, WHEEL = COLOURS[0], COLOURS[4]


def filmstrip(robot: Robot, log: Log, times: Sequence[float]) -> Figure:
    """The robot of a run at some `times` [s], each from its side, where its wheels have rolled it."""
    figure, axes = empty(len(times), height=1.5)
    width = 1.3 * height_of(robot)
    for ax, time in zip(axes, times, strict=True):
        row = int(abs(log.t - time).argmin())
        pitch, wheel = float(log["truth/pitch"][row]), float(log["truth/wheel"][row])
        x = robot.wheel_radius * wheel
        stand(ax, robot, pitch, wheel, x)
        ax.plot([x, x], [0, 2 * robot.wheel_radius + height_of(robot)], linestyle=":", linewidth=0.7, color=INK)
        ends = (x - width / 2, x + width / 2)
        for mark in range(math.ceil(ends[0] / FLOOR), math.floor(ends[1] / FLOOR) + 1):
            ax.plot([mark * FLOOR] * 2, [0, -0.008 if mark else -0.03], color=INK, linewidth=0.8)
        ax.set(xlim=ends, ylim=(-0.035, 2.1 * robot.wheel_radius + height_of(robot)))
        where = f"{number(time)} s\n{number(round(math.degrees(pitch), 1))}°, {number(round(100 * x, 1))} cm"
        ax.set_title(where, loc="center", fontsize=SMALL)
    return figure


def stand(ax: Axes, robot: Robot, pitch: float, wheel: float, x: float = 0.0) -> None:
    """The robot from its side on the floor: body at `pitch` [rad], wheel turned to `wheel` [rad], axle at `x` [m]."""
    R = robot.wheel_radius
    ax.add_patch(Polygon(outline(robot, pitch, x), facecolor=BODY, alpha=0.25, edgecolor=BODY, linewidth=1.2))
    ax.add_patch(Circle((x, R), R, fill=False, edgecolor=WHEEL, linewidth=1.8))
    ax.plot([x, x + R * math.sin(wheel)], [R, R + R * math.cos(wheel)], color=WHEEL, linewidth=1.2)
    ax.axhline(0, color=INK, linewidth=0.8)


def outline(robot: Robot, pitch: float, x: float) -> list[tuple[float, float]]:
    """The corners of the body from its side [m], at `pitch` [rad], over an axle at `x` [m]."""
    R = robot.wheel_radius
    half = robot.body_depth / 2
    height = height_of(robot)
    across = (math.cos(pitch), -math.sin(pitch))
    up = (math.sin(pitch), math.cos(pitch))
    corners = [(a * half, b) for a, b in ((-1, 0), (1, 0), (1, height), (-1, height))]
    return [(x + a * across[0] + b * up[0], R + a * across[1] + b * up[1]) for a, b in corners]


def height_of(robot: Robot) -> float:
    """From the axle to the top of the body [m]."""
    return robot.com_height + robot.body_height / 2
