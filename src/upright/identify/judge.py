"""Models judged in the loop: does a regulator designed on the model hold the robot that the log came from?

All models get the same weights, the same process noise and the same kit; only the model differs. The robot in the loop
is the one whose twin made the log; for a log of a built robot it is that robot calibrated from the same log.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies import Body, Electronics, NonlinearBody, make_body
from upright.calibrate.calibration import Calibration
from upright.control.delay import RAW
from upright.control.kalman import one_step, process_noise, steady_kalman
from upright.control.linear_controller import LinearController
from upright.control.lqr import LARGEST_COMMAND, LARGEST_STATE, bryson, riccati
from upright.errors import UprightError
from upright.experiment import Hold, outcome_of, run
from upright.identify.coordinates import PartModel
from upright.identify.grey_box import kit_as_found
from upright.identify.identified import assembled, reading
from upright.identify.prediction import ADDED, BIAS_WALK, MOTOR
from upright.identify.samples import Samples, by_name
from upright.physics.linear import LinearModel, delay_line
from upright.robots import PARAMETERS, Kit, Robot
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

HELD, UNTIL, SECONDS = 0.05, 1.0, 8.0
"""The robot is held at this pitch [rad] until that time [s], let go, and watched to the end."""


@dataclass(frozen=True)
class Judge:
    """A `robot` with its `kit` on a `body` ("twin" or "nonlinear"), in words `who` that is, and whether it is the very
    simulation that `made_the_log`."""

    robot: Robot
    kit: Kit
    body: str
    who: str
    made_the_log: bool = False


@dataclass(frozen=True)
class Trial:
    """What came of one regulator: whether it `holds`, when it `fell` [s], the largest pitch [rad] after the release and
    the rms of the last two seconds; or `why` there was nothing to try."""

    holds: bool
    fell: float | None = None
    largest: float | None = None
    restless: float | None = None
    why: str = ""

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        return dict(vars(self))

    def __str__(self) -> str:
        if self.why:
            return self.why
        return "holds" if self.holds else f"falls at {self.fell:.1f} s"


def judge_of(samples: Samples, calibration: Calibration | None = None) -> Judge:
    """Who judges models of this log: its twin, else the calibrated robot, else the one that was named."""
    said = samples.log.origin.get("robot", {})
    body = str(samples.log.origin.get("body", {}).get("kind", ""))
    if set(PARAMETERS) <= set(said) and body:
        robot = Robot(name=said["name"], drive=said["drive"], **{name: said[name] for name in PARAMETERS})
        kind = "twin" if body.startswith("twin") else "nonlinear"
        return Judge(robot, samples.kit, kind, f"the {body.split(' with ', maxsplit=1)[0]} that made the log", True)
    if calibration is not None:
        kit = kit_as_found(calibration, samples.kit)
        return Judge(calibration.robot, kit, "nonlinear", "the robot calibrated from this log (no built robot)")
    return Judge(samples.robot, samples.kit, "nonlinear", f"{samples.robot.name} as its file has it (no built robot)")


def regulator(samples: Samples, models: Sequence[PartModel]) -> LinearController:
    """The linear quadratic regulator of the models behind a Kalman filter, on raw encoders and gyro.

    Weights are Bryson's, as for `lqr` and `lqg`; late outputs wait among the filter's states, so that they are
    foretold. Raises `DesignFailed` where no regulator or no filter exists.
    """
    whole, _, _ = assembled(models, {})
    K = _gain(whole, samples.robot.command_unit)
    A, B, C, W, V, M = _seen(samples, models, whole)
    _, L = steady_kalman(A, C, W, V, ADDED)
    n = len(whole.states)
    F, G, after = one_step(A, C, L)
    state, direct = K @ after[:n], K @ L[:n] @ M
    order = [STATE_NAMES.index(name) if name in STATE_NAMES else -1 for name in whole.states]
    wanted = np.array([[float(i == j and i not in (0, 1)) for j in range(6)] for i in order])
    Br, Ba, own = np.zeros((len(A), 6)), B, np.zeros_like(A)
    By = G @ M
    if samples.sent:
        own, Ba = -B @ state, np.zeros_like(B)
        By, Br = By - B @ direct, B @ K @ wanted
    return LinearController(
        F + own, By, Br, Ba, -state, -direct, K @ wanted, RAW, samples.dt,
        command_unit=samples.robot.command_unit, kind="lqg on an identified model",
    )  # fmt: skip


def _gain(whole: LinearModel, unit: str) -> Array:
    """K (2, states), weighing the robot's states alone."""
    largest = dict(zip(STATE_NAMES, LARGEST_STATE, strict=True))
    Q = np.diag([1 / largest[name] ** 2 if name in largest else 0.0 for name in whole.states])
    return riccati(whole, Q, bryson([LARGEST_COMMAND[unit]] * 2))[1]


