"""Who may come in, and as what: alone on this machine, or a class with a token on a stated address."""

from __future__ import annotations

import hmac
import secrets
from dataclasses import dataclass, field
from typing import Any, Literal

from upright.errors import UprightError
from upright.lab.messages import Board, Hello, Setup, Student
from upright.pages import Say

Role = Literal["alone", "student", "teacher"]

MOST_STUDENTS = 30
MOST_ALONE = 8
ALPHABET = "abcdefghjkmnpqrstuvwxyz23456789"
"""Letters and digits that nobody takes for one another on a blackboard."""

CLASS_SETUP = Setup(bodies=("nonlinear", "linear"))
"""What students begin with: no twin, so that thirty robots fit on two cores."""


class NotAdmitted(UprightError):
    """A page that may not come in."""


def token(length: int = 8) -> str:
    """A word that nobody guesses: 40 bits for eight letters."""
    return "".join(secrets.choice(ALPHABET) for _ in range(length))


@dataclass
class Door:
    """Decides who comes in. Without `students`, everyone on this machine does, alone."""

    students: str = ""
    teacher: str = ""

    @classmethod
    def of_a_class(cls) -> Door:
        """A door with fresh tokens."""
        return cls(token(), token(16))

    @property
    def is_class(self) -> bool:
        """Whether this is a class."""
        return bool(self.students)

    def role(self, hello: Hello) -> Role:
        """What the page may be; raises `NotAdmitted` where its token is wrong."""
        if not self.is_class:
            return "alone"
        given = hello.token.encode()
        if hmac.compare_digest(given, self.teacher.encode()):
            return "teacher"
        if not hmac.compare_digest(given, self.students.encode()):
            hint = Say("open the address that your teacher shows")
            raise NotAdmitted(Say("the token is missing or wrong"), hint=hint)
        if not hello.name.strip():
            raise NotAdmitted(Say("your name is missing"), hint=Say("write a name, so that the board can show it"))
        return "student"


@dataclass
class Scores:
    """The board: the latest row of each session, under the names that students gave."""

    names: dict[str, str] = field(default_factory=dict[str, str])
    here: set[str] = field(default_factory=set[str])
    _rows: dict[str, tuple[Any, ...]] = field(default_factory=dict[str, tuple[Any, ...]])

    def update(self, rows: list[tuple[Any, ...]]) -> None:
        """Remember the latest rows (session, pitch, fallen, best, effort, controller), and the best push of all."""
        for name, pitch, fallen, best, *rest in rows:
            if name in self.names:
                before = self._rows[name][3] if name in self._rows else 0.0
                self._rows[name] = (name, pitch, fallen, max(best, before), *rest)

    def forget(self, session: str) -> None:
        """Take a session off the board."""
        self.names.pop(session, None)
        self._rows.pop(session, None)
        self.here.discard(session)

    def board(self) -> Board:
        """Students by largest recovered push, the least effort first among equals."""
        lines = [
            Student(self.names[name], pitch, fallen, best, effort, name in self.here, controller)
            for name, pitch, fallen, best, effort, controller in self._rows.values()
        ]
        return Board(tuple(sorted(lines, key=lambda line: (-line.best, line.effort, line.name))))
