"""The lab without Python: the page itself, in Chromium. What is printed for it: `test_lab_printed.py`."""

from __future__ import annotations

import shlex
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import EXPORTED
from test_lab_printed import DRIVEN, EXCITED
from upright.bodies import Electronics, NonlinearBody
from upright.classwork.grading import grade_file
from upright.classwork.tasks import TASKS
from upright.classwork.worksheet import fragment
from upright.cli.main import group
from upright.control import CONTROLLERS
from upright.experiment import Impulse, run
from upright.lab.codec import plain
from upright.lab.export import export
from upright.lab.handin import read_hand_in
from upright.lab.rerun import rerun
from upright.robots import Kit, Robot, preset_names
from upright.signals import STATE_NAMES, Log

BROWSER = [pytest.mark.needs("chromium", "module:playwright")]
LINKED = "#robot=twipr&controller=sliding&noise=0&bodies=nonlinear&push=impulse:0.2"


def marked(test: Any) -> Any:
    """A test of the page in a browser."""
    for mark in BROWSER:
        test = mark(test)
    return test


@pytest.fixture(scope="module")
def site(exported_lab: Path) -> Path:
    """The page with every usual controller."""
    return exported_lab


LEANT = "upright.store.traces.t.some((t, k) => t > {} && upright.store.traces.x[0][0][k] < -0.01)"
"""Whether it has leant back since that time: a moment of it that a busy machine may not see passing."""


@pytest.fixture
def unopened(browser: Any, site: Path, lend: Any) -> Iterator[Any]:
    """A browser without network, for the page in its folder, which asks for nothing but itself."""
    made = lend(browser, 1366, 768, offline=True)
    yield made
    assert [url for url in made.asked if not url.startswith((site.as_uri(), "data:"))] == []
    assert made.wrong == []


@pytest.fixture
def page(unopened: Any, site: Path) -> Any:
    """The page, opened."""
    opened(unopened, site)
    unopened.evaluate("upright.page.open('Controller')")  # a newcomer's page begins with the tour
    return unopened


def opened(page: Any, site: Path, link: str = "") -> None:
    page.goto("about:blank")
    page.goto(site.as_uri() + link)
    page.wait_for_function("window.upright?.page.drawnFirst")


def send(page: Any, **message: Any) -> None:
    page.evaluate("(message) => upright.store.send(message)", message)


@pytest.mark.evidence
def test_the_page_of_every_preset_is_small(tmp_path):
    assert len(export(tmp_path).read_bytes()) < 0.25e6 * len(preset_names())  # the bar was 1.5 MB for six presets


@marked
def test_the_page_s_session_is_python_s_run(page):
    """At rest under a knock, with all its noise: what the page shows after 3 s is what `run` computes."""
    robot = Robot.preset("nxtway-gs")
    kit = Kit.preset("nxt")
    send(page, kind="Play", paused=True, speed=1)
    page.evaluate("upright.store.change({ noise: 1, controller: 'lqg' })")
    send(page, kind="StandUp", pitch=0)
    send(page, kind="Strike", what="impulse", size=0.05)
    send(page, kind="Step", periods=300)
    shown = page.evaluate("upright.store.snapshot.x[0].slice(0, 6)")
    controller = CONTROLLERS["lqg"](robot, kit, kit.period)
    log = run(Electronics(NonlinearBody(robot), kit), controller, Impulse(impulse=0.05, start=0.0, duration=0.02),
              seconds=3.01)  # fmt: skip
    python = [log[f"truth/{name}"][-1] for name in STATE_NAMES]
    assert log.t[-1] == pytest.approx(3.0)
    assert np.abs(np.array(shown) - python).max() < 1e-6  # quanta are on: differences are not forgotten


@marked
def test_a_link_carries_robot_controller_and_push(unopened, site):
    page = unopened
    opened(page, site, LINKED)
    setup = page.evaluate("upright.store.setup")
    assert (setup["robot"], setup["controller"], setup["noise"]) == ("twipr", "sliding", 0)
    page.wait_for_function(LEANT.format(0))  # a second later it is pushed
    assert page.evaluate("upright.page.address()") == site.as_uri() + LINKED


