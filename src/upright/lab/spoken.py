"""What the server says, in every language at once: the pages that show one session may be in several."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from upright.errors import UprightError
from upright.lab.message_types import ErrorParts, Head
from upright.languages import LANGUAGES, speaking
from upright.messages import in_language
from upright.pages import Next, Page, Say

T = TypeVar("T")


def in_each(say: Callable[[], T]) -> dict[str, T]:
    """What `say` makes of words, by language."""
    made: dict[str, T] = {}
    for language in LANGUAGES:
        with speaking(language):
            made[language] = say()
    return made


def heads_of(page: Page) -> dict[str, Head]:
    """The first screen of a page, but for its picture and what to do next."""

    def head() -> Head:
        verdict = page.verdict
        return Head(
            title=str(page.title), verdict=str(verdict.text) if verdict else "",
            level=verdict.level if verdict else "info", lead=tuple(map(str, page.lead)),
            numbers=tuple((str(number.value), str(number.meaning)) for number in page.numbers),
        )  # fmt: skip

    return in_each(head)


def parts_of(error: UprightError | Say) -> dict[str, ErrorParts]:
    """An error by its parts."""
    parts = error.parts if isinstance(error, UprightError) else {"came": error}
    hint = parts.get("hint")
    verb = hint.verb if isinstance(hint, Next) else ""
    return in_each(lambda: ErrorParts(**{name: in_language(str(part)) for name, part in parts.items()}, verb=verb))
