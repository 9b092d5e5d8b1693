"""A controller of your own: four gains that somebody chose by hand, beside LQR, under the same push.

`upright simulate --controller examples/own_controller.py:HandMade` runs it too.
"""

import upright as up
from upright.control import ControllerSpec

READS = ("truth/wheel", "truth/pitch", "truth/wheel_rate", "truth/pitch_rate")


class HandMade:
    """The same voltage to both motors, from the angles and rates of wheel and body."""

    def __init__(self, robot, kit=None, dt=0.01, gains=(0.5, 25.0, 1.0, 2.5)):
        self.gains = gains  # [V/rad, V/rad, V s/rad, V s/rad]
        self.spec = ControllerSpec("hand-made", READS, dt or 0.01)

    def reset(self):
        """It has no memory to clear."""

    def step(self, measurement, reference):
        volts = sum(gain * value for gain, value in zip(self.gains, measurement, strict=True))
        return volts, volts

    def estimate(self):
        return ()  # an observer would give its six states here

    def applied(self, command):
        """The command that the motors really got; an observer would use it."""

    def to_json(self):
        return {"kind": "hand-made", "gains": list(self.gains)}


if __name__ == "__main__":
    robot = up.Robot.preset("nxtway-gs")
    push = up.Impulse(impulse=0.05, start=1.0)
    logs = {
        controller.spec.kind: up.run(up.Twin(robot), controller, push, seconds=6.0)
        for controller in (up.lqr_state(robot, dt=0.01), HandMade(robot))
    }
    print(up.compare(logs))
