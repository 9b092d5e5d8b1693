"""Many robots at once: fleets that vary, push maps, basins, campaigns."""
