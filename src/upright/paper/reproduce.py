"""`upright reproduce`: the paper from end to end, into a folder with one page to open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

from upright.atomic import make_folder, write_json
from upright.comparison import compare
from upright.comparison.drawing import draw_apart
from upright.comparison.runs import FAIR
from upright.control import lqr_state
from upright.languages import ENGLISH, speaking
from upright.pages import Column, Fold, KeyNumber, Next, Page, Picture, Quantity, Result, Say, Table, Verdict
from upright.pages.result import write_page
from upright.paper import as_built, controllers, equations, linear_model, printed, pushes, regulator, sensors, turning
from upright.paper.claim import BADGES, BEYOND, NOT_AS_PRINTED, REPRODUCED, Claim
from upright.paper.pushes import MODELS, RegulatedRobot
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot

LIGHT, HEAVY = "nxtway-gs", "herrera2015"

PAPER = (
    "M. Herrera, W. Chamorro, A. Gómez and O. Camacho (2015), Two-Wheeled Inverted Pendulum Robot NXT Lego Mindstorms: "
    "Mathematical Modelling and Real Robot Comparisons"
)
DRAWN = "5c"  # the push of figure 5, on the robot of the printed matrices
FOLDS = (
    (Say("Pushes"), ("5a", "5b", "5c", "5d", "5e", "5f")),
    (Say("Models and regulator"), ("1a", "3a", "4")),
    (Say("Misprints"), ("1b",)),
    (Say("Beyond the paper"), ("2a", "2b", "3b", "3c", "6")),
)
"""Heading → parts of the paper below it."""


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Result):
    """Every claim, in the paper's order, and the output folder."""

    claims: Sequence[Claim]
    folder: Path

    @property
    def judged(self) -> list[Claim]:
        """The claims that are the paper's own."""
        return [claim for claim in self.claims if claim.verdict != BEYOND]

    def page(self) -> Page:
        """The page as written to report.html."""
        verdict = Verdict(Say("reproduced in part"), "warn")
        reproduced = [claim for claim in self.judged if claim.verdict == REPRODUCED]
        if len(reproduced) == len(self.judged):
            verdict = BADGES[REPRODUCED]
        lead = [Say("A twin, simulated by MuJoCo, stands in for the robot.")]
        fails = [claim.title for claim in self.judged if claim.verdict == NOT_AS_PRINTED]
        if fails:
            lead.append(Say("Not as printed: {titles}.", titles=fails))
        drawn = next((claim for claim in self.claims if claim.part == DRAWN), None)
        why = Say("A real robot's log tells how it settles.")
        versions = ", ".join(f"{name} {number}" for name, number in _versions().items())
        return Page(
            Say("Herrera et al. (2015): {n} of {all} claims reproduced", n=len(reproduced), all=len(self.judged)),
            verdict=verdict,
            lead=lead,
            numbers=_numbers(self.claims),
            picture=drawn and _picture(drawn),
            next=[Next("reproduce", log="LOG", robot="ROBOT", why=why)],
            blocks=[_table(self.judged), *_folds(self.claims)],
            origin={"paper": PAPER, "versions": versions},
        )

    def to_json(self) -> dict[str, Any]:
        """All numbers, as written to results.json."""
        with speaking(ENGLISH):
            findings = [claim.to_json() for claim in self.claims]
            return {"schema": "upright/reproduce/1", "versions": _versions(), "findings": findings}


def reproduce(folder: str | Path = "herrera2015", progress: Progress = unwatched) -> Reproduction:
    """Run every chapter and write report.html, results.json and the logs into `folder`, which is created if missing.

    `progress` is called with the fraction done. Raises `UprightError` where the folder cannot be written.
    """
    target = make_folder(Path(folder) / "logs").parent
    claims = chapters(progress)
    for claim in claims:
        for name, log in claim.logs.items():
            log.save(target / "logs" / f"{name}.parquet")
    done = Reproduction(claims, target)
    write_page(done.page(), target / "report.html", "upright reproduce")
    write_json(target / "results.json", done.to_json())
    progress(1.0)
    return done


