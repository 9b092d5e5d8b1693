"""Tune: which weights would an LQG need, so that fewer robots fall and a larger knock is survived?"""

import upright as up

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")

tuned = up.tune("lqg", robot, kit, budget=40)  # 400 candidates by default
print(tuned)  # figures on 1000 robots that neither the search nor its rule has used

for point in tuned.front:  # another choice is yours: none of these is beaten in everything
    f = point.figures
    print(f"{100 * f.falls:.2f} % fall, knock {f.knock:.2f} N s, effort {f.effort:.3g}")

tuned.save("tuned.json")  # a controller file as any other
up.report(tuned, "tune.html")

hold = up.Hold(pitch=0.1, until=1.0)
travel = []
for controller in (tuned.controller, up.lqg(robot, kit)):
    log = up.run(up.Electronics(up.NonlinearBody(robot), kit), controller, hold, seconds=4.0, seed=1)
    travel.append(1e3 * robot.wheel_radius * abs(log["truth/wheel"]).max())
print(f"after a hold: {travel[0]:.0f} mm of travel instead of {travel[1]:.0f} mm")
