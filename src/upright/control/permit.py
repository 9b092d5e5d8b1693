"""Whether a controller may drive a real robot: what stands between a design and hardware."""

from __future__ import annotations

from typing import Protocol

from upright.control.controller import Controller, controller_hash
from upright.errors import NotPermitted


class Permit(Protocol):
    """What a certificate is to whoever drives hardware: one line why `controller` may not, or nothing."""

    def refuses(self, controller: Controller | None = None) -> str: ...


def permitted(controller: Controller, permit: Permit | None, anyway: bool = False) -> str:
    """What a log or a program says of it: "certified", "not certified", or "overridden" with what was refused.

    Raises `NotPermitted` where `permit` refuses the controller and `anyway` does not tell otherwise. Without a permit
    nothing is known of the controller, and nothing is refused.
    """
    refused = permit.refuses(controller) if permit else ""
    if refused and not anyway:
        raise NotPermitted(
            f"the {controller.spec.kind} {controller_hash(controller)[:12]} may not drive this robot: {refused}",
            expected="a certificate that is not red, of this very controller",
            hint="change the design and certify it again, or say anyway=True (--anyway) and stand beside the robot",
        )
    if refused:
        return f"overridden: {refused}"
    return "certified" if permit else "not certified"
