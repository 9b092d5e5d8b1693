"""A controller as a program for a brick: its statements with proven ranges, and its text in two languages."""

import upright as up
from upright.firmware import generate, trace

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
controller = up.lqg(robot, kit)

# every number that the program computes has a range that it cannot leave, whatever the sensors say
program = trace(controller, robot, kit, "nxc")
print(program)

# the same statements as source: NXC for the NXT's own firmware, Python for a brick with ev3dev
for language in ("nxc", "ev3dev"):
    text = generate(controller, robot, kit, language).text
    duty = [line.strip() for line in text.splitlines() if "duty_left" in line]
    print(f"{language}: {len(text.splitlines())} lines, those of the left motor's duty:", *duty, sep="\n    ")
