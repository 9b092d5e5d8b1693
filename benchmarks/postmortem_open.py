"""Whether the post-mortem knows its limits: faults outside the nine of `postmortem.py`, and two faults at once.

    python benchmarks/postmortem_open.py                                       # 6 falls of each fault, 24 pairs
    python benchmarks/postmortem_open.py --first-seed 7300 --runs 10 --results told.jsonl    # again resumes

`LISTED` are causes that the post-mortem knows, planted in the twin by MuJoCo's own means: actuators without gain,
locked joints, a box in the way, tilted gravity, another mass. `UNLISTED` are in no list of the code: right is "none of
these", or a cause that says the same. Of a pair neither fault fells the robot alone. As in `postmortem.py`, a run
counts where it falls after the onset and does not fall without the fault, and nothing of the truth is shown.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import harness
import numpy as np
from postmortem import Told

from planted.falls import Fault, NoFall
from planted.open_falls import LISTED, PAIRS, SEED, UNLISTED, Broken, broken, right
from upright.diagnose import post_mortem
from upright.diagnose.changes import scaled_sensors
from upright.diagnose.evidence import Evidence, gather
from upright.diagnose.fault_fits import FAULT_NUMBERS, FaultFit, score_of, with_pushes
from upright.diagnose.innovations import FilterRun
from upright.diagnose.pairs import together
from upright.diagnose.remedy import COMMAND_FAULTS, READING_FAULTS, beside_pushes, exact, moved
from upright.diagnose.usual import window_of
from upright.robots import Kit, Robot

NEAREST = 20  # signatures of the planted kind, by their onset, in which the log is searched for it


def planted_fit(fault: Fault) -> FaultFit | None:
    """What was planted, in the terms of the code under test; None of a push, which needs none."""
    size, way = fault.size, fault.way
    if fault.cause == "push too large":
        return None
    if fault.cause == "gyro bias":
        return FaultFit(fault="bias", way=way, onset=fault.onset, size=fault.sign * size)
    if fault.cause == "weak battery":
        return FaultFit(fault="weak", way=way, onset=fault.onset, size=size, rise=0.5)
    if fault.cause == "sensor mis-scaled":
        return FaultFit(fault="scale", way=way, onset=fault.onset, size=1 - 1 / size)
    return FaultFit(fault=fault.cause.split()[0].replace("load", "payload"), onset=fault.onset, size=size)


def supported(case: Broken, run: FilterRun, evidence: Evidence) -> tuple[float, float]:
    """What the log supports: nats by which a fit that is started at both planted causes explains it better than each of
    them alone, and than the best that was found."""
    window = window_of(run, evidence.fell_at)
    bank = window.bank(run, pushes_only=False)
    planted = [fit for fault in case.faults if (fit := planted_fit(fault)) is not None]
    alone: list[FaultFit] = []
    if len(scaled_sensors(run)) == 2:  # two encoders that agree are read as one
        planted = [replace(fit, way=fit.way.replace("encoders", "encoder_left")) for fit in planted]
    for i, fit in enumerate(planted):
        if fit.fault in READING_FAULTS + COMMAND_FAULTS:
            near = (exact(run, one, window, bank) for one in (fit, *moved(run, [[fit]], window)))
            best = max(near, key=lambda one: one.score)
            alone.append(beside_pushes(run, best, window, bank) if best.pushes else best)
        else:
            signatures = sorted(
                (o for o in bank.faults if o.fault == fit.fault), key=lambda o: abs(o.onset - fit.onset)
            )
            alone.append(max((with_pushes(bank, one) for one in signatures[:NEAREST]), key=lambda one: one.score))
            planted[i] = replace(fit, values=alone[-1].values)
    if len(planted) == 2:
        both, lesser = together(run, *planted, window, bank).score, [fit.score for fit in alone]
    else:  # beside a push
        if not len(alone[0].rest):  # the filter loses the robot even so
            return -math.inf, -math.inf
        here = window.bank(alone[0].run) if alone[0].run is not None else None
        y = bank.y + alone[0].values if here is None else here.y
        both, lesser = alone[0].score, [evidence.pushes_only.score, score_of(bank, y, FAULT_NUMBERS)]
    found = max([fit.score for fit in evidence.fits] + [pair.score for pair in evidence.pairs[:1]])
    return both - max(lesser), both - found


def judged(key: tuple[Sequence[str], int]) -> Told:
    """One fall, made and examined. `nats`: what the log supports of two causes (`supported`)."""
    causes, seed = key
    name = "+".join(causes)
    try:
        case = broken(tuple(causes), seed)
    except NoFall as error:
        return Told(name, seed, trouble=str(error))
    nominal, clock = Robot.preset(case.robot), harness.Clock()
    found = post_mortem(case.log, nominal)
    seconds, nats = clock.cpu, ()
    if len(causes) == 2:
        run, evidence = gather(case.log, nominal, Kit.preset(nominal.kit), None, lambda _: None)
        nats = supported(case, run, evidence) if evidence is not None else ()
    ways, sizes = ("+".join(x) for x in ([f.way for f in case.faults], [f"{f.size:.3g}" for f in case.faults]))
    how = f"{case.design} {ways} {sizes} from {case.faults[0].onset:.2f} to {case.fell_at:.2f} s"
    odds = ", ".join(f"{c.name} {c.likelihood:.2f}" for c in found.causes[:3]) or found.verdict
    why = f"{odds}; {found.causes[0].evidence if found.causes else ''}"
    return Told(name, seed, case.robot, how, found.verdict, right(causes, found.verdict), why, seconds, nats=nats)


def main() -> None:
    asked = harness.options(__doc__, runs=6, first_seed=SEED, workers=2, results=Path, causes=())
    every = [(c,) for c in (*LISTED, *UNLISTED)] + list(PAIRS)
    chosen = [tuple(c.split("+")) for c in asked.causes] or every
    keys = [
        (causes, asked.first_seed + i)
        for i in range(asked.runs) for causes in chosen
        if len(causes) == 1 or i < (asked.runs + 1) // 2
    ]  # fmt: skip
    report(harness.cases(judged, keys, Told, asked.workers, asked.results))


def one_alone(told: Told) -> bool:
    """Whether one cause stands at 0.9 or more where two were planted."""
    name, _, odds = told.why.partition(";")[0].partition(",")[0].rpartition(" ")
    return (
        not told.right
        and " and " not in name
        and not name.startswith("none of these")
        and bool(name)
        and float(odds) >= 0.9
    )


def one_below(told: Told) -> bool:
    """Whether one of two causes is named, below 0.9: the rest is left to what the log does not show."""
    return told.verdict in told.planted.split("+") and not one_alone(told)


def report(told: Sequence[Told]) -> None:
    """Figures against the bars."""
    runs = [t for t in told if t.robot]
    for name, some in (("listed", LISTED), ("unlisted", UNLISTED)):
        these = [t for t in runs if t.planted in some]
        print(f"\n{name}: {harness.share(sum(t.right for t in these), len(these))}")
        for cause in dict.fromkeys(t.planted for t in these):
            mine = [t for t in these if t.planted == cause]
            print(
                f"  {cause:<18}{sum(t.right for t in mine):>3} of {len(mine)}", dict(Counter(t.verdict for t in mine))
            )
    pairs = [t for t in runs if "+" in t.planted]
    alone = sum(one_alone(t) for t in pairs)
    print(f"\npairs: both named in {sum(t.right for t in pairs)} of {len(pairs)}; one alone at 0.9 or more in {alone}")
    print(f"  besides, one of both named below 0.9 in {sum(one_below(t) for t in pairs)}")
    print("  what the log supports of both: nats over one of them, and over the best that was found")
    for t in pairs:
        print(" ", "".join(f"{n:>+8.0f}" for n in t.nats) or f"{'–':>16}", "", t)
    if runs:
        print(f"post-mortem: median {np.median([t.seconds for t in runs]):.1f} s of processor time")


if __name__ == "__main__":
    main()
