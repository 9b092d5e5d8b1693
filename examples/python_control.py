"""Our linear model in python-control: its poles, an LQR designed there, and the margins of that loop."""

import control
import numpy as np

import upright as up

robot = up.Robot.preset("nxtway-gs")
model = up.linearise(robot)  # six states; both motors, in volts
system = model.to_control()
print("poles:", np.round(np.sort_complex(system.poles()), 3))

largest = np.array([0.15, 1.5, 4.0, 15.0, 0.5, 3.0])  # accepted deviations of pitch, wheel, yaw and their rates
K, _, _ = control.lqr(system, np.diag(largest**-2), np.eye(2) / 4.0**2)  # Bryson's rule; 4 V
closed = control.ss(system.A - system.B @ K, system.B, system.C, 0)
print("closed loop:", np.round(np.sort_complex(closed.poles()), 3))

both = np.ones((2, 1))  # the same voltage to both motors: the loop that balances
loop = control.ss(system.A, system.B @ both, K[:1], 0)
gain, phase, *_ = control.margin(loop)
print(f"phase margin {phase:.0f} degrees; the gain may fall to {gain:.2f} of its value")
