"""A log of another program: degrees, PWM, its own names. What is each column, and what is wrong with it?"""

import numpy as np

import upright as up
from upright.experiment.examples import example
from upright.logs.mapping import propose
from upright.logs.readers import read_table

# Such a file, as an Arduino sketch may print it: milliseconds, degrees, duty in steps of 255. One sign is wrong.
log = example("excited")
columns = {
    "millis": 1000 * log.t,
    "enc_left": np.degrees(log["sensor/encoder_left"]),
    "enc_right": np.degrees(log["sensor/encoder_right"]),
    "gyro": -np.degrees(log["sensor/gyro"]),
    "pwm_left": 255 * log["command/left"] / log["sensor/battery"],
    "pwm_right": 255 * log["command/right"] / log["sensor/battery"],
    "vbat": log["sensor/battery"],
}
rows = np.column_stack(list(columns.values()))
np.savetxt("arduino.csv", rows, fmt="%.5g", delimiter=",", header=",".join(columns), comments="")

print(
    propose(read_table("arduino.csv")).to_toml()
)  # what each column is taken for: save it, edit it, pass it as mapping
diagnosis = up.doctor("arduino.csv", robot="nxtway-gs")
print(diagnosis)
print("repaired:", diagnosis.repaired().save("repaired.parquet"))
