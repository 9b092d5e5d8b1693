"""The lab's page in a real browser: pushed with the mouse, every control used, and nothing lost on the way."""

from __future__ import annotations

import csv
import json
import math
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from socket import AF_INET
from typing import Any

import numpy as np
import pytest
from matplotlib.figure import Figure

from conftest import PATIENCE, listening, patient
from upright.calibration.annealing import lost
from upright.experiment.examples import example
from upright.lab.codec import plain
from upright.lab.message_types import Head
from upright.lab.messages import Light, Setup
from upright.lab.spoken import in_each, parts_of
from upright.lab.tasks import TASKS
from upright.pages import Fold, Next, Page, Picture, Say, html
from upright.physics.dynamics import accelerations
from upright.robots import Robot
from upright.signals import Log

pytestmark = [pytest.mark.needs("chromium", "module:playwright")]

FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
WINDOW = (900, 640)  # [px]
MAY_DRIVE = Head("The controller lqg may drive nxtway-gs", "Green: at most 4 % fall", "good")
PUEDE_MANEJAR = Head("El controlador lqg puede manejar nxtway-gs", "Verde: caen como máximo 4 %", "good")
GREEN = Light("green", {"en": MAY_DRIVE, "es": PUEDE_MANEJAR})
WEB = Path(__file__).resolve().parents[1] / "src" / "upright" / "lab" / "web"


FEW = """import sys
from upright.cli.main import main
from upright.lab import server
server.ALONE = server.Options(rate=20.0, coarse=True, certified=False)
sys.exit(main())"""
"""`upright lab` for tests of its page: fewer pictures of coarser steps, and no certificate that nobody waits for."""


class Lab:
    """The program `FEW` or, with options, `upright lab` as a user starts it; it can be started again on its port."""

    def __init__(self, *options: str) -> None:
        self.options, self.port, self.said = options, 0, ""
        self.start()

    def start(self) -> None:
        program = ["-m", "upright"] if self.options else ["-c", FEW]
        command = [sys.executable, *program, "lab", "--port", str(self.port), "--no-browser", *self.options]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self.process.stdout
        self.said = self.process.stdout.readline()
        if "--class" in self.options:
            self.said += self.process.stdout.readline()
        self.url = re.findall(r"http://\S+", self.said)[0]
        self.port = int(re.findall(r":(\d+)/", self.url)[0])

    def stop(self) -> None:
        self.process.send_signal(signal.SIGINT)
        self.process.communicate(timeout=PATIENCE)


@pytest.fixture(scope="module")
def lab() -> Iterator[Lab]:
    made = Lab()
    yield made
    made.stop()


@pytest.fixture
def seen(driver: Any, lab: Lab, lend: Any) -> Iterator[Any]:
    """A page in a browser that draws the room, in software."""
    browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=FLAGS)
    yield from watched(lend(patient(browser), *WINDOW), lab)
    browser.close()


@pytest.fixture
def page(browser: Any, lab: Lab, lend: Any) -> Iterator[Any]:
    """A fresh page on the lab."""
    yield from watched(lend(browser, *WINDOW), lab)


BEFORE = """() => {
    const { store } = upright;
    window.whole = { send: store.send, now: performance.now, setup: JSON.stringify(store.setup), lit: store.lit };
}"""
"""What a test may have replaced on a page that stays open."""

AS_NEW = """() => {
    const { store } = upright;
    const { send, now, setup, lit } = window.whole;
    [store.send, performance.now] = [send, now];
    document.querySelectorAll('.toast').forEach((toast) => toast.remove());
    for (const kept of [localStorage, sessionStorage]) kept.clear();
    if (JSON.stringify(store.setup) !== setup) store.change(JSON.parse(setup)); // after which the lab says its light
    else store.lit = lit;
    store.send({ kind: 'StandUp', pitch: 0 });
    store.send({ kind: 'Play', paused: false, speed: 1 });
    scrollTo(0, 0);
}"""


class Kept:
    """The page that stays open."""

    page: Any = None


@pytest.fixture(scope="module")
def kept() -> Iterator[Kept]:
    made = Kept()
    yield made
    if made.page:
        made.page.context.close()


@pytest.fixture
def open_page(request: pytest.FixtureRequest, browser: Any, lab: Lab, kept: Kept) -> Iterator[Any]:
    """One page on the lab for all tests that tell it something and see what it shows: to load one takes a second. Each
    finds it with the usual set-up, language, size and tab; one on which a test failed is left to nobody."""
    failed = request.session.testsfailed
    if not kept.page:
        kept.page = listening(browser.new_context().new_page())
        kept.page.asked, kept.page.wrong = list[str](), list[str]()
        kept.page.emulate_media(color_scheme="light", reduced_motion="reduce")
        kept.page.goto(lab.url)
        ready(kept.page)
        at_rest(kept.page)
        kept.page.evaluate(BEFORE)
    page = kept.page
    page.asked.clear(), page.wrong.clear()
    page.set_viewport_size(dict(zip(("width", "height"), WINDOW, strict=True)))
    page.select_option("[data-key=language]", "en")
    page.evaluate(AS_NEW)
    page.evaluate("upright.page.open('Controller')")
    until(page, "upright.store.settled && upright.store.analysed && !upright.store.snapshot.paused")
    yield page
    if request.session.testsfailed > failed:
        page.context.close()
        kept.page = None
    else:
        page.evaluate("upright.store.send({ kind: 'Play', paused: true, speed: 1 })")  # it costs the lab no time
    orderly(page, lab)


def watched(page: Any, lab: Lab) -> Iterator[Any]:
    """A page that has heard from its session."""
    page.goto(lab.url)
    ready(page)
    yield page
    orderly(page, lab)


def orderly(page: Any, lab: Lab) -> None:
    """A page may ask no other host and log no error."""
    assert [url for url in page.asked if not url.startswith((lab.url, "data:", "blob:"))] == []
    harmless = ("WebSocket", "ERR_CONNECTION", "WebGL")
    assert [text for text in page.wrong if not any(word in text for word in harmless)] == []


def until(page: Any, expression: str, wanted: Callable[[Any], bool] = bool) -> Any:
    """What the expression gives once it is wanted; the page forbids `eval`, so it is asked again and again."""
    end, found, wait = time.monotonic() + PATIENCE, None, 20.0
    while time.monotonic() < end:
        found = page.evaluate(expression)
        if wanted(found):
            return found
        page.wait_for_timeout(wait)
        wait = min(1.5 * wait, 250.0)  # [ms] what comes late need not be asked for so often
    raise AssertionError(f"{expression} stayed {found}")


def ready(page: Any) -> None:
    """The page has heard from its session. A newcomer's has the tour open; here everybody begins with Controller."""
    until(page, "Boolean(window.upright?.store.snapshot && document.querySelector('#panel').firstChild)")
    page.evaluate("upright.page.open('Controller')")


def at_rest(page: Any) -> None:
    """The lab has said all that it says of a set-up, after which no part of the page moves by itself."""
    until(page, "upright.store.settled && upright.store.analysed && upright.store.lit?.heads.en")


def lit(page: Any, light: Light = GREEN) -> None:
    """The page hears that light of a certificate, after what this lab says of itself: that it computes none."""
    at_rest(page)
    page.evaluate("(light) => upright.store.hear(light)", {"kind": "Light", **plain(light)})


def tab(page: Any, name: str) -> None:
    page.click(f"#tab-{name}")


def setup(page: Any) -> dict[str, Any]:
    return page.evaluate("upright.store.setup")


@pytest.mark.evidence
def test_a_mouse_drags_the_robot_and_it_leans_the_right_way(seen):
    """The camera looks from the right side, so that forward is to the right: pulled there, ψ grows at first.

    Paused and stepped with a key while the mouse holds the robot, so that a slow picture decides nothing.
    """
    for way in (1, -1):
        seen.click("[data-key=stand]")
        until(seen, "!upright.store.snapshot.paused")
        seen.click("[data-key=pause]")
        until(seen, "upright.store.snapshot.paused")
        seen.evaluate("upright.store.send({ kind: 'StandUp', pitch: 0 })")  # it may have swayed until it was paused
        until(seen, "upright.store.snapshot.paused && Math.abs(upright.store.snapshot.x[0][0]) < 0.004")
        at_rest(seen)
        box, at = seen.locator(".room").bounding_box(), seen.evaluate("upright.page.grasp()")
        x, y = box["x"] + at["x"], box["y"] + at["y"]
        before = seen.evaluate("upright.store.snapshot.x[0][0]")
        seen.mouse.move(x, y)
        seen.mouse.down()
        for k in range(1, 6):
            seen.mouse.move(x + way * 8 * k, y)
        force = stepped(seen, "upright.store.snapshot.f[0]", lambda f, way=way: f * way > 0.05)
        assert force * way < 0.81 * 0.6 * 9.81  # never more than 0.8 of its weight
        stepped(seen, f"upright.store.snapshot.x[0][0] - {before}", lambda lean, way=way: lean * way > 0.003)
        until(seen, "document.querySelector('.force').innerText", lambda text: text.endswith("N"))
        seen.mouse.up()
        stepped(seen, "upright.store.snapshot.f[0] === 0")
    assert _colours(seen) > 200  # a robot, its shadow and ghosts in a room: not an empty canvas


def stepped(page: Any, expression: str, wanted: Callable[[Any], bool] = bool, most: int = 12) -> Any:
    """What the expression gives in a paused run once it is wanted: the page gathers the moves of a mouse for a moment,
    so that they may come after the first of `most` steps. No pull has the robot lean the other way within those."""
    for _ in range(most):
        n = page.evaluate("upright.store.snapshot.n")
        page.keyboard.press(".")
        until(page, f"upright.store.snapshot.n > {n}")
        if wanted(found := page.evaluate(expression)):
            return found
        page.wait_for_timeout(100)
    raise AssertionError(f"{expression} stayed {found}")


def _colours(page: Any) -> int:
    """How many colours the room is drawn with."""
    return page.evaluate("""async () => {
        const image = await createImageBitmap(await upright.page.picture());
        const canvas = new OffscreenCanvas(image.width, image.height);
        canvas.getContext('2d').drawImage(image, 0, 0);
        const data = canvas.getContext('2d').getImageData(0, 0, image.width, image.height).data;
        return new Set(new Uint32Array(data.buffer)).size;
    }""")


