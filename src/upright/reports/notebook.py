"""A notebook to begin with: a robot, a push, a comparison, a verdict, and the lab inside."""

from __future__ import annotations

from pathlib import Path

from upright.atomic import write_json

CELLS = (
    """# A robot on two wheels

Run one cell after the other (Shift and Enter), then change a number and run it again.""",
    """import upright as up

robot = up.Robot.preset("nxtway-gs")  # your own: up.Robot.load("mine.toml")
robot""",
    """## Push it

A LEGO robot under a regulator and a Kalman filter is knocked at 1 s. The twin stands in for the real one; the nonlinear
model is its equations of motion.""",
    """kit = up.Kit.preset("nxt")
controller = up.lqg(robot, kit)
push = up.Impulse(impulse=0.05, start=1.0)  # [N s]


def pushed(body):
    return up.run(up.Electronics(body, kit), controller, push, seconds=6.0, seed=1)


runs = {"twin": pushed(up.Twin(robot)), "model": pushed(up.NonlinearBody(robot))}
up.compare(runs)""",
    """## Look at it""",
    """up.compare(runs).plot("pitch", "wheel")""",
    """## Is it safe to drive?""",
    """up.certify(controller, robot, kit, samples=200, sweeps=False)""",
    """## Push it with the mouse

The page beside this notebook, `lab/index.html`, runs without Python.""",
    """up.lab_page(robot, ["lqg", "pid"], push="impulse:0.1")""",
)
"""Prose and code in turn; a cell of prose begins with #."""


def starting_notebook(path: Path) -> Path:
    """Write the notebook (nbformat 4.5), not yet executed."""
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    cells = [_cell(f"cell-{number}", text) for number, text in enumerate(CELLS)]
    return write_json(path, {"nbformat": 4, "nbformat_minor": 5, "metadata": kernel, "cells": cells})


def _cell(name: str, text: str) -> dict[str, object]:
    cell = {"id": name, "metadata": {}, "source": text}
    if text.startswith("#"):
        return {"cell_type": "markdown", **cell}
    return {"cell_type": "code", **cell, "execution_count": None, "outputs": []}
