"""The lab: a live page in which robots are pushed with the mouse, and the session behind it.

`Session` knows nothing of HTTP: the same one runs in tests, in the command line and behind the page.
"""
