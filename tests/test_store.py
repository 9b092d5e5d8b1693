"""Machine code on disk is what the present sources make, undamaged, or it is made anew."""

from __future__ import annotations

import os
import random
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from upright.kernel import store

SOURCE = Path(__file__).parents[1] / "src" / "upright"
ARGUMENTS = ("*float64", "int64", "int64")

USE = """
import numpy as np
from upright.calibrate.motion import block_of
print(int(block_of(np.ones((60, 2))).sum()), sum(block_of.stats.cache_hits.values()))
"""


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the package that may be changed, and cannot keep anything in its own folder."""
    place = tmp_path_factory.mktemp("package")
    shutil.copytree(SOURCE, place / "upright", ignore=shutil.ignore_patterns("web", "static", "__pycache__"))
    return place


def used(package: Path, cache: Path) -> tuple[int, int]:
    """What a compiled function of the package computes in a new process, and how often it came from the disk."""
    environment = os.environ | {"PYTHONPATH": str(package), "UPRIGHT_CACHE": str(cache)}
    done = subprocess.run([sys.executable, "-c", USE], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    result, hits = done.stdout.split()
    return int(result), int(hits)


def test_a_change_of_any_source_compiles_the_calibration_anew(package: Path, tmp_path: Path) -> None:
    first, hits = used(package, tmp_path)
    assert hits == 0
    assert used(package, tmp_path) == (first, 1)
    called = package / "upright" / "compiled" / "jit.py"  # what the function calls, in another file
    text = called.read_text("utf-8")
    line = "builder.store(args[3], _lane("
    assert text.count(line) == 1
    called.write_text(text.replace(line, "builder.store(builder.fadd(args[3], args[3]), _lane("))
    changed, hits = used(package, tmp_path)
    assert hits == 0
    assert changed == pytest.approx(2 * first, abs=3), "the stale code gives half of it"
    called.write_text(text)
    assert used(package, tmp_path) == (first, 1)


def test_damage_to_the_calibrations_code_is_noticed(package: Path, tmp_path: Path) -> None:
    first, _ = used(package, tmp_path)
    (path,) = tmp_path.iterdir()
    whole = bytearray(path.read_bytes())
    whole[len(whole) // 2] ^= 1
    path.write_bytes(whole)
    assert used(package, tmp_path) == (first, 0)
    assert used(package, tmp_path) == (first, 1)


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


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A file of machine code, and no other in its folder."""
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    store._address_of.cache_clear()
    store.address_of("compiled.generated_motion", "specific_force_smooth", ARGUMENTS)
    (path,) = tmp_path.iterdir()
    return path


def made_anew(monkeypatch: pytest.MonkeyPatch) -> int:
    """How often the compiler is asked for the function, which then is there."""
    asked, compiled = [0], store._compiled

    def counted(*given: object) -> bytes:
        asked[0] += 1
        return compiled(*given)  # type: ignore[arg-type]

    monkeypatch.setattr(store, "_compiled", counted)
    store._address_of.cache_clear()
    assert store.address_of("compiled.generated_motion", "specific_force_smooth", ARGUMENTS)
    monkeypatch.setattr(store, "_compiled", compiled)
    return asked[0]


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_machine_code_is_never_loaded(damage: str, kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = kept.read_bytes()
    monkeypatch.setattr(store, "_compiled", lambda *_: pytest.fail("it is whole"))
    store._address_of.cache_clear()
    store.address_of("compiled.generated_motion", "specific_force_smooth", ARGUMENTS)
    code = whole[store._CHECKSUM :]
    monkeypatch.setattr(store, "_compiled", lambda *_: code)
    kept.write_bytes(DAMAGES[damage](whole))
    assert made_anew(monkeypatch) == 1
    assert kept.read_bytes() == whole
    assert made_anew(monkeypatch) == 0


def test_the_code_of_another_function_is_not_taken(kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store.address_of("compiled.generated_motion", "specific_force_coulomb", ARGUMENTS)
    (other,) = set(kept.parent.iterdir()) - {kept}
    kept.write_bytes(other.read_bytes())
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
