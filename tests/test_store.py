"""Machine code on disk is what the present sources make, undamaged, or it is made anew."""

from __future__ import annotations

import os
import random
import shutil
import subprocess
import sys
from collections.abc import Callable
from importlib.metadata import requires
from pathlib import Path

import numpy as np
import pytest
from packaging.requirements import Requirement

from upright.calibration.kept import njit
from upright.kernel import store

SOURCE = Path(__file__).parents[1] / "src" / "upright"
NAME, OTHER = "specific_force_smooth", "specific_force_coulomb"
ARGUMENTS = ("*float64", "int64", "int64")

USE = """
from upright.calibration.kept import njit
from upright.compiled.jit import fma

@njit
def square(x):
    return fma(x, x, 0.0)

print(int(square(3.0)), sum(square.stats.cache_hits.values()), flush=True)
"""

EACH = """
import os, sys
import numba, numpy
called, before, after, use = sys.argv[1:]
whole = open(called).read()
for text in (whole, whole.replace(before, after), whole):
    with open(called, "w") as file:
        file.write(text)
    if not os.fork():
        exec(use)
        os._exit(0)
    os.wait()
"""
"""Each time in a new process, which has what takes longest, and nothing of the package."""


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package that may be changed, and cannot keep anything in its own folder."""
    place = tmp_path_factory.mktemp("package")
    shutil.copytree(SOURCE, place / "upright", ignore=shutil.ignore_patterns("web", "static", "__pycache__"))
    return place


def test_a_change_of_any_source_compiles_the_calibration_anew(package: Path, tmp_path: Path) -> None:
    """What a compiled function computes, and how often it came from the disk: whole, changed, and whole again."""
    called = package / "upright" / "compiled" / "jit.py"  # what the function calls, in another file
    line = "return builder.call(function, args)"
    assert called.read_text("utf-8").count(line) == 1
    environment = os.environ | {"PYTHONPATH": str(package), "UPRIGHT_CACHE": str(tmp_path)}
    words = [str(called), line, "return builder.fadd(*args[:2])", USE]
    done = subprocess.run(
        [sys.executable, "-B", "-c", EACH, *words], env=environment, capture_output=True, text=True, check=False
    )
    # the stale code gives 9 for the changed one
    assert done.stdout.splitlines() == ["9 0", "6 0", "9 1"], done.stderr


def hits_of(function: Callable[[float], float]) -> int:
    """How often the code of a function, compiled as the calibration's are, comes from the disk; it doubles."""
    made = njit(function)
    assert made(3.0) == 6.0
    return sum(made.stats.cache_hits.values())


