"""Terminal, page and notebook of a result say the same, in both languages."""

from __future__ import annotations

import json
import re

from upright.languages import speaking
from upright.pages import Result
from upright.pages.html import document


def shown_alike(result: Result) -> None:
    """Fail where terminal, page and notebook lack a number of the head, where the terminal is wider than 80 columns, or
    where Spanish has other numbers."""
    json.dumps(result.to_json(), allow_nan=False)
    values = [value for value, _ in result.page().head()["numbers"]]
    assert values
    for rendered in (str(result), document(result.page()), result._repr_html_()):
        assert all(value.replace("\u00a0", " ") in rendered.replace("\u00a0", " ") for value in values)
    lines = [line for line in str(result).splitlines() if not line.startswith("  `upright ")]  # whole, to be copied
    assert max(map(len, lines)) <= 80
    english = str(result).partition("\n\n")[0]
    with speaking("es"):
        spanish = str(result).partition("\n\n")[0]
    assert spanish != english
    assert re.findall(r"\d+", spanish) == re.findall(r"\d+", english)
