"""The page of an `ExcitationPlan`: the excitation, the predicted intervals, and the limits."""

from __future__ import annotations

import math

import numpy as np

from upright.arrays import Array
from upright.calibration.estimate import BOUNDED, CLOSE, MEASURED, NOT_VISIBLE, ONE_SIDED
from upright.excitation.plan import VISIBLE, ExcitationPlan, Predicted
from upright.plotting import AXIS, BESIDE, COLOURS, INK, WIDTH, legend, line, number, numbered, panels, rows_of
from upright.reports.figure import Figure
from upright.reports.made import chosen, command, typed
from upright.reports.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import joined, spoken


def page_of(plan: ExcitationPlan) -> Page:
    """The plan's page, not yet written."""
    wrong = plan.check()
    several = f"{len(wrong)} reservation{'s' if len(wrong) > 1 else ''}"
    verdict = Verdict(several, "warn") if wrong else Verdict("within all limits", "good")
    sections = [
        *([Section("Reservations", wrong)] if wrong else []),
        Section("The run", [_over_time(plan)]),
        Section("Limits", [_limits(plan), _checked_words(plan), *_rest(plan)]),
        Section("Frequencies and energy", [_spectrum(plan), _energies(plan), _energy(plan)], folded=True),
        Section("Predicted intervals", [_PREDICTED, *_tables(plan)], folded=True),
        Section("Beside a random dither", [_beside_dither(plan)], folded=True),
        Section("Alternatives", [_TRIED.format(_focus(plan)), _tried(plan)], folded=True),
    ]
    facts = {"controller": f"{plan.controller} (fingerprint {plan.hash[:12]})", "seed": str(plan.seed), "kit": plan.kit}
    numbers = [
        (f"≤ {number(100 * plan.checked.bound, 2)} %", _falls(plan)),
        (
            f"{cell_text(plan.checked.travel, 2)} m",
            f"95 % of the robots travel no further; allowed {plan.limits.travel:g} m",
        ),
        (f"{cell_text(math.degrees(plan.checked.peak), 2)}°", "95 % of the robots lean no more"),
    ]
    return Page(
        _title(plan), sections, _lead(plan), facts, False, verdict=verdict, picture=_widths(plan),
        numbers=numbers,
    )  # fmt: skip


def _falls(plan: ExcitationPlan) -> str:
    c = plan.checked
    louder = f", with the signal {100 * (plan.margin - 1):.0f} % larger" if plan.margin > 1 else ""
    counted = f"{c.fell} of {c.samples} simulated robots fell{louder}"
    return f"may fall, with 95 % confidence: {counted}; allowed {100 * plan.limits.falls:g} %"


_WHAT = (
    "It is added to the commands of the controller, which keeps the robot upright. The mean of both motors drives the "
    "robot; half of their difference turns it."
)
_PREDICTED = (
    "Predicted from the Fisher information of the calibration's predictor, along a run of the nonlinear model with the "
    "kit."
)
_DITHERS = (
    "Both dithers are random binary signals of the same energy at the motors: one changes every period, one is held "
    "for 40 ms. What a hundred runs leave comes from other numbers of the file, such as masses: measure those."
)
_TRIED = (
    "Each alternative is as large as the limits allow; energies are those at the motors. The plan takes the best, then "
    "less of it: as little energy as leaves the intervals hardly wider. So an alternative may be narrower than the "
    "plan, by more energy, and a dither is louder here than the one above. "
    "The last column is what is minimised: the width of the intervals after the run over that before, as the geometric "
    "mean over {}."
)


BETTER = 0.95  # of the plan's interval: that of a random signal is narrower


def _meant(plan: ExcitationPlan) -> list[str]:
    """The parameters that excitations are compared by."""
    from upright.robots import PARAMETERS

    return list(plan.focus) or [p.name for p in plan.predicted if p.name in PARAMETERS]


def _focus(plan: ExcitationPlan) -> str:
    if plan.focus:
        return f"the parameters in focus: {joined([spoken(name) for name in plan.focus])}"
    return f"the {len(_meant(plan))} numbers of the robot itself that the table lists, without delays and motors"


