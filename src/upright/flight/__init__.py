"""A program on a brick: upload, start, follow, fetch the log."""
