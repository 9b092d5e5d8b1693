"""What a command prints first, its page shows first and its JSON has as its head: read from all three, and compared."""

from __future__ import annotations

import html
import json
import re
from typing import Any

from upright.languages import speaking
from upright.pages import Result
from upright.pages.html import document


def plain(text: str) -> str:
    """Words as they are read: without tags, code's backticks, and one space between them."""
    return " ".join(html.unescape(re.sub(r"<[^>]+>", "", text)).replace("`", "").split())


def first_screen(page: str) -> tuple[str, str, list[tuple[str, str]], str]:
    """Level and text of the verdict, the numbers and what is next, as the page's markup has them."""
    top = page[page.index("<header>") : page.index("</header>")]
    badge = re.search(r'<p class="badge (\w+)">(.*?)</p>', top)
    numbers = re.findall(r"<dt>(.*?)</dt><dd[^>]*>(.*?)</dd>", top, re.DOTALL)
    after = re.search(r'<p class="next"><strong>Next</strong>(.*?)</p>', top, re.DOTALL)
    level, text = badge.groups() if badge else ("", "")
    return level, plain(text), [(plain(n), plain(m)) for m, n in numbers][:3], plain(after[1]) if after else ""


def begins_as(printed: str, head: dict[str, Any], page: str) -> None:
    """Fail where what is printed, the head of the JSON and the page differ; what is next may, by the command."""
    level, verdict, numbers, after = first_screen(page)
    lines = printed.split("\n\n", maxsplit=1)[0].split("\n")
    assert max(map(len, lines)) <= 80
    top = plain("\n".join(lines))
    assert numbers
    assert (head["verdict"] or {"level": "", "text": ""}) == {"level": level, "text": verdict}
    assert [(plain(value), plain(meaning)) for value, meaning in head["numbers"]] == numbers
    assert top.startswith(f"Verdict: {verdict} " if verdict else plain(head["title"]))
    assert [n for n in numbers if f" {n[0]} {n[1]}" not in top] == []
    after = after.replace(" --json", "")  # of a page that was written beside JSON
    assert top.endswith(f"Next: {after}" if after else " ".join(numbers[-1]))


def shown_alike(result: Result) -> None:
    """Fail where terminal, page and notebook lack a number of the head, where the terminal is wider than 80 columns, or
    where Spanish has other numbers."""
    json.dumps(result.to_json(), allow_nan=False)
    values = [value for value, _ in result.page().head()["numbers"]]
    assert values
    for rendered in (str(result), document(result.page()), result._repr_html_()):
        assert all(value.replace("\u00a0", " ") in rendered.replace("\u00a0", " ") for value in values)
    assert max(map(len, str(result).splitlines())) <= 80
    english = str(result).partition("\n\n")[0]
    with speaking("es"):
        spanish = str(result).partition("\n\n")[0]
    assert spanish != english
    assert re.findall(r"\d+", spanish) == re.findall(r"\d+", english)
