"""Models judged in the loop: does a regulator designed on the model hold the robot that the log came from?

All models get the same weights, the same process noise and the same kit; only the model differs. The robot in the loop
is the one whose twin made the log; for a log of a built robot it is that robot calibrated from the same log.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.bodies import Body, Electronics, NonlinearBody, make_body
from upright.calibration.calibration import Calibration
from upright.control.delay import RAW
from upright.control.kalman import one_step, process_noise, steady_kalman
from upright.control.linear_controller import LinearController
from upright.control.riccati import LARGEST_COMMAND, LARGEST_STATE, bryson, riccati
from upright.errors import UprightError
from upright.experiment import Hold, outcome_of, run
from upright.identification.grey_box import calibrated_kit
from upright.identification.identified import assembled, reading
from upright.identification.prediction import ADDED, BIAS_WALK, MOTOR
from upright.identification.samples import Samples
from upright.pages import Quantity, Say, Verdict
from upright.physics.linear import LinearModel, delay_line
from upright.robots import PARAMETERS, Kit, Robot
from upright.robots.drives import SPEED_DRIVE
from upright.robots.facts import recorded
from upright.signals import STATE_NAMES

HELD, UNTIL, SECONDS = 0.05, 1.0, 8.0
"""The robot is held at this pitch [rad] until that time [s], let go, and watched to the end."""


@dataclass(frozen=True)
class Judge:
    """A `robot` with its `kit` on a `body` ("twin" or "nonlinear"), `who` that is in words, and whether this simulation
    `made_the_log`."""

    robot: Robot
    kit: Kit
    body: str
    who: Say
    made_the_log: bool = False


@dataclass(frozen=True)
class LoopTrial:
    """The result of one regulator: whether it `holds`, and fell at `fell_at` [s]; the `largest` pitch [rad] after the
    release, its rms [rad] in the last two seconds (`restless`); or `why` there is no regulator."""

    holds: bool
    fell_at: float | None = None
    largest: float | None = None
    restless: float | None = None
    why: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        return dict(vars(self))

    @property
    def verdict(self) -> Verdict:
        """What the regulator did."""
        if self.why:
            return Verdict(Say("no regulator"), "bad")
        if self.holds:
            return Verdict(Say("holds"), "good")
        return Verdict(Say("falls after {time}", time=Quantity(self.fell_at, "s", digits=2)), "bad")


def judge_of(samples: Samples, calibration: Calibration | None = None) -> Judge:
    """The judge of models of this log: its twin, else the calibrated robot, else the one that was named."""
    origin = samples.log.origin.get("robot", {})
    body = str(samples.log.origin.get("body", {}).get("kind", ""))
    if set(PARAMETERS) - set(SPEED_DRIVE) <= set(origin) and body:
        robot = Robot(name=origin["name"], drive=origin["drive"], **recorded(origin))
        kind = "twin" if body.startswith("twin") else "nonlinear"
        return Judge(robot, samples.kit, kind, Say("the simulated robot that made the log"), True)
    if calibration is not None:
        kit = calibrated_kit(calibration, samples.kit)
        return Judge(calibration.robot, kit, "nonlinear", Say("the robot calibrated from this log, simulated"))
    who = Say("{robot} with the numbers of its file, simulated", robot=samples.robot.name)
    return Judge(samples.robot, samples.kit, "nonlinear", who)


def regulator(samples: Samples, halves: Mapping[str, LinearModel]) -> LinearController:
    """The linear quadratic regulator of the models behind a Kalman filter, on raw encoders and gyro.

    Weights are Bryson's, as for `lqr` and `lqg`; delayed outputs are states of the filter, which predicts them. Raises
    `DesignFailed` where no regulator or no filter exists.
    """
    whole, _, _ = assembled(halves, {})
    K = _gain(whole, samples.robot.command_unit)
    A, B, C, W, V, M = _filter_model(samples, halves, whole)
    _, L = steady_kalman(A, C, W, V, ADDED)
    n = len(whole.states)
    F, G, after = one_step(A, C, L)
    state = K @ after[:n]
    direct = K @ L[:n] @ M
    # positions, yaw and their rates follow the reference; pitch and its rate stay at zero
    follows = np.array([[name == known for known in STATE_NAMES] for name in whole.states], dtype=np.float64)
    follows[:, :2] = 0.0
    Br = np.zeros((len(A), 6))
    Ba = B
    own = np.zeros_like(A)
    By = G @ M
    if samples.sent:
        own = -B @ state
        Ba = np.zeros_like(B)
        By = By - B @ direct
        Br = B @ K @ follows
    return LinearController(
        F + own, By, Br, Ba, -state, -direct, K @ follows, reads=RAW, period=samples.dt,
        command_unit=samples.robot.command_unit, kind="lqg on an identified model",
    )  # fmt: skip


def _gain(whole: LinearModel, unit: str) -> Array:
    """K (2, states), weighing the robot's states alone."""
    largest = dict(zip(STATE_NAMES, LARGEST_STATE, strict=True))
    Q = np.diag([1 / largest[name] ** 2 if name in largest else 0.0 for name in whole.states])
    return riccati(whole, Q, bryson([LARGEST_COMMAND[unit]] * 2))[1]


