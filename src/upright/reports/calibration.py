"""The page of a `Calibration`: estimates, what the log does not determine, and the checks."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from pathlib import Path

from upright.calibration.calibration import GOOD, PREDICTED, UNKNOWN, Calibration
from upright.calibration.estimate import (
    AGREE,
    BOUNDED,
    CLOSE,
    MEASURED,
    MOVED,
    NOT_VISIBLE,
    PRIOR,
    REFUSED,
    VERDICTS,
    VISIBLE,
    Estimate,
)
from upright.plotting import number
from upright.reports import sensors
from upright.reports.doubts import FACTOR, again_with, doubts, repeated, reservations
from upright.reports.made import command, typed
from upright.reports.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.reports.priors import by_name, groups
from upright.reports.readings import closer, over_time
from upright.tables import joined, least, power_of_ten, sentence, short, spoken

GIVEN = 3  # parameters named on the first screen
STRONG = 0.9
"""Correlations from this size up are listed: only the prior separates such pairs."""


def page_of(calibration: Calibration) -> Page:
    """The calibration's page, not yet written."""
    wrong = reservations(calibration)
    others = (*calibration.delays, *calibration.electronics)
    drawn = [figure for figure in (over_time(calibration), by_name(calibration)) if figure]
    notes = [item for note in calibration.notes if note not in repeated(calibration)
             for item in _note(calibration, note)]  # fmt: skip
    near = closer(calibration)
    sections = [
        *([Section(near.title.partition(" over ")[0] + " closer", [near])] if near else []),
        *([Section("Reservations", wrong)] if wrong else []),
        Section("Parameters", [*drawn[1:], *notes, *_by_origin(calibration)]),
        Section(
            "Predictions of each sensor", [*sensors.in_words(calibration), *sensors.tables(calibration)], folded=True
        ),
        *([Section("Delays and motors", [_DELAYS, _estimates(others)], folded=True)] if others else []),
        Section(
            "Coefficients of the motion",
            [_COMBINED, *calibration.which_pole, _estimates(calibration.combinations)],
            folded=True,
        ),
        Section("What the log does not separate", _undetermined(calibration), folded=True),
        Section("Innovations", [_INNOVATIONS, _whiteness(calibration)], folded=True),
        Section("What the labels mean", [_meanings()], folded=True),
    ]
    kept = {
        "prior": calibration.prior.name,
        "samples": str(calibration.samples),
        "logs": _names_of(calibration),
        **_forced(calibration),
    }
    return Page(
        _title(calibration), sections, _lead(calibration), kept, False, verdict=_verdict(calibration),
        picture=drawn[0] if drawn else None, numbers=_numbers(calibration),
    )  # fmt: skip


def _forced(c: Calibration) -> dict[str, str]:
    """What --force did, where it was typed."""
    if "--force" not in command().split():
        return {}
    if c.decision.withheld:
        return {"--force": "wrote the robot although the fit is refused, or the log cannot tell it"}
    return {"--force": "changed nothing: the fit is neither refused nor unknown"}


def _names_of(c: Calibration) -> str:
    """The files of the logs, without their folders."""
    return ", ".join(Path(source).name for source in c.sources)


def _verdict(c: Calibration) -> Verdict:
    """Whether anything speaks against the fit, and so whether a controller may be designed with this robot."""
    wrong = reservations(c)
    decision = c.decision
    if decision.withheld:
        return Verdict(decision.verdict, "bad" if decision.verdict == REFUSED else "warn")
    if wrong:
        so = "do not use it yet" if decision.against else "validate it first"
        return Verdict(f"{len(wrong)} reservation{'s' if len(wrong) > 1 else ''}: {so}", "warn")
    good = c.least_score >= GOOD
    return Verdict("ready for a design" if good else "predicts in part", "good" if good else "warn")


