"""What the log doctor looks for, one file for each family of checks."""
