"""Hand-ins: what a student did, run again on another machine, and what was forged."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from upright.classwork.graded import MEASURED, TOLERANCE, differs
from upright.classwork.grading import grade, grade_file
from upright.classwork.tasks import TASKS, task_of
from upright.classwork.worksheet import LANGUAGES, fragment, worksheet
from upright.control import lqr_state
from upright.errors import UprightError
from upright.lab.desk import InlineDesk
from upright.lab.handin import HandIn, InvalidHandIn, RunResult, read_hand_in, write_hand_in
from upright.lab.messages import Change, Drag, Made, Notice, Save, Setup, StandUp, Steer, Strike
from upright.lab.plant import COARSE
from upright.lab.rerun import rerun
from upright.lab.session import Session
from upright.pages.html import document
from upright.robots import Robot

MODEL = Setup(bodies=("nonlinear",), seed=7)


def a_run(folder: Path, setup: Setup = MODEL, student: str = "Ana", seconds: float = 4.0) -> Path:
    """What a student does: some seconds that do not count, then Stand up, a knock, a drag, and the hand-in."""
    desk = InlineDesk()
    session = Session(setup, desk, folder, fine=COARSE, certified=False)
    for (_, job), status, result in desk.poll():
        session.reported(job, status, result)
    session.handle(Strike("impulse", 0.05))
    session.handle(Steer(0.1, 0.5))
    session.advance(0.7)
    session.handle(StandUp(0.05))
    session.advance(0.5)
    session.handle(Strike("impulse", 0.1))
    session.advance(1.0)
    session.handle(Drag(0.3, 0.1))
    session.advance(0.3)
    session.handle(Drag(0.0, 0.0))
    while session.result().seconds < seconds - 0.02:
        session.advance(0.1)
    session.handle(Save("handin", student))
    for (_, job), status, result in desk.poll():
        session.reported(job, status, result)
    events = session.events()
    assert [event.parts for event in events if isinstance(event, Notice)] == []
    made = [event for event in events if isinstance(event, Made)]
    return (folder / made[-1].name).rename(folder / f"{student}.json")


@pytest.mark.parametrize("controller", ["lqg", "pid"])
def test_a_hand_in_runs_again_as_it_was(tmp_path, controller):
    """To the last digit on the machine where it was made; `pid` is designed beside the loop."""
    done = read_hand_in(a_run(tmp_path, replace(MODEL, controller=controller)))
    assert done.sealed
    assert done.student == "Ana"
    assert [type(action).__name__ for _, action in done.actions] == ["Steer", "Strike", "Drag", "Drag"]
    assert [t for t, _ in done.actions] == pytest.approx([0.0, 0.5, 1.5, 1.8], abs=0.011)  # a period
    assert rerun(done) == done.claimed


def test_after_a_change_there_is_nothing_to_hand_in(tmp_path):
    """A run whose set-up was changed on its way cannot be run again from its beginning."""
    desk = InlineDesk()
    session = Session(MODEL, desk, tmp_path, fine=COARSE, certified=False)
    session.handle(StandUp(0.0))
    session.advance(0.5)
    session.handle(Change(replace(MODEL, slope=0.02)))
    session.advance(0.5)
    session.handle(Save("handin", "Ana"))
    (notice,) = [event for event in session.events() if isinstance(event, Notice)]
    assert "Stand up" in notice.parts["en"].hint


@pytest.fixture(scope="module")
def genuine(tmp_path_factory: pytest.TempPathFactory) -> HandIn:
    return read_hand_in(a_run(tmp_path_factory.mktemp("lab")))


HOSTILE = {
    "empty": "", "no-json": "{", "no-table": "[]", "deep": "[" * 100_000, "another-kind": '{"kind": "upright robot"}',
    "old": '{"kind": "upright hand-in", "version": 0}', "bare": '{"kind": "upright hand-in", "version": 1}',
    "long-number": '{"kind": "upright hand-in", "version": 1, "seconds": ' + "9" * 5000 + "}",
}  # fmt: skip


def broken(done: HandIn, folder: Path) -> list[str]:
    """Files that are no hand-ins, and hand-ins with one thing in them that cannot be."""
    for name, text in HOSTILE.items():
        (folder / f"{name}.json").write_text(text)
    data = done.to_json()
    wrong = {
        "no-name": {"student": ""}, "line-in-name": {"student": "A\nB"}, "nan": {"seconds": float("nan")},
        "an-hour": {"seconds": 3600.0}, "no-step": {"step": 1e-9}, "no-body": {"setup": data["setup"] | {"bodies": []}},
        "no-list": {"actions": {}}, "too-many": {"actions": data["actions"] * 3000},
        "change-on-the-way": {"actions": [[0.0, {"kind": "Change", "setup": data["setup"]}]]},
        "no-action": {"actions": [[0.0, {"kind": "__class__"}]]}, "disordered": {"actions": data["actions"][::-1]},
        "strong": {"actions": [[0.0, {"kind": "Drag", "force": 1e9, "height": 0.0}]]},
        "strange-field": {"setup": data["setup"] | {"path": "/etc/passwd"}},
    }  # fmt: skip
    for name, changes in wrong.items():
        (folder / f"{name}.json").write_text(json.dumps(data | changes))
    (folder / "bytes.json").write_bytes(bytes(range(256)))
    return [*HOSTILE, *wrong, "bytes"]


def test_genuine_forged_and_broken_hand_ins_are_distinguished(tmp_path, genuine):
    folder = tmp_path / "class"
    folder.mkdir()
    write_hand_in(genuine, folder / "genuine.json")
    claim = genuine.claimed
    cheats: dict[str, dict[str, Any]] = {
        "stronger": {"claimed": replace(claim, best=0.3)},  # its pushes follow too closely for a record
        "never-fell": {"setup": replace(MODEL, controller="off")},
        "faller": {"claimed": replace(claim, fell=True)},
        "weightless": {"setup": replace(MODEL, numbers={"body_mass": -1.0})},
    }
    for name, changes in cheats.items():
        write_hand_in(replace(genuine, student=name, **changes), folder / f"{name}.json")
    text = (folder / "genuine.json").read_text()
    (folder / "seed.json").write_text(text.replace('"seed": 7', '"seed": 8'))
    assert (folder / "seed.json").read_text() != text
    (folder / "loop.json").symlink_to(folder / "genuine.json")
    (folder / "folder.json").mkdir()
    none = broken(genuine, folder)
    grades = {g.file.removesuffix(".json"): g for g in grade(folder, workers=1).rows}
    assert {name: g.verdict for name, g in grades.items() if name not in none} == {
        "genuine": "ok", "stronger": "differs", "never-fell": "differs", "faller": "differs", "weightless": "broken",
        "seed": "edited",
    }  # fmt: skip
    assert {grades[name].verdict for name in none} == {"broken"}
    for g in grades.values():
        assert "\n" not in str(g.why)
        assert g.verdict == "ok" or g.why
    assert "fell at" in str(grades["never-fell"].why)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"student": " " * 3}, "student: no name of 1 to 40 letters"),
        ({"student": "a" * 41}, "student: no name of 1 to 40 letters"),
        ({"step": 0.5}, "step: none of the steps 0.001, 0.002, 0.01 s"),
        ({"seconds": 60.1}, "seconds: no length of 0 to 60 s"),
        ({"setup": replace(MODEL, bodies=("calibrated",))}, "setup: its first body cannot be run again"),
        ({"actions": ((2.0, Drag(0.1, 0.0)), (1.0, Drag(0.0, 0.0)))}, "actions: the actions are out of order"),
    ],
)
def test_a_refusal_is_in_words_of_a_teacher(tmp_path, genuine, changes, says):
    path = write_hand_in(replace(genuine, **changes), tmp_path / "Ana.json")
    with pytest.raises(InvalidHandIn, match=f"Ana.json is broken: {re.escape(says)};"):
        read_hand_in(path)


def test_a_name_is_read_without_the_blanks_about_it(tmp_path, genuine):
    assert read_hand_in(write_hand_in(replace(genuine, student="  Ana "), tmp_path / "a.json")).student == "Ana"


def test_the_same_run_under_two_names_is_reported(tmp_path, genuine):
    for name in ("Ana", "Luis"):
        write_hand_in(replace(genuine, student=name), tmp_path / f"{name}.json")
    other = replace(genuine, student="Eva", actions=genuine.actions[:2])
    write_hand_in(replace(other, claimed=rerun(other)), tmp_path / "Eva.json")
    grades = grade(tmp_path, workers=1)
    assert [(g.student, g.verdict) for g in grades.rows] == [("Ana", "copied"), ("Eva", "ok"), ("Luis", "copied")]
    assert "Luis" in str(grades.rows[0].why)
    page = grades.page()
    assert page.verdict
    assert page.verdict.level == "warn"
    assert [number.value for number in page.numbers] == [0, 2, 0]  # miss their goal, not genuine, broken
    assert grades.to_json()["counts"] == {"copied": 2, "ok": 1}


def test_two_machines_agree_within_the_tolerance(genuine):
    """A processor that rounds otherwise is like a start that is 1e-12 rad away: the run ends alike, though readings may
    fall into other steps."""
    moved = rerun(replace(genuine, lean=genuine.lean + 1e-12))
    assert differs(genuine.claimed, moved) is None
    for name, (absolute, _) in TOLERANCE.items():
        cheat = replace(genuine.claimed, **{name: getattr(genuine.claimed, name) * 1.1 + 2 * absolute})
        assert str(MEASURED[name][0]) in str(differs(cheat, genuine.claimed))


def verdict_on(task_name: str, changes: dict[str, Any], actions: Any, seconds: float, folder: Path) -> str:
    """The verdict on a run of a task."""
    task = next(task for task in TASKS if task.name == task_name)
    nothing = RunResult(fell=False, seconds=0.0, peak=0.0, travel=0.0, best=0.0)
    done = HandIn(
        student="Ana", setup=replace(task.setup, **changes), step=COARSE, lean=0.0, seconds=seconds, actions=actions,
        claimed=nothing,
    )  # fmt: skip
    folder.mkdir()
    write_hand_in(replace(done, claimed=rerun(done)), folder / "a.json")
    row = grade_file(folder / "a.json")
    assert task_of(done) is task
    assert row.task == task_name
    return row.verdict


HOLD = ((1.0, Strike("front", 0.1)),)


def test_each_task_can_be_done_and_can_be_missed(tmp_path):
    """By hand: with the regulator's gains, which the lab shows under LQR."""
    robot = Robot.preset("nxtway-gs")
    gains = tuple(lqr_state(robot, dt=0.01).gain[0].tolist())
    assert verdict_on("push", {}, ((1.0, Strike("impulse", 0.25)),), 6.0, tmp_path / "a") == "ok"
    assert verdict_on("push", {}, ((1.0, Strike("impulse", 0.05)),), 6.0, tmp_path / "b") == "not reached"
    assert verdict_on("gains", {}, HOLD, 10.0, tmp_path / "c") == "not reached"
    assert verdict_on("gains", {"gains": gains}, HOLD, 10.0, tmp_path / "d") == "ok"
    assert verdict_on("payload", {"controller": "lqr"}, HOLD, 10.0, tmp_path / "e") == "ok"
    assert verdict_on("payload", {"controller": "lqr", "payload": 0.0}, HOLD, 10.0, tmp_path / "f") == "other set-up"


