"""Makes docs/lab.webp, the moving picture of the lab, its Spanish one, and pictures of three tabs:
`python docs/lab_picture.py [NAME …]`, by default all.

To be run after a change of the page: each picture keeps the words that it shows, and `tests/test_docs.py` compares them
with the words of the page. Needs Chromium and Playwright. The page is paused and stepped, so that a slow machine makes
the same picture.
"""

from __future__ import annotations

import io
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from PIL import Image
from playwright.sync_api import sync_playwright

from upright.atomic import write_bytes
from upright.lab.export import export

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
EVERY = 8  # periods of 10 ms between two pictures
PICTURES = 56
WIDTH = 800  # [px] of the picture
KNOCK = 0.12  # [N s], as the slider beside the button shows it
SLIDE = "(slider, size) => { slider.value = size; slider.dispatchEvent(new Event('input')); }"
RUNNING = "(words) => { document.querySelector('[data-key=pause]').textContent = words; }"
"""The button as it is while the robot moves: here the page is paused, and goes on step by step."""
HERE = Path(__file__).resolve().parent


PLACES = {"lab.webp": "en", "lab.es.webp": "es"}


TABS = ("controller", "see", "identify")
"""Of each a picture tab-NAME.webp, and tab-NAME.es.webp."""
DESCRIPTION = 0x010E  # of EXIF: what a picture shows


def texts(language: str) -> dict[str, Any]:
    """The words of the page."""
    words: dict[str, Any] = json.loads(
        (HERE.parent / f"src/upright/lab/web/src/texts/{language}.json").read_text("utf-8")
    )
    return words


def described(page: Any) -> Image.Exif:
    """The lines of words that are seen on the page, as the description of its picture."""
    lines = page.evaluate("document.querySelector('#app').innerText.split('\\n')")
    exif = Image.Exif()
    exif[DESCRIPTION] = json.dumps([line.strip() for line in lines if re.search(r"[^\W\d_]{3}", line)])
    return exif


def film(language: str, target: Path) -> None:
    """The lab, knocked forward and back."""
    pictures: list[Image.Image] = []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        page_file = export(folder, ["nxtway-gs"], ["lqg"])
        browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        page = browser.new_page(viewport={"width": 1200, "height": 675}, locale=language)
        page.goto(page_file.as_uri())
        page.wait_for_selector("canvas.room")  # which takes the side view's place
        page.eval_on_selector("[data-key=knock]", SLIDE, KNOCK)
        page.evaluate("upright.store.send({ kind: 'Step', periods: 200 })")
        for k in range(PICTURES):
            if k in (6, 34):
                size = KNOCK if k == 6 else -KNOCK
                page.evaluate(f"upright.store.send({{ kind: 'Strike', what: 'impulse', size: {size} }})")
            page.evaluate(f"upright.store.send({{ kind: 'Step', periods: {EVERY} }})")
            page.evaluate("document.querySelector('.toasts').replaceChildren()")
            page.evaluate(RUNNING, texts(language)["pause"])
            page.wait_for_timeout(150)  # for the room and the traces, which are drawn 20 times a second
            shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            pictures.append(shot.resize((WIDTH, round(WIDTH * shot.height / shot.width)), Image.Resampling.LANCZOS))
        words = described(page)
        browser.close()
    first, *others = pictures
    made = io.BytesIO()
    first.save(
        made, "webp", save_all=True, append_images=others, duration=10 * EVERY, loop=0, quality=55, method=6, exif=words
    )
    _write(target, made)


def _write(target: Path, made: io.BytesIO) -> None:
    write_bytes(target, made.getvalue())
    print(f"wrote {target}: {target.stat().st_size / 1e3:.0f} kB", flush=True)


@contextmanager
def live() -> Iterator[str]:
    """A live lab of this machine, and its address."""
    command = [sys.executable, "-m", "upright", "lab", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as lab:
        try:
            yield next(found[0] for line in lab.stdout or () if (found := re.search(r"http://\S+", line)))
        finally:
            lab.terminate()


def tabs(language: str, names: list[str]) -> None:
    """Pictures of tabs of the live lab, each with what it needs: the certificate, a curve, what the doctor found."""
    with live() as address, sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        page = browser.new_page(viewport={"width": 1366, "height": 768}, locale=language, device_scale_factor=1.5)
        page.goto(address)
        page.wait_for_timeout(4000)  # it stands still before it is knocked
        page.click("[data-key=impulse]")
        page.wait_for_selector(".headlight .lamp.green", timeout=180_000)
        for tab in TABS:
            page.click(f"#tab-{tab.capitalize()}")
            if tab == "identify":
                page.click("[data-key=doctor]")
                page.wait_for_selector(".result h1", timeout=120_000)
            page.wait_for_timeout(1500)
            page.evaluate("document.querySelector('.toasts').replaceChildren()")
            name = f"tab-{tab}{'.es' if language == 'es' else ''}.webp"
            if name not in names:
                continue
            made = io.BytesIO()
            shot = Image.open(io.BytesIO(page.locator(".below").screenshot())).convert("RGB")
            shot.save(made, "webp", quality=70, method=6, exif=described(page))
            _write(HERE / name, made)
        browser.close()


if __name__ == "__main__":
    every = [*PLACES, *(f"tab-{tab}{suffix}.webp" for tab in TABS for suffix in ("", ".es"))]
    asked = sys.argv[1:] or every
    for name, language in PLACES.items():
        if name in asked:
            film(language, HERE / name)
    for language in ("en", "es"):
        if own := [name for name in asked if name.startswith("tab-") and (".es" in name) == (language == "es")]:
            tabs(language, own)
