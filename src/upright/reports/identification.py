"""The page of a comparison of identified models: trials in the loop, poles with intervals, predictions, orders."""

from __future__ import annotations

import math

import numpy as np

from upright.identification.identified import Identified
from upright.identification.identify import MethodComparison
from upright.identification.judge import HELD, LoopTrial
from upright.identification.methods import TITLES
from upright.plotting import legend, line, numbered, panels, plane, points
from upright.reports.figure import Figure
from upright.reports.made import again
from upright.reports.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import joined, sentence


def page_of(compared: MethodComparison) -> Page:
    """The comparison's page, not yet written."""
    data = compared.samples
    sections = [
        Section("Regulators in closed loop", [trial_table(compared), *_about_trials(compared)]),
        Section("The unstable pole", [pole_table(compared), *_poles(compared), _eigenvalues(compared)], folded=True),
        Section("Predictions", [*_about_predictions(compared), *_predictions(compared)], folded=True),
        Section("Model order", _orders(compared), folded=True),
        Section("Notes", [*compared.notes, *_failures(compared), *_delays(compared)], folded=True),
    ]
    facts = {
        "samples": f"{data.fitted} fitted of {len(data.log)}",
        "period": f"{data.dt * 1e3:.4g} ms",
        "angles and rates from": data.source,
        "robot": data.robot.name,
        "kit": data.kit.name,
    }
    return Page(
        _title(compared), sections, _lead(compared), facts,
        compared.judge.made_the_log, verdict=_verdict(compared),
        picture=_pole_figure(compared), numbers=_numbers(compared),
    )  # fmt: skip


def _verdict(compared: MethodComparison) -> Verdict:
    """How many regulators hold the robot: green where all, red where none do."""
    holding = len(_ranked(compared))
    tried = len(compared.trials)
    level = "bad" if not holding else "good" if holding == tried else "warn"
    if tried == 1:
        return Verdict("holds the robot" if holding else "does not hold the robot", level)
    if not holding:
        return Verdict("none can be used", level)
    return Verdict(f"take {_best(compared)}", "good")


PRIOR = "calibrate"  # the method that starts from what is known of the robot


def _title(compared: MethodComparison) -> str:
    """How many models are good for a regulator, and which one is to be taken."""
    name = compared.samples.robot.name
    ranked = _ranked(compared)
    if len(compared.models) < 2 or not compared.trials:
        return f"{name}: a lean doubles in {_doubling(compared)}"
    if not ranked:
        return f"No identified model gives a regulator that holds {name}"
    return f"{len(ranked)} of {len(compared.trials)} methods give a model that balances {name}"


def taken(compared: MethodComparison) -> str:
    """The method that the page says to take; empty where it names none."""
    return _best(compared) if len(compared.models) > 1 and _ranked(compared) else ""


def _best(compared: MethodComparison, without: str = "") -> str:
    """Of the methods, `without` one, whose regulators lean alike the one with the surest pole, since their order is
    chance."""
    alike = _alike(compared, without)
    poles = {method: compared.models[method].pole for method in alike}
    return min(alike, key=lambda m: width if math.isfinite(width := poles[m].high - poles[m].low) else math.inf)


def _alike(compared: MethodComparison, without: str = "") -> list[str]:
    """The methods, `without` one, whose regulators lean about as little as the least."""
    ranked = [method for method in _ranked(compared) if method != without]
    least = compared.trials[ranked[0]].largest or 0.0
    return [method for method in ranked if (compared.trials[method].largest or 0.0) <= ALIKE * least]


def _doubling(compared: MethodComparison) -> str:
    times = [1e3 * math.log(2) / m.pole.value for m in compared.models.values() if m.pole.value > 0]
    ends = dict.fromkeys(cell_text(end, 2) for end in (min(times), max(times))) if times else {"–": None}
    return " to ".join(ends) + " ms"


ALIKE = 1.1  # times the least lean: the same to within what another seed changes


def _ranked(compared: MethodComparison) -> list[str]:
    """Methods whose regulators hold the robot, the one first after whose release it leans least."""
    leans = {name: trial.largest or 0.0 for name, trial in compared.trials.items() if trial.holds}
    return sorted(leans, key=leans.__getitem__)