@marked
def test_links_of_the_worksheet_set_the_page_up_too(unopened, site):
    """The first opens the page; the others come one after the other into the open one: nothing of the task before
    stays."""
    page = unopened
    opened(page, site, fragment(TASKS[2]))
    for number, task in enumerate((TASKS[2], TASKS[1], TASKS[2], TASKS[0])):
        if number:
            page.evaluate(f"location.hash = {fragment(task)!r}")
        page.wait_for_function(f"upright.store.setup.seed === {task.setup.seed}")
        setup = page.evaluate("upright.store.setup")
        assert {name: setup[name] for name in task.given} == {name: plain(task.setup)[name] for name in task.given}
        assert task.name != "gains" or tuple(setup["gains"]) == task.setup.gains
    page.evaluate("location.hash = '#payload=0.12&payload_height=0.3'")  # which this page does not have
    page.wait_for_function("upright.store.setup.seed === 0")
    assert page.evaluate("upright.store.setup.payload") == 0


@marked
def test_margins_are_those_of_the_kit_s_own_dead_time(page):
    """The controller stays as it was designed: who moves the slider is told for which dead time its margins are."""
    page.evaluate("upright.store.change({ robot: 'nxtway-gs', controller: 'lqg' })")
    judged = page.locator("#panel .numbers")
    judged.locator(".badge").wait_for()
    assert judged.locator(".badge").inner_text() == "stable, with small margins"
    assert "dead time" not in judged.inner_text()
    page.evaluate("upright.store.change({ delay: 0.04 })")
    judged.locator("text=The slider has 40\u00a0ms.").wait_for()
    assert "the kit's own dead time, 2 ms" in judged.inner_text()
    page.evaluate("upright.store.change({ delay: -1, controller: 'gains' })")
    judged.locator("text=at both motors").first.wait_for()
    assert "computes one for gains by hand" in page.locator(".note.column.full").inner_text()


@marked
def test_a_payload_is_put_on_and_taken_off(page):
    page.click("#tab-Robot")
    weight = page.evaluate("upright.store.changed.look.weight")
    page.click("[data-key=load]")
    assert "300 g" in page.inner_text("label[for=load]")
    # 300 g more, at 9.81 m/s² or what the preset has: a part in a hundred
    assert page.evaluate("upright.store.changed.look.weight") - weight == pytest.approx(0.3 * 9.81, rel=0.01)
    page.click("[data-key=load]")
    assert page.evaluate("upright.store.changed.look.weight") == weight
    page.select_option("[data-key=robot]", "twipr")
    page.click("[data-key=load]")  # every robot of the page can carry it
    assert page.evaluate("upright.store.changed.look.payload") == 0.3


@marked
def test_a_slope_is_drawn_as_steep_as_it_is(page):
    """Positive climbs forward, to the right of the side view; the robot's pitch counts from the floor's normal."""
    page.evaluate("upright.store.change({slope: 0.1, controller: 'off'})")
    page.evaluate("upright.store.send({kind: 'Step', periods: 1})")
    page.wait_for_function("document.querySelector('.ground').getCTM().b")
    steep = "(part => Math.atan2(-part.getCTM().b, part.getCTM().a))(document.querySelector('%s'))"
    assert page.evaluate(steep % ".ground") == pytest.approx(0.1, abs=1e-4)
    lean = page.evaluate("upright.store.snapshot.x[0][0]")
    page.wait_for_function(f"Math.abs({steep % '.shell'} - {0.1 - lean!r}) < 1e-3")  # forward is clockwise; once drawn
    assert "5.7°" in page.inner_text(".force")


