"""Discrete H∞ control: a four-block mixed sensitivity for pitch and wheel, and a second one for yaw.

Both motors alike and both motors opposed are two separate plants, by the robot's symmetry. In each, K minimises the
largest gain ‖z ← w‖∞ with

    w = [disturbance at the command, error of each reading]        each in units of its expected size
    z = [weighted states, the command, the command with its disturbance]   each in units of its accepted size

S, KS, GS and T are all among the blocks, so that poles on the unit circle are moved by feedback, never cancelled (Zhou
and Doyle 1998, chapter 14). z = (1 + s)/(1 − s) maps the problem to continuous time for SLICOT's SB10AD, and the
controller back. Both norms are the same (Doyle, Glover, Khargonekar and Francis 1989). The achieved γ is that of the
discrete loop.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.control.delay import RAW, SampledRobot, sampled
from upright.control.design import Design
from upright.control.family import half
from upright.control.kalman import process_noise, steady_kalman
from upright.control.linear_controller import LinearController
from upright.control.observer import steady
from upright.control.riccati import LARGEST_STATE
from upright.control.state_space import continuous, discrete, hearing, plant_of
from upright.errors import DesignFailed
from upright.physics.dynamics import turn_ratio
from upright.physics.interconnect import append, lft
from upright.physics.linear import LinearModel
from upright.physics.sensing import GYRO, sensor_matrix
from upright.robots import Kit, Robot, find_kit, find_robot

COMMAND = {"V": 4.0, "N m": 0.02, "rad/s": 10.0}
"""Commands of this size cost one. Torque is dear, since it is what the dead time of the torque-driven robot forbids."""

STARTS = tuple(1e3 / 2**k for k in range(20))
"""Values of γ to begin from: at very large ones SLICOT's tests drown in rounding."""

_HALVINGS = 16
UNAPPLIED = 1.0  # standard deviation of what motors do not apply, as a fraction of the usual command


@dataclass(frozen=True, kw_only=True)
class Expected:
    """Accepted and expected sizes, in physical units: the weights of the design.

    `state` are the largest accepted deviations [rad, rad/s, …], `command` that of each motor in its own unit (None:
    that of `COMMAND`). The expected disturbance at the command is `disturbance` times as large. `errors` are the
    expected errors of the encoders [rad] and of the gyro [rad/s]. Errors far above those of the sensors keep the loop
    slow enough for unmodelled dynamics. A gyro's bias b then moves the wheels by at most γ·state[2]·b/errors[1] [rad].
    """

    state: tuple[float, ...] = LARGEST_STATE
    command: float | None = None
    disturbance: float = 1.0
    errors: tuple[float, float] = (0.1, 0.5)


@dataclass(frozen=True, eq=False)
class Channel:
    """One of both problems: `problem` from [w, u] to [z, y], the controller found for it, and the γ it was found at."""

    problem: LinearModel
    controller: LinearModel
    gamma: float

    @property
    def closed(self) -> LinearModel:
        """From w to z under the controller."""
        return lft(self.problem, self.controller)

    def norm(self) -> float:
        """The largest gain of the closed discrete loop; infinite where it is unstable."""
        return hinf_norm(self.closed)


@dataclass(frozen=True, eq=False)
class Hinf(Design):
    """Both channels of a design, `forward` (both motors alike) and `turning` (opposed), and the weights: the sizes
    `expected`, and of the `command` [V or N m]."""

    forward: Channel
    turning: Channel
    expected: Expected
    command: float

    @property
    def gamma(self) -> float:
        """The larger of both γ."""
        return max(self.forward.gamma, self.turning.gamma)

    def check(self) -> float:
        """By how much the measured norms exceed γ, as a fraction of it: zero where they do not."""
        return max(0.0, *(channel.norm() / channel.gamma - 1 for channel in (self.forward, self.turning)))


