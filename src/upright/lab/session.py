"""A session: bodies side by side under controllers of their own, and everything a page can ask of them.

It knows nothing of HTTP, of processes or of wall time: messages go in by `handle`, simulated time by `advance`, what a
desk has done by `reported`; snapshots and events come out. The same sequence gives the same robots, bit for bit.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from upright.control import Controller
from upright.errors import InvalidLog, InvalidScenario, UprightError
from upright.lab import views
from upright.lab.desk import Desk
from upright.lab.display import KEPT, Display
from upright.lab.handin import Recorder, RunResult, result_of
from upright.lab.lane import Lane
from upright.lab.message_types import Acted, ErrorParts, Job
from upright.lab.messages import (
    VERSION,
    Analysed,
    Broadcast,
    Cancel,
    Change,
    Changed,
    Drag,
    Light,
    Made,
    Notice,
    Play,
    Progress,
    Recall,
    Save,
    Scrub,
    Setup,
    Snapshot,
    StandUp,
    Start,
    Steer,
    Step,
    Strike,
    Welcome,
)  # fmt: skip
from upright.lab.plant import FINE, Plant, behind, body_of, design, design_part, is_slow, plant_of, setup_of, stand_in
from upright.lab.pushing import Pushing, Score
from upright.lab.recording import FILES, MOMENT
from upright.lab.spoken import heads_of, parts_of
from upright.lab.uploads import Uploaded
from upright.pages import Page, Quantity, Say
from upright.physics.dynamics import CALM
from upright.robots import Robot
from upright.signals import Log

LONGEST = 1.0  # [s] of simulated time in one go


class Session:
    """One robot, its bodies and their controllers, from the set-up on.
    `folder` is where files are made; `desk` does what takes longer than a frame, under `name`; `fine` [s] is a body's
    period; `certified`: the light follows every change. Raises an `UprightError` where the first set-up cannot be.
    """

    def __init__(
        self, setup: Setup, desk: Desk, folder: Path, *, name: str = "", fine: float = FINE, certified: bool = True
    ) -> None:
        self._desk, self.folder, self.name, self._fine, self._certified = desk, folder, name, fine, certified
        self._events: list[Any] = []
        self.paused, self.speed, self._back, self._owed = False, 1.0, 0.0, 0.0
        self.calibrated: Robot | None = None
        self._pushing, self.score, self._display, self._recorder = Pushing(), Score(), Display(), Recorder(fine)
        self._known: dict[type, Any] = {}
        self._built = 0
        self._n, self._periods, self._target, self._steer = 0, 0, np.zeros(6), (0.0, 0.0)
        self.setup, self.plant = setup, plant_of(setup)
        self._designed, self._busy = self._begin_design(setup, self.plant)
        self._build((0.0,) * 6)

    # What comes in

    def handle(self, message: Any) -> None:
        """Do what the message asks; what cannot be done becomes an error event."""
        try:
            self._do(message)
            self._recorder.note(message, self.t)
        except UprightError as error:
            self._events.append(Notice("error", parts_of(error)))

    def advance(self, seconds: float) -> None:
        """Let `seconds` of simulated time pass, unless paused."""
        if self.paused or not self.lanes:
            return
        self._owed = min(self._owed + seconds, LONGEST)
        period = self.plant.kit.period
        while self._owed >= period * (1 - 1e-9):
            self._owed -= period
            self._period()

    def reported(self, job: str, status: str, result: Any) -> None:
        """What the desk reports on a job; `status` is "progress", "done" or "failed"."""
        if status == "progress":
            self._events.append(Progress(job, *result))  # type: ignore[arg-type]
        elif status == "failed":
            self._failed(job, result)
        else:
            answer = self._answer(job, result)
            self._known |= {type(event): event for event in answer if isinstance(event, Analysed | Light)}
            self._events += answer

    # What goes out

    @property
    def t(self) -> float:
        """Simulated time [s]."""
        return self._periods * self.plant.kit.period

    def events(self) -> list[Any]:
        """What happened since this was asked last, in order."""
        happened, self._events = self._events, []
        return happened

    def moment(self) -> tuple[Any, ...]:
        """What tells one snapshot from another: nothing new is worth sending while paused."""
        return (self._periods, self._built, self.paused, self._back)

    def snapshot(self) -> Snapshot:
        """The moment shown: now, or while scrubbing the one asked for."""
        self._n += 1
        return self._display.snapshot(self._n, self._back, self.paused)

    def changed(self) -> Changed:
        """The set-up as it is now."""
        return views.changed(self.setup, self.plant, self.lanes, bool(self._busy))

    def welcome(self) -> list[Any]:
        """The events that describe the session to a page that connects later."""
        return [views.catalogue(), *self.standing_events(), self._display.history()]

    def standing_events(self) -> list[Any]:
        """The set-up, its equations, and the analysis of its loop so far."""
        return [self.changed(), views.equations(self.plant.robot), *self._known.values()]

    def logs(self) -> dict[str, Log]:
        """The run of every body since the last change, at most the last minute; nothing before the first period."""
        return {lane.name: log for lane in self.lanes if (log := lane.log()) is not None}

    def result(self) -> RunResult:
        """How the first body's run went so far; raises `InvalidLog` before its first period."""
        log, lane = next(iter(self._recorded().values())), self.lanes[0]
        return result_of(log, self.plant.robot, fell=lane.fallen, best=self.score.run)

    def close(self) -> None:
        """Free what the bodies hold."""
        for lane in self.lanes:
            lane.body.close()

    # What happens inside

    def _period(self) -> None:
        dt, t = self.plant.kit.period, self.t
        disturbance, pull = self._pushing.at(t, self.setup.slope, self.plant.robot)
        self._steered(dt)
        for lane in self.lanes:
            stood = not lane.fallen
            lane.step(self._target, disturbance, pull)
            if stood and lane.fallen and lane.trouble:
                self._events.append(Notice("error", parts_of(lane.trouble)))
        self._periods += 1
        main = self.lanes[0]
        ended = self.score.watch(dt, 0.0 if pull else disturbance.force, main.state(), main.applied, main.fallen)
        self._events += [ended] if ended else []
        self._display.record(self.t, disturbance, pull, self._target)

    def _steered(self, dt: float) -> None:
        speed, rate = self._steer
        rolling = speed / self.plant.nominal.wheel_radius
        _, _, wheel, _, yaw, _ = self._target.tolist()
        self._target = np.array([0.0, 0.0, wheel + rolling * dt, rolling, yaw + rate * dt, rate])

    def _build(self, start: Sequence[float], states: dict[str, list[float]] | None = None) -> None:
        """New lanes, each from its own body's state where it had one."""
        length, lanes = round(KEPT / self.plant.kit.period), list[Lane]()
        for name in self._names():
            inner = body_of(name, self.plant, self.setup, self._fine, self.calibrated)
            body = behind(inner, self.plant.kit)
            at = (states or {}).get(name, start)
            own = copy.deepcopy(self._designed)
            lanes.append(Lane(name, inner, body, own, start=at, seed=self.setup.seed, length=length))
        self.lanes = lanes
        self._display.show(lanes, self.plant.kit.period)
        self._target, self._owed, self._back = np.zeros(6), 0.0, 0.0
        self._built += 1
        self.score.exchanged()
        self._recorder.stop()
        self._display.record(self.t, CALM, 0.0, self._target)

    def _names(self) -> tuple[str, ...]:
        names = tuple(n for n in dict.fromkeys(self.setup.bodies) if n != "calibrated" or self.calibrated is not None)
        if not names:
            raise InvalidScenario("the set-up names no body", expected="at least one of twin, nonlinear, linear")
        return names

    def _begin_design(self, setup: Setup, plant: Plant) -> tuple[Controller, str]:
        """The controller at once, or nothing but gravity until the desk has it; its loop is analysed beside."""
        slow = is_slow(setup.controller)
        controller = None if slow else design(setup, plant.nominal, plant.kit)
        for job in ("light", "certify"):  # of the controller before
            self._desk.cancel((self.name, job))
        self._desk.submit((self.name, "design"), "design", (setup, slow), alone=slow)
        standing = getattr(self, "_designed", None)
        if controller is not None:
            return controller, ""
        same = standing is not None and plant.nominal == self.plant.nominal
        return standing if same and standing is not None else stand_in(setup, plant), setup.controller

    def designed(self, controller: Controller) -> None:
        """Install what the desk has designed."""
        self._designed, self._busy = controller, ""
        self._build((0.0,) * 6, {lane.name: lane.state() for lane in self.lanes if not lane.fallen})

    def follow(self) -> list[Any]:
        """Have the certificate's light computed for the controller that was designed last, or say that it is not."""
        if not self._certified:
            return [Light(heads=heads_of(Page(Say("In a class the certificate is computed on request"))))]
        self._desk.submit((self.name, "light"), "light", (design_part(self.setup),), alone=True)
        return []

    def upload(self, name: str) -> Path:
        """The uploaded file of that name, which lies in this session's folder and nowhere else."""
        path = self.folder / Path(name).name
        if not path.is_file():
            raise InvalidLog(Say("there is no file {name} here", name=path.name[:60]), hint=Say("open it again"))
        return path

    def _do(self, message: Any) -> None:
        match message:
            case Change(setup):
                self._change(setup)
            case Broadcast(setup):
                self._change(setup)
                self._stand(0.0)
            case Drag():
                if self._pushing.drag(message):
                    self.score.push()
            case Strike():
                self._strike(message)
            case Steer(speed, rate):
                self._steer = (speed, rate)
            case Play(paused, speed):
                self.paused, self.speed = paused, speed
                self._back = self._back if paused else 0.0
            case Step(periods):
                self.paused, self._back = True, 0.0
                for _ in range(periods):
                    self._period()
            case Scrub(back):
                self.paused, self._back = True, back
            case StandUp(pitch):
                self._stand(pitch)
            case _:
                self._ask(message)

    def _ask(self, message: Any) -> None:
        """What the desk does, and what is told again."""
        match message:
            case Recall(since):
                self._events.append(self._display.history(since))
            case Start(job, file):
                self._desk.submit((self.name, job), *self._task(job, file), alone=True)
                self._events.append(Progress(job, 0.0))
            case Cancel(job):
                self._desk.cancel((self.name, job))
                self._events += [Progress(job, 1.0), Notice("info", job=job)]
            case Save(what):
                self._desk.submit((self.name, f"keep {what}"), *self._keeping(message))
            case Uploaded("robot", path):
                self._desk.submit((self.name, "robot"), "robot", (path,), alone=True)
            case Uploaded(_, path):
                self._ask(Start("doctor", path))
            case _:
                raise TypeError(f"a session knows no {type(message).__name__}")

    def _change(self, setup: Setup) -> None:
        if replace(setup, slope=0.0) == replace(self.setup, slope=0.0):
            self.setup = setup
            self._recorder.stop()
            self._events.append(self.changed())
            return
        plant = plant_of(setup)
        before = (self.setup, self.plant, self._designed, self._busy)
        start = [0.0] * 6 if self.lanes[0].fallen else self.lanes[0].state()
        states = {lane.name: lane.state() for lane in self.lanes if not lane.fallen}
        same_robot = plant.nominal == self.plant.nominal
        redesign = design_part(setup) != design_part(self.setup) or not same_robot or plant.kit != self.plant.kit
        try:
            if redesign:
                self._designed, self._busy = self._begin_design(setup, plant)
            self.setup, self.plant = setup, plant
            self.calibrated = self.calibrated if same_robot else None
            self._build(start if same_robot else [0.0] * 6, states if same_robot else {})
        except UprightError:
            self.setup, self.plant, self._designed, self._busy = before
            if redesign:
                self._begin_design(self.setup, self.plant)
            self._events += [self.changed(), *self._known.values()]
            raise
        self._events += [self.changed(), views.equations(self.plant.robot)]
        if redesign:
            self._events += [Light(), Progress("certify", 1.0)]
            self._known.clear()

    def _stand(self, pitch: float) -> None:
        self._pushing.clear()
        self.score = self.score.anew(pitch)
        self._build((pitch, 0.0, 0.0, 0.0, 0.0, 0.0))
        self._recorder.begin(self.t, pitch, *self._steer)
        self._events.append(Acted(self.t))

    def _strike(self, message: Strike) -> None:
        if message.what in ("front", "back") and abs(message.size) > 1.0:
            lean = Quantity(message.size, "rad")
            raise InvalidScenario(Say("a hold at {lean}", lean=lean), expected=Quantity(None, "rad", high=1.0))
        self._pushing.strike(message, self.t, self.plant.kit.period)
        self.score.push()
        self._events.append(Acted(self.t))

    def _failed(self, job: str, parts: dict[str, ErrorParts]) -> None:
        self._busy = "" if job == "design" else self._busy
        self._events += [Notice("error", parts, job=job), Progress(job, 1.0)]  # type: ignore[arg-type]

    # What the desk is given, and what comes of it

    def _task(self, job: Job, file: str) -> tuple[str, tuple[Any, ...]]:
        """The task and its arguments for a job that a page starts."""
        if job in ("certify", "design"):
            return job, (self.setup, *((False,) if job == "design" else ()))
        source = self.upload(file) if file else next(iter(self._recorded().values()))
        kit = () if job == "doctor" else (self.plant.kit,)
        return job, (source, self.plant.nominal, *kit)

    def _keeping(self, message: Save) -> tuple[str, tuple[Any, ...]]:
        """The task and its arguments for a file to be downloaded."""
        what = message.what
        path = self.folder / FILES[what]
        if what in ("report", "compare") and message.name:
            opened = (self.upload(message.name), self.plant.nominal, self.plant.kit)
            return "keep", ("comparison", opened, self.logs(), message.language, path)
        content: dict[str, Callable[[], tuple[Any, ...]]] = {
            "controller": lambda: (self.setup,),
            "robot": lambda: (self.calibrated or self.plant.nominal,),
            "replay": lambda: (([Welcome(VERSION, "", "alone", ""), views.catalogue(), *self.standing_events()],
                                self._display.view(), self._display.rows(MOMENT)),),
            "report": lambda: (self._recorded(), message.language),
            "compare": lambda: (self._recorded(), message.language),
            "handin": lambda: (self._recorder.hand_in(message.name, self.setup, self.t, self.result()),),
        }  # fmt: skip
        given = content[what]() if what in content else (next(iter(self._recorded().values())),)
        return "keep", (what, *given, path)

    def _recorded(self) -> dict[str, Log]:
        logs = self.logs()
        if not logs:
            raise InvalidLog(Say("nothing was recorded yet"), hint=Say("let it run for a moment"))
        return logs

    def _answer(self, job: str, result: Any) -> list[Any]:
        """The events that tell what came of a job."""
        if job == "design":
            return self._analysed(*result)
        if job == "light":
            return [result]
        if job in ("certify", "doctor"):
            return [*result, Progress(job, 1.0)]  # type: ignore[arg-type]
        if job == "calibrate":
            self.calibrated, table = result
            self.handle(Change(replace(self.setup, bodies=tuple(dict.fromkeys((*self.setup.bodies, "calibrated"))))))
            return [table, Progress(job, 1.0)]
        if job == "robot":
            self.handle(Change(setup_of(result, self.setup)))
            return [Notice("info", parts_of(Say("Robot {name} is read", name=result.name)))]
        name = Path(result).name
        return [Made(name, name), Progress(job, 1.0)]  # type: ignore[arg-type]

    def _analysed(self, controller: Controller | None, analysis: Analysed) -> list[Any]:
        if controller is None:
            return [analysis, *self.follow()]
        try:
            self.designed(controller)
        except UprightError as error:
            return [Notice("error", parts_of(error))]
        return [analysis, self.changed(), *self.follow()]
