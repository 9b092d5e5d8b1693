"""A controller as a program for a brick: its statements with proven ranges, and its text in the brick's language."""

import upright as up
from upright.firmware import generate, trace

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
controller = up.lqg(robot, kit)
program = trace(controller, robot, kit, "nxc")
print(program)

made = generate(controller, robot, kit, "nxc")
print("\n".join(line for line in made.text.splitlines() if "duty_left" in line))
