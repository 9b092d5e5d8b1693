"""How many planted faults the log doctor names, and how often it cries wolf over a clean log.

    python benchmarks/doctor.py [--clean 50] [--seed 0]

Every log is a twin or the nonlinear model behind a kit's electronics, stripped of its origin and of `truth/…`; the
doctor is told neither robot nor kit. A fault counts as named when the right code is found, on the right channel where
the channel matters, with no other error beside it. What a kit really does (a late gyro, a saturated motor) is no false
alarm.
"""

from __future__ import annotations

import harness

from planted.faults import CASES, false_alarms, named, planted, standing
from upright.checkup.doctor import doctor


def main() -> None:
    options = harness.options(__doc__, clean=50, seed=0)
    right = 0
    for case in CASES:
        clock = harness.Clock()
        diagnosis = doctor(planted(case, options.seed))
        ok = named(case, diagnosis)
        right += ok
        said = ", ".join(f"{f.code} {f.channel}" for f in diagnosis.findings if f.severity != "note") or "nothing"
        verdict, spent = "named " if ok else "MISSED", clock.wall
        print(f"{verdict} {case.name:32} {case.setting:12} {said}  ({spent:.1f} s)", flush=True)
    print(f"\nplanted faults named rightly: {harness.share(right, len(CASES))}")
    wrong = 0
    for seed in range(options.seed, options.seed + options.clean):
        name, log = standing(seed)
        alarms = false_alarms(name, log, doctor(log))
        wrong += bool(alarms)
        for alarm in alarms:
            print(f"false alarm on clean log {seed} ({name}): {alarm}", flush=True)
    print(f"clean logs that raised a false alarm: {harness.share(wrong, options.clean)}")


if __name__ == "__main__":
    main()
