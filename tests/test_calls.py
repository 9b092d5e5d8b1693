"""A seeded part of the malformed calls of `benchmarks/abuse.py calls`: those of commands that answer at once."""

from __future__ import annotations

from pathlib import Path

import pytest

from planted.abuse import calls


def test_malformed_calls_are_one_line_and_change_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    rows = list(calls.rows(tmp_path, seed=3, count=6, names=("linearise", "robots")))
    assert [what for what, _, _, held in rows if not held] == []


def test_every_option_and_argument_of_every_command_is_abused() -> None:
    from upright.cli.main import group

    every = list(calls.calls())
    assert {call.command for call in every} == set(group().commands)  # type: ignore[attr-defined]
    assert len(every) > 2000
    assert not any(output.startswith("/") or ".." in output for call in every for output in call.outputs)