def _lead(plan: ExcitationPlan) -> str:
    close = [f"{spoken(p.name)} (± {number(_per_cent(p, p.after), 2)} %)" for p in _own(plan) if _kind(p) == MEASURED]
    named = close if len(close) <= GIVEN + 1 else [*close[:GIVEN], f"{len(close) - GIVEN} more"]
    most = f" Its log should measure {joined(named)}." if named else ""
    from upright.excitation.search import COMBINED

    way = "a mix of random steps, sines, drives and turns" if plan.way == COMBINED else f"a {plan.way}"
    return f"While {plan.controller} balances the robot, {way} is added to its commands.{most} Next: {_next(plan)}"


GIVEN = 3  # parameters named on the first screen


def _next(plan: ExcitationPlan) -> str:
    every = f"every {1e3 * plan.hold * plan.period:g} ms"
    file = typed("--output")
    robot = chosen("--robot", "--kit")
    if not file:
        return f"`{command() or 'upright excite'} -o plan.json` writes the plan as a file."
    law = chosen("--controller")
    return (
        f"`upright simulate{robot}{law} --excite {file} -o run.csv` tries it. On your own robot: `excitation` in "
        f"{file} has a row {every}, two numbers [{plan.unit}]. Add the first to the left command, the second to the "
        f"right, and log the sums. Then `upright calibrate run.csv{robot} -o robot.toml`."
    )


def _over_time(plan: ExcitationPlan) -> Figure:
    t = np.arange(len(plan.excitation)) * plan.hold * plan.period
    figure, axes = panels([f"driving of both motors [{plan.unit}]", f"turning by (right − left) / 2 [{plan.unit}]"])
    sizes: list[str] = []
    for style, (ax, (name, wave)) in enumerate(zip(axes, _waves(plan).items(), strict=True)):
        line(ax, name, t, wave, step=True, solid=True, style=style)
        sizes.append(f"{name} up to {cell_text(float(np.abs(wave).max()), 2)} {plan.unit}")
    return Figure(f"The excitation over time: {' and '.join(sizes)}{_of_most(plan)}", figure, _WHAT)


def _of_most(plan: ExcitationPlan) -> str:
    """What the motors of its kit get at most, where the kit is known here."""
    from upright.errors import UprightError
    from upright.robots import Kit

    try:
        kit = Kit.preset(plan.kit)
    except UprightError:
        return ""
    most = kit.most("V")
    return f"; the motors get at most {most:g} V" if plan.unit == "V" and math.isfinite(most) else ""


def _waves(plan: ExcitationPlan) -> dict[str, Array]:
    left, right = plan.excitation.T
    return {"driving": (left + right) / 2, "turning": (right - left) / 2}


def _spectrum(plan: ExcitationPlan) -> Figure:
    step = plan.hold * plan.period
    frequency: Array = np.fft.rfftfreq(len(plan.excitation), step)[1:].astype(np.float64)
    figure, (ax,) = panels([f"amplitude [dB over 1 {plan.unit}]"], "frequency [Hz]", "log")
    for name, wave in _waves(plan).items():
        line(ax, name, frequency, _level(wave, frequency))
    for drawn, marker in zip(ax.lines, ("o", "x"), strict=True):
        drawn.set(linestyle="", marker=marker, markersize=3)
    return Figure("Spectrum of the excitation", legend(figure), "Amplitude of each sine in the run, a mark for each.")


QUIETEST = 60.0  # [dB] below the loudest sine: less is not drawn


def _level(wave: Array, frequency: Array) -> Array:
    """Amplitudes in decibels; NaN for what is not drawn."""
    amplitude = 2 * np.abs(np.fft.rfft(wave))[1 : len(frequency) + 1] / len(wave)
    level = 20 * np.log10(np.maximum(amplitude, 1e-12))
    return np.where(level > level.max() - QUIETEST, level, np.nan)


def _energies(plan: ExcitationPlan) -> Table:
    rows: list[list[Cell]] = [
        [name.replace("common", "driving"), 100 * fraction] for name, fraction in plan.division.items()
    ]
    caption = f"What reaches the motors, {plan.energy:.3g} {_energy_unit(plan)}, by part of the excitation"
    return Table(["part", "fraction [%]"], rows, caption, 3)


def _energy_unit(plan: ExcitationPlan) -> str:
    return f"({plan.unit})² s" if " " in plan.unit else f"{plan.unit}² s"


def _energy(plan: ExcitationPlan) -> str:
    unit = _energy_unit(plan)
    answer = "works against it, and leaves" if plan.energy < plan.added else "answers it; together they give"
    return (
        f"As drawn, before the loop, the excitation has an energy of {plan.added:.3g} {unit} over both motors. The "
        f"controller {answer} {_joules(plan)} at the motors. Only this one is meant where energies are compared. "
        "The controller works most against slow parts, so these are larger in the drawing."
    )


