"""The page of a `Calibration`: estimates, what the log does not determine, and the checks."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from upright.calibrate.calibration import (
    GOOD,
    HELD,
    PREDICTED,
    QUIET,
    SURPRISE,
    VERDICTS,
    VISIBLE,
    Calibration,
    Estimate,
)
from upright.plotting import legend, line, number, panels
from upright.report.figure import Figure
from upright.report.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.report.priors import BOUNDED, CLOSE, MEASURED, NOT_VISIBLE, by_name, groups, width
from upright.tables import joined, least, sentence, spoken

if TYPE_CHECKING:
    pass

GIVEN = 2  # parameters named on the first screen
STRONG = 0.9
"""Correlations from this size up are listed: only the prior separates such pairs."""


def page_of(calibration: Calibration) -> Page:
    """The calibration's page, not yet written."""
    wrong = _reservations(calibration)
    others = (*calibration.delays, *calibration.electronics)
    drawn = [figure for figure in (_measured(calibration), by_name(calibration)) if figure]
    sections = [
        *([Section("Reservations", wrong)] if wrong else []),
        Section("Parameters", [*map(_as_words, calibration.notes), *drawn[1:], *_by_origin(calibration)]),
        Section("Predictions of each sensor", [*_predicted_words(calibration), *_predicted(calibration)], folded=True),
        *([Section("Delays and motors", [_DELAYS, *_estimates(others)], folded=True)] if others else []),
        Section(
            "Coefficients of the motion",
            [_COMBINED, *calibration.which_pole, *_estimates(calibration.combinations)],
            folded=True,
        ),
        Section("What the log does not determine", _undetermined(calibration), folded=True),
        Section("Innovations", [_INNOVATIONS, _whiteness(calibration)], folded=True),
        Section("Meaning of the verdicts", [_meanings()], folded=True),
    ]
    kept = {
        "prior": calibration.prior.name,
        "samples": str(calibration.samples),
        "logs": _names_of(calibration),
    }
    return Page(
        _title(calibration), sections, _lead(calibration), kept, False, verdict=_verdict(calibration),
        picture=drawn[0] if drawn else None, numbers=_numbers(calibration),
    )  # fmt: skip


def _names_of(c: Calibration) -> str:
    """The files of the logs, without their folders."""
    return ", ".join(Path(source).name for source in c.sources)


def _reservations(c: Calibration) -> list[str]:
    """What speaks against the calibration; sensors with the same fault are named in one sentence."""
    words, coloured = list[str](), list[str]()
    for text in c.check():
        match = None if text in c.apart else _COLOURED.fullmatch(text.rstrip("."))
        if match:
            coloured.append(_plain(match[1]).strip())
        else:
            words.append(text if text in c.apart else _sentence(text))
    words += [
        f"The {spoken(e.name)} is {number(abs(e.shift), 2)} standard deviations from the guess of the robot's file: "
        "check it."
        for e in c.parameters
        if e.guess and abs(e.shift) > SURPRISE and e.verdict not in (HELD, QUIET)
    ]
    if coloured:
        words.append(
            f"The prediction errors (innovations) of the {joined(coloured)} are not white noise: later ones follow "
            "from earlier ones. So the model leaves something out."
        )
    return words


_COLOURED = re.compile(r"innovations of the (.+) are not white")


def _verdict(c: Calibration) -> Verdict:
    """Two questions: whether the model follows the log, and whether most parameters come from the log."""
    wrong, kept = _reservations(c), sum(e.verdict != VISIBLE for e in c.parameters)
    if c.refused:
        return Verdict("refused", "bad")
    if wrong:
        predicts = "predicts the log, with " if _least(c)[0] >= GOOD else ""
        return Verdict(f"{predicts}{len(wrong)} reservation{'s' if len(wrong) > 1 else ''}", "warn")
    rest = f"; {kept} of {len(c.parameters)} parameters stay uncertain" if kept else ""
    return Verdict(f"predicts the log{rest}", "warn" if 2 * kept > len(c.parameters) else "good")


