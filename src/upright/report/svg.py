"""Small parts of a drawing: numbers as text, ticks, decimation, elements. Everything is text, and deterministic."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from html import escape

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

COLOURS = 6
DASHES = 7
MARKERS = ("cross", "circle", "square", "triangle", "diamond")


def num(value: float) -> str:
    """A coordinate rounded to 2 decimals, without trailing zeros."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def element(tag: str, content: str | None = None, **attributes: str | float) -> str:
    """An element; an attribute is written with '-' for '_' and without its trailing '_'. `content` is markup."""
    pairs = ((name.rstrip("_").replace("_", "-"), value) for name, value in attributes.items())
    text = "".join(f' {name}="{escape(v) if isinstance(v, str) else num(v)}"' for name, v in pairs)
    return f"<{tag}{text}/>" if content is None else f"<{tag}{text}>{content}</{tag}>"


def label(text: str, x: float, y: float, anchor: str = "start", class_: str = "tick") -> str:
    """Escaped text at a point."""
    return element("text", escape(text), x=x, y=y, text_anchor=anchor, class_=class_)


def style_class(index: int) -> str:
    """The colour and dash classes of trace number `index`; they repeat together only after 42."""
    return f"c{index % COLOURS} d{index % DASHES}"


def nice_ticks(low: float, high: float, count: int) -> list[float]:
    """About `count` round numbers inside [low, high], a step of 1, 2 or 5 times a power of ten apart."""
    raw = (high - low) / max(count, 1)
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= raw * (1 - 1e-9))
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [n * step for n in range(first, last + 1)]


def tick_texts(ticks: list[float]) -> list[str]:
    """The ticks as text with the same number of decimals and a true minus sign; powers of ten beyond 10⁴ or 10⁻⁴."""
    step = ticks[1] - ticks[0] if len(ticks) > 1 else abs(ticks[0]) if ticks else 1.0
    largest = max((abs(tick) for tick in ticks), default=0.0)
    decimals = max(0, -math.floor(math.log10(step) + 1e-9)) if step else 0
    plain = decimals <= 4 and largest < 1e5
    texts = (f"{tick + 0.0:.{decimals}f}" if plain else f"{tick:.3g}" for tick in ticks)
    return [("0" if float(text) == 0 else text).replace("-", "−") for text in texts]


def padded(values: Array, margin: float = 0.06) -> tuple[float, float]:
    """The range of the finite values, widened by `margin` of itself; one around a constant, [0, 1] around nothing."""
    finite = values[np.isfinite(values)]
    if len(finite) == 0:
        return 0.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    spread = high - low
    if spread <= 1e-9 * max(abs(low), abs(high)):
        pad = 0.5 * abs(low) or 1.0
        return low - pad, high + pad
    return low - margin * spread, high + margin * spread


def finite_runs(x: Array, y: Array) -> Iterator[tuple[Array, Array]]:
    """The stretches between samples that are not finite: a line must not bridge what is not there."""
    good = np.isfinite(x) & np.isfinite(y)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], good, [False]]).astype(np.int8)))
    for start, stop in edges.reshape(-1, 2):
        yield x[start:stop], y[start:stop]


def decimate(x: Array, y: Array, columns: int) -> tuple[Array, Array]:
    """Keep the first, smallest, largest and last sample of each of `columns` equal parts of x, which looks the same.

    Few samples, and an x that does not increase, come back as they are.
    """
    if len(x) <= 4 * columns or (np.diff(x) <= 0).any():
        return x, y
    column = np.minimum((x - x[0]) / (x[-1] - x[0]) * columns, columns - 1).astype(int)
    starts = np.flatnonzero(np.diff(column, prepend=-1))
    keep: set[int] = set()
    for start, stop in zip(starts, np.append(starts[1:], len(x)), strict=True):
        part = y[start:stop]
        keep |= {int(start), int(start + part.argmin()), int(start + part.argmax()), int(stop - 1)}
    rows = sorted(keep)
    return x[rows], y[rows]


def stairs(x: Array, y: Array) -> tuple[Array, Array]:
    """The corners of a value that holds from its sample to the next."""
    return np.repeat(x, 2)[1:], np.repeat(y, 2)[:-1]


@dataclass(frozen=True)
class Scale:
    """The straight line from [low, high] in a signal's unit to [start, stop] in the drawing's."""

    low: float
    high: float
    start: float
    stop: float

    def __call__(self, value: float) -> float:
        return self.start + (value - self.low) / (self.high - self.low) * (self.stop - self.start)

    def many(self, values: Array) -> Array:
        """The same for an array."""
        return self.start + (values - self.low) / (self.high - self.low) * (self.stop - self.start)


def points(x: Array, y: Array) -> str:
    """The `points` of a polyline."""
    return " ".join(f"{num(a)},{num(b)}" for a, b in zip(x.tolist(), y.tolist(), strict=True))


def marker(shape: str, x: float, y: float, class_: str, r: float = 5.0) -> str:
    """A hollow marker of `shape`, one of `MARKERS`, about a point."""
    west, east, north, south, x_, y_ = (num(v) for v in (x - r, x + r, y - r, y + r, x, y))
    corners = {
        "cross": f"M{west} {north}L{east} {south}M{west} {south}L{east} {north}",
        "square": f"M{west} {north}H{east}V{south}H{west}Z",
        "triangle": f"M{x_} {north}L{east} {south}H{west}Z",
        "diamond": f"M{x_} {north}L{east} {y_}L{x_} {south}L{west} {y_}Z",
    }
    classes = f"mark {class_}"
    if shape == "circle":
        return element("circle", cx=x, cy=y, r=r, class_=classes)
    return element("path", d=corners[shape], class_=classes)
