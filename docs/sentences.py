"""What a page of the site says, in parts that have an address, for the search: it shows the sentence that it found."""

from __future__ import annotations

from html.parser import HTMLParser

MUTE = {"script", "style", "pre", "svg", "iframe", "nav"}
"""What is no sentence."""
VOID = {"area", "br", "col", "hr", "img", "input", "link", "meta", "source", "wbr"}
BLOCKS = {"p", "li", "dd", "dt", "h1", "h2", "h3", "h4", "h5", "div", "summary", "section", "blockquote", "tr"}
CELLS = {"td", "th"}
SHORTEST = 4  # letters of a line that says something


class _Reader(HTMLParser):
    """The text of the article alone, cut at each element that has an id."""

    def __init__(self) -> None:
        super().__init__()
        self.parts: list[tuple[str, list[str]]] = []
        self.inside: list[str] = []
        self.mute = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        if not self.inside and given.get("role") != "main":
            return
        if tag in BLOCKS and self.parts and "tr" not in self.inside:
            self.parts[-1][1].append("\n")
        if tag in CELLS and self.parts:
            self.parts[-1][1].append(" · ")
        if tag in VOID:
            return
        self.inside.append(tag)
        if given.get("id") and not self.mute:
            self.parts.append((given["id"], []))
        if self.mute or tag in MUTE or {"headerlink", "sig", "caption"} & {*given.get("class", "").split()}:
            self.mute += 1

    def handle_endtag(self, tag: str) -> None:
        if not self.inside or tag in VOID:
            return
        self.inside.pop()
        self.mute = max(0, self.mute - 1)

    def handle_data(self, data: str) -> None:
        if self.inside and not self.mute and self.parts:
            self.parts[-1][1].append(data.replace("\n", " "))


def parts_of(page: str) -> list[tuple[str, str]]:
    """Each part of a page with words: the id of its place, and its text, one line for each paragraph."""
    reader = _Reader()
    reader.feed(page)
    lines = [
        (place, [" ".join(line.split()).strip(" ·") for line in "".join(text).split("\n")])
        for place, text in reader.parts
    ]
    whole = [(place, "\n".join(line for line in text if len(line) >= SHORTEST)) for place, text in lines]
    return [(place, text) for place, text in whole if text]
