"""What is being done to the robot at this moment: the mouse, pushes by name, pulls, and what came of each."""

from __future__ import annotations

from dataclasses import dataclass, field

from upright.experiment import Hold, Impulse, Push
from upright.experiment.pushes import PushProgramme, combined
from upright.lab.messages import Drag, Recovered, Strike
from upright.physics.dynamics import Disturbance
from upright.robots import Robot

HOLD = 3.0  # [s] a hold of this length lets every preset come to rest against it
KNOCK = 0.02  # [s] that an impulse takes, but for whole periods
PULL = 0.3  # [s] that a wheel is pulled

UPRIGHT, STILL, CALM_FOR = 0.05, 0.4, 1.0
"""A robot has recovered that leans less [rad] and turns less [rad/s] for so long [s]."""

SHORT = 0.5  # [s] a longer push leans the robot against it: it is held, not struck


@dataclass
class Pushing:
    """Active pushes of one session; `t` is the session's time [s]."""

    force: float = 0.0
    height: float = 0.0
    _active: list[tuple[float, PushProgramme]] = field(default_factory=list[tuple[float, PushProgramme]])
    _pull: tuple[float, float] = (0.0, 0.0)

    def strike(self, strike: Strike, t: float, period: float) -> None:
        """Begin a push by name at time `t`; a knock takes whole periods [s], as every force here, to have its size."""
        size = strike.size
        knock = max(round(KNOCK / period), 1) * period
        if strike.what in ("pull_left", "pull_right"):
            self._pull = (t + PULL, size if strike.what == "pull_left" else -size)
            self._active.append((t + PULL, Push(force=size, start=t, duration=PULL, height=0.0)))
        elif strike.what == "impulse":
            self._active.append((t + knock, Impulse(impulse=size, start=t, duration=knock)))
        else:
            self._active.append((t + HOLD, Hold(pitch=size, start=t, until=t + HOLD)))

    def drag(self, drag: Drag) -> bool:
        """Push by hand from now on; whether that begins a push."""
        begins = drag.force != 0 and self.force == 0
        self.force, self.height = drag.force, drag.height
        return begins

    def at(self, t: float, slope: float, robot: Robot) -> tuple[Disturbance, float]:
        """What acts on the robot from `t` on, and the pull [N]."""
        if not self._active and not self.force:
            return Disturbance(slope=slope), 0.0
        self._active = [(end, push) for end, push in self._active if t < end]
        parts = [push for _, push in self._active]
        disturbance = combined([*parts, Push(force=self.force, start=t, duration=1.0, height=self.height)], t, robot)
        pull = self._pull[1] if t < self._pull[0] else 0.0
        return disturbance._replace(slope=slope), pull

    def clear(self) -> None:
        """Let go of everything."""
        self.force = 0.0
        self._active = []
        self._pull = (0.0, 0.0)


@dataclass(kw_only=True)
class Score:
    """The largest single push from which the robot came back. One that was given before it had recovered from another,
    or from a lean, sets no record; nor do pushes that last longer than `SHORT`, and pulls at a wheel, which turn it."""

    best: float = 0.0
    run: float = 0.0  # [N s] the same of this run alone
    effort: float = 0.0  # [u² s] of the whole run
    _given: int = 0  # pushes that it has yet to recover from
    _impulse: float = 0.0
    _lasted: float = 0.0
    _calm: float = 0.0
    _before: float = 0.0

    def push(self) -> None:
        """A push of any kind begins."""
        if not self._given:
            self._impulse = 0.0
            self._lasted = 0.0
            self._before = self.effort
        self._given += 1
        self._calm = 0.0

    def exchanged(self) -> None:
        """Another robot or controller goes on: what it recovers from is nobody's record."""
        self._given = self._given + (self._given > 0)
        self._impulse = 0.0

    def anew(self, lean: float) -> Score:
        """That of the next run, which begins at rest or with a `lean` [rad]."""
        return Score(best=self.best, _given=1 if lean else 0)

    def watch(
        self, dt: float, force: float, state: list[float], applied: tuple[float, float], fallen: bool
    ) -> Recovered | None:
        """One period; the `Recovered` that it completes, or None."""
        self.effort += (applied[0] ** 2 + applied[1] ** 2) * dt
        if force:
            self._impulse = self._impulse + abs(force) * dt
            self._lasted = self._lasted + dt
            self._calm = 0.0
        elif self._given:
            calm = abs(state[0]) < UPRIGHT and abs(state[1]) < STILL
            self._calm = self._calm + dt if calm else 0.0
            return self._ended(fallen) if fallen or self._calm >= CALM_FOR else None
        return None

    def _ended(self, fallen: bool) -> Recovered | None:
        single = self._given == 1
        self._given = 0
        if not self._impulse or (self._lasted > SHORT and not fallen):
            return None
        if single and not fallen:
            self.run = max(self.run, self._impulse)
            self.best = max(self.best, self.run)
        return Recovered(self._impulse, self.effort - self._before, self.best, fallen, single)
