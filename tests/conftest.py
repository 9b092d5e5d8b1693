"""What some tests need, and the rule that with UPRIGHT_REQUIRE_ALL=1 nothing may be left out."""

from __future__ import annotations

import hashlib
import json
import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the tests themselves run side by side; set before numpy loads
os.environ.setdefault("UPRIGHT_LANG", "en")  # where the system speaks Spanish, too

import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Generator, Iterator
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
SHARED = CHECKOUT.parent / "shared"
LAB = CHECKOUT / "src" / "upright" / "lab" / "web"
if sys.dont_write_bytecode:  # as many images set it: each process that a test starts would compile the package again
    os.environ.setdefault("PYTHONPYCACHEPREFIX", str(CHECKOUT / ".pytest_cache" / "bytecode"))
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    sys.dont_write_bytecode, sys.pycache_prefix = False, os.environ["PYTHONPYCACHEPREFIX"]
REQUIRE_ALL = os.environ.get("UPRIGHT_REQUIRE_ALL", "") not in ("", "0")


def missing(need: str) -> bool:
    """Whether a folder or file ("shared/data/regbot"), a module ("module:cvxpy") or a program ("node") is absent."""
    if need.startswith("/"):
        return not Path(need).exists()
    if need.startswith("shared/"):
        return not (SHARED.parent / need).exists()
    if need.startswith("module:"):
        return find_spec(need.removeprefix("module:")) is None
    return shutil.which(need) is None


MODEST = 5
"""Of nice, as the jobs of one user's lab have it: those that a test waits for are no worse off than the other tests."""


def pytest_configure(config: pytest.Config) -> None:
    if "PYTEST_XDIST_WORKER" in os.environ and hasattr(os, "nice"):
        os.nice(max(0, MODEST - os.nice(0)))
    for name in ("SIGINT", "SIGHUP"):  # a run in the background ignores them: what it starts must not
        if signal.getsignal(getattr(signal, name, signal.SIGINT)) == signal.SIG_IGN:
            signal.signal(getattr(signal, name), signal.default_int_handler)
    config.addinivalue_line(
        "markers",
        "needs(*what): skip where 'shared/…', 'module:…' or a program is not there; fail if UPRIGHT_REQUIRE_ALL=1",
    )


BROWSER = frozenset(("test_lab_page", "test_lab_exported", "test_browser_pages"))
"""Files with a browser, and a lab beside it: two at once take more than two cores."""

FIRST = (
    "browser", "test_site", "test_reproduce", "test_postmortem", "test_first_robot", "test_head", "test_calibrate",
    "test_foreign_robots", "test_readme", "test_designs", "test_firmware_parity", "test_support", "test_doctor",
    "test_firmware_brick", "test_margins", "test_identify", "test_report", "test_lab_session", "test_docs",
)  # fmt: skip
"""Units of work that take longest: begun first, so that all processes end at about the same time."""


SOURCES = frozenset(("test_architecture", "test_budget"))
"""Files that look at the syntax tree of every source."""


def unit_of(path: str) -> str:
    """The unit of work that a file belongs to: one process runs it whole, and computes once what its tests share."""
    stem = Path(path).stem
    if stem in SOURCES:
        return "sources"
    return "browser" if stem in BROWSER else stem


MADE_BEFORE = {("test_site", "site"): "UPRIGHT_SITE", ("test_reproduce", "done"): "UPRIGHT_REPRODUCED"}
"""Fixtures, by their file, that take minutes unless somebody made them before and says where, as CI does."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What waits minutes for a fixture is `evidence`. The longest units of work come first."""
    for item in items:
        for (stem, fixture), where in MADE_BEFORE.items():
            if item.path.stem == stem and fixture in getattr(item, "fixturenames", ()) and not os.environ.get(where):
                item.add_marker(pytest.mark.evidence)
    rank = {unit: number for number, unit in enumerate(FIRST)}
    items.sort(key=lambda item: rank.get(unit_of(item.path.name), len(FIRST)))


def pytest_xdist_auto_num_workers(config: pytest.Config) -> int | None:
    """One process more than there are cores: some tests wait for a browser, a flight or a server."""
    if "PYTEST_XDIST_AUTO_NUM_WORKERS" in os.environ:
        return None  # pytest-xdist reads it
    return len(os.sched_getaffinity(0)) + 1 if hasattr(os, "sched_getaffinity") else None


