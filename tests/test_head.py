"""What a command prints first is what its page shows first, and what `--json` has as its head."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path
from typing import Any

import pytest

from upright.cli import output
from upright.cli.main import main
from upright.errors import UnknownName
from upright.report import Page, Verdict
from upright.report.head import MOST, WIDTH, Head

KNOCK = "--push impulse:0.1"
QUICK = [
    "linearise", "linearise --period 0.01", f"simulate {KNOCK} -s 2", "doctor a.csv",
    "fleet -n 30 -s 1 --vary com_height=±10%", "basin --points 5 -s 1", "sweep spec.toml --workers 0",
]  # fmt: skip
"""One of each kind of head: with a verdict, of either level, and without one; with and without what to run next."""

ALL = [
    "simulate -s 1", "compare a.csv b.csv", f"fleet -n 30 -s 2 {KNOCK}", "push-map --points 2 -n 0 --watch 1",
    "grade hand-ins", "design lqg", "bench-controllers -c lqg -c lqr", "certify lqg --samples 100",
    "calibrate excited.csv --until 4", "validate nxtway-gs excited.csv", "post-mortem fall.csv",
    "tune lqr --budget 4 --samples 100", "identify excited.csv --method instrumental --repeats 2",
    "excite -s 20 --samples 600 --focus com_height",
]  # fmt: skip
COMMANDS = [*QUICK, *(pytest.param(command, marks=pytest.mark.evidence) for command in ALL)]
EXAMPLES = {"excited.csv": "excited", "fall.csv": "fall", "hand-ins": "handed-in"}
SPEC = """
robots = ["nxtway-gs"]
n = 20
seconds = 1.0
vary = ["spread"]

[[scenario]]
name = "knock"
push = [{ kind = "impulse", impulse = 0.1, start = 0.2 }]
"""


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the logs that the commands read."""
    folder = tmp_path_factory.mktemp("study")
    for name in "ab":
        assert main(f"simulate {KNOCK} -s 2 --seed {ord(name)} -o {folder / name}.csv".split()) == 0
    (folder / "spec.toml").write_text(SPEC, "utf-8")
    return folder


def plain(text: str) -> str:
    """Words as they are read: without tags, code's backticks, and one space between them."""
    return " ".join(html.unescape(re.sub(r"<[^>]+>", "", text)).replace("`", "").split())


def first_screen(page: str) -> tuple[str, str, list[tuple[str, str]], str]:
    """Level and text of the verdict, the numbers and what is next, as the page's markup has them."""
    top = page[page.index("<header>") : page.index("</header>")]
    badge = re.search(r'<p class="badge (\w+)">(.*?)</p>', top)
    numbers = re.findall(r"<dt>(.*?)</dt><dd[^>]*>(.*?)</dd>", top, re.DOTALL)
    after = re.search(r'<p class="next"><strong>Next</strong>(.*?)</p>', top, re.DOTALL)
    level, text = badge.groups() if badge else ("", "")
    return level, plain(text), [(plain(n), plain(m)) for m, n in numbers][:3], plain(after[1]) if after else ""


@pytest.fixture
def paged(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """What commands print the head of: that of `--json` can be printed as text without computing it again."""
    printed: list[Any] = []
    page_of = output._page_of

    def noted(result: Any) -> Page | None:
        printed.append(result)
        return page_of(result)

    monkeypatch.setattr(output, "_page_of", noted)
    return printed


@pytest.mark.parametrize("command", COMMANDS)
def test_terminal_page_and_json_begin_alike(
    command: str, study: Path, paged: list[Any], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(study)
    monkeypatch.setenv("COLUMNS", "80")
    words = command.split()
    for file, name in EXAMPLES.items():
        if file in words and not Path(file).exists():
            assert main(["example", name, "-o", file]) == 0
    capsys.readouterr()
    # the same words for all three, since what to run next goes on from them
    typed = [*words, "--report", "page.html"]
    assert main([*typed, "--json"]) in (0, 3)
    head = json.loads(capsys.readouterr().out)["head"]
    level, verdict, numbers, after = first_screen(Path("page.html").read_text("utf-8"))
    if command in QUICK:
        assert main(typed) in (0, 3)
    else:
        before = output.TYPED.set(typed)
        output.print_result(paged[-1], "")
        output.TYPED.reset(before)
    printed = capsys.readouterr().out

    lines = printed.split("\n\n")[0].split("\n")
    assert max(map(len, lines)) <= 80
    top = plain("\n".join(lines))
    assert numbers
    assert (head["verdict"] or {"level": "", "text": ""}) == {"level": level, "text": verdict}
    assert [(plain(value), plain(meaning)) for value, meaning in head["numbers"]] == numbers
    assert top.startswith(f"Verdict: {verdict} " if verdict else plain(head["title"]))
    assert [n for n in numbers if f" {n[0]} {n[1]}" not in top] == []
    assert top.endswith(f"Next: {after.replace(' --json', '')}" if after else " ".join(numbers[-1]))
    assert plain(head["next"]) == after


def test_a_command_stays_on_one_line_and_no_line_is_too_long() -> None:
    command = "`upright certify tuned-controller.json --robot nxtway-gs --samples 1000`"
    assert len(command) <= WIDTH - 2
    head = Head("word " * 40, Verdict("fell", "bad"), [("1.5 %", "of them " * 20)], f"Then try {command}.")
    for width in (WIDTH, 200, 60):
        lines = head.text(width).split("\n")
        assert max(map(len, lines)) <= min(width, WIDTH)
    assert command in head.text()
    assert head.text(1).startswith("Verdict: fell\n")  # in a terminal of no width too


def test_a_head_has_at_most_three_numbers_and_what_is_coloured_as_text() -> None:
    page = Page("T", [], "So. Next: go.", numbers=[(Verdict("5 %", "bad"), "a"), ("2", "b"), ("3", "c"), ("4", "d")])
    assert page.head == Head("T", None, [("5 %", "a"), ("2", "b"), ("3", "c")], "go.")
    assert MOST == 3
    with pytest.raises(UnknownName):
        Verdict("so", "maybe")
