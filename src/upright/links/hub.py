"""The connection to a Pybricks hub: upload, start, output and stop, each within a time limit.

What speaks to the hub is pybricksdev (MIT), an optional extra that is loaded when a hub is first asked for.
"""

from __future__ import annotations

import asyncio
import os
import subprocess
from collections.abc import AsyncGenerator, Awaitable, Callable
from contextlib import asynccontextmanager, suppress
from pathlib import Path
from typing import Any, Protocol, TypeVar

from upright.errors import UprightError, require

OLDEST = (3, 4)  # Pybricks whose names programs use: Axis among the parameters (3.3), buttons on every hub (3.4)
PATIENCE = 5.0  # [s] to wait for an answer; a hub answers in 0.1 s
SEARCH = 10.0  # [s] to wait for a hub that advertises
UPLOAD = 60.0  # [s] for a program: 20 kB in pieces of 150 bytes, each acknowledged, take 15 s
AIR = "ble"
"""The port of the first hub that advertises; `ble:NAME` is one of that name or address."""

T = TypeVar("T")


class HubLost(UprightError):
    """A hub that cannot be reached, or no longer answers."""


class HubRefused(UprightError):
    """A hub that refuses a request."""


class Peripheral(Protocol):
    """A hub outside Bluetooth, such as a virtual one: `client(lost)` stands for bleak's client."""

    name: str

    def client(self, lost: Callable[[], None]) -> Any: ...


class HubLink:
    """A connected hub. `lines` holds the output of its program since its start; `lost` is whether the connection is."""

    def __init__(self, hub: Any, name: str, patience: float) -> None:
        from pybricksdev.ble.pybricks import StatusFlag
        from pybricksdev.connections import ConnectionState

        self.name = name
        self.patience = patience
        self.lines = list[str]()
        self.lost = False
        self._hub = hub
        self._flags = StatusFlag
        self._gone = ConnectionState.DISCONNECTED
        self._rest = b""
        self._news = asyncio.Event()
        self.begun = False  # whether the program was reported to run since its start
        hub.stdout_observable.subscribe(self._receive)
        hub.status_observable.subscribe(self._changed)
        self.reported = False  # until the hub itself sends its status, which that first call was not

    def watch(self) -> None:
        """From now on a broken connection counts as lost."""
        self._hub.connection_state_observable.subscribe(self._state)

    @property
    def running(self) -> bool:
        """Whether a program runs, by the hub's last status."""
        return bool(self._hub.status_observable.value & self._flags.USER_PROGRAM_RUNNING)

    @property
    def flat(self) -> bool:
        """Whether the hub warns of its battery."""
        low = self._flags.BATTERY_LOW_VOLTAGE_WARNING | self._flags.BATTERY_LOW_VOLTAGE_SHUTDOWN
        return bool(self._hub.status_observable.value & low)

    async def upload(self, source: Path) -> None:
        """Compile a program and put it into the hub's memory."""
        size, version = self._hub._max_user_program_size, self._hub.fw_version  # nothing public tells the size
        if not size or (version and version.release < OLDEST):
            raise HubRefused(
                f"the firmware {version} of {self.name} is too old", expected="Pybricks 3.4 or later",
                hint="install it at code.pybricks.com",
            )  # fmt: skip
        try:
            await self._do(self._hub.download(str(source)), "take the program", UPLOAD)
        except subprocess.CalledProcessError as error:
            reason = (error.stderr or b"no reason given").decode("utf-8", "replace").strip().splitlines()[-1]
            raise HubRefused(f"{source.name} does not compile: {reason}", likely="an edit by hand") from None

    async def start(self) -> None:
        """Start the program; its output goes into `lines`."""
        self.lines = []
        self._rest = b""
        self.begun = False
        await self._do(self._hub.start_user_program(), "start")
        while not self.begun and await self.news(self.patience):
            pass  # what it prints may come before its status

    async def stop(self) -> None:
        """Request the program's stop: it ends as after the hub's button, with its last lines."""
        await self._do(self._hub.stop_user_program(), "stop")

    async def write(self, text: bytes) -> None:
        """Send input to the program, in pieces that a hub takes."""
        await self._do(self._hub.write(text), "listen")

    async def news(self, timeout: float) -> bool:
        """Wait for output or a status, for `timeout` [s] at most; whether one came."""
        self._news.clear()
        with suppress(TimeoutError):
            async with asyncio.timeout(timeout):
                await self._news.wait()
        return self._news.is_set()

    def _receive(self, data: bytes) -> None:
        *lines, self._rest = (self._rest + bytes(data)).replace(b"\r\n", b"\n").split(b"\n")
        self.lines += [line.decode("utf-8", "replace") for line in lines]
        self._news.set()

    def _changed(self, flags: Any) -> None:
        self.reported, self.begun = True, self.begun or bool(flags & self._flags.USER_PROGRAM_RUNNING)
        self._news.set()

    def _state(self, state: Any) -> None:
        if state == self._gone:
            self.lost = True
            self._news.set()

    async def _do(self, request: Awaitable[T], what: str, patience: float = 0.0) -> T:
        return await _done(request, self.name, what, max(patience, self.patience))