def test_the_side_view_of_a_browser_without_3d_can_be_pushed_too(page):
    page.click("[data-key=pause]")
    until(page, "upright.store.snapshot.paused")
    at_rest(page)
    body = page.locator(".flat .shell")
    body.hover()  # waits until it stands still and the mouse would hit it
    box = body.bounding_box()
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2 - 30, box["y"] + box["height"] / 2)
    stepped(page, "upright.store.snapshot.f[0] < -0.05")
    page.mouse.up()


def test_at_first_sight(open_page):
    page = open_page
    assert page.title() == "upright lab"
    captions = page.locator(".strip figcaption b")
    assert [text.split()[0] for text in captions.all_inner_texts()] == ["ψ", "θ"]  # what a push is seen by, and large
    page.click("[data-key=curves]")
    assert captions.count() == 6
    units = page.locator(".strip figcaption > span").all_inner_texts()
    assert units == ["°", "°/s"] * 3
    page.click("[data-key=curves]")
    assert captions.count() == 2
    names = ["robot: twin", "nonlinear model", "linear model"]
    assert page.locator(".legend .key").all_inner_texts() == names
    key = "[...document.querySelectorAll('.legend line')]"
    lines = page.evaluate(key + ".map(l => [l.getAttribute('stroke'), l.getAttribute('stroke-dasharray')])")
    assert len({colour for colour, _ in lines}) == len({dash for _, dash in lines}) == 3  # twice told apart
    assert page.inner_text(".status") == "Live"
    lit(page)
    assert "green" in page.inner_text(".headlight")


@pytest.mark.evidence
def test_every_control_of_the_page_is_used(page):
    """Each is moved or pressed once; every set-up that comes of it runs, and what must follow does. Of the jobs the
    quickest begins: what becomes of the others is tested by itself."""
    page.evaluate("""() => {
        const { send } = upright.store;
        upright.store.send = (message) => ['certify', 'calibrate'].includes(message.job) || send(message);
    }""")
    used: set[str] = set()
    for name in ("Controller", "Robot", "Kit", "See", "Identify", "Keep", "Tour"):
        tab(page, name)
        if name == "Robot":
            page.click("summary")
        used |= _work(page, "#panel " if used else "")  # the others are the same beside every tab
    page.click("[data-key=tour-set]")  # of the second step: the first needs none
    used.add("tour-set")
    for family in ("gains", "off"):
        tab(page, "Controller")
        page.select_option("[data-key=controller]", family)
        until(page, f"upright.store.changed.setup.controller === '{family}'")
        used |= _work(page, "#panel ")
    wanted = {
        "controller",
        "weight-0",
        "gain-0",
        "robot",
        "payload",
        "slope",
        "grip",
        "kit",
        "noise",
        "delay",
        "voltage",
    }
    wanted |= {
        "dead_zone",
        "view",
        "doctor",
        "calibrate",
        "compare",
        "certify",
        "pause",
        "step",
        "speed",
        "scrub",
        "front",
    }
    wanted |= {
        "back",
        "impulse",
        "knock",
        "pull_left",
        "pull_right",
        "tilt",
        "stand",
        "language",
        "theme",
        "help",
        "link",
    }
    wanted |= {
        "picture",
        "keep-csv",
        "keep-replay",
        "keep-robot",
        "tour-set",
        "tour-next",
        "body-published",
        "number-gravity",
    }
    assert wanted <= used
    before = page.evaluate("upright.store.snapshot.n")
    page.click("[data-key=stand]")
    until(page, f"upright.store.snapshot.n > {before} && !upright.store.snapshot.paused")


def _work(page: Any, where: str = "") -> set[str]:
    """Use every control that is seen, and return their keys."""
    used: set[str] = set()
    keys = page.evaluate(
        f"[...document.querySelectorAll('{where}[data-key]')].filter(e => e.offsetParent).map(e => e.dataset.key)"
    )
    for key in keys:
        target = page.locator(f"[data-key='{key}']").first
        if not key or key.startswith(("tab-", "open-", "stop-", "headlight")):  # what shows other controls
            continue
        if not target.is_visible() or not target.is_enabled():
            continue
        _use(page, target, key)
        used.add(key)
    return used


def _use(page: Any, target: Any, key: str) -> None:
    kind = target.evaluate("e => e.tagName + ' ' + (e.type ?? '')")
    if kind == "INPUT range":
        target.focus()
        page.keyboard.press("ArrowLeft")
    elif target.evaluate("e => e.className") == "number":
        target.fill(str(float(target.input_value().replace("−", "-")) * 1.001))
        page.keyboard.press("Enter")
    elif kind.startswith("SELECT"):
        choices = target.evaluate("e => [...e.options].map(o => o.value)")
        chosen = target.input_value()
        for choice in [*[c for c in choices if c != chosen][: 4 if key == "view" else 1], chosen]:
            target.select_option(choice)
            if key == "controller":  # what else there is to use follows it
                until(page, f"upright.store.changed.setup.controller === '{choice}'")
    elif kind == "INPUT checkbox":
        target.click()
        target.click()
    else:
        target.click()
        if key == "help":
            page.keyboard.press("Escape")


def test_sliders_and_choices_reach_the_session(page):
    page.locator("[data-key=weight-0]").focus()
    for _ in range(5):
        page.keyboard.press("ArrowLeft")
    until(page, "upright.store.changed.setup.largest[0]", lambda size: size is not None and size < 0.15)
    until(
        page, "upright.store.analysed?.gain[0]?.[0]", lambda gain: gain is not None and gain < -26.9
    )  # stricter than usual
    tab(page, "Robot")
    page.locator("[data-key=payload]").focus()
    page.keyboard.press("PageUp")
    until(page, "upright.store.changed.look.payload > 0")
    page.select_option("[data-key=robot]", "twipr")
    until(page, "upright.store.changed.look.command_unit === 'N m'")
    tab(page, "Kit")
    page.select_option("[data-key=kit]", "ideal")
    until(page, "upright.store.changed.setup.kit === 'ideal' && upright.store.changed.look.limit === null")


def keep_csv(page, path):
    """The run so far as CSV, as the page saves it."""
    tab(page, "Keep")
    with page.expect_download() as fetched:
        page.click("[data-key=keep-csv]")
    fetched.value.save_as(path)


def compared(page: Any) -> Path:
    """The page that Compare makes, saved by its link."""
    page.click("[data-key=compare]")
    assert page.inner_text(".comparison")  # from the press on
    page.wait_for_selector("[data-key=save-comparison]")
    with page.expect_download() as fetched:
        page.click("[data-key=save-comparison]")
    assert fetched.value.suggested_filename == "compare.html"
    return Path(fetched.value.path())


@pytest.mark.evidence
def test_a_log_is_uploaded_and_a_report_downloaded(page, tmp_path):
    page.click("[data-key=front]")
    until(page, "upright.store.snapshot.t > 1.5")
    keep_csv(page, tmp_path / "mine.csv")
    log = Log.load(tmp_path / "mine.csv")
    assert log.origin["body"]["kind"].startswith("twin")
    tab(page, "Identify")
    page.set_input_files("[data-key=open-log]", str(tmp_path / "mine.csv"))
    until(page, "upright.store.found?.job === 'doctor'")
    until(page, "document.querySelector('.result .page')?.shadowRoot.textContent.includes('mine.csv')")
    shown = page.evaluate("document.querySelector('.result .page').shadowRoot.textContent")
    assert "in-mine" not in shown  # the name that the user gave
    report = compared(page).read_text("utf-8")
    assert all(body in report for body in ("twin", "nonlinear", "linear"))
    assert "ready: Open · Save compare.html" in page.inner_text(".comparison").replace("\N{NO-BREAK SPACE}", " ")
    with page.context.expect_page() as opened:
        page.click("[data-key=open-comparison]")
    assert opened.value.url.endswith("/compare.html")  # seen beside the lab, not saved
    opened.value.close()
    tab(page, "Keep")
    tab(page, "Identify")
    assert page.locator(".comparison a").count() == 2  # and it stays there


def test_a_recording_replays_without_a_server(page, browser, lend, tmp_path):
    page.click("[data-key=impulse]")
    until(page, "upright.store.snapshot.t > 1.5")
    tab(page, "Keep")
    with page.expect_download() as fetched:
        page.click("[data-key=keep-replay]")
    fetched.value.save_as(tmp_path / "replay.html")
    alone = lend(browser, 700, 500, offline=True)
    alone.goto((tmp_path / "replay.html").as_uri())
    until(alone, "upright.store.snapshot?.t > 0.3")
    assert alone.inner_text(".status") == "Recording"
    assert max(map(abs, alone.evaluate("upright.store.traces.x[0][0]"))) < 0.5
    whole = float(alone.get_attribute(".scrub", "max"))
    assert whole == pytest.approx(alone.evaluate("upright.store.recorded"), abs=0.02)  # a step of the line
    assert not alone.is_visible(".hint")  # a recording cannot be pushed
    alone.locator(".scrub").fill(str(round(whole / 2, 2)))
    until(alone, "upright.store.snapshot", lambda s: s["t"] >= whole / 2 - 0.05 and not s["paused"])
    alone.click("[data-key=pause]")
    until(alone, "upright.store.snapshot.paused")
    assert alone.wrong == []


def test_a_reload_and_a_restart_of_the_server_are_survived(page, lab):
    tab(page, "Controller")
    page.select_option("[data-key=controller]", "lqi")
    until(page, "upright.store.changed.setup.controller === 'lqi'")
    t = until(page, "upright.store.snapshot.t", lambda t: t > 0.5)
    page.reload()
    ready(page)
    assert page.evaluate("upright.store.snapshot.t") >= t
    assert setup(page)["controller"] == "lqi"
    lab.stop()
    until(page, "document.querySelector('.status').textContent", lambda text: text.startswith("No connection"))
    lab.start()
    until(page, "document.querySelector('.status').textContent === 'Live'")
    until(page, "upright.store.snapshot.t < 30")
    assert setup(page)["controller"] == "lqi"


def test_a_link_restores_the_whole_setup(page, browser, lab, lend):
    page.evaluate("upright.store.change({controller: 'lqi', payload: 0.05, slope: 0.05, numbers: {body_mass: 0.65}})")
    until(page, "upright.store.changed.setup.controller === 'lqi'")
    tab(page, "Keep")
    page.click("[data-key=impulse]")
    page.click("[data-key=link]")
    assert "on this computer. For others, start the lab with upright lab --class" in page.inner_text(".toast")
    address = page.input_value(".address")
    other = lend(browser)
    other.goto(address)
    ready(other)
    until(other, "upright.store.changed.setup", lambda restored: restored == setup(page))
    until(other, "upright.store.last.push?.join()", lambda push: push == "impulse,0.05")  # the knock is repeated


