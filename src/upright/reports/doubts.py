"""What speaks against a `Calibration`, in words: each reservation, and all of them in short."""

from __future__ import annotations

import math
import re

from upright.calibration.calibration import Calibration
from upright.calibration.estimate import VISIBLE, WIDER, Estimate
from upright.plotting import number
from upright.reports.page import cell_text
from upright.tables import joined, sentence, short, spoken

FACTOR = 0.25
"""[1] From this deviation of a logarithm on, it is written as a factor."""
MEASURABLE = ("wheel_mass", "wheel_radius", "body_mass", "track", "com_height")
"""Numbers that a scale, a ruler or a balance point gives."""


def reservations(c: Calibration) -> list[str]:
    """What speaks against the calibration; sensors with the same fault are named in one sentence."""
    words, coloured = list[str](), list[str]()
    for text in c.check():
        match = None if text in c.apart else _COLOURED.fullmatch(text.rstrip("."))
        if match:
            coloured.append(short(match[1]).strip())
        elif c.refused or not _CONTRADICTED.fullmatch(text):
            words.append(text if text in c.apart else sentence(text.replace("sensor/", "").replace("_", " ")))
    words += _numbers(c)
    if coloured:
        wide = f" So the intervals were made {number(c.widening, 2)} times as wide." if c.widening > WIDER else ""
        words.append(
            f"The model leaves something out. Its prediction errors (innovations) of the {joined(coloured)} are not "
            f"white noise: later ones follow from earlier ones.{wide}{_TRY}"
        )
    return words


def _numbers(c: Calibration) -> list[str]:
    """Each number outside of what was known, and after the last why one moves that is not visible."""
    words = [_one(c, e) for e in c.off]
    weak = sum(e.verdict != VISIBLE for e in c.off)
    if weak:
        words[-1] += _WEAKLY if weak == 1 else _BOTH
    return words


def _one(c: Calibration, e: Estimate) -> str:
    """A number that the log puts outside what was known before."""
    far = f", {abs(e.shift):.1f} standard deviations away" if e.surprising else ""
    was = f"{cell_text(e.prior, 3)} ± {cell_text(e.prior_spread, 2)} {e.unit}"
    if e.asked.rate > FACTOR:
        was = f"{cell_text(e.prior, 3)} {e.unit}, × or ÷ {cell_text(math.exp(e.asked.rate), 2)}"
    check = "Measure it again." if e.name in MEASURABLE else "Check that number of the file."
    return (
        f"The {spoken(e.name)} comes out {_times(e)}: {cell_text(e.value, 3)} {e.unit}, not {was}{far}."
        f"{_heavy(c, e)} {check}"
    )


def _heavy(c: Calibration, e: Estimate) -> str:
    """That no robot has such wheels, as a sentence with a space before it."""
    body = c.robot.body_mass
    if e.name != "wheel_mass" or e.value < body:
        return ""
    return f" No robot has that: one wheel would weigh more than the whole body ({cell_text(body, 2)} kg)."


_WEAKLY = (
    " Its interval hardly narrows, so the log does not show it: the calibration moves it to make up for something "
    "else, in the model, in the log or in another number."
)
_BOTH = (
    " The intervals of these numbers hardly narrow, so the log does not show them: the calibration moves them to make "
    "up for something else, in the model or in the log."
)
_TRY = " Whether that matters, `upright validate` shows with another log."
_COLOURED = re.compile(r"innovations of the (.+) are not white")
_CONTRADICTED = re.compile(r"\w+ contradicts its prior by [\d.]+ deviations")


def repeated(c: Calibration) -> list[str]:
    """Notes whose content is among the reservations."""
    numbers = ("The log contradicts the stated value", "Outside of what was known before")
    starts = ("The innovations are not white", *(() if c.refused else numbers))
    return [note for note in c.notes if note.startswith(starts)]


def _times(e: Estimate) -> str:
    """How an estimate compares with the file: as a factor, where the file's value is not zero."""
    return f"at {number(e.value / e.prior, 2)} times the value of the robot's file" if e.prior else "far from its file"


def doubts(c: Calibration) -> str:
    """The reservations in a few words, as a sentence with a space before it."""
    wrong = c.off
    left_out = any(not w.white for w in c.whiteness)
    if not wrong:
        return " But the model leaves something out." if left_out else ""
    far = [f"the {spoken(e.name)} {_comes(e) if k == 0 else _comes(e).removeprefix('comes out ')} "
           f"({cell_text(e.value, 2)} {e.unit}{', more than the body' if _heavy(c, e) else ''})"
           for k, e in enumerate(wrong)]  # fmt: skip
    why = ": something in the model or in the log is wrong" if any(e.verdict != VISIBLE for e in wrong) else ""
    more = " The model leaves something out." if left_out and not why else ""
    return f" But {joined(far)}{why}.{more} Do not design with this robot yet."


def _comes(e: Estimate) -> str:
    return f"comes out at {number(e.value / e.prior, 2)} times the file" if e.prior else "comes out far from its file"


def again_with(c: Calibration, made: str) -> str:
    """What to do about numbers outside of what was known: measure what can be measured, and fit again."""
    wrong = c.off
    measure = [e for e in wrong if e.name in MEASURABLE]
    rest = joined([spoken(e.name) for e in wrong if e not in measure])
    check = f"check the {rest} in the robot's file, then " if rest else ""
    if not measure:
        return check
    known = " ".join(f"--known {e.name}" for e in measure)
    them = "them" if len(measure) > 1 else "it"
    named = joined([spoken(e.name) for e in measure])
    return (
        f"{check}measure the {named}, write {them} into the robot's file, and calibrate again: `{made} {known}`. Then "
    )
