"""What any controller could survive: the largest hold and the largest knock, from the nonlinear equations.

One mode of a balancing robot falls, and full command towards the fall turns it soonest. It acts once a reading shows
the push and a command has crossed the dead time. If full command without end brings the body back past upright, then an
earlier end of it brings the robot to rest; if not, nothing does. For linear robots that is exact (Hu and Lin 2001,
theorem 2.3); for the presets, tests compare it with searches over other commands. The state counts as known without
noise and the command as free of quanta, so that real controllers survive less. `control.reach` has the closed form of
the linear robot, for leans at rest.
"""

from __future__ import annotations

import math
from functools import cache, lru_cache
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import numpy as np

from upright.arrays import Array, Mask
from upright.control import LinearController
from upright.experiment.pushes import Hold, Impulse
from upright.kernel.batch import NAMES, FleetBatch
from upright.kernel.simulate import simulate
from upright.physics.dynamics import drives_speed, motor_gain
from upright.robots import Kit, Robot
from upright.robots.kit import STOP

KNOCK_DURATION = 0.02  # [s] of a standard knock
WATCHED = 2.5  # [s] of full command: who falls to neither side by then is at the very border
STEP = 0.001  # [s] of the body, as everywhere
SIZES = 64
"""Sizes that are tried at once: between both ends, and again between the last that is survived and the next."""
SOFTEST, HARDEST = 1e-3, 20.0  # [m/s] of the whole robot: knocks that are tried
SEEING = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "sensor/accel_forward", "sensor/accel_up")


class Means(NamedTuple):
    """What a controller can do at most: command `most` [its unit] at both motors, `wait` [s] after it was needed."""

    most: float
    wait: float


def means(robot: Robot, kit: Kit, battery: float | None = None) -> Means:
    """The driver's limit, or what `battery` [V] (None: the kit's) gives while both motors draw from it, less the
    driver's drop. The wait is the kit's period and dead time, and the delay of the fastest sensor that sees a push."""
    full = kit.battery.voltage if battery is None else battery
    volts = full / (1 + 2 * kit.battery.sag) if robot.command_unit == "V" else math.inf
    delays = [sensor.delay for name, sensor in kit.sensors.items() if name in SEEING]
    strength = (kit.motor.left + kit.motor.right) / 2
    wait = kit.period + kit.delay + min(delays, default=0.0)
    drop = kit.motor.drop if robot.command_unit == "V" else 0.0
    return Means(max(min(kit.motor.limit, volts) - drop, 0.0) * strength, math.floor(wait / STEP + 1e-6) * STEP)


def largest_hold(robot: Robot, kit: Kit, side: int = 1, *, battery: float | None = None, slope: float = 0.0) -> float:
    """The largest size [rad] of a `Hold` towards `side` whose release from rest any controller survives.

    Every smaller one is survivable too. Zero where the robot cannot stand on the `slope` [rad] at all, infinite without
    a limit of the command.
    """
    numbers = tuple(robot.numbers().values())
    able = means(robot, kit, battery)
    return _largest(numbers, able, slope, "hold", side) if math.isfinite(able.most) else math.inf


def largest_knock(robot: Robot, kit: Kit, side: int = 1, *, battery: float | None = None, slope: float = 0.0) -> float:
    """The largest `Impulse` [N s] of `KNOCK_DURATION` at the centre of mass towards `side` that any controller survives
    from rest; zero and infinite as in `largest_hold`."""
    numbers = tuple(robot.numbers().values())
    able = means(robot, kit, battery)
    return _largest(numbers, able, slope, "knock", side) if math.isfinite(able.most) else math.inf


def largest_slope(robot: Robot, kit: Kit, battery: float | None = None) -> float:
    """The steepest floor [rad] on which the robot can rest, from statics: the wheels bear (M + 2m) g R sin γ, which
    neither both motors nor a body that lies level, M g L, may exceed."""
    able = means(robot, kit, battery).most
    body = robot.body_mass * robot.gravity * robot.com_height
    torque = min(2 * motor_gain(robot) * able, body)
    weight = (robot.body_mass + 2 * robot.wheel_mass) * robot.gravity * robot.wheel_radius
    return math.asin(min(1.0, torque / weight))


def recoverable(
    parameters: Array, able: Means, push: Hold | Impulse, slope: float | Array = 0.0, threads: int | None = None
) -> Mask:
    """Which of the robots with `parameters` (n, 25) a controller with these means could save from this push."""
    if not (math.isfinite(able.most) and len(parameters)):
        return np.ones(len(parameters), dtype=np.bool_)
    p = _columns(parameters)
    if isinstance(push, Hold):
        side = 1 if push.pitch >= 0 else -1
        return _saved(parameters, able, slope, side, force=np.asarray(push.force(cast(Robot, p))), threads=threads)
    side = 1 if push.impulse >= 0 else -1
    sizes = np.full(len(parameters), push.impulse)
    return _saved(parameters, able, slope, side, impulse=sizes, duration=push.duration, threads=threads)


