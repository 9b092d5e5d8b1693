"""What runs a generated program step by step: the contract, and the C of a program on this very machine."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Protocol

from upright.atomic import TemporaryFolder
from upright.compiled.fixed import fractions
from upright.compiled.program import Kind, Program
from upright.firmware.tools import run_tool, tool
from upright.pages import Say

Values = Mapping[str, float]


class Executor(Protocol):
    """`start()` begins anew; `step(raw)` gives the program one period with those raw readings and returns its outputs,
    nothing while it still calibrates. `numbers` is the arithmetic it runs in, `where` the machine."""

    where: Say
    numbers: str

    def start(self) -> None: ...

    def step(self, raw: Values) -> Values: ...

    def close(self) -> None: ...


class Words:
    """How a C program's structures stand in memory: one number after the other, of `type` float, double or int32_t."""

    def __init__(self, program: Program, number: str) -> None:
        self.inputs = [v.name for v in program.of(Kind.INPUT)]
        self.outputs = [v.name for v in program.of(Kind.OUTPUT)]
        self.states = [v.name for v in program.of(Kind.STATE)] + program.carried()
        self.number = number
        self.code = {"float": "f", "double": "d", "fixed": "i"}[number]
        bits = fractions(program) if number == "fixed" else {}
        self._ones = {name: 2.0 ** bits.get(name, 0) for name in (*self.inputs, *self.outputs)}

    def to_words(self, raw: Values) -> list[Any]:
        """The inputs in order, as the program's own numbers."""
        return [round(raw[n] * self._ones[n]) if self.number == "fixed" else raw[n] for n in self.inputs]

    def from_words(self, words: Sequence[float]) -> dict[str, float]:
        """The outputs by name."""
        return {name: word / self._ones[name] for name, word in zip(self.outputs, words, strict=True)}


FLAGS = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-O2", "-ffp-contract=off")
"""Products and sums stay apart: a fused multiply-add rounds once where the other targets round twice."""


class CExecutor:
    """The three functions of a program in C, called once a period; a kind of machine says how."""

    def __init__(self, program: Program, number: str) -> None:
        self.numbers = number
        self._words = Words(program, number)
        self._ready = False

    def step(self, raw: Values) -> Values:
        self._give(self._words.to_words(raw))
        if not self._ready:
            self._call("calibrate")
            self._ready = bool(self._results()["ready"])
            return {}
        self._call("command")
        self._call("update")
        return self._results()

    def _give(self, words: Sequence[Any]) -> None:
        raise NotImplementedError

    def _call(self, name: str) -> None:
        raise NotImplementedError

    def _results(self) -> dict[str, float]:
        raise NotImplementedError


class HostExecutor(CExecutor):
    """The program's C, built by gcc as a library of this process."""

    def __init__(self, source: Path, program: Program, number: str, flags: Sequence[str] = ()) -> None:
        super().__init__(program, number)
        self.where = Say("this machine (gcc)")
        self._folder = TemporaryFolder()
        library = Path(self._folder.name) / "balance.so"
        run_tool([tool("gcc"), *FLAGS, *flags, "-shared", "-fPIC", "-o", str(library), str(source)], source.name)
        self._library = ctypes.CDLL(str(library))
        kind = {"float": ctypes.c_float, "double": ctypes.c_double, "fixed": ctypes.c_int32}[number]
        self._in, self._out, self._state = (
            (kind * max(len(names), 1))() for names in (self._words.inputs, self._words.outputs, self._words.states)
        )
        self.start()

    def start(self) -> None:
        self._library.upright_reset(self._state)
        self._ready = False

    def close(self) -> None:
        self._folder.cleanup()

    def _give(self, words: Sequence[Any]) -> None:
        self._in[:] = words

    def _results(self) -> dict[str, float]:
        return self._words.from_words([float(word) for word in self._out])

    def _call(self, name: str) -> None:
        self._library[f"upright_{name}"](self._state, self._in, self._out)