def _title(c: Calibration) -> str:
    if c.refused:
        what = f"tell {c.robot.name}: {c.refused[0]}" if c.untold else f"describe {c.robot.name}"
        return f"The log does not {what}"
    one = len(c.sources) < 2
    logs = _names_of(c) if len(c.sources) == 1 else "this log" if one else f"these {len(c.sources)} logs"
    predicts = "predicts" if c.least_score >= GOOD else "partly predicts"
    kept = one and bool(c.unfitted)
    it = "the rest" if kept else "it" if one else "them"
    close = len(groups(c)[0])
    of = f"{close or 'none'} of its {len(c.parameters)} parameters {'are' if close > 1 else 'is'} measured"
    return f"{c.robot.name}, fitted to {'part of ' if kept else ''}{logs}, {predicts} {it}; {of}"


def _numbers(c: Calibration) -> list[tuple[str, str]]:
    """How well it predicts, how fast the robot falls, and how late its gyro is."""
    if c.refused:
        return []
    pole = c["unstable_pole"]
    numbers = list[tuple[str, str]]()
    held = c.unfitted
    if scores := held or {name: c.segments[name] for name in c.channels}:
        counted = {name: r2 for name, r2 in scores.items() if name in PREDICTED} or scores
        last = min(counted, key=lambda name: counted[name])
        part = f" in the part not fitted ({least(c.segments[last])} over the whole log)" if held else ""
        words = f"R² of the {short(last)}, the worst of {len(counted)} sensors that count,{part}; good from {GOOD:g}"
        others = [f"{short(name)} {least(r2)}, not judged" for name, r2 in scores.items() if name not in counted]
        numbers.append((least(scores[last]), "; ".join([words, *others])))
    if pole.value > 0:
        doubles = number(1e3 * math.log(2) / pole.value, 2)
        within = f"95 %: {cell_text(pole.low, 3)} to {cell_text(pole.high, 3)}"
        grows = f"until a lean has doubled: unstable pole {_value(pole)} {pole.unit} ({within})"
        grows += "" if pole.verdict == VISIBLE else ", mostly from the robot's file"
        numbers.append((_whole(f"{doubles} ms"), grows))
    gyro = next((e for e in c.delays if e.name == "delay/gyro" and e.verdict == VISIBLE), None)
    if gyro:
        ms = [number(1e3 * x, 2) for x in (gyro.value, gyro.low, gyro.high)]
        text = f"from a command until the gyro shows it (95 %: {ms[1]} to {ms[2]})"
        wheels = next((e for e in c.delays if e.name == "delay/encoder" and e.verdict == VISIBLE), None)
        text += f"; the encoders within {number(1e3 * wheels.high, 2)} ms" if wheels else ""
        numbers.append((_whole(f"{ms[0]} ms"), text))
    return numbers


def _whole(text: str) -> str:
    """Text that is never broken into lines."""
    return text.replace(" ", "\u00a0")


def _value(e: Estimate) -> str:
    return cell_text(e.value, 3)


def _undetermined(c: Calibration) -> list[Item]:
    pairs = _pairs(c)
    words: list[Item] = list(map(_as_words, c.unseen)) or ["The log determines every direction."]
    if c.unseen:
        words.append(
            "A scale or a ruler separates them: write what you measured, and how surely, into the robot's file, or "
            "name it with `--known`."
        )
    return [*words, *([pairs] if pairs.rows else [])]


def _note(c: Calibration, note: str) -> list[Item]:
    """A note in words, with the names of its logs without their folders; what it was judged by, in brackets at its end,
    is pressed for."""
    for source in c.sources:
        note = note.replace(source, Path(source).name)
    text, bracket, judged = note.removesuffix(").").partition(" (log posterior ")
    if not bracket:
        return [_as_words(note)]
    why = sentence(f"log posterior of these commands less that of those as logged: {judged}")
    return [_as_words(f"{text}."), Details("How that was judged", [why])]


def _as_words(text: str) -> str:
    """A sentence with names of parameters in words, and options as code."""
    named = re.sub(r"\b[a-z]+(?:_[a-z]+)+(?:/[a-z_]+)?", lambda m: spoken(m[0]), text)
    return re.sub(r"(?<![`\w-])--[a-z]+(?:-[a-z]+)*", r"`\g<0>`", named)


