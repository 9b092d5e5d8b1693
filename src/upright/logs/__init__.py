"""Logs that other programs wrote: readers, mappings, and the recording a fit needs."""