def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """By files, not by `xdist_group`: pytest-xdist 3.8 reads those marks into an attribute that pytest 9.2 no longer
    has, and then every process computes for itself what groups should share."""
    from xdist.scheduler import LoadFileScheduling

    class Units(LoadFileScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return unit_of(nodeid.partition("::")[0])

    return Units(config, log)


def pytest_runtest_setup(item: pytest.Item) -> None:
    for mark in item.iter_markers("needs"):
        absent = [need for need in mark.args if missing(need)]
        if absent:
            pytest.skip(f"needs {', '.join(absent)}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if not hasattr(report, "wasxfail"):
        _refuse_skip(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    _refuse_skip(report)
    return report


def _refuse_skip(report: pytest.TestReport | pytest.CollectReport) -> None:
    if REQUIRE_ALL and report.outcome == "skipped":
        reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        report.outcome = "failed"
        report.longrepr = f"UPRIGHT_REQUIRE_ALL=1 allows no skip, but: {reason}"


@pytest.fixture
def shared() -> Path:
    """The folder beside the checkout that holds measured logs; mark the test with `needs("shared/…")`."""
    return SHARED


PATIENCE = 300.0
"""[s] A guard against what never ends, and no measurement: on a busy machine a second's work takes minutes."""

CALM = """{
    const later = window.setTimeout;
    window.setTimeout = (act, wait, ...given) => later(act, wait >= 6000 ? 1e9 : wait, ...given);
    window.requestAnimationFrame = (draw) => later(() => draw(performance.now()), 400);
}"""
"""A page whose messages stay, which go after 6 s or more: a busy machine may read them later. It draws hardly three
times a second: sixty times, in software, takes a core from what is tested, and five times a quarter."""


def patient(browser: Any) -> Any:
    """The browser, whose pages are `CALM` and wait `PATIENCE` for what is asked of them."""
    new = browser.new_context

    def context(**options: Any) -> Any:
        made = new(**options)
        made.set_default_timeout(1000 * PATIENCE)
        made.add_init_script(CALM)
        return made

    browser.new_context, browser.new_page = context, lambda **options: context(**options).new_page()
    browser.left = {}
    return browser


def listening(page: Any) -> Any:
    """The page, which notes what it asks for, and what errors it has and logs."""
    page.on("request", lambda request: page.asked.append(request.url))
    page.on("pageerror", lambda error: page.wrong.append(str(error)))
    page.on("console", lambda message: page.wrong.append(message.text) if message.type == "error" else None)
    return page


@pytest.fixture
def lend(request: pytest.FixtureRequest) -> Iterator[Any]:
    """`lend(browser, width, height, **options)`: a page as new, with nothing stored, in a context of its own. What it
    asked for is in `asked`, its errors in `wrong`.

    It is a page that another test has left, if there is one: for a new one the browser starts three processes, two
    seconds of work. A page on which something failed is left to nobody.
    """
    given: list[tuple[Any, list[Any]]] = []
    failed = request.session.testsfailed

    def lend(browser: Any, width: int = 1280, height: int = 720, scheme: str = "light", **options: Any) -> Any:
        left = browser.left.setdefault(repr(sorted(options.items())), [])
        page = left.pop() if left else listening(browser.new_context(**options).new_page())
        given.append((page, left))
        page.asked, page.wrong = [], []
        page.set_viewport_size({"width": width, "height": height})
        page.emulate_media(color_scheme=scheme, reduced_motion="reduce")  # what glides is drawn again and again
        return page

    yield lend
    for page, left in given:
        if page.is_closed():
            continue
        if request.session.testsfailed > failed:
            page.context.close()
            continue
        page.evaluate("for (const kept of [localStorage, sessionStorage]) kept.clear()")
        page.context.clear_cookies()
        page.mouse.move(-9, -9)  # over nothing
        page.goto("about:blank")
        left.append(page)


OPEN: list[Any] = []
"""The driver of browsers and the one browser, for all files of a unit of work: to begin them takes seconds."""


@pytest.fixture
def driver() -> Any:
    return _begun()[0]


@pytest.fixture
def browser() -> Any:
    """Without 3-D, as on some school machines: charts and buttons do everything but the picture."""
    return _begun()[1]


def _begun() -> list[Any]:
    if not OPEN:
        from playwright.sync_api import sync_playwright

        OPEN.append(sync_playwright().start())
        arguments = ["--no-sandbox", "--disable-3d-apis"]
        OPEN.append(patient(OPEN[0].chromium.launch(executable_path="/usr/bin/chromium", args=arguments)))
    return OPEN


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> None:
    """The browser ends with its unit of work: beside its driver no other test has an event loop."""
    if OPEN and (nextitem is None or unit_of(nextitem.path.name) != unit_of(item.path.name)):
        OPEN.pop().close()
        OPEN.pop().stop()


def common(factory: pytest.TempPathFactory, name: str) -> Path:
    """A temporary folder of that name for all processes of this run."""
    base = factory.getbasetemp()
    return (base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base) / name


@pytest.fixture(scope="session")
def nbc_once(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """What nbc made of a text it need not make again, which takes it a second: all flights have the same program."""
    from upright.execution import execute_nxc

    folder, run_tool = common(tmp_path_factory, "nbc"), execute_nxc.run_tool

    def once(command: list[str], what: str) -> str:
        *options, source = command
        made = [Path(option[3:]) for option in options if option.startswith(("-O=", "-Y="))]
        key = [option for option in options if not option.startswith(("-O=", "-Y="))]
        kept = folder / hashlib.sha256(repr(key).encode() + Path(source).read_bytes()).hexdigest()
        if not kept.exists():
            run_tool(command, what)
            scratch = Path(tempfile.mkdtemp(dir=folder))
            for place in made:
                shutil.copy(place, scratch / f"made{place.suffix}")
            with suppress(OSError):  # the other process was first
                scratch.rename(kept)
            return ""
        for place in made:
            shutil.copy(kept / f"made{place.suffix}", place)
        return ""

    folder.mkdir(exist_ok=True)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(execute_nxc, "run_tool", once)
        yield


@pytest.fixture(autouse=True)
def _nbc_once_where_needed(request: pytest.FixtureRequest) -> None:
    if any("nbc" in mark.args for mark in request.node.iter_markers("needs")):
        request.getfixturevalue("nbc_once")


EXPORTED = ("nxtway-gs", "twipr")


@pytest.fixture(scope="session")
def exported_lab(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page that `upright lab --export site` writes, with a robot in volts and one in newton metres: once for all
    processes. There is one analysis for all controllers of the second robot: with its delays of five periods they are
    half of the work."""
    from upright.cli.main import main
    from upright.lab import export

    folder = common(tmp_path_factory, "exported-lab")
    page, failed = folder / "site" / "index.html", folder / "failed"
    try:
        folder.mkdir()
    except FileExistsError:  # another process makes it, and moves it there when it is whole
        while not page.exists():
            assert not failed.exists()
            time.sleep(0.2)
        return page
    analysed, kept = export.analysed, dict[str, Any]()

    def analysis(controller: Any, robot: Any, kit: Any) -> Any:
        if robot.name == EXPORTED[0]:
            return analysed(controller, robot, kit)
        if robot.name not in kept:
            kept[robot.name] = analysed(controller, robot, kit)
        return kept[robot.name]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(export, "analysed", analysis)
        if main(["lab", "--export", str(page.parent), f"--robots={','.join(EXPORTED)}"]) != 0:
            failed.touch()
    return page


@pytest.fixture(scope="session")
def axe(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """axe-core, as the lock of the lab's page pins it."""
    for web in (LAB, Path(os.environ.get("UPRIGHT_WEB", LAB))):
        if (web / "node_modules/axe-core").is_dir():
            return web / "node_modules/axe-core/axe.min.js"
    name = "node_modules/axe-core"
    entry = json.loads((LAB / "package-lock.json").read_text())["packages"][name]
    kept = CHECKOUT / ".pytest_cache" / f"axe-{entry['version']}.js"  # a run before has fetched it
    if kept.exists():
        return kept
    folder = tmp_path_factory.mktemp("axe")
    asked = {"name": "axe", "dependencies": {"axe-core": entry["version"]}}
    (folder / "package.json").write_text(json.dumps(asked))
    lock = {"name": "axe", "lockfileVersion": 3, "packages": {"": asked, name: {**entry, "dev": False}}}
    (folder / "package-lock.json").write_text(json.dumps(lock))
    npm = shutil.which("npm") or "npm"
    subprocess.run([npm, "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder, check=True, timeout=300)
    kept.parent.mkdir(exist_ok=True)
    copied = shutil.copy(folder / name / "axe.min.js", kept.with_suffix(f".{os.getpid()}"))
    Path(copied).replace(kept)  # another process may read it at this moment
    return kept
