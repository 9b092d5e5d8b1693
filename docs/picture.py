"""Makes docs/push.gif, the picture of the README: run `python docs/picture.py` after a change of the models."""

from __future__ import annotations

from pathlib import Path

import upright as up
from upright.report.film import film

if __name__ == "__main__":
    robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
    pushes = (up.Impulse(impulse=0.2, start=0.5), up.Impulse(impulse=-0.2, start=3.5))
    logs = {
        "twin, on its sensors": up.run(
            up.Electronics(up.Twin(robot), kit), up.lqg(robot, kit), pushes, seconds=6.5, seed=1
        ),
        "linear model": up.run(up.LinearBody(up.linearise(robot), robot), up.lqr(robot, dt=0.01), pushes, seconds=6.5),
    }
    film(logs, Path(__file__).with_name("push.gif"), width=800, frames=20)
