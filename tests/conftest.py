"""What some tests need, and the rule that with UPRIGHT_REQUIRE_ALL=1 nothing may be left out."""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the tests themselves run side by side; set before numpy loads

import shutil
import signal
from collections.abc import Generator
from importlib.util import find_spec
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
SHARED = CHECKOUT.parent / "shared"
REQUIRE_ALL = os.environ.get("UPRIGHT_REQUIRE_ALL", "") not in ("", "0")


def missing(need: str) -> bool:
    """Whether a folder or file ("shared/data/regbot"), a module ("module:cvxpy") or a program ("node") is absent."""
    if need.startswith("/"):
        return not Path(need).exists()
    if need.startswith("shared/"):
        return not (SHARED.parent / need).exists()
    if need.startswith("module:"):
        return find_spec(need.removeprefix("module:")) is None
    return shutil.which(need) is None


def pytest_configure(config: pytest.Config) -> None:
    for name in ("SIGINT", "SIGHUP"):  # a run in the background ignores them: what it starts must not
        if signal.getsignal(getattr(signal, name, signal.SIGINT)) == signal.SIG_IGN:
            signal.signal(getattr(signal, name), signal.default_int_handler)
    config.addinivalue_line(
        "markers",
        "needs(*what): skip where 'shared/…', 'module:…' or a program is not there; fail if UPRIGHT_REQUIRE_ALL=1",
    )


TOGETHER = frozenset((
    "test_agreement", "test_campaign", "test_certificate", "test_excite", "test_hinf", "test_identify", "test_margins",
    "test_permit", "test_postmortem", "test_reproduce",
))  # fmt: skip
"""Files whose tests share results that take seconds: one process runs the file and computes them once."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests of one robust design run in one process too, which designs it once: that takes up to fifteen seconds."""
    for item in items:
        given = item.callspec.params if isinstance(item, pytest.Function) and hasattr(item, "callspec") else {}
        if given.get("name") == "robust" and "preset" in given:
            item.add_marker(pytest.mark.xdist_group(f"robust {given['preset']}"))
        elif item.path.stem in TOGETHER:
            item.add_marker(pytest.mark.xdist_group(item.path.stem))


def pytest_runtest_setup(item: pytest.Item) -> None:
    for mark in item.iter_markers("needs"):
        absent = [need for need in mark.args if missing(need)]
        if absent:
            pytest.skip(f"needs {', '.join(absent)}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport() -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if not hasattr(report, "wasxfail"):
        _refuse_skip(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    _refuse_skip(report)
    return report


def _refuse_skip(report: pytest.TestReport | pytest.CollectReport) -> None:
    if REQUIRE_ALL and report.outcome == "skipped":
        reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        report.outcome = "failed"
        report.longrepr = f"UPRIGHT_REQUIRE_ALL=1 allows no skip, but: {reason}"


@pytest.fixture
def shared() -> Path:
    """The folder beside the checkout that holds measured logs; mark the test with `needs("shared/…")`."""
    return SHARED