def hinf_norm(system: LinearModel) -> float:
    """‖·‖∞, the largest singular value over all frequencies (SLICOT AB13DD: Bruinsma and Steinbuch 1990).

    Infinite where the system is unstable.
    """
    if not system.stable:
        return math.inf
    from slycot import ab13dd

    (p, m), n = system.D.shape, len(system.A)
    time = "C" if system.continuous else "D"
    norm, _ = ab13dd(time, "I", "N", "D", n, m, p, system.A, np.eye(n), system.B, system.C, system.D)
    return float(norm)


def hinf(
    robot: Robot | str, kit: Kit | str, dt: float | None = None, *, expected: Expected | None = None, slack: float = 1.1
) -> LinearController:
    """The H∞ controller for `robot` on the encoders and the gyro of `kit`.

    It is the central controller at `slack` times the least γ: at the least itself its gains know no bound. Raises
    `DesignFailed` for weights that make no sense or where SLICOT finds no controller.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    model = sampled(robot, kit, dt, RAW)
    wants = _checked(expected or Expected(), slack)
    size = COMMAND[robot.command_unit] if wants.command is None else wants.command
    plant = plant_of(model)
    forward = _problem(_half(plant, 1.0), 2, range(4), wants, size)
    turning = _problem(_half(plant, -1.0), 1, range(4, 6), wants, size)
    design = Hinf(_synthesised(forward, 2, slack), _synthesised(turning, 1, slack), wants, size)
    return _assembled(model, design, wants, size)


def _checked(wants: Expected, slack: float) -> Expected:
    numbers = [*wants.state, *wants.errors, wants.disturbance, 1.0 if wants.command is None else wants.command]
    if len(numbers) != 10 or not all(math.isfinite(n) and n > 0 for n in numbers):
        raise DesignFailed("weights that are not six states and positive sizes", expected=str(Expected()))
    if not slack > 1:
        raise DesignFailed(f"slack is {slack:g}", expected="more than 1, such as 1.1")
    return wants


def _half(plant: LinearModel, sign: float) -> LinearModel:
    """The `half` of the plant, of which the outputs are the mean of the encoders (or half their difference), the gyro
    and the robot's six states."""
    C = np.vstack([[sign / 2, 0.5] @ plant.C[:2], plant.C[2], np.eye(6, len(plant.A))])
    return half(LinearModel(plant.A, plant.B, C, dt=plant.dt, states=plant.states), sign)


def _synthesised(problem: LinearModel, readings: int, slack: float) -> Channel:
    """The central controller at `slack` times the least γ, which bisection finds."""
    mapped = continuous(problem)
    reached = (channel for gamma in STARTS if (channel := _central(problem, mapped, readings, gamma)))
    first = next(reached, None)
    if first is None:
        raise _no_controller()
    low = 0.0
    high = first.norm()
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high) if low else high / 2
        low, high = (low, middle) if _central(problem, mapped, readings, middle) else (middle, high)
    result = _central(problem, mapped, readings, slack * high)
    if result is None:
        raise _no_controller()
    return result


def _central(problem: LinearModel, mapped: LinearModel, readings: int, gamma: float) -> Channel | None:
    """SLICOT's central controller at `gamma`, or None where there is none or its discrete loop is unstable."""
    from slycot import sb10ad
    from slycot.exceptions import SlycotError

    P = mapped
    try:
        result: Any = sb10ad(len(P.A), P.B.shape[1], len(P.C), 1, readings, gamma, P.A, P.B, P.C, P.D, 4, 0.0, 0.0)
    except SlycotError:
        return None
    A, B, C, D = (np.array(matrix, dtype=np.float64) for matrix in result[1:5])
    controller = discrete(LinearModel(A, B, C, D), problem.dt)
    channel = Channel(problem, controller, gamma)
    return channel if channel.closed.stable else None


