"""What the exported lab costs: bytes, time to the first picture, a step, a frame, and whether it keeps real time.

Run: python benchmarks/lab_export.py [--seconds N]. Needs Chromium and Playwright. The room is drawn in software, as
on a machine without a GPU, then as the side view of a browser without 3-D. Each figure is taken with the processor as
it is and throttled by 4, in Chromium's own way.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import harness

from upright.lab.export import export

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
FLAT = ["--no-sandbox", "--disable-3d-apis"]
SLOWER = 4
WATCH = """
const watch = () => {
  if (window.upright?.page.drawnFirst) window.first ??= performance.now();
  if (window.upright?.page.deeper === null && window.first) window.whole = performance.now();
  else requestAnimationFrame(watch);
};
requestAnimationFrame(watch);
"""
COMPUTED = """([robot, controller, seconds]) => {
  const session = upright.page.local;
  upright.store.change({ robot, controller, gains: [] });
  session.paused = true;
  session.advance(1);
  const began = performance.now();
  session.advance(seconds);
  const spent = performance.now() - began;
  session.paused = false;
  return spent / (seconds / session.facts.period) / 2;
}"""
DRAWN = """(count) => {
  const { room, charts } = upright.page;
  const began = performance.now();
  for (let i = 0; i < count; i += 1) { room.stale = true; room.draw(16); charts.draw(); }
  return (performance.now() - began) / count;
}"""
LIVE = """(seconds) => new Promise((done) => {
  const session = upright.page.local;
  const [began, t, at, spent] = [performance.now(), session.t, session.wall, session.spent];
  let frames = 0;
  const frame = (now) => {
    frames += 1;
    if (now - began < 1000 * seconds) return requestAnimationFrame(frame);
    const wall = (performance.now() - began) / 1000;
    const kept = (session.t - t) / ((session.wall - at) / 1000);
    return done({ kept, frames: frames / wall, share: (session.spent - spent) / 1000 / wall });
  };
  requestAnimationFrame(frame);
})"""


def main() -> None:
    seconds = harness.options(__doc__, seconds=8.0).seconds
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder:
        clock = harness.Clock()
        page = export(folder)
        print(f"{'written in (CPU)':<46}{clock.cpu:>9.1f} s")
        print(f"{'size':<46}{page.stat().st_size / 1e6:>9.2f} MB   (bar 1.5)")
        with sync_playwright() as driver:
            for title, flags in (("room drawn in software", FLAGS), ("side view, without 3-D", FLAT)):
                browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=flags)
                for slower in (1, SLOWER):
                    measured(browser, page, slower, seconds, title)
                browser.close()


def measured(browser: Any, path: Path, slower: int, seconds: float, title: str) -> None:
    """One page with the processor throttled by `slower`."""
    print(f"\n{title}; processor {'as it is' if slower == 1 else f'throttled by {slower}'}")
    firsts, wholes = list[float](), list[float]()
    for _ in range(4):
        page = opened(browser, path, slower)
        firsts.append(page.evaluate("window.first") / 1000)
        wholes.append(page.evaluate("window.whole") / 1000)
        page.context.close()
    if slower == 1:
        print(f"{'first picture, browser just started':<46}{firsts[0]:>9.2f} s")
    print(f"{'first picture, median of three':<46}{sorted(firsts[1:])[1]:>9.2f} s    (bar 2, as it is)")
    print(f"{'with the room, median of three':<46}{sorted(wholes[1:])[1]:>9.2f} s")
    page = opened(browser, path, slower)
    for robot, controller in (("herrera2015", "lqg"), ("twipr", "hinf"), ("ev3way", "mpc")):
        each = page.evaluate(COMPUTED, [robot, controller, seconds])
        title = f"{robot} {controller}: a step of 1 ms"
        print(f"{title:<46}{1000 * each:>9.2f} µs   {1 / each:.0f} × real time, one body")
    print(f"{'drawing, main thread: room and traces':<46}{page.evaluate(DRAWN, 30):>9.2f} ms")
    live = page.evaluate(LIVE, seconds)
    print(f"{'live: frames a second':<46}{live['frames']:>9.1f}")
    print(f"{'live: simulated over wall time':<46}{live['kept']:>9.3f}      (bar 0.99)")
    print(f"{'live: computing, of one processor':<46}{100 * live['share']:>9.1f} %")
    page.context.close()


def opened(browser: Any, path: Path, slower: int) -> Any:
    """A page without network that has shown its first picture, and when it did."""
    context = browser.new_context(viewport={"width": 1366, "height": 768}, offline=True)
    page = context.new_page()
    context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": slower})
    page.add_init_script(WATCH)
    page.goto(path.as_uri())
    page.wait_for_function("window.whole")
    return page


if __name__ == "__main__":
    main()
