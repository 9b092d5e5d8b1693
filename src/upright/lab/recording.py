"""A recording: the same messages with their time, in a page that replays them without a server."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from importlib import resources
from pathlib import Path
from typing import Any

from upright.atomic import write_text
from upright.errors import MissingTool
from upright.lab.codec import plain

FILES = {
    "csv": "run.csv", "parquet": "run.parquet", "report": "report.html", "compare": "compare.html",
    "replay": "replay.html", "controller": "controller.json", "robot": "robot.toml", "handin": "hand-in.json",
}  # fmt: skip
"""What is kept of a session, and under which name."""

MOMENT = 0.02
"""[s] between two pictures of a replay."""

MARK = "<!-- recording -->"
"""Where the page takes a recording."""


def replay_page(messages: Sequence[Any], path: Path) -> Path:
    """Write the page with its script, style and `messages` inside."""
    page = inlined(page_text())
    data = [plain(m) for m in messages]
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    return write_text(path, page.replace(MARK, f'<script type="application/json" id="recording">{text}</script>'))


def static() -> Any:
    """The folder of built files."""
    return resources.files("upright.lab") / "static"


def page_text() -> str:
    """The built page; raises `MissingTool` in a checkout where nobody has built it."""
    index = static() / "index.html"
    if not index.is_file():
        raise MissingTool("the lab's page has not been built", hint="npm install, npm run build in src/upright/lab/web")
    return index.read_text(encoding="utf-8")


def inlined(page: str) -> str:
    """The page with every script and style sheet inside it."""

    def script(match: re.Match[str]) -> str:
        code = _read(match[1]).replace("</script", "<\\/script")
        return f'<script type="module">{code}</script>'

    page = re.sub(r'<link rel="modulepreload"[^>]*>', "", page)
    page = re.sub(r'<script type="module"[^>]*src="([^"]+)"[^>]*></script>', script, page)
    return re.sub(r'<link rel="stylesheet"[^>]*href="([^"]+)"[^>]*>', lambda m: f"<style>{_read(m[1])}</style>", page)


def _read(link: str) -> str:
    return (static() / link.removeprefix("./")).read_text(encoding="utf-8")
