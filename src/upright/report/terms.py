"""The words of a page that need a line of explanation: each is defined here, once, and stands at the foot of the pages
that use it."""

from __future__ import annotations

import re
from html import unescape

TERMS: dict[str, tuple[str, str]] = {
    r"twins?": ("twin", "A simulation by a physics engine that stands in for hardware. Its equations are not those of "
        "the model under test. Results of a twin are not results of a real robot."),
    r"R²": ("R²", "1: predicted exactly. 0: no better than the mean of the readings."),
    r"fits?": ("fit", "100 (1 − rms error / standard deviation). 100 %: the curves are equal. 0 %: no better than the "
        "mean."),
    r"innovations?": ("innovation", "What a sensor reads, less what the filter expected."),
    r"NIS": ("NIS", "Mean of the squared innovations over what the filter expects; 1 is usual."),
    r"Ms": ("Ms", "Peak of the sensitivity: 1 over the least distance of the Nyquist curve from −1. Usual target: at "
        "most 2."),
    r"Nyquist": ("Nyquist curve", "The gain of the open loop in the complex plane. Far from −1 the loop has large "
        "margins."),
    r"phase margin": ("phase margin", "How much later the loop may answer, as an angle. Usual target: at least 30°."),
    r"gain margin": ("gain margin", "By what factor the motors may be weaker or stronger."),
    r"delay margin": ("delay margin", "How much later a reading or a command may come, before the loop is unstable."),
    r"unstable poles?": ("unstable pole", "The rate at which a small lean grows: it doubles in 0.69 / pole."),
    r"N s": ("N s", "Newton second: force times duration. 0.2 N s is a push of 10 N for 20 ms."),
    r"dead zone": ("dead zone", "The largest command that does not move the motor."),
    r"[Cc]oulomb friction": ("Coulomb friction", "Dry friction: of one size at every speed, against the motion."),
    r"multisine": ("multisine", "A sum of sines, so that one run excites many frequencies."),
    r"lq[gr]|LQ[GR]": ("lqr, lqg", "State feedback that is optimal for a quadratic cost; lqg adds a Kalman filter."),
    r"BIC": ("BIC", "Bayesian information criterion: of several models the least is the best."),
}  # fmt: skip
"""Pattern in the text → the term and its definition."""


def terms_of(markup: str) -> list[tuple[str, str]]:
    """The terms that the text of some HTML uses, each with its definition."""
    text = unescape(re.sub(r"<[^>]*>", " ", re.sub(r"<(title|desc)\b.*?</\1>", " ", markup, flags=re.DOTALL)))
    return [term for pattern, term in TERMS.items() if re.search(rf"(?<!\w)(?:{pattern})(?!\w)", text)]