def test_a_table_for_a_spreadsheet_holds_no_formula(tmp_path, genuine):
    write_hand_in(replace(genuine, student="=HYPERLINK(A1)"), tmp_path / "a.json")
    grades = grade(tmp_path, workers=1)
    lines = grades.save(tmp_path / "grades.csv").read_text("utf-8").splitlines()
    assert "'=HYPERLINK(A1)" in lines[1].split(",")
    assert "=HYPERLINK" in document(grades.page())


def test_a_folder_without_hand_ins_is_one_line(tmp_path):
    for folder in (tmp_path, tmp_path / "nowhere"):
        with pytest.raises(UprightError, match="expected"):
            grade(folder)
    with pytest.raises(InvalidHandIn):
        read_hand_in(tmp_path / "nothing.json")


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_worksheet_of_the_documents_is_the_present_one(language):
    """It is the last section of the lesson. After a change of the tasks: what `upright grade --worksheet LANGUAGE`
    prints, with each title one level lower."""
    page = Path(__file__).resolve().parents[1] / "docs" / f"lesson.{language}.md"
    text = worksheet(language)
    assert page.read_text("utf-8").endswith(re.sub(r"^#", "##", text, flags=re.MULTILINE))
    assert all(fragment(task) in text for task in TASKS)
    assert "(http://class.example/#robot=" in worksheet(language, "http://class.example/")
