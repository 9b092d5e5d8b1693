"""The feedback loop as two linear systems: its margins, ν-gap and μ."""
