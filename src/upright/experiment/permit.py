"""Whether a controller may drive a real robot: what stands between a design and hardware."""

from __future__ import annotations

from typing import Protocol

from upright.control.controller import Controller, controller_hash
from upright.errors import NotPermitted
from upright.robots import Kit, Robot


class Permit(Protocol):
    """What a certificate is to whoever drives hardware: one line why `controller` may not drive `robot` on `kit`, or
    nothing."""

    def refuses(
        self, controller: Controller | None = None, robot: Robot | None = None, kit: Kit | None = None
    ) -> str: ...


def permitted(
    controller: Controller,
    permit: Permit | None,
    robot: Robot,
    kit: Kit | None = None,
    *,
    anyway: bool = False,
) -> str:
    """What a log or a program says of it: "certified", "not certified", or "overridden" with what was refused.

    Raises `NotPermitted` where `permit` refuses the controller for `robot` on `kit` (None where it is not known),
    and `anyway` does not override that. Without a permit nothing is known of the controller, and nothing is refused.
    """
    refused = permit.refuses(controller, robot, kit) if permit else ""
    if refused and not anyway:
        raise NotPermitted(
            f"the {controller.spec.kind} {controller_hash(controller)[:12]} may not drive this robot: {refused}",
            expected="a certificate that is not red, of this controller, robot, kit and period",
            hint="certify what will drive, or say anyway=True (--anyway) and stand beside the robot",
        )
    if refused:
        return f"overridden: {refused}"
    return "certified" if permit else "not certified"
