"""How well model and twin agree, and what a simulated second costs: `python benchmarks/twin.py`.

NXTway-GS drives off to 4.3 rad/s of wheel while it turns, each body under the same feedback; RMS over the twin's peak.
"""

from __future__ import annotations

import time

from upright.bodies import Body, NonlinearBody
from upright.bodies.twin import Twin
from upright.control import lqr
from upright.experiment import run
from upright.paper import turning
from upright.robots import Robot


def agreement(robot: Robot) -> None:
    """Complete and published model against the twin, at three yaw rates."""
    feedback = lqr(robot, turning.PERIOD)
    print(
        f"{'yaw [rad/s]':>12}{'model':>12}{'pitch RMS [%]':>15}{'max [%]':>10}{'wheel rate RMS [%]':>20}{'max [%]':>10}"
    )
    for rate in turning.RATES:
        twin = turning.drive(Twin(robot), feedback, rate)
        for model in ("complete", "published"):
            log = turning.drive(NonlinearBody(robot, model), feedback, rate)
            pitch, wheel = (turning.deviation(log, twin, state) for state in ("pitch", "wheel_rate"))
            numbers = (pitch.rms, pitch.largest, wheel.rms, wheel.largest)
            print(
                f"{rate:>12g}{model:>12}"
                + "".join(f"{100 * n:>{w}.3f}" for n, w in zip(numbers, (15, 10, 20, 10), strict=True))
            )


def cost(robot: Robot) -> None:
    """Computing time for one simulated second under feedback every 10 ms, beside the nonlinear model's."""
    bodies: dict[str, Body] = {"nonlinear model": NonlinearBody(robot), "twin": Twin(robot)}
    took: dict[str, float] = {}
    for name, body in bodies.items():
        best = float("inf")
        for _ in range(3):
            before = time.perf_counter()
            run(body, lqr(robot, 0.01), seconds=4.0, start=(0.05, 0, 0, 0, 0, 0))
            best = min(best, time.perf_counter() - before)
        took[name] = best / 4.0
    print(f"\n{'body':<20}{'[s] a simulated second':>25}{'ratio':>8}")
    for name, seconds in took.items():
        print(f"{name:<20}{seconds:>25.4f}{seconds / took['nonlinear model']:>8.2f}")


if __name__ == "__main__":
    nxtway = Robot.preset("nxtway-gs")
    agreement(nxtway)
    cost(nxtway)
