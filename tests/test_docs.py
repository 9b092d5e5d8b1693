"""What the documents show works: Python runs, commands are understood and the quick ones run, TOML is read by what it
is for, and links lead somewhere. An example that cannot run has a fence of `text`."""

from __future__ import annotations

import ast
import json
import math
import re
import shlex
import shutil
import tomllib
from collections.abc import Collection
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from upright.bodies import Body, Electronics
from upright.bodies.twin import Twin
from upright.cli.main import group, main
from upright.control import lqg
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.logs.mapping import Mapping, propose
from upright.logs.readers import read_table
from upright.robots import Kit, Robot
from upright.signals import Log

ROOT = Path(__file__).parents[1]
PAGES = [
    ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md")),
    ROOT / "notebooks" / "README.md",
]  # fmt: skip
LANGUAGES = {"python", "sh", "toml", "text"}
READ_WHOLE = (ROOT / "README.md", ROOT / "docs" / "first-robot.md")  # test_readme.py, test_first_robot.py run them
EXTEND = ROOT / "docs" / "extend.md"  # a controller, then a body
QUICK = {"doctor", "design", "compare", "linearise", "robots"}
"""Commands of at most a second or two, which are executed; the others have tests of their own, and are parsed here."""

FENCE = re.compile(r"^```(\w*)\n(.*?)^```", re.MULTILINE | re.DOTALL)


def blocks(page: Path, language: str) -> list[str]:
    return [text for name, text in FENCE.findall(page.read_text("utf-8")) if name == language]


def commands(page: Path) -> list[list[str]]:
    """Every command line of a page's shell examples as words, lines joined and comments dropped."""
    lines = [line for block in blocks(page, "sh") for line in block.replace("\\\n", " ").splitlines()]
    typed = [shlex.split(part, comments=True) for line in lines for part in line.split(" && ") if part.strip()]
    # what stands behind a pipe is another program's
    return [words[: words.index("|")] if "|" in words else words for words in typed]


def with_(language: str) -> list[Path]:
    return [page for page in PAGES if blocks(page, language)]


