"""The page that is shipped: built from its source, small, self-sufficient, in two languages, readable to all."""

from __future__ import annotations

import gzip
import hashlib
import inspect
import json
import os
import re
from pathlib import Path

import pytest

from upright import pages
from upright.lab import typescript
from upright.lab.recording import MARK, inlined, page_text
from upright.loops import analysis_page, places

LAB = Path(__file__).resolve().parents[1] / "src" / "upright" / "lab"
WEB, STATIC = LAB / "web", LAB / "static"


def source_hash() -> str:
    """Of the page's source, as vite.config.ts writes it beside what it builds."""
    around = ("index.html", "package.json", "package-lock.json", "tsconfig.json", "vite.config.ts")
    files = [*(WEB / name for name in around), *(path for path in (WEB / "src").rglob("*") if path.is_file())]
    whole = hashlib.sha256()
    for name, path in sorted((path.relative_to(WEB).as_posix(), path) for path in files):
        whole.update(f"{name}\n".encode() + path.read_bytes())
    return whole.hexdigest()


def test_the_shipped_page_was_built_from_its_source():
    """After a change in web/: npm install && npm run build there."""
    assert (STATIC / "source.sha256").read_text("utf-8") == source_hash()


if BUILT := os.environ.get("UPRIGHT_WEB"):  # a copy of web/ in which CI has built the page

    def test_the_shipped_page_is_what_its_source_builds():
        fresh, shipped = (_contents(folder) for folder in (Path(BUILT).parent / "static", STATIC))
        assert fresh.keys() == shipped.keys()
        assert [name for name in fresh if fresh[name] != shipped[name]] == []


def _contents(folder: Path) -> dict[str, bytes]:
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_the_script_is_under_300_kb_gzipped():
    size = sum(len(gzip.compress(path.read_bytes(), 9)) for path in STATIC.rglob("*.js"))
    assert size < 300_000  # as promised


def test_the_page_names_its_own_files_alone():
    page = page_text()
    links = re.findall(r'(?:src|href)="([^"]+)"', page)
    assert all(link.startswith(("./assets/", "data:")) for link in links)
    assert MARK in page
    whole = inlined(page)
    assert not re.findall(r'<(?:script|link)[^>]*(?:src|href)="\./', whole)


def test_the_lock_file_names_no_registry():
    lock = json.loads((WEB / "package-lock.json").read_text("utf-8"))
    assert all("resolved" not in package for name, package in lock["packages"].items() if name)
    assert all("integrity" in package for name, package in lock["packages"].items() if name)


def shape(value: object) -> object:
    """The keys and lengths of a nest of texts, with how many placeholders each has."""
    if isinstance(value, dict):
        return {key: shape(item) for key, item in value.items()}
    if isinstance(value, list):
        return [shape(item) for item in value]
    assert isinstance(value, str)
    assert value.strip()
    return sorted(re.findall(r"\{\w+\}", value))


SHARED = {"hinf", "tabRobot", "tabKit", "preset", "doctor", "title", "tabPython", "install", "robotIs"}


def test_the_page_s_spanish_is_that_of_the_catalogue():
    """After a change of either: python -m upright.lab.typescript."""
    assert (typescript.TEXTS / "es.json").read_text("utf-8") == typescript.spoken("es")


def test_gains_by_hand_are_judged_in_the_words_of_every_design():
    """A page without Python computes their margins itself, but says what the page of a design says."""
    words = json.loads((WEB / "src" / "texts" / "en.json").read_text("utf-8"))["loopSaid"]
    sources = [inspect.getsource(module) for module in (analysis_page, places, pages.words)]
    assert [text for text in words.values() if not any(f'"{text}"' in source for source in sources)] == []


def test_both_languages_say_the_same_things():
    english, spanish = (json.loads((WEB / "src" / "texts" / f"{key}.json").read_text("utf-8")) for key in ("en", "es"))
    assert shape(english) == shape(spanish)
    assert len(english["tour"]) == 9
    same = [key for key in english if isinstance(english[key], str) and english[key] == spanish[key]]
    same += [a for one, other in zip(english["tour"], spanish["tour"], strict=True) for a in one if one[a] == other[a]]
    assert set(same) <= SHARED  # words that both languages share


def test_colours_have_enough_contrast_for_wcag_aa():
    """Text of any size: 4.5 to 1 (WCAG 2.2, 1.4.3); lines of charts: 3 to 1 (1.4.11)."""
    css = (WEB / "src" / "style.css").read_text("utf-8")
    light, dark = re.findall(r"(?::root|:root\[data-theme=\"dark\"\]) \{(.*?)\n\}", css, re.DOTALL)[:2]
    palette = (WEB / "src" / "palette.ts").read_text("utf-8")
    lanes = re.findall(r"const (?:LIGHT|DARK)[^{]*\{(.*?)\};", palette, re.DOTALL)
    for block, lines in zip((light, dark), lanes, strict=True):
        colour = dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6})", block))
        for text in ("ink", "soft", "accent", "good", "bad", "push", "warn"):
            for ground in ("card", "paper"):
                assert contrast(colour[text], colour[ground]) >= 4.5, (text, ground)
        assert contrast(colour["on-accent"], colour["accent"]) >= 4.5
        for line in re.findall(r"#[0-9a-f]{6}", lines):
            assert contrast(line, colour["card"]) >= 3, line


def contrast(one: str, other: str) -> float:
    """The ratio of relative luminances (WCAG 2.2)."""
    first, second = sorted((luminance(one), luminance(other)), reverse=True)
    return (first + 0.05) / (second + 0.05)


def luminance(colour: str) -> float:
    parts = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def test_contrast_is_computed_as_the_standard_says():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)  # the standard's largest
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)  # the well-known grey that just fails
