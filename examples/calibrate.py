"""From one raw log to the robot's parameters, each with a 95 % interval; then that robot predicts another log."""

import upright as up
from upright.experiment.examples import example

log = example("excited")  # 12 s of a twin whose motors got small random voltages while it balanced
calibration = up.calibrate(log, up.Robot.preset("nxtway-gs"))
print(calibration)

motor = calibration["torque_constant"]
print(f"torque constant: {motor.low:.4f} to {motor.high:.4f} N m/A, {motor.verdict}")

calibration.known_robot().save("calibrated.toml")  # for every other command: --robot calibrated.toml
print(up.validate(example("pushed"), "calibrated.toml"))
up.report(calibration, "calibration.html")