@pytest.fixture(scope="module")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files that the pages speak of: logs made by a twin, its robot, and a controller."""
    folder = tmp_path_factory.mktemp("workshop")
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    controller = lqg(robot, kit)
    excitation = random_binary(int(4 / kit.period), 1.0, seed=1)
    log = run(Electronics(Twin(robot), kit), Excited(controller, excitation), seconds=4.0, seed=1)
    measured = {name: values for name, values in log.channels.items() if not name.startswith("truth/")}
    units = {name: log.units[name] for name in measured}
    for name in ("run.csv", "first.parquet", "spike.parquet"):
        Log(log.t, measured, units, log.origin).save(folder / name)
    robot.save(folder / "robot.toml")
    robot.save(folder / "mine.toml")
    (folder / "m.toml").write_text(propose(read_table(folder / "run.csv")).to_toml(), "utf-8")
    return folder


@pytest.fixture
def bench(workshop: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the workshop to work in."""
    shutil.copytree(workshop, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_every_example_stands_in_a_fence_that_names_its_language(page: Path) -> None:
    text = page.read_text("utf-8")
    assert {name for name, _ in FENCE.findall(text)} <= LANGUAGES
    assert re.findall(r"\n\n {4}(?![-*] ).*", FENCE.sub("", text)) == []


LONG = {"README.md", "excite.md", "calibrate.md", "identify.md"}
"""Pages whose Python calibrates, or plans an experiment."""


def run_pages(pages: list[Path], long: Collection[str] = ()) -> list[Any]:
    """The pages whose examples run; those in Spanish give the same ones, which a test below says."""
    return [
        pytest.param(page, id=page.name, marks=pytest.mark.evidence if page.name in long else ())
        for page in pages
        if ".es." not in page.name
    ]


@pytest.mark.parametrize("page", run_pages(with_("python"), LONG))
def test_python_in_the_documents_runs(page: Path, bench: Path) -> None:
    names: dict[str, object] = {"__name__": "example"}
    for block in blocks(page, "python"):
        if "figure = " in block:
            continue  # the site draws it: test_site.py
        exec(compile(block, str(page), "exec"), names)


@pytest.mark.parametrize("page", with_("sh"), ids=lambda page: page.name)
def test_commands_in_the_documents_are_understood(page: Path) -> None:
    for words in commands(page):
        if words[0] == "python" and words[1].endswith(".py"):
            assert (ROOT / words[1]).exists(), words
        if words[0] == "upright":
            understood(words[1:])


@cache
def parser() -> Any:
    """The program's commands, of which none does anything."""
    root = group()
    todo = [root]
    while todo:
        command = todo.pop()
        if command is not root:
            command.callback = lambda **_: None
        todo += getattr(command, "commands", {}).values()
    return root


def understood(words: list[str]) -> None:
    """Parse a command as the program does, without executing it; an unknown command or option raises."""
    parser().main(words, prog_name="upright", standalone_mode=False)


@pytest.mark.parametrize("words", ["simulat", "simulate --bodi twin", "robots shw nxtway-gs", "compare"])
def test_a_wrong_command_is_not_understood(words: str) -> None:
    with pytest.raises(Exception, match=r"(?i)no such|missing"):
        understood(words.split())


OUTPUTS = {"-o", "--output", "--report", "--fix", "--save", "--write-mapping"}


def quick(page: Path) -> list[list[str]]:
    return [words for words in commands(page) if words[0] == "upright" and words[1] in QUICK]


RUN: dict[str, list[set[str]]] = {}
"""Command → the options that it ran with on pages before: with no others it does the same there."""


def runs_first(words: list[str]) -> bool:
    """Whether a command has an option that no command of its name has had yet, or is the first of its name."""
    name = " ".join(words[1 : 3 if words[1] in ("design", "robots") else 2])
    options = {word for word in words if word.startswith("-")} - {"--robot"}  # of which one is the usual
    known = RUN.setdefault(name, [])
    if any(options <= others for others in known):
        return False
    known.append(options)
    return True


@pytest.mark.parametrize("page", run_pages([page for page in PAGES if quick(page) and page not in READ_WHOLE]))
def test_quick_commands_in_the_documents_run(page: Path, bench: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words in quick(page):
        inputs = [word for option, word in pairwise(words) if option not in OUTPUTS]
        files = [word for word in inputs if re.search(r"\.(csv|parquet|json|toml)$", word)]
        # a file that is not there is written by an earlier command, which is only parsed
        if all(Path(file).exists() for file in files) and runs_first(words):
            assert main(words[1:]) == 0, (words, capsys.readouterr().err)


def test_the_toml_of_the_documents_is_read() -> None:
    for page in with_("toml"):
        for block in blocks(page, "toml"):
            tomllib.loads(block)


def test_the_example_mapping_and_kit_are_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    mapping = next(text for text in blocks(ROOT / "docs" / "logs.md", "toml") if "[channels" in text)
    Path("mapping.toml").write_text(mapping, "utf-8")
    assert Mapping.load("mapping.toml").channels["applied/left"].times == "sensor/battery"
    kit = next(text for text in blocks(ROOT / "docs" / "add-a-robot.md", "toml") if "my-board" in text)
    Path("kit.toml").write_text(kit, "utf-8")
    assert Kit.load("kit.toml").sensors["sensor/gyro"].noise == 0.002


def test_the_example_body_keeps_the_contract() -> None:
    names: dict[str, object] = {"__name__": "example"}
    exec(blocks(EXTEND, "python")[1], names)
    robot = Robot.preset("nxtway-gs")
    body = names["Rod"](robot)  # type: ignore[operator]
    assert isinstance(body, Body)
    body.reset((0.01, 0, 0, 0, 0, 0))
    for _ in range(100):
        last = body.step((0.0, 0.0))
    # ψ = ψ₀ cosh(√(g/L) t) with g/L = 136 1/s²; Euler's steps of 1 ms err by about λ²th/2 = 0.7 %
    assert last.values[0] == pytest.approx(0.01 * math.cosh(math.sqrt(9.81 / 0.072) * 0.1), rel=0.01)


def test_the_command_printed_with_the_example_body_runs(tmp_path, monkeypatch, capsys) -> None:
    (tmp_path / "rod.py").write_text(blocks(EXTEND, "python")[1])
    command = next(line for block in blocks(EXTEND, "sh") for line in block.splitlines() if "rod.py" in line)
    monkeypatch.chdir(tmp_path)
    assert main(shlex.split(command)[1:]) == 0
    # ψ = 0.01 cosh(11.67 t) reaches 0.8 rad, where every program stops, at 0.435 s; it is read
    # a period of 10 ms later
    assert "fell at 0.44 s" in capsys.readouterr().out
    assert main(["simulate", "--body", "rod.py:Rod"]) == 2  # the NXT's sensors are missing on a rod
    assert "try: a kit without them, such as 'ideal'" in capsys.readouterr().err


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files_that_exist(page: Path) -> None:
    prose = re.sub(r"`[^`\n]*`", "", FENCE.sub("", page.read_text("utf-8")))
    targets = re.findall(r"\]\(([^)#]+?)(?:#[^)]*)?\)", prose)
    missing = [t for t in targets if not t.startswith("http") and not (page.parent / t).exists()]
    assert not missing


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_a_link_to_a_page_names_what_is_there(page: Path) -> None:
    """The name of a file tells a reader of the site nothing."""
    assert re.findall(r"\[`?[\w./-]+\.md`?\]\(.*?\)", page.read_text("utf-8")) == []


@pytest.mark.parametrize("page", PAGES[2:], ids=lambda page: page.name)
def test_each_page_says_for_whom_it_is(page: Path) -> None:
    assert re.match(r"# .+\n\n\*(For|Para) .+\.\*\n", page.read_text("utf-8"))


SPANISH = sorted((ROOT / "docs").glob("*.es.md"))


@pytest.mark.parametrize("page", SPANISH, ids=lambda page: page.name)
def test_both_languages_give_the_same_commands_and_python(page: Path) -> None:
    """In the same order; comments differ, and what builds the lab's page stands in English alone."""
    name = page.name.removesuffix(".es.md")
    english = next(p for p in (page.with_name(f"{name}.md"), page.with_name(f"{name}.en.md")) if p.exists())
    given = [[words for words in commands(p) if words[0] not in ("cd", "npm")] for p in (page, english)]
    assert given[0] == given[1]
    written = [[ast.dump(ast.parse(block)) for block in blocks(p, "python")] for p in (page, english)]
    assert written[0] == written[1]


def test_both_languages_have_a_first_page_a_lab_and_a_lesson() -> None:
    assert {"index.es.md", "lab.es.md", "lesson.es.md"} <= {p.name for p in SPANISH}


TEXTS = ROOT / "src" / "upright" / "lab" / "web" / "src" / "texts"
EVERYWHERE = (
    "title", "impulse", "front", "backPush", "pullLeft", "pullRight", "tilt", "step", "standUp", "speed", "back",
    "tabTour", "tabController", "tabRobot", "tabSee", "tabKeep", "moreCurves",
)  # fmt: skip
ON_TAB = {
    "controller": ("family", "weights", "fullCertificate"),
    "see": ("viewLabel",),
    "identify": ("doctor", "openLog"),
}
DESCRIPTION = 0x010E  # of EXIF, as docs/lab_picture.py writes it


@pytest.mark.needs("module:PIL")
@pytest.mark.parametrize("picture", sorted((ROOT / "docs").rglob("*lab*.webp")) + sorted(ROOT.glob("docs/tab-*.webp")))
def test_a_picture_of_the_lab_shows_the_words_of_the_page(picture: Path) -> None:
    """Each picture keeps the lines that were seen in it. Where this fails: `python docs/lab_picture.py`."""
    from PIL import Image

    texts = json.loads((TEXTS / ("es.json" if ".es." in picture.name else "en.json")).read_text("utf-8"))
    seen = {line.replace("\u00a0", " ") for line in json.loads(Image.open(picture).getexif()[DESCRIPTION])}
    expected = {texts[key] for key in EVERYWHERE}
    if "tab-" in picture.name:
        expected |= {texts[key] for key in ON_TAB[picture.name.split(".")[0].removeprefix("tab-")]}
    else:  # a film of the exported page, with the first step of the tour open
        first = texts["tour"][0]
        expected |= {text for text in (first | first["here"]).values() if isinstance(text, str)}
    assert expected - seen == set()
