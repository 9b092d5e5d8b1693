"""`python -m upright`: the command `upright`."""

from upright.cli.start import run

run()
