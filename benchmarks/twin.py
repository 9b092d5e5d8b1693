"""How well model and twin agree, and what a simulated second costs: `python benchmarks/twin.py`.

NXTway-GS drives off to 4.3 rad/s of wheel while it turns, each body under the same feedback; RMS over the twin's peak.
"""

from __future__ import annotations

import harness

from upright.bodies import NonlinearBody
from upright.bodies.twin import Twin
from upright.control import lqr_state
from upright.experiment import run
from upright.paper import turning
from upright.robots import Robot


def agreement(robot: Robot) -> None:
    """Complete and published model against the twin, at three yaw rates."""
    feedback = lqr_state(robot, turning.PERIOD)
    table = harness.Table(
        "yaw [rad/s] >12g",
        "model >12",
        "pitch RMS [%] >15.3f",
        "max [%] >10.3f",
        "wheel rate RMS [%] >20.3f",
        "max [%] >10.3f",
    )
    for rate in turning.RATES:
        twin = turning.drive(Twin(robot), feedback, rate)
        for model in ("complete", "published"):
            log = turning.drive(NonlinearBody(robot, model), feedback, rate)
            pitch, wheel = (turning.deviation(log, twin, state) for state in ("pitch", "wheel_rate"))
            table.row(rate, model, *(100 * n for n in (pitch.rms, pitch.largest, wheel.rms, wheel.largest)))


def cost(robot: Robot) -> None:
    """Computing time for one simulated second under feedback every 10 ms, beside the nonlinear model's."""
    bodies = {"nonlinear model": NonlinearBody(robot), "twin": Twin(robot)}
    start = (0.05, 0, 0, 0, 0, 0)
    jobs = {n: lambda b=b: run(b, lqr_state(robot, 0.01), seconds=4.0, start=start) for n, b in bodies.items()}
    took = harness.best(jobs, 3)
    print()
    table = harness.Table("body <20", "[s] a simulated second >25.4f", "ratio >8.2f")
    for name, seconds in took.items():
        table.row(name, seconds / 4.0, seconds / took["nonlinear model"])


def main() -> None:
    harness.options(__doc__)
    nxtway = Robot.preset("nxtway-gs")
    agreement(nxtway)
    cost(nxtway)


if __name__ == "__main__":
    main()
