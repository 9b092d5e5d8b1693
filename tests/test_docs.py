"""What the documents show works: their Python runs, and their links lead somewhere."""

import math
import re
from pathlib import Path

import pytest

from upright.bodies import Body
from upright.robots import Robot

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def python_blocks(page: Path) -> list[str]:
    return re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_python_in_the_documents_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "example"}
    for block in python_blocks(page):
        exec(compile(block, str(page), "exec"), names)


def test_the_example_body_keeps_the_contract():
    names: dict[str, object] = {"__name__": "example"}
    exec(python_blocks(ROOT / "docs" / "add-a-body.md")[0], names)
    robot = Robot.preset("nxtway-gs")
    body = names["Rod"](robot)  # type: ignore[operator]
    assert isinstance(body, Body)
    body.reset((0.01, 0, 0, 0, 0, 0))
    for _ in range(100):
        last = body.step((0.0, 0.0))
    # ψ = ψ₀ cosh(√(g/L) t) with g/L = 136 1/s²; Euler's steps of 1 ms err by about λ²th/2 = 0.7 %
    assert last.values[0] == pytest.approx(0.01 * math.cosh(math.sqrt(9.81 / 0.072) * 0.1), rel=0.01)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files_that_exist(page):
    targets = re.findall(r"\]\(([^)#]+?)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    missing = [t for t in targets if not t.startswith("http") and not (page.parent / t).exists()]
    assert not missing
