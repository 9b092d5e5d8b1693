"""Push a simulated LEGO robot, with the sensors and motors that it really has, and plot what it did."""

import upright as up

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
controller = up.lqg(robot, kit)  # LQR and a Kalman filter: it sees encoders and gyro, not the true state
body = up.Electronics(up.Twin(robot), kit)  # MuJoCo, inside the electronics of the kit

push = up.Impulse(impulse=0.05, start=2.0)  # [N s], at the centre of mass
log = up.run(body, controller, push, seconds=8.0, seed=1)

print(log)
print(f"largest lean {abs(log['truth/pitch']).max():.3f} rad, travel {abs(log['sensor/encoder_left']).max():.2f} rad")
log.plot().savefig("simulate.png")
log.save("simulate.csv")  # or .parquet, .mcap
