"""The page of a `Calibration`: estimates, what the log does not determine, and the checks."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from upright.calibrate.calibration import GOOD, NORMAL, PREDICTED, VERDICTS, VISIBLE, Calibration, Estimate
from upright.plotting import COLOURS, INK, SMALL, SPAN, legend, line, number, panels, rows_of
from upright.report.figure import Figure
from upright.report.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.robots import PARAMETERS
from upright.tables import joined, least, sentence, spoken

if TYPE_CHECKING:
    from matplotlib.figure import Figure as MplFigure

CLOSE = 0.25  # of a value: the half width of an interval up to which it counts as measured
GIVEN = 2  # parameters named on the first screen
STRONG = 0.9
"""Correlations from this size up are listed: only the prior separates such pairs."""


def page_of(calibration: Calibration) -> Page:
    """The calibration's page, not yet written."""
    wrong = calibration.check()
    others = (*calibration.delays, *calibration.electronics)
    drawn = [figure for figure in (_measured(calibration), _by_name(calibration)) if figure]
    sections = [
        *([Section("Reservations", _reservations(calibration))] if wrong else []),
        Section("Parameters", [*calibration.notes, *drawn[1:], *_estimates(calibration.parameters)]),
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
        "logs": ", ".join(calibration.sources),
    }
    return Page(
        _title(calibration), sections, _lead(calibration), kept, False, verdict=_verdict(calibration),
        picture=drawn[0] if drawn else None, numbers=_numbers(calibration),
    )  # fmt: skip


def _reservations(c: Calibration) -> list[Item]:
    return [text if text in c.apart else _sentence(text) for text in c.check()]


def _verdict(c: Calibration) -> Verdict:
    """Two questions: whether the model follows the log, and whether most parameters come from the log."""
    wrong, kept = c.check(), sum(e.verdict != VISIBLE for e in c.parameters)
    if c.refused:
        return Verdict("refused", "bad")
    if wrong:
        return Verdict(f"{len(wrong)} reservation{'s' if len(wrong) > 1 else ''}", "warn")
    rest = f"; {kept} of {len(c.parameters)} parameters stay uncertain" if kept else ""
    return Verdict(f"predicts the log{rest}", "warn" if 2 * kept > len(c.parameters) else "good")


def _title(c: Calibration) -> str:
    if c.refused:
        return f"The log does not describe {c.robot.name}"
    count, logs = sum(map(len, _groups(c))), "this log" if len(c.sources) < 2 else f"these {len(c.sources)} logs"
    predicts = "predicts" if _least(c)[0] >= GOOD else "predicts in part"
    tell = f"{'it determines' if len(c.sources) < 2 else 'they determine'} {count or 'none'} of {len(c.parameters)}"
    return f"Calibrated, {c.robot.name} {predicts} {logs}; {tell} parameters"


def _groups(c: Calibration) -> tuple[list[Estimate], list[Estimate], list[Estimate]]:
    """What the log measures, the closest first; what it only bounds from above; and what it gives roughly."""
    visible = sorted((e for e in c.parameters if e.verdict == VISIBLE and not c.refused), key=_width)
    bounded = [e for e in visible if e.low * e.high <= 0 or e.low < 0.1 * e.high]
    measured = [e for e in visible if e not in bounded and _width(e) <= CLOSE]
    return measured, bounded, [e for e in visible if e not in bounded and e not in measured]


MEASURED, BOUNDED = f"{VISIBLE}: measured", f"{VISIBLE}: bounded"
NOT_VISIBLE = f"not {VISIBLE}"


def _kind_of_verdict(e: Estimate) -> str:
    """The verdict as one of two words, visible or not, with its kind."""
    return f"{NOT_VISIBLE}: {e.verdict}" if e.verdict != VISIBLE else MEASURED if _width(e) <= CLOSE else BOUNDED


def _width(e: Estimate) -> float:
    """Half of the interval over the value."""
    return (e.high - e.low) / max(abs(e.high + e.low), 1e-300)


def _sentence(text: str) -> str:
    return sentence(text.replace("sensor/", "").replace("_", " "))


def _numbers(c: Calibration) -> list[tuple[str, str]]:
    """How well it predicts, how fast the robot falls, and how many parameters the log tells, the closest one named."""
    if c.refused:
        return []
    (lowest, sensor), pole = _least(c), c["unstable_pole"]
    measured, bounded, rough = _groups(c)
    numbers: list[tuple[str, str]] = []
    if math.isfinite(lowest):
        numbers.append((least(lowest), f"R² of the {sensor} over half seconds, the worst sensor; target {GOOD:g}"))
    if pole.value > 0:
        doubles = cell_text(1e3 * math.log(2) / pole.value, 2)
        within = f"{cell_text(pole.low, 3)} to {cell_text(pole.high, 3)}"
        grows = f"rate at which a lean grows (unstable pole; 95 %: {within}): doubles in {doubles} ms"
        numbers.append((_whole(f"{_value(pole)} {pole.unit}"), grows))
    kinds = [f"{len(measured)} to ± {100 * CLOSE:g} % or better" if measured else ""]
    kinds += [f"{len(bounded) + len(rough)} more roughly" if bounded or rough else ""]
    words = f"parameters that the log determines: {', '.join(filter(None, kinds)) or 'none'}"
    return [*numbers, (f"{sum(map(len, _groups(c)))} of {len(c.parameters)}", words)]


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
    """The smallest R² of half seconds, and its sensor."""
    sensors = [(v, n.removeprefix("sensor/").replace("_", " ")) for n, v in c.segments.items() if n[:7] == "sensor/"]
    return min(sensors, default=(math.nan, ""))


