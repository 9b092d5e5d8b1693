"""A controller as a program for a brick: its text, and its answer to a lean, computed as the brick would."""

import upright as up
from upright.compiled.interpret import Interpreter
from upright.firmware import trace

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
controller = up.lqg(robot, kit)
program = trace(controller, robot, kit, "nxc")  # statements with proven ranges, for one brick
print(program)

machine = Interpreter(program)
for period in range(5):  # it tips forward: 20 degrees a second, the wheels still
    raw = {"raw_encoder_left": 0, "raw_encoder_right": 0, "raw_gyro": 20, "raw_battery": 7900}
    duty = machine.command(raw)["duty_left"]
    machine.update()
    print(f"{10 * period} ms: duty {duty:.0f} %")