def _seen(samples: Samples, models: Sequence[PartModel], whole: LinearModel) -> tuple[Array, ...]:
    """A, B, C of the filter's states (the model's, the gyro's bias, readings on their way), W, V, and M from the raw
    readings to the outputs; what no kit reads is left out."""
    parts, raw, n = by_name(samples.parts), _raw(samples.robot), len(whole.states)
    rows: list[Array] = []
    late: list[int] = []
    variances: list[float] = []
    M: list[list[float]] = []
    for model in models:
        part = parts[model.name]
        for i, output in enumerate(part.outputs):
            if output not in raw:
                continue
            row = np.zeros(n + 1)
            row[[whole.states.index(name) for name in model.states]] = reading(output, model)
            row[n] = output == "gyro"
            rows.append(row)
            late.append(part.late[i] + samples.sent)
            variances.append(part.trusted[i])
            M.append(raw[output])
    if not any(row[n] for row in rows):
        raise UprightError("the model reads no gyro", expected="a log of encoders and gyro")
    base = np.eye(n + 1)
    base[:n, :n] = whole.A
    strength = MOTOR * LARGEST_COMMAND[samples.robot.command_unit]
    noise = np.zeros((n + 1, n + 1))
    noise[:n, :n] = process_noise(strength * whole.B, 1e-12)
    noise[n, n] = BIAS_WALK**2 * samples.dt
    A, C, W = _with_lines(base, np.array(rows), noise, late)
    B = np.vstack([whole.B, np.zeros((len(A) - n, 2))])
    return A, B, C, W, np.diag(variances), np.array(M)


def _with_lines(A: Array, C: Array, W: Array, late: Sequence[int]) -> tuple[Array, Array, Array]:
    """The same with every late output as a line of states."""
    n, size = len(A), len(A) + sum(late)
    full, seen, noise = np.zeros((size, size)), np.zeros((len(C), size)), 1e-14 * np.eye(size)
    full[:n, :n], noise[:n, :n] = A, W
    place = n
    for i, count in enumerate(late):
        if not count:
            seen[i, :n] = C[i]
            continue
        full[place, :n] = C[i]
        full[place + 1 : place + count, place : place + count] = delay_line(1, count, 0.0).A[1:]
        seen[i, place + count - 1] = 1.0
        place += count
    return full, seen, noise


def _raw(robot: Robot) -> dict[str, list[float]]:
    """Outputs from left encoder, right encoder and gyro."""
    share = robot.wheel_radius / robot.track
    return {"gyro": [0.0, 0.0, 1.0], "wheel": [0.5, 0.5, 0.0], "turn": [-share, share, 0.0]}


def _body(judge: Judge, dt: float) -> Body:
    """The body, whose steps make up the log's period."""
    if judge.body == "nonlinear":
        return NonlinearBody(judge.robot, period=dt / max(1, round(dt / 0.001)))
    return make_body(judge.body, judge.robot)


def tried(samples: Samples, models: Sequence[PartModel], judge: Judge, seed: int = 1) -> Trial:
    """The models' regulator on the judge, held and let go."""
    try:
        controller = regulator(samples, models)
    except (UprightError, np.linalg.LinAlgError) as error:
        return Trial(False, why=f"no regulator: {str(error).split(';')[0]}")
    body = Electronics(_body(judge, samples.dt), judge.kit)
    log = run(body, controller, Hold(pitch=HELD, until=UNTIL), seconds=SECONDS, seed=seed)
    body.close()
    outcome = outcome_of(log)
    if outcome.fell:
        return Trial(False, outcome.seconds)
    free = log.between(UNTIL, SECONDS)["truth/pitch"]
    last = log.between(SECONDS - 2.0, SECONDS)["truth/pitch"]
    return Trial(True, None, float(np.abs(free).max()), float(np.sqrt(np.mean(last**2))))
