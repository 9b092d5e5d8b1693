"""Linear models from a log that was recorded in closed loop, and why least squares is wrong there.

The controller answers each reading, noise included, so command and noise depend on each other. Least squares of the
readings takes that for physics. `bias` is measured by simulated repetitions with a known robot.
"""

import upright as up
from upright.experiment.examples import example

log, robot = example("excited"), up.Robot.preset("nxtway-gs")
true = max(pole.real for pole in up.linearise(robot).poles())
print(f"the twin falls with a pole of {true:.2f} 1/s")

for method in ("least-squares", "subspace"):
    found = up.identify(log, robot, method=method, runs=10)  # 40 by default
    pole = found.pole
    print(f"{method}: {pole.low:.2f} to {pole.high:.2f} 1/s, bias {pole.bias:+.2f}")
