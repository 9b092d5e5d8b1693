"""What a command prints first, its page shows first and its JSON has as its head: read from all three, and compared."""

from __future__ import annotations

import html
import re
from typing import Any


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