def _filter_model(samples: Samples, halves: Mapping[str, LinearModel], whole: LinearModel) -> tuple[Array, ...]:
    """A, B, C, W, V of the filter's states (the model's, the gyro's bias, delayed readings), and M from raw readings to
    outputs; outputs that no kit reads are left out."""
    raw, n = _raw(samples.robot), len(whole.states)
    used = [(part, i) for part in samples.parts for i, output in enumerate(part.outputs) if output in raw]
    if not any(part.outputs[i] == "gyro" for part, i in used):
        raise UprightError("the model reads no gyro", expected="a log of encoders and gyro")
    reads = np.zeros((len(used), n + 1))
    for row, (part, i) in zip(reads, used, strict=True):
        states = halves[part.name].states
        row[[whole.states.index(name) for name in states]] = reading(part.outputs[i], states)
        row[n] = part.outputs[i] == "gyro"
    base = np.eye(n + 1)
    base[:n, :n] = whole.A
    strength = MOTOR * LARGEST_COMMAND[samples.robot.command_unit]
    noise = np.zeros((n + 1, n + 1))
    noise[:n, :n] = process_noise(strength * whole.B, 1e-12)
    noise[n, n] = BIAS_WALK**2 * samples.dt
    A, C, W = _with_lines(base, reads, noise, [part.delays[i] + samples.sent for part, i in used])
    B = np.vstack([whole.B, np.zeros((len(A) - n, 2))])
    V = np.diag([part.trusted[i] for part, i in used])
    M = np.array([raw[part.outputs[i]] for part, i in used])
    return A, B, C, W, V, M


def _with_lines(A: Array, C: Array, W: Array, delays: Sequence[int]) -> tuple[Array, Array, Array]:
    """The same with every delayed output as a line of states."""
    n = len(A)
    size = len(A) + sum(delays)
    full = np.zeros((size, size))
    reads = np.zeros((len(C), size))
    noise = 1e-14 * np.eye(size)
    full[:n, :n], noise[:n, :n] = A, W
    place = n
    for i, count in enumerate(delays):
        if not count:
            reads[i, :n] = C[i]
            continue
        full[place, :n] = C[i]
        full[place + 1 : place + count, place : place + count] = delay_line(1, count, 0.0).A[1:]
        reads[i, place + count - 1] = 1.0
        place += count
    return full, reads, noise


def _raw(robot: Robot) -> dict[str, list[float]]:
    """Outputs from left encoder, right encoder and gyro."""
    turn = robot.wheel_radius / robot.track
    return {"gyro": [0.0, 0.0, 1.0], "wheel": [0.5, 0.5, 0.0], "turn": [-turn, turn, 0.0]}


def _body(judge: Judge, dt: float) -> Body:
    """The body, whose steps make up the log's period."""
    if judge.body == "nonlinear":
        return NonlinearBody.dividing(judge.robot, dt)
    return make_body(judge.body, judge.robot)


def loop_trial(samples: Samples, halves: Mapping[str, LinearModel], judge: Judge, seed: int = 1) -> LoopTrial:
    """The models' regulator on the judge, held and let go."""
    try:
        controller = regulator(samples, halves)
    except (UprightError, np.linalg.LinAlgError) as error:
        return LoopTrial(False, why=str(error))
    body = Electronics(_body(judge, samples.dt), judge.kit)
    log = run(body, controller, Hold(pitch=HELD, until=UNTIL), seconds=SECONDS, seed=seed)
    body.close()
    outcome = outcome_of(log)
    if outcome.fell:
        return LoopTrial(False, outcome.seconds)
    free = log.between(UNTIL, SECONDS)["truth/pitch"]
    last = log.between(SECONDS - 2.0, SECONDS)["truth/pitch"]
    return LoopTrial(True, None, float(np.abs(free).max()), float(np.sqrt(np.mean(last**2))))
