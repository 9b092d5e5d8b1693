"""Design, then prove: what do 300 robots that could be yours do under this controller, before a motor turns?"""

import upright as up

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")

for design in (up.lqg, up.pid):
    controller = design(robot, kit)
    certificate = up.certify(controller, robot, samples=300, sweeps=False)  # 1000 robots and delay sweeps by default
    print(certificate)
    print()

certificate = up.certify(up.lqg(robot, kit), robot, samples=300)
up.report(certificate, "certificate.html")
certificate.save("certificate.json")  # `upright firmware` and `upright fly` ask for it