_DELAYS = (
    "The delay from a command to each sensor, then the motors. Asymmetry: right motor less left, over their mean. "
    "Battery: the fraction of the logged command that reaches the motors. Drop: volts that the driver keeps of each "
    "command. Gyro resonance: where the gyro swings against the frame, or its filter ends. Gyro misalignment: the part "
    "of the yaw rate that a tilted gyro reads."
)
_COMBINED = (
    "The coefficients of the equations of motion, and the unstable pole. A log often determines these much better than "
    "the single parameters. The torque on the wheels is a11 θ̈ + a12 ψ̈, that on the body a12 θ̈ + a22 ψ̈. Here θ is "
    "the angle of the wheels, and ψ the pitch. The weight moment is mass times gravity times height of the "
    "centre of mass."
)
_INNOVATIONS = (
    "Innovations are the filter's prediction errors. They should not correlate with each other (Ljung and Box) or with "
    "earlier commands. Both statistics then stay below the threshold in 99 of 100 logs."
)


def _lead(c: Calibration) -> str:
    """What the log tells, the reservations in short, and what to run next."""
    if c.refused:
        text = sentence(c.refused[0])
    else:
        close, bounded, rough = groups(c)
        named = [f"{spoken(e.name)} (± {cell_text(100 * e.width, 2)} %)" for e in close]
        if len(named) > GIVEN + 1:
            named = [*named[:GIVEN], f"{len(named) - GIVEN} more"]
        text = f"The log measures {joined(named)}" if named else "The log measures no parameter"
        text += _bounds(len(bounded), len(rough), more=bool(named))
        rest = sum(e.verdict != VISIBLE for e in c.parameters)
        together = ", or only together with others" if c.unseen else ""
        text += f"; the other {rest} are not visible in it{together}." if rest else "."
        if rest == len(c.parameters):
            text = f"The log shows none of the {rest} clearly: it adds little to what the robot's file says."
        text += doubts(c) or _enough(c)
    return f"{text} Next: {_next(c)}".strip()


def _bounds(bounded: int, rough: int, more: bool) -> str:
    """What the log says of the numbers that it does not measure closely."""
    parts = [f"gives {rough}{' more' * more} roughly"] if rough else []
    if bounded:
        of = "" if rough else " more" * more
        parts.append(f"says of {bounded}{of} how large {'they are' if bounded > 1 else 'it is'} at most")
    return f"{',' if parts and not more else ''}{' and ' if more and parts else ' but ' * bool(parts)}{joined(parts)}"


def _enough(c: Calibration) -> str:
    """That balancing needs less than all parameters, where the log tells that well."""
    pole = c["unstable_pole"]
    if not pole.measured or c.least_score < GOOD:
        return ""
    return (
        " That is enough: balancing depends on few combinations of them, and the most important, the unstable pole, is "
        f"known to ± {_per_cent(pole)} %."
    )


def _per_cent(e: Estimate) -> str:
    return cell_text(100 * e.width, 2)


def _next(c: Calibration) -> str:
    """What to run next: with the robot that was written, where one was."""
    logs = " ".join(Path(source).name for source in c.sources) or "LOG"
    if c.decision.verdict == UNKNOWN:
        return f"{c.decision.hint}."
    if any(reason.startswith(AGREE) for reason in c.refused):
        return "measure again, correct the robot's file, and calibrate once more."
    if c.refused:
        return f"`upright doctor {logs.split()[0]}` looks for what is wrong with the log."
    robot = typed("--output")
    if not robot:
        return f"`{command() or f'upright calibrate {logs}'} -o robot.toml` writes this robot as a file."
    if reservations(c):
        check = again_with(c, command())
        return f"{check}`upright validate {robot} LOG` with another LOG; design with this robot once it passes."
    return f"`upright design lqg --robot {robot} -o lqg.json` designs a controller for it."


