"""The words of a page that need a line of explanation: each is defined here, once. It is a link where a page first uses
it, and the definitions stand at the foot."""

from __future__ import annotations

import re
from html import escape, unescape

TERMS: dict[str, tuple[str, str]] = {
    r"twins?": ("twin", "A simulation by a physics engine (MuJoCo) that stands in for hardware. Its equations are not "
        "those of the model under test. Results of a twin are not results of a real robot."),
    r"nonlinear": ("nonlinear", "The full equations of motion, with the "
        "sine and cosine of the lean."),
    r"linear": ("linear", "The equations near the upright rest, where sines are "
        "replaced by angles."),
    r"kit": ("kit", "The electronics of a robot: sensors with their noise and delay, motors with their "
        "limits, and the period of the controller."),
    r"(?<![\d)] )R²": ("R²", "1: predicted exactly. 0: no better than the mean of the readings."),
    r"fits?": ("fit", "100 (1 − rms error / standard deviation). 100 %: the curves are equal. 0 %: no better than the "
        "mean."),
    r"[Ss]kill": ("skill", "100 (1 − rms error / rms error of a guess): of an angle that it stays, of a rate that it "
        "has its mean. 100 %: predicted exactly. 0 %: no better than that guess."),
    r"innovations?": ("innovation", "What a sensor reads, less what the filter expected."),
    r"NIS": ("NIS", "Mean of the squared innovations over what the filter expects; 1 is usual."),
    r"Ms": ("Ms", "Peak of the sensitivity: 1 over the least distance of the Nyquist curve from −1. Usual target: at "
        "most 2."),
    r"Mt": ("Mt", "Peak of the complementary sensitivity: the largest gain of the closed loop."),
    r"disk α": ("disk α", "Size of a disk of gains and phases at once that the loop survives; 2 is the most."),
    r"b\(P, C\)": ("b(P, C)", "Stability margin of the normalised coprime factors, from 0 to 1. It depends on how "
        "readings and commands are scaled, so that it may be small in a sound loop."),
    r"hold at": ("hold", "A constant force that leans the robot, until it lets go."),
    r"certificate": ("certificate", "What `upright certify` writes: robots within the uncertainty are pushed, and "
        "those that fall are counted. It is green only where at most 5 % may fall."),
    r"NRMSE": ("NRMSE", "Root mean square error over the standard deviation; the fit is 100 % less that."),
    r"ν-gap": ("ν-gap", "How different two robots are for a controller: 0 the same, 1 not comparable."),
    r"Nyquist": ("Nyquist curve", "The gain of the open loop in the complex plane. Far from −1 the loop has large "
        "margins."),
    r"[Bb]ode": ("Bode diagram", "Gain and phase of the open loop over the frequency."),
    r"gain crossover": ("gain crossover", "The frequency at which the gain of the open loop is 1."),
    r"phase margins?": ("phase margin", "The least turn of the loop's phase that makes it unstable, a lag or a lead. "
        "Usual target: at least 30°."),
    r"gain margins?": ("gain margin", "By what factor the motors may be weaker or stronger. Usual target: half "
        "to double."),
    r"delay margin": ("delay margin", "How much later a reading or a command may come, before the loop is "
        "unstable. Usual target: at least one period."),
    r"unstable poles?": ("unstable pole", "The rate at which a small lean grows: it doubles "
        "in 0.69 / pole."),
    r"N s": ("N s", "Newton second: force times duration. 0.2 N s is a push of 10 N for 20 ms."),
    r"knocks?|knocked": ("knock", "A push so short that only its impulse counts [N s]."),
    r"dead zone": ("dead zone", "The largest command that does not move the motor."),
    r"[Cc]oulomb friction": ("Coulomb friction", "Dry friction: of one size at every speed, against the motion."),
    r"roll fraction": ("roll fraction", "The body's roll inertia, as a fraction of the range that its pitch and yaw "
        "inertias allow."),
    r"multisine": ("multisine", "A sum of sines, so that one run excites many frequencies."),
    r"lqr": ("lqr", "Linear quadratic regulator: the state feedback that is optimal for a quadratic cost."),
    r"lqi": ("lqi", "An lqr with an integrator, so that the robot returns to its place."),
    r"lqg": ("lqg", "Linear quadratic regulator (lqr) of the state that a Kalman filter estimates."),
    r"pid": ("pid", "Proportional, integral and derivative gains on pitch and wheels."),
    r"hinf": ("hinf", "H∞ control: keeps the largest gain small, from disturbances and sensor errors to state and "
        "command."),
    r"mpc": ("mpc", "Model predictive control: plans each command some periods ahead, within the motors' limits."),
    r"sliding": ("sliding", "Sliding mode: drives the state onto a surface on which it comes to rest."),
    r"robust": ("robust", "State feedback that is stable for all robots of the spreads at once."),
    r"BIC": ("BIC", "Bayesian information criterion: the model with the smallest one is best."),
    r"effort": ("effort", "Integral of the squared commands of both motors: how hard they work."),
    r"saturated": ("saturated", "A command larger than the motors can follow."),
    r"rms|RMS": ("rms", "Root of the mean square: the usual size of what swings."),
    r"dithers?": ("dither", "A small signal added to the commands, so that a log shows more."),
}  # fmt: skip
"""Pattern in the text → the term and its definition."""
SILENT = ("svg", "code", "script", "dd", "li", "h1", "h2", "summary", "a", "title", "math", "pre", "output", "th")
"""In these a term is not marked as a link."""
_TAG = re.compile(r"(<[^>]*>)")