def _pole_figure(compared: MethodComparison) -> Figure:
    """The intervals, under what they have to do with balancing."""
    title = "The unstable pole by each method, with its 95 % interval"
    poles = compared.models.items()
    inside = [n for n, m in poles if m.pole.low <= compared.true_pole <= m.pole.high]
    holding = [n for n, t in compared.trials.items() if t.holds]
    if inside and set(inside) == set(holding):
        title = "The regulator holds where the 95 % interval of the pole contains the true one"
    elif math.isfinite(compared.true_pole):
        those = f"that of {inside[0]} contains" if len(inside) == 1 else f"those of {joined(inside)} contain"
        title = f"95 % intervals of the unstable pole; {those if inside else 'none contains'} the true one"
    still = [n for n, m in poles if m.pole.value <= 0]
    note = "The pole is the rate at which a lean grows. An interval shorter than its dot stands only in numbers."
    gives = f"{joined(still)} {'gives' if len(still) == 1 else 'give'}".capitalize()
    models = "that model is" if len(still) == 1 else "those models are"
    note += f" {gives} a stable pole; a balancing robot falls, so {models} wrong." if still else ""
    kinds = [f"{name}: {SHORT[name]}" for name in compared.models if name in SHORT]
    return Figure(title, compared.plot(), f"{note} {sentence('; '.join(kinds))}".strip() if kinds else note)


def _numbers(compared: MethodComparison) -> list[tuple[str | Verdict, str]]:
    """How many regulators hold the robot, the best method's pole and the lean that its regulator allows; of one method
    its pole and what its regulator does."""
    if len(compared.models) < 2 or not compared.trials:
        poles: list[tuple[str | Verdict, str]] = [
            (f"{cell_text(m.pole.value, 3)} 1/s", f"unstable pole by {n}") for n, m in compared.models.items()
        ]
        return [*poles, *((_did(t), _leans(n, t)) for n, t in compared.trials.items())][:3]
    if not _ranked(compared):
        return [(f"0 of {len(compared.trials)}", "regulators, each from a method's model, hold the robot")]
    best = _best(compared)
    pole = compared.models[best].pole
    lean = compared.trials[best].largest or 0.0
    true = f"; true: {cell_text(compared.true_pole, 3)} 1/s" if math.isfinite(compared.true_pole) else ""
    numbers: list[tuple[str | Verdict, str]] = [
        (f"{cell_text(pole.value, 3)} 1/s", f"unstable pole by {best}, the rate at which a lean grows{true}"),
        (f"{cell_text(math.degrees(lean), 3)}°", f"largest lean under the regulator of {best}, let go at 2.9°"),
    ]
    if math.isfinite(pole.high - pole.low):
        wide = f"± {cell_text(50 * (pole.high - pole.low) / abs(pole.value), 2)} %"
        numbers.insert(1, (wide, f"of the pole: its 95 % interval by {best}"))
    return numbers


def _did(trial: LoopTrial) -> Verdict:
    text = "holds" if trial.holds else "no regulator" if trial.why else "falls"
    return Verdict(text, "good" if trial.holds else "bad")


def _leans(name: str, trial: LoopTrial) -> str:
    if trial.fell is not None:
        return f"{name}, after {trial.fell:.1f} s"
    return f"{name}: leans {cell_text(math.degrees(trial.largest), 2)}° at most" if trial.largest else name


_POLES = (
    "The rate at which the robot falls, with its 95 % interval. Dry friction counts as damping. The interval tells how "
    "much the estimate scatters from log to log. It does not tell how far all of them are off: that is the bias.",
    "The bias comes from simulated logs, whose pole is known: the median estimate less that pole. They are simulated "
    "with the subspace model. So the bias of subspace is small by construction, and says little.",
)
_KNOWN = (
    "Calibrate alone starts from the robot's file, its numbers and their spreads. So its interval is narrow also "
    "because of that prior; the other methods get none."
)
_KNEW = "The twin that made this log has the very numbers of that file: such a prior cannot be wrong here."
_PREDICTIONS = (
    "Skill of the predictions on the held-out part of the log. The filter is the same for all models. Wheel: the mean "
    "of both encoders, relative to the body."
)
_STABLE = (
    "A model that is stable, though the robot is not, forgets an error of its start; a right one lets it grow. So a "
    "wrong model may predict better far ahead."
)


def _poles(compared: MethodComparison) -> list[Item]:
    known = [_KNOWN] if PRIOR in compared.models and len(compared.models) > 1 else []
    return [*_POLES, *known, *([_KNEW] if known and compared.judge.made_the_log else [])]


def _about_predictions(compared: MethodComparison) -> list[Item]:
    stable = any(m.pole.value <= 0 for m in compared.models.values())
    return [_PREDICTIONS, *([_STABLE] if stable else [])]