@marked
def test_traces_are_broken_where_the_robot_does_not_go_on(page):
    """By another controller, and by standing up; not by a knock, however fast it makes the wheels."""
    send(page, kind="Step", periods=20)
    send(page, kind="Strike", what="impulse", size=0.2)
    send(page, kind="Step", periods=100)
    assert page.evaluate("upright.store.traces.breaks.length") == 0
    page.evaluate("upright.store.change({controller: 'pid'})")
    send(page, kind="Step", periods=20)
    send(page, kind="StandUp", pitch=0.0)
    send(page, kind="Step", periods=1)
    (_, first), (_, second) = page.evaluate("upright.store.traces.breaks")
    # 20 periods of 10 ms, less the one or two until the new controller is drawn; standing up is drawn at once
    assert second - first == pytest.approx(0.185, abs=0.006)
    send(page, kind="StandUp", pitch=0.1)
    send(page, kind="Step", periods=1)
    t, pitch = page.evaluate("[upright.store.traces.t, upright.store.traces.x[0][0]]")
    _, (_, third) = page.evaluate("upright.store.traces.breaks.slice(-2)")
    assert pitch[t.index(third)] == 0.1  # the lean that was asked for, before the robot moves


@pytest.mark.parametrize(
    "part",
    [
        "robot=nobody", "gains=1,2",
        *(pytest.param(part, marks=pytest.mark.evidence)
          for part in ("%", "controller=__proto__", "slope=9", "push=impulse:1e9")),
    ],
)  # fmt: skip
@marked
def test_a_link_that_makes_no_sense_is_the_usual_page(unopened, site, part):
    page = unopened
    opened(page, site, f"#{part}")
    assert page.evaluate("[upright.store.setup.robot, upright.store.setup.controller]") == ["nxtway-gs", "lqg"]
    name, _, value = part.partition("=")
    if name in ("robot", "controller"):  # a mistyped name is said, with what there is
        said = page.inner_text(".toast span")
        assert f"{name} '{value}'" in said
        assert ("twipr" if name == "robot" else "lqi") in said
    elif name in ("gains", "slope", "push"):
        assert part in page.inner_text(".toast span")


@marked
def test_gains_by_hand_begin_with_the_present_ones_and_act_at_once(page):
    page.select_option("[data-key=controller]", "lqr")
    present = page.evaluate("upright.store.analysed.gain[0]")
    page.select_option("[data-key=controller]", "gains")
    assert page.evaluate("upright.store.setup.gains") == present[:6]
    typed = page.locator("[data-key=gain-0-typed]")
    page.select_option("[data-key=language]", "es")  # as people type there
    for text, gain in (("-30,5", -30.5), ("-30,5,1", -30.5), (str(present[0]), present[0])):
        typed.fill(text)
        typed.press("Enter")
        page.wait_for_function(f"upright.store.setup.gains[0] === {gain!r}")
        assert (typed.get_attribute("aria-invalid") == "true") == (text == "-30,5,1")
    page.wait_for_function(
        "upright.store.analysed?.heads.es.verdict.startsWith('estable, con márgenes')"
    )  # as the LQR's
    assert page.locator(".numbers dt").count() == 3
    assert not page.evaluate("upright.store.snapshot.x[0][8]")
    send(page, kind="StandUp", pitch=0.05)
    page.evaluate("upright.store.change({ gains: [0, 0, 0, 0, 0, 0] })")
    page.wait_for_function("upright.store.snapshot.x[0][8] === 1")  # nothing holds it: it falls
    page.wait_for_function("upright.store.analysed?.stable === false")


@marked
def test_a_link_without_a_controller_drops_the_robot(unopened, site):
    """From a small lean: upright, without noise at its wheels, it would stand for seconds."""
    page = unopened
    opened(page, site, "#controller=off")
    page.wait_for_function("upright.store.snapshot?.x[0][8] === 1")
    assert page.evaluate("upright.store.setup.controller") == "off"
    assert not page.locator(".hint").is_visible()  # what balances by itself does not lie there


@marked
def test_the_tour_has_the_steps_that_need_no_python(page):
    page.keyboard.press("n")
    for step, controller in enumerate(("lqg", "off", "off", "lqr", "lqg", "lqg", "lqr"), 1):
        assert f"{step} of 7" in page.inner_text(".tour .note")
        if step > 1:
            page.keyboard.press("Enter")
        page.wait_for_function(f"upright.store.changed.setup.controller === '{controller}'")
        page.keyboard.press("n")
    assert page.evaluate("upright.store.changed.setup.payload") > 0
    page.click("[data-key=tour-back]")
    assert page.evaluate("upright.store.changed.setup.payload") == 0


