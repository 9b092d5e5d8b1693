"""`upright lab`: the live page."""

from __future__ import annotations

from typing import Annotated

import typer

from upright.errors import UprightError


def lab(
    port: Annotated[int, typer.Option(help="Port to serve on; 0 takes any that is free.")] = 8765,
    browser: Annotated[bool, typer.Option("--browser/--no-browser", help="Open the page in a browser.")] = True,
    class_: Annotated[
        bool, typer.Option("--class", help="Up to 30 students, each with a robot, on the address of --host.")
    ] = False,
    host: Annotated[
        str, typer.Option(help="This machine's address, which students type (only with --class).")
    ] = "127.0.0.1",
) -> None:
    """Push the robot with the mouse, in a page that this machine serves.

    Works offline and only answers this machine, unless --class states an address. Ctrl-C ends it.
    """
    from upright.lab.classroom import Door
    from upright.lab.server import LOOPBACK, Lab, listening, serve

    if class_ and host in (LOOPBACK, "localhost", "0.0.0.0"):
        raise UprightError("--class without an address", hint="--class --host ADDRESS, this machine's in the network")
    if not class_ and host != LOOPBACK:
        raise UprightError(
            f"--host {host} without --class", expected="only this machine, 127.0.0.1", hint="add --class"
        )
    if not 0 <= port < 65536:
        raise UprightError(f"--port {port}", expected="between 0 and 65535")
    served = Lab(host, port, Door.of_a_class() if class_ else Door())
    socket = listening(served)

    def ready() -> None:
        _say(served.url, served.teacher_url if class_ else "")
        if browser:
            import webbrowser

            webbrowser.open(served.teacher_url if class_ else served.url)

    serve(served, socket, ready)


def _say(url: str, teacher: str) -> None:
    if teacher:
        typer.echo(f"students: {url}\nteacher:  {teacher}\nCtrl-C ends the class")
    else:
        typer.echo(f"the lab is at {url}\nCtrl-C ends it")