def _lead(compared: MethodComparison) -> str:
    """What was done, and what to run next."""
    fitted = compared.samples.fitted * compared.samples.dt
    done = (
        f"Each method fitted a model to the same {fitted:.2g} s of log. That model's regulator had to hold "
        f"{compared.judge.who}, let go at {math.degrees(HELD):.2g}°."
    )
    if len(compared.models) < 2:
        return done
    ranked = _ranked(compared)
    return f"{done} {_why(compared)} Next: {_next(compared)}" if ranked else done


def _why(compared: MethodComparison) -> str:
    """Why the best of those that hold the robot is best: how far each leans, and how close its pole is."""
    best, alike = _best(compared), _alike(compared)
    degrees = [cell_text(math.degrees(compared.trials[m].largest or 0.0), 3) for m in alike]
    if len(alike) < 2:
        return f"Under the regulator of {best} it leaned least, {degrees[0]}°."
    ends = " to ".join(dict.fromkeys((degrees[0], degrees[-1])))
    pole = compared.models[best].pole
    sure = f"; {best} knows the pole best" if math.isfinite(pole.high - pole.low) else ""
    return f"Under the regulators of {joined(alike)} it leaned about equally far ({ends}°){sure}."


SHORT = {
    "least-squares": "plain regression", "total-least-squares": "regression with noise in all states",
    "instrumental": "regression that noise does not bias", "subspace": "a model from the log alone",
    "calibrate": "corrects the robot's file",
}  # fmt: skip
"""What a method is, in a few words."""


def _next(compared: MethodComparison) -> str:
    command = again("upright identify LOG", "--method", "--output", "--controller")
    return (
        f"`{command} --method {_best(compared)} -o model.json -c regulator.json` writes that model and its regulator."
        f"{_without_file(compared)}"
    )


def _without_file(compared: MethodComparison) -> str:
    """What to take where the robot's file may be wrong, as a sentence with a space before it."""
    if _best(compared) != PRIOR or len(_ranked(compared)) < 2:
        return ""
    other = _best(compared, PRIOR)
    return f" {PRIOR.capitalize()} trusts the robot's file; if in doubt of it, take {other}, which needs the log alone."


def _about_trials(compared: MethodComparison) -> list[Item]:
    """How they were tried, what to take without the robot's file, and what the methods are."""
    words: list[Item] = [
        "Weights, filter noise and kit are the same for all; only the model differs. Tested on "
        f"{compared.judge.who}: held at {math.degrees(HELD):.2g}° for a second, then released for seven seconds."
    ]
    leans = {m: t.restless for m, t in compared.trials.items() if t.holds and t.restless is not None}
    if len(leans) > 1 and (calm := min(leans, key=lambda m: leans[m])) != _best(compared):
        words.append(
            f"At rest {calm} is calmest. But the largest lean decides, since a robot falls by it; between about equal "
            "leans, how well the pole is known."
        )
    return [*words, Details("What the methods are", [methods_table(compared)])]


def trial_table(compared: MethodComparison) -> Table:
    """The trial of each regulator."""
    rows: list[list[Cell]] = [
        [
            name,
            Verdict(str(t), "good" if t.holds else "bad"),
            *(None if x is None else math.degrees(x) for x in (t.largest, t.restless)),
        ]
        for name, t in compared.trials.items()
    ]
    return Table(
        ["method", "in the loop", "largest lean [°]", "rms at rest [°]"],
        rows,
        "Largest lean after the release, and its rms in the last two seconds",
        digits=3,
    )


def methods_table(compared: MethodComparison) -> Table:
    """What each method is."""
    caption = "Rebuilt states are angles and rates computed from the readings, with their noise"
    return Table(["method", "how"], [[name, TITLES.get(name, "")] for name in compared.trials], caption)


def pole_table(compared: MethodComparison) -> Table:
    """Unstable poles by method, with interval and bias."""
    rows: list[list[Cell]] = []
    for name, m in compared.models.items():
        rows.append(_pole_row(name, m))
        if m.pole.without_friction:
            value, low, high = m.pole.without_friction
            within = f"{cell_text(low, 3)} to {cell_text(high, 3)}"
            rows.append([f"{name}, without dry friction", value, within, "", None])
    if not math.isnan(compared.true_pole):
        rows.append(["the robot itself", compared.true_pole, "", "", None])
    header = ["method", "pole [1/s]", "95 % interval", "bias [1/s]", "pole − bias"]
    how = dict.fromkeys(m.pole.how for m in compared.models.values() if math.isfinite(m.pole.low))
    return Table(header, rows, "Unstable pole; intervals from the " + ", or the ".join(how), digits=3)


def _pole_row(name: str, model: Identified) -> list[Cell]:
    p = model.pole
    known = f"{cell_text(p.low, 3)} to {cell_text(p.high, 3)}" if math.isfinite(p.low) else "none"
    bias = _with_error(p.bias, 2 * p.bias_error) if math.isfinite(p.bias) else "–"
    return [name, p.value, known, bias, p.corrected]


