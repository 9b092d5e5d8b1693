"""`upright reproduce`: the paper from end to end, into a folder with one page to open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from upright.atomic import make_folder, write_json
from upright.comparison.runs import FAIR
from upright.control import lqr_state
from upright.paper import as_built, controllers, equations, linear_model, printed, pushes, regulator, sensors, turning
from upright.paper.as_built import MODELS
from upright.paper.claim import BEYOND, IN_PART, NOT_AS_PRINTED, REPRODUCED, Claim
from upright.paper.pushes import RELEASE, RegulatedRobot
from upright.plotting import legend, line, panels, span
from upright.progress import Progress, unwatched
from upright.reports import Details, Figure, Page, Section, Table, Verdict
from upright.reports.page import Cell, cell_text
from upright.reports.robot import labelled
from upright.robots import PARAMETERS, Kit, Robot
from upright.tables import Shown, joined

LIGHT, HEAVY = "nxtway-gs", "herrera2015"

LEAD = (
    "The paper tests two models of a balancing NXT robot by pushes, but does not print the robot's parameters. Two "
    f"simulated robots (twins) stand in: {HEAVY}, derived from the paper's matrices, and {LIGHT}, a lighter one that "
    "the paper cites."
)
PAPER = (
    "M. Herrera, W. Chamorro, A. Gómez and O. Camacho (2015), Two-Wheeled Inverted Pendulum Robot NXT Lego Mindstorms: "
    "Mathematical Modelling and Real Robot Comparisons"
)
COUNTED = (
    "Reproduced: what the claim says holds here. In part: some of it does. Not as printed: what is printed is wrong "
    "or contradicts itself. Beyond the paper: an addition, not counted. The paper prints curves and no settling times, "
    f"so 5a to 5d compare shapes: two robots, each under two pushes. {HEAVY} has the printed gains; they do not "
    f"balance {LIGHT}, which has a regulator of its own. Open a claim for its evidence."
)

AFTER = " Next: `upright reproduce --log LOG --robot ROBOT` puts a LOG of your own robot beside both models."


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Shown):
    """Every claim, in the paper's order, and the output folder."""

    claims: Sequence[Claim]
    folder: Path

    def __str__(self) -> str:
        width = max(len(f.title) for f in self.claims)
        rows = [f"{f.part:<3} {f.title:<{width}}  {f.says}\n{f.why(100)}" for f in self.claims]
        return "\n".join(
            [
                *rows,
                "",
                f"{title(self.claims)}.",
                f"wrote {self.folder / 'report.html'}, results.json and the logs beside it",
            ]
        )

    def page(self) -> Page:
        """The page as written to report.html."""
        return _page(self.claims)

    def to_json(self) -> dict[str, Any]:
        """All numbers, as written to results.json."""
        return {"versions": _versions(), "findings": [claim.to_json() for claim in self.claims]}


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
    done.page().write(target / "report.html")
    write_json(target / "results.json", done.to_json())
    progress(1.0)
    return done


def _page(claims: Sequence[Claim]) -> Page:
    """What holds and what does not, figure 5, then each claim with its evidence folded."""
    judged = [c for c in claims if c.says != BEYOND]
    counted = {verdict: sum(c.says == verdict for c in judged) for verdict in (REPRODUCED, IN_PART, NOT_AS_PRINTED)}
    counts = [(f"{n} of {len(judged)}", f"claims {verdict}") for verdict, n in counted.items() if n]
    numbers = _findings(claims) or counts
    failed = [_failure(c) for c in judged if c.says == NOT_AS_PRINTED]
    missed = f" Not as printed: {'; '.join(failed)}." if failed else ""
    part = next(c for c in claims if c.part == "5c")
    drawn = next(item for item in part.items if isinstance(item, Figure))
    again = _with_differences(part) or drawn
    again = replace(again, title=_finding(part, drawn.title))
    robots = [Robot.preset(name) for name in (LIGHT, HEAVY)]
    parameters: list[list[Cell]] = [
        [symbol, name.replace("_", " "), unit, *(getattr(robot, name) for robot in robots)]
        for name, (unit, symbol) in PARAMETERS.items()
    ]
    sketch = Section("The robot", [
        Figure("Angles and lengths of the model", labelled(robots[0]), _INTO),
        Details("Parameters of both robots", [Table(["", "parameter", "unit", LIGHT, HEAVY], parameters)]),
    ])  # fmt: skip
    sections = [Section("The claims", [COUNTED]), *(claim.section(_brief(claim)) for claim in claims), sketch]
    whole = all(c.says == REPRODUCED for c in judged)
    verdict = Verdict("reproduced", "good") if whole else Verdict("reproduced in part", "warn")
    facts = {"command": "upright reproduce", "paper": PAPER, **_versions()}
    return Page(
        title(claims), sections, f"{LEAD}{missed}{AFTER}", facts, verdict=verdict, picture=again, numbers=numbers
    )