Term = tuple[str, str, str]
"""A term, its definition, and the name of its place."""


def explained(markup: str, twin: bool = True, more: str = "") -> tuple[str, list[Term], list[Term]]:
    """HTML with the first use of each term as a link to its definition; the terms that are seen at once; and those that
    only folded parts use. `twin` tells whether "twin" is one of them; `more` is further text of the page."""
    used = [(pattern, *term) for pattern, term in _used(f"{markup} {more}").items() if twin or term[0] != "twin"]
    anchors = {name: "word-" + re.sub(r"\W+", "-", name) for _, name, _ in used}
    left = {re.compile(_whole(pattern)): (name, meaning) for pattern, name, meaning in used}
    inside: list[str] = []
    parts = _TAG.split(markup)
    for k, part in enumerate(parts):
        if k % 2:
            _follow(part, inside)
        elif not inside:
            text = part
            for pattern, (name, meaning) in list(left.items()):
                link = f'<a class="term" href="#{anchors[name]}" title="{escape(meaning)}">\\g<0></a>'
                text, marked = _outside(text, pattern, link)
                if marked:
                    del left[pattern]
            parts[k] = text
    words = sorted({name: meaning for _, name, meaning in used}.items(), key=lambda term: term[0].lower())
    open_ones = {name for name, _ in _used(f"{_unfolded(markup)} {more}").values()}
    terms = [(name, meaning, anchors[name]) for name, meaning in words]
    return "".join(parts), [t for t in terms if t[0] in open_ones], [t for t in terms if t[0] not in open_ones]


def _unfolded(markup: str) -> str:
    """The HTML without what is folded: of each <details> its summary stays."""
    kept: list[str] = []
    depth, summary = 0, False
    for part in _TAG.split(markup):
        depth -= part == "</details>"
        summary = depth == 1 and (part.startswith("<summary") or (summary and part != "</summary>"))
        if not depth or summary:
            kept.append(part)
        depth += part.startswith("<details")
    return "".join(kept)


def _outside(text: str, pattern: re.Pattern[str], link: str) -> tuple[str, int]:
    """The first place of a pattern replaced, but not inside a link that was put there before."""
    pieces = re.split(r"(<a .*?</a>)", text)
    for k in range(0, len(pieces), 2):
        pieces[k], count = pattern.subn(link, pieces[k], count=1)
        if count:
            return "".join(pieces), 1
    return text, 0


def _follow(tag: str, inside: list[str]) -> None:
    """Keep the stack of open elements of one name in which nothing is marked."""
    match = re.match(r"</?(\w+)", tag)
    name = match[1] if match and not tag.endswith("/>") else ""
    silent = name == inside[0] if inside else name in SILENT or 'class="badge' in tag
    if silent and tag.startswith("</"):
        del inside[-1:]
    elif silent:
        inside.append(name)


def _used(markup: str) -> dict[str, tuple[str, str]]:
    text = unescape(_TAG.sub(" ", re.sub(r"<(title|desc|pre|math)\b.*?</\1>", " ", markup, flags=re.DOTALL)))
    return {pattern: term for pattern, term in TERMS.items() if re.search(_whole(pattern), text)}


def _whole(pattern: str) -> str:
    """The pattern as whole words, whatever kind of space stands between them."""
    return rf"(?<![\w-])(?:{pattern.replace(' ', chr(92) + 's')})(?![\w-])"