DRAWN = 0.95  # of the width before: parameters whose intervals shrink less are not drawn beside a dither


def _title(plan: ExcitationPlan) -> str:
    kinds = [_kind(p) for p in _own(plan)]
    close, bounded = (kinds.count(kind) for kind in (MEASURED, BOUNDED))
    of = f"{close or 'none'} of {len(kinds)} parameters of {plan.robot}"
    return f"A run of {plan.seconds:.3g} s should measure {of}{f' and bound {bounded} more' if bounded else ''}"


def _own(plan: ExcitationPlan) -> list[Predicted]:
    """The parameters of the robot itself, without delays and motors, as the page of a calibration counts them."""
    from upright.robots import PARAMETERS

    own = [p for p in plan.predicted if p.name in PARAMETERS or p.name == "roll_fraction"]
    return own or list(plan.predicted)


def _kind(p: Predicted) -> str:
    """What the log will be said to tell of a parameter, in the words of a calibration's page."""
    if p.after >= VISIBLE * p.before:
        return NOT_VISIBLE
    return MEASURED if _per_cent(p, p.after) <= 100 * CLOSE else BOUNDED


def _per_cent(p: Predicted, width: float) -> float:
    """Half a width in per cent of the value; infinite where the value is zero."""
    return 50 * width / abs(p.value) if p.value else math.inf


def _widths(plan: ExcitationPlan) -> Figure:
    """Widths over those before, a bar for each parameter of the robot, the best known of each kind first."""
    kinds = {MEASURED: COLOURS[2], BOUNDED: COLOURS[0], NOT_VISIBLE: INK}
    own = sorted(_own(plan), key=lambda p: (list(kinds).index(_kind(p)), p.after / p.before))
    figure, ax = rows_of(
        [p.name.replace("fraction", "inertia") for p in own],
        "uncertainty left after the run [% of that before]",
        "parameter",
    )
    rows = np.arange(len(own))
    after = np.array([100 * p.after / p.before for p in own])
    for label, colour in kinds.items():
        kept = np.array([_kind(p) == label for p in own])
        if kept.any():
            ax.barh(rows[kept], after[kept], height=0.6, color=colour, label=label)
    for row, p in enumerate(own):
        if after[row] < THIN:
            ax.annotate(
                f"{number(after[row], 2)} %", (after[row], row), (4, 0), textcoords="offset points", va="center"
            )
        text = ax.annotate(_beside(p), (1, row), (8, 0), xycoords=ax.get_yaxis_transform(), textcoords="offset points",
                           va="center")  # fmt: skip
        text.set_gid(BESIDE)
    box = ax.get_position()
    left, above = ax.yaxis.label.get_position()
    ax.set_position((box.x0, box.y0, box.width - COLUMN / WIDTH, box.height))
    ax.yaxis.set_label_coords(left * box.width / ax.get_position().width, above)
    ax.axvline(100 * VISIBLE, linestyle="--", linewidth=1, color=AXIS, label="half")
    ax.set(xlim=(0, 103), xticks=range(0, 101, 25))
    note = (
        f"Measured: at most half is left, and ± {100 * CLOSE:g} % of the value or less. "
        f"Bounded: at most half is left, but not to ± {100 * CLOSE:g} %. ±: half of the 95 % interval, in per cent of "
        "the value, before → after. ≤: the largest value that stays possible."
    )
    halved = sum(_kind(p) != NOT_VISIBLE for p in own)
    title = f"The run should at least halve the uncertainty of {halved} of {len(own)} parameters"
    return Figure(title, legend(figure), note)


def _beside(p: Predicted) -> str:
    """How uncertain a parameter is before and after, or how large it may be at most."""
    if _kind(p) == NOT_VISIBLE:
        return ""
    low = p.value - p.after / 2
    high = p.value + p.after / 2
    if low < ONE_SIDED * high:
        return f"≤ {cell_text(high, 2)} {p.unit}"
    return f"± {number(_per_cent(p, p.before), 2)} → {number(_per_cent(p, p.after), 2)} %"


COLUMN = 1.75  # [inches] right of the bars, for the numbers
THIN = 5.0  # [%] of a bar that is hardly seen, so that its number stands beside it


