"""Ten thousand robots under the same push: which one falls, and what is different about it?"""

import numpy as np

import upright as up

result = up.fleet(
    "nxtway-gs",
    n=10_000,
    controller=up.lqg(up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")),
    vary={"com_height": "±20%", "body_mass": "±20%", "torque_constant": "±20%"},
    pushes=(up.Impulse(impulse=0.3),),
    seconds=3.0,
)
print(result)

fell = result.data["fell"].values.astype(bool)
for name in ("com_height", "body_mass", "torque_constant"):
    values = result.data[name].values
    print(f"{name}: {np.mean(values[fell]):.4g} where it fell, {np.mean(values[~fell]):.4g} where it stood")
up.report(result, "sweep.html")