def test_damage_to_the_calibrations_code_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))

    def double(x: float) -> float:
        return 2.0 * x

    assert [hits_of(double), hits_of(double)] == [0, 1]
    (path,) = tmp_path.iterdir()
    whole = bytearray(path.read_bytes())
    whole[len(whole) // 2] ^= 1
    path.write_bytes(whole)
    assert [hits_of(double), hits_of(double)] == [0, 1]


@pytest.mark.parametrize("other", ["0.60.2", "0.69.0", "1.0.0rc1"])
def test_another_numba_keeps_nothing_and_says_so_once(
    other: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """What numba makes by itself computes the same, for this process alone."""
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    monkeypatch.setattr(store, "version", lambda _: other)
    monkeypatch.setattr(store, "_by_numba", lambda *_: 17)
    store.known_numba.cache_clear()
    store._address_of.cache_clear()
    try:
        assert store.address_of("compiled.generated_motion", NAME, ARGUMENTS) == 17
        assert hits_of(lambda x: x + x) == 0
        assert not list(tmp_path.iterdir())
    finally:
        store.known_numba.cache_clear()
        store._address_of.cache_clear()
    assert capsys.readouterr().err.splitlines() == [
        f"upright: numba {other} was never tried: every process compiles anew, which takes longer"
    ]


def test_what_numba_makes_by_itself_computes_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    rows, asked = np.random.default_rng(1).uniform(0.5, 1.5, 20000), ("compiled.generated_motion", NAME, ARGUMENTS)
    results = []
    for address in (store.address_of(*asked), store._by_numba(*asked)):
        given = rows.copy()
        store.call(address, [given.ctypes.data, 8, 40])
        results.append(given)
    # two orders of the same sums
    np.testing.assert_allclose(*results, rtol=1e-12)
    assert not np.array_equal(results[0], rows)


def test_the_versions_of_numba_are_those_that_are_installed() -> None:
    (asked,) = (line for line in requires("upright") or () if line.startswith("numba"))
    least, most = (f"{major}.{minor}" for major, minor in store.NUMBA)
    assert Requirement(asked).specifier == Requirement(f"numba>={least},<{most}").specifier


def test_every_compiled_file_decides_what_is_kept() -> None:
    """Whatever Numba compiles, and whatever that imports from the package, is in the hash."""
    text = {path.relative_to(SOURCE).as_posix(): path.read_text("utf-8") for path in SOURCE.rglob("*.py")}
    compiled = {
        file for file, code in text.items() if "\n@njit" in code or "\n@inlined" in code or "\n@intrinsic" in code
    }
    assert compiled <= set(store.SOURCES) | set(store.ALSO), compiled


def random_damage(seed: int) -> Callable[[bytes], bytes]:
    def damage(whole: bytes) -> bytes:
        draw = random.Random(seed)
        kind, at = draw.choice(["flip", "cut", "fill", "shift"]), draw.randrange(len(whole))
        flipped = whole[:at] + bytes([whole[at] ^ 1 << draw.randrange(8)]) + whole[at + 1 :]
        return {"flip": flipped, "cut": whole[:at], "fill": whole[:at] + bytes(99), "shift": whole[1:] + b"\0"}[kind]

    return damage


DAMAGES: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda _: b"", "zeros": lambda whole: bytes(len(whole)), "text": lambda _: b"not code" * 99,
} | {f"seed {seed}": random_damage(seed) for seed in range(12)}  # fmt: skip


@pytest.fixture(scope="module")
def machine_code(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[str, bytes]]:
    """Two functions, compiled once: the name of each one's file, and what is in it."""
    made: dict[str, tuple[str, bytes]] = {}
    with pytest.MonkeyPatch.context() as patch:
        for name in (NAME, OTHER):
            place = tmp_path_factory.mktemp("code")
            patch.setenv("UPRIGHT_CACHE", str(place))
            store._address_of.cache_clear()
            store.address_of("compiled.generated_motion", name, ARGUMENTS)
            (path,) = place.iterdir()
            made[name] = path.name, path.read_bytes()
    return made


@pytest.fixture
def kept(machine_code: dict[str, tuple[str, bytes]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A file of machine code, and no other in its folder. The compiler gives what it gave, without its second."""
    name, whole = machine_code[NAME]
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    monkeypatch.setattr(store, "_compiled", lambda *_: whole[store._CHECKSUM :])
    (tmp_path / name).write_bytes(whole)
    return tmp_path / name


def made_anew(monkeypatch: pytest.MonkeyPatch) -> int:
    """How often the compiler is asked for the function, which then is there."""
    asked, compiled = [0], store._compiled

    def counted(*given: object) -> bytes:
        asked[0] += 1
        return compiled(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(store, "_compiled", counted)
    store._address_of.cache_clear()
    assert store.address_of("compiled.generated_motion", NAME, ARGUMENTS)
    monkeypatch.setattr(store, "_compiled", compiled)
    return asked[0]


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_machine_code_is_never_loaded(damage: str, kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = kept.read_bytes()
    assert made_anew(monkeypatch) == 0
    kept.write_bytes(DAMAGES[damage](whole))
    assert made_anew(monkeypatch) == 1
    assert kept.read_bytes() == whole
    assert made_anew(monkeypatch) == 0


def test_the_code_of_another_function_is_not_taken(
    kept: Path, machine_code: dict[str, tuple[str, bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    kept.write_bytes(machine_code[OTHER][1])
    assert made_anew(monkeypatch) == 1


@pytest.mark.parametrize("place", ["a file", "nowhere", "a folder in the place of the code"])
def test_where_nothing_can_be_kept_every_process_compiles(
    place: str, kept: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if place == "a folder in the place of the code":
        kept.unlink()
        kept.mkdir()
    else:
        (tmp_path / "file").touch()
        monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path / "file") if place == "a file" else "/proc/none")
    assert made_anew(monkeypatch) == 1
    assert made_anew(monkeypatch) == 1