def test_a_link_of_an_exported_page_opens_here(page, browser, lab):
    """With the robot's own kit, which such a link does not name; what cannot be is said."""
    page.goto("about:blank")
    page.goto(f"{lab.url}#robot=twipr&controller=mpc&bodies=nonlinear&slope=9&push=impulse:0.1")
    ready(page)
    until(page, "upright.store.changed.setup.robot === 'twipr'")
    assert [setup(page)[name] for name in ("kit", "controller", "bodies")] == ["twipr", "mpc", ["nonlinear"]]
    assert "slope=9" in page.inner_text(".toast.error")
    until(page, "upright.store.last.push?.join()", lambda push: push == "impulse,0.1")
    until(page, "upright.store.traces.x[0][0].some(pitch => pitch < -0.01)")  # a second later it is pushed
    page.evaluate("location.hash = '#panel'")  # of the way past the header: no link
    page.evaluate("location.hash = '#robot=nobody&controller=lqi'")
    until(page, "upright.store.changed.setup.controller === 'lqi'")
    assert "'nobody'" in page.locator(".toast.error").last.inner_text()


@pytest.mark.evidence
def test_a_newcomer_is_shown_the_tour(browser, lab, lend):
    """Open beside the robot on a laptop; on a phone, where it is below, a button in the room leads there. Once."""
    page = lend(browser, 390, 844)
    page.goto(lab.url)
    until(page, "Boolean(document.querySelector('.tour'))")
    assert page.locator("[role=tab]").first.get_attribute("aria-selected") == "true"
    page.click("[data-key=invitation]")
    until(page, "Boolean(document.querySelector('.scene.pinned'))")
    bottoms = "[...document.querySelectorAll('.scene .room, .slot .strip')].map(e => e.getBoundingClientRect().bottom)"
    lowest = f"Math.max(...{bottoms})"
    assert page.locator(".tour h3").bounding_box()["y"] > page.evaluate(lowest)
    page.evaluate("upright.store.hear({kind: 'Notice', level: 'error', parts: {}, key: 'own'})")
    assert page.locator(".toast").bounding_box()["y"] > page.evaluate(lowest)  # room, light and pitch stay in sight
    page.reload()
    until(page, "Boolean(document.querySelector('#panel').firstChild)")
    assert page.locator("[data-key=invitation]").count() == 0
    page.evaluate("scrollTo(0, 1e6)")
    until(page, "Boolean(document.querySelector('.scene.pinned'))")
    page.evaluate("scrollTo(0, 0)")  # in one jump, past where the tabs would be seen
    until(page, "!document.querySelector('.scene.pinned')")
    for name in ("Robot", "Kit"):  # what it opens comes into sight, below room and pitch, and stays there
        page.click(f"#tab-{name}")
        shown = "document.querySelector('#panel select').getBoundingClientRect().y"
        pinned = "Boolean(document.querySelector('.scene.pinned'))"
        until(page, f"{pinned} && {lowest} < {shown} && {shown} < {844 / 2}")
    page.click("[data-key=impulse]")  # which the tour asks for: in the corner of the room
    assert (
        page.locator("[data-key=impulse]").bounding_box()["y"] < page.locator(".slot .strip").first.bounding_box()["y"]
    )
    page.evaluate("upright.store.push({ kind: 'Strike', what: 'impulse', size: 0.8 })")
    page.click(".fell button")  # as is what stands it up again
    until(page, "!document.querySelector('.fell').textContent")
    assert page.locator(".scene.pinned").count() == 1


def test_the_keyboard_alone_does_it(page):
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.className") == "skip"
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.id") == "panel"
    page.keyboard.press("Space")
    until(page, "upright.store.snapshot.paused")
    before = page.evaluate("upright.store.snapshot.t")
    page.keyboard.press(".")
    until(page, f"upright.store.snapshot.t > {before} + 0.009")
    page.keyboard.press(",")
    until(page, "upright.store.snapshot.back === 0.25")
    page.keyboard.press("Space")
    until(page, "!upright.store.snapshot.paused")
    page.keyboard.down("ArrowUp")
    until(page, "upright.store.snapshot.r[0]", lambda wanted: wanted > 1)  # the reference rolls forward
    page.keyboard.up("ArrowUp")
    page.keyboard.down("ArrowLeft")
    until(page, "upright.store.snapshot.r[1]", lambda wanted: wanted > 0.2)  # and turns anticlockwise
    page.keyboard.up("ArrowLeft")
    page.keyboard.down("b")
    until(page, "upright.store.snapshot.f[0] > 0.3")  # from behind is forward
    page.keyboard.up("b")
    until(page, "upright.store.snapshot.f[0] === 0")
    page.keyboard.press("?")
    assert page.locator("dialog.help").evaluate("e => [e.scrollTop, e.scrollHeight > e.clientHeight]") == [0, True]
    page.keyboard.press("Escape")
    page.locator("#tab-Controller").focus()
    page.keyboard.press("ArrowRight")
    assert page.evaluate("document.activeElement.id") == "tab-Robot"
    assert page.locator("#tab-Robot").get_attribute("aria-selected") == "true"


def test_everything_has_a_name_for_who_does_not_see_it(open_page):
    page = open_page
    nameless = """[...document.querySelectorAll('button, input, select, canvas, progress, [role=tab], [role=img]')]
        .filter(e => e.offsetParent && !e.closest('[aria-hidden=true]')
            && !(e.getAttribute('aria-label') || e.textContent.trim()
            || [...(e.labels ?? [])].some(l => l.textContent.trim()))).map(e => e.outerHTML.slice(0, 80))"""
    for name in ("Controller", "Robot", "Kit", "See", "Identify", "Keep", "Tour"):
        tab(page, name)
        assert page.evaluate(nameless) == []
    until(page, "document.querySelector('.room').getAttribute('aria-label')", lambda text: "leans" in text)
    page.select_option("[data-key=language]", "es")
    assert page.evaluate("document.documentElement.lang") == "es"
    assert page.inner_text("#tab-Controller") == "Controlador"
    assert page.evaluate(nameless) == []


def test_the_accessibility_tree_names_everything(open_page):
    """As a screen reader is told it, by the browser itself."""
    page = open_page
    spoken = {"button", "checkbox", "combobox", "slider", "spinbutton", "textbox", "tab", "tablist", "image", "img"}
    spoken |= {"progressbar", "dialog", "region", "tabpanel", "link", "figure"}
    session = page.context.new_cdp_session(page)
    until(page, "!!upright.store.analysed")  # See then has its drawings
    for name in ("Controller", "Robot", "Kit", "See", "Identify", "Keep", "Tour"):
        tab(page, name)
        nodes = [node for node in session.send("Accessibility.getFullAXTree")["nodes"] if not node["ignored"]]
        named = [(n["role"]["value"], n.get("name", {}).get("value", "").strip()) for n in nodes if "role" in n]
        assert [role for role, text in named if role in spoken and not text] == [], name
        assert {"tabpanel", "slider", "button", "combobox"} <= {role for role, _ in named}


PADS = "window.pad = {connected: true, axes: [0, 0]}; navigator.getGamepads = () => [null, window.pad];"


@pytest.mark.evidence
def test_a_gamepad_drives_and_lets_go(browser, lab):
    """Stick forward (-1) rolls forward, left (-1) turns anticlockwise; a stick at rest or unplugged does neither."""
    context = browser.new_context()
    context.add_init_script(PADS)
    page = context.new_page()
    page.goto(lab.url)
    ready(page)
    wanted = "upright.store.snapshot.r"

    def rests() -> bool:
        before, t = page.evaluate(wanted), page.evaluate("upright.store.snapshot.t")
        until(page, f"upright.store.snapshot.t > {t} + 0.3")
        return page.evaluate(wanted) == before

    page.evaluate("pad.axes = [0, -1]")
    until(page, wanted + "[0] > 0.5")
    page.evaluate("pad.axes = [-1, 0.1]")  # hardly off the middle: no stick rests there exactly
    until(page, wanted + "[1] > 0.2")
    page.evaluate("pad.axes = [0.1, -0.1]")
    assert any(rests() for _ in range(10))
    page.evaluate("pad.axes = [0, 1]")
    before = page.evaluate(wanted + "[0]")
    until(page, wanted + f"[0] < {before} - 0.5")
    page.evaluate("window.pad = null")
    assert any(rests() for _ in range(10))
    context.close()


@pytest.mark.evidence
def test_a_calibration_joins_as_the_fourth_trace(page):
    """Recorded, examined, calibrated and compared with nothing but the page."""
    page.click("[data-key=stand]")
    for key in ("ArrowUp", "ArrowLeft", "ArrowDown", "ArrowRight"):
        t = page.evaluate("upright.store.snapshot.t")
        page.keyboard.down(key)
        page.keyboard.press("k")
        until(page, f"upright.store.snapshot.t > {t} + 1.5")
        page.keyboard.up(key)
    page.click("[data-key=pause]")
    until(page, "upright.store.snapshot.paused")
    tab(page, "Identify")
    page.click("[data-key=doctor]")
    until(page, "upright.store.found?.job === 'doctor'")
    page.click("[data-key=calibrate]")
    bar = page.get_by_role("progressbar", name="Calibrate")
    bar.wait_for()
    until(page, "document.querySelector('progress')?.value ?? 1", lambda share: share > 0)
    until(page, "upright.store.changed.bodies.length === 4")
    assert page.evaluate("upright.store.changed.bodies[3]") == "calibrated"
    until(page, "upright.store.found.job === 'calibrate'")  # told after the trace has joined
    page.locator(".result tbody tr").nth(3).wait_for(state="attached")
    until(page, "document.querySelectorAll('.legend .key')[3]?.textContent === 'calibrated model'")
    bar.wait_for(state="detached")
    page.click("[data-key=pause]")
    until(page, "upright.store.traces.x[3]?.[0].length > 20")
    assert "calibrated" in compared(page).read_text("utf-8")


