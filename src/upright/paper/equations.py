"""Chapter 1: the nonlinear model, derived again from the energies, and the misprints of its equations, each proved."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, replace

import numpy as np

from upright.pages import Cell, Column, Items, Quantity, Say, Table
from upright.paper.claim import NOT_AS_PRINTED, Claim, judged
from upright.paper.derivation import Model, derive
from upright.paper.errata import ERRATA, WITNESS, Erratum, Proof, prove
from upright.physics.dynamics import accelerations
from upright.progress import Progress, unwatched
from upright.robots import Robot

STATES = 200
LARGEST = np.array([0.6, 4.0, 6.0, 15.0, 3.0, 6.0])  # [rad, rad/s, …] leaning, rolling and turning hard, all at once
VOLTS = 9.0  # [V] six full batteries of the NXT brick
ROUNDING = 1e-12  # some 20 terms in float64 and a 2×2 solve that loses a factor of 10: 4e-14, and room for cancelling


def chapter(progress: Progress = unwatched) -> list[Claim]:
    """Whether the corrected equations are the derived ones, and every misprint with its proof."""
    progress(0.0)
    model = _model()
    progress(0.4)
    proofs = {erratum: prove(erratum) for erratum in ERRATA}
    progress(1.0)
    return [model, _misprints(proofs)]


def disagreement(model: Model, robot: Robot, seed: int = 0) -> float:
    """Largest difference of `physics.dynamics` from the derivation, over `STATES` random states and voltages,
    relative to the largest acceleration of each."""
    rng = np.random.default_rng(seed)
    derived = derive(model).evaluator("math")
    largest = 0.0
    for _ in range(STATES):
        x = (LARGEST * rng.uniform(-1, 1, 6)).tolist()
        u = rng.uniform(-VOLTS, VOLTS, 2).tolist()
        theirs = np.array(derived(x, u, robot))
        ours = np.array(accelerations(x, u, robot, xp=math, model=model))
        largest = max(largest, float(np.abs(ours - theirs).max() / np.abs(theirs).max()))
    return largest


def _model() -> Claim:
    robot = Robot.preset("nxtway-gs")
    models: tuple[Model, Model] = ("published", "complete")
    off = {model: disagreement(model, robot) for model in models}
    largest = Quantity(max(off.values()), "1", digits=1)
    summary = Say("They equal those derived from the energies, to within {off}.", off=largest)
    derived = derive("published")
    plain = replace(derived, force=derived.force.subs(derived.loads))  # the paper has no push, slope or dry friction
    lines = [*plain.equations, "α = n K_t / R_m", "β = n K_t K_b / R_m + f_m"]
    blocks = [
        Say("As in the paper, rolling is put into the energies before these are differentiated."),
        Items([Say("{name}", name=line) for line in lines]),
    ]
    numbers = {"states": STATES, "largest_relative_difference": off}
    verdict = judged(value < ROUNDING for value in off.values())
    title = Say("Corrected equations")
    return Claim("1a", title, verdict, summary, numbers, blocks, result=Say("off by {off}", off=largest))


def _misprints(proofs: Mapping[Erratum, Proof | None]) -> Claim:
    proved = [proof for proof in proofs.values() if proof]
    holding = sum(proof.holds for proof in proved)
    summary = Say(
        "{n} misprints: {proved} in equations of motion are proved, {other} are of notation.",
        n=len(proofs),
        proved=holding,
        other=len(proofs) - len(proved),
    )
    numbers = {
        "errata": [_as_json(erratum, proof) for erratum, proof in proofs.items()],
        "proved": holding,
        "provable": len(proved),
        "witness": WITNESS,
    }
    result = Say("{n} misprints", n=len(proofs))
    return Claim("1b", Say("Printed equations"), NOT_AS_PRINTED, summary, numbers, [_table(proofs)], result=result)


def _as_json(erratum: Erratum, proof: Proof | None) -> dict[str, object]:
    record = {name: getattr(erratum, name) for name in ("equations", "printed", "corrected")}
    return {**record, "why": erratum.why.template, "proof": asdict(proof) if proof else None}


def _table(proofs: Mapping[Erratum, Proof | None]) -> Table:
    columns = [
        Column(Say("equation")),
        Column(Say("printed")),
        Column(Say("should be")),
        Column(Say("why")),
        Column(Say("off by"), "fraction"),
        Column(Say("proved")),
    ]
    rows: list[list[Cell]] = [
        [e.equations, e.printed, e.corrected, e.why, p and p.printed_residual, p and p.holds] for e, p in proofs.items()
    ]
    caption = Say("Each misprint alone: how far it changes its equation, for a robot that leans, rolls and turns")
    return Table(columns, rows, caption)
