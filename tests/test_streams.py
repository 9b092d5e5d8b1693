"""What a command prints may go anywhere: to another alphabet, a closed or full stream, a reader that leaves."""

from __future__ import annotations

import json
import os
import stat
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from conftest import PATIENCE
from upright.robots import Robot

COMMAND = [sys.executable, "-m", "upright"]
SHOWS = ["robots", "show", "nxtway-gs"]  # prints Greek letters, and computes nothing
NOBODY = ["robots", "show", "nobody"]


def run(arguments: list[str], **options: Any) -> subprocess.CompletedProcess[bytes]:
    given = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
    done = subprocess.run([*COMMAND, *arguments], check=False, timeout=PATIENCE, **given)
    assert b"Traceback" not in (done.stderr or b"")
    assert b"Exception ignored" not in (done.stderr or b"")
    return done


PRINTED = """
from upright.streams import guard
from upright.cli.output import print_json
guard()
print_json({"angle": "ψ"})
print("ψ")
"""


@pytest.mark.parametrize("alphabet", ["latin-1", "ascii", "cp1252", "utf-16"])
def test_a_character_that_an_alphabet_lacks_is_replaced_and_json_keeps_it(alphabet: str) -> None:
    environment = os.environ | {"PYTHONIOENCODING": alphabet}
    done = subprocess.run([sys.executable, "-c", PRINTED], capture_output=True, check=True, env=environment)
    *data, text = done.stdout.decode(alphabet).splitlines()
    assert json.loads("".join(data)) == {"angle": "ψ"}
    assert text == ("ψ" if alphabet == "utf-16" else "?")


def test_a_command_prints_in_any_alphabet() -> None:
    done = run(SHOWS, env=os.environ | {"PYTHONIOENCODING": "latin-1"})
    assert done.returncode == 0
    assert len(done.stdout.decode("latin-1").splitlines()) > 5


def close(*numbers: int) -> Callable[[], None]:
    def before() -> None:
        for number in numbers:
            os.close(number)

    return before


@pytest.mark.parametrize("numbers", [(1,), (0, 1, 2)], ids=str)
def test_a_closed_stream_is_nothing_to_a_command(numbers: tuple[int, ...], tmp_path: Path) -> None:
    inherited = {"stdin": None, "stdout": None, "stderr": None}
    done = run([*SHOWS, "-o", str(tmp_path / "m.toml")], preexec_fn=close(*numbers), **inherited)
    assert done.returncode == 0
    assert Robot.load(tmp_path / "m.toml").wheel_radius == 0.04, "nothing else in its place"
    assert [p.name for p in tmp_path.iterdir()] == ["m.toml"]
    assert run(NOBODY, preexec_fn=close(*numbers), **inherited).returncode == 2


@pytest.fixture
def full(tmp_path: Path) -> Path:
    """A device that is always full."""
    node = tmp_path / "full"
    try:
        os.mknod(node, 0o666 | stat.S_IFCHR, os.makedev(1, 7))
        node.open("wb").close()
    except PermissionError:
        node = Path("/dev/full")
    return node


def test_a_full_stdout_is_one_line(full: Path) -> None:
    with full.open("wb") as stream:
        done = run(SHOWS, stdout=stream)
    assert done.returncode == 2
    assert done.stderr.decode().splitlines() == [
        "upright: cannot print: No space left on device; try: -o FILE, or another place for the output"
    ]


def test_a_full_stderr_changes_no_exit_code(full: Path) -> None:
    with full.open("wb") as stream:
        assert run(NOBODY, stderr=stream).returncode == 2
        assert run(SHOWS, stderr=stream).returncode == 0


def test_a_reader_that_leaves_has_what_it_wants(tmp_path: Path) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    try:
        done = run([*SHOWS, "-o", str(tmp_path / "m.toml")], stdout=writer)
    finally:
        os.close(writer)
    assert done.returncode == 0
    assert done.stderr == b""
    assert (tmp_path / "m.toml").exists()


def test_head_ends_nothing_badly() -> None:
    line = f"set -o pipefail; {sys.executable} -m upright robots | head -1"
    done = subprocess.run(["bash", "-c", line], capture_output=True, check=False)
    assert done.returncode == 0
    assert done.stderr == b""
    assert done.stdout.count(b"\n") == 1


def test_a_name_in_no_alphabet_is_printed_and_written(tmp_path: Path) -> None:
    odd = os.fsencode(tmp_path) + b"/\xff.json"
    done = run(["linearise", "-o", odd.decode("utf-8", "surrogateescape")])
    assert done.returncode == 0
    assert os.path.exists(odd)
