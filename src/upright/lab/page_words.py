"""What other parts say for the terminal, in words for the page: its buttons and tabs in place of options."""

from __future__ import annotations

import re

BUTTONS = {"calibrate": "Calibrate", "doctor": "Doctor", "keep compare": "Compare", "keep comparison": "Compare"}
"""The button of each job that works on a log."""

_RULES: tuple[tuple[str, str], ...] = (
    (r"there is no run to hand in.*",
     "Nothing to hand in yet: press Stand up, push the robot, then Hand in within a minute."),
    (r"the log's commands are in (.+?); expected (.+?), as those of '(.+?)'; likely another robot; try: .*",
     "this log is of a robot whose commands are in {0}; {2} takes {1}. "
     "Choose the log's robot in the tab Robot, then press {job} again."),
    (r"(.*) bends the numbers(?:, since no push is known)?; try --between-knocks\.?",
     "{0} bends the numbers, since no push is known. "
     "The terminal's “upright calibrate … --between-knocks” leaves the pushes out."),
    (r"(.*) Fix what you measured with --known\.",
     "{0} The terminal's “upright calibrate … --known NAME” takes as exact what you measured."),
    (r"(.*); try: (?:run `upright doctor` on the log|upright doctor shows the poses)",
     "{0}. Press Doctor: it examines the log."),
    (r"(.*); try: name their columns in a mapping; see `upright doctor`",
     "{0}. The terminal's “upright doctor LOG --write-mapping m.toml” drafts names for its columns."),
    (r"(.*); try: (?:upright doctor LOG )?--write-mapping \S+, (?:and|which) .*",
     "{0}. The terminal's “upright doctor LOG --write-mapping m.toml” drafts names for its columns."),
    (r"(.*); try: (?:upright doctor (?:LOG )?--fix|cut the log with --from).*",
     "{0}. The terminal's “upright doctor LOG --fix NEW.csv” repairs what it can."),
)  # fmt: skip
"""A pattern for all of a text, and what the page says; `{job}` is the button to press again."""

_PRESET = re.compile(r"--robot (?=[\w-])")
_MAPPING = re.compile(r"(?<!LOG )--write-mapping (\S+\.toml)")
_OPTION = re.compile(r"; try: ([^;]*(?:--\w|\bupright )[^;]*)$")


def for_page(text: str, job: str = "calibrate") -> str:
    """The text without options of the terminal, except in a command that is named as one."""
    text = text.removeprefix(f"{job}: ")
    for pattern, words in _RULES:
        if match := re.fullmatch(pattern, text, re.DOTALL):
            return words.format(*match.groups(), job=BUTTONS.get(job, "Calibrate"))
    text = _MAPPING.sub(r"the terminal's “upright doctor LOG --write-mapping \1”", _PRESET.sub("", text))
    return _OPTION.sub(r". In a terminal: \1.", text)
