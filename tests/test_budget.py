"""No room of the package becomes heavier than `budget.toml` allows; what becomes lighter lowers its line."""

from __future__ import annotations

import ast
import io
import tokenize

import pytest

import budget


@pytest.fixture(scope="module")
def counted() -> dict[str, dict[str, int]]:
    return budget.measured()


@pytest.mark.parametrize("table", ["rooms", "beside", "dense"])
def test_nothing_is_heavier_than_its_budget(table: str, counted: dict[str, dict[str, int]]) -> None:
    allowed = budget.allowed()[table]
    heavier = {
        name: (count, allowed.get(name)) for name, count in counted[table].items() if count > allowed.get(name, 0)
    }
    assert not heavier, "lighten it, or raise its line in budget.toml and say why in the commit"


@pytest.mark.parametrize("table", ["rooms", "beside", "dense"])
def test_what_became_lighter_lowered_its_budget(table: str, counted: dict[str, dict[str, int]]) -> None:
    # a hundredth may stand unused, so that a small change needs no second file
    stale = {
        name: most for name, most in budget.allowed()[table].items() if counted[table].get(name, 0) < 0.99 * most - 5
    }
    assert not stale, "python tests/budget.py --lower"


def tokens_of(text: str) -> int:
    return budget.tokens_of(text, budget.inside(ast.parse(text)))


def test_layout_comments_and_docstrings_weigh_nothing() -> None:
    bare = "def f(a):\n    return a + 1\n"
    # def f ( a ) : return a + 1
    assert tokens_of(bare) == 10
    documented = '"""A module."""\n\ndef f(a):\n    """Add."""\n    return (\n        a\n        + 1\n    )  # one\n'
    assert tokens_of(documented) == 12


def test_tokens_are_those_of_the_standard_library() -> None:
    """In a file of every kind of number, text and sign that the package has."""
    text = (budget.PACKAGE / "doctor" / "finding.py").read_text("utf-8") + KINDS
    layout = {"COMMENT", "NL", "NEWLINE", "INDENT", "DEDENT", "ENCODING", "ENDMARKER"}
    found = list(tokenize.generate_tokens(io.StringIO(text).readline))
    tokens = [token for token in found if tokenize.tok_name[token.type] not in layout]
    docstrings = [token for token in tokens if token.type == tokenize.STRING and token.line.lstrip()[:3] == '"""']
    assert tokens_of(text) == len(tokens) - len(docstrings)


KINDS = r'''
a = 1.5e-3 + 0x1F + 1_000j + .5 + 2. ** -1e5 // 3
b: dict[str, int] = {"a#": 1, 'b\'': 2} | {f"{a!r:>{8}}": 3, rb"\n": 4}  # not "this"
c = (lambda *_, **__: ...) if a != 3 else \
    not a <= b[::2] @ c >> 2
d = """one "two" #
three""" "four"
def θ(ψ̇: float, /) -> None:
    if (n := ψ̇) >= 1: a.b -= ~n; a |= 1
'''
"""Beside the text of its own: signs of two and three characters, and a line that goes on."""
