"""Draws docs/push.svg, the picture of the README: run `python docs/picture.py` after a change of the models."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

from upright.atomic import write_text
from upright.bodies import Electronics, LinearBody, NonlinearBody
from upright.bodies.twin import Twin
from upright.control import Estimated, kalman, lqr
from upright.experiment import Hold, run
from upright.physics.linear import linearise
from upright.report import Figure, Panel, Trace
from upright.robots import Kit, Robot

WIDTH, HEAD = 720, 64


def figure() -> Figure:
    """Pitch and wheel angle of twin, nonlinear and linear model, held at 0.1 rad for 4 s."""
    robot = Robot.preset("herrera2015")
    kit, regulator, push = Kit.preset(robot.kit), lqr(robot, 0.01), Hold(pitch=0.1, until=4.0)
    logs = {
        "twin on its sensors": run(
            Electronics(Twin(robot), kit), Estimated(regulator, kalman(robot, kit)), push, seed=1
        ),
        "nonlinear model": run(NonlinearBody(robot), regulator, push),
        "linear model": run(LinearBody(linearise(robot), robot), regulator, push),
    }
    panels = [
        Panel(text, "rad", [Trace(name, log.t, log[channel]) for name, log in logs.items()])
        for text, channel in (("pitch ψ", "truth/pitch"), ("wheel angle θ", "truth/wheel"))
    ]
    return Figure("A robot leans into a push and comes back: twin and models agree", panels, spans=((0.0, 4.0),))


def standalone(drawn: Figure) -> str:
    """The figure with its title, key and colours in one SVG file."""
    style = resources.files("upright.report").joinpath("style.css").read_text(encoding="utf-8")
    height = float(drawn.svg().partition('viewBox="0 0 ')[2].split('"')[0].split()[1])
    entries = "".join(
        f'<g transform="translate({20 + 170 * i}, 34)">{_sized(key.sample)}<text x="42" y="12">{key.name}</text></g>'
        for i, key in enumerate(drawn.key())
    )
    inside = drawn.svg().replace("<svg ", f'<svg y="{HEAD}" width="{WIDTH}" height="{height:g}" ', 1)
    paper = f'<rect width="{WIDTH}" height="{height + HEAD:g}" style="fill: var(--paper)"/>'
    title = f'<text x="20" y="20" style="font-weight: 600; font-size: 16px; fill: var(--ink)">{drawn.title}</text>'
    box = f'viewBox="0 0 {WIDTH} {height + HEAD:g}" width="{WIDTH}" height="{height + HEAD:g}"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {box}><style>{style}</style>{paper}{title}{entries}{inside}</svg>\n'
    )


def _sized(sample: str) -> str:
    return sample.replace("<svg ", '<svg width="34" height="14" ', 1)


if __name__ == "__main__":
    write_text(Path(__file__).with_name("push.svg"), standalone(figure()))
