"""Campaigns: one process, many, or many of which some were killed write the same bytes, and none does work twice."""

from __future__ import annotations

import json
import math
import os
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from conftest import PATIENCE
from upright.cli.main import main
from upright.errors import InvalidScenario, UnknownName, UprightError
from upright.experiment.pushes import Impulse, Slope
from upright.fleets import workers
from upright.fleets.binomial import clopper_pearson, upper_bound
from upright.fleets.campaign import chunk_path, collect, run_campaign
from upright.fleets.cases import Cases
from upright.fleets.fleet import ensemble_of
from upright.fleets.sweep import campaign_of, read_campaign
from upright.fleets.tally import CaseSummary, Moments
from upright.interrupts import Stopped

SPEC = """
robots = ["nxtway-gs"]
n = 24
chunk = 4
seed = 3
seconds = 1.0
vary = ["spread", "delay=0..0.004"]

[grid]
"motor.dead_zone" = [0.0, 0.3]

[[scenario]]
name = "knock"
push = [{ kind = "impulse", impulse = 0.25, start = 0.2 }]
"""
CHUNKS = 12  # two cases of 24 robots, 4 at a time


@pytest.fixture(scope="module")
def spec(tmp_path_factory):
    path = tmp_path_factory.mktemp("spec") / "campaign.toml"
    path.write_text(SPEC)
    return path


@pytest.fixture(scope="module")
def alone(spec, tmp_path_factory):
    """The campaign in one process."""
    folder = tmp_path_factory.mktemp("alone")
    run_campaign(read_campaign(spec), folder, workers=0)
    return folder


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted((folder / "chunks").iterdir())}


def forked(act: Callable[[], int | object]) -> int:
    """A process that does this and ends with its exit code, a copy of this one, which has imported all."""
    child = os.fork()
    if child:
        return child
    code = 70
    try:
        result = act()
        code = result if isinstance(result, int) else 0
    finally:
        os._exit(code)


def worker_processes() -> list[int]:
    """Processes that this one started: the workers, by what they were started with."""
    import psutil

    found = []
    for child in psutil.Process().children(recursive=True):
        try:
            found += [child.pid] if any("spawn_main" in word for word in child.cmdline()) else []
        except psutil.NoSuchProcess:
            continue
    return found


@pytest.mark.evidence
def test_two_workers_write_the_bytes_of_one_process_though_one_is_killed(spec, alone, tmp_path, monkeypatch):
    killed = []
    (tmp_path / "temporary").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))

    def kill_one(done):
        if done == 3 / CHUNKS and not killed:
            killed.append(worker_processes()[0])
            os.kill(killed[0], signal.SIGKILL)

    run_campaign(read_campaign(spec), tmp_path / "c", workers=2, progress=kill_one)
    assert len(killed) == 1
    assert files(tmp_path / "c") == files(alone)
    assert len(files(alone)) == CHUNKS
    assert list((tmp_path / "temporary").iterdir()) == []


def test_a_piece_that_kills_its_workers_is_given_up_and_named(monkeypatch):
    """Exit codes as pieces: `os._exit` ends the process that takes one, and no other."""
    monkeypatch.setattr(workers, "FAILURES", 1)
    done = []

    def submit(worker, piece):
        return worker.submit(os._exit, 9) if piece == "deadly" else worker.submit(abs, piece)

    # one worker: a second might still be starting when the piece is given up
    with workers.connected(workers=1) as one, pytest.raises(UprightError, match="deadly killed its worker 2 times"):
        workers.run_all([-1, -2, "deadly"], submit, lambda piece, result: done.append((piece, result)), one)
    assert sorted(done) == [(-2, 2), (-1, 1)]