def _title(c: Calibration) -> str:
    if c.refused:
        return f"The log does not describe {c.robot.name}"
    count, logs = sum(map(len, groups(c))), "this log" if len(c.sources) < 2 else f"these {len(c.sources)} logs"
    predicts = "predicts" if _least(c)[0] >= GOOD else "predicts in part"
    measures = "the log measures" if len(c.sources) < 2 else "they measure"
    close = len(groups(c)[0])
    bounds = f" and {'bounds' if len(c.sources) < 2 else 'bound'} {count - close}" if count > close else ""
    of = f"{close or 'none'} of {len(c.parameters)} parameters{bounds}"
    return f"Calibrated, {c.robot.name} {predicts} {logs}; {measures} {of}"


def _kind_of_verdict(e: Estimate) -> str:
    """The verdict as one of two words, visible or not, with its kind."""
    return f"{NOT_VISIBLE}: {e.verdict}" if e.verdict != VISIBLE else MEASURED if width(e) <= CLOSE else BOUNDED


def _sentence(text: str) -> str:
    return sentence(text.replace("sensor/", "").replace("_", " "))


def _numbers(c: Calibration) -> list[tuple[str, str]]:
    """How well it predicts, how fast the robot falls, and how many parameters the log tells, the closest one named."""
    if c.refused:
        return []
    (lowest, sensor), pole = _least(c), c["unstable_pole"]
    measured, bounded, rough = groups(c)
    numbers: list[tuple[str, str]] = []
    if scores := _held_out(c):
        worst = min(scores, key=lambda name: scores[name])
        numbers.append((least(scores[worst]), f"R² of the {_plain(worst)} where it was not fitted; good from {GOOD:g}"))
    elif math.isfinite(lowest):
        numbers.append((least(lowest), f"R² of the {sensor} over half seconds, the worst sensor; good from {GOOD:g}"))
    if pole.value > 0:
        doubles = number(1e3 * math.log(2) / pole.value, 2)
        within = f"{cell_text(pole.low, 3)} to {cell_text(pole.high, 3)}"
        grows = f"rate at which a lean grows (unstable pole; 95 %: {within}): doubles in {doubles} ms"
        numbers.append((_whole(f"{_value(pole)} {pole.unit}"), grows))
    more = len(bounded) + len(rough)
    words = f"parameters are measured, to ± {100 * CLOSE:g} % or better{f'; {more} more are bounded' if more else ''}"
    return [*numbers, (f"{len(measured)} of {len(c.parameters)}", words)]


def _whole(text: str) -> str:
    """Text that is never broken into lines."""
    return text.replace(" ", "\u00a0")


def _value(e: Estimate) -> str:
    return cell_text(e.value, 3)


def _measured(c: Calibration) -> Figure | None:
    if not c.free:
        return None
    drawn = [name for name in c.channels if name in PREDICTED] or c.channels
    rest = [name for name in c.channels if name not in drawn]
    title = f"Measured and predicted, half a second at a time: R² of {_each(c, drawn)}"
    note = "Each half second starts from a fitted state and gets only the commands."
    note += " Shaded: held out, not used in the fit; R² counts it too." if c.held_out else ""
    note += f" Not drawn: R² of {_each(c, rest)}." if rest else ""
    return Figure(title, c.plot_prediction(), note)


def _each(c: Calibration, names: Sequence[str]) -> str:
    """The least R² of each kind of sensor among these, in words."""
    kinds: dict[str, list[float]] = {}
    for name in names:
        kinds.setdefault(name.removeprefix("sensor/").partition("_")[0], []).append(c.segments[name])
    words = [f"{kind}{'s' if len(values) > 1 else ''} ≥ {least(min(values))}" for kind, values in kinds.items()]
    return ", ".join(words).replace("_", " ")


def _least(c: Calibration) -> tuple[float, str]:
    """The smallest R² of half seconds, and its sensor; a compass, which also turns with iron nearby, counts alone."""
    sensors = {name: value for name, value in c.segments.items() if name.startswith("sensor/")}
    judged = {name: value for name, value in sensors.items() if name in PREDICTED} or sensors
    return min(((value, _plain(name)) for name, value in judged.items()), default=(math.nan, ""))