async def _done(request: Awaitable[T], name: str, what: str, patience: float) -> T:
    """The result of the request; `HubLost` or `HubRefused` where it fails."""
    from bleak.exc import BleakError
    from pybricksdev.connections.pybricks import HubDisconnectError

    try:
        async with asyncio.timeout(patience):
            return await request
    except (HubDisconnectError, OSError, EOFError) as error:  # a time-out is an OSError
        raise _lost(name, what, error) from None
    except BleakError as error:
        if "onnect" in str(error):
            raise _lost(name, what, error) from None
        raise HubRefused(f"{name} refuses to {what}: {error}", likely="another program runs on it") from None
    except (RuntimeError, ValueError) as error:
        raise HubRefused(f"{name} refuses to {what}: {error}", hint="install Pybricks at code.pybricks.com") from None


def _lost(name: str, what: str, error: BaseException) -> HubLost:
    reason = f": {error}" if str(error) else ""
    return HubLost(
        f"{name} does not answer ({what}{reason})", likely="it is out of reach, or off",
        hint="come nearer and switch it on; its button stops the program",
    )  # fmt: skip


@asynccontextmanager
async def linked(port: str | Peripheral, patience: float = PATIENCE) -> AsyncGenerator[HubLink]:
    """The hub at `port` (ble, ble:NAME, or one that Bluetooth knows nothing of), for as long as the block lasts.

    Raises `HubLost`, `HubRefused` or `MissingTool`.
    """
    hub, name = await _hub_at(port)
    link = HubLink(hub, name, patience)
    await _done(hub.connect(), name, "connect", max(patience, SEARCH) if isinstance(port, str) else patience)
    link.watch()
    try:
        if not link.reported:
            await link.news(patience)
        yield link
    finally:
        with suppress(Exception):  # the line may be gone already, and then nothing is left to close
            async with asyncio.timeout(patience):
                await hub.disconnect()


async def _hub_at(port: str | Peripheral) -> tuple[Any, str]:
    require("a Pybricks hub", "pybricksdev")
    os.environ.setdefault("TQDM_DISABLE", "1")  # pybricksdev draws a bar of its own, before it is loaded alone
    from pybricksdev.ble import find_device
    from pybricksdev.connections.pybricks import PybricksHub, PybricksHubBLE

    if not isinstance(port, str):
        hub: Any = PybricksHubBLE.__new__(PybricksHubBLE)  # all but its search for a Bluetooth device
        PybricksHub.__init__(hub)
        hub._device, hub._client = port, port.client(hub._handle_disconnect)
        return hub, f"the hub {port.name}"
    kind, _, name = port.partition(":")
    if kind != AIR:
        raise UprightError(f"'{port}' is not the port of a hub", expected=f"{AIR}, {AIR}:NAME or virtual")
    label = f"hub {name}".strip()
    try:
        device = await _done(find_device(name or None, timeout=SEARCH), label, "be found", 2 * SEARCH)
    except (HubLost, HubRefused):
        raise HubLost(
            f"no {label} was found in {SEARCH:g} s", likely="it is off, or this computer has no Bluetooth",
            hint="switch both on; the hub must not be connected elsewhere",
        ) from None  # fmt: skip
    return PybricksHubBLE(device), f"the hub {device.name}"
