"""The weights of a method, found on the verdict of a fleet."""
