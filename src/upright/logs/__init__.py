"""Logs of other programs: readers, mappings to our channels, and the recording that a fit reads.

`upright.logs.raw.raw_log` reads any log: a file, through a mapping, as a `Log` of raw sensors and commands.
"""
