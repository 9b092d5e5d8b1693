"""A table's cells as text, the same on every screen."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from upright.languages import localised, number
from upright.pages.blocks import Cell, Column, Table, Verdict
from upright.pages.words import Say, shown_in, text_of


@dataclass(frozen=True)
class Text:
    """A cell as text; a number stands to the right, a verdict has its `level`."""

    text: str
    is_number: bool = False
    level: str = ""


def heading_of(column: Column, cells: Sequence[Cell]) -> str:
    """A column's name, with the unit in which its floats are shown in brackets."""
    _, unit = shown_in(column.unit, _largest(cells))
    return f"{column.name} [{unit}]" if unit else str(column.name)


def texts_of(column: Column, cells: Sequence[Cell]) -> list[Text]:
    """The cells of a column; its floats have equal decimals."""
    factor, _ = shown_in(column.unit, _largest(cells))
    floats = [factor * cell for cell in cells if isinstance(cell, float) and math.isfinite(cell)]
    decimals = _decimals(floats, column.digits)
    return [_text(cell, factor, decimals, column.digits) for cell in cells]


def columns_of(table: Table) -> list[tuple[str, list[Text]]]:
    """Heading and texts of each column in which any row has something."""
    by_column = [[row[k] for row in table.rows] for k in range(len(table.columns))]
    return [
        (heading_of(column, cells), texts_of(column, cells))
        for column, cells in zip(table.columns, by_column, strict=True)
        if any(cell is not None for cell in cells)
    ]


def _largest(cells: Sequence[Cell]) -> float:
    return max((abs(cell) for cell in cells if isinstance(cell, float) and math.isfinite(cell)), default=math.nan)


def _decimals(values: Sequence[float], digits: int) -> int | None:
    """As many decimals as the largest number needs; None where powers of ten are plainer."""
    sizes = [abs(value) for value in values if value]
    if not sizes or max(sizes) >= 1e5 or min(sizes) < 10.0**-digits * max(sizes) or max(sizes) < 1e-3:
        return None
    needed = digits - 1 - math.floor(math.log10(max(sizes)))
    shown = [f"{size:.{digits}g}".partition(".")[2] for size in sizes]
    return max(0, min(needed, max(map(len, shown))))


def _text(cell: Cell, factor: float, decimals: int | None, digits: int) -> Text:
    if isinstance(cell, Verdict):
        return Text(str(cell.text), level=cell.level)
    if isinstance(cell, bool):
        return Text(str(Say("yes") if cell else Say("no")))
    if cell is None:
        text = "–"
    elif isinstance(cell, float):
        plain = decimals is None or not math.isfinite(cell)
        text = number(factor * cell, digits) if plain else localised(f"{factor * cell:.{decimals}f}")
    else:
        text = text_of(cell)
    return Text(text, is_number=not isinstance(cell, str | Say))