@pytest.mark.needs("module:distributed")
def test_a_cluster_elsewhere_is_used_by_its_address(spec, alone, tmp_path):
    from distributed import LocalCluster

    with LocalCluster(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as cluster:
        run_campaign(read_campaign(spec), tmp_path / "c", cluster=cluster.scheduler_address)
    assert files(tmp_path / "c") == files(alone)


def test_a_campaign_killed_half_way_goes_on_from_what_is_on_disk(spec, alone, tmp_path):
    folder = tmp_path / "c"

    def stop(done):
        if done == 4 / CHUNKS:
            signal.pause()

    child = forked(lambda: run_campaign(read_campaign(spec), folder, workers=0, progress=stop))
    deadline = time.monotonic() + PATIENCE
    # it is there, and the folder that it was written in is gone
    while not chunk_path(folder, 3).exists() or any(path.is_dir() for path in (folder / "chunks").iterdir()):
        assert time.monotonic() < deadline
        assert os.waitpid(child, os.WNOHANG) == (0, 0)
        time.sleep(0.02)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    before = {name: (folder / "chunks" / name).stat().st_mtime_ns for name in files(folder)}
    assert 4 <= len(before) < CHUNKS
    told = []
    run_campaign(read_campaign(spec), folder, workers=0, progress=told.append)
    assert told == [done / CHUNKS for done in range(len(before), CHUNKS + 1)]
    assert files(folder) == files(alone)
    assert all((folder / "chunks" / name).stat().st_mtime_ns == when for name, when in before.items())


def test_a_campaign_that_ctrl_c_stops_shows_what_is_on_disk(spec, alone, tmp_path):
    """Two cases of six chunks each: of the second one two chunks, of four robots, were done."""

    def stop(done):
        if done == 8 / CHUNKS:
            raise KeyboardInterrupt

    with pytest.raises(Stopped) as stopped:
        run_campaign(read_campaign(spec), tmp_path, workers=0, progress=stop)
    cases, runs = stopped.value.result, collect(alone)
    assert [case.n for case in cases] == [24, 8]
    fell = [runs["fell"].values[runs["case"].values == k][:n].sum() for k, n in enumerate((24, 8))]
    assert [case.fell for case in cases] == fell
    assert cases.to_json()["unfinished"] == {"robots": 32, "of": 48}
    assert "unfinished: 32 of 48 robots" in str(cases)
    whole = run_campaign(read_campaign(spec), tmp_path, workers=0)
    assert whole.to_json()["unfinished"] is None
    assert files(tmp_path) == files(alone)


def test_a_campaign_puts_its_robot_at_the_medians_of_a_posterior_as_a_fleet_does(tmp_path):
    file = tmp_path / "posterior.json"
    names, covariance = ["com_height", "body_mass"], [[1e-6, 8e-6], [8e-6, 1e-4]]
    file.write_text(json.dumps({"parameters": names, "mean": [0.07, 0.6], "covariance": covariance}))
    table = {"n": 10, "seed": 5, "posterior": "posterior.json"}
    (case,) = campaign_of(table, tmp_path).cases
    robot = case.ensemble.family.robot
    assert (robot.com_height, robot.body_mass) == (0.07, 0.6)
    # robot, distributions, controller and scenario decide every outcome
    assert case.ensemble.origin() == ensemble_of("nxtway-gs", posterior=file, seed=5).origin()
    with pytest.raises(
        InvalidScenario, match="the posterior draws body_mass"
    ):  # the drawn mass would replace the grid's
        campaign_of(table | {"grid": {"body_mass": [0.5, 0.7]}}, tmp_path)


def test_a_chunk_cut_off_by_a_crash_is_run_again(spec, alone, tmp_path):
    shutil.copytree(alone, tmp_path, dirs_exist_ok=True)
    whole = chunk_path(tmp_path, 5).read_bytes()
    chunk_path(tmp_path, 5).write_bytes(whole[: len(whole) // 2])
    chunk_path(tmp_path, 6).write_bytes(b"")
    run_campaign(read_campaign(spec), tmp_path, workers=0)
    assert files(tmp_path) == files(alone)


def flip(path: Path, _: Path) -> None:
    data = bytearray(path.read_bytes())
    data[len(data) // 3] ^= 1
    path.write_bytes(data)


def exchange(path: Path, _: Path) -> None:
    path.write_bytes(path.with_name("00000004.parquet").read_bytes())


def foreign(path: Path, other: Path) -> None:
    path.write_bytes((other / "chunks" / path.name).read_bytes())


def table_of_another(path: Path, _: Path) -> None:
    import pyarrow as pa
    import pyarrow.parquet as pq

    pq.write_table(pa.table({"fell": [0.0] * 4}), path)


@pytest.fixture(scope="module")
def another(tmp_path_factory):
    """A campaign of another seed, whose chunks have the same names and columns."""
    folder = tmp_path_factory.mktemp("another")
    (folder / "c.toml").write_text(SPEC.replace("seed = 3", "seed = 4"))
    run_campaign(read_campaign(folder / "c.toml"), folder, workers=0)
    return folder


@pytest.mark.parametrize("damage", [flip, exchange, foreign, table_of_another])
def test_a_chunk_is_known_by_its_content(damage, spec, alone, another, tmp_path):
    shutil.copytree(alone, tmp_path, dirs_exist_ok=True)
    damage(chunk_path(tmp_path, 7), another)
    done = []
    run_campaign(read_campaign(spec), tmp_path, workers=0, progress=done.append)
    assert done == [(CHUNKS - 1) / CHUNKS, 1]
    assert files(tmp_path) == files(alone)


def test_a_damaged_chunk_is_not_collected(alone, tmp_path):
    shutil.copytree(alone, tmp_path, dirs_exist_ok=True)
    flip(chunk_path(tmp_path, 7), tmp_path)
    with pytest.raises(InvalidScenario, match="chunk 7"):
        collect(tmp_path)


def test_a_campaign_that_fails_writes_nothing(tmp_path):
    wrong = tmp_path / "wrong.toml"
    wrong.write_text(SPEC.replace("seconds = 1.0", "seconds = -1.0"))
    folder = tmp_path / "c"
    with pytest.raises(UprightError):
        run_campaign(read_campaign(wrong), folder, workers=0)
    assert not folder.exists()


def test_a_full_disk_is_one_line_and_the_campaign_goes_on_from_there(spec, alone, tmp_path, capfd):
    largest = max(len(data) for data in files(alone).values())
    command = ["sweep", str(spec), "-o", str(tmp_path / "c"), "--workers", "0"]

    def on_full_disk():
        import resource

        sys.dont_write_bytecode = True  # else what is imported here first stays cut off for later processes
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest - 1, largest - 1))
        return main(command)

    _, status = os.waitpid(forked(on_full_disk), 0)
    complaints = capfd.readouterr().err
    assert os.waitstatus_to_exitcode(status) == 2
    lines = [line for line in complaints.splitlines() if line.startswith("upright:")]
    assert len(lines) == 1
    assert "cannot write" in lines[0]
    assert "Traceback" not in complaints
    run_campaign(read_campaign(spec), tmp_path / "c", workers=0)
    assert files(tmp_path / "c") == files(alone)


def test_the_size_of_a_chunk_changes_no_robot(alone):
    table = {"n": 24, "seed": 3, "seconds": 1.0, "vary": ["spread", "delay=0..0.004"], "chunk": 24}
    table["scenario"] = [{"name": "knock", "push": [{"kind": "impulse", "impulse": 0.25, "start": 0.2}]}]
    ensemble = campaign_of(table).cases[0].ensemble  # without the grid: the kit's own dead zone
    at_once = ensemble.run(range(24))
    in_parts = [ensemble.run(range(start, start + 8)) for start in (0, 8, 16)]
    for name, values in at_once.items():
        np.testing.assert_array_equal(values, np.concatenate([part[name] for part in in_parts]))


def test_all_runs_come_together_and_the_tally_is_theirs(spec, alone):
    data = collect(alone)
    assert data.sizes["robot"] == 48
    cases = run_campaign(read_campaign(spec), alone, workers=0)  # nothing left to do
    for number, case in enumerate(cases):
        mine = data.isel(robot=data["case"].values == number)
        assert case.labels["motor.dead_zone"] == (0.0, 0.3)[number]
        assert case.fell == int(mine["fell"].sum())
        stood = mine["peak_pitch"].values[mine["fell"].values == 0]
        moments = case.outcomes["peak_pitch"]
        found = (moments.n, moments.mean, moments.deviation, moments.least, moments.most)
        assert found == pytest.approx(
            (stood.size, stood.mean(), stood.std(ddof=1), stood.min(), stood.max()), rel=1e-12
        )


def campaign_with(fell, n=200, names=("robot", "controller", "scenario", "motor.dead_zone")):
    """Cases by their labels, each with how many of its robots fell."""
    return Cases(CaseSummary(dict(zip(names, key, strict=False)), n, k, clopper_pearson(k, n), {}) for key, k in fell)


def test_a_campaign_that_was_interrupted_counts_the_robots_of_each_case():
    cases = Cases(CaseSummary({"robot": name}, n, 0, clopper_pearson(0, n), {}) for name, n in (("a", 100), ("b", 30)))
    assert str(cases.page().lead[0]) == "130 robots were simulated in 2 cases, and nobody pushed them."


def test_a_campaign_is_ranked_by_falls_and_what_nobody_survived_has_a_dash():
    stood = {"effort": Moments().with_values(np.array([2.0, 4.0]))}
    cases = Cases((
        CaseSummary({"robot": "a"}, 100, 0, clopper_pearson(0, 100), stood),
        CaseSummary({"robot": "b"}, 100, 100, clopper_pearson(100, 100), {"effort": Moments()}),
    ))  # fmt: skip
    (ax,) = cases.plot().axes
    assert [label.get_text() for label in ax.get_yticklabels()] == ["b", "a"]
    # where none of the 100 fell, the line ends at 1 − 0.05^(1/100)
    (lines,) = ax.collections
    assert lines.get_segments()[-1][:, 0].tolist() == pytest.approx([0.0, 100 * upper_bound(0, 100)])
    text = str(cases)
    assert "Up to 100 % of the robots fall with b, none with a" in text
    rows = [["b", "100", "%", "100", "–"], ["a", "0", "%", "100", "3"]]
    assert [line.split() for line in text.splitlines()[-2:]] == rows


def test_a_campaign_names_the_case_that_falls_and_not_its_mean_with_those_that_stand():
    """All of b fall when knocked and 3 % on a slope: 51 % is what no case has."""
    fell = {("a", "x", "knock"): 0, ("a", "x", "slope"): 0, ("b", "x", "knock"): 100, ("b", "x", "slope"): 3}
    page = campaign_with(fell.items(), 100).page()
    assert str(page.title) == "Up to 100\u00a0% of the robots fall with b, none with a"
    assert page.title.facts["most"].value == 1.0
    low = math.floor(100 * clopper_pearson(100, 100).low)
    assert [str(number.value) for number in page.numbers] == [f"{low} to 100\u00a0%", "2 of 4"]
    assert (str(page.verdict.text), page.verdict.level) == ("over 5\u00a0% fall in 1 of 4 cases", "bad")


def test_cases_without_a_clear_difference_are_counted_together():
    knocked = {("a", "lqr", "knock"): 117, ("a", "hinf", "knock"): 116, ("b", "hinf", "knock"): 8}
    others = {("b", "hinf", "slope"): 9, ("b", "lqr", "knock"): 0, ("b", "lqr", "slope"): 0, ("a", "lqr", "slope"): 4,
              ("a", "hinf", "slope"): 0}  # fmt: skip
    cases = campaign_with(((*key, zone), k) for key, k in (knocked | others).items() for zone in (0.0, 0.4))
    # 9 of 200 [2.1, 8.4] % are apart from 0 of 200 [0, 1.8] %: on b's slope the controller matters, the zone nowhere
    assert cases.alike() == ["motor.dead_zone"]
    page = cases.page()
    (ax,) = page.picture.draw().axes
    rows = [label.get_text() for label in ax.get_yticklabels()]
    assert len(rows) == 8
    assert rows[:4] == ["a, lqr, knock", "a, hinf, knock", "b, hinf, slope", "b, hinf, knock"]
    assert [text.get_text() for text in ax.texts][:4] == ["59 %", "58 %", "4.5 %", "4 %"]
    # the same 200 robots stood for both dead zones: their interval is that of 200
    merged = cases.merged(["motor.dead_zone"])
    assert [(case.n, case.fell) for case in merged.worst_first()[:2]] == [(200, 117), (200, 116)]
    assert merged.worst_first()[0].chance == pytest.approx(clopper_pearson(117, 200))
    name, levels = cases.decisive()
    assert (name, list(levels)) == ("scenario", ["knock", "slope"])


def test_a_campaign_says_what_is_done_in_each_scenario():
    cases = campaign_with({("a", "x", "knock"): 0, ("a", "x", "hill"): 0}.items(), 100)
    pushes = ((Impulse(impulse=0.3),), (Slope(angle=0.1),))
    cases.origins = [ensemble_of("nxtway-gs", pushes=push).origin() for push in pushes]
    (items,) = [block.blocks[0] for block in cases.page().blocks if str(getattr(block, "heading", "")) == "Scenarios"]
    assert [str(item).replace("\u00a0", " ") for item in items.items] == [
        "knock: a knock of 0.3 N s forward", "hill: a slope of 5.73°",
    ]  # fmt: skip
    # the cases have the same 100 robots: none of 200 would bound falls twice as well (1 − 0.05^(1/100) = 3.0 %)
    assert str(cases.page().numbers[0].value) == "at most 3\u00a0%"


def test_a_campaign_is_judged_by_the_bound_of_its_worst_case():
    # 4 of 100 fell, but with 95 % confidence up to 8.9 % may (Clopper and Pearson), which a certificate counts
    levels = [campaign_with({("a",): fell}.items(), 100).page().verdict.level for fell in (0, 4, 30)]
    assert levels == ["good", "warn", "bad"]


def test_moments_merge_to_those_of_the_whole():
    values = 1e3 + np.random.Generator(np.random.Philox(1)).standard_normal(1000)
    merged = Moments()
    for part in np.split(values, [1, 400, 400, 990]):  # parts of 1, 399, 0, 590 and 10
        merged = merged.with_values(part)
    # mean and deviation of numbers about 1000 lose three of the sixteen digits
    assert merged.mean == pytest.approx(values.mean(), rel=1e-13)
    assert merged.deviation == pytest.approx(values.std(ddof=1), rel=1e-11)


def test_a_name_that_is_no_text_is_one_line_and_makes_no_folder(spec, tmp_path):
    """A byte of Latin-1 in a name comes as half of a pair (PEP 383), which Arrow's paths cannot hold."""
    with pytest.raises(InvalidScenario, match="UTF-8"):
        run_campaign(read_campaign(spec), tmp_path / "\udcff", workers=0)
    assert not list(tmp_path.iterdir())


def test_another_campaign_keeps_out_of_the_folder(spec, alone, tmp_path):
    other = tmp_path / "other.toml"
    other.write_text(SPEC.replace("seed = 3", "seed = 4"))
    with pytest.raises(InvalidScenario, match="another campaign"):
        run_campaign(read_campaign(other), alone, workers=0)
    with pytest.raises(InvalidScenario, match="no campaign"):
        collect(tmp_path)


@pytest.mark.needs("module:distributed")
def test_an_address_without_a_scheduler_is_reported(spec, tmp_path, monkeypatch):
    import distributed

    client = distributed.Client
    monkeypatch.setattr(distributed, "Client", lambda address, timeout: client(address, timeout=timeout / 10))
    with pytest.raises(UprightError, match="no scheduler"):
        # port 1 is reserved and nobody listens there
        run_campaign(read_campaign(spec), tmp_path / "far", cluster="tcp://127.0.0.1:1")


@pytest.mark.parametrize(
    ("old", "new", "error", "says"),
    [
        ("n = 24", "n = 0", InvalidScenario, "without robots"),
        ("n = 24", 'n = "many"', InvalidScenario, "n is 'many'"),
        ('["nxtway-gs"]', "[1]", InvalidScenario, "texts in quotes"),
        ("seed = 3", "seed = -3", InvalidScenario, "seed of -3"),
        ("seed", "sead", UnknownName, "seed"),
        ('"impulse"', '"impuls"', UnknownName, "impulse"),
        ("impulse = 0.25, ", "", InvalidScenario, "lacks impulse"),
        ("impulse = 0.25, start = 0.2", 'impulse = "0.25,start=2"', InvalidScenario, "impulse impulse: '0.25,start=2'"),
        ("start = 0.2", "start = true", InvalidScenario, "start: True"),
        ('"knock"', '"knock"\nstart = { pitch = "0.1,wheel=3" }', InvalidScenario, "start pitch: '0.1,wheel=3'"),
        ('"knock"', '"knock"\nstart = { pitch = 3 }', InvalidScenario, "3 rad of pitch"),
        ("[0.0, 0.3]", "0.3", InvalidScenario, "list of numbers"),
        ("motor.dead_zone", "motor.deadzone", UnknownName, "motor.dead_zone"),
        ("seconds = 1.0", "seconds = 1.0\nkeep = ['pitch']", InvalidScenario, "peak_pitch"),
        ("[grid]", "[grid", InvalidScenario, "broken TOML"),
        ("nxtway-gs", "missing.toml", UprightError, "missing.toml"),
    ],
)
def test_what_is_wrong_with_a_campaign_is_reported(tmp_path, old, new, error, says):
    assert old in SPEC
    path = tmp_path / "c.toml"
    path.write_text(SPEC.replace(old, new))
    with pytest.raises(error, match=says):
        read_campaign(path)


def test_only_what_is_asked_for_is_kept(tmp_path, capsys):
    path = tmp_path / "c.toml"
    path.write_text(SPEC.replace("n = 24", "n = 20").replace("seed = 3", "seed = 3\nkeep = ['fell', 'effort']"))
    assert main(["sweep", str(path), "--workers", "0"]) == 0
    assert "Worst: " in capsys.readouterr().out
    assert set(collect(tmp_path / "c").data_vars) == {"fell", "effort", "case"}