_INTO = (
    "A force on the front pushes backwards. The wheels run back from under the body, so that it leans forward, into "
    "the force, until its weight holds it."
)


def title(claims: Sequence[Claim]) -> str:
    """How many of the paper's claims hold: "Herrera et al. (2015): 4 of 10 claims reproduced, 4 in part"."""
    says = [claim.says for claim in claims if claim.says != BEYOND]
    rest = ((says.count(IN_PART), "in part"), (says.count(NOT_AS_PRINTED), "not as printed"))
    counts = f"{says.count(REPRODUCED)} of {len(says)} claims reproduced"
    return f"Herrera et al. (2015): {counts}{''.join(f', {n} {words}' for n, words in rest if n)}"


def _findings(claims: Sequence[Claim]) -> list[tuple[str, str]]:
    """What was found, each in a number: the misprints, the gain and the fit."""
    known = {claim.part: claim.numbers for claim in claims}
    facts: list[tuple[str, str]] = []
    conclusions = known.get("5e", {}).get("claims", {})
    if errata := known.get("1b", {}).get("errata"):
        facts.append((str(len(errata)), "misprints in the printed equations (1b)"))
    if gains := known.get("4", {}).get("dlqr_without_noise"):
        words = f"pitch gain by the printed weights; printed: {cell_text(known['4']['printed'][0][0], 3)} (4)"
        facts.append((cell_text(gains[0][0], 3), words))
    if logs := known.get("5c", {}).get("logs"):
        fit = min(logs[name]["fit"]["pitch"] for name in ("nonlinear", "linear"))
        facts.append((f"{cell_text(fit, 2)} %", f"fit of both models to the twin of {HEAVY}, in pitch (5c)"))
    if conclusions:
        missed = joined([f"“{name}”" for name, holds in conclusions.items() if not holds])
        words = f"of the paper's conclusions hold in all runs{f'; not {missed}' if missed else ''} (5e)"
        facts.append((f"{sum(conclusions.values())} of {len(conclusions)}", words))
    return facts


def _failure(claim: Claim) -> str:
    """What is wrong with a claim, in a few words, with its number in brackets."""
    wrong = sum(not holds for holds in claim.numbers.get("claims", {}).values())
    words = {
        "1b": "the equations have misprints", "4": "the gains do not follow from the printed weights",
        "5e": f"the {wrong} conclusions do not hold",
    }  # fmt: skip
    return f"{words.get(claim.part, _brief(claim))} ({claim.part})"


def _brief(claim: Claim) -> str:
    """What a claim is about."""
    return BRIEF.get(claim.part) or claim.title.split(",")[0]


BRIEF = {
    "1a": "nonlinear model", "1b": "printed equations", "3a": "least squares", "4": "regulator, gains",
    "5a": f"{LIGHT}, front", "5b": f"{LIGHT}, back", "5c": f"{HEAVY}, front", "5d": f"{HEAVY}, back",
    "5e": "conclusions", "5f": "dry friction", "2a": "terms left out", "2b": "MuJoCo", "3b": "sensors, biased",
    "3c": "sensors, other ways", "6": "every controller",
}  # fmt: skip


