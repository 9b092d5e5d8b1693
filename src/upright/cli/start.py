"""The process of the command `upright`: ready for signals and for any stdout before it loads anything else."""

from __future__ import annotations

import sys
from typing import NoReturn

from upright import interrupts
from upright.streams import guard


def run() -> NoReturn:
    """Run the command of this process's arguments, and end the process with its exit code."""
    printed = guard()  # first, since whatever opens a file might get the number of a closed stream
    code = interrupts.exit_code()
    try:
        interrupts.watch()
        from upright.cli.main import USER_ERROR, complain, main

        code = main()
        sys.stdout.flush()
        if printed.error and not interrupts.interrupted():
            complain(f"cannot print: {printed.error.strerror}; try: -o FILE, or another place for the output")
            code = code or USER_ERROR
    except KeyboardInterrupt:
        pass
    interrupts.leave(code)
