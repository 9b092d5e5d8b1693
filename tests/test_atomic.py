"""Whatever is written appears whole or not at all, where its name leads, and nothing but a file is ever replaced."""

from __future__ import annotations

import os
import socket
import stat
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

import pytest

from conftest import PATIENCE
from upright.atomic import TemporaryFolder, write_text, writing
from upright.cli.main import USER_ERROR, main
from upright.errors import UprightError
from upright.pages import Page, Say
from upright.pages.result import write_page
from upright.robots import Robot
from upright.signals import Log

OLD = b"what stood here before"

Write = Callable[[Path], object]


def a_text(path: Path) -> None:
    write_text(path, "new\n")


def a_robot(path: Path) -> None:
    Robot.preset("nxtway-gs").save(path)


def a_page(path: Path) -> None:
    write_page(Page(Say("number")), path)


def a_log(path: Path) -> None:
    Log([0.0, 0.1], {"truth/pitch": [0.0, 0.1]}, units={"truth/pitch": "rad"}).save(path)


def a_command(path: Path) -> None:
    if main(["linearise", "-o", str(path)]):
        raise UprightError("refused")


WRITERS = {"text": a_text, "robot": a_robot, "page": a_page, "log": a_log, "command": a_command}
SUFFIX = {"log": ".parquet", "page": ".html", "robot": ".toml"}


@pytest.fixture(params=WRITERS)
def writer(request: pytest.FixtureRequest) -> tuple[Write, str]:
    return WRITERS[request.param], f"out{SUFFIX.get(request.param, '.json')}"


def test_a_link_stays_a_link_and_its_target_is_written(writer: tuple[Write, str], tmp_path: Path) -> None:
    write, name = writer
    (tmp_path / "there").mkdir()
    target, link = tmp_path / "there" / name, tmp_path / name
    target.write_bytes(OLD)
    link.symlink_to(target)
    write(link)
    assert link.is_symlink()
    assert target.read_bytes() not in (OLD, b"")
    assert sorted(p.name for p in tmp_path.rglob("*")) == sorted(["there", name, name])


def test_a_link_to_nothing_yet_makes_its_target(writer: tuple[Write, str], tmp_path: Path) -> None:
    write, name = writer
    link = tmp_path / name
    link.symlink_to("target" + link.suffix)
    write(link)
    assert link.is_symlink()
    assert link.stat().st_size > 0


@pytest.mark.parametrize("mode", [0o600, 0o755])
def test_a_file_keeps_its_mode(writer: tuple[Write, str], mode: int, tmp_path: Path) -> None:
    write, name = writer
    target = tmp_path / name
    target.write_bytes(OLD)
    target.chmod(mode)
    write(target)
    assert target.read_bytes() != OLD
    assert stat.S_IMODE(target.stat().st_mode) == mode


