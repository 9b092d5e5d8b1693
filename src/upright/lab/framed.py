"""The page without Python in a frame, as a notebook shows it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from urllib.parse import quote, urlencode

from upright.lab.export import export
from upright.robots import Robot, find_robot

USUAL = ("lqg", "lqr", "pid")
"""Methods that are designed within a second each."""


@dataclass(frozen=True)
class LabPage:
    """A page at `path`, opened at `place` (what stands behind its address, without #) in a frame `height` pixels high.

    The notebook holds the frame alone: the page stays a file beside it, and moves with it.
    """

    path: Path
    place: str
    height: int = 620

    def __str__(self) -> str:
        return f"{self.path}: open it in a browser"

    def _repr_html_(self) -> str:
        address = escape(f"{quote(self.path.as_posix())}#{self.place}")
        look = f'width="100%" height="{self.height}" style="border: 1px solid #8884; border-radius: 8px"'
        frame = f'<iframe src="{address}" title="The lab: push the robot" loading="lazy" {look}></iframe>'
        return f'{frame}<p><a href="{address}">{escape(self.path.as_posix())}</a></p>'


def lab_page(
    robot: Robot | str = "nxtway-gs",
    controllers: Sequence[str] = USUAL,
    *,
    push: str = "",
    folder: str | Path = "lab",
) -> LabPage:
    """Write the lab of one `robot` with these `controllers` (methods of design) into `folder`, and show it in a frame.

    The first controller is in use; a second later comes the `push`, such as `impulse:0.1` [N s] or `tilt:0.05` [rad].
    Raises what `upright lab --export` refuses: an `UprightError`.
    """
    chosen = find_robot(robot)
    path = export(folder, [chosen], controllers, say=lambda _: None)
    link = {"robot": chosen.name, "controller": controllers[0]} | ({"push": push} if push else {})
    return LabPage(path, urlencode(link, safe=":"))