def _problem(plant: LinearModel, reads: int, states: Sequence[int], wants: Expected, size: float) -> LinearModel:
    """From [disturbance, error of each reading, command] to [states, command, it disturbed, readings], in units."""
    n = len(plant.A)
    m = len(states)
    B = np.zeros((n, 2 + reads))
    C = np.zeros((m + 2 + reads, n))
    B[:, 0], B[:, -1] = plant.B[:, 0] * wants.disturbance * size, plant.B[:, 0] * size
    D = np.zeros((len(C), 2 + reads))
    C[:m] = plant.C[[2 + i for i in states]] / np.array(wants.state)[list(states), None]
    D[m : m + 2, -1], D[m + 1, 0] = 1.0, wants.disturbance
    C[m + 2 :] = plant.C[:reads] / np.array(wants.errors)[:reads, None]
    D[m + 2 :, 1:-1] = np.eye(reads)
    return LinearModel(plant.A, B, C, D, plant.dt)


def _no_controller() -> DesignFailed:
    return DesignFailed(
        "SLICOT finds no H∞ controller", expected="a robot that the sensors show and the motors reach",
        likely="a delay too long for the robot, or weights far apart",
        hint="shorten the period or the delay, or bring the weights nearer to each other",
    )  # fmt: skip


def _assembled(model: SampledRobot, design: Hinf, wants: Expected, size: float) -> LinearController:
    """u_l = u_f − u_t, u_r = u_f + u_t from [mean of the encoders, gyro] and half their difference.

    A reference is taken off the readings as the sensors would show it, and met by the command that it needs.
    """
    errors = 1 / np.array(wants.errors)
    forward = design.forward.controller.scaled(errors, [1 / size])
    turning = design.turning.controller.scaled(errors[:1], [1 / size])
    split = np.array([[0.5, 0.5, 0.0], [0.0, 0.0, 1.0], [-0.5, 0.5, 0.0]])
    join = np.array([[1.0, -1.0], [1.0, 1.0]])
    both = append(forward, turning)
    whole = LinearModel(both.A, both.B @ split, join @ both.C, join @ both.D @ split, model.dt)
    shown, due = _reference(model)
    noise = np.array([wants.errors[name == GYRO] for name in model.reads])
    return _conditioned(
        model, whole, _conditioning(whole, noise, size), (-whole.B @ shown, due - whole.D @ shown), design
    )


def _conditioning(K: LinearModel, noise: Array, size: float) -> Array:
    """H, by which a command that was not applied corrects the controller's state, z⁺ = … + H (a − u).

    The Kalman gain of a controller driven by `noise` at its readings and seen by its command: A − H C is stable even
    where A is not (Hanus, Kinnaert and Henrotte 1987, with the gain of a filter).
    """
    W = process_noise(K.B * noise, least=1e-9)
    return K.A @ steady_kalman(K.A, K.C, W, (size * UNAPPLIED) ** 2 * np.eye(2))[1]


def _conditioned(
    model: SampledRobot, K: LinearModel, H: Array, reference: tuple[Array, Array], design: Hinf
) -> LinearController:
    """The controller corrected by what the motors did, after as many periods as the command is on its way."""
    Br, Dr = reference
    B = np.hstack([K.B, Br, H, -H])  # of readings, reference, the command applied, and that which should be
    D = np.hstack([K.D, Dr, np.zeros((2, 4))])
    whole = hearing(LinearModel(K.A, B, K.C, D, model.dt), model.delay)
    By, Br, Ba = np.split(whole.B, [len(model.reads), len(model.reads) + 6], axis=1)
    return LinearController(
        whole.A, By, Br, Ba, whole.C, K.D, Dr, reads=model.reads, period=model.dt,
        command_unit=model.robot.command_unit, kind="hinf", design=design,
    )  # fmt: skip


def _reference(model: SampledRobot) -> tuple[Array, Array]:
    """What the readings (3, 6) and the commands (2, 6) are while the robot follows a reference."""
    still = steady(model.robot)
    now = sensor_matrix(model.reads, turn_ratio(model.robot), model.kit.sensors) @ still.x_r
    delays = np.array([model.kit.sensors[name].delay for name in model.reads])
    moved = np.zeros_like(now)
    moved[:, 1::2] = now[:, ::2]
    return now - delays[:, None] * moved, still.u_r
