"""Do the controllers of the LEGO presets hold a robot that has dry friction and play in its gears?

    python benchmarks/as_built.py          # a minute

Each method designs for the preset and its kit as they stand. It then balances that robot from leans up to 0.06 rad; the
same with 5 mN m of dry friction in each motor; with 1.1° of play between wheel and encoder; and with both. Printed are
falls, and by how much pitch and wheel still move in the last three of eight seconds.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command `upright` does

import numpy as np

from upright.control import Controller, make_controller
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.paper.as_built import built
from upright.robots import Kit, Robot, find_kit

ROBOTS = ("herrera2015", "nxtway-gs", "nxtway-gs-measured", "ev3way", "ev3way-large-wheels")
METHODS = ("lqr", "lqg", "pid", "mpc", "sliding")
STARTS, LEAN = 32, 0.06  # [rad]
SECONDS, LAST = 8.0, 3.0


def balanced(robot: Robot, kit: Kit, controller: Controller) -> str:
    """Falls, and the largest distance from the mean of pitch [mrad] and wheel [rad] at the end."""
    starts = np.zeros((STARTS, 6))
    starts[:, 0] = np.linspace(-LEAN, LEAN, STARTS)
    batch = FleetBatch(parameters=parameters_of([robot] * STARTS), controller=controller, start=starts, kit=kit, seed=1)
    result = simulate(batch, SECONDS, record=1, channels=("truth/pitch", "truth/wheel"))
    last = result.trace[~result.fell, -round(LAST / controller.spec.period) :]
    if not len(last):
        return f"{STARTS} fall"
    pitch, wheel = np.abs(last - last.mean(axis=1, keepdims=True)).max(axis=(0, 1)).tolist()
    return f"{int(result.fell.sum())} fall, ±{1000 * pitch:.0f} mrad, ±{wheel:.2f} rad"


def main() -> None:
    print("| preset | method | as it is | dry friction | play | both |\n|---|---|---|---|---|---|")
    for name in ROBOTS:
        robot = Robot.preset(name)
        kit = find_kit(robot.kit)
        dry, play = built(robot, kit)
        for method in METHODS:
            controller = make_controller(method, robot, kit, kit.period)
            pairs = ((robot, kit), (dry, kit), (robot, play), (dry, play))
            print(f"| {name} | {method} | {' | '.join(balanced(*one, controller) for one in pairs)} |", flush=True)


if __name__ == "__main__":
    main()