def test_a_new_file_has_the_mode_of_any_other(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        write_text(tmp_path / "new", "new\n")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o640


def test_a_pipe_gets_the_bytes_and_stays_one(writer: tuple[Write, str], tmp_path: Path) -> None:
    write, name = writer
    pipe, file = tmp_path / name, tmp_path / f"file-{name}"
    os.mkfifo(pipe)
    came: list[bytes] = []
    reader = threading.Thread(target=lambda: came.append(pipe.read_bytes()), daemon=True)
    reader.start()
    write(pipe)
    reader.join(PATIENCE)
    write(file)
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    assert came
    assert len(came[0]) == pytest.approx(len(file.read_bytes()), abs=len(str(tmp_path)))


def test_a_device_gets_the_bytes_and_stays_one(tmp_path: Path) -> None:
    ours, theirs = os.openpty()
    link = tmp_path / "out.txt"
    link.symlink_to(os.ttyname(theirs))  # the terminal of this test alone
    try:
        a_text(link)
        assert stat.S_ISCHR(link.stat().st_mode)
        assert os.read(ours, 100).split() == [b"new"]
    finally:
        os.close(ours)
        os.close(theirs)


def test_a_full_device_is_an_error_and_stays_one(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    node = tmp_path / "full"
    try:
        os.mknod(node, 0o666 | stat.S_IFCHR, os.makedev(1, 7))
        node.open("wb").close()
    except PermissionError:
        pytest.xfail("device nodes cannot be made here")
    assert main(["linearise", "-o", str(node)]) == USER_ERROR
    assert "No space left" in capsys.readouterr().err
    assert stat.S_ISCHR(node.stat().st_mode)


def test_a_socket_is_refused(writer: tuple[Write, str], tmp_path: Path) -> None:
    write, name = writer
    listening = socket.socket(socket.AF_UNIX)
    listening.bind(str(tmp_path / name))
    with pytest.raises(UprightError):
        write(tmp_path / name)
    assert stat.S_ISSOCK((tmp_path / name).stat().st_mode)
    listening.close()


def test_a_folder_is_refused(writer: tuple[Write, str], tmp_path: Path) -> None:
    write, name = writer
    (tmp_path / name).mkdir()
    with pytest.raises(UprightError):
        write(tmp_path / name)
    assert [p.name for p in tmp_path.rglob("*")] == [name]


def test_a_ring_of_links_is_refused(writer: tuple[Write, str], tmp_path: Path) -> None:
    write, name = writer
    (tmp_path / name).symlink_to(tmp_path / "other")
    (tmp_path / "other").symlink_to(tmp_path / name)
    with pytest.raises(UprightError):
        write(tmp_path / name)


def test_an_option_in_the_place_of_a_name_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["simulate", "--seconds", "0.1", "-o", "--json"]) == USER_ERROR
    assert "Option '-o' requires an argument" in capsys.readouterr().err
    assert main(["lab", "--export", "--help"]) == USER_ERROR
    assert not [*tmp_path.iterdir()]


def test_a_failure_leaves_the_older_file_and_nothing_else(tmp_path: Path) -> None:
    target = tmp_path / "out"
    target.write_bytes(OLD)

    with pytest.raises(ZeroDivisionError), writing(target):
        raise ZeroDivisionError
    assert target.read_bytes() == OLD
    assert [p.name for p in tmp_path.iterdir()] == ["out"]


KILLED = """
import os, signal, sys
from pathlib import Path
from upright.atomic import TemporaryFolder, writing
place = Path(sys.argv[1]) / "run.txt"
kept = TemporaryFolder(place)
with writing(place) as stream:
    stream.write(b"half")
    stream.flush()
    os.kill(os.getpid(), signal.SIGKILL)
"""


@pytest.mark.parametrize("writer", [a_text, a_robot, a_page, a_log])
def test_what_a_killed_process_left_goes_with_the_next_file_and_that_of_a_living_one_stays(
    writer: Write, tmp_path: Path
) -> None:
    subprocess.run([sys.executable, "-c", KILLED, str(tmp_path)], check=False)
    assert len(list(tmp_path.iterdir())) == 2  # two temporary folders, and no file
    other = tmp_path / ".upright-elsewhere-1-abc"  # of another machine, whose processes nobody here knows
    other.mkdir()
    living = TemporaryFolder(tmp_path / "x")
    writer(tmp_path / {a_log: "run.csv", a_page: "run.html"}.get(writer, "run.toml"))
    assert {path.name for path in tmp_path.iterdir() if path.is_dir()} == {other.name, living.path.name}


def test_stdout_by_a_name_gets_the_bytes(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    link = tmp_path / "stdout"  # as the system's own link, which a test must not risk
    link.symlink_to("/proc/self/fd/1")
    assert main(["linearise", "--json", "-o", str(link)]) == 0
    out = capfd.readouterr().out
    assert out.count('"A": [') == 2, "once by -o, once by --json"
    assert link.is_symlink()


@pytest.mark.needs("module:zarr")
def test_a_folder_of_results_replaces_its_like_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["fleet", "-n", "4", "-s", "0.1", "-o"]
    result, mine, file, link = (tmp_path / f"{name}.zarr" for name in ("result", "mine", "file", "link"))
    for _ in range(2):
        assert main([*command, str(result)]) == 0
    link.symlink_to(result)
    assert main([*command, str(link)]) == 0
    assert link.is_symlink()
    mine.mkdir()
    (mine / "thesis.txt").write_bytes(OLD)
    file.write_bytes(OLD)
    for place in (mine, file, tmp_path / "none" / "result.zarr"):
        assert main([*command, str(place)]) == USER_ERROR
    assert (mine / "thesis.txt").read_bytes() == OLD
    assert file.read_bytes() == OLD
    assert {p.name for p in tmp_path.iterdir()} == {"result.zarr", "mine.zarr", "file.zarr", "link.zarr"}
