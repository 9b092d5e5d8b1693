"""Section 5 again, on a robot with dry friction and backlash whose filter knows what a calibration gave."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.bodies import Electronics
from upright.bodies.twin import Twin
from upright.calibration.calibrate import calibrate
from upright.calibration.calibration import Calibration
from upright.comparison import compare
from upright.control import Estimated, StateFeedback, kalman
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.pages import Picture, Quantity, Say
from upright.paper import printed
from upright.paper.claim import Claim, agreed, judged
from upright.paper.pushes import MODELS, PUSHES, SECONDS, RegulatedRobot, never, plain, released, settling_table
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot
from upright.signals import Log

FRICTION = 0.005
"""[N m] of each motor, a guess: a quarter of what an NXT motor loses at no load (60 mA at 9 V, so 19 mN m)."""
PLAY = math.radians(1.1)
"""[rad] between wheel and encoder, a guess: about one count of the encoder."""
SEEDS = (1, 2)
AMPLITUDE, HELD, EXCITED = 1.2, 8, 10.0  # [V], rows, [s] of the run that is calibrated from
AT_REST = 2.0  # [s] at the end of a run
AS_BUILT = "twin with friction"
OTHERS = ("twin", *MODELS)


@dataclass(frozen=True)
class Settled:
    """One robot under one push. `settling` [s] by band (5 % and 2 % of the largest pitch after the release) and run; a
    run's value is a list, one for each seed, and infinity stands for a run that does not settle. `rest` is the largest
    pitch [rad] of the last `AT_REST` seconds, infinite where the robot fell."""

    settling: Mapping[str, Mapping[str, Sequence[float]]]
    rest: Mapping[str, Sequence[float]]

    @property
    def slower(self) -> bool | None:
        """The robot settles to 5 % later than both models, by more than a sample; None where the seeds disagree."""
        models = max(max(self.settling["5 %"][name]) for name in MODELS)
        return agreed(time > models + printed.PERIOD for time in self.settling["5 %"][AS_BUILT])


def built(robot: Robot, kit: Kit) -> tuple[Robot, Kit]:
    """`robot` with dry friction in its motors, and `kit` with play in its gears."""
    return robot.replace(coulomb_friction=FRICTION), replace(kit, motor=replace(kit.motor, backlash=PLAY))


def calibrated(robot: Robot, kit: Kit, feedback: StateFeedback) -> Calibration:
    """What one excited run of the robot as it is built tells to somebody who has the file of `robot`."""
    excitation = random_binary(round(EXCITED / kit.period), AMPLITUDE, seed=SEEDS[0], hold=HELD)
    controller = Excited(Estimated(feedback, kalman(robot, kit)), excitation)
    real, parts = built(robot, kit)
    log = run(Electronics(Twin(real), parts), controller, seconds=EXCITED, seed=SEEDS[0])
    raw = {name: values for name, values in log.channels.items() if not name.startswith("truth/")}
    return calibrate(Log(log.t, raw, {name: log.units[name] for name in raw}, log.origin), robot, kit)


def pushed(trial: RegulatedRobot, known: Robot, side: str, kit: Kit, seed: int) -> Log:
    """The robot as it is built, held and released; its filter knows the robot as `known`."""
    real, parts = built(trial.robot, kit)
    return released(Electronics(Twin(real), parts), Estimated(trial.feedback, kalman(known, kit)), side, seed)


def settled(logs: Mapping[str, Sequence[Log]]) -> Settled:
    """How long pitch takes to settle after the release, and how far it swings at the end."""
    metrics = {name: [compare({name: log}).metrics[name] for log in several] for name, several in logs.items()}
    settling = {
        "5 %": {name: [never(m.settling_5) for m in several] for name, several in metrics.items()},
        "2 %": {name: [never(m.settling_2) for m in several] for name, several in metrics.items()},
    }
    return Settled(settling, {name: [_rest(log) for log in several] for name, several in logs.items()})


def _rest(log: Log) -> float:
    if log.origin["outcome"]["fell"]:
        return math.inf
    return float(np.abs(log.between(SECONDS - AT_REST, SECONDS)["truth/pitch"]).max())


def chapter(trial: RegulatedRobot, kit: Kit, logs: Mapping[str, Log], progress: Progress = unwatched) -> Claim:
    """The paper's finding that settling times differ, the linear model's being the shortest, on a robot with losses.

    `logs` are the runs of 5a to 5d, by robot, push and run.
    """
    name = trial.robot.name
    calibration = calibrated(trial.robot, kit, trial.feedback)
    cases: dict[str, Settled] = {}
    kept: dict[str, Log] = {}
    for side in PUSHES:
        progress((1 + len(cases)) / (1 + len(PUSHES)))
        runs = [pushed(trial, calibration.robot, side, kit, seed) for seed in SEEDS]
        kept[f"{name}-{side}-as-built"] = runs[0]
        others = {other: logs[f"{name}-{side}-{other}"] for other in OTHERS}
        cases[f"{side} push"] = settled({AS_BUILT: runs, **{other: [log] for other, log in others.items()}})
    counts = {"n": sum(c.slower is True for c in cases.values()), "all": len(cases)}
    summary = Say(
        "With guessed friction and backlash, {robot} settles later than both models under {n} of {all} pushes.",
        robot=name,
        **counts,
    )
    friction = calibration["coulomb_friction"]
    guess = Say(
        "Friction of {friction} and backlash of {play} are guesses; a calibration finds {known}.",
        friction=Quantity(FRICTION, "N m"),
        play=Quantity(PLAY, "rad", digits=2),
        known=Quantity(friction.value, "N m", low=friction.low, high=friction.high, digits=2),
    )
    numbers = {
        "friction": FRICTION,
        "backlash": PLAY,
        "seeds": list(SEEDS),
        "cases": {
            name: {
                "settling": {band: plain(runs) for band, runs in c.settling.items()},
                "rest": plain(c.rest),
                "slower": c.slower,
            }
            for name, c in cases.items()
        },
    }
    front = {AS_BUILT: kept[f"{name}-front-as-built"], **{model: logs[f"{name}-front-{model}"] for model in MODELS}}
    picture = Picture(
        Say("Friction keeps the robot swinging, front push"), functools.partial(compare(front).plot, "pitch")
    )
    table = settling_table({name: case.settling["5 %"] for name, case in cases.items()})
    verdict = judged(case.slower for case in cases.values())
    blocks = [picture, guess, table]
    result = Say("later in {n} of {all}", **counts)
    return Claim("5f", Say("Settling with friction"), verdict, summary, numbers, blocks, kept, result=result)
