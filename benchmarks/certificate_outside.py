"""Whether the certificate is right outside its spreads: robots that differ from what it assumes, each with a log.

    python benchmarks/certificate_outside.py 40                  # 40 robots
    python benchmarks/certificate_outside.py 40 --plain --each   # no posterior: the log is calibrated first
    python benchmarks/certificate_outside.py 40 --plain --weighed  # the same, and the robot stood on a scale
    python benchmarks/certificate_outside.py 40 --robots twipr ev3way --plain
    python benchmarks/certificate_outside.py 400 --fallen --plain  # certifies those alone that fall under a push

A robot differs in one way that its certificate does not know of: battery, slope, mass, delay, dead zone, motors, gyro's
scale or noise, or in none. Its log is of `LOGGED` seconds under the same controller, driven and knocked, in the
nonlinear model; the certificate has this log and the spreads of an older calibration, or with `--plain` this log alone.
It falls where it does under any of the standard pushes of the robot of the file, in runs of `SECONDS`. One that holds
may pass a limit of an amber light itself in these runs: a motor at its end, travel, sway at rest. It is counted too,
since an amber light is right of it.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Sequence
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy loads; many small products gain nothing by threads


sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.strangers import NOT_ASKED, OUTSIDE, REFUSED, ROBOTS, Stranger, stranger


def strangers(
    first: int, count: int, samples: int, *, each: bool, plain: bool, robots: Sequence[str], scale: bool, fallen: bool
) -> None:
    """Run and print the robots from number `first` on."""
    cases: list[Stranger] = []
    for number in range(first, first + count):
        cases.append(stranger(number, samples, plain=plain, robots=robots, scale=scale, fallen=fallen))
        if each and cases[-1].light != NOT_ASKED:
            print(cases[-1], flush=True)
    headings = ("no log", "fell", "not green", "held", "green", "passes", "refused", "taken")
    print(f"{'':<12}" + "".join(f"{name:>11}" for name in headings))
    for way in (*OUTSIDE, "all"):
        own = [c for c in cases if way in (c.way, "all")]
        with_log = [c for c in own if c.logged and c.light != NOT_ASKED]
        fell, held = ([c for c in with_log if c.fell is happened] for happened in (True, False))
        numbers = (sum(not c.logged for c in own), len(fell), sum(c.light != "green" for c in fell), len(held))
        passes = sum(bool(c.passes) and c.light not in ("green", REFUSED) for c in held)  # held, amber or red, rightly
        numbers += (sum(c.light == "green" for c in held), passes, sum(c.light == REFUSED for c in held))
        numbers += (sum("as the log shows" in c.reason for c in with_log),)
        print(f"{way:<12}" + "".join(f"{n:>11}" for n in numbers))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", type=int, nargs="?", default=40)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument(
        "--samples", type=int, default=1000, help="robots of a certificate; 1000 is the default of upright certify"
    )
    parser.add_argument("--each", action="store_true", help="print every case")
    parser.add_argument("--plain", action="store_true", help="no posterior, the log is calibrated")
    parser.add_argument("--weighed", action="store_true", help="the robot stood on a scale")
    parser.add_argument("--fallen", action="store_true", help="certify those alone that fall under a push")
    parser.add_argument("--robots", nargs="+", default=ROBOTS, help="presets to draw from")
    asked, started = parser.parse_args(), time.perf_counter()
    if asked.weighed and not asked.plain:
        parser.error("--weighed is of a robot without a posterior: add --plain")
    strangers(
        asked.first, asked.count, asked.samples, each=asked.each, plain=asked.plain, robots=asked.robots,
        scale=asked.weighed, fallen=asked.fallen,
    )  # fmt: skip
    print(f"{time.perf_counter() - started:.0f} s")


if __name__ == "__main__":
    main()
