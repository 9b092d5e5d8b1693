"""The web application: the built page, the WebSocket, uploads and downloads. Loaded only where a lab is served."""

from __future__ import annotations

import asyncio
import contextlib
import secrets
from collections.abc import AsyncGenerator, Callable
from typing import Any

from fastapi import FastAPI, Request, Response, WebSocket, WebSocketDisconnect
from fastapi.responses import FileResponse, HTMLResponse, JSONResponse

from upright.errors import UprightError
from upright.lab import connections, uploads
from upright.lab.codec import plain
from upright.lab.connections import FINE, Address, Book
from upright.lab.hub import Client, Hub
from upright.lab.mailbox import Mailbox
from upright.lab.recording import FILES, page_text, static
from upright.lab.spoken import parts_of
from upright.lab.uploads import TooLarge, Uploaded, UploadRefused
from upright.pages import Say

Foreign = Callable[[str | None, str | None], bool]

HEADERS = {
    "Content-Security-Policy": "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
    "script-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-cache",
}


ELSEWHERE = (
    '<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
    "<title>upright lab</title><style>body{font:1.1rem/1.5 system-ui,sans-serif;max-width:34rem;margin:15vh auto;"
    "padding:0 1rem;color-scheme:light dark}</style><h1>There is nothing at this address</h1>"
    '<p><a href="/">Open the lab</a></p><h2 lang="es">No hay nada en esta dirección</h2>'
    '<p lang="es"><a href="/#lang=es">Abrir el laboratorio</a></p></html>'
)
"""What a mistyped address shows, in both languages."""


def application(foreign: Foreign, hub: Hub, book: Book) -> FastAPI:
    """The application round a hub; `foreign(host, origin)` says whether a request comes from another site, `book` has
    the server's connections."""
    app = FastAPI(title="upright lab", docs_url=None, redoc_url=None, openapi_url=None, lifespan=_life(hub, book))

    async def guard(request: Request, call_next: Any) -> Response:
        if foreign(request.headers.get("host"), request.headers.get("origin")):
            return JSONResponse({"error": "this page belongs to another site"}, 403, HEADERS)
        response = await call_next(request)
        response.headers.update(HEADERS)
        return response

    def download(session: str, name: str) -> Response:
        return _download(hub, session, name)

    async def upload(session: str, request: Request, what: str = "log", name: str = "") -> Response:
        return await _upload(hub, session, request, what, name)

    async def talk(socket: WebSocket) -> None:
        await _talk(foreign, hub, book, socket)

    app.exception_handler(404)(_lost)
    app.middleware("http")(guard)
    app.get("/", response_model=None)(_index)
    app.get("/assets/{name}", response_model=None)(_asset)
    app.get("/files/{session}/{name}", response_model=None)(download)
    app.post("/upload/{session}", response_model=None)(upload)
    app.websocket("/ws")(talk)
    return app


def _life(hub: Hub, book: Book) -> Any:
    @contextlib.asynccontextmanager
    async def life(_: Any) -> AsyncGenerator[None]:
        hub.begin()
        sweeping = asyncio.create_task(_sweep(hub, book))
        try:
            yield
        finally:
            sweeping.cancel()

    return life


async def _sweep(hub: Hub, book: Book) -> None:
    while True:
        await asyncio.sleep(1.0)
        book.sweep()
        hub.check()
        hub.sweep()


async def _lost(request: Request, error: Exception) -> Response:  # noqa: ARG001
    return HTMLResponse(ELSEWHERE, 404)


async def _index() -> Response:
    return HTMLResponse(page_text())


TYPES = {"js": "text/javascript", "css": "text/css", "svg": "image/svg+xml", "json": "application/json"}


def _asset(name: str) -> Response:  # in a thread, as what reads a disk is
    folder = static() / "assets"
    known = {entry.name for entry in folder.iterdir()} if folder.is_dir() else set()
    if name not in known:
        return Response("not found", 404)
    kind = TYPES.get(name.rpartition(".")[2], "application/octet-stream")
    return Response((folder / name).read_bytes(), media_type=kind)


def _download(hub: Hub, session: str, name: str) -> Response:
    folder = hub.folder(session)
    known = {entry.name for entry in folder.iterdir()} if folder and folder.is_dir() else set()
    if folder is None or name not in known or name.startswith("."):
        return Response("not found", 404)
    # what was uploaded is never shown: its name begins with in-
    shown = "inline" if name == FILES["compare"] else "attachment"
    return FileResponse(folder / name, filename=name, content_disposition_type=shown)


async def _upload(hub: Hub, session: str, request: Request, what: str, name: str) -> Response:
    folder = hub.folder(session)
    if folder is None:
        gone = UploadRefused(Say("there is no such session"), hint=Say("reload the page"))
        return JSONResponse({"error": plain(parts_of(gone))}, 404)
    try:
        path = await uploads.receive(request.stream(), folder, name, what)
    except UprightError as error:
        return JSONResponse({"error": plain(parts_of(error))}, 413 if isinstance(error, TooLarge) else 400)
    hub.pass_on(session, Uploaded(what, str(path)))
    return JSONResponse({"name": path.name})


async def _talk(foreign: Foreign, hub: Hub, book: Book, socket: WebSocket) -> None:
    if foreign(socket.headers.get("host"), socket.headers.get("origin")):
        await socket.close(code=4403, reason="this page belongs to another site")
        return
    await socket.accept()
    address = (socket.client.host, socket.client.port) if socket.client else ("", 0)
    client = Client(secrets.token_hex(8), Mailbox(), address[0])
    both = client.box.deliver(socket.send_text), _listen(hub, client, book, socket, address)
    tasks = [asyncio.create_task(task) for task in (*both, client.box.overflown.wait())]
    try:
        await asyncio.wait(tasks, return_when=asyncio.FIRST_COMPLETED)
        if client.closed:
            await asyncio.sleep(0.2)  # let the reason go out before the door closes
            await socket.close(code=4400, reason=client.closed[:100])
    except (WebSocketDisconnect, RuntimeError):
        pass
    finally:
        hub.leave(client)
        for task in tasks:
            task.cancel()
        asyncio.get_running_loop().call_later(1.0, book.end, address)  # whatever it has not read
        await asyncio.gather(*tasks, return_exceptions=True)


async def _listen(hub: Hub, client: Client, book: Book, socket: WebSocket, address: Address) -> None:
    """Hand over what the client says, until it is let go or its first Hello does not come."""
    async with asyncio.timeout(connections.PATIENCE):
        while not (client.session or client.closed):
            hub.receive(client, await _next(socket))
    book.pages.add(address)
    while not client.closed:
        hub.receive(client, await _next(socket))
    book.asks(address, FINE)


async def _next(socket: WebSocket) -> str:
    """The next message as text; binary ones are no messages."""
    event = await socket.receive()
    if event["type"] == "websocket.disconnect":
        raise WebSocketDisconnect(event.get("code", 1000))
    return event.get("text") or ""