def _by_name(c: Calibration) -> Figure | None:
    if not any(0 < e.prior_spread < math.inf for e in c.parameters):
        return None
    note = (
        "Left or right of the middle: the log moved the value. Numbers: how much is left of the uncertainty before. "
        f"Visible: the log halves it; measured where that leaves ± {100 * CLOSE:g} % or less, bounded where it leaves "
        "more. Not visible: it does not, or not reliably. The kinds of both are at the end."
    )
    drawn = [e for e in c.parameters if 0 < e.prior_spread < math.inf]
    one_sided = [e for e in _groups(c)[1] if e in drawn and e.name in PARAMETERS]
    short = [e for e in drawn if e not in one_sided and e.high - e.low < 0.1 * e.prior_spread]
    if any(e.wider for e in c.parameters):
        note += " Wider: the log knows less of it than the file, for the reason beside the estimates."
    note += " A dot without a bar: its interval is shorter than the dot." if short else ""
    note += " A bar without a dot: only an upper bound is known; it reaches from zero to that." if one_sided else ""
    return Figure("What this log tells of each parameter, beside what was known before", _bars(c), note)


def _bars(c: Calibration) -> MplFigure:
    """Intervals in standard deviations of the prior, coloured by what the log says of the parameter."""
    measured, bounded, rough = _groups(c)
    sorts = {
        MEASURED: (measured, COLOURS[2]),
        BOUNDED: ([*rough, *bounded], COLOURS[0]),
        NOT_VISIBLE: ([e for e in c.parameters if e not in (*measured, *rough, *bounded)], INK),
    }
    kept = {k: ([e for e in group if 0 < e.prior_spread < math.inf], tone) for k, (group, tone) in sorts.items()}
    names = [e.name for group, _ in kept.values() for e in group]
    figure, ax = rows_of(names, "difference from the value before [its standard deviations]", "parameter")
    for label, (group, colour) in kept.items():
        if group:
            rows = [names.index(e.name) for e in group]
            value, low, high = ([(x - e.prior) / e.prior_spread for e, x in zip(group, xs, strict=True)]
                                for xs in zip(*((e.value, e.low, e.high) for e in group), strict=True))  # fmt: skip
            one_sided = [e in bounded and e.name in PARAMETERS for e in group]
            low = [_zero(e) if side else x for e, x, side in zip(group, low, one_sided, strict=True)]
            ax.hlines(rows, low, high, linewidth=2.5, color=colour, label=label)
            for row, x, end, side in zip(rows, value, high, one_sided, strict=True):
                mark, size = ("|", 9.0) if side else ("o", 4.5)
                ax.plot(end if side else x, row, mark, color=colour, markersize=size, markeredgewidth=size / 4.5)
            for e, row, end in zip(group, rows, high, strict=True):
                ax.annotate(
                    _left(e),
                    (max(end, *value), row),
                    (6, 0),
                    textcoords="offset points",
                    va="center",
                    size=SMALL,
                )
    every = [e for group, _ in kept.values() for e in group]
    least = [max(-NORMAL, _zero(e)) if e.name in PARAMETERS else -NORMAL for e in every]
    ax.barh(
        range(len(every)),
        [NORMAL - x for x in least],
        1.0,
        least,
        color=SPAN,
        alpha=0.22,
        zorder=0,
        label="95 % before this log",
    )
    low, high = ax.get_xlim()
    ax.set_xlim(low, high + ROOM * (high - low))
    return legend(figure)


def _zero(e: Estimate) -> float:
    """Where zero lies, which no number of a robot is below, in standard deviations of the prior."""
    return -e.prior / e.prior_spread


def _left(e: Estimate) -> str:
    """How much of the uncertainty is left [%], with more digits where they decide whether it is half; in a word where
    it is more than before."""
    if e.wider:
        return "wider"
    left = min(100 * e.shrink, 100.0)
    return next((text for digits in (2, 3, 4) if (text := number(left, digits)) != "50"), "50") + " %"


ROOM = 0.08  # of the width, for the number beside the longest bar


def _undetermined(c: Calibration) -> list[Item]:
    pairs = _pairs(c)
    plain = [re.sub(r"\b[a-z]+(?:_[a-z]+)+(?:/[a-z_]+)?", lambda m: spoken(m[0]), text) for text in c.unseen]
    return [*(plain or ["The log determines every direction."]), *([pairs] if pairs.rows else [])]


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
    logs = ", ".join(c.sources) or "the log"
    text = f"{c.robot.name} was fitted to {c.samples} rows of {logs}."
    measured = [f"{spoken(e.name)} (± {cell_text(100 * _width(e), 2)} %)" for e in _groups(c)[0]]
    text += f" Best known now: {joined(measured[:GIVEN])}." if measured else ""
    unknown = sum(e.verdict != VISIBLE for e in c.parameters)
    text += f" {unknown} parameters keep what was known before." if unknown else ""
    return text + (" Next: `upright excite` plans a run that tells more parameters." if unknown else "")


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
    grows = f" doubles every {cell_text(1e3 * math.log(2) / pole, 2)} ms" if pole > 0 else " grows"
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