def _with_error(value: float, error: float) -> str:
    """A value as far as its error tells its digits: two of the error."""
    if not (math.isfinite(error) and error > 0):
        return cell_text(value, 2)
    decimals = max(0, 1 - math.floor(math.log10(error)))
    return f"{round(value, decimals) + 0.0:.{decimals}f} ± {error:.{decimals}f}".replace("-", "−")


NEAR = 0.3  # from 1: the motions that a regulator has to know; faster ones fade within a few periods


def _eigenvalues(compared: MethodComparison) -> Figure:
    figure, ax = plane("real part [1]", "imaginary part [1]", circle=True)
    everything = {name: np.linalg.eigvals(m.halves["pitch"].A) for name, m in compared.models.items()}
    near = {name: values[np.abs(values - 1) < NEAR] for name, values in everything.items()}
    for k, (name, values) in enumerate(near.items()):
        points(ax, name, values.tolist(), size=5.0 + 2.0 * k)  # those that coincide stand round each other
    beyond = sum(len(values) for values in everything.values()) - sum(len(values) for values in near.values())
    drawn = np.concatenate([values - 1 for values in near.values()]) if near else np.zeros(0)
    reach = 1.3 * max(float(np.abs(drawn).max(initial=0.0)), 0.05)
    ax.set(xlim=(1 - reach, 1 + reach), ylim=(-reach, reach))
    unstable = [name for name, m in compared.models.items() if m.pole.value > 0]
    title = f"Eigenvalues over one period, near 1; {len(unstable)} of {len(near)} models have one outside the circle"
    note = f" {beyond} eigenvalues further away are not drawn." if beyond else ""
    return Figure(title, legend(figure), f"Of pitch and wheels.{note}")


def _predictions(compared: MethodComparison) -> list[Item]:
    horizons = list(next(iter(compared.models.values())).fits) if compared.models else []
    outputs = compared.samples.parts[0].outputs
    figure, axes = panels([f"skill for the {output} [%]" for output in outputs], "samples ahead", "log")
    for ax, output in zip(axes, outputs, strict=True):
        for name, m in compared.models.items():
            line(ax, name, [float(h) for h in m.fits], [fit.get(output, math.nan) for fit in m.fits.values()])
        ax.set_ylim(0, 100)
        for drawn in ax.lines:
            drawn.set(marker="o", markersize=4)
    axes[-1].set_xticks([float(h) for h in horizons], horizons)
    axes[-1].minorticks_off()
    note = "The lines join what was computed, at the marks. Skills below 0 are not drawn; the tables have them."
    drawing = Figure("Predictions of the held-out part", legend(figure), note)
    tables = [
        Table(
            ["samples ahead", *horizons],
            [[name, *(m.fits[h].get(output) for h in horizons)] for name, m in compared.models.items()],
            f"Skill for the {output} [%]; – where the prediction diverges",
            digits=3,
        )
        for output in outputs
    ]
    return [drawing, *tables]


def _orders(compared: MethodComparison) -> list[Item]:
    items: list[Item] = []
    for name, order in compared.orders.items():
        rows: list[list[Cell]] = [
            [float(n), value - min(order.bic.values()) if math.isfinite(value) else None, n == order.chosen]
            for n, value in order.bic.items()
        ]
        caption = f"Order of {name}: BIC above its least value, from {order.past} past rows"
        items.append(Table(["states", "BIC", "chosen"], rows, caption, digits=3))
        figure, (ax,) = panels(["singular value"], "number")
        ax.set_yscale("log")
        numbered(ax.yaxis)
        sizes = np.maximum(order.singular, 1e-300)
        ax.plot(np.arange(1, len(sizes) + 1), sizes, "o", fillstyle="none", label="left out")
        ax.plot(np.arange(1, order.chosen + 1), sizes[: order.chosen], "o", label="kept")
        title = f"Singular values of the prediction of {name}: {order.chosen} states are kept"
        items.append(Figure(title, legend(figure)))
    return items


def _failures(compared: MethodComparison) -> list[Item]:
    return [f"{name}: {why}" for name, why in compared.failed.items()]


def _delays(compared: MethodComparison) -> list[Item]:
    rows: list[list[Cell]] = [
        [output, float(count), count * part.dt * 1e3]
        for part in compared.samples.parts
        for output, count in zip(part.outputs, part.delays, strict=True)
    ]
    caption = "Delays from a command to the response, in whole periods, removed before any fit"
    return [Table(["output", "periods", "ms"], rows, caption)]
