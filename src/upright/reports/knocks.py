"""What pushes there were: how hard, how long and where; beside those of a certificate on the same robot."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from upright.plotting import number
from upright.robots import Kit, Robot
from upright.robots.facts import recorded
from upright.robots.kit import Battery, Motor


def robot_of(origin: Mapping[str, Any]) -> tuple[Robot, Kit] | None:
    """The nominal robot of an origin and its motors and battery; None without a kit."""
    kit = origin.get("kit")
    numbers = origin.get("robot", {})
    if not kit or not isinstance(kit, Mapping):
        return None
    robot = Robot(name=numbers["name"], drive=numbers["drive"], **recorded(numbers))
    return robot, Kit(name=kit["name"], motor=Motor(**kit["motor"]), battery=Battery(**kit["battery"]),
                      delay=kit["delay"])  # fmt: skip


def certificate_knocks(robot: Robot, kit: Kit) -> str:
    """With how much a certificate knocks a robot, with a low and a full battery: "0.186 to 0.245 N s"."""
    sizes = sorted(knock_sizes(robot, kit))
    return f"{' to '.join(dict.fromkeys(number(size, 3) for size in (sizes[0], sizes[-1])))} N s"


def knock_sizes(robot: Robot, kit: Kit) -> list[float]:
    """With how much a certificate knocks a robot [N s], one for each battery."""
    from upright.certification.pushes import standard_pushes
    from upright.likelihood.assumptions import batteries

    return [[*standard_pushes(robot, kit, volts).values()][-1].size for volts in batteries(robot, kit) or (None,)]


def harder(origins: Sequence[Mapping[str, Any]]) -> str:
    """How many times as hard the hardest knock of a robot is as a certificate's hardest on the same robot, as a
    sentence with a space before it; nothing where it is not harder."""

    def knock(origin: Mapping[str, Any]) -> float:
        return max((abs(p.get("impulse") or 0.0) for p in origin.get("scenario", {}).get("push") or ()), default=0.0)

    hardest = {str(origin.get("robot", {}).get("name", "")): origin for origin in sorted(origins, key=knock)}
    for origin in hardest.values():  # one of each robot
        known = robot_of(origin)
        if known and knock(origin) and knock(origin) > max(knock_sizes(*known)):
            times = number(knock(origin) / max(knock_sizes(*known)), 2)
            size = number(knock(origin))
            return (
                f" The knock, {size} N s, is {times} times the hardest that `upright certify` tries on {known[0].name}."
            )
    return ""


def pushed(pushes: Sequence[Mapping[str, Any]] | None) -> str:
    """What was done to them."""
    sizes = {"impulse": "N s", "force": "N"}
    words: list[str] = []
    for push in pushes or ():
        for name, unit in sizes.items():
            if size := push.get(name):
                words.append(f"pushed {'forward' if size > 0 else 'backward'} by {number(abs(size))} {unit}")
        if push.get("pitch"):
            words.append(f"held at {number(math.degrees(push['pitch']), 2)}° and released")
        if push.get("angle"):
            words.append(f"on a floor tilted by {number(math.degrees(push['angle']), 2)}°")
    return " and ".join(words[:3]) or ("pushed" if pushes else "without a push")


def where(pushes: Sequence[Mapping[str, Any]] | None) -> str:
    """How long the first impulse takes and at which height: "for 10 ms at the centre of mass"; empty without one."""
    for push in pushes or ():
        if push.get("impulse"):
            height = push.get("height")
            at = "at the centre of mass" if height is None else f"{height:g} m above the axle"
            return f"for {1e3 * push.get('duration', 0.01):g} ms {at}"
    return ""