@pytest.mark.evidence
@marked
def test_a_phone_does_the_tour_where_it_is_read(browser, site, lend):
    """What a step names is in its card, and does what the real control does; a tap makes a curve large."""
    page = lend(browser, 390, 844, has_touch=True, offline=True)
    page.goto(site.as_uri())
    page.wait_for_function("window.upright?.page.drawnFirst")
    page.click("[data-key=invitation]")
    page.wait_for_selector(".scene.pinned")
    send(page, kind="Play", paused=True, speed=1)  # it may fall under the first knock, and then takes no second one
    page.click("[data-key='act-0.3']")
    assert page.evaluate("upright.store.last.push") == ["impulse", 0.3]
    assert page.input_value("[data-key=knock]") == page.input_value("[data-key=act-size]") == "0.3"
    assert page.inner_text("[data-key=impulse]").split() == ["Knock", "0.30", "N", "s"]
    page.fill("[data-key=act-size]", "0.1")
    page.click("[data-key=impulse]")
    assert page.evaluate("upright.store.last.push") == ["impulse", 0.1]
    send(page, kind="Play", paused=False, speed=1)
    span = "(({min, max}) => max - min)(upright.page.charts.strips[0].plot.scales.x)"
    for large in (True, False):
        page.click(".slot .strip:first-child .plot")
        page.wait_for_function(f"{'' if large else '!'}document.querySelector('.slot .strip.large')")
        page.wait_for_function(f"Math.abs({span} - 10) < 0.01")  # [s] that are shown, large or small
        box = page.locator(".slot .plot").first.bounding_box()
        assert (box["height"] >= 150 and box["width"] > 350) == large  # [px] of a page 390 wide
    page.click("[data-key=curves]")  # beside the names of the bodies
    page.wait_for_function("document.querySelectorAll('.charts .strip').length === 4")
    assert page.locator(".charts .strip").last.is_visible()
    assert page.locator(".charts .strip").last.bounding_box()["y"] < 844
    page.evaluate("upright.page.bring('Tour')")
    while not page.locator("[data-key=act-tilt]").count():
        page.click("[data-key=tour-next]")
    page.click("[data-key=act-tilt]")
    page.wait_for_function("upright.store.last.push?.[0] === 'tilt'")


@pytest.mark.evidence
@marked
def test_a_robot_that_sets_off_by_itself_is_marked_so(page, site):
    """Once, where the wheels begin to roll; not where somebody has pushed it before, or has changed it."""
    send(page, kind="Play", paused=True, speed=1)
    page.evaluate("upright.store.change({ noise: 3 })")  # soon enough
    for push in (False, True):
        send(page, kind="StandUp", pitch=0)
        if push:
            send(page, kind="Strike", what="impulse", size=0.05)
        send(page, kind="Step", periods=1)
        for _ in range(100):
            send(page, kind="Step", periods=10)
        marks = page.evaluate("upright.store.traces.marks.map(m => m.what)")
        assert marks == (["stood", "self", "stood", "impulse"] if push else ["stood", "self"])


@marked
def test_every_controller_of_every_robot_stands_up_again_from_a_lean(page):
    """A lean of 0.05 rad; the one of the true state alone cannot bear TWIPR's dead time of 53 ms, as in Python."""
    fell: list[str] = []
    send(page, kind="Play", paused=True, speed=1)
    for robot in EXPORTED:
        for name in page.evaluate(f"Object.keys(upright.exported.laws['{robot}'])"):
            page.evaluate(f"upright.store.change({{ robot: '{robot}', controller: '{name}', gains: [] }})")
            send(page, kind="StandUp", pitch=0.05)
            send(page, kind="Step", periods=400)
            fell += [f"{robot} {name}"] if page.evaluate("upright.store.snapshot.x[0][8]") else []
    assert fell == ["twipr lqr-state"]


