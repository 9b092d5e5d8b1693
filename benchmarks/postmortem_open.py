"""Whether the post-mortem knows its limits: faults outside the nine of `postmortem.py`, and two faults at once.

    python benchmarks/postmortem_open.py                                       # 6 falls of each fault, 24 pairs
    python benchmarks/postmortem_open.py --first-seed 7300 --runs 10 --results told.jsonl    # again resumes

`LISTED` are causes that the post-mortem knows, planted in the twin by MuJoCo's own means: actuators without gain,
locked joints, a box in the way, tilted gravity, another mass. `UNLISTED` are in no list of the code: right is "none of
these", or a cause that says the same. Of a pair neither fault fells the robot alone. As in `postmortem.py`, a run
counts where it falls after the onset and does not fall without the fault, and nothing of the truth is shown.
"""

from __future__ import annotations

import argparse
import json
import math
import sys
import time
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from planted.open_falls import LISTED, PAIRS, SEED, UNLISTED, Broken, Fault, NoFall, made
from upright.diagnose import PostMortem, post_mortem
from upright.diagnose.changes import scaled_sensors
from upright.diagnose.evidence import Evidence, gather
from upright.diagnose.fault_fits import FAULT_NUMBERS, FaultFit, score_of, with_pushes
from upright.diagnose.innovations import FilterRun
from upright.diagnose.pairs import together
from upright.diagnose.remedy import COMMAND_FAULTS, READING_FAULTS, beside_pushes, exact, moved
from upright.diagnose.usual import window_of
from upright.robots import Kit, Robot

SAME_AS = {
    "stall": ("dropped samples",), "half bridge": ("motor dead",), "counts lost": ("sensor mis-scaled",),
    "stiction": ("wheel jammed",), "cable": ("ramp",), "tyre lost": ("tyre lost",), "ripple": (),
    "loose plug": ("motor dead",), "frozen program": ("dropped samples",), "spikes": (),
    "clipped": ("sensor mis-scaled",),
    "clutch": (), "wrong sign": ("motor or sensor reversed",), "hand": ("push too large", "wall"), "magnet": (),
    "packets": ("delay grown", "dropped samples"), "brown-out": ("dropped samples",),
}  # fmt: skip
"""Answers that say the same as what happened, besides "none of these"."""
NONE = "none of these"
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


@dataclass(frozen=True)
class Told:
    """What was planted and what was answered; `odds` are the likelihoods of the first three causes. `log` is what the
    log supports of two causes (`supported`), `pair` the nats by which the best two found explain more than one."""

    causes: str
    seed: int
    robot: str = ""
    design: str = ""
    way: str = ""
    size: str = ""
    onset: float = 0.0
    fell_at: float = 0.0
    verdict: str = ""
    odds: str = ""
    evidence: str = ""
    seconds: float = 0.0
    trouble: str = ""
    log: tuple[float, float] | None = None
    pair: float = math.nan

    @property
    def right(self) -> bool:
        """Whether the answer is the planted cause, both of them, or says that none is known."""
        causes = self.causes.split("+")
        if len(causes) > 1:
            return all(cause in self.verdict for cause in causes)
        if self.causes in UNLISTED:
            return self.verdict.startswith(NONE) or self.verdict in SAME_AS[self.causes]
        return self.verdict == self.causes

    def __str__(self) -> str:
        if self.trouble:
            return f"{self.seed} {self.causes}: {self.trouble}"
        return (
            f"{self.seed} {self.robot} {self.design} {self.causes}/{self.way} {self.size} from {self.onset:.2f} to "
            f"{self.fell_at:.2f} s: {self.odds}; {self.evidence}"
        )


