"""What a command prints first is what its page shows first, and what `--json` has as its head."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from heads import begins_as, first_screen, plain
from upright.cli import output
from upright.cli.main import main
from upright.errors import UnknownName
from upright.reports import Page, Verdict
from upright.reports.head import MOST, WIDTH, Head

KNOCK = "--push impulse:0.1"
QUICK = [
]  # fmt: skip
"""One of each kind of head: with a verdict, of either level, and without one; with and without what to run next."""

LONGER = [
    "grade hand-ins",
]  # fmt: skip
"""What `test_first_robot.py` does not walk past, which asks the same of its commands."""

COMMANDS = [*QUICK, *(pytest.param(command, marks=pytest.mark.evidence) for command in LONGER)]
EXAMPLES = {"hand-ins": "handed-in"}


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the logs that the commands read."""
    folder = tmp_path_factory.mktemp("study")
    for name in "ab":
        assert main(f"simulate {KNOCK} -s 2 --seed {ord(name)} -o {folder / name}.csv".split()) == 0
    return folder


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
    page = Path("page.html").read_text("utf-8")
    if command == LONGER[0]:
        assert main(typed) in (0, 3)
    else:
        before = output.TYPED.set(typed)
        output.print_result(paged[-1], "")
        output.TYPED.reset(before)
    printed = capsys.readouterr().out

    assert plain(head["next"]) == first_screen(page)[3]
    begins_as(printed, head, page)


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