@marked
def test_it_is_pushed_by_mouse_key_and_button(page):
    send(page, kind="Play", paused=True, speed=1)  # it stands still until it is held
    page.wait_for_function("upright.store.settled && upright.store.analysed")
    body = page.locator(".flat .shell")
    body.hover()  # waits until the mouse would hit it
    page.mouse.down()
    box = body.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2 + 60, box["y"] + box["height"] / 2, steps=4)
    send(page, kind="Play", paused=False, speed=1)
    page.wait_for_function("upright.store.snapshot.f[0] > 0.05")
    page.mouse.up()
    page.wait_for_function("upright.store.snapshot.f[0] === 0")
    said, link = page.evaluate("[upright.store.last.kept, upright.page.address()]")
    assert ("push=impulse:" in link) == (said == "knockPush")  # a short push goes as a knock, a long one not at all
    assert said in ("knockPush", "heldPush")
    page.keyboard.down("b")
    page.wait_for_function("upright.store.snapshot.f[0] > 0.05")
    page.keyboard.up("b")
    page.click("[data-key=stand]")
    stood = page.evaluate("upright.store.snapshot.t")
    page.click("[data-key=impulse]")
    page.wait_for_function(LEANT.format(stood))  # a knock forward at its middle


@marked
def test_two_knocks_are_no_record_and_one_has_the_size_of_the_slider(page):
    send(page, kind="Play", paused=True, speed=1)
    page.fill("[data-key=knock]", "0.2")
    for count, record in ((2, ""), (1, "best knock 0.2 N s")):
        send(page, kind="StandUp", pitch=0)
        for _ in range(count):
            page.click("[data-key=impulse]")
            send(page, kind="Step", periods=70)  # it stands, and moves on
        send(page, kind="Step", periods=400)
        assert page.inner_text(".most").replace("\N{NO-BREAK SPACE}", " ") == record
        assert ("not from a single push" in page.inner_text(".fell")) == (count == 2)


@marked
@pytest.mark.parametrize(
    ("setup", "lean"),
    [
        pytest.param({"robot": "nxtway-gs", "controller": "lqg"}, 0.05, marks=pytest.mark.evidence),
        ({"robot": "nxtway-gs", "controller": "gains", "noise": 3, "delay": 0.01, "slope": 0.02}, 0.0),
        pytest.param({"robot": "twipr", "controller": "hinf", "seed": 5}, 0.05, marks=pytest.mark.evidence),
        pytest.param(
            {"robot": "nxtway-gs", "controller": "lqi", "payload": 0.3, "payload_height": 0.3},
            0.0,
            marks=pytest.mark.evidence,
        ),
    ],
)
def test_what_a_student_hands_in_is_run_again(page, tmp_path, setup, lean):
    """Noise and all: the page counts its random numbers, and the rerun counts the same. Two digits of the peak are the
    grades' tolerance; a part in ten thousand is what differences in the last bit have become after 5 s, and more: it
    is handed in after 3."""
    send(page, kind="Play", paused=True, speed=1)
    page.evaluate("(setup) => upright.store.change({ gains: [], ...setup })", setup)
    page.select_option("[data-key=language]", "en")
    page.click("#tab-Keep")
    page.fill("[data-key=student]", "José Ñandú")
    page.click("[data-key=keep-handin]")
    assert "press Stand up" in page.locator(".toast.error").inner_text()  # nothing to hand in yet
    send(page, kind="Step", periods=20)
    send(page, kind="Steer", speed=0.05, rate=0.1)
    send(page, kind="StandUp", pitch=lean)
    for periods, action in (
        (50, {"kind": "Strike", "what": "impulse", "size": 0.05}),
        (100, {"kind": "Drag", "force": 0.2, "height": 0.1}),
        (40, {"kind": "Drag", "force": 0, "height": 0.1}),
        (10, {"kind": "Strike", "what": "pull_left", "size": 0.3}),
    ):
        send(page, kind="Step", periods=periods)
        send(page, **action)
    send(page, kind="Step", periods=100)
    with page.expect_download() as saved:
        page.click("[data-key=keep-handin]")
    saved.value.save_as(tmp_path / "hand-in.json")
    done = read_hand_in(tmp_path / "hand-in.json")
    assert done.sealed
    assert done.student == "José Ñandú"
    assert [type(action).__name__ for _, action in done.actions] == ["Steer", "Strike", "Drag", "Drag", "Strike"]
    replayed = rerun(done)
    assert (replayed.fell, replayed.seconds, replayed.best) == (False, done.claimed.seconds, done.claimed.best)
    assert (replayed.peak, replayed.travel) == pytest.approx((done.claimed.peak, done.claimed.travel), rel=1e-4)
    assert grade_file(tmp_path / "hand-in.json").verdict == "ok"


