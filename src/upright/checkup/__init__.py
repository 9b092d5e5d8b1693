"""The log doctor: checks of a log, one file for each family of faults."""