def judged(work: tuple[tuple[str, ...], int, str]) -> Told:
    """One fall, made and examined."""
    causes, seed, folder = work
    name = "+".join(causes)
    try:
        case = made(causes, seed, Path(folder) if folder else None)
    except NoFall as error:
        return Told(name, seed, trouble=str(error))
    began = time.process_time()
    nominal = Robot.preset(case.robot)
    found: PostMortem = post_mortem(case.log, nominal)
    seconds, log, pair = time.process_time() - began, None, math.nan
    if len(causes) == 2:
        run, evidence = gather(case.log, nominal, Kit.preset(nominal.kit), None, lambda _: None)
        if evidence is not None:
            log = supported(case, run, evidence)
            pair = evidence.pairs[0].score - evidence.fits[0].score if evidence.pairs else -math.inf
    odds = ", ".join(f"{c.name} {c.likelihood:.2f}" for c in found.causes[:3])
    return Told(
        name, seed, case.robot, case.design, "+".join(f.way for f in case.faults),
        "+".join(f"{f.size:.3g}" for f in case.faults), case.faults[0].onset, case.fell_at, found.verdict,
        odds or found.verdict, found.causes[0].evidence if found.causes else "", seconds, "", log, pair,
    )  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=6, help="falls of each fault; half as many of each pair")
    parser.add_argument("--first-seed", type=int, default=SEED)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--results", type=Path, help="a file of lines to which answers are added; none is made twice")
    parser.add_argument("--keep", default="", help="a folder in which the runs are kept")
    parser.add_argument("--causes", nargs="*", help="only these, a pair as 'one+other'")
    options = parser.parse_args()
    every = [(c,) for c in (*LISTED, *UNLISTED)] + list(PAIRS)
    chosen = [tuple(c.split("+")) for c in options.causes] if options.causes else every
    work = [
        (causes, options.first_seed + i, options.keep)
        for i in range(options.runs)
        for causes in chosen
        if len(causes) == 1 or i < (options.runs + 1) // 2
    ]
    lines = options.results.read_text().splitlines() if options.results and options.results.exists() else []
    found = {(t.causes, t.seed): t for t in (Told(**json.loads(line)) for line in lines)}
    new = [one for one in work if ("+".join(one[0]), one[1]) not in found]
    with ProcessPoolExecutor(options.workers) as pool:
        for done, told in enumerate(pool.map(judged, new), 1):
            found[told.causes, told.seed] = told
            if options.results:
                with options.results.open("a") as file:
                    file.write(json.dumps(asdict(told)) + "\n")
            print(f"{done}/{len(new)} {'right' if told.right else 'WRONG'} {told}", flush=True)
    report(list(found.values()))


def one_alone(told: Told) -> bool:
    """Whether one cause stands at 0.9 or more where two were planted."""
    name, _, odds = told.odds.partition(",")[0].rpartition(" ")
    return not told.right and " and " not in name and not name.startswith(NONE) and bool(name) and float(odds) >= 0.9


def one_below(told: Told) -> bool:
    """Whether one of two causes is named, below 0.9: the rest is left to what the log does not show."""
    return told.verdict in told.causes.split("+") and not one_alone(told)


def report(told: Sequence[Told]) -> None:
    """Figures against the bars."""
    runs = [t for t in told if t.robot]
    for name, some in (("listed", LISTED), ("unlisted", UNLISTED)):
        these = [t for t in runs if t.causes in some]
        print(f"\n{name}: {sum(t.right for t in these)} of {len(these)}")
        for cause in some:
            mine = [t for t in these if t.causes == cause]
            print(
                f"  {cause:<18}{sum(t.right for t in mine):>3} of {len(mine)}  {dict(Counter(t.verdict for t in mine))}"
            )
    pairs = [t for t in runs if "+" in t.causes]
    alone = sum(one_alone(t) for t in pairs)
    print(f"\npairs: both named in {sum(t.right for t in pairs)} of {len(pairs)}; one alone at 0.9 or more in {alone}")
    print(f"  besides, one of both named below 0.9 in {sum(one_below(t) for t in pairs)}")
    print("  what the log supports of both: nats over one of them, and over the best that was found")
    for t in pairs:
        log = "      –       –" if t.log is None else f"{t.log[0]:+7.0f} {t.log[1]:+7.0f}"
        print(f"  {'right' if t.right else 'WRONG'} {log}  {t}")
    if runs:
        print(f"post-mortem: median {np.median([t.seconds for t in runs]):.1f} s of processor time")


if __name__ == "__main__":
    main()