@pytest.mark.evidence
def test_a_log_of_another_robot_is_refused_under_the_button_with_what_to_do(page, tmp_path):
    """In volts, for a robot that takes torques: which job, why and what to press; in both languages, for as long as
    that robot stands there."""
    log = example("excited").between(0.0, 6.0).save(tmp_path / "run.csv")
    tab(page, "Robot")
    page.select_option("[data-key=robot]", "twipr")
    until(page, "upright.store.settled && upright.store.changed.setup.robot === 'twipr'")
    tab(page, "Identify")
    page.set_input_files("[data-key=open-log]", str(log))
    until(page, "upright.store.found?.job === 'doctor'")
    page.click("[data-key=calibrate]")
    until(page, "document.querySelector('.failed').textContent")
    words = page.inner_text(".failed")
    assert words.startswith("Calibrate stopped: The log's commands are in V. Expected: N m, as those of 'twipr'.")
    assert "Try: choose the robot of the log" in words
    assert page.locator(".toast.error").count() == 0  # it is said where one looks
    page.select_option("[data-key=language]", "es")
    assert page.inner_text(".failed").startswith("Calibrar se detuvo: Los mandos del registro están en V.")
    assert not re.search(ENGLISH, page.inner_text(".failed"))
    page.evaluate("upright.store.change({ robot: 'nxtway-gs', kit: 'nxt' })")
    until(page, "!document.querySelector('.failed').textContent")


HEARD = """([job, language, html]) => {
    const head = { title: 'Robot', verdict: 'sound', level: 'warn', lead: [], numbers: [] };
    upright.store.hear({ kind: 'JobResult', job, heads: { en: head, es: head }, html: { [language]: html } });
}"""
"""The page hears of a job what this HTML says, in one language alone."""


def test_a_page_of_a_result_has_the_lab_s_own_buttons(open_page):
    """A verb that it names next is at hand where the lab can do it; what stands in the page stays text there."""
    page = open_page
    tab(page, "Identify")
    page.evaluate("() => { window.sent = []; upright.store.send = (message) => sent.push(message); }")
    steps = (Next("calibrate", "run.csv"), Next("excite", robot="nxtway-gs"))
    page.evaluate(HEARD, ["doctor", "en", html.shadow(Page(Say("{name}", name="<b>mine</b>"), next=steps))])
    result = page.locator(".result")
    assert result.locator("h1").inner_text() == "<b>mine</b>"
    assert result.locator(".next").count() == 2
    assert result.locator("button").all_inner_texts() == ["Calibrate"]
    page.click("[data-key=next-calibrate]")
    assert page.evaluate("sent.at(-1)") == {"kind": "Start", "job": "calibrate", "file": ""}


def drawn() -> Figure:
    """A line through (0, 0) and (10, 20)."""
    figure = Figure(figsize=(7, 3))
    ax = figure.subplots()
    x = np.linspace(0, 10, 201)
    ax.plot(x, 2 * x, label="run")
    ax.set(xlim=(0, 10), ylim=(0, 20), xlabel="time [s]")
    return figure


MIDDLE = """() => {
    const svg = [...READ].find((one) => one.checkVisibility());
    svg.scrollIntoView({ block: 'center' });
    const { x, y, width, height } = svg.getBoundingClientRect();
    const [{ left, right }] = JSON.parse(svg.dataset.curves);
    const across = (left + right) / 2 / svg.viewBox.baseVal.width;
    return [x + across * width, y + height / 2, svg.classList.contains('narrow')];
}"""
"""Where the middle of the first figure is that is seen, and whether it is the one for a phone."""


def read(page: Any, root: str) -> tuple[str, bool]:
    """What the pointer reads in the middle of the first figure in `root`, and whether it is the one for a phone."""
    before: list[Any] = []

    def stands(found: list[Any]) -> bool:
        same = found == before
        before[:] = found
        return same

    *place, narrow = until(page, "(" + MIDDLE.replace("READ", f"{root}.querySelectorAll('svg.lines')") + ")()", stands)
    page.mouse.move(*place)
    said = until(page, f"[...{root}.querySelectorAll('output')].map((one) => one.textContent).join('')")
    return said, narrow


SHADOW = "document.querySelector('.page').shadowRoot"


def test_a_page_of_a_result_is_in_the_lab_what_it_is_alone(open_page):
    """The pointer reads its curve, with the mark of the language; a tab that is narrow has the figure for a phone; a
    fold opens by its key, which elsewhere pauses, and stays open in another language and theme."""
    page = open_page
    tab(page, "Identify")
    result = Page(Say("{name}", name="mine"), picture=Picture(Say("{name}", name="a line"), drawn),
                  blocks=(Fold(Say("{name}", name="more"), (Say("{name}", name="words"),)),))  # fmt: skip
    head = {"title": "mine", "verdict": "", "level": "info", "lead": [], "numbers": []}
    message = {"heads": {"en": head, "es": head}, "html": in_each(lambda: html.shadow(result))}
    page.evaluate("(found) => upright.store.hear({ kind: 'JobResult', job: 'doctor', ...found })", message)
    for width, shown in ((1280, True), (900, False), (390, True)):
        page.set_viewport_size({"width": width, "height": 768})
        said, narrow = read(page, SHADOW)
        time, value = map(float, re.findall(r"-?\d+\.?\d*", said))
        assert (time, value) == pytest.approx((5, 10), abs=0.1)
        assert narrow is shown
    page.evaluate(f"{SHADOW}.querySelector('summary').focus()")
    page.keyboard.press(" ")
    opened = f"{SHADOW}.querySelector('details').open"
    assert page.evaluate(opened)
    assert not page.evaluate("upright.store.snapshot.paused")
    page.select_option("[data-key=language]", "es")
    page.click("[data-key=theme]")
    tab(page, "Keep")
    tab(page, "Identify")
    assert page.evaluate(opened)
    page.click("[data-key=theme]")


def test_the_pointer_reads_a_bode_diagram(open_page):
    """Between its ends, in the decimals of the language: that of the exported lab is the same."""
    page = open_page
    tab(page, "See")
    until(page, "upright.store.analysed?.L.length === 3")
    omega, real, imaginary = page.evaluate("upright.store.analysed.L")
    loudness = np.interp(
        math.log(omega[0] * omega[-1]) / 2, np.log(omega), 20 * np.log10(np.hypot(real, imaginary))
    )  # [dB] half way on a logarithmic axis
    page.select_option("[data-key=language]", "es")
    said, _ = read(page, "document.querySelector('#panel')")
    frequency, level = (
        float(number.replace(",", ".").replace("−", "-")) for number in re.findall(r"[-−]?\d+,?\d*", said)
    )
    assert frequency == pytest.approx(math.sqrt(omega[0] * omega[-1]), rel=0.03)
    assert level == pytest.approx(loudness, abs=0.3)  # [dB] a pixel of the screen


def test_nothing_to_press_moves_when_the_light_arrives(open_page):
    """The button of the full certificate stands still while what is known of the loop and the light go and come."""
    page = open_page
    page.set_viewport_size({"width": 1280, "height": 768})
    tab(page, "Controller")
    lit(page)
    page.evaluate("document.querySelector('#panel').scrollTop = 1e4")
    moved = page.evaluate("""(light) => {
        const { store } = upright;
        const [analysed, places] = [store.analysed, []];
        const look = () => {
            const keys = ['certify', 'weight-0', 'headlight'];
            const box = (key) => document.querySelector(`[data-key=${key}]`).getBoundingClientRect();
            places.push(JSON.stringify(keys.map((key) => [box(key).x, box(key).y])));
        };
        look();
        store.analysed = null;
        for (const message of [{ kind: 'Light', light: 'none', heads: {} }, analysed, light]) {
            store.hear(message);
            look();
        }
        return [...new Set(places)];
    }""", {"kind": "Light", **plain(GREEN)})  # fmt: skip
    assert len(moved) == 1


def test_an_error_is_told_part_by_part_with_the_button_of_its_command(open_page):
    page = open_page
    tab(page, "Identify")
    page.evaluate(
        "(parts) => upright.store.hear({ kind: 'Notice', level: 'error', parts, key: '', job: 'calibrate' })",
        plain(parts_of(lost())),
    )
    failed = page.locator(".failed")
    assert failed.locator(".said").inner_text() == (
        "Calibrate stopped: The filter loses the robot from every start. "
        "Expected: a log of the named robot, balancing. "
        "Likely: another robot, a flipped sign or a wrong unit. Try: `upright doctor LOG`."
    )
    assert failed.locator("button").inner_text() == "Doctor"
    page.select_option("[data-key=language]", "es")
    assert not re.search(ENGLISH, failed.inner_text())


@pytest.mark.evidence
def test_a_phone_s_large_curve_shows_the_fall_that_the_tour_asks_about(page):
    """The step asks for the times of 0.1 and 0.2 rad, and the curve is shown up to 0.3: so far."""
    page.set_viewport_size({"width": 390, "height": 844})
    page.evaluate("upright.page.bring('Tour')")
    page.click("[data-key=tour-next]")
    page.click("[data-key=tour-set]")
    until(page, "upright.store.lain")
    page.click(".slot .strip:first-child .plot")
    until(page, "document.querySelector('.slot .strip.large')")
    scale = "(({min, max}) => [min, max])(upright.page.charts.strips[0].plot.scales.x)"
    until(page, f"{scale}[0] !== null && {scale}[1] - {scale}[0] < 0.99")
    low, high = page.evaluate(scale)
    t, pitch = page.evaluate("[upright.store.traces.t, upright.store.traces.x[0][0]]")
    shown = [abs(y) for x, y in zip(t, pitch, strict=True) if low - 1e-6 <= x <= high + 1e-6]
    assert shown[0] == pytest.approx(0.02, abs=0.01)
    assert 0.3 < shown[-1] < 0.5  # a sample later, not where it lies
    page.click(".slot .strip:first-child .plot")
    until(page, f"Math.abs({scale}[1] - {scale}[0] - 1) < 1e-3")


def test_a_fallen_body_leaves_the_scale_to_those_that_stand(open_page):
    """It lies at π/2; the others stand within 0.1 rad."""
    page = open_page
    page.evaluate("upright.store.send({ kind: 'Play', paused: true, speed: 1 })")
    until(page, "upright.store.snapshot.paused")
    page.evaluate("""() => {
        const s = upright.store.snapshot;
        const x = s.x.map((row, b) => b === 1 ? [1.57, ...row.slice(1, 8), 1] : row);
        for (let k = 1; k < 40; k += 1) upright.store.hear({ ...s, n: s.n + k, t: s.t + 0.02 * k, x });
    }""")
    until(page, "upright.page.charts.strips[0].plot.scales.y.max < 30")