def _held_out(c: Calibration) -> dict[str, float]:
    """R² of the half seconds that were not fitted, of each sensor that is drawn; empty where all were."""
    if not c.held_out or not c.free:
        return {}
    free, (start, _) = c.free[0], c.held_out
    rest = free.when >= start
    part = replace(free, **{name: getattr(free, name)[rest] for name in _READINGS})
    return {
        name: part.r_squared(name)
        for name in free.rows
        if name in PREDICTED and (part.row == free.rows.index(name)).sum() > 2
    }


_READINGS = ("row", "when", "measured", "predicted", "segment")


def _undetermined(c: Calibration) -> list[Item]:
    pairs = _pairs(c)
    return [
        *(list(map(_as_words, c.unseen)) or ["The log determines every direction."]),
        *([pairs] if pairs.rows else []),
    ]


def _as_words(text: str) -> str:
    """A sentence with names of parameters in words, and options as code."""
    named = re.sub(r"\b[a-z]+(?:_[a-z]+)+(?:/[a-z_]+)?", lambda m: spoken(m[0]), text)
    return re.sub(r"(?<![`\w-])--[a-z]+(?:-[a-z]+)*", r"`\g<0>`", named)


_DELAYS = (
    "The delay from a command to each sensor, then the motors. Asymmetry: right motor less left, over their mean. "
    "Battery: the fraction of the logged command that reaches the motors."
)
_COMBINED = (
    "The coefficients of the equations of motion, and the unstable pole. A log often determines these much better than "
    "the single parameters. The torque on the wheels is a11 θ̈ + a12 ψ̈, that on the body a12 θ̈ + a22 ψ̈. Here θ is "
    "the angle of the wheels, and ψ the pitch. The weight moment is mass times gravity times height of the "
    "centre of mass."
)
_PREDICTED = (
    "R²: the log is simulated half a second at a time. Each simulation starts from a state fitted to that half second.",
    "Fit: the part of the log held out is predicted some samples ahead. Each prediction starts from what the filter "
    "knew of the past, which is less sure. An error of the start{grows}. So a fit can fall over many samples "
    "where R² stays near 1.",
)
_INNOVATIONS = (
    "Innovations are the filter's prediction errors. They should not correlate with each other (Ljung and Box) or with "
    "earlier commands. Both statistics then stay below the threshold in 99 of 100 logs."
)


def _lead(c: Calibration) -> str:
    """How well the calibrated robot predicts, and what to run next."""
    if c.refused:
        return sentence(c.refused[0])
    logs = _names_of(c) or "the log"
    text = f"{c.robot.name} was fitted to {c.samples} rows of {logs}."
    measured = [f"{spoken(e.name)} (± {cell_text(100 * width(e), 2)} %)" for e in groups(c)[0]]
    text += f" The log tells most of the {joined(measured[:GIVEN])}." if measured else ""
    unknown = sum(e.verdict != VISIBLE for e in c.parameters)
    text += f" It says little of {unknown} other parameters." if unknown else ""
    return text + (" Next: `upright excite` plans a run that tells more parameters." if unknown else "")


def _by_origin(c: Calibration) -> list[Item]:
    """The numbers that the log determines; those that stay as they were are pressed for."""
    measured, bounded, rough = groups(c)
    known = [*measured, *rough, *bounded]  # as in the figure
    rest = [e for e in c.parameters if e not in known]
    if not known or not rest:
        return _estimates(c.parameters)
    folded = Details(f"The other {len(rest)}, which the log does not determine", _estimates(rest))
    return [f"The {len(known)} numbers that the log determines:", *_estimates(known), folded]


