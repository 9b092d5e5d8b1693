"""How many planted faults the log doctor names, and how often it cries wolf over a clean log.

    python benchmarks/doctor.py [--clean 50] [--seed 0]

Every log is a twin or the nonlinear model behind a kit's electronics, stripped of its origin and of `truth/…`; the
doctor is told neither robot nor kit. A fault counts as named when the right code is found, on the right channel where
the channel matters, with no other error beside it. What a kit really does (a late gyro, a saturated motor) is no false
alarm.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.faults import CASES, false_alarms, named, planted, standing
from upright.doctor.doctor import doctor


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--clean", type=int, default=50)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args(argv)
    right = 0
    for case in CASES:
        start = time.perf_counter()
        diagnosis = doctor(planted(case, options.seed))
        ok = named(case, diagnosis)
        right += ok
        said = ", ".join(f"{f.code} {f.channel}" for f in diagnosis.findings if f.severity != "note") or "nothing"
        verdict, spent = "named " if ok else "MISSED", time.perf_counter() - start
        print(f"{verdict} {case.name:32} {case.setting:12} {said}  ({spent:.1f} s)", flush=True)
    print(f"\n{right} of {len(CASES)} planted faults named rightly")
    wrong = 0
    for seed in range(options.seed, options.seed + options.clean):
        name, log = standing(seed)
        alarms = false_alarms(name, log, doctor(log))
        wrong += bool(alarms)
        for alarm in alarms:
            print(f"false alarm on clean log {seed} ({name}): {alarm}", flush=True)
    print(f"{wrong} of {options.clean} clean logs raised a false alarm")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