@pytest.mark.parametrize("width", [390, pytest.param(1366, marks=pytest.mark.evidence)])
def test_the_light_leads_to_its_reasons(open_page, width):
    page = open_page
    page.set_viewport_size({"width": width, "height": 844 if width == 390 else 768})
    lit(page)
    tab(page, "Keep")
    page.evaluate("scrollTo(0, 0)")
    if width == 390:
        assert page.inner_text(".headlight .word") == "green"
    page.click("[data-key=headlight]")
    heading = page.locator(".light h4")
    assert heading.inner_text() == "Certificate"
    box = "document.querySelector('.light h4').getBoundingClientRect()"
    until(page, f"{box}.top > 150 && {box}.bottom < innerHeight - 40")  # below what a phone docks


def test_a_job_is_stopped_and_a_robot_opened(page, tmp_path):
    until(page, "upright.store.snapshot.t > 1")
    tab(page, "Identify")
    page.evaluate("""() => {  // at once: of a second's log it is soon said what is missing, and the button goes
        document.querySelector('[data-key=calibrate]').click();
        upright.store.hear({ kind: 'Progress', job: 'calibrate', fraction: 0, runs: 0 });
        document.querySelector('[data-key=stop-calibrate]').click();
    }""")
    page.locator("[data-key=stop-calibrate]").wait_for(state="detached")
    Robot.preset("nxtway-gs").replace(name="mine", body_mass=0.7).save(tmp_path / "mine.toml")
    tab(page, "Robot")
    page.set_input_files("[data-key=open-robot]", str(tmp_path / "mine.toml"))
    until(page, "upright.store.changed.setup.numbers.body_mass === 0.7")
    until(page, "document.querySelector('[data-key=robot]').value === 'mine'")


TOUR = ("lqg", "off", "off", "lqr", "lqg", "lqg", "lqg", "lqr", "robust")
"""Controllers of the eight steps: none twice, then what the paper does, a payload that breaks it, and what mends it."""


@pytest.mark.parametrize("language", ["en", pytest.param("es", marks=pytest.mark.evidence)])
def test_the_tour_is_walked_by_keys_and_by_buttons(page, language):
    """In English by keys alone, in Spanish by buttons: eight steps, each with what to do, to watch and to ask."""
    texts = json.loads((WEB / "src" / "texts" / f"{language}.json").read_text("utf-8"))
    page.select_option("[data-key=language]", language)
    assert page.evaluate("document.activeElement.dataset.key") == "language"  # the focus outlives the new words
    if language == "en":
        page.evaluate("document.activeElement.blur()")
        page.keyboard.press("n")
    else:
        tab(page, "Tour")
    for step, controller in zip(texts["tour"], TOUR, strict=True):
        assert page.inner_text(".tour h3") == step["title"]
        assert page.locator(".tour .hint-part p").all_inner_texts() == [step["do"], step["watch"], step["ask"]]
        if step is texts["tour"][0]:
            assert page.locator("[data-key=tour-set]").count() == 0  # all is ready
        elif language == "en":
            page.keyboard.press("Enter")  # the button that sets up has the focus
        else:
            page.click("[data-key=tour-set]")
        until(page, f"upright.store.changed.setup.controller === '{controller}' && !upright.store.snapshot.paused")
        page.keyboard.press("n") if language == "en" else page.locator("[data-key=tour-next]").click(force=True)
    assert page.inner_text(".tour h3") == texts["tour"][8]["title"]  # there is no tenth
    assert page.evaluate("upright.store.changed.setup.payload") > 0
    page.keyboard.press("p")
    assert page.inner_text(".tour h3") == texts["tour"][7]["title"]


def test_the_equations_with_their_numbers_are_those_of_the_dynamics(open_page):
    """Both sides of each, with the accelerations of `physics.dynamics`; numbers are shown to two digits and more."""
    page = open_page
    page.evaluate("upright.store.change({numbers: {coulomb_friction: 0, wheel_friction: 0}})")
    until(page, "upright.store.changed.setup.numbers.coulomb_friction === 0")
    tab(page, "See")
    page.select_option("[data-key=view]", "equations")
    lines = page.inner_text(".equations").splitlines()[:3]
    robot = Robot.preset("nxtway-gs").replace(coulomb_friction=0.0, wheel_friction=0.0)
    x, u = (0.3, 0.7, 0.0, 5.0, 0.0, 1.1), (2.0, 3.0)
    pitch_acc, wheel_acc, yaw_acc = accelerations(x, u, robot)
    values = {"ψ̈": pitch_acc, "θ̈": wheel_acc, "φ̈": yaw_acc, "ψ̇": x[1], "θ̇": x[3], "φ̇": x[5], "ψ": x[0]}
    for line in lines:
        for symbol, value in values.items():
            line = line.replace(symbol, f"({value!r})")  # noqa: PLW2901
        for sign, python in (("·", "*"), ("²", "**2"), ("−", "-"), ("v_l", "2.0"), ("v_r", "3.0")):
            line = line.replace(sign, python)  # noqa: PLW2901
        line = re.sub(r"(sin|cos)(\*\*2)? \((.*?)\)", r"(\1(\3))\2", line)  # noqa: PLW2901
        line = re.sub(r"(?<=[\w)]) +(?=[\w(])", "*", line)  # noqa: PLW2901
        left, right = (eval(side, {"sin": math.sin, "cos": math.cos}) for side in line.split("="))
        assert left == pytest.approx(right, rel=0.01), line


def test_nothing_moves_for_who_asked_for_less_motion(browser, lab, lend):
    page = lend(browser)
    for wish, moves in (("reduce", False), ("no-preference", True)):
        page.emulate_media(reduced_motion=wish)
        page.goto("about:blank")
        page.goto(lab.url)
        ready(page)
        style = page.evaluate("getComputedStyle(document.querySelector('[data-key=pause]')).transitionDuration")
        assert (style != "0s") == moves


@pytest.mark.parametrize(
    "size",
    [
        (390, 844),
        (844, 390),
        *(pytest.param(size, marks=pytest.mark.evidence) for size in ((1440, 900), (1920, 1080), (2560, 1440))),
    ],
)
def test_from_phone_to_wall_nothing_is_cut_off(open_page, size):
    """No panel is wider than the screen, no button narrower than its text; on a wall type is half as large again."""
    page = open_page
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    cut = "[...document.querySelectorAll('button, label, th, .strip figcaption')].filter(e => e.offsetParent)"
    cut += ".filter(e => e.scrollWidth > e.clientWidth + 1 && getComputedStyle(e).display !== 'inline')"
    for name in ("Controller", "Robot", "Kit", "See", "Identify", "Keep", "Tour"):
        tab(page, name)
        until(page, f"document.documentElement.scrollWidth <= {size[0]}")  # curves follow when they are drawn again
        until(page, cut + ".map(e => e.textContent)", lambda texts: texts == [])
    assert page.evaluate("parseFloat(getComputedStyle(document.documentElement).fontSize)") == {
        390: 16, 844: 16, 1440: 16, 1920: pytest.approx(17.92), 2560: 24,
    }[size[0]]  # fmt: skip
    if size == (844, 390):  # a phone on its side shows robot, pitch, a push and the open tab at once
        parts = ".room, .slot .strip, [data-key=impulse], #tab-Tour, #panel h3"
        seen = f"[...document.querySelectorAll('{parts}')].map(e => e.getBoundingClientRect().bottom <= innerHeight)"
        until(page, seen, lambda inside: inside == [True] * 5)
        whole = seen.replace("[data-key=impulse]", ".transport")  # nor is a button below the fold
        for language in ("en", "es"):
            page.select_option("[data-key=language]", language)
            until(page, whole, lambda inside: inside == [True] * 5)
            tabs = page.locator(".tabs")
            assert tabs.evaluate("e => e.scrollWidth - e.clientWidth") <= 0, language
            page.evaluate(
                "upright.store.hear({kind: 'Recovered', impulse: 0.1, effort: 1, best: 0.2, fell: true, single: true})"
            )
            page.evaluate("upright.page.lie()")
            room, fell = (page.locator(name).bounding_box() for name in (".room", ".fell"))
            assert fell["y"] >= room["y"] + room["height"], "what is said covers no robot"
        assert page.locator(".slot .plot").bounding_box()["height"] >= 80  # twice what two curves had


@pytest.mark.parametrize("scheme", ["light", pytest.param("dark", marks=pytest.mark.evidence)])
def test_a_phone_shows_all_of_it_without_scrolling_sideways(browser, lab, lend, scheme):
    page = lend(browser, 360, 720, scheme, has_touch=True)
    page.goto(lab.url)
    ready(page)
    assert page.evaluate("document.documentElement.dataset.theme") == scheme
    for name in ("Controller", "Robot", "See", "Identify", "Tour"):
        tab(page, name)
        until(page, "document.documentElement.scrollWidth <= 360")


def address() -> str:
    """An address of this machine that others reach, as a class needs one."""
    import psutil

    of_here = [a.address for addresses in psutil.net_if_addrs().values() for a in addresses if a.family == AF_INET]
    return next((text for text in of_here if not text.startswith("127.")), "") or pytest.skip("no network")