@marked
def test_the_traces_are_kept_as_a_log_that_upright_reads(page, tmp_path):
    send(page, kind="Play", paused=True, speed=1)
    send(page, kind="StandUp", pitch=0.05)
    send(page, kind="Step", periods=100)
    page.click("#tab-Keep")
    with page.expect_download() as saved:
        page.click("[data-key=keep-csv]")
    saved.value.save_as(tmp_path / "run.csv")
    log = Log.load(tmp_path / "run.csv")
    assert log["truth/pitch"][-1] == page.evaluate("upright.store.snapshot.x[0][0]")
    assert log.t[-1] == page.evaluate("upright.store.snapshot.t")
    assert (log.units["truth/yaw_rate"], log.units["applied/left"]) == ("rad/s", "V")


@marked
def test_what_this_page_lacks_is_said_where_it_is_looked_for(page):
    """In one plain sentence each: strictness under Controller, report and replay under Keep."""
    page.click("#tab-Controller")
    assert "To change something here, choose Gains by hand." in page.inner_text("#panel")
    page.click("#tab-Keep")
    assert "A report and a replay page need Python" in page.inner_text("#panel")


@marked
def test_a_link_that_is_opened_in_slow_motion_runs_at_full_speed(page):
    """And sets the size of the knock that it has."""
    page.select_option("[data-key=speed]", "0.1")
    page.evaluate("location.hash = '#robot=nxtway-gs&controller=lqr&push=impulse:0.06'")
    page.wait_for_function("upright.store.setup.controller === 'lqr'")
    page.wait_for_function("document.querySelector('[data-key=knock]').value === '0.06'")
    assert page.input_value("[data-key=speed]") == "1"
    page.wait_for_function(LEANT.format(0))  # its push comes after a second


@pytest.mark.evidence
@marked
def test_what_needs_python_says_so_with_its_command(page):
    for language in ("en", "es"):
        page.select_option("[data-key=language]", language)
        page.click("#tab-Python")
        commands = page.locator(".commands code").all_inner_texts()
        assert "upright calibrate run.csv --robot nxtway-gs" in commands
        for robot, first in (("twipr", DRIVEN), ("nxtway-gs", EXCITED)):
            page.evaluate("(robot) => upright.store.change({ robot })", robot)
            page.click("#tab-Python")
            commands = page.locator(".commands code").all_inner_texts()
            assert commands[0] == first  # a log that moves enough for an inertia, of this robot
            for line in commands:
                name, *arguments = shlex.split(line)[1:]
                group().commands[name].make_context(name, arguments)  # raises where it is no such call


@pytest.mark.parametrize(
    ("scheme", "tabs"),
    [
        ("light", ("Controller", "Robot")),  # where most stands to be pressed
        *(pytest.param(scheme, ("Controller", "Robot", "See", "Python"), marks=pytest.mark.evidence)
          for scheme in ("light", "dark")),
    ],
)  # fmt: skip
@marked
def test_axe_core_finds_nothing_serious_in_any_tab(browser, site, axe, lend, scheme, tabs):
    page = lend(browser, scheme=scheme, offline=True)
    page.goto(site.as_uri())
    page.wait_for_function("window.upright?.page.drawnFirst")
    page.add_script_tag(path=str(axe))
    serious: list[str] = []
    for tab in tabs:
        page.click(f"#tab-{tab}")
        for rule in page.evaluate("axe.run().then((result) => result.violations)"):
            if rule["impact"] in ("serious", "critical"):
                serious += [f"{tab}: {rule['id']}: {node['html'][:200]}" for node in rule["nodes"]]
    assert not serious


# Bad input
