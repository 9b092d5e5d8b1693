"""What a command prints first is what its page shows first, and what `--json` has as its head."""

from __future__ import annotations

import pytest

from upright.errors import UnknownName
from upright.reports import Page, Verdict
from upright.reports.head import MOST, WIDTH, Head


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
