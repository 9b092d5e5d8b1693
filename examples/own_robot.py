"""A robot of your own: begin with a preset, replace what you measured, and ask what the rest may be."""

import upright as up

lego = up.Robot.preset("nxtway-gs")
mine = lego.replace(
    name="my robot",
    wheel_radius=0.028,  # [m] a ruler
    body_mass=0.72,  # [kg] kitchen scales
    com_height=0.095,  # [m] where it balances on an edge
)
mine.save("my_robot.toml")  # every number, its unit and its source; edit it, and read it with Robot.load
print(up.Robot.load("my_robot.toml"))

for robot in (lego, mine):
    falling = max(pole.real for pole in up.linearise(robot).poles())
    print(f"{robot.name}: a fall grows e-fold in {1000 / falling:.0f} ms")

log = up.run(up.NonlinearBody(mine), up.lqr_state(mine, dt=0.01), up.Hold(pitch=0.1, until=1.0), seconds=5.0)
print(f"after 5 s it leans by {log['truth/pitch'][-1]:+.4f} rad")
