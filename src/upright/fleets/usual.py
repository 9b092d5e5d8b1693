"""How many robots and points a command takes where nobody says it.

Each is of a controller that is compiled, and of one that is called in Python, some hundred times as slowly: a minute or
so of both.
"""

FLEET = (10_000, 1000)
BASIN_POINTS = (101, 41)
MAP_POINTS = (64, 8)
MAP_ROBOTS = (200, 20)
