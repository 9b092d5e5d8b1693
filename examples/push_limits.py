"""The largest knock that each method survives, from behind, found by bisection on the twin."""

import upright as up

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")


def survives(controller, impulse):
    body, push = up.Electronics(up.Twin(robot), kit), up.Impulse(impulse=impulse, start=0.5)
    return not up.run(body, controller, push, seconds=3.0, seed=1).origin["outcome"]["fell"]


for design in (up.lqg, up.pid, up.sliding):
    controller, low, high = design(robot, kit), 0.0, 1.0  # [N s]
    while high - low > 0.01:
        middle = (low + high) / 2
        low, high = (middle, high) if survives(controller, middle) else (low, middle)
    print(f"{controller.spec.kind}: {low:.2f} N s")
