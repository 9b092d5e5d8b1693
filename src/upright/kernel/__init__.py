"""`experiment.run` for thousands of robots in compiled code, generated from `physics.dynamics`."""
