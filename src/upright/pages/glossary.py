"""Words that a page explains at its foot, where it uses them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from upright.languages import ENGLISH, speaking
from upright.pages.blocks import Block, Fold, Items, Page, Picture, Table
from upright.pages.words import Say

GLOSSARY: dict[str, tuple[Say, Say]] = {
    "twin": (Say("twin"), Say("A simulation in MuJoCo that stands in for a robot, but is no real robot.")),
    "kit": (Say("kit"), Say("The electronics of a robot: sensors, motors' driver, battery, and the period.")),
    r"(?<![\w)²] )R²": (Say("R²"), Say("1: predicted exactly. 0: no better than the mean of the readings.")),
    "fit": (Say("fit"), Say("100 %: both curves are equal. 0 %: no better than a constant.")),
    "knock": (Say("knock"), Say("A blow so short that only its impulse counts, force times duration [N s].")),
    "hold at": (Say("hold"), Say("A constant force leans the robot, and then lets go.")),
    "N s": (Say("N s"), Say("Force times duration: 0.2 N s is 10 N for 20 ms.")),
    "unstable pole": (Say("unstable pole"), Say("The rate at which a small lean grows. It doubles in 0.69 / pole.")),
    "gain margin": (Say("gain margin"), Say("How much weaker or stronger the motors may be in a stable loop.")),
    "phase margin": (Say("phase margin"), Say("By how much the loop's phase may turn until it is unstable.")),
    "delay margin": (Say("delay margin"), Say("How much later a reading or a command may come in a stable loop.")),
    "certificate": (Say("certificate"), Say("What `upright certify` writes: similar robots pushed, falls counted.")),
    "effort": (Say("effort"), Say("The squared commands of both motors, summed over time.")),
    "saturated": (Say("saturated"), Say("The command is larger than the motor can follow.")),
    "dead zone": (Say("dead zone"), Say("The largest command that does not move the motor.")),
    "dither": (Say("dither"), Say("A small signal added to the commands, so that the log shows more.")),
    "innovation": (Say("innovation"), Say("What a sensor reads, less what the filter expected.")),
    "Coulomb friction": (Say("Coulomb friction"), Say("Dry friction: as large at every speed, against the motion.")),
    "lqr": (Say("lqr"), Say("State feedback that is optimal for a quadratic cost.")),
    "lqi": (Say("lqi"), Say("State feedback with an integrator, which brings the robot back to its place.")),
    "lqg": (Say("lqg"), Say("State feedback, optimal for a quadratic cost, of a Kalman filter's estimate.")),
    "pid": (Say("pid"), Say("Proportional, integral and derivative gains.")),
    "hinf": (Say("hinf"), Say("H∞ control: it keeps the largest gain from disturbances to errors small.")),
    "mpc": (Say("mpc"), Say("Model predictive control: it plans some commands ahead, within the motors' limits.")),
    "sliding": (Say("sliding"), Say("Sliding mode: it drives the state onto a surface on which it comes to rest.")),
}  # fmt: skip
"""A word, in English → its name and its meaning."""


def explained(page: Page) -> list[tuple[Say, Say]]:
    """The words of the glossary that a page uses, with their meanings."""
    with speaking(ENGLISH):
        text = "\n".join(_texts(page)).replace("\u00a0", " ")
    return [entry for word, entry in GLOSSARY.items() if re.search(rf"(?<![\w-]){word}s?(?![\w-])", text)]


def _texts(page: Page) -> Iterator[str]:
    sentences = [page.title, *page.lead, *(n.meaning for n in page.numbers), *(step.why for step in page.next)]
    if page.verdict:
        sentences.append(page.verdict.text)
    yield from map(str, filter(None, sentences))
    yield from _of_blocks([page.picture, *page.blocks] if page.picture else page.blocks)


def _of_blocks(blocks: Sequence[Block]) -> Iterator[str]:
    for block in blocks:
        if isinstance(block, Fold):
            yield str(block.heading)
            yield from _of_blocks(block.blocks)
        elif isinstance(block, Table):
            yield from (str(column.name) for column in block.columns)
            yield str(block.caption or "")
            yield from (str(cell) for row in block.rows for cell in row[:1])
        elif isinstance(block, Picture):
            yield f"{block.claim}\n{block.note or ''}"
        elif isinstance(block, Items):
            yield from map(str, block.items)
        else:
            yield str(block)
