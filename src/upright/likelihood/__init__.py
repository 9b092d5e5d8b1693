"""How likely a log is under what was assumed of a robot, and what it shows instead."""