def _numbers(claims: Sequence[Claim]) -> list[KeyNumber]:
    """The fit of the models, the pitch gain and the misprints, as far as there are such claims."""
    known = {claim.part: claim.numbers for claim in claims}
    numbers: list[KeyNumber] = []
    if logs := known.get(DRAWN, {}).get("logs"):
        fit = Quantity(_fit(logs) / 100, "fraction", digits=2)
        numbers.append(KeyNumber(fit, Say("fit of both models")))
    if "4" in known:
        gain, printed_gain = (known["4"][name][0][0] for name in ("dlqr_without_noise", "printed"))
        meaning = Say("pitch gain by the weights, printed as {gain}", gain=Quantity(printed_gain))
        numbers.append(KeyNumber(Quantity(gain), meaning))
    if "1b" in known:
        numbers.append(KeyNumber(len(known["1b"]["errata"]), Say("misprints")))
    return numbers


def _fit(logs: Any) -> float:
    """The fit [%] of the worse model to the twin, in pitch."""
    return min(logs[name]["fit"]["pitch"] for name in MODELS)


def _picture(claim: Claim) -> Picture:
    """Figure 5 again: pitch of the twin and of both models."""
    runs = compare({name: claim.logs[f"{HEAVY}-front-{name}"] for name in ("twin", *MODELS)})
    shown = Say("Figure 5 again: both models follow the twin")
    if _fit(claim.numbers["logs"]) < FAIR:
        shown = Say("Figure 5 again: the models do not follow the twin")
    force = Quantity(abs(claim.numbers["force"]), "N", digits=2)
    return Picture(
        shown,
        lambda: draw_apart(runs, "pitch"),
        Say("{robot}, pushed by {force}", robot=HEAVY, force=force),
    )


def _table(claims: Sequence[Claim]) -> Table:
    """What was found of each claim."""
    columns = [Column(Say("part")), Column(Say("claim")), Column(Say("here")), Column(Say("found"))]
    return Table(columns, [[claim.part, claim.title, BADGES[claim.verdict], claim.result] for claim in claims])


def _folds(claims: Sequence[Claim]) -> list[Fold]:
    """The evidence, a fold for each claim where a heading has several."""
    folds: list[Fold] = []
    for heading, parts in FOLDS:
        each = [(claim, [claim.summary, *claim.blocks]) for claim in claims if claim.part in parts]
        if len(each) == 1:
            folds.append(Fold(heading, each[0][1]))
        elif each:
            titled = [(Say("{part} {title}", part=claim.part, title=claim.title), blocks) for claim, blocks in each]
            folds.append(Fold(heading, [Fold(title, blocks) for title, blocks in titled]))
    return folds


def chapters(progress: Progress = unwatched) -> list[Claim]:
    """The claims of every chapter, in the paper's order."""
    light = Robot.preset(LIGHT)
    heavy = Robot.preset(HEAVY)
    kit = Kit.preset("nxt")
    gains = regulator.printed_feedback()
    claims = equations.chapter(lambda fraction: progress(0.2 * fraction))
    claims += turning.chapter(lambda fraction: progress(0.2 + 0.1 * fraction))
    claims += linear_model.chapter(heavy, gains, kit)
    sensed = claims[-1].logs["identification-sensors"]
    claims.append(sensors.chapter(heavy, kit, sensed, lambda fraction: progress(0.3 + 0.1 * fraction)))
    progress(0.4)
    claims.append(regulator.chapter(light))
    progress(0.5)
    robots = [
        RegulatedRobot(robot, feedback, linear_model.identify(robot, feedback)[1].model)
        for robot, feedback in ((light, lqr_state(light, printed.PERIOD)), (heavy, gains))
    ]
    claims += pushes.chapter(robots, kit, lambda fraction: progress(0.5 + 0.15 * fraction))
    logs = {name: log for claim in claims for name, log in claim.logs.items()}
    claims.append(as_built.chapter(robots[-1], kit, logs, lambda fraction: progress(0.65 + 0.15 * fraction)))
    claims.append(controllers.chapter(light, kit, lambda fraction: progress(0.8 + 0.2 * fraction)))
    return claims


def _versions() -> dict[str, str]:
    return {name: version(name) for name in ("upright", "numpy", "scipy", "mujoco", "sympy")}
