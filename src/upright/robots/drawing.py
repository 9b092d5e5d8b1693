"""Drawings of a robot to scale: a filmstrip of a run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.patches import Arc, Circle, Polygon, Rectangle

from upright.languages import number
from upright.pages import Say
from upright.pages.terms import term
from upright.plotting import COLOURS, INK, SMALL, empty, styled
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Robot = Any  # that of `robot.py`, whose page draws it

TURN = 1.25  # [rad] of the wheel there, beyond the body
LEAN = 0.35  # [rad] in the labelled drawing: enough to see ψ
LETTERS = 9.0  # [pt]
FLOOR = 0.05  # [m] between the marks on the floor of a filmstrip
BODY, WHEEL = COLOURS[0], COLOURS[4]


@styled
def labelled(robot: Robot) -> Figure:
    """The robot from its side, leaning, with ψ, θ, L, R and a force on the front, and from above, with φ and W."""
    figure, (side, top) = empty(2, height=2.9, least=3.0)
    R, L = robot.wheel_radius, robot.com_height
    stand(side, robot, LEAN, TURN)
    height = height_of(robot)
    centre = (L * math.sin(LEAN), R + L * math.cos(LEAN))
    tip = (height * math.sin(LEAN), R + height * math.cos(LEAN))
    side.plot([0, 0], [R, R + 1.05 * height], linestyle="--", color=INK, linewidth=0.8)
    side.plot([0, tip[0]], [R, tip[1]], linestyle="--", color=INK, linewidth=0.8)
    side.add_patch(Arc((0, R), 1.7 * height, 1.7 * height, theta1=90 - math.degrees(LEAN), theta2=90, color=COLOURS[1]))
    side.text(-0.15 * R, R + 0.9 * height, _named("ψ", "pitch"), color=COLOURS[1], ha="right")
    side.plot([centre[0]], [centre[1]], "o", markersize=5, color=COLOURS[4])
    leader = {"arrowstyle": "-", "color": INK, "linewidth": 0.6, "shrinkB": 3}
    side.annotate(str(Say("centre of mass")), centre, (-0.9 * R, centre[1]), ha="right", va="center", arrowprops=leader)
    tail = (centre[0] + 1.1 * R, centre[1])
    _arrow(side, centre, tail, color=COLOURS[3], shrinkA=0, shrinkB=3)
    side.text(tail[0] + 0.12 * R, centre[1], str(Say("force on the front")), color=COLOURS[3], va="center")
    _arrow(side, centre, (0, R), "<->", shrinkA=0, shrinkB=0)
    side.text(0.5 * centre[0] + 0.15 * R, R + 0.42 * (centre[1] - R), "L", va="center")
    _arrow(side, (R * math.cos(0.9), R - R * math.sin(0.9)), (0, R))
    side.text(1.1 * R, 0.35 * R, _named("R", "wheel_radius"), va="center")
    side.add_patch(Arc((0, R), 2.6 * R, 2.6 * R, theta1=90 - math.degrees(TURN), theta2=90, color=COLOURS[2]))
    at = (1.3 * R * math.sin(TURN), R + 1.3 * R * math.cos(TURN))
    side.plot([0, at[0]], [R, at[1]], linestyle="--", color=COLOURS[2], linewidth=0.8)
    side.text(at[0] + 0.12 * R, at[1], str(Say("θ, turn of the wheel")), color=COLOURS[2], va="center")
    side.set_title(str(Say("from the side")), loc="center", fontsize=LETTERS)
    _above(top, robot)
    return figure


def filmstrip(robot: Robot, log: Log, times: Sequence[float]) -> Figure:
    """The robot of a run at some `times` [s], each from its side, where its wheels have rolled it."""
    figure, axes = empty(len(times), height=1.5, least=1.6)
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


def _above(ax: Axes, robot: Robot) -> None:
    half = robot.track / 2
    R = robot.wheel_radius
    thick = 0.25 * robot.wheel_radius
    depth = robot.body_depth
    ax.add_patch(Rectangle((-depth / 2, -0.7 * half), depth, 1.4 * half, facecolor=BODY, alpha=0.25, edgecolor=BODY))
    for side in (-1, 1):
        ax.add_patch(Rectangle((-R, side * half - thick), 2 * R, 2 * thick, fill=False, edgecolor=WHEEL, linewidth=1.8))
    out = 1.2 * max(R, depth / 2)
    _arrow(ax, (-out, half), (-out, -half), "<->")
    ax.text(-1.1 * out, 0, _named("W", "track"), ha="right", va="center")
    _arrow(ax, (1.4 * out, 0), (0, 0))
    ax.text(1.5 * out, 0, str(Say("ahead")), va="center")
    ax.add_patch(Arc((0, 0), 1.6 * out, 1.6 * out, theta1=0, theta2=50, color=COLOURS[3]))
    ax.text(0.9 * out * math.cos(0.5), 0.9 * out * math.sin(0.5), f" {_named('φ', 'yaw')}", color=COLOURS[3])
    reach = 1.35 * max(half, 1.6 * R)
    ax.set(xlim=(-1.2 * reach, 1.5 * reach), ylim=(-reach, reach))
    ax.set_title(str(Say("from above")), loc="center", fontsize=LETTERS)


def _arrow(ax: Axes, tip: tuple[float, float], tail: tuple[float, float], style: str = "->", **how: Any) -> None:
    ax.annotate("", tip, tail, arrowprops={"arrowstyle": style, "color": INK, **how})


def _named(symbol: str, name: str) -> str:
    return str(Say("{symbol}, {name}", symbol=symbol, name=term(name)))


def height_of(robot: Robot) -> float:
    """From the axle to the top of the body [m]."""
    return robot.com_height + robot.body_height / 2
