"""Makes docs/lab.webp, the moving picture of the lab, with its dark and its Spanish ones for the site: run
`python docs/lab_picture.py [NAME …]`, by default all.

To be run after a change of the page. Needs Chromium and Playwright. The page is paused and stepped, so that a slow
machine makes the same picture.
"""

from __future__ import annotations

import io
import sys
import tempfile
from pathlib import Path
from typing import Literal

from PIL import Image
from playwright.sync_api import sync_playwright

from upright.atomic import write_bytes
from upright.lab.export import export

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
EVERY = 8  # periods of 10 ms between two pictures
PICTURES = 56
WIDTH = 800  # [px] of the picture
KNOCK = 0.12  # [N s], as the slider beside the button shows it
SLIDE = "(slider, size) => { slider.value = Math.log(size); slider.dispatchEvent(new Event('input')); }"
HERE = Path(__file__).resolve().parent


PLACES: dict[str, tuple[Literal["light", "dark"], str]] = {
    "lab.webp": ("light", "en"),
    "_static/lab-dark.webp": ("dark", "en"),
    "lab.es.webp": ("light", "es"),
    "_static/lab-dark.es.webp": ("dark", "es"),
}


def film(scheme: Literal["light", "dark"], language: str, target: Path) -> None:
    """The lab in a colour scheme, knocked forward and back."""
    pictures: list[Image.Image] = []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        page_file = export(folder, ["nxtway-gs"], ["lqg"])
        browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        page = browser.new_page(viewport={"width": 1200, "height": 675}, color_scheme=scheme, locale=language)
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
            page.wait_for_timeout(150)  # for the room and the traces, which are drawn 20 times a second
            shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            pictures.append(shot.resize((WIDTH, round(WIDTH * shot.height / shot.width)), Image.Resampling.LANCZOS))
        browser.close()
    first, *others = pictures
    made = io.BytesIO()
    first.save(made, "webp", save_all=True, append_images=others, duration=10 * EVERY, loop=0, quality=55, method=6)
    write_bytes(target, made.getvalue())
    print(f"wrote {target}: {target.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    for name in sys.argv[1:] or PLACES:
        film(*PLACES[name], HERE / name)