def read_qr(dark: set[tuple[int, int]]) -> str:
    """The text of a QR code of bytes, of version 2 to 5 and correction M (ISO/IEC 18004: 7.3 to 7.9, annex C)."""
    size = max(x for x, _ in dark) + 1
    version = (size - 17) // 4
    bits = [int((x, 8) in dark) for x in (0, 1, 2, 3, 4)]  # of the format, masked by 101010000010010
    format_bits = [bit ^ mask for bit, mask in zip(bits, (1, 0, 1, 0, 1), strict=True)]
    assert format_bits[:2] == [0, 0]  # M
    formula: Callable[[int, int], bool] = {
        0: lambda i, j: (i + j) % 2 == 0, 1: lambda i, _: i % 2 == 0, 2: lambda _, j: j % 3 == 0,
        3: lambda i, j: (i + j) % 3 == 0, 4: lambda i, j: (i // 2 + j // 3) % 2 == 0,
        5: lambda i, j: i * j % 2 + i * j % 3 == 0, 6: lambda i, j: (i * j % 2 + i * j % 3) % 2 == 0,
        7: lambda i, j: ((i + j) % 2 + i * j % 3) % 2 == 0,
    }[format_bits[2] * 4 + format_bits[3] * 2 + format_bits[4]]  # fmt: skip

    def patterned(x: int, y: int) -> bool:
        corners = (x < 9 and y < 9) or (x > size - 9 and y < 9) or (x < 9 and y > size - 9)
        return corners or 6 in (x, y) or (abs(x - size + 7) < 3 and abs(y - size + 7) < 3)

    columns = [x for x in range(size - 1, 0, -2) if x > 6] + [5, 3, 1]
    stream = [
        ((x, y) in dark) ^ formula(y, x)
        for turn, right in enumerate(columns)
        for y in (range(size) if turn % 2 else range(size - 1, -1, -1))
        for x in (right, right - 1)
        if not patterned(x, y)
    ]
    words = [int("".join("01"[bit] for bit in stream[k : k + 8]), 2) for k in range(0, len(stream) - 7, 8)]
    blocks, data = {2: (1, 28), 3: (1, 44), 4: (2, 32), 5: (2, 43)}[version]
    words = [word for block in range(blocks) for word in words[block : blocks * data : blocks]]
    return "".join(qr_parts("".join(f"{word:08b}" for word in words)))


ALPHANUMERIC = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:"


def qr_parts(bits: str) -> Iterator[str]:
    """Segments of digits, capitals and bytes, of versions up to 9 (ISO/IEC 18004: 7.4.3 to 7.4.5, tables 2 and 3)."""

    def take(count: int) -> int:
        nonlocal bits
        value, bits = int(bits[:count], 2), bits[count:]
        return value

    while bits[:4] not in ("0000", "") and (mode := take(4)):
        count = take({1: 10, 2: 9, 4: 8}[mode])
        if mode == 4:
            yield bytes(take(8) for _ in range(count)).decode()
        elif mode == 2:
            pairs = "".join(ALPHANUMERIC[v // 45] + ALPHANUMERIC[v % 45] for v in (take(11) for _ in range(count // 2)))
            yield pairs + (ALPHANUMERIC[take(6)] if count % 2 else "")
        else:
            groups = [3] * (count // 3) + [count % 3] * bool(count % 3)
            yield "".join(f"{take((0, 4, 7, 10)[n]):0{n}d}" for n in groups)


@pytest.mark.evidence
def test_a_class_in_the_browser(browser, lend):
    lab = Lab("--class", "--host", address())
    try:
        students, teacher = re.findall(r"http://\S+", lab.said)
        ana = lend(browser, 500, 500)
        ana.goto(students)
        ana.fill("#name", "=Ana")  # which a spreadsheet must not take for a formula
        ana.keyboard.press("Enter")
        ready(ana)
        assert ana.evaluate("upright.store.changed.bodies") == ["nonlinear", "linear"]
        assert "token" not in ana.url  # a link that is passed on lets nobody in
        front = lend(browser, 500, 500)
        front.goto(teacher)
        ready(front)
        tab(front, "Class")
        until(front, "document.querySelector('.board tbody')?.textContent.includes('Ana')")
        front.evaluate("upright.store.change({controller: 'lqi'})")
        until(front, "upright.store.changed.setup.controller === 'lqi'")
        assert "on request" in until(front, "upright.store.lit?.heads.en?.title ?? ''")
        front.click("[data-key=broadcast]")
        until(ana, "upright.store.changed.setup.controller === 'lqi'")
        until(front, "upright.store.board.students[0].controller === 'lqi'")
        with front.expect_download() as fetched:
            front.click("[data-key=results]")
        rows = list(csv.DictReader(Path(fetched.value.path()).read_text("utf-8-sig").splitlines()))
        assert [(row["name"], row["controller"], row["here"]) for row in rows] == [("'=Ana", "lqi", "true")]
        path = front.locator(".qr path").get_attribute("d")
        dark = {(int(x), int(y)) for x, y in re.findall(r"M(\d+) (\d+)", path)}
        assert read_qr(dark) == students
    finally:
        lab.stop()


SEEN_AT_ONCE = """[...document.querySelectorAll('.room, .strip:first-child, .tabs, .panel')].map(e => {
    const box = e.getBoundingClientRect();
    return box.top >= 0 && box.bottom <= innerHeight && box.width > 150 && box.height > 30;
})"""


@pytest.mark.parametrize("language", [pytest.param("en", marks=pytest.mark.evidence), "es"])
def test_a_laptop_shows_room_pitch_and_the_open_tab_at_once(open_page, language):
    """1366 × 768, the commonest laptop: nothing scrolls but the inside of a tab."""
    page = open_page
    page.set_viewport_size({"width": 1366, "height": 768})
    page.select_option("[data-key=language]", language)
    for name in ("Controller", "Robot", "Kit", "See", "Identify", "Keep", "Tour"):
        tab(page, name)
        until(page, SEEN_AT_ONCE, lambda inside: inside == [True] * 4)
        until(page, "document.documentElement.scrollHeight <= 768")
    assert page.locator(".room").bounding_box()["height"] > 768 / 3  # and the robot is no stamp


def test_nothing_of_the_controller_before_stays_under_the_new_name(open_page):
    """Gains, margins and light go with the choice itself, and none of the old ones comes back."""
    page = open_page
    lit(page)
    at_once = page.evaluate("""() => {
        window.shown = [];
        const note = () => shown.push([upright.store.analysed?.heads.en.title, upright.store.lit?.light]);
        upright.store.listen(note);
        window.before = upright.store.analysed.heads.en.title;
        upright.store.change({controller: 'lqi'});
        note();
        return [...shown.at(-1), document.querySelector('.headlight').innerText];
    }""")
    assert at_once[:2] == [None, "none"]
    assert "computing" in at_once[2]
    until(page, "upright.store.analysed && upright.store.lit?.heads.en")
    assert page.evaluate("shown.some(([words]) => words === before)") is False


@pytest.mark.evidence
def test_what_is_said_follows_what_was_chosen(page):
    tab(page, "Robot")
    page.click("summary")
    page.select_option("[data-key=robot]", "twipr")
    until(page, "document.querySelector('#panel .note').textContent.startsWith('TWIPR')")
    tab(page, "Controller")
    page.select_option("[data-key=controller]", "off")
    assert page.inner_text(".numbers") == "There is no controller, so there is no loop."
    until(page, "upright.store.snapshot.x[0][8]")  # it starts with a lean, and falls
    page.click("[data-key=impulse]")
    until(page, "document.querySelector('.fell').textContent === 'It lies; press Stand up first.Stand up'")
    assert page.locator(".toast").count() == 0  # which could stand over that button


def test_an_answer_to_an_earlier_choice_does_not_undo_a_later_one(page):
    """Whatever the session says by itself, as after a choice that cannot be, counts."""
    shown = page.evaluate("""() => {
        const { store } = upright;
        const [send, before] = [store.send, store.changed];
        const sent = [];
        store.send = (message) => sent.push(message.setup);
        const hear = (setup) => { store.hear({ ...before, setup }); return store.setup.controller; };
        for (const controller of ['pid', 'gains', 'off']) store.change({ controller });
        const shown = [...sent.slice(0, 2), sent[2], before.setup].map(hear);
        store.send = send;
        return [...shown, store.settled];
    }""")
    assert shown == ["off", "off", "off", "lqg", True]


LIGHTS = """() => ['none', 'green', 'amber', 'red'].flatMap(light => [0, 1, 2, 3].map(changed => {
    const [{ store, page }, payload, slope] = [upright, changed & 1 ? 0.2 : 0, changed & 2 ? 0.1 : 0];
    [store.setup, store.lit] = [{ ...store.setup, payload, slope }, { ...store.lit, light }];
    page.lamp();
    const words = [...document.querySelectorAll('.headlight span:last-child, .what')];
    const cut = words.filter(e => e.clientWidth > 1 && e.scrollWidth > e.clientWidth);
    return [document.querySelector('main').getBoundingClientRect().top + scrollY, cut.length];
}))"""


@pytest.mark.parametrize(
    "size", [*((pytest.param(s, marks=pytest.mark.evidence)) for s in ((1366, 768), (844, 390))), (390, 844)]
)
def test_no_words_of_the_bar_move_the_page_or_are_cut(page, size):
    """Whatever the certificate says, and while the connection is lost; the whole of it is the light's title."""
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    lit(page)
    for language in ("en", "es"):
        page.select_option("[data-key=language]", language)
        tops, cut = zip(*page.evaluate(LIGHTS), strict=True)
        assert set(cut) == {0}, language
        for state in ("lost", "connecting", "connected"):
            page.evaluate(f"upright.page.says('{state}')")
            tops += (page.evaluate("document.querySelector('main').getBoundingClientRect().top + scrollY"),)
            assert page.evaluate("document.querySelector('header').scrollWidth <= innerWidth"), (language, state)
        assert len(set(tops)) == 1, language
    assert "carga" in page.locator(".headlight").get_attribute("title")
    assert "suelo" in page.locator(".headlight").get_attribute("title")


UNDER = """() => [...document.querySelectorAll('.toast')].flatMap(toast => {
    const a = toast.getBoundingClientRect();
    return [...document.querySelectorAll('.fell, .plot, button, select, input')].filter(e => {
        const b = e.getBoundingClientRect();
        const beside = a.left >= b.right - 1 || b.left >= a.right - 1 || a.top >= b.bottom - 1 || b.top >= a.bottom - 1;
        return b.width > 3 && !toast.contains(e) && !beside;
    }).map(e => e.dataset.key ?? e.className);
})"""


@pytest.mark.parametrize(
    "size",
    [*((pytest.param(s, marks=pytest.mark.evidence)) for s in ((768, 1024), (390, 844))), (1366, 768), (390, 664)],
)
def test_what_the_corner_says_covers_nothing_to_press(open_page, size):
    """Under a robot that lies, with its button, at the top of the page and in the tour."""
    page = open_page
    page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    page.evaluate("upright.store.change({ controller: 'off' }); upright.store.send({ kind: 'StandUp', pitch: 0.1 })")
    until(page, "upright.store.snapshot.x[0][8] && document.querySelector('.fell button')")
    for level, key in (("info", "tooMany"), ("error", "setBack"), ("info", "restarted"), ("error", "ended")):
        page.evaluate(f"upright.store.hear({{ kind: 'Notice', level: '{level}', parts: {{}}, key: '{key}' }})")
    assert page.locator(".toast.error").count() == page.locator(".toast:not(.error)").count() == 1  # the latest of each
    for act in ("scrollTo(0, 0)", "upright.page.bring('Tour')"):
        page.evaluate(act)
        until(page, UNDER, lambda under: under == [])  # it scrolls gently


@pytest.mark.evidence
def test_a_slow_page_fills_its_traces_from_the_history(page):
    page.evaluate("""() => {
        const hear = upright.store.hear.bind(upright.store);
        window.deaf = true;
        upright.store.hear = (m) => {
            if (m.kind === 'Snapshot') window.heard = m.t;
            if (!(window.deaf && m.kind === 'Snapshot')) hear(m);
        };
        window.heard = upright.store.snapshot.t;
    }""")
    page.click("[data-key=front]")
    t = page.evaluate("window.heard")
    until(page, f"window.heard > {t} + 1.5")
    for deaf, lasting in (("false", 300), ("true", 400), ("false", 0)):  # the second hole within a second of the first
        page.evaluate(f"window.deaf = {deaf}")
        page.wait_for_timeout(lasting)
    gaps = "upright.store.traces.t.slice(1).map((t, i) => t - upright.store.traces.t[i])"
    until(page, f"Math.max(...{gaps}) < 0.15")  # from 0.15 s on the page asks for a hole; more of them is no hole
    assert page.evaluate(f"Math.min(...{gaps}) > 0")
    assert page.evaluate("upright.store.traces.volts[0].every(Number.isFinite)")
    lengths = "[upright.store.traces.estimate, ...upright.store.traces.x.flat()].map(t => t.length)"
    assert len(set(page.evaluate(lengths))) == 1


@pytest.mark.evidence
def test_gains_by_hand_begin_with_those_of_the_present_controller(page):
    gain = until(page, "upright.store.analysed?.gain[0]")
    page.select_option("[data-key=controller]", "gains")
    until(page, "upright.store.changed.setup.controller === 'gains'")
    assert setup(page)["gains"] == gain
    page.select_option("[data-key=controller]", "pid")  # which has no such gains: the regulator's take their place
    until(page, "upright.store.changed.setup.controller === 'pid' && upright.store.analysed?.gain.length === 0")
    page.select_option("[data-key=controller]", "gains")
    until(page, "upright.store.analysed?.gain[0]?.some(v => Math.abs(v) > 1)")
    assert "Stand" not in page.inner_text(".fell")
    assert page.locator("[data-key=gain-0]").get_attribute("aria-valuetext") != "0"


def test_a_calibration_that_is_done_is_no_red_toast(open_page):
    """Whatever it found: red is for what went wrong."""
    page = open_page
    page.evaluate(HEARD, ["calibrate", "en", ""])
    toast = page.locator(".toast").last
    assert "Calibrate – sound" in toast.inner_text()
    assert "error" not in toast.get_attribute("class")


def test_a_job_says_what_it_computes_and_how_long_it_still_takes(open_page):
    """A third of what is left was done in 1.2 s: two thirds take twice as long."""
    page = open_page
    tab(page, "Identify")
    tell = "upright.store.hear({{kind: 'Progress', job: 'calibrate', fraction: {}}})"
    page.evaluate(tell.format(0))
    assert "one at a time" in page.inner_text(".bar")
    page.evaluate("upright.clock = performance.now(); performance.now = () => upright.clock")  # of the test alone
    page.evaluate(tell.format(0.1))
    page.evaluate("upright.clock += 1200")
    page.evaluate(tell.format(0.4))
    found = re.search(r"40 % · about (\d+) s left\s+Searching for the parameters", page.inner_text(".bar"))
    assert found
    assert int(found[1]) == 3  # 2.4 s, and no less
    page.evaluate(tell.format(1))
    assert page.locator(".bar").count() == 0


ENGLISH = (
    r"\b(?:the|of|and|with|from|is|are|to|in|at|by|under|this|that|more|delay|gain|pitch|wheel|body|mass|survives)\b"
)


@pytest.mark.evidence
def test_spanish_is_spanish_to_the_last_decimal(page):
    """No English word in any tab but in names of files and robots, and no decimal point."""
    page.select_option("[data-key=language]", "es")
    lit(page, TASKS["light"](lambda *_: None, Setup()))  # with all its reasons
    page.click("[data-key=impulse]")
    until(page, "upright.store.snapshot.t > 2")
    for name in ("Controller", "Robot", "Kit", "See", "Identify", "Keep", "Tour"):
        tab(page, name)
        for view in ("loop", "portrait", "voltages", "estimate", "equations") if name == "See" else ("",):
            if view:
                page.select_option("[data-key=view]", view)
            if name == "Robot":
                page.click("summary")
                mass = page.locator("[data-key=number-body_mass]")
                assert "," in mass.input_value()
                mass.fill("0,61")
                mass.press("Enter")
                until(page, "upright.store.setup.numbers.body_mass === 0.61")
            if name == "Identify":
                t = page.evaluate("upright.store.snapshot.t")
                until(page, f"upright.store.snapshot.t > {t} + 0.5")  # a new mass begins a new log, of no row yet
                page.click("[data-key=doctor]")
                until(page, "upright.store.found?.job === 'doctor'")
            text = page.evaluate(
                "document.body.innerText + [...document.querySelectorAll('svg')].map(e => e.textContent)"
            )
            assert re.findall(rf".*{ENGLISH}.*", text) == [], (name, view)
            assert re.findall(r"\d\.\d[^.]*", text) == [], (name, view)
    said = page.evaluate("""() => [0.2, 0.05].map(impulse => {  // at once: what became of the knock comes at any time
        upright.store.hear({ kind: 'Recovered', impulse, effort: 1, best: 0.2, fell: false, single: true });
        return [...document.querySelectorAll('.fell span, .most')].map(e => e.innerText.replaceAll('\\u00a0', ' '));
    })""")
    for (fell, most), words in zip(
        said, ("0,2 N s, el mayor hasta ahora", "0,05 N s; el mayor hasta ahora 0,2 N s"), strict=True
    ):
        assert (fell, most) == (f"Se recuperó de un empujón de {words}", "mejor golpe 0,2 N s")  # which stays there
    page.evaluate("upright.store.change({ robot: 'twipr', numbers: {} })")  # under the kit of a LEGO robot
    page.wait_for_selector("text=El kit nxt mueve los motores por voltaje. Se esperaba: par, como en el robot.")


LABELS = """() => upright.page.charts.strips.filter(Boolean).slice(0, 2).flatMap(({root, plot}) => {
    const over = root.querySelector('.u-over').getBoundingClientRect();
    const lines = upright.store.traces.marks.map(m => ({...m, x: over.left + plot.valToPos(m.t, 'x')}))
        .filter(({x}) => x > over.left && x < over.right);
    return [...root.querySelectorAll('.event')].map(e => {
        const {left, right} = e.getBoundingClientRect();
        return {text: e.textContent, at: lines.filter(({x}) => x > left - 1.5 && x < right + 1.5)};
    });
})"""
"""Each label of a curve, and the lines of pushes that it touches."""

DRAWN = """async () => {
    upright.page.charts.draw();
    await new Promise(requestAnimationFrame);
}"""
"""The curves have drawn all that is known."""


@pytest.mark.evidence
@pytest.mark.parametrize("width", [390, 1366])
def test_each_push_is_named_at_its_own_line(page, width):
    """However many there are, a label touches one line, and says what was done there."""
    page.set_viewport_size({"width": width, "height": 844})
    page.evaluate("upright.store.send({kind: 'Play', paused: true, speed: 1})")
    until(page, "upright.store.snapshot.paused")
    send = "(message) => (message.kind === 'Strike' ? upright.store.push(message) : upright.store.send(message))"
    knock, hold = {"kind": "Strike", "what": "impulse", "size": 0.05}, {"kind": "Strike", "what": "front", "size": 0.1}
    stand, tilt = {"kind": "StandUp", "pitch": 0}, {"kind": "StandUp", "pitch": 0.1}
    fall = knock | {"size": 0.9}
    known = {"impulse": "knock", "front": "held from the front", "stood": "stood up", "tilt": "lean"}
    alone = {"self": "sets off by itself"}  # which it may do while nobody touches it
    named = set()
    for message, seconds in ((knock, 1), (hold, 4), (fall, 3), (stand, 2), (tilt, 1.5), (knock, 0.3), (knock, 3)):
        page.evaluate(send, message)
        before = page.evaluate("upright.store.snapshot.t")
        page.evaluate(send, {"kind": "Step", "periods": round(seconds * 100)})
        until(page, f"upright.store.snapshot.t > {before + seconds - 0.02} && upright.store.traces.t.at(-1) > {before}")
        page.evaluate(DRAWN)
        for label in page.evaluate(LABELS):
            assert len(label["at"]) == 1, (message, label)
            (mark,) = label["at"]
            size = f"{abs(mark['size']):g}" if mark["what"] != "tilt" else f"{math.degrees(abs(mark['size'])):.1f}"
            assert label["text"].startswith((known | alone)[mark["what"]]), label  # a push by its name, however short
            assert mark["what"] not in ("impulse", "tilt") or size in label["text"], label
            named |= {mark["what"]} - set(alone)
    assert named >= {"impulse", "stood"} if width == 390 else named == set(known)  # a phone has room for few


def test_the_full_certificate_stands_under_its_button(open_page):
    """In the same tab, in both languages, and no longer than its controller."""
    page = open_page
    tab(page, "Controller")
    until(page, "upright.store.settled && upright.store.analysed")
    made = {"en": "<h1>It may drive</h1>", "es": "<h1>Puede manejar</h1>"}
    heads = plain({"en": MAY_DRIVE, "es": PUEDE_MANEJAR})
    page.evaluate(
        "(message) => upright.store.hear({ kind: 'JobResult', job: 'certify', ...message })",
        {"heads": heads, "html": made},
    )
    assert page.get_attribute("#tab-Controller", "aria-selected") == "true"
    button, title = (page.locator(f"#panel {where}") for where in ("[data-key=certify]", ".certified h1"))
    below = title.bounding_box()["y"] - button.bounding_box()["y"]
    assert 0 < below < 400  # [px] in the same column of a panel 640 px high
    panel = page.locator("#panel").bounding_box()
    assert title.bounding_box()["y"] < min(panel["y"] + panel["height"], 640)  # it has come into sight
    tab(page, "Robot")
    tab(page, "Controller")
    page.select_option("[data-key=language]", "es")
    assert title.inner_text() == "Puede manejar"
    page.select_option("#panel [data-key=controller]", "lqi")
    until(page, "!document.querySelector('.certified').childElementCount")


@pytest.mark.evidence
def test_a_link_runs_at_full_speed(page):
    """Whatever slow motion was chosen before; and a page that is opened again shows the speed that there is."""
    page.select_option("[data-key=speed]", "0.1")
    page.evaluate("location.hash = '#robot=nxtway-gs&controller=lqr&push=impulse:0.05'")
    until(page, "upright.store.changed.setup.controller === 'lqr'")
    assert page.input_value("[data-key=speed]") == "1"
    page.select_option("[data-key=speed]", "0.05")
    page.evaluate("history.replaceState(null, '', location.pathname)")  # no link: the session goes on
    page.reload()
    ready(page)
    assert page.input_value("[data-key=speed]") == "1"
    began, t = time.monotonic(), page.evaluate("upright.store.snapshot.t")
    # at 1/20 it is never more than that part of the clock's time, however quick the machine
    until(page, "upright.store.snapshot.t", lambda now: now - t > max(0.5, 0.1 * (time.monotonic() - began)))


@pytest.mark.evidence
def test_compare_takes_the_opened_log(page, tmp_path):
    page.click("[data-key=impulse]")
    until(page, "upright.store.snapshot.t > 1.5")
    keep_csv(page, tmp_path / "friday.csv")
    tab(page, "Identify")
    page.set_input_files("[data-key=open-log]", str(tmp_path / "friday.csv"))
    until(page, "upright.store.found?.job === 'doctor'")
    assert "friday" in compared(page).read_text("utf-8")


def test_a_hand_in_of_the_page_is_graded(page, tmp_path):
    """From the link of a task on the worksheet to a verdict."""
    from upright.classwork.grading import grade_file
    from upright.classwork.tasks import TASKS
    from upright.classwork.worksheet import fragment

    page.evaluate(f"location.hash = {fragment(TASKS[0])!r}")  # pasted behind the address of the open page
    until(page, f"upright.store.changed.setup.seed === {TASKS[0].setup.seed}")
    page.click("[data-key=stand]")
    page.evaluate("upright.store.send({kind: 'Strike', what: 'impulse', size: 0.22})")
    until(page, "document.querySelector('.fell').textContent.includes('0.22')")  # it came back from it
    tab(page, "Keep")
    page.fill("[data-key=student]", "Ana")
    with page.expect_download() as fetched:
        page.click("[data-key=keep-handin]")
    fetched.value.save_as(tmp_path / "ana.json")
    graded = grade_file(tmp_path / "ana.json")
    assert (graded.student, graded.task, graded.verdict) == ("Ana", "push", "ok"), graded.why


def test_a_calibration_of_a_loaded_run_says_what_to_do_first(open_page):
    page = open_page
    page.evaluate("upright.store.change({ payload: 0.2 })")
    tab(page, "Identify")
    page.evaluate("""() => {  // no job begins, whose own result would come at any time
        upright.sent = upright.store.send;
        upright.store.send = (message) => message.kind === 'Start' || upright.sent(message);
    }""")
    page.click("[data-key=calibrate]")
    page.evaluate("upright.store.hear({ kind: 'Progress', job: 'calibrate', fraction: 0, runs: 0 })")
    page.evaluate(HEARD, ["calibrate", "en", ""])
    words = page.locator(".result .verdict b").inner_text()
    assert words.startswith("This run carried 200\u00a0g that the robot's file does not")


UNLIT = "upright.store.hear({ kind: 'Light', light: 'none', heads: {} })"


def test_a_certificate_that_waits_for_a_job_says_so(open_page):
    page = open_page
    tab(page, "Controller")
    waits, computes = page.evaluate(f"""() => {{ // at once: a light of the session's own comes at any time
        const calibrated = (fraction) => {{
            upright.store.hear({{ kind: 'Progress', job: 'calibrate', fraction, runs: 0 }});
            {UNLIT};
            return document.querySelector('.lit b').innerText;
        }};
        return [calibrated(0.3), calibrated(1)];
    }}""")
    assert (waits, computes) == ("waits for the job in Identify", "computing …")


@pytest.mark.evidence
def test_a_prepared_run_begins_when_its_controller_is_designed(page):
    """Until then another one drives: a sway that it left would fell the new one, and a push would judge the old."""
    last_step_of_the_tour(page)
    page.evaluate("""() => {
        window.stood = [];
        window.told = [];
        const { store } = upright;
        const send = store.send;
        store.send = (message) => {
            if (message.kind === 'StandUp') stood.push(store.changed.busy);
            send(message);
        };
        const text = () => document.querySelector('.fell').innerText;
        store.listen(({ kind, busy }) => kind === 'Changed' && told.push([busy, text()]));
    }""")
    page.click("[data-key=tour-set]")
    until(page, "stood.length === 2")
    assert page.evaluate("stood[1]") is False
    told = page.evaluate("told")
    assert [text for busy, text in told if busy and "another controller drives" in text]
    until(page, "document.querySelector('.fell').innerText === 'The new controller drives now: push the robot.'")


def last_step_of_the_tour(page: Any) -> None:
    page.evaluate("upright.page.bring('Tour')")
    for _ in range(8):
        page.click("[data-key=tour-next]")


def test_a_prepared_run_begins_with_its_words_though_the_robot_fell_meanwhile(page):
    """On a slow machine the controller before has time to drop it. It stands up again a moment after the new one is
    there, and what it lay for is no longer said; nor is it said again after a push."""
    last_step_of_the_tour(page)
    told = page.evaluate("""() => {  // at once, and with nothing sent: no message of the session's own comes in between
        const { store } = upright;
        const told = [];
        const hear = (message) => {
            store.hear(message);
            told.push(document.querySelector('.fell').innerText);
        };
        const rows = (lies) => store.snapshot.x.map((row) => [...row.slice(0, 8), lies]);
        const seen = (lies) => hear({ ...store.snapshot, x: rows(lies) });
        const changed = (busy) => hear({ ...store.changed, setup: store.setup, busy });
        store.send = () => undefined;
        document.querySelector('[data-key=tour-set]').click();
        changed(true);
        seen(1);
        changed(false);
        seen(1);
        seen(0);
        const push = { kind: 'Recovered', impulse: 0.1, effort: 1, best: 0, fell: true, single: true };
        hear(push);
        seen(1);
        seen(0);
        return told;
    }""")
    before, lies, _, lay, stands, _, fell, stood = told
    assert "another controller drives" in before
    assert "Stand up" in lies
    assert lies == lay
    assert stands == "The new controller drives now: push the robot."
    assert "0.1" in fell
    assert stood == ""


@pytest.mark.evidence
def test_what_has_the_focus_keeps_it(page):
    """While a design comes and goes: a slider goes on by keys, and Tab leads to the next field."""
    page.locator("[data-key=weight-0]").focus()
    for step in range(1, 5):
        page.keyboard.press("ArrowLeft")
        until(
            page,
            f"upright.store.settled && upright.store.analysed && upright.store.setup.largest[0] < {0.15 * 0.98**step}",
        )
        assert page.evaluate("document.activeElement.dataset.key") == "weight-0"
    assert page.evaluate("upright.store.snapshot.r[1]") == 0  # no key has turned the robot
    tab(page, "Robot")
    page.click("summary")
    for key in ("body_mass", "wheel_mass"):
        field = page.locator(f"[data-key=number-{key}]")
        field.focus()
        field.fill(str(float(field.input_value()) * 1.01))
        page.keyboard.press("Enter")
        until(page, f"upright.store.settled && upright.store.changed.setup.numbers.{key}")
        assert page.evaluate("document.activeElement.dataset.key") == f"number-{key}"
    t = page.evaluate("upright.store.snapshot.t")
    until(page, f"upright.store.snapshot.t > {t} + 0.5")  # the doctor asks for 20 rows since the last change
    tab(page, "Identify")
    page.click("[data-key=doctor]")
    until(page, "upright.store.found?.job === 'doctor'")
    assert page.evaluate("document.activeElement.dataset.key") == "doctor"


@pytest.mark.evidence
def test_the_fall_of_the_tour_fills_its_curve(page):
    """Its curve begins with the lean, in a window of a second, and stays when the robots lie; and nobody says that it
    balances by itself."""
    assert page.locator(".hint").inner_text().startswith("It balances")
    page.keyboard.press("n")
    page.click("[data-key=tour-next]")
    page.click("[data-key=tour-set]")
    until(page, "upright.store.changed.setup.controller === 'off'")
    page.evaluate("upright.store.send({ kind: 'Play', paused: false, speed: 0.5 })")  # not a tenth, for which one waits
    assert not page.locator(".hint > span").is_visible()
    until(page, "upright.store.lain")
    first, fallen = page.evaluate("[upright.store.traces.t[0], upright.store.lain]")
    assert page.evaluate("upright.store.traces.x[0][0][0]") == pytest.approx(0.02, abs=0.01)
    until(page, f"upright.store.snapshot.t > {fallen} + 1.1")  # a window later
    low, high = page.evaluate("(({min, max}) => [min, max])(upright.page.charts.strips[0].plot.scales.x)")
    assert high - low == pytest.approx(1.0)
    assert low - 0.3 < first < fallen < high  # the fall takes half of it
    assert fallen - first > 0.4
    top = "upright.page.charts.strips[0].plot.scales.y.max"
    assert 12 < page.evaluate(top) < 20  # [°] the step asks for the times of 6° and 12°
    page.click("[data-key=tour-next]")
    page.click("[data-key=tour-set]")
    until(page, f"{top} > 57")  # the next one shows the fall down to the floor


def test_what_is_said_follows_the_language(open_page):
    """Messages that stand there when the language is changed, in the room, in the corner and in a tab not open then."""
    page = open_page
    tab(page, "Keep")
    page.click("[data-key=link]")
    page.click("[data-key=keep-robot]")
    until(page, "document.querySelector('.saved a')")
    tab(page, "Controller")
    page.evaluate("upright.store.hear({kind: 'Notice', level: 'error', parts: {}, key: 'tooMany'})")
    page.evaluate(
        "upright.store.hear({kind: 'Recovered', impulse: 0.2, effort: 1, best: 0.2, fell: false, single: true})"
    )
    page.select_option("[data-key=language]", "es")
    texts = json.loads((WEB / "src" / "texts" / "es.json").read_text("utf-8"))
    assert (
        page.inner_text(".fell").replace("\N{NO-BREAK SPACE}", " ")
        == "Se recuperó de un empujón de 0,2 N s, el mayor hasta ahora"
    )
    assert texts["tooMany"] in page.locator(".toast").all_inner_texts()[-1]
    tab(page, "Keep")
    assert re.findall(rf".*{ENGLISH}.*", page.inner_text(".links .note")) == []
    assert page.inner_text(".saved").startswith(texts["saved"])
    page.evaluate("upright.store.push({ kind: 'Strike', what: 'impulse', size: 0.8 })")
    until(page, "document.querySelector('.fell button')")
    for language, words in (("en", "It fell"), ("es", "Se cayó")):
        page.select_option("[data-key=language]", language)
        assert page.inner_text(".fell").startswith(words)
