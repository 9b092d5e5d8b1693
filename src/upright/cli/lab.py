"""`upright lab`: the live page, or the page alone."""

from __future__ import annotations

from pathlib import Path

from upright.cli.output import tell
from upright.errors import UprightError


def lab(
    *,
    port: int = 8765,
    browser: bool = True,
    class_: bool = False,
    host: str | None = None,
    export: Path | None = None,
    robots: str | None = None,
    controllers: str | None = None,
) -> None:
    """Open the lab: push a simulated robot with the mouse.

    The page works offline and is for this machine only; --class opens it to the network. Ctrl-C ends it.
    --export FOLDER serves nothing: it writes one page with robots and controllers inside, for any web host.
    """
    if export is not None:
        if class_:
            raise UprightError("--export with --class", expected="one of both", hint="leave out --class")
        _export(export, robots, controllers)
    elif robots or controllers:
        given = "--robots" if robots else "--controllers"
        raise UprightError(f"{given} without --export", expected="--export FOLDER", hint="choose it in the page")
    else:
        _serve(host, port, browser=browser, class_=class_)


def _serve(host: str | None, port: int, *, browser: bool, class_: bool) -> None:
    from upright.lab.classroom import Door
    from upright.lab.server import LOOPBACK, Lab, listening, own_address, reachable, serve

    if class_:
        host = own_address() if host is None else reachable(host)
    elif host not in (None, LOOPBACK):
        raise UprightError(f"--host {host} without --class", expected=f"this machine, {LOOPBACK}", hint="add --class")
    host = host or LOOPBACK
    served = Lab(host, port, Door.of_a_class() if class_ else Door())
    socket = listening(served)

    def ready() -> None:
        if class_:
            alone = "\nno network was found, so only this machine can open them: --host ADDRESS" * (host == LOOPBACK)
            tell(f"students: {served.url}\nteacher:  {served.teacher_url}{alone}\nCtrl-C ends the class")
        else:
            tell(f"the lab is at {served.url}\nCtrl-C ends it")
        if browser:
            import webbrowser

            webbrowser.open(served.teacher_url if class_ else served.url)

    serve(served, socket, ready)


def _export(folder: Path, robots: str | None, controllers: str | None) -> None:
    from upright.experiment.notation import listed
    from upright.lab.export import export
    from upright.progress import progress

    with progress("designing and printing") as show:
        page = export(folder, listed(robots), listed(controllers), say=lambda line: tell(line, err=True), progress=show)
    tell(f"wrote {page}: open it in a browser, or put it on any web host")
