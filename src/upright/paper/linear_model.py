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
from upright.paper import printed
from upright.paper.claim import BEYOND, Claim, judged
from upright.paper.regression import LeastSquares, least_squares, rebuild_states, unstable_pole
from upright.physics.linear import LinearModel, linearise
from upright.reports import Table
from upright.reports.page import Cell, cell_text
from upright.robots import Kit, Robot
from upright.signals import STATE, STATE_NAMES, Log

SMALL = 0.3  # [V] excitation; pitch stays within 3 mrad, where sin ψ = ψ to 2e-6
LAST_DIGIT = 1e-4  # (34) and (35) are printed to four decimals, trailing zeros left out
MORE = 3  # times the data: random errors shrink by √3, a bias remains
PITCH = (0, 1, 2, 3)
YAW = (4, 5)
NOISE = (5, 4)  # the printed −0.0007 from heading to yaw rate: heading exerts no torque, so this entry is noise


@dataclass(frozen=True)
class Misfit:
    """Largest difference between a fitted block and the printed one, in units of the last printed digit."""

    block: str
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
    return log, least_squares(log.state(), _applied(log), printed.PERIOD)


def from_sensors(
    robot: Robot, feedback: StateFeedback, kit: Kit, samples: int = printed.SAMPLES, seed: int = 1
) -> tuple[Log, LeastSquares]:
    """The same regression from the twin's sensors, with states rebuilt as on the paper's robot."""
    controller: Controller = Excited(Estimated(feedback, kalman(robot, kit)), random_binary(samples, 1.0, seed))
    log = run(Electronics(Twin(robot), kit), controller, seconds=samples * printed.PERIOD, seed=seed)
    return log, least_squares(rebuild_states(log, robot), _applied(log), printed.PERIOD)


def misfits(model: LinearModel) -> tuple[Misfit, ...]:
    """The pitch block and the yaw block of (34) and (35) against `model`, with yaw's input sign
    turned as the errata settle it."""
    turned = printed.B * np.array([[1], [1], [1], [1], [-1], [-1]])
    return (
        _misfit("pitch block of A and B", model, turned, PITCH),
        _misfit("yaw block of A and B, sign of the inputs turned", model, turned, YAW),
        _misfit("yaw block with the inputs as printed", model, printed.B, YAW),
    )


def chapter(robot: Robot, feedback: StateFeedback, kit: Kit) -> list[Claim]:
    """The fit to true states, which reproduces the paper, and the fit to sensor readings, which is biased."""
    log, fit = identify(robot, feedback)
    sensed, biased = from_sensors(robot, feedback, kit)
    longer = from_sensors(robot, feedback, kit, MORE * printed.SAMPLES)[1]
    return [_fitted(log, fit), _biased(robot, sensed, biased, longer)]


def _fitted(log: Log, fit: LeastSquares) -> Claim:
    blocks = misfits(fit.model)
    offset = float(np.abs(fit.offset).max())
    good = blocks[0].agrees and blocks[1].agrees and fit.full_rank
    summary = (
        f"Least squares on {fit.samples} samples gives the printed numbers of pitch and wheels, to within "
        f"{blocks[0].units:.1f} units of the last printed digit. With the sign of the yaw inputs turned, the yaw block "
        f"is within {blocks[1].units:.1f}. X_g has rank {fit.rank} of 9 and condition number {fit.condition:.1f}; the "
        f"independent term is at most {cell_text(offset, 2)}."
    )
    numbers = {
        "misfit": {b.block: {"last_digits": b.units, "entries": b.entries} for b in blocks},
        "rank": fit.rank, "condition": fit.condition, "largest_offset": offset, "samples": fit.samples,
        "A": fit.model.A.tolist(), "B": fit.model.B.tolist(),
    }  # fmt: skip
    table = Table(
        ["block", "entries", "largest difference [last printed digit]", "within ±2"],
        [[b.block, float(b.entries), b.units, b.agrees] for b in blocks],
        "Fitted matrices against (34) and (35)",
    )
    both = [
        _matrices("A and B, fitted", fit.model.A, fit.model.B),
        _matrices("A and B, printed in (34) and (35)", printed.A, printed.B),
    ]
    verdict = judged([good])
    return Claim(
        "3a",
        "Linear model by least squares, eqs. (33)–(35)",
        verdict,
        summary,
        numbers,
        [table, *both],
        {"identification": log},
        aside="in the printed matrix the motors turn the robot the other way",
    )


def _biased(robot: Robot, log: Log, fit: LeastSquares, longer: LeastSquares) -> Claim:
    true = unstable_pole(linearise(robot).c2d(printed.PERIOD))
    estimated, with_more = unstable_pole(fit.model), unstable_pole(longer.model)
    gives = "finds an unstable pole of" if estimated > 0 else "finds no unstable pole: its largest is"
    gives += f" {cell_text(estimated, 3)} 1/s"
    summary = (
        f"On the twin's sensors (encoders of 1°, gyro with noise and bias) the same regression {gives}; the true "
        f"unstable pole is {cell_text(true, 3)} 1/s. Noise in the regressors "
        f"biases least squares, and {MORE} times the data does not remove the bias ({cell_text(with_more, 3)} 1/s)."
    )
    reference = linearise(robot).c2d(printed.PERIOD)
    relative = float(np.linalg.norm(fit.model.A[:4, :4] - reference.A[:4, :4]) / np.linalg.norm(reference.A[:4, :4]))
    numbers = {
        "unstable_pole": estimated,
        "unstable_pole_with_more_data": with_more,
        "true_unstable_pole": true,
        "relative_error_of_A": relative,
        "A": fit.model.A.tolist(),
    }
    tables = [
        _matrices("A and B, from the sensors", fit.model.A, fit.model.B),
        _matrices("A and B, of the robot linearised", reference.A, reference.B),
    ]
    return Claim(
        "3b",
        "The same regression on realistic sensors is biased",
        BEYOND,
        summary,
        numbers,
        tables,
        {"identification-sensors": log},
    )


def _matrices(caption: str, A: Array, B: Array) -> Table:
    """A and B side by side, to the four decimals that are printed."""
    header = ["", *(signal.symbol for signal in STATE), "left", "right"]
    entries = np.round(np.column_stack([A, B]), 4) + 0.0  # + 0.0 makes a positive zero of a negative one
    rows: list[list[Cell]] = [
        [name.replace("_", " "), *row] for name, row in zip(STATE_NAMES, entries.tolist(), strict=True)
    ]
    return Table(header, rows, caption, digits=6)


def _misfit(block: str, model: LinearModel, B: Array, rows: tuple[int, ...]) -> Misfit:
    index = list(rows)
    fitted = np.column_stack([model.A[np.ix_(index, index)], model.B[index]])
    paper = np.column_stack([printed.A[np.ix_(index, index)], B[index]])
    difference = np.abs(fitted - paper)
    counted = difference.size
    if NOISE[0] in rows:
        difference[rows.index(NOISE[0]), rows.index(NOISE[1])] = 0.0
        counted -= 1
    return Misfit(block, float(difference.max()) / LAST_DIGIT, counted)


def _applied(log: Log) -> Array:
    return np.column_stack([log["applied/left"], log["applied/right"]])
