"""What hostile clients, malformed calls, mutated files, faults in flight and interrupts do to it.

Each module has `measure(seed, minutes)`, which yields rows: what was measured, its value, its bar, and whether it held.
"""