def _by_origin(c: Calibration) -> list[Item]:
    """The numbers that the log determines; those that stay as they were are pressed for."""
    close, bounded, rough = groups(c)
    known = [*close, *rough, *bounded]  # as in the figure
    known += [e for e in c.off if e not in known]
    rest = [e for e in c.parameters if e not in known]
    if not rest:
        return [_estimates(c.parameters)]
    others = "others" if any(e.verdict != VISIBLE for e in known) else "parameters"
    folded = Details(f"The {len(rest)} {others} that are not visible", [_estimates(rest)])
    return [*([_estimates(known)] if known else []), folded]


def _estimates(estimates: Sequence[Estimate]) -> Table:
    """Values with their intervals, what was known before, and how well the log knows them."""
    rows: list[list[Cell]] = [[_named(e), e.value, _interval(e), _before(e), e.called] for e in estimates]
    return Table(["", "value", "95 % interval", "before, with σ", "this log"], rows, digits=3)


def _named(e: Estimate) -> str:
    return f"{spoken(e.name)} {_whole(f'[{e.unit}]')}"


def _before(e: Estimate) -> str:
    if e.asked.rate > FACTOR:  # of its logarithm
        return _whole(f"{cell_text(e.prior, 3)} × or ÷ {cell_text(math.exp(e.asked.rate), 2)}")
    return _whole(in_one_power([e.prior, e.prior_spread], " ± ", e.high))


def _interval(e: Estimate) -> str:
    if e.low == 0:
        return _whole(f"at most {cell_text(e.high, 3)}")
    return _whole(in_one_power([e.low, e.high], " … "))


def in_one_power(values: Sequence[float], between: str, beside: float = 0.0) -> str:
    """Numbers beside each other, with one power of ten where any needs one; that of the number `beside` them, where
    they are not far from it.

    >>> in_one_power([9.354e-07, 3.88e-05], " … ")
    '(0.0935 … 3.88) · 10⁻⁵'
    >>> in_one_power([1e-05, 5.52e-04], " ± ", beside=3.88e-05)
    '(1 ± 55.2) · 10⁻⁵'
    """
    texts = [cell_text(value, 3) for value in values]
    largest = max(abs(value) for value in values)
    if not any(" · " in text for text in texts) or not 0 < largest < math.inf:
        return between.join(texts)
    largest = beside if beside and 0.01 < largest / abs(beside) < 100 else largest
    power = math.floor(math.log10(largest))
    return f"({between.join(cell_text(value / 10**power, 3) for value in values)}) · {power_of_ten(power)}"


def _meanings() -> Table:
    kinds = [
        [MEASURED, f"{VERDICTS[VISIBLE]}; the interval is at most {100 * CLOSE:g} % of the value either side"],
        [BOUNDED, f"{VERDICTS[VISIBLE]}; but the interval is wider, or reaches zero"],
    ]
    kinds += [[NOT_VISIBLE, VERDICTS[PRIOR]], [MOVED, _MOVED]]
    others = ([f"{NOT_VISIBLE} ({kind})", text] for kind, text in VERDICTS.items() if kind not in (VISIBLE, PRIOR))
    return Table(["label", "meaning"], [*kinds, *others])


_MOVED = (
    "the log adds little, and yet moves the number outside of what was known before: that makes up for something "
    "else, in the model, in the log or in another number"
)


def _pairs(c: Calibration) -> Table:
    R = c.correlation
    rows: list[list[Cell]] = [
        [spoken(c.names[i]), spoken(c.names[j]), float(R[i, j])]
        for i in range(len(R))
        for j in range(i)
        if abs(R[i, j]) >= STRONG
    ]
    return Table(["", "with", "correlation"], rows, f"Pairs correlated by {STRONG:g} or more", digits=3)


def _whiteness(c: Calibration) -> Table:
    rows: list[list[Cell]] = [
        [short(w.sensor), w.rms, w.worst, w.ljung_box, w.input_test, w.threshold, w.white] for w in c.whiteness
    ]
    header = ["sensor", "size / expected", "correlation", "Ljung–Box", "commands", "threshold", "white"]
    return Table(header, rows)
