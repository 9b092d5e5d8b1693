"""Every finding of the doctor on the real logs beside the checkout, next to a figure computed without the doctor.

    python benchmarks/doctor_logs.py [--data FOLDER]
    python benchmarks/doctor_logs.py --cuts 60   # false alarms in as many parts of each log, cut out at random

The figures come from the raw columns by counts, sums and correlations alone. The whole logs have no wrong sign, unit,
kind or offset, so that none of their parts has one.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import harness
import numpy as np
from numpy.typing import NDArray

from upright.checkup.doctor import doctor
from upright.logs.readers import RawTable, read_table

Array = NDArray[np.float64]

LOGS = (
    "ev3way/tilt_000.csv", "ev3way/nn_v17_005.csv", "ev3way/nn_v7_000.csv", "regbot/position_step_2m.txt",
    "regbot/wheel_speed_upside_down.txt", "twipr/run1.csv", "twipr/run2_all.csv", "twipr/direct_1_all.csv",
    "ev3-balanc3r/datalog.json.txt",
)  # fmt: skip
ROBOTS = {"ev3way": "ev3way-large-wheels", "twipr": "twipr"}
FALSE = ("gyro/bias", "motion/flipped", "motion/swapped", "motion/integrated", "motion/differentiated", "units/",
         "encoder/jump", "encoder/grain")  # fmt: skip
"""How the codes begin that no part of these logs deserves; encoders of REGBOT and TWIPR are rates that were summed."""


def lag(one: Array, two: Array, period: float, reach: int = 12) -> str:
    """By how much `one` is behind `two`, where their correlation is largest in size [ms]."""
    n = len(one) - reach
    size = {k: abs(float(np.corrcoef(one[k : n + k], two[:n])[0, 1])) for k in range(reach)}
    best = max(size, key=lambda k: size[k])
    return f"largest correlation {best * period * 1e3:.0f} ms behind"


def turned(t: RawTable) -> str:
    """The gyro summed over the last second [rad]."""
    rate = np.radians(t.columns["gyro_raw"])
    clock = t.columns["t_ms"] / 1000
    last = clock > clock[-1] - 1.0
    return f"the raw gyro sums to {float(np.sum(rate[last][1:] * np.diff(clock[last]))):+.2f} rad in the last second"


def _repeats(t: RawTable) -> str:
    g = t.columns["gyro_raw"]
    moving = np.abs(g[3:] - g[:-3]) >= 6
    step = np.abs(np.diff(g)[1:-1][moving])
    return f"{int((step == 0).sum())} of {int(moving.sum())} steps are 0, {int((step == 1).sum())} are ±1"


def _leaning(t: RawTable) -> float:
    up = np.abs(t.columns["theta_rad"]) < 1.0
    clock = t.columns["t_s"]
    summed = np.concatenate([[0.0], np.cumsum(t.columns["theta_dot_radps"][1:] * np.diff(clock))])
    rest = (t.columns["theta_rad"] - summed)[up]
    leant = np.arctan2(t.columns["acc_y"], t.columns["acc_z"])[up] - t.columns["theta_rad"][up]
    return float(np.corrcoef(np.diff(rest), leant[1:])[0, 1])


def _upright(t: RawTable) -> float:
    return float(t.columns["t_s"][(np.abs(t.columns["theta_rad"]) < 0.2).argmax()])


def _gyro_lag(t: RawTable) -> str:
    if "gyro_raw" in t.columns:
        wheel = (t.columns["cnt_l"] + t.columns["cnt_r"]) / 2
        smooth = np.convolve(np.gradient(np.gradient(wheel)), np.ones(3) / 3, "same")
        return "change of gyro and of wheel rate: " + lag(np.gradient(t.columns["gyro_raw"]), smooth, 0.0107)
    speed = (t.columns["speed_left_radps"] + t.columns["speed_right_radps"]) / 2
    on = t.columns["mode"] == 3
    return "change of wheel rate and of gyro: " + lag(
        np.gradient(speed)[on], np.gradient(t.columns["theta_dot_radps"])[on], 0.01
    )


FIGURES: dict[str, Callable[[RawTable], str]] = {
    "samples/repeated": _repeats,
    "saturation": lambda t: f"|pwm| is 100 in {float((np.abs(t.columns['pwm_l']) >= 100).mean()):.1%} of the rows",
    "segment/fall": turned,
    "samples/controller": lambda t: (
        "its header says " + (re.findall(r"decim=\d", " ".join(t.comments)) or ["1 ms (REGBOT's firmware)"])[0]
    ),
    "channel/coarse": lambda t: f"{len(np.unique(t.columns['gyro_ang_x10']))} different values in the whole log",
    "estimate/accelerometer": lambda t: (
        "the estimate less the summed gyro follows atan2(acc_y, acc_z): correlation "
        f"{_leaning(t):.2f}"
    ),
    "segment/still": lambda t: (
        "the first wheel speed beyond ten quanta is in row "
        f"{int((np.abs(t.columns['speed_left_radps']) > 0.245).argmax())}"
    ),
    "motion/quiet": lambda t: f"the logged angle has a deviation of {t.columns['gyroEstimatedAngle'].std():.4f} rad",
    "segment/lying": lambda t: f"the logged tilt begins at {t.columns['theta_rad'][0]:+.2f} rad",
    "segment/upside-down": lambda t: f"the logged tilt is {np.median(t.columns['c17']):+.2f} rad",
    "segment/standing-up": lambda t: f"the logged tilt is first within 0.2 rad at {_upright(t):.2f} s",
    "delay/sensor": _gyro_lag,
    "delay/command": lambda _: "the calibration (`upright calibrate`, another method) finds 76 and 48 ms in run1",
}  # fmt: skip


def cuts(folder: Path, parts: int, seed: int) -> None:
    """The false alarms in parts of 110 to 700 rows, without a robot and with the right one by turns."""
    rng = np.random.default_rng(seed)
    for name in LOGS:
        if name.endswith(".json.txt"):
            continue  # too quiet for any of these checks
        table, false = read_table(folder / name), Counter[str]()
        robot = next((preset for robot, preset in ROBOTS.items() if name.startswith(robot)), None)
        for part in range(parts):
            rows = int(rng.integers(110, min(700, len(table))))
            first = int(rng.integers(0, len(table) - rows))
            columns = {column: values[first : first + rows] for column, values in table.columns.items()}
            diagnosis = doctor(replace(table, columns=columns), robot=robot if part % 2 else None)
            false.update(code for code in set(diagnosis.codes()) if code.startswith(FALSE))
        said = ", ".join(f"{code} {count}" for code, count in false.most_common()) or "none"
        print(f"| `{name.split('.')[0]}` | {parts} | {said} |", flush=True)


def main() -> None:
    asked = harness.options(__doc__, data=harness.DATA, cuts=0, seed=0)
    if asked.cuts:
        cuts(asked.data, asked.cuts, asked.seed)
    else:
        findings(asked.data)


def findings(folder: Path) -> None:
    """The table of the whole logs."""
    for name in LOGS:
        table = read_table(folder / name)
        seen = set[str]()
        for finding in doctor(table).findings:
            if finding.code in seen:
                continue
            seen.add(finding.code)
            figure = FIGURES.get(finding.code)
            try:
                beside = figure(table) if figure else "–"
            except KeyError:
                beside = "–"
            print(f"| `{name.split('.')[0]}` | {finding.code} | {finding.evidence} | {beside} |", flush=True)


if __name__ == "__main__":
    main()
