"""Chapter 1: the nonlinear model, derived again from the energies, and the misprints of its equations, each proved."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, replace

import numpy as np

from upright.paper.claim import NOT_AS_PRINTED, Claim, judged
from upright.paper.derivation import Derivation, Model, derive
from upright.paper.errata import WITNESS, Erratum, Proof, errata, prove
from upright.physics.dynamics import accelerations
from upright.progress import Progress, unwatched
from upright.reports import Formula, Table
from upright.reports.page import Cell, Item
from upright.robots import Robot
from upright.tables import power_of_ten

STATES = 200
LARGEST = np.array([0.6, 4.0, 6.0, 15.0, 3.0, 6.0])  # [rad, rad/s, …] leaning, rolling and turning hard, all at once
VOLTS = 9.0  # [V] six full batteries of the NXT brick
ROUNDING = 1e-12  # some 20 terms in float64 and a 2×2 solve that loses a factor of 10: 4e-14, and room for cancelling


def chapter(progress: Progress = unwatched) -> list[Claim]:
    """Whether the corrected equations are the derived ones, and every misprint with its proof."""
    progress(0.0)
    model = _model()
    progress(0.4)
    proofs = {erratum: prove(erratum) for erratum in errata()}
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


def without_loads(derivation: Derivation) -> Derivation:
    """The same without push, slope and dry friction, which the paper does not model."""
    return replace(derivation, force=derivation.force.subs(derivation.loads))


def _model() -> Claim:
    robot = Robot.preset("nxtway-gs")
    models: tuple[Model, Model] = ("published", "complete")
    off = {model: disagreement(model, robot) for model in models}
    summary = (
        "With their misprints corrected, (11) to (24) agree with what computer algebra (SymPy) derives from the "
        f"energies, to {_power(max(off.values()))} of the largest acceleration. Compared are {STATES} random states "
        "and voltages. "
        "The complete model (chapter 2) agrees as well."
    )
    items: list[Item] = [
        "As in the paper and in its source, reference [4], the rolling constraint is put into the energies before they "
        "are differentiated. Torques in N m:",
        *(Formula(text) for text in without_loads(derive("published")).mathml),
        "with α = n K_t/R_m and β = n K_t K_b/R_m + f_m.",
    ]
    verdict = judged(value < ROUNDING for value in off.values())
    numbers = {"states": STATES, "largest_relative_difference": off}
    return Claim("1a", "The nonlinear model, eqs. (11)–(24), corrected", verdict, summary, numbers, items)


def _misprints(proofs: Mapping[Erratum, Proof | None]) -> Claim:
    proved = {erratum: proof for erratum, proof in proofs.items() if proof is not None}
    holding = sum(proof.holds for proof in proved.values())
    worst = max(proof.printed_residual for proof in proved.values())
    least = min(proof.printed_residual for proof in proved.values())
    summary = (
        f"{len(proofs)} misprints, {len(proved)} of them in equations of motion. Against the derivation {holding} of "
        f"{len(proved)} are proved: the corrected form equals it identically, the printed one does not. Each alone "
        f"is off by {100 * least:.1f} % to {100 * worst:.0f} % of the derived value. For this, NXTway-GS leans "
        f"{WITNESS['pitch']:g} rad, rolls at {WITNESS['wheel_rate']:g} rad/s and turns at {WITNESS['yaw_rate']:g} "
        f"rad/s. The other {len(proofs) - len(proved)} are slips of notation."
    )
    numbers = {
        "errata": [_as_json(erratum, proof) for erratum, proof in proofs.items()],
        "proved": holding, "provable": len(proved), "witness": WITNESS,
    }  # fmt: skip
    items: list[Item] = [_table(proofs), "The derived form of each equation with a misprint:"]
    items.extend(Formula(line) for line in _derived(proved))
    return Claim("1b", "The equations as printed: the errata", NOT_AS_PRINTED, summary, numbers, items)


def _as_json(erratum: Erratum, proof: Proof | None) -> dict[str, object]:
    record = {name: getattr(erratum, name) for name in ("equations", "printed", "corrected", "why")}
    return {**record, "proof": asdict(proof) if proof else None}


def _table(proofs: Mapping[Erratum, Proof | None]) -> Table:
    rows: list[list[Cell]] = [
        [
            e.equations,
            e.printed,
            e.corrected,
            e.why,
            *((100 * p.printed_residual, p.holds) if p else (None, "notation")),
        ]
        for e, p in proofs.items()
    ]
    header = ["equation", "printed", "should be", "why", "off by [%]", "proved"]
    return Table(header, rows, "Misprints, each alone, against the derived equations", digits=4)


def _derived(proofs: Mapping[Erratum, Proof]) -> list[str]:
    """One line for each derived form, under the numbers of all equations that should have it."""
    forms: dict[str, list[str]] = {}
    for erratum, proof in proofs.items():
        known = forms.setdefault(proof.derived, [])
        known += [name for name in erratum.equations.split(", ")[:1] if name not in known]
    return [f"{', '.join(names)}\n{form}" for form, names in forms.items()]


def _power(fraction: float) -> str:
    """The power of ten above a fraction, such as 10⁻¹³; zero as 'the last digit'."""
    return power_of_ten(math.ceil(math.log10(fraction))) if fraction else "the last digit"
