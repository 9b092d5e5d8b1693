"""A robot's parameters from one raw log, by maximum likelihood, with intervals."""
