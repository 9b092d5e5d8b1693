"""How often visible intervals hold the truth of robots that others made: logs of `tests/planted/foreign`.

    python benchmarks/calibrate_foreign.py --robots arduino --first-seed 40 --logs 4
    python benchmarks/calibrate_foreign.py --dead-zone 0.6      # motors that nothing below 0.6 V moves

Robots that stay in a plane are held for half a second and then balance, excited; those that turn (F, G, H) are driven
and knocked. The file is what its owner would have measured. Prints a row for each log: visible intervals that hold, the
numbers whose interval misses, and time.
"""

from __future__ import annotations

import harness
from calibrate import off

from planted import foreign
from planted.foreign import plane
from upright.calibration.calibrate import calibrate
from upright.logs.mapping import apply, propose
from upright.logs.readers import RawTable


def main() -> None:
    asked = harness.options(__doc__, robots=tuple(plane.ROBOTS), first_seed=40, logs=3, dead_zone=0.0)
    harness.machine("numpy")
    held = harness.Held()
    for name in asked.robots:
        for seed in range(asked.first_seed, asked.first_seed + asked.logs):
            options = {"dead_zone": asked.dead_zone} if name in plane.ROBOTS else {}
            case = foreign.stand(name, seed, **options)
            clock, log = harness.Clock(), case.log
            found = calibrate(apply(propose(log), log) if isinstance(log, RawTable) else log, case.file)
            missed = off((*found.parameters, *found.combinations, *found.delays), case.truth)
            right = [held.add(number, not by) for number, by in missed.items()]
            refused = "; refused" if found.refused else ""
            names = ", ".join(number for number, by in missed.items() if by)
            print(f"{name:8} {seed:3}  {sum(right):2} of {len(right):2} hold; {clock}{refused}  {names}", flush=True)
    print(held)


if __name__ == "__main__":
    main()