def _estimates(estimates: Sequence[Estimate]) -> list[Item]:
    """Values with their intervals; what was known before, and the verdicts, are pressed for."""
    values: list[list[Cell]] = [[_named(e), e.value, _interval(e)] for e in estimates]
    known: list[list[Cell]] = [[_named(e), _before(e), _kind_of_verdict(e)] for e in estimates]
    return [
        Table(["", "value", "95 % interval"], values, digits=3),
        Details("Known before this log, and verdicts", [Table(["", "before ± standard deviation", "verdict"], known)]),
    ]


def _named(e: Estimate) -> str:
    return f"{spoken(e.name)} {_whole(f'[{e.unit}]')}"


def _before(e: Estimate) -> str:
    return _whole(f"{cell_text(e.prior, 3)} ± {cell_text(e.prior_spread, 2)}")


def _interval(e: Estimate) -> str:
    return f"{cell_text(e.low, 3)} … {cell_text(e.high, 3)}".replace(" ", "\u00a0")


def _meanings() -> Table:
    kinds = [
        [MEASURED, f"{VERDICTS[VISIBLE]}; the interval is at most {100 * CLOSE:g} % of the value either side"],
        [BOUNDED, f"{VERDICTS[VISIBLE]}; but the interval is wider, or reaches zero"],
    ]
    others = ([f"{NOT_VISIBLE}: {kind}", text] for kind, text in VERDICTS.items() if kind != VISIBLE)
    return Table(["verdict", "meaning"], [*kinds, *others])


def _pairs(c: Calibration) -> Table:
    R = c.correlation
    rows: list[list[Cell]] = [
        [spoken(c.names[i]), spoken(c.names[j]), float(R[i, j])]
        for i in range(len(R))
        for j in range(i)
        if abs(R[i, j]) >= STRONG
    ]
    return Table(["", "with", "correlation"], rows, f"Pairs correlated by {STRONG:g} or more", digits=3)


def _predicted_words(c: Calibration) -> list[Item]:
    pole = c["unstable_pole"].value
    grows = f" doubles every {number(1e3 * math.log(2) / pole, 2)} ms" if pole > 0 else " grows"
    return [text.replace("{grows}", grows) for text in _PREDICTED]


def _predicted(c: Calibration) -> list[Item]:
    free: list[list[Cell]] = [[_plain(name), value] for name, value in c.segments.items() if name != "lost"]
    tables: list[Item] = [Table(["sensor", "R² of half seconds"], free)]
    if lost := c.segments.get("lost", 0.0):
        tables.append(f"In {cell_text(100 * lost, 2)} % of these readings the simulated robot had fallen.")
    if not c.fits:
        return tables
    names = list(next(iter(c.fits.values())))
    rows: list[list[Cell]] = [
        [_ahead(str(h)), *("worse than the mean" if fit < 0 else fit for fit in fits.values())]
        for h, fits in c.fits.items()
    ]
    tables.append(Table(["ahead", *map(_plain, names)], rows, "Fit [%]", digits=3))
    figure, (ax,) = panels(["fit on the part held out [%]"], "samples ahead", "log")
    for name in names:
        line(ax, _plain(name), [float(h) for h in c.fits], [fits[name] for fits in c.fits.values()])
    for drawn in ax.lines:
        drawn.set(marker="o", markersize=4)
    ax.set_xticks([float(h) for h in c.fits], list(map(str, c.fits)))
    ax.minorticks_off()
    ax.set_ylim(0, 100)
    tables.append(Figure(f"Fit of each sensor, {_ahead(str(list(c.fits)[-1]))} ahead and less", legend(figure)))
    return tables


def _ahead(samples: str) -> str:
    return f"{samples} sample{'' if samples == '1' else 's'}"


def _plain(name: str) -> str:
    return name.removeprefix("sensor/").replace("_", " ")


def _whiteness(c: Calibration) -> Table:
    rows: list[list[Cell]] = [
        [_plain(w.sensor), w.rms, w.worst, w.ljung_box, w.input_test, w.threshold, w.white] for w in c.whiteness
    ]
    header = ["sensor", "rms / expected", "correlation", "Ljung–Box", "commands", "threshold", "white"]
    return Table(header, rows)