@lru_cache(maxsize=512)
def _largest(numbers: tuple[float, ...], able: Means, slope: float, kind: str, side: int) -> float:
    table = np.array([numbers])
    p = _columns(table)

    def saved(sizes: Array) -> Mask:
        if kind == "hold":
            pushes = [Hold(pitch=side * float(size), until=1.0) for size in sizes]
            force = np.concatenate([push.force(cast(Robot, p)) for push in pushes])
            return _saved(table, able, slope, side, force=force)
        return _saved(table, able, slope, side, impulse=side * sizes, duration=KNOCK_DURATION)

    mass = float(p.body_mass[0] + 2 * p.wheel_mass[0])
    sizes = np.linspace(0.0, STOP, SIZES + 1)[1:] if kind == "hold" else mass * np.geomspace(SOFTEST, HARDEST, SIZES)
    low = 0.0
    for _ in range(2):
        survived = saved(sizes)
        if survived.all():
            return float(sizes[-1])
        first = int(np.argmin(survived))
        low = float(sizes[first - 1]) if first else low
        sizes = np.linspace(low, sizes[first], SIZES + 1)[1:]
    return low


def _saved(
    parameters: Array, able: Means, slope: float | Array, side: int, *,
    force: Array | None = None, impulse: Array | None = None, duration: float = STEP, threads: int | None = None,
) -> Mask:  # fmt: skip
    """Which of n robots full command towards `side` keeps from falling to that side: let go from rest under `force`
    (n,) [N] at the centre of mass, or given an `impulse` (n,) [N s] at rest. Until the command comes they keep the one
    of their rest."""
    p = _columns(parameters)
    pitch, command = _rest(p, 0.0 if force is None else force, slope)
    n = max(len(parameters), len(pitch), 0 if impulse is None else len(impulse))
    pitch, command, radius = (np.broadcast_to(v, (n,)) for v in (pitch, command, p.wheel_radius))
    can = np.isfinite(pitch) & (np.abs(command) <= able.most) & (np.abs(pitch) < STOP)
    after, _ = _rest(p, 0.0, slope)  # when nobody pushes
    can &= np.isfinite(after) & (np.abs(after) < STOP)
    start = np.zeros((n, 6))
    ramps = np.zeros((n, 2, 4))
    pushes = np.zeros((n, 1, 4))
    start[:, 0] = np.where(can, pitch, 0.0)
    ramps[:, 0] = np.stack([np.where(can, command, 0.0) * radius, 0 * radius, 0 * radius, able.wait + 0 * radius], 1)
    ramps[:, 1] = np.stack([side * able.most * radius, 0 * radius, able.wait + 0 * radius, math.inf + 0 * radius], 1)
    pushes[:, 0] = (0.0, math.nan, 0.0, duration)
    pushes[:, 0, 0] = 0.0 if impulse is None else impulse / duration
    batch = FleetBatch(
        parameters=parameters, controller=_following(), start=start, pushes=pushes, reference=ramps,
        slope=np.column_stack([np.broadcast_to(slope, n), np.zeros(n)]), period=STEP,
    )  # fmt: skip
    result = simulate(batch, able.wait + WATCHED, threads=threads)
    lost = result.fell & (side * result.final[:, 0] > 0)
    return can & ~lost


@cache
def _following() -> LinearController:
    """Commands both motors as many volts (N m, rad/s) as the reference's wheel rate says."""
    none, follow = np.zeros((0, 0)), np.zeros((2, 6))
    follow[:, 3] = 1.0
    return LinearController(
        none, np.zeros((0, 0)), np.zeros((0, 6)), np.zeros((0, 2)), np.zeros((2, 0)), np.zeros((2, 0)), follow,
        reads=(), period=STEP,
    )  # fmt: skip


def _rest(p: Any, force: Any, slope: float | Array) -> tuple[Array, Array]:
    """Pitch [rad] and command at rest under a force at the centre of mass; NaN where there is none. Wheels that hold a
    speed hold still under any torque up to that at which they slip.

    Statics: 2 τ = climb − F R at the wheels, M g L sin(ψ − slope) + F L cos ψ = 2 τ at the body.
    """
    weight = p.body_mass * p.gravity * p.com_height
    climb = (p.body_mass + 2 * p.wheel_mass) * p.gravity * p.wheel_radius * np.sin(slope)
    torque = climb - force * p.wheel_radius
    along = weight * np.cos(slope)
    across = force * p.com_height - weight * np.sin(slope)
    with np.errstate(invalid="ignore"):
        pitch = np.arcsin(torque / np.hypot(along, across)) - np.arctan2(across, along)
    if drives_speed(p):
        return np.where(np.abs(torque) <= 2 * p.slip_torque, pitch, np.nan), 0.0 * torque
    return pitch, torque / (2 * motor_gain(p))


def _columns(parameters: Array) -> Any:
    return SimpleNamespace(**dict(zip(NAMES, parameters.T, strict=True)))