def _finding(part: Claim, plain: str) -> str:
    """What the picture of a push shows, and which figure it repeats; without runs its `plain` title."""
    logs = part.numbers.get("logs")
    if not logs:
        return plain
    fits = [logs[name]["fit"]["pitch"] for name in ("nonlinear", "linear")]
    follow = "both models follow the twin" if min(fits) >= FAIR else "the models do not both follow the twin"
    least = cell_text(min(fits), 2)
    more = "" if cell_text(max(fits), 2) == least else " or more"
    return f"Figure 5 again (claim {part.part}): {follow} of {HEAVY}; pitch fits {least} %{more}"


def _with_differences(part: Claim) -> Figure | None:
    """Pitch of twin and models, and below it how far each model is from the twin, where its runs are there."""
    logs = {name: part.logs.get(f"{HEAVY}-front-{name}") for name in ("twin", *MODELS)}
    twin = logs["twin"]
    if twin is None or None in logs.values():
        return None
    figure, (above, below) = panels(["pitch [°]", "model less twin [°]"])
    for style, (name, log) in enumerate(logs.items()):
        if log is None:
            continue
        line(above, name, log.t, np.degrees(log["truth/pitch"]), style=style)
        if name in MODELS:
            n = min(len(log), len(twin))
            line(below, name, log.t[:n], np.degrees(log["truth/pitch"][:n] - twin["truth/pitch"][:n]), style=style)
    span([above, below], 0.0, RELEASE, "push acts")
    force = part.numbers.get("force")
    size = f" of {cell_text(abs(force), 2)} N" if force else ""
    note = (
        f"Held by a constant force{size} at the centre of mass, on the front, until 8 s, then released. The robot "
        "leans into the force: its pitch is positive. The paper prints this figure as curves only: compare the shape."
    )
    models = [np.degrees(log["truth/pitch"]) for name, log in logs.items() if name in MODELS and log is not None]
    n = min(map(len, models))
    apart = float(np.abs(models[0][:n] - models[1][:n]).max())
    if apart < ALIKE * float(np.abs(models[0]).max()):
        note += f" The curves of both models lie on each other: they are at most {cell_text(apart, 2)}° apart."
    return Figure("", legend(figure), note)


ALIKE = 0.02  # of the largest pitch: two lines this close cannot be seen apart


def chapters(progress: Progress = unwatched) -> list[Claim]:
    """The claims of every chapter, in the paper's order."""
    light = Robot.preset(LIGHT)
    heavy = Robot.preset(HEAVY)
    kit = Kit.preset("nxt")
    gains = regulator.printed_feedback()
    own = lqr_state(light, printed.PERIOD)
    why = "The printed gains do not balance this lighter robot; its regulator is an LQR of its own."
    claims = equations.chapter(lambda fraction: progress(0.2 * fraction))
    claims += turning.chapter(lambda fraction: progress(0.2 + 0.1 * fraction))
    claims += linear_model.chapter(heavy, gains, kit)
    sensed = claims[-1].logs["identification-sensors"]
    claims.append(sensors.chapter(heavy, kit, sensed, lambda fraction: progress(0.3 + 0.1 * fraction)))
    progress(0.4)
    claims.append(regulator.chapter(light))
    progress(0.5)
    robots = [
        RegulatedRobot(light, own, linear_model.identify(light, own)[1].model, why),
        RegulatedRobot(heavy, gains, linear_model.identify(heavy, gains)[1].model, "The gains are the printed ones."),
    ]  # fmt: skip
    claims += pushes.chapter(robots, kit, lambda fraction: progress(0.5 + 0.15 * fraction))
    logs = {name: log for claim in claims for name, log in claim.logs.items()}
    claims.append(as_built.chapter(robots[-1], kit, logs, lambda fraction: progress(0.65 + 0.15 * fraction)))
    claims.append(controllers.chapter(light, kit, lambda fraction: progress(0.8 + 0.2 * fraction)))
    return claims


def _versions() -> dict[str, str]:
    return {name: version(name) for name in ("upright", "numpy", "scipy", "mujoco", "sympy")}
