"""Tasks for a class, and what comes of its hand-ins when they are run again."""
