"""The comparison of the paper: robot (here its twin), nonlinear and linear model, held at 0.1 rad and released."""

import upright as up

robot = up.Robot.preset("herrera2015")
controller = up.lqr_state(robot, dt=0.01)
release = up.Hold(pitch=0.1, until=1.0)

bodies = {
    "twin": up.Twin(robot),
    "nonlinear": up.NonlinearBody(robot),
    "linear": up.LinearBody(up.linearise(robot), robot),
}
logs = {name: up.run(body, controller, release, seconds=6.0) for name, body in bodies.items()}

comparison = up.compare(logs)  # the first is the reference
print(comparison)
up.report(comparison, "compare.html")
