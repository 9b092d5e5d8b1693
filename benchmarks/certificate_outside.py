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

from collections.abc import Sequence

import harness

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
    names = ("no log", "fell", "not green", "held", "green", "passes", "refused", "taken")
    table = harness.Table("way <12", *(f"{name} >11" for name in names))
    for way in (*OUTSIDE, "all"):
        own = [c for c in cases if way in (c.way, "all")]
        with_log = [c for c in own if c.logged and c.light != NOT_ASKED]
        fell, held = ([c for c in with_log if c.fell is happened] for happened in (True, False))
        numbers = (sum(not c.logged for c in own), len(fell), sum(c.light != "green" for c in fell), len(held))
        passes = sum(bool(c.passes) and c.light not in ("green", REFUSED) for c in held)  # held, amber or red, rightly
        numbers += (sum(c.light == "green" for c in held), passes, sum(c.light == REFUSED for c in held))
        numbers += (sum("as the log shows" in c.reason for c in with_log),)
        table.row(way, *numbers)


def main() -> None:
    asked = harness.options(
        __doc__, ("count", 40), first=0, samples=1000, each=False, plain=False, weighed=False, fallen=False,
        robots=ROBOTS,
    )  # fmt: skip
    if asked.weighed and not asked.plain:
        raise SystemExit("--weighed is of a robot without a posterior: add --plain")
    clock = harness.Clock()
    strangers(
        asked.first, asked.count, asked.samples, each=asked.each, plain=asked.plain, robots=asked.robots,
        scale=asked.weighed, fallen=asked.fallen,
    )  # fmt: skip
    print(clock)


if __name__ == "__main__":
    main()
