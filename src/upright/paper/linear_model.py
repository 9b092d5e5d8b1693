"""Chapter 3: the linear model by least squares, from true states and from real sensors (eqs. 25 to 35)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.arrays import Array
from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.control import Controller, Estimated, StateFeedback, kalman
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.pages import Column, Quantity, Say, Table
from upright.paper import printed
from upright.paper.claim import BEYOND, Claim, judged
from upright.physics.linear import LinearModel, linearise
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES, Log

SMALL = 0.3  # [V] excitation; pitch stays within 3 mrad, where sin ψ = ψ to 2e-6
LAST_DIGIT = 1e-4  # (34) and (35) are printed to four decimals, trailing zeros left out
MORE = 3  # times the data: random errors shrink by √3, a bias remains
PITCH = (0, 1, 2, 3)
YAW = (4, 5)
NOISE = (5, 4)  # the printed −0.0007 from heading to yaw rate: heading exerts no torque, so this entry is noise


@dataclass(frozen=True, eq=False)
class LeastSquares:
    """P̂ = (XᵀX)⁻¹Xᵀy of eq. (33) for x⁺ = p₀ + A x + B u.

    `offset` p₀ (6,) is the independent term; `condition` is that of X_g with columns scaled to unit length, `rank` its
    numerical rank out of 9.
    """

    model: LinearModel
    offset: Array
    rank: int
    condition: float
    samples: int


def least_squares(x: Array, log: Log) -> LeastSquares:
    """Fit x⁺ = p₀ + A x + B u (eqs. 25 to 33) to states (n, 6) and the commands (n, 2) that a log held after each."""
    u = np.column_stack([log["applied/left"], log["applied/right"]])
    regressors = np.column_stack([np.ones(len(x) - 1), x[:-1], u[:-1]])
    scale = np.maximum(np.linalg.norm(regressors, axis=0), np.finfo(float).tiny)
    solution, _, rank, singular = np.linalg.lstsq(regressors / scale, x[1:], rcond=1e-12)
    P = solution / scale[:, None]
    model = LinearModel(P[1:7].T, P[7:].T, dt=printed.PERIOD)
    return LeastSquares(model, P[0], int(rank), float(singular[0] / singular[-1]), len(x))


def rebuild_states(log: Log, robot: Robot) -> Array:
    """The six states (n, 6) as the paper's robot has them: ψ is the integrated gyro, less its mean (the bias);
    θ the encoders plus ψ; φ the compass where there is one, else the encoders; rates of θ and φ are differences.
    """
    gyro = log["sensor/gyro"] - log["sensor/gyro"].mean()
    pitch = np.concatenate([[0.0], np.cumsum(gyro[:-1] * np.diff(log.t))])
    pitch -= pitch.mean()
    left, right = log["sensor/encoder_left"], log["sensor/encoder_right"]
    wheel = (left + right) / 2 + pitch
    turn = (right - left) * robot.wheel_radius / robot.track
    yaw = log.channels.get("sensor/compass", turn)
    return np.column_stack([pitch, gyro, wheel, _difference(wheel, log.t), yaw, _difference(yaw, log.t)])


def _difference(values: Array, t: Array) -> Array:
    slope = np.diff(values) / np.diff(t)
    return np.concatenate([slope[:1], slope])


def unstable_pole(model: LinearModel) -> float:
    """The fastest growing real mode of a model in steps of `PERIOD` [1/s]: ln of its largest |eigenvalue| over it."""
    pitch = [STATE_NAMES.index(name) for name in ("pitch", "pitch_rate", "wheel_rate")]
    return float(np.log(np.abs(np.linalg.eigvals(model.A[np.ix_(pitch, pitch)])).max()) / printed.PERIOD)


@dataclass(frozen=True)
class Misfit:
    """Largest difference between a fitted block and the printed one, in units of the last printed digit."""

    block: Say
    units: float
    entries: int

    @property
    def agrees(self) -> bool:
        """Within ±2 of the last printed digit."""
        return self.units <= 2.0


def identify(robot: Robot, feedback: StateFeedback, seed: int = 1) -> tuple[Log, LeastSquares]:
    """2000 samples of the nonlinear model under `feedback` with a small excitation, and the fit to its states."""
    excitation = random_binary(printed.SAMPLES, SMALL, seed)
    log = run(NonlinearBody(robot), Excited(feedback, excitation), seconds=printed.SAMPLES * printed.PERIOD, seed=seed)
    return log, least_squares(log.state(), log)


def from_sensors(
    robot: Robot, feedback: StateFeedback, kit: Kit, samples: int = printed.SAMPLES, seed: int = 1
) -> tuple[Log, LeastSquares]:
    """The same regression from the twin's sensors, with states rebuilt as on the paper's robot."""
    controller: Controller = Excited(Estimated(feedback, kalman(robot, kit)), random_binary(samples, 1.0, seed))
    log = run(Electronics(Twin(robot), kit), controller, seconds=samples * printed.PERIOD, seed=seed)
    return log, least_squares(rebuild_states(log, robot), log)


def misfits(model: LinearModel) -> tuple[Misfit, ...]:
    """The pitch block and the yaw block of (34) and (35) against `model`, with yaw's input sign
    turned as the errata settle it."""
    return (
        _misfit(Say("pitch block of A and B"), model, printed.B_TURNED, PITCH),
        _misfit(Say("yaw block of A and B, sign of the inputs turned"), model, printed.B_TURNED, YAW),
        _misfit(Say("yaw block with the inputs as printed"), model, printed.B, YAW),
    )


def chapter(robot: Robot, feedback: StateFeedback, kit: Kit) -> list[Claim]:
    """The fit to true states, which reproduces the paper, and the fit to sensor readings, which is biased."""
    log, fit = identify(robot, feedback)
    sensed, biased = from_sensors(robot, feedback, kit)
    longer = from_sensors(robot, feedback, kit, MORE * printed.SAMPLES)[1]
    return [_fitted(log, fit), _biased(robot, sensed, biased, longer)]


def _fitted(log: Log, fit: LeastSquares) -> Claim:
    blocks = misfits(fit.model)
    numbers = {
        "misfit": {b.block.template: {"last_digits": b.units, "entries": b.entries} for b in blocks},
        "rank": fit.rank,
        "condition": fit.condition,
        "largest_offset": float(np.abs(fit.offset).max()),
        "samples": fit.samples,
        "A": fit.model.A.tolist(),
        "B": fit.model.B.tolist(),
    }
    summary = Say("Pitch and wheels have the printed numbers; the inputs of yaw have the other sign.")
    result = Say("all but a sign")
    if not (blocks[0].agrees and blocks[1].agrees):
        summary = Say("The fit differs from the printed numbers.")
        result = Say("other numbers")
    columns = [
        Column(Say("part of A and B")),
        Column(Say("entries")),
        Column(Say("largest difference [last digits]")),
        Column(Say("agrees")),
    ]
    rows = [[b.block, b.entries, b.units, b.agrees] for b in blocks]
    table = Table(columns, rows, Say("The fit to {n} samples beside (34) and (35)", n=fit.samples))
    verdict = judged(b.agrees and fit.rank == 9 for b in blocks)  # of 9 parameters a row: full rank, as the paper asks
    title = Say("Linear model")
    return Claim("3a", title, verdict, summary, numbers, [table], {"identification": log}, result=result)


def _biased(robot: Robot, log: Log, fit: LeastSquares, longer: LeastSquares) -> Claim:
    reference = linearise(robot).c2d(printed.PERIOD)
    true = unstable_pole(reference)
    estimated = unstable_pole(fit.model)
    summary = Say(
        "On real sensors the unstable pole comes out as {pole}, and is {true}: noise biases least squares.",
        pole=Quantity(estimated, "1/s"),
        true=Quantity(true, "1/s"),
    )
    relative = float(np.linalg.norm(fit.model.A[:4, :4] - reference.A[:4, :4]) / np.linalg.norm(reference.A[:4, :4]))
    numbers = {
        "unstable_pole": estimated,
        "unstable_pole_with_more_data": unstable_pole(longer.model),
        "true_unstable_pole": true,
        "relative_error_of_A": relative,
        "A": fit.model.A.tolist(),
    }
    title = Say("The same fit on real sensors")
    return Claim("3b", title, BEYOND, summary, numbers, [], {"identification-sensors": log})


def _misfit(block: Say, model: LinearModel, B: Array, rows: tuple[int, ...]) -> Misfit:
    index = list(rows)
    fitted = np.column_stack([model.A[np.ix_(index, index)], model.B[index]])
    paper = np.column_stack([printed.A[np.ix_(index, index)], B[index]])
    difference = np.abs(fitted - paper)
    counted = difference.size
    if NOISE[0] in rows:
        difference[rows.index(NOISE[0]), rows.index(NOISE[1])] = 0.0
        counted -= 1
    return Misfit(block, float(difference.max()) / LAST_DIGIT, counted)
