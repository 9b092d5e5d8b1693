"""The documentation site: built without a warning, whole, and quiet: it asks no other host, from a folder too."""

from __future__ import annotations

import html
import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import pytest

import upright

pytestmark = [pytest.mark.needs("module:sphinx", "module:nbclient")]

ROOT = Path(__file__).parents[1]
LINK = re.compile(r'<(a|link|script|img|iframe|source|video)\b[^>]*?\b(href|src)="([^"]*)"')
SHOWN = (
    "index.html", "api.html", "how-to.html", "model.html", "excite.html", "firmware.html",
    "notebooks/3_lqg.html", "es/index.html", "es/notebooks/5_certificate.html",
)  # fmt: skip
NARROW = ("how-to.html", "model.html", "notebooks/3_lqg.html")
"""Of a phone: the widest commands, formulas, and figures with a lab between them."""


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The whole site, every notebook executed: in the folder `UPRIGHT_SITE`, where CI has built it; or else built."""
    if built := os.environ.get("UPRIGHT_SITE"):
        return Path(built)
    folder = tmp_path_factory.mktemp("site") / "site"
    command = [sys.executable, str(ROOT / "docs" / "build.py"), str(folder)]
    ran = subprocess.run(command, capture_output=True, text=True, timeout=1500, check=False)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    return folder


CUT = "[...document.querySelectorAll('.highlight-sh pre')].filter((block) => block.scrollWidth > block.clientWidth + 1)"


def links(page: Path) -> list[tuple[str, str]]:
    """Tag and target of every link of a page."""
    return [(tag, html.unescape(target)) for tag, _, target in LINK.findall(page.read_text("utf-8"))]


def test_every_link_leads_to_a_page_and_a_place_in_it(site: Path) -> None:
    pages = {page: set(re.findall(r'\bid="([^"]+)"', page.read_text("utf-8"))) for page in site.rglob("*.html")}
    assert len(pages) > 30
    assert site / "try" / "index.html" in pages
    broken: list[str] = []
    for page in pages:
        for _, target in links(page):
            path, _, place = target.partition("#")
            if "://" in path or path.startswith(("mailto:", "data:")):
                continue
            to = (page.parent / unquote(path.partition("?")[0])).resolve() if path else page
            found = not place or to not in pages or "=" in place or unquote(place) in pages[to]  # k=v sets a lab up
            if not (to.is_file() and found):
                broken.append(f"{page.relative_to(site)}: {target}")
    assert not broken


def test_no_page_and_no_style_asks_another_host(site: Path) -> None:
    """Only what a reader clicks may lead elsewhere."""
    tags = [(tag, target) for page in site.rglob("*.html") for tag, target in links(page)]
    assert not [target for tag, target in tags if tag != "a" and re.match(r"(https?:)?//", target)]
    styles = "".join(style.read_text("utf-8") for style in site.rglob("*.css"))
    assert not re.findall(r"(?:url\(|@import )[\"']?((?:https?:)?//[^\"')]+)", styles)


def test_the_reference_has_everything_that_the_package_offers(site: Path) -> None:
    page = (site / "api.html").read_text("utf-8")
    assert [name for name in upright.__all__ if f'id="upright.{name}"' not in page] == []


def test_notebooks_are_there_in_both_languages_without_answers(site: Path) -> None:
    for text in (ROOT / "notebooks").glob("[0-9]_*.py"):
        pictures: list[list[str]] = []
        for lang in ("en", "es"):
            folder = site / {"en": ".", "es": "es"}[lang] / "notebooks"
            other = {"en": "../es/notebooks", "es": "../../notebooks"}[lang]
            page = (folder / f"{text.stem}.html").read_text("utf-8")
            assert f'<html class="no-js" lang="{lang}"' in page
            assert {"en": "On this page", "es": "En esta página"}[lang] in page
            assert f'href="{other}/{text.stem}.html"' in page
            (taken,) = re.findall(r'href="([^"]*\.ipynb)"', page)
            cells = json.loads((folder / taken).read_text("utf-8"))["cells"]
            assert not [cell for cell in cells if "answer" in cell["metadata"].get("tags", ())]
            drawn = [out.get("data", {}).get("image/png") for cell in cells for out in cell.get("outputs", ())]
            pictures.append([png for png in drawn if png])
            assert "<img" in page
            assert ("<iframe" in page) == (text.stem in ("3_lqg", "6_own_robot"))
            assert len(json.dumps(cells)) < 1e6  # figures; a lab is a file beside
        assert 0 < len(pictures[0]) == len(pictures[1])
        assert not set(pictures[0]) & set(pictures[1])  # each has its language: the words are in test_language.py


def test_spanish_pages_are_reached_and_lead_back(site: Path) -> None:
    spanish = {page.relative_to(site / "es").as_posix() for page in (site / "es").rglob("*.html")}
    pages = {"index.html", "lab.html", "lesson.html", "notebooks/index.html"}
    assert pages <= spanish
    for page in pages:
        ways = {target for _, target in links(site / page)}
        assert f"{'../' * page.count('/')}es/{page}" in ways, page
        back = {target for _, target in links(site / "es" / page)}
        assert f"{'../' * page.count('/')}../{page}" in back, page
    assert "./../try/index.html#lang=es" in {target for _, target in links(site / "es" / "index.html")}
    assert "___" not in (site / "es" / "lesson.html").read_text("utf-8")  # a line to write on, as long as there is room


def test_the_download_is_what_pip_installs_from(site: Path) -> None:
    (link,) = {target for tag, target in links(site / "index.html") if tag == "a" and target.endswith("upright.zip")}
    names = zipfile.ZipFile(site / link).namelist()
    assert {"upright/pyproject.toml", "upright/README.md", "upright/LICENSE", "upright/src/upright/__init__.py"} <= set(
        names
    )
    assert not [name for name in names if "node_modules" in name or "__pycache__" in name]


@pytest.mark.needs("chromium", "module:playwright")
@pytest.mark.parametrize(
    ("width", "shown", "searched"),
    [pytest.param(1280, SHOWN, ("", "es"), marks=pytest.mark.evidence), (390, NARROW, ("es",))],
)
def test_in_a_browser_from_a_folder(
    site: Path, browser: Any, lend: Any, width: int, shown: tuple[str, ...], searched: tuple[str, ...]
) -> None:
    page = lend(browser, width, 900)
    for name in shown:
        page.goto((site / name).as_uri())
        assert page.evaluate("document.documentElement.scrollWidth") == width, name  # what is wide scrolls by itself
        assert page.evaluate(CUT) == [], name
    for folder in searched:  # each language has a search of its own
        page.goto((site / folder / "index.html").as_uri())
        page.locator(".sidebar-search").first.evaluate("(box) => { box.value = 'kalman'; box.form.submit(); }")
        page.wait_for_selector("#search-results li a[href^='notebooks/3_lqg']")
    page.goto((site / "model.html").as_uri())
    assert page.locator("article details").count()
    assert not page.locator("article details[open]").count()  # the depth, on demand
    assert not [url for url in page.asked if not url.startswith(("file:", "data:"))]
    assert not page.wrong


@pytest.mark.needs("chromium", "module:playwright", "npm")
@pytest.mark.parametrize(
    ("names", "scheme", "width"),
    [
        (SHOWN[-1:], "dark", 390),
        *(pytest.param(SHOWN, *how, marks=pytest.mark.evidence) for how in (("light", 1280), ("dark", 390))),
    ],
)
def test_axe_core_finds_nothing_serious_on_the_site(
    site: Path, browser: Any, lend: Any, axe: Path, names: tuple[str, ...], scheme: str, width: int
) -> None:
    page = lend(browser, width, 900, scheme=scheme)
    found: list[str] = []
    for name in names:
        page.goto((site / name).as_uri())
        page.add_script_tag(path=str(axe))
        for wrong in page.evaluate("axe.run().then((result) => result.violations)"):
            if wrong["impact"] in ("serious", "critical"):
                found += [f"{name}: {wrong['id']}: {node['html'][:200]}" for node in wrong["nodes"][:3]]
    assert not found
