"""Many robots at once: the batch kernel, fleets that vary, push maps, basins, campaigns.

`fleet.kernel.simulate` is `experiment.run` for thousands of robots in compiled code, generated from `physics.dynamics`.
"""
