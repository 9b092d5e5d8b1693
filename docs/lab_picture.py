"""Makes docs/lab.webp, the moving picture of the lab: run `python docs/lab_picture.py` after a change of the page.

Needs Chromium and Playwright. The page is paused and stepped, so that a slow machine makes the same picture.
"""

from __future__ import annotations

import io
import tempfile
from pathlib import Path

from PIL import Image
from playwright.sync_api import sync_playwright

from upright.lab.export import export

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
EVERY = 8  # periods of 10 ms between two pictures
PICTURES = 56
WIDTH = 800  # [px] of the picture

if __name__ == "__main__":
    pictures: list[Image.Image] = []
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        page_file = export(folder, ["nxtway-gs"], ["lqg"])
        browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
        page = browser.new_page(viewport={"width": 1200, "height": 675}, color_scheme="light")
        page.goto(page_file.as_uri())
        page.wait_for_selector("canvas.room")  # which takes the side view's place
        page.evaluate("upright.store.send({ kind: 'Step', periods: 200 })")
        for k in range(PICTURES):
            if k in (6, 34):
                size = 0.12 if k == 6 else -0.12
                page.evaluate(f"upright.store.send({{ kind: 'Strike', what: 'impulse', size: {size} }})")
            page.evaluate(f"upright.store.send({{ kind: 'Step', periods: {EVERY} }})")
            page.evaluate("document.querySelector('.toasts').replaceChildren()")
            page.wait_for_timeout(150)  # for the room and the traces, which are drawn 20 times a second
            shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
            pictures.append(shot.resize((WIDTH, round(WIDTH * shot.height / shot.width)), Image.Resampling.LANCZOS))
        browser.close()
    first, *others = pictures
    target = Path(__file__).with_name("lab.webp")
    first.save(target, save_all=True, append_images=others, duration=10 * EVERY, loop=0, quality=55, method=6)
    print(f"wrote {target}: {target.stat().st_size / 1e3:.0f} kB")