def _rest(plan: ExcitationPlan) -> list[str]:
    """The plan's notes, but for the robots that do not stand, which are said above."""
    return [note for note in plan.notes if "fall without an excitation" not in note]


def _shrunk(plan: ExcitationPlan) -> list[Predicted]:
    """The parameters that the run tells something of, the best known first."""
    return sorted((p for p in plan.predicted if p.after < DRAWN * p.before), key=lambda p: p.after / p.before)


def _beside_dither(plan: ExcitationPlan) -> Figure:
    """Widths over those before, of the run and of a random signal as loud."""
    shown = _shrunk(plan)
    figure, ax = rows_of([p.name for p in shown], "uncertainty left [% of that before]", "parameter")
    ax.set_xscale("log")
    numbered(ax.xaxis)
    rows = np.arange(len(shown))
    for name, left, mark, colour in (
        ("random dither of the same energy", [p.dither / p.before for p in shown], "x", 4),
        ("this run", [p.after / p.before for p in shown], "o", 0),
    ):
        ax.plot(100 * np.array(left), rows, mark, markersize=6, color=COLOURS[colour], label=name)
    worse = [p for p in plan.predicted if p.after < BETTER * p.dither]
    better = [spoken(p.name) for p in plan.predicted if p.after < VISIBLE * p.before and p.dither < BETTER * p.after]
    title = f"The run tells more than a random dither of {len(worse)} of {len(plan.predicted)} parameters"
    dither = f" It would tell more of {joined(better)}." if better else ""
    note = f"Left is better. Dither: a random binary signal of the same energy at the motors.{dither}"
    return Figure(title, legend(figure), note)


def _joules(plan: ExcitationPlan) -> str:
    return f"{plan.energy:.3g} {_energy_unit(plan)}"


def _tables(plan: ExcitationPlan) -> list[Item]:
    """Half widths of the intervals; what only some ask for is pressed for."""
    rows: list[list[Cell]] = [[_named(p), p.before / 2, p.after / 2, _kind(p)] for p in plan.predicted]
    more: list[list[Cell]] = [
        [_named(p), p.dither / 2, p.held / 2, p.least / 2, p.after / p.dither] for p in plan.predicted
    ]
    header = ["parameter", "dither", "held 40 ms", "100 runs", "after / dither"]
    return [
        Table(["parameter", "before", "after", "this run"], rows, "Half widths of 95 % intervals", 3),
        Details("Both dithers, and a hundred runs", [_DITHERS, Table(header, more, "Half widths, and their ratio", 3)]),
    ]


def _named(p: Predicted) -> str:
    unit = f"[{p.unit}]".replace(" ", "\u00a0")
    return f"{spoken(p.name)} {unit}"


def _checked_words(plan: ExcitationPlan) -> str:
    c = plan.checked
    alone = f"The {c.dropped} more that were drawn fall without an excitation, and do not count. " if c.dropped else ""
    times = "this excitation" if plan.margin == 1 else f"this excitation made {plan.margin:g} times as large"
    return (
        f"{c.samples} robots drawn from the uncertainty of {plan.robot}, in the nonlinear model with kit {plan.kit} "
        f"and {times}: {c.fell} fell. {alone}"
    )


def _limits(plan: ExcitationPlan) -> Table:
    c, limits = plan.checked, plan.limits
    rows: list[list[Cell]] = [
        ["probability of a fall [%]", 100 * c.bound, 100 * limits.falls],
        ["periods with a saturated motor [%]", 100 * c.saturated, 100 * limits.saturated],
        ["travel [m]", c.travel, limits.travel],
        ["largest lean [°]", math.degrees(c.peak), "none"],
    ]
    return Table(["", "at most", "limit"], rows, "Predicted, with 95 % confidence or as 95 % quantiles", 2)


def _tried(plan: ExcitationPlan) -> Table:
    left = [p.after / p.before for p in plan.predicted if p.name in _meant(plan)]
    whole = float(np.exp(np.mean(np.log(left)))) if left else math.nan
    known = [(t.name, t.energy, t.shrinks) for t in plan.tried]
    tried = sorted([*known, ("this plan", plan.energy, whole)], key=lambda one: np.nan_to_num(one[2], nan=math.inf))
    rows: list[list[Cell]] = [list(one) for one in tried]
    return Table(["excitation", f"energy [{_energy_unit(plan)}]", "width after / before"], rows, _NARROWEST, 3)


_NARROWEST = "Excitations, the narrowest intervals first"
