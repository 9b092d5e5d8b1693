"""Do the paper's claims keep their verdicts under other noise: the chapters that simulate sensors, seed after seed.

    python benchmarks/claims.py --seeds 20    # half a minute of processor a seed
    python benchmarks/claims.py --seeds 20 --parts linear pushes built controllers sensors    # all

Excitations stay as they are. Seed 0 is what `upright reproduce` shows.
"""

from __future__ import annotations

import importlib
from collections import Counter
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

import harness

from upright.control import lqr_state
from upright.paper import as_built, controllers, linear_model, printed, pushes, regulator, sensors
from upright.paper.pushes import RegulatedRobot
from upright.robots import Kit, Robot

RUNS = ("paper.linear_model", "paper.pushes", "paper.as_built", "comparison.bench", "identification.judge")
FAR = 1000  # between two of our seeds, more than any chapter uses
BIASED = 0.1  # of the pole
PARTS = ("linear", "pushes", "built", "controllers")


@dataclass(frozen=True)
class Told:
    """What one seed says of each claim."""

    seed: int
    says: dict[str, str]
    seconds: float

    def __str__(self) -> str:
        return f"seed {self.seed}: {self.says} ({self.seconds:.0f} s of processor)"


def reseeded(run: Callable[..., Any], shift: int) -> Callable[..., Any]:
    """`run` with other noise."""

    def other(*args: Any, seed: int = 0, **options: Any) -> Any:
        return run(*args, seed=seed + shift, **options)

    return other


def told_by(parts: tuple[str, ...], seed: int) -> Told:
    clock = harness.Clock()
    modules = [importlib.import_module(f"upright.{name}") for name in RUNS]
    with ExitStack() as stack:
        for module in modules:
            stack.enter_context(patch.object(module, "run", reseeded(module.run, FAR * seed)))
        return Told(seed, _said(parts), clock.cpu)


def _said(parts: tuple[str, ...]) -> dict[str, str]:
    """Part of the paper → verdict, with the conclusions of 5e one by one, and what the parts beyond it find."""
    light, heavy, kit = Robot.preset("nxtway-gs"), Robot.preset("herrera2015"), Kit.preset("nxt")
    own, gains = lqr_state(light, printed.PERIOD), regulator.printed_feedback()
    says: dict[str, str] = {}
    claims = list[Any]()
    if "linear" in parts or "sensors" in parts:
        linear = linear_model.chapter(heavy, gains, kit)
        claims += linear
        numbers = linear[-1].numbers
        says["3b biased"] = str(abs(numbers["unstable_pole"] / numbers["true_unstable_pole"] - 1) > BIASED)
    if "sensors" in parts:
        chapter = sensors.chapter(heavy, kit, claims[-1].logs["identification-sensors"])
        says["3c holding"] = " ".join(sorted(name for name, holds in chapter.numbers["holds"].items() if holds))
    robots = [
        RegulatedRobot(light, own, linear_model.identify(light, own)[1].model),
        RegulatedRobot(heavy, gains, linear_model.identify(heavy, gains)[1].model),
    ]
    pushed = pushes.chapter(robots, kit) if "pushes" in parts or "built" in parts else []
    claims += pushed
    if pushed:
        says |= {f"5e {claim}": str(holds) for claim, holds in pushed[-1].numbers["claims"].items()}
    if "built" in parts:
        claims.append(as_built.chapter(robots[-1], kit, {n: log for c in pushed for n, log in c.logs.items()}))
    if "controllers" in parts:
        rows = controllers.chapter(light, kit).numbers["rows"]
        falling = sorted({row["controller"] for row in rows if row["outcome"] != "yes"})
        says["6 not through both"] = " ".join(falling) or "none"
    return {c.part: c.verdict for c in claims} | says


def main() -> None:
    asked = harness.options(__doc__, seeds=20, parts=PARTS, results=Path)
    told = harness.cases(partial(told_by, tuple(asked.parts)), list(range(asked.seeds)), Told, 1, asked.results)
    for claim in told[0].says:
        print(f"{claim:40}", dict(Counter(one.says[claim] for one in told)))


if __name__ == "__main__":
    main()
