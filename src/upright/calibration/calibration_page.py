"""The page of a calibration: whether a controller may be designed with this robot, and what the log measures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

from upright.calibration.calibrated_robot import ENOUGH, GOOD, CalibratedRobot
from upright.calibration.decision import DOUBTFUL, UNKNOWN
from upright.calibration.estimate import BOUNDED, CLOSE, REFUSED, VISIBLE, Estimate, headed, known_to
from upright.pages import Block, Column, Fold, Items, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.terms import channel, term

FILE = "robot.toml"  # the name that is proposed for the calibrated robot
STRONG = 0.9
"""Correlations from this size up are listed: only the prior separates such pairs."""


def calibration_page(c: CalibratedRobot) -> Page:
    """The page of a calibration."""
    lead = _lead(c)
    remarks = [remark for remark in dict.fromkeys((*c.doubts, *c.notes)) if remark not in lead]
    known = [e for e in c.parameters if e.verdict == VISIBLE or e in c.off]
    rest = [e for e in c.parameters if e not in known]
    blocks: list[Block] = []
    if remarks:
        blocks.append(Items(remarks))
    if known:
        measured = Say(
            "Measured: known to ±{close} or better; bounded: uncertainty at least halved",
            close=Quantity(CLOSE, "fraction"),
        )
        blocks.append(_estimates(sorted(known, key=lambda e: (not e.measured, e.shrink)), measured))
    if rest:
        blocks.append(Fold(Say("Parameters that this log does not show"), [*_beside_file(c), _estimates(rest)]))
    if c.channels:
        blocks.append(Fold(Say("Predictions of each sensor"), [_predictions(c), *([c.uneven] if c.uneven else [])]))
    blocks.append(Fold(Say("Coefficients of the motion, delays and motors"), _coefficients(c)))
    if c.unseen:
        blocks.append(Fold(Say("What the log does not separate"), _not_separated(c)))
    return Page(
        _title(c),
        verdict=_verdict(c),
        lead=lead,
        numbers=_numbers(c),
        picture=_picture(c),
        next=_next(c),
        blocks=blocks,
        origin=_origin(c),
    )


def _verdict(c: CalibratedRobot) -> Verdict:
    verdict = c.decision.verdict
    if verdict == REFUSED:
        return Verdict(Say("refused: do not use it"), "bad")
    if verdict == UNKNOWN:
        return Verdict(Say("unknown: do not use it"), "unknown")
    if verdict == DOUBTFUL:
        return Verdict(Say("do not use it yet"), "warn")
    if c.doubts:
        return Verdict(Say("validate it before a design"), "warn")
    return Verdict(Say("ready for a design"), "good")


def _title(c: CalibratedRobot) -> Say:
    if c.untold:
        return Say("The log cannot tell the numbers of {robot}", robot=c.robot.name)
    if c.refused:
        return Say("The fit does not describe {robot}", robot=c.robot.name)
    if c.decision.against:
        return Say("{robot} as fitted cannot be trusted", robot=c.robot.name)
    if c.doubts:
        return Say("{robot} is fitted, but not surely enough", robot=c.robot.name)
    return Say("{robot} is known well enough to design with", robot=c.robot.name)


def _lead(c: CalibratedRobot) -> list[Say]:
    """Why it is not to be used, or to be validated; else why it is enough."""
    if c.decision.why:
        return [c.decision.why]
    facts = {
        "n": sum(e.measured for e in c.parameters),
        "m": len(c.parameters),
        "k": sum(e.kind == BOUNDED for e in c.parameters),
    }
    shown = Say("The log measures {n} of {m} parameters and bounds {k}; the others stay about as in the file.", **facts)
    enough = Say("Enough: readings are predicted, and the unstable pole, on which balancing depends most, is known.")
    return [c.doubts[0] if c.doubts else enough, shown]


def _numbers(c: CalibratedRobot) -> list[KeyNumber]:
    """How well it predicts and how surely the pole is known, each beside its bar; and how fast the robot falls."""
    if c.refused:
        return []
    numbers: list[KeyNumber] = []
    if scores := c.scores:
        worst = min(scores, key=lambda name: scores[name])
        facts = {"sensor": channel(worst), "needed": Quantity(GOOD, "1")}
        meaning = Say("R² of the worst prediction, {sensor}; a design needs at least {needed}", **facts)
        numbers.append(KeyNumber(r2_of(scores[worst]), meaning))
    pole = c["unstable_pole"]
    if pole.value > 0:
        most = Quantity(ENOUGH, "fraction")
        meaning = Say("uncertainty of the unstable pole; a design needs at most ±{most}", most=most)
        if pole.verdict != VISIBLE:
            meaning = Say(
                "uncertainty of the unstable pole, mostly by the file; a design needs at most ±{most}", most=most
            )
        part = Quantity(pole.width, "fraction", digits=2)
        numbers.append(KeyNumber(Say("±{part}", part=part), meaning))
        doubles = Quantity(math.log(2) / pole.value, "s", digits=2)
        numbers.append(KeyNumber(doubles, Say("until a lean has doubled without control")))
    return numbers


def r2_of(r2: float) -> Quantity | Say:
    """R² to three digits, never rounded up to what passes."""
    return Say("below 0") if r2 < 0 else Quantity(math.floor(1000 * r2) / 1000, "1")


def _picture(c: CalibratedRobot) -> Picture | None:
    if not c.free:
        return None
    missed = [channel(name) for name, r2 in c.scores.items() if r2 < GOOD]
    if c.decision.verdict == UNKNOWN:
        claim = Say("Predictions beside readings: a close fit alone proves no number")
    elif missed:
        claim = Say("Predictions miss part of: {sensors}", sensors=missed)
    elif c.held_out:
        claim = Say("Predictions lie on the readings, also where nothing was fitted")
    else:
        claim = Say("Predictions lie on the readings")
    return Picture(
        claim, c.plot_prediction, Say("Every half second the model starts anew, and gets only the logged commands.")
    )


def _next(c: CalibratedRobot) -> list[Next]:
    """What to run next; the robot becomes a file first, where it is none yet."""
    if c.decision.next:
        return [c.decision.next]
    file = c.saved or FILE
    if c.doubts:
        then = Next("validate", file, "LOG", why=Say("Take a log that was not fitted."))
    else:
        then = Next("design", "lqg", robot=file, output="lqg.json")
    if c.saved:
        return [then]
    why = Say("It writes this robot as a file. Then: {step}", step=then)
    return [Next("calibrate", *c.sources, output=FILE, why=why)]


def _estimates(estimates: Sequence[Estimate], caption: Say | None = None) -> Table:
    """Values, how surely they are known, what the log says of them, and what was known before."""
    rows = [
        [
            headed(e.name, e.unit),
            Quantity(e.value, "1"),
            e.called,
            known_to(e.value, e.low, e.high),
            known_to(e.prior, *e.before),
        ]
        for e in estimates
    ]
    names = (Say("number"), Say("value"), Say("this log"), Say("known to (95 %)"), Say("before"))
    return Table([Column(name) for name in names], rows, caption)


def _beside_file(c: CalibratedRobot) -> list[Block]:
    """The picture of all intervals, where any number has one before."""
    if not any(0 < e.prior_spread < math.inf for e in c.parameters):
        return []
    return [Picture(Say("Each parameter beside the robot's file, with 95 % intervals"), c.plot)]


def _predictions(c: CalibratedRobot) -> Table:
    """R² of half seconds of each sensor, of all and of those not fitted; and fits some samples ahead."""
    ahead = list(c.fits)
    rest = c.unfitted
    columns = [Column(Say("sensor")), Column(Say("R², half seconds"), "1")]
    columns += [Column(Say("R², not fitted"), "1")] if rest else []
    columns += [Column(Say("{n} ahead [%]", n=int(samples))) for samples in ahead]
    rows = [
        [
            channel(name),
            float(c.segments[name]),
            *([rest.get(name, math.nan)] if rest else []),
            *(_fit(c.fits[samples].get(name, math.nan)) for samples in ahead),
        ]
        for name in c.channels
    ]
    caption = Say("Ahead: fit on the part held out, some samples after what the filter knew. 100 % is perfect.")
    return Table(columns, rows, caption if ahead else None)


def _fit(per_cent: float) -> Quantity | Say:
    return Say("worse than the mean") if per_cent < 0 else Quantity(per_cent, "1")


def _coefficients(c: CalibratedRobot) -> list[Block]:
    torque = Say("Torque on the wheels: a11 θ̈ + a12 ψ̈. On the body: a12 θ̈ + a22 ψ̈. θ: wheels, ψ: pitch.")
    blocks: list[Block] = [_estimates(c.combinations, torque), *c.which_pole]
    if others := (*c.delays, *c.electronics):
        blocks.append(_estimates(others, Say("Delays count from the command. Asymmetry: right motor less left.")))
    return blocks


def _not_separated(c: CalibratedRobot) -> list[Block]:
    R = c.correlation
    pairs = [
        [term(c.names[i]), term(c.names[j]), float(R[i, j])]
        for i in range(len(R))
        for j in range(i)
        if abs(R[i, j]) >= STRONG
    ]
    advice = Say("A scale or a ruler separates them: write what you measured into the robot's file.")
    blocks: list[Block] = [Items(c.unseen), advice]
    if pairs:
        columns = [Column(Say("number")), Column(Say("beside")), Column(Say("correlation"), "1")]
        blocks.append(Table(columns, pairs))
    return blocks


def _origin(c: CalibratedRobot) -> dict[str, str]:
    """What was fitted, for a page's foot."""
    logs = ", ".join(Path(source).name for source in c.sources)
    return {"prior": c.prior.name, "samples": str(c.samples), "logs": logs}
